/// @file
/// Distances of closest approach, one pair per lane: |d|/μ(d), by the contact function of the direction d.
#ifndef PW85_KERNELS_LANE_CLOSEST_APPROACH_HPP_INCLUDED
#define PW85_KERNELS_LANE_CLOSEST_APPROACH_HPP_INCLUDED

#include "lane_contact.hpp"

namespace pw85 {
namespace {

/// Pairs whose r12 is a direction: made of order one, as the function for one pair does. A direction of length zero becomes NaN.
struct DirectionRows {
    kernels::PairArrays arrays;

    PW85_INLINE LanePair load(std::size_t const *indices) const noexcept
    {
        LanePair pair = BatchRows{arrays}.load(indices);
        Pack const largest = largest_coordinate(pair.r12);
        for (int d = 0; d < 3; ++d) pair.r12[d] = pair.r12[d] / largest;
        return pair;
    }

    PW85_INLINE void prefetch(std::size_t, std::size_t) const noexcept {}
};

/// Replaces the μ² of neighbouring pairs by their distances. Pairs without one, and those whose μ² leaves the range of double, which
/// the distance does not, go to the function for one pair.
PW85_INLINE kernels::Failure to_distances(DirectionRows const &rows, std::size_t begin, std::size_t count,
                                          double *distance, kernels::ScalarKernels const &scalar) noexcept
{
    kernels::Failure first{0, 0};
    Vector<Pack, 3> const direction = load_neighbors(rows, begin, count).r12;
    double mu2[lanes];
    for (std::size_t i = 0; i < lanes; ++i) mu2[i] = distance[begin + (i < count ? i : count - 1)];
    Pack const squares = load_lanes<Pack>(mu2);
    unsigned const good = (squares > Pack(0.0) && squares <= Pack(largest_number<double>())).to_bits();
    store(square_root(dot(direction, direction)) / square_root(squares), count, distance + begin);
    for (unsigned bits = live_lanes(count) & ~good; bits != 0; bits &= bits - 1) {
        std::size_t const i = begin + static_cast<unsigned>(__builtin_ctz(bits));
        kernels::PairArrays const &a = rows.arrays;
        first.update({i, scalar.closest_approach(a.r12 + 3 * i, a.q1 + 6 * i, a.q2 + 6 * i, distance + i)});
    }
    return first;
}

/// The distances of a range of pairs.
[[gnu::flatten]] inline kernels::Failure closest_approach_rows(DirectionRows const &rows, kernels::Range range,
                                                               double *distance,
                                                               kernels::ScalarKernels const &scalar) noexcept
{
    kernels::Failure first{0, 0};
    contact_rows(rows, range, {distance, nullptr}, scalar);
    for (std::size_t begin = range.begin; begin < range.end; begin += lanes)
        first.update(to_distances(rows, begin, range.end - begin, distance, scalar));
    return first;
}

} // namespace
} // namespace pw85

#endif
