// SPDX-License-Identifier: BSD-3-Clause
// Lanes: contacts of grains.
#include "chunks.hpp"

#include "grains.hpp"

PW85_KERNEL(PairArrays<3>, GrainArrays)
