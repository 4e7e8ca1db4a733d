// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `compute ID group pw85/overlap`. It tests pairs by the batch functions of pw85.
#ifndef PW85_LAMMPS_COMPUTE_OVERLAP_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_OVERLAP_HPP_INCLUDED

#include "compute_pairs.hpp"

namespace pw85_lammps {

/// The number of ellipsoids that overlap each atom, and as a scalar the number of overlapping
/// pairs.
class ComputeOverlap final : public ComputePairs {
  public:
    ComputeOverlap(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);

    double compute_scalar() override;
    void compute_peratom() override;

  private:
    double merge(double value, double from_ghost) const override { return value + from_ghost; }
    void count();

    /// summed over all processors, twice the number of overlapping pairs
    LAMMPS_NS::bigint halves_ = 0;
};

} // namespace pw85_lammps

#endif
