// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: volumes and common parts by wider numbers.
#include <pw85/volume/overlap_area_derivatives.hpp>
#include <pw85/volume/overlap_volume_derivatives.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(measure_of)
PW85_DEFINE_OF(rim_frame_finely, double)
PW85_DEFINE(measure_part_finely)
PW85_DEFINE_OF(part_derivatives_finely, double)
PW85_DEFINE_OF(area_derivatives_finely, double)
PW85_DEFINE_OF(plane_part_derivatives_finely, double)

} // namespace pw85::detail
