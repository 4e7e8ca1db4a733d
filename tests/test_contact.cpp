// SPDX-License-Identifier: BSD-3-Clause
// Tests of the contact function by both solvers: those of the manual's chapter on testing, and the
// contact problems.
#include <cmath>
#include <map>

#include <glib.h>

#include "failures.hpp"
#include "reference_data.hpp"
#include "solvers.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

/// μ1² = (1-λ)² sᵀQ1s, μ2² = λ² sᵀQ2s with s = Q(λ)⁻¹ r12: the squares by which either ellipsoid
/// must be scaled to reach x0(λ).
struct ScaleFactors {
    double mu1_2, mu2_2;
};

ScaleFactors scale_factors(Sample<double, 3> const &p, double lambda)
{
    auto const l = pw85::cholesky(pw85::detail::blend(1.0 - lambda, p.q1, lambda, p.q2));
    auto const s = pw85::cholesky_solve(l, p.r12);
    return {(1.0 - lambda) * (1.0 - lambda) * pw85::detail::quadratic_form(p.q1, s),
            lambda * lambda * pw85::detail::quadratic_form(p.q2, s)};
}

void check_as_in_manual(Failures &failures, Solver const &solver, Sample<double, 3> const &p)
{
    double out[2], residual[3];
    auto const describe = [&] { return hex_text(p); };
    int const status = solver.call(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) return;
    auto const [mu1_2, mu2_2] = scale_factors(p, out[1]);
    failures.check(std::fabs(mu1_2 - out[0]) <= 1e-10 * out[0], "mu1^2", mu1_2, out[0], describe);
    failures.check(std::fabs(mu2_2 - out[0]) <= 1e-10 * out[0], "mu2^2", mu2_2, out[0], describe);
    pw85__residual(out[1], p.r12.coordinates, p.q1.entries, p.q2.entries, residual);
    failures.check(std::fabs(residual[1]) <= PW85_LAMBDA_ATOL * std::fabs(residual[2]), "f'",
                   residual[1], PW85_LAMBDA_ATOL * residual[2], describe);
}

void test_as_in_manual(void const *data)
{
    auto const &grid = spheroid_grid();
    Failures failures;
    for (auto const &q1 : grid.spheroids)
        for (auto const &q2 : grid.spheroids)
            for (auto const &direction : grid.directions)
                for (double const distance : {0.15, 1.1, 11.0})
                    check_as_in_manual(failures, *static_cast<Solver const *>(data),
                                       {distance * direction, q1, q2});
    g_assert_cmpint(failures.checked(), ==, 4 * 108 * 108 * 12 * 3);
}

void test_problems(void const *data)
{
    auto const &solver = *static_cast<Solver const *>(data);
    Failures failures;
    std::map<std::string, double> worst;
    for (auto const &p : contact_problems()) {
        double out[2];
        auto const describe = [&] { return *p.category + ": " + hex_text(p.pair); };
        int const status =
            solver.call(p.pair.r12.coordinates, p.pair.q1.entries, p.pair.q2.entries, out);
        if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) continue;
        double const units = std::fabs(out[0] - p.mu2) / p.mu2 / (u * p.cond);
        failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
        worst[*p.category] = std::fmax(worst[*p.category], units);
    }
    for (auto const &[category, units] : worst)
        g_test_message("%s, %s: %.2f u cond", solver.name, category.c_str(), units);
}

// λ is as good as its value of f: f(λ) falls short of μ² by no more than the bound on the error of
// μ². The rounding of λ itself costs ½ |f''| (uλ)², for λ rounded to the nearest double; where λ is
// 1e-10 or less from 1, that is not small, and λ is not a good variable.
void test_lambda_of_problems(void const *data)
{
    auto const &solver = *static_cast<Solver const *>(data);
    Failures failures;
    for (auto const &p : contact_problems()) {
        if (1.0 - p.lambda < 1e-10) continue;
        double out[2];
        solver.call(p.pair.r12.coordinates, p.pair.q1.entries, p.pair.q2.entries, out);
        auto const w = convert<Wide>(p.pair);
        auto const f = pw85::detail::evaluate_derivatives(Wide(out[1]), w.r12, w.q1, w.q2);
        double const shortfall = static_cast<double>(Wide((p.mu2 - f.f) / p.mu2));
        double const rounding = static_cast<double>(Wide(abs(f.second) / p.mu2)) * 2.0 * u * u;
        double const bound = 4.0 * u * p.cond + rounding;
        failures.check(shortfall <= bound, "shortfall of f(lambda)", shortfall, bound, [&] {
            return *p.category + ": lambda = " + hex_text(&out[1], 1) + ", " + hex_text(p.pair);
        });
    }
}

void test_number_of_evaluations()
{
    Failures failures;
    std::map<int, int> histogram;
    for (auto const &p : contact_problems()) {
        auto const scaled =
            pw85::detail::scale(pw85::detail::pair_of(p.pair.r12, p.pair.q1, p.pair.q2));
        int const evaluations = pw85::detail::maximize(scaled.pair).evaluations;
        ++histogram[evaluations];
        failures.check(evaluations <= pw85::detail::max_evaluations, "evaluations", evaluations,
                       pw85::detail::max_evaluations,
                       [&] { return *p.category + ": " + hex_text(p.pair); });
    }
    for (auto const &[evaluations, count] : histogram)
        g_test_message("%2d evaluations: %d pairs", evaluations, count);
}

// Two spheres of very different sizes: an absolute tolerance on λ is worth nothing here.
void test_spheres_of_different_sizes(void const *data)
{
    auto const &solver = *static_cast<Solver const *>(data);
    for (double const ratio : {1.0, 1e3, 1e6, 1e9, 1e12}) {
        double const a1 = 1.0 / ratio, a2 = ratio, r12[3] = {0.0, 3.0 * ratio, 0.0};
        double const q1[6] = {a1 * a1, 0.0, 0.0, a1 * a1, 0.0, a1 * a1},
                     q2[6] = {a2 * a2, 0.0, 0.0, a2 * a2, 0.0, a2 * a2};
        double const expected = (r12[1] / (a1 + a2)) * (r12[1] / (a1 + a2));
        double out[2];
        g_assert_cmpint(solver.call(r12, q1, q2, out), ==, PW85_SUCCESS);
        g_assert_cmpfloat(std::fabs(out[0] - expected), <=, 16 * u * expected);
        g_assert_cmpfloat(std::fabs(out[1] - a1 / (a1 + a2)), <=, 16 * u * out[1]);
    }
}

void test_concentric(void const *data)
{
    double const r12[3] = {0.0, -0.0, 0.0}, q1[6] = {4.0, 1.0, 0.0, 3.0, 0.0, 2.0},
                 q2[6] = {1.0, 0.0, 0.0, 2.0, 0.0, 9.0};
    double out[2];
    g_assert_cmpint(static_cast<Solver const *>(data)->call(r12, q1, q2, out), ==, PW85_SUCCESS);
    g_assert_cmpfloat(out[0], ==, 0.0);
    g_assert_cmpfloat(out[1], ==, 0.5);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    add_for_each_solver("", "as_in_manual", test_as_in_manual);
    add_for_each_solver("", "problems", test_problems);
    add_for_each_solver("", "lambda", test_lambda_of_problems);
    add_for_each_solver("", "spheres_of_different_sizes", test_spheres_of_different_sizes);
    add_for_each_solver("", "concentric", test_concentric);
    g_test_add_func("/contact/evaluations", test_number_of_evaluations);
    return g_test_run();
}
