// SPDX-License-Identifier: BSD-3-Clause
// Tests of the depth of an overlap.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include <glib.h>

#include <pw85.h>
#include <pw85/distance/penetration.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"
#include "sensitivity.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

template <class T, int D> pw85::Penetration<T, D> penetration(Sample<T, D> const &p)
{
    return pw85::penetration(p.r12, p.q1, p.q2);
}

/// In double by the C API.
template <int D> pw85::Penetration<double, D> penetration(Sample<double, D> const &p)
{
    pw85::Penetration<double, D> result{};
    result.status = static_cast<pw85::Status>((D == 3 ? pw85_penetration : pw85_penetration_2d)(
        p.r12.coordinates, p.q1.entries, p.q2.entries, &result.depth,
        result.direction.coordinates));
    return result;
}

/// By how far ellipsoid 2 must move along n.
template <class T, int D> T shift(Sample<T, D> const &p, pw85::Vector<T, D> const &n)
{
    return pw85::detail::support(p.q1, n).extent + pw85::detail::support(p.q2, n).extent -
           pw85::dot(n, p.r12);
}

template <int D> Sample<double, D> overlapping_pair(Random &random, double aspect)
{
    return random_pair<D>(random, {.aspect = random.log_uniform(1.0, aspect),
                                   .size_ratio = random.log_uniform(1.0, 100.0),
                                   .mu2_min = 1e-6,
                                   .mu2_max = 0.999});
}

// The contract: moved along the direction by the depth, the pair touches, to rounding (of the sum
// as for the distance, 8 u Σ); μ² is computed in a wider type, and changes by 2/(α + β) times what
// the gap does.
template <int D> void check_touching(int pairs)
{
    Failures failures;
    Random random(700 + D);
    for (int n = 0; n < pairs; ++n) {
        auto const s = overlapping_pair<D>(random, 1e3);
        auto const found = penetration(s);
        auto const p = convert<Wide>(s);
        auto direction = convert<Wide>(found.direction);
        direction = Wide(1 / norm(direction)) * direction;
        auto const text = [&] { return hex_text(s); };
        double const length = static_cast<double>(Wide(shift(p, direction)));
        double const bound = 8 * u * static_cast<double>(Wide(sensitivity(p, direction)));
        failures.check(std::fabs(found.depth - length) <= bound, "what the direction needs",
                       found.depth, length, text);
        failures.check(
            std::fabs(static_cast<double>(norm(convert<Wide>(found.direction))) - 1.0) <= 4 * u,
            "unit", static_cast<double>(norm(convert<Wide>(found.direction))), 1.0, text);
        auto moved = p;
        for (int i = 0; i < D; ++i) moved.r12[i] += length * direction[i];
        Wide const extents = pw85::detail::support(p.q1, direction).extent +
                             pw85::detail::support(p.q2, direction).extent;
        double const gap = static_cast<double>(
            Wide((pw85::contact(moved.r12, moved.q1, moved.q2).mu2 - 1) * extents / 2));
        failures.check(std::fabs(gap) <= 4 * bound, "gap after the translation", gap, 4 * bound,
                       text);
    }
}

PW85_TEST("/penetration/touching")
{
    check_touching<3>(1000);
    check_touching<2>(500);
}

// Near contact, where a certificate or a direction that separates decides, the answer is that of
// the overlap test.
PW85_TEST("/penetration/near_contact")
{
    Failures failures;
    Random random(705);
    int overlapping = 0;
    for (int n = 0; n < draws(8000); ++n) {
        double const mu2 = 1.0 + random.sign() * random.log_uniform(1e-16, 0.1);
        auto const s = random_pair<3>(random, {.aspect = random.log_uniform(1.0, 1e3),
                                               .size_ratio = random.log_uniform(1.0, 100.0),
                                               .mu2_min = mu2,
                                               .mu2_max = mu2});
        int overlap;
        g_assert_cmpint(pw85_overlap(s.r12.coordinates, s.q1.entries, s.q2.entries, &overlap), ==,
                        PW85_SUCCESS);
        auto const found = penetration(s);
        failures.check(std::isnan(found.direction[0]) == (overlap == 0), "overlap", found.depth,
                       overlap, [&] { return hex_text(s); });
        overlapping += overlap;
    }
    g_assert_cmpint(overlapping, >, draws(2000));
}

/// The least shift over random directions, the best of which are followed downhill: on to the
/// normal at the point of the sum of the ellipsoids that is nearest in direction, with ever shorter
/// steps.
double dense_search(Sample<double, 3> const &p, Random &random)
{
    double least = std::numeric_limits<double>::infinity();
    for (int start = 0; start < 40; ++start) {
        pw85::Vector<double, 3> n{};
        double value = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 50; ++k) {
            auto const m = random.direction<3>();
            if (double const here = shift(p, m); here < value) {
                value = here;
                n = m;
            }
        }
        for (double step = 0.1; step > 1e-8;) {
            auto const turn = random.direction<3>();
            pw85::Vector<double, 3> m{n[0] + step * turn[0], n[1] + step * turn[1],
                                      n[2] + step * turn[2]};
            m = 1.0 / norm(m) * m;
            double const here = shift(p, m);
            step *= here < value ? 1.5 : 0.93;
            if (here < value) {
                value = here;
                n = m;
            }
        }
        least = std::fmin(least, value);
    }
    return least;
}

// The global minimum: that of a dense search, and no less; the search ends near enough for 1e-11.
PW85_TEST("/penetration/dense_search")
{
    Failures failures;
    Random random(710);
    for (int n = 0; n < 60; ++n) {
        auto const s = overlapping_pair<3>(random, 10.0);
        double const depth = penetration(s).depth, expected = dense_search(s, random);
        double const size = norm(s.r12) + std::sqrt(pw85::detail::largest_diagonal(s.q1)) +
                            std::sqrt(pw85::detail::largest_diagonal(s.q2));
        failures.check(std::fabs(depth - expected) <= 1e-11 * size, "dense search", depth, expected,
                       [&] { return hex_text(s); });
    }
}

// No direction needs less than the depth, but for what the contract leaves.
template <int D> void check_none_shorter(int pairs)
{
    Failures failures;
    Random random(720 + D);
    for (int n = 0; n < pairs; ++n) {
        auto const s = overlapping_pair<D>(random, 1e4);
        auto const found = penetration(s);
        failures.check(found.status == pw85::Status::success && found.depth >= 0.0, "depth",
                       found.depth, 0.0, [&] { return hex_text(s); });
        double const bound = 32 * u * sensitivity(s, found.direction);
        for (int k = 0; k < 500; ++k) {
            auto direction = random.direction<D>();
            // everywhere, and nearby
            double const spread = k % 2 == 0 ? 1.0 : random.log_uniform(1e-8, 1.0);
            for (int i = 0; i < D; ++i)
                direction[i] = spread * direction[i] + (1.0 - spread) * found.direction[i];
            direction = 1.0 / norm(direction) * direction;
            double const length = shift(s, direction);
            failures.check(length >= found.depth - bound, "shorter", length, found.depth,
                           [&] { return hex_text(s); });
        }
    }
}

PW85_TEST("/penetration/none_shorter")
{
    check_none_shorter<3>(1000);
    check_none_shorter<2>(1000);
}

// In a wider type the proof is to its rounding: the same depth, to the contract.
PW85_TEST("/penetration/wide")
{
    Failures failures;
    Random random(730);
    for (int n = 0; n < 4; ++n) {
        auto const s = overlapping_pair<3>(random, 30.0);
        auto const p = convert<Multiprecision<20>>(s);
        auto const exact = pw85::penetration(p.r12, p.q1, p.q2);
        double const depth = penetration(s).depth, expected = static_cast<double>(exact.depth);
        double const bound = 32 * u * static_cast<double>(sensitivity(p, exact.direction));
        failures.check(std::fabs(depth - expected) <= bound, "depth", depth, expected,
                       [&] { return hex_text(s); });
    }
}

void assert_depth(Sample<double, 3> const &p, double expected)
{
    auto const found = penetration(p);
    g_assert_cmpint(static_cast<int>(found.status), ==, PW85_SUCCESS);
    double const bound = 32 * u * sensitivity(p, found.direction);
    if (std::fabs(found.depth - expected) > bound) g_test_message("%s", hex_text(p).c_str());
    g_assert_cmpfloat(std::fabs(found.depth - expected), <=, bound);
    g_assert_cmpfloat(std::fabs(shift(p, found.direction) - expected), <=, bound);
}

// Minima that are not isolated: spheres, concentric or not; ellipsoids of revolution on one axis,
// whose best directions are circles; ellipsoids of one shape, whose sum is one.
PW85_TEST("/penetration/degenerate")
{
    pw85::SymmetricMatrix<double, 3> const one{1.0, 0.0, 0.0, 1.0, 0.0, 1.0},
        two{4.0, 0.0, 0.0, 4.0, 0.0, 4.0}, prolate{1.0, 0.0, 0.0, 1.0, 0.0, 9.0},
        oblate{9.0, 0.0, 0.0, 9.0, 0.0, 1.0}, general{1.0, 0.0, 0.0, 4.0, 0.0, 9.0},
        twice{4.0, 0.0, 0.0, 16.0, 0.0, 36.0};
    assert_depth({{0.0, 0.0, 0.0}, one, two}, 3.0);
    assert_depth({{0.5, 0.0, 0.0}, one, two}, 2.5);
    assert_depth({{0.0, 0.0, 0.0}, prolate, prolate}, 2.0);
    assert_depth({{0.0, 0.0, 0.0}, prolate, oblate}, 4.0);
    assert_depth({{0.0, 0.0, 0.0}, prolate, one}, 2.0);
    assert_depth({{0.0, 0.0, 0.0}, general, twice}, 3.0);
    assert_depth({{2.5, 0.0, 0.0}, general, twice}, 0.5);
    assert_depth({{0.0, 0.0, 0.3}, oblate, {1.0, 0.0, 0.0, 1.0, 0.0, 4.0}}, 2.7);
    // A prolate spheroid of axes 1 and 3 that is off-centre by z on its axis, and a sphere: 1 + the
    // depth of the point in the spheroid, 3 - z behind the centre of curvature at 3 - 1/3, and
    // √(1 - z²/8) before.
    for (double const z : {0.1, 1.0, 2.0, 2.5, 2.66, 2.6666, 2.667, 2.7, 2.9, 3.5})
        assert_depth({{0.0, 0.0, z}, prolate, one},
                     z < 8.0 / 3.0 ? 1.0 + std::sqrt(1.0 - z * z / 8.0) : 4.0 - z);
}

// A small sphere in an ellipsoid: the depth of the point, which nearest.hpp has, plus the radius.
PW85_TEST("/penetration/sphere")
{
    Failures failures;
    Random random(740);
    for (int n = 0; n < 500; ++n) {
        double const radius = random.log_uniform(1e-6, 10.0);
        auto const form = random.form(1.0, random.log_uniform(1.0, 100.0));
        auto const direction = random.direction<3>();
        double const reach =
            1.0 /
            std::sqrt(pw85::dot(
                direction, pw85::detail::solve(pw85::detail::factorize(form, 0.0), direction)));
        Sample<double, 3> const s{
            reach * random.uniform(0.0, 1.0) * direction,
            form,
            {radius * radius, 0.0, 0.0, radius * radius, 0.0, radius * radius}};
        auto const found = penetration(s);
        double const expected = radius - pw85::distance_point(s.r12, form).distance;
        double const bound = 32 * u * sensitivity(s, found.direction);
        failures.check(std::fabs(found.depth - expected) <= bound, "sphere", found.depth, expected,
                       [&] { return hex_text(s); });
    }
}

// Exchanging the ellipsoids turns the direction round; a power of two on all lengths changes
// nothing but the unit.
PW85_TEST("/penetration/invariance")
{
    Failures failures;
    Random random(750);
    for (int n = 0; n < 300; ++n) {
        auto const s = overlapping_pair<3>(random, 100.0);
        double const depth = penetration(s).depth,
                     exchanged = penetration(Sample<double, 3>{-s.r12, s.q2, s.q1}).depth;
        double const bound = 64 * u * sensitivity(s, penetration(s).direction);
        failures.check(std::fabs(depth - exchanged) <= bound, "exchange", exchanged, depth,
                       [&] { return hex_text(s); });
        for (int const unit : {-480, -100, 100, 480}) {
            Sample<double, 3> const scaled{pw85::detail::times_power_of_two(s.r12, unit),
                                           pw85::detail::times_power_of_two(s.q1, 2 * unit),
                                           pw85::detail::times_power_of_two(s.q2, 2 * unit)};
            double const result = std::ldexp(penetration(scaled).depth, -unit);
            failures.check(std::fabs(result - depth) <= bound, "unit", result, depth,
                           [&] { return hex_text(scaled); });
        }
    }
}

// Any size and shape: an answer that is true to the contract for its own direction.
PW85_TEST("/penetration/extremes")
{
    Failures failures;
    Random random(760);
    for (int n = 0; n < 300; ++n) {
        auto const axis = [&] { return random.log_uniform(1e-8, 1e8); };
        auto const square = [](double x) { return x * x; };
        double const size1 = random.log_uniform(1e-130, 1e130),
                     size2 = n % 2 == 0 ? random.log_uniform(1e-130, 1e130) : size1;
        Sample<double, 3> s{
            random.direction<3>(),
            {square(size1 * axis()), 0.0, 0.0, square(size1 * axis()), 0.0, square(size1 * axis())},
            {square(size2 * axis()), 0.0, 0.0, square(size2 * axis()), 0.0,
             square(size2 * axis())}};
        double const apart = 1.0 / std::sqrt(pw85::contact(s.r12, s.q1, s.q2).mu2);
        s.r12 = apart * random.uniform(0.0, 0.99) * s.r12;
        auto const found = penetration(s);
        double const length = shift(s, found.direction),
                     bound = 8 * u * sensitivity(s, found.direction);
        failures.check(found.status == pw85::Status::success &&
                           std::fabs(found.depth - length) <= bound,
                       "depth", found.depth, length, [&] { return hex_text(s); });
        for (int k = 0; k < 100; ++k) {
            auto const direction = random.direction<3>();
            failures.check(shift(s, direction) >= found.depth - 4 * bound, "shorter",
                           shift(s, direction), found.depth, [&] { return hex_text(s); });
        }
    }
}

// Centres that nearly coincide: squares of the distance, and of its multiples, underflow.
PW85_TEST("/penetration/nearly_concentric")
{
    Failures failures;
    Random random(765);
    for (int n = 0; n < 300; ++n) {
        auto s = random_pair<3>(random, {.aspect = n % 3 == 0 ? 1.0 : random.log_uniform(1.0, 1e4),
                                         .size_ratio = random.log_uniform(1.0, 100.0)});
        if (n % 2 == 0) s.q2 = s.q1;
        s.r12 = random.log_uniform(1e-320, 1e-100) * random.direction<3>();
        auto const found = penetration(s);
        auto const text = [&] { return hex_text(s); };
        double const bound = 8 * u * sensitivity(s, found.direction),
                     length = shift(s, found.direction);
        failures.check(std::fabs(norm(found.direction) - 1.0) <= 4 * u, "unit",
                       norm(found.direction), 1.0, text);
        failures.check(found.status == pw85::Status::success &&
                           std::fabs(found.depth - length) <= bound,
                       "depth", found.depth, length, text);
        double const exchanged = penetration(Sample<double, 3>{s.r12, s.q2, s.q1}).depth;
        failures.check(std::fabs(found.depth - exchanged) <= 8 * bound, "exchanged", found.depth,
                       exchanged, text); // 32 u Σ
    }
}

// The ends of the range at once: axes of 1e150 and 1e121, whose ratio must not meet their squares.
PW85_TEST("/penetration/widest")
{
    Sample<double, 3> const s{{0.0, 0.0, 0x1.ep472},
                              {0x1p1000, 0.0, 0.0, 0x1p808, 0.0, 0x1p807},
                              {0x1p1000, 0.0, 0.0, 0x1p808, 0.0, 0x1p1000}};
    auto const found = penetration(s);
    g_assert_cmpint(static_cast<int>(found.status), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(found.depth / 0x1p405 - 1.0), <=, 16 * u);
    g_assert_cmpfloat(std::fabs(found.direction[1]), ==, 1.0);
}

template <class T> void check_scalar(Failures &failures, Random &random)
{
    auto const s = overlapping_pair<3>(random, 10.0);
    auto const p = convert<T>(s);
    auto const found = pw85::penetration(p.r12, p.q1, p.q2);
    double const exact = penetration(s).depth, depth = static_cast<double>(found.depth);
    // The pair itself is rounded to T.
    double const bound = 64 * static_cast<double>(pw85::detail::unit_roundoff<T>() + T(u)) *
                         sensitivity(s, penetration(s).direction);
    failures.check(std::fabs(depth - exact) <= bound, "scalar", depth, exact,
                   [&] { return hex_text(s); });
}

PW85_TEST("/penetration/scalars")
{
    Failures failures;
    Random random(770);
    for (int n = 0; n < 100; ++n) {
        check_scalar<float>(failures, random);
        check_scalar<long double>(failures, random);
    }
}

// Where none_deeper() says so, no c of the interval gives less than the best that is known, which
// is set between what the two ends give. Each of the ends is the one that matters for half of the
// intervals.
PW85_TEST("/penetration/proof")
{
    Failures failures;
    Random random(790);
    int proved = 0;
    for (int n = 0; n < draws(8000); ++n) {
        auto const s = overlapping_pair<3>(random, 30.0);
        double const c = random.log_uniform(0.1, 10.0), rho = 1.0 + random.log_uniform(1e-3, 0.5);
        auto const depth = [&](double at) {
            auto const form = pw85::detail::enclosing_form(s.q1, s.q2, at, 0.0);
            auto const normal = pw85::detail::extreme_normal(form, s.r12, true);
            return pw85::detail::support(form, normal).extent - pw85::dot(normal, s.r12);
        };
        double const lower = depth(c), upper = depth(rho * rho * c),
                     level = random.uniform(0.0, 1.0);
        pw85::detail::DepthSearch<double, 3> search{
            s.r12, s.q1, s.q2, {}, {lower + level * (upper - lower), 1.0, 0.0}};
        if (!none_deeper(search, c, rho)) continue;
        ++proved;
        for (int k = 0; k <= 8; ++k) {
            double const at = c * std::pow(rho, 0.25 * k), found = depth(at);
            failures.check(
                found >= search.best.length - 1e-13 * (1.0 + found), "depth in the interval", found,
                search.best.length,
                [&] { return hex_text(s) + ", c, rho = " + hex_text(&c, 1) + hex_text(&rho, 1); });
        }
    }
    g_assert_cmpint(proved, >, draws(80));
}

/// The depth of r in the ellipsoid of a form.
double depth_in(pw85::SymmetricMatrix<Wide, 3> const &form, pw85::Vector<Wide, 3> const &r)
{
    auto const normal = pw85::detail::extreme_normal(form, r, true);
    return static_cast<double>(
        Wide(pw85::detail::support(form, normal).extent - pw85::dot(normal, r)));
}

// A vertex (c, y) is found deep only if r has the depth in W(c, y), whatever σ the test begins
// with. A quarter of the levels is below 0.9 of the depth, where at most one vertex of a hundred
// may be missed (0.2 % of a million are). A miss halves a tangent and costs nothing else.
PW85_TEST("/penetration/vertices")
{
    Failures failures;
    Random random(792);
    int deeper = 0, found = 0;
    for (int n = 0; n < draws(8000); ++n) {
        auto const s = overlapping_pair<3>(random, 1e3);
        auto const p = convert<Wide>(s);
        double const c = random.log_uniform(1e-2, 1e2), y = random.uniform(0.5, 1.0) / c;
        Wide const one_c = Wide(1) + Wide(c), one_y = Wide(1) + Wide(y);
        double const depth = depth_in(pw85::detail::blend(one_c, p.q1, one_y, p.q2), p.r12);
        bool const below = n % 4 == 1;
        double const difference = (n % 2 == 0 ? 1.0 : -1.0) * random.log_uniform(1e-15, 1.0),
                     level = depth * (below ? random.uniform(0.0, 0.9) : 1.0 + difference);
        if (!(level > 0.0)) continue;
        pw85::detail::DepthSearch<double, 3> search{s.r12, s.q1, s.q2, {}, {level, 1.0, 0.0}};
        double const size = pw85::detail::trace(s.q1) + pw85::detail::trace(s.q2);
        pw85::detail::DepthVertex<double> vertex{c, y, random.log_uniform(1e-6, 1.0) * size};
        bool const deep = is_deep_at(search, vertex);
        failures.check(!deep || depth >= level, "depth at a vertex", depth, level, [&] {
            return hex_text(s) + ", c, y = " + hex_text(&c, 1) + hex_text(&y, 1);
        });
        if (!below) continue;
        ++deeper;
        found += deep;
    }
    g_assert_cmpint(deeper, >, draws(400));
    g_assert_cmpint(100 * found, >, 99 * deeper);
}

// Where the depth is proved beyond a ratio c, r has it in W at all further ratios, up to rounding.
// A test at half of the least of these depths mostly succeeds if c is far from the ratio of the
// least depth.
PW85_TEST("/penetration/beyond")
{
    Failures failures;
    Random random(794);
    int deeper = 0, found = 0;
    for (int n = 0; n < draws(2000); ++n) {
        auto const s = overlapping_pair<3>(random, 100.0);
        auto const p = convert<Wide>(s);
        bool const above = n % 2 == 0, half = n % 4 < 2;
        double const c = random.log_uniform(1e-2, 1e2);
        double least = std::numeric_limits<double>::infinity();
        for (double beyond = 1.0; beyond < 1e5; beyond *= 1.3) {
            Wide const ratio(above ? c * beyond : c / beyond), one(1);
            auto const form =
                pw85::detail::blend(Wide(one + ratio), p.q1, Wide(one + one / ratio), p.q2);
            least = std::fmin(least, depth_in(form, p.r12));
        }
        double const level = least * (half ? 0.5 : 1.0 + random.log_uniform(1e-12, 1.0));
        if (!(level > 0.0)) continue;
        pw85::detail::DepthSearch<double, 3> search{s.r12, s.q1, s.q2, {}, {level, 1.0, 0.0}};
        double const size = pw85::detail::trace(s.q1) + pw85::detail::trace(s.q2);
        bool const deep = is_deep_beyond(search, c, above, random.log_uniform(1e-6, 1.0) * size);
        failures.check(!deep || least >= level, "depth beyond a ratio", least, level,
                       [&] { return hex_text(s) + ", c = " + hex_text(&c, 1); });
        if (!half) continue;
        ++deeper;
        found += deep;
    }
    g_assert_cmpint(deeper, >, draws(400));
    g_assert_cmpint(10 * found, >, 5 * deeper);
}

// A Newton's turn leaves an error of second order, and a correction with the same stiffness one of
// third order: at a tenth of the distance from a minimum, a hundredth and a thousandth, up to terms
// of the next order.
PW85_TEST("/penetration/turns")
{
    using namespace pw85::detail;
    Failures failures;
    Random random(799);
    int tested = 0;
    for (int n = 0; n < draws(1600); ++n) {
        auto const s = overlapping_pair<3>(random, 4.0);
        auto const p = convert<Wide>(s);
        auto const q = side_by_side(p.q1, p.q2);
        auto const unit = [](auto m) { return Wide(1 / norm(m)) * m; };
        bool newton = true;
        auto const turned = [&](pw85::Vector<Wide, 3> const &m, bool corrected) {
            pw85::Vector<Wide, 3> step{};
            pw85::SymmetricMatrix<Wide, 3> inverse{};
            auto const at = state_along(q, p.r12, m, false);
            newton = normal_turn(q, p.r12, at, step, inverse) && newton;
            if (!corrected) return unit(m + step);
            auto const next = state_along(q, p.r12, m + step, false);
            return unit(next.n + correction_at(next, p.r12, inverse).turn);
        };
        auto minimum = convert<Wide>(penetration(s).direction);
        for (int k = 0; k < 3; ++k) minimum = turned(minimum, true);
        auto const aside = convert<Wide>(random.direction<3>());
        auto const error = [&](char const *distance, bool corrected) {
            auto const m = unit(minimum + Wide(distance) * aside);
            return static_cast<double>(norm(turned(m, corrected) - minimum));
        };
        double const second = error("1e-8", false) / error("1e-9", false),
                     third = error("1e-8", true) / error("1e-9", true);
        if (!newton || !(error("1e-8", true) > 1e-25)) continue;
        ++tested;
        failures.check(std::fabs(second - 100.0) <= 0.1, "Newton's turn", second, 100.0,
                       [&] { return hex_text(s); });
        failures.check(std::fabs(third - 1000.0) <= 1.0, "correction", third, 1000.0,
                       [&] { return hex_text(s); });
    }
    g_assert_cmpint(tested, >, draws(200));
}

// The line from a vertex to the next one is below the hyperbola y = 1/c and touches it.
PW85_TEST("/penetration/tangents")
{
    Failures failures;
    Random random(791);
    for (int n = 0; n < draws(8000); ++n) {
        double const c = random.log_uniform(1e-9, 1e9), y = random.uniform(0.1, 1.0) / c,
                     width = random.log_uniform(1e-3, 0.5);
        auto const next =
            next_vertex(pw85::detail::DepthProgress<double>{c, width, {c, y, 1.0}, true});
        double least = 1.0;
        for (int k = 0; k <= 4096; ++k) {
            double const part = k / 4096.0, at = c + part * (next.c - c);
            least = std::fmin(least, 1.0 - at * (y + part * (next.y - y)));
        }
        failures.check(next.c > c && least >= -1e-12 && least <= 1e-6, "tangent", least, 0.0,
                       [&] { return hex_text(&c, 1) + hex_text(&y, 1) + hex_text(&width, 1); });
    }
}

// The bounds of the semi-axes hold, and are within a factor of two of their squares.
template <int D> void check_axis_bounds()
{
    Failures failures;
    Random random(793 + D);
    for (int n = 0; n < draws(8000); ++n) {
        auto const s = overlapping_pair<D>(random, 1e4);
        auto const q = convert<Wide>(s).q2;
        auto const exact = pw85::detail::principal_axes(q);
        auto const bounds = pw85::detail::axis_bounds(s.q2);
        double least = std::numeric_limits<double>::infinity(), most = 0.0;
        for (auto const &square : exact.squares) {
            least = std::fmin(least, static_cast<double>(square));
            most = std::fmax(most, static_cast<double>(square));
        }
        double const lower = std::ldexp(bounds.least, 2 * bounds.unit.exponent),
                     upper = std::ldexp(bounds.most, 2 * bounds.unit.exponent);
        failures.check(lower <= least, "lower bound", lower, least, [&] { return hex_text(s); });
        failures.check(upper >= most, "upper bound", upper, most, [&] { return hex_text(s); });
        failures.check(2.0 * lower >= least - 256 * u * most && upper <= 2.0 * most, "tight", lower,
                       least, [&] { return hex_text(s); });
    }
}

PW85_TEST("/penetration/axis_bounds")
{
    check_axis_bounds<2>();
    check_axis_bounds<3>();
}

// Around a local minimum, from any start, no c of the proved range gives less. Global minima in the
// range, and ranges that go too far, would show. Most minima have such a range.
PW85_TEST("/penetration/minimum_proof")
{
    Failures failures;
    Random random(795);
    int proved = 0, total = 0;
    for (int n = 0; n < draws(2000); ++n) {
        auto const s = overlapping_pair<3>(random, 100.0);
        pw85::detail::DepthSearch<double, 3> search{
            s.r12, s.q1, s.q2, {}, {std::numeric_limits<double>::max(), 1.0, 0.0}};
        descend(search, random.log_uniform(1e-2, 1e2));
        auto const range = proved_range(search);
        ++total;
        if (!(range.upper > range.lower)) continue;
        if (range.upper > 1.5 * range.lower) ++proved;
        for (int k = 0; k <= 32; ++k) {
            double const c = range.lower * std::pow(range.upper / range.lower, k / 32.0);
            auto const form = pw85::detail::enclosing_form(s.q1, s.q2, c, 0.0);
            auto const normal = pw85::detail::extreme_normal(form, s.r12, true);
            double const depth =
                pw85::detail::support(form, normal).extent - pw85::dot(normal, s.r12);
            double const rounding =
                std::fmax(search.best.rounding,
                          pw85::detail::shift_along(normal, s.r12, s.q1, s.q2).rounding);
            failures.check(depth >= search.best.length - 4 * rounding, "depth in the range", depth,
                           search.best.length,
                           [&] { return hex_text(s) + ", c = " + hex_text(&c, 1); });
        }
    }
    g_assert_cmpint(10 * proved, >, 8 * total);
}

/// Turns from a unit vector.
pw85::detail::FollowedNormal<double, 3> follow(pw85::detail::DepthSearch<double, 3> &search,
                                               pw85::Vector<double, 3> const &n)
{
    search.best = {std::numeric_limits<double>::max(), 1.0, 0.0};
    return follow_normal(search, n);
}

pw85::detail::DepthSearch<double, 3> search_of(Sample<double, 3> const &s)
{
    return {s.r12, s.q1, s.q2, {}, {}};
}

/// Checks that a certified minimum exceeds what `other` needs by no more than the contract leaves.
/// The shifts are computed in a wider type. Returns whether the minimum is certified.
bool check_certificate(Failures &failures, pw85::detail::DepthSearch<double, 3> const &search,
                       pw85::detail::FollowedNormal<double, 3> const &minimum,
                       pw85::Vector<double, 3> const &other)
{
    if (!minimum.found || !is_certified(search, minimum.at)) return false;
    Sample<double, 3> const s{search.r12, search.q1, search.q2};
    auto const p = convert<Wide>(s);
    auto const unit = [](auto n) { return Wide(1 / norm(n)) * n; };
    double const needed =
        static_cast<double>(Wide(shift(p, unit(convert<Wide>(other))) - search.best.length));
    double const bound =
        32 * u * std::fmax(sensitivity(s, search.direction), sensitivity(s, other));
    failures.check(needed >= -bound, "certified", needed, -bound,
                   [&] { return hex_text(s) + ", n = " + hex_text(other.coordinates, 3); });
    return true;
}

// A certified minimum is the global one: other local minima, which turns from random directions
// find, do not need less. Most minima of the C API have a certificate, at any scale.
PW85_TEST("/penetration/certificate")
{
    Failures failures;
    Random random(796);
    int higher = 0, certified = 0, total = 0;
    for (int n = 0; n < draws(4000); ++n) {
        auto s = overlapping_pair<3>(random, n % 2 == 0 ? 30.0 : 1e3);
        int const unit = static_cast<int>(random.uniform(-40.0, 40.0));
        s = {pw85::detail::times_power_of_two(s.r12, unit),
             pw85::detail::times_power_of_two(s.q1, 2 * unit),
             pw85::detail::times_power_of_two(s.q2, 2 * unit)};
        auto search = search_of(s), other = search;
        auto const minimum = follow(search, random.direction<3>());
        auto const found = penetration(s);
        other.direction = found.direction;
        for (int k = 0; k < 4; ++k) {
            check_certificate(failures, search, minimum, other.direction);
            follow(other, random.direction<3>());
        }
        if (search.best.length > 1.001 * found.depth) ++higher;
        ++total;
        if (check_certificate(failures, other, follow(other, found.direction), found.direction))
            ++certified;
    }
    g_assert_cmpint(100 * higher, >, 2 * total);
    g_assert_cmpint(100 * certified, >, 80 * total);
}

// Of two minima that are nearly equally good, the higher one has no certificate. r12 is moved until
// they differ by a given length.
PW85_TEST("/penetration/certificate_at_ties")
{
    Failures failures;
    Random random(797);
    int ties = 0;
    for (int n = 0; n < draws(16000); ++n) {
        auto const s = overlapping_pair<3>(random, 100.0);
        auto first = search_of(s), second = first;
        auto const difference = random.log_uniform(1e-16, 1e-3);
        auto minimum = follow(first, random.direction<3>());
        follow(second, random.direction<3>());
        for (int k = 0; k < 8; ++k) {
            auto const apart = first.direction - second.direction;
            double const square = pw85::dot(apart, apart);
            if (!(square > 1e-3)) break;
            double const step = (first.best.length - second.best.length - difference) / square;
            first.r12 = second.r12 = first.r12 + step * apart;
            minimum = follow(first, first.direction);
            follow(second, second.direction);
        }
        if (!(first.best.length > second.best.length) || second.best.length <= 0.0) continue;
        if (norm(first.direction - second.direction) > 0.03) ++ties;
        check_certificate(failures, first, minimum, second.direction);
    }
    g_assert_cmpint(ties, >, draws(80));
}

// A quartic is found positive only if it is. Its least value over c² is near zero, relative to its
// terms: (ac + b/c - m)² + (x√c - y/√c)² + rest, with m = ac + b/c and y = xc at a random c. If the
// rest is half of the terms, it mostly is found.
PW85_TEST("/penetration/quartic")
{
    Failures failures;
    Random random(798);
    int clear = 0, found = 0;
    for (int n = 0; n < draws(80000); ++n) {
        double const c = random.log_uniform(1e-3, 1e3), a = random.log_uniform(1e-3, 1e3),
                     b = random.log_uniform(1e-3, 1e3), m = a * c + b / c,
                     x = random.sign() < 0.0 ? 0.0 : a * m * random.log_uniform(1e-3, 10.0);
        double const size = m * m + x * c,
                     rest = random.sign() * size * random.log_uniform(1e-16, 1.0);
        double const k[5] = {b * b, x * c * c - 2.0 * b * m,
                             m * m + 2.0 * a * b - 2.0 * x * c + rest, x - 2.0 * a * m, a * a};
        Wide value = Wide(k[4]);
        for (int i = 3; i >= 0; --i) value = value * Wide(c) + Wide(k[i]);
        bool const positive = pw85::detail::is_positive(k);
        auto const text = [&] { return hex_text(k, 5) + ", c = " + hex_text(&c, 1); };
        failures.check(!positive || value > 0, "positive", static_cast<double>(value), 0.0, text);
        if (!(rest >= 0.5 * size)) continue;
        ++clear;
        found += positive;
    }
    g_assert_cmpint(clear, >, draws(400));
    g_assert_cmpint(100 * found, >, 95 * clear);
}

// The ellipse of R is found inside of the sum of those of B1 and B2 only if it is, in all of 256
// directions and near the worst of them. If there are two per cent to spare, it mostly is found.
PW85_TEST("/penetration/inside_sum")
{
    Failures failures;
    Random random(799);
    int inside = 0, found = 0;
    for (int n = 0; n < draws(8000); ++n) {
        auto const form = [&] { return random_form<2>(random, 1.0, random.log_uniform(1.0, 1e3)); };
        auto const b1 = form(), b2 = random.log_uniform(1e-2, 1e2) * form();
        auto r = form();
        auto const ratio = [&](double angle) {
            pw85::Vector<double, 2> const t{std::cos(angle), std::sin(angle)};
            auto const extent = [&](auto const &q) {
                return std::sqrt(pw85::detail::quadratic_form(q, t));
            };
            return (extent(b1) + extent(b2)) / extent(r);
        };
        double worst = 0.0, step = std::numbers::pi / 256;
        for (int k = 1; k < 256; ++k)
            if (ratio(k * step) < ratio(worst)) worst = k * step;
        for (; step > 1e-9; step *= 0.5)
            for (double const at : {worst - step, worst + step})
                if (ratio(at) < ratio(worst)) worst = at;
        double const spare = random.sign() * random.log_uniform(1e-12, 1.0),
                     factor = ratio(worst) * (1.0 - 0.5 * spare);
        r = factor * factor * r;
        bool const is_inside = is_inside_sum(pw85::detail::CertificateForms<double, 2>{b1, b2, r});
        double const worst_ratio = ratio(worst);
        failures.check(!is_inside || worst_ratio >= 1.0 - 1e-13, "inside", worst_ratio, 1.0, [&] {
            return hex_text(b1.entries, 3) + hex_text(b2.entries, 3) + hex_text(r.entries, 3);
        });
        if (worst_ratio < 1.02) continue;
        ++inside;
        found += is_inside;
    }
    g_assert_cmpint(inside, >, draws(200));
    g_assert_cmpint(100 * found, >, 98 * inside);
}

// step_below() finds a direction that needs less wherever it says so, from some of the minima that
// are not global.
PW85_TEST("/penetration/step_below")
{
    Failures failures;
    Random random(800);
    int steps = 0;
    for (int n = 0; n < draws(8000); ++n) {
        auto const s = overlapping_pair<3>(random, 1e3);
        auto search = search_of(s);
        follow(search, random.direction<3>());
        double const level = search.best.length;
        if (!step_below(search)) continue;
        ++steps;
        double const here = shift(s, search.direction);
        failures.check(here < level, "below", here, level, [&] { return hex_text(s); });
    }
    g_assert_cmpint(steps, >, draws(80));
}

PW85_TEST("/penetration/statuses")
{
    double const r12[3] = {1.0, 0.0, 0.0}, apart[3] = {9.0, 0.0, 0.0},
                 q[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    auto const expect = [&](double const *r, double depth) {
        double found = 7.0, direction[3] = {7.0, 7.0, 7.0};
        g_assert_cmpint(pw85_penetration(r, q, q, &found, direction), ==, PW85_SUCCESS);
        g_assert_cmpfloat(found, ==, depth);
        for (double const x : direction) g_assert_true(std::isnan(x) == !(depth > 0.0));
    };
    expect(r12, 1.0);
    expect(apart, 0.0);
}

} // namespace
