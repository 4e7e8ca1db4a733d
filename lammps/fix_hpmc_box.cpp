// SPDX-License-Identifier: GPL-2.0-only
// The box of fix pw85/hpmc: exact positions, the cells and their shifts, and the ghosts of a sweep.
#include "fix_hpmc.hpp"

#include "words.hpp"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

std::string direction(int k) { return std::string(" along ") + "xyz"[k]; }

} // namespace

void FixHpmc::refuse_box() const
{
    constexpr int fixed = 1; // as LAMMPS numbers the words p, f, s, m of the command boundary
    if (domain->dimension != 3) refuse("works in three dimensions: use dimension 3");
    for (int k = 0; k < 3; ++k)
        if (std::max(domain->boundary[k][0], domain->boundary[k][1]) > fixed)
            refuse("works in boxes that stay as they are" + direction(k) +
                   ": use boundary p or f instead of s or m");
    if (comm->style != 0 || comm->layout != Comm::LAYOUT_UNIFORM)
        refuse("needs sub-domains of equal size: remove balance and comm_style tiled");
    if (atom->firstgroup >= 0) refuse("needs ghosts of all atoms: remove atom_modify first");
    if (comm->mode != Comm::SINGLE)
        refuse("needs one cutoff for all ghosts: use comm_modify mode single");
}

/// Returns whether trials of the volume may scale the box along an axis.
bool FixHpmc::scales(int k) const
{
    Scaled const one = k == 0 ? Scaled::x : k == 1 ? Scaled::y : Scaled::z;
    return scaled_ == Scaled::all || scaled_ == Scaled::one_of_three || scaled_ == one;
}

/// A fix wall/pw85 is across directions that are not periodic. It does not change if the box
/// becomes longer or shorter along a periodic one.
void FixHpmc::refuse_pressure() const
{
    for (int k = 0; k < 3; ++k)
        if (scales(k) && !is_periodic(static_cast<std::size_t>(k)))
            refuse("cannot have a pressure" + direction(k) +
                   ", where the box is not periodic: use pressure x, y or z for a periodic one");
}

/// Returns the box as it is, without rounding.
ExactBox FixHpmc::present_box() const
{
    ExactBox box;
    box.lower = vector(domain->boxlo);
    box.edges = vector(domain->boxhi) - box.lower;
    if (domain->triclinic) box.tilts = {domain->xy, domain->xz, domain->yz};
    box.units = box_.units;
    return box;
}

void FixHpmc::make_positions_exact()
{
    box_ = exact_box(vector(domain->boxlo), vector(domain->boxhi), present_box().tilts,
                     domain->triclinic != 0);
    for (int i = 0; i < atom->nlocal; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            double &x = atom->x[i][k];
            bool const was_below = x < domain->boxhi[k];
            x = box_.rounded(k, x);
            // LAMMPS loses atoms on the upper side of a box that is not periodic.
            if (!is_periodic(k) && was_below) x = std::min(x, box_.upper(k) - box_.units[k]);
        }
    set_domain(box_);
}

/// Undoes the rounding errors with which LAMMPS converts positions in a triclinic box to fractions
/// of its vectors and back.
void FixHpmc::recover_positions(int count)
{
    if (!domain->triclinic) return;
    for (int i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k) atom->x[i][k] = box_.rounded(k, atom->x[i][k]);
}

void FixHpmc::set_domain(ExactBox const &box)
{
    for (std::size_t k = 0; k < 3; ++k) {
        domain->boxlo[k] = box.lower[k];
        domain->boxhi[k] = box.upper(k);
    }
    if (domain->triclinic) {
        domain->xy = box.tilts[0];
        domain->xz = box.tilts[1];
        domain->yz = box.tilts[2];
    }
    domain->set_global_box();
    if (domain->triclinic) domain->set_lamda_box();
    domain->set_local_box();
}

/// Returns the box in which a sweep shifts the atoms of a box.
ExactBox FixHpmc::lengthened(ExactBox box) const
{
    for (std::size_t k = 0; k < 3; ++k)
        if (!is_periodic(k)) box = Checkerboard::lengthened(box, k, cells_.counts()[k]);
    return box;
}

void FixHpmc::make_cells()
{
    Checkerboard::Counts counts{};
    for (int k = 0; k < 3; ++k) {
        auto const index = static_cast<std::size_t>(k);
        int const largest = largest_count(k);
        require_cells(k, largest);
        counts[index] =
            wanted_cells_[index] ? wanted_cells_[index] : Checkerboard::default_count(largest);
        if (counts[index] % comm->procgrid[k] != 0)
            refuse("has " + std::to_string(counts[index]) + " cells" + direction(k) + ", which " +
                   std::to_string(comm->procgrid[k]) +
                   " sub-domains cannot share: use cells with a multiple of this number, at most " +
                   std::to_string(largest) + ", or another grid of processors");
    }
    cells_ = {box_, counts};
    cells_ = {lengthened(box_), counts};
}

/// Returns the largest number of cells along a direction. Without periodicity, one of them is
/// beyond the box.
int FixHpmc::largest_count(int k) const
{
    auto const index = static_cast<std::size_t>(k);
    return Checkerboard::largest_count(box_.heights()[index], diameter_, is_periodic(index));
}

void FixHpmc::require_cells(int k, int largest) const
{
    auto const index = static_cast<std::size_t>(k);
    int const wanted = wanted_cells_[index];
    double const height = box_.heights()[index];
    bool const periodic = is_periodic(index);
    if (largest < 2)
        refuse("needs a box of at least " +
               (periodic ? "two of the largest diameter, " + decimal(2.0 * diameter_)
                         : "the largest diameter, " + decimal(diameter_)) +
               direction(k) + ", where it is " + decimal(height) +
               (periodic ? ": use a larger box (replicate)"
                         : ": use a larger box, with walls inside of it"));
    if (wanted % 2 != 0)
        refuse("needs an even number of cells" + direction(k) + ": use " +
               std::to_string(std::min(wanted + 1, largest)) + " instead of " +
               std::to_string(wanted));
    if (wanted > largest)
        refuse("has cells with an edge of " + decimal(height / (periodic ? wanted : wanted - 1)) +
               direction(k) + ", which is less than the largest diameter " + decimal(diameter_) +
               ": use at most " + std::to_string(largest) + " cells");
}

/// Returns the distance within which a processor needs ghosts at the start of a sweep.
///
/// Two atoms can meet during the sweep only if they are closer than the diameter and the longest
/// displacement of one of them, and only if they are in the same cell or in adjacent ones. A trial
/// of the volume compresses the box at the end of the sweep; then atoms can meet that are farther
/// apart, and in other cells.
double FixHpmc::ghost_distance() const
{
    double const path = num_trials_ * largest_step_[translation];
    double distance = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        double const edge = cells_.height(k);
        distance = std::max(distance, scaled_ == Scaled::none
                                          ? std::min(edge, diameter_ + path)
                                          : diameter_ * std::exp(largest_step_[expansion]) +
                                                std::min(edge, path));
    }
    return 1.001 * distance; // far more than rounding errors
}

void FixHpmc::ensure_ghosts()
{
    double const distance = ghost_distance();
    Vector reach = vector(comm->cutghost);
    // In a triclinic box these are parts of the heights.
    for (std::size_t k = 0; domain->triclinic && k < 3; ++k) reach[k] *= box_.heights()[k];
    if (*std::min_element(reach.begin(), reach.end()) >= distance) return;
    comm->cutghostuser = distance;
    comm->setup();
    if (neighbor->style) neighbor->setup_bins();
}

/// Returns a random vector in a cell. A further shift by whole cells would only permute the cells.
Vector FixHpmc::random_shift(Stream &random) const
{
    Vector fractions;
    for (double &fraction : fractions) fraction = random.uniform();
    return cells_.in_cell(fractions);
}

/// Sets the box to that of the cells. LAMMPS's sub-domains are parts of it, with the same number of
/// cells each. An atom that was in one sub-domain of the box is in the same or in an adjacent one
/// after the shift, and the same holds when the box is made shorter again.
void FixHpmc::lengthen_domain()
{
    if (domain->nonperiodic == 0) return;
    set_domain(cells_.box());
    comm->setup();
}

void FixHpmc::restore_domain()
{
    if (domain->nonperiodic == 0) return;
    set_domain(box_);
    comm->setup();
}

void FixHpmc::shift_all(Vector const &shift)
{
    for (int i = 0; i < atom->nlocal; ++i)
        for (std::size_t k = 0; k < shift.size(); ++k) atom->x[i][k] += shift[k];
}

// Atoms move by less than a cell, so by less than a sub-domain, as exchange() needs. LAMMPS
// exchanges atoms of a triclinic box by their fractions.
void FixHpmc::receive_atoms()
{
    if (domain->triclinic) domain->x2lamda(atom->nlocal);
    domain->pbc();
    comm->exchange();
    comm->borders();
    if (domain->triclinic) domain->lamda2x(atom->nlocal + atom->nghost);
    recover_positions(atom->nlocal);
    ellipsoids_.read([](int) { return true; });
    forward_to_ghosts(*comm, this);
    build_bins();
}

} // namespace pw85_lammps
