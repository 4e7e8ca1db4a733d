// SPDX-License-Identifier: BSD-3-Clause
// Lanes: distances from an ellipsoid's surface, with the bits of one row.
#define PW85_ROUNDED_PRODUCTS
#include "chunks.hpp"

#include "surface_distances.hpp"

PW85_KERNEL(PointRows, SurfaceArrays)
PW85_KERNEL(CylinderRows, SurfaceArrays)
