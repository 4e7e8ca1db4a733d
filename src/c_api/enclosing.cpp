// SPDX-License-Identifier: BSD-3-Clause
// The C API of enclosing ellipsoids and random points, by hand: the number of dimensions and the
// causes of a refusal are not those of functions of a pair.
#include <algorithm>

#include <pw85_enclosing.h>

#include <pw85/contact/scaling.hpp>

#include "../any_dimension/causes.hpp"
#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"
#include "../enclosing/functions.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;
using enclosing::Outputs;

namespace {

void fill_with_nan(Outputs const &out) noexcept
{
    store_nan(out.center, out.n);
    store_nan(out.q, enclosing::at(out.n, 0));
    store_nan(out.excess, 1);
}

/// A call: the function, its n, and the smallest m.
struct Call {
    char const *function;
    int n;
    std::size_t m, least;
    double tolerance;

    /// Records that all ellipsoids or points together are the cause.
    int refuse_all(int status, char const *argument, char const *requirement) const noexcept
    {
        return refuse(status, {0, function, argument, requirement, 0, 0, quiet_nan<double>()});
    }
};

/// Records what is wrong with n, m, the tolerance, or pointers. Returns success if nothing is
/// wrong.
template <class... Arrays>
int status_of_call(Call const &call, int columns, Arrays... arrays) noexcept
{
    if (call.n < 1 || call.n > enclosing::max_dimension)
        return any_dimension::refuse_dimension(call.function, call.n);
    bool const is_null = ((arrays.pointer == nullptr) || ...);
    if (is_null || call.m > PTRDIFF_MAX / (static_cast<std::size_t>(columns) * sizeof(double)))
        return refuse_arrays(call.function, "m", call.m, arrays...);
    if (call.m < call.least)
        return refuse(PW85_EINVAL,
                      {0, call.function, "m",
                       call.least == 1 ? "must be at least 1" : "must be at least n + 1", 0, 0,
                       static_cast<double>(call.m)});
    if (call.tolerance > 0.0 && call.tolerance <= largest_number<double>()) return PW85_SUCCESS;
    return refuse_call(PW85_EINVAL, call.function,
                       Argument("tolerance", call.tolerance, limit::positive));
}

/// Records why numbers were refused: the first row that is not finite, or else the extents. Returns
/// the status.
[[gnu::cold, gnu::noinline]] int refuse_rows(Call const &call, Argument const &rows,
                                             Argument const &others) noexcept
{
    for (Argument const *one : {&rows, &others})
        for (std::size_t i = 0; i < one->count; ++i)
            if (!is_finite(one->numbers()[i])) return refuse_call(PW85_EINVAL, call.function, *one);
    return call.refuse_all(PW85_EINVAL, rows.name,
                           "must have an extent between 2^-480 and 2^480 along each coordinate");
}

/// Records the cause of a status that has no ellipsoid, or one whose excess is too large.
[[gnu::cold, gnu::noinline]] int refuse_result(int status, Call const &call) noexcept
{
    char const *const text =
        status == PW85_ECONVERGENCE ? "the excess is above the tolerance" : pw85_strerror(status);
    return call.refuse_all(status, nullptr, text);
}

} // namespace

int pw85_enclosing_ellipsoid(int n, size_t m, double const *points, double tolerance,
                             double *center, double *q, double *excess)
{
    bool const is_dimension = n >= 1 && n <= enclosing::max_dimension;
    Outputs const outputs{is_dimension ? n : 0, center, q, excess};
    Call const call{"pw85_enclosing_ellipsoid", n, m, static_cast<size_t>(n) + 1, tolerance};
    fill_with_nan(outputs);
    int status = status_of_call(call, n, NamedArray{"points", points});
    if (status != PW85_SUCCESS) return status;
    status = in_default_environment(
        [&] { return static_cast<int>(enclose(n, m, points, tolerance, outputs)); });
    if (status == PW85_EINVAL) {
        auto const rows = Argument::rows("points", points, m, static_cast<size_t>(n));
        return refuse_rows(call, rows, rows);
    }
    return checked(status, [&](int bad) PW85_IN_COLD_PATH {
        if (bad != PW85_ENOTPD) return refuse_result(bad, call);
        return call.refuse_all(bad, "points", "must not be in a hyperplane, or too close to one");
    });
}

int pw85_enclosing_ellipsoid_of(int n, size_t m, double const *centers, double const *forms,
                                double tolerance, double *center, double *q, double *excess)
{
    bool const is_dimension = n >= 1 && n <= enclosing::max_dimension;
    int const columns = is_dimension ? any_dimension::packed_size(n) : 1;
    Outputs const outputs{is_dimension ? n : 0, center, q, excess};
    Call const call{"pw85_enclosing_ellipsoid_of", n, m, 1, tolerance};
    fill_with_nan(outputs);
    int status =
        status_of_call(call, columns, NamedArray{"centers", centers}, NamedArray{"forms", forms});
    if (status != PW85_SUCCESS) return status;
    status = in_default_environment([&] {
        enclosing::Ellipsoids const bodies{n, m, centers, forms};
        return static_cast<int>(enclose(bodies, tolerance, outputs));
    });
    auto const size = static_cast<size_t>(columns);
    if (status == PW85_EINVAL)
        return refuse_rows(call, Argument::rows("centers", centers, m, static_cast<size_t>(n)),
                           Argument::rows("forms", forms, m, size));
    for (size_t i = 0; status == PW85_ENOTPD && i < m; ++i)
        if (any_dimension::is_indefinite(n, forms + i * size))
            return refuse(status, {0, call.function, "forms", "must be positive definite", i, 0,
                                   quiet_nan<double>()});
    return checked(status, [&](int bad) PW85_IN_COLD_PATH {
        if (bad != PW85_ENOTPD) return refuse_result(bad, call);
        return call.refuse_all(bad, nullptr, "the ellipsoid is too flat to be certified");
    });
}

int pw85_random_points(double const q[6], int surface, size_t seed, size_t num_points,
                       double *points)
{
    if (num_points > PTRDIFF_MAX / (3 * sizeof(double)) || (num_points > 0 && any_null(points)))
        return refuse_arrays("pw85_random_points", "num_points", num_points,
                             NamedArray{"points", points});
    int const found = in_default_environment([&] {
        auto const status =
            any_null(q) ? Status::invalid_argument : Status(validate(load_matrix<3>(q)));
        if (status == Status::success)
            enclosing::draw_points(load_matrix<3>(q), surface != 0, seed, num_points, points);
        else
            std::fill_n(points, 3 * num_points, quiet_nan<double>());
        return put(status);
    });
    return checked(found, [&](int status) {
        return refuse_call(status, "pw85_random_points", Argument("q", q, 6, limit::definite));
    });
}
