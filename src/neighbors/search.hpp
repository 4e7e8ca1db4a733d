// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the pairs of boxes of a tree that intersect, with periodic images. neighbors.cpp calls
/// list_images(), and runs find_pairs() for each task.
#ifndef PW85_NEIGHBORS_SEARCH_HPP_INCLUDED
#define PW85_NEIGHBORS_SEARCH_HPP_INCLUDED

#include <cmath>

#include "../base/array.hpp"
#include "periodicity.hpp"
#include "tree.hpp"

namespace pw85::detail::neighbors {

/// Box `second` intersects box `first` after box `first` is moved by the lattice vector number
/// `image`.
struct Found {
    std::int32_t first, second, image;
};

/// A growing array of pairs.
class FoundPairs {
  public:
    /// Adds the pairs of box `first` with box `begin` + k for each bit k that is set. Returns false
    /// if there is no memory.
    [[gnu::always_inline]] bool add(std::size_t first, std::size_t begin, unsigned bits,
                                    std::size_t image) noexcept
    {
        if (size_ + width > room_.size() && !room_.resize(2 * room_.size() + 1024)) return false;
        for (; bits != 0; bits &= bits - 1)
            room_[size_++] = {
                static_cast<std::int32_t>(first),
                static_cast<std::int32_t>(begin + static_cast<unsigned>(std::countr_zero(bits))),
                static_cast<std::int32_t>(image)};
        return true;
    }

    [[gnu::always_inline]] std::size_t size() const noexcept { return size_; }
    [[gnu::always_inline]] Found const &operator[](std::size_t k) const noexcept
    {
        return room_[k];
    }
    [[gnu::always_inline]] void clear() noexcept { size_ = 0; }

  private:
    Array<Found> room_;
    std::size_t size_ = 0;
};

/// Largest numbers for which a list is made.
struct ListLimits {
    double images = most_multiples; ///< lattice vectors, of which the list has one of v and -v
    double pairs = HUGE_VAL;        ///< per particle of a task; lists have a pair once
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
