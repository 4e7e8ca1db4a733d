// SPDX-License-Identifier: BSD-3-Clause
// Lanes: contacts of grains. It is compiled once per instruction set.
#include "chunks.hpp"
#include "lane_grains.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_COMPUTE(PairArrays<3>, GrainArrays)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
