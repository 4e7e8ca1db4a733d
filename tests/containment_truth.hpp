// SPDX-License-Identifier: BSD-3-Clause
// The factor by which an ellipsoid must be scaled to contain another one, in 100 digits.
#ifndef PW85_TESTS_CONTAINMENT_TRUTH_HPP_INCLUDED
#define PW85_TESTS_CONTAINMENT_TRUTH_HPP_INCLUDED

#include <limits>

#include "golden_section.hpp"
#include "wide.hpp"

namespace pw85_tests {

using Truth100 = Multiprecision<100>;

/// ν + rᵀ(Q1 - Q2/ν)⁻¹r by elimination; infinity where the matrix is not positive definite.
template <int D> Truth100 gauge(Sample<Truth100, D> const &s, Truth100 const &nu)
{
    Truth100 m[std::size_t(D)][std::size_t(D)], x[std::size_t(D)], sum = nu;
    for (int i = 0; i < D; ++i) {
        x[i] = s.r12[i];
        for (int j = 0; j < D; ++j) m[i][j] = s.q1(i, j) - s.q2(i, j) / nu;
    }
    for (int k = 0; k < D; ++k) {
        if (m[k][k] <= 0) return std::numeric_limits<Truth100>::infinity();
        sum += x[k] * x[k] / m[k][k];
        for (int i = k + 1; i < D; ++i) {
            Truth100 const factor = m[i][k] / m[k][k];
            x[i] -= factor * x[k];
            for (int j = k + 1; j < D; ++j) m[i][j] -= factor * m[k][j];
        }
    }
    return sum;
}

/// κ², the least of the gauge, by golden section: to some 1e-50.
template <class T, int D> Truth100 kappa2(Sample<T, D> const &sample)
{
    auto const s = convert<Truth100>(sample);
    auto const value = [&s](Truth100 const &nu) { return gauge(s, nu); };
    Truth100 high = 1;
    while (isinf(value(high))) high *= 2;
    return value(golden_section<Truth100>(value, {0, value(high)}, 250).high);
}

/// κ² <= 1; what is nearer to 1 than 1e-40 touches.
inline bool is_inside(Truth100 const &kappa2) { return kappa2 < 1 + Truth100("1e-40"); }

} // namespace pw85_tests

#endif
