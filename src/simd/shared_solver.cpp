// SPDX-License-Identifier: BSD-3-Clause
// What many questions call, and no caller inlines: the solver. It is compiled for the instruction sets of the functions for one pair.
#include <pw85/contact/contact.hpp>

#include "define_shared.hpp"

namespace pw85::detail {
inline namespace PW85_SHARED_WITH {

PW85_SHARED_VALIDATION(PW85_DEFINE_SHARED, double, 3)
PW85_SHARED_SEARCH(PW85_DEFINE_SHARED, double, 3)
PW85_SHARED_SOLVER(PW85_DEFINE_SHARED, double, 3)

} // namespace PW85_SHARED_WITH
} // namespace pw85::detail
