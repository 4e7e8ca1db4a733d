// SPDX-License-Identifier: BSD-3-Clause
// The table of the lane kernels (lane_*.hpp). It is compiled once per instruction set. dispatch.cpp chooses a table, and
// many_pairs.hpp calls its kernels.
#include "kernels.hpp"
#include "lane_closest_approach.hpp"
#include "lane_closest_passage.hpp"
#include "lane_contact.hpp"
#include "lane_derivatives.hpp"
#include "lane_distance.hpp"
#include "lane_law.hpp"
#include "lane_overlap.hpp"
#include "lane_shapes.hpp"

namespace pw85::detail::kernels {

namespace {

/// The number of pairs of a chunk.
template <class Rows, class Arrays> constexpr std::size_t chunk_size = contact_chunk_size;
template <class Rows> constexpr std::size_t chunk_size<Rows, OverlapArray> = overlap_chunk_size;
template <class Set, class Arrays> constexpr std::size_t chunk_size<SetRows<Set>, Arrays> = lanes;
template <class Set> constexpr std::size_t chunk_size<SetRows<Set>, OverlapArray> = lanes;

/// Computes chunk after chunk. It stops when there may be no room for the pairs that the next chunk leaves over.
template <class Rows, class Arrays>
[[gnu::flatten]] std::size_t compute(Rows const &rows, std::size_t n, Arrays const &out, Worklist &left_over) noexcept
{
    constexpr std::size_t chunk = chunk_size<Rows, Arrays>, last_begin = Worklist::largest_index + 1 - chunk;
    left_over.size = 0;
    std::size_t done = 0;
    while (done < n && done <= last_begin && left_over.size + chunk <= Worklist::capacity) {
        std::size_t const count = n - done < chunk ? n - done : chunk;
        compute_chunk(rows, {done, count, n}, out, left_over);
        done += count;
    }
    return done;
}

/// Computes the values of a law, pack by pack. Lanes beyond the last pair repeat that pair, and do not enter the sum.
template <class Law>
[[gnu::flatten]] LawSums evaluate_law(Law const &given, std::size_t n, double const *mu2, double *d_u) noexcept
{
    Law const law = given; // so that no store to d_u may change it
    Pack energies = Pack(0.0), counts = Pack(0.0);
    for (std::size_t k = 0; k < n; k += lanes) {
        std::size_t const left = n - k;
        LawValues const values = evaluate(law, load_numbers(mu2 + k, left));
        store_lanes(values.d_u, left, d_u + k);
        PackMask const live = PackMask::from_bits(live_lanes(left));
        energies = energies + select(live, values.u, Pack(0.0));
        counts = counts + select(live && !(values.d_u == Pack(0.0)), Pack(1.0), Pack(0.0));
    }
    double energy = 0.0, count = 0.0;
    for (std::size_t i = 0; i < lanes; ++i) {
        energy += energies[i];
        count += counts[i];
    }
    return {energy, static_cast<std::size_t>(count)};
}

template <class Rows, class Arrays> constexpr LaneKernel<Rows, Arrays> made(LaneKernel<Rows, Arrays> const &) noexcept
{
    return {compute<Rows, Arrays>, gather<Rows>};
}

template <class Set, class Arrays>
constexpr LaneKernel<SetRows<Set>, Arrays> made(LaneKernel<SetRows<Set>, Arrays> const &) noexcept
{
    return {compute<SetRows<Set>, Arrays>};
}

template <class Law> constexpr LawKernel<Law> made(LawKernel<Law> const &) noexcept { return {evaluate_law<Law>}; }

template <class... Kernel> constexpr KernelTable<Kernel...> fill(KernelTable<Kernel...> const &) noexcept
{
    return {made(Kernel{})...};
}

} // namespace

extern LaneKernels const PW85_LANES_KERNELS;
constexpr LaneKernels PW85_LANES_KERNELS = fill(LaneKernels{});

} // namespace pw85::detail::kernels
