// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether ellipsoid 2 is inside ellipsoid 1 in n dimensions, decided in integers. containment.hpp
/// calls contains_exactly() where floating-point numbers do not suffice.
///
/// Let M(ν) = νQ1 - Q2, B = det M, A = rᵀ adj(M) r and p = (1 - ν) B - νA, of degrees n, n - 1 and
/// n + 1. The roots of B are the eigenvalues d_i > 0 of Q1⁻¹Q2; let ν1 be the largest one.
///
/// 1. By the S-lemma, ellipsoid 2 is inside if and only if K(ν) = Q1 - Q2/ν - r rᵀ/(1 - ν) is
///    positive semidefinite for some ν in (0, 1); for r = 0, if and only if Q1 - Q2 is positive
///    semidefinite (exact_containment.hpp of overlap/, with w = ν/(1 - ν)). Such a ν is at least
///    ν1. Therefore ν1 < 1 is necessary for r != 0. For ν > ν1, K(ν) is positive semidefinite if
///    and only if h(ν) >= 0, where h(ν) = p/B = (1 - ν) - rᵀ(Q1 - Q2/ν)⁻¹r.
/// 2. In the eigenbasis, h = (1 - ν) - ν Σ c_i/(ν - d_i) with c_i > 0. The sum is over the k
///    distinct d_i for which r has a component in the eigenspace. Let h = q/E in lowest terms. E
///    has these d_i as its roots, q has the degree k + 1, and p/q = B/E = gcd(p, B). h is -∞ at
///    infinity, and at ν1 if ν1 is one of these d_i. So ellipsoid 2 is inside if and only if the
///    largest root of q is at least ν1. If ν1 is not one of these d_i, K(ν1) is the limit of K(ν),
///    so equality counts as inside.
/// 3. Between two neighbours of these d_i, h rises from -∞ to ∞. This gives k - 1 roots of q below
///    the largest d_i. If the largest root of q is at least ν1, q therefore has k - 1 simple roots
///    there, and two more roots above. All roots of q are then real and positive, and so are those
///    of p. If p has other roots, ellipsoid 2 is not inside.
/// 4. For a polynomial with real roots Descartes' rule of signs is exact: the coefficients of p(x +
///    t) change sign as often as p has roots above x. Therefore bisection finds which of several
///    polynomials has the largest root, if no two of them have this root in common. Let c = gcd(q,
///    B), and let q' and B' be q and B without the roots of c. No two of q', B' and c have a root
///    in common. If q' or c has the largest root of the three, ellipsoid 2 is inside. If B' has it,
///    ellipsoid 2 is not inside.
#ifndef PW85_ANY_DIMENSION_EXACT_CONTAINMENT_HPP_INCLUDED
#define PW85_ANY_DIMENSION_EXACT_CONTAINMENT_HPP_INCLUDED

#include <pw85/any_dimension/exact_sign.hpp>

namespace pw85::detail::any_dimension {

PW85_FUNCTION inline void copy(ExactPolynomial const &x, ExactPolynomial &y) noexcept
{
    y.degree = x.degree;
    for (int i = 0; i <= x.degree; ++i) y.c[i] = copy(x.c[i]);
}

/// Replaces p(t) by p(t + step), step = ±1.
PW85_FUNCTION inline void shift(ExactPolynomial &p, int step) noexcept
{
    for (int i = 0; i < p.degree; ++i)
        for (int j = p.degree - 1; j >= i; --j) p.c[j] = sum(p.c[j], p.c[j + 1], step);
}

/// Replaces p(t) by 2^degree p(t/2).
PW85_FUNCTION inline void stretch(ExactPolynomial &p) noexcept
{
    for (int i = 0; i < p.degree; ++i) p.c[i] = p.c[i] * to_integer(1.0, p.degree - i);
}

/// Counts the changes of sign of the coefficients: the number of positive roots, if all roots are
/// real.
PW85_FUNCTION inline int count_sign_changes(ExactPolynomial const &p) noexcept
{
    int count = 0, last = 0;
    for (int i = 0; i <= p.degree; ++i) {
        int const sign = p.c[i].sign();
        if (sign * last < 0) ++count;
        if (sign != 0) last = sign;
    }
    return count;
}

/// Replaces p by its multiple that has the given leading coefficient. Its coefficients must be
/// integers.
PW85_FUNCTION inline void set_leading(ExactPolynomial &p, Integer const &leading) noexcept
{
    Integer const old = copy(p.leading());
    for (int i = 0; i <= p.degree; ++i) p.c[i] = exact_quotient(leading * p.c[i], old);
}

/// Computes the greatest common divisor, up to a factor. Returns whether there is memory. Its
/// leading coefficient becomes that of y: y is an integer times a divisor with integer
/// coefficients.
PW85_FUNCTION inline bool find_common_divisor(ExactPolynomial const &x, ExactPolynomial const &y,
                                              ExactPolynomial &divisor) noexcept
{
    ExactPolynomial pair[2];
    copy(x, pair[0]);
    copy(y, pair[1]);
    auto const *const last = divide_repeatedly(pair, [](ExactPolynomial const &) {});
    if (last == nullptr) return false;
    copy(*last, divisor);
    set_leading(divisor, y.leading());
    return is_defined(divisor);
}

/// Replaces p by p/y, up to a factor, for a divisor y: its leading coefficient stays that of p.
PW85_FUNCTION inline void divide(ExactPolynomial &p, ExactPolynomial const &y) noexcept
{
    Integer const leading = copy(p.leading());
    int const degree = p.degree - y.degree;
    for (int k = degree; k >= 0;
         --k) { // the quotient replaces the coefficients above the remainder
        Integer const &top = p.c[k + y.degree];
        for (int i = 0; i < k + y.degree; ++i) {
            p.c[i] = y.leading() * p.c[i];
            if (i >= k) p.c[i] = p.c[i] - top * y.c[i - k];
        }
        for (int i = k + y.degree + 1; i <= p.degree; ++i) p.c[i] = y.leading() * p.c[i];
    }
    for (int k = 0; k <= degree; ++k) p.c[k] = std::move(p.c[k + y.degree]);
    p.degree = degree;
    set_leading(p, leading);
}

/// Divides p by its common divisor with y, until they have no common root. Returns whether there is
/// memory.
PW85_FUNCTION inline bool remove_roots(ExactPolynomial &p, ExactPolynomial const &y) noexcept
{
    for (;;) {
        ExactPolynomial common;
        if (!find_common_divisor(y, p, common)) return false;
        if (common.degree == 0) return true;
        divide(p, common);
    }
}

/// Returns the index of the polynomial with the largest root of three, or -1 if there is no memory.
/// All roots must be real, above 0 and at most 1, and no two polynomials may have one in common.
PW85_FUNCTION inline int find_largest_root(ExactPolynomial (&p)[3]) noexcept
{
    for (;;) {
        ExactPolynomial upper[3];
        int count = 0, last = 0;
        for (int k = 0; k < 3; ++k) {
            if (!is_defined(p[k])) return -1;
            stretch(p[k]);
            copy(p[k], upper[k]);
            shift(upper[k], 1);
            if (count_sign_changes(upper[k]) > 0) ++count, last = k;
        }
        if (count == 1) return last;
        for (int k = 0; count > 1 && k < 3; ++k) p[k] = std::move(upper[k]);
    }
}

/// Computes p and B as polynomials of ν - 1. Returns 1, 0 if Q1 - Q2 is not positive semidefinite,
/// or sign_unknown. Interpolation is at ν = 2 … n + 3, where M is positive definite if Q1 - Q2 is
/// semidefinite.
PW85_FUNCTION inline int find_containment_polynomials(Input const &in, ExactPolynomial &p,
                                                      ExactPolynomial &b) noexcept
{
    int const n = in.n;
    IntegerInput x;
    read(in, 1.0, x);
    Integer values_p[max_dimension + 2], values_b[max_dimension + 2];
    for (int k = 0; k <= n + 1; ++k) {
        int const nu = k + 2;
        Minors at = evaluate(n, x, nu, -1);
        if (at.definite == sign_unknown) return sign_unknown;
        if (at.definite != 1) return 0;
        values_p[k] = to_integer(nu, 0) * x.scale_a * at.bordered +
                      to_integer(1 - nu, 0) * x.scale_b * at.determinant;
        values_b[k] = std::move(at.determinant);
    }
    interpolate(n + 1, values_p, p);
    interpolate(n, values_b, b);
    shift(p, -1);
    shift(b, -1);
    return is_defined(p) && is_defined(b) ? 1 : sign_unknown;
}

/// Decides by the largest roots, for p and B with real roots above 0 and at most 1. If ν1 = 1, B
/// has it: h < 0 there, so it is not a root of q. Returns 1, 0 or sign_unknown.
PW85_FUNCTION inline int compare_largest_roots(ExactPolynomial &p, ExactPolynomial &b) noexcept
{
    ExactPolynomial candidates[3]; // q', B' and c
    ExactPolynomial divisor;
    if (!find_common_divisor(p, b, divisor)) return sign_unknown;
    if (divisor.degree > 0) {
        divide(p, divisor);
        if (!find_common_divisor(p, b, divisor)) return sign_unknown;
    }
    if (divisor.degree > 0 && !(remove_roots(p, divisor) && remove_roots(b, divisor)))
        return sign_unknown;
    candidates[0] = std::move(p);
    candidates[1] = std::move(b);
    candidates[2] = std::move(divisor);
    int const largest = find_largest_root(candidates);
    return largest < 0 ? sign_unknown : largest != 1;
}

/// Returns whether ellipsoid 2 is inside ellipsoid 1: 1 or 0, or sign_unknown. Both forms must be
/// positive definite.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline int contains_exactly(Input const &in) noexcept
{
    ExactPolynomial p, b;
    int const semidefinite = find_containment_polynomials(in, p, b);
    if (semidefinite != 1) return semidefinite;
    bool const below_one = count_sign_changes(b) == 0;
    if (largest_magnitude(in.n, in.r12) == 0.0 || !below_one) return below_one;
    shift(p, -1);
    shift(b, -1);
    if (count_sign_changes(p) < p.degree) return 0;
    ExactPolynomial pair[2];
    copy(p, pair[0]);
    auto const roots = count_roots(pair);
    if (roots.positive < 0 || !is_defined(b)) return sign_unknown;
    return roots.positive + roots.repeated < p.degree ? 0 : compare_largest_roots(p, b);
}

} // namespace pw85::detail::any_dimension

#endif
