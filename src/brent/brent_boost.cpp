// SPDX-License-Identifier: BSD-3-Clause
// Brent's method of Boost.Math, for builds with that library. brent.cpp calls minimize().
#include "brent_minimizer.hpp"

#include <cmath>
#include <cstdint>

#include <boost/math/tools/minima.hpp>

namespace pw85::detail::brent {

namespace {

// The method ends when both ends of its bracket are within 2^(2 - bits) (x + 1/4) of x. In [0, 1]
// this is at most 5·2^-bits.
int bits_of(double lambda_atol) noexcept { return std::ilogb(5.0 / lambda_atol) + 1; }

} // namespace

double minimize(Objective const &objective, Options const &options) noexcept
{
    auto const f = [&objective](double x) noexcept { return objective.value(x, objective.data); };
    if (!(f(0.5) < 0.0)) return 0.5;
    // The first two iterations only find a point between the ends. GSL's method receives this
    // point.
    auto iterations = static_cast<std::uintmax_t>(options.max_iterations) + 2;
    return boost::math::tools::brent_find_minima(f, 0.0, 1.0, bits_of(options.lambda_atol),
                                                 iterations)
        .first;
}

} // namespace pw85::detail::brent
