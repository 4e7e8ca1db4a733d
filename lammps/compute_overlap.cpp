// SPDX-License-Identifier: GPL-2.0-only
// compute pw85/overlap: it tests the pairs of each batch, and counts the overlaps.
#include "compute_overlap.hpp"

#include <pw85_systems.h>

using namespace LAMMPS_NS;

namespace pw85_lammps {

ComputeOverlap::ComputeOverlap(LAMMPS *lammps, int narg, char **arg)
    : ComputePairs(lammps, narg, arg)
{
    if (narg != 3) stop_all(*error, "Illegal compute pw85/overlap command: it takes no arguments");
    scalar_flag = 1;
    // LAMMPS must not divide the number of pairs by the number of atoms in thermodynamic output
    extscalar = 0;
}

double ComputeOverlap::compute_scalar()
{
    if (!is_current(INVOKED_PERATOM, invoked_peratom)) compute_peratom();
    invoked_scalar = update->ntimestep;
    bigint halves = 0;
    MPI_Allreduce(&halves_, &halves, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    scalar = static_cast<double>(halves / 2);
    return scalar;
}

void ComputeOverlap::compute_peratom()
{
    invoked_peratom = update->ntimestep;
    invoked_flag |= INVOKED_PERATOM;
    begin(Needed::contacts, 1.0, 0.0);
    halves_ = 0;
    batch.run(neighbours.get(), ellipsoids.reach(1.0), [this] { count(); });
    end();
}

void ComputeOverlap::count()
{
    pw85_pair_list const list = batch.list();
    pw85_system const system = ellipsoids.system();
    pw85_overlap_pairs(&list, &system, batch.overlaps.data());
    int const counted = num_counted();
    for (std::size_t k = 0; k < batch.size(); ++k) {
        if (batch.overlaps[k] == 0) continue;
        int const i = batch.pairs[2 * k], j = batch.pairs[2 * k + 1];
        if (batch.overlaps[k] != 1) ellipsoids.refuse_pair(i, j);
        value(i) += 1.0;
        halves_ += 1;
        if (j >= counted) continue;
        value(j) += 1.0;
        halves_ += 1;
    }
}

} // namespace pw85_lammps
