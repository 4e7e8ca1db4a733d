// SPDX-License-Identifier: BSD-3-Clause
// Contacts of grains along their common normals (include/pw85/distance/grain_contact.hpp): the
// equations of the contact in 50 digits, spheres in closed form, invariances, derivatives, walls,
// and pairs that have no contact.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"

using namespace pw85_tests;

namespace {

using Pair = Sample<double, 3>;

struct Contact {
    Vector3 normal;
    double depth;
    Vector3 point;
    std::array<double, 2> curvatures;
    double radius;
};

/// After the last step, which is below 2^-22, the normal errs by the square of the step times a
/// ratio of third and second derivatives, which is below 100 for aspect ratios up to 4 and small
/// depths: 6e-12. So do points and curvatures.
constexpr double accuracy = 6e-12;

double const u = 0x1p-53;

/// Pairs that overlap by some percent.
Pair random_grains(Random &random) { return random_pair<3>(random, {4.0, 8.0, 0.94, 0.999}); }

Vector3 contact_normal(Pair const &p)
{
    double out[2];
    Vector3 normal{};
    pw85_contact_function(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    pw85_contact_geometry(p.r12.coordinates, p.q1.entries, p.q2.entries, out[1], nullptr,
                          normal.coordinates);
    return normal;
}

int find(Pair const &p, Vector3 const &start, Contact &c)
{
    return pw85_grain_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, start.coordinates,
                              c.normal.coordinates, &c.depth, c.point.coordinates,
                              c.curvatures.data(), &c.radius);
}

Contact contact(Pair const &p, Vector3 const &start)
{
    Contact c{};
    g_assert_cmpint(find(p, start, c), ==, PW85_SUCCESS);
    return c;
}

Contact contact(Pair const &p) { return contact(p, contact_normal(p)); }

double distance(Vector3 const &a, Vector3 const &b) { return norm(Vector3(a - b)); }

void check_same(Contact const &a, Contact const &b, double bound, Failures &failures, Pair const &p)
{
    auto const describe = [&] { return hex_text(p); };
    auto const check = [&](char const *what, double error) {
        failures.check(error <= bound, what, error, bound, describe);
    };
    check("normal", distance(a.normal, b.normal));
    check("depth", std::abs(a.depth - b.depth));
    check("point", distance(a.point, b.point));
    for (std::size_t i = 0; i < 2; ++i)
        check("curvature", std::abs(a.curvatures[i] / b.curvatures[i] - 1.0));
    check("radius", std::abs(a.radius / b.radius - 1.0));
}

/// The minimum of the overlap by the same search in 50 digits, which ends after a step of 10^-21.
/// That it is a stationary point is checked by the points themselves, which do not depend on the
/// search.
void check_truth(Pair const &p, Contact const &c, double bound, Failures &failures)
{
    auto const describe = [&] { return hex_text(p); };
    auto const wide = convert<Wide>(p);
    auto const w =
        pw85::grain_contact(wide.r12, wide.q1, wide.q2, convert<Wide>(contact_normal(p)));
    g_assert_true(w.status == pw85::Status::success);
    WideVector const p1 = pw85::product(wide.q1, w.normal), p2 = pw85::product(wide.q2, w.normal);
    Wide const h1 = sqrt(pw85::dot(w.normal, p1)), h2 = sqrt(pw85::dot(w.normal, p2));
    WideVector const gap = Wide(1 / h1) * p1 + Wide(1 / h2) * p2 - wide.r12 - w.depth * w.normal;
    auto const check = [&](char const *what, double error, double limit) {
        failures.check(error <= limit, what, error, limit, describe);
    };
    check("equation", static_cast<double>(norm(gap)), 1e-38);
    check("normal", static_cast<double>(norm(WideVector(convert<Wide>(c.normal) - w.normal))),
          bound);
    check("depth", static_cast<double>(Wide(abs(Wide(c.depth) - w.depth))), 64 * u);
    check("point", static_cast<double>(norm(WideVector(convert<Wide>(c.point) - w.point))), bound);
    check("radius", static_cast<double>(Wide(abs(Wide(c.radius) / w.radius - 1))), bound);
}

PW85_TEST("/grain_contact/truth")
{
    Failures failures;
    Random random(900);
    for (int n = 0; n < draws(800); ++n) {
        Pair const p = random_grains(random);
        check_truth(p, contact(p), accuracy, failures);
    }
}

// The curvatures, the point and the radius are those of pw85_hertz_contact for the normal.
PW85_TEST("/grain_contact/equations")
{
    Failures failures;
    Random random(910);
    for (int n = 0; n < draws(8000); ++n) {
        Pair const p = random_grains(random);
        Contact const c = contact(p);
        Contact other = c;
        pw85_hertz_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, c.normal.coordinates,
                           &other.depth, other.point.coordinates, other.curvatures.data(), nullptr,
                           &other.radius, nullptr);
        check_same(c, other, accuracy, failures, p);
    }
}

// Two spheres: everything in closed form. The errors are those of some thirty operations.
PW85_TEST("/grain_contact/spheres")
{
    Failures failures;
    Random random(915);
    for (int n = 0; n < draws(800); ++n) {
        double const a = random.log_uniform(0.125, 8.0), b = random.log_uniform(0.125, 8.0),
                     share = random.uniform(0.0, 0.2) * std::min(a, b);
        Vector3 const up = random.direction<3>();
        Pair const p{(a + b - share) * up,
                     {a * a, 0.0, 0.0, a * a, 0.0, a * a},
                     {b * b, 0.0, 0.0, b * b, 0.0, b * b}};
        Vector3 const start = 3.0 * (up + 0.1 * random.direction<3>());
        double const curvature = 1.0 / a + 1.0 / b;
        Contact c = contact(p, start);
        Contact const wanted{
            up, share, (a - 0.5 * share) * up, {curvature, curvature}, 1.0 / curvature};
        check_same(c, wanted, 64 * u * (a + b + 1.0), failures, p);
    }
}

// Ellipsoids tip to tip, whose curvatures have any ratio, also beyond that of the fit for the
// radius. The fit errs by 7e-16, and the roundings of the five means and of the ratio of curvatures
// by some 30 u. Thin needles and flat discs are among them.
PW85_TEST("/grain_contact/ratios")
{
    Failures failures;
    Random random(920);
    for (int n = 0; n < draws(8000); ++n) {
        double const aspect = random.log_uniform(1.0, 400.0);
        // deeper than the least sum of radii of curvature, 2/aspect², there is no minimum
        Pair const p{{0.0, 0.0, 2.0 - 1e-3 / (aspect * aspect)},
                     {1.0, 0.0, 0.0, 1.0 / (aspect * aspect), 0.0, 1.0},
                     {1.0, 0.0, 0.0, 1.0 / (aspect * aspect), 0.0, 1.0}};
        double const curvatures[2] = {2.0, 2.0 / p.q1.entries[3]};
        double radius;
        pw85_hertz(curvatures, &radius, nullptr);
        double const error = std::abs(contact(p, {0.0, 0.0, 1.0}).radius / radius - 1.0);
        failures.check(error <= 64 * u, "radius", error, 64 * u, [&] { return hex_text(p); });
    }
}

// A contact does not depend on where the search starts, nor on the length of the start. In the
// other order, ellipsoids have the same contact, seen from the other one.
PW85_TEST("/grain_contact/starts")
{
    Failures failures;
    Random random(930);
    for (int n = 0; n < draws(4000); ++n) {
        Pair const p = random_grains(random);
        Contact const c = contact(p);
        Vector3 const start = random.log_uniform(1e-9, 1e9) *
                              (c.normal + random.log_uniform(1e-9, 1e-2) * random.direction<3>());
        check_same(contact(p, start), c, accuracy, failures, p);
        Contact other = contact({-p.r12, p.q2, p.q1});
        other.normal = -other.normal;
        other.point = p.r12 + other.point;
        check_same(other, c, accuracy, failures, p);
    }
}

// Units that are powers of two change no bit.
PW85_TEST("/grain_contact/sizes")
{
    Failures failures;
    Random random(940);
    for (int n = 0; n < draws(2000); ++n) {
        Pair const p = random_grains(random);
        Contact const c = contact(p);
        for (int const e : {-400, -40, 40, 400}) {
            double const unit = std::ldexp(1.0, e);
            Contact s = contact({unit * p.r12, unit * unit * p.q1, unit * unit * p.q2});
            s.depth /= unit;
            s.point = (1.0 / unit) * s.point;
            for (double &k : s.curvatures) k *= unit;
            s.radius /= unit;
            check_same(s, c, 0.0, failures, p);
        }
    }
}

Pair turned(Pair const &p, Vector3 const &omega1, Vector3 const &omega2)
{
    auto const form = [](Form3 const &q, Vector3 const &omega) {
        Form3 result{};
        auto const wide = rotated(convert<Wide>(q), convert<Wide>(omega));
        for (int k = 0; k < 6; ++k) result[k] = static_cast<double>(wide[k]);
        return result;
    };
    return {p.r12, form(p.q1, omega1), form(p.q2, omega2)};
}

/// x after rotation by |ω| about ω.
Vector3 rotated_vector(Vector3 const &x, Vector3 const &omega)
{
    double const angle = norm(omega);
    Vector3 const axis = (1.0 / angle) * omega;
    return std::cos(angle) * x + std::sin(angle) * pw85::cross(axis, x) +
           ((1.0 - std::cos(angle)) * pw85::dot(axis, x)) * axis;
}

PW85_TEST("/grain_contact/rotations")
{
    Failures failures;
    Random random(950);
    for (int n = 0; n < draws(800); ++n) {
        Pair const p = random_grains(random);
        Vector3 const omega = random.uniform(0.1, 3.0) * random.direction<3>();
        auto const turn = [&](Vector3 const &x) { return rotated_vector(x, omega); };
        Pair joint = turned(p, omega, omega);
        joint.r12 = turn(p.r12);
        Contact c = contact(p);
        c.normal = turn(c.normal);
        c.point = turn(c.point);
        check_same(contact(joint), c, accuracy, failures, p);
    }
}

// While grains turn steadily, radius and depth have no jumps. Their second differences are h² times
// second derivatives, which are below 500 for aspect ratios up to 4. Each search starts from the
// normal before, as in a run.
PW85_TEST("/grain_contact/path")
{
    Failures failures;
    Random random(960);
    double const h = 1e-3;
    for (int n = 0; n < draws(16); ++n) {
        Pair const p = random_grains(random);
        Vector3 const omega = random.direction<3>();
        Contact c = contact(p);
        std::array<double, 2> last{c.radius, c.depth}, difference{};
        for (int i = 1; i < 100; ++i) {
            c = contact(turned(p, (i * h) * omega, {}), c.normal);
            std::array<double, 2> const now{c.radius, c.depth};
            for (std::size_t k = 0; k < 2; ++k) {
                double const step = now[k] - last[k], second = std::abs(step - difference[k]);
                if (i > 1)
                    failures.check(second <= 500 * h * h, "second difference", second, 500 * h * h,
                                   [&] { return hex_text(p); });
                difference[k] = step;
            }
            last = now;
        }
    }
}

// Central differences err by h²/6 times third derivatives, which may be some 10³, and by
// accuracy/h. Derivatives by rotations scale with the unit, those by r12 do not.
PW85_TEST("/grain_contact/gradient")
{
    Failures failures;
    Random random(970);
    double const h = 1e-5, bound = 1e-6;
    for (int n = 0; n < draws(800); ++n) {
        Pair const p = random_grains(random);
        Contact const c = contact(p);
        Vector3 d[3], scaled[3];
        auto const derive = [&](Pair const &q, Vector3(&out)[3]) {
            return pw85_grain_radius_gradient(q.r12.coordinates, q.q1.entries, q.q2.entries,
                                              c.normal.coordinates, out[0].coordinates,
                                              out[1].coordinates, out[2].coordinates);
        };
        g_assert_cmpint(derive(p, d), ==, PW85_SUCCESS);
        double const unit = 0x1p300;
        derive({unit * p.r12, unit * unit * p.q1, unit * unit * p.q2}, scaled);
        auto const check = [&](char const *what, double found, double wanted, double limit) {
            failures.check(std::abs(found - wanted) <= limit, what, found, wanted,
                           [&] { return hex_text(p); });
        };
        for (int i = 0; i < 3; ++i) {
            Vector3 e{};
            e[i] = h;
            auto const difference = [&](auto const &moved) {
                return (contact(moved(1.0)).radius - contact(moved(-1.0)).radius) / (2.0 * h);
            };
            check("by r12", d[0][i], difference([&](double s) {
                      Pair q = p;
                      q.r12[i] += s * h;
                      return q;
                  }),
                  bound);
            check("by rotation 1", d[1][i],
                  difference([&](double s) { return turned(p, s * e, {}); }), bound);
            check("by rotation 2", d[2][i],
                  difference([&](double s) { return turned(p, {}, s * e); }), bound);
            check("by r12, scaled", scaled[0][i], d[0][i], 0.0);
            check("by rotation 1, scaled", scaled[1][i] / unit, d[1][i], 0.0);
            check("by rotation 2, scaled", scaled[2][i] / unit, d[2][i], 0.0);
        }
    }
}

// A wall is a plane, or curved along one direction like a cylinder. Along a principal direction of
// the grain both curvatures add up, so that pw85_hertz gives R.
PW85_TEST("/grain_contact/walls")
{
    Failures failures;
    Random random(980);
    for (int n = 0; n < draws(800); ++n) {
        auto const q = random.form(1.0, random.log_uniform(1.0, 4.0));
        Vector3 const normal = random.log_uniform(0.01, 100.0) * random.direction<3>();
        Vector3 across = pw85::cross(normal, random.direction<3>());
        double curvatures[2], directions[6], wanted, found[2], depth, radius, distance_, half;
        Vector3 point, nearest;
        auto const describe = [&] { return hex_text(q.entries, 6); };
        auto const check = [&](char const *what, double error, double bound) {
            failures.check(error <= bound, what, error, bound, describe);
        };
        pw85_curvature(normal.coordinates, q.entries, curvatures, directions);
        auto const touch = [&](Vector3 const &along, double bend) {
            half = 0.9 * norm(normal);
            return pw85_grain_contact_wall(normal.coordinates, half, along.coordinates, bend,
                                           q.entries, &depth, point.coordinates, found, &radius);
        };
        // a plane
        g_assert_cmpint(touch(across, 0.0), ==, PW85_SUCCESS);
        pw85_hertz(curvatures, &wanted, nullptr);
        pw85_distance_plane(normal.coordinates, half, q.entries, &distance_, nearest.coordinates);
        check("depth", std::abs(depth + distance_), 0.0);
        check("point", distance(point, nearest), 0.0);
        check("radius on a plane", std::abs(radius / wanted - 1.0), 128 * u);
        // along a principal direction, its curvature is added
        for (int i = 0; i < 2; ++i) {
            double const bend = random.uniform(-0.5 * curvatures[i], 2.0);
            Vector3 const along{directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]};
            g_assert_cmpint(touch(7.0 * along, bend), ==, PW85_SUCCESS);
            double sum[2] = {curvatures[0], curvatures[1]};
            sum[i] += bend;
            pw85_hertz(sum, &wanted, nullptr);
            check("radius on a cylinder", std::abs(radius / wanted - 1.0), 512 * u);
            check("smaller", std::abs(found[0] / std::min(sum[0], sum[1]) - 1.0), 512 * u);
            check("larger", std::abs(found[1] / std::max(sum[0], sum[1]) - 1.0), 512 * u);
        }
        // the trace does not depend on the direction
        g_assert_cmpint(touch(across, 0.75), ==, PW85_SUCCESS);
        check("trace", std::abs((found[0] + found[1]) / (curvatures[0] + curvatures[1] + 0.75) - 1),
              64 * u);
        // a grain that fits into a cylinder has the largest radius
        Vector3 const first{directions[0], directions[1], directions[2]};
        touch(first, -2.0 * curvatures[0]);
        check("least ratio", std::abs(found[0] / found[1] * 0x1p20 - 1.0), 0.0);
    }
}

/// The curvatures of a grain and a wall in 50 digits: eigenvalues of the sum of both second
/// fundamental forms, which is the inverse of the Schur complement of n in Q, times √(n·Qn), plus c
/// ddᵀ.
struct WallTruth {
    Wide smaller, larger;

    WallTruth(Vector3 const &normal, Vector3 const &along, double bend, Form3 const &form)
    {
        auto const q = convert<Wide>(form);
        auto const unit = [](WideVector const &x) { return Wide(1 / sqrt(pw85::dot(x, x))) * x; };
        auto const n = unit(convert<Wide>(normal)), d = unit(convert<Wide>(along));
        int k = 0; // the axis that is farthest from n
        for (int i = 1; i < 3; ++i)
            if (abs(n[i]) < abs(n[k])) k = i;
        WideVector axis{};
        axis[k] = 1;
        WideVector const e[2] = {unit(pw85::cross(n, axis)),
                                 pw85::cross(n, unit(pw85::cross(n, axis)))};
        auto const qn = pw85::product(q, n);
        Wide const extent = pw85::dot(n, qn);
        Wide s[2][2], sum[2][2];
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                s[i][j] = pw85::dot(e[i], pw85::product(q, e[j])) -
                          pw85::dot(e[i], qn) * pw85::dot(e[j], qn) / extent;
        Wide const factor = sqrt(extent) / (s[0][0] * s[1][1] - s[0][1] * s[0][1]);
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                sum[i][j] = (i == j ? s[1 - i][1 - j] : -s[i][j]) * factor +
                            Wide(bend) * pw85::dot(d, e[i]) * pw85::dot(d, e[j]);
        Wide const half = (sum[0][0] - sum[1][1]) / 2, mean = (sum[0][0] + sum[1][1]) / 2,
                   root = sqrt(half * half + sum[0][1] * sum[0][1]), least = Wide(0x1p-20);
        larger = mean + root;
        smaller = mean - root > least * larger ? mean - root : least * larger;
    }
};

/// A direction near a principal one, or any.
Vector3 direction_of_wall(Random &random, Vector3 const &normal, double const (&directions)[6],
                          int n)
{
    Vector3 along = pw85::cross(normal, random.direction<3>());
    if (n % 3 == 0) return along;
    Vector3 const aside = random.direction<3>();
    double const turn = n % 3 == 1 ? 0.0 : random.log_uniform(1e-12, 1.0);
    for (int i = 0; i < 3; ++i) along[i] = directions[3 * (n / 3 % 2) + i] + turn * aside[i];
    return along;
}

/// The curvature of a wall: convex, some 1e-3 to 1e8 times one of the grain's, or hollow, near one
/// of them.
double curvature_of_wall(Random &random, double const (&curvatures)[2], int n)
{
    double const own = curvatures[n / 2 % 2];
    if (n % 2 == 0) return own * random.log_uniform(1e-3, 1e8);
    return -own * (n % 4 == 1 ? 1.0 - random.log_uniform(1e-9, 1.0) : random.uniform(0.0, 2.0));
}

// Curvatures of grain and wall that differ by up to 10⁸, in sizes that differ by 2^80: relative
// errors below 1e-12, also of the smaller one.
PW85_TEST("/grain_contact/walls/unlike_curvatures")
{
    Failures failures;
    Random random(983);
    int hollow = 0, unlike = 0;
    for (int n = 0; n < draws(6000); ++n) {
        int const size = 40 * (n % 3 - 1);
        double const aspect = random.log_uniform(1.0, n % 5 == 0 ? 1e6 : 30.0);
        auto const q = pw85::detail::times_power_of_two(random.form(1.0, aspect), 2 * size);
        Vector3 const normal = random.log_uniform(0.01, 100.0) * random.direction<3>();
        double curvatures[2], directions[6], found[2], radius, wanted;
        pw85_curvature(normal.coordinates, q.entries, curvatures, directions);
        Vector3 const along = direction_of_wall(random, normal, directions, n);
        double const bend = curvature_of_wall(random, curvatures, n / 6);
        g_assert_cmpint(pw85_grain_contact_wall(normal.coordinates, 1.0, along.coordinates, bend,
                                                q.entries, nullptr, nullptr, found, &radius),
                        ==, PW85_SUCCESS);
        WallTruth const truth(normal, along, bend, q);
        auto const describe = [&] {
            return hex_text(q.entries, 6) + ", normal " + hex_text(normal.coordinates, 3) +
                   ", direction " + hex_text(along.coordinates, 3) + ", curvature " +
                   hex_text(&bend, 1);
        };
        failures.check(abs(Wide(found[0] - truth.smaller)) <= 1e-12 * truth.smaller, "smaller",
                       found[0], static_cast<double>(truth.smaller), describe);
        failures.check(abs(Wide(found[1] - truth.larger)) <= 1e-12 * truth.larger, "larger",
                       found[1], static_cast<double>(truth.larger), describe);
        pw85_hertz(found, &wanted, nullptr);
        failures.check(std::abs(radius / wanted - 1) <= 256 * u, "radius", radius, wanted,
                       describe);
        hollow += bend < 0;
        unlike += found[1] > 1e5 * found[0];
    }
    g_assert_cmpint(hollow, >, draws(1500));
    g_assert_cmpint(unlike, >, draws(300));
}

// The sharpest edge that a double can describe, and a wall of which the grain takes no notice.
PW85_TEST("/grain_contact/walls/extreme")
{
    Form3 const q{4.0, 0.0, 0.0, 1.0, 0.0, 9.0};
    Vector3 const up{0.0, 0.0, 1.0}, along{1.0, 0.0, 0.0};
    double found[2], radius;
    for (double const bend : {0x1p1000, -0x1p1000}) {
        g_assert_cmpint(pw85_grain_contact_wall(up.coordinates, 1.0, along.coordinates, bend,
                                                q.entries, nullptr, nullptr, found, &radius),
                        ==, PW85_SUCCESS);
        g_assert_true(found[1] == (bend > 0 ? bend : 3.0) && found[0] == 0x1p-20 * found[1]);
        g_assert_true(radius > 0);
    }
    pw85_grain_contact_wall(up.coordinates, 1.0, along.coordinates, -0x1p-1000, q.entries, nullptr,
                            nullptr, found, &radius);
    g_assert_true(found[0] == 0.75 && found[1] == 3.0);
}

// Pairs that are so deep that the overlap has no minimum, and bad forms.
PW85_TEST("/grain_contact/no contact")
{
    Form3 const sphere{1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, flat{1.0, 0.0, 0.0, 1.0, 0.0, -1.0};
    Vector3 const up{0.0, 0.0, 1.0};
    struct {
        Pair pair;
        Vector3 start;
        int status;
    } const cases[] = {
        {{{0.0, 0.0, 0.0}, sphere, sphere}, up, PW85_ECONVERGENCE},
        {{{0.0, 0.0, -1.5}, sphere, sphere}, up, PW85_ECONVERGENCE},
        {{{0.0, 0.0, 1.5}, sphere, flat}, up, PW85_ENOTPD},
        {{{0.0, 0.0, 1.5}, flat, sphere}, up, PW85_ENOTPD},
        {{{0.0, 0.0, 1.5}, sphere, sphere}, {}, PW85_EINVAL},
        {{{0.0, 0.0, 1.5}, sphere, sphere}, up, PW85_SUCCESS},
    };
    for (auto const &[p, start, status] : cases) {
        Contact one{}, many{};
        Vector3 d[3];
        g_assert_cmpint(find(p, start, one), ==, status);
        g_assert_cmpint(pw85_grain_contact_batch(1, p.r12.coordinates, p.q1.entries, p.q2.entries,
                                                 start.coordinates, many.normal.coordinates,
                                                 &many.depth, many.point.coordinates,
                                                 many.curvatures.data(), &many.radius),
                        ==, status);
        g_assert_cmpint(pw85_grain_radius_gradient(p.r12.coordinates, p.q1.entries, p.q2.entries,
                                                   start.coordinates, d[0].coordinates,
                                                   d[1].coordinates, d[2].coordinates),
                        ==, status);
        bool const bad = status != PW85_SUCCESS;
        for (Contact const &c : {one, many}) {
            g_assert_true(std::isnan(c.depth) == bad && std::isnan(c.radius) == bad);
            for (int i = 0; i < 3; ++i)
                g_assert_true(std::isnan(c.normal[i]) == bad && std::isnan(c.point[i]) == bad);
            for (double const k : c.curvatures) g_assert_true(std::isnan(k) == bad);
        }
        for (Vector3 const &x : d)
            for (int i = 0; i < 3; ++i) g_assert_true(std::isnan(x[i]) == bad);
    }
}

// Ellipsoids whose sizes differ by 10^200 have the contact of a point and a plane.
PW85_TEST("/grain_contact/unlike sizes")
{
    Form3 const large{1e200, 0.0, 0.0, 1e200, 0.0, 1e200},
        small_{1e-200, 0.0, 0.0, 1e-200, 0.0, 1e-200};
    Vector3 const up{0.0, 0.0, 1.0};
    for (bool const swap : {false, true}) {
        Contact const c = swap ? contact({1e100 * up, small_, large}, up)
                               : contact({1e100 * up, large, small_}, up);
        g_assert_true(std::abs(c.radius / 1e-100 - 1.0) < 64 * u);
        g_assert_true(std::abs(c.curvatures[0] / 1e100 - 1.0) < 64 * u);
    }
}

// Rows have the contacts of single pairs, to the accuracy of both, wherever they stand, and the
// same bits in every place. Some rows are bad, some have curvatures beyond the fit.
PW85_TEST("/grain_contact/rows")
{
    Failures failures;
    Random random(990);
    auto const n = static_cast<std::size_t>(draws(2000));
    std::vector<double> r12, q1, q2, starts;
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < n; ++i) {
        Pair p = i % 7 == 3 ? random_pair<3>(random, {400.0, 8.0, 0.99999, 0.999999})
                            : random_grains(random);
        if (i % 11 == 5) p.q1[0] = -1.0;
        double const unit = i % 5 == 1 ? 0x1p-20 : i % 13 == 2 ? 0x1p80 : 1.0;
        p = {unit * p.r12, unit * unit * p.q1, unit * unit * p.q2};
        pairs.push_back(p);
        Vector3 const start = p.q1[0] > 0.0 ? contact_normal(p) : p.r12;
        for (int k = 0; k < 3; ++k) r12.push_back(p.r12[k]);
        for (int k = 0; k < 3; ++k) starts.push_back(start[k]);
        for (int k = 0; k < 6; ++k) q1.push_back(p.q1[k]);
        for (int k = 0; k < 6; ++k) q2.push_back(p.q2[k]);
    }
    std::vector<double> normal(3 * n), depth(n), point(3 * n), curvatures(2 * n), radius(n);
    g_assert_cmpint(pw85_grain_contact_batch(n, r12.data(), q1.data(), q2.data(), starts.data(),
                                             normal.data(), depth.data(), point.data(),
                                             curvatures.data(), radius.data()),
                    ==, PW85_ENOTPD);
    for (std::size_t i = 0; i < n; ++i) {
        auto const row = [&](std::vector<double> const &x, std::size_t k) {
            return Vector3{x[3 * i + k], x[3 * i + k + 1], x[3 * i + k + 2]};
        };
        Contact one{}, again{};
        int const status = find(pairs[i], row(starts, 0), one);
        auto const describe = [&] { return hex_text(pairs[i]); };
        if (status != PW85_SUCCESS) {
            failures.check(std::isnan(depth[i]) && std::isnan(radius[i]), "NaN", depth[i], 0.0,
                           describe);
            continue;
        }
        double const unit = std::sqrt(std::max({pairs[i].q1[0], pairs[i].q1[3], pairs[i].q1[5]}));
        Contact const many{row(normal, 0),
                           depth[i],
                           row(point, 0),
                           {curvatures[2 * i], curvatures[2 * i + 1]},
                           radius[i]};
        auto const scaled = [&](Contact c) {
            c.depth /= unit;
            c.point = (1.0 / unit) * c.point;
            return c;
        };
        // For aspect ratios up to 400 both lose a factor of its square.
        check_same(scaled(many), scaled(one), i % 7 == 3 ? 400.0 * 400.0 * accuracy : accuracy,
                   failures, pairs[i]);
        pw85_grain_contact_batch(1, &r12[3 * i], &q1[6 * i], &q2[6 * i], &starts[3 * i],
                                 again.normal.coordinates, &again.depth, again.point.coordinates,
                                 again.curvatures.data(), &again.radius);
        check_same(again, many, 0.0, failures, pairs[i]);
    }
}

} // namespace
