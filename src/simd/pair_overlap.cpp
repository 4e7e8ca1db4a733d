// SPDX-License-Identifier: BSD-3-Clause
// The overlap of one pair. It is compiled for the baseline and for one newer instruction set (meson.build).
#include "one_pair.hpp"

#include <pw85/overlap/overlap.hpp>

#include "../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace {

Vector<double, 3> const &view_vector(double const *x) noexcept { return view<Vector<double, 3>>(x); }

SymmetricMatrix<double, 3> const &view_matrix(double const *a) noexcept { return view<SymmetricMatrix<double, 3>>(a); }

} // namespace

namespace PW85_COMPILED_FOR {

int overlap(double const *r12, double const *q1, double const *q2, int *overlap) noexcept
{
    auto const &r = view_vector(r12);
    auto const &m1 = view_matrix(q1), &m2 = view_matrix(q2);
    // The common case returns at once: a structure of results would pass through memory.
    Decision const decision = decide_by_quartic(r, m1, m2);
    if (decision != Decision::none) {
        *overlap = decision == Decision::overlap;
        return PW85_SUCCESS;
    }
    return put(overlap_near_contact(pair_of(r, m1, m2)), overlap, nullptr);
}

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
