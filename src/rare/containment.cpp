// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: containment by integers.
#include <pw85/overlap/exact_containment.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(contains_exactly)

} // namespace pw85::detail
