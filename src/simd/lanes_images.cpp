// SPDX-License-Identifier: BSD-3-Clause
// Lanes: one ellipsoid of a simulation and images of others. It is compiled once per instruction
// set.
#include "images.hpp" // before the templates that call its load_pairs()

#include "lane_overlap.hpp"

namespace pw85::detail {
namespace {

static_assert(kernels::most_images <= overlap_chunk_size);

/// Makes the first test, up to the first pack with an overlap. Returns whether there is one.
PW85_INLINE bool test_first(kernels::OneToImages const &rows, std::size_t n,
                            UndecidedList &undecided, kernels::Worklist &rejected_lanes) noexcept
{
    for (std::size_t k = 0; k < n; k += lanes) {
        std::size_t const left = n - k;
        auto const pair = load_consecutive(rows, k, left);
        unsigned const live = live_lanes(left), passing = live & passes_fast_checks(pair).to_bits();
        LaneCertainty const certainty = test_lanes(pair, first_point(pair));
        if ((certainty.overlap & passing) != 0) return true;
        for_lanes(passing & ~certainty.decided,
                  [&](unsigned i) { undecided.push(k + i, certainty.next[i]); });
        for_lanes(live & ~passing, [&](unsigned i) { rejected_lanes.push(k + i); });
    }
    return false;
}

/// All further tests of the pairs that the first one left undecided.
[[gnu::noinline, gnu::flatten]] bool test_again(kernels::OneToImages const &rows, std::size_t n,
                                                UndecidedList &undecided,
                                                kernels::Worklist &rejected_lanes) noexcept
{
    unsigned char answers[kernels::most_images];
    std::memset(answers, 0, n);
    for (int i = 0; i < 2; ++i) test_undecided(rows, answers, undecided);
    if (undecided.pairs.size > 0) test_converged(rows, answers, undecided.pairs, rejected_lanes);
    return std::memchr(answers, 1, n) != nullptr;
}

} // namespace

namespace kernels::PW85_COMPILED_FOR {

[[gnu::flatten]] bool find_overlap_of_images(OneToImages const &rows, std::size_t n,
                                             Worklist &rejected_lanes) noexcept
{
    UndecidedList undecided;
    rejected_lanes.size = 0;
    return test_first(rows, n, undecided, rejected_lanes) ||
           (undecided.pairs.size > 0 && test_again(rows, n, undecided, rejected_lanes));
}

} // namespace kernels::PW85_COMPILED_FOR

} // namespace pw85::detail
