// SPDX-License-Identifier: BSD-3-Clause
// The C API: quadratic forms.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/contact/forms.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_ellipsoid_quaternion(int status,
                                                                    double const semi_axes[3],
                                                                    double const quaternion[4],
                                                                    double q[6]) noexcept
{
    return refuse_call(status, "pw85_ellipsoid_quaternion",
                       Argument("semi_axes", semi_axes, 3, limit::positive | limit::finite_square),
                       Argument("quaternion", quaternion, 4, limit::not_zero), Argument("q", q));
}

int pw85_ellipsoid_quaternion(double const semi_axes[3], double const quaternion[4], double q[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_ellipsoid_quaternion(status, semi_axes, quaternion, q);
    };
    if (any_null(semi_axes, quaternion, q)) return refused(null_pointer(q, 6));
    int const status = in_default_environment([&] {
        auto const result = pw85::ellipsoid_quaternion(load_vector<3>(semi_axes),
                                                       load_vector<4>(quaternion));
        return put(result.status, result.q, q);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_ellipsoid_factor(int status,
                                                                double const semi_axes[3],
                                                                double const quaternion[4],
                                                                double s[9]) noexcept
{
    return refuse_call(status, "pw85_ellipsoid_factor",
                       Argument("semi_axes", semi_axes, 3, limit::positive | limit::finite_square),
                       Argument("quaternion", quaternion, 4, limit::not_zero), Argument("s", s));
}

int pw85_ellipsoid_factor(double const semi_axes[3], double const quaternion[4], double s[9])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_ellipsoid_factor(status, semi_axes, quaternion, s);
    };
    if (any_null(semi_axes, quaternion, s)) return refused(null_pointer(s, 9));
    int const status = in_default_environment([&] {
        auto const result = pw85::ellipsoid_factor(load_vector<3>(semi_axes),
                                                   load_vector<4>(quaternion));
        return put(result.status, result.s, s);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_ellipse(int status, double a, double b, double angle,
                                                       double q[3]) noexcept
{
    return refuse_call(status, "pw85_ellipse",
                       Argument("a", a, limit::positive | limit::finite_square),
                       Argument("b", b, limit::positive | limit::finite_square),
                       Argument("angle", angle), Argument("q", q));
}

int pw85_ellipse(double a, double b, double angle, double q[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_ellipse(status, a, b, angle, q);
    };
    if (any_null(q)) return refused(null_pointer(q, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::ellipse(a, b, angle);
        return put(result.status, result.q, q);
    });
    return checked(status, refused);
}
