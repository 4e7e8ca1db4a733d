// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions for many rows, one per lane, that are compiled once per instruction set. A
/// kernel has two types: the rows that it reads, and the arrays that it writes. lanes/chunks.hpp
/// says how to add one.
#ifndef PW85_SIMD_LANES_HPP_INCLUDED
#define PW85_SIMD_LANES_HPP_INCLUDED

#include "pairs.hpp"
#include "targets.hpp"
#include "worklist.hpp"

namespace pw85::detail::kernels {

/// Computes pairs from the first of n on, and returns their number. It writes to `rejected_lanes`
/// the indices of the computed pairs that need the function for one pair.
template <class Rows, class Arrays>
using ComputeLanes = std::size_t(Rows const &, std::size_t n, Arrays const &,
                                 Worklist &rejected_lanes) noexcept;

/// Copies the pairs with the given indices, with the separations and images that lanes compute.
template <class Rows> using GatherPairs = void(Rows const &, std::uint16_t const *indices,
                                               std::size_t count,
                                               PairRow<Rows::dimension> *pairs) noexcept;

#define PW85_DECLARE_LANES(target, one_pair, lanes256, available)                                  \
    namespace target {                                                                             \
    template <class Rows, class Arrays>                                                            \
    std::size_t compute(Rows const &, std::size_t, Arrays const &, Worklist &) noexcept;           \
    template <class Rows> void gather(Rows const &, std::uint16_t const *, std::size_t,            \
                                      PairRow<Rows::dimension> *) noexcept;                        \
    }
PW85_EACH_TARGET(PW85_DECLARE_LANES)
#undef PW85_DECLARE_LANES

namespace {

// The functions of a target.

template <class Rows, class Arrays> auto compute_of(Target const &target) noexcept
{
    using Compute = ComputeLanes<Rows, Arrays>;
    if constexpr (has_lanes256<Rows, Arrays>)
        return PW85_OF_LANES256(target, Compute, compute);
    else
        return PW85_OF_LANES(target, Compute, compute);
}

template <class Rows> auto gather_of(Target const &target) noexcept
{
    return PW85_OF_LANES(target, GatherPairs<Rows>, gather);
}

} // namespace
} // namespace pw85::detail::kernels

#endif
