// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of many lines in ellipsoids with their centres at 0, one line per lane, with the bits
/// of one line. Lines without a clear chord are left over.
#ifndef PW85_SIMD_LANES_LINES_HPP_INCLUDED
#define PW85_SIMD_LANES_LINES_HPP_INCLUDED

#include "../pairs.hpp"
#include "shapes.hpp"

namespace pw85::detail::kernels {

/// Straight lines, by an origin and a direction.
struct Lines {
    static constexpr int num_points = 2;
};

/// Ends of the parts of lines that are in ellipsoids. Any pointer may be null.
struct ChordArrays {
    double *enter, *leave;

    PW85_MEMBER ChordArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(enter, 1, begin), row_or_null(leave, 1, begin)};
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/distance/line.hpp>

namespace pw85::detail {

struct Line {
    Vector<Pack, 3> origin, direction;
};

static PW85_INLINE Line set_of(kernels::Lines, Vector<Pack, 3> const (&points)[2]) noexcept
{
    return {points[0], points[1]};
}

namespace {

/// Stores the ends of the chords of a chunk: NaN where a line misses.
PW85_INLINE void compute_chunk(kernels::SetRows<kernels::Lines> const &rows, Chunk const &chunk,
                               kernels::ChordArrays const &out,
                               kernels::Worklist &rejected_lanes) noexcept
{
    set_chunk(rows, chunk, rejected_lanes, [&](Line const &line, auto const &q) {
        auto const [middle, half2] = chord(line.origin, line.direction, q);
        Pack const half = square_root(half2);
        // A compiler may compute x - NaN as x + (-NaN). So the ends are selected, and not the half.
        auto const if_hit = [hits = half2 >= Pack(0.0)](Pack const &end) {
            return select(hits, end, Pack(quiet_nan<double>()));
        };
        auto const part = out.from(chunk.begin);
        if (part.enter != nullptr) store_lanes(if_hit(middle - half), chunk.count, part.enter);
        if (part.leave != nullptr) store_lanes(if_hit(middle + half), chunk.count, part.leave);
        return has_clear_chord(line.origin, line.direction, q);
    });
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

namespace pw85::detail::kernels {

static inline int scalar_fallback(SetRows<Lines> const &row, ChordArrays const &out) noexcept
{
    double t[2];
    int const status = pw85_intersect_line(row.points[0], row.points[1], row.q, t);
    if (out.enter != nullptr) *out.enter = t[0];
    if (out.leave != nullptr) *out.leave = t[1];
    return status;
}

} // namespace pw85::detail::kernels

#endif
#endif
