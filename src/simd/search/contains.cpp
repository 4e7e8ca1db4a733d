// SPDX-License-Identifier: BSD-3-Clause
// Whether one ellipsoid contains another, also for other functions that call it first
// (PW85_SHARED_BY_QUESTIONS). It is compiled for the baseline and for one newer
// instruction set (meson.build).
#include "../one_pair.hpp"

#include <pw85/overlap/containment.hpp>

#include "../../base/c_arrays.hpp"
#include "../define_shared.hpp"

namespace pw85::detail {

inline namespace PW85_SHARED_WITH {

PW85_DEFINE_SHARED(call_contains, double, 3)

} // namespace PW85_SHARED_WITH

namespace kernels {

using namespace c_api;

namespace PW85_BUILDING {

int contains(double const *r12, double const *q1, double const *q2, int *contains) noexcept
{
    auto const result = pw85::contains(view_vector<3>(r12), view_matrix<3>(q1), view_matrix<3>(q2));
    return put(result.status, result.contains, contains);
}

} // namespace PW85_BUILDING

} // namespace kernels

} // namespace pw85::detail
