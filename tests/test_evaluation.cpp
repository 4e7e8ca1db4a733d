// SPDX-License-Identifier: BSD-3-Clause
// Tests of f, its derivatives, and the linear algebra on which they stand, by the C API.
#include <cmath>

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

struct Parameters {
    double values[PW85_DIM + 2 * PW85_SYM];
};

Parameters parameters(Sample<double, 3> const &s)
{
    Parameters p{};
    for (int i = 0; i < 3; ++i) p.values[i] = s.r12[i];
    for (int k = 0; k < 6; ++k) {
        p.values[3 + k] = s.q1[k];
        p.values[9 + k] = s.q2[k];
    }
    return p;
}

// The tolerance of the manual, chapter 6, and the sharp one: f is a backward stable function of its
// data, so that its error is at most 4 u cond, cond being that of f at λ.
PW85_TEST("/evaluation/f/reference")
{
    Failures failures;
    double worst = 0.0;
    for_all_of_f([&](Sample<double, 3> const &s, double lambda, double expected) {
        double const f = -pw85_f_neg(lambda, parameters(s).values);
        double const error = std::fabs(f - expected);
        auto const describe = [&] {
            return "lambda = " + hex_text(&lambda, 1) + ", " + hex_text(s);
        };
        if (expected == 0.0) return (void)failures.check(f == 0.0, "f at an end", f, 0.0, describe);
        failures.check(error <= 1e-10 * expected, "f", f, expected, describe);
        double const units = error / (u * expected * condition_number(s, lambda));
        failures.check(units <= 4.0, "error of f in u cond", units, 4.0, describe);
        worst = std::fmax(worst, units);
    });
    g_test_message("largest error of f over /F: %.2f u cond", worst);
}

// One evaluation lies behind all three.
PW85_TEST("/evaluation/residual/f")
{
    Failures failures;
    Random random(1);
    for (int i = 0; i < draws(20000); ++i) {
        auto const s = random_pair<3>(random, {.aspect = 1e4});
        double const lambda = random.uniform(0.0, 1.0);
        double out[3];
        pw85__residual(lambda, s.r12.coordinates, s.q1.entries, s.q2.entries, out);
        double const f = -pw85_f_neg(lambda, parameters(s).values);
        failures.check(out[0] == f, "f of residual", out[0], f, [&] { return hex_text(s); });
    }
}

// f' = μ1² - μ2² errs by at most a small multiple of u cond (μ1² + μ2²) and f'' by one of the
// square of the condition number of the blend times its terms. At aspect 10 the latter is below
// 1e4, hence the bounds, with room for constants.
PW85_TEST("/evaluation/residual/wide_type")
{
    Failures failures;
    Random random(2);
    for (int i = 0; i < draws(2000); ++i) {
        auto const s = random_pair<3>(random, {.aspect = 10.0});
        double const lambda = random.uniform(0.01, 0.99);
        auto const w = convert<Wide>(s);
        auto const exact = pw85::detail::evaluate_derivatives(Wide(lambda), w.r12, w.q1, w.q2);
        double const f = static_cast<double>(exact.f), second = static_cast<double>(exact.second);
        double out[3];
        pw85__residual(lambda, s.r12.coordinates, s.q1.entries, s.q2.entries, out);
        auto const describe = [&] {
            return "lambda = " + hex_text(&lambda, 1) + ", " + hex_text(s);
        };
        double const g = static_cast<double>(Wide(-exact.first)), weight = lambda * (1.0 - lambda);
        failures.check(std::fabs(out[1] - g) <= 1e4 * u * f / weight, "g", out[1], g, describe);
        failures.check(std::fabs(out[2] + second) <= 1e4 * u * (std::fabs(second) + f / weight),
                       "g'", out[2], -second, describe);
    }
}

// The derivatives are those of f: central differences in the wide type, with an error of the square
// of the step.
PW85_TEST("/evaluation/derivatives/differences")
{
    Failures failures;
    Random random(3);
    Wide const h("1e-12");
    for (int i = 0; i < 200; ++i) {
        auto const s = random_pair<3>(random, {.aspect = 100.0});
        auto const w = convert<Wide>(s);
        Wide const lambda = random.uniform(0.05, 0.95);
        auto const f = [&](Wide const &x) {
            return pw85::detail::evaluate_f(x, w.r12, w.q1, w.q2);
        };
        auto const exact = pw85::detail::evaluate_derivatives(lambda, w.r12, w.q1, w.q2);
        Wide const before = f(lambda - h), at = f(lambda), after = f(lambda + h);
        Wide const first = (after - before) / (2 * h), second = (after - 2 * at + before) / (h * h);
        double const scale = std::fabs(static_cast<double>(exact.second));
        auto const describe = [&] { return hex_text(s); };
        auto const compare = [&](Wide const &actual, Wide const &difference, char const *what) {
            double const error = std::fabs(static_cast<double>(Wide(actual - difference)));
            failures.check(error <= 1e-16 * scale, what, error, 1e-16 * scale, describe);
        };
        compare(exact.first, first, "f'");
        compare(exact.second, second, "f''");
    }
}

// |A - L Lᵀ|_ij <= 4u |L||Lᵀ|_ij: at most three products and a subtraction each, a division or a
// root.
PW85_TEST("/evaluation/cholesky/decomposition")
{
    Failures failures;
    Random random(4);
    for (int n = 0; n < draws(20000); ++n) {
        auto const a = random.form(random.log_uniform(1e-3, 1e3), random.log_uniform(1.0, 1e6));
        pw85::SymmetricMatrix<double, 3> l{};
        pw85__cholesky_decomp(a.entries, l.entries);
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) {
                Wide product = 0, magnitude = 0;
                for (int k = 0; k <= i; ++k) {
                    product += Wide(l(k, i)) * l(k, j);
                    magnitude += abs(Wide(l(k, i)) * l(k, j));
                }
                double const error = static_cast<double>(Wide(abs(product - a(i, j)) / magnitude));
                failures.check(error <= 6 * u, "L Lt - A", error, 6 * u,
                               [&] { return hex_text(a.entries, 6); });
            }
    }
}

PW85_TEST("/evaluation/cholesky/by_hand")
{
    double const a[6] = {4.0, 2.0, 6.0, 17.0, 23.0, 70.0},
                 expected[6] = {2.0, 1.0, 3.0, 4.0, 5.0, 6.0};
    double l[6], x[3];
    pw85__cholesky_decomp(a, l);
    for (int k = 0; k < 6; ++k) g_assert_cmpfloat(l[k], ==, expected[k]);
    double const b[3] = {4.0 + 4.0 + 18.0, 2.0 + 34.0 + 69.0, 6.0 + 46.0 + 210.0};
    pw85__cholesky_solve(l, b, x);
    for (int i = 0; i < 3; ++i) g_assert_cmpfloat(x[i], ==, i + 1.0);
    double in_place[3] = {b[0], b[1], b[2]};
    pw85__cholesky_solve(l, in_place, in_place);
    for (int i = 0; i < 3; ++i) g_assert_cmpfloat(in_place[i], ==, i + 1.0);
}

// |b - L Lᵀx|_i <= 8u (|L||Lᵀ||x|)_i: two substitutions of at most three terms (Higham, Accuracy
// and Stability of Numerical Algorithms, theorem 8.5: 3u each).
PW85_TEST("/evaluation/cholesky/solution")
{
    Failures failures;
    Random random(5);
    for (int n = 0; n < draws(20000); ++n) {
        auto const a = random.form(1.0, random.log_uniform(1.0, 1e6));
        auto const b = random.direction<3>();
        pw85::SymmetricMatrix<double, 3> l{};
        double x[3];
        pw85__cholesky_decomp(a.entries, l.entries);
        pw85__cholesky_solve(l.entries, b.coordinates, x);
        for (int i = 0; i < 3; ++i) {
            Wide residual = b[i], magnitude = 0;
            for (int j = 0; j < 3; ++j)
                for (int k = 0; k <= (i < j ? i : j); ++k) {
                    residual -= Wide(l(k, i)) * l(k, j) * x[j];
                    magnitude += abs(Wide(l(k, i)) * l(k, j) * x[j]);
                }
            double const error = static_cast<double>(Wide(abs(residual) / magnitude));
            failures.check(error <= 8 * u, "b - A x", error, 8 * u,
                           [&] { return hex_text(a.entries, 6); });
        }
    }
}

} // namespace
