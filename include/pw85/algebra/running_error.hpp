// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A number with a bound on its error, which grows with each operation (J. H. Wilkinson, Rounding
/// Errors in Algebraic Processes, 1963). The templates of contact/ compute with it where a bound
/// must hold for forms of any shape. overlap/contact_rounded.hpp uses it with extended numbers.
#ifndef PW85_ALGEBRA_RUNNING_ERROR_HPP_INCLUDED
#define PW85_ALGEBRA_RUNNING_ERROR_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail {

/// A number that differs from `value` by at most `error`. T must have guard digits: its unit
/// roundoff must exceed the error of each operation by so much that it bounds the rounding errors
/// of `error` as well.
template <class T> struct RunningError {
    T value, error;

    RunningError() noexcept = default;
    PW85_MEMBER explicit RunningError(T const &exact) noexcept : value(exact), error(T(0)) {}
    PW85_MEMBER RunningError(T const &rounded, T const &propagated) noexcept
        : value(rounded), error(propagated + T(unit_roundoff<T>()) * absolute(rounded))
    {
    }
};

template <class T> PW85_FUNCTION inline RunningError<T> operator+(RunningError<T> const &x,
                                                                  RunningError<T> const &y) noexcept
{
    return {x.value + y.value, x.error + y.error};
}

template <class T> PW85_FUNCTION inline RunningError<T> operator-(RunningError<T> x) noexcept
{
    x.value = -x.value;
    return x;
}

template <class T> PW85_FUNCTION inline RunningError<T> operator-(RunningError<T> const &x,
                                                                  RunningError<T> const &y) noexcept
{
    return x + -y;
}

template <class T> PW85_FUNCTION inline RunningError<T> operator*(RunningError<T> const &x,
                                                                  RunningError<T> const &y) noexcept
{
    return {x.value * y.value,
            absolute(x.value) * y.error + absolute(y.value) * x.error + x.error * y.error};
}

/// 1/x, with an infinite error, or NaN, if x may be zero.
template <class T>
PW85_FUNCTION inline RunningError<T> reciprocal_of(RunningError<T> const &x) noexcept
{
    T const quotient = T(1) / x.value, least = absolute(x.value) - x.error;
    return {quotient, least > T(0) ? T(absolute(quotient) * x.error / least) : quiet_nan<T>()};
}

} // namespace pw85::detail

#endif
