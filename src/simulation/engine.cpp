// SPDX-License-Identifier: BSD-3-Clause
// Sweeps: see engine.hpp.
#include "engine.hpp"

#include <algorithm>
#include <cmath>

#include "../simd/one_pair.hpp"
#include "acceptance.hpp"

namespace pw85::detail::simulation {

namespace {

/// The task whose random numbers belong to a whole sweep. No domain has this number.
constexpr std::uint32_t whole_sweep = UINT32_MAX;

/// The Verlet list is rebuilt before a sweep if the clearance of a particle in its fixed box is
/// less than this part of the skin. Otherwise a particle would often leave its fixed box during the
/// sweep, and other threads would wait for the new Verlet list. At packing fraction 0.4, aspect
/// ratio 3 and with 1e4 particles, 0.02 takes a twentieth less time with one thread, but a fifth
/// more with two. Larger values rebuild the list more often: 0.1 takes some 7 % more instructions
/// for each trial, and 0.25 nearly twice as many.
constexpr double least_room = 0.05;

/// The skin over the longest semi-axis takes the least time at packing fraction 0.4 and aspect
/// ratio 3 if it is this up to 1e4 particles and grows with the logarithm of their number beyond:
/// the more particles, the sooner one of them has left its fixed box.
constexpr double relative_skin = 0.75, growth_of_skin = 0.12, few_particles = 1e4;

/// The memory order is recomputed once in this many rebuilds of the Verlet list. Particles diffuse
/// slowly.
constexpr int rows_per_order = 16;

/// The least width of a domain, over the longest semi-axis. Particles whose centres are twice that
/// semi-axis apart do not overlap. The rest is for the rounding errors of the borders. They are
/// below 2⁻⁵⁰ times the coordinates.
constexpr double reach_of_domains = 2.125;

/// Returns a quaternion after a rotation by (1, v), of length one.
Quaternion turned(Quaternion const &quaternion, Vector3 const &v) noexcept
{
    auto const [w, x, y, z] = quaternion.coordinates;
    Quaternion const product = {
        w - v[0] * x - v[1] * y - v[2] * z, x + v[0] * w + v[1] * z - v[2] * y,
        y - v[0] * z + v[1] * w + v[2] * x, z + v[0] * y - v[1] * x + v[2] * w};
    return product / magnitude(product);
}

/// Rotates a quaternion about z by (1, 0, 0, v). x and y, which are zero, keep their signs.
Quaternion turned_in_plane(Quaternion const &quaternion, double v) noexcept
{
    auto const [w, x, y, z] = quaternion.coordinates;
    double const real = w - v * z, imaginary = z + v * w,
                 length = std::sqrt(real * real + imaginary * imaginary);
    return {real / length, x, y, imaginary / length};
}

} // namespace

Engine::Engine() noexcept = default;

Engine::~Engine() = default;

/// The sizes of particles in the space of the dimensions.
void Engine::measure() noexcept
{
    int const dimensions = configuration.dimensions;
    longest_ = configuration.longest_semi_axis();
    spread_ = anisotropy_ = 0.0;
    for (Vector3 const &axes : std::span(configuration.semi_axes.data(), configuration.size())) {
        auto const [least, most] =
            std::minmax_element(axes.coordinates, axes.coordinates + dimensions);
        anisotropy_ = std::max(anisotropy_, *most - *least);
    }
    for (int d = 0; d < dimensions; ++d) {
        auto const is_less = [&](Vector3 const &x, Vector3 const &y) { return x[d] < y[d]; };
        std::span const all(configuration.semi_axes.data(), configuration.size());
        if (all.empty()) continue;
        auto const [least, most] = std::minmax_element(all.begin(), all.end(), is_less);
        spread_ = std::max(spread_, (*most)[d] - (*least)[d]);
    }
}

int Engine::start() noexcept
{
    measure();
    is_started_ = is_taken_ = false;
    neighborhood_ = Neighborhood();
    boxes_ = FloatBoxes();
    if (!ordered_.resize(configuration.size()) || !moved_.resize(configuration.size()))
        return PW85_ENOMEM;
    if (int const status = memory_order_.prepare(configuration)) return status;
    is_started_ = true;
    return PW85_SUCCESS;
}

void Engine::set_dimensions(int dimensions) noexcept
{
    configuration.dimensions = dimensions;
    measure();
    neighborhood_ = Neighborhood(); // rows of space are longer where third semi-axes are
    forget();
}

void Engine::limit_translations(double longest) noexcept
{
    parameters.translation = std::min(parameters.translation, longest);
    for (std::size_t k = 0; k < species.size(); ++k)
        species[k].translation = std::min(species[k].translation, longest);
}

/// Copies the configuration in memory order, unless it is the same as at the last end(). There are
/// rows afterwards, also if the call before had no memory for them. Returns a status.
int Engine::begin() noexcept
{
    if (is_taken_)
        return neighborhood_.size() == ordered_.size() ? int{PW85_SUCCESS} : rebuild_list();
    if (!is_started_)
        if (int const status = start()) return status;
    ordered_.cell = configuration.cell;
    ordered_.dimensions = configuration.dimensions;
    for (std::size_t i = 0; i < configuration.size(); ++i)
        ordered_.set(memory_order_.of(i), configuration.get(i));
    std::fill_n(moved_.data(), moved_.size(), std::uint8_t{false});
    is_taken_ = true;
    if (!all_within_skin(0.0)) return rebuild_list();
    refresh_boxes();
    return PW85_SUCCESS;
}

/// Copies the particles that have moved back to the configuration. A sweep moves a third of them,
/// and their places are in random order. So the others are not copied.
void Engine::end() noexcept
{
    if (!is_taken_) return;
    configuration.cell = ordered_.cell;
    for_all(configuration.size(), [&](Range range) {
        for (std::size_t i = range.begin; i < range.end; ++i) {
            std::size_t const place = memory_order_.of(i);
            if (std::exchange(moved_[place], std::uint8_t{false}))
                configuration.set(i, ordered_.get(place));
        }
        return Failure{0, PW85_SUCCESS};
    });
}

/// Recomputes the memory order of the particles.
int Engine::order() noexcept
{
    end();
    if (int const status = memory_order_.prepare(configuration)) return status;
    neighborhood_ = Neighborhood();
    is_taken_ = false;
    return begin();
}

int Engine::rebuild_list() noexcept
{
    skin_of_rows_ = skin();
    int const status = neighborhood_.update(ordered_, pair_energy.reach(), skin_of_rows_);
    if (status == PW85_SUCCESS && boxes_.resize(ordered_.size(), neighborhood_.num_images())) {
        refresh_boxes();
        return PW85_SUCCESS;
    }
    neighborhood_ = Neighborhood();
    return status == PW85_SUCCESS ? int{PW85_ENOMEM} : status;
}

/// Recomputes the float boxes. Between two rebuilds of the Verlet list a particle moves by at most
/// twice the half-width of its fixed box along an axis.
void Engine::refresh_boxes() noexcept
{
    double const reach = pair_energy.reach();
    boxes_.refresh(ordered_, neighborhood_, longest_, reach,
                   2.0 * (reach * longest_) + skin_of_rows_);
}

// One trial moves a side of a bounding box by at most `step` or `spread_`. Half of the skin is
// more, so a trial is within the fixed boxes of Verlet lists that have just been rebuilt. A
// rotation by (1, v) turns by less than 2 |v|. The half-widths of a bounding box are between the
// shortest semi-axis and the longest one, so a rotation changes them by no more than the
// difference. All of this holds for ellipsoids that are enlarged by the reach of energies.
double Engine::skin() const noexcept
{
    auto const step_of = [&](double translation, double rotation) {
        return translation + pair_energy.reach() * std::min(2.0 * rotation * longest_, anisotropy_);
    };
    double step = step_of(parameters.translation, parameters.rotation);
    for (SpeciesSteps const &one : std::span(species.data(), species.size()))
        step = std::max(step, step_of(one.translation, one.rotation));
    double const many = std::max(1.0, static_cast<double>(ordered_.size()) / few_particles);
    double const usual = (relative_skin + growth_of_skin * std::log(many)) * longest_;
    return std::max(
        {usual, 3.0 * step,
         parameters.fractions[exchange] > 0.0 ? 2.125 * spread_ * pair_energy.reach() : 0.0});
}

bool Engine::all_within_skin(double displacement) const noexcept
{
    if (neighborhood_.size() != ordered_.size()) return false;
    return for_all(ordered_.size(), [&](Range range) {
               std::size_t i = range.begin;
               while (i < range.end && is_within_skin(i, displacement)) ++i;
               return Failure{i, i < range.end};
           }) == 0;
}

/// Returns whether particle i overlaps an image that lanes do not decide. Also true if the pair is
/// bad.
[[gnu::cold]] bool Engine::overlaps_image(std::size_t i, Neighbor const &image) const noexcept
{
    auto const j = static_cast<std::size_t>(image.index);
    Vector3 const r12 = ordered_.separation(i, j, neighborhood_.translation(image.image));
    int overlap = -1; // stays where the pair is bad
    PW85_OF_PAIR(kernels::chosen(), overlap)
    (r12.coordinates, ordered_.q[i].entries, ordered_.q[j].entries, &overlap);
    return overlap != 0;
}

/// Returns whether particle i overlaps any of some images.
bool Engine::overlaps_any(std::size_t i, Neighbor const *images, std::size_t count) const noexcept
{
    kernels::OneToImages rows;
    rows.center = ordered_.centers[i].coordinates;
    rows.q1 = ordered_.q[i].entries;
    rows.images = images;
    rows.centers = ordered_.centers.data()->coordinates;
    rows.q = ordered_.q.data()->entries;
    rows.translations = neighborhood_.translations()->coordinates;
    kernels::Worklist left;
    if (kernels::find_overlap_of(kernels::chosen())(rows, count, left)) return true;
    return std::any_of(left.indices, left.indices + left.size,
                       [&](std::uint16_t k) { return overlaps_image(i, images[k]); });
}

/// Returns whether particle i overlaps any other that a thread may read while it works on its
/// domain.
bool Engine::overlaps(std::size_t i, ReadableDomains const &readable) const noexcept
{
    if (readable.are_all()) return overlaps(i, [](std::size_t) { return true; });
    return overlaps(i, [&](std::size_t j) { return readable.contain(domains_.number_at(j)); });
}

int Engine::sweep() noexcept
{
    if (int const status = external.check_potential()) return status;
    if (external.has_energy() || pair_energy.exists()) end();
    Counts const before = parameters.counts;
    Stream stream(parameters.seed, parameters.step, whole_sweep);
    if (!all_within_skin(least_room * skin()))
        if (int const status = ++num_rows_ % rows_per_order == 0 ? order() : rebuild_list())
            return status;
    if (int const status =
            domains_.prepare(ordered_, memory_order_.all(),
                             reach_of_domains * longest_ * pair_energy.reach(), stream))
        return status;
    if (!scheduler_.prepare(domains_, stream) || !progress_.resize(scheduler_.size()))
        return PW85_ENOMEM;
    for (std::size_t k = 0; k < scheduler_.size(); ++k) {
        Label const domain = scheduler_.domain(k);
        progress_[k] = {Stream(parameters.seed, parameters.step, domains_.number(domain)),
                        static_cast<std::uint32_t>(domains_.members(domain).size())};
    }
    std::size_t const threads = most_threads();
    if (!marks_.resize(threads * domains_.size())) return PW85_ENOMEM;
    std::fill_n(marks_.data(), marks_.size(), std::uint8_t{0});
    int const status = run_all();
    if (status == PW85_EPOTENTIAL) return fail(before);
    if (status == PW85_SUCCESS) ++parameters.step;
    return status;
}

/// Works on all domains of a sweep. Returns a status.
int Engine::run_all() noexcept
{
    has_failed_.store(false, std::memory_order_relaxed);
    while (!scheduler_.for_all(domains_, [&](std::size_t k) { return run(k); })) {
        if (has_failed_.load(std::memory_order_relaxed)) return PW85_EPOTENTIAL;
        if (int const status = rebuild_list()) return status;
    }
    return PW85_SUCCESS;
}

/// Goes back to the configuration before the sweep.
int Engine::fail(Counts const &before) noexcept
{
    parameters.counts = before;
    forget();
    return ExternalPotential::refuse_energy();
}

/// Marks the domains that the calling thread may read while it works on a domain, or removes the
/// marks.
ReadableDomains Engine::set_readable(Label domain, std::uint8_t mark) noexcept
{
    auto const [thread, threads] = this_thread();
    if (threads == 1) return {};
    std::uint8_t *const marks = marks_.data() + thread * domains_.size();
    domains_.mark_readable(domain, mark, marks);
    return {marks};
}

/// Works on the domain with some position in the order. Returns whether it is finished.
bool Engine::run(std::size_t position) noexcept
{
    Label const domain = scheduler_.domain(position);
    std::span<std::int32_t const> next;
    if (position + 1 < scheduler_.size()) next = domains_.members(scheduler_.domain(position + 1));
    Counts counts_by_species[max_species];
    DomainRun own{progress_[position], domain, set_readable(domain, 1), next, {}, nullptr};
    if (species.size() > 0) {
        std::fill_n(counts_by_species, max_species, Counts{});
        own.counts_by_species = counts_by_species;
    }
    run(own);
    set_readable(domain, 0);
    progress_[position] = own.progress;
#pragma omp critical(pw85_counts)
    {
        parameters.counts.add(own.counts);
        for (std::size_t k = 0; k < species.size(); ++k)
            species_counts[k].add(counts_by_species[k]);
    }
    return own.progress.remaining == 0;
}

/// Makes the trials of a domain, until a particle leaves its fixed box. With each trial a particle
/// of the next domain is prefetched: loading it takes about the time of a trial.
void Engine::run(DomainRun &run) noexcept
{
    auto const members = domains_.members(run.domain);
    auto const count = static_cast<std::uint32_t>(members.size());
    Stream &stream = run.progress.stream;
    auto const draw = [&] { return static_cast<std::size_t>(members[stream.below(count)]); };
    for (; run.progress.remaining > 0; --run.progress.remaining) {
        if (run.progress.remaining <= run.next.size())
            prefetch(static_cast<std::size_t>(run.next[run.progress.remaining - 1]));
        Stream const before = stream;
        Move const move = choose(stream);
        std::size_t const i = draw();
        Outcome const outcome =
            move == exchange ? try_exchange(i, draw(), run) : try_move(move, i, run);
        if (outcome == Outcome::failed) {
            has_failed_.store(true, std::memory_order_relaxed);
            return;
        }
        if (outcome == Outcome::unlisted) {
            stream = before;
            return;
        }
        ++run.counts.trials[move];
        run.counts.accepted[move] += outcome == Outcome::accepted;
        if (run.counts_by_species == nullptr || move == exchange) continue;
        if (std::size_t const k = species_of(ordered_.semi_axes[i]); k < species.size()) {
            ++run.counts_by_species[k].trials[move];
            run.counts_by_species[k].accepted[move] += outcome == Outcome::accepted;
        }
    }
}

Move Engine::choose(Stream &stream) const noexcept
{
    double x = stream.uniform();
    int move = 0;
    while (move + 1 < num_particle_moves && x >= parameters.fractions[move])
        x -= parameters.fractions[move++];
    return static_cast<Move>(move);
}

/// Returns whether walls and energies accept a trial.
[[gnu::noinline]] Engine::Outcome Engine::acceptance_of(std::size_t const *particles,
                                                        Particle const *moved, std::size_t count,
                                                        Stream &stream) const noexcept
{
    int const dimensions = ordered_.dimensions;
    for (std::size_t k = 0; k < count; ++k)
        if (external.cuts(moved[k], dimensions)) return Outcome::rejected;
    if (!external.has_energy()) return Outcome::accepted;
    double change = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        auto const number = static_cast<std::size_t>(memory_order_.particle(particles[k]));
        change += external.energy(number, moved[k], dimensions) -
                  external.energy(number, ordered_.get(particles[k]), dimensions);
    }
    if (std::isnan(change)) return Outcome::failed;
    if (change <= 0.0) return Outcome::accepted;
    return accept(1.0, 0.0, change, stream.uniform()) ? Outcome::accepted : Outcome::rejected;
}

/// Moves particles to their new positions, and back unless the trial is accepted. An overlap that
/// is found is certain, wherever the fixed boxes are. accept_energy_change() is called last, with
/// the particles as they were.
template <class Overlaps, class Accept>
Engine::Outcome Engine::accept_or_revert(std::size_t const *particles, Particle const *moved,
                                         std::size_t count, Overlaps const &overlaps_others,
                                         Accept const &accept_energy_change) noexcept
{
    Particle old[2];
    for (std::size_t k = 0; k < count; ++k) {
        old[k] = ordered_.get(particles[k]);
        put(particles[k], moved[k]);
    }
    Outcome outcome = Outcome::accepted;
    for (std::size_t k = 0; k < count && outcome != Outcome::rejected; ++k) {
        if (overlaps_others(particles[k]))
            outcome = Outcome::rejected;
        else if (!is_within_skin(particles[k]))
            outcome = Outcome::unlisted;
    }
    if (outcome == Outcome::accepted) outcome = accept_energy_change(old);
    for (std::size_t k = 0; k < count; ++k) {
        if (outcome == Outcome::accepted)
            moved_[particles[k]] = true;
        else
            put(particles[k], old[k]);
    }
    return outcome;
}

Engine::Outcome Engine::try_move(Move move, std::size_t i, DomainRun &run) noexcept
{
    Particle moved = ordered_.get(i);
    Stream &stream = run.progress.stream;
    int const dimensions = ordered_.dimensions;
    SpeciesSteps const steps = steps_of(moved.semi_axes);
    if (move != rotation)
        moved.center =
            add_scaled(moved.center, external.shortened(steps.translation, moved.semi_axes),
                       stream.in_ball(dimensions));
    if (move != translation) {
        if (dimensions == 2)
            moved.quaternion =
                turned_in_plane(moved.quaternion, steps.rotation * stream.symmetric());
        else
            moved.quaternion = turned(moved.quaternion, steps.rotation * stream.in_ball());
        if (!moved.shape()) return Outcome::rejected;
    }
    if (move != rotation && domains_.label_of(moved.center) != run.domain) return Outcome::rejected;
    if (!external.is_empty())
        if (Outcome const outcome = acceptance_of(&i, &moved, 1, stream);
            outcome != Outcome::accepted)
            return outcome;
    return accept_or_revert(
        &i, &moved, 1, [&](std::size_t k) { return overlaps(k, run.readable); },
        [&](Particle *old) { return acceptance_of_pairs(&i, old, &moved, 1, run); });
}

/// Tries to exchange the semi-axes of two particles.
Engine::Outcome Engine::try_exchange(std::size_t i, std::size_t j, DomainRun &run) noexcept
{
    std::size_t const particles[2] = {i, j};
    Particle moved[2] = {ordered_.get(i), ordered_.get(j)};
    std::swap(moved[0].semi_axes, moved[1].semi_axes);
    auto const &[first, second] = moved;
    bool const alike =
        std::equal(std::begin(first.semi_axes.coordinates), std::end(first.semi_axes.coordinates),
                   second.semi_axes.coordinates);
    if (alike || !moved[0].shape() || !moved[1].shape()) return Outcome::rejected;
    if (!external.is_empty())
        if (Outcome const outcome = acceptance_of(particles, moved, 2, run.progress.stream);
            outcome != Outcome::accepted)
            return outcome;
    return accept_or_revert(
        particles, moved, 2, [&](std::size_t k) { return overlaps(k, run.readable); },
        [&](Particle *old) { return acceptance_of_pairs(particles, old, moved, 2, run); });
}

// Tests a new position, and accepts it if wanted. If the position is outside of the fixed box, the
// Verlet list is rebuilt for the test. A rejected particle may then be outside of its new fixed
// box, and the engine starts again from the configuration.
int Engine::try_placement(std::size_t particle, Particle const &moved, bool take,
                          bool &is_free) noexcept
{
    if (int const status = begin()) return status;
    std::size_t const i = memory_order_.of(particle);
    Particle const old = ordered_.get(i);
    auto const test = [&] {
        return accept_or_revert(
            &i, &moved, 1,
            [&](std::size_t k) { return overlaps(k, [](std::size_t) { return true; }); },
            [](Particle *) { return Outcome::accepted; });
    };
    Outcome outcome = test();
    int status = PW85_SUCCESS;
    if (outcome == Outcome::unlisted) {
        put(i, moved);
        status = rebuild_list();
        outcome = status == PW85_SUCCESS ? test() : Outcome::rejected;
    }
    is_free = outcome == Outcome::accepted;
    if (is_free && take) {
        configuration.set(particle, moved);
        return status;
    }
    put(i, old);
    if (neighborhood_.size() != ordered_.size() || !is_within_skin(i)) forget();
    return status;
}

int Engine::find_neighbors(std::size_t particle, Array<NearImage> &found) noexcept
{
    if (int const status = begin()) return status;
    std::size_t const i = memory_order_.of(particle);
    auto const row = neighborhood_.row(i);
    if (!found.resize(row.size())) return PW85_ENOMEM;
    std::size_t count = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
        Neighbor const near = row[k];
        auto const j = static_cast<std::size_t>(near.index);
        Vector3 const r12 = ordered_.separation(i, j, neighborhood_.translation(near.image));
        Vector3 const reach = ordered_.half_widths[i] + ordered_.half_widths[j];
        bool meets = true;
        for (int d = 0; d < 3; ++d) meets &= absolute(r12[d]) <= reach[d];
        if (meets)
            found[count++] = {memory_order_.particle(j), neighborhood_.multiples(near.image), r12};
    }
    std::sort(found.data(), found.data() + count, [](NearImage const &a, NearImage const &b) {
        if (a.particle != b.particle) return a.particle < b.particle;
        return std::lexicographical_compare(a.image.n, a.image.n + 3, b.image.n, b.image.n + 3);
    });
    return found.resize(count) ? PW85_SUCCESS : PW85_ENOMEM;
}

} // namespace pw85::detail::simulation
