// SPDX-License-Identifier: BSD-3-Clause
// The templates of two ellipsoids in n dimensions, compiled once.
#include "functions.hpp"
#include "shared.hpp"

namespace pw85::detail::any_dimension {

StatusCode exact_status_of_form(int n, double const *q) noexcept { return status_of_form(n, q); }

void find_dual(ReachWorkspace<double> &memory) noexcept
{
    // What the bounds have reached is in the memory, also where they differ by more.
    static_cast<void>(find_dual(memory, 4.0 * unit_roundoff<double>()));
}

bool shows_inside_wider(Input const &in, Doubled<double> const *r12, double nu,
                        double other) noexcept
{
    using Wide = Doubled<double>;
    return with_wide_workspace([&](auto &work) {
        scale(in, {}, work.pair);
        for (int k = 0; k < in.n; ++k) work.pair.r12[k] = r12[k];
        return shows_inside(work.pair, Wide(nu), work.at.factors) ||
               shows_inside(work.pair, Wide(other), work.at.factors);
    });
}

} // namespace pw85::detail::any_dimension

namespace pw85::detail::compiled {

Contact<double> nd_contact(int n, double const *r12, double const *q1, double const *q2) noexcept
{
    return pw85::nd_contact(n, r12, q1, q2);
}

Status nd_contact_geometry(int n, double const *r12, double const *q1, double const *q2,
                           double lambda, NdGeometry const &out) noexcept
{
    return pw85::nd_contact_geometry(n, r12, q1, q2, lambda, out);
}

NdComparison nd_compare(int n, double const *r12, double const *q1, double const *q2,
                        double mu2) noexcept
{
    return pw85::nd_compare(n, r12, q1, q2, mu2);
}

NdOverlap nd_overlap(int n, double const *r12, double const *q1, double const *q2) noexcept
{
    return pw85::nd_overlap(n, r12, q1, q2);
}

NdContainment nd_contains(int n, double const *r12, double const *q1, double const *q2) noexcept
{
    return pw85::nd_contains(n, r12, q1, q2);
}

NdContainmentScale nd_containment(int n, double const *r12, double const *q1, double const *q2,
                                  double *point) noexcept
{
    return pw85::nd_containment(n, r12, q1, q2, point);
}

NdDistance nd_distance(int n, double const *r12, double const *q1, double const *q2,
                       NdClosestPoints const &out) noexcept
{
    return pw85::nd_distance(n, r12, q1, q2, out);
}

} // namespace pw85::detail::compiled
