// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The status of a form and of a pair in n dimensions. Every function checks its input here.
#ifndef PW85_ANY_DIMENSION_DEFINITE_HPP_INCLUDED
#define PW85_ANY_DIMENSION_DEFINITE_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/any_dimension/exact_sign.hpp>
#include <pw85/status.hpp>

namespace pw85::detail::any_dimension {

/// The shift with which is_definite_with_shift() proves that a form is positive definite: four
/// times n (n + 4) u. The errors of factorisation are at most n (n + 8) u (factorization_error()),
/// and the rounding of a - shift a adds u. The sum n (n + 8) + 1 is less than 4 n (n + 4).
template <class T> PW85_FUNCTION inline T least_shift(int n) noexcept
{
    return T(4 * factorization_error(n)) * T(unit_roundoff<T>());
}

template <class T, class N>
PW85_FUNCTION inline bool is_clearly_definite(N n, double const *q, Unit unit) noexcept
{
    if (!keeps_digits(n, q, unit)) return false;
    T matrix[packed_size(capacity<N>)];
    to_local(unit, 2, packed_size(n), q, matrix);
    return is_definite_with_shift(n, matrix, least_shift<T>(n), matrix);
}

/// Decides for forms that double precision does not decide.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline StatusCode
status_of_difficult_form(int n, double const *q, Unit unit) noexcept
{
    if (is_clearly_definite<Doubled<double>>(n, q, unit)) return StatusCode::success;
    int const definite = is_definite_exactly(n, q);
    return definite == sign_unknown ? StatusCode::out_of_memory
           : definite == 1          ? StatusCode::success
                                    : StatusCode::not_positive_definite;
}

/// Returns the status of numbers that must be finite.
PW85_FUNCTION inline StatusCode status_of_numbers(int size, double const *x) noexcept
{
    double sum = 0.0;
    for (int i = 0; i < size; ++i) sum += x[i] * 0.0;
    return sum == 0.0 ? StatusCode::success : StatusCode::invalid_argument;
}

/// Returns the status of one form. Whether it is positive definite is decided exactly.
template <class N> PW85_FUNCTION inline StatusCode status_of_form(N n, double const *q) noexcept
{
    if (status_of_numbers(packed_size(n), q) != StatusCode::success)
        return StatusCode::invalid_argument;
    for (int i = 0; i < n; ++i)
        if (!(q[packed_index(n, i, i)] > 0.0)) return StatusCode::not_positive_definite;
    double const size = largest_diagonal(n, q);
    Unit const unit{is_in_range(size, size, size) ? 0 : half_exponent(size)};
    return is_clearly_definite<double>(n, q, unit) ? StatusCode::success
                                                   : status_of_difficult_form(n, q, unit);
}

PW85_FUNCTION constexpr bool is_dimension(int n) noexcept { return n >= 1 && n <= max_dimension; }

/// Returns the status of a pair.
template <class N>
[[gnu::noinline]] PW85_FUNCTION inline StatusCode status_of(InputOf<N> const &in) noexcept
{
    if (!is_dimension(in.n) || status_of_numbers(in.n, in.r12) != StatusCode::success)
        return StatusCode::invalid_argument;
    StatusCode const first = status_of_form(in.n, in.q1), second = status_of_form(in.n, in.q2);
    bool const invalid = second == StatusCode::invalid_argument;
    return first == StatusCode::success || invalid ? second : first;
}

} // namespace pw85::detail::any_dimension

#endif
