/// @file
/// The pairs of boxes of a tree that meet, images included.
#ifndef PW85_NEIGHBORS_SEARCH_HPP_INCLUDED
#define PW85_NEIGHBORS_SEARCH_HPP_INCLUDED

#include "array.hpp"
#include "periodicity.hpp"
#include "tree.hpp"

namespace pw85::detail::neighbors {

/// Box `second` meets box `first` moved by a multiple of the lattice's vectors, the number of which is `image`.
struct Found {
    std::int32_t first, second, image;
};

/// Pairs, in the order in which they are found.
class FoundPairs {
  public:
    /// Adds pairs of the box `first` and those of a block, from number `begin` on, whose bits are set; false if there is no memory.
    [[gnu::always_inline]] bool add(std::size_t first, std::size_t begin, unsigned bits, std::size_t image) noexcept
    {
        if (size_ + width > room_.size() && !room_.resize(2 * room_.size() + 1024)) return false;
        for (; bits != 0; bits &= bits - 1)
            room_[size_++] = {static_cast<std::int32_t>(first),
                              static_cast<std::int32_t>(begin + static_cast<unsigned>(std::countr_zero(bits))),
                              static_cast<std::int32_t>(image)};
        return true;
    }

    [[gnu::always_inline]] std::size_t size() const noexcept { return size_; }
    [[gnu::always_inline]] Found const &operator[](std::size_t k) const noexcept { return room_[k]; }
    [[gnu::always_inline]] void clear() noexcept { size_ = 0; }

  private:
    Array<Found> room_;
    std::size_t size_ = 0;
};

/// The vectors by which a tree can be moved and still meet itself, number 0 being zero; of v and -v only one. PW85_ENOMEM if they are
/// too many to be listed, PW85_EINVAL if some are too far away for their multiples.
[[nodiscard]] int list_images(Periodicity const &lattice, Box const &root, Array<Move> &images) noexcept;

/// Groups whose pairs are found by one task.
inline constexpr std::size_t groups_per_task = 16;

/// The pairs whose first box is of the groups of a task, each once, in place of those found before. False if there is no memory.
[[nodiscard]] bool find_pairs(Tree const &tree, Periodicity const &lattice, Array<Move> const &images, std::size_t task,
                              FoundPairs &found) noexcept;

} // namespace pw85::detail::neighbors

#endif
