// SPDX-License-Identifier: BSD-3-Clause
// What hardly ever runs: forms of any magnitudes, and those of lengths and quaternions.
#include <pw85/contact/forms.hpp>
#include <pw85/contact/scaling.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(PW85_RARE_FORM_VALIDATION)
PW85_DEFINE_IN_SPACE(PW85_RARE_FORM)

} // namespace pw85::detail
