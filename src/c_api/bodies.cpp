// SPDX-License-Identifier: BSD-3-Clause
// The C API: surface and inertia of bodies.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/bodies/inertia.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_surface_area(double const q[6], double *area)
{
    if (any_null(q, area)) return null_pointer(area, 1);
    return in_default_environment([&] {
        auto const result = pw85::surface_area(load_matrix<3>(q));
        return put(result.status, result.area, area);
    });
}

int pw85_second_moments(double const q[6], double moments[6])
{
    if (any_null(q, moments)) return null_pointer(moments, 6);
    return in_default_environment([&] {
        auto const result = pw85::second_moments(load_matrix<3>(q));
        return put(result.status, result.moments, moments);
    });
}

int pw85_from_moments(double const second_moments[6], double q[6])
{
    if (any_null(second_moments, q)) return null_pointer(q, 6);
    return in_default_environment([&] {
        auto const result = pw85::from_moments(load_matrix<3>(second_moments));
        return put(result.status, result.q, q);
    });
}

int pw85_shell_moments(double const q[6], double moments[6])
{
    if (any_null(q, moments)) return null_pointer(moments, 6);
    return in_default_environment([&] {
        auto const result = pw85::shell_moments(load_matrix<3>(q));
        return put(result.status, result.moments, moments);
    });
}

int pw85_inertia(double const q[6], int shell, double inertia[6])
{
    if (any_null(q, inertia)) return null_pointer(inertia, 6);
    return in_default_environment([&] {
        auto const result = pw85::inertia(load_matrix<3>(q), shell);
        return put(result.status, result.inertia, inertia);
    });
}
