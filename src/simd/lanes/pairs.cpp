// SPDX-License-Identifier: BSD-3-Clause
// Lanes: rows of pairs, gathered for the functions of one pair.
#include "chunks.hpp"

PW85_GATHER(PairArrays<3>)
PW85_GATHER(OneToMany)
