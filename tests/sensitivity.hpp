// SPDX-License-Identifier: BSD-3-Clause
// How much the distance along a direction depends on the entries of a pair.
#ifndef PW85_TESTS_SENSITIVITY_HPP_INCLUDED
#define PW85_TESTS_SENSITIVITY_HPP_INCLUDED

#include <pw85/distance/support.hpp>

#include "random_pairs.hpp"

namespace pw85_tests {

/// Σ of the contracts of pw85_distance(), pw85_penetration() and pw85_signed_distance() along n:
/// relative changes ε of the entries change the distance along n by at most ε Σ.
template <class T, int D> T sensitivity(Sample<T, D> const &p, pw85::Vector<T, D> const &n)
{
    return pw85::detail::magnitude_of_form(p.q1, n) / (2 * pw85::detail::support(p.q1, n).extent) +
           pw85::detail::magnitude_of_form(p.q2, n) / (2 * pw85::detail::support(p.q2, n).extent) +
           pw85::detail::magnitude_of_dot(n, p.r12);
}

} // namespace pw85_tests

#endif
