// SPDX-License-Identifier: BSD-3-Clause
// Lanes: distances from an ellipsoid's surface, with the bits of one row.
#include "../lanes/chunks.hpp"

#include "../lanes/surface_distances.hpp"

PW85_KERNEL(PointRows, SurfaceArrays)
PW85_KERNEL(CylinderRows, SurfaceArrays)
