// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: the factor of containment by wider numbers.
#include <pw85/overlap/containment_factor.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(minimize_dual_wider)

} // namespace pw85::detail
