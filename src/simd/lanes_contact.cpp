// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the contact function, and the distance of closest approach. It is compiled once per
// instruction set.
#include "chunks.hpp"
#include "lane_closest_approach.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_GATHER(Directions)
PW85_DEFINE_COMPUTE(PairArrays<3>, ContactArrays)
PW85_DEFINE_COMPUTE(Directions, ApproachArray)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
