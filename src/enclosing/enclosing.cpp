// SPDX-License-Identifier: BSD-3-Clause
// The C function for the smallest ellipsoid around points.
#include <memory>
#include <new>

#include <pw85_enclosing.h>

#include "../base/floating_point_environment.hpp"
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

    void put(Search const &search) const noexcept
    {
        for (int i = 0, k = 0; i < n; ++i) {
            if (center != nullptr) center[i] = search.center(i);
            for (int j = i; q != nullptr && j < n; ++j) q[k++] = search.form(i, j);
        }
        if (excess != nullptr) *excess = search.excess();
    }
};

bool is_allowed(int n, std::size_t m, double const *points, double tolerance) noexcept
{
    auto const columns = static_cast<std::size_t>(n);
    return points != nullptr && m > columns && m <= PTRDIFF_MAX / (columns * sizeof(double)) &&
           tolerance > 0.0 && tolerance <= largest_number<double>();
}

Status find(int n, std::size_t m, double const *points, double tolerance,
            Outputs const &outputs) noexcept
{
    std::unique_ptr<Search> const search(new (std::nothrow) Search(n, m, points));
    if (search == nullptr) return Status::out_of_memory;
    Status const status = search->run(tolerance);
    if (status == Status::success || status == Status::no_convergence) outputs.put(*search);
    return status;
}

} // namespace

int pw85_enclosing_ellipsoid(int n, size_t m, double const *points, double tolerance,
                             double *center, double *q, double *excess)
{
    bool const is_dimension = n >= 1 && n <= enclosing::max_dimension;
    Outputs const outputs{is_dimension ? n : 0, center, q, excess};
    outputs.fill_with_nan();
    if (!is_dimension || !is_allowed(n, m, points, tolerance)) return PW85_EINVAL;
    return in_default_environment(
        [&] { return static_cast<int>(find(n, m, points, tolerance, outputs)); });
}
