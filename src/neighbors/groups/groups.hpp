// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The pairs of boxes of two groups. search.cpp calls pair_groups_of(). The function is compiled
/// once per instruction set: with AVX-512, six comparisons test a box against a block of eight. All
/// find the same pairs, because comparisons do not round.
#ifndef PW85_NEIGHBORS_GROUPS_GROUPS_HPP_INCLUDED
#define PW85_NEIGHBORS_GROUPS_GROUPS_HPP_INCLUDED

#include "../../simd/targets.hpp"
#include "../search.hpp"

namespace pw85::detail::neighbors {

/// The blocks of a group, moved by the lattice vector number `image`.
struct MovedGroup {
    Block blocks[width];
    std::size_t group, image;
};

/// Finds the pairs of a moved group with another group. Returns false if there is no memory.
using PairGroups = bool(Tree const &, MovedGroup const &, std::size_t group, FoundPairs &) noexcept;

} // namespace pw85::detail::neighbors

namespace pw85::detail::kernels {

#define PW85_DECLARE_GROUPS(target, one_pair, lanes256, available)                                 \
    namespace target {                                                                             \
    neighbors::PairGroups pair_groups;                                                             \
    }
PW85_EACH_TARGET(PW85_DECLARE_GROUPS)
#undef PW85_DECLARE_GROUPS

namespace {

/// Returns the function of a target.
inline auto pair_groups_of(Target const &target) noexcept
{
    return PW85_OF_LANES(target, neighbors::PairGroups, pair_groups);
}

} // namespace
} // namespace pw85::detail::kernels

#endif
