// SPDX-License-Identifier: BSD-3-Clause
// Lanes: distances.
#include "chunks.hpp"

#include "distance.hpp"

PW85_KERNEL(PairArrays<3>, DistanceArrays)
