// The oracle of the tests: the templates of the core with a type of 50 digits and an unlimited exponent.
#ifndef PW85_TESTS_WIDE_HPP_INCLUDED
#define PW85_TESTS_WIDE_HPP_INCLUDED

// GCC 14 takes a shift of Boost's for one beyond the limbs of a number.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#include <boost/multiprecision/cpp_bin_float.hpp>
#pragma GCC diagnostic pop

#include "condition_number.hpp"

namespace pw85_tests {

template <unsigned Digits> using Multiprecision =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

using Wide = Multiprecision<50>;

/// The contact function of a pair exactly as given, and its condition number.
template <class T> struct Truth {
    T mu2, lambda, cond;
};

template <class Oracle, class T, int D> Truth<Oracle> truth(Sample<T, D> const &sample)
{
    auto const p = convert<Oracle>(sample);
    auto const c = pw85::contact(p.r12, p.q1, p.q2);
    return {c.mu2, c.lambda, condition_number(p, c.lambda)};
}

/// |actual - truth|/truth in units of u·cond, u the unit roundoff of the type of `actual`.
template <class Oracle, class T> double error_in_units(T const &actual, Truth<Oracle> const &exact)
{
    Oracle const error = pw85::detail::absolute(Oracle(Oracle(actual) - exact.mu2)) / exact.mu2;
    return static_cast<double>(Oracle(error / (Oracle(pw85::detail::unit_roundoff<T>()) * exact.cond)));
}

} // namespace pw85_tests

#endif
