// SPDX-License-Identifier: BSD-3-Clause
// Lanes: overlaps. It is compiled once per instruction set.
#include "chunks.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_COMPUTE(PairArrays<3>, OverlapArray)
PW85_DEFINE_COMPUTE(OneToMany, OverlapArray)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
