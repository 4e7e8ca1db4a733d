// SPDX-License-Identifier: GPL-2.0-only
// fix pw85/hpmc: its command, what it refuses, and what LAMMPS calls. It moves atoms before LAMMPS
// exchanges them between processors and builds its neighbour lists. fix_hpmc_box.cpp has the box,
// fix_hpmc_trials.cpp the moves.
#include "fix_hpmc.hpp"

#include "fix_wall.hpp"
#include "words.hpp"

#include <algorithm>
#include <cmath>

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

void FixHpmc::pre_exchange()
{
    if (update->ntimestep != next_reneighbor) return;
    next_reneighbor += every_;
    if (present_box() != box_)
        refuse("works in a box that nothing else changes, but it has changed during the run");
    if (scaled_ != Scaled::none) make_cells();
    sweep();
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
