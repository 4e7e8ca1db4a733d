// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the pairs of boxes of a tree that intersect, with periodic images. neighbors.cpp calls
/// list_images(), and runs find_pairs() for each task.
#ifndef PW85_NEIGHBORS_SEARCH_HPP_INCLUDED
#define PW85_NEIGHBORS_SEARCH_HPP_INCLUDED

#include <span>

#include "../base/array.hpp"
#include "periodicity.hpp"
#include "tree.hpp"

namespace pw85::detail::neighbors {

/// Pairs of boxes, in runs with the same first box.
class FoundPairs {
  public:
    /// The boxes that box `first` intersects after it is moved by the lattice vector number
    /// `image`: the second boxes from the end of the run before up to `end`.
    struct Run {
        std::int32_t first, image;
        std::size_t end;
    };

    /// Makes room for the second boxes of a block. Returns false if there is no memory.
    [[gnu::always_inline]] bool reserve_block() noexcept
    {
        return size_ + width <= seconds_.size() || seconds_.resize(2 * seconds_.size() + 1024);
    }

    /// Returns the place for the second boxes of the next block.
    [[gnu::always_inline]] std::int32_t *next() noexcept { return seconds_.data() + size_; }

    /// Takes the first `count` of them into the run.
    [[gnu::always_inline]] void extend(std::size_t count) noexcept { size_ += count; }

    /// Ends the run of a box, unless it is empty. Returns false if there is no memory.
    [[gnu::always_inline]] bool end_run(std::size_t first, std::size_t image) noexcept
    {
        if (size_ == (num_runs_ > 0 ? runs_[num_runs_ - 1].end : 0)) return true;
        if (num_runs_ == runs_.size() && !runs_.resize(2 * num_runs_ + 256)) return false;
        runs_[num_runs_++] = {static_cast<std::int32_t>(first), static_cast<std::int32_t>(image),
                              size_};
        return true;
    }

    /// Returns the number of pairs.
    [[gnu::always_inline]] std::size_t size() const noexcept { return size_; }
    [[gnu::always_inline]] std::int32_t second(std::size_t k) const noexcept { return seconds_[k]; }
    [[gnu::always_inline]] std::span<Run const> runs() const noexcept
    {
        return {runs_.data(), num_runs_};
    }
    [[gnu::always_inline]] void clear() noexcept { size_ = num_runs_ = 0; }

  private:
    Array<std::int32_t> seconds_;
    Array<Run> runs_;
    std::size_t size_ = 0, num_runs_ = 0;
};

/// Largest numbers for which a list is made.
struct ListLimits {
    double images = most_multiples;    ///< lattice vectors, of which the list has one of v and -v
    double pairs = infinity<double>(); ///< per particle of a task; lists have a pair once
};

/// Lists the lattice vectors by which a tree can be moved and still intersect itself. Number 0 is
/// zero. Of v and -v only one is in the list. Returns PW85_ENOMEM if there are more vectors than
/// `most`, and PW85_EINVAL if the multiples of one are too large.
[[nodiscard]] int list_images(Periodicity const &lattice, Box const &root, double most,
                              Array<LatticeVector> &images) noexcept;

/// The number of groups of one task.
inline constexpr std::size_t groups_per_task = 16;

/// Finds the pairs whose first box belongs to the groups of a task, each pair once. They replace
/// the pairs in `found`. Returns false if there is no memory, or if there are more than `most`
/// pairs per particle.
[[nodiscard]] bool find_pairs(Tree const &tree, Periodicity const &lattice,
                              Array<LatticeVector> const &images, std::size_t task, double most,
                              FoundPairs &found) noexcept;

} // namespace pw85::detail::neighbors

#endif
