// SPDX-License-Identifier: BSD-3-Clause
// Computes the intervals of deformation.hpp.
#include "deformation.hpp"

namespace pw85::detail::neighbors {

Deformation::Deformation(Periodicity const &periodicity, double const *now,
                         double const *then) noexcept
{
    for (int l = 0; l < 3; ++l) {
        if (!periodicity.is_periodic(l)) continue;
        Vector<double, 3> const dual = periodicity.dual_of_cell(l);
        for (int e = 0; e < 3; ++e)
            for (int d = 0; d < 3; ++d)
                gradient_[e][d] += dual[e] * (then[3 * l + d] - now[3 * l + d]);
    }
    for (int l = 0; l < 3; ++l)
        if (periodicity.is_periodic(l))
            add_error(periodicity.dual_of_cell_bound(l), now + 3 * l, then + 3 * l);
    // the part of the rounding errors of w that shared_motions() leaves to this
    double const largest = largest_gradient();
    for (double &error : error_) error += margin * largest;
}

double Deformation::largest_gradient() const noexcept
{
    double largest = 0.0;
    for (auto const &row : gradient_)
        for (double const entry : row) largest = maximum(largest, elementary::abs(entry));
    return largest;
}

BoxExtent Deformation::taken_back(BoxExtent const &now) const noexcept
{
    BoxExtent then = now;
    for (int d = 0; d < 3; ++d) {
        then.half_widths[d] = half_width(d, now.half_widths);
        for (int e = 0; e < 3; ++e) then.center[d] += now.center[e] * gradient_[e][d];
    }
    return then;
}

double Deformation::half_width(int d, Vector<double, 3> const &now) const noexcept
{
    double sum = 0.0;
    for (int e = 0; e < 3; ++e)
        sum += elementary::abs((e == d ? 1.0 : 0.0) + gradient_[e][d]) * now[e];
    return sum;
}

// ρ is the sum of a difference and three products. Its rounding error is below 8 u times the sum of
// their magnitudes.
void Deformation::add_error(double dual_bound, double const *now, double const *then) noexcept
{
    for (int d = 0; d < 3; ++d) {
        double const change = then[d] - now[d];
        double residual = change, size = elementary::abs(change);
        for (int e = 0; e < 3; ++e) {
            residual -= now[e] * gradient_[e][d];
            size += elementary::abs(now[e] * gradient_[e][d]);
        }
        error_[d] += dual_bound * (elementary::abs(residual) + margin * size);
    }
}

Box Deformation::shared_motions(BoxExtent const &now, BoxExtent const &then) const noexcept
{
    double size = 0.0;
    for (int d = 0; d < 3; ++d) size += elementary::abs(now.center[d]) + now.half_widths[d];
    Box motions;
    for (int d = 0; d < 3; ++d) {
        double motion = now.center[d] - then.center[d];
        for (int e = 0; e < 3; ++e) motion += now.center[e] * gradient_[e][d];
        // The rounding errors of w are below 4 u |w_d| + 12 u |c'| max|K_ed|, and those of the ends
        // of the interval are below u |w_d|. So s must also shrink by 16 u (|w_d| + (|c'| + |h'|)
        // max|K_ed|), the last part of which is in error_. Those of g and of differences with H are
        // below 10 u H. The list has room for these: its boxes grow by 16 u H, of which it needs 2
        // (periodicity.hpp).
        double const clearance = then.half_widths[d] - half_width(d, now.half_widths) -
                                 margin * elementary::abs(motion) - error_[d] * size;
        bool const is_empty = !(clearance >= 0.0); // also true for NaN, which an overflow gives
        motions.lower[d] = is_empty ? infinity<double>() : motion - clearance;
        motions.upper[d] = is_empty ? -infinity<double>() : motion + clearance;
    }
    return motions;
}

} // namespace pw85::detail::neighbors
