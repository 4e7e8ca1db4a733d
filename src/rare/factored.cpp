// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: pairs by their factors, in wider numbers.
#include <pw85/contact/contact_factored.hpp>
#include <pw85/overlap/exact_factored.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_OF(search_doubled, double, 3)
PW85_DEFINE_OF(decide_factored_exactly, double, 3)

} // namespace pw85::detail
