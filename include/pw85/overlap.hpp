/// @file
/// Whether two ellipsoids overlap, decided by the cheapest means that is certain.
///
/// 1. Quartic. With M = Q1 + t Q2, a = rᵀ adj(M) r and b = det M, the ellipsoids are apart where t a - (1 + t) b > 0 for some
///    t > 0 (W. Wang, J. Wang and M.-S. Kim, Comput. Aided Geom. Des. 18, 531, 2001), that is f > 1; and for any t, x0 is
///    inside both, and they overlap, if A < 1 and t²B < 1. Both are tested at a few t at once, with margins for rounding.
///    The first t is about √(rᵀQ1r/rᵀQ2r): there f > 1 whenever the projections on the line of centres are apart, as those
///    of bounding spheres are, since rᵀM⁻¹r >= |r|⁴/rᵀMr.
/// 2. Contact. μ² by the solver, against 1, with a margin for rounding.
/// 3. Exact. Whether the quartic has a positive root, from its discriminant, in integers (exact.hpp): if and only if it has
///    none the ellipsoids overlap. The quartic is negative at both ends of (0, ∞), and where it is not negative μ² >= 1.
#ifndef PW85_OVERLAP_HPP_INCLUDED
#define PW85_OVERLAP_HPP_INCLUDED

#include <pw85/exact.hpp>
#include <pw85/geometry.hpp>

namespace pw85 {

/// The means by which a pair was decided.
enum class OverlapTier { quartic, contact, exact };

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

/// What is certain after a test in each lane.
template <class Mask> struct Certainty {
    Mask apart;
    Mask overlap;
};

/// What the test on the quartic needs to know at t.
template <class T> struct QuarticEvaluation {
    T b;                                     ///< det M
    T a;                                     ///< b R, with R = rᵀM⁻¹r
    T form;                                  ///< b²B
    typename ScalarTraits<T>::Mask accurate; ///< whether M is well-conditioned
};

template <class T, int D>
static constexpr QuarticEvaluation<T> evaluate_quartic(Pair<T, D> const &pair, T const &t) noexcept
{
    auto const solution = solve_by_adjugate(blend(pair.q1, t, pair.q2), pair.r12);
    return {solution.determinant, dot(pair.r12, solution.s), quadratic_form(pair.q2, solution.s),
            is_accurate(solution)};
}

/// b²A, from A + tB = R.
template <class T> static constexpr T complement(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return e.a * e.b - t * e.form;
}

/// Margin, relative to one, of the tests on the quartic. Where M is well-conditioned, a and b err by less than 128 u/d <
/// 2^-27 of themselves, and s by e < √(u/8) = 2^-28 in the norm of M, where it measures √R: √(tB) and hence √A err by less
/// than 8 e where R < 64, t√B by less than 2^9 e where t R < 2^18, and the sums in the quadratic forms by 54 u R/d < 2^-23.
/// Where A < 1 and t²B < 1, R < 1 + 1/t.
template <class T> static constexpr T quartic_margin() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 2 - 9);
}

/// Item 1, at one t, for a pair with ratio 1.
template <class T>
static constexpr Certainty<typename ScalarTraits<T>::Mask> decide(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    T const rest = T(1) - quartic_margin<T>();
    T const square = rest * e.b * e.b;
    auto const apart = t * rest * e.a > (T(1) + t) * e.b;
    auto const inside = complement(e, t) < square && t * t * e.form < square;
    auto const resolvable = t > T(0x1p-5) && t < T(0x1p17);
    return {e.accurate && apart, e.accurate && resolvable && inside};
}

template <class Lanes, class T, int D> static constexpr Vector<Lanes, D> broadcast(Vector<T, D> const &x) noexcept
{
    Vector<Lanes, D> copies{};
    for (int i = 0; i < D; ++i) copies[i] = Lanes(x[i]);
    return copies;
}

template <class Lanes, class T, int D>
static constexpr SymmetricMatrix<Lanes, D> broadcast(SymmetricMatrix<T, D> const &a) noexcept
{
    SymmetricMatrix<Lanes, D> copies{};
    for (int k = 0; k < a.size; ++k) copies[k] = Lanes(a[k]);
    return copies;
}

/// Item 1 for any pair. A test that follows upon another costs most where its need cannot be foreseen, so that several are
/// made at once; from there on the fixed-point map of the solver's item 3 leads.
template <class Lanes, class T, int D> [[gnu::always_inline]] static inline Decision
decide_by_quartic(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    if (!is_ordinary(r12, q1, q2)) return Decision::none;
    constexpr int max_rounds = 5;
    // In as many lanes as there are: eight points decide 95 to 98 % of random pairs of aspect ratios from 2 to 100, four
    // 92 to 97 %, the first alone 80 to 96 %.
    constexpr T points[8] = {T(1), T(0.5), T(2), T(0.25), T(0.7), T(1.4), T(4), T(0.85)};
    auto const weights = outer_weights(r12);
    T center = coarse_root_of_ratio(quadratic_form(q1, weights), quadratic_form(q2, weights));
    Pair<Lanes, D> const pair{broadcast<Lanes>(r12), broadcast<Lanes>(q1), broadcast<Lanes>(q2), Lanes(T(1))};
    for (int round = 1;; ++round) {
        Lanes const t = Lanes(center) * load_lanes<Lanes>(points);
        auto const e = evaluate_quartic(pair, t);
        auto const certainty = decide(e, t);
        Decision const decision = to_decision(any_of(certainty.apart), any_of(certainty.overlap));
        if (decision != Decision::none || round == max_rounds) return decision;
        center = rough_root(rough_quotient(first_lane(complement(e, t)), first_lane(e.form)));
    }
}

/// The condition number of the contact function at the maximum: cond·u is what entrywise rounding of the data moves μ²/μ²
/// by.
template <class T, int D> static inline T condition_number(Pair<T, D> const &pair, Maximum<T> const &m) noexcept
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

/// Item 2. The stationary form of finish() sums with an error below 9 u cond, and 16 leaves room for what the inexact s and
/// λ add. `tangent` is μ² of tangent ellipsoids in the units of the pair.
template <class T, int D>
[[gnu::noinline]] static inline Decision decide_by_contact(Pair<T, D> const &pair, T const &tangent) noexcept
{
    Maximum<T> const m = maximize(pair);
    if (!m.converged) return Decision::none;
    T const error = T(16) * unit_roundoff<T>() * condition_number(pair, m) * m.mu2;
    return to_decision(m.mu2 - error > tangent, m.mu2 + error < tangent);
}

/// Items 2 and 3, for any pair. A multiprecision number is compared by item 2 to rounding.
template <class T, int D> [[gnu::noinline]] static inline Overlap
overlap_near_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = validate(r12, q1, q2, scaled);
    if (status != Status::success) return {false, OverlapTier::contact, status};
    if (largest_coordinate(r12) == T(0)) return {true, OverlapTier::contact, Status::success};
    T const tangent = times_power_of_two(T(1), 2 * (scaled.form - scaled.length));
    Decision const by_contact = decide_by_contact(scaled.pair, tangent);
    if (by_contact != Decision::none) return {by_contact == Decision::overlap, OverlapTier::contact, Status::success};
    if constexpr (exact::is_decidable<T>)
        return {decide_exactly(r12, q1, q2) == Decision::overlap, OverlapTier::exact, Status::success};
    else
        return {maximize(scaled.pair).mu2 < tangent, OverlapTier::contact, Status::success};
}

/// Whether two ellipsoids overlap, μ² < 1.
template <class T, int D> static inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    Decision const decision = decide_by_quartic<T>(r12, q1, q2);
    if (decision != Decision::none) return {decision == Decision::overlap, OverlapTier::quartic, Status::success};
    return overlap_near_contact(r12, q1, q2);
}

/// Whether two ellipsoids overlap, with what shows it.
template <class T, int D> static inline OverlapWitness<T, D>
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

} // namespace pw85

#endif
