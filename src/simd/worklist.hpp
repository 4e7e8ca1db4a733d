// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lists of the pairs that a kernel has not decided. The lane kernels fill them; many_pairs.hpp
/// reads them.
#ifndef PW85_SIMD_WORKLIST_HPP_INCLUDED
#define PW85_SIMD_WORKLIST_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

namespace pw85::detail::kernels {

/// Up to `Capacity` pairs, by their indices.
template <std::size_t Capacity> struct IndexList {
    static constexpr std::size_t capacity = Capacity, largest_index = UINT16_MAX;

    std::size_t size = 0;
    std::uint16_t indices[Capacity];

    [[gnu::always_inline]] void push(std::size_t index) noexcept
    {
        indices[size++] = static_cast<std::uint16_t>(index);
    }
};

/// The pairs that lanes leave over to the function for one pair. There is room for two chunks of
/// any kernel.
using Worklist = IndexList<512>;

} // namespace pw85::detail::kernels

#endif
