// SPDX-License-Identifier: GPL-2.0-only
// fix wall/pw85: the forces of planes on ellipsoids.
#include "fix_wall.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

constexpr char style_name[] = "fix wall/pw85";
constexpr char usage[] =
    "use fix ID group wall/pw85 xplane|yplane|zplane LO|NULL HI|NULL [wiggle DIM AMPLITUDE PERIOD | shear DIM SPEED] "
    "[arms contact|surface] law LAW";

} // namespace

FixWall::FixWall(LAMMPS *lammps, int narg, char **arg) : Fix(lammps, narg, arg), first_step_(update->ntimestep)
{
    if (narg < 8) stop_all(*error, std::string("Illegal fix command: ") + usage);
    int const k = parse_motion(parse_planes(arg), narg, arg);
    law_ = ContactLaw::parse(lmp, style_name, narg - k, arg + k);
    ellipsoids_.emplace(lmp, style_name, "leave it out of the group");
    restart_global = 1;
    restart_peratom = 1;
    create_attribute = 1;
    maxexchange = exchange_size;
    scalar_flag = 1;
    global_freq = 1;
    extscalar = 1;
    grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
}

FixWall::~FixWall()
{
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
}

/// Reads the planes; returns the number of the next word.
int FixWall::parse_planes(char **arg)
{
    std::string const word = arg[3];
    if (word.size() != 6 || word.substr(1) != "plane")
        stop_all(*error, std::string(style_name) + ": unknown wall " + word + ": " + usage);
    axis_ = axis_of(word.substr(0, 1).c_str());
    planes_ = {Plane{place(arg[4]), -1.0, std::strcmp(arg[4], "NULL") != 0},
               {place(arg[5]), 1.0, std::strcmp(arg[5], "NULL") != 0}};
    return 6;
}

double FixWall::place(char const *word) const
{
    return std::strcmp(word, "NULL") == 0 ? 0.0 : utils::numeric(FLERR, word, false, lmp);
}

int FixWall::axis_of(char const *word) const
{
    for (int k = 0; k < 3; ++k)
        if (std::string(word) == std::string(1, "xyz"[k])) return k;
    stop_all(*error, std::string(style_name) + ": " + word + " is no axis: " + usage);
}

/// Reads what is before the law; returns the number of its first word.
int FixWall::parse_motion(int k, int narg, char **arg)
{
    bool moves = false;
    while (k < narg && std::strcmp(arg[k], "law") != 0) {
        std::string const word = arg[k];
        if (word == "arms" && k + 1 < narg) {
            std::string const where = arg[k + 1];
            if (where != "contact" && where != "surface") break;
            arms_at_surface_ = where == "surface";
            k += 2;
            continue;
        }
        bool const wiggles = word == "wiggle";
        int const next = k + (wiggles ? 4 : 3);
        if ((!wiggles && word != "shear") || moves || next > narg) break;
        moves = true;
        wiggles_ = wiggles;
        moving_axis_ = axis_of(arg[k + 1]);
        (wiggles ? amplitude_ : speed_) = utils::numeric(FLERR, arg[k + 2], false, lmp);
        if (wiggles) period_ = utils::numeric(FLERR, arg[k + 3], false, lmp);
        k = next;
    }
    if (k >= narg || std::strcmp(arg[k], "law") != 0) stop_all(*error, std::string("Illegal fix command: ") + usage);
    if (!(period_ > 0.0)) stop_all(*error, std::string(style_name) + ": the period must be positive");
    if (!wiggles_ && moves && moving_axis_ == axis_)
        stop_all(*error, std::string(style_name) + ": shear must be along the wall: use wiggle to move it across");
    return k + 1;
}

int FixWall::setmask() { return FixConst::POST_FORCE; }

void FixWall::init()
{
    if (std::string(update->integrate_style).rfind("respa", 0) == 0)
        stop_all(*error, std::string(style_name) + " does not work with run_style respa: use run_style verlet");
    if (domain->periodicity[axis_])
        stop_all(*error,
                 std::string(style_name) + ": the box is periodic across the wall: use boundary f or s for this axis");
    ellipsoids_->forget();
}

/// How far the planes are from their first place, along the axis that they move along.
double FixWall::shift() const
{
    double const time = static_cast<double>(update->ntimestep - first_step_) * update->dt;
    return wiggles_ ? amplitude_ * (1.0 - std::cos(2.0 * std::numbers::pi * time / period_)) : 0.0;
}

Vector FixWall::wall_velocity() const
{
    double const time = static_cast<double>(update->ntimestep - first_step_) * update->dt;
    double const frequency = 2.0 * std::numbers::pi / period_;
    Vector v{};
    v[static_cast<std::size_t>(moving_axis_)] = wiggles_ ? amplitude_ * frequency * std::sin(frequency * time) : speed_;
    return v;
}

void FixWall::post_force(int)
{
    timestep_ = update->setupflag ? 0.0 : update->dt;
    energy_ = 0.0;
    ellipsoids_->read([this](int i) { return (atom->mask[i] & groupbit) != 0; });
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!ellipsoids_->selected(i)) continue;
        for (std::size_t k = 0; k < planes_.size(); ++k)
            if (planes_[k].exists) push(i, planes_[k], springs(i)[k]);
    }
}

/// Adds the force of a plane on a grain. A grain that does not touch the plane loses its spring.
void FixWall::push(int i, Plane const &plane, Vector &spring)
{
    double const moved = plane.place + (moving_axis_ == axis_ ? shift() : 0.0);
    double const distance = plane.side * (moved - atom->x[i][axis_]);
    if (distance >= ellipsoids_->largest_semi_axis(i)) {
        spring = {};
        return;
    }
    Vector normal{};
    normal[static_cast<std::size_t>(axis_)] = plane.side;
    GrainGeometry g = plane_geometry(ellipsoids_->form(i), normal, distance);
    if (!(g.depth > 0.0)) {
        spring = {};
        return;
    }
    if (!arms_at_surface_) g.meet_in_the_middle();
    Vector const spin = without_inertia(atom->rmass[i], ellipsoids_->form(i), vector(atom->angmom[i]));
    Vector const velocity = vector(atom->v[i]) + cross(spin, g.arm1) - wall_velocity();
    Reaction const reaction = law_.react({normal, g.depth, g.radius, atom->rmass[i], velocity, timestep_}, spring);
    Vector const torque = cross(g.arm1, reaction.force);
    for (std::size_t k = 0; k < 3; ++k) {
        atom->f[i][k] += reaction.force[k];
        atom->torque[i][k] += torque[k];
    }
    energy_ += reaction.energy;
}

double FixWall::compute_scalar()
{
    double sum = 0.0;
    MPI_Allreduce(&energy_, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
}

// A restart file stores the step at which the motion of the wall began.
void FixWall::write_restart(FILE *file)
{
    if (comm->me != 0) return;
    int const size = sizeof(first_step_);
    std::fwrite(&size, sizeof(size), 1, file);
    std::fwrite(&first_step_, sizeof(first_step_), 1, file);
}

void FixWall::restart(char *state) { std::memcpy(&first_step_, state, sizeof(first_step_)); }

int FixWall::pack_exchange(int i, double *buffer)
{
    for (Vector const &spring : springs(i)) buffer = std::copy(spring.begin(), spring.end(), buffer);
    return exchange_size;
}

int FixWall::unpack_exchange(int i, double *buffer)
{
    springs(i) = {vector(buffer), vector(buffer + 3)};
    return exchange_size;
}

int FixWall::pack_restart(int i, double *buffer)
{
    buffer[0] = restart_size;
    return 1 + pack_exchange(i, buffer + 1);
}

void FixWall::unpack_restart(int i, int which)
{
    double *numbers = atom->extra[i];
    for (int k = 0; k < which; ++k) numbers += static_cast<int>(numbers[0]);
    unpack_exchange(i, numbers + 1);
}

} // namespace pw85_lammps
