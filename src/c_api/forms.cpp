// SPDX-License-Identifier: BSD-3-Clause
// The C API: quadratic forms.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/contact/forms.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_ellipsoid_quaternion(double const semi_axes[3], double const quaternion[4], double q[6])
{
    if (any_null(semi_axes, quaternion, q)) return null_pointer(q, 6);
    return in_default_environment([&] {
        auto const result = pw85::ellipsoid_quaternion(load_vector<3>(semi_axes),
                                                       load_vector<4>(quaternion));
        return put(result.status, result.q, q);
    });
}

int pw85_ellipsoid_factor(double const semi_axes[3], double const quaternion[4], double s[9])
{
    if (any_null(semi_axes, quaternion, s)) return null_pointer(s, 9);
    return in_default_environment([&] {
        auto const result = pw85::ellipsoid_factor(load_vector<3>(semi_axes),
                                                   load_vector<4>(quaternion));
        return put(result.status, result.s, s);
    });
}

int pw85_ellipse(double a, double b, double angle, double q[3])
{
    if (any_null(q)) return null_pointer(q, 3);
    return in_default_environment([&] {
        auto const result = pw85::ellipse(a, b, angle);
        return put(result.status, result.q, q);
    });
}
