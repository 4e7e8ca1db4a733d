// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The pressure, from the contacts of event chains (chains.hpp).
///
/// Michel, Kapfer and Krauth, Generalized event-chain Monte Carlo (2014), doi:10.1063/1.4863991:
/// βP/ρ, along the direction d of a chain, is the mean of (x_last - x_first)/length. Here x is the
/// coordinate along d of the particle that moves. At each contact it jumps by the coordinate of the
/// separation.
#ifndef PW85_SIMULATION_PRESSURE_SAMPLE_HPP_INCLUDED
#define PW85_SIMULATION_PRESSURE_SAMPLE_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail::simulation {

/// Sums over some chains.
struct PressureSample {
    double length;    ///< the sum of the paths
    double transfers; ///< the sum of the coordinates along d of the separations at contacts

    /// Returns βP/ρ if no particle can touch its own images; NaN without chains.
    double compressibility() const noexcept
    {
        return length > 0.0 ? 1.0 + transfers / length : quiet_nan<double>();
    }
};

} // namespace pw85::detail::simulation

#endif
