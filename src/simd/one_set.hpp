// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions for one ellipsoid and a convex set that are compiled per instruction set:
/// set/one_set.cpp defines them, and PW85_OF_PAIR() chooses one.
#ifndef PW85_SIMD_ONE_SET_HPP_INCLUDED
#define PW85_SIMD_ONE_SET_HPP_INCLUDED

#include "targets.hpp"

namespace pw85::detail::kernels {

// They are given the points of Segments, Triangles or Boxes, and the form. They return false, and
// write nothing, if the input fails the fast checks or the digits do not suffice. `mu2` and `point`
// may be null.

using ContactOfTwoPoints = bool(double const *, double const *, double const *q, double *mu2,
                                double *point) noexcept;
using ContactOfThreePoints = bool(double const *, double const *, double const *, double const *q,
                                  double *mu2, double *point) noexcept;
using OverlapOfTwoPoints = bool(double const *, double const *, double const *q,
                                int *overlap) noexcept;
using OverlapOfThreePoints = bool(double const *, double const *, double const *, double const *q,
                                  int *overlap) noexcept;

#define PW85_DECLARE_ONE_SET(target, one_pair, lanes256, available)                                \
    namespace one_pair {                                                                           \
    ContactOfTwoPoints contact_segment, contact_box;                                               \
    ContactOfThreePoints contact_triangle;                                                         \
    OverlapOfTwoPoints overlap_segment, overlap_box;                                               \
    OverlapOfThreePoints overlap_triangle;                                                         \
    }
PW85_EACH_TARGET(PW85_DECLARE_ONE_SET)
#undef PW85_DECLARE_ONE_SET

} // namespace pw85::detail::kernels

#endif
