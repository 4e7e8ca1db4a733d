// SPDX-License-Identifier: BSD-3-Clause
// Insertions and removals: see insertions.hpp.
#include "insertions.hpp"

#include <algorithm>

#include "../neighbors/bounded_list.hpp"
#include "../rows/many_pairs.hpp"

namespace pw85::detail::simulation {

namespace {

/// No particle, among those whose pairs count.
constexpr std::size_t none = SIZE_MAX;

/// Images that are tested together.
constexpr std::size_t most_candidates = 64;

/// Returns a uniform orientation: a point of a ball of four dimensions, or of a disc, divided by
/// its length.
Quaternion random_orientation(Stream &stream, int dimensions) noexcept
{
    if (dimensions == 2) {
        Vector3 const x = stream.in_disc();
        double const length = elementary::sqrt(x[0] * x[0] + x[1] * x[1]);
        return {x[0] / length, 0.0, 0.0, x[1] / length};
    }
    Quaternion x;
    double square;
    do {
        x = {stream.symmetric(), stream.symmetric(), stream.symmetric(), stream.symmetric()};
        square = dot(x, x);
    } while (square > 1.0);
    return x / elementary::sqrt(square);
}

} // namespace

int Insertions::prepare(std::size_t more) noexcept
{
    Configuration const &all = particles_.all();
    if (!all.cell.find_lattice(periodicity_)) return PW85_EINVAL;
    shortest_ = periodicity_.shortest();
    listed_ = 0.0;
    std::size_t const n = all.size();
    longest_ = all.longest_semi_axis();
    double const longest = n > 0 ? longest_ : 1.0;
    if (int const status = bins_.prepare(all, bin_size * longest, more)) return status;
    if (!numbers_.resize(n + more)) return PW85_ENOMEM;
    for (std::size_t k = 0; k < n; ++k)
        numbers_[bins_.number_in_configuration(k)] = static_cast<std::int32_t>(k);
    for (std::size_t k = n; k < n + more; ++k) numbers_[k] = static_cast<std::int32_t>(k);
    return PW85_SUCCESS;
}

int Insertions::add(Particle const &particle) noexcept
{
    std::size_t const n = particles_.all().size();
    if (int const status = particles_.add(particle)) return status;
    longest_ = maximum(longest_, largest_coordinate(particle.semi_axes));
    bins_.add(static_cast<std::size_t>(numbers_[n]), n, particle.center, particle.half_widths);
    return PW85_SUCCESS;
}

void Insertions::remove(std::size_t i) noexcept
{
    std::size_t const last = particles_.all().size() - 1;
    bins_.take_out(static_cast<std::size_t>(numbers_[i]));
    std::swap(numbers_[i], numbers_[last]);
    bins_.rename(static_cast<std::size_t>(numbers_[i]), i);
    particles_.remove(i);
}

bool Insertions::overlaps_others(Particle const &particle) const noexcept
{
    Configuration const &all = particles_.all();
    double r12[3 * most_candidates], q2[6 * most_candidates];
    std::size_t count = 0;
    bool overlaps = false;
    auto const test = [&] {
        int any = 0;
        kernels::find_overlap(kernels::OneToMany{particle.q.entries, r12, q2}, count, any);
        overlaps = any != 0;
        count = 0;
    };
    bins_.visit(particle.center, (1.0 + 0x1p-20) * particle.half_widths,
                [&](std::size_t k, Multiples const &cell) {
                    if (overlaps) return;
                    std::size_t const j = bins_.number_in_configuration(k);
                    Vector3 const r = separation(particle.center, all.centers[j],
                                                 all.cell.translation(bins_.image_in(cell, k)));
                    std::copy_n(r.coordinates, 3, r12 + 3 * count);
                    std::copy_n(all.q[j].entries, 6, q2 + 6 * count);
                    if (++count == most_candidates) test();
                });
    if (count > 0 && !overlaps) test();
    return overlaps;
}

double Insertions::longest_axis(Particle const &particle) const noexcept
{
    double longest = 0.0;
    for (int d = 0; d < particles_.all().dimensions; ++d)
        longest = maximum(longest, particle.semi_axes[d]);
    return longest;
}

/// Lists the images of a particle whose boxes may meet its own if no half-width is above `reach`.
/// None does where the shortest vector of the lattice is longer than twice that.
int Insertions::list_own_images(double reach) noexcept
{
    double const width = (1.0 + 0x1p-40) * 2.0 * reach;
    if (width <= listed_) return PW85_SUCCESS;
    Array<neighbors::LatticeVector> vectors;
    std::size_t count = 0;
    if (shortest_ <= width) {
        double const half = 0.5 * width;
        if (int const status =
                neighbors::list_images(periodicity_, {{-half, -half, -half}, {half, half, half}},
                                       neighbors::bounded.images, vectors))
            return status;
        if (!own_images_.resize(vectors.size())) return PW85_ENOMEM;
        for (std::size_t k = 1; k < vectors.size(); ++k) {
            Vector3 const image = particles_.all().cell.translation(vectors[k].of_cell);
            own_images_[count] = image;
            count += largest_coordinate(image) <= width;
        }
    }
    if (!own_images_.resize(count)) return PW85_ENOMEM;
    listed_ = width;
    return PW85_SUCCESS;
}

int Insertions::test_images(Particle const &particle, bool &is_free) noexcept
{
    if (int const status = list_own_images(longest_axis(particle))) return status;
    auto const overlap = PW85_OF_PAIR(kernels::chosen(), overlap);
    is_free = true;
    for (std::size_t k = 0; k < own_images_.size() && is_free; ++k) {
        int answer = 0;
        if (int const status = overlap(own_images_[k].coordinates, particle.q.entries,
                                       particle.q.entries, &answer))
            return is_free = false, status;
        is_free = answer == 0;
    }
    return PW85_SUCCESS;
}

int Insertions::test(Particle const &particle, bool &is_free) noexcept
{
    is_free = false;
    if (hamiltonian_.external.cuts(particle, particles_.all().dimensions) ||
        overlaps_others(particle))
        return PW85_SUCCESS;
    return test_images(particle, is_free);
}

/// Adds the energies of a particle with images of all others but one, and with its own images. The
/// bins know the boxes of the other particles without the reach: only the query is enlarged, by the
/// reach of both.
int Insertions::add_pair_energy(Particle const &particle, std::size_t skipped,
                                double &energy) noexcept
{
    PairEnergy const &pairs = hamiltonian_.pairs;
    if (!pairs.exists()) return PW85_SUCCESS;
    Configuration const &all = particles_.all();
    double const reach = pairs.reach(), others = (reach - 1.0) * longest_;
    EnergyCollector collected(pairs);
    Vector3 const half_widths = reach * particle.half_widths + Vector3{others, others, others};
    bins_.visit(particle.center, (1.0 + 0x1p-20) * half_widths,
                [&](std::size_t k, Multiples const &cell) {
                    std::size_t const j = bins_.number_in_configuration(k);
                    if (j == skipped) return;
                    Vector3 const r = separation(particle.center, all.centers[j],
                                                 all.cell.translation(bins_.image_in(cell, k)));
                    collected.add(r, particle.q, all.q[j], 2);
                });
    if (int const status = list_own_images(reach * longest_axis(particle))) return status;
    for (std::size_t k = 0; k < own_images_.size(); ++k)
        collected.add(own_images_[k], particle.q, particle.q, 2);
    EnergySum const sum = collected.sum();
    energy += sum.energy();
    return sum.is_bad ? PW85_EPOTENTIAL : PW85_SUCCESS;
}

/// Draws a particle at a random position in the cell.
bool Insertions::draw(Stream &stream, Vector3 const &semi_axes, Particle &particle) const noexcept
{
    Configuration const &all = particles_.all();
    Vector3 center{};
    for (int k = 0; k < all.dimensions; ++k)
        center = add_scaled(center, stream.uniform(), all.cell.vector(k));
    if (all.dimensions == 2) center[2] = all.size() > 0 ? all.centers[0][2] : 0.0;
    particle = {center, random_orientation(stream, all.dimensions), semi_axes, {}, {}};
    return particle.shape();
}

int Insertions::try_weight(Vector3 const &semi_axes, double &weight) noexcept
{
    Configuration const &all = particles_.all();
    Stream stream(parameters_.seed, parameters_.step, 0);
    Particle particle;
    weight = 0.0;
    bool is_free = draw(stream, semi_axes, particle);
    if (is_free)
        if (int const status = test(particle, is_free)) return status;
    double energy =
        is_free ? hamiltonian_.external.energy(all.size(), particle, all.dimensions) : 0.0;
    if (elementary::isnan(energy)) return ExternalPotential::refuse_energy();
    if (is_free)
        if (int const status = add_pair_energy(particle, none, energy)) return status;
    ++parameters_.step;
    // e^800 is infinity, as are larger powers, for which exponential() is not made
    if (is_free)
        weight =
            energy > 700.0 ? 0.0 : exponential(Doubled<Pack>(Pack(minimum(800.0, -energy))))[0];
    return PW85_SUCCESS;
}

int Insertions::try_exchange(std::span<Species> species, InsertionCounts &counts) noexcept
{
    Stream stream(parameters_.seed, parameters_.step, 0);
    Species &chosen = species[stream.below(static_cast<std::uint32_t>(species.size()))];
    bool const inserts = stream.below(2) == 0;
    int const status =
        inserts ? try_insertion(chosen, stream, counts) : try_removal(chosen, stream, counts);
    if (status == PW85_SUCCESS) ++parameters_.step;
    return status;
}

int Insertions::try_insertion(Species &species, Stream &stream, InsertionCounts &counts) noexcept
{
    Configuration const &all = particles_.all();
    Particle particle;
    bool is_free = draw(stream, species.semi_axes, particle);
    double energy = hamiltonian_.external.energy(all.size(), particle, all.dimensions);
    if (elementary::isnan(energy)) return ExternalPotential::refuse_energy();
    double const ratio = species.activity * all.volume() / static_cast<double>(species.count + 1);
    // Pairs that overlap have no energy, so the overlap test comes first. Without pair energies it
    // comes last, because it takes the longest time.
    bool const is_tested = hamiltonian_.pairs.exists();
    if (is_free && is_tested)
        if (int const status = test(particle, is_free)) return status;
    if (is_free)
        if (int const status = add_pair_energy(particle, none, energy)) return status;
    is_free = is_free && accept(ratio, 1.0, energy, stream.uniform());
    if (is_free && !is_tested)
        if (int const status = test(particle, is_free)) return status;
    if (is_free)
        if (int const status = add(particle)) return status;
    species.count += is_free;
    ++counts.insertions;
    counts.inserted += is_free;
    return PW85_SUCCESS;
}

int Insertions::try_removal(Species &species, Stream &stream, InsertionCounts &counts) noexcept
{
    Configuration const &all = particles_.all();
    bool is_accepted = false;
    if (species.count > 0) {
        std::size_t i;
        do i = stream.below(static_cast<std::uint32_t>(all.size()));
        while (!are_equal(species.semi_axes, all.semi_axes[i]));
        double energy = hamiltonian_.external.energy(i, all.get(i), all.dimensions);
        if (elementary::isnan(energy)) return ExternalPotential::refuse_energy();
        if (int const status = add_pair_energy(all.get(i), i, energy)) return status;
        double const ratio = static_cast<double>(species.count) / (species.activity * all.volume());
        is_accepted =
            all.is_in_cell(all.centers[i]) && accept(ratio, 1.0, -energy, stream.uniform());
        if (is_accepted) remove(i);
    }
    species.count -= is_accepted;
    ++counts.removals;
    counts.removed += is_accepted;
    return PW85_SUCCESS;
}

} // namespace pw85::detail::simulation
