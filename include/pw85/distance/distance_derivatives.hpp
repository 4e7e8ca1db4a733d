// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// First and second derivatives of the distance with respect to positions and rotations.
/// src/simd/search/distance.cpp calls distance_derivatives(), which takes the normal and the
/// closest points from distance.hpp. signed_distance.hpp calls derivatives_across() for pairs that
/// overlap, where d is negative.
///
/// The notation is that of distance.hpp. p1 = Q1n/α and p2 = Q2n/β are the points of the surfaces,
/// relative to their own centres.
///
/// 1. By the envelope theorem n may be held fixed. So ∂d/∂r12 = n, and rotations about the own
///    centres give ∂d/∂ωi = n × pi. The sum of the two rotations plus r12 × n vanishes: there is no
///    net torque.
/// 2. Let Ai = ∂pi/∂n and P = I - nnᵀ. If the condition of the normal is violated by a vector, the
///    normal turns by G = P(A1 + A2 + d I)⁻¹P times this vector (curvature.hpp). Let Ci = ∂(n ×
///    pi)/∂n = [n]Ai - [pi], where [x]y = x × y. The Hessian is J G Jᵀ with J = (I; C1; C2), plus
///    for each rotation its contribution at fixed n, Ki = (n·pi) I - ½(pi nᵀ + n piᵀ) - [n]ᵀAi[n].
#ifndef PW85_DISTANCE_DISTANCE_DERIVATIVES_HPP_INCLUDED
#define PW85_DISTANCE_DISTANCE_DERIVATIVES_HPP_INCLUDED

#include <pw85/distance/curvature.hpp>
#include <pw85/distance/distance.hpp>

namespace pw85 {

/// Derivatives of the distance. They are NaN if the ellipsoids overlap.
template <class T> struct DistanceDerivatives {
    Vector<T, 3> r12;                  ///< the unit normal, from 1 to 2
    Vector<T, 3> rotation1, rotation2; ///< per radian, for rotation vectors about the own centres
    T hessian[9][9];                   ///< with respect to r12, rotation 1, rotation 2
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

template <class T> PW85_FUNCTION constexpr Vector<T, 3> unit_vector(int i) noexcept
{
    Vector<T, 3> e{};
    e[i] = T(1);
    return e;
}

/// Computes K of item 2.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3>
curvature_matrix(SurfaceElement<T, 3> const &element, Vector<T, 3> const &n) noexcept
{
    SymmetricMatrix<T, 3> k{};
    Vector<T, 3> const &p = element.point;
    T const extent = dot(n, p);
    for (int i = 0; i < 3; ++i) {
        Vector<T, 3> const turned = product(element.turn, cross(n, unit_vector<T>(i)));
        for (int j = i; j < 3; ++j)
            k(i, j) = (i == j ? extent : T(0)) - T(0.5) * (p[i] * n[j] + n[i] * p[j]) -
                      dot(cross(n, unit_vector<T>(j)), turned);
    }
    return k;
}

/// Computes the Hessian in the units of a DistancePair (item 2).
template <class T>
PW85_FUNCTION inline void distance_hessian(SurfaceElement<T, 3> const (&elements)[2],
                                           T const &distance, Vector<T, 3> const &n,
                                           T (&hessian)[9][9]) noexcept
{
    auto const factors = factorize(stiffness_across(elements, distance, n), T(unit_roundoff<T>()));
    Vector<T, 3> rows[9], turned[9]; // rows of J and of J G
    for (int k = 0; k < 3; ++k) {
        rows[k] = unit_vector<T>(k);
        for (int e = 0; e < 2; ++e) {
            auto const &[point, turn] = elements[e];
            Vector<T, 3> const arm = cross(rows[k], point),
                               change = cross(n, product(turn, rows[k]));
            for (int i = 0; i < 3; ++i) rows[3 + 3 * e + i][k] = arm[i] + change[i];
        }
    }
    for (int i = 0; i < 9; ++i) turned[i] = project(solve(factors, project(rows[i], n)), n);
    for (int i = 0; i < 9; ++i)
        for (int j = i; j < 9; ++j) hessian[i][j] = hessian[j][i] = dot(turned[i], rows[j]);
    for (int e = 0; e < 2; ++e) {
        SymmetricMatrix<T, 3> const k = curvature_matrix(elements[e], n);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                T &entry = hessian[3 + 3 * e + i][3 + 3 * e + j];
                entry = entry + k(i, j);
            }
    }
}

/// Computes the derivatives in the units of a DistancePair. The derivatives with respect to
/// rotations are in the units of the forms. Both points of `d` are relative to their own centres.
template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
derivatives_across(DistancePair<T, 3> const &pair, Distance<T, 3> const &d) noexcept
{
    DistanceDerivatives<T> result{
        d.normal, cross(d.normal, d.point1), cross(d.normal, d.point2), {}, StatusCode::success};
    SurfaceElement<T, 3> const elements[2] = {surface_element(pair.q1, pair.scale1, d.normal),
                                              surface_element(pair.q2, pair.scale2, d.normal)};
    distance_hessian(elements, d.distance, d.normal, result.hessian);
    return result;
}

/// Computes the derivatives at an accurate slab of a type with more digits, and rounds them.
template <class T, class F> [[gnu::noinline]] PW85_FUNCTION inline DistanceDerivatives<T>
derivatives_at(DistancePair<T, 3> const &pair, Slab<F, 3> const &slab) noexcept
{
    auto const fine = derivatives_across(finer<F>(pair), distance_across(slab));
    DistanceDerivatives<T> result{rounded(fine.r12),
                                  rounded(fine.rotation1),
                                  rounded(fine.rotation2),
                                  {},
                                  StatusCode::success};
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j) result.hessian[i][j] = rounded(fine.hessian[i][j]);
    return result;
}

template <class T> PW85_RARE DistanceDerivatives<T>
refined_derivatives(DistancePair<T, 3> const &pair, FoundSlab<T, 3> const &slab) noexcept
{
    return refine_slab(pair, slab, [&](auto const &found) {
        return found.accurate ? derivatives_at(pair, found.slab)
                              : all_nan<DistanceDerivatives<T>>(StatusCode::no_convergence);
    });
}

/// Returns derivatives in the caller's units.
template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
to_caller(DistanceDerivatives<T> result, Units const &units) noexcept
{
    result.rotation1 = units.first.to_caller(result.rotation1);
    result.rotation2 = units.second.to_caller(result.rotation2);
    // a derivative by r12 and by a rotation is a number
    int const length = units.length.exponent;
    for (int i = 0; i < 3; ++i) multiply_by_power_of_two<3>(result.hessian[i], -length);
    for (int i = 3; i < 9; ++i) multiply_by_power_of_two<6>(result.hessian[i] + 3, length);
    return result;
}

/// Computes distance_derivatives() of a valid pair that is apart.
template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
distance_derivatives_apart(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                           SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const [pair, units] = scale_distance(r12, q1, q2);
    auto const found = find_slab(pair, true);
    return to_caller(found.accurate ? derivatives_across(pair, distance_across(found.slab))
                                    : refined_derivatives(pair, found),
                     units);
}

PW85_RARE_TIER_OF(refined_derivatives, double)

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
distance_derivatives(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                     SymmetricMatrix<T, 3> const &q2) noexcept
{
    Overlap const decision = detail::call_overlap(r12, q1, q2);
    if (decision.status != StatusCode::success || decision.overlap)
        return detail::all_nan<DistanceDerivatives<T>>(decision.status);
    return detail::distance_derivatives_apart(r12, q1, q2);
}

} // namespace pw85

#endif
