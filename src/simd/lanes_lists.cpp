// SPDX-License-Identifier: BSD-3-Clause
// Lanes: pairs of lists, and one ellipsoid of a system and its neighbours. It is compiled once per
// instruction set.
#include "chunks.hpp"
#include "lane_derivatives.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_GATHER(NeighborList)
PW85_DEFINE_GATHER(OneToIndexed)
PW85_DEFINE_COMPUTE(NeighborList, ContactArrays)
PW85_DEFINE_COMPUTE(NeighborList, OverlapArray)
PW85_DEFINE_COMPUTE(NeighborList, DerivativeArrays)
PW85_DEFINE_COMPUTE(OneToIndexed, OverlapArray)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
