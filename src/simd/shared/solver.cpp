// SPDX-License-Identifier: BSD-3-Clause
// The contact function of one pair, and its solver, which other questions share
// (PW85_SHARED_BY_QUESTIONS, attributes.hpp). Both stand in one unit, because the contact function
// takes 3 % longer with the solver in another one. It is compiled for the baseline and for one
// newer instruction set (meson.build).
#define PW85_SHARED_HERE
#include "../one_pair.hpp"

#include <pw85/contact/closest_approach.hpp>
#include <pw85/overlap/certified_value.hpp>

#include "../../base/c_arrays.hpp"
#include "../define_shared.hpp"

namespace pw85::detail {

namespace PW85_BUILDING {

PW85_DEFINE_SHARED(validate_pair, double, 3)
PW85_DEFINE_SHARED(search_in_steps, double, 3)
PW85_DEFINE_SHARED(last_factorized_evaluation, double, 3)
PW85_DEFINE_SHARED(maximize, double, 3)
PW85_DEFINE_SHARED(maximize_factorized, double, 3)
PW85_DEFINE_SHARED(decide_by_certified_value, double, 3)

} // namespace PW85_BUILDING

namespace kernels {

using namespace c_api;

namespace PW85_BUILDING {

int contact(double const *r12, double const *q1, double const *q2, double *out) noexcept
{
    auto const result = pw85::contact(view_vector<3>(r12), view_matrix<3>(q1), view_matrix<3>(q2));
    return put(result.status, result.mu2, out, result.lambda, out + 1);
}

int closest_approach(double const *direction, double const *q1, double const *q2,
                     double *distance) noexcept
{
    auto const result =
        pw85::closest_approach(load_vector<3>(direction), load_matrix<3>(q1), load_matrix<3>(q2));
    return put(result.status, result.distance, distance);
}

} // namespace PW85_BUILDING

} // namespace kernels

} // namespace pw85::detail
