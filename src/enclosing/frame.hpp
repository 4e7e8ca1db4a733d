// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An ellipsoid as the set |A (x - c)| <= 1, with a lower triangle A. The numbers have twice the
/// digits of double: those of A are as inaccurate as the square of the aspect ratio is large.
#ifndef PW85_ENCLOSING_FRAME_HPP_INCLUDED
#define PW85_ENCLOSING_FRAME_HPP_INCLUDED

#include "cloud.hpp"

namespace pw85::detail::enclosing {

struct Frame {
    int n;
    Wide center[max_dimension];
    Wide a[max_packed];
};

/// Computes a point relative to the centre, exactly if the centre is a double.
inline void offset_of(Cloud const &cloud, Wide const *center, std::size_t i, Wide *z) noexcept
{
    for (int k = 0; k < cloud.n; ++k) z[k] = Wide(cloud.coordinate(i, k)) - center[k];
}

/// Computes w = A z.
[[gnu::always_inline]] inline void multiply(Frame const &frame, Wide const *z, Wide *w) noexcept
{
    for (int i = 0; i < frame.n; ++i) {
        w[i] = frame.a[at(i, 0)] * z[0];
        for (int j = 1; j <= i; ++j) w[i] = w[i] + frame.a[at(i, j)] * z[j];
    }
}

/// Returns |A (x - c)|² in double precision, for searches. `a` is the triangle and `center` the
/// centre.
[[gnu::always_inline]] inline double squared_norm(Cloud const &cloud, double const *a,
                                                  double const *center, std::size_t point) noexcept
{
    double z[max_dimension], sum = 0.0;
    for (int k = 0; k < cloud.n; ++k) z[k] = cloud.coordinate(point, k) - center[k];
    for (int i = 0; i < cloud.n; ++i) {
        double w = 0.0;
        for (int j = 0; j <= i; ++j) w += *a++ * z[j];
        sum += w * w;
    }
    return sum;
}

/// Replaces a positive definite matrix, a lower triangle, by the inverse of its Cholesky factor.
/// Returns false if a pivot is not above `least` times the diagonal entry.
bool invert_factor(int n, Wide *a, double least) noexcept;

/// Computes the mean and the covariance of points with weights.
void moments(Cloud const &cloud, std::size_t count, std::size_t const *points,
             double const *weights, Wide *mean, Wide *covariance) noexcept;

} // namespace pw85::detail::enclosing

#endif
