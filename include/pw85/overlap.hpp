/// @file
/// Whether two ellipsoids overlap, decided by the cheapest means that is certain.
///
/// 1. Projection. The ellipsoids project on the line of centres with half-widths √(rᵀQ1r)/|r| and √(rᵀQ2r)/|r|: if these do
///    not fill |r|, the ellipsoids are apart.
/// 2. Quartic. With M = Q1 + t Q2, a = rᵀ adj(M) r and b = det M, the ellipsoids are apart where p(t) = t a - (1 + t) b > 0
///    for some t > 0 (W. Wang, J. Wang and M.-S. Kim, Comput. Aided Geom. Des. 18, 531, 2001), that is f > 1; and for any
///    t, x0 is inside both, and they overlap, if A < 1 and t²B < 1. Both are tested at a few t, with margins for rounding.
/// 3. Contact. μ² by the solver, against 1, with a margin for rounding.
/// 4. Exact. The number of positive roots of the quartic, by Sturm's theorem in exact arithmetic: none if and only if the
///    ellipsoids overlap. p is negative at both ends of (0, ∞), and where it is not negative μ² >= 1.
#ifndef PW85_OVERLAP_HPP_INCLUDED
#define PW85_OVERLAP_HPP_INCLUDED

#include <pw85/dyadic.hpp>
#include <pw85/geometry.hpp>

namespace pw85::inline PW85_TARGET {

/// The means by which a pair was decided.
enum class OverlapTier { projection, quartic, contact, exact };

/// Whether two ellipsoids overlap; false where the status is not success.
struct Overlap {
    bool overlap;
    OverlapTier tier;
    Status status;
};

/// What shows that two ellipsoids overlap or not. Near tangency it is right to rounding only.
template <class T, int D> struct OverlapWitness {
    bool overlap;
    T lambda;               ///< where f > 1 if they are apart
    Vector<T, D> direction; ///< unit normal of a plane that separates them, from 1 to 2, if they are apart
    Vector<T, D> point;     ///< inside both, relative to the centre of ellipsoid 1, if they overlap
    Status status;
};

/// What is certain after a test; both false if nothing is.
template <class Mask> struct Certainty {
    Mask apart;
    Mask overlap;
};

/// Margin, relative to one, of the tests on the quartic. They require the scaled determinant d of conditioning() to be at
/// least fine_conditioning(), and R = rᵀM⁻¹r < 64. Then bR and b err by less than 128 u/d < 2^-27 of themselves, and s by
/// e < √(u/8) in the norm of M, where it measures √R: √B√t and hence √A err by less than 8e < 2^-24, and the sums in the
/// quadratic form by 54 u R/d < 2^-23.
template <class T> constexpr T quartic_margin() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 2 - 6);
}

/// Half-widths of the projections on r12, times |r12|.
template <class T> struct Projection {
    T width1, width2;
};

template <class T, int D> inline Projection<T> project(Pair<T, D> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    return {square_root(quadratic_form(pair.q1, weights)), square_root(quadratic_form(pair.q2, weights))};
}

/// Item 1. Valid forms of clear definiteness project with a relative error far below the margin.
template <class T, int D>
constexpr typename ScalarTraits<T>::Mask is_apart(Pair<T, D> const &pair, Projection<T> const &p) noexcept
{
    return dot(pair.r12, pair.r12) > (T(1) + quartic_margin<T>()) * (p.width1 + p.width2);
}

/// b = det M, b R = rᵀ adj(M) r, and b²B at t.
template <class T> struct QuarticEvaluation {
    T b, rs, form;
    T diagonal; ///< product of the diagonal of M
};

template <class T, int D> constexpr QuarticEvaluation<T> evaluate_quartic(Pair<T, D> const &pair, T const &t) noexcept
{
    auto const m = blend(T(1), pair.q1, t, pair.q2);
    auto const adj = adjugate(m);
    Vector<T, D> const s = product(adj, pair.r12);
    T diagonal = m(0, 0);
    for (int i = 1; i < D; ++i) diagonal = diagonal * m(i, i);
    return {determinant(m, adj), dot(pair.r12, s), quadratic_form(pair.q2, s), diagonal};
}

/// b²A, from A + tB = R.
template <class T> constexpr T complement(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return e.b * e.rs - t * e.form;
}

/// Item 2, at one t, for a pair with ratio 1.
template <class T>
constexpr Certainty<typename ScalarTraits<T>::Mask> decide(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    T const margin = T(1) + quartic_margin<T>();
    auto const reliable = e.b > fine_conditioning<T>() * e.diagonal && e.rs < T(64) * e.b;
    auto const apart = t * e.rs > (T(1) + t) * margin * e.b;
    auto const overlap = maximum(complement(e, t), T(t * t * e.form)) * margin < e.b * e.b;
    return {reliable && apart, reliable && overlap};
}

/// Item 2 for a pair with ratio 1, from t on. The fixed-point map of the solver's item 3 is slow to converge, but cheap, and
/// two or three points are enough unless the ellipsoids are nearly tangent.
template <class T, int D> inline Certainty<bool> decide_by_quartic(Pair<T, D> const &pair, T t) noexcept
{
    constexpr int max_points = 5;
    for (int i = 1;; ++i) {
        auto const e = evaluate_quartic(pair, t);
        auto const certainty = decide(e, t);
        if (certainty.apart || certainty.overlap || i == max_points) return certainty;
        t = square_root(T(complement(e, t) / e.form));
    }
}

/// The condition number of the contact function at the maximum: cond·u is what entrywise rounding of the data moves μ²/μ²
/// by.
template <class T, int D> inline T condition_number(Pair<T, D> const &pair, Maximum<T> const &m) noexcept
{
    T const t = m.lambda / pair.ratio / m.complement / pair.ratio;
    Vector<T, D> const s = solve(factorize_blend(T(1), pair.q1, t, pair.q2), pair.r12);
    T forms = T(0), arms = T(0);
    for (int i = 0; i < D; ++i) {
        arms = arms + absolute(T(pair.r12[i] * s[i]));
        for (int j = 0; j < D; ++j)
            forms = forms + (absolute(pair.q1(i, j)) + t * absolute(pair.q2(i, j))) * absolute(T(s[i] * s[j]));
    }
    return m.lambda * (forms + T(2) * arms) / m.mu2;
}

/// Item 3. The stationary form of finish() sums with an error below 9 u cond, and 16 leaves room for what the inexact s and
/// λ add. `tangent` is μ² of tangent ellipsoids in the units of the pair.
template <class T, int D>
[[gnu::noinline]] inline Certainty<bool> decide_by_contact(Pair<T, D> const &pair, T const &tangent) noexcept
{
    Maximum<T> const m = maximize(pair);
    if (!m.converged) return {false, false};
    T const error = T(16) * unit_roundoff<T>() * condition_number(pair, m) * m.mu2;
    return {m.mu2 - error > tangent, m.mu2 + error < tangent};
}

/// A polynomial of degree up to 4, in increasing powers.
struct ExactPolynomial {
    Dyadic c[5];
    int degree;

    void trim() noexcept
    {
        while (degree >= 0 && c[degree].sign() == 0) --degree;
    }
};

/// Minus the remainder of p by q, times a positive number.
inline ExactPolynomial negative_remainder(ExactPolynomial p, ExactPolynomial const &q) noexcept
{
    bool negative = true;
    while (p.degree >= q.degree) {
        Dyadic const lead = p.c[p.degree];
        int const shift = p.degree - q.degree;
        for (int i = 0; i < p.degree; ++i) {
            p.c[i] = p.c[i] * q.c[q.degree];
            if (i >= shift) p.c[i] = p.c[i] - lead * q.c[i - shift];
        }
        if (q.c[q.degree].sign() < 0) negative = !negative;
        --p.degree;
        p.trim();
    }
    for (int i = 0; negative && i <= p.degree; ++i) p.c[i] = -p.c[i];
    return p;
}

/// The number of distinct roots of p in (0, ∞), by Sturm's theorem; p(0) != 0. `exact` becomes false if a number did not fit.
inline int count_positive_roots(ExactPolynomial p, bool &exact) noexcept
{
    p.trim();
    ExactPolynomial q{{}, p.degree - 1};
    for (int i = 1; i <= p.degree; ++i) q.c[i - 1] = Dyadic(i) * p.c[i];
    int at_zero = 0, at_infinity = 0, sign_at_zero = 0, sign_at_infinity = 0;
    while (p.degree >= 0) {
        for (int i = 0; i <= p.degree; ++i) exact = exact && p.c[i].is_exact();
        if (!exact) return 0;
        int const zero = p.c[0].sign(), infinity = p.c[p.degree].sign();
        if (zero * sign_at_zero < 0) ++at_zero;
        if (infinity * sign_at_infinity < 0) ++at_infinity;
        if (zero != 0) sign_at_zero = zero;
        sign_at_infinity = infinity;
        ExactPolynomial const next = q.degree >= 0 ? negative_remainder(p, q) : q;
        p = q;
        q = next;
    }
    return at_zero - at_infinity;
}

/// Item 4, for the numbers as they were given. Not certain if their magnitudes span so many binades that 16384 bits do not
/// hold what comes of them.
template <class T, int D> [[gnu::noinline]] inline Certainty<bool>
decide_exactly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Vector<Dyadic, D> r;
    SymmetricMatrix<Dyadic, D> p, q;
    for (int i = 0; i < D; ++i) r[i] = Dyadic(r12[i]);
    for (int k = 0; k < p.size; ++k) {
        p[k] = Dyadic(q1[k]);
        q[k] = Dyadic(q2[k]);
    }
    auto const form = rational_form(Pair<Dyadic, D>{r, p, q, Dyadic(1)});
    ExactPolynomial quartic{{-form.b[0], form.a[0] - form.b[1] - form.b[0], form.a[1] - form.b[2] - form.b[1],
                             form.a[2] - form.b[3] - form.b[2], -form.b[3]},
                            4};
    bool exact = true;
    bool const has_root = count_positive_roots(quartic, exact) > 0;
    return {exact && has_root, exact && !has_root};
}

/// Items 3 and 4, for any pair.
template <class T, int D> [[gnu::noinline]] inline Overlap
overlap_near_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = validate(r12, q1, q2, scaled);
    if (status != Status::success) return {false, OverlapTier::contact, status};
    if (largest_coordinate(r12) == T(0)) return {true, OverlapTier::contact, Status::success};
    T const tangent = times_power_of_two(T(1), 2 * (scaled.form - scaled.length));
    auto const by_contact = decide_by_contact(scaled.pair, tangent);
    if (by_contact.apart || by_contact.overlap) return {by_contact.overlap, OverlapTier::contact, Status::success};
    auto const exactly = decide_exactly(r12, q1, q2);
    if (exactly.apart || exactly.overlap) return {exactly.overlap, OverlapTier::exact, Status::success};
    return {maximize(scaled.pair).mu2 < tangent, OverlapTier::contact, Status::success};
}

/// Whether two ellipsoids overlap, μ² < 1.
template <class T, int D> inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                 SymmetricMatrix<T, D> const &q2) noexcept
{
    if (is_finite(r12) && is_ordinary(r12, q1, q2)) {
        Pair<T, D> const pair{r12, q1, q2, T(1)};
        auto const projection = project(pair);
        if (is_apart(pair, projection)) return {false, OverlapTier::projection, Status::success};
        auto const certainty = decide_by_quartic(pair, T(projection.width1 / projection.width2));
        if (certainty.apart || certainty.overlap) return {certainty.overlap, OverlapTier::quartic, Status::success};
    }
    return overlap_near_contact(r12, q1, q2);
}

/// Whether two ellipsoids overlap, with what shows it.
template <class T, int D> inline OverlapWitness<T, D>
overlap_witness(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const answer = overlap(r12, q1, q2);
    T const lambda = contact(r12, q1, q2).lambda;
    auto const geometry = contact_geometry(r12, q1, q2, lambda);
    OverlapWitness<T, D> witness{answer.overlap, lambda, geometry.normal, geometry.point, answer.status};
    for (int i = 0; i < D; ++i) {
        if (answer.overlap) witness.direction[i] = quiet_nan<T>();
        if (answer.status != Status::success || !answer.overlap)
            witness.point[i] = quiet_nan<T>();
        else if (geometry.status != Status::success)
            witness.point[i] = T(0);
    }
    return witness;
}

} // namespace pw85::inline PW85_TARGET

#endif
