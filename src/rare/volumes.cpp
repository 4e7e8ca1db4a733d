// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: volumes and common parts by wider numbers.
#include <pw85/volume/overlap_area_derivatives.hpp>
#include <pw85/volume/overlap_volume_derivatives.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(PW85_RARE_MEASURE)
PW85_DEFINE_IN_SPACE(PW85_RARE_RIM_FRAME)
PW85_DEFINE(PW85_RARE_PART)
PW85_DEFINE_IN_SPACE(PW85_RARE_DERIVATIVES)
PW85_DEFINE_IN_SPACE(PW85_RARE_AREA_DERIVATIVES)
PW85_DEFINE_IN_SPACE(PW85_RARE_PART_DERIVATIVES)

} // namespace pw85::detail
