// SPDX-License-Identifier: BSD-3-Clause
// Lanes: two dimensions. It is compiled once per instruction set.
#include "chunks.hpp"
#include "lane_area.hpp"

namespace pw85::detail {

inline namespace PW85_PACKS {

[[gnu::flatten]] void run(PackSearches<2> &searches, std::size_t packs) noexcept
{
    run_searches(searches, packs);
}

} // namespace PW85_PACKS

namespace kernels::PW85_COMPILED_FOR {

PW85_DEFINE_GATHER(PairArrays<2>)
PW85_DEFINE_COMPUTE(PairArrays<2>, ContactArrays)
PW85_DEFINE_COMPUTE(PairArrays<2>, OverlapArray)
PW85_DEFINE_COMPUTE(PairArrays<2>, AreaArray)

} // namespace kernels::PW85_COMPILED_FOR

} // namespace pw85::detail
