// SPDX-License-Identifier: BSD-3-Clause
// Lanes: overlaps.
#include "chunks.hpp"

#include "overlap.hpp"

PW85_KERNEL(PairArrays<3>, OverlapArray)
PW85_KERNEL(OneToMany, OverlapArray)
