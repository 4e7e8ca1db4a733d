// SPDX-License-Identifier: BSD-3-Clause
// Tests of contact point, normal, gradient and torque. The items are those of
// include/pw85/contact/geometry.hpp.
#include <cmath>

#include <glib.h>

#include <pw85.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using WideSample = Sample<Wide, 3>;

Wide contact_value(WideSample const &p) { return pw85::contact(p.r12, p.q1, p.q2).mu2; }

/// Central difference of μ² along a one-parameter family of pairs, with an error of h² times the
/// third derivative.
template <class Family> Wide central_difference(Family family)
{
    Wide const h("1e-14");
    return (contact_value(family(h)) - contact_value(family(Wide(-h)))) / (2 * h);
}

/// Rodrigues' rotation of a form about a coordinate axis.
WideForm rotated(WideForm const &q, int axis, Wide const &angle)
{
    int const i = (axis + 1) % 3, j = (axis + 2) % 3;
    Wide const c = cos(angle), s = sin(angle);
    WideForm r = q;
    r(i, i) = c * c * q(i, i) - 2 * c * s * q(i, j) + s * s * q(j, j);
    r(j, j) = s * s * q(i, i) + 2 * c * s * q(i, j) + c * c * q(j, j);
    r(i, j) = (c * c - s * s) * q(i, j) + c * s * (q(i, i) - q(j, j));
    r(axis, i) = c * q(axis, i) - s * q(axis, j);
    r(axis, j) = s * q(axis, i) + c * q(axis, j);
    return r;
}

// Truncation leaves 1e-28 times the third derivative, which for aspect 4 is at most 1e5 times μ²; λ
// of the wide type limits the formula to its accuracy, 1e-32.
void check_wide(Failures &failures, Wide const &actual, Wide const &difference, Wide const &scale,
                char const *what, WideSample const &p)
{
    double const error = std::fabs(static_cast<double>(Wide((actual - difference) / scale)));
    failures.check(error <= 1e-22, what, error, 1e-22, [&] { return hex_text(p); });
}

void check_gradient_by_differences(Failures &failures, WideSample const &p)
{
    auto const c = pw85::contact(p.r12, p.q1, p.q2);
    auto const gradient = pw85::contact_gradient(p.r12, p.q1, p.q2, c.lambda);
    for (int i = 0; i < 3; ++i) {
        Wide const d = central_difference([&](Wide const &h) {
            WideSample moved = p;
            moved.r12[i] += h;
            return moved;
        });
        check_wide(failures, gradient.r12[i], d, c.mu2, "d_r12", p);
    }
    for (int k = 0; k < 6; ++k) {
        Wide const d1 = central_difference([&](Wide const &h) {
            WideSample changed = p;
            changed.q1[k] += h;
            return changed;
        });
        Wide const d2 = central_difference([&](Wide const &h) {
            WideSample changed = p;
            changed.q2[k] += h;
            return changed;
        });
        check_wide(failures, gradient.q1[k], d1, c.mu2, "d_q1", p);
        check_wide(failures, gradient.q2[k], d2, c.mu2, "d_q2", p);
    }
}

PW85_TEST("/geometry/gradient/differences")
{
    Failures failures;
    Random random(80);
    for (int n = 0; n < 50; ++n)
        check_gradient_by_differences(
            failures, convert<Wide>(random_pair<3>(random, {.aspect = 4.0, .mu2_min = 0.1})));
}

PW85_TEST("/geometry/torque/differences")
{
    Failures failures;
    Random random(81);
    for (int n = 0; n < 50; ++n) {
        auto const p = convert<Wide>(random_pair<3>(random, {.aspect = 4.0, .mu2_min = 0.1}));
        auto const c = pw85::contact(p.r12, p.q1, p.q2);
        auto const torque = pw85::contact_torque(p.r12, p.q1, p.q2, c.lambda);
        for (int axis = 0; axis < 3; ++axis) {
            Wide const d1 = central_difference([&](Wide const &h) {
                return WideSample{p.r12, rotated(p.q1, axis, h), p.q2};
            });
            Wide const d2 = central_difference([&](Wide const &h) {
                return WideSample{p.r12, p.q1, rotated(p.q2, axis, h)};
            });
            check_wide(failures, torque.rotation1[axis], d1, c.mu2, "d_rot1", p);
            check_wide(failures, torque.rotation2[axis], d2, c.mu2, "d_rot2", p);
        }
    }
}

/// All that the C API says of the geometry of a pair.
struct Derivatives {
    Vector3 point, normal, r12, rotation1, rotation2;
    Form3 q1, q2;
};

Derivatives derivatives(Sample<double, 3> const &p, double lambda)
{
    Derivatives d{};
    double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    pw85_contact_geometry(r12, q1, q2, lambda, d.point.coordinates, d.normal.coordinates);
    pw85_contact_gradient(r12, q1, q2, lambda, d.r12.coordinates, d.q1.entries, d.q2.entries);
    pw85_contact_torque(r12, q1, q2, lambda, d.rotation1.coordinates, d.rotation2.coordinates);
    return d;
}

double lambda_of(Sample<double, 3> const &p)
{
    double out[2];
    pw85_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    return out[1];
}

template <class T> double largest(T const *x, int count)
{
    double largest = 0.0;
    for (int i = 0; i < count; ++i)
        largest = std::fmax(largest, std::fabs(static_cast<double>(x[i])));
    return largest;
}

// In double, at the same λ as in the wide type: s errs by at most 16u times the condition number of
// the blend, 100² or less, relative to its largest coordinate; outputs are of first or second
// degree in s.
PW85_TEST("/geometry/rounding_errors")
{
    Failures failures;
    Random random(82);
    for (int n = 0; n < draws(5000); ++n) {
        double const aspect = random.log_uniform(1.0, 100.0), bound = 64 * u * aspect * aspect;
        auto const p = random_pair<3>(random, {.aspect = aspect});
        auto const w = convert<Wide>(p);
        double const lambda = lambda_of(p);
        auto const d = derivatives(p, lambda);
        auto const geometry = pw85::contact_geometry(w.r12, w.q1, w.q2, Wide(lambda));
        auto const gradient = pw85::contact_gradient(w.r12, w.q1, w.q2, Wide(lambda));
        auto const check = [&](double const *actual, Wide const *expected, int count,
                               char const *what) {
            for (int i = 0; i < count; ++i) {
                double const error = std::fabs(static_cast<double>(Wide(actual[i] - expected[i])));
                failures.check(error <= bound * largest(expected, count), what, actual[i],
                               static_cast<double>(expected[i]),
                               [&] { return hex_text(p) + ", lambda = " + hex_text(&lambda, 1); });
            }
        };
        check(d.point.coordinates, geometry.point.coordinates, 3, "point");
        check(d.normal.coordinates, geometry.normal.coordinates, 3, "normal");
        check(d.r12.coordinates, gradient.r12.coordinates, 3, "d_r12");
        check(d.q1.entries, gradient.q1.entries, 6, "d_q1");
        check(d.q2.entries, gradient.q2.entries, 6, "d_q2");
    }
}

// No net torque: a rotation of all, r12 included, leaves μ² as it is. With n = M⁻¹r, M = (1-λ)Q1 +
// λQ2, the sum is 2λ(1-λ) n × (M n - r). By factorisation, the computed n solves a system whose
// matrix differs by at most 10u of the trace of M from this one, and the products round: |M n - r|
// <= 32u tr M |n|. By the adjugate, n errs by 108u/d in the norm of M (see the conditioning of M in
// include/pw85/contact/rational.hpp), in which it measures √(rᵀn), so that |M n - r| <= √(tr M rᵀn)
// 108u/d.
PW85_TEST("/geometry/no_net_torque")
{
    Failures failures;
    Random random(83);
    for (int n = 0; n < draws(20000); ++n) {
        auto const p = random_pair<3>(random, {.aspect = 1e3, .size_ratio = 10.0});
        double const lambda = lambda_of(p), weight = 2.0 * lambda * (1.0 - lambda);
        auto const d = derivatives(p, lambda);
        auto const arm = pw85::cross(p.r12, d.r12);
        auto const m = pw85::detail::blend(1.0 - lambda, p.q1, lambda, p.q2);
        double const norm = std::sqrt(pw85::dot(d.r12, d.r12)), trace = m[0] + m[3] + m[5];
        double const conditioning =
            pw85::detail::determinant(m, pw85::detail::adjugate(m)) / (m[0] * m[3] * m[5]);
        double residual = 32 * u * trace * norm / weight;
        if (conditioning > 0.9 * pw85::detail::adjugate_conditioning<double>())
            residual +=
                std::sqrt(trace * pw85::dot(p.r12, d.r12) / weight) * 108 * u / conditioning;
        for (int i = 0; i < 3; ++i) {
            double const sum = d.rotation1[i] + d.rotation2[i] + arm[i], bound = norm * residual;
            failures.check(std::fabs(sum) <= bound, "net torque", sum, bound,
                           [&] { return hex_text(p) + ", lambda = " + hex_text(&lambda, 1); });
        }
    }
}

// Forces are equal and opposite: exchanging the ellipsoids changes the sign of d_r12, and exchanges
// the rest. The two computations differ by rounding, and in 1-λ.
PW85_TEST("/geometry/exchange")
{
    Failures failures;
    Random random(84);
    for (int n = 0; n < draws(5000); ++n) {
        double const aspect = random.log_uniform(1.0, 100.0), bound = 128 * u * aspect * aspect;
        auto const p = random_pair<3>(random, {.aspect = aspect});
        // A λ whose complement is a double too.
        double const lambda = std::round(lambda_of(p) * 0x1p40) * 0x1p-40;
        if (!(lambda > 0x1p-10 && lambda < 1.0 - 0x1p-10)) continue;
        auto const d = derivatives(p, lambda);
        auto const e = derivatives({-p.r12, p.q2, p.q1}, 1.0 - lambda);
        auto const check = [&](double const *x, double const *y, int count, double sign,
                               char const *what) {
            for (int i = 0; i < count; ++i)
                failures.check(std::fabs(x[i] - sign * y[i]) <= bound * largest(x, count), what,
                               x[i], sign * y[i],
                               [&] { return hex_text(p) + ", lambda = " + hex_text(&lambda, 1); });
        };
        check(d.r12.coordinates, e.r12.coordinates, 3, -1.0, "d_r12");
        check(d.normal.coordinates, e.normal.coordinates, 3, -1.0, "normal");
        check(d.q1.entries, e.q2.entries, 6, 1.0, "d_q1");
        check(d.q2.entries, e.q1.entries, 6, 1.0, "d_q2");
        double const torque = 2.0 * largest(d.r12.coordinates, 3) * largest(p.r12.coordinates, 3);
        for (int i = 0; i < 3; ++i)
            failures.check(std::fabs(d.rotation1[i] - e.rotation2[i]) <= bound * torque, "d_rot1",
                           d.rotation1[i], e.rotation2[i], [&] { return hex_text(p); });
    }
}

void assert_close(double actual, double expected, double tolerance)
{
    g_assert_cmpfloat(std::fabs(actual - expected), <=, tolerance);
}

/// Checks a pair whose derivatives are known, and without torques.
void expect_touching(Derivatives const &d, Vector3 const &point, Vector3 const &normal,
                     Vector3 const &force, double tolerance)
{
    for (int i = 0; i < 3; ++i) {
        assert_close(d.point[i], point[i], tolerance);
        assert_close(d.normal[i], normal[i], 4 * u);
        assert_close(d.r12[i], force[i], 4 * u);
        assert_close(d.rotation1[i], 0.0, 4 * u);
        assert_close(d.rotation2[i], 0.0, 4 * u);
    }
}

// μ² = r²/(a1+a2)², touching at r a1/(a1+a2), with ∂μ²/∂r = 2r/(a1+a2)² and no torque.
PW85_TEST("/geometry/spheres")
{
    Sample<double, 3> const p{
        {1.0, 2.0, 2.0}, {4.0, 0.0, 0.0, 4.0, 0.0, 4.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}};
    expect_touching(derivatives(p, 2.0 / 3.0), (2.0 / 3.0) * p.r12, (1.0 / 3.0) * p.r12,
                    (2.0 / 9.0) * p.r12, 8 * u);
}

// Two spheroids on one axis, end to end: μ = r/(c1+c2), at the ends.
PW85_TEST("/geometry/end_to_end")
{
    // Semi-axes 1, 1, 3 and 2, 2, 5; r = 16, so μ = 2 and λ = 3/8.
    Sample<double, 3> const p{
        {0.0, 0.0, 16.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 9.0}, {4.0, 0.0, 0.0, 4.0, 0.0, 25.0}};
    double out[2];
    pw85_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    assert_close(out[0], 4.0, 16 * u);
    assert_close(out[1], 0.375, 16 * u);
    auto const d = derivatives(p, 0.375);
    expect_touching(d, {0.0, 0.0, 6.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 0.5}, 16 * u);
    // dμ²/d(c²) = -2μ² /(c1+c2) · 1/(2c) for the axis in question, none for the others.
    assert_close(d.q1[5], -4.0 / 8.0 / 3.0, 4 * u);
    assert_close(d.q2[5], -4.0 / 8.0 / 5.0, 4 * u);
    for (int k = 0; k < 5; ++k) {
        assert_close(d.q1[k], 0.0, 4 * u);
        assert_close(d.q2[k], 0.0, 4 * u);
    }
}

// A spheroid on the flank of another, as in a T: the end of one, c1 = 3, and the waist of the
// other, a2 = 1.
PW85_TEST("/geometry/t_shaped")
{
    Sample<double, 3> const p{
        {0.0, 0.0, 2.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 9.0}, {16.0, 0.0, 0.0, 1.0, 0.0, 1.0}};
    double out[2];
    pw85_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    assert_close(out[0], 0.25, 8 * u);
    assert_close(out[1], 0.75, 16 * u);
    expect_touching(derivatives(p, 0.75), {0.0, 0.0, 1.5}, {0.0, 0.0, 1.0}, {0.0, 0.0, 0.25},
                    8 * u);
}

// The pair of the tutorial, with the numbers of the manual.
PW85_TEST("/geometry/tutorial")
{
    Sample<double, 3> const p{
        {0.7, -0.7, 1.1}, {100.0, 0.0, 0.0, 100.0, 0.0, 0.01}, {25.0, 0.0, 0.0, 0.25, 0.0, 0.25}};
    double const lambda = lambda_of(p);
    auto const d = derivatives(p, lambda);
    double const x1[3] = {-0.5, 0.4, -0.7}, point[3] = {0.16662271, -0.29964969, -0.51687799};
    double const normal[3] = {3.64031943e-04, -3.82067448e-04, 9.99999861e-01};
    assert_close(lambda, 0.1668589553405904, 1e-12);
    for (int i = 0; i < 3; ++i) {
        assert_close(d.point[i] + x1[i], point[i], 1e-8);
        assert_close(d.normal[i], normal[i], 1e-9);
    }
}

// Outputs that are null are left out; the others do not change.
PW85_TEST("/geometry/optional_outputs")
{
    Sample<double, 3> const p{
        {1.0, 2.0, 3.0}, {2.0, 0.5, 0.0, 1.0, 0.0, 1.0}, {1.0, 0.0, 0.0, 3.0, 0.5, 1.0}};
    double const lambda = lambda_of(p), *r12 = p.r12.coordinates, *q1 = p.q1.entries,
                 *q2 = p.q2.entries;
    auto const d = derivatives(p, lambda);
    double three[3], six[6];
    auto const same = [](double const *x, double const *y, int count) {
        for (int i = 0; i < count; ++i) g_assert_cmpfloat(x[i], ==, y[i]);
    };
    g_assert_cmpint(pw85_contact_geometry(r12, q1, q2, lambda, three, nullptr), ==, PW85_SUCCESS);
    same(three, d.point.coordinates, 3);
    g_assert_cmpint(pw85_contact_geometry(r12, q1, q2, lambda, nullptr, three), ==, PW85_SUCCESS);
    same(three, d.normal.coordinates, 3);
    g_assert_cmpint(pw85_contact_gradient(r12, q1, q2, lambda, three, nullptr, nullptr), ==,
                    PW85_SUCCESS);
    same(three, d.r12.coordinates, 3);
    g_assert_cmpint(pw85_contact_gradient(r12, q1, q2, lambda, nullptr, six, nullptr), ==,
                    PW85_SUCCESS);
    same(six, d.q1.entries, 6);
    g_assert_cmpint(pw85_contact_gradient(r12, q1, q2, lambda, nullptr, nullptr, six), ==,
                    PW85_SUCCESS);
    same(six, d.q2.entries, 6);
    g_assert_cmpint(pw85_contact_torque(r12, q1, q2, lambda, three, nullptr), ==, PW85_SUCCESS);
    same(three, d.rotation1.coordinates, 3);
    g_assert_cmpint(pw85_contact_torque(r12, q1, q2, lambda, nullptr, three), ==, PW85_SUCCESS);
    same(three, d.rotation2.coordinates, 3);
}

} // namespace
