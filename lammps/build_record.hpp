// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// How far atoms have moved since LAMMPS built its neighbour lists.
#ifndef PW85_LAMMPS_BUILD_RECORD_HPP_INCLUDED
#define PW85_LAMMPS_BUILD_RECORD_HPP_INCLUDED

#include "host.hpp"

#include <array>
#include <string>
#include <vector>

namespace pw85_lammps {

/// What happened to all atoms and their periodic images since neighbour lists were built: a homogeneous deformation, that
/// of the box, and what each atom moved on top of it.
struct Movement {
    double strain;       ///< Frobenius norm of deformation gradient minus identity
    double displacement; ///< the largest of any atom; infinite if atoms are not those of the lists

    /// A lower bound for the distance of two atoms that were `distance` apart when the lists were built.
    double closest(double distance) const { return (1.0 - strain) * distance - 2.0 * displacement; }
};

/// Remembers atoms and box of the last build. LAMMPS tells only fixes of it, so this is one.
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

    /// Collective.
    Movement movement() const;

  private:
    double own_displacement() const;

    int num_owned_ = -1, num_ghosts_ = 0;
    std::vector<double> fractions_; ///< n×3: positions as fractions of the box
    std::array<double, 6> box_{}, box_inverse_{};
};

} // namespace pw85_lammps

#endif
