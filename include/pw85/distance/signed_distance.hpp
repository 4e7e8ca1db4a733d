// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The signed distance of two ellipsoids: their distance if they are apart, minus the depth
/// of their overlap otherwise. The kernels of the C API (src/simd/unfused/depth.cpp) call
/// signed_distance_overlapping() and signed_derivatives_overlapping() with the normal from
/// penetration.hpp.
///
/// The notation is that of distance.hpp, with the unit normal n, the half-widths α and β along it,
/// and r = r12.
///
/// 1. The signed distance is d = max over n of n·r - α(n) - β(n), whether the ellipsoids overlap or
///    not. For fixed n the right-hand side is affine in r. So d is a convex function of r, and the
///    normal of any maximum is a subgradient.
/// 2. At a maximum r = (Q1/α + Q2/β + d I)n. So the points p1 = Q1n/α and r - Q2n/β of the surfaces
///    differ by d n, and d is also the distance along n from the first point to the second. The
///    derivatives of distance_derivatives.hpp hold for d < 0, too.
/// 3. The second derivatives exist if the maximum is isolated, that is if A1 + A2 + d I is positive
///    definite across n. It is positive semidefinite at every maximum. The ellipsoids are apart or
///    touch: then A1 + A2 is positive definite, and d >= 0.
#ifndef PW85_DISTANCE_SIGNED_DISTANCE_HPP_INCLUDED
#define PW85_DISTANCE_SIGNED_DISTANCE_HPP_INCLUDED

#include <pw85/distance/distance_derivatives.hpp>
#include <pw85/distance/penetration.hpp>

namespace pw85::detail {

/// Scales a valid pair that overlaps by the size of the larger ellipsoid. Numbers that underflow
/// are far below rounding.
template <class T, int D> PW85_FUNCTION inline Scaled<DistancePair<T, D>>
scale_overlapping(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                  SymmetricMatrix<T, D> const &q2) noexcept
{
    Unit const unit1 = unit_of(q1), unit2 = unit_of(q2);
    return in_units(r12, q1, q2, {larger_of(unit1, unit2), unit1, unit2, false, {}});
}

/// The signed distance of a scaled pair that overlaps, from the direction of its depth. Both points
/// are relative to their own centres, and they are in the units of the forms.
template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance_through(DistancePair<T, D> const &pair, Vector<T, D> const &direction) noexcept
{
    Slab<T, D> const slab = accurate_slab_along(pair, direction);
    return {minimum(T(0), slab.width), slab.support1.point, slab.support2.point, direction,
            StatusCode::success};
}

/// Computes signed_distance() of a pair that is not apart. The distance is minus the depth that
/// penetration() has found.
template <class T, int D> PW85_FUNCTION inline Distance<T, D>
signed_distance_overlapping(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                            SymmetricMatrix<T, D> const &q2,
                            Penetration<T, D> const &found) noexcept
{
    if (found.status != StatusCode::success) return all_nan<Distance<T, D>>(found.status);
    auto const [pair, units] = scale_overlapping(r12, q1, q2);
    Distance<T, D> result = to_caller(distance_through(pair, found.direction), units);
    result.distance = T(0) - found.depth;
    return with_point2(r12, result);
}

/// Returns whether the second derivatives of a scaled pair that overlaps exist, by item 3.
template <class T> PW85_FUNCTION inline bool has_hessian(DistancePair<T, 3> const &pair,
                                                         Distance<T, 3> const &d) noexcept
{
    SurfaceElement<T, 3> const elements[2] = {surface_element(pair.q1, pair.scale1, d.normal),
                                              surface_element(pair.q2, pair.scale2, d.normal)};
    auto const stiffness = stiffness_across(elements, d.distance, d.normal);
    return is_isolated(stiffness, factorize(stiffness, T(0)));
}

/// Computes the derivatives of a pair that overlaps from the direction of its depth. This is a
/// function of its own: its numbers are not on the stack during the search for the direction.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline DistanceDerivatives<T>
derivatives_through(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                    SymmetricMatrix<T, 3> const &q2, Vector<T, 3> const &direction) noexcept
{
    auto const [pair, units] = scale_overlapping(r12, q1, q2);
    auto const d = distance_through(pair, direction);
    auto result = to_caller(derivatives_across(pair, d), units);
    if (!has_hessian(pair, d))
        for (auto &row : result.hessian)
            for (T &entry : row) entry = quiet_nan<T>();
    return result;
}

/// Computes signed_distance_derivatives() of a pair that is not apart.
template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
signed_derivatives_overlapping(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                               SymmetricMatrix<T, 3> const &q2,
                               Penetration<T, 3> const &found) noexcept
{
    if (found.status != StatusCode::success) return all_nan<DistanceDerivatives<T>>(found.status);
    return derivatives_through(r12, q1, q2, found.direction);
}

} // namespace pw85::detail

namespace pw85 {

/// The signed distance. It is negative only if the ellipsoids overlap, and positive only if they
/// are apart.
template <class T, int D>
PW85_FUNCTION inline Distance<T, D> signed_distance(Vector<T, D> const &r12,
                                                    SymmetricMatrix<T, D> const &q1,
                                                    SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const found = detail::find_depth(r12, q1, q2);
    return found.apart ? detail::distance_apart(r12, q1, q2)
                       : detail::signed_distance_overlapping(r12, q1, q2, found.result);
}

/// The derivatives of the signed distance. The Hessian is NaN where the normal is not isolated.
template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
signed_distance_derivatives(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                            SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const found = detail::find_depth(r12, q1, q2);
    return found.apart ? detail::distance_derivatives_apart(r12, q1, q2)
                       : detail::signed_derivatives_overlapping(r12, q1, q2, found.result);
}

} // namespace pw85

#endif
