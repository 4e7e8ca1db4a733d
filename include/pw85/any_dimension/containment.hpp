// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Containment in n dimensions: the exact test whether ellipsoid 2 is inside ellipsoid 1, and the
/// factor κ by which ellipsoid 1 must be scaled to contain ellipsoid 2. containment_search.hpp has
/// the search for κ.
#ifndef PW85_ANY_DIMENSION_CONTAINMENT_HPP_INCLUDED
#define PW85_ANY_DIMENSION_CONTAINMENT_HPP_INCLUDED

#include <pw85/any_dimension/containment_search.hpp>
#include <pw85/any_dimension/exact_containment.hpp>
#include <pw85/any_dimension/overlap.hpp>

namespace pw85 {

/// The answer of nd_contains(). It is meaningless if the status is not success.
struct NdContainment {
    bool contains;
    StatusCode status;
};

/// The factor of nd_containment().
struct NdContainmentScale {
    double mu2; ///< square of the factor of ellipsoid 1, about its centre
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail::any_dimension {

/// Returns whether a direction proves that ellipsoid 2 is not inside: √(sᵀQ2s) + |s·r12| >
/// √(sᵀQ1s), with the errors of form_above(). s is scaled to a length of about one, so errors by
/// underflow are far below these errors.
template <class T>
PW85_FUNCTION inline bool shows_outside(Pair<T> const &pair, T const *direction) noexcept
{
    int const n = pair.n;
    T const w = operation_error<T>();
    T s[max_dimension]{}, qs[max_dimension]{}, largest = T(0), magnitude = T(0);
    for (int i = 0; i < n; ++i) largest = maximum(largest, absolute(direction[i]));
    for (int i = 0; i < n; ++i) {
        s[i] = direction[i] / largest;
        magnitude = magnitude + absolute(T(pair.r12[i] * s[i]));
    }
    product(n, pair.q1, s, qs);
    T const first = square_root(form_above(n, pair.q1, s, qs));
    product(n, pair.q2, s, qs);
    T const second = dot(n, s, qs) - T(n * (3 * n + 12)) * w * diagonal_form(n, pair.q2, s);
    T const along = absolute(dot(n, s, pair.r12)) - T(n + 8) * w * magnitude;
    T const sum = square_root(maximum(second, T(0))) + maximum(along, T(0));
    return sum > first * (T(1) + T(16) * w); // false for a direction that is not finite
}

/// Returns whether ν, 2⁻¹⁰⁰ <= ν < 1, proves that ellipsoid 2 is inside: K(ν) of
/// exact_containment.hpp is positive definite.
///
/// Let w be the error of an operation, 4u. As K has a positive diagonal if its pivots are positive,
/// the magnitudes of the terms Q2/ν + r rᵀ/(1 - ν) of entry (i, j) add up to at most √(Q1_ii
/// Q1_jj). An entry errs by less than 12 w √(Q1_ii Q1_jj) from 5 operations on the terms and two on
/// the entry, and a matrix of such errors by 12 n w = 48 n u of diag(Q1). The factorisation errs by
/// at most n (n + 8) u of the diagonal of K (factorization_error()), which is below that of Q1.
/// `share` times diag(Q1) exceeds the sum of both errors. Numbers that underflow have an error of
/// 2⁻¹⁰⁷⁴, which is far below `share` times the diagonal of Q1, because this diagonal is at least
/// 2⁻⁸⁰⁰.
template <class T>
PW85_FUNCTION inline bool shows_inside(Pair<T> const &pair, T const &nu, T *memory) noexcept
{
    int const n = pair.n;
    if (!(nu >= T(0x1p-100) && nu < T(1))) return false;
    T const share = T(4 * factorization_error(n) + 64 * n) * T(unit_roundoff<T>());
    T const shrink = T(1) - share, factor2 = T(1) / nu, factor_r = T(1) / (T(1) - nu);
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j) {
            int const k = packed_index(n, i, j);
            T const q1 = i == j ? T(shrink * pair.q1[k]) : pair.q1[k];
            memory[k] = q1 - (factor2 * pair.q2[k] + factor_r * pair.r12[i] * pair.r12[j]);
        }
    return factorize(n, memory);
}

/// Decides by numbers of type T. The search stops when κ² is clearly below or above one.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline ContainmentDecision
decide_containment_in(Input const &in, Unit unit, Workspace<T> &work) noexcept
{
    auto &pair = work.pair;
    auto &at = work.at;
    scale(in, {unit, unit, unit, false, {}}, pair);
    for (int i = 0; i < in.n; ++i) {
        T axis[max_dimension]{};
        axis[i] = T(1);
        if (shows_outside(pair, axis)) return ContainmentDecision::outside;
    }
    if (shows_inside(pair, T(0.5), at.factors)) return ContainmentDecision::inside;
    DualBoundSearch<T> search;
    minimize_dual(pair, search, at, Goal::side_of_one, T(T(4) * T(unit_roundoff<T>())));
    if (search.best.mu2 > T(1) && shows_outside(pair, search.best.s))
        return ContainmentDecision::outside;
    T const nu = search.nu + T(0.5) * (T(1) - search.bound); // g increases by less than ν does
    return shows_inside(pair, nu, at.factors) ? ContainmentDecision::inside
                                              : ContainmentDecision::none;
}

/// Returns whether ellipsoid 2 is inside, for a valid pair: 1 or 0, or sign_unknown.
PW85_FUNCTION inline int decide_containment(Input const &in) noexcept
{
    Unit const unit{half_exponent(largest_diagonal(in.n, in.q1))};
    auto decision = ContainmentDecision::none;
    if (keeps_digits(in.n, in.q1, unit)) {
        auto const decide = [&](auto &work) { return decide_containment_in(in, unit, work); };
        decision = with_workspace(decide);
        if constexpr (FLT_EVAL_METHOD == 0)
            if (decision == ContainmentDecision::none) decision = with_wide_workspace(decide);
    }
    if (decision == ContainmentDecision::none) return contains_exactly(in);
    return decision == ContainmentDecision::inside;
}

/// Scales a pair: scale_contained() in n dimensions.
PW85_FUNCTION inline Units scale_for_reach(Input const &in, Pair<double> &pair) noexcept
{
    int const n = in.n, size = packed_size(n);
    Unit const first{half_exponent(largest_diagonal(n, in.q1))},
        second{half_exponent(largest_diagonal(n, in.q2))},
        length = larger_unit(second, largest_magnitude(n, in.r12), {});
    pair.n = n;
    to_local(length, 1, n, in.r12, pair.r12);
    to_local(first, 2, size, in.q1, pair.q1);
    to_local(smaller_of(length, second / Unit{-384}), 2, size, in.q2, pair.q2);
    return {length, first, second, false, {}};
}

/// Memory of a search for κ.
template <class T> struct ReachWorkspace {
    Workspace<T> work;
    DualBoundSearch<T> search;
};

/// Searches until the bounds on κ² of the pair differ by at most tolerance S, with S of
/// condition_sum(). Returns whether they do.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline bool find_dual(ReachWorkspace<T> &memory,
                                                                         double tolerance) noexcept
{
    auto &work = memory.work;
    return minimize_dual(work.pair, memory.search, work.at, Goal::value, T(tolerance));
}

/// Computes κ² and the point in the units of the pair, by numbers of type T. Returns false if the
/// bounds on κ² differ by more than tolerance S, with S of condition_sum().
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline bool find_scale(Pair<double> const &given, double tolerance,
                                                       double &mu2, double *point,
                                                       ReachWorkspace<T> &memory) noexcept
{
    auto &pair = memory.work.pair;
    int const n = given.n;
    pair.n = n;
    to_local({}, 1, n, given.r12, pair.r12);
    to_local({}, 2, packed_size(n), given.q1, pair.q1);
    to_local({}, 2, packed_size(n), given.q2, pair.q2);
    memory.search.best.mu2 = T(0); // analysers do not follow the search, which sets it
    bool const converged = find_dual(memory, tolerance);
    auto const &best = memory.search.best;
    mu2 = rounded(best.mu2);
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): set by the search, too
    for (int i = 0; i < n; ++i) point[i] = rounded(T(pair.r12[i] + best.q2s[i] / best.root2));
    return converged;
}

/// Searches with numbers of twice, and then of seven times, the digits.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline StatusCode
find_scale_wider(Pair<double> const &pair, double &mu2, double *point) noexcept
{
    constexpr double u = unit_roundoff<double>();
    if constexpr (FLT_EVAL_METHOD == 0) {
        ReachWorkspace<Doubled<double>> memory;
        if (find_scale(pair, u, mu2, point, memory)) return StatusCode::success;
    }
    using Memory = ReachWorkspace<exact::Extended<double>>;
    auto *const memory = static_cast<Memory *>(std::malloc(sizeof(Memory)));
    if (memory == nullptr) return StatusCode::out_of_memory;
    bool const converged = find_scale(pair, u, mu2, point, *memory);
    std::free(memory);
    return converged ? StatusCode::success : StatusCode::no_convergence;
}

/// Searches with double precision first. The rounding errors are (5n/4 + 12) u S for each of the
/// two bounds, and 3 u S for M. Together with the tolerance, the error of the result is below (2n +
/// 20) u S.
PW85_FUNCTION inline StatusCode find_scale(Pair<double> const &pair, double &mu2,
                                           double *point) noexcept
{
    ReachWorkspace<double> memory;
    if (find_scale(pair, 4.0 * unit_roundoff<double>(), mu2, point, memory))
        return StatusCode::success;
    return find_scale_wider(pair, mu2, point);
}

} // namespace pw85::detail::any_dimension

namespace pw85 {

/// Decides exactly if ellipsoid 2 is inside ellipsoid 1 in n dimensions; see nd_contact(). An
/// ellipsoid 2 that touches the surface from inside counts as inside.
PW85_FUNCTION inline NdContainment nd_contains(int n, double const *r12, double const *q1,
                                               double const *q2) noexcept
{
    using namespace detail::any_dimension;
    Input const in{n, r12, q1, q2};
    StatusCode const status = status_of(in);
    if (status != StatusCode::success) return {false, status};
    int const answer = decide_containment(in);
    return answer == sign_unknown ? NdContainment{false, StatusCode::out_of_memory}
                                  : NdContainment{answer == 1, status};
}

/// Computes the square of the factor by which ellipsoid 1 must be scaled to contain ellipsoid 2 in
/// n dimensions, and a point at which the two then touch, on the surface of ellipsoid 2. `point`
/// has n coordinates relative to centre 1, or is null. It is not written if the status is not
/// success.
PW85_FUNCTION inline NdContainmentScale nd_containment(int n, double const *r12, double const *q1,
                                                       double const *q2, double *point) noexcept
{
    using namespace detail;
    using namespace detail::any_dimension;
    Input const in{n, r12, q1, q2};
    StatusCode status = any_dimension::status_of(in);
    if (status != StatusCode::success) return {quiet_nan<double>(), status};
    any_dimension::Pair<double> pair;
    auto const units = scale_for_reach(in, pair);
    double mu2 = quiet_nan<double>(), at[max_dimension]{};
    bool const in_range = keeps_digits(n, q1, units.first) && keeps_digits(n, q2, units.second);
    status = in_range ? find_scale(pair, mu2, at) : StatusCode::no_convergence;
    if (status != StatusCode::success) return {quiet_nan<double>(), status};
    for (int i = 0; point != nullptr && i < n; ++i) point[i] = units.length.to_caller(at[i]);
    return {units.mu().to_caller(mu2, 2), status};
}

} // namespace pw85

#endif
