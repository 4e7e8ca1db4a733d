// SPDX-License-Identifier: BSD-3-Clause
// Surfaces and shells by wider numbers.
#include <pw85/bodies/inertia.hpp>

#include "define.hpp"

namespace pw85::detail {

PW85_DEFINE(surface_of)
PW85_DEFINE(sheet_moments)

} // namespace pw85::detail
