// SPDX-License-Identifier: BSD-3-Clause
// Lanes: depths of overlaps, with the bits of one pair, and signed distances.
#include "../lanes/chunks.hpp"

#include "../lanes/signed_distance.hpp"

PW85_KERNEL(PairArrays<3>, DepthArrays)
PW85_KERNEL(PairArrays<3>, SignedDistanceArrays)
