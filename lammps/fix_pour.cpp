// SPDX-License-Identifier: GPL-2.0-only
// fix pw85/pour: its words, the places of new grains, and the atoms that it creates.
#include "fix_pour.hpp"

#include "fix_wall.hpp"

#include <pw85.h>
#include <pw85_batch.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

constexpr char pour_style[] = "fix pw85/pour";

constexpr bigint largest_number = 2000000000;

/// Maximum number of points of the box around a region that are drawn until one is in the region.
constexpr int most_points = 100000;

/// Returns whether a side of a region is INF, which LAMMPS stores as 1e20.
bool has_no_end(Region const &region)
{
    double const lower = std::min({region.extent_xlo, region.extent_ylo, region.extent_zlo});
    double const upper = std::max({region.extent_xhi, region.extent_yhi, region.extent_zhi});
    return !(lower > -1e20 && upper < 1e20);
}

/// Returns the image of a vector that is nearest to zero, coordinate by coordinate of the box.
Vector nearest_image(Domain const &domain, Vector const &r)
{
    double const *const h = domain.h, *const inverse = domain.h_inv;
    Vector n{inverse[0] * r[0] + inverse[5] * r[1] + inverse[4] * r[2],
             inverse[1] * r[1] + inverse[3] * r[2], inverse[2] * r[2]};
    for (std::size_t k = 0; k < 3; ++k) n[k] = domain.periodicity[k] ? std::round(n[k]) : 0.0;
    return r -
           Vector{h[0] * n[0] + h[5] * n[1] + h[4] * n[2], h[1] * n[1] + h[3] * n[2], h[2] * n[2]};
}

/// Calls use(r) for the image of a vector that is nearest to zero, and for those around it. Other
/// images of ellipsoids cannot touch if each period is at least as long as the distance at which
/// they touch.
template <class Use> void visit_images(Domain const &domain, Vector const &r, Use use)
{
    double const *const h = domain.h;
    Vector const nearest = nearest_image(domain, r);
    std::array<int, 3> n{};
    for (std::size_t k = 0; k < 3; ++k) n[k] = domain.periodicity[k] ? 1 : 0;
    for (int c = -n[2]; c <= n[2]; ++c)
        for (int b = -n[1]; b <= n[1]; ++b)
            for (int a = -n[0]; a <= n[0]; ++a)
                use(nearest +
                    Vector{h[0] * a + h[5] * b + h[4] * c, h[1] * b + h[3] * c, h[2] * c});
}

/// Returns the arrays of all processors, one after the other.
std::vector<double> gathered(std::vector<double> const &own, MPI_Comm world)
{
    int num_ranks = 1;
    MPI_Comm_size(world, &num_ranks);
    std::vector<int> counts(static_cast<std::size_t>(num_ranks)), places(counts.size());
    int const count = static_cast<int>(own.size());
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
    for (std::size_t k = 1; k < counts.size(); ++k) places[k] = places[k - 1] + counts[k - 1];
    std::vector<double> all(static_cast<std::size_t>(places.back() + counts.back()));
    MPI_Allgatherv(own.data(), count, MPI_DOUBLE, all.data(), counts.data(), places.data(),
                   MPI_DOUBLE, world);
    return all;
}

} // namespace

FixPour::FixPour(LAMMPS *lammps, int narg, char **arg)
    : Fix(lammps, narg, arg), ellipsoids_(lammps, pour_style, "remove it")
{
    Words words(lmp, pour_style, narg - 3, arg + 3);
    number_ = words.whole("number of grains", 1, largest_number);
    seed_ = static_cast<std::uint32_t>(words.whole("seed", 1, 4294967295));
    while (!words.done()) read_keyword(words);
    check_words(words);
    read_region();
    if (!atom->tag_enable) refuse("needs atom IDs: remove atom_modify id no");
    force_reneighbor = 1;
    next_reneighbor = state_.next_step = update->ntimestep + 1;
    restart_global = 1;
    scalar_flag = vector_flag = 1;
    size_vector = 4;
    global_freq = 1;
    extscalar = extvector = 0;
}

void FixPour::read_keyword(Words &words)
{
    if (words.skip("region")) {
        region_id_ = words.word("ID of its region");
    } else if (words.skip("grain")) {
        mixture_.parse_grain(words, atom->ntypes);
    } else if (words.skip("quat")) {
        mixture_.parse_orientation(words);
    } else if (words.skip("velocity")) {
        mixture_.parse_velocity(words);
    } else if (words.skip("every")) {
        every_ = words.whole("number of steps between insertions", 1, largest_number);
    } else if (words.skip("count")) {
        count_ =
            static_cast<double>(words.whole("number of grains of an insertion", 1, largest_number));
        rate_ = 0.0;
    } else if (words.skip("rate")) {
        rate_ = words.positive("rate");
        count_ = 0.0;
    } else if (words.skip("attempts")) {
        attempts_ = words.whole("number of attempts", 1, largest_number);
    } else {
        words.refuse("has an unknown keyword " + words.word("keyword") +
                     ": use one of attempts, count, every, grain, quat, rate, region, velocity");
    }
}

void FixPour::check_words(Words &words) const
{
    if (region_id_.empty()) words.refuse("lacks its region: add region ID");
    if (mixture_.empty()) words.refuse("lacks the shapes of its grains: add grain TYPE DX DY DZ");
}

int FixPour::setmask() { return FixConst::PRE_EXCHANGE; }

void FixPour::refuse(std::string const &reason) const
{
    stop_all(*error, std::string(pour_style) + " " + reason);
}

void FixPour::init()
{
    refuse_respa(*lmp, pour_style);
    read_region();
    check_box();
    ellipsoids_.forget();
    warned_ = false;
    find_last_tag();
    // The number of the step may have been changed.
    bigint const now = update->ntimestep;
    if (state_.next_step <= now || state_.next_step > now + every_) state_.next_step = now + 1;
    next_reneighbor = state_.inserted < number_ ? state_.next_step : -1;
}

void FixPour::read_region()
{
    region_ = find_region(*domain, region_id_);
    if (!region_)
        refuse("does not find region " + region_id_ + ": define it with the region command before");
    if (!region_->bboxflag || has_no_end(*region_))
        refuse("needs a region of finite size, unlike region " + region_id_ +
               ": use side in, and finite bounds");
    if (region_->dynamic_check())
        refuse("needs a region that stays where it is, unlike region " + region_id_);
}

void FixPour::check_box() const
{
    double const lower[] = {region_->extent_xlo, region_->extent_ylo, region_->extent_zlo};
    double const upper[] = {region_->extent_xhi, region_->extent_yhi, region_->extent_zhi};
    for (int k = 0; k < domain->dimension; ++k) {
        std::string const axis(1, "xyz"[k]);
        bool const is_fixed = domain->boundary[k][0] == 1 || domain->boundary[k][1] == 1;
        if (is_fixed && !domain->triclinic &&
            (lower[k] < domain->boxlo[k] || upper[k] > domain->boxhi[k]))
            refuse("has a region, " + region_id_ + ", that reaches out of the box along " + axis +
                   ", where atoms would be lost: make the box larger or the region smaller");
        if (domain->periodicity[k] && domain->prd[k] < 2.0 * mixture_.largest_radius())
            refuse("has grains with diameters of " + decimal(2.0 * mixture_.largest_radius()) +
                   " that overlap their own images along " + axis +
                   ": make the box larger or the grains smaller");
    }
}

void FixPour::pre_exchange()
{
    if (update->ntimestep != next_reneighbor) return;
    state_.wanted =
        std::min(static_cast<double>(number_),
                 state_.wanted + count_ + rate_ * update->dt * static_cast<double>(every_));
    find_others();
    forget_ghosts(*atom);
    find_last_tag();
    bigint const before = state_.inserted;
    while (static_cast<double>(state_.inserted) + 1.0 <= state_.wanted) {
        Stream stream(seed_, static_cast<std::uint64_t>(state_.inserted), 0);
        NewGrain const grain = mixture_.draw(stream, domain->dimension == 2);
        Vector center;
        std::array<double, PW85_SYM> form;
        if (!place(grain, center, form)) {
            warn_of_full_region();
            break;
        }
        create(grain, center, ++state_.last_tag);
        others_.centers.insert(others_.centers.end(), center.begin(), center.end());
        others_.forms.insert(others_.forms.end(), form.begin(), form.end());
        others_.radii.push_back(grain.radius());
        ++state_.inserted;
        state_.mass += grain.mass();
    }
    announce(state_.inserted - before);
    state_.next_step += every_;
    next_reneighbor = state_.inserted < number_ ? state_.next_step : -1;
}

/// Collects the ellipsoids of all processors that a new grain may touch.
void FixPour::find_others()
{
    ellipsoids_.read([this](int i) { return atom->ellipsoid[i] >= 0; });
    Others own;
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!ellipsoids_.selected(i) || !is_beside_region(i)) continue;
        own.centers.insert(own.centers.end(), atom->x[i], atom->x[i] + 3);
        own.forms.insert(own.forms.end(), ellipsoids_.form(i), ellipsoids_.form(i) + PW85_SYM);
        own.radii.push_back(ellipsoids_.radius(i));
    }
    others_ = {gathered(own.centers, world), gathered(own.forms, world),
               gathered(own.radii, world)};
    double const largest =
        others_.radii.empty() ? 0.0 : *std::max_element(others_.radii.begin(), others_.radii.end());
    for (int k = 0; k < domain->dimension; ++k)
        if (domain->periodicity[k] && domain->prd[k] < largest + mixture_.largest_radius())
            refuse(std::string("works in boxes that are longer than the sum of the largest radii "
                               "of two grains, unlike "
                               "this one along ") +
                   "xyz"[k] + ": make the box larger");
}

/// Returns whether an image of an ellipsoid may touch a new grain.
bool FixPour::is_beside_region(int i) const
{
    if (domain->triclinic) return true;
    Vector const lower{region_->extent_xlo, region_->extent_ylo, region_->extent_zlo};
    Vector const upper{region_->extent_xhi, region_->extent_yhi, region_->extent_zhi};
    Vector const r = nearest_image(*domain, vector(atom->x[i]) - 0.5 * (lower + upper));
    double const reach = ellipsoids_.radius(i) + mixture_.largest_radius();
    for (std::size_t k = 0; k < static_cast<std::size_t>(domain->dimension); ++k)
        if (std::abs(r[k]) > 0.5 * (upper[k] - lower[k]) + reach) return false;
    return true;
}

/// Finds a position for the next grain. Returns whether there is one.
bool FixPour::place(NewGrain const &grain, Vector &center, std::array<double, PW85_SYM> &form)
{
    pw85_ellipsoid_quaternion(grain.semi_axes.data(), grain.quaternion.data(), form.data());
    for (bigint attempt = 0; attempt < attempts_; ++attempt, ++state_.refused) {
        Stream stream(seed_, static_cast<std::uint64_t>(state_.inserted),
                      static_cast<std::uint64_t>(state_.refused) + 1);
        center = draw_place(stream);
        if (!is_in_box(center) || meets_others(center, form.data(), grain.radius()) ||
            meets_walls(center, form.data(), grain.radius()))
            continue;
        return true;
    }
    return false;
}

Vector FixPour::draw_place(Stream &stream) const
{
    for (int point = 0; point < most_points; ++point) {
        Vector x{
            region_->extent_xlo + (region_->extent_xhi - region_->extent_xlo) * stream.uniform(),
            region_->extent_ylo + (region_->extent_yhi - region_->extent_ylo) * stream.uniform(),
            region_->extent_zlo + (region_->extent_zhi - region_->extent_zlo) * stream.uniform()};
        if (domain->dimension == 2) x[2] = 0.0;
        if (region_->match(x[0], x[1], x[2])) return x;
    }
    refuse("finds no point in region " + region_id_ + ": use a region with a volume");
}

/// Returns whether an atom at a position is not lost. Boxes with shrink-wrapped sides grow.
bool FixPour::is_in_box(Vector const &x) const
{
    Vector copy = x, place = x;
    if (domain->triclinic) domain->x2lamda(copy.data(), place.data());
    double const *const lower = domain->triclinic ? domain->boxlo_lamda : domain->boxlo;
    double const *const upper = domain->triclinic ? domain->boxhi_lamda : domain->boxhi;
    for (int k = 0; k < domain->dimension; ++k) {
        auto const value = place[static_cast<std::size_t>(k)];
        if ((domain->boundary[k][0] == 1 && value < lower[k]) ||
            (domain->boundary[k][1] == 1 && value >= upper[k]))
            return false;
    }
    return true;
}

bool FixPour::meets_others(Vector const &center, double const *form, double radius)
{
    near_r12_.clear();
    near_forms_.clear();
    for (std::size_t j = 0; j < others_.radii.size(); ++j) {
        double const reach = (1.0 + Ellipsoids::margin) * (radius + others_.radii[j]);
        visit_images(*domain, vector(&others_.centers[3 * j]) - center, [&](Vector const &r) {
            if (dot(r, r) > reach * reach) return;
            near_r12_.insert(near_r12_.end(), r.begin(), r.end());
            double const *const q = &others_.forms[PW85_SYM * j];
            near_forms_.insert(near_forms_.end(), q, q + PW85_SYM);
        });
    }
    int any = 0;
    int const status =
        pw85_overlap_any(form, near_r12_.size() / 3, near_r12_.data(), near_forms_.data(), &any);
    if (status != PW85_SUCCESS) {
        pw85_error cause;
        pw85_last_error(&cause);
        refuse("cannot tell whether a new grain overlaps another one: " +
               words_of(cause, "the new grain", "the other one"));
    }
    return any != 0;
}

bool FixPour::meets_walls(Vector const &center, double const *form, double radius) const
{
    for (int k = 0; k < modify->nfix; ++k) {
        auto const *const wall = dynamic_cast<FixWall const *>(modify->fix[k]);
        if (wall && (wall->groupbit & (1 | groupbit)) != 0 && wall->meets(center, form, radius))
            return true;
    }
    return false;
}

void FixPour::create(NewGrain const &grain, Vector const &center, tagint tag)
{
    Vector x = center;
    imageint image = static_cast<imageint>(IMGMAX) << IMG2BITS |
                     static_cast<imageint>(IMGMAX) << IMGBITS | IMGMAX;
    domain->remap(x.data(), image);
    if (!owns(x)) return;
    create_ellipsoid(*atom, grain.type, x, grain.semi_axes, grain.quaternion);
    int const i = atom->nlocal - 1;
    atom->tag[i] = tag;
    atom->mask[i] = 1 | groupbit;
    atom->image[i] = image;
    std::copy(grain.velocity.begin(), grain.velocity.end(), atom->v[i]);
    atom->rmass[i] = grain.mass();
    modify->create_attribute(i);
}

/// Returns whether a position belongs to this processor. Positions outside of the box belong to the
/// processors at its sides.
bool FixPour::owns(Vector const &x) const
{
    Vector copy = x, place = x;
    bool const skewed = domain->triclinic != 0;
    if (skewed) domain->x2lamda(copy.data(), place.data());
    double const *const lower = skewed ? domain->sublo_lamda : domain->sublo;
    double const *const upper = skewed ? domain->subhi_lamda : domain->subhi;
    double const *const box_lower = skewed ? domain->boxlo_lamda : domain->boxlo;
    double const *const box_upper = skewed ? domain->boxhi_lamda : domain->boxhi;
    for (std::size_t k = 0; k < 3; ++k) {
        if (place[k] < lower[k] && lower[k] > box_lower[k]) return false;
        if (place[k] >= upper[k] && upper[k] < box_upper[k]) return false;
    }
    return true;
}

/// Finds the largest tag that any atom has had. Tags of lost atoms must not be used again, because
/// styles identify shapes and contacts by them.
void FixPour::find_last_tag()
{
    tagint largest = state_.last_tag;
    for (int i = 0; i < atom->nlocal; ++i) largest = std::max(largest, atom->tag[i]);
    MPI_Allreduce(&largest, &state_.last_tag, 1, MPI_LMP_TAGINT, MPI_MAX, world);
    if (static_cast<bigint>(state_.last_tag) + number_ - state_.inserted >= MAXTAGINT)
        refuse("would give atoms larger IDs than LAMMPS has: renumber them by reset_atom_ids");
}

/// Adds the new grains to the number of atoms and to the map of their tags.
void FixPour::announce(bigint count)
{
    atom->natoms += count;
    if (atom->map_style == 0) return;
    atom->map_init();
    atom->map_set();
}

void FixPour::warn_of_full_region()
{
    if (warned_) return;
    warned_ = true;
    if (comm->me != 0) return;
    std::string const step = std::to_string(update->ntimestep), tried = std::to_string(attempts_);
    error->warning(FLERR, std::string(pour_style) + ": region " + region_id_ + " is full in step " +
                              step + ": " + tried + " places of grain " +
                              std::to_string(state_.inserted + 1) +
                              " overlap other grains or walls. It waits, and is tried again in "
                              "later insertions. Use a "
                              "larger region, a lower rate, a larger velocity, or more attempts");
}

double FixPour::compute_vector(int k)
{
    double const inserted = compute_scalar();
    return std::array{inserted, state_.mass, std::floor(state_.wanted) - inserted,
                      static_cast<double>(state_.refused)}[static_cast<std::size_t>(k)];
}

void FixPour::write_restart(FILE *file)
{
    if (comm->me != 0) return;
    int const size = sizeof(state_);
    std::fwrite(&size, sizeof(size), 1, file);
    std::fwrite(&state_, sizeof(state_), 1, file);
}

void FixPour::restart(char *state)
{
    std::memcpy(&state_, state, sizeof(state_));
    if (state_.inserted > number_)
        refuse("has inserted " + std::to_string(state_.inserted) +
               " grains before the restart: give a number of grains of at least that");
}

double FixPour::memory_usage()
{
    return ellipsoids_.bytes() +
           static_cast<double>(
               (others_.centers.capacity() + others_.forms.capacity() + others_.radii.capacity()) *
               sizeof(double));
}

} // namespace pw85_lammps
