// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: pairs by their factors, in wider numbers.
#include <pw85/contact/contact_factored.hpp>
#include <pw85/overlap/exact_factored.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(PW85_RARE_FACTORED)
PW85_DEFINE(PW85_RARE_EXACT_FACTORED)

} // namespace pw85::detail
