// SPDX-License-Identifier: GPL-2.0-only
// pair_style pw85/granular: its commands, and what LAMMPS calls before a run.
// pair_granular_forces.cpp has the forces.
#include "pair_granular.hpp"

#include "fix_pour.hpp"

#include <algorithm>

using namespace LAMMPS_NS;

namespace pw85_lammps {

PairGranular::PairGranular(LAMMPS *lammps) : Pair(lammps), masses_(lammps)
{
    restartinfo = 0;
    single_enable = 0;
    comm_forward = Ellipsoids::comm_size;
}

PairGranular::~PairGranular()
{
    if (!history_id_.empty() && modify->find_fix(history_id_) >= 0) modify->delete_fix(history_id_);
    if (!allocated) return;
    memory->destroy(setflag);
    memory->destroy(cutsq);
}

void PairGranular::allocate()
{
    allocated = 1;
    int const n = atom->ntypes + 1;
    memory->create(setflag, n, n, "pair:setflag");
    memory->create(cutsq, n, n, "pair:cutsq");
    std::fill_n(setflag[0], n * n, 0);
    for (int i = 1; i < n; ++i)
        setflag[i][i] = 1; // LAMMPS's error would not name the type: init_one() looks for the law
    std::fill_n(cutsq[0], n * n, 0.0);
    materials_.assign(static_cast<std::size_t>(n * n), {});
}

std::size_t PairGranular::material_index(int t, int u) const
{
    return static_cast<std::size_t>(t * (atom->ntypes + 1) + u);
}

void PairGranular::settings(int narg, char **arg)
{
    cutoff_ = 0.0;
    arms_ = Arms::contact;
    int k = 0;
    if (narg > 0 && std::strcmp(arg[0], "arms") != 0) {
        cutoff_ = utils::numeric(FLERR, arg[k++], false, lmp);
        if (!(cutoff_ > 0.0 && std::isfinite(cutoff_)))
            stop_all(*error,
                     std::string(granular_style) + ": the cutoff must be positive and finite");
    }
    Words words(lmp, std::string(granular_style) + ": the pair_style command", narg - k, arg + k);
    while (words.skip("arms")) arms_ = parse_arms(words);
    if (!words.done())
        words.refuse("has too many words: use pair_style pw85/granular [cutoff] [arms "
                     "contact|surface|granular]");
    if (!history_) add_history();
    if (!allocated && domain->box_exist) allocate();
}

// The fix must exist before fixes that insert atoms, because it must store the contacts before they
// do.
void PairGranular::add_history()
{
    int k = 0;
    do history_id_ = "PW85_HISTORY_" + std::to_string(k++);
    while (modify->find_fix(history_id_) >= 0);
    history_ = ContactHistory::add(*modify, history_id_);
}

void PairGranular::coeff(int narg, char **arg)
{
    if (narg < 3)
        stop_all(*error,
                 "Illegal pair_coeff command: pw85/granular takes a law: hooke K ETA, hertz K ETA, "
                 "hertz/material E ETA NU, dmt E ETA NU GAMMA, or jkr E ETA NU GAMMA");
    if (!allocated) allocate();
    int ilo, ihi, jlo, jhi;
    utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
    utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
    bool const conserves = std::strcmp(arg[narg - 1], "conservative") == 0;
    ContactLaw const law = ContactLaw::parse(lmp, granular_style, narg - 2 - conserves, arg + 2);
    if (conserves && law.sticks())
        stop_all(*error,
                 std::string(granular_style) +
                     ": conservative is not offered with dmt, jkr and liquid: leave the word out");
    int count = 0;
    for (int i = ilo; i <= ihi; ++i) {
        for (int j = std::max(jlo, i); j <= jhi; ++j, ++count) {
            material(i, j) = material(j, i) = {law, conserves, true};
            setflag[i][j] = 1;
        }
    }
    if (count == 0) stop_all(*error, "Incorrect args for pair coefficients");
}

void PairGranular::init_style()
{
    if (!comm->ghost_velocity)
        stop_all(*error, std::string(granular_style) +
                             " needs velocities of ghosts: use comm_modify vel yes");
    if (!atom->tag_enable)
        stop_all(*error, std::string(granular_style) + " needs atom IDs: use atom_modify id yes");
    refuse_respa(*lmp, granular_style);
    if (modify->find_fix(history_id_) < 0)
        stop_all(
            *error,
            std::string(granular_style) + ": fix " + history_id_ +
                ", which keeps the contacts, is missing: do not unfix it, or repeat pair_style "
                "and pair_coeff");
    ellipsoids_.emplace(lmp, granular_style, "give its type to another style of pair_style hybrid");
    std::fill_n(cutsq[0], (atom->ntypes + 1) * (atom->ntypes + 1), 0.0);
    used_types_.assign(static_cast<std::size_t>(atom->ntypes) + 1, false);
    expect_new_grains();
    find_gaps();
    if (cutoff_ == 0.0) read_reaches();
    turns_ = false;
    heat_ = nullptr;
    frozen_ = 0;
    for (int k = 0; k < modify->nfix; ++k)
        if (std::strcmp(modify->fix[k]->style, "freeze") == 0) frozen_ |= modify->fix[k]->groupbit;
    masses_.start_run();
    time_step_check_.start_run();
    if (comm->me == 0 && nothing_moves())
        error->warning(FLERR, std::string(granular_style) +
                                  ": no fix moves the grains, so they stand still under their "
                                  "forces: add fix nve/asphere, or another fix that integrates");
    Pair::init_style();
}

/// Returns whether a run has steps, but no fix that integrates motions or temperatures. Snapshots
/// of a rerun need none.
bool PairGranular::nothing_moves() const
{
    constexpr int in_run = 1; // as LAMMPS numbers what it is doing
    if (update->whichflag != in_run || update->nsteps == 0 || is_rerun(*input)) return false;
    for (int k = 0; k < modify->nfix; ++k)
        if (modify->fix[k]->time_integrate || dynamic_cast<FixHeat const *>(modify->fix[k]))
            return false;
    return true;
}

/// Asks the fixes that insert grains during the run for their sizes.
void PairGranular::expect_new_grains()
{
    for (int k = 0; k < modify->nfix; ++k) {
        auto const *const pour = dynamic_cast<FixPour const *>(modify->fix[k]);
        if (!pour) continue;
        GrainMixture const &grains = pour->mixture();
        for (int t = 1; t <= atom->ntypes; ++t)
            ellipsoids_->expect(t, grains.largest_radius(t), grains.largest_curvature_radius(t));
    }
}

/// Finds how far apart surfaces of two types can be in a contact. The equivalent radius is at most
/// that of two spheres with the largest radii of curvature.
void PairGranular::find_gaps()
{
    gaps_.assign(materials_.size(), 0.0);
    largest_gap_ = 0.0;
    ellipsoids_->read([this](int i) { return atom->ellipsoid[i] >= 0; });
    std::vector<double> const radii = ellipsoids_->largest_curvature_radii();
    for (int t = 1; t <= atom->ntypes; ++t)
        for (int u = t; u <= atom->ntypes; ++u) {
            double const a = radii[static_cast<std::size_t>(t)],
                         b = radii[static_cast<std::size_t>(u)];
            if (a == 0.0 || b == 0.0) continue;
            // Without a pair_coeff command, the law of both is that of the run before.
            auto const mixed = setflag[t][u]
                                   ? material(t, u).law
                                   : ContactLaw::mixed(material(t, t).law, material(u, u).law)
                                         .value_or(ContactLaw());
            double const gap = mixed.largest_gap(a * b / (a + b));
            gaps_[material_index(t, u)] = gaps_[material_index(u, t)] = gap;
            largest_gap_ = std::max(largest_gap_, gap);
        }
}

/// Finds the largest distances at which ellipsoids of two types can touch; zero for types without
/// ellipsoids.
void PairGranular::read_reaches()
{
    auto const n = static_cast<std::size_t>(atom->ntypes) + 1;
    reaches_.assign(n * n, 0.0);
    ellipsoids_->read([this](int i) { return atom->ellipsoid[i] >= 0; });
    ellipsoids_->for_each_reach([this, n](int t, int u, double reach) {
        reaches_[static_cast<std::size_t>(t) * n + static_cast<std::size_t>(u)] =
            reach + largest_gap(t, u);
    });
}

// Within pair_style hybrid, LAMMPS calls this only for the types on which the style acts. Other
// types need no shapes and no laws.
double PairGranular::init_one(int i, int j)
{
    used_types_[static_cast<std::size_t>(i)] = used_types_[static_cast<std::size_t>(j)] = true;
    if (setflag[i][j] == 0) mix(i, j);
    if (!material(i, j).is_set) refuse_type(i);
    turns_ = turns_ || material(i, j).law.resists_turning();
    if (material(i, j).law.conducts()) heat_ = &FixHeat::require(*lmp, granular_style);
    if (cutoff_ > 0.0) return cutoff_;
    return reaches_[static_cast<std::size_t>(i * (atom->ntypes + 1) + j)];
}

/// Finds the law of two types from those of each.
void PairGranular::mix(int i, int j)
{
    for (int const t : {i, j})
        if (!material(t, t).is_set) refuse_type(t);
    auto const law = ContactLaw::mixed(material(i, i).law, material(j, j).law);
    if (!law)
        stop_all(*error, std::string(granular_style) + ": the laws of types " + std::to_string(i) +
                             " and " + std::to_string(j) +
                             " cannot be mixed, because their words differ: add pair_coeff " +
                             std::to_string(i) + " " + std::to_string(j));
    material(i, j) =
        material(j, i) = {*law, material(i, i).conserves && material(j, j).conserves, true};
}

void PairGranular::refuse_type(int t) const
{
    std::string const name = std::to_string(t);
    stop_all(*error, std::string(granular_style) + ": type " + name +
                         " has no law of force: add pair_coeff " + name + " " + name +
                         ", or pair_coeff * *");
}

int PairGranular::pack_forward_comm(int count, int *atoms, double *buffer, int, int *)
{
    return sends_masses_ ? masses_.pack(count, atoms, buffer)
                         : ellipsoids_->pack(count, atoms, buffer);
}

void PairGranular::unpack_forward_comm(int count, int first, double *buffer)
{
    sends_masses_ ? masses_.unpack(count, first, buffer)
                  : ellipsoids_->unpack(count, first, buffer);
}

double PairGranular::memory_usage()
{
    return Pair::memory_usage() + (ellipsoids_ ? ellipsoids_->bytes() : 0.0);
}

} // namespace pw85_lammps
