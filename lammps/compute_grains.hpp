// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `compute ID group pw85/grains`: the contacts of pair_style pw85/granular.
#ifndef PW85_LAMMPS_COMPUTE_GRAINS_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_GRAINS_HPP_INCLUDED

#include "fix_wall.hpp"
#include "local_rows.hpp"
#include "pair_granular.hpp"

#include <array>
#include <vector>

namespace pw85_lammps {

/// Contacts of grains, and on demand with walls, as a local array, their number as a scalar, the
/// sum of their stresses as a vector, and per atom the number of contacts.
class ComputeGrains final : public LAMMPS_NS::Compute {
  public:
    ComputeGrains(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~ComputeGrains() override { delete[] vector; }

    void init() override;
    double compute_scalar() override;
    void compute_vector() override;
    void compute_local() override;
    void compute_peratom() override;
    int pack_reverse_comm(int count, int first, double *buffer) override;
    void unpack_reverse_comm(int count, int *atoms, double *buffer) override;
    double memory_usage() override;

  private:
    /// The tags of both atoms, the smaller first; point, normal, depth, the force on the first
    /// atom, the stress, the tangential part of the force, the tangential spring, and the heat that
    /// flows into the first atom. With a wall, the second tag is minus the number of the wall.
    using Rows = LocalRows<28>;
    using Row = Rows::Row;
    static constexpr std::size_t stress_size = 9, stress_place = 12;

    void check_step() const;
    bool counts(PairGranular::Touch const &touch) const;
    bool counts(FixWall::Touch const &touch) const { return (atom->mask[touch.i] & groupbit) != 0; }
    Row row(PairGranular::Touch const &touch) const;
    Row row(FixWall::Touch const &touch, std::size_t wall) const;
    template <class Use> void for_each_row(Use use) const;

    PairGranular *pair_ = nullptr;
    bool has_walls_ = false;
    std::vector<FixWall *> walls_; ///< in the order of their commands
    Rows rows_;
    std::vector<double> counts_; ///< by owned atom and ghost
};

} // namespace pw85_lammps

#endif
