// SPDX-License-Identifier: BSD-3-Clause
// Random linear maps of small integers, which make ellipsoids of balls and move no digit.
#ifndef PW85_TESTS_INTEGER_MAPS_HPP_INCLUDED
#define PW85_TESTS_INTEGER_MAPS_HPP_INCLUDED

#include <cmath>
#include <cstdlib>

#include <pw85/pw85.hpp>

#include "random_pairs.hpp"

namespace pw85_tests {

/// Returns an integer from -limit to limit.
inline int random_integer(Random &random, int limit)
{
    return static_cast<int>(std::floor(random.uniform(-limit, limit + 1)));
}

/// A lower triangular matrix L.
template <int D> struct IntegerMap {
    double l[std::size_t(D)][std::size_t(D)] = {};
};

/// Returns a map with a positive diagonal, often diagonal, or the identity.
template <int D> IntegerMap<D> random_map(Random &random, int limit, int diagonal_limit)
{
    IntegerMap<D> map;
    bool const diagonal = random.uniform(0.0, 1.0) < 0.5;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < i && !diagonal; ++j) map.l[i][j] = random_integer(random, limit);
        map.l[i][i] = 1 + std::abs(random_integer(random, diagonal_limit));
    }
    return map;
}

/// Returns L diag(d) Lᵀ.
template <int D>
pw85::SymmetricMatrix<double, D> mapped(IntegerMap<D> const &map, pw85::Vector<double, D> const &d)
{
    pw85::SymmetricMatrix<double, D> q{};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j)
            for (int k = 0; k < D; ++k) q(i, j) += map.l[i][k] * d[k] * map.l[j][k];
    return q;
}

/// Returns d L Lᵀ.
template <int D>
pw85::SymmetricMatrix<double, D> mapped_ball(IntegerMap<D> const &map, double d = 1.0)
{
    pw85::Vector<double, D> all{};
    for (int i = 0; i < D; ++i) all[i] = d;
    return mapped(map, all);
}

} // namespace pw85_tests

#endif
