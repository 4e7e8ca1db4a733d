// SPDX-License-Identifier: BSD-3-Clause
// Gaps of contained ellipsoids.
#include <pw85/distance/gap_inside.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(gap_contained)

} // namespace pw85::detail
