// SPDX-License-Identifier: BSD-3-Clause
// Tests of walls, points and lines (include/pw85/distance/walls.hpp, nearest.hpp, line.hpp).
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

std::string text(Vector3 const &x, Form3 const &q)
{
    return "x = " + hex_text(x.coordinates, 3) + ", q = " + hex_text(q.entries, 6);
}

/// Σ|n_i q_ij n_j|/(2α).
Wide width_sensitivity(WideForm const &q, WideVector const &n)
{
    return absolute_form(q, n) / (2 * pw85::detail::support(q, n).extent);
}

Wide absolute_dot(WideVector const &x, WideVector const &y)
{
    Wide sum = 0;
    for (int i = 0; i < 3; ++i) sum += abs(x[i] * y[i]);
    return sum;
}

Form3 random_form_of_any_size(Random &random)
{
    return random.form(random.log_uniform(1e-100, 1e100), random.log_uniform(1.0, 1e4));
}

double size_of(Form3 const &q) { return std::sqrt(q[0] + q[3] + q[5]); }

// (offset - α)/|n| in the wide type; the sign agrees with μ² < 1.
PW85_TEST("/walls/plane")
{
    Failures failures;
    Random random(500);
    for (int n = 0; n < draws(20000); ++n) {
        auto const q = random_form_of_any_size(random);
        double const length = random.log_uniform(1e-100, 1e100);
        auto const normal = length * random.direction<3>();
        double const offset = length * size_of(q) * random.uniform(-1.0, 3.0);
        double distance, mu2;
        Vector3 point{}, touching{};
        pw85_distance_plane(normal.coordinates, offset, q.entries, &distance, point.coordinates);
        pw85_contact_plane(normal.coordinates, offset, q.entries, &mu2, touching.coordinates);
        auto const w = convert<Wide>(q);
        auto const v = convert<Wide>(normal);
        Wide const l = norm(v);
        auto const unit = Wide(1 / l) * v;
        auto const s = pw85::detail::support(w, unit);
        Wide const exact = offset / l - s.extent,
                   bound = 8 * u * (abs(Wide(offset / l)) + width_sensitivity(w, unit));
        auto const inputs = [&] { return text(normal, q) + ", offset = " + hex_text(&offset, 1); };
        failures.check(abs(Wide(distance - exact)) <= bound, "distance", distance,
                       static_cast<double>(exact), inputs);
        Wide const mu = offset > 0 ? Wide(offset / l / s.extent) : Wide(0);
        // Half-width and offset each err by half of 8 u of their terms, and μ² by twice that of
        // their ratio.
        Wide const mu2_bound = 8 * u * (1 + width_sensitivity(w, unit) / s.extent) * mu * mu;
        failures.check(abs(Wide(mu2 - mu * mu)) <= mu2_bound, "mu2", mu2,
                       static_cast<double>(Wide(mu * mu)), inputs);
        for (int i = 0; i < 3; ++i) {
            Wide const error =
                16 * u * absolute_form(w, unit) / s.extent / s.extent * norm(s.point);
            failures.check(abs(Wide(point[i] - s.point[i])) <= error, "point", point[i],
                           static_cast<double>(s.point[i]), inputs);
            failures.check(abs(Wide(touching[i] - mu * s.point[i])) <= 2 * error * mu,
                           "touching point", touching[i],
                           static_cast<double>(Wide(mu * s.point[i])), inputs);
        }
        failures.check((distance < 0) == (mu2 < 1) || abs(exact) <= 2 * bound, "sign", distance,
                       mu2, inputs);
    }
}

// Differences in the wide type: h = 1e-15 leaves 1e-30.
PW85_TEST("/walls/plane/derivatives")
{
    Failures failures;
    Random random(510);
    Wide const h("1e-15");
    for (int n = 0; n < 200; ++n) {
        auto const q = random.form(1.0, 4.0);
        auto const normal = random.uniform(0.5, 2.0) * random.direction<3>();
        Vector3 d_center{}, d_rot{};
        pw85_distance_plane_derivatives(normal.coordinates, q.entries, d_center.coordinates,
                                        d_rot.coordinates);
        auto const w = convert<Wide>(q);
        auto const v = convert<Wide>(normal);
        for (int i = 0; i < 3; ++i) {
            auto const at = [&](int sign) {
                WideVector omega{};
                omega[i] = sign * h;
                return pw85::distance_plane(v, Wide(1), rotated(w, omega)).distance;
            };
            double const turned = static_cast<double>(Wide((at(1) - at(-1)) / (2 * h)));
            double const moved = static_cast<double>(Wide(-v[i] / norm(v)));
            failures.check(std::fabs(d_rot[i] - turned) <= 256 * u, "d_rot", d_rot[i], turned,
                           [&] { return text(normal, q); });
            failures.check(std::fabs(d_center[i] - moved) <= 4 * u, "d_center", d_center[i], moved,
                           [&] { return text(normal, q); });
        }
    }
}

// The same for μ², whose factors 2μ/α and 2μ²/α have the relative errors of two half-widths, 16 u
// of their terms with the rounding of products; and the nearest point of 16 u more.
PW85_TEST("/walls/plane/contact_derivatives")
{
    Failures failures;
    Random random(511);
    Wide const h("1e-15");
    for (int n = 0; n < 200; ++n) {
        auto const q = random.form(1.0, 4.0);
        auto const normal = random.uniform(0.5, 2.0) * random.direction<3>();
        double const offset = random.uniform(-1.0, 3.0);
        Vector3 d_center{}, d_rot{};
        pw85_contact_plane_derivatives(normal.coordinates, offset, q.entries, d_center.coordinates,
                                       d_rot.coordinates);
        auto const w = convert<Wide>(q);
        auto const v = convert<Wide>(normal);
        auto const s = pw85::detail::support(w, v);
        Wide const mu = offset > 0 ? Wide(offset / s.extent) : Wide(0);
        Wide const error =
            32 * u * (1 + absolute_form(w, v) / s.extent / s.extent) * 2 * mu * norm(v) / s.extent;
        auto const inputs = [&] { return text(normal, q) + ", offset = " + hex_text(&offset, 1); };
        for (int i = 0; i < 3; ++i) {
            auto const turned = [&](int sign) {
                WideVector omega{};
                omega[i] = sign * h;
                return pw85::contact_plane(v, Wide(offset), rotated(w, omega)).mu2;
            };
            auto const moved = [&](int sign) {
                return pw85::contact_plane(v, Wide(offset - sign * h * v[i]), w).mu2;
            };
            Wide const rotation = (turned(1) - turned(-1)) / (2 * h),
                       center = (moved(1) - moved(-1)) / (2 * h);
            failures.check(abs(Wide(d_rot[i] - rotation)) <= error * mu * norm(s.point), "d_rot",
                           d_rot[i], static_cast<double>(rotation), inputs);
            failures.check(abs(Wide(d_center[i] - center)) <= error, "d_center", d_center[i],
                           static_cast<double>(center), inputs);
        }
    }
}

/// Whether a symmetric matrix is positive semidefinite up to rounding of the wide type, `scale`
/// being its size.
bool is_semidefinite(WideForm a, Wide const &scale)
{
    for (int i = 0; i < 3; ++i) a(i, i) += scale * Wide("1e-30");
    auto const f = pw85::detail::factorize(a, Wide(0));
    return f.pivots[0] > 0 && f.pivots[1] > 0 && f.pivots[2] > 0;
}

/// A point: outside, inside, near a plane of symmetry of the ellipsoid or in it, near the surface,
/// near the centre.
Vector3 random_point(Random &random, Form3 const &q, int kind)
{
    auto const direction = random.direction<3>();
    double const size = size_of(q);
    auto const s = pw85::detail::support(q, direction);
    switch (kind % 4) {
    case 0:
        return size * random.log_uniform(1e-3, 1e3) * direction;
    case 1:
        return random.uniform(0.0, 1.0) * s.point;
    case 2:
        return (1.0 + random.uniform(-1e-10, 1e-10)) * s.point;
    default:
        return size * random.log_uniform(1e-100, 1.0) * direction;
    }
}

// nearest.hpp, item 1: with r - p = s Q⁻¹p, p on the surface, p is a nearest point if Q + s I is
// semidefinite: for x on the surface |x - r|² - |p - r|² = (x - p)ᵀ(I + s Q⁻¹)(x - p).
void test_point_optimality()
{
    Failures failures;
    Random random(520);
    for (int n = 0; n < draws(2000); ++n) {
        auto q = random.form(1.0, random.log_uniform(1.0, 1e3));
        if (n % 5 == 0) q[1] = q[2] = q[4] = 0.0; // points in planes of symmetry follow
        auto r = random_point(random, q, n);
        if (n % 3 == 0) r[n % 2] = 0.0;
        auto const w = convert<Wide>(q);
        auto const x = convert<Wide>(r);
        auto const d = pw85::distance_point(x, w);
        auto const gradient = pw85::detail::solve(pw85::detail::factorize(w, Wide(0)), d.point);
        Wide const s = d.distance / norm(gradient);
        Wide residual = abs(Wide(pw85::dot(gradient, d.point) - 1));
        for (int i = 0; i < 3; ++i) residual += abs(Wide(x[i] - d.point[i] - s * gradient[i]));
        WideForm shifted = w;
        for (int i = 0; i < 3; ++i) shifted(i, i) += s;
        failures.check(residual <= 1e-35, "residual", static_cast<double>(residual), 1e-35,
                       [&] { return text(r, q); });
        failures.check(is_semidefinite(shifted, 1), "nearest of all",
                       static_cast<double>(d.distance), 0.0, [&] { return text(r, q); });
    }
}

// In double, of any size. Normals of double precision: the value is stationary, so that their error
// counts squared.
PW85_TEST("/walls/point/rounding_errors")
{
    Failures failures;
    Random random(530);
    for (int n = 0; n < draws(10000); ++n) {
        auto const q = random_form_of_any_size(random);
        auto const r = random_point(random, q, n);
        double distance;
        Vector3 point{}, normal{};
        pw85_distance_point(r.coordinates, q.entries, &distance, point.coordinates,
                            normal.coordinates);
        auto const w = convert<Wide>(q);
        auto const x = convert<Wide>(r);
        auto const exact = pw85::distance_point(x, w);
        Wide const bound =
            8 * u * (absolute_dot(exact.normal, x) + width_sensitivity(w, exact.normal));
        failures.check(abs(Wide(distance - exact.distance)) <= bound, "distance", distance,
                       static_cast<double>(exact.distance), [&] { return text(r, q); });
        failures.check(std::fabs(norm(normal) - 1.0) <= 4 * u, "normal", norm(normal), 1.0,
                       [&] { return text(r, q); });
        // The point is on the surface, its distance from r is that which is given, but for the
        // error of the normal.
        auto const p = convert<Wide>(point);
        Wide const form = pw85::dot(p, pw85::detail::solve(pw85::detail::factorize(w, Wide(0)), p));
        failures.check(abs(Wide(form - 1)) <= 1e-6, "on the surface", static_cast<double>(form),
                       1.0, [&] { return text(r, q); });
    }
}

void assert_close(double actual, double expected, double tolerance)
{
    g_assert_cmpfloat(std::fabs(actual - expected), <=, tolerance);
}

// The centre, points of the axes inside and outside, and beyond the evolute, where the nearest
// point leaves the axis.
PW85_TEST("/walls/point/by_hand")
{
    double const q[6] = {9.0, 0.0, 0.0, 4.0, 0.0, 1.0};
    auto const distance = [&](double x, double y, double z) {
        double const r[3] = {x, y, z};
        double d;
        g_assert_cmpint(pw85_distance_point(r, q, &d, nullptr, nullptr), ==, PW85_SUCCESS);
        return d;
    };
    assert_close(distance(0.0, 0.0, 0.0), -1.0, 8 * u);
    assert_close(distance(0.0, 0.0, 0.5), -0.5, 8 * u);
    assert_close(distance(0.0, 0.0, -3.0), 2.0, 8 * u);
    assert_close(distance(5.0, 0.0, 0.0), 2.0, 16 * u);
    assert_close(distance(0.0, 2.0, 0.0), 0.0, 8 * u);
    // On the long axis: nearest in the plane xz, at height √(1 - x²/9·81/64), x p = 9x/8.
    double const x = 1.0, p = 9.0 / 8.0, z2 = 1.0 - p * p / 9.0;
    assert_close(distance(x, 0.0, 0.0), -std::sqrt((p - x) * (p - x) + z2), 16 * u);
    double const sphere[6] = {4.0, 0.0, 0.0, 4.0, 0.0, 4.0}, center[3] = {0.0, 0.0, 0.0};
    double d, point[3];
    g_assert_cmpint(pw85_distance_point(center, sphere, &d, point, nullptr), ==, PW85_SUCCESS);
    assert_close(d, -2.0, 8 * u);
    assert_close(std::hypot(point[0], point[1], point[2]), 2.0, 16 * u);
}

// The nearest of six half-spaces.
PW85_TEST("/walls/box")
{
    Failures failures;
    Random random(540);
    for (int n = 0; n < draws(5000); ++n) {
        auto const q = random_form_of_any_size(random);
        double const size = size_of(q);
        Vector3 lower{}, upper{}, point{}, normal{}, deepest{};
        for (int i = 0; i < 3; ++i) {
            lower[i] = size * random.uniform(-2.0, 0.5);
            upper[i] = lower[i] + size * random.uniform(0.0, 3.0);
        }
        double distance, expected = std::numeric_limits<double>::infinity();
        g_assert_cmpint(pw85_distance_box(lower.coordinates, upper.coordinates, q.entries,
                                          &distance, point.coordinates, normal.coordinates),
                        ==, PW85_SUCCESS);
        for (int face = 0; face < 6; ++face) {
            double outward[3] = {}, d, p[3];
            outward[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
            pw85_distance_plane(outward, face % 2 == 0 ? upper[face / 2] : -lower[face / 2],
                                q.entries, &d, p);
            if (d < expected) {
                expected = d;
                deepest = {p[0], p[1], p[2]};
            }
        }
        failures.check(std::fabs(distance - expected) <= 4 * u * 3 * size, "distance", distance,
                       expected, [&] { return text(lower, q) + text(upper, q); });
        for (int i = 0; i < 3; ++i)
            failures.check(std::fabs(point[i] - deepest[i]) <= 4 * u * size, "point", point[i],
                           deepest[i], [&] { return text(lower, q); });
        failures.check(std::fabs(pw85::dot(normal, normal) - 1.0) == 0.0, "normal", normal[0], 1.0,
                       [&] { return text(lower, q); });
    }
}

// The farthest point of the projection, p: with c + p = ν Q⁻¹p in the plane across the axis, it is
// farthest if ν I - Q is semidefinite there (the counterpart of test_point_optimality()).
PW85_TEST("/walls/cylinder")
{
    Failures failures;
    Random random(550);
    for (int n = 0; n < draws(5000); ++n) {
        auto const q = random_form_of_any_size(random);
        double const size = size_of(q), radius = size * random.uniform(0.1, 3.0);
        auto const axis = random.log_uniform(1e-100, 1e100) * random.direction<3>();
        auto const center =
            (n % 7 == 0 ? 0.0 : size * random.log_uniform(1e-10, 10.0)) * random.direction<3>();
        double distance;
        Vector3 point{}, normal{};
        g_assert_cmpint(pw85_distance_cylinder(axis.coordinates, radius, center.coordinates,
                                               q.entries, &distance, point.coordinates,
                                               normal.coordinates),
                        ==, PW85_SUCCESS);
        auto const w = convert<Wide>(q);
        auto const c = convert<Wide>(center);
        auto const a = convert<Wide>(axis);
        auto const exact = pw85::distance_cylinder(a, Wide(radius), c, w);
        auto const inputs = [&] {
            return text(center, q) + ", axis = " + hex_text(axis.coordinates, 3) +
                   ", radius = " + hex_text(&radius, 1);
        };
        Wide const bound =
            8 * u * (radius + absolute_dot(exact.normal, c) + width_sensitivity(w, exact.normal));
        failures.check(abs(Wide(distance - exact.distance)) <= bound, "distance", distance,
                       static_cast<double>(exact.distance), inputs);
        // No other normal gives less, and this one is that of a point as far from the axis.
        Wide const along = pw85::dot(a, exact.normal) / norm(a);
        auto position = c;
        for (int i = 0; i < 3; ++i) position[i] += exact.point[i];
        Wide const off = norm(pw85::cross(position, a)) / norm(a);
        failures.check(abs(along) <= 1e-40 &&
                           abs(Wide(radius - off - exact.distance)) <= 1e-35 * (radius + off),
                       "farthest point", static_cast<double>(off),
                       static_cast<double>(Wide(radius - exact.distance)), inputs);
        WideVector e1, e2;
        pw85::detail::complete_basis(Wide(1 / norm(a)) * a, e1, e2);
        for (int k = 0; k < draws(64); ++k) {
            Wide const angle = random.uniform(0.0, 2.0 * std::numbers::pi);
            auto other = Wide(cos(angle)) * e1;
            for (int i = 0; i < 3; ++i) other[i] += sin(angle) * e2[i];
            Wide const clearance =
                radius - pw85::dot(other, c) - pw85::detail::support(w, other).extent;
            failures.check(clearance >= exact.distance, "another normal",
                           static_cast<double>(clearance), static_cast<double>(exact.distance),
                           inputs);
        }
    }
}

// A spheroid across a cylinder, off its axis; and along it.
PW85_TEST("/walls/cylinder/by_hand")
{
    double const axis[3] = {0.0, 0.0, 2.0}, q[6] = {9.0, 0.0, 0.0, 1.0, 0.0, 1.0},
                 long_one[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 400.0};
    double const center[3] = {0.5, 0.0, 7.0}, beside[3] = {0.0, -3.0, 0.0};
    double d, point[3], normal[3];
    g_assert_cmpint(pw85_distance_cylinder(axis, 5.0, center, q, &d, point, normal), ==,
                    PW85_SUCCESS);
    assert_close(d, 1.5, 16 * u);
    assert_close(point[0], 3.0, 16 * u);
    assert_close(normal[0], 1.0, 4 * u);
    g_assert_cmpint(pw85_distance_cylinder(axis, 5.0, beside, long_one, &d, point, nullptr), ==,
                    PW85_SUCCESS);
    assert_close(d, 1.0, 16 * u);
    assert_close(point[1], -1.0, 16 * u);
}

// Both ends of the chord are on the surface, and its middle is inside; the wide type decides which
// lines miss.
PW85_TEST("/walls/line")
{
    Failures failures;
    Random random(560);
    int hits = 0, misses = 0;
    for (int n = 0; n < draws(20000); ++n) {
        double const aspect = random.log_uniform(1.0, 100.0);
        auto const q = random.form(random.log_uniform(1e-100, 1e100), aspect);
        double const size = size_of(q), far = random.log_uniform(1e-3, 1e6),
                     step = random.log_uniform(1e-20, 1e20);
        auto const direction = random.direction<3>(), aside = random.direction<3>();
        Vector3 origin{}, d{};
        for (int i = 0; i < 3; ++i) {
            origin[i] = size * (0.5 * aside[i] - far * direction[i]);
            d[i] = size * step * direction[i];
        }
        double t[2];
        g_assert_cmpint(pw85_intersect_line(origin.coordinates, d.coordinates, q.entries, t), ==,
                        PW85_SUCCESS);
        auto const exact =
            pw85::intersect_line(convert<Wide>(origin), convert<Wide>(d), convert<Wide>(q));
        // The nearest point errs by u times the distance of the origin, in the norm of Q⁻¹ by the
        // aspect ratio as much again, and the half chord by that over itself.
        Wide const half = (exact.leave - exact.enter) / 2,
                   error = 64 * u * aspect * aspect * (1 + far) / step;
        auto const inputs = [&] {
            return text(origin, q) + ", direction = " + hex_text(d.coordinates, 3);
        };
        if (std::isnan(t[0]) || exact.enter != exact.enter) {
            failures.check(std::isnan(t[0]) == (exact.enter != exact.enter) ||
                               half * half <= error / step,
                           "miss", t[0], static_cast<double>(exact.enter), inputs);
            ++misses;
            continue;
        }
        ++hits;
        Wide const bound = error * (1 + 1 / (half * step));
        failures.check(abs(Wide(t[0] - exact.enter)) <= bound, "enter", t[0],
                       static_cast<double>(exact.enter), inputs);
        failures.check(abs(Wide(t[1] - exact.leave)) <= bound, "leave", t[1],
                       static_cast<double>(exact.leave), inputs);
        failures.check(t[0] <= t[1], "order", t[0], t[1], inputs);
        auto const on_surface = [&](Wide const &at) {
            WideVector x = convert<Wide>(origin);
            for (int i = 0; i < 3; ++i) x[i] += at * d[i];
            Wide const form = pw85::dot(
                x, pw85::detail::solve(pw85::detail::factorize(convert<Wide>(q), Wide(0)), x));
            failures.check(abs(Wide(form - 1)) <= 1e-25, "on the surface",
                           static_cast<double>(form), 1.0, inputs);
        };
        on_surface(exact.enter);
        on_surface(exact.leave);
    }
    g_assert_cmpint(hits, >, draws(1000));
    g_assert_cmpint(misses, >, draws(1000));
}

PW85_TEST("/walls/line/by_hand")
{
    double const q[6] = {4.0, 0.0, 0.0, 1.0, 0.0, 1.0}, direction[3] = {2.0, 0.0, 0.0};
    double const before[3] = {-6.0, 0.0, 0.0}, tangent[3] = {-6.0, 1.0, 0.0},
                 above[3] = {-6.0, 1.0 + 0x1p-52, 0.0};
    double t[2];
    g_assert_cmpint(pw85_intersect_line(before, direction, q, t), ==, PW85_SUCCESS);
    assert_close(t[0], 2.0, 8 * u);
    assert_close(t[1], 4.0, 8 * u);
    g_assert_cmpint(pw85_intersect_line(tangent, direction, q, t), ==, PW85_SUCCESS);
    assert_close(t[0], 3.0, 8 * u);
    assert_close(t[1], 3.0, 8 * u);
    g_assert_cmpint(pw85_intersect_line(above, direction, q, t), ==, PW85_SUCCESS);
    g_assert_true(std::isnan(t[0]) && std::isnan(t[1]));
}

bool all_nan(double const *x, int count)
{
    for (int i = 0; i < count; ++i)
        if (!std::isnan(x[i])) return false;
    return true;
}

// As far away as doubles reach, in units of the ellipsoid: along r, with the half-width that it has
// there.
PW85_TEST("/walls/point/far_away")
{
    double const r[3] = {0x1p900, 0x1p900, 0.0},
                 q[6] = {0x1p-1000, 0.0, 0.0, 0x1p-998, 0.0, 0x1p-1002};
    double d, point[3], normal[3];
    g_assert_cmpint(pw85_distance_point(r, q, &d, point, normal), ==, PW85_SUCCESS);
    assert_close(d / 0x1p900, std::sqrt(2.0), 8 * u);
    for (int i = 0; i < 3; ++i) assert_close(normal[i], i < 2 ? std::sqrt(0.5) : 0.0, 4 * u);
    assert_close(point[0] * 0x1p500, std::sqrt(0.2), 8 * u);
    assert_close(point[1] * 0x1p500, std::sqrt(3.2), 8 * u);
}

/// Every function of one ellipsoid; `out` is 7 numbers, of which `count` are written.
struct Function {
    int count;
    int (*call)(double const *x, double const *q, double *out);
};

constexpr double ones[3] = {1.0, 1.0, 1.0};
constexpr Function functions[] = {
    {4, [](auto x, auto q, auto out) { return pw85_distance_plane(x, 1.0, q, out, out + 1); }},
    {6,
     [](auto x, auto q, auto out) { return pw85_distance_plane_derivatives(x, q, out, out + 3); }},
    {4, [](auto x, auto q, auto out) { return pw85_contact_plane(x, 1.0, q, out, out + 1); }},
    {6, [](auto x, auto q,
           auto out) { return pw85_contact_plane_derivatives(x, 1.0, q, out, out + 3); }},
    {7,
     [](auto x, auto q, auto out) { return pw85_distance_box(x, ones, q, out, out + 1, out + 4); }},
    {7,
     [](auto x, auto q, auto out) { return pw85_distance_box(ones, x, q, out, out + 1, out + 4); }},
    {7, [](auto x, auto q,
           auto out) { return pw85_distance_cylinder(x, 1.0, ones, q, out, out + 1, out + 4); }},
    {7, [](auto x, auto q,
           auto out) { return pw85_distance_cylinder(ones, 1.0, x, q, out, out + 1, out + 4); }},
    {7, [](auto x, auto q, auto out) { return pw85_distance_point(x, q, out, out + 1, out + 4); }},
    {2, [](auto x, auto q, auto out) { return pw85_intersect_line(x, ones, q, out); }},
    {2, [](auto x, auto q, auto out) { return pw85_intersect_line(ones, x, q, out); }},
};

void expect(Function const &f, double const *x, double const *q, int expected)
{
    double out[7] = {};
    g_assert_cmpint(f.call(x, q, out), ==, expected);
    g_assert_true(expected == PW85_SUCCESS ? !std::isnan(out[0]) : all_nan(out, f.count));
    for (int i = f.count; i < 7; ++i) g_assert_cmpfloat(out[i], ==, 0.0);
}

PW85_TEST("/walls/statuses")
{
    double const x[3] = {1.0, 1.0, 1.0}, q[6] = {4.0, 0.5, 0.0, 3.0, 0.0, 2.0};
    for (auto const &f : functions) expect(f, x, q, PW85_SUCCESS);
    double const zero[3] = {0.0, 0.0, 0.0};
    for (int i : {0, 1, 2, 3, 6, 10}) expect(functions[i], zero, q, PW85_EINVAL);
    double const above[3] = {0.0, 0.0, 1.5};
    expect(functions[4], above, q, PW85_EINVAL);
    double out[7];
    for (double const radius : {0.0, -1.0})
        g_assert_cmpint(pw85_distance_cylinder(x, radius, x, q, out, out + 1, out + 4), ==,
                        PW85_EINVAL);
}

// Forms whose entries lie so far apart that products of them leave the range of double, and hide
// that they are not definite.
PW85_TEST("/walls/forms_out_of_range")
{
    double const x[3] = {1.0, 1.0, 1.0};
    double const forms[][6] = {
        {0x1.853ff7fp+508, 0x98p-1074, 0.0, 0x1p+433, 0x90012p-1074, 0x1.41d1d1d1d1ddcp-557},
        {0x1.f7f7fb77b3b9p+1016, 0x1.f3f3f7f7f7f7fp-12, 0x1.f3f3f3f3f3f3fp-12,
         0x1.f3f3f3f3f9b3fp-12, 0x1p-1023, 0x1.1ff4a4a4a4a4ep-911},
        {0x1.2425542p+37, 0x1.bp-1020, 0x7p-1040, 0x1.a2023p+545, -0x1.e424e000aff3fp-36,
         0x1.3424a6c0001bep-509}};
    for (auto const &q : forms) {
        double half_widths[3];
        g_assert_cmpint(pw85_bounding_boxes(1, q, half_widths), ==, PW85_ENOTPD);
        for (auto const &f : functions) expect(f, x, q, PW85_ENOTPD);
    }
}

// Semi-axes below the range of the contract: nothing that underflows makes an answer NaN.
PW85_TEST("/walls/tiny_form")
{
    double const x[3] = {0.0, 0x1p-15, 0.0};
    double const q[6] = {0x1p-1054, 0.0, 0.0, 0x1p-1052, 0.0, 0x1p-1008};
    for (int i = 0; i < 4; ++i) {
        double out[7] = {};
        g_assert_cmpint(functions[i].call(x, q, out), ==, PW85_SUCCESS);
        for (double const y : out) g_assert_false(std::isnan(y));
    }
}

// μ² beyond the range of double is infinity, derivatives are not below its largest number, and no
// coordinate is NaN.
PW85_TEST("/walls/plane/out_of_range")
{
    double const normal[3] = {0x1p-950, 0.0, 0.0}, q[6] = {4.0, 0.0, 0.0, 3.0, 0.0, 2.0};
    double mu2, point[3];
    g_assert_cmpint(pw85_contact_plane(normal, 0x1p600, q, &mu2, point), ==, PW85_SUCCESS);
    g_assert_cmpfloat(mu2, ==, HUGE_VAL);
    g_assert_cmpfloat(point[0], ==, HUGE_VAL);
    g_assert_true(point[1] == 0.0 && point[2] == 0.0);
    double d_center[3], d_rot[3];
    g_assert_cmpint(pw85_contact_plane_derivatives(normal, 0x1p600, q, d_center, d_rot), ==,
                    PW85_SUCCESS);
    g_assert_cmpfloat(d_center[0], <=, -std::numeric_limits<double>::max());
    g_assert_true(d_center[1] == 0.0 && d_center[2] == 0.0 && d_rot[0] == 0.0 && d_rot[1] == 0.0 &&
                  d_rot[2] == 0.0);
}

// The templates in two dimensions and other scalars agree with three dimensions and double.
PW85_TEST("/walls/templates")
{
    pw85::SymmetricMatrix<float, 2> const flat{4.0f, 0.0f, 1.0f};
    auto const d = pw85::distance_point(pw85::Vector<float, 2>{3.0f, 0.0f}, flat);
    assert_close(static_cast<double>(d.distance), 1.0, 1e-6);
    auto const plane = pw85::distance_plane(pw85::Vector<float, 2>{0.0f, 2.0f}, 4.0f, flat);
    assert_close(static_cast<double>(plane.distance), 1.0, 1e-6);
    auto const box = pw85::distance_box(pw85::Vector<float, 2>{-3.0f, -3.0f},
                                        pw85::Vector<float, 2>{2.5f, 3.0f}, flat);
    assert_close(static_cast<double>(box.distance), 0.5, 1e-6);
    auto const chord = pw85::intersect_line(
        pw85::Vector<long double, 2>{-4.0L, 0.0L}, pw85::Vector<long double, 2>{1.0L, 0.0L},
        pw85::SymmetricMatrix<long double, 2>{4.0L, 0.0L, 1.0L});
    assert_close(static_cast<double>(chord.enter), 2.0, 4 * u);
    assert_close(static_cast<double>(chord.leave), 6.0, 8 * u);
}

PW85_ADD_TEST("/walls/point/optimality", test_point_optimality);

} // namespace
