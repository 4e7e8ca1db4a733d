// SPDX-License-Identifier: BSD-3-Clause
// The C API: forms of ellipsoids that are not those of their templates, argument by argument
// (api/shims.py makes the others).
#include <pw85.h>

#include <pw85/contact/forms.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

void pw85_spheroid(double a, double c, double const n[3], double q[6])
{
    if (any_null(n, q)) return store_nan(q, PW85_SYM);
    int const status = in_default_environment([&] {
        auto const result = spheroid(a, c, load_vector<3>(n));
        return put(result.status, result.q, q);
    });
    checked(status, [&](int bad) {
        constexpr unsigned length = limit::positive | limit::finite_square;
        return refuse_call(bad, "pw85_spheroid", Argument("a", a, length), Argument("c", c, length),
                           Argument("n", n, 3, limit::not_zero));
    });
}

int pw85_ellipsoid(double const semi_axes[3], double const rotation[9], double q[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(
            status, "pw85_ellipsoid",
            Argument("semi_axes", semi_axes, 3, limit::positive | limit::finite_square),
            Argument("rotation", rotation, 9, limit::rotation), Argument("q", q));
    };
    if (any_null(semi_axes, rotation, q)) return refused(null_pointer(q, PW85_SYM));
    double r[9];
    for (int i = 0; i < 9; ++i) r[i] = rotation[i];
    return checked(in_default_environment([&] {
                       auto const result = ellipsoid(load_vector<3>(semi_axes), r);
                       return put(result.status, result.q, q);
                   }),
                   refused);
}
