// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `compute ID group pw85/order`: the nematic order of ellipsoids.
#ifndef PW85_LAMMPS_COMPUTE_ORDER_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_ORDER_HPP_INCLUDED

#include "ellipsoids.hpp"
#include "vectors.hpp"

#include <array>
#include <optional>

namespace pw85_lammps {

/// The order parameter as a scalar; the director and all eigenvalues of the tensor of order as a
/// vector.
class ComputeOrder final : public LAMMPS_NS::Compute {
  public:
    ComputeOrder(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~ComputeOrder() override { delete[] vector; }

    void init() override { ellipsoids_.forget(); }
    double compute_scalar() override;
    void compute_vector() override;
    double memory_usage() override { return ellipsoids_.bytes(); }

  private:
    std::optional<Vector> axis(int i) const;

    Ellipsoids ellipsoids_;
};

} // namespace pw85_lammps

#endif
