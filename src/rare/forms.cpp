// SPDX-License-Identifier: BSD-3-Clause
// What hardly ever runs: forms of any magnitudes, and those of lengths and quaternions.
#include <pw85/contact/forms.hpp>
#include <pw85/contact/scaling.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(validate_scaled)
PW85_DEFINE_OF(form_of_any_axes, double)

} // namespace pw85::detail
