// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The masses with which grains move: that of a grain, or that of the body of `fix rigid` of which
/// it is a part.
#ifndef PW85_LAMMPS_BODY_MASSES_HPP_INCLUDED
#define PW85_LAMMPS_BODY_MASSES_HPP_INCLUDED

#include "host.hpp"

#include <cstddef>
#include <vector>

namespace pw85_lammps {

/// The masses by local index, of owned atoms, and of ghosts if the style that owns this object
/// sends them.
class BodyMasses : protected LAMMPS_NS::Pointers {
  public:
    explicit BodyMasses(LAMMPS_NS::LAMMPS *lammps) : Pointers(lammps) {}

    /// Finds the fixes with rigid bodies. Call this at the start of a run.
    void start_run();

    /// Returns whether the masses must be read: rigid bodies exist, and the neighbour list is new,
    /// which changes the indices of atoms.
    bool are_new() const { return !fixes_.empty() && neighbor->ago == 0; }

    /// Reads the masses of owned atoms.
    void read();

    double of(int i) const
    {
        return fixes_.empty() ? atom->rmass[i] : masses_[static_cast<std::size_t>(i)];
    }

    int pack(int count, int const *atoms, double *buffer) const;
    void unpack(int count, int first, double const *buffer);

  private:
    std::vector<LAMMPS_NS::Fix *> fixes_;
    std::vector<double> masses_;
};

} // namespace pw85_lammps

#endif
