// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The interface to the functions that are compiled once per instruction set. one_pair.cpp, one_set.cpp and lanes.cpp implement it,
/// dispatch.cpp chooses the instruction set, and the C API calls chosen().
///
/// The types here are plain data and the same for every target, because units that are compiled for different processors exchange
/// them. A kernel has two types: the rows that it reads, and the arrays that it writes, by the same index. To add a kernel:
/// 1. list its types in LaneKernels, and define them here if they are new;
/// 2. write compute_chunk() for its arrays, in a header that lanes.cpp includes;
/// 3. write settle() for a pair that lanes leave over (many_pairs.hpp).
#ifndef PW85_KERNELS_KERNELS_HPP_INCLUDED
#define PW85_KERNELS_KERNELS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#include <pw85/attributes.hpp>

#include "lattice.hpp"
#include "worklist.hpp"

struct
    pw85_motion; // Declared here, because pw85.h includes a header that the build makes, and code for devices has none.

namespace pw85::detail::kernels {

/// Row `index` of an array of rows of `width` numbers.
template <class Number>
[[gnu::always_inline]] PW85_FUNCTION inline Number *row_of(Number *rows, int width, std::size_t index) noexcept
{
    return rows + static_cast<std::size_t>(width) * index;
}

/// The same for an array that may be null.
template <class Number>
[[gnu::always_inline]] PW85_FUNCTION inline Number *row_or_null(Number *rows, int width, std::size_t index) noexcept
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

/// One ellipsoid and others of a system, given by their indices. Images are chosen as for NeighborList.
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
        return {center, q1, others + begin, centers, q, row_or_null(images, 3, begin), cell, lattice};
    }
};

/// A neighbour list: pairs (i, j) of rows of centers (N×3) and q (N×6). `images` gives the image of j as multiples of the rows of
/// `cell`. Without `images` the image is the nearest one in the lattice. Without both it is j itself.
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

/// Kinds of sets, by the points that give one: the ends of a segment, the vertices of a triangle, two corners of a box.
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
        return {row_or_null(distance, 1, begin), row_or_null(point1, 3, begin), row_or_null(point2, 3, begin)};
    }
};

/// Closest passages, and the ways: the velocities, three numbers per pair, and the end of the time are input. `t` may be null.
struct PassageArrays {
    double *mu2, *t;
    double const *velocities;
    double t_max;

    [[gnu::always_inline]] PassageArrays from(std::size_t begin) const noexcept
    {
        return {mu2 + begin, row_or_null(t, 1, begin), row_of(velocities, 3, begin), t_max};
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

/// Contact functions and derivatives. Any pointer may be null, except that kernels need `lambda`: they set it to NaN for pairs that
/// they leave over without a certain λ.
struct DerivativeArrays {
    double *mu2, *lambda;
    double *point, *normal, *d_r12, *d_rot1, *d_rot2; ///< three numbers per pair
    double *r12 = nullptr;                            ///< the separations of the images that the kernel chose

    PW85_MEMBER DerivativeArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(mu2, 1, begin),    row_or_null(lambda, 1, begin), row_or_null(point, 3, begin),
                row_or_null(normal, 3, begin), row_or_null(d_r12, 3, begin),  row_or_null(d_rot1, 3, begin),
                row_or_null(d_rot2, 3, begin), row_or_null(r12, 3, begin)};
    }
};

// Laws: energies U(μ²) of pairs.

/// U = ε/α (1 - μ)^α for μ < 1, otherwise 0.
struct SoftRepulsion {
    double energy, exponent;
};

/// U = A μ^-n - B μ^-m - `shift` for μ² < `mu2_max`, otherwise 0.
struct InversePowers {
    double repulsion, n, attraction, m, mu2_max, shift;
};

/// U by cubic Hermite interpolation between points that are equally spaced in μ², and 0 from the last point on. The derivative is
/// that of the polynomial, so that forces conserve the energy. Before the first point, U is linear.
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

/// A function for the values of a law. It writes the derivatives of U at n numbers μ².
template <class Law> struct LawKernel {
    LawSums (*evaluate)(Law const &, std::size_t n, double const *mu2, double *d_u) noexcept;
};

struct OnePairKernels; // one_pair.hpp

/// Functions for one ellipsoid and a convex set, given by the points of Segments, Triangles or Boxes. They return false, and write
/// nothing, if the input fails the fast checks or the digits do not suffice. `mu2` and `point` may be null.
struct OneSetKernels {
    bool (*contact_segment)(double const *end1, double const *end2, double const *q, double *mu2,
                            double *point) noexcept;
    bool (*contact_triangle)(double const *vertex1, double const *vertex2, double const *vertex3, double const *q,
                             double *mu2, double *point) noexcept;
    bool (*contact_box)(double const *lower, double const *upper, double const *q, double *mu2, double *point) noexcept;
    bool (*overlap_segment)(double const *end1, double const *end2, double const *q, int *overlap) noexcept;
    bool (*overlap_triangle)(double const *vertex1, double const *vertex2, double const *vertex3, double const *q,
                             int *overlap) noexcept;
    bool (*overlap_box)(double const *lower, double const *upper, double const *q, int *overlap) noexcept;
};

/// A function for many pairs, one per lane.
template <class Rows, class Arrays> struct LaneKernel {
    /// Computes pairs from the first of n on, and returns their number. It writes to `left_over` the indices of the computed pairs
    /// that need the function for one pair.
    std::size_t (*compute)(Rows const &, std::size_t n, Arrays const &, Worklist &left_over) noexcept;
    /// Copies the pairs with the given indices, with the separations and images that lanes compute.
    void (*gather)(Rows const &, std::uint16_t const *indices, std::size_t count,
                   PairRow<Rows::dimension> *pairs) noexcept;
};

/// The same for ellipsoids and sets. Nothing has to be gathered: consecutive rows are left over as they are.
template <class Set, class Arrays> struct LaneKernel<SetRows<Set>, Arrays> {
    std::size_t (*compute)(SetRows<Set> const &, std::size_t n, Arrays const &, Worklist &left_over) noexcept;
};

/// All lane kernels of a target. Each kernel is a base class, so that its types select it.
template <class... Kernel> struct KernelTable : Kernel... {
};

using LaneKernels =
    KernelTable<LaneKernel<PairArrays<2>, ContactArrays>, LaneKernel<PairArrays<2>, OverlapArray>,
                LaneKernel<PairArrays<3>, ContactArrays>, LaneKernel<NeighborList, ContactArrays>,
                LaneKernel<PairArrays<3>, OverlapArray>, LaneKernel<NeighborList, OverlapArray>,
                LaneKernel<OneToMany, OverlapArray>, LaneKernel<OneToIndexed, OverlapArray>,
                LaneKernel<PairArrays<3>, DerivativeArrays>, LaneKernel<NeighborList, DerivativeArrays>,
                LaneKernel<Directions, ApproachArray>, LaneKernel<PairArrays<3>, DistanceArrays>,
                LaneKernel<PairArrays<3>, PassageArrays>, LaneKernel<SetRows<Segments>, SetContactArrays>,
                LaneKernel<SetRows<Triangles>, SetContactArrays>, LaneKernel<SetRows<Boxes>, SetContactArrays>,
                LaneKernel<SetRows<Segments>, OverlapArray>, LaneKernel<SetRows<Triangles>, OverlapArray>,
                LaneKernel<SetRows<Boxes>, OverlapArray>, LawKernel<SoftRepulsion>, LawKernel<InversePowers>,
                LawKernel<LawTable>>;

/// All functions of one target.
struct Kernels {
    char const *name;
    OnePairKernels const *one_pair;
    OneSetKernels const *one_set;
    LaneKernels const *lanes;
};

/// The kernels for this processor. If the environment variable PW85_TARGET names others that the processor can run, it is those. In
/// the reproducible mode it is those of the baseline. The first call decides for the whole process, until set_reproducible().
Kernels const &chosen() noexcept;

/// Switches the reproducible mode on or off, for all threads.
void set_reproducible(bool on) noexcept;

bool is_reproducible() noexcept;

} // namespace pw85::detail::kernels

#endif
