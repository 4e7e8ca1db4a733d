// SPDX-License-Identifier: BSD-3-Clause
// Lanes: volumes of common parts, with the bits of one pair.
#define PW85_FOUR_LANES
#include "../lanes/chunks.hpp"

#include "../lanes/volumes.hpp"

PW85_KERNEL(PairArrays<3>, VolumeArray)
