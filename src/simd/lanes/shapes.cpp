// SPDX-License-Identifier: BSD-3-Clause
// Lanes: ellipsoids and convex sets.
#include "chunks.hpp"

#include "shapes.hpp"

PW85_KERNEL(SetRows<Segments>, SetContactArrays)
PW85_KERNEL(SetRows<Triangles>, SetContactArrays)
PW85_KERNEL(SetRows<Boxes>, SetContactArrays)
PW85_KERNEL(SetRows<Segments>, OverlapArray)
PW85_KERNEL(SetRows<Triangles>, OverlapArray)
PW85_KERNEL(SetRows<Boxes>, OverlapArray)
