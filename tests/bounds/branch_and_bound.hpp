// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A proof that a function of a few angles is nowhere above a limit: by bounds on boxes, which are
/// halved where the bound is above it.
#ifndef PW85_TESTS_BOUNDS_BRANCH_AND_BOUND_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_BRANCH_AND_BOUND_HPP_INCLUDED

#include <algorithm>
#include <vector>

#include "unit_pair.hpp"

namespace pw85_bounds {

struct Proof {
    bool proved;
    long boxes;     ///< that were looked at
    double largest; ///< value that was seen
};

/// The first of two halves of a box replaces it; the second one is returned. They overlap by more
/// than the centers are rounded, for widths above 2^-20.
template <int N> Box<N> halve(Box<N> &box, int k)
{
    box.width[k] *= 0.5 * (1.0 + 0x1p-30);
    Box<N> other = box;
    box.center[k] -= box.width[k];
    other.center[k] += other.width[k];
    return other;
}

/// All angles from 0 to their ranges, and a little more.
template <int N> Box<N> whole_box(double const *ranges)
{
    Box<N> box;
    for (int k = 0; k < N; ++k) {
        box.center[k] = 0.5 * ranges[k];
        box.width[k] = box.center[k] * (1.0 + 0x1p-30);
    }
    return box;
}

/// Which angle to halve: that which moves the terms most. Its square counts as well: in the middle
/// of a wide range slopes may vanish.
template <int N> int angle_to_halve(Box<N> const &box, double (&variation)[std::size_t(N)])
{
    for (int k = 0; k < N; ++k)
        variation[k] = std::min(variation[k], 100.0) + 30.0 * box.width[k] * box.width[k];
    return static_cast<int>(std::max_element(variation, variation + N) - variation);
}

/// The value at the center of a box.
template <int N, class Function>
double value_at_center(Function &function, Box<N> box, double limit)
{
    for (double &width : box.width) width = 0.0;
    double variation[std::size_t(N)] = {};
    return function.bound(box, limit, variation);
}

/// The function has bound(box, limit, variation). The proof fails at a value above the limit, or
/// after so many boxes.
template <int N, class Function>
Proof prove(Function &function, double const *ranges, double limit, long most_boxes)
{
    std::vector<Box<N>> open{whole_box<N>(ranges)};
    Proof proof{false, 0, 0.0};
    for (; !open.empty() && proof.boxes < most_boxes; ++proof.boxes) {
        Box<N> box = open.back();
        open.pop_back();
        double variation[std::size_t(N)] = {};
        if (function.bound(box, limit, variation) <= limit) continue;
        if (proof.boxes % 64 == 0)
            proof.largest = std::max(proof.largest, value_at_center(function, box, limit));
        if (proof.largest > limit) return proof;
        open.push_back(halve(box, angle_to_halve(box, variation)));
        open.push_back(box);
    }
    proof.proved = open.empty();
    return proof;
}

} // namespace pw85_bounds

#endif
