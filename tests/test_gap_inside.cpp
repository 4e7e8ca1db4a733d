// SPDX-License-Identifier: BSD-3-Clause
// The least gap of an ellipsoid inside another one, against distances of points of both outlines
// (in the plane) and directions (in space) in 50 digits, closed forms, and exact containment.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

/// In double by the C API.
template <int D> pw85::GapInside<double, D> gap_inside(Sample<double, D> const &p)
{
    pw85::GapInside<double, D> result{};
    result.status = static_cast<pw85::Status>((D == 3 ? pw85_gap_inside : pw85_gap_inside_2d)(
        p.r12.coordinates, p.q1.entries, p.q2.entries, &result.gap, result.point1.coordinates,
        result.point2.coordinates, result.normal.coordinates));
    return result;
}

template <int D> bool contains(Sample<double, D> const &p)
{
    int inside = -1;
    (D == 3 ? pw85_contains : pw85_contains_2d)(p.r12.coordinates, p.q1.entries, p.q2.entries,
                                                &inside);
    return inside == 1;
}

/// A lower triangular L with Q = LLᵀ.
template <class T, int D> struct Root {
    T entries[std::size_t(D)][std::size_t(D)];

    explicit Root(pw85::SymmetricMatrix<T, D> const &q) : entries{}
    {
        for (int j = 0; j < D; ++j)
            for (int i = j; i < D; ++i) {
                T sum = q(i, j);
                for (int k = 0; k < j; ++k) sum -= entries[i][k] * entries[j][k];
                if (i == j)
                    entries[i][i] = sqrt(sum);
                else
                    entries[i][j] = sum / entries[j][j];
            }
    }
};

/// The squared distance of two points of the outlines of ellipses, by angles.
template <class T> struct OutlineDistance {
    Root<T, 2> root1, root2;
    pw85::Vector<T, 2> r12;

    explicit OutlineDistance(Sample<T, 2> const &p) : root1(p.q1), root2(p.q2), r12(p.r12) {}

    T operator()(T const (&angles)[2]) const
    {
        using std::cos, std::sin;
        T const c1 = cos(angles[0]), s1 = sin(angles[0]), c2 = cos(angles[1]), s2 = sin(angles[1]);
        auto const &a = root1.entries, &b = root2.entries;
        T const x = a[0][0] * c1 - (r12[0] + b[0][0] * c2),
                y = a[1][0] * c1 + a[1][1] * s1 - (r12[1] + b[1][0] * c2 + b[1][1] * s2);
        return x * x + y * y;
    }
};

/// The gap along a direction, by the angles of a unit vector w with n = L1⁻ᵀw. In the plane the
/// second angle counts, and the first one is best at 1.
template <class T, int D> struct GapAlong {
    Root<T, D> root1;
    Sample<T, D> p;

    explicit GapAlong(Sample<T, D> const &pair) : root1(pair.q1), p(pair) {}

    T operator()(T const (&angles)[2]) const
    {
        using std::cos, std::sin, std::sqrt;
        T const ring = D == 2 ? T(1) : T(sin(angles[0])),
                height = D == 2 ? T(0) : T(cos(angles[0])), off = D == 2 ? T(angles[0] - 1) : T(0);
        T const w[3] = {ring * cos(angles[1]), ring * sin(angles[1]), height};
        T n[std::size_t(D)], square = 0, along = 0, form = 0;
        for (int i = D - 1; i >= 0; --i) {
            n[i] = w[i];
            for (int k = i + 1; k < D; ++k) n[i] -= root1.entries[k][i] * n[k];
            n[i] /= root1.entries[i][i];
        }
        for (int i = 0; i < D; ++i) {
            square += n[i] * n[i];
            along += n[i] * p.r12[i];
            for (int j = 0; j < D; ++j) form += n[i] * p.q2(i, j) * n[j];
        }
        return (1 - sqrt(form) - along) / sqrt(square) + off * off;
    }
};

/// Newton's method on differences, with steps that must go down.
template <class Function> Wide minimize(Function const &f, double x0, double y0)
{
    Wide const h("1e-12");
    Wide at[2] = {Wide(x0), Wide(y0)}, value = f(at);
    auto const beside = [&](int i, int j) {
        Wide const x[2] = {at[0] + i * h, at[1] + j * h};
        return f(x);
    };
    for (int step = 0; step < 60; ++step) {
        Wide const e = beside(1, 0), w = beside(-1, 0), n = beside(0, 1), s = beside(0, -1);
        Wide const gx = (e - w) / (2 * h), gy = (n - s) / (2 * h);
        Wide xx = (e + w - 2 * value) / (h * h), yy = (n + s - 2 * value) / (h * h);
        Wide const xy =
            (beside(1, 1) + beside(-1, -1) - beside(1, -1) - beside(-1, 1)) / (4 * h * h);
        if (!(xx > 0 && xx * yy > xy * xy)) {
            Wide const lift = abs(xx) + abs(yy) + 2 * abs(xy);
            xx += lift;
            yy += lift;
        }
        Wide const det = xx * yy - xy * xy;
        Wide dx = (yy * gx - xy * gy) / det, dy = (xx * gy - xy * gx) / det;
        bool lower = false;
        for (int k = 0; k < 40 && !lower; ++k, dx /= 2, dy /= 2) {
            Wide const next[2] = {at[0] - dx, at[1] - dy}, there = f(next);
            if (!(there < value)) continue;
            at[0] = next[0];
            at[1] = next[1];
            value = there;
            lower = true;
        }
        if (!lower) break;
    }
    return value;
}

/// The least value of a function of two angles: Newton's method from the lowest minima of a grid,
/// which is periodic in the second angle, and in the first one if it goes all around.
template <class Function, class WideFunction> Wide
global_minimum(Function const &f, WideFunction const &wide, int rows, int columns, double range)
{
    double const turn = 2 * std::numbers::pi;
    std::vector<double> values;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            double const angles[2] = {range * (i + 0.5) / rows, turn * j / columns};
            values.push_back(f(angles));
        }
    bool const around = range > 4;
    auto const value = [&](int i, int j) {
        if (around)
            i = (i + rows) % rows;
        else if (i < 0 || i >= rows)
            return std::numeric_limits<double>::infinity();
        return values[std::size_t(i * columns + (j + columns) % columns)];
    };
    std::vector<std::pair<double, int>> minima;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            bool least = true;
            for (int k = 0; k < 9; ++k)
                least &= !(value(i + k / 3 - 1, j + k % 3 - 1) < value(i, j));
            if (least) minima.emplace_back(value(i, j), i * columns + j);
        }
    std::sort(minima.begin(), minima.end());
    Wide best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < std::min<std::size_t>(6, minima.size()); ++k) {
        int const i = minima[k].second / columns, j = minima[k].second % columns;
        Wide const found = minimize(wide, range * (i + 0.5) / rows, turn * j / columns);
        if (found < best) best = found;
    }
    return best;
}

/// By points of both curves.
Wide gap_of_points(Sample<double, 2> const &p)
{
    return sqrt(global_minimum(OutlineDistance<double>(p), OutlineDistance<Wide>(convert<Wide>(p)),
                               240, 240, 2 * std::numbers::pi));
}

/// By directions.
template <int D> Wide gap_of_directions(Sample<double, D> const &p)
{
    return global_minimum(GapAlong<double, D>(p), GapAlong<Wide, D>(convert<Wide>(p)),
                          D == 2 ? 1 : 60, D == 2 ? 4000 : 120, D == 2 ? 2 : std::numbers::pi);
}

/// The bound of the contract, 128 u α (1 + α/β).
template <int D> double bound_of(Sample<double, D> const &p, pw85::Vector<double, D> const &normal)
{
    auto const wide = convert<Wide>(p);
    auto const n = convert<Wide>(normal);
    double const a = std::sqrt(static_cast<double>(pw85::detail::quadratic_form(wide.q1, n))),
                 b = std::sqrt(static_cast<double>(pw85::detail::quadratic_form(wide.q2, n)));
    return 128 * u * a * (1 + a / b);
}

/// A pair with ellipse or ellipsoid 2 inside, near to the surface as often as in the middle.
template <int D> Sample<double, D> nested_pair(Random &random, double aspect)
{
    Sample<double, D> p{};
    p.q1 = random_form<D>(random, random.uniform(1.0, 2.0), random.log_uniform(1.0, aspect));
    p.q2 = random_form<D>(random, random.uniform(1.0, 2.0), random.log_uniform(1.0, aspect));
    double mu2;
    pw85::Vector<double, D> const zero{};
    (D == 3 ? pw85_containment : pw85_containment_2d)(zero.coordinates, p.q1.entries, p.q2.entries,
                                                      &mu2, nullptr);
    double const share = random.uniform(0.05, 0.99);
    p.q2 = (share * share / mu2) * p.q2;
    auto const direction = random.direction<D>();
    double lower = 0, upper = 4;
    while (upper - lower > 1e-12 * upper) {
        double const middle = 0.5 * (lower + upper);
        p.r12 = middle * direction;
        (contains(p) ? lower : upper) = middle;
        if (upper < 1e-9) break;
    }
    p.r12 =
        (lower * std::pow(random.uniform(0.0, 1.0), random.sign() < 0 ? 1.0 : 0.01)) * direction;
    return p;
}

template <int D, class TrueGap> void check_truth(int pairs, double aspect, TrueGap const &truth)
{
    Failures failures;
    Random random(7400 + D);
    for (int n = 0; n < pairs; ++n) {
        auto const p = nested_pair<D>(random, aspect);
        auto const text = [&] { return hex_text(p); };
        auto const found = gap_inside(p);
        double const exact = static_cast<double>(truth(p));
        if (!failures.check(found.status == pw85::Status::success, "status",
                            static_cast<double>(found.status), 0, text))
            continue;
        double const bound = bound_of(p, found.normal);
        failures.check(std::fabs(found.gap - exact) <= bound, "gap", found.gap, exact, text);
        // It is the value along the normal, to a few roundings.
        auto const wide = convert<Wide>(p);
        auto const normal = convert<Wide>(found.normal);
        Wide const length = sqrt(pw85::dot(normal, normal));
        Wide const along =
            (sqrt(pw85::detail::quadratic_form(wide.q1, normal)) -
             sqrt(pw85::detail::quadratic_form(wide.q2, normal)) - pw85::dot(normal, wide.r12)) /
            length;
        failures.check(std::fabs(static_cast<double>(length) - 1) <= 2 * u, "unit",
                       static_cast<double>(length), 1, text);
        failures.check(std::fabs(found.gap - static_cast<double>(along)) <= bound / 16,
                       "gap along the normal", found.gap, static_cast<double>(along), text);
    }
}

PW85_TEST("/gap_inside/truth")
{
    check_truth<2>(draws(400), 10.0, gap_of_points);
    check_truth<2>(draws(800), 1e3, gap_of_directions<2>);
    check_truth<3>(draws(400), 1e3, gap_of_directions<3>);
}

// Moved by less than the gap in any direction, ellipsoid 2 stays inside; moved by more along the
// normal, it does not: decided in integers.
template <int D> void check_room(int pairs, double aspect)
{
    Failures failures;
    Random random(7500 + D);
    for (int n = 0; n < pairs; ++n) {
        auto const p = nested_pair<D>(random, aspect);
        auto const text = [&] { return hex_text(p); };
        auto const found = gap_inside(p);
        double const bound = bound_of(p, found.normal), rounding = 8 * u * 2;
        auto moved = p;
        for (int k = 0; k < 40; ++k) {
            auto const direction = k < D ? random.direction<D>() : found.normal;
            auto const turned = k < D ? direction : random.direction<D>();
            double const mix = k < D ? 0 : std::exp2(-k);
            auto way = direction;
            for (int i = 0; i < D; ++i) way[i] += mix * turned[i];
            double const length = std::sqrt(pw85::dot(way, way));
            for (int i = 0; i < D; ++i)
                moved.r12[i] =
                    p.r12[i] + std::max(0.0, found.gap - bound - rounding) / length * way[i];
            failures.check(contains(moved), "moved by less", found.gap, bound, text);
        }
        for (int i = 0; i < D; ++i)
            moved.r12[i] = p.r12[i] + (found.gap + bound + rounding) * found.normal[i];
        failures.check(!contains(moved), "moved by more", found.gap, bound, text);
    }
}

PW85_TEST("/gap_inside/room")
{
    check_room<2>(draws(2000), 1e3);
    check_room<3>(draws(1000), 1e3);
}

// A cap around a local minimum, which need not be the global one, has no smaller values.
template <int D> void check_caps(int pairs)
{
    namespace detail = pw85::detail;
    Failures failures;
    Random random(7700 + D);
    for (int n = 0; n < pairs; ++n) {
        auto const p = nested_pair<D>(random, n % 2 == 0 ? 10.0 : 1e3);
        auto const axes = detail::principal_axes(detail::converted<detail::Finer<double>>(p.q1));
        detail::GapProof<double, D> proof{
            detail::gap_frame(p.r12, p.q2, axes), {}, 0.0, {}, {}, 0, 0};
        proof.best =
            detail::descend_gap(proof.frame, detail::gap_state(proof.frame, random.direction<D>()));
        proof.rounding = detail::gap_rounding(proof.frame, proof.best);
        detail::add_cap(proof, proof.best);
        double const level = detail::gap_level(proof);
        auto const text = [&] { return hex_text(p); };
        for (int k = 0; k < 200 * proof.num_caps; ++k) {
            auto const &cap = proof.caps[0];
            auto const t = detail::project(random.direction<D>(), cap.m);
            double const length = cap.radius * std::sqrt(random.uniform(0.0, 1.0));
            auto const m = detail::add_scaled(cap.m, length / detail::magnitude(t), t);
            auto const state = detail::gap_state(proof.frame, detail::unit_along(m));
            failures.check(state.gap >= level - proof.rounding, "value in a cap", state.gap, level,
                           text);
        }
    }
}

// A cell on which any level is proved has no smaller values.
template <int D> void check_cells(int pairs)
{
    namespace detail = pw85::detail;
    Failures failures;
    Random random(7800 + D);
    long proved = 0;
    for (int n = 0; n < pairs; ++n) {
        auto const p = nested_pair<D>(random, n % 2 == 0 ? 10.0 : 1e3);
        auto const axes = detail::principal_axes(detail::converted<detail::Finer<double>>(p.q1));
        auto const frame = detail::gap_frame(p.r12, p.q2, axes);
        auto const center = random.direction<D>();
        double const size = random.log_uniform(1e-3, 1.0);
        detail::GapCell<double, D> cell{};
        pw85::Vector<double, D> sum{};
        for (auto &corner : cell.corners) {
            corner = detail::unit_along(detail::add_scaled(center, size, random.direction<D>()));
            sum = sum + corner;
        }
        auto const middle = detail::gap_state(frame, detail::unit_along(sum));
        double const level = middle.gap * (1 - random.log_uniform(1e-6, 0.5));
        if (!(level > 0) || !detail::is_proved_on(frame, middle, cell, level)) continue;
        ++proved;
        auto const text = [&] { return hex_text(p); };
        for (int k = 0; k < 100; ++k) {
            pw85::Vector<double, D> m{};
            for (auto const &corner : cell.corners)
                m = detail::add_scaled(m, random.log_uniform(1e-3, 1.0), corner);
            auto const state = detail::gap_state(frame, detail::unit_along(m));
            failures.check(state.gap >= level - detail::gap_rounding(frame, state),
                           "value on a cell", state.gap, level, text);
        }
    }
    g_assert_cmpint(proved, >, pairs / 8);
}

PW85_TEST("/gap_inside/cells")
{
    check_cells<2>(draws(4000));
    check_cells<3>(draws(4000));
}

PW85_TEST("/gap_inside/caps")
{
    check_caps<2>(draws(2000));
    check_caps<3>(draws(2000));
}

pw85::SymmetricMatrix<double, 3> form(double a, double b, double c)
{
    return {a * a, 0, 0, b * b, 0, c * c};
}

void check(char const *what, Sample<double, 3> const &p, double gap, double tolerance,
           double size = 1)
{
    auto const found = gap_inside(p);
    g_assert_true(found.status == pw85::Status::success);
    if (!(std::fabs(found.gap - gap) <= tolerance))
        g_test_fail_printf("%s: %a, expected %a; %s", what, found.gap, gap, hex_text(p).c_str());
    double between = 0;
    for (int i = 0; i < 3; ++i) between += std::pow(found.point1[i] - found.point2[i], 2);
    if (!(std::fabs(std::sqrt(between) - found.gap) <= 1e-7 * size))
        g_test_fail_printf("%s: the points have the distance %a; %s", what, std::sqrt(between),
                           hex_text(p).c_str());
}

// Numbers from known geometry. Minima on circles, and on the curve of the last pair, are not
// isolated.
PW85_TEST("/gap_inside/closed_forms")
{
    double const close = 16 * u;
    check("balls", {{0.25, -0.5, 0.5}, form(3, 3, 3), form(1, 1, 1)}, 1.25, close);
    check("concentric balls", {{}, form(3, 3, 3), form(1, 1, 1)}, 2, close);
    check("near balls", {{}, form(1, 1, 1), form(1 - 0x1p-30, 1 - 0x1p-30, 1 - 0x1p-30)}, 0x1p-30,
          close);
    check("ball in the middle", {{}, form(3, 2, 5), form(1, 1, 1)}, 1, close);
    check("similar", {{}, form(3, 2, 5), form(1.5, 1, 2.5)}, 1, close);
    check("in a ball", {{}, form(3, 3, 3), form(1, 2, 0.5)}, 1, close);
    // The centre of curvature of the vertex is at 2 - 1/2 for the semi-axes 2 and 1.
    check("at the centre of curvature", {{1.5, 0, 0}, form(2, 1, 1), form(0.125, 0.125, 0.125)},
          0.375, close);
    check("ball in a needle", {{}, form(1, 1, 1000), form(0.5, 0.5, 0.5)}, 0.5, close);
    // β² = b gives α² = x b + y, and √(x b + y) - √b is least, √(y (x - 1)/x), at
    // b = y/(x (x - 1)).
    double const x = 1.25, y = 2;
    Sample<double, 3> const curve{
        {}, {x * 1 + y, 0, 0, x * 80 + y, 0, x * 9 + y}, {1, 0, 0, 80, 0, 9}};
    check("on a curve", curve, std::sqrt(y * (x - 1) / x), close);
}

/// The ellipsoid with the semi-axes 3a, 3b, 3c, turned by a matrix of thirds, which is exact.
pw85::SymmetricMatrix<double, 3> turned_form(double a, double b, double c)
{
    double const axes[3][3] = {{1, 2, 2}, {2, 1, -2}, {2, -2, 1}},
                 squares[] = {a * a, b * b, c * c};
    pw85::SymmetricMatrix<double, 3> q{};
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) q(i, j) += squares[k] * axes[i][k] * axes[j][k];
    return q;
}

/// Concentric ellipsoids that touch where no axis of the outer one is: two of its axes are equal.
/// Another minimum is found first.
PW85_TEST("/gap_inside/touching_on_a_circle")
{
    for (double const size : {0x1p-40, 1.0, 0x1p40})
        for (int turn = 0; turn < 3; ++turn) {
            double a[] = {9, 9, 4}, b[] = {9, 2, 3};
            std::rotate(a, a + turn, a + 3);
            std::rotate(b, b + turn, b + 3);
            double const s2 = size * size;
            check("touching on a circle",
                  {{}, s2 * turned_form(a[0], a[1], a[2]), s2 * turned_form(b[0], b[1], b[2])}, 0,
                  16 * u * 27 * size, size);
        }
}

/// The number that users of another program found in the plane, by the distance of the curves: 25
/// by 30 around 10 by 8 at (-10, 10).
PW85_TEST("/gap_inside/published")
{
    Sample<double, 2> const p{{-10, 10}, {625, 0, 900}, {100, 0, 64}};
    auto const found = gap_inside(p);
    g_assert_cmpfloat_with_epsilon(found.gap, 2.99197, 5e-6);
    g_assert_cmpfloat_with_epsilon(found.gap, static_cast<double>(gap_of_points(p)), 64 * u * 25);
}

// Touching from inside, by numbers for which that is exact, and what is not inside.
PW85_TEST("/gap_inside/decision")
{
    for (double const size : {0x1p-40, 1.0, 0x1p40}) {
        double const s2 = size * size;
        Sample<double, 3> p{{size, 0, 0}, s2 * form(2, 3, 3), s2 * form(1, 1, 1)};
        auto found = gap_inside(p);
        g_assert_true(found.status == pw85::Status::success);
        g_assert_cmpfloat(found.gap, ==, 0);
        g_assert_cmpfloat(found.normal[0], ==, 1);
        g_assert_cmpfloat(found.point1[0], ==, 2 * size);
        g_assert_cmpfloat(found.point2[0], ==, 2 * size);
        p.r12[0] = std::nextafter(size, 2 * size);
        found = gap_inside(p);
        g_assert_true(found.status == pw85::Status::success);
        g_assert_cmpfloat(found.gap, ==, 0);
        g_assert_true(std::isnan(found.normal[0]) && std::isnan(found.point1[1]) &&
                      std::isnan(found.point2[2]));
        p.q2 = p.q1;
        p.r12 = {};
        g_assert_cmpfloat(gap_inside(p).gap, ==, 0);
        g_assert_false(std::isnan(gap_inside(p).normal[0]));
    }
    Sample<double, 2> bad{{0, 0}, {4, 0, 4}, {1, 2, 1}};
    g_assert_true(gap_inside(bad).status == pw85::Status::not_positive_definite);
    bad.r12[0] = std::numeric_limits<double>::quiet_NaN();
    g_assert_true(gap_inside(bad).status == pw85::Status::invalid_argument);
    g_assert_true(std::isnan(gap_inside(bad).gap));
}

// Powers of two change no bit, and neither does any size of ellipsoid 2 that is far below rounding.
template <int D> void check_scales(int pairs)
{
    Failures failures;
    Random random(7600 + D);
    for (int n = 0; n < pairs; ++n) {
        auto const p = nested_pair<D>(random, 1e3);
        auto const text = [&] { return hex_text(p); };
        auto const found = gap_inside(p);
        for (int e : {-400, -40, 40, 400}) {
            double const unit = std::exp2(e);
            auto const scaled = gap_inside(
                Sample<double, D>{unit * p.r12, (unit * unit) * p.q1, (unit * unit) * p.q2});
            failures.check(scaled.gap == unit * found.gap, "scaled", scaled.gap, unit * found.gap,
                           text);
            for (int i = 0; i < D; ++i) {
                failures.check(scaled.point2[i] == unit * found.point2[i], "scaled point",
                               scaled.point2[i], unit * found.point2[i], text);
                failures.check(scaled.normal[i] == found.normal[i], "normal", scaled.normal[i],
                               found.normal[i], text);
            }
        }
        auto tiny = p;
        tiny.q2 = 0x1p-900 * tiny.q2;
        auto smaller = p;
        smaller.q2 = 0x1p-300 * smaller.q2;
        double const expected = gap_inside(smaller).gap;
        failures.check(std::fabs(gap_inside(tiny).gap - expected) <= 64 * u * expected, "tiny",
                       gap_inside(tiny).gap, expected, text);
    }
}

PW85_TEST("/gap_inside/scales")
{
    check_scales<2>(draws(400));
    check_scales<3>(draws(400));
}

} // namespace
