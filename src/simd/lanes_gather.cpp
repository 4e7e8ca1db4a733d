// SPDX-License-Identifier: BSD-3-Clause
// Lanes: rows of pairs, gathered for the functions of one pair. It is compiled once per instruction
// set.
#include "chunks.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_GATHER(PairArrays<3>)
PW85_DEFINE_GATHER(OneToMany)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
