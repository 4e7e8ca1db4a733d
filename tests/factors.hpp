// SPDX-License-Identifier: BSD-3-Clause
// Ellipsoids that are given by factors of their forms, and their exact products.
#ifndef PW85_TESTS_FACTORS_HPP_INCLUDED
#define PW85_TESTS_FACTORS_HPP_INCLUDED

#include <cmath>
#include <string>

#include <pw85/pw85.hpp>

#include "random_pairs.hpp"
#include "wide.hpp"

namespace pw85_tests {

/// The digits of 1 - λ, too, where one ellipsoid is 2⁴⁹⁰ times as large as the other.
using TruthOfFactors = Multiprecision<200>;

template <class T, int D> struct Factors {
    pw85::Vector<T, D> r12;
    pw85::Factor<T, D> s1, s2;
};

template <class T, int D> std::string hex_text(Factors<T, D> const &p)
{
    return "r12 = " + pw85_tests::hex_text(p.r12.coordinates, D) +
           ", s1 = " + pw85_tests::hex_text(p.s1.entries, D * D) +
           ", s2 = " + pw85_tests::hex_text(p.s2.entries, D * D);
}

/// Q = S Sᵀ for the factors as given.
template <class T, int D> Sample<TruthOfFactors, D> squared(Factors<T, D> const &p)
{
    auto const form = [](pw85::Factor<T, D> const &s) {
        pw85::SymmetricMatrix<TruthOfFactors, D> q{};
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j)
                for (int k = 0; k < D; ++k)
                    q(i, j) += TruthOfFactors(s(i, k)) * TruthOfFactors(s(j, k));
        return q;
    };
    return {pw85::detail::converted<TruthOfFactors>(p.r12), form(p.s1), form(p.s2)};
}

template <int D>
pw85::Factor<double, D> product(pw85::Factor<double, D> const &a, pw85::Factor<double, D> const &b)
{
    pw85::Factor<double, D> c{};
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
            for (int k = 0; k < D; ++k) c(i, j) += a(i, k) * b(k, j);
    return c;
}

inline pw85::Factor<double, 3> random_rotation(Random &random)
{
    return pw85::ellipsoid_factor({1.0, 1.0, 1.0}, random.direction<4>()).s;
}

/// Axes as columns; mixed columns; a triangle; columns that are nearly parallel.
inline pw85::Factor<double, 3> random_factor(Random &random, int kind, double size, double aspect)
{
    auto const axes = random.semi_axes(size, aspect);
    auto s = pw85::ellipsoid_factor(axes, random.direction<4>()).s;
    if (kind == 1) return product(s, random_rotation(random));
    if (kind == 2)
        for (int i = 0; i < 3; ++i)
            for (int j = i + 1; j < 3; ++j) s(i, j) = 0.0;
    if (kind == 3)
        for (int i = 0; i < 3; ++i) s(i, 1) = s(i, 0) / axes[0] * axes[1] + 1e-3 * s(i, 1);
    return s;
}

/// A pair whose μ² is from 0.01 to 100. The second ellipsoid has the size `ratio`.
inline Factors<double, 3> random_factors(Random &random, int kind, double aspect, double ratio)
{
    Factors<double, 3> p{random.direction<3>(), random_factor(random, kind, 1.0, aspect),
                         random_factor(random, kind, ratio, random.log_uniform(1.0, aspect))};
    double const mu2 = pw85::contact_factored(p.r12, p.s1, p.s2).mu2;
    p.r12 = std::sqrt(random.log_uniform(0.01, 100.0) / mu2) * p.r12;
    return p;
}

} // namespace pw85_tests

#endif
