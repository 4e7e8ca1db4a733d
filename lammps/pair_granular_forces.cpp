// SPDX-License-Identifier: GPL-2.0-only
// The forces of pair_style pw85/granular: it finds the overlapping pairs, the geometry of their
// contacts, and the forces by the laws.
#include "pair_granular.hpp"

#include <pw85.h>
#include <pw85_systems.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// The cosine of the largest angle by which a normal may turn in a step of a run. A normal that
/// turns further may belong to another minimum of the depth.
constexpr double least_cosine = 0.97;

} // namespace

void PairGranular::compute(int eflag, int vflag)
{
    ev_init(eflag, vflag);
    ellipsoids_->read(
        [this](int i) { return used_types_[static_cast<std::size_t>(atom->type[i])]; });
    ellipsoids_->for_each_reach([this](int t, int u, double reach) {
        if (used_types_[static_cast<std::size_t>(t)] && used_types_[static_cast<std::size_t>(u)])
            ellipsoids_->require_cutoff(t, u, std::sqrt(cutsq[t][u]), reach + largest_gap(t, u));
    });
    forward_to_ghosts(*comm, this);
    if (masses_.are_new()) read_masses();
    read_bodies();
    timestep_ = update->setupflag ? 0.0 : update->dt;
    fastest_ = 0.0;
    touches_.clear();
    if (keeps_touches_) step_of_touches_ = update->ntimestep;
    history_->start_step(*list, turns_);
    batch_.run(*list, ellipsoids_->reach(1.0, largest_gap_), [this, eflag] { add_batch(eflag); });
    history_->finish_step();
    time_step_check_.finish_step(*lmp, limit_of_contacts(fastest_, *force), timestep_,
                                 std::string(granular_style) + ": " + too_long_for_contacts);
    if (vflag_fdotr) virial_fdotr_compute();
}

void PairGranular::add_batch(int eflag)
{
    pw85_system const system = ellipsoids_->system();
    auto const refuse = [this](int i, int j) { ellipsoids_->refuse_pair(i, j); };
    // The depth says whether a contact of the step before is still there. With attraction, surfaces
    // may be apart in it.
    auto const holds = [this](std::uint32_t entry) { return history_->has(entry); };
    std::size_t const count = batch_.keep_overlaps(system, refuse, holds).num_pairs;
    for (first_ = 0; first_ < count; first_ += row_capacity)
        add_pairs(std::min(row_capacity, count - first_), eflag);
}

/// Adds the forces and torques of some pairs, from first_ on.
void PairGranular::add_pairs(std::size_t count, int eflag)
{
    sort_by_law(count);
    search_.clear();
    std::array<std::size_t, row_capacity> unknown;
    std::size_t num_unknown = 0;
    for (std::size_t l = 0; l < count; ++l) {
        add_row(l);
        if (!overlaps_[l].is_known) unknown[num_unknown++] = l;
    }
    if (num_unknown > 0) start_at_contact_function({unknown.data(), num_unknown});
    search_.solve();
    for (std::size_t l = 0; l < count; ++l)
        if (!is_certified(l)) search_anew(l);
    react(count);
    for (std::size_t k = 0; k < count; ++k) add_pair(rows_of_pairs_[k], eflag);
}

/// Assigns rows to the pairs in the order of their laws.
void PairGranular::sort_by_law(std::size_t count)
{
    std::array<std::size_t, row_capacity> keys; // the law, and the pair
    std::int32_t const *const pairs = &batch_.pairs[2 * first_];
    bool sorted = true;
    for (std::size_t k = 0; k < count; ++k) {
        auto const [t, u] = std::minmax(atom->type[pairs[2 * k]], atom->type[pairs[2 * k + 1]]);
        keys[k] = material_index(t, u) * row_capacity + k;
        sorted = sorted && (k == 0 || keys[k - 1] < keys[k]);
    }
    if (!sorted) std::sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t l = 0; l < count; ++l) {
        std::size_t const k = keys[l] % row_capacity;
        overlaps_[l].i = pairs[2 * k];
        overlaps_[l].j = pairs[2 * k + 1];
        overlaps_[l].entry = batch_.entries[first_ + k];
        overlaps_[l].law = keys[l] / row_capacity;
        rows_.share[l] = force->special_lj[batch_.special[first_ + k]];
        rows_of_pairs_[k] = l;
    }
}

/// Lets searches start from the normals of the contact function.
void PairGranular::start_at_contact_function(std::span<std::size_t const> rows)
{
    std::array<std::int32_t, 2 * row_capacity> indices;
    std::array<double, 3 * row_capacity> normals;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        indices[2 * n] = overlaps_[rows[n]].i;
        indices[2 * n + 1] = overlaps_[rows[n]].j;
    }
    pw85_system const system = ellipsoids_->system();
    pw85_pair_list const pairs{rows.size(), indices.data(), nullptr};
    pw85_contact_derivatives_pairs(&pairs, &system, nullptr, nullptr, nullptr, normals.data(),
                                   nullptr, nullptr, nullptr);
    for (std::size_t n = 0; n < rows.size(); ++n)
        search_.set_start(rows[n], vector(&normals[3 * n]));
}

/// Fills row l: the geometry of the pair, its springs in the step before, and the data of its
/// bodies that the law needs.
void PairGranular::add_row(std::size_t l)
{
    Overlap &pair = overlaps_[l];
    ContactHistory::Contact const *const before = history_->find(pair.entry);
    store(before ? before->sliding : Vector{}, rows_.sliding, l);
    if (turns_) {
        auto const turning = before ? history_->turning(*before) : ContactHistory::Turning{};
        store(turning.rolling, rows_.rolling, l);
        rows_.twisting[l] = turning.twisting;
    }
    pair.has_touched = before != nullptr;
    pair.is_known = before && !history_->is_from_before(*before);
    Body const &a = body(pair.i), &b = body(pair.j);
    search_.add(b.x - a.x, a.form, b.form, pair.is_known ? before->normal : Vector{});
    store(a.v - b.v, rows_.velocity, l);
    store(a.spin, rows_.spin1, l);
    store(b.spin, rows_.spin2, l);
    rows_.mass[l] = mass_of_contact(a.mass, b.mass);
}

/// Returns whether a contact is that of its pair. If the normal has turned far since the step
/// before, it may belong to another minimum.
bool PairGranular::is_certified(std::size_t l) const
{
    if (!overlaps_[l].is_known) return true;
    GrainSearch::Rows const &rows = search_.rows();
    return rows.depth[l] > least_depth(l) &&
           dot(load(rows.normal, l), search_.start(l)) >= least_cosine;
}

/// Returns the depth below which there is no contact in row l. It is negative if the surfaces
/// attract each other and have touched.
double PairGranular::least_depth(std::size_t l) const
{
    if (largest_gap_ == 0.0 || !overlaps_[l].has_touched) return 0.0;
    return -materials_[overlaps_[l].law].law.largest_gap(search_.rows().radius[l]);
}

/// Replaces the contact in row l by the one that is found from the normal of the contact function.
void PairGranular::search_anew(std::size_t l)
{
    start_at_contact_function({&l, 1});
    search_.search_again(l);
}

/// Computes the forces and torques of all rows, law by law.
void PairGranular::react(std::size_t count)
{
    for (std::size_t l = 0, end = 0; l < count; l = end) {
        while (end < count && overlaps_[end].law == overlaps_[l].law) ++end;
        materials_[overlaps_[l].law].law.react(search_.rows(), rows_, l, end - l, arms_, timestep_);
    }
}

/// Adds the force and torques of the pair in row l.
void PairGranular::add_pair(std::size_t l, int eflag)
{
    Overlap const &pair = overlaps_[l];
    double const depth = search_.rows().depth[l];
    if (rows_.share[l] == 0.0) return;
    if (std::isnan(depth)) refuse_depth(pair.i, pair.j);
    if (!(depth > least_depth(l))) return;
    history_->store(pair.entry, pair.i, pair.j,
                    {load(rows_.sliding, l), load(rows_.rolling, l), rows_.twisting[l]},
                    load(search_.rows().normal, l));
    fastest_ = std::max(fastest_, rows_.rate[l]);
    Vector f = load(rows_.force, l), torque1 = load(rows_.torque1, l),
           torque2 = load(rows_.torque2, l);
    if (materials_[pair.law].conserves) add_gradient(l, f, torque1, torque2);
    double const heat = heat_ ? conduct(l) : 0.0;
    if (keeps_touches_) keep_touch(l, f, heat);
    apply(pair.i, f, torque1);
    if (force->newton_pair || pair.j < atom->nlocal) apply(pair.j, -1.0 * f, torque2);
    if (!evflag) return;
    Vector const &r12 = search_.separation(l);
    ev_tally_xyz(pair.i, pair.j, atom->nlocal, force->newton_pair, eflag ? rows_.energy[l] : 0.0,
                 0.0, f[0], f[1], f[2], -r12[0], -r12[1], -r12[2]);
}

/// Adds the force and the torques that come from changes of the equivalent radius.
void PairGranular::add_gradient(std::size_t l, Vector &f, Vector &torque1, Vector &torque2) const
{
    Overlap const &pair = overlaps_[l];
    double const by_radius = rows_.by_radius[l];
    Vector const normal = load(search_.rows().normal, l);
    Vector d_r12, d_rotation1, d_rotation2;
    pw85_grain_radius_gradient(search_.separation(l).data(), body(pair.i).form.data(),
                               body(pair.j).form.data(), normal.data(), d_r12.data(),
                               d_rotation1.data(), d_rotation2.data());
    f = f + by_radius * d_r12;
    torque1 = torque1 - by_radius * d_rotation1;
    torque2 = torque2 - by_radius * d_rotation2;
}

/// Adds the heat that flows through the contact in row l, and returns it.
double PairGranular::conduct(std::size_t l)
{
    Overlap const &pair = overlaps_[l];
    ContactLaw const &law = materials_[pair.law].law;
    if (!law.conducts()) return 0.0;
    double const conductance = rows_.share[l] * law.conductance(search_.contact(l));
    double const flow = conductance * (heat_->temperature(pair.j) - heat_->temperature(pair.i));
    heat_->add(pair.i, flow, conductance);
    if (force->newton_pair || pair.j < atom->nlocal) heat_->add(pair.j, -flow, conductance);
    return flow;
}

void PairGranular::keep_touch(std::size_t l, Vector const &f, double heat)
{
    GrainGeometry g = search_.contact(l);
    if (arms_ != Arms::surface) g.meet_in_the_middle();
    touches_.push_back({overlaps_[l].i, overlaps_[l].j, g.arm1, g.normal, f, g.depth,
                        load(rows_.sliding, l), heat});
}

/// Reads the masses of owned atoms, and sends them to the ghosts.
void PairGranular::read_masses()
{
    masses_.read();
    sends_masses_ = true;
    forward_to_ghosts(*comm, this);
    sends_masses_ = false;
}

void PairGranular::read_bodies()
{
    bodies_.resize(static_cast<std::size_t>(atom->nlocal + atom->nghost));
    for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
        if (!ellipsoids_->selected(i)) continue;
        Body &body = bodies_[static_cast<std::size_t>(i)];
        double const *const q = ellipsoids_->form(i), mass = masses_.of(i);
        body.x = vector(atom->x[i]);
        body.v = vector(atom->v[i]);
        body.spin = without_inertia(atom->rmass[i], q, vector(atom->angmom[i]));
        std::memcpy(body.form.data(), q, sizeof body.form);
        body.mass = (atom->mask[i] & frozen_) != 0 ? -mass : mass;
    }
}

void PairGranular::apply(int i, Vector const &push, Vector const &torque)
{
    auto const at = 3 * static_cast<std::ptrdiff_t>(i);
    double *const f = atom->f[0] + at, *const t = atom->torque[0] + at;
    // Component by component: a loop would read pairs of numbers that were just written singly,
    // which stalls.
    f[0] += push[0];
    f[1] += push[1];
    f[2] += push[2];
    t[0] += torque[0];
    t[1] += torque[1];
    t[2] += torque[2];
}

void PairGranular::refuse_depth(int i, int j) const
{
    std::string const types =
        std::to_string(atom->type[i]) + " and " + std::to_string(atom->type[j]);
    ellipsoids_->refuse_pair(
        i, j,
        "(types " + types +
            ") overlap more than the law of force allows, so that their common normal is not "
            "unique: use a larger stiffness or a smaller time step, or remove overlaps before the "
            "run (fix pw85/fire)");
}

} // namespace pw85_lammps
