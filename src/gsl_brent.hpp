// The contact function by Brent's method of the GNU Scientific Library.
#ifndef PW85_GSL_BRENT_HPP_INCLUDED
#define PW85_GSL_BRENT_HPP_INCLUDED

#include <pw85/contact.hpp>

namespace pw85::brent {

/// What governs the method; the C API has one set of values.
struct Options {
    double lambda_atol;
    int max_iterations;
    int newton_iterations;
};

/// μ² and λ of any pair.
Contact<double> contact_function(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                                 SymmetricMatrix<double, 3> const &q2, Options const &options) noexcept;

} // namespace pw85::brent

#endif
