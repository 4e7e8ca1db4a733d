// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the parts of lines in ellipsoids, with the bits of one line. It is compiled once per
// instruction set.
#define PW85_ROUNDED_PRODUCTS
#include "chunks.hpp"
#include "lane_shapes.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_COMPUTE(SetRows<Lines>, ChordArrays)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
