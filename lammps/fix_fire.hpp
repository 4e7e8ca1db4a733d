// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `fix ID group pw85/fire`. It needs forces and torques, as pair_style pw85/contact
/// gives them.
#ifndef PW85_LAMMPS_FIX_FIRE_HPP_INCLUDED
#define PW85_LAMMPS_FIX_FIRE_HPP_INCLUDED

#include "ellipsoids.hpp"

#include <optional>
#include <string>

namespace pw85_lammps {

/// Minimises the energy over positions and orientations, by the fast inertial relaxation engine of
/// Bitzek, Koskinen, Gähler, Moseler and Gumbsch (Phys. Rev. Lett. 97, 170201, 2006). It is a
/// dynamics that turns the momenta towards the forces while the motion goes downhill, and stops the
/// motion when it goes uphill.
///
/// The dynamics is that of `fix nve/asphere`, which this fix adds and removes. "Momenta" are linear
/// and angular momenta, and "forces" are forces and torques. Their norms use the inverse masses and
/// moments of inertia; no parameter depends on units or shapes.
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

    /// Returns √(Σ F²/m + T·I⁻¹T), which is zero if all forces and torques are zero.
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
