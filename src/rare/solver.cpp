// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: the contact function by wider numbers.
#include <pw85/contact/contact.hpp>
#include <pw85/contact/geometry.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(PW85_RARE_DEFINITE)
PW85_DEFINE(PW85_RARE_SOLVER)
PW85_DEFINE(PW85_RARE_SEARCH)
PW85_DEFINE(PW85_RARE_GEOMETRY)

} // namespace pw85::detail
