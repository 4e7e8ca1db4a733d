// SPDX-License-Identifier: BSD-3-Clause
// Ellipses as sections of ellipsoids: a pair of ellipsoids with centres in the plane z = 0 and an
// axis along z has the same derivatives as its section by that plane.
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85/batch.hpp>

#include "cases.hpp"
#include "condition_number.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

pw85::SymmetricMatrix<double, 3> in_space(pw85::SymmetricMatrix<double, 2> const &q, double third)
{
    return {q[0], q[1], 0.0, q[2], 0.0, third};
}

Sample<double, 3> in_space(Random &random, Sample<double, 2> const &p)
{
    return {{p.r12[0], p.r12[1], 0.0},
            in_space(p.q1, random.log_uniform(0.1, 10.0)),
            in_space(p.q2, random.log_uniform(0.1, 10.0))};
}

/// All that is said of a pair at some λ, in the plane; entries of space that are zero there are
/// left out.
struct Derivatives {
    double point[2], normal[2], d_r12[2], d_q1[3], d_q2[3], torque[2];
};

Derivatives flat_derivatives(Sample<double, 2> const &p, double lambda)
{
    Derivatives d{};
    double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    g_assert_cmpint(pw85_contact_geometry_2d(r12, q1, q2, lambda, d.point, d.normal), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_contact_gradient_2d(r12, q1, q2, lambda, d.d_r12, d.d_q1, d.d_q2), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_contact_torque_2d(r12, q1, q2, lambda, d.torque, d.torque + 1), ==,
                    PW85_SUCCESS);
    return d;
}

Derivatives derivatives_in_space(Sample<double, 3> const &p, double lambda)
{
    auto const g = pw85::contact_geometry(p.r12, p.q1, p.q2, lambda);
    auto const d = pw85::contact_gradient(p.r12, p.q1, p.q2, lambda);
    auto const t = pw85::contact_torque(p.r12, p.q1, p.q2, lambda);
    return {{g.point[0], g.point[1]},    {g.normal[0], g.normal[1]},
            {d.r12[0], d.r12[1]},        {d.q1[0], d.q1[1], d.q1[3]},
            {d.q2[0], d.q2[1], d.q2[3]}, {t.rotation1[2], t.rotation2[2]}};
}

template <std::size_t n> void check_close(Failures &failures, char const *what,
                                          double const (&actual)[n], double const (&expected)[n],
                                          double bound, Sample<double, 2> const &p)
{
    double largest = 0.0;
    for (double const x : expected) largest = std::fmax(largest, std::fabs(x));
    for (std::size_t i = 0; i < n; ++i)
        failures.check(std::fabs(actual[i] - expected[i]) <= bound * largest, what, actual[i],
                       expected[i], [&] { return hex_text(p); });
}

// Both solve the same equations, in another order, so that they differ by roundings over the
// conditioning, aspect²; a torque is a difference of products that are larger than it by the aspect
// ratio.
PW85_TEST("/two_dimensions/sections")
{
    Failures failures;
    Random random(800);
    for (int n = 0; n < draws(3000); ++n) {
        double const aspect = random.log_uniform(1.0, 30.0), bound = 64 * u * aspect * aspect;
        auto const p = random_pair<2>(random, {.aspect = aspect, .aspect_min = 1.0});
        double out[2];
        pw85_contact_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        auto const actual = flat_derivatives(p, out[1]);
        auto const expected = derivatives_in_space(in_space(random, p), out[1]);
        check_close(failures, "point", actual.point, expected.point, bound, p);
        check_close(failures, "normal", actual.normal, expected.normal, bound, p);
        check_close(failures, "d_r12", actual.d_r12, expected.d_r12, bound, p);
        check_close(failures, "d_q1", actual.d_q1, expected.d_q1, bound, p);
        check_close(failures, "d_q2", actual.d_q2, expected.d_q2, bound, p);
        double const reference = std::fabs(out[0]);
        for (int e = 0; e < 2; ++e)
            failures.check(
                std::fabs(actual.torque[e] - expected.torque[e]) <= bound * aspect * reference,
                "torque", actual.torque[e], expected.torque[e], [&] { return hex_text(p); });
    }
}

// An overlap of sections is one of the ellipsoids, exactly.
PW85_TEST("/two_dimensions/overlap")
{
    Failures failures;
    Random random(810);
    for (int n = 0; n < draws(3000); ++n) {
        double const excess = random.sign() * random.log_uniform(1e-16, 0.5);
        auto const p = random_pair<2>(random, {.aspect = 100.0,
                                               .mu2_min = (1.0 + excess) * (1.0 - u),
                                               .mu2_max = (1.0 + excess) * (1.0 + u)});
        auto const q = in_space(random, p);
        int flat = 7, solid = 7;
        g_assert_cmpint(pw85_overlap_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, &flat), ==,
                        PW85_SUCCESS);
        g_assert_cmpint(pw85_overlap(q.r12.coordinates, q.q1.entries, q.q2.entries, &solid), ==,
                        PW85_SUCCESS);
        failures.check(flat == solid, "overlap", flat, solid, [&] { return hex_text(p); });
    }
}

/// A pair of any shape, some of them in extreme units, concentric, or bad.
Sample<double, 2> any_pair(Random &random)
{
    double const kind = random.uniform(0.0, 1.0);
    auto p =
        random_pair<2>(random, {.aspect = kind < 0.5 ? 10.0 : 1e6, .mu2_min = 0.5, .mu2_max = 2.0});
    if (kind > 0.9) p.r12 = {0.0, 0.0};
    if (kind > 0.93) p.q1[0] = -1.0;
    if (kind > 0.96) p.q2[2] = std::numeric_limits<double>::infinity();
    int const exponent = kind < 0.7 ? 0 : static_cast<int>(random.uniform(-400.0, 400.0));
    p.r12 = pw85::detail::times_power_of_two(p.r12, exponent);
    p.q1 = pw85::detail::times_power_of_two(p.q1, 2 * exponent);
    p.q2 = pw85::detail::times_power_of_two(p.q2, 2 * exponent);
    return p;
}

// Batches against single calls: overlaps are the same; of μ², each errs by at most 4 u cond.
PW85_TEST("/two_dimensions/batches")
{
    Failures failures;
    Random random(820);
    constexpr std::size_t n = 10000; // more than a thread takes at a time
    std::vector<pw85::Vector<double, 2>> r12(n);
    std::vector<pw85::SymmetricMatrix<double, 2>> q1(n), q2(n);
    std::vector<double> mu2(n), lambda(n);
    std::vector<unsigned char> overlap(n);
    int first_bad = PW85_SUCCESS;
    for (std::size_t i = 0; i < n; ++i) {
        auto const p = any_pair(random);
        r12[i] = p.r12;
        q1[i] = p.q1;
        q2[i] = p.q2;
        if (first_bad == PW85_SUCCESS)
            first_bad = static_cast<int>(pw85::contact(p.r12, p.q1, p.q2).status);
    }
    using Flat = pw85::FlatVectors;
    g_assert_cmpint(static_cast<int>(pw85::contact_batch(Flat(r12), q1, q2, mu2, lambda)), ==,
                    first_bad);
    g_assert_cmpint(static_cast<int>(pw85::overlap_batch(Flat(r12), q1, q2, overlap)), ==,
                    first_bad);
    for (std::size_t i = 0; i < n; ++i) {
        Sample<double, 2> const p{r12[i], q1[i], q2[i]};
        auto const text = [&] { return hex_text(p); };
        auto const c = pw85::contact(p.r12, p.q1, p.q2);
        auto const o = pw85::overlap(p.r12, p.q1, p.q2);
        int const expected = o.status != pw85::Status::success ? 255 : o.overlap ? 1 : 0;
        failures.check(overlap[i] == expected, "overlap", overlap[i], expected, text);
        if (!(c.mu2 > 0.0)) {
            failures.check(std::isnan(mu2[i]) == std::isnan(c.mu2) &&
                               (std::isnan(c.mu2) || mu2[i] == 0.0),
                           "mu2", mu2[i], c.mu2, text);
            continue;
        }
        double const bound = 8.0 * u *
                             static_cast<double>(condition_number(
                                 convert<long double>(p), static_cast<long double>(c.lambda)));
        failures.check(std::fabs(mu2[i] - c.mu2) <= bound * c.mu2, "mu2", mu2[i], c.mu2, text);
        failures.check(lambda[i] >= 0.0 && lambda[i] <= 1.0, "lambda", lambda[i], c.lambda, text);
    }
    g_assert_cmpint(pw85_contact_batch_2d(0, nullptr, nullptr, nullptr, nullptr, nullptr), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(
        pw85_contact_batch_2d(1, r12[0].coordinates, q1[0].entries, nullptr, mu2.data(), nullptr),
        ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_batch_2d(SIZE_MAX, r12[0].coordinates, q1[0].entries,
                                          q2[0].entries, overlap.data()),
                    ==, PW85_EINVAL);
}

PW85_TEST("/two_dimensions/optional_outputs")
{
    double const r12[2] = {3.0, 1.0}, q[3] = {4.0, 0.5, 1.0};
    g_assert_cmpint(pw85_contact_geometry_2d(r12, q, q, 0.5, nullptr, nullptr), ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_contact_gradient_2d(r12, q, q, 0.5, nullptr, nullptr, nullptr), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_contact_torque_2d(r12, q, q, 0.5, nullptr, nullptr), ==, PW85_SUCCESS);
    int overlap = 7;
    g_assert_cmpint(pw85_overlap_2d(r12, q, nullptr, &overlap), ==, PW85_EINVAL);
    g_assert_cmpint(overlap, ==, -1);
    g_assert_cmpint(pw85_overlap_2d(r12, q, q, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact_hessian_2d(r12, q, q, 0.5, nullptr), ==, PW85_EINVAL);
}

} // namespace
