// SPDX-License-Identifier: BSD-3-Clause
// Lanes: closest passages.
#include "chunks.hpp"

#include "passage.hpp"

PW85_KERNEL(PairArrays<3>, PassageArrays)
