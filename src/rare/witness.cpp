// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: witnesses by wider numbers and integers.
#include <pw85/overlap/witness.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(maximize_precisely)
PW85_DEFINE(decide_by_extended)

} // namespace pw85::detail
