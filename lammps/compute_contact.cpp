// SPDX-License-Identifier: GPL-2.0-only
// compute pw85/contact: it computes the contact function of each pair, and reports each contact
// once.
#include "compute_contact.hpp"

#include <pw85.h>
#include <pw85_systems.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

using namespace LAMMPS_NS;

namespace pw85_lammps {

ComputeContact::ComputeContact(LAMMPS *lammps, int narg, char **arg)
    : ComputePairs(lammps, narg, arg), below_(std::numeric_limits<double>::infinity())
{
    if (narg != 3 && (narg != 5 || std::strcmp(arg[3], "below") != 0))
        stop_all(
            *error,
            "Illegal compute pw85/contact command: the only keyword is below, with a value of mu2");
    if (narg == 5) below_ = utils::numeric(FLERR, arg[4], false, lmp);
    if (!(below_ > 0.0))
        stop_all(*error, "Compute pw85/contact: the value of below must be positive");
    if (!atom->tag_enable)
        stop_all(*error, "Compute pw85/contact needs atom IDs: remove atom_modify id no");
    scalar_flag = 1;
    // LAMMPS must not divide the number of pairs by the number of atoms in thermodynamic output
    extscalar = 0;
    local_flag = 1;
    size_local_cols = row_size;
}

double ComputeContact::merge(double value, double from_ghost) const
{
    return std::min(value, from_ghost);
}

double ComputeContact::compute_scalar()
{
    if (!is_current(INVOKED_PERATOM, invoked_peratom)) compute_peratom();
    invoked_scalar = update->ntimestep;
    bigint count = 0;
    MPI_Allreduce(&count_, &count, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    scalar = static_cast<double>(count);
    return scalar;
}

void ComputeContact::compute_local()
{
    invoked_local = invoked_peratom = update->ntimestep;
    invoked_flag |= INVOKED_LOCAL | INVOKED_PERATOM;
    evaluate(true);
    rows_.publish(*this);
}

// Points and normals cost as much as everything else, so they are computed only on request.
void ComputeContact::compute_peratom()
{
    if (is_current(INVOKED_LOCAL, invoked_local)) return;
    invoked_peratom = update->ntimestep;
    invoked_flag |= INVOKED_PERATOM;
    evaluate(false);
}

void ComputeContact::evaluate(bool with_rows)
{
    bool const bounded = std::isfinite(below_);
    begin(bounded ? Needed::contacts : Needed::all_within_cutoff, bounded ? std::sqrt(below_) : 1.0,
          std::numeric_limits<double>::infinity());
    rows_.clear();
    count_ = 0;
    auto const use = [this, with_rows] { add_batch(with_rows); };
    if (bounded) {
        batch.run(neighbours.get(), ellipsoids.reach(below_), use);
    } else {
        // The cutoff of the pair style selects the pairs: results do not depend on the skin.
        double const *const x = atom->x[0];
        int const *const type = atom->type;
        auto const within_cutoff = [this, x, type](int i, int j) {
            double const *a = x + 3 * static_cast<std::ptrdiff_t>(i),
                         *b = x + 3 * static_cast<std::ptrdiff_t>(j);
            double const dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2];
            bool const near = dx * dx + dy * dy + dz * dz < cutoffs.square(type[i], type[j]);
            bool const first = ellipsoids.selected(i), second = ellipsoids.selected(j);
            return near & first & second;
        };
        batch.run(neighbours.get(), within_cutoff, use);
    }
    end();
}

void ComputeContact::add_batch(bool with_rows)
{
    // Each pair is ordered by tags: all processors compute the same result from the same positions.
    for (std::size_t k = 0; k < batch.size(); ++k) {
        std::int32_t &i = batch.pairs[2 * k], &j = batch.pairs[2 * k + 1];
        if (atom->tag[i] > atom->tag[j]) std::swap(i, j);
    }
    pw85_pair_list const list = batch.list();
    pw85_system const system = ellipsoids.system();
    pw85_contact_pairs(&list, &system, batch.mu2.data(), batch.lambda.data());
    int const counted = num_counted();
    for (std::size_t k = 0; k < batch.size(); ++k) {
        int const i = batch.pairs[2 * k], j = batch.pairs[2 * k + 1];
        double const mu2 = batch.mu2[k];
        if (std::isnan(mu2)) ellipsoids.refuse_pair(i, j);
        if (!(mu2 < below_)) continue;
        value(i) = std::min(value(i), mu2);
        value(j) = std::min(value(j), mu2);
        if (std::max(i, j) >= counted && !belongs_here(*atom, i, j)) continue;
        count_ += 1;
        if (with_rows) add_row(i, j, mu2, batch.lambda[k]);
    }
}

void ComputeContact::add_row(int i, int j, double mu2, double lambda)
{
    double const *a = atom->x[i], *b = atom->x[j];
    double const r12[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    double point[3], normal[3];
    int const status =
        pw85_contact_geometry(r12, ellipsoids.form(i), ellipsoids.form(j), lambda, point, normal);
    // Concentric ellipsoids, scaled by zero, touch at their common centre and have no normal.
    if (status != PW85_SUCCESS) std::fill_n(point, 3, 0.0), std::fill_n(normal, 3, 0.0);
    rows_.add({static_cast<double>(atom->tag[i]), static_cast<double>(atom->tag[j]), mu2,
               a[0] + point[0], a[1] + point[1], a[2] + point[2], normal[0], normal[1], normal[2]});
}

double ComputeContact::memory_usage() { return ComputePairs::memory_usage() + rows_.bytes(); }

} // namespace pw85_lammps
