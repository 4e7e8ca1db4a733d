// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rational form of f in λ, from the values of its polynomials at four points, and the
/// superseded solvers. They are kept for comparison; pw85_legacy.cpp calls them.
///
/// f(λ) = λ(1-λ) a(λ)/b(λ) with a = rᵀ adj[(1-λ)Q1 + λQ2] r and b = det[(1-λ)Q1 + λQ2].
#ifndef PW85_HISTORY_LEGACY_HPP_INCLUDED
#define PW85_HISTORY_LEGACY_HPP_INCLUDED

#include <pw85/contact/contact.hpp>

namespace pw85::detail::legacy {

template <class T> PW85_FUNCTION constexpr T determinant(SymmetricMatrix<T, 3> const &a) noexcept
{
    return pw85::detail::determinant(a, adjugate(a));
}

/// xᵀ adj(A) x.
template <class T> PW85_FUNCTION constexpr T adjugate_form(Vector<T, 3> const &x,
                                                           SymmetricMatrix<T, 3> const &a) noexcept
{
    return quadratic_form(adjugate(a), x);
}

/// Coefficients of the polynomials in increasing powers of λ.
template <class T> struct Polynomials {
    T a[3];
    T b[4];
};

/// The cubic b from det at λ = 0, 1, -1 and 1/2.
template <class T>
PW85_FUNCTION constexpr void interpolate_cubic(T const &at0, T const &at1, T const &at_minus1,
                                               T const &at_half, T (&b)[4]) noexcept
{
    b[0] = at0;
    b[1] = T(8) * at_half / T(3) - T(2) * at0 - at1 / T(2) - at_minus1 / T(6);
    b[2] = (at1 + at_minus1) / T(2) - at0;
    b[3] = T(2) * at0 + at1 - T(8) * at_half / T(3) - at_minus1 / T(3);
}

/// The quadratic a from its values at λ = 0, 1 and -1.
template <class T> PW85_FUNCTION constexpr void
interpolate_quadratic(T const &at0, T const &at1, T const &at_minus1, T (&a)[3]) noexcept
{
    a[0] = at0;
    a[1] = (at1 - at_minus1) / T(2);
    a[2] = (at1 + at_minus1) / T(2) - at0;
}

template <class T>
PW85_FUNCTION constexpr Polynomials<T> polynomials(Vector<T, 3> const &r12,
                                                   SymmetricMatrix<T, 3> const &q1,
                                                   SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const q3 = blend(T(2), q1, T(-1), q2), q4 = blend(T(0.5), q1, T(0.5), q2);
    Polynomials<T> p{};
    interpolate_quadratic(adjugate_form(r12, q1), adjugate_form(r12, q2), adjugate_form(r12, q3),
                          p.a);
    interpolate_cubic(determinant(q1), determinant(q2), determinant(q3), determinant(q4), p.b);
    return p;
}

/// f, f' and f'' from the polynomials: with g = λ(1-λ)a, f' = (g' - f b')/b and f'' = (g'' -
/// 2f'b' - f b'')/b.
template <class T> PW85_FUNCTION constexpr Derivatives<T> evaluate_rational(Polynomials<T> const &p,
                                                                            T const &x) noexcept
{
    T const w = x * (T(1) - x), w1 = T(1) - T(2) * x;
    T const a = (p.a[2] * x + p.a[1]) * x + p.a[0], a1 = T(2) * p.a[2] * x + p.a[1],
            a2 = T(2) * p.a[2];
    T const b = ((p.b[3] * x + p.b[2]) * x + p.b[1]) * x + p.b[0];
    T const b1 = (T(3) * p.b[3] * x + T(2) * p.b[2]) * x + p.b[1],
            b2 = T(6) * p.b[3] * x + T(2) * p.b[2];
    T const f = w * a / b, f1 = (w1 * a + w * a1 - f * b1) / b;
    return {f, f1, (T(2) * (w1 * a1 - a) + w * a2 - T(2) * f1 * b1 - f * b2) / b};
}

/// f, f' and f'' at λ; NaN for invalid input.
template <class T>
PW85_FUNCTION inline Derivatives<T> checked_rational(T const &lambda, Vector<T, 3> const &r12,
                                                     SymmetricMatrix<T, 3> const &q1,
                                                     SymmetricMatrix<T, 3> const &q2) noexcept
{
    return is_valid(lambda, pair_of(r12, q1, q2))
               ? evaluate_rational(polynomials(r12, q1, q2), lambda)
               : invalid_derivatives<T>();
}

/// The numerator c(λ) of f' = c/b².
template <class T> PW85_FUNCTION constexpr T numerator(Polynomials<T> const &p, T const &x) noexcept
{
    T const w = x * (T(1) - x), w1 = T(1) - T(2) * x;
    T const a = (p.a[2] * x + p.a[1]) * x + p.a[0], a1 = T(2) * p.a[2] * x + p.a[1];
    T const b = ((p.b[3] * x + p.b[2]) * x + p.b[1]) * x + p.b[0];
    T const b1 = (T(3) * p.b[3] * x + T(2) * p.b[2]) * x + p.b[1];
    return (w1 * a + w * a1) * b - w * a * b1;
}

/// Scales a valid pair to one unit for both forms, which keeps its polynomials in range.
template <class T>
PW85_FUNCTION inline ScaledPair<T, 3> scale_alike(Pair<T, 3> const &pair) noexcept
{
    Unit const length = unit_of(pair.r12), form = larger_of(unit_of(pair.q1), unit_of(pair.q2));
    return {pair_of(length.to_local(pair.r12), form.to_local(pair.q1), form.to_local(pair.q2)),
            {length, form, form, false, {}}};
}

/// Newton-Raphson iterations on f' from λ = 1/2. If f varies sharply near an end, they often leave
/// [0, 1] or do not converge; then the status is not success.
template <class T> PW85_FUNCTION inline Contact<T> newton(Pair<T, 3> const &pair) noexcept
{
    constexpr int max_iterations = 50;
    T x = T(0.5);
    for (int i = 0; i < max_iterations; ++i) {
        auto const f = evaluate_derivatives(x, pair.r12, pair.q1, pair.q2);
        T const step = f.first / f.second;
        x = x - step;
        if (!(f.second < T(0)) || !(x > T(0) && x < T(1))) break;
        // One quadratically convergent step from here is exact to rounding.
        if (absolute(step) <= square_root(unit_roundoff<T>()) * minimum(x, T(T(1) - x)))
            return {evaluate_f(x, pair.r12, pair.q1, pair.q2), x, StatusCode::success};
    }
    return all_nan<Contact<T>>(StatusCode::no_convergence);
}

/// Bisection on the numerator of f', to the last digit of λ. If cancellation in the polynomials
/// makes the value of f meaningless there, f is computed by the factorised form.
template <class T> PW85_FUNCTION inline Contact<T> bisection(Pair<T, 3> const &pair) noexcept
{
    auto const p = polynomials(pair.r12, pair.q1, pair.q2);
    T lower = T(0), upper = T(1), x = T(0.5);
    for (int i = 0; i < 2 * mantissa_digits<T>() && x > lower && x < upper; ++i) {
        (numerator(p, x) > T(0) ? lower : upper) = x;
        x = T(0.5) * (lower + upper);
    }
    T const f = evaluate_rational(p, x).f;
    bool const sensible = f > T(0) && f <= largest_number<T>();
    return {sensible ? f : evaluate_f(x, pair.r12, pair.q1, pair.q2), x, StatusCode::success};
}

/// The contact function by one of the solvers above.
template <class T, class Solver>
PW85_FUNCTION inline Contact<T> contact_by(Solver solver, Vector<T, 3> const &r12,
                                           SymmetricMatrix<T, 3> const &q1,
                                           SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const pair = pair_of(r12, q1, q2);
    ScaledPair<T, 3> scaled;
    StatusCode const status = validate_pair(pair, scaled);
    if (status != StatusCode::success) return all_nan<Contact<T>>(status);
    if (largest_coordinate(r12) == T(0)) return {T(0), T(0.5), StatusCode::success};
    scaled = scale_alike(pair);
    Contact<T> result = solver(scaled.pair);
    result.mu2 = scaled.units.mu().to_caller(result.mu2, 2);
    return result;
}

} // namespace pw85::detail::legacy

namespace pw85::legacy {

/// The contact function by Newton-Raphson iterations on f' from λ = 1/2, which often do not
/// converge.
template <class T>
PW85_FUNCTION inline Contact<T> contact_newton(Vector<T, 3> const &r12,
                                               SymmetricMatrix<T, 3> const &q1,
                                               SymmetricMatrix<T, 3> const &q2) noexcept
{
    return detail::legacy::contact_by(detail::legacy::newton<T>, r12, q1, q2);
}

/// The contact function by bisection on the numerator of f' in rational form.
template <class T>
PW85_FUNCTION inline Contact<T> contact_bisection(Vector<T, 3> const &r12,
                                                  SymmetricMatrix<T, 3> const &q1,
                                                  SymmetricMatrix<T, 3> const &q2) noexcept
{
    return detail::legacy::contact_by(detail::legacy::bisection<T>, r12, q1, q2);
}

} // namespace pw85::legacy

#endif
