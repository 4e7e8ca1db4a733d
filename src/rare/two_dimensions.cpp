// SPDX-License-Identifier: BSD-3-Clause
// What many functions call, and no caller inlines: two dimensions. Nothing of it is compiled
// for newer processors.
#include <pw85/contact/contact.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/overlap.hpp>

#include "../simd/define_shared.hpp"

namespace pw85::detail {
inline namespace PW85_SHARED_WITH {

PW85_DEFINE_SHARED(validate_pair, double, 2)
PW85_DEFINE_SHARED(search_in_steps, double, 2)
PW85_DEFINE_SHARED(last_factorized_evaluation, double, 2)
PW85_DEFINE_SHARED(maximize, double, 2)
PW85_DEFINE_SHARED(maximize_factorized, double, 2)
PW85_DEFINE_SHARED(decide_by_certified_value, double, 2)
PW85_DEFINE_SHARED(call_overlap, double, 2)
PW85_DEFINE_SHARED(call_contains, double, 2)

} // namespace PW85_SHARED_WITH
} // namespace pw85::detail
