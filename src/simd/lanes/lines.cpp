// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the parts of lines in ellipsoids, with the bits of one line.
#define PW85_ROUNDED_PRODUCTS
#include "chunks.hpp"

#include "lines.hpp"

PW85_KERNEL(SetRows<Lines>, ChordArrays)
