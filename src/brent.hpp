// The contact function by Brent's method, for which brent_minimizer.hpp has a choice of libraries.
#ifndef PW85_BRENT_HPP_INCLUDED
#define PW85_BRENT_HPP_INCLUDED

#include <pw85/contact/contact.hpp>

namespace pw85::detail::brent {

/// What governs the method; the C API has one set of values.
struct Options {
    double lambda_atol;
    int max_iterations;
    int newton_iterations;
};

/// Where Brent's method ends.
struct Rough {
    double t;
    int rounds; ///< choices of units that it took
};

/// The maximiser to about lambda_atol, for a valid pair in range with r12 != 0.
Rough maximizer_by_brent(Pair<double, 3> const &pair, Options const &options) noexcept;

/// Refines the candidate, in at most newton_iterations steps of the search on the factorised form; whether they settle it.
bool refine(Pair<double, 3> const &pair, Candidate<double> &candidate, Options const &options) noexcept;

/// μ² and λ of any pair.
Contact<double> contact_function(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                                 SymmetricMatrix<double, 3> const &q2, Options const &options) noexcept;

} // namespace pw85::detail::brent

#endif
