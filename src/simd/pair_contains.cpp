// SPDX-License-Identifier: BSD-3-Clause
// Whether one ellipsoid contains another. It is compiled for the baseline and for one newer instruction set (meson.build).
#include "one_pair.hpp"

#include <pw85/overlap/containment.hpp>

#include "../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace {

Vector<double, 3> const &view_vector(double const *x) noexcept { return view<Vector<double, 3>>(x); }

SymmetricMatrix<double, 3> const &view_matrix(double const *a) noexcept { return view<SymmetricMatrix<double, 3>>(a); }

} // namespace

namespace PW85_COMPILED_FOR {

int contains(double const *r12, double const *q1, double const *q2, int *contains) noexcept
{
    return put(pw85::contains(view_vector(r12), view_matrix(q1), view_matrix(q2)), contains);
}

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
