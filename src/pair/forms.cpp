// SPDX-License-Identifier: BSD-3-Clause
// The C API: forms of ellipsoids that are not those of their templates, argument by argument
// (api/shims.py makes the others).
#include <pw85.h>

#include <pw85/contact/forms.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

void pw85_spheroid(double a, double c, double const n[3], double q[6])
{
    if (any_null(n, q)) return store_nan(q, PW85_SYM);
    in_default_environment([&] { store(spheroid(a, c, load_vector<3>(n)).q, q); });
}

int pw85_ellipsoid(double const semi_axes[3], double const rotation[9], double q[6])
{
    if (any_null(semi_axes, rotation, q)) return null_pointer(q, PW85_SYM);
    double r[9];
    for (int i = 0; i < 9; ++i) r[i] = rotation[i];
    return in_default_environment([&] {
        auto const result = ellipsoid(load_vector<3>(semi_axes), r);
        return put(result.status, result.q, q);
    });
}
