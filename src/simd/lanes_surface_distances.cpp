// SPDX-License-Identifier: BSD-3-Clause
// Lanes: distances from an ellipsoid's surface, with the bits of one row. It is compiled once per
// instruction set.
#define PW85_ROUNDED_PRODUCTS
#include "surface_distances.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_COMPUTE(PointRows, SurfaceArrays)
PW85_DEFINE_COMPUTE(CylinderRows, SurfaceArrays)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
