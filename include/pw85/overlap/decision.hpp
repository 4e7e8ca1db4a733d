/// @file
/// What a test for overlap can conclude.
#ifndef PW85_OVERLAP_DECISION_HPP_INCLUDED
#define PW85_OVERLAP_DECISION_HPP_INCLUDED

#include <pw85/attributes.hpp>

namespace pw85 {

/// What is certain after a test.
enum class Decision { none, apart, overlap };

} // namespace pw85

namespace pw85::detail {

/// The decision from two conditions, of which at most one holds. Which one cannot be foreseen: no branches.
PW85_FUNCTION constexpr Decision to_decision(bool apart, bool overlap) noexcept
{
    return static_cast<Decision>(static_cast<unsigned>(apart) + 2u * static_cast<unsigned>(overlap));
}

} // namespace pw85::detail

#endif
