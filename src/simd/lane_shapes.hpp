// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The kernels for ellipsoids and convex sets, one ellipsoid per lane: the contact functions with
/// segments, triangles and boxes, and whether they overlap (lanes_shapes.cpp); the parts of lines
/// in ellipsoids (lanes_lines.cpp).
///
/// The formulas are those of one ellipsoid. Rows that fail the fast checks, and rows for which the
/// digits do not suffice, are left over.
#ifndef PW85_SIMD_LANE_SHAPES_HPP_INCLUDED
#define PW85_SIMD_LANE_SHAPES_HPP_INCLUDED

#include <pw85/distance/line.hpp>
#include <pw85/shapes/overlap_shapes.hpp>

#include "lane_derivatives.hpp"
#include "lane_overlap.hpp"

namespace pw85::detail {
namespace {

/// Loads consecutive rows of N numbers. Lanes beyond the last row repeat it.
template <int N, class Columns>
PW85_INLINE void load_rows(double const *first, std::size_t count, Columns &columns) noexcept
{
#if defined(PW85_LANES_AVX512)
    if (count >= lanes) return load_eight_rows(first, columns);
#endif
    double const *rows[lanes];
    for (std::size_t i = 0; i < lanes; ++i)
        rows[i] = kernels::row_of(first, N, i < count ? i : count - 1);
    ColumnLoader<Pack, N>::load(rows, &columns[0]);
}

PW85_INLINE Hull<Pack, 2> set_of(kernels::Segments, Vector<Pack, 3> const (&ends)[2]) noexcept
{
    return {{ends[0], ends[1]}};
}

PW85_INLINE Hull<Pack, 3> set_of(kernels::Triangles, Vector<Pack, 3> const (&vertices)[3]) noexcept
{
    return {{vertices[0], vertices[1], vertices[2]}};
}

PW85_INLINE SolidBox<Pack> set_of(kernels::Boxes, Vector<Pack, 3> const (&corners)[2]) noexcept
{
    return {corners[0], corners[1]};
}

struct Line {
    Vector<Pack, 3> origin, direction;
};

PW85_INLINE Line set_of(kernels::Lines, Vector<Pack, 3> const (&points)[2]) noexcept
{
    return {points[0], points[1]};
}

/// Calls write(set, form) for the pack of a chunk. It returns the lanes that are done; the other
/// rows are left over.
template <class Set, class Write>
PW85_INLINE void set_chunk(kernels::SetRows<Set> const &rows, Chunk const &chunk,
                           kernels::Worklist &rejected_lanes, Write const &write) noexcept
{
    auto const from = rows.from(chunk.begin);
    Vector<Pack, 3> points[Set::num_points];
    SymmetricMatrix<Pack, 3> q;
    for (int k = 0; k < Set::num_points; ++k) load_rows<3>(from.points[k], chunk.count, points[k]);
    load_rows<6>(from.q, chunk.count, q);
    PackMask const done = write(set_of(Set{}, points), q);
    for_lanes(live_lanes(chunk.count) & ~done.to_bits(),
              [&](unsigned i) { rejected_lanes.push(chunk.begin + i); });
}

/// Stores the contact functions of a chunk. scalar_fallback() overwrites those that are not
/// certain.
template <class Set> PW85_INLINE void compute_chunk(kernels::SetRows<Set> const &rows,
                                                    Chunk const &chunk,
                                                    kernels::SetContactArrays const &out,
                                                    kernels::Worklist &rejected_lanes) noexcept
{
    set_chunk(rows, chunk, rejected_lanes, [&](auto const &set, SymmetricMatrix<Pack, 3> const &q) {
        auto const nearest = set.template nearest<false>(q);
        auto const part = out.from(chunk.begin);
        if (part.mu2 != nullptr) store_lanes(nearest.mu2, chunk.count, part.mu2);
        if (part.point != nullptr) store_rows(nearest.point, chunk.count, part.point);
        return nearest.certified && set.passes_checks(q);
    });
}

/// Stores whether the sets of a chunk overlap. scalar_fallback() overwrites the answers that are
/// not certain.
template <class Set> PW85_INLINE void compute_chunk(kernels::SetRows<Set> const &rows,
                                                    Chunk const &chunk,
                                                    kernels::OverlapArray const &out,
                                                    kernels::Worklist &rejected_lanes) noexcept
{
    set_chunk(rows, chunk, rejected_lanes, [&](auto const &set, SymmetricMatrix<Pack, 3> const &q) {
        auto const certainty = decide_at(set, q, set.template nearest<true>(q));
        store_answers(certainty.overlap.to_bits(), chunk.count, out.overlap + chunk.begin);
        return (certainty.apart || certainty.overlap) && set.passes_checks(q);
    });
}

/// Stores the ends of the chords of a chunk: NaN where a line misses.
PW85_INLINE void compute_chunk(kernels::SetRows<kernels::Lines> const &rows, Chunk const &chunk,
                               kernels::ChordArrays const &out,
                               kernels::Worklist &rejected_lanes) noexcept
{
    set_chunk(rows, chunk, rejected_lanes, [&](Line const &line, auto const &q) {
        auto const [middle, half2] = chord(line.origin, line.direction, q);
        Pack const half = select(half2 >= Pack(0.0), square_root(half2), Pack(quiet_nan<double>()));
        auto const part = out.from(chunk.begin);
        if (part.enter != nullptr) store_lanes(middle - half, chunk.count, part.enter);
        if (part.leave != nullptr) store_lanes(middle + half, chunk.count, part.leave);
        return has_clear_chord(line.origin, line.direction, q);
    });
}

} // namespace
} // namespace pw85::detail

#endif
