// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `pair_style pw85/hard`, for fix pw85/hpmc. It gives LAMMPS the cutoff of hard
/// ellipsoids, and has no forces.
#ifndef PW85_LAMMPS_PAIR_HARD_HPP_INCLUDED
#define PW85_LAMMPS_PAIR_HARD_HPP_INCLUDED

#include "ellipsoids.hpp"

#include <optional>
#include <vector>

namespace pw85_lammps {

/// At the start of each run it checks that the cutoffs reach all contacts.
class PairHard final : public LAMMPS_NS::Pair {
  public:
    explicit PairHard(LAMMPS_NS::LAMMPS *lammps);
    ~PairHard() override;

    void compute(int eflag, int vflag) override;
    void settings(int narg, char **arg) override;
    void coeff(int narg, char **arg) override;
    void init_style() override;
    double init_one(int i, int j) override;
    double memory_usage() override;

  private:
    double cutoff_ = 0.0;
    bool checked_ = false;
    std::vector<bool> used_types_;
    std::optional<Ellipsoids> ellipsoids_;
};

} // namespace pw85_lammps

#endif
