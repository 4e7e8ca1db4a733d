// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Warnings of a time step that is too long.
#ifndef PW85_LAMMPS_TIME_STEP_CHECK_HPP_INCLUDED
#define PW85_LAMMPS_TIME_STEP_CHECK_HPP_INCLUDED

#include "host.hpp"

#include <cmath>
#include <string>

namespace pw85_lammps {

/// Compares the time step with the shortest limit that any processor has found since the run began,
/// and warns once a run.
///
/// Processors compare their limits in the first and the last step of a run and where the neighbour
/// list is new: other steps have no message for it. The iterations of a minimiser have no time
/// step.
class TimeStepCheck {
  public:
    void start_run()
    {
        limit_ = HUGE_VAL;
        warned_ = false;
    }

    /// All processors call this together.
    /// @param limit the longest time step that this processor allows in this step
    /// @param timestep zero while a run is set up
    /// @param trouble of a longer time step, for the warning
    void finish_step(LAMMPS_NS::LAMMPS &lammps, double limit, double timestep,
                     std::string const &trouble);

  private:
    double limit_ = HUGE_VAL; ///< on this processor
    bool warned_ = false;     ///< equal on all processors
};

/// Returns the limit for contacts of which the largest stiffness over mass is this rate, in the
/// units of LAMMPS.
double limit_of_contacts(double rate, LAMMPS_NS::Force const &force);

/// Its trouble.
constexpr char too_long_for_contacts[] = "the time step is too long for the stiffest contact";

} // namespace pw85_lammps

#endif
