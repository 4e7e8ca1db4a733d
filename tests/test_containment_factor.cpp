// SPDX-License-Identifier: BSD-3-Clause
// The factor by which an ellipsoid must be scaled to contain another one, against the least value
// of g in 100 digits.
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "containment_truth.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

/// A⁻¹ x by elimination.
template <int D> pw85::Vector<Truth100, D> solved(pw85::SymmetricMatrix<Truth100, D> const &a,
                                                  pw85::Vector<Truth100, D> x)
{
    Truth100 m[std::size_t(D)][std::size_t(D)];
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) m[i][j] = a(i, j);
    for (int k = 0; k < D; ++k)
        for (int i = k + 1; i < D; ++i) {
            Truth100 const factor = m[i][k] / m[k][k];
            x[i] -= factor * x[k];
            for (int j = k + 1; j < D; ++j) m[i][j] -= factor * m[k][j];
        }
    for (int i = D - 1; i >= 0; --i) {
        for (int j = i + 1; j < D; ++j) x[i] -= m[i][j] * x[j];
        x[i] /= m[i][i];
    }
    return x;
}

template <int D>
Truth100 product(pw85::Vector<Truth100, D> const &x, pw85::Vector<Truth100, D> const &y)
{
    Truth100 sum = 0;
    for (int i = 0; i < D; ++i) sum += x[i] * y[i];
    return sum;
}

/// Σ|n_i||A_ij||n_j|.
template <int D>
Truth100 magnitudes(pw85::SymmetricMatrix<Truth100, D> const &a, pw85::Vector<Truth100, D> const &n)
{
    Truth100 sum = 0;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) sum += abs(n[i] * a(i, j) * n[j]);
    return sum;
}

/// What the numbers of a pair and a result tell, in 100 digits. n = Q1⁻¹x at the point x.
template <int D> struct Check {
    Truth100 gauge; ///< xᵀQ1⁻¹x
    Truth100 level; ///< (x - r)ᵀQ2⁻¹(x - r)
    Truth100 slack; ///< the error of `level` for relative errors u of x, r and Q2
    Truth100 sum;   ///< S: the change of κ² for relative errors of one in the numbers
};

template <class T, int D>
Check<D> check_point(Sample<T, D> const &sample, pw85::Vector<T, D> const &point)
{
    auto const s = convert<Truth100>(sample);
    auto const x = convert<Truth100>(point);
    auto y = x;
    for (int i = 0; i < D; ++i) y[i] -= s.r12[i];
    auto const n = solved(s.q1, x), m = solved(s.q2, y);
    Check<D> check{product(x, n), product(y, m), magnitudes(s.q2, m), magnitudes(s.q1, n)};
    for (int i = 0; i < D; ++i) {
        check.slack += 2 * abs(m[i]) * (abs(x[i]) + abs(s.r12[i]));
        check.sum += 2 * abs(s.r12[i] * n[i]);
    }
    // Along n ellipsoid 2 reaches √(nᵀQ2n) = ν.
    Truth100 form = 0;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) form += n[i] * s.q2(i, j) * n[j];
    check.sum += magnitudes(s.q2, n) / sqrt(form);
    return check;
}

/// The bound of the header, and that the point is on ellipsoid 2, where xᵀQ1⁻¹x is κ². The point
/// errs by 8 u of each number, and its own rounding changes xᵀQ1⁻¹x by 2u Σ|n_i x_i|, which is
/// below 2 u S.
template <class T, int D> void compare(Sample<T, D> const &s, Failures &failures)
{
    auto const describe = [&] { return hex_text(s); };
    auto const c = pw85::containment(s.r12, s.q1, s.q2);
    if (c.status == pw85::Status::not_positive_definite) return; // when it is rounded
    if (!failures.check(c.status == pw85::Status::success, "status", static_cast<int>(c.status), 0,
                        describe))
        return;
    auto const exact = kappa2(s);
    auto const point = check_point(s, c.point);
    Truth100 const u = pw85::detail::unit_roundoff<T>();
    Truth100 const error = abs(Truth100(c.mu2) - exact) / (u * point.sum);
    failures.check(error <= 16, "error in u S", static_cast<double>(error), 16, describe);
    Truth100 const level = abs(point.level - 1) / (u * point.slack);
    failures.check(level <= 8, "distance from the surface", static_cast<double>(level), 8,
                   describe);
    Truth100 const gauge = abs(point.gauge - exact) / (u * point.sum);
    failures.check(gauge <= 32, "value at the point", static_cast<double>(gauge), 32, describe);
}

/// Ellipsoids without off-diagonal entries, and with a separation that has no part, or a tiny one,
/// along some axes. The forms may have equal axes, or be equal.
template <int D> Sample<double, D> aligned(Random &random, Sample<double, D> s)
{
    for (int i = 0; i < D; ++i)
        for (int j = i + 1; j < D; ++j) s.q1(i, j) = s.q2(i, j) = 0;
    for (int i = 0; i < D; ++i)
        if (random.uniform(0.0, 1.0) < 0.5)
            s.r12[i] *= random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.log_uniform(1e-30, 1e-3);
    if (random.uniform(0.0, 1.0) < 0.3) {
        s.q2(1, 1) = s.q2(0, 0);
        s.q1(1, 1) = s.q1(0, 0);
    }
    return random.uniform(0.0, 1.0) < 0.2 ? Sample<double, D>{s.r12, s.q2, s.q2} : s;
}

/// Balls, needles, discs and what is between; sizes and distances of all proportions.
template <int D> Sample<double, D> hostile_pair(Random &random, int n)
{
    double const aspect = n % 4 == 0 ? 1.0 : n % 4 == 1 ? 10.0 : n % 4 == 2 ? 1e3 : 1e6;
    Sample<double, D> s{
        random.log_uniform(1e-9, 1e3) * random.direction<D>(),
        random_form<D>(random, 1.0, random.log_uniform(1.0, aspect)),
        random_form<D>(random, random.log_uniform(1e-3, 1e3), random.log_uniform(1.0, aspect))};
    if (n / 4 % 4 == 1) s.r12 = 0.0 * s.r12;
    return n / 4 % 4 >= 2 ? aligned(random, s) : s;
}

template <class T, int D> void test_random()
{
    Failures failures;
    Random random(600 + D);
    for (int n = 0; n < draws(D == 3 ? 320 : 160); ++n)
        compare(convert<T>(hostile_pair<D>(random, n)), failures);
}

// Balls: κ = (|r| + a2)/a1, by Pythagorean quadruples. A linear map of integers makes ellipsoids of
// them, with the same κ.
PW85_TEST("/containment_factor/touching_balls")
{
    Failures failures;
    Random random(610);
    double const quadruples[][4] = {{1, 2, 2, 3},  {2, 3, 6, 7}, {1, 4, 8, 9},
                                    {6, 6, 7, 11}, {0, 3, 4, 5}, {0, 0, 2, 2}};
    for (int n = 0; n < draws(400); ++n) {
        auto const &quadruple = quadruples[n % 6];
        double const a2 = 1 + n % 19, a1 = 1 + n % 23,
                     wanted = (quadruple[3] + a2) * (quadruple[3] + a2) / (a1 * a1);
        double l[3][3] = {};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j <= i; ++j)
                l[i][j] =
                    i == j ? 1 + n / 6 % 5 : std::floor(random.uniform(-9.0, 10.0)) * (n % 4 != 0);
        Sample<double, 3> s{};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k <= i; ++k) s.r12[i] += l[i][k] * quadruple[k];
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                for (int k = 0; k < 3; ++k) {
                    s.q1(i, j) += a1 * a1 * l[i][k] * l[j][k];
                    s.q2(i, j) += a2 * a2 * l[i][k] * l[j][k];
                }
        auto const c = pw85::containment(s.r12, s.q1, s.q2);
        Truth100 const sum = check_point(s, c.point).sum;
        double const error =
            static_cast<double>(abs(Truth100(c.mu2) - Truth100(wanted)) / sum) * 0x1p53;
        // `wanted` is rounded
        failures.check(error <= 17, "error in u S", error, 17, [&] { return hex_text(s); });
    }
}

// Where r is zero, or orthogonal to the longest axis: the factor is a ratio of axes, and the point
// one of two.
PW85_TEST("/containment_factor/several_points")
{
    using Form = pw85::SymmetricMatrix<double, 3>;
    Form const box{4, 0, 0, 9, 0, 16}, thin{4, 0, 0, 1, 0, 1};
    auto const c = pw85::containment(pw85::Vector{0.0, 0.0, 0.0}, box, thin);
    g_assert_cmpfloat_with_epsilon(c.mu2, 1.0, 1e-15);
    g_assert_cmpfloat_with_epsilon(std::abs(c.point[0]), 2.0, 1e-15);
    g_assert_cmpfloat(std::abs(c.point[1]) + std::abs(c.point[2]), <, 1e-7);
    // The disc x²/4 + ... at height 1 in a ball of radius 3: it touches on a rim of radius 2 or
    // less, √(4 + 1) of 3.
    auto const rim = pw85::containment(pw85::Vector{0.0, 0.0, 1.0}, Form{9, 0, 0, 9, 0, 9},
                                       Form{4, 0, 0, 4, 0, 0x1p-40});
    g_assert_cmpfloat_with_epsilon(rim.mu2, 5.0 / 9.0, 1e-12);
    g_assert_cmpfloat_with_epsilon(std::hypot(rim.point[0], rim.point[1]), 2.0, 1e-9);
    for (double const size : {1.0, 0x1p-300, 0x1p300}) {
        auto const self = pw85::containment(pw85::Vector{0.0, 0.0, 0.0}, size * box, size * box);
        g_assert_cmpfloat_with_epsilon(self.mu2, 1.0, 1e-15);
        pw85::SymmetricMatrix<double, 2> const circle{size, 0, size};
        auto const in_plane = pw85::containment(pw85::Vector{0.0, 0.0}, circle, 4.0 * circle);
        g_assert_cmpfloat_with_epsilon(in_plane.mu2, 4.0, 1e-14);
    }
}

// Units change no bit, and neither does the size of ellipsoid 1, except that of the result.
PW85_TEST("/containment_factor/units")
{
    Failures failures;
    Random random(620);
    for (int n = 0; n < draws(200); ++n) {
        auto const s = hostile_pair<3>(random, n);
        auto const c = pw85::containment(s.r12, s.q1, s.q2);
        if (c.status != pw85::Status::success) continue;
        for (int const e : {-480, -40, 40, 480})
            for (int const e1 : {-e / 8, 0, e / 8}) {
                auto t = s;
                for (int i = 0; i < 3; ++i) t.r12[i] = std::ldexp(s.r12[i], e);
                for (int k = 0; k < 6; ++k) {
                    t.q1[k] = std::ldexp(s.q1[k], 2 * (e + e1));
                    t.q2[k] = std::ldexp(s.q2[k], 2 * e);
                }
                if (std::fpclassify(t.q1[0]) != FP_NORMAL) continue;
                auto const other = pw85::containment(t.r12, t.q1, t.q2);
                auto const describe = [&] { return hex_text(t); };
                double const expected = std::ldexp(c.mu2, -2 * e1);
                failures.check(other.mu2 == expected, "mu2", other.mu2, expected, describe);
                for (int i = 0; i < 3; ++i) {
                    double const coordinate = std::ldexp(c.point[i], e);
                    failures.check(other.point[i] == coordinate, "point", other.point[i],
                                   coordinate, describe);
                }
            }
    }
}

// Sizes that differ by 1e±150 or more.
PW85_TEST("/containment_factor/extremes")
{
    auto const ball = [](double a) {
        return pw85::SymmetricMatrix<double, 3>{a * a, 0, 0, a * a, 0, a * a};
    };
    auto const near = [](double x, double y) { g_assert_cmpfloat_with_epsilon(x / y, 1.0, 1e-14); };
    near(pw85::containment(pw85::Vector{1e150, 0.0, 0.0}, ball(1e150), ball(1e-150)).mu2, 1.0);
    near(pw85::containment(pw85::Vector{1e-150, 0.0, 0.0}, ball(1.0), ball(1.0)).mu2, 1.0);
    near(pw85::containment(pw85::Vector{3e-100, 4e-100, 0.0}, ball(1.0), ball(1e-150)).mu2,
         2.5e-199);
    near(pw85::containment(pw85::Vector{1e100, 0.0, 0.0}, ball(1e-50), ball(1.0)).mu2, 1e300);
    near(pw85::containment(pw85::Vector{0.0, 0.0, 0.0}, ball(1e-70), ball(1e80)).mu2, 1e300);
    g_assert_true(
        std::isinf(pw85::containment(pw85::Vector{0.0, 0.0, 0.0}, ball(1e-150), ball(1e150)).mu2));
    g_assert_true(pw85::containment(pw85::Vector{0.0, 0.0, 0.0}, ball(1e150), ball(1e-150)).mu2 ==
                  0.0);
}

// pw85_contains() and the factor agree, outside of the error of the factor. The C functions give
// the bits of the headers.
PW85_TEST("/containment_factor/agreement")
{
    Failures failures;
    Random random(630);
    std::vector<Sample<double, 3>> pairs;
    std::vector<double> r12, q1, q2;
    for (int n = 0; n < draws(2000); ++n) {
        auto s = hostile_pair<3>(random, n);
        double const mu2 = pw85::containment(s.r12, s.q1, s.q2).mu2;
        if (!(mu2 > 0.0)) continue;
        for (int k = 0; k < 6; ++k) s.q1[k] *= mu2 * random.uniform(0.9, 1.1);
        int contains = 7;
        if (pw85_contains(s.r12.coordinates, s.q1.entries, s.q2.entries, &contains) != PW85_SUCCESS)
            continue;
        auto const c = pw85::containment(s.r12, s.q1, s.q2);
        double const margin = static_cast<double>(check_point(s, c.point).sum) * 0x1p-49;
        if (std::abs(c.mu2 - 1) > margin)
            failures.check(contains == (c.mu2 < 1), "contains", contains, c.mu2 < 1,
                           [&] { return hex_text(s); });
        pairs.push_back(s);
        r12.insert(r12.end(), s.r12.coordinates, s.r12.coordinates + 3);
        q1.insert(q1.end(), s.q1.entries, s.q1.entries + 6);
        q2.insert(q2.end(), s.q2.entries, s.q2.entries + 6);
    }
    std::vector<double> mu2(pairs.size()), points(3 * pairs.size());
    g_assert_cmpint(pw85_containment_batch(pairs.size(), r12.data(), q1.data(), q2.data(),
                                           mu2.data(), points.data()),
                    ==, PW85_SUCCESS);
    for (std::size_t n = 0; n < pairs.size(); ++n) {
        auto const &s = pairs[n];
        auto const c = pw85::containment(s.r12, s.q1, s.q2);
        auto const describe = [&] { return hex_text(s); };
        failures.check(mu2[n] == c.mu2, "batch", mu2[n], c.mu2, describe);
        for (std::size_t i = 0; i < 3; ++i)
            failures.check(points[3 * n + i] == c.point[static_cast<int>(i)], "point",
                           points[3 * n + i], c.point[static_cast<int>(i)], describe);
    }
}

// In two dimensions the C functions are those of the headers.
PW85_TEST("/containment_factor/two_dimensions")
{
    Failures failures;
    Random random(640);
    for (int n = 0; n < draws(400); ++n) {
        auto const s = hostile_pair<2>(random, n);
        auto const c = pw85::containment(s.r12, s.q1, s.q2);
        auto const inside = pw85::contains(s.r12, s.q1, s.q2);
        double mu2 = 7, point[2] = {7, 7};
        int contains = 7;
        auto const describe = [&] { return hex_text(s); };
        int const status =
            pw85_containment_2d(s.r12.coordinates, s.q1.entries, s.q2.entries, &mu2, point);
        failures.check(status == static_cast<int>(c.status), "status", status,
                       static_cast<int>(c.status), describe);
        pw85_contains_2d(s.r12.coordinates, s.q1.entries, s.q2.entries, &contains);
        if (status != PW85_SUCCESS) continue;
        failures.check(mu2 == c.mu2 && point[0] == c.point[0] && point[1] == c.point[1], "2d", mu2,
                       c.mu2, describe);
        failures.check(contains == inside.contains, "contains", contains, inside.contains,
                       describe);
    }
}

// A unit ball around thin ellipsoids along the axes. The longest axis is across a long separation,
// where M is nearly singular and the upper bound cancels. The centre of ellipsoid 2 is inside the
// scaled ball: κ² >= |r12|².
PW85_TEST("/containment_factor/across_the_separation")
{
    Failures failures;
    Random random(93);
    // for these the bound was below the other one by far
    constexpr double known[2][2][3] = {
        {{1.6275910964207236e-06, 107.28588216361874, 1.8242096231504765e-08},
         {245372.35565671985, 15.085282241407107, 17.984412980620625}},
        {{1.1947616462177535e-07, 1.1891701825697902e-06, 121.32404963259958},
         {2.59297447122125, 1327.5985394889212, 2.6325295022406077}}};
    for (int i = 0; i < draws(16000); ++i) {
        double r12[3], mu2, point[3], square = 0;
        double const q1[6] = {1, 0, 0, 1, 0, 1};
        double q2[6] = {};
        for (int k = 0; k < 3; ++k) {
            double const axis = i < 2 ? known[i][0][k] : random.log_uniform(1e-8, 1e4);
            q2[k == 0 ? 0 : k == 1 ? 3 : 5] = axis * axis;
            r12[k] = i < 2 ? known[i][1][k] : random.log_uniform(1e-2, 1e6);
            square += r12[k] * r12[k];
        }
        g_assert_cmpint(pw85_containment(r12, q1, q2, &mu2, point), ==, PW85_SUCCESS);
        failures.check(mu2 >= square * (1 - 1e-12), "kappa2", mu2, square,
                       [&] { return hex_text(r12, 3) + " " + hex_text(q2, 6); });
    }
}

PW85_ADD_TEST("/containment_factor/random/float", test_random<float, 3>);
PW85_ADD_TEST("/containment_factor/random/double", test_random<double, 3>);
PW85_ADD_TEST("/containment_factor/random/long_double", test_random<long double, 3>);
PW85_ADD_TEST("/containment_factor/random/2d", test_random<double, 2>);

} // namespace
