// Brent's method, by the library that the build has chosen: brent_gsl.cpp or brent_boost.cpp.
#ifndef PW85_BRENT_MINIMIZER_HPP_INCLUDED
#define PW85_BRENT_MINIMIZER_HPP_INCLUDED

#include "brent.hpp"

namespace pw85::detail::brent {

/// A function of a number, finite and non-positive in [0, 1], and zero at the ends.
struct Objective {
    double (*value)(double x, void *data) noexcept;
    void *data;
};

/// The minimiser to within lambda_atol, in at most max_iterations; 1/2 where the function is not negative there. It allocates
/// nothing.
double minimize(Objective const &objective, Options const &options) noexcept;

} // namespace pw85::detail::brent

#endif
