// SPDX-License-Identifier: BSD-3-Clause
// Moments of weighted points, and the inverse of a Cholesky factor.
#include "frame.hpp"

#include "cholesky.hpp"

namespace pw85::detail::enclosing {

bool factorize(std::size_t n, Wide *a, double share) noexcept
{
    return factorize<Wide>(n, a, share);
}

bool invert_factor(int n, Wide *a, double least) noexcept
{
    auto const size = static_cast<std::size_t>(n);
    Wide factor[max_dimension * max_dimension], column[max_dimension];
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) factor[i * n + j] = a[at(i, j)];
    if (!factorize(size, factor, least)) return false;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) column[i] = Wide(i == j ? 1.0 : 0.0);
        substitute(size, factor, column);
        for (int i = j; i < n; ++i) a[at(i, j)] = column[i];
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
