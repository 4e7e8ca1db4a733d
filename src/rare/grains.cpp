// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: curvatures and contacts of grains by wider numbers.
#include <pw85/distance/grain_contact_wall.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_OF(curvature_finer, double)
PW85_DEFINE_OF(hertz_facing_finer, double)
PW85_DEFINE_OF(gap_curvatures_finer, double)

} // namespace pw85::detail
