// SPDX-License-Identifier: BSD-3-Clause
// The contact function of one pair, correctly rounded. It is compiled for the baseline and for one
// newer instruction set (meson.build).
#include "../one_pair.hpp"

#include <pw85/overlap/contact_rounded.hpp>

#include "../../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace PW85_BUILDING {

int contact_rounded(double const *r12, double const *q1, double const *q2, double *out) noexcept
{
    auto const result =
        pw85::contact_rounded(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
    return put(result.status, result.mu2, out, result.lambda, out + 1);
}

} // namespace PW85_BUILDING

} // namespace pw85::detail::kernels
