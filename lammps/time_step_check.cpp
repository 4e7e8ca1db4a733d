// SPDX-License-Identifier: GPL-2.0-only
// Warnings of a time step that is too long, for the stiffness of a contact or another rate.
#include "time_step_check.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace pw85_lammps {

namespace {

/// The largest time step times the frequency √(k/m) of a contact. Verlet's method makes a frequency
/// ω too large by a fraction of (ω dt)²/24, here 0.2 %; it is unstable from ω dt = 2.
constexpr double largest_phase = 0.2;

/// Returns three digits of a number, rounded down by at most 0.5 %.
std::string rounded_down(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value / 1.005);
    return text.data();
}

bool is_step_of_check(LAMMPS_NS::LAMMPS const &lammps)
{
    constexpr int in_run = 1; // as LAMMPS numbers what it is doing
    LAMMPS_NS::Update const &update = *lammps.update;
    return update.whichflag == in_run &&
           (lammps.neighbor->ago == 0 || update.ntimestep == update.firststep + 1 ||
            update.ntimestep == update.laststep);
}

} // namespace

void TimeStepCheck::finish_step(LAMMPS_NS::LAMMPS &lammps, double limit, double timestep,
                                std::string const &trouble)
{
    limit_ = std::min(limit_, limit);
    if (warned_ || timestep == 0.0 || !is_step_of_check(lammps)) return;
    MPI_Allreduce(MPI_IN_PLACE, &limit_, 1, MPI_DOUBLE, MPI_MIN, lammps.world);
    if (timestep <= limit_) return;
    warned_ = true;
    if (lammps.comm->me == 0)
        lammps.error->warning(FLERR,
                              trouble + ": use timestep " + rounded_down(limit_) + " or less");
}

// Returns the limit of the time step. In some units a force over a mass is not an acceleration.
double limit_of_contacts(double rate, LAMMPS_NS::Force const &force)
{
    return largest_phase / std::sqrt(rate * force.ftm2v);
}

} // namespace pw85_lammps
