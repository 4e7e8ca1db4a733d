// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the parts of lines in ellipsoids, with the bits of one line.
#include "../lanes/chunks.hpp"

#include "../lanes/lines.hpp"

PW85_KERNEL(SetRows<Lines>, ChordArrays)
