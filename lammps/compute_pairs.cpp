// SPDX-License-Identifier: GPL-2.0-only
#include "compute_pairs.hpp"

#include <algorithm>

using namespace LAMMPS_NS;

namespace pw85_lammps {

ComputePairs::ComputePairs(LAMMPS *lammps, int narg, char **arg)
    : Compute(lammps, narg, arg), ellipsoids(lammps, std::string("Compute ") + arg[2]), neighbours(lammps)
{
    peratom_flag = 1;
    size_peratom_cols = 0;
    comm_forward = Ellipsoids::comm_size;
    comm_reverse = 1;
}

void ComputePairs::init()
{
    if (!force->pair)
        stop_all(*error, std::string("Compute ") + style +
                             " uses the cutoff and the neighbour list of a pair style: define one, for instance "
                             "pair_style zero 4.0 and pair_coeff * *, with a cutoff that reaches every contact");
    neighbours.request();
    ellipsoids.forget();
    checked_ = false;
}

void ComputePairs::begin(double reach, double initial_value)
{
    if (!neighbours.built())
        stop_all(*error, std::string("Compute ") + style + " was asked for a value before a run: use run 0 first");
    // Fixes that move atoms or the box at the end of a step leave ghosts where they were.
    comm->forward_comm();
    ellipsoids.read([this](int i) { return (atom->mask[i] & groupbit) != 0; });
    // Shapes and types change between runs, or when atoms are added, which makes LAMMPS rebuild the lists.
    if (!checked_ || neighbor->ago == 0) ellipsoids.require_cutoff(reach);
    checked_ = true;
    forward_to_ghosts(*comm, this);
    if (values_.size() < static_cast<std::size_t>(atom->nmax)) values_.resize(static_cast<std::size_t>(atom->nmax));
    std::fill_n(values_.begin(), atom->nlocal + atom->nghost, initial_value);
    vector_atom = values_.data();
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
