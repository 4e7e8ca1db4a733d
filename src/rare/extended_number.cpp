// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: the operations of extended numbers.
#include <pw85/algebra/extended_number.hpp>

#include "define.hpp"

namespace pw85::detail::exact {

PW85_DEFINE_IN_SPACE(PW85_RARE_EXTENDED)

} // namespace pw85::detail::exact
