// SPDX-License-Identifier: BSD-3-Clause
// Lanes: pairs of lists, and one ellipsoid of a system and its neighbours.
#include "chunks.hpp"

#include "derivatives.hpp"
#include "overlap.hpp"

PW85_GATHER(NeighborList)
PW85_GATHER(OneToIndexed)
PW85_KERNEL(NeighborList, ContactArrays)
PW85_KERNEL(NeighborList, OverlapArray)
PW85_KERNEL(NeighborList, DerivativeArrays)
PW85_KERNEL(OneToIndexed, OverlapArray)
