/// @file
/// The contact function of two ellipsoids, by the fast solver.
#ifndef PW85_CONTACT_HPP_INCLUDED
#define PW85_CONTACT_HPP_INCLUDED

#include <pw85/solver.hpp>

namespace pw85 {

/// The contact function of a pair.
template <class T> struct Contact {
    T mu2;    ///< square of the common factor by which both ellipsoids must be scaled to touch
    T lambda; ///< the maximiser of f, in [0, 1]
    Status status;
};

/// Status of the separation and the forms, before anything is computed with them.
template <class T, int D> PW85_FUNCTION inline Status
check_finite(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_finite(r12) && is_finite(q1) && is_finite(q2) ? Status::success : Status::invalid_argument;
}

/// Whether all diagonal entries are positive.
template <class T, int D> PW85_FUNCTION constexpr bool has_positive_diagonal(SymmetricMatrix<T, D> const &a) noexcept
{
    T smallest = a(0, 0);
    for (int i = 1; i < D; ++i) smallest = minimum(smallest, a(i, i));
    return smallest > T(0);
}

/// Validates a pair and brings it into range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Status validate(Vector<T, D> const &r12,
                                                                                 SymmetricMatrix<T, D> const &q1,
                                                                                 SymmetricMatrix<T, D> const &q2,
                                                                                 ScaledPair<T, D> &scaled) noexcept
{
    if (Status const status = check_finite(r12, q1, q2); status != Status::success) return status;
    if (!(has_positive_diagonal(q1) && has_positive_diagonal(q2))) return Status::not_positive_definite;
    scaled = scale(r12, q1, q2);
    bool const definite = is_positive_definite(scaled.pair.q1) && is_positive_definite(scaled.pair.q2);
    return definite ? Status::success : Status::not_positive_definite;
}

template <class T> PW85_FUNCTION constexpr Derivatives<T> invalid_derivatives() noexcept
{
    return {quiet_nan<T>(), quiet_nan<T>(), quiet_nan<T>()};
}

/// Whether λ is in [0, 1] and a pair is valid.
template <class T, int D> PW85_FUNCTION inline bool is_valid(T const &lambda, Vector<T, D> const &r12,
                                                             SymmetricMatrix<T, D> const &q1,
                                                             SymmetricMatrix<T, D> const &q2) noexcept
{
    ScaledPair<T, D> scaled;
    return lambda >= T(0) && lambda <= T(1) && validate(r12, q1, q2, scaled) == Status::success;
}

/// f at λ; NaN for invalid input.
template <class T, int D> PW85_FUNCTION inline T checked_f(T const &lambda, Vector<T, D> const &r12,
                                                           SymmetricMatrix<T, D> const &q1,
                                                           SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_valid(lambda, r12, q1, q2) ? evaluate_f(lambda, r12, q1, q2) : quiet_nan<T>();
}

/// f, f' and f'' at λ; NaN for invalid input.
template <class T, int D>
PW85_FUNCTION inline Derivatives<T> checked_derivatives(T const &lambda, Vector<T, D> const &r12,
                                                        SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_valid(lambda, r12, q1, q2) ? evaluate_derivatives(lambda, r12, q1, q2) : invalid_derivatives<T>();
}

template <class T> PW85_FUNCTION constexpr Contact<T> failed_contact(Status status) noexcept
{
    return {quiet_nan<T>(), quiet_nan<T>(), status};
}

/// The contact function from a maximum that was found.
template <class T> PW85_FUNCTION inline Contact<T> to_contact(Maximum<T> const &m) noexcept
{
    if (!m.converged || !(m.mu2 >= T(0))) return failed_contact<T>(Status::no_convergence);
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

/// Whether products alone show that a pair is valid and in range, and r12 != 0: true of almost all pairs.
template <class T, int D> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_ordinary(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_in_range(sum_of_magnitudes(r12), largest_diagonal(q1), largest_diagonal(q2)) && is_clearly_definite(q1) &&
           is_clearly_definite(q2);
}

/// contact() for any pair: validated, and in units that keep it in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Contact<T>
contact_scaled(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = validate(r12, q1, q2, scaled);
    if (status != Status::success) return failed_contact<T>(status);
    if (largest_coordinate(r12) == T(0)) return {T(0), T(0.5), Status::success};
    return unscale(scaled, maximize(scaled.pair));
}

template <class T, int D> PW85_FUNCTION inline Contact<T>
contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    if (is_ordinary(r12, q1, q2)) return to_contact(maximize(Pair<T, D>{r12, q1, q2, T(1)}));
    return contact_scaled(r12, q1, q2);
}

} // namespace pw85

#endif
