// SPDX-License-Identifier: BSD-3-Clause
// The oracle of the tests: the templates of the core with a type of 50 digits and an unlimited
// exponent.
#ifndef PW85_TESTS_WIDE_HPP_INCLUDED
#define PW85_TESTS_WIDE_HPP_INCLUDED

#include "condition_number.hpp"
#include "oracle/compiled_once.hpp"

namespace pw85_tests {

using WideVector = pw85::Vector<Wide, 3>;
using WideForm = pw85::SymmetricMatrix<Wide, 3>;

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
    return static_cast<double>(
        Oracle(error / (Oracle(pw85::detail::unit_roundoff<T>()) * exact.cond)));
}

} // namespace pw85_tests

#endif
