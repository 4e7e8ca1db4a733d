// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact point, the normal and the first derivatives of μ², from the maximiser λ. pw85.hpp,
/// the lane kernels, the code for devices, contact_hessian.hpp, condition.hpp and witness.hpp use
/// this file.
///
/// Let n = [(1-λ) Q1 + λ Q2]⁻¹ r12. By the envelope theorem λ may be held fixed in the derivatives,
/// because f is stationary there.
///
/// 1. x0 - c1 = (1-λ) Q1 n, x0 - c2 = -λ Q2 n. The common normal is along n.
/// 2. ∂μ²/∂r12 = 2λ(1-λ) n; ∂μ²/∂Q1 = -λ(1-λ)² n nᵀ; ∂μ²/∂Q2 = -λ²(1-λ) n nᵀ.
/// 3. For rotations about the own centres, ∂μ²/∂ω1 = 2λ(1-λ)² n × Q1n and ∂μ²/∂ω2 = 2λ²(1-λ) n ×
///    Q2n. Their sum plus r12 × ∂μ²/∂r12 vanishes: there is no net torque.
#ifndef PW85_CONTACT_GEOMETRY_HPP_INCLUDED
#define PW85_CONTACT_GEOMETRY_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/algebra/gram_schmidt.hpp>
#include <pw85/contact/factorized_search.hpp>

namespace pw85 {

/// The point and the normal at which the ellipsoids touch if both are scaled by μ.
template <class T, int D> struct ContactGeometry {
    Vector<T, D> point;  ///< relative to the centre of ellipsoid 1
    Vector<T, D> normal; ///< unit vector, out of ellipsoid 1 and into ellipsoid 2
    StatusCode status;
};

/// Derivatives of μ² with respect to the separation and the stored entries of the forms.
template <class T, int D> struct ContactGradient {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    StatusCode status;
};

/// The derivatives of μ² with respect to the rotation vectors of the ellipsoids, each about its own
/// centre. In two dimensions the one component is the derivative with respect to the angle.
template <class T, int D = 3> struct ContactTorque {
    Vector<T, detail::rotation_axes<D>> rotation1, rotation2;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The conditioning (rational.hpp) above which the adjugate is accurate enough for derivatives. The
/// error of M⁻¹x is then below 126 u/d < 2^-28 in double. This is a few times the error that the
/// rounding of λ and of the forms causes in the derivatives of such a pair.
template <class T> PW85_FUNCTION constexpr T adjugate_conditioning() noexcept
{
    return negative_power_of_two<T>(maximum(mantissa_digits<T>() / 2 - 8, 0));
}

template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_accurate(AdjugateSolution<T, D> const &solution) noexcept
{
    return solution.determinant > adjugate_conditioning<T>() * solution.diagonal;
}

/// The largest relative error, in the norm of M, at which a solution by factorisation is accepted:
/// 2^-13 for double. Pairs with larger errors are computed with extended numbers, which take some
/// hundred times as long.
template <class T> PW85_FUNCTION constexpr T tolerated_error() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 4);
}

/// M⁻¹ x for M = w1 Q1 + w2 Q2. It is correct to rounding in the norm of M.
template <class T, int D>
PW85_RARE Vector<T, D> solve_blend_extended(T const &w1, SymmetricMatrix<T, D> const &q1,
                                            T const &w2, SymmetricMatrix<T, D> const &q2,
                                            Vector<T, D> const &x) noexcept
{
    using W = Widened<T>;
    auto const s =
        solve(factorize_blend(W(w1), converted<W>(q1), W(w2), converted<W>(q2)), converted<W>(x));
    Vector<T, D> result{};
    for (int i = 0; i < D; ++i) result[i] = rounded(s[i]);
    return result;
}

PW85_RARE_TIER(solve_blend_extended)

/// M⁻¹ x for M = w1 Q1 + w2 Q2, where the adjugate is not accurate. It uses factorisation if that
/// leaves some digits. Otherwise it uses extended numbers, if the type has them.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Vector<T, D>
solve_ill_conditioned(T const &w1, SymmetricMatrix<T, D> const &q1, T const &w2,
                      SymmetricMatrix<T, D> const &q2, Vector<T, D> const &x) noexcept
{
    auto const m = blend(w1, q1, w2, q2);
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    if constexpr (has_extended_numbers<T>)
        if (!(T(factorization_error) * unit_roundoff<T>() * inverse_eigenvalue_bound(factors, m) <=
              tolerated_error<T>()))
            return solve_blend_extended(w1, q1, w2, q2, x);
    return solve(factors, x);
}

/// M⁻¹ x for M = w1 Q1 + w2 Q2. It uses the adjugate if that is as accurate as rounding allows.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> solve_blend(T const &w1, SymmetricMatrix<T, D> const &q1,
                                              T const &w2, SymmetricMatrix<T, D> const &q2,
                                              Vector<T, D> const &x) noexcept
{
    auto const solution = solve_by_adjugate(blend(w1, q1, w2, q2), x);
    if (is_accurate(solution)) return T(T(1) / solution.determinant) * solution.s;
    return solve_ill_conditioned(w1, q1, w2, q2, x);
}

/// A pair at one λ, in units of its own. n is proportional to v = (w1 Q1 + w2 Q2)⁻¹ r12. `V` is the
/// type that solve_blend() returns.
template <class T, int D, class V = Vector<T, D>> struct Tangency {
    V v;
    T lambda1, lambda2;       ///< 1-λ, λ
    T weight1, weight2;       ///< w1 and w2, proportional to 1-λ and λ
    int lambda_exponent = 0;  ///< lambda2 is λ divided by 2 to this power
    int weights_exponent = 0; ///< lambda1 lambda2 is w1 w2 times 2 to this power
};

/// The point x0, relative to the centre of ellipsoid 1 (item 1).
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
tangency_point(Tangency<T, D> const &at, SymmetricMatrix<T, D> const &q1) noexcept
{
    return at.weight1 * product(q1, at.v);
}

/// The unit vector along n. It is not finite if n is zero.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> tangency_normal(Tangency<T, D> const &at) noexcept
{
    return T(T(1) / square_root(dot(at.v, at.v))) * at.v;
}

/// ∂μ²/∂r12 (item 2).
template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> separation_gradient(Tangency<T, D> const &at) noexcept
{
    return T(T(2) * at.lambda1 * at.lambda2) * at.v;
}

/// ∂μ²/∂ω1 and ∂μ²/∂ω2 (item 3).
template <class T, int D = 3> struct RotationGradients {
    Vector<T, rotation_axes<D>> first, second;
};

template <class T, int D> PW85_FUNCTION constexpr RotationGradients<T, D>
rotation_gradients(Tangency<T, D> const &at, SymmetricMatrix<T, D> const &q1,
                   SymmetricMatrix<T, D> const &q2) noexcept
{
    Vector<T, D> const n = separation_gradient(at);
    return {cross(n, at.weight1 * product(q1, at.v)), cross(n, at.weight2 * product(q2, at.v))};
}

/// 1-λ, but not below the unit roundoff. A maximiser that rounds to 1 belongs to a pair of very
/// different sizes; it is not the end of the interval.
template <class T> PW85_FUNCTION constexpr T complement_of(T const &lambda) noexcept
{
    return maximum(T(T(1) - lambda), T(unit_roundoff<T>() / 2));
}

/// The pair at λ, computed by the adjugate, and whether the result is accurate.
template <class T, int D> struct FastTangency {
    Tangency<T, D> at;
    typename ScalarTraits<T>::Mask accurate;
};

template <class T, int D> PW85_FUNCTION inline FastTangency<T, D>
fast_tangency(Pair<T, D> const &pair, T const &lambda) noexcept
{
    T const lambda1 = complement_of(lambda);
    auto const solution = solve_by_adjugate(blend(lambda1, pair.q1, lambda, pair.q2), pair.r12);
    T const reciprocal = T(1) / solution.determinant;
    return {{reciprocal * solution.s, lambda1, lambda, lambda1, lambda}, is_accurate(solution)};
}

/// The units of a Tangency.
struct TangencyUnits {
    Unit length;        ///< of r12
    Unit normal;        ///< of n
    Unit lambda;        ///< of λ
    Unit first, second; ///< of the sizes of the ellipsoids
};

/// The pair at λ in units in which the forms, the larger of the weights and λ are of order one. So
/// everything that is computed from them stays in range. `scaled` is the scaled pair, perhaps with
/// the ellipsoids exchanged. The result is in the order of the caller.
template <class T, int D, class Q>
PW85_FUNCTION inline auto scaled_tangency(ScaledPair<T, D, Q> const &scaled, T const &lambda1,
                                          T const &lambda2, TangencyUnits &units) noexcept
{
    auto const &[pair, own] = scaled;
    T const &first = own.swapped ? lambda2 : lambda1, &second = own.swapped ? lambda1 : lambda2;
    int const shift = -2 * binary_exponent(pair.ratio);
    bool const first_leads =
        !(second > T(0)) ||
        (first > T(0) && binary_exponent(first) > binary_exponent(second) + shift);
    Unit const weight{first_leads ? binary_exponent(first) : binary_exponent(second) + shift},
        weight2 = weight / Unit{shift}, lambda{lambda2 > T(0) ? binary_exponent(lambda2) : 0};
    T const w1 = weight.to_local(first), w2 = weight2.to_local(second);
    auto const v = solve_blend(w1, pair.q1, w2, pair.q2, pair.r12);
    units = {own.length, own.mu() / own.first / weight, lambda,
             own.swapped ? own.second : own.first, own.swapped ? own.first : own.second};
    return Tangency<T, D, std::remove_const_t<decltype(v)>>{own.reordered(v),
                                                            lambda1,
                                                            lambda.to_local(lambda2),
                                                            own.swapped ? w2 : w1,
                                                            own.swapped ? w1 : w2,
                                                            lambda.exponent,
                                                            (weight * weight2 / lambda).exponent};
}

/// Computes formula(tangency, q1, q2) for any pair at λ.
template <class Formula, class T, int D, class Q> [[gnu::noinline]] PW85_FUNCTION inline auto
at_tangency_scaled(Formula formula, Pair<T, D, Q> pair, T const &lambda1, T const &lambda2) noexcept
{
    ScaledPair<T, D, Q> scaled;
    TangencyUnits units;
    using At = decltype(scaled_tangency(scaled, lambda1, lambda2, units));
    using Result = decltype(formula(At{}, pair.q1, pair.q2));
    StatusCode const status = lambda2 >= T(0) && lambda2 <= T(1) ? validate_pair(pair, scaled)
                                                                 : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<Result>(status);
    if (!(largest_coordinate(pair.r12) > T(0))) return formula(At{}, pair.q1, pair.q2);
    At const at = scaled_tangency(scaled, lambda1, lambda2, units);
    auto result = scaled.units.swapped ? formula(at, scaled.pair.q2, scaled.pair.q1)
                                       : formula(at, scaled.pair.q1, scaled.pair.q2);
    rescale(result, units);
    return result;
}

/// Computes formula(tangency, q1, q2) for a pair at λ. The arguments are references, because a Pair
/// would be copied to memory.
template <class Formula, class T, int D, class Q>
PW85_FUNCTION inline auto at_tangency(Formula formula, Vector<T, D> const &r12, Q const &q1,
                                      Q const &q2, T const &lambda) noexcept
{
    T const lambda1 = complement_of(lambda);
    if (lambda >= T(0) && lambda <= T(1) && passes_fast_checks(pair_of(r12, q1, q2))) {
        auto const v = solve_blend(lambda1, q1, lambda, q2, r12);
        return formula(
            Tangency<T, D, std::remove_const_t<decltype(v)>>{v, lambda1, lambda, lambda1, lambda},
            q1, q2);
    }
    return at_tangency_scaled(formula, pair_of(r12, q1, q2), lambda1, lambda);
}

template <class T, int D>
PW85_FUNCTION inline void rescale(ContactGeometry<T, D> &g, TangencyUnits const &units) noexcept
{
    g.point = units.length.to_caller(g.point);
}

/// Not inlined: the entries would go through scalar registers between two loops over vectors.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline void
rescale(ContactGradient<T, D> &g, TangencyUnits const &units) noexcept
{
    Unit const unit = units.normal * units.lambda;
    g.r12 = unit.to_caller(g.r12);
    g.q1 = (unit * units.normal).to_caller(g.q1, 1);
    g.q2 = unit.to_caller(g.q2, 2);
}

template <class T, int D>
PW85_FUNCTION inline void rescale(ContactTorque<T, D> &t, TangencyUnits const &units) noexcept
{
    Unit const unit = units.length * units.normal * units.lambda;
    t.rotation1 = unit.to_caller(t.rotation1);
    t.rotation2 = unit.to_caller(t.rotation2);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline ContactGeometry<T, D>
contact_geometry(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                 SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    using namespace detail;
    return at_tangency(
        [](Tangency<T, D> const &at, SymmetricMatrix<T, D> const &p1,
           SymmetricMatrix<T, D> const &) {
            if (!(dot(at.v, at.v) > T(0)))
                return all_nan<ContactGeometry<T, D>>(StatusCode::invalid_argument);
            return ContactGeometry<T, D>{tangency_point(at, p1), tangency_normal(at),
                                         StatusCode::success};
        },
        r12, q1, q2, lambda);
}

template <class T, int D> PW85_FUNCTION inline ContactGradient<T, D>
contact_gradient(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                 SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    using namespace detail;
    return at_tangency(
        [](Tangency<T, D> const &at, SymmetricMatrix<T, D> const &, SymmetricMatrix<T, D> const &) {
            auto const nn = outer_weights(at.v);
            T const weight = at.lambda1 * at.lambda2;
            return ContactGradient<T, D>{separation_gradient(at), T(-at.lambda1 * weight) * nn,
                                         T(-at.lambda2 * weight) * nn, StatusCode::success};
        },
        r12, q1, q2, lambda);
}

template <class T, int D> PW85_FUNCTION inline ContactTorque<T, D>
contact_torque(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
               SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    using namespace detail;
    return at_tangency(
        [](Tangency<T, D> const &at, SymmetricMatrix<T, D> const &p1,
           SymmetricMatrix<T, D> const &p2) {
            auto const gradients = rotation_gradients(at, p1, p2);
            return ContactTorque<T, D>{gradients.first, gradients.second, StatusCode::success};
        },
        r12, q1, q2, lambda);
}

} // namespace pw85

#endif
