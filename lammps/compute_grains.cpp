// SPDX-License-Identifier: GPL-2.0-only
// compute pw85/grains: it reports the contacts that the pair style has found in the present step,
// each of them once.
#include "compute_grains.hpp"

#include "neighbours.hpp"

#include <algorithm>

using namespace LAMMPS_NS;

namespace pw85_lammps {

ComputeGrains::ComputeGrains(LAMMPS *lammps, int narg, char **arg) : Compute(lammps, narg, arg)
{
    if (narg > 4 || (narg == 4 && std::string(arg[3]) != "walls"))
        stop_all(*error,
                 "Illegal compute pw85/grains command: it takes no arguments but the word walls");
    has_walls_ = narg == 4;
    // LAMMPS must not divide the number of contacts by the number of atoms in thermodynamic output,
    // nor the stresses.
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
        stop_all(*error, "Compute pw85/grains reports the contacts of pair_style pw85/granular: "
                         "use this pair style");
    pair_->keep_touches();
    walls_.clear();
    if (!has_walls_) return;
    for (int k = 0; k < modify->nfix; ++k)
        if (auto *const wall = dynamic_cast<FixWall *>(modify->fix[k])) walls_.push_back(wall);
    for (FixWall *const wall : walls_) wall->keep_touches();
}

void ComputeGrains::check_step() const
{
    bool is_present = pair_ && pair_->step_of_touches() == update->ntimestep;
    for (FixWall const *const wall : walls_)
        is_present = is_present && wall->step_of_touches() == update->ntimestep;
    if (!is_present)
        stop_all(
            *error,
            "Compute pw85/grains was asked for contacts of a step without forces: use run 0 first");
}

/// Returns whether a contact belongs to the group and this processor reports it.
bool ComputeGrains::counts(PairGranular::Touch const &touch) const
{
    if (!(atom->mask[touch.i] & atom->mask[touch.j] & groupbit)) return false;
    return force->newton_pair || std::max(touch.i, touch.j) < atom->nlocal ||
           belongs_here(*atom, touch.i, touch.j);
}

namespace {

/// Returns the row of a contact.
/// @param arm of the stress of the contact: from the first centre to the second one, or to the wall
template <class Row> Row contact_row(double tag1, double tag2, Vector const &point,
                                     Vector const &normal, double depth, Vector const &push,
                                     Vector const &arm, Vector const &spring, double heat)
{
    Row row{tag1, tag2};
    auto end = row.begin() + 2;
    auto const add = [&end](Vector const &x) { end = std::copy(x.begin(), x.end(), end); };
    add(point);
    add(normal);
    *end++ = depth;
    add(push);
    for (double const r : arm)
        for (double const f : push) *end++ = -r * f;
    add(push - dot(push, normal) * normal);
    add(spring);
    *end = heat;
    return row;
}

} // namespace

ComputeGrains::Row ComputeGrains::row(PairGranular::Touch const &touch) const
{
    bool const in_order = atom->tag[touch.i] <= atom->tag[touch.j];
    int const first = in_order ? touch.i : touch.j, second = in_order ? touch.j : touch.i;
    double const sign = in_order ? 1.0 : -1.0;
    Vector const r12 = pw85_lammps::vector(atom->x[second]) - pw85_lammps::vector(atom->x[first]);
    return contact_row<Row>(
        static_cast<double>(atom->tag[first]), static_cast<double>(atom->tag[second]),
        pw85_lammps::vector(atom->x[touch.i]) + touch.arm, sign * touch.normal, touch.depth,
        sign * touch.force, r12, sign * touch.spring, sign * touch.heat);
}

ComputeGrains::Row ComputeGrains::row(FixWall::Touch const &touch, std::size_t wall) const
{
    return contact_row<Row>(static_cast<double>(atom->tag[touch.i]), -static_cast<double>(wall + 1),
                            pw85_lammps::vector(atom->x[touch.i]) + touch.arm, touch.normal,
                            touch.depth, touch.force, touch.arm, touch.spring, touch.heat);
}

/// Calls use(row) for each contact that this processor reports.
template <class Use> void ComputeGrains::for_each_row(Use use) const
{
    check_step();
    for (PairGranular::Touch const &touch : pair_->touches())
        if (counts(touch)) use(row(touch));
    for (std::size_t k = 0; k < walls_.size(); ++k)
        for (FixWall::Touch const &touch : walls_[k]->touches())
            if (counts(touch)) use(row(touch, k));
}

double ComputeGrains::compute_scalar()
{
    invoked_scalar = update->ntimestep;
    bigint own = 0, count = 0;
    for_each_row([&own](Row const &) { ++own; });
    MPI_Allreduce(&own, &count, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    scalar = static_cast<double>(count);
    return scalar;
}

void ComputeGrains::compute_vector()
{
    invoked_vector = update->ntimestep;
    std::array<double, stress_size> own{};
    for_each_row([&own](Row const &r) {
        for (std::size_t k = 0; k < stress_size; ++k) own[k] += r[stress_place + k];
    });
    MPI_Allreduce(own.data(), vector, static_cast<int>(stress_size), MPI_DOUBLE, MPI_SUM, world);
}

void ComputeGrains::compute_local()
{
    invoked_local = update->ntimestep;
    rows_.clear();
    for_each_row([this](Row const &r) { rows_.add(r); });
    rows_.publish(*this);
}

// Counts the contacts of each atom. If two processors know a contact, the one that reports it
// counts it, and ghosts send their counts to the owners.
void ComputeGrains::compute_peratom()
{
    invoked_peratom = update->ntimestep;
    check_step();
    counts_.assign(static_cast<std::size_t>(atom->nmax), 0.0);
    for (PairGranular::Touch const &touch : pair_->touches())
        if (counts(touch))
            for (int const i : {touch.i, touch.j}) counts_[static_cast<std::size_t>(i)] += 1.0;
    for (FixWall const *const wall : walls_)
        for (FixWall::Touch const &touch : wall->touches())
            if (counts(touch)) counts_[static_cast<std::size_t>(touch.i)] += 1.0;
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
    return rows_.bytes() + static_cast<double>(counts_.capacity() * sizeof(double));
}

} // namespace pw85_lammps
