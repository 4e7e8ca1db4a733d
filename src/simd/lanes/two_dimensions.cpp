// SPDX-License-Identifier: BSD-3-Clause
// Lanes: two dimensions.
#include "chunks.hpp"

#include "two_dimensions.hpp"

namespace pw85::detail {
inline namespace PW85_PACKS {

[[gnu::flatten]] void run(PackSearches<2> &searches, std::size_t packs) noexcept
{
    run_searches(searches, packs);
}

} // namespace PW85_PACKS
} // namespace pw85::detail

PW85_GATHER(PairArrays<2>)
PW85_KERNEL(PairArrays<2>, ContactArrays)
PW85_KERNEL(PairArrays<2>, OverlapArray)
