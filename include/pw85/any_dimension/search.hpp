// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the maximum of f in n dimensions, by factorisation of Q1 + t Q2. The steps, the
/// bracket and the last evaluation are those of two and three dimensions (contact/iteration.hpp,
/// contact/safeguarded_search.hpp): they are formulas in A, B and their derivatives, whatever the
/// dimension. contact.hpp calls maximize().
#ifndef PW85_ANY_DIMENSION_SEARCH_HPP_INCLUDED
#define PW85_ANY_DIMENSION_SEARCH_HPP_INCLUDED

#include <pw85/any_dimension/pair.hpp>
#include <pw85/contact/factorized_search.hpp>

namespace pw85::detail::any_dimension {

/// An evaluation at t: the factors of M = Q1 + t Q2, s = M⁻¹ r12, Q1 s and Q2 s, and M⁻¹ Q2 s.
template <class T, class N = int> struct Evaluation {
    T factors[packed_size(capacity<N>)];
    T s[capacity<N>], p[capacity<N>], q[capacity<N>], v[capacity<N>];
    T a, b; ///< sᵀQ1s and sᵀQ2s
};

/// sᵀQs from Qs, raised to at least its rounding error to make it positive.
template <class T, class N>
PW85_FUNCTION inline T positive_form(N n, T const *q, T const *s, T const *qs) noexcept
{
    return maximum(dot(n, s, qs), T(T(unit_roundoff<T>()) * diagonal_form(n, q, s)));
}

/// Evaluates the factors, s, Q2 s and B. Returns false if rounding errors make a pivot negative.
template <class T, class N> [[gnu::noinline]] PW85_FUNCTION inline bool
solve_at(Pair<T, N> const &pair, T const &t, Evaluation<T, N> &at) noexcept
{
    N const n = pair.n;
    int const size = packed_size(n);
    for (int k = 0; k < size; ++k) at.factors[k] = pair.q1[k] + t * pair.q2[k];
    if (!factorize(n, at.factors)) return false;
    solve(n, at.factors, pair.r12, at.s);
    product(n, pair.q2, at.s, at.q);
    at.b = positive_form(n, pair.q2, at.s, at.q);
    return true;
}

/// Computes Q1 s and A.
template <class T, class N>
PW85_FUNCTION inline void apply_first(Pair<T, N> const &pair, Evaluation<T, N> &at) noexcept
{
    product(pair.n, pair.q1, at.s, at.p);
    at.a = positive_form(pair.n, pair.q1, at.s, at.p);
}

/// Evaluates all but v. Returns false if rounding errors make a pivot negative.
template <class T, class N> PW85_FUNCTION inline bool evaluate(Pair<T, N> const &pair, T const &t,
                                                               Evaluation<T, N> &at) noexcept
{
    if (!solve_at(pair, t, at)) return false;
    apply_first(pair, at);
    return true;
}

/// Returns whether A = s·r12 - t B loses at most ten binary digits. Then sᵀQ1v = B - t sᵀQ2v adds
/// an error of the same size to h', in which it is multiplied by t/A.
template <class T, class N>
PW85_FUNCTION inline bool spares_first(T const &t, Evaluation<T, N> const &at) noexcept
{
    return T(0x1p10) * at.a > t * at.b;
}

/// Evaluates for a step of the search: A is the difference of s·r12 and t B if this is accurate,
/// and Q1 s is not computed then.
template <class T, class N> PW85_FUNCTION inline bool
evaluate_step(Pair<T, N> const &pair, T const &t, Evaluation<T, N> &at) noexcept
{
    if (!solve_at(pair, t, at)) return false;
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): solve_at() wrote b
    at.a = dot(pair.n, pair.r12, at.s) - t * at.b;
    if (!spares_first(t, at)) apply_first(pair, at);
    return true;
}

/// A, B and their derivatives divided by A: contact/evaluation.hpp, item 2. As vᵀMv = vᵀQ2s, one
/// quadratic form gives both second derivatives.
template <class T, class N> PW85_FUNCTION inline Jet<T> jet_of(Pair<T, N> const &pair, T const &t,
                                                               Evaluation<T, N> &at) noexcept
{
    N const n = pair.n;
    solve(n, at.factors, at.q, at.v);
    T const qv = dot(n, at.q, at.v), second = quadratic_form(n, pair.q2, at.v);
    T const pv = spares_first(t, at) ? T(at.b - t * qv) : dot(n, at.p, at.v);
    T const inverse = T(1) / at.a;
    return {T(1),
            T(-2) * (pv * inverse),
            T(6) * (maximum(T(0), T(qv - t * second)) * inverse),
            at.b * inverse,
            T(-2) * (qv * inverse),
            T(6) * (second * inverse),
            T(0)};
}

/// Searches from the candidate until a step is within penultimate_step(): the algorithm of
/// detail::search(). Returns false if the search does not converge.
template <class T, class N>
[[gnu::noinline]] PW85_FUNCTION inline bool search(Pair<T, N> const &pair, Candidate<T> &candidate,
                                                   Evaluation<T, N> &at, int &evaluations) noexcept
{
    auto state = safeguarded_search(candidate.t, free_factorized_steps);
    for (int i = 1;; ++i) {
        ++evaluations;
        if (!evaluate_step(pair, state.t, at)) return false;
        Jet<T> const jet = jet_of(pair, state.t, at);
        Slope<T> const s = slope(jet, pair.ratio, state.t);
        TrustedStep<T> const trusted = trust(halley_step(s), s);
        T const image = fixed_point_image(jet, pair.ratio);
        bool const pinned = is_narrow(state, penultimate_step<T>()); // t is in it
        take_bound(state, image > state.t, image);
        bool const noise =
            trusted.nearby && !halves(state, trusted.size) && state.shortest < T(0.1);
        bool const found = trusted.size <= penultimate_step<T>() || pinned || noise;
        if (found || i >= max_factorized_steps - 1) {
            candidate = end_of_search(state, s, trusted);
            return found && trusted.nearby;
        }
        take_step(state, next_guess(jet, trusted, pair.ratio, state.t, image), trusted.size);
    }
}

/// A bound on the inverse of the smallest eigenvalue of M scaled to a unit diagonal: the sum of
/// M_ii (M⁻¹)_ii, with M⁻¹ = L⁻ᵀ D⁻¹ L⁻¹.
template <class T, class N> PW85_FUNCTION inline T
inverse_bound(Pair<T, N> const &pair, T const &t, Evaluation<T, N> const &at) noexcept
{
    N const n = pair.n;
    T sum = T(0), inverse_pivots[capacity<N>];
    for (int i = 0; i < n; ++i) inverse_pivots[i] = T(1) / at.factors[packed_index(n, i, i)];
    for (int i = 0; i < n; ++i) {
        T column[capacity<N>]; // of L⁻¹
        for (int j = i + 1; j < n; ++j) column[j] = T(0);
        column[i] = T(1);
        T entry = T(0);
        for (int k = i; k < n; ++k) {
            T const *const row = at.factors + row_offset(n, k);
            for (int j = k + 1; j < n; ++j) column[j] = column[j] - row[j] * column[k];
            entry = entry + column[k] * column[k] * inverse_pivots[k];
        }
        int const diagonal = packed_index(n, i, i);
        sum = sum + (pair.q1[diagonal] + t * pair.q2[diagonal]) * entry;
    }
    return sum;
}

/// Returns a bound on the error of s in the norm of M, in units of u κ with κ from inverse_bound():
/// the backward error of factorisation and of both solutions, (3n + 3) u |L| D |Lᵀ| (N. J. Higham,
/// theorem 10.4, with two more roundings by the reciprocals), whose norm is that of
/// factorization_error().
PW85_FUNCTION constexpr int solution_error(int n) noexcept { return n * (3 * n + 4); }

/// The error of h' where sᵀQ1s and sᵀQ2s cancel, as noise_of_slope() of three dimensions: n + 2
/// roundings of product(), and n/4 + 3 of dot(), of sums of magnitudes of at most n
/// diagonal_form().
template <class T, class N>
PW85_FUNCTION inline T noise_of_slope(Pair<T, N> const &pair, Evaluation<T, N> const &at) noexcept
{
    N const n = pair.n;
    T const sum = diagonal_form(n, pair.q1, at.s) / at.a + diagonal_form(n, pair.q2, at.s) / at.b;
    return T(T(n * (2 * n + 6)) * T(unit_roundoff<T>())) * sum;
}

template <class T, class N> [[gnu::noinline]] PW85_FUNCTION inline LastEvaluation<T>
last_evaluation(Pair<T, N> const &pair, Candidate<T> const &candidate,
                Evaluation<T, N> &at) noexcept
{
    if (!evaluate(pair, candidate.t, at)) return {{}, false};
    auto const value =
        stationary_value(candidate, pair.ratio, at.a, at.b, dot(pair.n, pair.r12, at.s));
    T const error = T(solution_error(pair.n)) * inverse_bound(pair, candidate.t, at) *
                    negative_power_of_two<T>(mantissa_digits<T>() - result_digits<T>());
    return {value, candidate.k > noise_of_slope(pair, at) &&
                       is_certified(candidate, value.step, error, T(1))};
}

/// The start of a search.
template <class T, class N>
PW85_FUNCTION inline Candidate<T> start(Pair<T, N> const &pair, Evaluation<T, N> &at) noexcept
{
    N const n = pair.n;
    product(n, pair.q1, pair.r12, at.p);
    product(n, pair.q2, pair.r12, at.q);
    T const form1 = positive_form(n, pair.q1, pair.r12, at.p),
            form2 = positive_form(n, pair.q2, pair.r12, at.q);
    return {initial_guess(form1, form2, pair.ratio), T(1), T(0)};
}

/// The maximum of f. It is correct to rounding if `certified` is true.
template <class T, class N>
PW85_FUNCTION inline Maximum<T> maximize(Pair<T, N> const &pair, Evaluation<T, N> &at) noexcept
{
    Candidate<T> candidate = start(pair, at);
    int evaluations = 0;
    if (!search(pair, candidate, at, evaluations))
        return {T(0), T(0), T(0), evaluations, false, false};
    auto const last = last_evaluation(pair, candidate, at);
    return {last.value.mu2, last.value.lambda, last.value.complement, evaluations + 1,
            true,           last.certified};
}

} // namespace pw85::detail::any_dimension

#endif
