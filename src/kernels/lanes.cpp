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

namespace pw85::detail::kernels {

namespace {

/// The number of pairs of a chunk.
template <class Arrays> constexpr std::size_t chunk_size = contact_chunk_size;
template <> constexpr std::size_t chunk_size<OverlapArray> = overlap_chunk_size;

/// Computes chunk after chunk. It stops when there may be no room for the pairs that the next chunk leaves over.
template <class Rows, class Arrays>
[[gnu::flatten]] std::size_t compute(Rows const &rows, std::size_t n, Arrays const &out, Worklist &left_over) noexcept
{
    constexpr std::size_t chunk = chunk_size<Arrays>, last_begin = Worklist::largest_index + 1 - chunk;
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
[[gnu::flatten]] double evaluate_law(Law const &law, std::size_t n, double const *mu2, double *d_u) noexcept
{
    Pack sums = Pack(0.0);
    for (std::size_t k = 0; k < n; k += lanes) {
        std::size_t const left = n - k;
        LawValues const values = evaluate(law, load_numbers(mu2 + k, left));
        store_lanes(values.d_u, left, d_u + k);
        sums = sums + select(PackMask::from_bits(live_lanes(left)), values.u, Pack(0.0));
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < lanes; ++i) sum += sums[i];
    return sum;
}

template <class Rows, class Arrays> constexpr LaneKernel<Rows, Arrays> made(LaneKernel<Rows, Arrays> const &) noexcept
{
    return {compute<Rows, Arrays>, gather<Rows>};
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
