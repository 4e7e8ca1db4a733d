// SPDX-License-Identifier: BSD-3-Clause
// Lanes: depths of overlaps, with the bits of one pair.
#define PW85_ROUNDED_PRODUCTS
#include "chunks.hpp"

#include "depth.hpp"

PW85_KERNEL(PairArrays<3>, DepthArrays)
