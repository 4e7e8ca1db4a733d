/// @file
/// The first tier of the overlap test: the sign of a quartic.
///
/// With M = Q1 + t Q2, a = rᵀ adj(M) r and b = det M, the ellipsoids are apart where t a - (1 + t) b > 0 for some t > 0
/// (W. Wang, J. Wang and M.-S. Kim, Comput. Aided Geom. Des. 18, 531, 2001), that is f > 1; and for any t, x0 is inside both, and
/// they overlap, if A < 1 and t²B < 1. Both are tested at a few t, with bounds on the rounding errors: what is decided is certain.
/// The first t is about √(rᵀQ1r/rᵀQ2r): there f > 1 whenever the projections on the line of centres are apart, as those
/// of bounding spheres are, since rᵀM⁻¹r >= |r|⁴/rᵀMr. The search on the rational form leads to the next ones.
#ifndef PW85_QUARTIC_HPP_INCLUDED
#define PW85_QUARTIC_HPP_INCLUDED

#include <pw85/contact.hpp>
#include <pw85/decision.hpp>

namespace pw85 {

/// What is certain after a test in each lane.
template <class Mask> struct Certainty {
    Mask apart;
    Mask overlap;
};

/// What the test needs to know at t. In units in which M has a unit diagonal, `diagonal` is 1 and `arms` is |r|².
template <class T> struct QuarticEvaluation {
    T b;        ///< det M
    T a;        ///< b R, with R = rᵀM⁻¹r
    T form;     ///< b²B
    T diagonal; ///< P, the product of the diagonal of M
    T arms;     ///< W = Σ r_i² P/M_ii
};

/// Σ r_i² P/M_ii, with P the product of the diagonal of M.
template <class T> static constexpr T weighted_square(SymmetricMatrix<T, 2> const &m, Vector<T, 2> const &r) noexcept
{
    return T(r[0] * r[0]) * m[2] + T(r[1] * r[1]) * m[0];
}

template <class T> static constexpr T weighted_square(SymmetricMatrix<T, 3> const &m, Vector<T, 3> const &r) noexcept
{
    return T(T(r[0] * r[0]) * m[3] + T(r[1] * r[1]) * m[0]) * m[5] + T(T(r[2] * r[2]) * m[0]) * m[3];
}

template <class T, int D>
static constexpr QuarticEvaluation<T> evaluate_quartic(Pair<T, D> const &pair, T const &t) noexcept
{
    auto const m = blend(pair.q1, t, pair.q2);
    auto const solution = solve_by_adjugate(m, pair.r12);
    return {solution.determinant, dot(pair.r12, solution.s), quadratic_form(pair.q2, solution.s), solution.diagonal,
            weighted_square(m, pair.r12)};
}

/// b²A, from A + tB = R.
template <class T> static constexpr T first_form(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return e.a * e.b - t * e.form;
}

/// t² for the next t of the fixed-point map, x - h in log t.
template <class T> static constexpr T fixed_point_square(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return rough_quotient(first_form(e, t), e.form);
}

/// What one t shows, for a pair with ratio 1 that is_ordinary(). Errors to first order in u, in units in which M has a unit
/// diagonal and det M = d, where adj(M) errs by 11u in each entry and s by e = 126 u/d of itself (rational.hpp):
///
/// Apart. a errs by 17u (Σ|r_i|)² <= 51 u W and b by 48 u; t a and (1 + t) b are at most 9/4 t W and 1 + t, and rounded three
/// times more. So 64 u (t W + (1 + t) P) is more than t a - (1 + t) b errs by.
///
/// Overlap. Relative to b² R: a b errs by (3·51 + 48 + 2) u/d, since b R >= W d/3; t b²B by 2e, and by 54 u/d from rounding
/// (8 roundings of |s|²·3, where |s|² <= 9/4 R/d); b² errs by 96 u/d of itself. In total A errs by less than 640 u/d R, and
/// t²B by less than 450 u/d t R. Where d > 2048 u, R is less than 11 % more than computed, and that is A + tB < 1 + 1/t
/// where what is to be shown is. So A and t²B err by less than 1024 u/d (1 + 1/t) and 1024 u/d (1 + t).
template <class T>
static constexpr Certainty<typename ScalarTraits<T>::Mask> decide(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    auto const u = unit_roundoff<T>();
    T const one_plus_t = T(1) + t, pb = e.diagonal * e.b, square = e.b * e.b;
    T const error_apart = T(64 * u) * (t * e.arms + one_plus_t * e.diagonal);
    T const error_overlap = T(1024 * u) * T(one_plus_t * pb);
    auto const positive = t > T(0);
    auto const apart = t * e.a > one_plus_t * e.b + error_apart;
    auto const inside1 = t * first_form(e, t) + error_overlap < t * square;
    auto const inside2 = t * T(t * e.form) + error_overlap < square;
    return {positive && apart, positive && e.b > T(2048 * u) * e.diagonal && inside1 && inside2};
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

/// The test at several points about the first t at once, as many as there are lanes: a test that follows upon another costs
/// most where its need cannot be foreseen. Eight points decide 95 to 98 % of random pairs of aspect ratios from 2 to 100, four 92
/// to 97 %, the first alone 80 to 96 %. `t` becomes that of the fixed-point map from the first point.
template <class Lanes, class T, int D>
[[gnu::always_inline]] static inline Decision decide_by_points(Pair<T, D> const &pair, T &t) noexcept
{
    T const points[8] = {T(1), T(0.5), T(2), T(0.25), T(0.7), T(1.4), T(4), T(0.85)};
    auto const weights = outer_weights(pair.r12);
    T const center = coarse_root_of_ratio(quadratic_form(pair.q1, weights), quadratic_form(pair.q2, weights));
    Lanes const probes = Lanes(center) * load_lanes<Lanes>(points);
    Pair<Lanes, D> const copies{broadcast<Lanes>(pair.r12), broadcast<Lanes>(pair.q1), broadcast<Lanes>(pair.q2),
                                Lanes(T(1))};
    auto const e = evaluate_quartic(copies, probes);
    auto const certainty = decide(e, probes);
    t = rough_root(first_lane(fixed_point_square(e, probes)));
    return to_decision(any_of(certainty.apart), any_of(certainty.overlap));
}

/// The test at the points through which a search from t on the rational form goes.
template <class T, int D> static inline Decision decide_by_search(Pair<T, D> const &pair, T const &t) noexcept
{
    auto state = start_search(pair, t);
    Decision decision = Decision::none;
    for (int step = 0; any_of(state.active) && decision == Decision::none && step < max_rational_steps; ++step) {
        take_step(state, pair.ratio);
        auto const certainty = decide(evaluate_quartic(pair, state.candidate.t), state.candidate.t);
        decision = to_decision(certainty.apart, certainty.overlap);
    }
    return decision;
}

/// The tier for one pair; `none` for pairs that are not ordinary, ill-conditioned, or tangent to about as many digits as their
/// conditioning leaves.
template <class Lanes, class T, int D> [[gnu::always_inline]] static inline Decision
decide_by_quartic(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    if (!is_ordinary(r12, q1, q2)) return Decision::none;
    Pair<T, D> const pair{r12, q1, q2, T(1)};
    T t;
    Decision const decision = decide_by_points<Lanes>(pair, t);
    return decision != Decision::none ? decision : decide_by_search(pair, t);
}

} // namespace pw85

#endif
