// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides whether trials of a simulation are accepted. volume.cpp, engine.cpp and insertions.cpp
/// call this.
#ifndef PW85_SIMULATION_ACCEPTANCE_HPP_INCLUDED
#define PW85_SIMULATION_ACCEPTANCE_HPP_INCLUDED

#include "../simd/power.hpp"

namespace pw85::detail::simulation {

/// Returns true with probability min(1, ratio^exponent e^-cost). The functions for x^y and e^x give
/// the same bits everywhere.
[[gnu::always_inline]] inline bool accept(double ratio, double exponent, double cost,
                                          double uniform) noexcept
{
    double const log = logarithm(Pack(ratio)).high[0], sum = exponent * log - cost;
    if (sum >= 0.0) return true;
    return sum > -700.0 && uniform < exponential(Doubled<Pack>(Pack(sum)))[0];
}

} // namespace pw85::detail::simulation

#endif
