// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of two ellipsoids. pw85.hpp, the lane kernels and the headers for
/// derivatives, overlaps and closest approach use this file. It validates the pair (scaling.hpp),
/// and finds the maximum of f by the solver (solver.hpp).
#ifndef PW85_CONTACT_CONTACT_HPP_INCLUDED
#define PW85_CONTACT_CONTACT_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/scaling.hpp>
#include <pw85/contact/solver.hpp>

namespace pw85 {

/// The contact function of a pair.
template <class T> struct Contact {
    T mu2;    ///< square of the common factor by which both ellipsoids must be scaled to touch
    T lambda; ///< the maximiser of f, in [0, 1]
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

template <class T> PW85_FUNCTION constexpr Derivatives<T> invalid_derivatives() noexcept
{
    return {quiet_nan<T>(), quiet_nan<T>(), quiet_nan<T>()};
}

/// f at λ. It is NaN for invalid input.
template <class T, int D> PW85_FUNCTION inline T checked_f(T const &lambda, Vector<T, D> const &r12,
                                                           SymmetricMatrix<T, D> const &q1,
                                                           SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_valid(lambda, pair_of(r12, q1, q2)) ? evaluate_f(lambda, r12, q1, q2)
                                                  : quiet_nan<T>();
}

/// f, f' and f'' at λ. They are NaN for invalid input.
template <class T, int D>
PW85_FUNCTION inline Derivatives<T> checked_derivatives(T const &lambda, Vector<T, D> const &r12,
                                                        SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_valid(lambda, pair_of(r12, q1, q2)) ? evaluate_derivatives(lambda, r12, q1, q2)
                                                  : invalid_derivatives<T>();
}

/// Returns whether to accept the last evaluation of a search for a pair that was not validated.
template <class T, int D> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_accepted(Pair<T, D> const &pair, LastEvaluation<T> const &last) noexcept
{
    return last.certified && passes_fast_checks(pair);
}

/// Converts a maximum to the contact function.
template <class T> PW85_FUNCTION inline Contact<T> to_contact(Maximum<T> const &m) noexcept
{
    if (!m.converged || !(m.mu2 >= T(0))) return all_nan<Contact<T>>(StatusCode::no_convergence);
    return {m.mu2, m.lambda, StatusCode::success};
}

/// Converts a maximum in scaled units to the contact function in the units of the caller.
template <class T, int D, class Q> PW85_FUNCTION inline Contact<T>
unscale(ScaledPair<T, D, Q> const &scaled, Maximum<T> const &m) noexcept
{
    Contact<T> result = to_contact(m);
    result.mu2 = scaled.units.mu().to_caller(result.mu2, 2);
    if (scaled.units.swapped && result.status == StatusCode::success) result.lambda = m.complement;
    return result;
}

/// contact() for any pair. It validates the pair and scales it to units in which all numbers stay
/// in range.
template <class T, int D, class Q>
[[gnu::noinline]] PW85_FUNCTION inline Contact<T> contact_scaled(Pair<T, D, Q> pair) noexcept
{
    ScaledPair<T, D, Q> scaled;
    StatusCode const status = validate_pair(pair, scaled);
    if (status != StatusCode::success) return all_nan<Contact<T>>(status);
    if (largest_coordinate(pair.r12) == T(0)) return {T(0), T(0.5), StatusCode::success};
    return unscale(scaled, maximize(scaled.pair));
}

/// contact() of a pair.
template <class T, int D, class Q>
PW85_FUNCTION inline Contact<T> contact_of(Pair<T, D, Q> const &pair) noexcept
{
    return passes_fast_checks(pair) ? to_contact(maximize(pair)) : contact_scaled(pair);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline Contact<T> contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    auto const q = side_by_side(q1, q2);
    auto const pair = pair_of(r12, q1, q2);
    return passes_fast_checks(r12, q, adjugate(q)) ? to_contact(maximize(pair))
                                                   : contact_scaled(pair);
}

} // namespace pw85

#endif
