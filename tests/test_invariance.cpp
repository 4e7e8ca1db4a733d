// SPDX-License-Identifier: BSD-3-Clause
// Tests of the invariances of the contact function. With f(λ) = λ(1-λ) r12ᵀ [(1-λ)Q1 + λQ2]⁻¹ r12:
//
// 1. exchange: (-r12, Q2, Q1) has the same μ², and 1-λ;
// 2. joint linear maps: (L r12, L Q1 Lᵀ, L Q2 Lᵀ) has the same μ² and λ; rotations are the special
//    case;
// 3. scaling: μ²(k r12) = k² μ²(r12), and by powers of two each bit of it;
// 4. spheres: μ² = |r12|²/(a1+a2)², λ = a1/(a1+a2).
//
// Maps are applied in a wider type and the result is rounded once, which changes μ² by at most u
// cond. The error of each of the two evaluations is at most 4 u cond, with its own cond.
#include <cmath>

#include <glib.h>

#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "solvers.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

struct Result {
    double mu2, lambda;
};

Result solve(void const *solver, Sample<double, 3> const &p)
{
    double out[2];
    static_cast<Solver const *>(solver)->call(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    return {out[0], out[1]};
}

Sample<double, 3> random_case(Random &random)
{
    return random_pair<3>(random, {.aspect = 1e4, .size_ratio = 100.0});
}

void check_same_mu2(Failures &failures, void const *solver, Sample<double, 3> const &p,
                    Sample<double, 3> const &image)
{
    Result const a = solve(solver, p), b = solve(solver, image);
    double const cond = condition_number(p, a.lambda) + condition_number(image, b.lambda);
    double const bound = 5 * u * cond * a.mu2;
    failures.check(std::fabs(a.mu2 - b.mu2) <= bound, "mu^2 of the image", b.mu2, a.mu2,
                   [&] { return hex_text(p) + "; image: " + hex_text(image); });
}

void test_exchange(void const *solver)
{
    Failures failures;
    Random random(20);
    for (int i = 0; i < draws(20000); ++i) {
        auto const p = random_case(random);
        Sample<double, 3> const image{-p.r12, p.q2, p.q1};
        check_same_mu2(failures, solver, p, image);
    }
}

using Map = Wide[3][3];

Sample<double, 3> apply(Map const &l, Sample<double, 3> const &p)
{
    Sample<double, 3> image{};
    for (int i = 0; i < 3; ++i) {
        Wide r = 0;
        for (int k = 0; k < 3; ++k) r += l[i][k] * p.r12[k];
        image.r12[i] = static_cast<double>(r);
        for (int j = i; j < 3; ++j) {
            Wide q1 = 0, q2 = 0;
            for (int k = 0; k < 3; ++k)
                for (int m = 0; m < 3; ++m) {
                    q1 += l[i][k] * p.q1(k, m) * l[j][m];
                    q2 += l[i][k] * p.q2(k, m) * l[j][m];
                }
            image.q1(i, j) = static_cast<double>(q1);
            image.q2(i, j) = static_cast<double>(q2);
        }
    }
    return image;
}

void test_rotation(void const *solver)
{
    Failures failures;
    Random random(21);
    for (int n = 0; n < draws(5000); ++n) {
        auto const p = random_case(random);
        auto const quaternion = convert<Wide>(random.direction<4>());
        auto const rotation =
            pw85::detail::rotation_matrix(quaternion, pw85::dot(quaternion, quaternion));
        Map l;
        for (int i = 0; i < 9; ++i) l[i / 3][i % 3] = rotation.entries[i];
        check_same_mu2(failures, solver, p, apply(l, p));
    }
}

void test_linear_map(void const *solver)
{
    Failures failures;
    Random random(22);
    for (int n = 0; n < draws(5000); ++n) {
        auto const p = random_pair<3>(random, {.aspect = 100.0});
        Map l;
        for (auto &row : l)
            for (auto &entry : row) entry = random.normal();
        auto const image = apply(l, p);
        // A map that is nearly singular can make a form indefinite when it is rounded.
        if (!pw85::detail::is_clearly_definite(image.q1) ||
            !pw85::detail::is_clearly_definite(image.q2))
            continue;
        check_same_mu2(failures, solver, p, image);
    }
}

Sample<double, 3> scaled(Sample<double, 3> const &p, int length, int form)
{
    return {pw85::detail::times_power_of_two(p.r12, length),
            pw85::detail::times_power_of_two(p.q1, 2 * form),
            pw85::detail::times_power_of_two(p.q2, 2 * form)};
}

void test_powers_of_two(void const *solver)
{
    Failures failures;
    Random random(23);
    for (int n = 0; n < draws(20000); ++n) {
        auto const p = random_case(random);
        int const length = static_cast<int>(random.uniform(-400.0, 400.0));
        int const form = length + static_cast<int>(random.uniform(-20.0, 20.0));
        auto const image = scaled(p, length, form);
        Result const a = solve(solver, p), b = solve(solver, image);
        double const expected = std::ldexp(a.mu2, 2 * (length - form));
        auto const describe = [&] { return hex_text(p) + "; image: " + hex_text(image); };
        failures.check(b.mu2 == expected, "mu^2 after scaling", b.mu2, expected, describe);
        failures.check(b.lambda == a.lambda, "lambda after scaling", b.lambda, a.lambda, describe);
    }
}

void test_scaling_of_separation(void const *solver)
{
    Failures failures;
    Random random(24);
    for (int n = 0; n < draws(20000); ++n) {
        auto const p = random_case(random);
        double const k = random.log_uniform(1e-3, 1e3);
        auto image = p;
        for (int i = 0; i < 3; ++i) image.r12[i] = k * p.r12[i];
        Result const a = solve(solver, p), b = solve(solver, image);
        // 2u for the square of k and its product, 2u for the rounding of r12 (in cond).
        double const bound =
            (5 * u * (condition_number(p, a.lambda) + condition_number(image, b.lambda)) + 2 * u) *
            b.mu2;
        failures.check(std::fabs(b.mu2 - k * k * a.mu2) <= bound, "mu^2(k r)", b.mu2, k * k * a.mu2,
                       [&] { return hex_text(p) + ", k = " + hex_text(&k, 1); });
    }
}

// cond = 3 for spheres, to which the rounding of the squares of the radii and of the expected value
// adds a few u.
void test_spheres(void const *solver)
{
    Failures failures;
    Random random(25);
    for (int n = 0; n < draws(20000); ++n) {
        double const a1 = random.log_uniform(1e-6, 1e6), a2 = a1 * random.log_uniform(1e-6, 1e6);
        auto const r12 = (a1 + a2) * random.log_uniform(0.01, 100.0) * random.direction<3>();
        Sample<double, 3> const p{r12,
                                  {a1 * a1, 0.0, 0.0, a1 * a1, 0.0, a1 * a1},
                                  {a2 * a2, 0.0, 0.0, a2 * a2, 0.0, a2 * a2}};
        Result const c = solve(solver, p);
        double const mu2 = pw85::dot(r12, r12) / ((a1 + a2) * (a1 + a2)), lambda = a1 / (a1 + a2);
        auto const describe = [&] { return hex_text(p); };
        failures.check(std::fabs(c.mu2 - mu2) <= 20 * u * mu2, "mu^2", c.mu2, mu2, describe);
        failures.check(std::fabs(c.lambda - lambda) <= 20 * u * lambda, "lambda", c.lambda, lambda,
                       describe);
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    add_for_each_solver("/invariance", "exchange", test_exchange);
    add_for_each_solver("/invariance", "rotation", test_rotation);
    add_for_each_solver("/invariance", "linear_map", test_linear_map);
    add_for_each_solver("/invariance", "powers_of_two", test_powers_of_two);
    add_for_each_solver("/invariance", "scaling_of_separation", test_scaling_of_separation);
    add_for_each_solver("/invariance", "spheres", test_spheres);
    return g_test_run();
}
