// SPDX-License-Identifier: BSD-3-Clause
// Random points of ellipsoids (src/enclosing/random_points.cpp): chi-square tests over cells of the
// ball and of spheroids, whose shares of the area are elementary; second moments; and the distance
// from the surface with 50 digits.
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/enclosing.hpp>
#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

double const u = 0x1p-53;
std::size_t const num_points = 40000;

std::vector<Vector3> drawn(Form3 const &q, bool surface, std::size_t seed = 20261129,
                           std::size_t n = num_points)
{
    std::vector<Vector3> points(n);
    auto const status = pw85::random_points(q, surface, seed, points);
    g_assert_true(status == pw85::StatusCode::success);
    return points;
}

Form3 diagonal(double a, double b, double c) { return {a * a, 0, 0, b * b, 0, c * c}; }

/// What chi-square exceeds with a probability below e⁻²⁰: the inequality of Laurent and Massart
/// (2000), lemma 1.
double largest_chi_square(double freedom) { return freedom + 2 * std::sqrt(freedom * 20) + 40; }

double chi_square(std::vector<double> const &counts, std::vector<double> const &shares)
{
    double sum = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        double const expected = shares[k] * static_cast<double>(num_points);
        sum += (counts[k] - expected) * (counts[k] - expected) / expected;
    }
    return sum;
}

/// One of n parts of [0, 1].
std::size_t part(double x, std::size_t n)
{
    return std::min(static_cast<std::size_t>(x * static_cast<double>(n)), n - 1);
}

std::size_t octant(Vector3 const &x)
{
    return std::size_t{x[0] < 0} + 2 * std::size_t{x[1] < 0} + 4 * std::size_t{x[2] < 0};
}

/// 128 cells of the ball with the same volume: shells, slices of height, and octants.
std::size_t cell_of_ball(Vector3 const &x)
{
    double const radius = std::hypot(x[0], x[1], x[2]);
    return (part(radius * radius * radius, 4) * 4 + part(std::abs(x[2]) / radius, 4)) * 8 +
           octant(x);
}

/// Points of the body are those of the ball, after any map that turns one into the other.
PW85_TEST("/random_points/body")
{
    Failures failures;
    for (double const size : {0x1p-40, 1.0, 0x1p40})
        for (Vector3 const &axes :
             {Vector3{1, 1, 1}, Vector3{1, 1e6, 1e6}, Vector3{1, 1, 1e6}, Vector3{1e6, 1, 1e3}}) {
            Form3 const q = diagonal(size * axes[0], size * axes[1], size * axes[2]);
            std::vector<double> counts(128);
            for (Vector3 x : drawn(q, false)) {
                for (int i = 0; i < 3; ++i) x[i] /= size * axes[i];
                ++counts[cell_of_ball(x)];
            }
            double const found = chi_square(counts, std::vector<double>(128, 1.0 / 128)),
                         bound = largest_chi_square(127);
            failures.check(found < bound, "chi-square", found, bound,
                           [&] { return hex_text(q.entries, 6); });
        }
}

/// The area of a spheroid with the semi-axes a, a, c between the heights 0 and c t, divided by 2πa:
/// the integral of √(c² + (a² - c²) t²).
double area_below(double t, double a, double c)
{
    double const k = a * a - c * c, root = std::sqrt(std::abs(k)) / c;
    double const curved = k == 0 ? t : (k > 0 ? std::asinh(root * t) : std::asin(root * t)) / root;
    return (t * std::sqrt(c * c + k * t * t) + c * curved) / 2;
}

/// 64 cells of spheroids: eight slices of each half, in four quadrants of the same area.
PW85_TEST("/random_points/surface")
{
    Failures failures;
    for (double const size : {0x1p-40, 1.0, 0x1p40})
        for (double const c : {1e-6, 1e-2, 0.5, 1.0, 2.0, 1e2, 1e6}) {
            Form3 const q = diagonal(size, size, size * c);
            std::vector<double> counts(64), shares(64);
            for (Vector3 const &x : drawn(q, true))
                ++counts[part(std::abs(x[2]) / (size * c), 8) * 8 + octant(x)];
            for (std::size_t k = 0; k < 64; ++k) {
                double const below = static_cast<double>(k / 8) / 8;
                shares[k] = (area_below(below + 0.125, 1, c) - area_below(below, 1, c)) /
                            area_below(1, 1, c) / 8;
            }
            double const found = chi_square(counts, shares), bound = largest_chi_square(63);
            failures.check(found < bound, "chi-square", found, bound,
                           [&] { return hex_text(q.entries, 6); });
        }
}

/// Second moments of points of any ellipsoids. |x_i x_j| is at most √(q_ii q_jj) on an ellipsoid,
/// so a mean of independent products differs by this times √(2·20/N) with a probability below 2
/// e⁻²⁰ (Hoeffding).
PW85_TEST("/random_points/moments")
{
    Failures failures;
    Random random(20261129);
    for (int n = 0; n < 20; ++n) {
        Form3 const q = n == 0 ? diagonal(1, 2, 3) : random_form<3>(random, 1.0, 10.0);
        for (bool const surface : {false, true}) {
            double wanted[6];
            (surface ? pw85_shell_moments : pw85_second_moments)(q.entries, wanted);
            Form3 sum{};
            for (Vector3 const &x : drawn(q, surface))
                for (int i = 0; i < 3; ++i)
                    for (int j = i; j < 3; ++j) sum(i, j) += x[i] * x[j];
            for (int i = 0, k = 0; i < 3; ++i)
                for (int j = i; j < 3; ++j, ++k) {
                    double const found = sum(i, j) / static_cast<double>(num_points),
                                 bound = std::sqrt(40.0 / num_points * q(i, i) * q(j, j));
                    failures.check(std::abs(found - wanted[k]) <= bound, "moment", found, wanted[k],
                                   [&] { return hex_text(q.entries, 6); });
                }
        }
    }
}

/// xᵀQ⁻¹x is 1 on the surface, and at most 1 in the body, up to the errors of x. A vector e of
/// errors changes it by 2 ε + ε² at most, with ε² = eᵀQ⁻¹e <= |e|² tr(Q⁻¹), and |e| is below
/// √3 · 10 u times the longest semi-axis.
PW85_TEST("/random_points/distance")
{
    Failures failures;
    Random random(20261130);
    for (int n = 0; n < 2000; ++n) {
        double const size = std::exp2(std::floor(random.uniform(-40.0, 41.0)));
        Form3 const q = random_form<3>(random, size, random.log_uniform(1.0, 1e6));
        WideForm wide;
        for (int k = 0; k < 6; ++k) wide[k] = q[k];
        WideForm inverse = pw85::detail::adjugate(wide);
        Wide const det = pw85::detail::determinant(wide, inverse);
        for (int k = 0; k < 6; ++k) inverse[k] /= det;
        Wide const traces = (wide[0] + wide[3] + wide[5]) * (inverse[0] + inverse[3] + inverse[5]);
        double const e = std::sqrt(300.0 * static_cast<double>(traces)) * u, bound = 2 * e + e * e;
        for (bool const surface : {false, true})
            for (Vector3 const &x : drawn(q, surface, static_cast<std::size_t>(n), 4)) {
                Wide sum = -1;
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) sum += inverse(i, j) * Wide(x[i]) * Wide(x[j]);
                double const away = static_cast<double>(sum);
                failures.check((surface ? std::abs(away) : away) <= bound, "away", away, bound,
                               [&] { return hex_text(q.entries, 6); });
            }
    }
}

/// Fewer points are the first ones of more, other seeds give others, and sizes are exact.
PW85_TEST("/random_points/seeds")
{
    Form3 const q{1, 0.25, 0.5, 4, -0.125, 9}, large = pw85::detail::times_power_of_two(q, 80);
    for (bool const surface : {false, true}) {
        auto const many = drawn(q, surface, 7, 100), few = drawn(q, surface, 7, 10),
                   others = drawn(q, surface, 8, 10), scaled = drawn(large, surface, 7, 10);
        for (std::size_t k = 0; k < 10; ++k)
            for (int i = 0; i < 3; ++i) {
                g_assert_cmpfloat(few[k][i], ==, many[k][i]);
                g_assert_cmpfloat(scaled[k][i], ==, 0x1p40 * many[k][i]);
                g_assert_cmpfloat(few[k][i], !=, others[k][i]);
            }
    }
}

PW85_TEST("/random_points/refusals")
{
    double const flat[] = {1, 0, 0, 1, 0, 0}, nan_form[] = {1, 0, 0, std::nan(""), 0, 1},
                 ball[] = {1, 0, 0, 1, 0, 1};
    for (double const *const q : {flat, nan_form, static_cast<double const *>(nullptr)}) {
        double points[7] = {0, 0, 0, 0, 0, 0, 85};
        int const status = q == flat ? PW85_ENOTPD : PW85_EINVAL;
        g_assert_cmpint(pw85_random_points(q, 0, 1, 2, points), ==, status);
        for (int k = 0; k < 6; ++k) g_assert_true(std::isnan(points[k]));
        g_assert_cmpfloat(points[6], ==, 85);
        g_assert_cmpint(pw85_random_points(q, 1, 1, 0, nullptr), ==, status);
    }
    g_assert_cmpint(pw85_random_points(ball, 1, 1, 1, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_random_points(ball, 1, 1, 0, nullptr), ==, PW85_SUCCESS);
    double point[3];
    g_assert_cmpint(pw85_random_points(ball, 1, 1, SIZE_MAX / 8, point), ==, PW85_EINVAL);
}

} // namespace
