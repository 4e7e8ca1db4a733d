// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search in n dimensions for κ, the factor by which ellipsoid 1 must be scaled to contain
/// ellipsoid 2. The bounds and the search are those of overlap/containment_bounds.hpp and
/// overlap/containment_factor.hpp, with M = Q1 + t Q2, t = -1/ν, of search.hpp.
///
/// With s = M⁻¹r12, any direction s gives a lower bound on κ², and any ν at which M is positive
/// definite an upper bound. Rounding errors of forms are those of product() and dot(): 5n/4 + 9
/// operations on a term.
#ifndef PW85_ANY_DIMENSION_CONTAINMENT_SEARCH_HPP_INCLUDED
#define PW85_ANY_DIMENSION_CONTAINMENT_SEARCH_HPP_INCLUDED

#include <pw85/any_dimension/overlap.hpp>
#include <pw85/overlap/containment_factor.hpp>

namespace pw85::detail::any_dimension {

/// κ² from below by a direction s with s·r12 >= 0.
template <class T> struct SupportRatio {
    T s[max_dimension], q2s[max_dimension];
    T mu2;                 ///< 0 if s is not a direction
    T form1, root2, along; ///< sᵀQ1s, √(sᵀQ2s) and s·r12
    T nu;                  ///< the ν that belongs to s: κ √(sᵀQ2s)/√(sᵀQ1s)
};

/// The state of the search for κ: see DualBoundSearch of overlap/containment_factor.hpp.
template <class T> struct DualBoundSearch {
    T lower, upper; ///< of ν
    T bound, nu;    ///< κ² from above, and the ν that gives it
    T width;
    SupportRatio<T> best;
};

/// Computes the support ratio of a direction s.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline void
support_ratio(Pair<T> const &pair, T const *s, SupportRatio<T> &reach) noexcept
{
    int const n = pair.n;
    T q1s[max_dimension]{};
    product(n, pair.q1, s, q1s);
    product(n, pair.q2, s, reach.q2s);
    T const along = dot(n, s, pair.r12), form1 = dot(n, s, q1s), form2 = dot(n, s, reach.q2s);
    T const sign = along < T(0) ? T(-1) : T(1);
    for (int i = 0; i < n; ++i) {
        reach.s[i] = sign * s[i];
        reach.q2s[i] = sign * reach.q2s[i];
    }
    bool const valid = form1 > T(0) && form2 > T(0) && form1 < largest_number<T>();
    reach.form1 = form1;
    reach.along = sign * along;
    reach.root2 = valid ? square_root(form2) : T(0);
    T const sum = reach.root2 + reach.along;
    reach.mu2 = valid ? T(sum * sum / form1) : T(0);
    reach.nu = valid ? T(sum * reach.root2 / form1) : T(0);
}

template <class T> PW85_FUNCTION inline void keep_better(DualBoundSearch<T> &search,
                                                         SupportRatio<T> const &reach) noexcept
{
    if (reach.mu2 > search.best.mu2) search.best = reach;
}

/// Computes near_null_vector() in n dimensions, from the factors of M.
template <class T> PW85_FUNCTION inline void
find_null_vector(Pair<T> const &pair, Evaluation<T> const &at, T *z) noexcept
{
    int const n = pair.n;
    auto const pivot = [&](int i) { return at.factors[packed_index(n, i, i)]; };
    auto const weight = [&](int i) { return pair.q2[packed_index(n, i, i)]; };
    int smallest = 0;
    for (int i = 1; i < n; ++i)
        if (pivot(i) * weight(smallest) < pivot(smallest) * weight(i)) smallest = i;
    T y[max_dimension]{};
    y[smallest] = T(1);
    for (int pass = 0; pass < 2; ++pass) {
        if (pass > 0) product(n, pair.q2, z, y);
        solve(n, at.factors, y, z);
        T largest = T(0);
        for (int i = 0; i < n; ++i) largest = maximum(largest, absolute(z[i]));
        for (int i = 0; i < n; ++i) z[i] = z[i] / largest;
    }
}

/// Tries the two vectors s + αz with sᵀQ2s = ν²: reach_beyond() in n dimensions.
template <class T> PW85_FUNCTION inline void try_beyond(Pair<T> const &pair,
                                                        Evaluation<T> const &at, T const &nu,
                                                        DualBoundSearch<T> &search) noexcept
{
    int const n = pair.n;
    T z[max_dimension]{}, q2z[max_dimension]{};
    find_null_vector(pair, at, z);
    product(n, pair.q2, z, q2z);
    T const a = dot(n, z, q2z), b = dot(n, at.s, q2z), c = dot(n, at.s, at.q) - nu * nu;
    T const discriminant = b * b - a * c;
    if (!(discriminant >= T(0) && a > T(0))) return;
    T const root = square_root(discriminant), sum = b < T(0) ? T(b - root) : T(b + root);
    for (T const &alpha : {T(-(c / sum)), T(-(sum / a))}) {
        SupportRatio<T> reach;
        for (int i = 0; i < n; ++i) q2z[i] = at.s[i] + alpha * z[i];
        support_ratio(pair, q2z, reach);
        keep_better(search, reach);
    }
}

/// Returns ρᵀM⁻¹ρ for the residual of s. Overwrites v.
template <class T>
PW85_FUNCTION inline T residual_form(Pair<T> const &pair, T const &t, Evaluation<T> &at) noexcept
{
    T rest[max_dimension]{};
    for (int i = 0; i < pair.n; ++i) rest[i] = pair.r12[i] - at.p[i] - t * at.q[i];
    solve(pair.n, at.factors, rest, at.v);
    return dot(pair.n, rest, at.v);
}

/// Evaluates at ν, and returns the ν that Newton's method suggests (take_dual_step() of
/// overlap/containment_bounds.hpp). M must be positive definite in spite of rounding: its factors
/// err by at most n (n + 8) u of its diagonal (factorization_error()).
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline T evaluate_dual(Pair<T> const &pair,
                                                       DualBoundSearch<T> &search, T const &nu,
                                                       Evaluation<T> &at) noexcept
{
    int const n = pair.n;
    T const t = T(-1) / nu, error = T(4 * factorization_error(n)) * T(unit_roundoff<T>());
    if (!evaluate(pair, t, at) || !(error * inverse_bound(pair, t, at) < T(1))) {
        search.lower = nu;
        return nu;
    }
    T const q = dot(n, at.s, at.q), e = square_root(maximum(q, T(0))) / nu;
    T const form = dot(n, at.s, at.p) + t * q;
    T const upper = nu + (T(2) * dot(n, pair.r12, at.s) - form) + residual_form(pair, t, at);
    if (upper < search.bound) search.bound = upper, search.nu = nu;
    SupportRatio<T> reach;
    support_ratio(pair, at.s, reach);
    keep_better(search, reach);
    if (e < T(1)) try_beyond(pair, at, nu, search);
    (e > T(1) ? search.lower : search.upper) = nu;
    solve(n, at.factors, at.q, at.v);
    T const c = q > T(0) ? T(dot(n, at.q, at.v) / q) : T(0);
    return nu + nu * (e - T(1)) / (T(1) + c / nu);
}

/// Returns ratio_condition_sum() in n dimensions.
template <class T>
PW85_FUNCTION inline T condition_sum(Pair<T> const &pair, SupportRatio<T> const &reach) noexcept
{
    int const n = pair.n;
    T form1 = T(0), form2 = T(0), along = T(0);
    for (int i = 0; i < n; ++i) {
        along = along + absolute(T(pair.r12[i] * reach.s[i]));
        for (int j = 0; j < n; ++j) {
            int const k = packed_index(n, i, j);
            T const product = absolute(T(reach.s[i] * reach.s[j]));
            form1 = form1 + absolute(pair.q1[k]) * product;
            form2 = form2 + absolute(pair.q2[k]) * product;
        }
    }
    T const factor = square_root(T(reach.mu2 / reach.form1));
    return reach.mu2 * (form1 / reach.form1) + factor * (form2 / reach.root2 + T(2) * along);
}

/// Returns whether the bounds of κ² agree. S is at least 2κ². At a direction far from the best one,
/// S can be much larger than at the result. So in double S is used only if the bounds agree to half
/// of the digits. Otherwise, and for wider numbers, which have digits to spare, the test uses κ²
/// instead of S.
template <class T> PW85_FUNCTION inline bool
has_converged(Pair<T> const &pair, DualBoundSearch<T> const &search, T const &tolerance) noexcept
{
    // An upper bound far below the lower one is a rounding error: terms cancel if M is nearly
    // singular.
    T const mu2 = search.best.mu2, gap = absolute(T(search.bound - mu2));
    if (!(mu2 > T(0))) return false;
    if (gap <= tolerance * mu2) return true;
    if constexpr (std::is_same_v<T, double>)
        return gap <= 0x1p-26 * mu2 && gap <= tolerance * condition_sum(pair, search.best);
    return false;
}

/// The goal of a search for κ²: its value, or only the sign of κ² - 1.
enum class Goal { value, side_of_one };

/// Returns whether a search is done: its bounds agree, or, for the goal side_of_one, κ² is far from
/// 1.
template <class T> PW85_FUNCTION inline bool is_done(Pair<T> const &pair,
                                                     DualBoundSearch<T> const &search, Goal goal,
                                                     T const &tolerance) noexcept
{
    T const margin = T(0x1p-20);
    return (goal == Goal::side_of_one &&
            (search.bound < T(1) - margin || search.best.mu2 > T(1) + margin)) ||
           has_converged(pair, search, tolerance);
}

/// Returns initial_nu() in n dimensions.
template <class T>
PW85_FUNCTION inline T initial_nu(Pair<T> const &pair, Evaluation<T> &at) noexcept
{
    int const n = pair.n;
    if (!evaluate(pair, T(0), at)) return T(1);
    T sum = T(0);
    for (int i = 0; i < n; ++i) {
        T column[max_dimension]{};
        for (int j = 0; j < n; ++j) column[j] = pair.q2[packed_index(n, i, j)];
        solve(n, at.factors, column, at.v);
        // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): solve() wrote it
        sum = sum + at.v[i];
    }
    SupportRatio<T> reach;
    support_ratio(pair, at.s, reach);
    T const ball = reach.mu2 > T(0)
                       ? T(square_root(reach.mu2) * (reach.root2 / square_root(reach.form1)))
                       : T(0);
    return maximum(sum, ball);
}

/// Searches until is_done(), as search_dual() of overlap/containment_factor.hpp does. Returns false
/// if the search ends otherwise.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline bool
minimize_dual(Pair<T> const &pair, DualBoundSearch<T> &search, Evaluation<T> &at, Goal goal,
              T const &tolerance) noexcept
{
    T const largest = largest_number<T>();
    search.lower = T(0);
    for (int i = 0; i < pair.n; ++i) {
        int const k = packed_index(pair.n, i, i);
        search.lower = maximum(search.lower, T(T(0.5) * (pair.q2[k] / pair.q1[k])));
    }
    search.upper = search.bound = search.nu = search.width = largest;
    search.best.mu2 = search.best.nu = T(0);
    T nu = initial_nu(pair, at);
    for (int step = 0; step < max_dual_steps<T>(); ++step) {
        T next = evaluate_dual(pair, search, nu, at);
        if (is_done(pair, search, goal, tolerance)) return true;
        if (!(next > search.lower && next < search.upper)) next = next_in_bracket(search);
        if (!(next > search.lower && next < search.upper)) return false;
        nu = next;
    }
    return false;
}

} // namespace pw85::detail::any_dimension

#endif
