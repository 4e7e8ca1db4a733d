// SPDX-License-Identifier: BSD-3-Clause
// Brent's method of the library that the build chooses: brent_gsl.cpp or brent_boost.cpp. brent.cpp
// calls it.
#ifndef PW85_BRENT_BRENT_MINIMIZER_HPP_INCLUDED
#define PW85_BRENT_BRENT_MINIMIZER_HPP_INCLUDED

#include "brent.hpp"

namespace pw85::detail::brent {

/// A function of x in [0, 1] that is finite, non-positive, and zero at 0 and 1.
struct Objective {
    double (*value)(double x, void *data) noexcept;
    void *data;
};

/// Finds the minimiser to within lambda_atol, in at most max_iterations. Returns 1/2 if the
/// function is not negative at 1/2. It allocates nothing.
double minimize(Objective const &objective, Options const &options) noexcept;

} // namespace pw85::detail::brent

#endif
