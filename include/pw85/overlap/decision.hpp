// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The result of one tier of the overlap test.
#ifndef PW85_OVERLAP_DECISION_HPP_INCLUDED
#define PW85_OVERLAP_DECISION_HPP_INCLUDED

#include <pw85/attributes.hpp>

namespace pw85 {

/// Certified decision of a tier.
enum class Decision { none, apart, overlap };

} // namespace pw85

namespace pw85::detail {

/// Returns the decision from two conditions, of which at most one is true. It has no branches,
/// because a processor could not predict them.
PW85_FUNCTION constexpr Decision to_decision(bool apart, bool overlap) noexcept
{
    return static_cast<Decision>(static_cast<unsigned>(apart) +
                                 2u * static_cast<unsigned>(overlap));
}

} // namespace pw85::detail

#endif
