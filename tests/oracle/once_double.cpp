// SPDX-License-Identifier: BSD-3-Clause
// What units that define PW85_SHARED_WITH take from another one, as tests compile it.
#include "../../src/simd/define_shared.hpp"
#include "compiled_once.hpp"

namespace pw85::detail {
inline namespace PW85_SHARED_WITH {

using HullOfSegment = Hull<double, 2>; // macros take no commas
using HullOfTriangle = Hull<double, 3>;

PW85_ONCE_DETAIL(PW85_SHARED_DEFINED, double, 2)
PW85_ONCE_DETAIL(PW85_SHARED_DEFINED, double, 3)
PW85_DEFINE_SHARED(decide_by_certified_value, double, 2)
PW85_DEFINE_SHARED(decide_by_certified_value, double, 3)
PW85_DEFINE_SHARED(call_overlap, double, 2)
PW85_DEFINE_SHARED(call_overlap, double, 3)
PW85_DEFINE_SHARED(call_contains, double, 2)
PW85_DEFINE_SHARED(call_contains, double, 3)
PW85_DEFINE_SHARED(advance_until_spheres_meet, double, 3)
PW85_DEFINE_SHARED(plane_of_translation, double, 3)
PW85_DEFINE_SHARED(plane_from_afar, double, 3)
PW85_DEFINE_SHARED(search_polytope, double)
PW85_DEFINE_SHARED(check_planes, double)
PW85_DEFINE_SHARED(decide_polytope, double)
PW85_DEFINE_SHARED(contact_points_scaled, double, 2, FindOnSegment<>)
PW85_DEFINE_SHARED(contact_points_scaled, double, 3, FindOnTriangle<>)
PW85_DEFINE_SHARED(overlap_of_any, double, HullOfSegment)
PW85_DEFINE_SHARED(overlap_of_any, double, HullOfTriangle)
PW85_DEFINE_SHARED(overlap_of_any, double, SolidBox<double>)

} // namespace PW85_SHARED_WITH
} // namespace pw85::detail
