// SPDX-License-Identifier: BSD-3-Clause
// Lanes: derivatives of the contact function.
#include "chunks.hpp"

#include "derivatives.hpp"

PW85_KERNEL(PairArrays<3>, DerivativeArrays)
