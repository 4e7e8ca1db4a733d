// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the contact function, and the distance of closest approach.
#include "chunks.hpp"

#include "contact.hpp"

PW85_GATHER(Directions)
PW85_KERNEL(PairArrays<3>, ContactArrays)
PW85_KERNEL(Directions, ApproachArray)
