// SPDX-License-Identifier: BSD-3-Clause
// Curvatures and the geometry of Hertzian contacts (include/pw85/distance/principal_curvatures.hpp,
// hertz.hpp), against closed forms in 50 digits: the two invariants of the second fundamental form,
// and Hertz's equations in Carlson's integrals.
#include <cmath>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#pragma GCC diagnostic pop

using namespace pw85_tests;

namespace {

/// The bound of principal_curvatures.hpp on relative errors: 2^13 u for double.
template <class T> double const accuracy = std::ldexp(1.0, 5 + std::numeric_limits<T>::digits / 6 -
                                                               std::numeric_limits<T>::digits);

/// A pair of grains that face each other along a normal of any length.
struct Grains {
    Sample<double, 3> pair;
    Vector3 normal;
};

std::string text(Grains const &g)
{
    return hex_text(g.pair) + ", normal = " + hex_text(g.normal.coordinates, 3);
}

WideVector unit(WideVector const &x) { return Wide(1 / norm(x)) * x; }

/// The part across a unit vector n of α Q⁻¹, α = √(nᵀQn): the second fundamental form of the
/// surface, as a matrix whose third eigenvalue is zero.
WideForm fundamental_form(WideForm const &q, WideVector const &n)
{
    auto const adjugate = pw85::detail::adjugate(q);
    Wide const det = pw85::detail::determinant(q, adjugate),
               extent = sqrt(pw85::dot(n, pw85::product(q, n)));
    auto const inverse = Wide(extent / det) * adjugate;
    auto const in = pw85::product(inverse, n);
    Wide const nin = pw85::dot(n, in);
    WideForm k{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            k(i, j) = inverse(i, j) - n[i] * in[j] - in[i] * n[j] + nin * n[i] * n[j];
    return k;
}

/// The eigenvalues of such a matrix that are not zero, from its trace and the sum of its principal
/// minors.
struct Eigenvalues {
    Wide small, large;
};

Eigenvalues eigenvalues(WideForm const &k)
{
    Wide const trace = k[0] + k[3] + k[5];
    Wide const minors =
        k[0] * k[3] - k[1] * k[1] + k[0] * k[5] - k[2] * k[2] + k[3] * k[5] - k[4] * k[4];
    Wide const root = sqrt(Wide(abs(trace * trace / 4 - minors))), large = trace / 2 + root;
    return {minors / large, large};
}

Wide along(WideForm const &k, WideVector const &x, WideVector const &y)
{
    return pw85::dot(x, pw85::product(k, y));
}

/// Curvatures and directions against the matrix of the second fundamental form. Directions of a
/// part ε of the angle between them change the entries by ε times the difference of the curvatures.
template <class T> void compare(pw85::Vector<T, 2> const &found,
                                pw85::Vector<T, 3> const (&directions)[2], WideForm const &k,
                                WideVector const &n, double bound, Failures &failures,
                                std::string const &inputs)
{
    auto const describe = [&] { return inputs; };
    auto const exact = eigenvalues(k);
    double const u = pw85::detail::unit_roundoff<T>();
    for (int i = 0; i < 2; ++i) {
        Wide const wanted = i == 0 ? exact.small : exact.large;
        double const error = static_cast<double>(Wide(abs(Wide(found[i]) / wanted - 1)));
        failures.check(error <= bound, i == 0 ? "smaller" : "larger", error, bound, describe);
    }
    WideVector const d[2] = {convert<Wide>(directions[0]), convert<Wide>(directions[1])};
    double const skew = static_cast<double>(norm(WideVector(pw85::cross(d[0], d[1]) - n)));
    failures.check(skew <= 16 * u, "d1 × d2 - n", skew, 16 * u, describe);
    WideVector tangents[2];
    for (int i = 0; i < 2; ++i) tangents[i] = unit(d[i] - Wide(pw85::dot(d[i], n)) * n);
    double const mixed =
        static_cast<double>(Wide(abs(along(k, tangents[0], tangents[1])) / exact.large));
    failures.check(mixed <= bound, "mixed entry", mixed, bound, describe);
}

/// Forms whose axes are along the coordinates or not; normals anywhere, along an axis, nearly so,
/// or across one.
Grains random_grains(Random &random, int n, double largest_aspect)
{
    double const aspect = n % 4 == 0 ? 1.0 : std::pow(largest_aspect, (n % 4) / 3.0);
    Grains g{{{},
              random.form(random.log_uniform(1e-40, 1e40), random.log_uniform(1.0, aspect)),
              random.form(1.0, random.log_uniform(1.0, aspect))},
             random.log_uniform(1e-30, 1e30) * random.direction<3>()};
    int const kind = n / 4 % 4;
    if (kind == 1 || kind == 2)
        for (int const k : {1, 2, 4}) g.pair.q1[k] = g.pair.q2[k] = 0;
    if (kind == 2) g.normal[n % 3] *= random.log_uniform(1e-18, 1.0);
    if (kind == 2) g.normal[(n + 1) % 3] *= random.log_uniform(1e-18, 1.0);
    double const ratio = n % 3 == 0 ? 1.0 : random.log_uniform(1e-12, 1e12);
    double const size = std::sqrt(g.pair.q1[0] + g.pair.q1[3] + g.pair.q1[5]);
    for (int k = 0; k < 6; ++k) g.pair.q2[k] *= ratio * ratio * size * size;
    g.pair.r12 = random.uniform(0.1, 3.0) * (1 + ratio) * size * random.direction<3>();
    return g;
}

template <class T> void test_curvature()
{
    Failures failures;
    Random random(800);
    double worst = 0;
    for (int n = 0; n < draws(8000); ++n) {
        auto const g = random_grains(random, n, sizeof(T) == 4 ? 100.0 : 1e6);
        auto const q = convert<T>(
            Form3(sizeof(T) == 4 ? random.form(1.0, random.log_uniform(1.0, 100.0)) : g.pair.q1));
        auto const normal = convert<T>(g.normal);
        auto const c = pw85::curvature(normal, q);
        // a form that is not definite when it is rounded
        if (c.status == pw85::Status::not_positive_definite) continue;
        auto const wide = unit(convert<Wide>(normal));
        auto const k = fundamental_form(convert<Wide>(q), wide);
        compare(c.curvatures, {c.direction1, c.direction2}, k, wide, accuracy<T>, failures,
                text(g));
        worst = std::fmax(worst, static_cast<double>(
                                     Wide(abs(Wide(c.curvatures[0]) / eigenvalues(k).small - 1))));
    }
    g_test_message("largest error of a curvature: %g", worst);
}

/// hertz() by Carlson's integrals. The ratio k of the semi-axes is the root of κ2/κ1 = R_D(0, 1,
/// k²)/R_D(0, k², 1), found by the secant method from an approximation.
struct Ellipse {
    Wide radius, a2, b2;
};

Ellipse carlson(Wide const &small, Wide const &large, Wide approximation)
{
    using boost::math::ellint_rd, boost::math::ellint_rf;
    Wide const zero = 0, one = 1;
    auto const miss = [&](Wide const &k2) {
        return Wide(log(Wide(ellint_rd(zero, one, k2) / ellint_rd(zero, k2, one) * small / large)));
    };
    Wide last = approximation * (1 + Wide("1e-12")), k2 = approximation, miss_last = miss(last);
    for (int i = 0; i < 8; ++i) {
        Wide const missed = miss(k2);
        if (abs(missed) < Wide("1e-45") || missed == miss_last) break;
        Wide const next = k2 - missed * (k2 - last) / (missed - miss_last);
        last = k2;
        miss_last = missed;
        k2 = next;
    }
    Wide const rd = ellint_rd(zero, k2, one), rf = ellint_rf(zero, one, k2),
               pi = boost::math::constants::pi<Wide>();
    Wide const a2 = 2 * rd / (3 * small * rf);
    return {pi * pi * rd / (6 * small * rf * rf * rf), a2, k2 * a2};
}

template <class T> void compare(pw85::HertzEllipse<T> const &found, Wide const &small,
                                Wide const &large, double bound, Failures &failures,
                                std::string const &inputs)
{
    auto const describe = [&] { return inputs; };
    auto const exact = carlson(small, large, Wide(found.ellipse[1]) / Wide(found.ellipse[0]));
    auto const check = [&](T const &x, Wide const &wanted, char const *what) {
        double const error = static_cast<double>(Wide(abs(Wide(x) / wanted - 1)));
        failures.check(error <= bound, what, error, bound, describe);
    };
    check(found.radius, exact.radius, "radius");
    check(found.ellipse[0], exact.a2, "a²/δ");
    check(found.ellipse[1], exact.b2, "b²/δ");
}

template <class T> void test_hertz()
{
    Failures failures;
    Random random(810);
    for (int n = 0; n < draws(800); ++n) {
        double const ratio =
            n % 2 == 0 ? random.log_uniform(1.0, 1e3) : 1 + random.log_uniform(1e-17, 1e18);
        T const small = static_cast<T>(random.log_uniform(1e-10, 1e10));
        T const large = static_cast<T>(small * static_cast<T>(ratio));
        auto const h = pw85::hertz(pw85::Vector<T, 2>{small, large});
        compare(
            h, small, large, 256 * pw85::detail::unit_roundoff<T>(), failures,
            hex_text(pw85::Vector<double, 2>{static_cast<double>(small), static_cast<double>(large)}
                         .coordinates,
                     2));
        auto const swapped = pw85::hertz(pw85::Vector<T, 2>{large, small});
        g_assert_true(swapped.radius == h.radius && swapped.ellipse[0] == h.ellipse[1] &&
                      swapped.ellipse[1] == h.ellipse[0]);
    }
}

/// Half-widths, and points of the surfaces relative to their own centres.
struct Ends {
    pw85::detail::Support<Wide, 3> first, second;
};

Ends ends(Sample<Wide, 3> const &p, WideVector const &n)
{
    return {pw85::detail::support(p.q1, n), pw85::detail::support(p.q2, n)};
}

struct Found {
    double depth;
    Vector3 point;
    double curvatures[2];
    Vector3 directions[2];
    double radius, ellipse[2];
    int status;
};

Found by_c(Grains const &g)
{
    Found f{};
    f.status = pw85_hertz_contact(g.pair.r12.coordinates, g.pair.q1.entries, g.pair.q2.entries,
                                  g.normal.coordinates, &f.depth, f.point.coordinates, f.curvatures,
                                  f.directions[0].coordinates, &f.radius, f.ellipse);
    return f;
}

PW85_TEST("/hertz/contact")
{
    Failures failures;
    Random random(820);
    for (int n = 0; n < draws(1600); ++n) {
        auto const g = random_grains(random, n, 1e6);
        auto const f = by_c(g);
        if (f.status == PW85_ENOTPD) continue; // a form that is not definite when it is rounded
        auto const describe = [&] { return text(g); };
        auto const p = convert<Wide>(g.pair);
        auto const normal = unit(convert<Wide>(g.normal));
        auto const [end1, end2] = ends(p, normal);
        Wide const depth = end1.extent + end2.extent - pw85::dot(normal, p.r12);
        Wide sum = absolute_form(p.q1, normal) / (2 * end1.extent) +
                   absolute_form(p.q2, normal) / (2 * end2.extent);
        for (int i = 0; i < 3; ++i) sum += abs(normal[i] * p.r12[i]);
        double const depth_error =
            static_cast<double>(Wide(abs(f.depth - depth) / (sum * Wide(0x1p-53))));
        failures.check(depth_error <= 8, "depth in u Σ", depth_error, 8, describe);
        auto const point = Wide(0.5) * (end1.point + p.r12 - end2.point);
        Wide const length = norm(end1.point) + norm(end2.point) + norm(p.r12);
        double const point_error =
            static_cast<double>(Wide(norm(WideVector(convert<Wide>(f.point) - point)) / length));
        failures.check(point_error <= accuracy<double>, "point", point_error, accuracy<double>,
                       describe);
        auto const k = fundamental_form(p.q1, normal), k2 = fundamental_form(p.q2, normal);
        auto const gap = pw85::detail::blend(Wide(1), k, Wide(1), k2);
        compare({f.curvatures[0], f.curvatures[1]}, f.directions, gap, normal, accuracy<double>,
                failures, text(g));
        compare(pw85::HertzEllipse<double>{f.radius,
                                           {f.ellipse[0], f.ellipse[1]},
                                           pw85::Status::success},
                f.curvatures[0], f.curvatures[1], 256 * 0x1p-53, failures, text(g));
    }
}

/// The part across n of r, over n·r: the tangent of the angle between them.
WideVector slope(WideVector const &r, WideVector const &n)
{
    Wide const height = pw85::dot(n, r);
    return Wide(1 / height) * (r - height * n);
}

/// xᵀ(A1 + A2)⁻¹x for x across n, where A = (Q - ppᵀ)/α is the matrix of the radii of curvature.
Wide turning(Sample<Wide, 3> const &p, WideVector const &n, WideVector const &x)
{
    WideForm radii = pw85::detail::outer_weights(n); // so that the matrix is definite
    for (int const k : {1, 2, 4}) radii[k] /= 2;
    for (auto const &q : {p.q1, p.q2}) {
        auto const s = pw85::detail::support(q, n);
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                radii(i, j) += (q(i, j) - s.point[i] * s.point[j]) / s.extent;
    }
    auto const adjugate = pw85::detail::adjugate(radii);
    return along(adjugate, x, x) / pw85::detail::determinant(radii, adjugate);
}

// With the normal of the scaled pair the depth is δ = (1/μ - 1) n·r. It exceeds the depth of
// pw85_penetration() by ½ δ² tᵀ(A1 + A2)⁻¹t, with the slope t, plus terms of third order, whose
// factor is some power of the aspect ratio.
PW85_TEST("/hertz/depths")
{
    Failures failures;
    Random random(830);
    Wide const part = Wide(1) / (1 << 20);
    for (int n = 0; n < draws(160); ++n) {
        auto const s = random_pair<3>(random, {});
        auto p = convert<Wide>(s);
        Wide const mu = 1 - part;
        p.r12 = Wide(mu / sqrt(pw85::contact(p.r12, p.q1, p.q2).mu2)) * p.r12;
        Wide const lambda = pw85::contact(p.r12, p.q1, p.q2).lambda;
        auto const normal = pw85::contact_geometry(p.r12, p.q1, p.q2, lambda).normal;
        auto const describe = [&] { return hex_text(s); };
        Wide const depth = pw85::hertz_contact(p.r12, p.q1, p.q2, normal).depth;
        double const identity =
            static_cast<double>(Wide(abs(depth / ((1 / mu - 1) * pw85::dot(normal, p.r12)) - 1)));
        failures.check(identity <= 1e-30, "(1/μ - 1) n·r", identity, 1e-30, describe);
        Wide const least = pw85::penetration(p.r12, p.q1, p.q2).depth;
        Wide const second = depth * depth / 2 * turning(p, normal, slope(p.r12, normal));
        double const ratio = static_cast<double>(Wide((depth - least) / second));
        failures.check(std::abs(ratio - 1) <= 1e-3, "second order", ratio, 1.0, describe);
    }
}

Form3 diagonal(double a, double b, double c) { return {a * a, 0, 0, b * b, 0, c * c}; }

void check_close(double found, double wanted)
{
    g_assert_cmpfloat_with_epsilon(found / wanted, 1.0, 1e-14);
}

// Closed forms: spheres, the pole and the equator of spheroids, the three axes of an ellipsoid,
// spheroids that cross.
PW85_TEST("/hertz/closed_forms")
{
    double k[2], d[6];
    auto const curvature = [&](Vector3 const &normal, Form3 const &q) {
        g_assert_cmpint(pw85_curvature(normal.coordinates, q.entries, k, d), ==, PW85_SUCCESS);
    };
    for (double const c : {1e-6, 0.5, 3.0, 1e6}) {
        curvature({0, 0, 2}, diagonal(1, 1, c));
        check_close(k[0], c);
        check_close(k[1], c);
        curvature({0.6, 0.8, 0}, diagonal(1, 1, c));
        check_close(k[0], std::fmin(1.0, 1 / (c * c)));
        check_close(k[1], std::fmax(1.0, 1 / (c * c)));
        // the meridian is flatter if the spheroid is long
        g_assert_true(std::abs(d[c > 1 ? 2 : 5]) == 1.0);
    }
    curvature({0, 1, 0}, diagonal(4, 3, 2));
    check_close(k[0], 3.0 / 16);
    check_close(k[1], 3.0 / 4);
    g_assert_true(std::abs(d[0]) == 1.0 && std::abs(d[5]) == 1.0);

    auto f = by_c({{{0, 0, 2.5}, diagonal(1, 1, 1), diagonal(2, 2, 2)}, {0, 0, 3}});
    check_close(f.depth, 0.5);
    check_close(f.point[2], 0.75);
    for (double const x : {f.radius, f.ellipse[0], f.ellipse[1]}) check_close(x, 2.0 / 3);
    f = by_c({{{0, 0, 3}, diagonal(50, 2, 2), diagonal(2, 50, 2)}, {0, 0, 1}});
    for (double const x : {f.radius, f.ellipse[0], f.ellipse[1]})
        check_close(x, 1 / (0.5 + 2.0 / 2500));
    double radius, ellipse[2], one[2] = {0.25, 0.25};
    g_assert_cmpint(pw85_hertz(one, &radius, ellipse), ==, PW85_SUCCESS); // a sphere on a plane
    g_assert_true(radius == 4.0 && ellipse[0] == 4.0 && ellipse[1] == 4.0);
}

// The radius is the largest value of 2 agm(1, k)²/(κ1 + κ2 k²) over k: Hertz's pressure has the
// least energy.
PW85_TEST("/hertz/least_energy")
{
    Failures failures;
    Random random(840);
    for (int n = 0; n < draws(2000); ++n) {
        double const k2[2] = {1, random.log_uniform(1.0, 1e6)}, k = random.log_uniform(1e-3, 1.0);
        double radius, a = 1, b = k;
        pw85_hertz(k2, &radius, nullptr);
        for (int i = 0; i < 30; ++i) {
            double const mean = 0.5 * (a + b);
            b = std::sqrt(a * b);
            a = mean;
        }
        double const trial = 2 * a * a / (1 + k2[1] * k * k);
        failures.check(trial <= radius * (1 + 1e-14), "radius", trial, radius,
                       [&] { return hex_text(k2, 2); });
    }
}

// Units that are powers of two change no bit; the ellipsoids in the other order give the same
// contact.
PW85_TEST("/hertz/units_and_order")
{
    Failures failures;
    Random random(850);
    for (int n = 0; n < draws(2000); ++n) {
        auto g = random_grains(random, n, 1e4);
        for (auto *const q : {&g.pair.q1, &g.pair.q2}) // sizes that leave room for the units
            *q = std::ldexp(1.0, -2 * std::ilogb(std::sqrt((*q)[0]))) * *q;
        g.pair.r12 = random.uniform(0.1, 3.0) * random.direction<3>();
        auto const f = by_c(g);
        auto const describe = [&] { return text(g); };
        for (int const e : {-480, -40, 40, 480}) {
            Grains scaled = g;
            scaled.pair = {std::ldexp(1.0, e) * g.pair.r12, std::ldexp(1.0, 2 * e) * g.pair.q1,
                           std::ldexp(1.0, 2 * e) * g.pair.q2};
            scaled.normal = std::ldexp(1.0, -e) * g.normal;
            auto const s = by_c(scaled);
            failures.check(s.depth == std::ldexp(f.depth, e), "depth", s.depth, f.depth, describe);
            failures.check(s.point[1] == std::ldexp(f.point[1], e), "point", s.point[1], f.point[1],
                           describe);
            failures.check(s.curvatures[0] == std::ldexp(f.curvatures[0], -e), "curvature",
                           s.curvatures[0], f.curvatures[0], describe);
            failures.check(s.directions[1][2] == f.directions[1][2], "direction",
                           s.directions[1][2], f.directions[1][2], describe);
            failures.check(s.radius == std::ldexp(f.radius, e), "radius", s.radius, f.radius,
                           describe);
            failures.check(s.ellipse[1] == std::ldexp(f.ellipse[1], e), "ellipse", s.ellipse[1],
                           f.ellipse[1], describe);
        }
        auto const other = by_c({{-g.pair.r12, g.pair.q2, g.pair.q1}, -g.normal});
        failures.check(std::abs(other.depth - f.depth) <= 1e-13, "depth", other.depth, f.depth,
                       describe);
        for (int i = 0; i < 3; ++i)
            failures.check(std::abs(other.point[i] + g.pair.r12[i] - f.point[i]) <= 1e-12, "point",
                           other.point[i], f.point[i], describe);
        failures.check(std::abs(other.radius / f.radius - 1) <= 2 * accuracy<double>, "radius",
                       other.radius, f.radius, describe);
    }
}

// Sizes 1e±150 in any combination, and r12 = 0.
PW85_TEST("/hertz/extremes")
{
    for (double const a : {1e-150, 1.0, 1e150})
        for (double const b : {1e-150, 1.0, 1e150}) {
            double const sum = a + b,
                         reduced = std::fmin(a, b) / (1 + std::fmin(a, b) / std::fmax(a, b));
            auto const f =
                by_c({{{0, 0, 0.75 * sum}, diagonal(a, a, a), diagonal(b, b, b)}, {0, 0, 1e-300}});
            check_close(f.depth, 0.25 * sum);
            check_close(f.radius, reduced);
            check_close(f.ellipse[1], reduced);
            check_close(f.curvatures[0], 1 / reduced);
            auto const concentric =
                by_c({{{0, 0, 0}, diagonal(a, a, a), diagonal(b, b, b)}, {0, 1, 0}});
            check_close(concentric.depth, sum);
            g_assert_true(std::abs(concentric.point[1] - 0.5 * (a - b)) <= 1e-15 * sum);
        }
}

// Normals that are no normals; curvatures that are none.
PW85_TEST("/hertz/refusals")
{
    Form3 const q = diagonal(1, 2, 3), flat{1, 0, 0, 1, 0, 0};
    double k[2], nothing[3] = {0, 0, 0}, some[3] = {1, 0, 0};
    g_assert_cmpint(pw85_curvature(nothing, q.entries, k, nullptr), ==, PW85_EINVAL);
    g_assert_true(std::isnan(k[0]) && std::isnan(k[1]));
    g_assert_cmpint(pw85_curvature(some, flat.entries, k, nullptr), ==, PW85_ENOTPD);
    g_assert_cmpint(by_c({{{1, 0, 0}, q, q}, {0, 0, 0}}).status, ==, PW85_EINVAL);
    g_assert_cmpint(by_c({{{1, 0, 0}, q, flat}, {0, 0, 1}}).status, ==, PW85_ENOTPD);
    auto const f = by_c({{{1, 0, 0}, flat, q}, {0, 0, 1}});
    for (double const x :
         {f.depth, f.point[1], f.curvatures[1], f.directions[1][2], f.radius, f.ellipse[1]})
        g_assert_true(std::isnan(x));
    double radius;
    for (double const bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        double const one[2] = {1, bad};
        g_assert_cmpint(pw85_hertz(one, &radius, nullptr), ==, PW85_EINVAL);
        g_assert_true(std::isnan(radius));
    }
}

PW85_ADD_TEST("/hertz/curvature/double", test_curvature<double>);
PW85_ADD_TEST("/hertz/curvature/float", test_curvature<float>);
PW85_ADD_TEST("/hertz/curvature/long_double", test_curvature<long double>);
PW85_ADD_TEST("/hertz/theory/double", test_hertz<double>);
PW85_ADD_TEST("/hertz/theory/float", test_hertz<float>);
PW85_ADD_TEST("/hertz/theory/long_double", test_hertz<long double>);

} // namespace
