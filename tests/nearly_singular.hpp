// SPDX-License-Identifier: BSD-3-Clause
// Pairs of forms that are singular to working precision or nearly so, and their exact properties.
// These are computed by rational numbers and by bisection with 200 digits, independently of the
// library. (The condition number, the unit of errors, is that of the tests.)
#ifndef PW85_TESTS_NEARLY_SINGULAR_HPP_INCLUDED
#define PW85_TESTS_NEARLY_SINGULAR_HPP_INCLUDED

#include <cmath>

#include "oracle/exact_numbers.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

namespace pw85_tests {

using Precise = Multiprecision<200>;

/// Sylvester's criterion, exactly.
inline bool is_exactly_definite(pw85::SymmetricMatrix<double, 3> const &q)
{
    Rational const xx(q[0]), xy(q[1]), xz(q[2]), yy(q[3]), yz(q[4]), zz(q[5]);
    return xx > 0 && xx * yy - xy * xy > 0 &&
           xx * (yy * zz - yz * yz) - xy * (xy * zz - xz * yz) + xz * (xy * yz - xz * yy) > 0;
}

inline bool is_exactly_definite(Sample<double, 3> const &p)
{
    return is_exactly_definite(p.q1) && is_exactly_definite(p.q2);
}

/// a(t) = rᵀ adj(Q1 + t Q2) r and b(t) = det(Q1 + t Q2), interpolated at t = -1, 0, 1 and 2, in
/// powers of t.
struct PrecisePolynomials {
    Precise a[3], b[4];

    explicit PrecisePolynomials(Sample<double, 3> const &p)
    {
        Precise va[4], vb[4];
        for (int n = 0; n < 4; ++n) evaluate(p, n - 1, va[n], vb[n]);
        a[0] = va[1];
        a[1] = (va[2] - va[0]) / 2;
        a[2] = (va[2] + va[0]) / 2 - va[1];
        b[0] = vb[1];
        b[3] = (vb[3] - 3 * vb[2] + 3 * vb[1] - vb[0]) / 6;
        b[2] = (vb[2] + vb[0]) / 2 - vb[1];
        b[1] = (vb[2] - vb[0]) / 2 - b[3];
    }

    static void evaluate(Sample<double, 3> const &p, int t, Precise &a, Precise &b)
    {
        Precise m[6], x(p.r12[0]), y(p.r12[1]), z(p.r12[2]);
        for (int k = 0; k < 6; ++k) m[k] = Precise(p.q1[k]) + t * Precise(p.q2[k]);
        Precise const xx = m[3] * m[5] - m[4] * m[4], xy = m[2] * m[4] - m[1] * m[5],
                      xz = m[1] * m[4] - m[2] * m[3];
        Precise const yy = m[0] * m[5] - m[2] * m[2], yz = m[1] * m[2] - m[0] * m[4],
                      zz = m[0] * m[3] - m[1] * m[1];
        a = xx * x * x + yy * y * y + zz * z * z + 2 * (xy * x * y + xz * x * z + yz * y * z);
        b = m[0] * xx + m[1] * xy + m[2] * xz;
    }

    Precise a_at(Precise const &t) const { return (a[2] * t + a[1]) * t + a[0]; }
    Precise b_at(Precise const &t) const { return ((b[3] * t + b[2]) * t + b[1]) * t + b[0]; }

    /// Whether f = t/(1 + t) a/b increases at t.
    bool increases(Precise const &t) const
    {
        Precise const da = 2 * a[2] * t + a[1], db = (3 * b[3] * t + 2 * b[2]) * t + b[1];
        return a_at(t) * b_at(t) + t * (1 + t) * (da * b_at(t) - a_at(t) * db) > 0;
    }
};

/// t at the maximum of f, to 1e-48.
inline Precise maximizer(PrecisePolynomials const &f)
{
    int low = -400, high = 400;
    while (high - low > 1) {
        int const middle = (low + high) / 2;
        (f.increases(ldexp(Precise(1), middle)) ? low : high) = middle;
    }
    Precise lower = ldexp(Precise(1), low), upper = ldexp(Precise(1), high);
    for (int i = 0; i < 160; ++i) {
        Precise const middle = (lower + upper) / 2;
        (f.increases(middle) ? lower : upper) = middle;
    }
    return lower;
}

/// μ², λ and the condition number.
inline Truth<Precise> precise_truth(Sample<double, 3> const &sample)
{
    PrecisePolynomials const f(sample);
    Precise const t = maximizer(f), lambda = t / (1 + t);
    return {lambda * f.a_at(t) / f.b_at(t), lambda,
            condition_number(convert<Precise>(sample), lambda)};
}

/// A needle, ribbon or disc.
inline pw85::Vector<double, 3> thin_shape(Random &random, double size, double aspect)
{
    double const kind = random.uniform(0.0, 3.0), exponent = kind < 1.0 ? 0.0
                                                             : kind < 2.0
                                                                 ? 1.0
                                                                 : random.uniform(0.0, 1.0);
    return {size, size * std::pow(aspect, -exponent), size / aspect};
}

/// Two thin shapes, turned alike, almost alike or at random, of sizes up to 2^40 times one another.
/// Many forms of the larger aspect ratios are not positive definite any more. μ² is near 1.
inline Sample<double, 3> nearly_singular_pair(Random &random, double aspect)
{
    auto const turn = random.direction<4>();
    auto turn2 = random.direction<4>();
    double const kind = random.uniform(0.0, 3.0),
                 size = random.sign() < 0.0 ? 1.0 : random.log_uniform(0x1p-40, 0x1p40);
    for (int k = 0; k < 4 && kind < 2.0; ++k)
        turn2[k] = turn[k] + (kind < 1.0 ? 0.0 : 1e-8 * turn2[k]);
    Sample<double, 3> pair{random.direction<3>(),
                           pw85::ellipsoid_quaternion(thin_shape(random, 1.0, aspect), turn).q,
                           pw85::ellipsoid_quaternion(thin_shape(random, size, aspect), turn2).q};
    if (random.sign() < 0.0)
        pair.r12 = pw85::product(random.sign() < 0.0 ? pair.q1 : pair.q2, pair.r12);
    if (!is_exactly_definite(pair)) return pair;
    PrecisePolynomials const f(pair);
    Precise const t = maximizer(f), mu2 = t / (1 + t) * f.a_at(t) / f.b_at(t);
    double const excess = random.sign() * random.log_uniform(1e-14, 1e-1);
    pair.r12 = std::sqrt((1.0 + excess) / static_cast<double>(mu2)) * pair.r12;
    return pair;
}

} // namespace pw85_tests

#endif
