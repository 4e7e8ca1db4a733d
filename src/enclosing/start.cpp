// SPDX-License-Identifier: BSD-3-Clause
// The outermost points along n directions.
#include "start.hpp"

#include "basis.hpp"

namespace pw85::detail::enclosing {

namespace {

/// Finds the longest projection of a coordinate axis onto the orthogonal complement of the basis,
/// normalised.
void find_direction(Basis const &basis, double *direction) noexcept
{
    double longest = -1.0;
    for (int axis = 0; axis < basis.n; ++axis) {
        double x[max_dimension] = {};
        x[axis] = 1.0;
        subtract_projection(basis, x);
        double const length = normalize(basis.n, x);
        if (length <= longest) continue;
        longest = length;
        for (int k = 0; k < basis.n; ++k) direction[k] = x[k];
    }
}

/// Finds the outermost points along a direction. Returns the distance between them.
double find_pair(Cloud const &cloud, double const *direction, std::size_t *pair) noexcept
{
    double lowest = 0.0, highest = 0.0;
    pair[0] = pair[1] = 0;
    for (std::size_t i = 1; i < cloud.m; ++i) {
        double x = 0.0;
        for (int k = 0; k < cloud.n; ++k)
            x += direction[k] * (cloud.coordinate(i, k) - cloud.coordinate(0, k));
        if (x < lowest) lowest = x, pair[0] = i;
        if (x > highest) highest = x, pair[1] = i;
    }
    return highest - lowest;
}

} // namespace

bool find_outermost(Cloud const &cloud, std::size_t pairs[][2]) noexcept
{
    Basis basis{cloud.n, 0, {}};
    for (int i = 0; i < cloud.n; ++i) {
        double direction[max_dimension] = {};
        find_direction(basis, direction);
        if (find_pair(cloud, direction, pairs[i]) < 0x1p-24) return false;
        double *const next = basis.vectors[i];
        for (int k = 0; k < cloud.n; ++k)
            next[k] = cloud.coordinate(pairs[i][1], k) - cloud.coordinate(pairs[i][0], k);
        subtract_projection(basis, next);
        normalize(cloud.n, next);
        ++basis.size;
    }
    return true;
}

} // namespace pw85::detail::enclosing
