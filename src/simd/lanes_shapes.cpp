// SPDX-License-Identifier: BSD-3-Clause
// Lanes: ellipsoids and convex sets. It is compiled once per instruction set.
#include "chunks.hpp"
#include "lane_shapes.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_COMPUTE(SetRows<Segments>, SetContactArrays)
PW85_DEFINE_COMPUTE(SetRows<Triangles>, SetContactArrays)
PW85_DEFINE_COMPUTE(SetRows<Boxes>, SetContactArrays)
PW85_DEFINE_COMPUTE(SetRows<Segments>, OverlapArray)
PW85_DEFINE_COMPUTE(SetRows<Triangles>, OverlapArray)
PW85_DEFINE_COMPUTE(SetRows<Boxes>, OverlapArray)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
