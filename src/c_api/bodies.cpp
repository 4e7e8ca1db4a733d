// SPDX-License-Identifier: BSD-3-Clause
// The C API: surface and inertia of bodies.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/bodies/inertia.hpp>
#include <pw85/bodies/surface.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_surface_area(int status, double const q[6],
                                                            double *area) noexcept
{
    return refuse_call(status, "pw85_surface_area", Argument("q", q, 6, limit::definite),
                       Argument("area", area));
}

int pw85_surface_area(double const q[6], double *area)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_surface_area(status, q, area);
    };
    if (any_null(q, area)) return refused(null_pointer(area, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::surface_area(load_matrix<3>(q));
        return put(result.status, result.area, area);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_second_moments(int status, double const q[6],
                                                              double moments[6]) noexcept
{
    return refuse_call(status, "pw85_second_moments", Argument("q", q, 6, limit::definite),
                       Argument("moments", moments));
}

int pw85_second_moments(double const q[6], double moments[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_second_moments(status, q, moments);
    };
    if (any_null(q, moments)) return refused(null_pointer(moments, 6));
    int const status = in_default_environment([&] {
        auto const result = pw85::second_moments(load_matrix<3>(q));
        return put(result.status, result.moments, moments);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_from_moments(int status,
                                                            double const second_moments[6],
                                                            double q[6]) noexcept
{
    return refuse_call(status, "pw85_from_moments",
                       Argument("second_moments", second_moments, 6, limit::definite),
                       Argument("q", q));
}

int pw85_from_moments(double const second_moments[6], double q[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_from_moments(status, second_moments, q);
    };
    if (any_null(second_moments, q)) return refused(null_pointer(q, 6));
    int const status = in_default_environment([&] {
        auto const result = pw85::from_moments(load_matrix<3>(second_moments));
        return put(result.status, result.q, q);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_shell_moments(int status, double const q[6],
                                                             double moments[6]) noexcept
{
    return refuse_call(status, "pw85_shell_moments", Argument("q", q, 6, limit::definite),
                       Argument("moments", moments));
}

int pw85_shell_moments(double const q[6], double moments[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_shell_moments(status, q, moments);
    };
    if (any_null(q, moments)) return refused(null_pointer(moments, 6));
    int const status = in_default_environment([&] {
        auto const result = pw85::shell_moments(load_matrix<3>(q));
        return put(result.status, result.moments, moments);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_inertia(int status, double const q[6], int shell,
                                                       double inertia[6]) noexcept
{
    return refuse_call(status, "pw85_inertia", Argument("q", q, 6, limit::definite),
                       Argument("shell", shell), Argument("inertia", inertia));
}

int pw85_inertia(double const q[6], int shell, double inertia[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_inertia(status, q, shell, inertia);
    };
    if (any_null(q, inertia)) return refused(null_pointer(inertia, 6));
    int const status = in_default_environment([&] {
        auto const result = pw85::inertia(load_matrix<3>(q), shell);
        return put(result.status, result.inertia, inertia);
    });
    return checked(status, refused);
}
