// SPDX-License-Identifier: BSD-3-Clause
// Every function that takes lengths gives corresponding results at other scales. Pairs of various
// sizes and size ratios are multiplied by a power of two; the results must change by the powers of
// it that belong to their units. Functions of time have another unit of time, too.
#include <cmath>
#include <functional>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_systems.h>

#include "draws.hpp"
#include "failures.hpp"
#include "flights.hpp"
#include "systems.hpp"

using namespace pw85_tests;

namespace {

/// What functions are called with: a pair, a pair in two dimensions, how they move, and what is
/// made of them.
struct Problem {
    Flight<double, 3> flight;
    Sample<double, 2> plane;
    double cell; ///< the side of a cubic one
    double direction[3];
    std::vector<double> centers, forms; ///< of particles
    std::vector<pw85_motion> motions;
};

/// The largest aspect ratio, and what two results of lanes, which may be more or less exact than
/// those of one pair, may differ by: 64 u aspect² of the largest coordinate each
/// (tests/batch/test_derivatives.cpp), more than the 4 u cond of μ².
constexpr double largest_aspect = 20.0,
                 difference_of_lanes = 2.0 * 64.0 * 0x1p-53 * largest_aspect * largest_aspect;

/// Results, each with the powers of length and of time in its unit, and by how much it may differ:
/// 0 where the bits are the same.
struct Results {
    struct Result {
        double value;
        int length, time;
        double difference;
    };
    std::vector<Result> all;

    void add(double const *values, std::size_t count, int length, int time = 0)
    {
        for (std::size_t i = 0; i < count; ++i) all.push_back({values[i], length, time, 0.0});
    }
    void add(int value) { all.push_back({static_cast<double>(value), 0, 0, 0.0}); }

    /// Results of lanes; `size` is that of what they are made of.
    void add_lanes(double const *values, std::size_t count, int length, double size = 0.0)
    {
        for (std::size_t i = 0; i < count; ++i) size = std::fmax(size, std::fabs(values[i]));
        for (std::size_t i = 0; i < count; ++i)
            all.push_back({values[i], length, 0, difference_of_lanes * size});
    }
};

constexpr std::size_t particles = 12, pairs_of_all = particles * (particles - 1) / 2;

/// All pairs of particles.
std::vector<int32_t> all_pairs()
{
    std::vector<int32_t> pairs;
    for (int i = 0; i < static_cast<int>(particles); ++i)
        for (int j = 0; j < i; ++j) pairs.insert(pairs.end(), {i, j});
    return pairs;
}

struct Function {
    char const *name;
    std::function<void(Problem const &, Results &)> call;
};

using Table = std::vector<Function>;

double const *r12(Problem const &p) { return p.flight.start.r12.coordinates; }
double const *q1(Problem const &p) { return p.flight.start.q1.entries; }
double const *q2(Problem const &p) { return p.flight.start.q2.entries; }

double lambda_of(Problem const &p)
{
    double out[2];
    pw85_contact(r12(p), q1(p), q2(p), out);
    return out[1];
}

double lambda_in_plane(Problem const &p)
{
    double out[2];
    pw85_contact_2d(p.plane.r12.coordinates, p.plane.q1.entries, p.plane.q2.entries, out);
    return out[1];
}

/// Second derivatives with respect to r12 and rotations, of what has a power of length.
void add_hessian(Results &out, double const *hessian, int dimension, int axes, int power)
{
    int const size = dimension + 2 * axes;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j)
            out.add(hessian + size * i + j, 1,
                    power - (i < dimension ? 1 : 0) - (j < dimension ? 1 : 0));
}

Table const functions_of_pairs = {
    {"contact",
     [](Problem const &p, Results &out) {
         double value[2];
         out.add(pw85_contact(r12(p), q1(p), q2(p), value));
         out.add(value, 2, 0);
     }},
    {"contact_function",
     [](Problem const &p, Results &out) {
         double value[2];
         out.add(pw85_contact_function(r12(p), q1(p), q2(p), value));
         out.add(value, 2, 0);
     }},
    {"contact_geometry",
     [](Problem const &p, Results &out) {
         double point[3], normal[3];
         out.add(pw85_contact_geometry(r12(p), q1(p), q2(p), lambda_of(p), point, normal));
         out.add(point, 3, 1);
         out.add(normal, 3, 0);
     }},
    {"contact_gradient",
     [](Problem const &p, Results &out) {
         double r[3], d1[6], d2[6];
         out.add(pw85_contact_gradient(r12(p), q1(p), q2(p), lambda_of(p), r, d1, d2));
         out.add(r, 3, -1);
         out.add(d1, 6, -2);
         out.add(d2, 6, -2);
     }},
    {"contact_torque",
     [](Problem const &p, Results &out) {
         double d1[3], d2[3];
         out.add(pw85_contact_torque(r12(p), q1(p), q2(p), lambda_of(p), d1, d2));
         out.add(d1, 3, 0);
         out.add(d2, 3, 0);
     }},
    {"contact_hessian",
     [](Problem const &p, Results &out) {
         double hessian[81];
         out.add(pw85_contact_hessian(r12(p), q1(p), q2(p), lambda_of(p), hessian));
         add_hessian(out, hessian, 3, 3, 0);
     }},
    {"overlap",
     [](Problem const &p, Results &out) {
         int overlap;
         out.add(pw85_overlap(r12(p), q1(p), q2(p), &overlap));
         out.add(overlap);
     }},
    {"closest_approach",
     [](Problem const &p, Results &out) {
         double distance;
         out.add(pw85_closest_approach(p.direction, q1(p), q2(p), &distance));
         out.add(&distance, 1, 1);
     }},
    {"closest_approach along r12",
     [](Problem const &p, Results &out) {
         double distance;
         out.add(pw85_closest_approach(r12(p), q1(p), q2(p), &distance));
         out.add(&distance, 1, 1);
     }},
    {"distance",
     [](Problem const &p, Results &out) {
         double distance, point1[3], point2[3];
         out.add(pw85_distance(r12(p), q1(p), q2(p), &distance, point1, point2));
         out.add(&distance, 1, 1);
         out.add(point1, 3, 1);
         out.add(point2, 3, 1);
     }},
    {"distance_derivatives",
     [](Problem const &p, Results &out) {
         double r[3], d1[3], d2[3], hessian[81];
         out.add(pw85_distance_derivatives(r12(p), q1(p), q2(p), r, d1, d2, hessian));
         out.add(r, 3, 0);
         out.add(d1, 3, 1);
         out.add(d2, 3, 1);
         add_hessian(out, hessian, 3, 3, 1);
     }},
    {"penetration",
     [](Problem const &p, Results &out) {
         double depth, direction[3];
         out.add(pw85_penetration(r12(p), q1(p), q2(p), &depth, direction));
         out.add(&depth, 1, 1);
         out.add(direction, 3, 0);
     }},
    {"signed_distance",
     [](Problem const &p, Results &out) {
         double distance, point1[3], point2[3];
         out.add(pw85_signed_distance(r12(p), q1(p), q2(p), &distance, point1, point2));
         out.add(&distance, 1, 1);
         out.add(point1, 3, 1);
         out.add(point2, 3, 1);
     }},
    {"signed_distance_derivatives",
     [](Problem const &p, Results &out) {
         double r[3], d1[3], d2[3], hessian[81];
         out.add(pw85_signed_distance_derivatives(r12(p), q1(p), q2(p), r, d1, d2, hessian));
         out.add(r, 3, 0);
         out.add(d1, 3, 1);
         out.add(d2, 3, 1);
         add_hessian(out, hessian, 3, 3, 1);
     }},
};

Table const functions_of_motion = {
    {"first_contact",
     [](Problem const &p, Results &out) {
         auto const c = first_contact(p.flight);
         out.add(static_cast<int>(c.status));
         out.add(&c.time, 1, 0, 1);
     }},
    {"first_contact of translation",
     [](Problem const &p, Results &out) {
         auto f = p.flight;
         f.motion1.angular_velocity = f.motion2.angular_velocity = {};
         f.motion1.growth = f.motion2.growth = 0.0;
         auto const c = first_contact(f);
         out.add(static_cast<int>(c.status));
         out.add(&c.time, 1, 0, 1);
     }},
    {"first_contact of rotation",
     [](Problem const &p, Results &out) {
         auto f = p.flight;
         f.motion1.growth = f.motion2.growth = 0.0;
         auto const c = first_contact(f);
         out.add(static_cast<int>(c.status));
         out.add(&c.time, 1, 0, 1);
     }},
    {"first_contact of growth, without an end",
     [](Problem const &p, Results &out) {
         auto f = p.flight;
         f.motion1 = f.motion2 = {{}, {}, std::fabs(f.motion1.growth)};
         f.end = std::numeric_limits<double>::infinity();
         auto const c = first_contact(f);
         out.add(static_cast<int>(c.status));
         out.add(&c.time, 1, 0, 1);
     }},
    {"first_contact_batch",
     [](Problem const &p, Results &out) {
         pw85_motion const motion1 = c_motion(p.flight.motion1),
                           motion2 = c_motion(p.flight.motion2);
         double time;
         out.add(pw85_first_contact_batch(1, r12(p), q1(p), q2(p), &motion1, &motion2, p.flight.end,
                                          &time));
         out.add(&time, 1, 0, 1);
     }},
};

Table const functions_of_plane = {
    {"contact_2d",
     [](Problem const &p, Results &out) {
         double value[2];
         out.add(pw85_contact_2d(p.plane.r12.coordinates, p.plane.q1.entries, p.plane.q2.entries,
                                 value));
         out.add(value, 2, 0);
     }},
    {"contact_geometry_2d",
     [](Problem const &p, Results &out) {
         double point[2], normal[2];
         out.add(pw85_contact_geometry_2d(p.plane.r12.coordinates, p.plane.q1.entries,
                                          p.plane.q2.entries, lambda_in_plane(p), point, normal));
         out.add(point, 2, 1);
         out.add(normal, 2, 0);
     }},
    {"contact_gradient_2d",
     [](Problem const &p, Results &out) {
         double r[2], d1[3], d2[3];
         out.add(pw85_contact_gradient_2d(p.plane.r12.coordinates, p.plane.q1.entries,
                                          p.plane.q2.entries, lambda_in_plane(p), r, d1, d2));
         out.add(r, 2, -1);
         out.add(d1, 3, -2);
         out.add(d2, 3, -2);
     }},
    {"contact_torque_2d",
     [](Problem const &p, Results &out) {
         double d1, d2;
         out.add(pw85_contact_torque_2d(p.plane.r12.coordinates, p.plane.q1.entries,
                                        p.plane.q2.entries, lambda_in_plane(p), &d1, &d2));
         out.add(&d1, 1, 0);
         out.add(&d2, 1, 0);
     }},
    {"contact_hessian_2d",
     [](Problem const &p, Results &out) {
         double hessian[16];
         out.add(pw85_contact_hessian_2d(p.plane.r12.coordinates, p.plane.q1.entries,
                                         p.plane.q2.entries, lambda_in_plane(p), hessian));
         add_hessian(out, hessian, 2, 1, 0);
     }},
    {"overlap_2d",
     [](Problem const &p, Results &out) {
         int overlap;
         out.add(pw85_overlap_2d(p.plane.r12.coordinates, p.plane.q1.entries, p.plane.q2.entries,
                                 &overlap));
         out.add(overlap);
     }},
    {"closest_approach_2d",
     [](Problem const &p, Results &out) {
         double distance;
         out.add(pw85_closest_approach_2d(p.direction, p.plane.q1.entries, p.plane.q2.entries,
                                          &distance));
         out.add(&distance, 1, 1);
     }},
    {"distance_2d",
     [](Problem const &p, Results &out) {
         double distance, point1[2], point2[2];
         out.add(pw85_distance_2d(p.plane.r12.coordinates, p.plane.q1.entries, p.plane.q2.entries,
                                  &distance, point1, point2));
         out.add(&distance, 1, 1);
         out.add(point1, 2, 1);
         out.add(point2, 2, 1);
     }},
    {"contact_batch_2d",
     [](Problem const &p, Results &out) {
         double mu2, lambda;
         out.add(pw85_contact_batch_2d(1, p.plane.r12.coordinates, p.plane.q1.entries,
                                       p.plane.q2.entries, &mu2, &lambda));
         out.add_lanes(&mu2, 1, 0);
         out.add_lanes(&lambda, 1, 0);
     }},
    {"overlap_batch_2d",
     [](Problem const &p, Results &out) {
         unsigned char overlap;
         out.add(pw85_overlap_batch_2d(1, p.plane.r12.coordinates, p.plane.q1.entries,
                                       p.plane.q2.entries, &overlap));
         out.add(overlap);
     }},
};

// One ellipsoid, with a wall at the place, and of the size, of the other.
Table const functions_of_walls = {
    {"distance_plane",
     [](Problem const &p, Results &out) {
         double distance, point[3];
         out.add(pw85_distance_plane(p.direction, r12(p)[0], q1(p), &distance, point));
         out.add(&distance, 1, 1);
         out.add(point, 3, 1);
     }},
    {"distance_plane_derivatives",
     [](Problem const &p, Results &out) {
         double center[3], rotation[3];
         out.add(pw85_distance_plane_derivatives(p.direction, q1(p), center, rotation));
         out.add(center, 3, 0);
         out.add(rotation, 3, 1);
     }},
    {"contact_plane",
     [](Problem const &p, Results &out) {
         double mu2, point[3];
         out.add(pw85_contact_plane(p.direction, std::fabs(r12(p)[0]), q1(p), &mu2, point));
         out.add(&mu2, 1, 0);
         out.add(point, 3, 1);
     }},
    {"contact_plane_derivatives",
     [](Problem const &p, Results &out) {
         double center[3], rotation[3];
         out.add(pw85_contact_plane_derivatives(p.direction, std::fabs(r12(p)[0]), q1(p), center,
                                                rotation));
         out.add(center, 3, -1);
         out.add(rotation, 3, 0);
     }},
    {"distance_box",
     [](Problem const &p, Results &out) {
         double lower[3], upper[3], distance, point[3], normal[3];
         for (int i = 0; i < 3; ++i) {
             double const half = std::sqrt(p.flight.start.q2(i, i));
             lower[i] = r12(p)[i] - half, upper[i] = r12(p)[i] + half;
         }
         out.add(pw85_distance_box(lower, upper, q1(p), &distance, point, normal));
         out.add(&distance, 1, 1);
         out.add(point, 3, 1);
         out.add(normal, 3, 0);
     }},
    {"distance_segment",
     [](Problem const &p, Results &out) {
         double const end2[3] = {r12(p)[1], r12(p)[2], r12(p)[0]};
         double distance, point1[3], point2[3], normal[3];
         out.add(pw85_distance_segment(r12(p), end2, q1(p), &distance, point1, point2, normal));
         out.add(&distance, 1, 1);
         out.add(point1, 3, 1);
         out.add(point2, 3, 1);
         out.add(normal, 3, 0);
     }},
    {"distance_solid_box",
     [](Problem const &p, Results &out) {
         double lower[3], upper[3], distance, point1[3], point2[3], normal[3];
         for (int i = 0; i < 3; ++i) {
             double const half = std::sqrt(p.flight.start.q2(i, i));
             lower[i] = r12(p)[i] - half, upper[i] = r12(p)[i] + half;
         }
         out.add(pw85_distance_solid_box(lower, upper, q1(p), &distance, point1, point2, normal));
         out.add(&distance, 1, 1);
         out.add(point1, 3, 1);
         out.add(point2, 3, 1);
         out.add(normal, 3, 0);
     }},
    {"distance_cylinder",
     [](Problem const &p, Results &out) {
         double distance, point[3], normal[3], radius = std::sqrt(q2(p)[0]);
         out.add(
             pw85_distance_cylinder(p.direction, radius, r12(p), q1(p), &distance, point, normal));
         out.add(&distance, 1, 1);
         out.add(point, 3, 1);
         out.add(normal, 3, 0);
     }},
    {"distance_point",
     [](Problem const &p, Results &out) {
         double distance, point[3], normal[3];
         out.add(pw85_distance_point(r12(p), q1(p), &distance, point, normal));
         out.add(&distance, 1, 1);
         out.add(point, 3, 1);
         out.add(normal, 3, 0);
     }},
    {"intersect_line",
     [](Problem const &p, Results &out) {
         double t[2];
         double const towards[3] = {p.direction[0] - r12(p)[0] / norm(p.flight.start.r12),
                                    p.direction[1] - r12(p)[1] / norm(p.flight.start.r12),
                                    p.direction[2]};
         out.add(pw85_intersect_line(r12(p), towards, q1(p), t));
         out.add(t, 2, 1);
     }},
};

Table const functions_of_batches = {
    {"contact_batch",
     [](Problem const &p, Results &out) {
         double mu2, lambda;
         out.add(pw85_contact_batch(1, r12(p), q1(p), q2(p), &mu2, &lambda));
         out.add_lanes(&mu2, 1, 0);
         out.add_lanes(&lambda, 1, 0);
     }},
    {"overlap_batch",
     [](Problem const &p, Results &out) {
         unsigned char overlap;
         out.add(pw85_overlap_batch(1, r12(p), q1(p), q2(p), &overlap));
         out.add(overlap);
     }},
    {"closest_approach_batch",
     [](Problem const &p, Results &out) {
         double distance;
         out.add(pw85_closest_approach_batch(1, p.direction, q1(p), q2(p), &distance));
         out.add_lanes(&distance, 1, 1);
     }},
    {"contact_derivatives_batch",
     [](Problem const &p, Results &out) {
         double mu2, lambda, point[3], normal[3], r[3], d1[3], d2[3];
         out.add(pw85_contact_derivatives_batch(1, r12(p), q1(p), q2(p), &mu2, &lambda, point,
                                                normal, r, d1, d2));
         double const arm = std::hypot(r[0], r[1], r[2]) * norm(p.flight.start.r12);
         out.add_lanes(&mu2, 1, 0);
         out.add_lanes(&lambda, 1, 0);
         out.add_lanes(point, 3, 1);
         out.add_lanes(normal, 3, 0);
         out.add_lanes(r, 3, -1);
         out.add_lanes(d1, 3, 0, arm);
         out.add_lanes(d2, 3, 0, arm);
     }},
    {"distance_batch",
     [](Problem const &p, Results &out) {
         double distance, point1[3], point2[3];
         out.add(pw85_distance_batch(1, r12(p), q1(p), q2(p), &distance, point1, point2));
         out.add_lanes(&distance, 1, 1);
         out.add_lanes(point1, 3, 1, norm(p.flight.start.r12));
         out.add_lanes(point2, 3, 1, norm(p.flight.start.r12));
     }},
    {"penetration_batch",
     [](Problem const &p, Results &out) {
         double depth, direction[3];
         out.add(pw85_penetration_batch(1, r12(p), q1(p), q2(p), &depth, direction));
         out.add(&depth, 1, 1);
         out.add(direction, 3, 0);
     }},
    {"signed_distance_batch",
     [](Problem const &p, Results &out) {
         double distance, point1[3], point2[3];
         out.add(pw85_signed_distance_batch(1, r12(p), q1(p), q2(p), &distance, point1, point2));
         out.add(&distance, 1, 1);
         out.add(point1, 3, 1);
         out.add(point2, 3, 1);
     }},
    {"signed_distance_derivatives_batch",
     [](Problem const &p, Results &out) {
         double r[3], d1[3], d2[3], hessian[81];
         out.add(
             pw85_signed_distance_derivatives_batch(1, r12(p), q1(p), q2(p), r, d1, d2, hessian));
         out.add(r, 3, 0);
         out.add(d1, 3, 1);
         out.add(d2, 3, 1);
         add_hessian(out, hessian, 3, 3, 1);
     }},
    {"distance_plane_batch",
     [](Problem const &p, Results &out) {
         double distance, point[3];
         out.add(pw85_distance_plane_batch(1, p.direction, r12(p), q1(p), &distance, point));
         out.add(&distance, 1, 1);
         out.add(point, 3, 1);
     }},
    {"overlap_any",
     [](Problem const &p, Results &out) {
         int any;
         out.add(pw85_overlap_any(q1(p), 1, r12(p), q2(p), &any));
         out.add(any);
     }},
    {"bounding_boxes",
     [](Problem const &p, Results &out) {
         double half[3];
         out.add(pw85_bounding_boxes(1, q2(p), half));
         out.add(half, 3, 1);
     }},
};

/// A cubic cell, and one that is not reduced.
std::vector<double> cubic(Problem const &p)
{
    return {p.cell, 0.0, 0.0, 0.0, p.cell, 0.0, 0.0, 0.0, p.cell};
}
std::vector<double> skewed(Problem const &p)
{
    return {p.cell, 0.0, 0.0, 2.5 * p.cell, p.cell, 0.0, 0.25 * p.cell, -3.0 * p.cell, p.cell};
}

Table const functions_of_systems = {
    {"contact_pairs",
     [](Problem const &p, Results &out) {
         std::vector<double> mu2(pairs_of_all), lambda(pairs_of_all);
         out.add(pw85_contact_pairs(
             list_of(pairs_of_all, all_pairs().data()),
             system_of(particles, p.centers.data(), p.forms.data(), skewed(p).data()), mu2.data(),
             lambda.data()));
         for (double const &x : mu2) out.add_lanes(&x, 1, 0);
         out.add_lanes(lambda.data(), pairs_of_all, 0);
     }},
    {"overlap_pairs",
     [](Problem const &p, Results &out) {
         std::vector<unsigned char> overlap(pairs_of_all);
         out.add(pw85_overlap_pairs(
             list_of(pairs_of_all, all_pairs().data()),
             system_of(particles, p.centers.data(), p.forms.data(), cubic(p).data()),
             overlap.data()));
         for (int const o : overlap) out.add(o);
     }},
    {"contact_derivatives_pairs and contact_forces_pairs",
     [](Problem const &p, Results &out) {
         std::vector<double> mu2(pairs_of_all), lambda(pairs_of_all), point(3 * pairs_of_all),
             normal(3 * pairs_of_all), r(3 * pairs_of_all), d1(3 * pairs_of_all),
             d2(3 * pairs_of_all), ones(pairs_of_all, 1.0), forces(3 * particles),
             torques(3 * particles), virial(9);
         out.add(pw85_contact_derivatives_pairs(
             list_of(pairs_of_all, all_pairs().data()),
             system_of(particles, p.centers.data(), p.forms.data(), cubic(p).data()), mu2.data(),
             lambda.data(), point.data(), normal.data(), r.data(), d1.data(), d2.data()));
         out.add_lanes(point.data(), point.size(), 1);
         out.add_lanes(r.data(), r.size(), -1);
         out.add(pw85_contact_forces_pairs(
             list_of(pairs_of_all, all_pairs().data()),
             system_of(particles, p.centers.data(), nullptr, cubic(p).data()), ones.data(),
             r.data(), d1.data(), d2.data(), forces.data(), torques.data(), virial.data()));
         double largest = 0.0; // of the forces of pairs
         for (double const x : r) largest = std::fmax(largest, std::fabs(x));
         out.add_lanes(forces.data(), forces.size(), -1, largest);
         out.add_lanes(torques.data(), torques.size(), 0, largest * p.cell);
         out.add_lanes(virial.data(), virial.size(), 0, largest * p.cell);
     }},
    {"first_contact_pairs",
     [](Problem const &p, Results &out) {
         std::vector<double> times(pairs_of_all), next(particles);
         std::vector<int64_t> next_pair(particles);
         out.add(pw85_first_contact_pairs(
             list_of(pairs_of_all, all_pairs().data()),
             system_of(particles, p.centers.data(), p.forms.data(), cubic(p).data()),
             p.motions.data(), p.flight.end, times.data(), next.data(), next_pair.data()));
         out.add(times.data(), times.size(), 0, 1);
         out.add(next.data(), next.size(), 0, 1);
         for (int64_t const pair : next_pair) out.add(static_cast<int>(pair));
     }},
    {"overlap_any_indices",
     [](Problem const &p, Results &out) {
         std::vector<int32_t> indices;
         for (int i = 1; i < static_cast<int>(particles); ++i) indices.push_back(i);
         int any;
         out.add(pw85_overlap_any_indices(
             p.centers.data(), p.forms.data(),
             system_of(particles, p.centers.data(), p.forms.data(), cubic(p).data()),
             indices.size(), indices.data(), nullptr, &any));
         out.add(any);
     }},
    {"cell_reduce",
     [](Problem const &p, Results &out) {
         double reduced[9];
         out.add(pw85_cell_reduce(skewed(p).data(), reduced));
         out.add(reduced, 9, 1);
     }},
    {"nearest_images",
     [](Problem const &p, Results &out) {
         std::vector<double> r(3 * pairs_of_all);
         std::vector<int32_t> images(3 * pairs_of_all);
         out.add(
             pw85_nearest_images(pairs_of_all, all_pairs().data(),
                                 system_of(particles, p.centers.data(), nullptr, skewed(p).data()),
                                 r.data(), images.data()));
         out.add(r.data(), r.size(), 1);
         for (int const image : images) out.add(image);
     }},
    {"nearest_image_limit",
     [](Problem const &p, Results &out) {
         double mu2;
         out.add(pw85_nearest_image_limit(
             system_of(particles, nullptr, p.forms.data(), skewed(p).data()), &mu2));
         out.add(&mu2, 1, 0);
     }},
    {"neighbors",
     [](Problem const &p, Results &out) {
         pw85_neighbors *list = nullptr;
         out.add(pw85_neighbors_create(
             system_of(particles, p.centers.data(), p.forms.data(), cubic(p).data()), 1.5,
             0.125 * p.cell, &list));
         pw85_pair_list const found = pw85_neighbors_list(list);
         std::size_t const size = found.num_pairs;
         out.add(static_cast<int>(size));
         for (std::size_t n = 0; n < 2 * size; ++n) out.add(found.pairs[n]);
         for (std::size_t n = 0; n < 3 * size; ++n) out.add(found.images[n]);
         int holds = -1;
         out.add(pw85_neighbors_holds(
             list, system_of(particles, p.centers.data(), p.forms.data(), cubic(p).data()),
             &holds));
         out.add(holds);
         pw85_neighbors_destroy(list);
     }},
};

template <int D> Sample<double, D> unlike_pair(Random &random, int size_ratio)
{
    auto const q1 = random_form<D>(random, 1.0, random.log_uniform(1.0, largest_aspect));
    auto const q2 = random_form<D>(random, std::ldexp(random.uniform(1.0, 2.0), size_ratio),
                                   random.log_uniform(1.0, largest_aspect));
    return placed<D>(random.direction<D>(), random.log_uniform(0.5, 9.0), q1, q2);
}

/// Ellipsoid 2 is larger than the other by some power of two. It comes near within one or two units
/// of time, turns and grows, and so do particles in a cell.
Problem random_problem(Random &random, int size_ratio)
{
    Problem p{{unlike_pair<3>(random, size_ratio), {}, {}, 3.0},
              unlike_pair<2>(random, size_ratio),
              0.0,
              {},
              {},
              {},
              {}};
    double const distance = norm(p.flight.start.r12);
    auto const direction = random.direction<3>();
    std::copy_n(direction.coordinates, 3, p.direction);
    p.flight.motion1 = random_motion<3>(random, 0.2 * distance, Moving::all);
    p.flight.motion2 = random_motion<3>(random, 0.2 * distance, Moving::all);
    for (int i = 0; i < 3; ++i)
        p.flight.motion2.velocity[i] -= random.uniform(0.5, 1.0) * r12(p)[i];
    if (random.sign() < 0.0) p.flight.end = random.log_uniform(0.1, 100.0);
    p.flight.motion1.growth = std::fmax(p.flight.motion1.growth, -0.5 / p.flight.end);
    p.flight.motion2.growth = std::fmax(p.flight.motion2.growth, -0.5 / p.flight.end);
    p.cell = 4.0 * (std::sqrt(pw85::detail::largest_diagonal(p.flight.start.q1)) +
                    std::sqrt(pw85::detail::largest_diagonal(p.flight.start.q2)));
    for (std::size_t n = 0; n < particles; ++n) {
        for (int i = 0; i < 3; ++i) p.centers.push_back(random.uniform(0.0, p.cell));
        double const *q = n % 2 == 0 ? q1(p) : q2(p);
        p.forms.insert(p.forms.end(), q, q + 6);
        p.motions.push_back(c_motion(n % 2 == 0 ? p.flight.motion1 : p.flight.motion2));
    }
    return p;
}

/// The same in units that are smaller by powers of two.
Problem in_other_units(Problem p, int length, int time)
{
    p.flight = in_units(p.flight, length, time);
    p.plane = {pw85::detail::times_power_of_two(p.plane.r12, length),
               pw85::detail::times_power_of_two(p.plane.q1, 2 * length),
               pw85::detail::times_power_of_two(p.plane.q2, 2 * length)};
    p.cell = std::ldexp(p.cell, length);
    for (double &x : p.centers) x = std::ldexp(x, length);
    for (double &x : p.forms) x = std::ldexp(x, 2 * length);
    for (std::size_t n = 0; n < particles; ++n)
        p.motions[n] = c_motion(n % 2 == 0 ? p.flight.motion1 : p.flight.motion2);
    return p;
}

void check_function(Failures &failures, Function const &function, Problem const &p, int length,
                    int time)
{
    Results own, scaled;
    function.call(p, own);
    auto const image = in_other_units(p, length, time);
    function.call(image, scaled);
    auto const describe = [&] {
        return std::string(function.name) + ", " + flight_text(image.flight) +
               ", plane: " + hex_text(image.plane);
    };
    if (!failures.check(own.all.size() == scaled.all.size(), "number of results",
                        static_cast<double>(scaled.all.size()), static_cast<double>(own.all.size()),
                        describe))
        return;
    for (std::size_t i = 0; i < own.all.size(); ++i) {
        auto const &[value, of_length, of_time, difference] = own.all[i];
        int const unit = of_length * length + of_time * time;
        double const expected = std::ldexp(value, unit), actual = scaled.all[i].value;
        bool const same = std::fabs(actual - expected) <= std::ldexp(difference, unit) ||
                          actual == expected || (std::isnan(actual) && std::isnan(expected));
        if (!failures.check(same, function.name, actual, expected, describe)) return;
    }
}

void test_table(void const *data)
{
    for (Function const &function : *static_cast<Table const *>(data)) {
        Failures failures;
        Random random(700);
        for (int const size_ratio : {-30, -20, -3, 0, 3, 20, 30})
            for (int n = 0; n < draws(8); ++n) {
                auto const p = random_problem(random, size_ratio);
                for (int const length : {-40, -20, 20, 40})
                    check_function(failures, function, p, length, 7 * (n % 5 - 2));
            }
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_data_func("/scales/pairs", &functions_of_pairs, test_table);
    g_test_add_data_func("/scales/motion", &functions_of_motion, test_table);
    g_test_add_data_func("/scales/plane", &functions_of_plane, test_table);
    g_test_add_data_func("/scales/walls", &functions_of_walls, test_table);
    g_test_add_data_func("/scales/batches", &functions_of_batches, test_table);
    g_test_add_data_func("/scales/systems", &functions_of_systems, test_table);
    return g_test_run();
}
