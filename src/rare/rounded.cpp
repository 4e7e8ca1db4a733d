// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: the contact function, correctly rounded, by wider numbers.
#include <pw85/overlap/contact_rounded.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_OF(round_by_doubled_numbers, double, 3)

} // namespace pw85::detail
