// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The least contact function of two ellipsoids when one passes the other on a straight path: the
/// least μ² of the separations r + t v, 0 <= t <= t_max.
///
/// For fixed forms μ is a norm of the separation. So μ² is a convex function of t, strictly convex
/// for v != 0, and its minimum is unique. If the minimum on the whole line is outside the range,
/// the minimum of the range is at its nearer end. The least over t of the largest f over λ is the
/// largest over λ of the least f over t, because f is convex in t and concave in λ. In the formulas
/// W = [(1-λ)Q1 + λQ2]⁻¹.
#ifndef PW85_MOTION_CLOSEST_PASSAGE_HPP_INCLUDED
#define PW85_MOTION_CLOSEST_PASSAGE_HPP_INCLUDED

#include <pw85/contact/condition.hpp>
#include <pw85/contact/contact.hpp>

namespace pw85 {

/// The least contact function on a straight path, and the time at which it is reached.
template <class T> struct ClosestPassage {
    T mu2;
    T time; ///< in [0, t_max]
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// A pair in range, and a velocity and an end of the time in units in which the velocity is of
/// order one.
template <class T> struct StraightPath {
    Pair<T, 3> pair;
    Vector<T, 3> velocity;
    T end;
};

/// Rows of the projection P along v to the plane across v. With the largest coordinate v_k they are
/// v_j e_k - v_k e_j for the other j. They are orthogonal to v without rounding.
template <class T> struct Projection {
    Vector<T, 3> rows[2];
};

template <class T>
PW85_FUNCTION inline Projection<T> projection_along(Vector<T, 3> const &v) noexcept
{
    int largest = 0;
    for (int i = 1; i < 3; ++i)
        if (absolute(v[i]) > absolute(v[largest])) largest = i;
    Projection<T> projection{};
    for (int i = 0; i < 2; ++i) {
        int const other = (largest + 1 + i) % 3;
        projection.rows[i][largest] = v[other];
        projection.rows[i][other] = -v[largest];
    }
    return projection;
}

/// PQPᵀ.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 2>
project(Projection<T> const &p, SymmetricMatrix<T, 3> const &q) noexcept
{
    auto const first = product(q, p.rows[0]), second = product(q, p.rows[1]);
    return {dot(p.rows[0], first), dot(p.rows[0], second), dot(p.rows[1], second)};
}

/// The pair of the projections of the ellipsoids along v, in two dimensions. On the whole line the
/// least μ² of the ellipsoids is the contact function of this pair, and has the same λ, because the
/// least (r + t v)ᵀW(r + t v) is (Pr)ᵀ[(1-λ) PQ1Pᵀ + λ PQ2Pᵀ]⁻¹ Pr.
template <class T> PW85_FUNCTION inline Pair<T, 2> projected_pair(Pair<T, 3> const &pair,
                                                                  Vector<T, 3> const &v) noexcept
{
    auto const p = projection_along(v);
    return {{dot(p.rows[0], pair.r12), dot(p.rows[1], pair.r12)},
            project(p, pair.q1),
            project(p, pair.q2),
            pair.ratio};
}

/// The pair at time t.
template <class T>
PW85_FUNCTION inline Pair<T, 3> pair_at(StraightPath<T> const &path, T const &t) noexcept
{
    return {add_scaled(path.pair.r12, t, path.velocity), path.pair.q1, path.pair.q2,
            path.pair.ratio};
}

/// τ of a maximum in the units of a Pair: M = Q1 + τQ2.
template <class Maximum, class T>
PW85_FUNCTION inline T weight_of(Maximum const &m, T const &ratio) noexcept
{
    return m.lambda / ratio / m.complement / ratio;
}

/// The t on the whole line with the least f at τ: -rᵀWv/vᵀWv. A correction removes the error that a
/// large r causes.
template <class T>
PW85_FUNCTION inline T best_time(StraightPath<T> const &path, T const &tau) noexcept
{
    auto const &[r12, q1, q2, ratio] = path.pair;
    auto const wv = solve_blend(T(1), q1, tau, q2, path.velocity);
    T const norm = dot(path.velocity, wv), t = -dot(r12, wv) / norm;
    return t - dot(pair_at(path, t).r12, wv) / norm;
}

template <class T> PW85_FUNCTION inline T in_range(StraightPath<T> const &path, T const &t) noexcept
{
    return minimum(maximum(t, T(0)), path.end);
}

/// The time by the projections, or 0 if rounding errors are too large.
template <class T> PW85_FUNCTION inline T time_by_projection(StraightPath<T> const &path) noexcept
{
    auto const m = maximize(projected_pair(path.pair, path.velocity));
    return m.converged ? in_range(path, best_time(path, weight_of(m, path.pair.ratio))) : T(0);
}

/// The largest f of a pair with r12 != 0, by the factorised form.
template <class T, int D>
PW85_FUNCTION inline StationaryValue<T> largest_f(Pair<T, D> const &pair) noexcept
{
    Candidate<T> candidate{initial_guess(pair), T(1), T(0)};
    int evaluations = 0;
    search(pair, candidate, Precision::working, evaluations);
    return last_factorized_evaluation(pair, candidate, Precision::working).value;
}

/// closest_passage() with wider numbers: from the projections if the minimum is inside the range,
/// otherwise from the pair at an end of the range. If the path goes through the centre, the
/// separation of the projections is exactly 0.
template <class T>
PW85_RARE ClosestPassage<T> find_closest_passage_wider(StraightPath<T> const &path) noexcept
{
    using W = Widened<T>;
    StraightPath<W> const wide{widened<W>(path.pair), converted<W>(path.velocity),
                               W(minimum(path.end, largest_number<T>()))};
    auto const pair = projected_pair(wide.pair, wide.velocity);
    bool const central = largest_coordinate(pair.r12) == W(T(0));
    auto const f =
        central ? StationaryValue<W>{W(T(0)), W(T(0.5)), W(T(0.5)), W(T(0))} : largest_f(pair);
    W const best = best_time(wide, weight_of(f, pair.ratio)), t = in_range(wide, best);
    if (t == best) return {rounded(f.mu2), rounded(t), StatusCode::success};
    auto const end = pair_at(wide, t);
    W const mu2 = largest_coordinate(end.r12) == W(T(0)) ? W(T(0)) : largest_f(end).mu2;
    return {rounded(mu2), rounded(t), StatusCode::success};
}

PW85_RARE_TIER_OF(find_closest_passage_wider, double)

/// μ² at one time, and the time that follows from its λ.
template <class T> struct PassageStep {
    T mu2, next;
    /// true if the bounds of step_at() agree to rounding, or if the time is an end of the range
    bool best;
};

/// Returns whether the rounding of t, of t v and of r + t v is harmless at t. It changes a
/// coordinate of the separation by δ_i <= u x_i with x_i = |r_i| + 2t |v_i|. To first order in δ,
/// μ² changes by less than 2 u S. The term of second order is λ(1-λ) δᵀM⁻¹δ, where δᵀM⁻¹δ <= 3 u² Σ
/// x_i² (M⁻¹)_ii. It must be less than u S/64. Then S, which is computed at the rounded separation,
/// is correct.
template <class T>
PW85_FUNCTION inline bool is_rounding_harmless(StraightPath<T> const &path, T const &t,
                                               Factorization<T, 3> const &factors,
                                               T const &sum) noexcept
{
    T second = T(0);
    for (int i = 0; i < 3; ++i) {
        Vector<T, 3> unit{};
        unit[i] = absolute(path.pair.r12[i]) + T(T(2) * t) * absolute(path.velocity[i]);
        second = second + inverse_form(factors, unit);
    }
    return t == T(0) || T(T(192 * unit_roundoff<T>()) * second) <= sum;
}

/// Computes the step at t. For any λ and t, let n = W(r + t v). The least value of f at this λ is
/// f(λ, t) - λ(1-λ)(v·n)²/(vᵀWv), and is reached at the time t - v·n/(vᵀWv). It is a lower bound on
/// the result, and μ² at t is an upper bound. If λ is the maximiser at t, the bounds differ by the
/// second term. With S, the sum of condition_sum() and the terms of r and of t v, they agree if
/// they differ by u S.
template <class T>
PW85_FUNCTION inline PassageStep<T> step_at(StraightPath<T> const &path, T const &t) noexcept
{
    auto const pair = pair_at(path, t);
    auto const m = largest_coordinate(pair.r12) > T(0) ? maximize(pair) : Maximum<T>{};
    if (!m.converged) return {quiet_nan<T>(), t, false};
    T const tau = weight_of(m, pair.ratio), u = T(unit_roundoff<T>());
    auto const n = solve_blend(T(1), pair.q1, tau, pair.q2, pair.r12);
    auto const wv = solve_blend(T(1), pair.q1, tau, pair.q2, path.velocity);
    T const along = dot(pair.r12, wv), delay = -along / dot(path.velocity, wv);
    T const sum = condition_sum(pair, tau, n) + T(T(4) * t) * magnitude_of_dot(path.velocity, n);
    bool const at_end = (t == T(0) && along >= T(0)) || (t == path.end && along <= T(0));
    bool const best = at_end || T(-along * delay) <= u * sum;
    return {m.mu2, in_range(path, T(t + delay)),
            best &&
                is_rounding_harmless(path, t, factorize_blend(T(1), pair.q1, tau, pair.q2), sum)};
}

/// Maximum number of alternating steps in t and λ before wider numbers are used.
inline constexpr int max_passage_steps = 3;

/// closest_passage() in the units of a StraightPath, with v != 0 and r12 != 0. Types without wider
/// numbers use their own.
///
/// The projections give λ and t, and the pair at t gives μ². If the bounds differ by more than
/// rounding errors, the function improves t from λ and λ from t in turn. If they still differ, or
/// if r + t v cancels so much that its rounding matters, the projections are computed with wider
/// numbers.
///
/// The error of μ² is 4 u S for the contact function at t, 2 u S for the rounding of r + t v, u S
/// for the difference of the bounds, and u S/64 for the terms of second order: less than 8 u S in
/// all.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline ClosestPassage<T>
find_closest_passage(StraightPath<T> const &path) noexcept
{
    T t = time_by_projection(path);
    for (int i = 0; i < max_passage_steps; ++i) {
        auto const step = step_at(path, t);
        if (step.best) return {step.mu2, t, StatusCode::success};
        t = step.next;
    }
    return find_closest_passage_wider(path);
}

/// closest_passage() for a valid pair that moves.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline ClosestPassage<T>
pass_scaled(ScaledPair<T, 3> const &scaled, Vector<T, 3> const &velocity, T const &t_max) noexcept
{
    auto const &[pair, units] = scaled;
    Unit const speed = unit_of(velocity), time = units.length / speed;
    StraightPath<T> const path{pair, units.reordered(speed.to_local(velocity)),
                               time.to_local(t_max)};
    auto passage = find_closest_passage(path);
    passage.mu2 = units.mu().to_caller(passage.mu2, 2);
    passage.time = passage.time == path.end ? t_max : minimum(time.to_caller(passage.time), t_max);
    return passage;
}

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline ClosestPassage<T>
closest_passage(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                SymmetricMatrix<T, 3> const &q2, Vector<T, 3> const &velocity,
                T const &t_max) noexcept
{
    using namespace detail;
    auto const pair = pair_of(r12, q1, q2);
    ScaledPair<T, 3> scaled{pair, {}};
    bool const valid = is_finite(velocity) && t_max >= T(0);
    StatusCode const status = !valid                     ? StatusCode::invalid_argument
                              : passes_fast_checks(pair) ? StatusCode::success
                                                         : validate_pair(pair, scaled);
    if (status != StatusCode::success) return all_nan<ClosestPassage<T>>(status);
    if (largest_coordinate(r12) == T(0)) return {T(0), T(0), StatusCode::success};
    if (largest_coordinate(velocity) > T(0)) return pass_scaled(scaled, velocity, t_max);
    auto const c = contact(r12, q1, q2);
    if (c.status != StatusCode::success) return all_nan<ClosestPassage<T>>(c.status);
    return {c.mu2, T(0), StatusCode::success};
}

} // namespace pw85

#endif
