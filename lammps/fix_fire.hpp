// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// fix pw85/fire
#ifndef PW85_LAMMPS_FIX_FIRE_HPP_INCLUDED
#define PW85_LAMMPS_FIX_FIRE_HPP_INCLUDED

#include "ellipsoids.hpp"

#include <optional>
#include <string>

namespace pw85_lammps {

/// Minimises the energy over positions and orientations, by the fast inertial relaxation engine of Bitzek, Koskinen, Gähler,
/// Moseler and Gumbsch (Phys. Rev. Lett. 97, 170201, 2006): dynamics whose momenta are turned towards the forces while they
/// go downhill, and put to rest when they go uphill.
///
/// The dynamics is that of `fix nve/asphere`, which this fix adds and removes. Momenta are linear and angular ones, forces are
/// forces and torques, and both are measured by the inverse masses and moments of inertia, so that neither units nor shapes
/// need a parameter.
class FixFire final : public LAMMPS_NS::Fix {
  public:
    FixFire(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~FixFire() override;

    void post_constructor() override;
    int setmask() override;
    void init() override;
    void setup(int vflag) override;
    void end_of_step() override;
    void post_run() override;
    void reset_dt() override {}

    /// √(Σ F²/m + T·I⁻¹T): zero where all forces and torques are.
    double compute_scalar() override { return residual_; }
    double memory_usage() override { return ellipsoids_->bytes(); }

  private:
    /// F·v + T·ω, p·v + L·ω, and F²/m + T·I⁻¹T, each summed over all ellipsoids.
    struct Sums {
        double power, motion, force2;
    };

    bool moves(int i) const { return (atom->mask[i] & groupbit) != 0; }
    void read();
    double smallest_semi_axis() const;
    Sums sums() const;
    void scale_momenta(double kept, double push);
    double fastest() const;
    void set_timestep(double timestep);

    std::string integrator_;
    std::optional<Ellipsoids> ellipsoids_;
    double original_timestep_ = 0.0, largest_step_ = 0.0;
    double timestep_ = 0.0, mixing_ = 0.0, residual_ = 0.0;
    int downhill_ = 0; ///< steps since the last uphill one
};

} // namespace pw85_lammps

#endif
