// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Neighbour lists of simulations. Their time and memory per particle are bounded, whatever the
/// lengths of particles, steps and cutoffs are.
#ifndef PW85_NEIGHBORS_BOUNDED_LIST_HPP_INCLUDED
#define PW85_NEIGHBORS_BOUNDED_LIST_HPP_INCLUDED

#include <pw85_systems.h>

#include "search.hpp"

namespace pw85::detail::neighbors {

/// Each group of particles is tested with each image, which takes some 10 ns: 2¹⁵ images take less
/// than 0.05 ms for each particle. They are those of a box as long as 16 cells in each direction.
/// A pair takes some 50 bytes and 0.1 µs, or some 10 µs if it needs exact arithmetic. So 2¹³ pairs
/// take less than 0.1 s for each particle.
constexpr ListLimits bounded{0x1p15, 0x1p13};

/// A list as pw85_neighbors_create() makes it, but at most as long as `bounded` says.
class BoundedList {
  public:
    [[gnu::always_inline]] BoundedList() noexcept = default;
    [[gnu::always_inline]] ~BoundedList() { pw85_neighbors_destroy(list_); }
    BoundedList(BoundedList const &) = delete;
    BoundedList &operator=(BoundedList const &) = delete;

    /// Makes the list, once. A longer one is refused with PW85_ENOMEM and a cause.
    int make(pw85_system const &system, double scale, double skin = 0.0) noexcept;

    pw85_pair_list pairs() const noexcept { return pw85_neighbors_list(list_); }

  private:
    pw85_neighbors *list_ = nullptr;
};

} // namespace pw85::detail::neighbors

#endif
