// SPDX-License-Identifier: BSD-3-Clause
// The first contact of one pair that moves. It is compiled for the baseline and for one newer
// instruction set (meson.build).
#include "../one_pair.hpp"

#include <pw85/motion/first_contact.hpp>

#include "../../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace PW85_BUILDING {

int first_contact(double const *r12, double const *q1, double const *q2, pw85_motion const *motion1,
                  pw85_motion const *motion2, double end, double *time) noexcept
{
    auto const result =
        pw85::first_contact(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2),
                            load_motion(*motion1), load_motion(*motion2), end);
    return put(result.status, result.time, time);
}

} // namespace PW85_BUILDING

} // namespace pw85::detail::kernels
