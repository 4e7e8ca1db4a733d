// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The kernels for distances from an ellipsoid's surface, one row per lane, with the bits of one
/// row: from points, and from cylinders around.
///
/// The searches are those of one row (distance/nearest.hpp), in the units of the caller. They give
/// the bits of one row, which scales by powers of two, where no number overflows or underflows in
/// either. Other rows are left over.
#ifndef PW85_SIMD_LANES_SURFACE_DISTANCES_HPP_INCLUDED
#define PW85_SIMD_LANES_SURFACE_DISTANCES_HPP_INCLUDED

#include "../pairs.hpp"

namespace pw85::detail::kernels {

/// Arrays of points (n×3) and of ellipsoids around the origin (n×6).
struct PointRows {
    double const *r, *q;

    PW85_MEMBER PointRows from(std::size_t begin) const noexcept
    {
        return {row_of(r, 3, begin), row_of(q, 6, begin)};
    }
};

/// Arrays of cylinders around the origin, by their axes (n×3) and radii, and of ellipsoids: centres
/// (n×3) and forms (n×6).
struct CylinderRows {
    double const *axis, *radius, *center, *q;

    PW85_MEMBER CylinderRows from(std::size_t begin) const noexcept
    {
        return {row_of(axis, 3, begin), radius + begin, row_of(center, 3, begin),
                row_of(q, 6, begin)};
    }
};

/// Distances, and the points and unit normals of the surface. Any pointer may be null.
struct SurfaceArrays {
    /// fifty to a hundred microseconds of work
    static constexpr std::size_t rows_of_block = 1024;
    double *distance, *point, *normal;

    PW85_MEMBER SurfaceArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(distance, 1, begin), row_or_null(point, 3, begin),
                row_or_null(normal, 3, begin)};
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/distance/walls.hpp>

namespace pw85::detail {
namespace {

/// Returns whether each coordinate is zero, or so large that none of its products underflows.
template <int D> PW85_INLINE PackMask is_clear_of_zero(Vector<Pack, D> const &x) noexcept
{
    PackMask clear = x[0] == x[0];
    for (int i = 0; i < D; ++i)
        clear = clear && (x[i] == Pack(0.0) || absolute(x[i]) > negative_power_of_two<Pack>(255));
    return clear;
}

PW85_INLINE PackMask is_form_in_range(SymmetricMatrix<Pack, 3> const &q) noexcept
{
    Pack const largest = largest_diagonal(q);
    return is_in_range(largest, largest, largest) && is_clearly_definite(q);
}

/// A point and an ellipsoid.
struct PointPack {
    static constexpr int dimension = 3;
    static constexpr bool nearest = true;
    Vector<Pack, 3> r;
    SymmetricMatrix<Pack, 3> q;

    PW85_INLINE void load(kernels::PointRows const &rows, std::size_t count) noexcept
    {
        load_rows<3>(rows.r, count, r);
        load_rows<6>(rows.q, count, q);
    }

    PW85_INLINE SymmetricMatrix<Pack, 3> const &form() const noexcept { return q; }
    PW85_INLINE Vector<Pack, 3> const &point() const noexcept { return r; }

    PW85_INLINE SurfaceDistance<Pack, 3> distance(Vector<Pack, 3> const &n) const noexcept
    {
        Support<Pack, 3> const s = support(q, n);
        return {dot(n, r) - s.extent, s.point, n, StatusCode::success};
    }

    PW85_INLINE PackMask is_clear() const noexcept
    {
        return sum_of_magnitudes(r) < unscaled_limit<Pack>() && is_clear_of_zero(r) &&
               is_form_in_range(q);
    }
};

/// An ellipsoid in a cylinder.
struct CylinderPack {
    static constexpr int dimension = 2;
    static constexpr bool nearest = false;
    Vector<Pack, 3> axis, center;
    SymmetricMatrix<Pack, 3> q;
    Pack radius;
    CrossSection<Pack> section;

    PW85_INLINE void load(kernels::CylinderRows const &rows, std::size_t count) noexcept
    {
        load_rows<3>(rows.axis, count, axis);
        load_rows<3>(rows.center, count, center);
        load_rows<6>(rows.q, count, q);
        radius = load_numbers(rows.radius, count);
        axis = axis / largest_coordinate(axis);
        section = cross_section(unit_along(axis), center, q);
    }

    PW85_INLINE SymmetricMatrix<Pack, 2> const &form() const noexcept { return section.form; }
    PW85_INLINE Vector<Pack, 2> const &point() const noexcept { return section.center; }

    PW85_INLINE SurfaceDistance<Pack, 3> distance(Vector<Pack, 2> const &n2) const noexcept
    {
        Vector<Pack, 3> const n = in_space(section, n2);
        Support<Pack, 3> const s = support(q, n);
        return {radius - dot(n2, section.center) - s.extent, s.point, n, StatusCode::success};
    }

    PW85_INLINE PackMask is_clear() const noexcept
    {
        return sum_of_magnitudes(center) < unscaled_limit<Pack>() && radius > Pack(0.0) &&
               radius < infinity<Pack>() && is_clear_of_zero(axis) && is_clear_of_zero(center) &&
               is_clear_of_zero(section.center) &&
               is_clear_of_zero(Vector<Pack, 3>{q[1], q[2], q[4]}) && is_form_in_range(q);
    }
};

/// Stores the distances of a chunk. scalar_fallback() overwrites those that are not certain.
template <class Row, class Rows>
PW85_INLINE void surface_chunk(Rows const &rows, Chunk const &chunk,
                               kernels::SurfaceArrays const &out,
                               kernels::Worklist &rejected_lanes) noexcept
{
    constexpr int dimension = Row::dimension;
    Row row[packs_per_chunk];
    AxesSearch<Pack, dimension> axes[packs_per_chunk];
    ShiftSearch<Pack, dimension> shifts[packs_per_chunk];
    std::size_t const packs = (chunk.count + lanes - 1) / lanes;
    for (std::size_t k = 0; k < packs; ++k) {
        row[k].load(rows.from(chunk.begin + k * lanes), chunk.count - k * lanes);
        axes[k] = start_axes_search(row[k].form());
    }
    run(axes, packs, max_axes_steps, [&](std::size_t k) { take_step(axes[k]); });
    for (std::size_t k = 0; k < packs; ++k)
        shifts[k] =
            start_shift_search(axis_components(found_axes(axes[k]), row[k].point(), Row::nearest));
    run(shifts, packs, max_shift_steps, [&](std::size_t k) { take_step(shifts[k]); });
    for (std::size_t k = 0; k < packs; ++k) {
        std::size_t const first = chunk.begin + k * lanes, left = chunk.count - k * lanes;
        auto const d = row[k].distance(normal_at(found_axes(axes[k]), shifts[k]));
        auto const part = out.from(first);
        if (part.distance != nullptr) store_lanes(d.distance, left, part.distance);
        if (part.point != nullptr) store_rows(d.point, left, part.point);
        if (part.normal != nullptr) store_rows(d.normal, left, part.normal);
        for_lanes(live_lanes(left) & ~row[k].is_clear().to_bits(),
                  [&](unsigned i) { rejected_lanes.push(first + i); });
    }
}

PW85_INLINE void compute_chunk(kernels::PointRows const &rows, Chunk const &chunk,
                               kernels::SurfaceArrays const &out,
                               kernels::Worklist &rejected_lanes) noexcept
{
    surface_chunk<PointPack>(rows, chunk, out, rejected_lanes);
}

PW85_INLINE void compute_chunk(kernels::CylinderRows const &rows, Chunk const &chunk,
                               kernels::SurfaceArrays const &out,
                               kernels::Worklist &rejected_lanes) noexcept
{
    surface_chunk<CylinderPack>(rows, chunk, out, rejected_lanes);
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

namespace pw85::detail::kernels {

static inline int scalar_fallback(PointRows const &row, SurfaceArrays const &out) noexcept
{
    return pw85_distance_point(row.r, row.q, out.distance, out.point, out.normal);
}

static inline int scalar_fallback(CylinderRows const &row, SurfaceArrays const &out) noexcept
{
    return pw85_distance_cylinder(row.axis, *row.radius, row.center, row.q, out.distance, out.point,
                                  out.normal);
}

} // namespace pw85::detail::kernels

#endif
#endif
