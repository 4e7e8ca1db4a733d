// SPDX-License-Identifier: GPL-2.0-only
// pair_style pw85/contact: it tests all pairs for overlap, then computes the derivatives of those
// that overlap.
#include "pair_contact.hpp"

#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_systems.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace pw85_lammps {

PairContact::PairContact(LAMMPS *lammps) : Pair(lammps)
{
    restartinfo = 0;
    // if cutoffs cover every contact of like types, their means cover those of unlike types
    mix_flag = ARITHMETIC;
    single_extra = static_cast<int>(single_.size());
    svector = single_.data();
    comm_forward = Ellipsoids::comm_size;
    for (auto *const rows : {&d_r12_, &d_rot1_, &d_rot2_}) rows->resize(3 * PairBatch::capacity);
}

PairContact::~PairContact()
{
    if (!allocated) return;
    memory->destroy(setflag);
    memory->destroy(cutsq);
    memory->destroy(epsilon_);
    memory->destroy(cut_);
}

void PairContact::allocate()
{
    allocated = 1;
    int const n = atom->ntypes + 1;
    memory->create(setflag, n, n, "pair:setflag");
    memory->create(cutsq, n, n, "pair:cutsq");
    memory->create(epsilon_, n, n, "pair:epsilon");
    memory->create(cut_, n, n, "pair:cut");
    std::fill_n(setflag[0], n * n, 0);
    std::fill_n(epsilon_[0], n * n, 0.0);
    std::fill_n(cut_[0], n * n, 0.0);
}

void PairContact::settings(int narg, char **arg)
{
    if (narg < 1 || narg > 2)
        stop_all(*error,
                 "Illegal pair_style command: use pair_style pw85/contact cutoff [exponent]");
    cutoff_ = utils::numeric(FLERR, arg[0], false, lmp);
    exponent_ = narg == 2 ? utils::numeric(FLERR, arg[1], false, lmp) : 2.0;
    require_positive(cutoff_);
    if (!(exponent_ >= 2.0 && std::isfinite(exponent_)))
        stop_all(*error, "Pair pw85/contact: the exponent must be 2 or more");
    if (!allocated) return;
    for (int i = 1; i <= atom->ntypes; ++i)
        for (int j = i; j <= atom->ntypes; ++j)
            if (setflag[i][j]) cut_[i][j] = cutoff_;
}

void PairContact::coeff(int narg, char **arg)
{
    if (narg < 3 || narg > 4)
        stop_all(
            *error,
            "Illegal pair_coeff command: pw85/contact takes epsilon and, optionally, a cutoff");
    if (!allocated) allocate();
    int ilo, ihi, jlo, jhi;
    utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
    utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
    double const epsilon = utils::numeric(FLERR, arg[2], false, lmp);
    double const cut = narg == 4 ? utils::numeric(FLERR, arg[3], false, lmp) : cutoff_;
    if (!std::isfinite(epsilon)) stop_all(*error, "Pair pw85/contact: epsilon must be finite");
    require_positive(cut);
    int count = 0;
    for (int i = ilo; i <= ihi; ++i) {
        for (int j = std::max(jlo, i); j <= jhi; ++j, ++count) {
            epsilon_[i][j] = epsilon;
            cut_[i][j] = cut;
            setflag[i][j] = 1;
        }
    }
    if (count == 0) stop_all(*error, "Incorrect args for pair coefficients");
}

void PairContact::require_positive(double cutoff) const
{
    if (!(cutoff > 0.0 && std::isfinite(cutoff)))
        stop_all(*error, "Pair pw85/contact: the cutoff must be positive and finite");
}

void PairContact::init_style()
{
    ellipsoids_.emplace(lmp, "Pair pw85/contact",
                        "give its type to another style of pair_style hybrid");
    std::fill_n(cutsq[0], (atom->ntypes + 1) * (atom->ntypes + 1), 0.0);
    used_types_.assign(static_cast<std::size_t>(atom->ntypes) + 1, false);
    Pair::init_style();
}

// Within pair_style hybrid, LAMMPS calls this only for the types on which the style acts. Other
// types need no shapes.
double PairContact::init_one(int i, int j)
{
    used_types_[static_cast<std::size_t>(i)] = used_types_[static_cast<std::size_t>(j)] = true;
    if (setflag[i][j] == 0) {
        if (epsilon_[i][i] < 0.0 || epsilon_[j][j] < 0.0)
            stop_all(*error,
                     "Pair pw85/contact: a negative epsilon cannot be mixed: add pair_coeff " +
                         std::to_string(i) + " " + std::to_string(j));
        epsilon_[i][j] = mix_energy(epsilon_[i][i], epsilon_[j][j], 1.0, 1.0);
        cut_[i][j] = mix_distance(cut_[i][i], cut_[j][j]);
    }
    epsilon_[j][i] = epsilon_[i][j];
    return cut_[i][j];
}

// fix adapt calls this after it has changed epsilon.
void PairContact::reinit()
{
    for (int i = 1; i <= atom->ntypes; ++i)
        for (int j = i; j <= atom->ntypes; ++j)
            if (cutsq[i][j] > 0.0) init_one(i, j);
}

void *PairContact::extract(char const *name, int &dimension)
{
    dimension = 2;
    return std::strcmp(name, "epsilon") == 0 ? epsilon_ : nullptr;
}

void PairContact::compute(int eflag, int vflag)
{
    ev_init(eflag, vflag);
    ellipsoids_->read(
        [this](int i) { return used_types_[static_cast<std::size_t>(atom->type[i])]; });
    ellipsoids_->for_each_reach([this](int t, int u, double reach) {
        if (cutsq[t][u] > 0.0) ellipsoids_->require_cutoff(t, u, std::sqrt(cutsq[t][u]), reach);
    });
    forward_to_ghosts(*comm, this);
    batch_.run(*list, ellipsoids_->reach(1.0), [this, eflag] { add_batch(eflag); });
    if (vflag_fdotr) virial_fdotr_compute();
}

void PairContact::add_batch(int eflag)
{
    pw85_system const system = ellipsoids_->system();
    auto const refuse = [this](int i, int j) { ellipsoids_->refuse_pair(i, j); };
    pw85_pair_list const pairs = batch_.keep_overlaps(system, refuse);
    pw85_contact_derivatives_pairs(&pairs, &system, batch_.mu2.data(), batch_.lambda.data(),
                                   nullptr, nullptr, d_r12_.data(), d_rot1_.data(), d_rot2_.data());
    for (std::size_t k = 0; k < pairs.num_pairs; ++k) add_pair(k, eflag);
}

/// Adds the energy, forces and torques of pair k of the batch.
void PairContact::add_pair(std::size_t k, int eflag)
{
    int const i = batch_.pairs[2 * k], j = batch_.pairs[2 * k + 1];
    double const strength =
        force->special_lj[batch_.special[k]] * epsilon_[atom->type[i]][atom->type[j]];
    Action const action =
        act(batch_.mu2[k], {&d_r12_[3 * k], &d_rot1_[3 * k], &d_rot2_[3 * k]}, strength);
    apply(i, j, action);
    double const *a = atom->x[i], *b = atom->x[j];
    if (evflag)
        ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, eflag ? action.energy : 0.0, 0.0,
                     action.force[0], action.force[1], action.force[2], a[0] - b[0], a[1] - b[1],
                     a[2] - b[2]);
}

// With dU/dμ² = -ε (1 - μ)^(α-1) / (2μ): the force on the first is -∂U/∂x1 = U' ∂μ²/∂r12, the
// torques are -U' ∂μ²/∂ω. Concentric ellipsoids (μ = 0) are at a maximum of the energy, where it is
// not differentiable: their force and torques are zero. The μ² of ellipsoids that overlap may round
// to more than one.
PairContact::Action PairContact::act(double mu2, Derivatives const &d, double strength) const
{
    double const mu = std::min(std::sqrt(mu2), 1.0);
    double const slope =
        strength * (exponent_ == 2.0 ? 1.0 - mu : std::pow(1.0 - mu, exponent_ - 1.0));
    Action action{slope * (1.0 - mu) / exponent_, {}, {}, {}};
    if (!(mu2 > 0.0)) return action;
    double const derivative = -slope / (2.0 * mu);
    for (int k = 0; k < 3; ++k) {
        action.force[k] = derivative * d.r12[k];
        action.torque1[k] = -derivative * d.rot1[k];
        action.torque2[k] = -derivative * d.rot2[k];
    }
    return action;
}

double PairContact::single(int i, int j, int itype, int jtype, double rsq, double, double factor,
                           double &fforce)
{
    if (!is_in_place(i, j, rsq))
        stop_one(*error,
                 "Pair pw85/contact has the energy of a pair only for the positions and "
                 "orientations that the two "
                 "atoms had when forces were last computed: use the energy of the system instead");
    double const *a = atom->x[i], *b = atom->x[j];
    double const r12[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    double mu2, d_r12[3], d_rot1[3], d_rot2[3];
    int const status =
        pw85_contact_derivatives_batch(1, r12, ellipsoids_->form(i), ellipsoids_->form(j), &mu2,
                                       nullptr, nullptr, nullptr, d_r12, d_rot1, d_rot2);
    if (status != PW85_SUCCESS) ellipsoids_->refuse_pair(i, j);
    Action action{};
    if (mu2 < 1.0) action = act(mu2, {d_r12, d_rot1, d_rot2}, factor * epsilon_[itype][jtype]);
    double const *const f = action.force;
    fforce = rsq > 0.0 ? -(f[0] * r12[0] + f[1] * r12[1] + f[2] * r12[2]) / rsq : 0.0;
    single_ = {mu2, f[0], f[1], f[2]};
    return action.energy;
}

// Some callers of single() pass a distance that is not that of the atoms.
bool PairContact::is_in_place(int i, int j, double rsq) const
{
    int const count = atom->nlocal + atom->nghost;
    if (i < 0 || j < 0 || i >= count || j >= count || !ellipsoids_ || !ellipsoids_->has(i) ||
        !ellipsoids_->has(j))
        return false;
    double const *a = atom->x[i], *b = atom->x[j];
    double const dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
    return std::abs(dx * dx + dy * dy + dz * dz - rsq) <= Ellipsoids::margin * rsq;
}

void PairContact::apply(int i, int j, Action const &action)
{
    bool const both = force->newton_pair || j < atom->nlocal;
    for (int k = 0; k < 3; ++k) {
        atom->f[i][k] += action.force[k];
        atom->torque[i][k] += action.torque1[k];
        if (!both) continue;
        atom->f[j][k] -= action.force[k];
        atom->torque[j][k] += action.torque2[k];
    }
}

int PairContact::pack_forward_comm(int count, int *atoms, double *buffer, int, int *)
{
    return ellipsoids_->pack(count, atoms, buffer);
}

void PairContact::unpack_forward_comm(int count, int first, double *buffer)
{
    ellipsoids_->unpack(count, first, buffer);
}

double PairContact::memory_usage()
{
    return Pair::memory_usage() + (ellipsoids_ ? ellipsoids_->bytes() : 0.0);
}

} // namespace pw85_lammps
