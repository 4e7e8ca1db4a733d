// SPDX-License-Identifier: GPL-2.0-only
// The warning of a time step that is too long for the stiffness of a contact.
#include "time_step_check.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace pw85_lammps {

namespace {

/// The largest time step times the frequency √(k/m) of a contact. Verlet's method makes a frequency
/// ω too large by a fraction of (ω dt)²/24, here 0.2 %; it is unstable from ω dt = 2.
constexpr double largest_phase = 0.2;

/// Three digits of a number that is not larger: their rounding is at most 0.5 %.
std::string rounded_down(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value / 1.005);
    return text.data();
}

} // namespace

void TimeStepCheck::finish_step(LAMMPS_NS::LAMMPS &lammps, std::string const &style,
                                double timestep)
{
    // In some units a force over a mass is not an acceleration.
    double const limit = largest_phase / std::sqrt(fastest_ * lammps.force->ftm2v);
    if (warned_ || timestep <= limit) return;
    warned_ = true;
    lammps.error->warning(
        FLERR, style + ": the time step is too long for the stiffest contact: use timestep " +
                   rounded_down(limit) + " or less");
}

} // namespace pw85_lammps
