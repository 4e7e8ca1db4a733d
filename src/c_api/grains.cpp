// SPDX-License-Identifier: BSD-3-Clause
// The C API: curvature and contact of grains.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/distance/hertz.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_hertz(double const curvatures[2], double *radius, double ellipse[2])
{
    if (any_null(curvatures)) return null_pointer(radius, 1, ellipse, 2);
    return in_default_environment([&] {
        auto const result = pw85::hertz(load_vector<2>(curvatures));
        return put(result, radius, ellipse);
    });
}
