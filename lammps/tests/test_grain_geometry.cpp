// SPDX-License-Identifier: GPL-2.0-only
// The contacts of many pairs at a time (grain_geometry.hpp): equations of the contact, the
// library's Hertzian radius, invariances, and the derivatives of the radius.
#include <array>
#include <cmath>
#include <string>

#include <glib.h>

#include <pw85.h>

#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"

#include "grain_geometry.hpp"

using namespace pw85_lammps;
using namespace pw85_tests;

namespace {

using Pair = Sample<double, 3>;

/// After the last step, which is below 2^-22, the normal errs by the square of the step times a
/// ratio of third and second derivatives, which is below 100 for aspect ratios up to 4 and small
/// depths: 6e-12. So do points and curvatures.
constexpr double accuracy = 6e-12;

/// Pairs that overlap by some percent.
Pair random_grains(Random &random) { return random_pair<3>(random, {4.0, 8.0, 0.94, 0.999}); }

Vector array(pw85::Vector<double, 3> const &x) { return {x[0], x[1], x[2]}; }

Vector contact_normal(Pair const &p)
{
    double out[2];
    Vector normal{};
    pw85_contact_function(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    pw85_contact_geometry(p.r12.coordinates, p.q1.entries, p.q2.entries, out[1], nullptr,
                          normal.data());
    return normal;
}

/// The contact that a search finds from a start, in a place among others.
GrainGeometry contact(Pair const &p, Vector const &start, std::size_t place = 0)
{
    static GrainSearch search;
    search.clear();
    Vector const up{0.0, 0.0, 1.0};
    double const sphere[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    while (search.size() < place) search.add({0.3, 0.2, 1.7}, sphere, sphere, up);
    search.add(array(p.r12), p.q1.entries, p.q2.entries, start);
    search.solve();
    return search.contact(place);
}

GrainGeometry contact(Pair const &p) { return contact(p, contact_normal(p)); }

double distance(Vector const &a, Vector const &b) { return std::sqrt(dot(a - b, a - b)); }

void check_same(GrainGeometry const &a, GrainGeometry const &b, double bound, Failures &failures,
                Pair const &p)
{
    auto const describe = [&] { return hex_text(p); };
    auto const check = [&](char const *what, double error) {
        failures.check(error <= bound, what, error, bound, describe);
    };
    check("normal", distance(a.normal, b.normal));
    check("depth", std::abs(a.depth - b.depth));
    check("arm 1", distance(a.arm1, b.arm1));
    check("arm 2", distance(a.arm2, b.arm2));
    check("radius", std::abs(a.radius / b.radius - 1.0));
}

// The points are those of pw85_hertz_contact for the normal, and a depth apart along it; the radius
// is that of pw85_hertz_contact.
void test_equations()
{
    Failures failures;
    Random random(910);
    for (int n = 0; n < draws(8000); ++n) {
        Pair const p = random_grains(random);
        auto const describe = [&] { return hex_text(p); };
        GrainGeometry const g = contact(p);
        double depth, radius;
        Vector point{};
        pw85_hertz_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, g.normal.data(), &depth,
                           point.data(), nullptr, nullptr, &radius, nullptr);
        Vector const gap = g.arm1 - (array(p.r12) + g.arm2),
                     middle = g.arm1 - 0.5 * g.depth * g.normal;
        auto const check = [&](char const *what, double error) {
            failures.check(error <= accuracy, what, error, accuracy, describe);
        };
        check("gap along the normal", distance(gap, g.depth * g.normal));
        check("depth", std::abs(depth - g.depth));
        check("middle", distance(point, middle));
        check("radius", std::abs(g.radius / radius - 1.0));
    }
}

// Ellipsoids tip to tip, whose curvatures have any ratio, also beyond that of the approximation.
// The approximation errs by 7e-16, and the roundings of the five means and of the ratio of
// curvatures by some 30 u.
void test_ratios()
{
    Failures failures;
    Random random(920);
    for (int n = 0; n < draws(8000); ++n) {
        double const aspect = random.log_uniform(1.0, 400.0);
        Pair const p{{0.0, 0.0, 1.999},
                     {1.0, 0.0, 0.0, 1.0 / (aspect * aspect), 0.0, 1.0},
                     {1.0, 0.0, 0.0, 1.0 / (aspect * aspect), 0.0, 1.0}};
        double const curvatures[2] = {2.0, 2.0 / p.q1.entries[3]};
        double radius;
        pw85_hertz(curvatures, &radius, nullptr);
        double const error = std::abs(contact(p, {0.0, 0.0, 1.0}).radius / radius - 1.0);
        failures.check(error <= 64 * 0x1p-53, "radius", error, 64 * 0x1p-53,
                       [&] { return hex_text(p); });
    }
}

// A contact depends neither on where the search starts, nor on the place of the pair among others.
// In the other order, ellipsoids have the same contact.
void test_starts()
{
    Failures failures;
    Random random(930);
    for (int n = 0; n < draws(4000); ++n) {
        Pair const p = random_grains(random);
        GrainGeometry const g = contact(p);
        Vector start = g.normal + random.log_uniform(1e-9, 1e-2) * array(random.direction<3>());
        start = (1.0 / std::sqrt(dot(start, start))) * start;
        check_same(contact(p, start), g, accuracy, failures, p);
        check_same(
            contact(p, contact_normal(p), static_cast<std::size_t>(n) % GrainSearch::capacity), g,
            0.0, failures, p);
        GrainGeometry const other = contact({-p.r12, p.q2, p.q1});
        check_same({-1.0 * other.normal, other.depth, other.arm2, other.arm1, other.radius}, g,
                   accuracy, failures, p);
    }
}

// Units that are powers of two change no bit.
void test_sizes()
{
    Failures failures;
    Random random(940);
    for (int n = 0; n < draws(2000); ++n) {
        Pair const p = random_grains(random);
        GrainGeometry const g = contact(p);
        for (int const e : {-40, 40}) {
            double const unit = std::ldexp(1.0, e);
            GrainGeometry s = contact({unit * p.r12, unit * unit * p.q1, unit * unit * p.q2});
            s = {s.normal, s.depth / unit, (1.0 / unit) * s.arm1, (1.0 / unit) * s.arm2,
                 s.radius / unit};
            check_same(s, g, 0.0, failures, p);
        }
    }
}

Pair turned(Pair const &p, Vector const &omega1, Vector const &omega2)
{
    auto const form = [](pw85::SymmetricMatrix<double, 3> const &q, Vector const &omega) {
        pw85::SymmetricMatrix<double, 3> result{};
        auto const wide =
            rotated(convert<Wide>(q), {Wide(omega[0]), Wide(omega[1]), Wide(omega[2])});
        for (int k = 0; k < 6; ++k) result[k] = static_cast<double>(wide[k]);
        return result;
    };
    return {p.r12, form(p.q1, omega1), form(p.q2, omega2)};
}

/// x after rotation by |ω| about ω.
Vector rotated_vector(Vector const &x, Vector const &omega)
{
    double const angle = std::sqrt(dot(omega, omega));
    Vector const axis = (1.0 / angle) * omega;
    return std::cos(angle) * x + std::sin(angle) * cross(axis, x) +
           ((1.0 - std::cos(angle)) * dot(axis, x)) * axis;
}

void test_rotations()
{
    Failures failures;
    Random random(950);
    for (int n = 0; n < draws(800); ++n) {
        Pair const p = random_grains(random);
        Vector const omega = random.uniform(0.1, 3.0) * array(random.direction<3>());
        auto const turn = [&](Vector const &x) { return rotated_vector(x, omega); };
        Pair joint = turned(p, omega, omega);
        Vector const r12 = turn(array(p.r12));
        joint.r12 = {r12[0], r12[1], r12[2]};
        GrainGeometry const g = contact(p);
        check_same(contact(joint), {turn(g.normal), g.depth, turn(g.arm1), turn(g.arm2), g.radius},
                   accuracy, failures, p);
    }
}

// While grains turn steadily, radius and depth have no jumps. Their second differences are h² times
// second derivatives, which are below 500 for aspect ratios up to 4. Each search starts from the
// normal before, as in a run.
void test_path()
{
    Failures failures;
    Random random(960);
    double const h = 1e-3;
    for (int n = 0; n < draws(16); ++n) {
        Pair const p = random_grains(random);
        Vector const omega = array(random.direction<3>());
        GrainGeometry g = contact(p);
        std::array<double, 2> last{g.radius, g.depth}, difference{};
        for (int i = 1; i < 100; ++i) {
            g = contact(turned(p, (i * h) * omega, {}), g.normal);
            std::array<double, 2> const now{g.radius, g.depth};
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
// accuracy/h.
void test_gradient()
{
    Failures failures;
    Random random(970);
    double const h = 1e-5, bound = 1e-6;
    for (int n = 0; n < draws(800); ++n) {
        Pair const p = random_grains(random);
        GrainGeometry const g = contact(p);
        RadiusGradient const d = radius_gradient(p.q1.entries, p.q2.entries, g.normal, g.depth);
        for (std::size_t i = 0; i < 3; ++i) {
            Vector e{};
            e[i] = h;
            auto const difference = [&](auto const &moved) {
                return (contact(moved(1.0)).radius - contact(moved(-1.0)).radius) / (2.0 * h);
            };
            auto const check = [&](char const *what, double found, double wanted) {
                failures.check(std::abs(found - wanted) <= bound, what, found, wanted,
                               [&] { return hex_text(p); });
            };
            check("by r12", d.r12[i], difference([&](double s) {
                      Pair q = p;
                      q.r12[static_cast<int>(i)] += s * h;
                      return q;
                  }));
            check("by rotation 1", d.rotation1[i],
                  difference([&](double s) { return turned(p, s * e, {}); }));
            check("by rotation 2", d.rotation2[i],
                  difference([&](double s) { return turned(p, {}, s * e); }));
        }
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/grains/equations", test_equations);
    g_test_add_func("/grains/ratios", test_ratios);
    g_test_add_func("/grains/starts", test_starts);
    g_test_add_func("/grains/sizes", test_sizes);
    g_test_add_func("/grains/rotations", test_rotations);
    g_test_add_func("/grains/path", test_path);
    g_test_add_func("/grains/gradient", test_gradient);
    return g_test_run();
}
