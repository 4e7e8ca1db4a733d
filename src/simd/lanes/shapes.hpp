// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Many ellipsoids, with their centres at 0, and convex sets, one ellipsoid per lane: the contact
/// functions with segments, triangles and boxes, and whether they overlap.
///
/// The formulas are those of one ellipsoid. Rows that fail the fast checks, and rows for which the
/// digits do not suffice, are left over.
#ifndef PW85_SIMD_LANES_SHAPES_HPP_INCLUDED
#define PW85_SIMD_LANES_SHAPES_HPP_INCLUDED

#include "../pairs.hpp"
#include "overlap.hpp"

namespace pw85::detail::kernels {

/// Kinds of sets, by the points that give one: the ends of a segment, the vertices of a triangle,
/// two corners of a box.
struct Segments {
    static constexpr int num_points = 2;
};
struct Triangles {
    static constexpr int num_points = 3;
};
struct Boxes {
    static constexpr int num_points = 2;
};

/// Arrays of points (n×3 each) and of forms (n×6).
template <class Set> struct SetRows {
    double const *points[Set::num_points], *q;

    [[gnu::always_inline]] SetRows from(std::size_t begin) const noexcept
    {
        SetRows rest = *this;
        for (auto &x : rest.points) x = row_of(x, 3, begin);
        rest.q = row_of(q, 6, begin);
        return rest;
    }
};

/// Contact functions with sets, and points of contact. Any pointer may be null.
struct SetContactArrays {
    double *mu2, *point;

    [[gnu::always_inline]] SetContactArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(mu2, 1, begin), row_or_null(point, 3, begin)};
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/shapes/overlap_shapes.hpp>

namespace pw85::detail {
namespace {

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

template <class Set, class Arrays> constexpr std::size_t chunk_size<kernels::SetRows<Set>, Arrays> =
    lanes;
template <class Set>
constexpr std::size_t chunk_size<kernels::SetRows<Set>, kernels::OverlapArray> = lanes;

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

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

namespace pw85::detail::kernels {

static inline int scalar_fallback(SetRows<Segments> const &row,
                                  SetContactArrays const &out) noexcept
{
    return pw85_contact_segment(row.points[0], row.points[1], row.q, out.mu2, out.point);
}

static inline int scalar_fallback(SetRows<Triangles> const &row,
                                  SetContactArrays const &out) noexcept
{
    return pw85_contact_triangle(row.points[0], row.points[1], row.points[2], row.q, out.mu2,
                                 out.point);
}

static inline int scalar_fallback(SetRows<Boxes> const &row, SetContactArrays const &out) noexcept
{
    return pw85_contact_box(row.points[0], row.points[1], row.q, out.mu2, out.point);
}

static inline int overlap_of_one(SetRows<Segments> const &row, int *overlap) noexcept
{
    return pw85_overlap_segment(row.points[0], row.points[1], row.q, overlap);
}

static inline int overlap_of_one(SetRows<Triangles> const &row, int *overlap) noexcept
{
    return pw85_overlap_triangle(row.points[0], row.points[1], row.points[2], row.q, overlap);
}

static inline int overlap_of_one(SetRows<Boxes> const &row, int *overlap) noexcept
{
    return pw85_overlap_box(row.points[0], row.points[1], row.q, overlap);
}

template <class Set>
static int scalar_fallback(SetRows<Set> const &row, OverlapArray const &out) noexcept
{
    int overlap = -1;
    int const status = overlap_of_one(row, &overlap);
    *out.overlap = static_cast<unsigned char>(overlap); // -1, for a bad row, becomes 255
    return status;
}

} // namespace pw85::detail::kernels

#endif
#endif
