// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The warning of a time step that is too long for the stiffness of a contact.
#ifndef PW85_LAMMPS_TIME_STEP_CHECK_HPP_INCLUDED
#define PW85_LAMMPS_TIME_STEP_CHECK_HPP_INCLUDED

#include "host.hpp"

#include <algorithm>
#include <string>

namespace pw85_lammps {

/// Compares the time step with the fastest oscillation √(k/m) of the contacts of a step. It warns
/// once a run.
class TimeStepCheck {
  public:
    void start_run() { warned_ = false; }
    void start_step() { fastest_ = 0.0; }
    /// @param rate stiffness over mass of a contact, in the units of LAMMPS
    void add(double rate) { fastest_ = std::max(fastest_, rate); }

    /// @param timestep zero while a run is set up
    void finish_step(LAMMPS_NS::LAMMPS &lammps, std::string const &style, double timestep);

  private:
    double fastest_ = 0.0; ///< largest rate
    bool warned_ = false;
};

} // namespace pw85_lammps

#endif
