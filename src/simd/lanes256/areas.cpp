// SPDX-License-Identifier: BSD-3-Clause
// Lanes: areas of common parts in two dimensions.
#include "../lanes/chunks.hpp"

#include "../lanes/two_dimensions.hpp"

PW85_KERNEL(PairArrays<2>, AreaArray)
