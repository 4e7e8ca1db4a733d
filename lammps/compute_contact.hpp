// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `compute ID group pw85/contact`. It finds contacts by the batch functions of pw85.
#ifndef PW85_LAMMPS_COMPUTE_CONTACT_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_CONTACT_HPP_INCLUDED

#include "compute_pairs.hpp"
#include "local_rows.hpp"

namespace pw85_lammps {

/// Contacts of pairs as a local array, their number as a scalar, and per atom the smallest contact
/// function.
class ComputeContact final : public ComputePairs {
  public:
    ComputeContact(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);

    double compute_scalar() override;
    void compute_local() override;
    void compute_peratom() override;
    double memory_usage() override;

  private:
    /// The tags of the two atoms, μ², the contact point of the scaled ellipsoids, and the normal
    /// from the first to the second.
    static constexpr int row_size = 9;

    double merge(double value, double from_ghost) const override;
    void evaluate(bool with_rows);
    void add_batch(bool with_rows);
    void add_row(int i, int j, double mu2, double lambda);

    double below_;                ///< only contacts with a smaller μ² count
    LAMMPS_NS::bigint count_ = 0; ///< number of contacts that this processor reports
    LocalRows<row_size> rows_;
};

} // namespace pw85_lammps

#endif
