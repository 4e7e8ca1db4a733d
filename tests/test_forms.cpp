// SPDX-License-Identifier: BSD-3-Clause
// Tests of the functions that make quadratic forms.
#include <cmath>
#include <limits>
#include <numbers>

#include <glib.h>

#include <pw85.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

// a²(I - nnᵀ) + c²nnᵀ from the doubles a, c, n exactly as given, n normalised.
Form3 exact_spheroid(double a, double c, Vector3 const &n)
{
    Wide norm2 = 0;
    for (int i = 0; i < 3; ++i) norm2 += Wide(n[i]) * n[i];
    Form3 q{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            Wide const direction = Wide(n[i]) * n[j] / norm2;
            q(i, j) = static_cast<double>(
                Wide((i == j ? 1 : 0) * Wide(a) * a + (Wide(c) * c - Wide(a) * a) * direction));
        }
    return q;
}

void check_form(Failures &failures, Form3 const &actual, Form3 const &expected, double bound)
{
    for (int k = 0; k < 6; ++k)
        failures.check(std::fabs(actual[k] - expected[k]) <= bound * std::fabs(expected[k]),
                       "entry", actual[k], expected[k],
                       [&] { return "expected " + hex_text(expected.entries, 6); });
}

// No entry cancels: the diagonal is a sum of squares, the rest a product. Ten roundings at most.
PW85_TEST("/forms/spheroid/random")
{
    Failures failures;
    Random random(10);
    for (int i = 0; i < draws(20000); ++i) {
        double const a = random.log_uniform(1e-6, 1e6), c = random.log_uniform(1e-6, 1e6);
        auto const n = random.log_uniform(1e-200, 1e200) * random.direction<3>();
        Form3 q{};
        pw85_spheroid(a, c, n.coordinates, q.entries);
        check_form(failures, q, exact_spheroid(a, c, n), 12 * u);
    }
}

PW85_TEST("/forms/spheroid/reference")
{
    auto const &grid = spheroid_grid();
    Failures failures;
    std::size_t row = 0;
    for (double const a : grid.radii)
        for (double const c : grid.radii)
            for (auto const &n : grid.directions) {
                Form3 q{};
                pw85_spheroid(a, c, n.coordinates, q.entries);
                check_form(failures, q, grid.spheroids[row++], 12 * u);
            }
}

PW85_TEST("/forms/ellipsoid/by_hand")
{
    // The first axis along y, the second along z, the third along x.
    double const axes[3] = {1.0, 2.0, 3.0},
                 rotation[9] = {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    double const expected[6] = {9.0, 0.0, 0.0, 1.0, 0.0, 4.0}, quaternion[4] = {0.5, 0.5, 0.5, 0.5};
    double q[6];
    g_assert_cmpint(pw85_ellipsoid(axes, rotation, q), ==, PW85_SUCCESS);
    for (int k = 0; k < 6; ++k) g_assert_cmpfloat(q[k], ==, expected[k]);
    g_assert_cmpint(pw85_ellipsoid_quaternion(axes, quaternion, q), ==, PW85_SUCCESS);
    for (int k = 0; k < 6; ++k) g_assert_cmpfloat(q[k], ==, expected[k]);
}

// A quaternion is the rotation whose matrix it stands for, whatever its length and sign.
PW85_TEST("/forms/ellipsoid/quaternion")
{
    Failures failures;
    Random random(11);
    for (int n = 0; n < draws(5000); ++n) {
        auto const axes = random.semi_axes(1.0, random.log_uniform(1.0, 1e3));
        auto const unit = random.direction<4>();
        auto const rotation = pw85::detail::rotation_matrix(unit, pw85::dot(unit, unit));
        auto const scaled = -random.log_uniform(1e-200, 1e200) * unit;
        Form3 by_matrix{}, by_quaternion{};
        pw85_ellipsoid(axes.coordinates, rotation.entries, by_matrix.entries);
        pw85_ellipsoid_quaternion(axes.coordinates, scaled.coordinates, by_quaternion.entries);
        for (int k = 0; k < 6; ++k)
            // Entries of a rotation are off by a few u; those of Q are sums of products with
            // squares of axes <= 1.
            failures.check(std::fabs(by_matrix[k] - by_quaternion[k]) <= 32 * u, "entry",
                           by_matrix[k], by_quaternion[k], [&] {
                               return hex_text(axes.coordinates, 3) + hex_text(unit.coordinates, 4);
                           });
    }
}

/// Checks that no entry is -0.
void check_zeros(Failures &failures, char const *what, double const *entries, int count)
{
    for (int k = 0; k < count; ++k)
        failures.check(entries[k] != 0 || !std::signbit(entries[k]), what, entries[k], 0,
                       [&] { return hex_text(entries, count); });
}

// Directions and turns along the axes, with zeros of both signs: a product of 0 and a negative
// number is -0.
PW85_TEST("/forms/no_negative_zeros")
{
    Failures failures;
    double const numbers[] = {1.0, -1.0, 0.0, -0.0}, axes[3] = {2.0, 3.0, 5.0};
    for (int code = 0; code < 256; ++code) {
        double const n[4] = {numbers[code & 3], numbers[code >> 2 & 3], numbers[code >> 4 & 3],
                             numbers[code >> 6]};
        double q[6], s[9];
        for (double const c : {1.0, 3.0}) {
            pw85_spheroid(2.0, c, n, q);
            check_zeros(failures, "spheroid", q, 6);
        }
        pw85_ellipsoid_quaternion(axes, n, q);
        check_zeros(failures, "ellipsoid_quaternion", q, 6);
        pw85_ellipsoid_factor(axes, n, s);
        check_zeros(failures, "ellipsoid_factor", s, 9);
        double const rotation[9] = {n[0], 0.0, -0.0, 0.0, n[1], -0.0, -0.0, 0.0, n[2]};
        pw85_ellipsoid(axes, rotation, q);
        check_zeros(failures, "ellipsoid", q, 6);
    }
    for (double const angle : {0.0, -0.0, 1e-320, -1e-320}) {
        double q[3];
        pw85_ellipse(2.0, 1.0, angle, q);
        check_zeros(failures, "ellipse", q, 3);
    }
}

PW85_TEST("/forms/ellipsoid/spheroid")
{
    // A quarter turn about y takes the polar axis z to x.
    double const axes[3] = {2.0, 2.0, 5.0}, turn[4] = {1.0, 0.0, 1.0, 0.0}, n[3] = {1.0, 0.0, 0.0};
    double q[6], expected[6];
    pw85_spheroid(2.0, 5.0, n, expected);
    g_assert_cmpint(pw85_ellipsoid_quaternion(axes, turn, q), ==, PW85_SUCCESS);
    for (int k = 0; k < 6; ++k) g_assert_cmpfloat(std::fabs(q[k] - expected[k]), <=, 25.0 * 8 * u);
}

PW85_TEST("/forms/ellipse")
{
    double q[3];
    g_assert_cmpint(pw85_ellipse(3.0, 2.0, 0.0, q), ==, PW85_SUCCESS);
    g_assert_cmpfloat(q[0], ==, 9.0);
    g_assert_cmpfloat(q[1], ==, 0.0);
    g_assert_cmpfloat(q[2], ==, 4.0);
    g_assert_cmpint(pw85_ellipse(3.0, 1.0, std::numbers::pi / 4.0, q), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(q[0] - 5.0), <=, 32 * u);
    g_assert_cmpfloat(std::fabs(q[1] - 4.0), <=, 32 * u);
    g_assert_cmpfloat(std::fabs(q[2] - 5.0), <=, 32 * u);
}

void assert_invalid(int status, double const *q, int count)
{
    g_assert_cmpint(status, ==, PW85_EINVAL);
    for (int k = 0; k < count; ++k) g_assert_true(std::isnan(q[k]));
}

PW85_TEST("/forms/invalid/lengths")
{
    // Turned axes mix their squares, so that no entry of the form vanishes with the square of one
    // axis.
    double const n[3] = {0.0, 0.0, 1.0}, skew[3] = {0.48, 0.6, 0.64};
    double const quaternion[4] = {1.0, 0.0, 0.0, 0.0}, turned[4] = {1.0, 2.0, 3.0, 4.0};
    double const identity[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    // Squares of 1e160 and 1e-170 are beyond the range of double.
    for (double const bad : {0.0, -1.0, nan, infinity, -infinity, 1e160, 1e-170}) {
        for (int i = 0; i < 3; ++i) {
            double axes[3] = {1.0, 1.0, 1.0}, q[6] = {};
            axes[i] = bad;
            assert_invalid(pw85_ellipsoid(axes, identity, q), q, 6);
            for (double const *orientation : {quaternion, turned})
                assert_invalid(pw85_ellipsoid_quaternion(axes, orientation, q), q, 6);
        }
        double q[6] = {};
        for (double const *axis : {n, skew}) {
            pw85_spheroid(bad, 1.0, axis, q);
            assert_invalid(PW85_EINVAL, q, 6);
            pw85_spheroid(1.0, bad, axis, q);
            assert_invalid(PW85_EINVAL, q, 6);
        }
        for (double const angle : {0.0, 0.3}) {
            assert_invalid(pw85_ellipse(bad, 1.0, angle, q), q, 3);
            assert_invalid(pw85_ellipse(1.0, bad, angle, q), q, 3);
        }
    }
    for (double const bad : {nan, infinity}) {
        double q[3] = {};
        assert_invalid(pw85_ellipse(1.0, 1.0, bad, q), q, 3);
    }
}

PW85_TEST("/forms/invalid/orientations")
{
    double const axes[3] = {1.0, 2.0, 3.0}, zero[4] = {0.0, 0.0, 0.0, 0.0},
                 not_a_number[4] = {1.0, nan, 0.0, 0.0};
    double const infinite[4] = {1.0, 0.0, infinity, 0.0};
    double q[6] = {};
    for (double const *bad : {zero, not_a_number, infinite}) {
        assert_invalid(pw85_ellipsoid_quaternion(axes, bad, q), q, 6);
        pw85_spheroid(1.0, 2.0, bad + 1, q);
        assert_invalid(PW85_EINVAL, q, 6);
    }
    double rotation[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    for (int i = 0; i < 9; ++i) {
        double const entry = rotation[i];
        for (double const bad : {entry + 2e-6, nan, infinity}) {
            rotation[i] = bad;
            assert_invalid(pw85_ellipsoid(axes, rotation, q), q, 6);
        }
        rotation[i] = entry + 2e-7;
        g_assert_cmpint(pw85_ellipsoid(axes, rotation, q), ==, PW85_SUCCESS);
        rotation[i] = entry;
    }
}

} // namespace
