// SPDX-License-Identifier: BSD-3-Clause
// The contact function by Brent's method, as pw85 1.0 computed it. contact_function.cpp calls
// contact_function(); brent_minimizer.hpp offers the method of one of two libraries.
#ifndef PW85_BRENT_BRENT_HPP_INCLUDED
#define PW85_BRENT_BRENT_HPP_INCLUDED

#include <pw85/contact/contact.hpp>

namespace pw85::detail::brent {

/// Parameters of the method. The C API has one set of values.
struct Options {
    double lambda_atol;
    int max_iterations;
    int halley_steps;
};

/// The result of Brent's method.
struct BrentResult {
    double t;
    int rounds; ///< number of units that were tried
};

/// Finds the maximiser to about lambda_atol, for a valid pair in range with r12 != 0.
BrentResult maximizer_by_brent(Pair<double, 3> const &pair, Options const &options) noexcept;

/// Refines the candidate by at most halley_steps steps of the search on the factorised form.
/// Returns whether it converges.
bool refine(Pair<double, 3> const &pair, Candidate<double> &candidate,
            Options const &options) noexcept;

/// μ² and λ of any pair.
Contact<double> contact_function(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                                 SymmetricMatrix<double, 3> const &q2,
                                 Options const &options) noexcept;

} // namespace pw85::detail::brent

#endif
