// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random sequential addition in a periodic cell.
///
/// 1. Attempts draw particles in the whole cell. Threads test many of them against the packing, and
///    then one thread tests those that are free against the ones added before, in their order. So
///    the result does not depend on the number of threads.
/// 2. Rounds of attempts end with a decision: if few of them succeeded, voxels (voxels.hpp) are
///    made, or halved. A round that a limit interrupts is continued by the next call, so that the
///    result does not depend on the limits of calls before.
/// 3. If there are voxels, attempts draw in them. Those elsewhere would fail, so that an attempt in
///    a fraction of all voxels counts as the inverse of this fraction, which is the mean number of
///    attempts for one that hits a voxel.
#ifndef PW85_ADDITION_ADDITION_HPP_INCLUDED
#define PW85_ADDITION_ADDITION_HPP_INCLUDED

#include <algorithm>

#include "voxels.hpp"

namespace pw85::detail::sequential_addition {
namespace {

/// The minimum number of attempts of a round, and the ratio of successful attempts below which
/// voxels are divided. They change the time, but not the distribution of packings.
constexpr std::size_t min_attempts = 4096;
constexpr double first_few_accepted = 0.02;

/// The task of the random numbers of an attempt, whose number is their step: no domain of a sweep
/// and no event chain has this task.
constexpr std::uint32_t stream_of_attempts = UINT32_MAX - 1;

/// Limits of an addition.
struct Limits {
    double attempts;
    std::size_t particles;
};

template <int D> class Addition {
  public:
    /// @param all_species not empty; the object takes them
    Addition(Cell<D> const &cell, Array<Species<D>> &&all_species, std::uint64_t seed) noexcept
        : all_species_(std::move(all_species)), packing_(cell), voxels_(all_species_, cell),
          seed_(seed)
    {
    }

    /// Allocates the memory of the empty cell. Returns false if there is none.
    [[nodiscard]] bool prepare() noexcept
    {
        double outer = 0.0;
        for (std::size_t k = 0; k < all_species_.size(); ++k)
            outer = maximum(outer, all_species_[k].outer());
        return packing_.divide(outer);
    }

    Packing<D> const &packing() const noexcept { return packing_; }
    double attempts() const noexcept
    {
        if (attempts_in_voxels_ == 0) return attempts_before_; // there may be no voxel
        return attempts_before_ + static_cast<double>(attempts_in_voxels_) / share();
    }
    double share() const noexcept { return voxels_.share(); }
    bool is_saturated() const noexcept { return voxels_.is_saturated(); }

    /// Makes attempts of a round, and divides voxels if this was its end and few of them succeeded.
    /// Returns false if there is no memory.
    [[nodiscard]] bool advance(Limits const &limits) noexcept
    {
        if (is_saturated() || packing_.size() >= limits.particles || attempts() >= limits.attempts)
            return true;
        if (round_.left == 0) begin_round();
        // From the last division on, so that the number does not depend on limits before
        double const all = elementary::ceil((limits.attempts - attempts_before_) * share()),
                     left = maximum(1.0, all - static_cast<double>(attempts_in_voxels_));
        auto const number =
            static_cast<std::size_t>(minimum(left, static_cast<double>(round_.left)));
        return try_many(number, limits.particles) && (round_.left > 0 || end_round());
    }

  private:
    /// Attempts after which voxels may be divided.
    struct Round {
        std::size_t attempts, left, particles_before;
    };

    void begin_round() noexcept
    {
        std::size_t const number =
            std::max({min_attempts, packing_.size() / 4, minimum(voxels_.size(), max_voxels / 8)});
        round_ = {number, number, packing_.size()};
    }

    /// Divides voxels if few attempts of the round succeeded. Returns false if there is no memory.
    [[nodiscard]] bool end_round() noexcept
    {
        bool const is_slow = static_cast<double>(packing_.size() - round_.particles_before) <
                             few_accepted_ * static_cast<double>(round_.attempts);
        // Attempts without voxels take about as long as making the voxels.
        bool const is_early = !voxels_.exist() && attempts() < voxels_.total();
        if (!is_slow || is_early) return true;
        double const made = attempts();
        Division const division = voxels_.divide(packing_);
        if (division == Division::too_many) few_accepted_ /= 2;
        if (division == Division::done) attempts_before_ = made, attempts_in_voxels_ = 0;
        return division != Division::no_memory;
    }

    Particle<D> drawn(std::uint64_t attempt) const noexcept
    {
        return voxels_.draw_any(Stream(seed_, attempt, stream_of_attempts), packing_.cell());
    }

    /// Makes attempts up to a number of particles. Returns false if there is no memory: attempts
    /// that were made count.
    [[nodiscard]] bool try_many(std::size_t number, std::size_t most_particles) noexcept
    {
        constexpr std::size_t attempts_per_task = 256;
        if (!is_free_.resize(number)) return false;
        std::size_t const tasks = (number + attempts_per_task - 1) / attempts_per_task;
        for_tasks(tasks, tasks > 1, [&](std::size_t task) {
            std::size_t const end = minimum((task + 1) * attempts_per_task, number);
            for (std::size_t k = task * attempts_per_task; k < end; ++k)
                is_free_[k] = packing_.is_free(drawn(next_ + k));
        });
        std::size_t k = 0;
        bool has_memory = true;
        while (k < number && packing_.size() < most_particles && has_memory) {
            if (is_free_[k]) has_memory = add_if_free(drawn(next_ + k));
            k += has_memory; // an attempt without memory is made again
        }
        next_ += k;
        attempts_in_voxels_ += k;
        round_.left -= k;
        return has_memory;
    }

    /// Returns false if there is no memory.
    [[nodiscard]] bool add_if_free(Particle<D> const &one) noexcept
    {
        return !packing_.is_free(one) || packing_.add(one);
    }

    Array<Species<D>> all_species_;
    Packing<D> packing_;
    Voxels<D> voxels_;
    Array<bool> is_free_;
    Round round_{};
    std::uint64_t seed_, next_ = 0, attempts_in_voxels_ = 0; ///< since the last division
    double attempts_before_ = 0.0, few_accepted_ = first_few_accepted;
};

} // namespace
} // namespace pw85::detail::sequential_addition

#endif
