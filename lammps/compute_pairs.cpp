// SPDX-License-Identifier: GPL-2.0-only
// Prepares ellipsoids and neighbour lists for the computes, and checks that the lists miss no pair.
#include "compute_pairs.hpp"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace pw85_lammps {

ComputePairs::ComputePairs(LAMMPS *lammps, int narg, char **arg)
    : Compute(lammps, narg, arg),
      ellipsoids(lammps, std::string("Compute ") + arg[2], "leave it out of the group"),
      neighbours(lammps), record_id_(std::string("PW85_BUILD_") + arg[0])
{
    BuildRecord::add(*modify, record_id_);
    peratom_flag = 1;
    size_peratom_cols = 0;
    comm_forward = Ellipsoids::comm_size;
    comm_reverse = 1;
}

ComputePairs::~ComputePairs()
{
    // When LAMMPS ends, it removes fixes before computes.
    if (modify->find_fix(record_id_) >= 0) modify->delete_fix(record_id_);
}

void ComputePairs::init()
{
    if (!force->pair)
        stop_all(
            *error,
            std::string("Compute ") + style +
                " uses the cutoff and the neighbour list of a pair style: define one, for instance "
                "pair_style zero 4.0 and pair_coeff * *, with a cutoff that reaches every contact");
    cutoffs.assign(force->pair->cutsq, atom->ntypes);
    neighbours.request();
    ellipsoids.forget();
    warned_ = false;
}

void ComputePairs::begin(Needed needed, double scale, double initial_value)
{
    if (!neighbours.built())
        stop_all(*error, std::string("Compute ") + style +
                             " was asked for a value before a run: use run 0 first");
    Movement const movement = movement_since_build();
    if (!std::isfinite(movement.displacement))
        stop_all(*error,
                 std::string("Compute ") + style +
                     ": atoms were added, removed or sent to other processors " +
                     "since the neighbour lists were built: use run 0 first, without pre no");
    // Fixes that move atoms or the box at the end of a step do not move the ghosts.
    comm->forward_comm();
    ellipsoids.read([this](int i) { return (atom->mask[i] & groupbit) != 0; });
    check_reach(needed, scale, movement);
    forward_to_ghosts(*comm, this);
    if (values_.size() < static_cast<std::size_t>(atom->nmax))
        values_.resize(static_cast<std::size_t>(atom->nmax));
    std::fill_n(values_.begin(), atom->nlocal + atom->nghost, initial_value);
    vector_atom = values_.data();
}

Movement ComputePairs::movement_since_build() const
{
    int const record = modify->find_fix(record_id_);
    if (record < 0)
        stop_all(*error, "Fix " + record_id_ + " is missing, which compute " + id +
                             " needs: define the compute again");
    return static_cast<BuildRecord *>(modify->fix[record])->movement();
}

// A list has the pairs that were closer than cutoff plus skin when it was built. Fixes may move
// atoms at the end of a step, after LAMMPS has decided whether to rebuild the list.
void ComputePairs::check_reach(Needed needed, double scale, Movement const &movement)
{
    bool complete = true;
    ellipsoids.for_each_reach([&](int t, int u, double reach) {
        double const cutoff = std::sqrt(cutoffs.square(t, u)),
                     listed = std::sqrt(neighbor->cutneighsq[t][u]);
        double const distance = scale * reach;
        ellipsoids.require_cutoff(t, u, cutoff, distance);
        double const closest = movement.closest(listed) * (1.0 + Ellipsoids::margin);
        complete &= closest >= (needed == Needed::contacts ? distance : cutoff);
    });
    if (complete || warned_) return;
    warned_ = true;
    if (comm->me == 0)
        error->warning(FLERR, std::string("Compute ") + style +
                                  " may miss pairs: atoms and box have moved further since " +
                                  "the neighbour lists were built than the skin allows. Use a "
                                  "larger skin (neighbor), " +
                                  "neigh_modify delay 0, or smaller changes of the box");
}

bool ComputePairs::is_current(int kind, bigint step) const
{
    return (invoked_flag & kind) && step == update->ntimestep;
}

void ComputePairs::end()
{
    if (force->newton_pair) reverse_to_owners(*comm, this);
}

int ComputePairs::pack_forward_comm(int count, int *atoms, double *buffer, int, int *)
{
    return ellipsoids.pack(count, atoms, buffer);
}

void ComputePairs::unpack_forward_comm(int count, int first, double *buffer)
{
    ellipsoids.unpack(count, first, buffer);
}

int ComputePairs::pack_reverse_comm(int count, int first, double *buffer)
{
    std::copy_n(&value(first), count, buffer);
    return count;
}

void ComputePairs::unpack_reverse_comm(int count, int *atoms, double *buffer)
{
    for (int k = 0; k < count; ++k) value(atoms[k]) = merge(value(atoms[k]), buffer[k]);
}

double ComputePairs::memory_usage()
{
    return ellipsoids.bytes() + static_cast<double>(values_.capacity() * sizeof(double));
}

} // namespace pw85_lammps
