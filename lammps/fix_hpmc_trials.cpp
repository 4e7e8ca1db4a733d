// SPDX-License-Identifier: GPL-2.0-only
// The trials of fix pw85/hpmc: translations, rotations and changes of the volume.
#include "fix_hpmc.hpp"

#include "fix_wall.hpp"

#include <pw85_systems.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// Returns the differences of the counts of all types of trials.
template <std::size_t n>
std::array<bigint, n> difference(std::array<bigint, n> a, std::array<bigint, n> const &b)
{
    for (std::size_t k = 0; k < n; ++k) a[k] -= b[k];
    return a;
}

} // namespace

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

} // namespace pw85_lammps
