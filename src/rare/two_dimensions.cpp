// SPDX-License-Identifier: BSD-3-Clause
// What many functions call, and no caller inlines: two dimensions. Nothing of it is compiled
// for newer processors.
#include <pw85/contact/contact.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/overlap.hpp>

#include "../simd/define_shared.hpp"

namespace pw85::detail {
inline namespace PW85_SHARED_WITH {

PW85_SHARED_VALIDATION(PW85_DEFINE_SHARED, double, 2)
PW85_SHARED_SEARCH(PW85_DEFINE_SHARED, double, 2)
PW85_SHARED_SOLVER(PW85_DEFINE_SHARED, double, 2)
PW85_SHARED_CERTIFIED_VALUE(PW85_DEFINE_SHARED, double, 2)
PW85_SHARED_OVERLAP(PW85_DEFINE_SHARED, double, 2)
PW85_SHARED_CONTAINMENT(PW85_DEFINE_SHARED, double, 2)

} // namespace PW85_SHARED_WITH
} // namespace pw85::detail
