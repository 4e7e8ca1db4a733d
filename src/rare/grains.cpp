// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: curvatures and contacts of grains by wider numbers.
#include <pw85/distance/hertz.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_IN_SPACE(PW85_RARE_CURVATURE)
PW85_DEFINE_IN_SPACE(PW85_RARE_HERTZ)

} // namespace pw85::detail
