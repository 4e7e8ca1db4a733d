// SPDX-License-Identifier: BSD-3-Clause
// Projection onto a basis.
#include "basis.hpp"

namespace pw85::detail::enclosing {

void subtract_projection(Basis const &basis, double *x) noexcept
{
    for (int pass = 0; pass < 2; ++pass)
        for (int i = 0; i < basis.size; ++i) {
            double product = 0.0;
            for (int k = 0; k < basis.n; ++k) product += basis.vectors[i][k] * x[k];
            for (int k = 0; k < basis.n; ++k) x[k] -= product * basis.vectors[i][k];
        }
}

double normalize(int n, double *x) noexcept
{
    using elementary::sqrt;
    double sum = 0.0;
    for (int k = 0; k < n; ++k) sum += x[k] * x[k];
    double const length = sqrt(sum);
    for (int k = 0; k < n && length > 0.0; ++k) x[k] /= length;
    return length;
}

} // namespace pw85::detail::enclosing
