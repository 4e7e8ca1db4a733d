/// @file
/// An order of points in which neighbours in space are near each other: along Morton's curve.
///
/// Particles come in any order, and what is read from all over the memory costs more than all else where there are millions of them. So
/// they are first moved to parts of the curve, each of which is then sorted within the cache.
#ifndef PW85_NEIGHBORS_ORDER_HPP_INCLUDED
#define PW85_NEIGHBORS_ORDER_HPP_INCLUDED

#include <cstdint>

#include <pw85/algebra/symmetric.hpp>

#include "array.hpp"
#include "boxes.hpp"
#include "parallel.hpp"

namespace pw85::detail::neighbors {

/// The position on the curve through a box, which is divided into 2²¹ parts along each axis, of a point.
std::uint64_t key_of(Vector<double, 3> const &point, Box const &around) noexcept;

/// Points by the part of the curve to which they belong.
class Partition {
  public:
    /// Counts the points of each part; false if there is no memory.
    [[nodiscard]] bool prepare(Array<std::uint64_t> const &keys) noexcept;

    /// Calls visit(i, place) for the points, with places in the order of the parts. To be called once.
    template <class Visit> void for_places(Array<std::uint64_t> const &keys, Visit const &visit) noexcept
    {
        for_shares(keys.size(), [&](std::uint32_t *ends, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) visit(i, std::size_t{ends[part_of(keys[i])]++});
        });
    }

    std::size_t num_parts() const noexcept { return std::size_t{1} << bits_; }

    /// Where the places of a part end, after for_places().
    std::size_t end(std::size_t part) const noexcept { return ends_[(num_shares_ - 1) * num_parts() + part]; }

  private:
    std::size_t part_of(std::uint64_t key) const noexcept { return static_cast<std::size_t>(key >> (63 - bits_)); }

    /// Calls visit(ends, begin, end) for each share of n points.
    template <class Visit> void for_shares(std::size_t n, Visit const &visit) noexcept
    {
        std::size_t const rows = (n + num_shares_ - 1) / num_shares_;
        for_tasks(num_shares_, num_shares_ > 1, [&](std::size_t k) {
            visit(ends_.data() + k * num_parts(), std::min(n, k * rows), std::min(n, (k + 1) * rows));
        });
    }

    int bits_ = 0;
    std::size_t num_shares_ = 1;
    Array<std::uint32_t> ends_; ///< for each share, and each part within it
};

/// A point on the curve, and its number.
struct Place {
    std::uint64_t key;
    std::int32_t index;
};

/// Sorts places of one part by keys; those with the same key stay in their order. False if there is no memory.
[[nodiscard]] bool sort(Array<Place> &places) noexcept;

} // namespace pw85::detail::neighbors

#endif
