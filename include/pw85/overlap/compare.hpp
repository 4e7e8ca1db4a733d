/// @file
/// The sign of μ² - m for any number m. pw85.hpp and the C API use this file. The solver decides with a bound on its error
/// (comparison.hpp). If it cannot, integers decide (exact.hpp).
#ifndef PW85_OVERLAP_COMPARE_HPP_INCLUDED
#define PW85_OVERLAP_COMPARE_HPP_INCLUDED

#include <pw85/overlap/comparison.hpp>
#include <pw85/overlap/exact.hpp>

namespace pw85 {

/// The sign of μ² - m. It is 2 if the status is not success.
struct Comparison {
    int sign;
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// Converts a decision about the ellipsoids of m Q1 and m Q2 to the sign of μ² - m.
PW85_FUNCTION constexpr int to_sign(Decision decision) noexcept
{
    return decision == Decision::apart ? 1 : decision == Decision::overlap ? -1 : 0;
}

/// The last tier, for a valid pair and 0 < m < infinity. For multiprecision numbers the comparison is up to rounding.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline int compare_last(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2, T const &m) noexcept
{
    if constexpr (exact::is_decidable<T>) {
        return compare_exactly(r12, q1, q2, m);
    } else {
        T const mu2 = contact(r12, q1, q2).mu2;
        return to_sign(to_decision(mu2 > m, mu2 < m));
    }
}

/// Decides by the search for the maximum, for a valid pair and m > 0. In the units of the pair μ² is at least 2^-52, so a scaled m
/// that underflows does no harm. A scaled m that overflows becomes infinity, and μ² is below infinity.
template <class T, int D>
PW85_FUNCTION inline Decision compare_by_search(ScaledPair<T, D> const &scaled, T const &m) noexcept
{
    return decide_by_comparison(scaled.pair, T(times_power_of_two(m, 2 * (scaled.form - scaled.length))));
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Comparison
compare(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2, T const &m) noexcept
{
    using namespace detail;
    ScaledPair<T, D> scaled;
    Status const status = m >= T(0) ? validate(pair_of(r12, q1, q2), scaled) : Status::invalid_argument;
    if (status != Status::success) return {2, status};
    bool const concentric = largest_coordinate(r12) == T(0), positive = m > T(0);
    if (concentric || !positive) return {(concentric ? 0 : 1) - (positive ? 1 : 0), status};
    if (m > largest_number<T>()) return {-1, status};
    Decision const decision = compare_by_search(scaled, m);
    return {decision != Decision::none ? to_sign(decision) : compare_last(r12, q1, q2, m), status};
}

} // namespace pw85

#endif
