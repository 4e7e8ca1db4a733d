// SPDX-License-Identifier: BSD-3-Clause
// The overlap of one pair, also for functions that call it first (PW85_SHARED_BY_QUESTIONS). It is
// compiled for the baseline and for one newer instruction set (meson.build).
#include "../one_pair.hpp"

#include <pw85/overlap/overlap.hpp>

#include "../../base/c_arrays.hpp"
#include "../define_shared.hpp"

namespace pw85::detail {

inline namespace PW85_SHARED_WITH {

PW85_DEFINE_SHARED(call_overlap, double, 3)

} // namespace PW85_SHARED_WITH

namespace kernels {

using namespace c_api;

namespace PW85_BUILDING {

int overlap(double const *r12, double const *q1, double const *q2, int *overlap) noexcept
{
    auto const &r = view_vector<3>(r12);
    auto const &m1 = view_matrix<3>(q1), &m2 = view_matrix<3>(q2);
    // The common case returns at once: a structure of results would pass through memory.
    Decision const decision = decide_by_quartic(r, m1, m2);
    if (decision != Decision::none) {
        *overlap = decision == Decision::overlap;
        return PW85_SUCCESS;
    }
    auto const result = overlap_near_contact(pair_of(r, m1, m2));
    return put(result.status, result.overlap, overlap);
}

} // namespace PW85_BUILDING

} // namespace kernels

} // namespace pw85::detail
