// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `pair_style pw85/contact`. It computes energies, forces and torques by the batch
/// functions of pw85.
#ifndef PW85_LAMMPS_PAIR_CONTACT_HPP_INCLUDED
#define PW85_LAMMPS_PAIR_CONTACT_HPP_INCLUDED

#include "ellipsoids.hpp"
#include "neighbours.hpp"

#include <array>
#include <optional>

namespace pw85_lammps {

/// Soft repulsion of overlapping ellipsoids, U = ε/α (1 - μ)^α for μ < 1, else 0.
class PairContact final : public LAMMPS_NS::Pair {
  public:
    explicit PairContact(LAMMPS_NS::LAMMPS *lammps);
    ~PairContact() override;

    void compute(int eflag, int vflag) override;
    void settings(int narg, char **arg) override;
    void coeff(int narg, char **arg) override;
    void init_style() override;
    double init_one(int i, int j) override;
    void reinit() override;

    /// For the name "epsilon", the matrix of ε by type.
    void *extract(char const *name, int &dimension) override;

    /// Returns the energy of a pair of atoms. A distance `rsq` that is not that of the atoms is an
    /// error. `fforce` is the component of the force along the line of centres divided by the
    /// distance; svector holds μ² and the force on the first atom.
    double single(int i, int j, int itype, int jtype, double rsq, double factor_coul,
                  double factor_lj, double &fforce) override;
    int pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc) override;
    void unpack_forward_comm(int count, int first, double *buffer) override;
    double memory_usage() override;

  private:
    /// The energy of a pair, the force on the first ellipsoid, and the torques on both.
    struct Action {
        double energy, force[3], torque1[3], torque2[3];
    };

    /// The derivatives of μ² of a pair.
    struct Derivatives {
        double const *r12, *rot1, *rot2;
    };

    void allocate();
    void require_positive(double cutoff) const;
    bool is_in_place(int i, int j, double rsq) const;
    void add_batch(int eflag);
    void add_pair(std::size_t k, int eflag);
    Action act(double mu2, Derivatives const &d, double strength) const;
    void apply(int i, int j, Action const &action);

    double cutoff_ = 0.0, exponent_ = 2.0;
    double **epsilon_ = nullptr, **cut_ = nullptr;
    std::vector<bool> used_types_;
    std::optional<Ellipsoids> ellipsoids_;
    PairBatch batch_;
    /// derivatives of the pairs of a batch that overlap
    std::vector<double> d_r12_, d_rot1_, d_rot2_;
    std::array<double, 4> single_{};
};

} // namespace pw85_lammps

#endif
