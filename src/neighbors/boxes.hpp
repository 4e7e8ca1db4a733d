/// @file
/// Boxes with sides along the axes, eight at a time.
#ifndef PW85_NEIGHBORS_BOXES_HPP_INCLUDED
#define PW85_NEIGHBORS_BOXES_HPP_INCLUDED

#include <algorithm>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pw85::detail::neighbors {

struct Box {
    double lower[3], upper[3];
};

/// Boxes per block.
inline constexpr int width = 8;

/// Eight boxes, coordinate by coordinate. A place without a box has NaN, which meets nothing.
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

static constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
static constexpr Box no_box{{no_number, no_number, no_number}, {no_number, no_number, no_number}};

/// The box around two, or around the other one where one is no box.
static inline Box enclose(Box const &a, Box const &b) noexcept
{
    Box box;
    for (int d = 0; d < 3; ++d) {
        box.lower[d] = a.lower[d] < b.lower[d] || b.lower[d] != b.lower[d] ? a.lower[d] : b.lower[d];
        box.upper[d] = a.upper[d] > b.upper[d] || b.upper[d] != b.upper[d] ? a.upper[d] : b.upper[d];
    }
    return box;
}

static inline bool meets(Box const &a, Box const &b) noexcept
{
    bool meet = true;
    for (int d = 0; d < 3; ++d) meet = meet && a.lower[d] <= b.upper[d] && b.lower[d] <= a.upper[d];
    return meet;
}

/// The box around those of a block.
static inline Box enclose(Block const &block) noexcept
{
    Box box = no_box;
    for (int place = 0; place < width; ++place) box = enclose(box, block.get(place));
    return box;
}

/// Bit k is set where a box meets box k of a block.
static inline unsigned meeting(Box const &box, Block const &block) noexcept
{
    unsigned bits = 0;
#ifdef __SSE2__
    for (int k = 0; k < width; k += 2) {
        __m128d meet = _mm_castsi128_pd(_mm_set1_epi32(-1));
        for (int d = 0; d < 3; ++d) {
            meet = _mm_and_pd(meet, _mm_cmple_pd(_mm_loadu_pd(block.lower[d] + k), _mm_set1_pd(box.upper[d])));
            meet = _mm_and_pd(meet, _mm_cmpge_pd(_mm_loadu_pd(block.upper[d] + k), _mm_set1_pd(box.lower[d])));
        }
        bits |= static_cast<unsigned>(_mm_movemask_pd(meet)) << k;
    }
#else
    for (int k = 0; k < width; ++k) {
        unsigned meet = 1;
        for (int d = 0; d < 3; ++d)
            meet &= static_cast<unsigned>(block.lower[d][k] <= box.upper[d]) &
                    static_cast<unsigned>(block.upper[d][k] >= box.lower[d]);
        bits |= meet << k;
    }
#endif
    return bits;
}

} // namespace pw85::detail::neighbors

#endif
