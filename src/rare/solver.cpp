// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: the contact function by wider numbers.
#include <pw85/contact/contact.hpp>
#include <pw85/contact/geometry.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(has_positive_minors)
PW85_DEFINE(maximize_wider)
PW85_DEFINE_OF(search_in_steps, exact::Extended<double>, 2)
PW85_DEFINE_OF(search_in_steps, exact::Extended<double>, 3)
PW85_DEFINE(solve_blend_extended)

} // namespace pw85::detail
