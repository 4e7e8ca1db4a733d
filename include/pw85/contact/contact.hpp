/// @file
/// The contact function of two ellipsoids, by the fast solver.
#ifndef PW85_CONTACT_CONTACT_HPP_INCLUDED
#define PW85_CONTACT_CONTACT_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/solver.hpp>
#include <pw85/contact/validate.hpp>

namespace pw85 {

/// The contact function of a pair.
template <class T> struct Contact {
    T mu2;    ///< square of the common factor by which both ellipsoids must be scaled to touch
    T lambda; ///< the maximiser of f, in [0, 1]
    Status status;
};

} // namespace pw85

namespace pw85::detail {

template <class T> PW85_FUNCTION constexpr Derivatives<T> invalid_derivatives() noexcept
{
    return {quiet_nan<T>(), quiet_nan<T>(), quiet_nan<T>()};
}

/// f at λ; NaN for invalid input.
template <class T, int D> PW85_FUNCTION inline T checked_f(T const &lambda, Vector<T, D> const &r12,
                                                           SymmetricMatrix<T, D> const &q1,
                                                           SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_valid(lambda, pair_of(r12, q1, q2)) ? evaluate_f(lambda, r12, q1, q2) : quiet_nan<T>();
}

/// f, f' and f'' at λ; NaN for invalid input.
template <class T, int D>
PW85_FUNCTION inline Derivatives<T> checked_derivatives(T const &lambda, Vector<T, D> const &r12,
                                                        SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_valid(lambda, pair_of(r12, q1, q2)) ? evaluate_derivatives(lambda, r12, q1, q2)
                                                  : invalid_derivatives<T>();
}

/// Accepts the last evaluation of a search for a pair that nobody has validated.
template <class T, int D> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_accepted(Pair<T, D> const &pair, LastEvaluation<T> const &last) noexcept
{
    return last.certain && passes_fast_checks(pair);
}

/// The contact function from a maximum that was found.
template <class T> PW85_FUNCTION inline Contact<T> to_contact(Maximum<T> const &m) noexcept
{
    if (!m.converged || !(m.mu2 >= T(0))) return all_nan<Contact<T>>(Status::no_convergence);
    return {m.mu2, m.lambda, Status::success};
}

/// The contact function from a maximum that was found in scaled units.
template <class T, int D>
PW85_FUNCTION inline Contact<T> unscale(ScaledPair<T, D> const &scaled, Maximum<T> const &m) noexcept
{
    Contact<T> result = to_contact(m);
    result.mu2 = times_power_of_two(result.mu2, 2 * (scaled.length - scaled.form));
    if (scaled.swapped && result.status == Status::success) result.lambda = m.complement;
    return result;
}

/// contact() for any pair: validated, and in units that keep it in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Contact<T> contact_scaled(Pair<T, D> pair) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = validate(pair, scaled);
    if (status != Status::success) return all_nan<Contact<T>>(status);
    if (largest_coordinate(pair.r12) == T(0)) return {T(0), T(0.5), Status::success};
    return unscale(scaled, maximize(scaled.pair));
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Contact<T>
contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    auto const pair = pair_of(r12, q1, q2);
    return passes_fast_checks(pair) ? to_contact(maximize(pair)) : contact_scaled(pair);
}

} // namespace pw85

#endif
