/// @file
/// What is compiled once per instruction set, and the choice among them at run time.
///
/// Types here are plain data, the same for every target: they cross the border between units compiled for different
/// processors. A kernel is a pair of them, what it reads (rows) and what it writes (arrays by the same index); a new one is a line in
/// LaneKernels, its types where they are new, `compute()` for the arrays that it writes (lanes.cpp) and `settle()` for a pair that
/// lanes leave (many_pairs.hpp).
#ifndef PW85_KERNELS_KERNELS_HPP_INCLUDED
#define PW85_KERNELS_KERNELS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#include <pw85/attributes.hpp>

#include "lattice.hpp"
#include "worklist.hpp"

struct pw85_motion; // of pw85.h, which needs a header that the build makes: devices have no build

namespace pw85::detail::kernels {

/// Row `index` of an array of rows of `width` numbers.
template <class Number>
[[gnu::always_inline]] PW85_FUNCTION inline Number *row_of(Number *rows, int width, std::size_t index) noexcept
{
    return rows + static_cast<std::size_t>(width) * index;
}

/// The same of an array that may be null.
template <class Number>
[[gnu::always_inline]] PW85_FUNCTION inline Number *row_or_null(Number *rows, int width, std::size_t index) noexcept
{
    return rows == nullptr ? nullptr : row_of(rows, width, index);
}

// Rows of pairs; from() gives those from a pair on.

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

/// Pairs whose separation is a direction, of any length.
struct Directions {
    static constexpr int dimension = 3;
    PairArrays<3> arrays;

    PW85_MEMBER Directions from(std::size_t begin) const noexcept { return {arrays.from(begin)}; }
};

/// One ellipsoid, and others: r12 n×3, q2 n×6.
struct OneToMany {
    static constexpr int dimension = 3;
    double const *q1, *r12, *q2;

    PW85_MEMBER OneToMany from(std::size_t begin) const noexcept
    {
        return {q1, row_of(r12, 3, begin), row_of(q2, 6, begin)};
    }
};

/// One ellipsoid, and others of a system by their indices: their images as those of a list.
struct OneToSome {
    static constexpr int dimension = 3;
    double const *center, *q1;
    std::int32_t const *others;
    double const *centers, *q;
    std::int32_t const *images; ///< null, or one row for each of the others
    double const *cell;         ///< null without periodicity
    Lattice const *lattice;     ///< null, or prepared for nearest images

    [[gnu::always_inline]] OneToSome from(std::size_t begin) const noexcept
    {
        return {center, q1, others + begin, centers, q, row_or_null(images, 3, begin), cell, lattice};
    }
};

/// A neighbour list: pairs (i, j) of rows of centers (N×3) and q (N×6). Of the images of j it takes those that `images` names, as
/// multiples of the rows of `cell`, or else the nearest in the lattice, or else j itself.
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

/// One pair of any of these.
template <int D> struct PairRow {
    double r12[D], q1[D * (D + 1) / 2], q2[D * (D + 1) / 2];
};

// Where results of pairs go; from() as above.

/// Contact functions.
struct ContactArrays {
    double *mu2, *lambda; ///< lambda may be null

    PW85_MEMBER ContactArrays from(std::size_t begin) const noexcept
    {
        return {row_of(mu2, 1, begin), row_or_null(lambda, 1, begin)};
    }
};

/// Answers of the overlap test.
struct OverlapArray {
    unsigned char *overlap;

    PW85_MEMBER OverlapArray from(std::size_t begin) const noexcept { return {overlap + begin}; }
};

/// Distances of closest approach.
struct ApproachArray {
    double *distance;

    PW85_MEMBER ApproachArray from(std::size_t begin) const noexcept { return {distance + begin}; }
};

/// Distances and closest points; any may be null.
struct DistanceArrays {
    double *distance, *point1, *point2;

    [[gnu::always_inline]] DistanceArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(distance, 1, begin), row_or_null(point1, 3, begin), row_or_null(point2, 3, begin)};
    }
};

/// Contact functions and derivatives; any may be null, but for the kernels' lambda, which is NaN where a pair is left to the
/// function for one before its λ is known.
struct DerivativeArrays {
    double *mu2, *lambda;
    double *point, *normal, *d_r12, *d_rot1, *d_rot2; ///< three numbers per pair

    PW85_MEMBER DerivativeArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(mu2, 1, begin),    row_or_null(lambda, 1, begin), row_or_null(point, 3, begin),
                row_or_null(normal, 3, begin), row_or_null(d_r12, 3, begin),  row_or_null(d_rot1, 3, begin),
                row_or_null(d_rot2, 3, begin)};
    }
};

/// Functions for one pair, with the contracts of the C API where inputs are not null.
struct OnePairKernels {
    int (*contact)(double const *r12, double const *q1, double const *q2, double *out) noexcept;
    int (*overlap)(double const *r12, double const *q1, double const *q2, int *overlap) noexcept;
    int (*contact_geometry)(double const *r12, double const *q1, double const *q2, double lambda, double *point,
                            double *normal) noexcept;
    int (*contact_gradient)(double const *r12, double const *q1, double const *q2, double lambda, double *d_r12,
                            double *d_q1, double *d_q2) noexcept;
    int (*contact_torque)(double const *r12, double const *q1, double const *q2, double lambda, double *d_rot1,
                          double *d_rot2) noexcept;
    int (*contact_hessian)(double const *r12, double const *q1, double const *q2, double lambda,
                           double *hessian) noexcept;
    int (*closest_approach)(double const *direction, double const *q1, double const *q2, double *distance) noexcept;
    int (*distance)(double const *r12, double const *q1, double const *q2, double *distance, double *point1,
                    double *point2) noexcept;
    int (*distance_derivatives)(double const *r12, double const *q1, double const *q2, double *d_r12, double *d_rot1,
                                double *d_rot2, double *hessian) noexcept;
    int (*first_contact)(double const *r12, double const *q1, double const *q2, pw85_motion const *motion1,
                         pw85_motion const *motion2, double end, double *time) noexcept;
};

/// A function for many pairs, one per lane.
template <class Rows, class Arrays> struct LaneKernel {
    /// Computes the first of n pairs, as many as it returns; those that are left to the function for one pair replace what is in
    /// `left`.
    std::size_t (*compute)(Rows const &, std::size_t n, Arrays const &, Worklist &left) noexcept;
    /// Some rows, as lanes see them.
    void (*gather)(Rows const &, std::uint16_t const *indices, std::size_t count,
                   PairRow<Rows::dimension> *pairs) noexcept;
};

/// Kernels by their types: each is a base.
template <class... Kernel> struct KernelTable : Kernel... {
};

using LaneKernels = KernelTable<LaneKernel<PairArrays<2>, ContactArrays>, LaneKernel<PairArrays<2>, OverlapArray>,
                                LaneKernel<PairArrays<3>, ContactArrays>, LaneKernel<NeighborList, ContactArrays>,
                                LaneKernel<PairArrays<3>, OverlapArray>, LaneKernel<NeighborList, OverlapArray>,
                                LaneKernel<OneToMany, OverlapArray>, LaneKernel<OneToSome, OverlapArray>,
                                LaneKernel<PairArrays<3>, DerivativeArrays>, LaneKernel<NeighborList, DerivativeArrays>,
                                LaneKernel<Directions, ApproachArray>, LaneKernel<PairArrays<3>, DistanceArrays>>;

/// All functions of one target.
struct Kernels {
    char const *name;
    OnePairKernels const *one_pair;
    LaneKernels const *lanes;
};

/// The kernels for this processor, or those that the environment variable PW85_TARGET asks for if the processor can run
/// them. Decided at the first call, once and for all.
Kernels const &chosen() noexcept;

} // namespace pw85::detail::kernels

#endif
