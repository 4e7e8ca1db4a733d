// SPDX-License-Identifier: BSD-3-Clause
// Lanes: distances of pairs in a list, for signed distances. The kernel of distances would need
// more stack than is left there.
#include "chunks.hpp"

#include "distance.hpp"

namespace pw85::detail {

namespace {

constexpr std::size_t packs_of_list = lanes == 8 ? 2 : packs_per_chunk;

/// Packs of listed pairs, with their searches.
struct ListedPacks {
    LanePair<3> pairs[packs_of_list];
    NormalSearch<Pack> searches[packs_of_list];
};

[[gnu::noinline, gnu::flatten]] void search_listed(ListedPacks &all, std::size_t packs,
                                                   kernels::PairArrays<3> const &rows,
                                                   std::uint16_t const *indices) noexcept
{
    auto &pairs = all.pairs;
    auto &searches = all.searches;
    for (std::size_t k = 0; k < packs; ++k) {
        pairs[k] = load_listed(rows, indices + k * lanes);
        searches[k] = start_search(with_units(pairs[k]));
    }
    run(searches, packs, max_normal_steps,
        [&](std::size_t k) { take_step(searches[k], with_units(pairs[k])); });
}

/// Stores a pack, and returns the bits of its lanes that are certain.
[[gnu::noinline, gnu::flatten]] unsigned finish_listed(LanePair<3> const &pair,
                                                       Multipliers<Pack> const &x, unsigned live,
                                                       std::uint16_t const *indices,
                                                       kernels::DistanceArrays const &out) noexcept
{
    Distance<Pack, 3> d;
    auto const keep = [&](Distance<Pack, 3> const &now) { d = now; };
    unsigned const certain = live & finish_search(pair, x, keep).to_bits();
    scatter_distances(d, pair.r12, certain, indices, out);
    return certain;
}

} // namespace

void kernels::PW85_BUILDING::listed_distances(PairArrays<3> const &rows,
                                              std::uint16_t const *indices, std::size_t count,
                                              DistanceArrays const &out,
                                              Worklist &rejected_lanes) noexcept
{
    if constexpr (lanes == 2) return; // signed_distance.hpp does not call it
    ListedPacks all;
    for (std::size_t begin = 0; begin < count; begin += packs_of_list * lanes) {
        std::size_t const left = count - begin, most = (left + lanes - 1) / lanes,
                          packs = most < packs_of_list ? most : packs_of_list;
        search_listed(all, packs, rows, indices + begin);
        for (std::size_t k = 0; k < packs; ++k) {
            std::uint16_t const *const listed = indices + begin + k * lanes;
            unsigned const live = live_lanes(left - k * lanes);
            unsigned const certain =
                finish_listed(all.pairs[k], all.searches[k].x, live, listed, out);
            for_lanes(live & ~certain, [&](unsigned i) { rejected_lanes.push(listed[i]); });
        }
    }
}

} // namespace pw85::detail
