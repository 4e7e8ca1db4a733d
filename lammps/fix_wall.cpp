// SPDX-License-Identifier: GPL-2.0-only
// fix wall/pw85: the forces of walls on ellipsoids.
#include "fix_wall.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

constexpr char wall_style[] = "fix wall/pw85";

/// Cosine of the largest angle by which the normal of a contact turns in a step: 60°. The faces of
/// a box are further apart.
constexpr double farthest_turn = 0.5;

} // namespace

FixWall::FixWall(LAMMPS *lammps, int narg, char **arg)
    : Fix(lammps, narg, arg), step_(update->ntimestep), masses_(lammps)
{
    parse(narg, arg);
    ellipsoids_.emplace(lmp, wall_style, "leave it out of the group");
    restart_global = 1;
    restart_peratom = 1;
    create_attribute = 1;
    maxexchange = 1;
    maxexchange_dynamic = 1;
    scalar_flag = 1;
    global_freq = 1;
    extscalar = 1;
    vector_flag = 1;
    size_vector = 14;
    extvector = 0;
    grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
}

FixWall::~FixWall()
{
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
}

void FixWall::parse(int narg, char **arg)
{
    Words words(lmp, std::string(wall_style) + ": the wall", narg - 3, arg + 3);
    surface_ = WallSurface::parse(words);
    is_hard_ = words.skip("hard");
    if (is_hard_ && !words.done())
        words.refuse("has words behind the word hard, which is the last one");
    if (is_hard_) return;
    motion_.parse(words, *surface_);
    for (;;) {
        if (words.skip("arms")) {
            arms_ = parse_arms(words);
        } else if (words.skip("loads")) {
            if (surface_->num_triangles() == 0)
                words.refuse("has no triangles for the word loads: use a mesh");
            local_freq =
                static_cast<int>(words.whole("number of steps between loads", 1, 1000000000));
            local_flag = 1;
            size_local_cols = static_cast<int>(std::tuple_size_v<LoadRow>);
        } else if (words.skip("temperature")) {
            if (words.next_is("NULL")) words.refuse("has a bad temperature: NULL");
            temperature_ = EqualValue::parse(words, "temperature");
            present_temperature_ = temperature_->number();
        } else {
            break;
        }
    }
    if (!words.skip("law"))
        words.refuse("lacks the word law, which follows its shape, its motion, its arms and its "
                     "temperature, or the word hard, which follows its shape");
    law_ = ContactLaw::parse(lmp, wall_style, words.num_left(), words.left());
    check_heat(words);
}

void FixWall::check_heat(Words const &words) const
{
    if (law_.conducts() && !temperature_)
        words.refuse("has a law with heat, but no temperature: add temperature T before the word "
                     "law");
    if (temperature_ && !law_.conducts())
        words.refuse("has a temperature, but its law does not conduct heat: add heat area or heat "
                     "radius to the law, or remove the temperature");
}

int FixWall::setmask()
{
    return FixConst::PRE_EXCHANGE | FixConst::MIN_PRE_EXCHANGE | FixConst::POST_FORCE;
}

void FixWall::init()
{
    refuse_respa(*lmp, wall_style);
    for (int axis = 0; axis < 3; ++axis)
        if (surface_->crosses(axis) && domain->periodicity[axis])
            stop_all(
                *error,
                std::string(wall_style) +
                    ": the box is periodic across the wall: use boundary f or s for this axis");
    if (is_hard_) require_monte_carlo();
    heat_ = law_.conducts() ? &FixHeat::require(*lmp, wall_style) : nullptr;
    ellipsoids_->forget();
    masses_.start_run();
    time_step_check_.start_run();
}

/// Stops the run if nothing keeps grains away from a wall without forces.
void FixWall::require_monte_carlo() const
{
    for (int k = 0; k < modify->nfix; ++k)
        if (std::string(modify->fix[k]->style) == "pw85/hpmc") return;
    stop_all(*error, std::string(wall_style) +
                         ": hard walls are for fix pw85/hpmc, and exert no forces: give the wall a "
                         "law, or add that fix");
}

std::string FixWall::why_not_hard() const
{
    if (!surface_->has_cuts()) return "has triangles: use planes, cylinders or the inside of a box";
    if (!motion_.is_at_rest()) return "moves: remove the words of its motion";
    return {};
}

bool FixWall::cuts(Vector const &center, double const *form, double radius) const
{
    return surface_->cuts(motion_.to_wall(center, form, radius));
}

void FixWall::pre_exchange() { find_maxexchange(); }

/// Finds the largest number of values of an atom on any processor.
void FixWall::find_maxexchange()
{
    std::size_t longest = 0;
    for (int i = 0; i < atom->nlocal; ++i) longest = std::max(longest, contacts(i).size());
    int const own = 1 + contact_size * static_cast<int>(longest);
    MPI_Allreduce(&own, &maxexchange, 1, MPI_INT, MPI_MAX, world);
}

void FixWall::post_force(int)
{
    if (is_hard_) return;
    timestep_ = update->setupflag ? 0.0 : update->dt;
    // First, because variables may read the loads of the step before.
    move_wall();
    energy_ = 0.0;
    fastest_ = 0.0;
    load_ = {};
    step_of_total_ = -1;
    touches_.clear();
    if (keeps_touches_) step_of_touches_ = update->ntimestep;
    bool const has_table = local_flag && update->ntimestep % local_freq == 0;
    loads_.assign(has_table ? 3 * static_cast<std::size_t>(surface_->num_triangles()) : 0, 0.0);
    ellipsoids_->read([this](int i) { return (atom->mask[i] & groupbit) != 0; });
    if (masses_.are_new()) masses_.read();
    for (int i = 0; i < atom->nlocal; ++i)
        if (ellipsoids_->selected(i)) touch(i);
    time_step_check_.finish_step(*lmp, limit_of_contacts(fastest_, *force), timestep_,
                                 std::string(wall_style) + ": " + too_long_for_contacts);
    if (motion_.is_servo()) motion_.finish_servo_step(total_load().force, timestep_, force->ftm2v);
    if (has_table) tabulate_loads();
}

void FixWall::move_wall()
{
    pass_time();
    bool const varies = temperature_ && temperature_->is_variable();
    if (motion_.has_variables() || varies) {
        modify->clearstep_compute();
        motion_.read_variables(*lmp, wall_style);
        if (varies) present_temperature_ = temperature_->read(*lmp, wall_style);
        modify->addstep_compute(update->ntimestep + 1);
    }
    motion_.move_to(clock_.time());
    if (motion_.is_servo()) motion_.start_servo_step(timestep_);
}

/// Advances the time by a step; in the set-up of a run the time does not change. The states of a
/// rerun are as many time steps apart as their numbers say, and their springs are unknown.
void FixWall::pass_time()
{
    bool const is_from_file = is_rerun(*input);
    if (is_from_file)
        for (auto &row : contacts_) row.clear();
    double const distance = static_cast<double>(update->ntimestep - step_);
    double const in_run = update->setupflag ? 0.0 : 1.0;
    clock_.advance(is_from_file ? distance : in_run, update->dt);
    step_ = update->ntimestep;
}

/// Returns the largest gap between the surface of an owned grain and the wall in a contact.
double FixWall::largest_gap(int i) const
{
    double const longest = ellipsoids_->largest_semi_axis(i);
    double const curvature_radius = longest * longest / ellipsoids_->smallest_semi_axis(i);
    return law_.largest_gap(surface_->largest_radius(curvature_radius));
}

/// Adds the forces of the wall on a grain. A contact begins where the surfaces touch. With
/// attraction it lasts until the gap between them is too large.
void FixWall::touch(int i)
{
    touching_.clear();
    Grain const grain = motion_.to_wall(vector(atom->x[i]), ellipsoids_->form(i),
                                        ellipsoids_->largest_semi_axis(i));
    std::string const failure = surface_->touch(grain, largest_gap(i), touching_);
    if (!failure.empty())
        ellipsoids_->refuse(i, "(type " + std::to_string(atom->type[i]) + ") " + failure);
    std::vector<Contact> now;
    for (GrainGeometry &g : touching_) {
        g = motion_.to_space(g);
        now.push_back({g.normal, {}});
    }
    std::vector<bool> const was_there = inherit_springs(contacts(i), now);
    contacts(i).clear();
    for (std::size_t k = 0; k < now.size(); ++k) {
        GrainGeometry const &g = touching_[k];
        bool const lasts = was_there[k] && g.depth > -law_.largest_gap(g.radius);
        if (!(g.depth > 0.0 || lasts)) continue;
        push(i, g, now[k].springs);
        contacts(i).push_back(now[k]);
    }
}

bool FixWall::meets(Vector const &center, double const *form, double radius) const
{
    WallMotion motion = motion_;
    motion.move_on(clock_.time(), update->dt);
    std::vector<GrainGeometry> contacts;
    Grain const grain = motion.to_wall(center, form, radius);
    return surface_->contains(grain.center) || !surface_->touch(grain, 0.0, contacts).empty() ||
           !contacts.empty();
}

/// Assigns the springs of the step before to the contacts with the nearest normals, in the order of
/// their distances. Returns which contacts have got springs.
std::vector<bool> FixWall::inherit_springs(std::vector<Contact> &before,
                                           std::vector<Contact> &now) const
{
    std::vector<bool> has_spring(now.size(), false);
    while (!before.empty()) {
        double nearest = farthest_turn;
        std::size_t heir = now.size();
        auto source = before.end();
        for (auto old = before.begin(); old != before.end(); ++old)
            for (std::size_t k = 0; k < now.size(); ++k) {
                double const cosine = dot(old->normal, now[k].normal);
                if (has_spring[k] || !(cosine > nearest)) continue;
                nearest = cosine;
                heir = k;
                source = old;
            }
        if (source == before.end()) break;
        now[heir].springs = source->springs;
        has_spring[heir] = true;
        before.erase(source);
    }
    return has_spring;
}

/// Adds the force of a contact.
void FixWall::push(int i, GrainGeometry const &contact, Springs &springs)
{
    GrainGeometry g = contact;
    if (arms_ == Arms::contact) g.meet_in_the_middle();
    if (arms_ == Arms::granular) springs.sliding = turn_into_plane(springs.sliding, g.normal);
    Vector const spin =
        without_inertia(atom->rmass[i], ellipsoids_->form(i), vector(atom->angmom[i]));
    Vector const velocity =
        vector(atom->v[i]) + cross(spin, g.arm1) - motion_.velocity(vector(atom->x[i]) + g.arm2);
    Encounter const e{
        g.normal, g.depth, g.radius, masses_.of(i), g.curvatures, velocity, spin - motion_.spin(),
        timestep_};
    Reaction const reaction = law_.react(e, springs);
    fastest_ = std::max(fastest_, reaction.stiffness / e.mass);
    Vector const torque = cross(g.arm1, reaction.force) + reaction.couple;
    for (std::size_t k = 0; k < 3; ++k) {
        atom->f[i][k] += reaction.force[k];
        atom->torque[i][k] += torque[k];
    }
    energy_ += reaction.energy;
    double const heat = heat_ ? conduct(i, g) : 0.0;
    add_load(i, g, reaction);
    if (keeps_touches_)
        touches_.push_back({i, g.arm1, g.normal, reaction.force, g.depth, springs.sliding, heat});
}

/// Adds the heat that flows from the wall into a grain, and returns it.
double FixWall::conduct(int i, GrainGeometry const &contact)
{
    double const conductance = law_.conductance(contact),
                 flow = conductance * (present_temperature_ - heat_->temperature(i));
    heat_->add(i, flow, conductance);
    load_.heat -= flow;
    return flow;
}

/// Adds what a grain does to the wall, at the point where the force acts on the grain.
void FixWall::add_load(int i, GrainGeometry const &contact, Reaction const &reaction)
{
    Vector const arm = vector(atom->x[i]) + contact.arm1 - motion_.pivot();
    load_.force = load_.force - reaction.force;
    load_.torque = load_.torque - cross(arm, reaction.force) - reaction.couple;
    load_.num_contacts += 1.0;
    if (loads_.empty()) return;
    for (std::size_t k = 0; k < 3; ++k)
        loads_[3 * static_cast<std::size_t>(contact.triangle) + k] -= reaction.force[k];
}

FixWall::Load const &FixWall::total_load()
{
    if (step_of_total_ == update->ntimestep) return total_load_;
    step_of_total_ = update->ntimestep;
    std::array<double, 8> sum{load_.force[0],  load_.force[1],  load_.force[2],     load_.torque[0],
                              load_.torque[1], load_.torque[2], load_.num_contacts, load_.heat};
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), static_cast<int>(sum.size()), MPI_DOUBLE, MPI_SUM,
                  world);
    total_load_ = {vector(sum.data()), vector(&sum[3]), sum[6], sum[7]};
    return total_load_;
}

double FixWall::compute_vector(int k)
{
    Load const &load = total_load();
    auto const at = static_cast<std::size_t>(k);
    if (k < 3) return load.force[at];
    if (k < 6) return load.torque[at - 3];
    if (k == 6) return load.num_contacts;
    if (k == 13) return load.heat;
    return k < 10 ? motion_.shift()[at - 7] : motion_.speed()[at - 10];
}

/// Collects the loads of all triangles on the first processor.
void FixWall::tabulate_loads()
{
    int const count = static_cast<int>(loads_.size());
    std::vector<double> sum(loads_.size());
    MPI_Reduce(loads_.data(), sum.data(), count, MPI_DOUBLE, MPI_SUM, 0, world);
    load_rows_.clear();
    for (int t = 0; comm->me == 0 && t < surface_->num_triangles(); ++t) {
        LoadRow row{static_cast<double>(t + 1)};
        auto end = row.begin() + 1;
        auto corners = surface_->corners(t);
        for (Vector &corner : corners) {
            corner = motion_.to_space(corner);
            end = std::copy(corner.begin(), corner.end(), end);
        }
        Vector const push = vector(&sum[3 * static_cast<std::size_t>(t)]);
        // twice as long as the area
        Vector const normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        double const area2 = dot(normal, normal), along = dot(push, normal);
        end = std::copy(push.begin(), push.end(), end);
        *end++ = 2.0 * along / area2;
        *end = 2.0 * std::sqrt(std::max(0.0, dot(push, push) - along * along / area2) / area2);
        load_rows_.add(row);
    }
    load_rows_.publish(*this);
}

double FixWall::compute_scalar()
{
    double sum = 0.0;
    MPI_Allreduce(&energy_, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
}

// A restart file stores the time of the motion of the wall, and the state of a servo. All
// processors call this before LAMMPS asks for the sizes of the atoms.
void FixWall::write_restart(FILE *file)
{
    find_maxexchange();
    if (comm->me != 0) return;
    State const state{state_marker, clock_, motion_.servo_state()};
    int const size = sizeof(state);
    std::fwrite(&size, sizeof(size), 1, file);
    std::fwrite(&state, sizeof(state), 1, file);
}

void FixWall::restart(char *buffer)
{
    State state;
    std::memcpy(&state.marker, buffer, sizeof(state.marker));
    if (state.marker != state_marker) { // a file of version 3.0.0, which has the clock alone
        std::memcpy(&clock_, buffer, sizeof(clock_));
        return;
    }
    std::memcpy(&state, buffer, sizeof(state));
    clock_ = state.clock;
    if (motion_.is_servo()) motion_.set_servo_state(state.servo);
}

int FixWall::pack_exchange(int i, double *buffer)
{
    double *end = buffer;
    *end++ = static_cast<double>(contacts(i).size());
    for (Contact const &contact : contacts(i)) {
        end = std::copy(contact.normal.begin(), contact.normal.end(), end);
        end = contact.springs.write(end);
    }
    return static_cast<int>(end - buffer);
}

int FixWall::unpack_exchange(int i, double *buffer)
{
    contacts(i).resize(static_cast<std::size_t>(buffer[0]));
    double const *next = buffer + 1;
    for (Contact &contact : contacts(i)) {
        contact = {vector(next), Springs::read(next + 3)};
        next += contact_size;
    }
    return static_cast<int>(next - buffer);
}

int FixWall::pack_restart(int i, double *buffer)
{
    buffer[0] = size_restart(i);
    return 1 + pack_exchange(i, buffer + 1);
}

void FixWall::unpack_restart(int i, int which)
{
    double *numbers = atom->extra[i];
    for (int k = 0; k < which; ++k) numbers += static_cast<int>(numbers[0]);
    std::vector<double> all = restarted_contacts(numbers, 1, contact_size);
    unpack_exchange(i, all.data());
}

double FixWall::memory_usage()
{
    double sum = ellipsoids_->bytes() + load_rows_.bytes() +
                 static_cast<double>(contacts_.capacity() * sizeof(contacts_[0]));
    for (auto const &row : contacts_) sum += static_cast<double>(row.capacity() * sizeof(Contact));
    return sum;
}

} // namespace pw85_lammps
