// SPDX-License-Identifier: BSD-3-Clause
// The C functions for the smallest ellipsoid around points and around ellipsoids.
#include <memory>
#include <new>

#include <pw85_enclosing.h>

#include "../any_dimension/causes.hpp"
#include "../base/floating_point_environment.hpp"
#include "affine_hull.hpp"
#include "around_ellipsoids.hpp"
#include "smallest.hpp"

using namespace pw85;
using namespace pw85::detail;
using enclosing::Search, enclosing::AffineHullSearch;

namespace {

/// The outputs of the caller, each of which may be null.
struct Outputs {
    int n;
    double *center, *q, *excess;

    void fill_with_nan() const noexcept
    {
        double const nan = quiet_nan<double>();
        for (int i = 0; center != nullptr && i < n; ++i) center[i] = nan;
        for (int k = 0; q != nullptr && k < enclosing::at(n, 0); ++k) q[k] = nan;
        if (excess != nullptr) *excess = nan;
    }

    template <class Found> void put(Found const &search) const noexcept
    {
        for (int i = 0, k = 0; i < n; ++i) {
            if (center != nullptr) center[i] = search.center(i);
            for (int j = i; q != nullptr && j < n; ++j) q[k++] = search.form(i, j);
        }
        if (excess != nullptr) *excess = search.excess();
    }
};

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

bool has_ellipsoid(Status status) noexcept
{
    return status == Status::success || status == Status::no_convergence;
}

/// Runs a search, whose constructor takes `given`. Puts what it finds. Returns its status.
template <class Found, class... Given>
Status run(double tolerance, Outputs const &outputs, Given const &...given) noexcept
{
    std::unique_ptr<Found> const search(new (std::nothrow) Found(given...));
    if (search == nullptr) return Status::out_of_memory;
    Status const status = search->run(tolerance);
    if (has_ellipsoid(status)) outputs.put(*search);
    return status;
}

/// Points in a hyperplane have the ellipsoid of their affine hull, and the status
/// not_positive_definite.
Status find(int n, std::size_t m, double const *points, double tolerance,
            Outputs const &outputs) noexcept
{
    Status const status = run<Search>(tolerance, outputs, n, m, points);
    if (status != Status::not_positive_definite) return status;
    Status const flat = run<AffineHullSearch>(tolerance, outputs, n, m, points);
    return flat == Status::out_of_memory ? flat : status;
}

} // namespace

int pw85_enclosing_ellipsoid(int n, size_t m, double const *points, double tolerance,
                             double *center, double *q, double *excess)
{
    bool const is_dimension = n >= 1 && n <= enclosing::max_dimension;
    Outputs const outputs{is_dimension ? n : 0, center, q, excess};
    Call const call{"pw85_enclosing_ellipsoid", n, m, static_cast<size_t>(n) + 1, tolerance};
    outputs.fill_with_nan();
    int status = status_of_call(call, n, NamedArray{"points", points});
    if (status != PW85_SUCCESS) return status;
    status = in_default_environment(
        [&] { return static_cast<int>(find(n, m, points, tolerance, outputs)); });
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
    outputs.fill_with_nan();
    int status =
        status_of_call(call, columns, NamedArray{"centers", centers}, NamedArray{"forms", forms});
    if (status != PW85_SUCCESS) return status;
    status = in_default_environment([&] {
        enclosing::Ellipsoids const bodies{n, m, centers, forms};
        return static_cast<int>(run<enclosing::AroundEllipsoids>(tolerance, outputs, bodies));
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
