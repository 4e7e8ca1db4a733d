// SPDX-License-Identifier: BSD-3-Clause
// Compares contact points, normals and derivatives of many pairs with those of one pair, and with a
// wider type.
#include <cmath>

#include <glib.h>

#include <pw85/batch.hpp>
#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../systems.hpp"
#include "batch_data.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

/// Everything that the functions give back; `vectors` are point, normal, d_r12, d_rot1, d_rot2.
struct Result {
    std::vector<double> mu2, lambda;
    std::vector<Vector3> vectors[5];
    int status = 0;

    explicit Result(std::size_t n) : mu2(n), lambda(n)
    {
        for (auto &rows : vectors) rows.resize(n);
    }

    pw85::DerivativeSpans spans()
    {
        return {mu2, lambda, vectors[0], vectors[1], vectors[2], vectors[3], vectors[4]};
    }

    bool same_row(std::size_t i, Result const &other, std::size_t j) const
    {
        bool same = std::memcmp(&mu2[i], &other.mu2[j], sizeof(double)) == 0 &&
                    std::memcmp(&lambda[i], &other.lambda[j], sizeof(double)) == 0;
        for (int v = 0; v < 5; ++v)
            same = same && std::memcmp(&vectors[v][i], &other.vectors[v][j], sizeof(Vector3)) == 0;
        return same;
    }
};

/// Columns of a vector of pairs.
struct Columns {
    std::vector<Vector3> r12;
    std::vector<Form3> q1, q2;

    Columns(std::vector<Pair3> const &pairs, std::size_t first, std::size_t n)
    {
        for (std::size_t i = first; i < first + n; ++i) {
            r12.push_back(pairs[i].r12);
            q1.push_back(pairs[i].q1);
            q2.push_back(pairs[i].q2);
        }
    }
};

Result run(std::vector<Pair3> const &pairs, std::size_t first, std::size_t n)
{
    Columns const columns(pairs, first, n);
    Result result(n);
    result.status = static_cast<int>(
        pw85::contact_derivatives_batch(columns.r12, columns.q1, columns.q2, result.spans()));
    return result;
}

Result run(std::vector<Pair3> const &pairs) { return run(pairs, 0, pairs.size()); }

double largest(Vector3 const &x)
{
    return std::fmax(std::fabs(x[0]), std::fmax(std::fabs(x[1]), std::fabs(x[2])));
}

/// What the adjugate may add to an error: 13 u/d of itself (theorem `adjugate` of
/// tests/bounds/proofs.cpp), where it is taken.
double error_of_adjugate(Pair3 const &p, double lambda)
{
    auto const solution = pw85::detail::solve_by_adjugate(
        pw85::detail::blend(1.0 - lambda, p.q1, lambda, p.q2), p.r12);
    double const d = solution.determinant / solution.diagonal;
    return d > 0.9 * pw85::detail::adjugate_conditioning<double>()
               ? pw85::detail::adjugate_error * u / d
               : 0.0;
}

// At the λ that is given back, in a wider type: with the bound of the functions for one pair, 64 u
// aspect² of the largest coordinate by factorisation (see test_geometry.cpp), and what the adjugate
// adds. Torques are products of two vectors of which each may err by so much.
PW85_TEST("/derivatives/accuracy")
{
    Failures failures;
    Random random(51);
    for (double const aspect : {1.5, 10.0, 100.0, 1e3, 1e4}) {
        std::vector<Pair3> pairs;
        for (int i = 0; i < draws(2000); ++i) {
            pairs.push_back(random_pair<3>(random, {.aspect = aspect}));
            // Parallel ellipsoids of one shape: the blend is as ill-conditioned as they are.
            if (i % 4 == 0) pairs.back().q2 = 0.25 * pairs.back().q1;
        }
        Result const result = run(pairs);
        g_assert_cmpint(result.status, ==, PW85_SUCCESS);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            auto const p = convert<long double>(pairs[i]);
            auto const lambda = static_cast<long double>(result.lambda[i]);
            auto const geometry = pw85::contact_geometry(p.r12, p.q1, p.q2, lambda);
            auto const gradient = pw85::contact_gradient(p.r12, p.q1, p.q2, lambda);
            auto const torque = pw85::contact_torque(p.r12, p.q1, p.q2, lambda);
            Vector3 const expected[5] = {
                convert<double>(geometry.point), convert<double>(geometry.normal),
                convert<double>(gradient.r12), convert<double>(torque.rotation1),
                convert<double>(torque.rotation2)};
            double const bound = 64 * u * aspect * aspect +
                                 error_of_adjugate(pairs[i], result.lambda[i]),
                         arm = largest(expected[2]) * largest(pairs[i].r12);
            for (int v = 0; v < 5; ++v) {
                double const scale =
                    v < 3 ? largest(expected[v]) : std::fmax(arm, largest(expected[v]));
                for (int d = 0; d < 3; ++d) {
                    double const error = std::fabs(result.vectors[v][i][d] - expected[v][d]);
                    failures.check(error <= bound * scale, "error of a coordinate", error,
                                   bound * scale, [&] {
                                       return hex_text(pairs[i]) + ", vector " + std::to_string(v) +
                                              " of point, normal, r12, rotations";
                                   });
                }
            }
        }
    }
}

// μ² and λ have the bits of pw85_contact_batch(); vectors are NaN exactly where those of one pair
// are at this λ.
PW85_TEST("/derivatives/mixed")
{
    Failures failures;
    Random random(52);
    auto const pairs = mixed_pairs(random, 20000);
    Result const result = run(pairs);
    BatchResult const contact = run_batch(pairs);
    g_assert_cmpint(result.status, ==, contact.contact_status);
    g_assert_true(
        std::memcmp(result.mu2.data(), contact.mu2.data(), pairs.size() * sizeof(double)) == 0);
    g_assert_true(std::memcmp(result.lambda.data(), contact.lambda.data(),
                              pairs.size() * sizeof(double)) == 0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        double const *r12 = pairs[i].r12.coordinates, *q1 = pairs[i].q1.entries,
                     *q2 = pairs[i].q2.entries;
        double const lambda = result.lambda[i];
        Vector3 expected[5];
        pw85_contact_geometry(r12, q1, q2, lambda, expected[0].coordinates,
                              expected[1].coordinates);
        pw85_contact_gradient(r12, q1, q2, lambda, expected[2].coordinates, nullptr, nullptr);
        pw85_contact_torque(r12, q1, q2, lambda, expected[3].coordinates, expected[4].coordinates);
        for (int v = 0; v < 5; ++v)
            for (int d = 0; d < 3; ++d) {
                double const actual = result.vectors[v][i][d];
                failures.check(std::isnan(actual) == std::isnan(expected[v][d]), "mark", actual,
                               expected[v][d], [&] { return hex_text(pairs[i]); });
            }
    }
}

// Any number, at any position, in threads too: the same bits.
PW85_TEST("/derivatives/sizes_and_positions")
{
    Random random(53);
    auto const pairs = mixed_pairs(random, 9000);
    Result const whole = run(pairs);
    for (std::size_t const first :
         {std::size_t{0}, std::size_t{1}, std::size_t{130}, std::size_t{4097}})
        for (std::size_t const n :
             {std::size_t{1}, std::size_t{7}, std::size_t{8}, std::size_t{17}, std::size_t{129}}) {
            Result const part = run(pairs, first, n);
            for (std::size_t i = 0; i < n; ++i) g_assert_true(part.same_row(i, whole, first + i));
        }
}

// A list gives what a batch of its separations gives, with images and without.
PW85_TEST("/derivatives/pairs")
{
    Random random(54);
    std::size_t const n = 1000;
    std::vector<Pair3> pairs = mixed_pairs(random, n);
    std::vector<Vector3> centers(2 * n, Vector3{0.0, 0.0, 0.0});
    std::vector<Form3> q(2 * n);
    std::vector<pw85::IndexPair> list(n);
    std::vector<pw85::Image> images(n);
    pw85::Cell const cell = {{{3, 0, 0}, {0, 0, 0}, {0, 0, 7}}};
    for (std::size_t k = 0; k < n; ++k) {
        list[k] = {static_cast<std::int32_t>(2 * k), static_cast<std::int32_t>(2 * k + 1)};
        images[k] = {k % 3 == 0, 5, k % 5 == 0 ? -1 : 0};
        centers[2 * k + 1] = pairs[k].r12;
        q[2 * k] = pairs[k].q1;
        q[2 * k + 1] = pairs[k].q2;
    }
    for (bool const with_images : {false, true}) {
        if (with_images)
            for (std::size_t k = 0; k < n; ++k) {
                pairs[k].r12[0] += images[k][0] * 3.0;
                pairs[k].r12[2] += images[k][2] * 7.0;
            }
        Result const expected = run(pairs);
        pw85::PairList const pair_list{list, with_images ? std::span<pw85::Image const>(images)
                                                         : std::span<pw85::Image const>()};
        Result result(n);
        auto const status = pw85::contact_derivatives_pairs(
            pair_list, {centers, q, with_images ? &cell : nullptr}, result.spans());
        g_assert_cmpint(static_cast<int>(status), ==, expected.status);
        for (std::size_t k = 0; k < n; ++k) g_assert_true(result.same_row(k, expected, k));
    }
}

// Each output may be left out, and the others stay as they are.
PW85_TEST("/derivatives/outputs")
{
    Random random(55);
    std::size_t const n = 300;
    std::vector<Pair3> const pairs = mixed_pairs(random, n);
    Columns const columns(pairs, 0, n);
    Result const expected = run(pairs);
    for (int kept = 0; kept < 7; ++kept) {
        Result result(n);
        auto const all = result.spans();
        pw85::DerivativeSpans some;
        if (kept == 0) some.mu2 = all.mu2;
        if (kept == 1) some.lambda = all.lambda;
        if (kept == 2) some.point = all.point;
        if (kept == 3) some.normal = all.normal;
        if (kept == 4) some.d_r12 = all.d_r12;
        if (kept == 5) some.d_rot1 = all.d_rot1;
        if (kept == 6) some.d_rot2 = all.d_rot2;
        pw85::contact_derivatives_batch(columns.r12, columns.q1, columns.q2, some);
        auto const same = [&](auto const &x, auto const &y) {
            return std::memcmp(x.data(), y.data(), n * sizeof x[0]) == 0;
        };
        Result const untouched(n);
        g_assert_true(same(result.mu2, kept == 0 ? expected.mu2 : untouched.mu2));
        g_assert_true(same(result.lambda, kept == 1 ? expected.lambda : untouched.lambda));
        for (int v = 0; v < 5; ++v)
            g_assert_true(same(result.vectors[v],
                               kept == v + 2 ? expected.vectors[v] : untouched.vectors[v]));
    }
}

// Concentric ellipsoids attract and turn nothing.
PW85_TEST("/derivatives/concentric")
{
    std::vector<Pair3> const pairs = {{{0, 0, 0}, {1, 0, 0, 2, 0, 3}, {1, 0.5, 0, 1, 0, 1}}};
    Result const result = run(pairs);
    g_assert_cmpint(result.status, ==, PW85_SUCCESS);
    g_assert_true(result.mu2[0] == 0.0 && result.lambda[0] == 0.5);
    for (int d = 0; d < 3; ++d) {
        for (int const v : {0, 1}) g_assert_true(std::isnan(result.vectors[v][0][d]));
        for (int const v : {2, 3, 4}) g_assert_cmpfloat(result.vectors[v][0][d], ==, 0.0);
    }
}

PW85_TEST("/derivatives/arguments")
{
    double const x[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double out = 7.0;
    auto const list = [&](std::size_t n, std::int32_t const *pairs, std::int32_t const *images,
                          double const *cell) {
        return pw85_contact_derivatives_pairs(list_of(n, pairs, images), system_of(1, x, x, cell),
                                              &out, nullptr, nullptr, nullptr, nullptr, nullptr,
                                              nullptr);
    };
    std::int32_t const pairs[2] = {0, 0}, outside[2] = {0, 1}, image[3] = {};
    g_assert_cmpint(list(0, nullptr, nullptr, nullptr), ==, PW85_SUCCESS);
    g_assert_cmpint(list(1, nullptr, nullptr, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(list(1, outside, nullptr, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(list(1, pairs, image, nullptr), ==, PW85_EINVAL);
    g_assert_cmpfloat(out, ==, 7.0);
    g_assert_cmpint(list(1, pairs, nullptr, nullptr), ==, PW85_SUCCESS);
    g_assert_cmpfloat(out, ==, 0.0);
    Result result(3);
    std::vector<Vector3> const r12(3);
    std::vector<Form3> const q(3), fewer(2);
    g_assert_true(pw85::contact_derivatives_batch(r12, q, fewer, result.spans()) ==
                  pw85::Status::invalid_argument);
    Result too_small(2);
    g_assert_true(pw85::contact_derivatives_batch(r12, q, q, too_small.spans()) ==
                  pw85::Status::invalid_argument);
}

} // namespace
