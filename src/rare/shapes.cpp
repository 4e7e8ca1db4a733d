// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: shapes by wider numbers and by integers.
//
// Made from the headers by api/committed.py.
#include <pw85/distance/capsule.hpp>
#include <pw85/shapes/exact_polytope.hpp>
#include <pw85/shapes/exact_shapes.hpp>
#include <pw85/shapes/segment.hpp>
#include <pw85/shapes/triangle.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_IN_SPACE(PW85_RARE_CAPSULE)
PW85_DEFINE_IN_SPACE(PW85_RARE_EXACT_POLYTOPE)
PW85_DEFINE_IN_SPACE(PW85_RARE_EXACT_SHAPES)
PW85_DEFINE_IN_SPACE(PW85_RARE_SEGMENT)
PW85_DEFINE_IN_SPACE(PW85_RARE_TRIANGLE)

} // namespace pw85::detail
