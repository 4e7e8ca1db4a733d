// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: segments and triangles by wider numbers, and shapes by integers.
#include <pw85/shapes/exact_polytope.hpp>
#include <pw85/shapes/exact_shapes.hpp>
#include <pw85/shapes/triangle.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_IN_SPACE(PW85_RARE_SEGMENT)
PW85_DEFINE_IN_SPACE(PW85_RARE_TRIANGLE)
PW85_DEFINE_IN_SPACE(PW85_RARE_EXACT_SHAPES)
PW85_DEFINE_IN_SPACE(PW85_RARE_EXACT_POLYTOPE)

} // namespace pw85::detail
