// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rows that functions of many pairs read, and the arrays that they write, by the same index.
/// They are plain data and the same for every target, because units that are compiled for different
/// processors exchange them. lanes.hpp has the functions.
#ifndef PW85_SIMD_KERNELS_HPP_INCLUDED
#define PW85_SIMD_KERNELS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#include <pw85/attributes.hpp>

#include "../periodic/lattice.hpp"

struct
    // Declared here, because pw85.h includes a header that the build makes, and code for devices
    // has none.
    pw85_motion;

namespace pw85::detail::kernels {

/// Row `index` of an array of rows of `width` numbers.
template <class Number> [[gnu::always_inline]] PW85_FUNCTION inline Number *
row_of(Number *rows, int width, std::size_t index) noexcept
{
    return rows + static_cast<std::size_t>(width) * index;
}

/// Returns the pointer to a row of an array that may be null.
template <class Number> [[gnu::always_inline]] PW85_FUNCTION inline Number *
row_or_null(Number *rows, int width, std::size_t index) noexcept
{
    return rows == nullptr ? nullptr : row_of(rows, width, index);
}

// Rows of pairs. from(k) is the same rows without the first k.

/// Arrays of separations and forms: n×3, n×6, n×6 in three dimensions.
template <int D> struct PairArrays {
    static constexpr int dimension = D;
    static constexpr int form = D * (D + 1) / 2;
    double const *r12, *q1, *q2;

    PW85_MEMBER PairArrays from(std::size_t begin) const noexcept
    {
        return {row_of(r12, D, begin), row_of(q1, form, begin), row_of(q2, form, begin)};
    }
};

/// Pairs with a direction instead of the separation. Its length does not matter.
struct Directions {
    static constexpr int dimension = 3;
    PairArrays<3> arrays;

    PW85_MEMBER Directions from(std::size_t begin) const noexcept { return {arrays.from(begin)}; }
};

/// One ellipsoid and n others: r12 n×3, q2 n×6.
struct OneToMany {
    static constexpr int dimension = 3;
    double const *q1, *r12, *q2;

    PW85_MEMBER OneToMany from(std::size_t begin) const noexcept
    {
        return {q1, row_of(r12, 3, begin), row_of(q2, 6, begin)};
    }
};

/// One ellipsoid and others of a system, given by their indices. Images are chosen as for
/// NeighborList.
struct OneToIndexed {
    static constexpr int dimension = 3;
    double const *center, *q1;
    std::int32_t const *others;
    double const *centers, *q;
    std::int32_t const *images; ///< null, or one row for each of the others
    double const *cell;         ///< null without periodicity
    Lattice const *lattice;     ///< null, or prepared for nearest images

    [[gnu::always_inline]] OneToIndexed from(std::size_t begin) const noexcept
    {
        return {center, q1,     others + begin, centers, q, row_or_null(images, 3, begin),
                cell,   lattice};
    }
};

/// A neighbour list: pairs (i, j) of rows of centers (N×3) and q (N×6). `images` gives the image of
/// j as multiples of the rows of `cell`. Without `images` the image is the nearest one in the
/// lattice. Without both it is j itself.
struct NeighborList {
    static constexpr int dimension = 3;
    std::int32_t const *pairs;
    double const *centers, *q;
    std::int32_t const *images; ///< null, or one row per pair
    double const *cell;         ///< null without periodicity
    Lattice const *lattice;     ///< null, or prepared for nearest images

    PW85_MEMBER NeighborList from(std::size_t begin) const noexcept
    {
        return {row_of(pairs, 2, begin), centers, q, row_or_null(images, 3, begin), cell, lattice};
    }
};

/// The numbers of one pair.
template <int D> struct PairRow {
    double r12[std::size_t(D)], q1[std::size_t(D * (D + 1) / 2)], q2[std::size_t(D * (D + 1) / 2)];
};

// Ellipsoids with their centres at 0, and convex sets.

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
/// Straight lines, by an origin and a direction.
struct Lines {
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

// Output arrays, one row per pair, with from() as above.

/// Contact functions.
struct ContactArrays {
    double *mu2, *lambda; ///< lambda may be null

    PW85_MEMBER ContactArrays from(std::size_t begin) const noexcept
    {
        return {row_of(mu2, 1, begin), row_or_null(lambda, 1, begin)};
    }
};

/// Results of the overlap test: 1, 0, or 255 for a bad pair.
struct OverlapArray {
    unsigned char *overlap;

    PW85_MEMBER OverlapArray from(std::size_t begin) const noexcept { return {overlap + begin}; }
};

/// Areas of common parts.
struct AreaArray {
    double *area;

    PW85_MEMBER AreaArray from(std::size_t begin) const noexcept { return {area + begin}; }
};

/// Distances of closest approach.
struct ApproachArray {
    double *distance;

    PW85_MEMBER ApproachArray from(std::size_t begin) const noexcept { return {distance + begin}; }
};

/// Distances and closest points. Any pointer may be null.
struct DistanceArrays {
    double *distance, *point1, *point2;

    [[gnu::always_inline]] DistanceArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(distance, 1, begin), row_or_null(point1, 3, begin),
                row_or_null(point2, 3, begin)};
    }
};

/// Closest passages, and the paths: the velocities, three numbers per pair, and the end of the time
/// are input. `t` may be null.
struct PassageArrays {
    double *mu2, *t;
    double const *velocities;
    double t_max;

    [[gnu::always_inline]] PassageArrays from(std::size_t begin) const noexcept
    {
        return {mu2 + begin, row_or_null(t, 1, begin), row_of(velocities, 3, begin), t_max};
    }
};

/// Contacts of grains, and the directions from which the searches start, which are input. Any
/// pointer but `starts` may be null.
struct GrainArrays {
    double const *starts;
    double *normal, *depth, *point, *curvatures, *radius;

    [[gnu::always_inline]] GrainArrays from(std::size_t begin) const noexcept
    {
        return {row_of(starts, 3, begin),          row_or_null(normal, 3, begin),
                row_or_null(depth, 1, begin),      row_or_null(point, 3, begin),
                row_or_null(curvatures, 2, begin), row_or_null(radius, 1, begin)};
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

/// Ends of the parts of lines that are in ellipsoids. Any pointer may be null.
struct ChordArrays {
    double *enter, *leave;

    PW85_MEMBER ChordArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(enter, 1, begin), row_or_null(leave, 1, begin)};
    }
};

/// Contact functions and derivatives. Any pointer may be null, except that kernels need `lambda`:
/// they set it to NaN for pairs that they leave over without a certain λ.
struct DerivativeArrays {
    double *mu2, *lambda;
    double *point, *normal, *d_r12, *d_rot1, *d_rot2; ///< three numbers per pair
    /// the separations of the images that the kernel chose
    double *r12 = nullptr;

    PW85_MEMBER DerivativeArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(mu2, 1, begin),    row_or_null(lambda, 1, begin),
                row_or_null(point, 3, begin),  row_or_null(normal, 3, begin),
                row_or_null(d_r12, 3, begin),  row_or_null(d_rot1, 3, begin),
                row_or_null(d_rot2, 3, begin), row_or_null(r12, 3, begin)};
    }
};

// Rows and arrays that a header of their own defines, with all that belongs to their kernels.

struct PointRows; // surface_distances.hpp
struct CylinderRows;
struct SurfaceArrays;

// Laws: energies U(μ²) of pairs.

/// U = ε/α (1 - μ)^α for μ < 1, otherwise 0.
struct SoftRepulsion {
    double energy, exponent;
};

/// U = A μ^-n - B μ^-m - `shift` for μ² < `mu2_max`, otherwise 0.
struct InversePowers {
    double repulsion, n, attraction, m, mu2_max, shift;
};

/// U by cubic Hermite interpolation between points that are equally spaced in μ², and 0 from the
/// last point on. The derivative is that of the polynomial, so forces conserve the energy. Before
/// the first point, U is linear.
struct LawTable {
    double mu2_min, mu2_max;
    std::size_t intervals;
    double const *points; ///< U and its derivative, two numbers per point
};

/// The sum of U over some pairs, and the number of pairs whose derivative is not zero.
struct LawSums {
    double energy;
    std::size_t with_force;
};

} // namespace pw85::detail::kernels

#endif
