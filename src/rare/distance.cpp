// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: distances by wider numbers.
#include <pw85/distance/distance_derivatives.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(refined_distance)
PW85_DEFINE_OF(refined_derivatives, double)

} // namespace pw85::detail
