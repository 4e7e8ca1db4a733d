// SPDX-License-Identifier: GPL-2.0-only
// pair_style pw85/hard: one cutoff for all types, and no forces.
#include "pair_hard.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace pw85_lammps {

PairHard::PairHard(LAMMPS *lammps) : Pair(lammps)
{
    restartinfo = 0;
    single_enable = 0;
}

PairHard::~PairHard()
{
    if (!allocated) return;
    memory->destroy(setflag);
    memory->destroy(cutsq);
}

void PairHard::settings(int narg, char **arg)
{
    if (narg != 1) stop_all(*error, "Illegal pair_style command: use pair_style pw85/hard cutoff");
    cutoff_ = utils::numeric(FLERR, arg[0], false, lmp);
    if (!(cutoff_ > 0.0 && std::isfinite(cutoff_)))
        stop_all(*error, "Pair pw85/hard: the cutoff must be positive and finite");
}

void PairHard::coeff(int narg, char **arg)
{
    if (narg != 2 || std::strcmp(arg[0], "*") != 0 || std::strcmp(arg[1], "*") != 0)
        stop_all(*error,
                 "Illegal pair_coeff command: pw85/hard has no coefficients: use pair_coeff * *");
    int const n = atom->ntypes + 1;
    if (!allocated) {
        allocated = 1;
        memory->create(setflag, n, n, "pair:setflag");
        memory->create(cutsq, n, n, "pair:cutsq");
    }
    std::fill_n(setflag[0], n * n, 1);
    std::fill_n(cutsq[0], n * n, 0.0);
}

void PairHard::init_style()
{
    ellipsoids_.emplace(lmp, "Pair pw85/hard",
                        "give its type to another style of pair_style hybrid");
    used_types_.assign(static_cast<std::size_t>(atom->ntypes) + 1, false);
    std::fill_n(cutsq[0], (atom->ntypes + 1) * (atom->ntypes + 1), 0.0);
    checked_ = false;
    Pair::init_style();
}

double PairHard::init_one(int i, int j)
{
    used_types_[static_cast<std::size_t>(i)] = used_types_[static_cast<std::size_t>(j)] = true;
    return cutoff_;
}

void PairHard::compute(int eflag, int vflag)
{
    ev_init(eflag, vflag);
    if (checked_) return;
    checked_ = true;
    ellipsoids_->read(
        [this](int i) { return used_types_[static_cast<std::size_t>(atom->type[i])]; });
    ellipsoids_->for_each_reach([this](int t, int u, double reach) {
        if (cutsq[t][u] > 0.0) ellipsoids_->require_cutoff(t, u, std::sqrt(cutsq[t][u]), reach);
    });
}

double PairHard::memory_usage()
{
    return Pair::memory_usage() + (ellipsoids_ ? ellipsoids_->bytes() : 0.0);
}

} // namespace pw85_lammps
