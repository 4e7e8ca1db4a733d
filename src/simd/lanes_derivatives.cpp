// SPDX-License-Identifier: BSD-3-Clause
// Lanes: derivatives of the contact function. It is compiled once per instruction set.
#include "chunks.hpp"
#include "lane_derivatives.hpp"

namespace pw85::detail::kernels {

namespace PW85_COMPILED_FOR {

PW85_DEFINE_COMPUTE(PairArrays<3>, DerivativeArrays)

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
