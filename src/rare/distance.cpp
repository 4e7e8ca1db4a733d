// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: distances by wider numbers.
#include <pw85/distance/distance_derivatives.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(PW85_RARE_DISTANCE)
PW85_DEFINE_IN_SPACE(PW85_RARE_DISTANCE_DERIVATIVES)

} // namespace pw85::detail
