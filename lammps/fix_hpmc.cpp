// SPDX-License-Identifier: GPL-2.0-only
// fix pw85/hpmc: it moves atoms before LAMMPS exchanges them between processors and builds its
// neighbour lists.
#include "fix_hpmc.hpp"

#include "fix_wall.hpp"
#include "words.hpp"

#include <pw85_systems.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

constexpr char hpmc_style[] = "Fix pw85/hpmc";

/// The share of accepted trials that tuning aims at, and by how much the logarithm of a step
/// changes for a difference of one in the share. Efficiency has a flat maximum at shares from 0.2
/// to 0.5. A sweep has one trial of the volume, and its share is 0 or 1: the mean change is zero at
/// the wanted share.
constexpr double wanted_share = 0.3, gain = 0.3;

/// The largest rotation of a trial, in radians. Larger values would hardly change the distribution
/// of the orientations.
constexpr double largest_rotation = 3.0;

/// The largest change of the logarithm of the volume.
constexpr double largest_expansion = 0.5;

/// Returns the differences of the counts of all types of trials.
template <std::size_t n>
std::array<bigint, n> difference(std::array<bigint, n> a, std::array<bigint, n> const &b)
{
    for (std::size_t k = 0; k < n; ++k) a[k] -= b[k];
    return a;
}

std::string direction(int k) { return std::string(" along ") + "xyz"[k]; }

} // namespace

FixHpmc::FixHpmc(LAMMPS *lammps, int narg, char **arg)
    : Fix(lammps, narg, arg),
      ellipsoids_(lammps, hpmc_style, "remove it: all atoms must be ellipsoids")
{
    Words words(lmp, hpmc_style, narg - 3, arg + 3);
    every_ = static_cast<int>(words.number("number of steps between sweeps", 1.0, 1e9));
    seed_ = static_cast<std::uint32_t>(words.number("seed", 1.0, 4294967295.0));
    while (!words.done()) read_keyword(words);
    force_reneighbor = 1;
    next_reneighbor = -1;
    restart_global = 1;
    vector_flag = 1;
    size_vector = 3 * num_kinds;
    global_freq = 1;
    extvector = 0;
    comm_forward = Ellipsoids::comm_size + 3;
    if (scaled_ == Scaled::none) return;
    box_change = BOX_CHANGE_X | BOX_CHANGE_Y | BOX_CHANGE_Z;
    if (igroup != 0) refuse("with a pressure needs the group all");
}

void FixHpmc::read_keyword(Words &words)
{
    if (words.skip("translate")) {
        largest_step_[translation] = words.positive("largest translation");
    } else if (words.skip("rotate")) {
        largest_step_[rotation] = words.number("largest rotation", 0.0, largest_rotation);
    } else if (words.skip("trials")) {
        num_trials_ = static_cast<int>(words.number("number of trials", 1.0, 1e6));
    } else if (words.skip("tune")) {
        tuned_until_ = static_cast<bigint>(words.number("last step of tuning", 0.0, 9e15));
    } else if (words.skip("pressure")) {
        scaled_ = words.choice<Scaled>("kind of pressure", {{"iso", Scaled::all},
                                                            {"x", Scaled::x},
                                                            {"y", Scaled::y},
                                                            {"z", Scaled::z},
                                                            {"aniso", Scaled::one_of_three}});
        pressure_ = words.number("pressure");
    } else if (words.skip("volume")) {
        largest_step_[expansion] =
            words.number("largest change of the volume", 1e-15, largest_expansion);
    } else if (words.skip("cells")) {
        for (int &count : wanted_cells_)
            count = static_cast<int>(words.number("number of cells", 1.0, 1024.0));
    } else if (words.skip("walls")) {
        wall_ids_.push_back(words.word("the ID of a fix wall/pw85"));
    } else {
        words.refuse(
            "has an unknown keyword " + words.word("keyword") +
            ": use one of cells, pressure, rotate, translate, trials, tune, volume, walls");
    }
}

void FixHpmc::refuse(std::string const &reason) const
{
    stop_all(*error, std::string(hpmc_style) + " " + reason);
}

void FixHpmc::init()
{
    refuse_respa(*lmp, hpmc_style);
    constexpr int in_minimize = 2; // as LAMMPS numbers what it is doing
    if (update->whichflag == in_minimize)
        refuse(
            "samples in runs, not in minimize: give this fix after minimize, or unfix it before");
    if (group->count(igroup) == 0)
        refuse(std::string("has no atoms in its group ") + group->names[igroup] +
               ": nothing would move");
    refuse_box();
    find_walls();
    refuse_other_motion();
    if (scaled_ != Scaled::none) refuse_pressure();
    std::string const pair_style = force->pair ? force->pair_style : "none";
    if (pair_style != "pw85/hard" && pair_style != "zero")
        refuse("moves hard ellipsoids, without the energies of pair_style " + pair_style +
               ": use pair_style pw85/hard");
    if (!atom->tag_enable) refuse("needs atom IDs: remove atom_modify id no");
    next_reneighbor = (update->ntimestep / every_ + 1) * every_;
}

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

void FixHpmc::find_walls()
{
    walls_.clear();
    for (std::string const &wall_id : wall_ids_) {
        int const index = modify->find_fix(wall_id.c_str());
        auto const *const wall =
            index < 0 ? nullptr : dynamic_cast<FixWall const *>(modify->fix[index]);
        if (!wall)
            refuse("has walls " + wall_id +
                   ", but no fix wall/pw85 has this ID: define it before the run");
        if (std::string const reason = wall->why_not_hard(); !reason.empty())
            refuse("cannot have walls that fix " + wall_id + " has, which " + reason);
        walls_.push_back(wall);
    }
}

void FixHpmc::refuse_other_motion() const
{
    for (int k = 0; k < modify->nfix; ++k) {
        Fix const &other = *modify->fix[k];
        if (&other == this || std::count(walls_.begin(), walls_.end(), &other) > 0) continue;
        std::string const other_style = other.style;
        if (other_style == "wall/pw85")
            refuse(std::string("does not know the walls of fix ") + other.id + ": add walls " +
                   other.id + " to its command, or unfix them");
        if (other_style.rfind("wall", 0) == 0)
            refuse("does not see the walls of fix " + std::string(other.id) + " (" + other_style +
                   "): use fix wall/pw85, or unfix it");
        if (other.time_integrate || other.box_change || other.force_reneighbor)
            refuse(std::string("cannot run beside fix ") + other.id + " (" + other_style +
                   "), which moves, adds or removes atoms or changes the box, too: unfix it");
    }
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

void FixHpmc::setup_pre_exchange()
{
    make_positions_exact();
    ellipsoids_.forget();
    ellipsoids_.read([](int) { return true; });
    diameter_ = 0.0;
    ellipsoids_.for_each_reach(
        [this](int, int, double reach) { diameter_ = std::max(diameter_, reach); });
    make_cells();
    tried_ = accepted_ = {};
    first_sweep_ = true;
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

void FixHpmc::pre_exchange()
{
    if (update->ntimestep != next_reneighbor) return;
    next_reneighbor += every_;
    if (present_box() != box_)
        refuse("works in a box that nothing else changes, but it has changed during the run");
    if (scaled_ != Scaled::none) make_cells();
    sweep();
}

void FixHpmc::sweep()
{
    Counts const tried = tried_, accepted = accepted_;
    Stream random(seed_, static_cast<std::uint64_t>(update->ntimestep), 0);
    ensure_ghosts();
    shift_ = random_shift(random);
    shift_all(shift_);
    lengthen_domain();
    receive_atoms();
    if (first_sweep_) require_no_overlaps();
    find_movers();
    std::array<int, Checkerboard::num_colours> colours;
    std::iota(colours.begin(), colours.end(), 0);
    for (std::uint32_t left = Checkerboard::num_colours; left > 0; --left) {
        std::swap(colours[random.below(left)], colours[left - 1]);
        move_colour(colours[left - 1]);
    }
    ellipsoids_.write_quaternions();
    if (first_sweep_) require_quaternions();
    first_sweep_ = false;
    if (scaled_ != Scaled::none) {
        bool const is_accepted = try_volume(random);
        if (comm->me == 0) tried_[expansion] += 1;
        if (comm->me == 0 && is_accepted) accepted_[expansion] += 1;
    }
    shift_all(-1.0 * shift_);
    restore_domain();
    tune(difference(tried_, tried), difference(accepted_, accepted));
}

// Tries a change of the volume. The logarithm of the volume changes by a number that is uniform
// between two bounds. So the density of states has the factor V^(N+1). The trial is decided for the
// rounded box and positions.
bool FixHpmc::try_volume(Stream &random)
{
    ExactBox const old_box = box_;
    std::vector<double> const old_positions(
        atom->x[0], atom->x[0] + 3 * static_cast<std::ptrdiff_t>(atom->nlocal));
    Vector const factors = random_factors(random), old_shift = shift_;
    double const threshold = random.uniform();
    box_ = scaled(old_box, factors);
    set_domain(lengthened(box_));
    shift_ = scale_all(old_box);
    double const old_volume = old_box.volume(), volume = box_.volume();
    double const weight = static_cast<double>(atom->natoms + 1) * std::log(volume / old_volume) -
                          pressure_ * (volume - old_volume);
    if (std::log(threshold) < weight && !has_overlaps()) return true;
    box_ = old_box;
    shift_ = old_shift;
    set_domain(lengthened(box_));
    std::copy(old_positions.begin(), old_positions.end(), atom->x[0]);
    return false;
}

/// Returns the factors of the edges of the box.
Vector FixHpmc::random_factors(Stream &random) const
{
    double const change = largest_step_[expansion] * (2.0 * random.uniform() - 1.0);
    std::uint32_t const axis = random.below(3);
    if (scaled_ == Scaled::all) {
        double const factor = std::exp(change / 3.0);
        return {factor, factor, factor};
    }
    Vector factors{1.0, 1.0, 1.0};
    std::size_t const chosen = scaled_ == Scaled::x   ? 0
                               : scaled_ == Scaled::y ? 1
                               : scaled_ == Scaled::z ? 2
                                                      : axis;
    factors[chosen] = std::exp(change);
    return factors;
}

/// Returns the box scaled by factors, from its lower corner.
ExactBox FixHpmc::scaled(ExactBox const &box, Vector const &factors) const
{
    Vector upper;
    for (std::size_t k = 0; k < upper.size(); ++k)
        upper[k] = box.lower[k] + factors[k] * box.edges[k];
    auto const [xy, xz, yz] = box.tilts;
    return exact_box(box.lower, upper, {factors[0] * xy, factors[0] * xz, factors[1] * yz},
                     domain->triclinic != 0);
}

/// Moves all atoms from their positions in an old box to those in the present box, and returns the
/// shift.
Vector FixHpmc::scale_all(ExactBox const &old)
{
    Vector new_shift;
    for (std::size_t k = 0; k < new_shift.size(); ++k) {
        double const factor = box_.edges[k] / old.edges[k];
        new_shift[k] = box_.rounded(k, factor * shift_[k]);
        for (int i = 0; i < atom->nlocal; ++i)
            atom->x[i][k] =
                box_.lower[k] + box_.rounded(k, factor * (atom->x[i][k] - old.lower[k]));
    }
    return new_shift;
}

/// Returns whether any ellipsoids overlap. All processors call this together.
bool FixHpmc::has_overlaps()
{
    forward_to_ghosts(*comm, this);
    build_bins();
    int found = 0;
    for (int i = 0; i < atom->nlocal && !found; ++i) {
        gather(i, ellipsoids_.radius(i) + 0.5 * diameter_);
        found = overlaps(i, atom->x[i], ellipsoids_.form(i)) ? 1 : 0;
    }
    MPI_Allreduce(MPI_IN_PLACE, &found, 1, MPI_INT, MPI_MAX, world);
    return found != 0;
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

void FixHpmc::build_bins()
{
    int const count = atom->nlocal + atom->nghost;
    Vector lower = vector(domain->sublo) - vector(comm->cutghost),
           upper = vector(domain->subhi) + vector(comm->cutghost);
    if (domain->triclinic) bound_positions(count, lower, upper);
    // Bins of half a diameter waste little space at high densities. Larger ones hold one atom each
    // at low densities.
    double const edge =
        std::max(0.5 * diameter_, std::cbrt(box_.volume() / static_cast<double>(atom->natoms)));
    bins_.build(count, count > 0 ? atom->x[0] : nullptr, lower, upper, edge);
}

/// Computes the bounds of the first atoms, or of a point if there are none, enlarged by half a
/// diameter.
void FixHpmc::bound_positions(int count, Vector &lower, Vector &upper) const
{
    lower = upper = count > 0 ? vector(atom->x[0]) : box_.lower;
    for (std::size_t k = 0; k < 3; ++k) {
        for (int i = 0; i < count; ++i) {
            lower[k] = std::min(lower[k], atom->x[i][k]);
            upper[k] = std::max(upper[k], atom->x[i][k]);
        }
        lower[k] -= 0.5 * diameter_;
        upper[k] += 0.5 * diameter_;
    }
}

void FixHpmc::find_movers()
{
    for (auto &movers : movers_) movers.clear();
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit)) continue;
        Checkerboard::Cell const cell = cells_.cell(atom->x[i]);
        if (!cells_.is_inside(cell, atom->x[i])) continue;
        movers_[static_cast<std::size_t>(Checkerboard::colour(cell))].push_back(
            {cells_.index(cell), atom->tag[i], i, cell});
    }
    for (auto &movers : movers_)
        std::sort(movers.begin(), movers.end(), [](Mover const &a, Mover const &b) {
            return std::pair(a.cell_index, a.tag) < std::pair(b.cell_index, b.tag);
        });
}

void FixHpmc::move_colour(int colour)
{
    for (Mover const &mover : movers_[static_cast<std::size_t>(colour)]) move(mover);
    forward_to_ghosts(*comm, this);
    for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; ++i) bins_.update(i, atom->x[i]);
}

void FixHpmc::move(Mover const &mover)
{
    int const i = mover.atom;
    Stream random(seed_, static_cast<std::uint64_t>(update->ntimestep),
                  static_cast<std::uint64_t>(mover.tag));
    double const path = num_trials_ * largest_step_[translation]; // the sum of all translations
    gather(i, ellipsoids_.radius(i) + 0.5 * diameter_ + path);
    bool const turns = !is_sphere(i) && largest_step_[rotation] > 0.0;
    for (int trial = 0; trial < num_trials_; ++trial) {
        Kind const kind = turns && (random.bits() & 1) ? rotation : translation;
        bool const accepted =
            kind == rotation ? try_rotation(mover, random) : try_translation(mover, random);
        tried_[kind] += 1;
        accepted_[kind] += accepted ? 1 : 0;
    }
    bins_.update(i, atom->x[i]);
}

bool FixHpmc::try_translation(Mover const &mover, Stream &random)
{
    Vector const step = largest_step_[translation] * random.in_ball();
    Vector center = vector(atom->x[mover.atom]);
    for (std::size_t k = 0; k < center.size(); ++k) center[k] += box_.rounded(k, step[k]);
    if (!cells_.is_inside(mover.cell, center.data()) || is_outside(center)) return false;
    double const *const form = ellipsoids_.form(mover.atom);
    if (cuts_walls(mover.atom, center.data(), form)) return false;
    if (overlaps(mover.atom, center.data(), form)) return false;
    std::copy(center.begin(), center.end(), atom->x[mover.atom]);
    return true;
}

// Tries a rotation. A random vector v in a ball gives its axis, and |v| is the tangent of half of
// its angle. The rotation and its inverse, by -v, are equally probable.
bool FixHpmc::try_rotation(Mover const &mover, Stream &random)
{
    Vector const v = std::tan(0.5 * largest_step_[rotation]) * random.in_ball();
    double const *const q = ellipsoids_.quaternion(mover.atom);
    Vector const u{q[1], q[2], q[3]};
    double const w = q[0] - dot(v, u);
    Vector const turned = u + q[0] * v + cross(v, u);
    double const factor = 1.0 / std::sqrt(w * w + dot(turned, turned));
    std::array<double, 4> const quaternion{factor * w, factor * turned[0], factor * turned[1],
                                           factor * turned[2]};
    auto const form = ellipsoids_.form_with(mover.atom, quaternion.data());
    double const *const center = atom->x[mover.atom];
    if (cuts_walls(mover.atom, center, form.data())) return false;
    if (overlaps(mover.atom, center, form.data())) return false;
    ellipsoids_.turn(mover.atom, quaternion.data(), form);
    return true;
}

/// Finds the candidates within a distance of an atom, and some that are farther by up to a
/// thousandth. This is far more than rounding errors, of positions and forms.
void FixHpmc::gather(int i, double distance)
{
    candidates_.clear();
    Vector const center = vector(atom->x[i]);
    double const reach = 1.001 * distance;
    bins_.visit(center.data(), reach, [&](int j) {
        Vector const r = vector(atom->x[j]) - center;
        if (j != i && dot(r, r) <= reach * reach) candidates_.push_back(j);
    });
}

/// Returns whether an owned atom would overlap any candidate with another centre and form.
bool FixHpmc::overlaps(int i, double const *center, double const *form)
{
    neighbors_.clear();
    for (int const j : candidates_) {
        Vector const r = vector(atom->x[j]) - vector(center);
        double const reach = ellipsoids_.radius(i) + ellipsoids_.radius(j);
        if (dot(r, r) <= reach * reach * (1.0 + Ellipsoids::margin)) neighbors_.push_back(j);
    }
    pw85_system const system = ellipsoids_.system();
    int any = 0;
    int const status = pw85_overlap_any_indices(center, form, &system, neighbors_.size(),
                                                neighbors_.data(), nullptr, &any);
    if (status != PW85_SUCCESS) {
        pw85_error cause;
        pw85_last_error(&cause);
        std::string const other = neighbors_.empty() ? "" : ellipsoids_.name(neighbors_[cause.row]);
        ellipsoids_.refuse(i, "cannot be tested: " + words_of(cause, ellipsoids_.name(i), other));
    }
    return any != 0;
}

/// Returns whether a shifted centre is out of the box along a direction that is not periodic. As
/// with cells, positions within 16 units of the sides count as outside: LAMMPS would lose atoms by
/// rounding.
bool FixHpmc::is_outside(Vector const &center) const
{
    if (domain->nonperiodic == 0) return false;
    Vector const place = center - shift_, fractions = box_.fractions(place.data());
    for (std::size_t k = 0; k < 3; ++k) {
        double const guard = 16.0 * box_.units[k] / box_.edges[k];
        if (!is_periodic(k) && !(fractions[k] >= guard && fractions[k] < 1.0 - guard)) return true;
    }
    return false;
}

/// Returns whether an owned atom with a shifted centre and a form would cut a wall.
bool FixHpmc::cuts_walls(int i, double const *center, double const *form) const
{
    return std::any_of(walls_.begin(), walls_.end(), [&](FixWall const *wall) {
        return (atom->mask[i] & wall->groupbit) != 0 &&
               wall->cuts(vector(center) - shift_, form, ellipsoids_.radius(i));
    });
}

/// Atoms that do not move may be parts of a wall.
void FixHpmc::require_room_for(int i) const
{
    if ((atom->mask[i] & groupbit) != 0 && cuts_walls(i, atom->x[i], ellipsoids_.form(i)))
        ellipsoids_.refuse(i,
                           "cuts a wall at the start: move the atom or the wall (displace_atoms, "
                           "fix wall/pw85), or leave the atom out of the group of the wall");
}

void FixHpmc::require_no_overlaps()
{
    for (int i = 0; i < atom->nlocal; ++i) {
        require_room_for(i);
        gather(i, ellipsoids_.radius(i) + diameter_);
        if (!overlaps(i, atom->x[i], ellipsoids_.form(i))) continue;
        for (int const j : std::vector<int>(candidates_)) {
            candidates_ = {j};
            if (overlaps(i, atom->x[i], ellipsoids_.form(i)))
                ellipsoids_.refuse_pair(
                    i, j, "overlap at the start: remove overlaps first, as by fix pw85/fire");
        }
    }
}

// Stops the run if LAMMPS cannot set quaternions: its own function gives no message.
void FixHpmc::require_quaternions()
{
    if (atom->nlocal == 0) return;
    double const *const first = ellipsoids_.quaternion(0);
    std::vector<double> const written(first, first + 4 * static_cast<std::ptrdiff_t>(atom->nlocal));
    ellipsoids_.read([](int) { return true; });
    if (!std::equal(written.begin(), written.end(), ellipsoids_.quaternion(0)))
        stop_one(*error,
                 std::string(hpmc_style) +
                     " cannot set quaternions in this release of LAMMPS: use another release");
}

/// Changes the steps of trials towards the wanted share of accepted ones.
void FixHpmc::tune(Counts const &tried, Counts const &accepted)
{
    if (update->ntimestep > tuned_until_) return;
    std::array<bigint, 2 * num_kinds> sums;
    std::copy(accepted.begin(), accepted.end(),
              std::copy(tried.begin(), tried.end(), sums.begin()));
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_LMP_BIGINT, MPI_SUM,
                  world);
    std::array<double, num_kinds> const limits{
        std::min({cells_.height(0), cells_.height(1), cells_.height(2)}), largest_rotation,
        largest_expansion};
    for (std::size_t k = 0; k < num_kinds; ++k) {
        if (sums[k] == 0) continue;
        double const share =
            static_cast<double>(sums[num_kinds + k]) / static_cast<double>(sums[k]);
        double const factor = std::exp(gain * (share - wanted_share));
        largest_step_[k] = std::min(factor * largest_step_[k], limits[k]);
    }
}

double FixHpmc::compute_vector(int k)
{
    auto const kind = static_cast<std::size_t>(k % num_kinds);
    if (k >= 2 * num_kinds) return largest_step_[kind];
    std::array<bigint, 2> sums{accepted_[kind], tried_[kind]};
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_LMP_BIGINT, MPI_SUM,
                  world);
    if (k >= num_kinds) return static_cast<double>(sums[1]);
    return sums[1] > 0 ? static_cast<double>(sums[0]) / static_cast<double>(sums[1]) : 0.0;
}

void FixHpmc::write_restart(FILE *file)
{
    if (comm->me != 0) return;
    int const size = sizeof largest_step_;
    std::fwrite(&size, sizeof size, 1, file);
    std::fwrite(largest_step_.data(), sizeof largest_step_, 1, file);
}

// Without tuning the steps are those of the command.
void FixHpmc::restart(char *buffer)
{
    if (tuned_until_ >= 0) std::memcpy(largest_step_.data(), buffer, sizeof largest_step_);
}

int FixHpmc::pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc)
{
    double *x = buffer + ellipsoids_.pack(count, atoms, buffer);
    Vector const shift = pbc_flag ? image_shift(pbc) : Vector{};
    for (int k = 0; k < count; ++k)
        for (std::size_t d = 0; d < 3; ++d) *x++ = atom->x[atoms[k]][d] + shift[d];
    return count * comm_forward;
}

/// Returns the displacement to an image, by whole vectors of the box; pbc counts them along the
/// axes as LAMMPS does: x, y, z, and the tilts yz, xz, xy.
Vector FixHpmc::image_shift(int const *pbc) const
{
    Vector shift{pbc[0] * domain->xprd, pbc[1] * domain->yprd, pbc[2] * domain->zprd};
    if (domain->triclinic) {
        shift[0] += pbc[5] * domain->xy + pbc[4] * domain->xz;
        shift[1] += pbc[3] * domain->yz;
    }
    return shift;
}

void FixHpmc::unpack_forward_comm(int count, int first, double *buffer)
{
    ellipsoids_.unpack(count, first, buffer);
    std::copy_n(buffer + Ellipsoids::comm_size * static_cast<std::ptrdiff_t>(count),
                3 * static_cast<std::ptrdiff_t>(count), atom->x[first]);
}

double FixHpmc::memory_usage()
{
    double bytes = ellipsoids_.bytes() + bins_.bytes();
    for (auto const &movers : movers_)
        bytes += static_cast<double>(movers.capacity() * sizeof(Mover));
    return bytes;
}

} // namespace pw85_lammps
