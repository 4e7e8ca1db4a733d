// SPDX-License-Identifier: GPL-2.0-only
// compute pw85/grains: it reports the contacts that the pair style has found in the present step, each of them once.
#include "compute_grains.hpp"

#include "neighbours.hpp"

#include <algorithm>

using namespace LAMMPS_NS;

namespace pw85_lammps {

ComputeGrains::ComputeGrains(LAMMPS *lammps, int narg, char **arg) : Compute(lammps, narg, arg)
{
    if (narg != 3) stop_all(*error, "Illegal compute pw85/grains command: it takes no arguments");
    // LAMMPS must not divide the number of contacts by the number of atoms in thermodynamic output, nor the stresses.
    scalar_flag = vector_flag = local_flag = peratom_flag = 1;
    extscalar = extvector = 0;
    size_vector = static_cast<int>(stress_size);
    vector = new double[stress_size];
    size_local_cols = static_cast<int>(std::tuple_size_v<Row>);
    size_peratom_cols = 0;
    comm_reverse = 1;
}

void ComputeGrains::init()
{
    pair_ = dynamic_cast<PairGranular *>(force->pair_match("pw85/granular", 1));
    if (!pair_)
        stop_all(*error, "Compute pw85/grains reports the contacts of pair_style pw85/granular: use this pair style");
    pair_->keep_touches();
}

std::vector<PairGranular::Touch> const &ComputeGrains::touches() const
{
    if (!pair_ || pair_->step_of_touches() != update->ntimestep)
        stop_all(*error, "Compute pw85/grains was asked for contacts of a step without forces: use run 0 first");
    return pair_->touches();
}

/// Whether a contact is one of the group, and this processor reports it.
bool ComputeGrains::counts(PairGranular::Touch const &touch) const
{
    if (!(atom->mask[touch.i] & atom->mask[touch.j] & groupbit)) return false;
    return force->newton_pair || std::max(touch.i, touch.j) < atom->nlocal || belongs_here(*atom, touch.i, touch.j);
}

ComputeGrains::Row ComputeGrains::row(PairGranular::Touch const &touch) const
{
    bool const in_order = atom->tag[touch.i] <= atom->tag[touch.j];
    int const first = in_order ? touch.i : touch.j, second = in_order ? touch.j : touch.i;
    double const sign = in_order ? 1.0 : -1.0;
    Vector const normal = sign * touch.normal, push = sign * touch.force;
    Vector const r12 = pw85_lammps::vector(atom->x[second]) - pw85_lammps::vector(atom->x[first]);
    Vector const point = pw85_lammps::vector(atom->x[touch.i]) + touch.arm;
    Row row{static_cast<double>(atom->tag[first]), static_cast<double>(atom->tag[second])};
    auto end = std::copy(point.begin(), point.end(), row.begin() + 2);
    end = std::copy(normal.begin(), normal.end(), end);
    *end++ = touch.depth;
    end = std::copy(push.begin(), push.end(), end);
    for (double const r : r12)
        for (double const f : push) *end++ = -r * f;
    return row;
}

double ComputeGrains::compute_scalar()
{
    invoked_scalar = update->ntimestep;
    bigint const own = std::count_if(touches().begin(), touches().end(), [this](auto const &t) { return counts(t); });
    bigint count = 0;
    MPI_Allreduce(&own, &count, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    scalar = static_cast<double>(count);
    return scalar;
}

void ComputeGrains::compute_vector()
{
    invoked_vector = update->ntimestep;
    std::array<double, stress_size> own{};
    for (PairGranular::Touch const &touch : touches()) {
        if (!counts(touch)) continue;
        Row const r = row(touch);
        for (std::size_t k = 0; k < stress_size; ++k) own[k] += r[r.size() - stress_size + k];
    }
    MPI_Allreduce(own.data(), vector, static_cast<int>(stress_size), MPI_DOUBLE, MPI_SUM, world);
}

void ComputeGrains::compute_local()
{
    invoked_local = update->ntimestep;
    rows_.clear();
    for (PairGranular::Touch const &touch : touches())
        if (counts(touch)) rows_.push_back(row(touch));
    row_pointers_.resize(rows_.size());
    std::transform(rows_.begin(), rows_.end(), row_pointers_.begin(), [](Row &r) { return r.data(); });
    array_local = row_pointers_.data();
    size_local_rows = static_cast<int>(rows_.size());
}

// A contact that two processors know is counted by that one of them which reports it: ghosts bring the counts to their owners.
void ComputeGrains::compute_peratom()
{
    invoked_peratom = update->ntimestep;
    counts_.assign(static_cast<std::size_t>(atom->nmax), 0.0);
    for (PairGranular::Touch const &touch : touches())
        if (counts(touch))
            for (int const i : {touch.i, touch.j}) counts_[static_cast<std::size_t>(i)] += 1.0;
    reverse_to_owners(*comm, this);
    vector_atom = counts_.data();
}

int ComputeGrains::pack_reverse_comm(int count, int first, double *buffer)
{
    std::copy_n(&counts_[static_cast<std::size_t>(first)], count, buffer);
    return count;
}

void ComputeGrains::unpack_reverse_comm(int count, int *atoms, double *buffer)
{
    for (int k = 0; k < count; ++k) counts_[static_cast<std::size_t>(atoms[k])] += buffer[k];
}

double ComputeGrains::memory_usage()
{
    return static_cast<double>(rows_.capacity() * sizeof(Row) + row_pointers_.capacity() * sizeof(double *) +
                               counts_.capacity() * sizeof(double));
}

} // namespace pw85_lammps
