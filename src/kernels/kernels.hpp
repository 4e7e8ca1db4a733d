/// @file
/// What is compiled once per instruction set, and the choice among them at run time.
///
/// Types here are plain data, the same for every target: they cross the border between units compiled for different
/// processors.
#ifndef PW85_KERNELS_KERNELS_HPP_INCLUDED
#define PW85_KERNELS_KERNELS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#include <pw85.h>

#include "lattice.hpp"

namespace pw85::kernels {

/// Rows of pairs: n×3, n×6, n×6.
struct PairArrays {
    double const *r12, *q1, *q2;
};

/// A neighbour list: pairs (i, j) of rows of centers (N×3) and q (N×6). Of the images of j it takes those that `images` names, as
/// multiples of the rows of `cell`, or else the nearest in the lattice, or else j itself.
struct NeighborList {
    std::int32_t const *pairs;
    double const *centers, *q;
    std::int32_t const *images; ///< null, or one row per pair
    double const *cell;         ///< null without periodicity
    Lattice const *lattice;     ///< null, or prepared for nearest images
};

/// One ellipsoid, and others: r12 n×3, q2 n×6.
struct OneToMany {
    double const *q1, *r12, *q2;
};

/// Pairs begin, begin + 1, ... end - 1.
struct Range {
    std::size_t begin, end;
};

/// Where the contact functions of pairs go, by the index of the pair.
struct ContactArrays {
    double *mu2, *lambda; ///< lambda may be null
};

/// Where contact functions and derivatives go; any may be null.
struct DerivativeArrays {
    double *mu2, *lambda;
    double *point, *normal, *d_r12, *d_rot1, *d_rot2; ///< three numbers per pair
};

/// The first bad pair of a range; `status` is 0 if there is none.
struct Failure {
    std::size_t index;
    int status;

    /// Keeps the earlier of two failures.
    [[gnu::always_inline]] void update(Failure const &other) noexcept
    {
        if (other.status != 0 && (status == 0 || other.index < index)) *this = other;
    }
};

/// Functions for one pair, with the contracts of the C API where inputs are not null.
struct ScalarKernels {
    int (*contact)(double const *r12, double const *q1, double const *q2, double *out) noexcept;
    int (*overlap)(double const *r12, double const *q1, double const *q2, int *overlap) noexcept;
    int (*contact_geometry)(double const *r12, double const *q1, double const *q2, double lambda, double *point,
                            double *normal) noexcept;
    int (*contact_gradient)(double const *r12, double const *q1, double const *q2, double lambda, double *d_r12,
                            double *d_q1, double *d_q2) noexcept;
    int (*contact_torque)(double const *r12, double const *q1, double const *q2, double lambda, double *d_rot1,
                          double *d_rot2) noexcept;
    int (*closest_approach)(double const *direction, double const *q1, double const *q2, double *distance) noexcept;
    int (*distance)(double const *r12, double const *q1, double const *q2, double *distance, double *point1,
                    double *point2) noexcept;
    int (*distance_derivatives)(double const *r12, double const *q1, double const *q2, double *d_r12, double *d_rot1,
                                double *d_rot2, double *hessian) noexcept;
    int (*first_contact)(double const *r12, double const *q1, double const *q2, pw85_motion const *motion1,
                         pw85_motion const *motion2, double end, double *time) noexcept;
};

/// Functions for ranges of pairs. The scalar kernels serve the pairs that lanes cannot; the first bad one is returned.
struct LaneKernels {
    Failure (*contact_batch)(PairArrays const &, Range, ContactArrays const &, ScalarKernels const &) noexcept;
    Failure (*contact_pairs)(NeighborList const &, Range, ContactArrays const &, ScalarKernels const &) noexcept;
    Failure (*overlap_batch)(PairArrays const &, Range, unsigned char *, ScalarKernels const &) noexcept;
    Failure (*overlap_pairs)(NeighborList const &, Range, unsigned char *, ScalarKernels const &) noexcept;
    Failure (*derivatives_batch)(PairArrays const &, Range, DerivativeArrays const &, ScalarKernels const &) noexcept;
    Failure (*derivatives_pairs)(NeighborList const &, Range, DerivativeArrays const &, ScalarKernels const &) noexcept;
    Failure (*closest_approach_batch)(PairArrays const &, Range, double *, ScalarKernels const &) noexcept;
    int (*overlap_any)(OneToMany const &, std::size_t, int *, ScalarKernels const &) noexcept;
};

/// All functions of one target.
struct Kernels {
    char const *name;
    ScalarKernels const *scalar;
    LaneKernels const *lanes;
};

/// The kernels for this processor, or those that the environment variable PW85_TARGET asks for if the processor can run
/// them. Decided at the first call, once and for all.
Kernels const &chosen() noexcept;

} // namespace pw85::kernels

#endif
