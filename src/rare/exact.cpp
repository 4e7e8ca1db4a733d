// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: overlaps and comparisons by integers.
#include <pw85/overlap/exact.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(decide_exactly)
PW85_DEFINE_OF(compare_exactly, double, 3)

} // namespace pw85::detail
