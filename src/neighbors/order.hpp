/// @file
/// An order of points in which neighbours in space are near each other: along Morton's curve.
#ifndef PW85_NEIGHBORS_ORDER_HPP_INCLUDED
#define PW85_NEIGHBORS_ORDER_HPP_INCLUDED

#include <cstdint>

#include "array.hpp"
#include "boxes.hpp"

namespace pw85::neighbors {

/// A point on the curve, and its number.
struct Place {
    std::uint64_t key;
    std::int32_t index;
};

/// The position on the curve through a box, which is divided into 2²¹ parts along each axis, of the middle of another box.
std::uint64_t key_of(Box const &box, Box const &around) noexcept;

/// Sorts by keys; places with the same key stay in their order. False if there is no memory.
[[nodiscard]] bool sort(Array<Place> &places) noexcept;

} // namespace pw85::neighbors

#endif
