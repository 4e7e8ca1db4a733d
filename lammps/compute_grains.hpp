// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `compute ID group pw85/grains`: the contacts of pair_style pw85/granular.
#ifndef PW85_LAMMPS_COMPUTE_GRAINS_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_GRAINS_HPP_INCLUDED

#include "pair_granular.hpp"

#include <array>
#include <vector>

namespace pw85_lammps {

/// Contacts as a local array, their number as a scalar, the sum of their stresses as a vector, and per atom the number of contacts.
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
    /// The tags of both atoms, the smaller first; point, normal, depth, the force on the first atom, and the stress.
    using Row = std::array<double, 21>;
    static constexpr std::size_t stress_size = 9;

    std::vector<PairGranular::Touch> const &touches() const;
    bool counts(PairGranular::Touch const &touch) const;
    Row row(PairGranular::Touch const &touch) const;

    PairGranular *pair_ = nullptr;
    std::vector<Row> rows_;
    std::vector<double *> row_pointers_;
    std::vector<double> counts_; ///< by owned atom and ghost
};

} // namespace pw85_lammps

#endif
