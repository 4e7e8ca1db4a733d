// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: witnesses by wider numbers and integers.
#include <pw85/overlap/witness.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_OF(maximize_precisely, double, 3)
PW85_DEFINE_OF(decide_by_extended, double, 3)

} // namespace pw85::detail
