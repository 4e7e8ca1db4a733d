// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Measures how far atoms have moved since LAMMPS built its neighbour lists. The computes
/// (compute_pairs.cpp) ask whether the lists are still complete.
#ifndef PW85_LAMMPS_BUILD_RECORD_HPP_INCLUDED
#define PW85_LAMMPS_BUILD_RECORD_HPP_INCLUDED

#include "host.hpp"

#include <array>
#include <string>
#include <vector>

namespace pw85_lammps {

/// The motion of all atoms and their periodic images since the neighbour lists were built: the
/// homogeneous deformation of the box, and the displacement of each atom relative to it.
struct Movement {
    double strain; ///< Frobenius norm of the deformation gradient minus the identity
    /// largest displacement of any atom; infinite if the atoms are not those of the lists
    double displacement;

    /// Returns a lower bound for the distance of two atoms that were `distance` apart when the
    /// lists were built.
    double closest(double distance) const { return (1.0 - strain) * distance - 2.0 * displacement; }
};

/// Stores the atoms and the box of the last build. It is a fix, because LAMMPS notifies only fixes
/// of a build.
class BuildRecord final : public LAMMPS_NS::Fix {
  public:
    BuildRecord(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);

    /// Adds a record to the fixes of a running LAMMPS; its owner removes it.
    static void add(LAMMPS_NS::Modify &modify, std::string const &id);

    int setmask() override;
    void init() override { num_owned_ = -1; }
    void setup_pre_neighbor() override { pre_neighbor(); }
    void pre_neighbor() override;
    void min_pre_neighbor() override { pre_neighbor(); }
    double memory_usage() override;

    /// Returns the motion since the last build. All processors call this together.
    Movement movement() const;

  private:
    double own_displacement() const;

    int num_owned_ = -1, num_ghosts_ = 0;
    std::vector<double> fractions_; ///< n×3: positions as fractions of the box
    std::array<double, 6> box_{}, box_inverse_{};
};

} // namespace pw85_lammps

#endif
