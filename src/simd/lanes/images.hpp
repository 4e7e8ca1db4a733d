// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The overlap test of one ellipsoid of a system and images of others, up to the first overlap.
/// simulation/verlet_list.cpp calls it.
#ifndef PW85_SIMD_LANES_IMAGES_HPP_INCLUDED
#define PW85_SIMD_LANES_IMAGES_HPP_INCLUDED

#include "../pairs.hpp"
#include "../targets.hpp"
#include "../worklist.hpp"

namespace pw85::detail::kernels {

/// The largest number of images that FindOverlap is given.
inline constexpr std::size_t most_images = 256;

/// Returns whether lanes find an overlap with one of n images. They stop at the first one. If they
/// find none, `rejected_lanes` has those that need the function for one pair.
using FindOverlap = bool(OneToImages const &, std::size_t n, Worklist &rejected_lanes) noexcept;

#define PW85_DECLARE_IMAGES(target, one_pair, lanes256, available)                                 \
    namespace target {                                                                             \
    FindOverlap find_overlap_of_images;                                                            \
    }
PW85_EACH_TARGET(PW85_DECLARE_IMAGES)
#undef PW85_DECLARE_IMAGES

namespace {

/// Returns the function of a target.
inline auto find_overlap_of(Target const &target) noexcept
{
    return PW85_OF_LANES(target, FindOverlap, find_overlap_of_images);
}

} // namespace
} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include "overlap.hpp"

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
} // namespace pw85::detail

#endif
#endif
