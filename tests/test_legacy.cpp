// SPDX-License-Identifier: BSD-3-Clause
// Tests of the superseded variants. Over the reference data they have the manual's tolerance of
// 1e-10. For other pairs, for which cancellation in the rational form causes larger errors, the
// bound is that of a running error analysis, below.
#include <cmath>
#include <limits>

#include <glib.h>

#include <pw85/history/legacy.hpp>
#include <pw85_legacy.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

Form3 magnitudes(Form3 a)
{
    for (int k = 0; k < 6; ++k) a[k] = std::fabs(a[k]);
    return a;
}

/// The sum of the magnitudes of the terms of the determinant.
double absolute_determinant(Form3 const &a)
{
    Form3 const m = magnitudes(a);
    return m[0] * (m[3] * m[5] + m[4] * m[4]) + m[1] * (m[1] * m[5] + 2.0 * m[2] * m[4]) +
           m[2] * m[2] * m[3];
}

/// The sum of the magnitudes of the terms of xᵀ adj(A) x.
double absolute_adjugate_form(Vector3 const &x, Form3 const &a)
{
    Form3 const m = magnitudes(a);
    Form3 const adjugate = {m[3] * m[5] + m[4] * m[4], m[2] * m[4] + m[1] * m[5],
                            m[1] * m[4] + m[2] * m[3], m[0] * m[5] + m[2] * m[2],
                            m[1] * m[2] + m[0] * m[4], m[0] * m[3] + m[1] * m[1]};
    Vector3 const y{std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])};
    return pw85::detail::quadratic_form(adjugate, y);
}

/// Bounds on the errors of the coefficients of a and b, evaluated as polynomials of x with two
/// derivatives.
///
/// A determinant errs by at most 5u of its terms, and its entries, where they are 2Q1 - Q2 or (Q1 +
/// Q2)/2, by 1u each: 8u. A coefficient combines four of them with at most 5 roundings, and
/// Horner's rule adds 6u: 20u of the terms, less for the quadratic.
struct PolynomialErrors {
    double a[3]; ///< of a, a', a''
    double b[3]; ///< of b, b', b''
};

PolynomialErrors polynomial_errors(Sample<double, 3> const &p, double x)
{
    Form3 const q1 = magnitudes(p.q1), q2 = magnitudes(p.q2);
    Form3 const q3 = pw85::detail::blend(2.0, q1, 1.0, q2),
                q4 = pw85::detail::blend(0.5, q1, 0.5, q2);
    double const d[4] = {absolute_determinant(q1), absolute_determinant(q2),
                         absolute_determinant(q3), absolute_determinant(q4)};
    double const f[3] = {absolute_adjugate_form(p.r12, q1), absolute_adjugate_form(p.r12, q2),
                         absolute_adjugate_form(p.r12, q3)};
    double const b[4] = {d[0], 2.0 * d[0] + d[1] / 2.0 + d[2] / 6.0 + d[3] * 8.0 / 3.0,
                         d[0] + d[1] / 2.0 + d[2] / 2.0,
                         2.0 * d[0] + d[1] + d[2] / 3.0 + d[3] * 8.0 / 3.0};
    double const a[3] = {f[0], f[1] / 2.0 + f[2] / 2.0, f[0] + f[1] / 2.0 + f[2] / 2.0};
    double const e = 20.0 * u;
    return {{e * (a[0] + x * (a[1] + x * a[2])), e * (a[1] + x * 2.0 * a[2]), e * 2.0 * a[2]},
            {e * (b[0] + x * (b[1] + x * (b[2] + x * b[3]))),
             e * (b[1] + x * (2.0 * b[2] + x * 3.0 * b[3])), e * (2.0 * b[2] + x * 6.0 * b[3])}};
}

/// Bounds on the errors of f, f', f'' of the rational form, to first order in the errors of the
/// polynomials; `valid` where these are small.
struct RationalErrors {
    double f, first, second;
    bool valid;
};

// f = wa/b, f' = (w'a + wa' - fb')/b, f'' = (2(w'a' - a) + wa'' - 2f'b' - fb'')/b with w = x(1-x):
// every term may err by its factors' errors and 8 roundings.
RationalErrors rational_errors(Sample<double, 3> const &p, double x)
{
    auto const e = polynomial_errors(p, x);
    auto const wide = convert<Wide>(p);
    auto const exact = pw85::detail::legacy::polynomials(wide.r12, wide.q1, wide.q2);
    auto const value = pw85::detail::legacy::evaluate_rational(exact, Wide(x));
    auto const in_double = [](Wide const &y) { return std::fabs(static_cast<double>(y)); };
    Wide const X = x;
    double const w = x * (1.0 - x), w1 = std::fabs(1.0 - 2.0 * x);
    double const a = in_double(exact.a[0] + X * (exact.a[1] + X * exact.a[2]));
    double const a1 = in_double(exact.a[1] + 2 * X * exact.a[2]), a2 = in_double(2 * exact.a[2]);
    double const b = in_double(exact.b[0] + X * (exact.b[1] + X * (exact.b[2] + X * exact.b[3])));
    double const b1 = in_double(exact.b[1] + X * (2 * exact.b[2] + 3 * X * exact.b[3]));
    double const b2 = in_double(2 * exact.b[2] + 6 * X * exact.b[3]);
    double const f = in_double(value.f), f1 = in_double(value.first), f2 = in_double(value.second);
    double const r = 8.0 * u;
    double const error = (w * e.a[0] + f * e.b[0]) / b + r * f;
    double const error1 = (w1 * e.a[0] + w * e.a[1] + f * e.b[1] + b1 * error + f1 * e.b[0] +
                           r * (w1 * a + w * a1 + f * b1)) /
                          b;
    double const error2 =
        (2.0 * (w1 * e.a[1] + e.a[0]) + w * e.a[2] + 2.0 * (f1 * e.b[1] + b1 * error1) +
         f * e.b[2] + b2 * error + f2 * e.b[0] +
         r * (2.0 * (w1 * a1 + a) + w * a2 + 2.0 * f1 * b1 + f * b2)) /
        b;
    return {error, error1, error2, e.b[0] < 0.01 * b};
}

/// Room for what is beyond first order: errors of the denominator are below 1 %.
constexpr double second_order = 1.05;

// Exact in integers, so exact in doubles.
PW85_TEST("/legacy/adjugate/by_hand")
{
    double const a[6] = {2.0, 1.0, -1.0, 3.0, 0.5, 4.0}, x[3] = {1.0, -2.0, 3.0};
    // det by the first row; adj(A) = (11.75, -4.5, 3.5, 7, -2, 5).
    g_assert_cmpfloat(pw85_legacy__det_sym(a), ==, 2.0 * 11.75 + 1.0 * -4.5 - 1.0 * 3.5);
    g_assert_cmpfloat(pw85_legacy__xT_adjA_x(x, a), ==,
                      11.75 + 4.0 * 7.0 + 9.0 * 5.0 + 2.0 * (-2.0 * -4.5 + 3.0 * 3.5 - 6.0 * -2.0));
}

// With diagonal forms the polynomials are products of their entries.
PW85_TEST("/legacy/polynomials/by_hand")
{
    double const q1[6] = {1.0, 0.0, 0.0, 2.0, 0.0, 4.0}, q2[6] = {4.0, 0.0, 0.0, 5.0, 0.0, 1.0};
    double q3[6], q4[6], b[4], a[3];
    for (int k = 0; k < 6; ++k) {
        q3[k] = 2.0 * q1[k] - q2[k];
        q4[k] = 0.5 * (q1[k] + q2[k]);
    }
    pw85_legacy__detQ_as_poly(q1, q2, q3, q4, b);
    // (1 + 3λ)(2 + 3λ)(4 - 3λ) = 8 + 30λ + 9λ² - 27λ³
    double const expected_b[4] = {8.0, 30.0, 9.0, -27.0};
    for (int k = 0; k < 4; ++k) g_assert_cmpfloat(std::fabs(b[k] - expected_b[k]), <=, 1e-13);
    double const r[3] = {1.0, 0.0, 2.0};
    pw85_legacy__rT_adjQ_r_as_poly(r, q1, q2, q3, a);
    // (2 + 3λ)(4 - 3λ) + 4(1 + 3λ)(2 + 3λ) = 16 + 42λ + 27λ²
    double const expected_a[3] = {16.0, 42.0, 27.0};
    for (int k = 0; k < 3; ++k) g_assert_cmpfloat(std::fabs(a[k] - expected_a[k]), <=, 1e-13);
}

PW85_TEST("/legacy/polynomials/random")
{
    Failures failures;
    Random random(70);
    for (int n = 0; n < draws(5000); ++n) {
        auto const p = random_pair<3>(random, {.aspect = 100.0});
        double const x = random.uniform(0.0, 1.0);
        auto const q3 = pw85::detail::blend(2.0, p.q1, -1.0, p.q2),
                   q4 = pw85::detail::blend(0.5, p.q1, 0.5, p.q2);
        double a[3], b[4];
        pw85_legacy__rT_adjQ_r_as_poly(p.r12.coordinates, p.q1.entries, p.q2.entries, q3.entries,
                                       a);
        pw85_legacy__detQ_as_poly(p.q1.entries, p.q2.entries, q3.entries, q4.entries, b);
        auto const w = convert<Wide>(p);
        auto const blend = pw85::detail::blend(Wide(1 - Wide(x)), w.q1, Wide(x), w.q2);
        double const det = static_cast<double>(pw85::detail::legacy::determinant(blend));
        double const form = static_cast<double>(pw85::detail::legacy::adjugate_form(w.r12, blend));
        auto const e = polynomial_errors(p, x);
        double const at = b[0] + x * (b[1] + x * (b[2] + x * b[3])),
                     az = a[0] + x * (a[1] + x * a[2]);
        auto const describe = [&] { return hex_text(p) + ", lambda = " + hex_text(&x, 1); };
        failures.check(std::fabs(at - det) <= e.b[0], "det", at, det, describe);
        failures.check(std::fabs(az - form) <= e.a[0], "r adj r", az, form, describe);
    }
}

/// for_all_of_f() between the ends.
template <class Visit> void for_all_between_ends(Visit const &visit) { for_all_of_f(visit, 1); }

PW85_TEST("/legacy/f1/reference")
{
    Failures failures;
    for_all_between_ends([&](Sample<double, 3> const &p, double x, double expected) {
        double out[3];
        double const f = pw85_legacy_f1(x, p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        auto const describe = [&] { return hex_text(p) + ", lambda = " + hex_text(&x, 1); };
        failures.check(std::fabs(f - expected) <= 1e-10 * expected, "f1", f, expected, describe);
        failures.check(out[0] == f, "out[0] of f1", out[0], f, describe);
    });
}

PW85_TEST("/legacy/f2/reference")
{
    Failures failures;
    for_all_between_ends([&](Sample<double, 3> const &p, double x, double expected) {
        double out;
        double const f = pw85_legacy_f2(x, p.r12.coordinates, p.q1.entries, p.q2.entries, &out);
        auto const describe = [&] { return hex_text(p) + ", lambda = " + hex_text(&x, 1); };
        failures.check(std::fabs(f - expected) <= 1e-10 * expected, "f2", f, expected, describe);
        failures.check(out == f, "out of f2", out, f, describe);
    });
}

void check_derivatives(Failures &failures, Sample<double, 3> const &p, double x)
{
    auto const w = convert<Wide>(p);
    auto const exact = pw85::detail::evaluate_derivatives(Wide(x), w.r12, w.q1, w.q2);
    double const expected[3] = {static_cast<double>(exact.f), static_cast<double>(exact.first),
                                static_cast<double>(exact.second)};
    auto const e = rational_errors(p, x);
    if (!e.valid) return;
    double const bounds[3] = {e.f, e.first, e.second};
    double out[3];
    pw85_legacy_f2_derivatives(x, p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    for (int k = 0; k < 3; ++k)
        failures.check(std::fabs(out[k] - expected[k]) <= second_order * bounds[k],
                       "derivative of f2", out[k], expected[k], [&] {
                           return "order " + std::to_string(k) + ", " + hex_text(p) +
                                  ", lambda = " + hex_text(&x, 1);
                       });
}

PW85_TEST("/legacy/f2/derivatives")
{
    Failures failures;
    Random random(71);
    for (int n = 0; n < draws(3000); ++n) {
        auto const p = random_pair<3>(random, {.aspect = random.log_uniform(1.0, 1e4)});
        check_derivatives(failures, p, random.uniform(0.0, 1.0));
    }
    g_assert_cmpint(failures.checked(), >, draws(3000));
}

PW85_TEST("/legacy/f1/derivatives")
{
    Failures failures;
    Random random(72);
    for (int n = 0; n < draws(3000); ++n) {
        auto const p = random_pair<3>(random, {.aspect = 1e3});
        double const x = random.uniform(0.0, 1.0);
        double f1[3], residual[3];
        pw85_legacy_f1(x, p.r12.coordinates, p.q1.entries, p.q2.entries, f1);
        pw85__residual(x, p.r12.coordinates, p.q1.entries, p.q2.entries, residual);
        auto const describe = [&] { return hex_text(p); };
        failures.check(f1[0] == residual[0], "f", f1[0], residual[0], describe);
        failures.check(f1[1] == -residual[1], "f'", f1[1], -residual[1], describe);
        failures.check(f1[2] == -residual[2], "f''", f1[2], -residual[2], describe);
    }
}

// Newton's method: right when it claims to be, and NaN when it does not. λ may be off by the square
// root of u times the distance to the nearer end, which costs u/2 of f, since f is concave and zero
// at the ends.
PW85_TEST("/legacy/contact_function1")
{
    Failures failures;
    int converged = 0, failed = 0;
    for (auto const &p : contact_problems()) {
        double out[2];
        int const status = pw85_legacy_contact_function1(p.pair.r12.coordinates, p.pair.q1.entries,
                                                         p.pair.q2.entries, out);
        auto const describe = [&] { return *p.category + ": " + hex_text(p.pair); };
        if (status == PW85_SUCCESS) {
            ++converged;
            double const units = std::fabs(out[0] - p.mu2) / p.mu2 / (u * p.cond);
            failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
        } else {
            ++failed;
            failures.check(status == PW85_ECONVERGENCE, "status", status, PW85_ECONVERGENCE,
                           describe);
            failures.check(std::isnan(out[0]) && std::isnan(out[1]), "outputs", out[0], 0.0,
                           describe);
        }
    }
    g_test_message("%d converged, %d did not", converged, failed);
    g_assert_cmpint(converged, >, 1000);
    g_assert_cmpint(failed, >, 1000);
}

// Bisection: f is concave, so that f(λ) falls short of μ² by at most |f'(λ)| |λ* - λ|; f' vanishes
// there but for its error. To this comes the error of f itself.
PW85_TEST("/legacy/contact_function2")
{
    Failures failures;
    long judged = 0;
    for (auto const &p : contact_problems()) {
        double out[2];
        int const status = pw85_legacy_contact_function2(p.pair.r12.coordinates, p.pair.q1.entries,
                                                         p.pair.q2.entries, out);
        auto const describe = [&] { return *p.category + ": " + hex_text(p.pair); };
        failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe);
        failures.check(out[1] >= 0.0 && out[1] <= 1.0, "lambda", out[1], 1.0, describe);
        if (!(out[1] > 0.0 && out[1] < 1.0)) continue;
        auto const e = rational_errors(p.pair, out[1]);
        if (!e.valid) continue;
        ++judged;
        // λ itself is known to one part in 2^-52 of the larger of λ and 1-λ.
        auto const w = convert<Wide>(p.pair);
        double const second = std::fabs(static_cast<double>(
            pw85::detail::evaluate_derivatives(Wide(out[1]), w.r12, w.q1, w.q2).second));
        double const slope = second_order * e.first + 2.0 * u * second;
        double const bound =
            second_order * e.f + slope * std::fabs(out[1] - p.lambda) + 4.0 * u * u * second;
        failures.check(std::fabs(out[0] - p.mu2) <= bound, "mu^2", out[0], p.mu2, describe);
    }
    g_test_message("%ld pairs judged by the error bound", judged);
    g_assert_cmpint(static_cast<int>(judged), >, 3000);
}

PW85_TEST("/legacy/invalid")
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const r12[3] = {1.0, 0.0, 0.0}, q[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0},
                 bad[6] = {1.0, 2.0, 0.0, 1.0, 0.0, 1.0};
    double const not_a_number[3] = {nan, 0.0, 0.0}, zero[3] = {0.0, 0.0, 0.0};
    double out[3] = {};
    for (auto const f : {pw85_legacy_f1, pw85_legacy_f2}) {
        g_assert_true(std::isnan(f(0.5, nullptr, q, q, out)));
        g_assert_true(std::isnan(f(0.5, r12, nullptr, q, nullptr)));
        g_assert_true(std::isnan(f(0.5, not_a_number, q, q, out)) && std::isnan(out[0]));
        g_assert_true(std::isnan(f(0.5, r12, q, bad, out)) && std::isnan(out[0]));
        g_assert_true(std::isnan(f(1.5, r12, q, q, out)));
        g_assert_true(std::isnan(f(nan, r12, q, q, out)));
        g_assert_cmpfloat(f(0.5, r12, q, q, nullptr), ==, 0.25);
    }
    auto const f1_derivatives = [](double x, double const *r, double const *a, double const *b,
                                   double *to) { pw85_legacy_f1(x, r, a, b, to); };
    using GetDerivatives =
        void (*)(double, double const *, double const *, double const *, double *);
    for (auto const f : {static_cast<GetDerivatives>(f1_derivatives), pw85_legacy_f2_derivatives}) {
        for (auto const r : {static_cast<double const *>(nullptr), not_a_number}) {
            for (double &x : out) x = 0.0;
            f(0.5, r, q, q, out);
            for (double const x : out) g_assert_true(std::isnan(x));
        }
        f(0.5, r12, q, q, nullptr);
    }
    for (auto const contact : {pw85_legacy_contact_function1, pw85_legacy_contact_function2}) {
        g_assert_cmpint(contact(nullptr, q, q, out), ==, PW85_EINVAL);
        g_assert_true(std::isnan(out[0]) && std::isnan(out[1]));
        g_assert_cmpint(contact(r12, q, q, nullptr), ==, PW85_EINVAL);
        g_assert_cmpint(contact(not_a_number, q, q, out), ==, PW85_EINVAL);
        g_assert_cmpint(contact(r12, bad, q, out), ==, PW85_ENOTPD);
        g_assert_true(std::isnan(out[0]) && std::isnan(out[1]));
        g_assert_cmpint(contact(zero, q, q, out), ==, PW85_SUCCESS);
        g_assert_cmpfloat(out[0], ==, 0.0);
        g_assert_cmpfloat(out[1], ==, 0.5);
    }
    g_assert_true(std::isnan(pw85_legacy__det_sym(nullptr)));
    g_assert_true(std::isnan(pw85_legacy__xT_adjA_x(nullptr, q)));
    double b[4] = {}, a[3] = {};
    pw85_legacy__detQ_as_poly(q, nullptr, q, q, b);
    pw85_legacy__rT_adjQ_r_as_poly(nullptr, q, q, q, a);
    for (double const x : b) g_assert_true(std::isnan(x));
    for (double const x : a) g_assert_true(std::isnan(x));
}

} // namespace
