// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sorts points along Morton's curve, which brings neighbours in space near each other in memory.
/// build_tree.cpp calls this.
///
/// The particles come in any order. For millions of them, reads from random addresses cost more
/// than everything else. So the first pass moves the points to their parts of the curve, and the
/// second pass sorts each part within the cache.
#ifndef PW85_NEIGHBORS_ORDER_HPP_INCLUDED
#define PW85_NEIGHBORS_ORDER_HPP_INCLUDED

#include <cstdint>

#include <pw85/algebra/symmetric.hpp>

#include "../base/array.hpp"
#include "../base/parallel.hpp"
#include "boxes.hpp"

namespace pw85::detail::neighbors {

/// Returns the position of a point on the curve through a box. The curve divides the box into 2²¹
/// parts along each axis.
std::uint64_t key_of(Vector<double, 3> const &point, Box const &around) noexcept;

/// The first pass. It assigns points to parts of the curve. The points are divided into shares that
/// are processed in parallel.
class Partition {
  public:
    /// Counts the points of each part. Returns false if there is no memory.
    [[nodiscard]] bool prepare(Array<std::uint64_t> const &keys) noexcept;

    /// Calls visit(i, place) for each point i with its place in the order of the parts. Call this
    /// once, after prepare().
    template <class Visit>
    void for_places(Array<std::uint64_t> const &keys, Visit const &visit) noexcept
    {
        for_shares(keys.size(), [&](std::uint32_t *ends, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                visit(i, std::size_t{ends[part_of(keys[i])]++});
        });
    }

    std::size_t num_parts() const noexcept { return std::size_t{1} << bits_; }

    /// Returns the end of the places of a part. Call this after for_places().
    std::size_t end(std::size_t part) const noexcept
    {
        return ends_[(num_shares_ - 1) * num_parts() + part];
    }

  private:
    std::size_t part_of(std::uint64_t key) const noexcept
    {
        return static_cast<std::size_t>(key >> (63 - bits_));
    }

    /// Calls visit(ends, begin, end) for each share of n points.
    template <class Visit> void for_shares(std::size_t n, Visit const &visit) noexcept
    {
        std::size_t const rows = (n + num_shares_ - 1) / num_shares_;
        for_tasks(num_shares_, num_shares_ > 1, [&](std::size_t k) {
            visit(ends_.data() + k * num_parts(), minimum(n, k * rows), minimum(n, (k + 1) * rows));
        });
    }

    int bits_ = 0;
    std::size_t num_shares_ = 1;
    Array<std::uint32_t> ends_; ///< the next place, for each share and each part in the share
};

/// The position of a point on the curve, and the index of the point.
struct KeyedIndex {
    std::uint64_t key;
    std::int32_t index;
};

/// The second pass: sorts the points of one part by key, and by index where keys are equal. Returns
/// false if there is no memory.
[[nodiscard]] bool sort(Array<KeyedIndex> &points) noexcept;

} // namespace pw85::detail::neighbors

#endif
