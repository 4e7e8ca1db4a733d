// SPDX-License-Identifier: BSD-3-Clause
// Searches for the smallest ellipsoid around points and around ellipsoids, with their memory.
#include <new>

#include "../base/owner.hpp"
#include "affine_hull.hpp"
#include "functions.hpp"
#include "smallest.hpp"

namespace pw85::detail::enclosing {
namespace {

template <class Found> void put(Found const &search, Outputs const &out) noexcept
{
    for (int i = 0, k = 0; i < out.n; ++i) {
        if (out.center != nullptr) out.center[i] = search.center(i);
        for (int j = i; out.q != nullptr && j < out.n; ++j) out.q[k++] = search.form(i, j);
    }
    if (out.excess != nullptr) *out.excess = search.excess();
}

bool has_ellipsoid(Status status) noexcept
{
    return status == Status::success || status == Status::no_convergence;
}

/// Runs a search, whose constructor takes `given`. Puts what it finds. Returns its status.
template <class Found, class... Given>
Status run(double tolerance, Outputs const &outputs, Given const &...given) noexcept
{
    Owner<Found> const search(new (std::nothrow) Found(given...));
    if (search == nullptr) return Status::out_of_memory;
    Status const status = search->run(tolerance);
    if (has_ellipsoid(status)) put(*search, outputs);
    return status;
}

} // namespace

Status enclose(int n, std::size_t m, double const *points, double tolerance,
               Outputs const &outputs) noexcept
{
    Status const status = run<Search>(tolerance, outputs, n, m, points);
    if (status != Status::not_positive_definite) return status;
    Status const flat = run<AffineHullSearch>(tolerance, outputs, n, m, points);
    return flat == Status::out_of_memory ? flat : status;
}

Status enclose(Ellipsoids const &bodies, double tolerance, Outputs const &outputs) noexcept
{
    return run<AroundEllipsoids>(tolerance, outputs, bodies);
}

} // namespace pw85::detail::enclosing
