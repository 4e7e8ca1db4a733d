// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `compute ID group pw85/pressure`: the pressure of hard ellipsoids.
#ifndef PW85_LAMMPS_COMPUTE_PRESSURE_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_PRESSURE_HPP_INCLUDED

#include "compute_pairs.hpp"

#include <array>

namespace pw85_lammps {

/// The pressure over kT, from the contacts that a small compression makes.
///
/// Let n(y) be the mean number of pairs with ln μ < y: those that overlap if all distances shrink
/// by the factor exp(-y), and the volume by exp(-3y). The pressure is minus the derivative of the
/// free energy by the volume, (N + n′(0)/3)/V in units of kT. n′(0) is extrapolated from the counts
/// in [0, W) and [W, 2W), as (3 n₁ - n₂)/(2W): the error is of order W².
class ComputePressure final : public ComputePairs {
  public:
    ComputePressure(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~ComputePressure() override { delete[] vector; }

    double compute_scalar() override;
    void compute_vector() override;
    void compute_peratom() override {}

  private:
    double merge(double value, double) const override { return value; }
    void add_batch();

    double width_ = 0.01;                       ///< of the two ranges of ln μ
    std::array<LAMMPS_NS::bigint, 2> counts_{}; ///< pairs that this processor reports
};

} // namespace pw85_lammps

#endif
