// SPDX-License-Identifier: BSD-3-Clause
// The C function for the smallest ellipsoid around points.
#include <memory>
#include <new>

#include <pw85_enclosing.h>

#include "../base/floating_point_environment.hpp"
#include "around_ellipsoids.hpp"
#include "smallest.hpp"

using namespace pw85;
using namespace pw85::detail;
using enclosing::Search;

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

/// Returns whether the bytes of m rows can be counted, and whether the tolerance is allowed.
bool is_allowed(int columns, std::size_t m, double tolerance) noexcept
{
    return m <= PTRDIFF_MAX / (static_cast<std::size_t>(columns) * sizeof(double)) &&
           tolerance > 0.0 && tolerance <= largest_number<double>();
}

bool has_ellipsoid(Status status) noexcept
{
    return status == Status::success || status == Status::no_convergence;
}

Status find(int n, std::size_t m, double const *points, double tolerance,
            Outputs const &outputs) noexcept
{
    std::unique_ptr<Search> const search(new (std::nothrow) Search(n, m, points));
    if (search == nullptr) return Status::out_of_memory;
    Status const status = search->run(tolerance);
    if (has_ellipsoid(status)) outputs.put(*search);
    return status;
}

Status find_around(enclosing::Ellipsoids const &bodies, double tolerance,
                   Outputs const &outputs) noexcept
{
    using enclosing::AroundEllipsoids;
    std::unique_ptr<AroundEllipsoids> const around(new (std::nothrow) AroundEllipsoids(bodies));
    if (around == nullptr) return Status::out_of_memory;
    Status const status = around->run(tolerance);
    if (has_ellipsoid(status)) outputs.put(*around);
    return status;
}

} // namespace

int pw85_enclosing_ellipsoid(int n, size_t m, double const *points, double tolerance,
                             double *center, double *q, double *excess)
{
    bool const is_dimension = n >= 1 && n <= enclosing::max_dimension;
    Outputs const outputs{is_dimension ? n : 0, center, q, excess};
    outputs.fill_with_nan();
    if (!is_dimension || points == nullptr || m <= static_cast<size_t>(n)) return PW85_EINVAL;
    if (!is_allowed(n, m, tolerance)) return PW85_EINVAL;
    return in_default_environment(
        [&] { return static_cast<int>(find(n, m, points, tolerance, outputs)); });
}

int pw85_enclosing_ellipsoid_of(int n, size_t m, double const *centers, double const *forms,
                                double tolerance, double *center, double *q, double *excess)
{
    bool const is_dimension = n >= 1 && n <= enclosing::max_dimension;
    Outputs const outputs{is_dimension ? n : 0, center, q, excess};
    outputs.fill_with_nan();
    if (!is_dimension || centers == nullptr || forms == nullptr || m == 0) return PW85_EINVAL;
    if (!is_allowed(any_dimension::packed_size(n), m, tolerance)) return PW85_EINVAL;
    return in_default_environment([&] {
        return static_cast<int>(find_around({n, m, centers, forms}, tolerance, outputs));
    });
}
