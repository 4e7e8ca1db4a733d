// SPDX-License-Identifier: BSD-3-Clause
// Moments of weighted points, and the inverse of a Cholesky factor.
#include "frame.hpp"

namespace pw85::detail::enclosing {

namespace {

bool factorize(int n, Wide *a, double least) noexcept
{
    for (int i = 0; i < n; ++i) {
        double const diagonal = a[at(i, i)].high;
        for (int j = 0; j <= i; ++j) {
            Wide sum = a[at(i, j)];
            for (int k = 0; k < j; ++k) sum = sum - a[at(i, k)] * a[at(j, k)];
            if (i > j) {
                a[at(i, j)] = sum / a[at(j, j)];
            } else {
                if (!(sum.high > least * diagonal)) return false;
                a[at(i, i)] = sqrt(sum);
            }
        }
    }
    return true;
}

} // namespace

bool invert_factor(int n, Wide *a, double least) noexcept
{
    if (!factorize(n, a, least)) return false;
    for (int j = 0; j < n; ++j) {
        a[at(j, j)] = Wide(1.0) / a[at(j, j)];
        // Column j of the inverse needs rows below j of the factor, and the finished entries above.
        for (int i = j + 1; i < n; ++i) {
            Wide sum = a[at(i, j)] * a[at(j, j)];
            for (int k = j + 1; k < i; ++k) sum = sum + a[at(i, k)] * a[at(k, j)];
            a[at(i, j)] = -(sum / a[at(i, i)]);
        }
    }
    return true;
}

void moments(Cloud const &cloud, std::size_t count, std::size_t const *points,
             double const *weights, Wide *mean, Wide *covariance) noexcept
{
    int const n = cloud.n;
    Wide total(0.0), z[max_dimension];
    for (int k = 0; k < n; ++k) mean[k] = Wide(0.0);
    for (int k = 0; k < at(n, 0); ++k) covariance[k] = Wide(0.0);
    for (std::size_t i = 0; i < count; ++i) {
        total = total + Wide(weights[i]);
        for (int k = 0; k < n; ++k)
            mean[k] = mean[k] + Wide(weights[i]) * Wide(cloud.coordinate(points[i], k));
    }
    for (int k = 0; k < n; ++k) mean[k] = mean[k] / total;
    for (std::size_t i = 0; i < count; ++i) {
        offset_of(cloud, mean, points[i], z);
        for (int k = 0; k < n; ++k) {
            Wide const weighted = Wide(weights[i]) * z[k] / total;
            for (int l = 0; l <= k; ++l)
                covariance[at(k, l)] = covariance[at(k, l)] + weighted * z[l];
        }
    }
}

} // namespace pw85::detail::enclosing
