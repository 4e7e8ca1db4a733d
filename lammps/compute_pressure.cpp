// SPDX-License-Identifier: GPL-2.0-only
// compute pw85/pressure: it counts the pairs that nearly touch.
#include "compute_pressure.hpp"

#include <pw85_systems.h>

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace pw85_lammps {

ComputePressure::ComputePressure(LAMMPS *lammps, int narg, char **arg)
    : ComputePairs(lammps, narg, arg)
{
    if (narg > 4)
        stop_all(*error,
                 "Illegal compute pw85/pressure command: it takes one number, the width of ln mu");
    if (narg == 4) width_ = utils::numeric(FLERR, arg[3], false, lmp);
    if (!(width_ >= 1e-6 && width_ <= 0.1))
        stop_all(*error, "Compute pw85/pressure: the width of ln mu must be from 1e-6 to 0.1");
    if (igroup != 0) stop_all(*error, "Compute pw85/pressure needs the group all");
    if (domain->dimension != 3)
        stop_all(*error, "Compute pw85/pressure works in three dimensions: use dimension 3");
    if (!atom->tag_enable)
        stop_all(*error, "Compute pw85/pressure needs atom IDs: remove atom_modify id no");
    peratom_flag = 0;
    scalar_flag = vector_flag = 1;
    extscalar = extvector = 0;
    size_vector = 2;
    vector = new double[2];
}

double ComputePressure::compute_scalar()
{
    compute_vector();
    invoked_scalar = update->ntimestep;
    double const slope = (1.5 * vector[0] - 0.5 * vector[1]) / width_;
    double const volume = domain->xprd * domain->yprd * domain->zprd;
    scalar = (static_cast<double>(atom->natoms) + slope / 3.0) / volume;
    return scalar;
}

void ComputePressure::compute_vector()
{
    invoked_vector = update->ntimestep;
    if (domain->nonperiodic != 0)
        stop_all(*error, "Compute pw85/pressure does not see what walls carry: it needs a box that "
                         "is periodic in all directions");
    double const scale = std::exp(2.0 * width_);
    begin(Needed::contacts, scale, 0.0);
    counts_ = {};
    batch.run(neighbours.get(), ellipsoids.reach(scale * scale), [this] { add_batch(); });
    end();
    std::array<bigint, 2> counts{};
    MPI_Allreduce(counts_.data(), counts.data(), 2, MPI_LMP_BIGINT, MPI_SUM, world);
    for (std::size_t k = 0; k < 2; ++k) vector[k] = static_cast<double>(counts[k]);
}

void ComputePressure::add_batch()
{
    pw85_pair_list const list = batch.list();
    pw85_system const system = ellipsoids.system();
    pw85_contact_pairs(&list, &system, batch.mu2.data(), batch.lambda.data());
    int const counted = num_counted();
    for (std::size_t k = 0; k < batch.size(); ++k) {
        int const i = batch.pairs[2 * k], j = batch.pairs[2 * k + 1];
        if (std::isnan(batch.mu2[k])) ellipsoids.refuse_pair(i, j);
        double const range = 0.5 * std::log(batch.mu2[k]) / width_;
        if (!(range < 2.0)) continue;
        if (std::max(i, j) >= counted && !belongs_here(*atom, i, j)) continue;
        counts_[range < 1.0 ? 0 : 1] += 1;
    }
}

} // namespace pw85_lammps
