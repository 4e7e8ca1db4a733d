// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: curvatures and contacts of grains by wider numbers.
#include <pw85/distance/grain_contact_wall.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_IN_SPACE(PW85_RARE_CURVATURE)
PW85_DEFINE_IN_SPACE(PW85_RARE_HERTZ)
PW85_DEFINE_IN_SPACE(PW85_RARE_GAP_CURVATURES)

} // namespace pw85::detail
