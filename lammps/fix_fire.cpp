// SPDX-License-Identifier: GPL-2.0-only
// fix pw85/fire: it changes momenta and time step at the end of each step; fix nve/asphere moves
// the ellipsoids.
#include "fix_fire.hpp"

#include "vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

constexpr char fire_style[] = "fix pw85/fire";

/// The constants of the method, as published: the number of downhill steps before the time step
/// grows, the factors by which it grows and shrinks, the share of the force in a momentum and the
/// factor by which it shrinks, and the largest time step in units of the first.
constexpr int delay = 5;
constexpr double growth = 1.1, fall = 0.5, first_mixing = 0.1, mixing_fall = 0.99,
                 largest_growth = 10.0;

/// In one step no point of a surface moves by more than this fraction of the smallest semi-axis.
constexpr double largest_share = 0.1;

} // namespace

FixFire::FixFire(LAMMPS *lammps, int narg, char **arg)
    : Fix(lammps, narg, arg), integrator_(std::string("PW85_MOVE_") + id)
{
    if (narg != 3)
        stop_all(*error, std::string(fire_style) + " takes no arguments: fix ID group pw85/fire");
    nevery = 1;
    scalar_flag = 1;
    global_freq = 1;
    extscalar = 0;
    ellipsoids_.emplace(lmp, fire_style, "leave it out of the group");
}

FixFire::~FixFire()
{
    if (modify->find_fix(integrator_) >= 0) modify->delete_fix(integrator_);
}

void FixFire::post_constructor()
{
    modify->add_fix(integrator_ + " " + group->names[igroup] + " nve/asphere");
}

int FixFire::setmask() { return FixConst::END_OF_STEP | FixConst::POST_RUN; }

void FixFire::init()
{
    refuse_respa(*lmp, fire_style);
    ellipsoids_->forget();
    read();
    original_timestep_ = timestep_ = update->dt;
    mixing_ = first_mixing;
    downhill_ = 0;
}

void FixFire::read()
{
    ellipsoids_->read([this](int i) { return moves(i); });
}

void FixFire::setup(int)
{
    read();
    largest_step_ = largest_share * smallest_semi_axis();
    scale_momenta(0.0, 0.0);
    residual_ = std::sqrt(sums().force2);
}

void FixFire::end_of_step()
{
    read();
    Sums const s = sums();
    residual_ = std::sqrt(s.force2);
    if (s.power > 0.0) {
        scale_momenta(1.0 - mixing_, mixing_ * std::sqrt(s.motion / s.force2));
        if (++downhill_ > delay) {
            timestep_ = std::min(growth * timestep_, largest_growth * original_timestep_);
            mixing_ *= mixing_fall;
        }
    } else {
        scale_momenta(0.0, 0.0);
        if (s.force2 > 0.0) timestep_ *= fall;
        mixing_ = first_mixing;
        downhill_ = 0;
    }
    double const speed = fastest();
    set_timestep(timestep_ * speed > largest_step_ ? largest_step_ / speed : timestep_);
}

void FixFire::post_run()
{
    scale_momenta(0.0, 0.0);
    set_timestep(original_timestep_);
}

double FixFire::smallest_semi_axis() const
{
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < atom->nlocal; ++i)
        if (moves(i)) smallest = std::min(smallest, ellipsoids_->smallest_semi_axis(i));
    MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, world);
    return smallest;
}

FixFire::Sums FixFire::sums() const
{
    std::array<double, 3> s{};
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!moves(i)) continue;
        double const mass = atom->rmass[i];
        Vector const v = vector(atom->v[i]), f = vector(atom->f[i]);
        Vector const spin = vector(atom->angmom[i]), torque = vector(atom->torque[i]);
        Vector const w = without_inertia(mass, ellipsoids_->form(i), spin);
        Vector const turn = without_inertia(mass, ellipsoids_->form(i), torque);
        s[0] += dot(f, v) + dot(torque, w);
        s[1] += mass * dot(v, v) + dot(spin, w);
        s[2] += dot(f, f) / mass + dot(torque, turn);
    }
    MPI_Allreduce(MPI_IN_PLACE, s.data(), 3, MPI_DOUBLE, MPI_SUM, world);
    return {s[0], s[1], s[2]};
}

/// Replaces each momentum p by kept·p + push·F, where F is the force, and angular momenta alike.
void FixFire::scale_momenta(double kept, double push)
{
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!moves(i)) continue;
        for (int k = 0; k < 3; ++k) {
            atom->v[i][k] = kept * atom->v[i][k] + push / atom->rmass[i] * atom->f[i][k];
            atom->angmom[i][k] = kept * atom->angmom[i][k] + push * atom->torque[i][k];
        }
    }
}

/// Returns an upper bound on the speeds of all points of the ellipsoids.
double FixFire::fastest() const
{
    double speed = 0.0;
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!moves(i)) continue;
        Vector const v = vector(atom->v[i]);
        Vector const w =
            without_inertia(atom->rmass[i], ellipsoids_->form(i), vector(atom->angmom[i]));
        double const rim = ellipsoids_->largest_semi_axis(i) * std::sqrt(dot(w, w));
        speed = std::max(speed, std::sqrt(dot(v, v)) + rim);
    }
    MPI_Allreduce(MPI_IN_PLACE, &speed, 1, MPI_DOUBLE, MPI_MAX, world);
    return speed;
}

void FixFire::set_timestep(double timestep)
{
    update->update_time();
    update->dt = timestep;
    if (force->pair) force->pair->reset_dt();
    for (int k = 0; k < modify->nfix; ++k) modify->fix[k]->reset_dt();
}

} // namespace pw85_lammps
