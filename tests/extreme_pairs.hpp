// SPDX-License-Identifier: BSD-3-Clause
// Random pairs whose shapes, sizes and distances cover the whole range of forms in double
// precision.
#ifndef PW85_TESTS_EXTREME_PAIRS_HPP_INCLUDED
#define PW85_TESTS_EXTREME_PAIRS_HPP_INCLUDED

#include "random_pairs.hpp"

namespace pw85_tests {

using Lower = pw85::SymmetricMatrix<double, 3>;

/// L Lᵀ: positive definite up to rounding, for any L with positive diagonal (by rows of its
/// transpose).
inline pw85::SymmetricMatrix<double, 3> square(Lower const &l)
{
    return {l[0] * l[0],
            l[0] * l[1],
            l[0] * l[2],
            l[1] * l[1] + l[3] * l[3],
            l[1] * l[2] + l[3] * l[4],
            l[2] * l[2] + l[4] * l[4] + l[5] * l[5]};
}

/// Axes along the coordinates, nearly so, or anywhere, with lengths that differ by up to `binades`
/// binades.
inline pw85::SymmetricMatrix<double, 3> extreme_form(Random &random, int kind, double binades)
{
    Lower l{};
    for (int k : {0, 3, 5}) l[k] = std::exp2(random.uniform(-0.5, 0.5) * binades);
    if (kind == 1) {
        l[1] = random.uniform(-0.5, 0.5) * l[3];
        l[2] = random.uniform(-0.5, 0.5) * l[5];
        l[4] = random.uniform(-0.5, 0.5) * l[5];
    }
    if (kind == 2)
        for (int k : {1, 2, 4})
            l[k] = std::copysign(std::exp2(random.uniform(-10.0, 10.0)), random.uniform(-1.0, 1.0));
    return square(l);
}

/// A pair whose shapes, sizes and distance may be anything that a form of doubles can be.
inline Sample<double, 3> extreme_pair(Random &random, int kind)
{
    double const binades = std::fmin(480.0, std::exp2(random.uniform(1.0, 10.0)));
    double const shapes = kind == 2 ? 20.0 : 0.5 * binades;
    Sample<double, 3> p{{}, extreme_form(random, kind, shapes), extreme_form(random, kind, shapes)};
    for (int i = 0; i < 3; ++i)
        p.r12[i] = std::copysign(std::exp2(random.uniform(-0.5, 0.5) * binades),
                                 random.uniform(-1.0, 1.0));
    return p;
}

} // namespace pw85_tests

#endif
