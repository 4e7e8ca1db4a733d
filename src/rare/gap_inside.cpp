// SPDX-License-Identifier: BSD-3-Clause
// Gaps of contained ellipsoids.
#include <pw85/distance/gap_inside.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(PW85_RARE_GAP)

} // namespace pw85::detail
