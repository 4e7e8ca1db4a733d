// SPDX-License-Identifier: BSD-3-Clause
// What hardly ever runs: forms of lengths and quaternions of any magnitudes.
#include <pw85/contact/forms.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE_IN_SPACE(PW85_RARE_FORM)

} // namespace pw85::detail
