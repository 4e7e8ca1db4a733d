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

PW85_DEFINE_OF(find_capsule_finer, double)
PW85_DEFINE_OF(find_with_all_digits, double)
PW85_DEFINE_OF(overlaps_with_more_digits, double)
PW85_DEFINE_OF(polytope_overlaps_exactly, double)
PW85_DEFINE_OF(contact_polytope_exactly, double)
PW85_DEFINE_OF(overlaps_exactly, double, 2)
PW85_DEFINE_OF(overlaps_exactly, double, 3)
PW85_DEFINE_OF(box_overlaps_exactly, double)
PW85_DEFINE_OF(find_finer, double, 2, FindOnSegment<>)
PW85_DEFINE_OF(contact_with_all_digits, double, 2, FindOnSegment<>)
PW85_DEFINE_OF(find_finer, double, 3, FindOnTriangle<>)
PW85_DEFINE_OF(contact_with_all_digits, double, 3, FindOnTriangle<>)

} // namespace pw85::detail
