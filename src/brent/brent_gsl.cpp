// SPDX-License-Identifier: BSD-3-Clause
// Brent's method of the GNU Scientific Library, for builds with that library. brent.cpp calls
// minimize().
#include "brent_minimizer.hpp"

#include <cstddef>

#include <gsl/gsl_min.h>

namespace pw85::detail::brent {

// The function calls the method through its type instead of a gsl_min_fminimizer. So it needs only
// memory for its state, and allocates nothing. GSL's process-wide error handler, which aborts by
// default, is never called, because all values are finite. The state is six numbers in all versions
// of GSL. If it were larger than the memory here, the method would not be used.
double minimize(Objective const &objective, Options const &options) noexcept
{
    gsl_min_fminimizer_type const &method = *gsl_min_fminimizer_brent;
    alignas(std::max_align_t) unsigned char state[256];
    double x = 0.5, lower = 0.0, upper = 1.0;
    double f = objective.value(x, objective.data), f_lower = 0.0, f_upper = 0.0;
    if (method.size > sizeof state || !(f < 0.0)) return x;
    gsl_function function{objective.value, objective.data};
    method.set(state, &function, x, f, lower, f_lower, upper, f_upper);
    for (int i = 0; i < options.max_iterations && upper - lower >= options.lambda_atol; ++i)
        method.iterate(state, &function, &x, &f, &lower, &f_lower, &upper, &f_upper);
    return x;
}

} // namespace pw85::detail::brent
