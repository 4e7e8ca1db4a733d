// SPDX-License-Identifier: BSD-3-Clause
// Sweeps: see sweep.hpp.
#include "sweep.hpp"

#include <algorithm>

namespace pw85::detail::simulation {

namespace {

/// The task whose random numbers belong to a whole sweep. No domain has this number.
constexpr std::uint32_t whole_sweep = UINT32_MAX;

/// The fixed box of a particle is moved before a sweep if the clearance of the particle in it is
/// less than this part of the skin. Otherwise a particle would often leave its fixed box during the
/// sweep, and other threads would wait for the Verlet list. At packing fraction 0.4, aspect
/// ratio 3 and with 1e4 particles, 0.02 takes a twentieth less time with one thread, but a fifth
/// more with two. Larger values rebuild the list more often: 0.1 takes some 7 % more instructions
/// for each trial, and 0.25 nearly twice as many.
constexpr double least_room = 0.05;

/// The memory order is recomputed once in this many rebuilds of the Verlet list. Particles diffuse
/// slowly.
constexpr int rebuilds_per_order = 16;

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
                 length = elementary::sqrt(real * real + imaginary * imaginary);
    return {real / length, x, y, imaginary / length};
}

} // namespace

int Sweeps::run() noexcept
{
    if (int const status = model_.hamiltonian.external.check_potential()) return status;
    if (model_.hamiltonian.has_energy()) model_.particles.commit();
    Counts const before = model_.parameters.counts;
    if (int const status = prepare_list()) return status;
    if (int const status = prepare_domains()) return status;
    if (int const status = recenter_all({loose_.data(), num_loose_})) return status;
    int const status = run_all();
    if (status == PW85_SUCCESS) ++model_.parameters.step;
    if (status != PW85_EPOTENTIAL) return status;
    model_.parameters.counts = before;
    model_.particles.roll_back();
    return ExternalPotential::refuse_energy();
}

int Sweeps::prepare_list() noexcept
{
    Particles &particles = model_.particles;
    double const room = least_room * model_.skin();
    bool are_few = false;
    if (int const status = find_loose(room, are_few)) return status;
    if (are_few) return PW85_SUCCESS;
    num_loose_ = 0;
    if (++num_rebuilds_ % rebuilds_per_order == 0)
        if (int const status = particles.reorder()) return status;
    return model_.rebuild_list();
}

/// Lists the particles with less room in their fixed boxes, if they are few enough to move their
/// boxes alone. Returns a status.
int Sweeps::find_loose(double room, bool &are_few) noexcept
{
    Configuration const &all = model_.particles.copy();
    if (!loose_.resize(model_.list.rows().room())) return PW85_ENOMEM;
    std::atomic<std::size_t> count{0};
    for_all(all.size(), [&](Range range) {
        for (std::size_t i = range.begin; i < range.end; ++i) {
            if (model_.list.holds(i, all, room)) continue;
            std::size_t const k = count.fetch_add(1, std::memory_order_relaxed);
            if (k < loose_.size()) loose_[k] = static_cast<std::int32_t>(i);
        }
        return Failure{0, PW85_SUCCESS};
    });
    num_loose_ = count.load();
    are_few = num_loose_ <= loose_.size();
    return PW85_SUCCESS;
}

/// Centres the fixed boxes of some particles, or makes another list. Returns a status.
int Sweeps::recenter_all(std::span<std::int32_t const> places) noexcept
{
    for (std::int32_t const place : places) {
        int const status = recenter(place);
        if (status == PW85_EINVAL) return model_.rebuild_list();
        if (status != PW85_SUCCESS) return status;
    }
    return PW85_SUCCESS;
}

/// Centres the fixed boxes of the particles whose trials would leave them. Returns a status.
int Sweeps::recenter_unlisted() noexcept
{
    std::size_t count = 0;
    if (!loose_.resize(2 * progress_.size())) return PW85_ENOMEM;
    for (Progress &progress : std::span(progress_.data(), progress_.size()))
        for (std::int32_t &place : progress.unlisted)
            if (std::int32_t const one = std::exchange(place, -1); one >= 0) loose_[count++] = one;
    return recenter_all({loose_.data(), count});
}

/// Centres the fixed box of a particle at its present position. Returns a status, PW85_EINVAL if
/// the Verlet list must be rebuilt.
int Sweeps::recenter(std::int32_t place) noexcept
{
    auto const i = static_cast<std::size_t>(place);
    Configuration const &all = model_.particles.copy();
    double const reach = model_.list.reach_of_recentered();
    if (!(reach < infinity<double>())) return PW85_EINVAL;
    if (!domains_.list_near(all.centers[i], reach, near_)) return PW85_ENOMEM;
    return model_.list.recenter(i, all, model_.skin(), {near_.begin(), near_.size()});
}

/// Divides the cell, and draws the order of the domains.
int Sweeps::prepare_domains() noexcept
{
    Stream stream(model_.parameters.seed, model_.parameters.step, whole_sweep);
    double const reach =
        reach_of_domains * model_.particles.sizes().longest * model_.hamiltonian.pairs.reach();
    if (int const status = domains_.prepare(model_.particles.copy(), model_.particles.order().all(),
                                            reach, stream))
        return status;
    if (!scheduler_.prepare(domains_, stream) || !progress_.resize(scheduler_.size()) ||
        !marks_.resize(most_threads() * domains_.size()))
        return PW85_ENOMEM;
    for (std::size_t k = 0; k < scheduler_.size(); ++k) {
        Label const domain = scheduler_.domain(k);
        progress_[k] = {
            Stream(model_.parameters.seed, model_.parameters.step, domains_.number(domain)),
            static_cast<std::uint32_t>(domains_.members(domain).size()),
            {-1, -1}};
    }
    std::fill_n(marks_.data(), marks_.size(), std::uint8_t{0});
    return PW85_SUCCESS;
}

/// Works on all domains. Returns a status.
int Sweeps::run_all() noexcept
{
    has_failed_.store(false, std::memory_order_relaxed);
    while (!scheduler_.for_all(domains_, [&](std::size_t k) { return run(k); })) {
        if (has_failed_.load(std::memory_order_relaxed)) return PW85_EPOTENTIAL;
        if (int const status = recenter_unlisted()) return status;
    }
    return PW85_SUCCESS;
}

/// Marks the domains that the calling thread may read while it works on a domain, or removes the
/// marks.
ReadableDomains Sweeps::set_readable(Label domain, std::uint8_t mark) noexcept
{
    auto const [thread, threads] = this_thread();
    if (threads == 1) return {};
    std::uint8_t *const marks = marks_.data() + thread * domains_.size();
    domains_.mark_readable(domain, mark, marks);
    return {marks};
}

/// Works on the domain with some position in the order. Returns whether it is finished.
bool Sweeps::run(std::size_t position) noexcept
{
    Label const domain = scheduler_.domain(position);
    std::span<std::int32_t const> next;
    if (position + 1 < scheduler_.size()) next = domains_.members(scheduler_.domain(position + 1));
    Counts counts_by_species[max_species];
    DomainRun own{progress_[position], domain, set_readable(domain, 1), next, {}, nullptr};
    if (model_.parameters.species.size() > 0) {
        std::fill_n(counts_by_species, max_species, Counts{});
        own.counts_by_species = counts_by_species;
    }
    run(own);
    set_readable(domain, 0);
    progress_[position] = own.progress;
#pragma omp critical(pw85_counts)
    {
        model_.parameters.counts.add(own.counts);
        for (std::size_t k = 0; k < model_.parameters.species.size(); ++k)
            model_.parameters.species_counts[k].add(counts_by_species[k]);
    }
    return own.progress.remaining == 0;
}

/// Makes the trials of a domain, until one is unlisted: it is made again with the same random
/// numbers. With each trial a particle of the next domain is prefetched: loading it takes about the
/// time of a trial.
void Sweeps::run(DomainRun &run) noexcept
{
    auto const members = domains_.members(run.domain);
    auto const count = static_cast<std::uint32_t>(members.size());
    Stream &stream = run.progress.stream;
    auto const draw = [&] { return static_cast<std::size_t>(members[stream.below(count)]); };
    for (; run.progress.remaining > 0; --run.progress.remaining) {
        if (run.progress.remaining <= run.next.size()) {
            auto const next = static_cast<std::size_t>(run.next[run.progress.remaining - 1]);
            model_.particles.copy().prefetch(next);
            model_.list.prefetch(next);
        }
        Stream const before = stream;
        Move const move = choose(stream);
        std::size_t const i = draw(), j = move == exchange ? draw() : i;
        Outcome const outcome = move == exchange ? try_exchange(i, j, run) : try_move(move, i, run);
        if (outcome == Outcome::failed) {
            has_failed_.store(true, std::memory_order_relaxed);
            return;
        }
        if (outcome == Outcome::unlisted) {
            stream = before;
            run.progress.unlisted[0] = static_cast<std::int32_t>(i);
            if (j != i) run.progress.unlisted[1] = static_cast<std::int32_t>(j);
            return;
        }
        run.counts.count(move, outcome == Outcome::accepted);
        if (run.counts_by_species == nullptr || move == exchange) continue;
        std::size_t const k = model_.parameters.species_of(model_.particles.copy().semi_axes[i]);
        if (k < model_.parameters.species.size())
            run.counts_by_species[k].count(move, outcome == Outcome::accepted);
    }
}

Move Sweeps::choose(Stream &stream) const noexcept
{
    double x = stream.uniform();
    int move = 0;
    while (move + 1 < num_particle_moves && x >= model_.parameters.fractions[move])
        x -= model_.parameters.fractions[move++];
    return static_cast<Move>(move);
}

/// Tries to move or rotate a particle.
Outcome Sweeps::try_move(Move move, std::size_t i, DomainRun &run) noexcept
{
    Configuration const &all = model_.particles.copy();
    Trial<1> trial{{i}, {all.get(i)}};
    Particle &moved = trial.moved[0];
    Stream &stream = run.progress.stream;
    SpeciesSteps const steps = model_.parameters.steps_of(moved.semi_axes);
    if (move != rotation)
        moved.center = add_scaled(
            moved.center, model_.hamiltonian.external.shortened(steps.translation, moved.semi_axes),
            stream.in_ball(all.dimensions));
    if (move != translation) {
        if (all.dimensions == 2)
            moved.quaternion =
                turned_in_plane(moved.quaternion, steps.rotation * stream.symmetric());
        else
            moved.quaternion = turned(moved.quaternion, steps.rotation * stream.in_ball());
        if (!moved.shape()) return Outcome::rejected;
    }
    if (move != rotation && domains_.label_of(moved.center) != run.domain) return Outcome::rejected;
    return decide(trial, run);
}

/// Tries to exchange the semi-axes of two particles.
Outcome Sweeps::try_exchange(std::size_t i, std::size_t j, DomainRun &run) noexcept
{
    Trial<2> trial{{i, j}, {model_.particles.copy().get(i), model_.particles.copy().get(j)}};
    auto &[first, second] = trial.moved;
    std::swap(first.semi_axes, second.semi_axes);
    if (are_equal(first.semi_axes, second.semi_axes) || !first.shape() || !second.shape())
        return Outcome::rejected;
    return decide(trial, run);
}

template <std::size_t N>
inline Outcome Sweeps::decide(Trial<N> const &trial, DomainRun &run) noexcept
{
    if (!model_.hamiltonian.external.is_empty())
        if (Outcome const outcome = model_.hamiltonian.accept_external(
                model_.particles, trial.places, trial.moved, run.progress.stream);
            outcome != Outcome::accepted)
            return outcome;
    return model_.accept_or_revert(
        trial, [&](std::size_t k) { return overlaps(k, run.readable); },
        [&](Particle const *old) {
            return model_.hamiltonian.pairs.exists()
                       ? accept_energies(trial.places, old, trial.moved, run)
                       : Outcome::accepted;
        });
}

/// Returns whether particle i overlaps any other that a thread may read while it works on its
/// domain.
bool Sweeps::overlaps(std::size_t i, ReadableDomains const &readable) const noexcept
{
    if (readable.are_all())
        return model_.list.overlaps(i, model_.particles.copy(), [](std::size_t) { return true; });
    return model_.list.overlaps(i, model_.particles.copy(), [&](std::size_t j) {
        return readable.contain(domains_.number_at(j));
    });
}

/// Returns the energy of some particles that a thread moves, and of all pairs with others.
EnergySum Sweeps::energy_of(std::span<std::size_t const> places,
                            ReadableDomains const &readable) const noexcept
{
    EnergySum sum;
    for (std::size_t const i : places) {
        std::size_t const counted = i == places[0] ? SIZE_MAX : places[0];
        sum.add(model_.list.energy(i, model_.particles.copy(), model_.hamiltonian.pairs,
                                   [this, readable, counted](std::size_t j) {
                                       return readable.contain(domains_.number_at(j)) &&
                                              j != counted;
                                   }));
    }
    return sum;
}

/// Returns whether the energies of pairs accept particles in their new places.
Outcome Sweeps::accept_energies(std::span<std::size_t const> places, Particle const *old,
                                Particle const *moved, DomainRun &run) noexcept
{
    auto const energy_with = [&](Particle const *particles) {
        for (std::size_t k = 0; k < places.size(); ++k) model_.set(places[k], particles[k]);
        return energy_of(places, run.readable);
    };
    EnergySum const before = energy_with(old), after = energy_with(moved);
    return accept_energy(before, after, run.progress.stream);
}

} // namespace pw85::detail::simulation
