// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Boxes with sides along the axes, and tests of one box against eight others. tree.hpp, order.hpp
/// and periodicity.hpp include this file.
#ifndef PW85_NEIGHBORS_BOXES_HPP_INCLUDED
#define PW85_NEIGHBORS_BOXES_HPP_INCLUDED

#include <cstring>
#include <limits>

#include "../base/x86.hpp"

namespace pw85::detail::neighbors {

struct Box {
    double lower[3], upper[3];
};

/// The number of boxes per block.
inline constexpr int width = 8;

/// Eight boxes, stored coordinate by coordinate. An empty entry holds NaN, and intersects no box.
struct Block {
    double lower[3][width], upper[3][width];

    [[gnu::always_inline]] void set(int place, Box const &box) noexcept
    {
        for (int d = 0; d < 3; ++d) {
            lower[d][place] = box.lower[d];
            upper[d][place] = box.upper[d];
        }
    }

    [[gnu::always_inline]] Box get(int place) const noexcept
    {
        return {{lower[0][place], lower[1][place], lower[2][place]},
                {upper[0][place], upper[1][place], upper[2][place]}};
    }
};

static constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
static constexpr Box empty_box{{nan_value, nan_value, nan_value},
                               {nan_value, nan_value, nan_value}};

/// Returns the smallest box around two boxes. Either box may be empty.
static inline Box enclose(Box const &a, Box const &b) noexcept
{
    Box box;
    for (int d = 0; d < 3; ++d) {
        box.lower[d] =
            a.lower[d] < b.lower[d] || b.lower[d] != b.lower[d] ? a.lower[d] : b.lower[d];
        box.upper[d] =
            a.upper[d] > b.upper[d] || b.upper[d] != b.upper[d] ? a.upper[d] : b.upper[d];
    }
    return box;
}

static inline bool intersect(Box const &a, Box const &b) noexcept
{
    bool result = true;
    for (int d = 0; d < 3; ++d)
        result = result && a.lower[d] <= b.upper[d] && b.lower[d] <= a.upper[d];
    return result;
}

/// Returns the smallest box around the boxes of a block.
static inline Box enclose(Block const &block) noexcept
{
    Box box = empty_box;
    for (int place = 0; place < width; ++place) box = enclose(box, block.get(place));
    return box;
}

// intersecting(): bit k is set where `box` intersects box k of the block.

#if defined(PW85_X86_HAS_EIGHT)

static inline unsigned intersecting(Box const &box, Block const &block) noexcept
{
    x86::Mask both = 0xff;
    for (int d = 0; d < 3; ++d) {
        x86::Eight lower, upper;
        std::memcpy(&lower, block.lower[d], sizeof lower);
        std::memcpy(&upper, block.upper[d], sizeof upper);
        both = x86::compare<x86::less_or_equal>(lower, box.upper[d] - x86::Eight(), both);
        both = x86::compare<x86::greater_or_equal>(upper, box.lower[d] - x86::Eight(), both);
    }
    return both;
}

#elif defined(__SSE2__)

static inline unsigned intersecting(Box const &box, Block const &block) noexcept
{
#if defined(__AVX__)
    using Register = x86::Four;
#else
    using Register = x86::Two;
#endif
    constexpr int lanes = sizeof(Register) / sizeof(double);
    unsigned bits = 0;
    for (int k = 0; k < width; k += lanes) {
        Register both = reinterpret_cast<Register>(Register() == Register());
        for (int d = 0; d < 3; ++d) {
            Register lower, upper;
            std::memcpy(&lower, block.lower[d] + k, sizeof lower);
            std::memcpy(&upper, block.upper[d] + k, sizeof upper);
            both = x86::both(both, reinterpret_cast<Register>(lower <= box.upper[d]));
            both = x86::both(both, reinterpret_cast<Register>(upper >= box.lower[d]));
        }
        bits |= x86::signs(both) << k;
    }
    return bits;
}

#else

static inline unsigned intersecting(Box const &box, Block const &block) noexcept
{
    unsigned bits = 0;
    for (int k = 0; k < width; ++k) {
        unsigned one = 1;
        for (int d = 0; d < 3; ++d)
            one &= static_cast<unsigned>(block.lower[d][k] <= box.upper[d]) &
                   static_cast<unsigned>(block.upper[d][k] >= box.lower[d]);
        bits |= one << k;
    }
    return bits;
}

#endif

} // namespace pw85::detail::neighbors

#endif
