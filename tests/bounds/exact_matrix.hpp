// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Symmetric matrices whose minors have no rounding errors.
#ifndef PW85_TESTS_BOUNDS_EXACT_MATRIX_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_EXACT_MATRIX_HPP_INCLUDED

#include <pw85/pw85.hpp>

namespace pw85_bounds {

/// The entries are multiples of 2^-8 below 2^8. So minors are multiples of 2^-24 below 2^27.
template <int D> using Exact = pw85::SymmetricMatrix<double, D>;

/// Whether a matrix is positive definite.
template <int D> bool is_positive(Exact<D> const &a)
{
    bool all = true;
    for (double const minor : pw85::detail::leading_minors(a).coordinates) all = all && minor > 0.0;
    return all;
}

} // namespace pw85_bounds

#endif
