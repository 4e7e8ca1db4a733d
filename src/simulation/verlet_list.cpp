// SPDX-License-Identifier: BSD-3-Clause
// Verlet lists of sessions: see verlet_list.hpp.
#include "verlet_list.hpp"

#include <algorithm>
#include <atomic>

#include "../simd/one_pair.hpp"

namespace pw85::detail::simulation {

namespace {

/// Particles per block of a thread: each takes some hundred nanoseconds.
constexpr std::size_t block_of_particles = 256;

} // namespace

bool VerletList::holds(Particles const &particles, double reach) noexcept
{
    Configuration const &all = particles.copy();
    if (reach != reach_ || all.dimensions != dimensions_ || rows_.size() != all.size())
        return false;
    if (generation_ == particles.generation()) return true;
    return deform(particles) && holds_all(all);
}

int VerletList::rebuild(Particles const &particles, double reach, double skin) noexcept
{
    Configuration const &all = particles.copy();
    dimensions_ = all.dimensions;
    reach_ = reach;
    skin_ = skin;
    widest_ = 2.0 * (reach * particles.sizes().longest) + skin;
    int status = rows_.update(all, reach, skin);
    if (status == PW85_SUCCESS && !boxes_.resize(all.size(), rows_.num_images()))
        status = PW85_ENOMEM;
    if (status == PW85_SUCCESS)
        refresh_boxes(particles);
    else
        rows_ = Neighborhood();
    return status;
}

void VerletList::refresh_boxes(Particles const &particles) noexcept
{
    generation_ = particles.generation();
    boxes_.refresh(particles.copy(), rows_, particles.sizes().longest, reach_, widest_);
}

bool VerletList::deform(Particles const &particles) noexcept
{
    if (!rows_.set_cell(particles.copy().cell)) return false;
    refresh_boxes(particles);
    return true;
}

bool VerletList::holds_all(Configuration const &all, double displacement) const noexcept
{
    if (rows_.size() != all.size()) return false;
    return for_all(all.size(), [&](Range range) {
               std::size_t i = range.begin;
               while (i < range.end && holds(i, all, displacement)) ++i;
               return Failure{i, i < range.end};
           }) == 0;
}

/// Returns whether particle i overlaps an image that lanes do not decide. Also true if the pair is
/// bad.
[[gnu::cold]] bool VerletList::overlaps_image(std::size_t i, Configuration const &all,
                                              Neighbor const &image) const noexcept
{
    auto const j = static_cast<std::size_t>(image.index);
    Vector3 const r12 = all.separation(i, j, rows_.translation(image.image));
    int overlap = -1; // stays where the pair is bad
    PW85_OF_PAIR(kernels::chosen(), overlap)
    (r12.coordinates, all.q[i].entries, all.q[j].entries, &overlap);
    return overlap != 0;
}

/// Returns whether particle i overlaps any of some images.
bool VerletList::overlaps_any(std::size_t i, Configuration const &all, Neighbor const *images,
                              std::size_t count) const noexcept
{
    kernels::OneToImages rows;
    rows.center = all.centers[i].coordinates;
    rows.q1 = all.q[i].entries;
    rows.images = images;
    rows.centers = all.centers.data()->coordinates;
    rows.q = all.q.data()->entries;
    rows.translations = rows_.translations()->coordinates;
    kernels::Worklist left;
    if (kernels::find_overlap_of(kernels::chosen())(rows, count, left)) return true;
    return std::any_of(left.indices, left.indices + left.size,
                       [&](std::uint16_t k) { return overlaps_image(i, all, images[k]); });
}

bool VerletList::any_overlaps(Configuration const &all) const noexcept
{
    std::atomic<bool> found{false};
    for_all(
        all.size(),
        [&](Range range) {
            for (std::size_t i = range.begin;
                 i < range.end && !found.load(std::memory_order_relaxed); ++i)
                if (overlaps(i, all, [i](std::size_t j) { return j >= i; }))
                    found.store(true, std::memory_order_relaxed);
            return Failure{0, PW85_SUCCESS};
        },
        block_of_particles);
    return found.load();
}

EnergySum VerletList::energy_of_all(Configuration const &all, PairEnergy const &law) const noexcept
{
    std::atomic<std::int64_t> halves{0};
    std::atomic<bool> is_bad{false};
    for_all(all.size(), [&](Range range) {
        EnergySum sum;
        for (std::size_t i = range.begin; i < range.end; ++i)
            sum.add(energy(i, all, law, [i](std::size_t j) { return j >= i; }));
        halves.fetch_add(sum.halves, std::memory_order_relaxed);
        if (sum.is_bad) is_bad.store(true, std::memory_order_relaxed);
        return Failure{0, PW85_SUCCESS};
    });
    return {halves.load(), is_bad.load()};
}

} // namespace pw85::detail::simulation
