// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The factor by which ellipsoid 1 must be scaled to contain ellipsoid 2. pw85.hpp and the C API
/// use this file.
///
/// The search keeps the best lower and upper bounds of containment_bounds.hpp. Newton's method
/// finds them (search_dual()). The search stops where they differ by 4 u S, with the S of
/// ratio_condition_sum(). If rounding errors prevent this, wider numbers repeat the search. The
/// lower bound errs by 8 u S + 6 u κ² (see shows_outside() in containment.hpp), where S >= 2 κ². So
/// the result errs by less than 16 u S.
#ifndef PW85_OVERLAP_CONTAINMENT_FACTOR_HPP_INCLUDED
#define PW85_OVERLAP_CONTAINMENT_FACTOR_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/containment_bounds.hpp>

namespace pw85 {

/// Factor by which ellipsoid 1 must be scaled to contain ellipsoid 2.
template <class T, int D> struct ContainmentScale {
    T mu2; ///< square of the factor of ellipsoid 1, about its centre
    /// where they touch then, on ellipsoid 2; relative to the centre of ellipsoid 1
    Vector<T, D> point;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Scales a valid pair: Q1 is of order one, and so is the larger of r12 and Q2, which have one
/// unit. A form Q2 that is much smaller than r12 is enlarged to a fixed small size. Valid forms of
/// type T are not so flat that this changes κ² by more than rounding.
template <class T, int D>
PW85_FUNCTION inline ScaledPair<T, D> scale_contained(Pair<T, D> const &pair) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    constexpr Unit smallest{-std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 8 *
                            3};
    Unit const first = unit_of(q1), second = unit_of(q2),
               length = larger_unit(second, largest_coordinate(r12), {}),
               q2_unit = smaller_of(length, second / smallest);
    return {pair_of(length.to_local(r12), first.to_local(q1), q2_unit.to_local(q2)),
            {length, first, length, false, {}}};
}

/// The state of the search: a bracket of ν, the best SupportRatio, and the least g.
/// SafeguardedSearch is not suitable for two reasons. It accepts only steps that halve, but here
/// every step of Newton's method inside the bracket is good, because these steps increase ν
/// monotonically. And it bisects log ν, but near a minimum at ν1 the ν of the best SupportRatio is
/// a better estimate (next_in_bracket()).
template <class T, int D> struct DualBoundSearch {
    T lower, upper; ///< of ν
    SupportRatio<T, D> best;
    T bound; ///< κ² from above
    T width; ///< of the bracket when next_in_bracket() was last called
};

/// Returns whether the bounds on κ² differ by no more than `tolerance` S.
template <class T, int D>
PW85_FUNCTION inline bool has_converged(Pair<T, D> const &pair, DualBoundSearch<T, D> const &search,
                                        T const &tolerance) noexcept
{
    // An upper bound far below the lower one is a rounding error: terms cancel if M is nearly
    // singular.
    T const mu2 = search.best.mu2, gap = absolute(T(search.bound - mu2));
    return mu2 > T(0) &&
           (gap <= tolerance * mu2 || gap <= T(tolerance * ratio_condition_sum(pair, search.best)));
}

/// Evaluates at ν, and returns the ν that Newton's method suggests. It is not valid if M is not
/// positive definite.
template <class T, int D> PW85_FUNCTION inline T
evaluate_at(Pair<T, D> const &pair, DualBoundSearch<T, D> &search, T const &nu) noexcept
{
    SymmetricMatrix<T, D> m = pair.q1;
    for (int k = 0; k < m.size; ++k) m[k] = m[k] - T(pair.q2[k] / nu);
    auto const factors = factorize(m, T(0));
    if (!exceeds_rounding(m, factors)) {
        search.lower = nu;
        return nu;
    }
    auto const step = take_dual_step(pair, m, factors, nu);
    auto const reach = step.e < T(1)
                           ? reach_beyond(pair, step.n, near_null_vector(pair.q2, factors), nu)
                           : support_ratio(pair, step.n);
    if (reach.mu2 > search.best.mu2) search.best = reach;
    search.bound = minimum(search.bound, step.upper);
    (step.e > T(1) ? search.lower : search.upper) = nu;
    return step.next;
}

/// Maximum number of steps. Bisection of an interval with the ratio 2 to the last digit takes one
/// step for each digit. Between two bisections there may be one step of each other type.
template <class T> PW85_FUNCTION constexpr int max_dual_steps() noexcept
{
    return 3 * mantissa_digits<T>() + 40;
}

/// The next ν if Newton's method leaves the bracket, as it does for a minimum at ν1. Near the
/// minimum, the error of the ν of the best SupportRatio is of the order of the square of the error
/// of n. So the next ν is above that ν by the square of its distance from the upper end, as long as
/// this halves the bracket. Otherwise the next ν is the middle of the bracket.
template <class Search> PW85_FUNCTION inline auto next_in_bracket(Search &search) noexcept
{
    using T = decltype(search.lower);
    if (!(search.upper < largest_number<T>())) return T(T(2) * search.lower);
    T const excess = search.upper - search.best.nu,
            next = search.best.nu + excess * T(excess / search.upper);
    T const width = search.upper - search.lower;
    bool const halves = width <= T(T(0.5) * search.width);
    search.width = width;
    return halves && next > search.lower && next < search.upper
               ? T(next)
               : T(T(0.5) * (search.lower + search.upper));
}

/// Searches from ν on for bounds that differ by no more than `tolerance` S.
template <class T, int D> PW85_FUNCTION inline bool search_dual(Pair<T, D> const &pair,
                                                                DualBoundSearch<T, D> &search, T nu,
                                                                T const &tolerance) noexcept
{
    for (int step = 0; step < max_dual_steps<T>(); ++step) {
        T next = evaluate_at(pair, search, nu);
        if (has_converged(pair, search, tolerance)) return true;
        if (!(next > search.lower && next < search.upper)) next = next_in_bracket(search);
        if (!(next > search.lower && next < search.upper)) return false;
        nu = next;
    }
    return false;
}

/// A ν at which M is positive definite: the larger of the trace of Q1⁻¹Q2 and of the ν of two
/// balls whose radii are the half-widths of the ellipsoids along r.
template <class T, int D> PW85_FUNCTION inline T initial_nu(Pair<T, D> const &pair) noexcept
{
    auto const factors = factorize(pair.q1, T(unit_roundoff<T>()));
    T sum = T(0);
    for (int i = 0; i < D; ++i) {
        Vector<T, D> column{};
        for (int j = 0; j < D; ++j) column[j] = pair.q2(i, j);
        sum = sum + solve(factors, column)[i];
    }
    Vector<T, D> const n = solve(factors, pair.r12);
    T const q1 = quadratic_form(pair.q1, n), q2 = quadratic_form(pair.q2, n);
    T const ball =
        q2 > T(0) ? T(square_root(support_ratio(pair, n).mu2) * square_root(T(q2 / q1))) : T(0);
    return maximum(sum, ball);
}

/// The result of a search.
template <class T, int D> struct DualMinimum {
    T mu2;
    Vector<T, D> point;
    bool converged;
};

/// Searches with numbers of type W, which may be wider than those of the pair. The point is r +
/// Q2n/√(nᵀQ2n), on the surface of ellipsoid 2. The largest Q2ii/Q1ii is a lower bound on
/// λmax(Q1⁻¹Q2), and hence on ν.
template <class W, class T, int D> [[gnu::noinline]] PW85_FUNCTION inline DualMinimum<T, D>
minimize_dual_with(Pair<T, D> const &pair, W const &tolerance) noexcept
{
    auto const wide = widened<W>(pair);
    DualBoundSearch<W, D> search{W(0),
                                 largest_number<W>(),
                                 {{}, W(0), W(0), W(0)},
                                 largest_number<W>(),
                                 largest_number<W>()};
    for (int i = 0; i < D; ++i)
        search.lower = maximum(search.lower, W(wide.q2(i, i) / wide.q1(i, i)));
    search.lower = W(T(0.5)) * search.lower;
    bool const converged = search_dual(wide, search, initial_nu(wide), tolerance);
    auto const point =
        add_scaled(wide.r12, W(W(1) / search.best.root2), product(wide.q2, search.best.n));
    DualMinimum<T, D> dual{rounded(search.best.mu2), {}, converged};
    for (int i = 0; i < D; ++i) dual.point[i] = rounded(point[i]);
    return dual;
}

/// Searches with wider numbers.
template <class T, int D>
PW85_RARE DualMinimum<T, D> minimize_dual_wider(Pair<T, D> const &pair) noexcept
{
    T const u = T(unit_roundoff<T>());
    auto const finer = minimize_dual_with(pair, Doubled<T>(u));
    return finer.converged ? finer : minimize_dual_with(pair, exact::Extended<T>(u));
}

PW85_RARE_TIER(minimize_dual_wider)

/// Searches with T, then with wider numbers if T has them.
template <class T, int D>
PW85_FUNCTION inline DualMinimum<T, D> minimize_dual(Pair<T, D> const &pair) noexcept
{
    auto const dual = minimize_dual_with(pair, T(T(4) * T(unit_roundoff<T>())));
    if constexpr (has_extended_numbers<T>)
        if (!dual.converged) return minimize_dual_wider(pair);
    return dual;
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline ContainmentScale<T, D> containment(Vector<T, D> const &r12,
                                                        SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    auto const pair = pair_of(r12, q1, q2);
    StatusCode const status =
        passes_fast_checks(pair) ? StatusCode::success : validate_apart(r12, q1, q2);
    if (status != StatusCode::success) return all_nan<ContainmentScale<T, D>>(status);
    auto const scaled = scale_contained(pair);
    auto const dual = minimize_dual(scaled.pair);
    if (!dual.converged) return all_nan<ContainmentScale<T, D>>(StatusCode::no_convergence);
    Units const &units = scaled.units;
    return {units.mu().to_caller(dual.mu2, 2), units.length.to_caller(dual.point),
            StatusCode::success};
}

} // namespace pw85

#endif
