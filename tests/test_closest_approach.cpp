// SPDX-License-Identifier: BSD-3-Clause
// Tests of the distance of closest approach, in two and three dimensions, and of the contact
// function of ellipses.
#include <cmath>

#include <glib.h>

#include <pw85.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

// μ² is quadratic in the separation: at the distance of closest approach μ² = 1. Half of the errors
// of μ² (4 u cond each way) and a few roundings.
PW85_TEST("/closest_approach/contact")
{
    Failures failures;
    Random random(90);
    for (int n = 0; n < draws(20000); ++n) {
        auto const p = random_pair<3>(random, {.aspect = 1e3, .size_ratio = 100.0});
        double const length = random.log_uniform(1e-140, 1e140);
        auto const direction = length * random.direction<3>();
        double distance, out[2];
        int const status =
            pw85_closest_approach(direction.coordinates, p.q1.entries, p.q2.entries, &distance);
        auto const describe = [&] {
            return "direction = " + hex_text(direction.coordinates, 3) + ", " + hex_text(p);
        };
        if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) continue;
        double const norm =
            length * std::sqrt(pw85::dot(1.0 / length * direction, 1.0 / length * direction));
        Sample<double, 3> const tangent{distance / norm * direction, p.q1, p.q2};
        pw85_contact(tangent.r12.coordinates, p.q1.entries, p.q2.entries, out);
        double const bound = 10 * u * condition_number(tangent, out[1]) + 16 * u;
        failures.check(std::fabs(out[0] - 1.0) <= bound, "mu^2 at closest approach", out[0], 1.0,
                       describe);
    }
}

// The plane z = 0 cuts two ellipsoids with a principal axis along z in two ellipses; separations in
// the plane have the same contact function in two and three dimensions.
PW85_TEST("/closest_approach/two_dimensions")
{
    Failures failures;
    Random random(91);
    for (int n = 0; n < draws(20000); ++n) {
        auto const p = random_pair<2>(random, {.aspect = 1e3, .size_ratio = 100.0});
        auto const raised = [&](pw85::SymmetricMatrix<double, 2> const &q) {
            double const z = random.log_uniform(1e-3, 1e3);
            return pw85::SymmetricMatrix<double, 3>{q[0], q[1], 0.0, q[2], 0.0, z * z};
        };
        Sample<double, 3> const solid{{p.r12[0], p.r12[1], 0.0}, raised(p.q1), raised(p.q2)};
        double flat_out[2], out[2];
        auto const describe = [&] { return hex_text(p); };
        pw85_contact_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, flat_out);
        pw85_contact(solid.r12.coordinates, solid.q1.entries, solid.q2.entries, out);
        double const bound = 8 * u * condition_number(p, flat_out[1]) * out[0];
        failures.check(std::fabs(flat_out[0] - out[0]) <= bound, "mu^2", flat_out[0], out[0],
                       describe);
        double flat_distance, distance;
        pw85_closest_approach_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, &flat_distance);
        pw85_closest_approach(solid.r12.coordinates, solid.q1.entries, solid.q2.entries, &distance);
        failures.check(std::fabs(flat_distance - distance) <= bound / out[0] * distance, "distance",
                       flat_distance, distance, describe);
    }
}

PW85_TEST("/closest_approach/contact_2d")
{
    Failures failures;
    Random random(92);
    for (int n = 0; n < draws(10000); ++n) {
        auto const p = random_pair<2>(random, {.aspect = 1e6, .size_ratio = 1e4});
        double out[2];
        auto const describe = [&] { return hex_text(p); };
        int const status = pw85_contact_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        // A form this slender can lose its definiteness when it is rounded.
        if (status == PW85_ENOTPD) continue;
        if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) continue;
        double const units = error_in_units(out[0], truth<Wide>(p));
        failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
    }
}

PW85_TEST("/closest_approach/by_hand")
{
    double const x[3] = {2.0, 0.0, 0.0}, q1[6] = {9.0, 0.0, 0.0, 1.0, 0.0, 4.0},
                 q2[6] = {25.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double const flat1[3] = {9.0, 0.0, 1.0}, flat2[3] = {25.0, 0.0, 1.0};
    double distance, out[2];
    g_assert_cmpint(pw85_closest_approach(x, q1, q2, &distance), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(distance - 8.0), <=, 16 * u);
    g_assert_cmpint(pw85_closest_approach_2d(x, flat1, flat2, &distance), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(distance - 8.0), <=, 16 * u);
    g_assert_cmpint(pw85_contact_2d(x, flat1, flat2, out), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(out[0] - 0.0625), <=, u);
    g_assert_cmpfloat(std::fabs(out[1] - 0.375), <=, 2 * u);
}

} // namespace
