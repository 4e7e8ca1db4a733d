// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Records the cause of a refusal of functions in n dimensions for pw85_last_error(). Nothing here
/// runs before a call has failed.
#ifndef PW85_SRC_ANY_DIMENSION_CAUSES_HPP_INCLUDED
#define PW85_SRC_ANY_DIMENSION_CAUSES_HPP_INCLUDED

#include "../base/last_error.hpp"

namespace pw85::detail::any_dimension {

/// Records that n is not from 1 to 16.
[[gnu::cold]] int refuse_dimension(char const *function, int n) noexcept;

/// Records the first argument of a pair that explains the status, and returns the status. The first
/// three arguments are r12, q1 and q2.
[[gnu::cold]] int refuse_pair(int status, char const *function, int n, Argument const *arguments,
                              std::size_t count) noexcept;

/// Returns whether a form is known not to be positive definite: where it is not, the status of a
/// function may be due to it.
bool is_indefinite(int n, double const *q) noexcept;

} // namespace pw85::detail::any_dimension

#endif
