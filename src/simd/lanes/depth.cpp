// SPDX-License-Identifier: BSD-3-Clause
// Lanes: depths of overlaps, with the bits of one pair, and signed distances.
#define PW85_ROUNDED_PRODUCTS
#include "chunks.hpp"

#include "signed_distance.hpp"

PW85_KERNEL(PairArrays<3>, DepthArrays)
PW85_KERNEL(PairArrays<3>, SignedDistanceArrays)
