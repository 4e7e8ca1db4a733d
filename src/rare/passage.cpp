// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: closest passages by wider numbers.
#include <pw85/motion/closest_passage.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_OF(find_closest_passage_wider, double)

} // namespace pw85::detail
