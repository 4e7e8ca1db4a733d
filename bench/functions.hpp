// SPDX-License-Identifier: BSD-3-Clause
// Calls of the functions of the C API on a pair and on a block of pairs, by their names. speed.cpp
// and instructions/calls.cpp use them.
#ifndef PW85_BENCH_FUNCTIONS_HPP_INCLUDED
#define PW85_BENCH_FUNCTIONS_HPP_INCLUDED

#include <cmath>

#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

#include "pairs.hpp"

namespace pw85_bench {

/// Memory for results that are not read.
struct Sink {
    double a[6], b[6], c[6];
    int overlap;
};

struct Function {
    char const *name;
    void (*call)(Pair const &, double lambda, Sink &);
};

/// A pair of a block with its separation multiplied by a factor: at half the distance all pairs
/// overlap, at twice the distance none.
inline pw85::Vector<double, 3> scaled_separation(Pair const &x, double factor)
{
    return factor * x.r12;
}

/// First contact of a pair that is apart, and whose centres meet at time 1.
inline void first_contact(Pair const &x, double turn, double growth, double &t)
{
    auto const r12 = scaled_separation(x, 3.0);
    pw85_motion const motion1{{}, {turn, -turn, turn}, 0.0};
    pw85_motion const motion2{{-r12[0], -r12[1], -r12[2]}, {turn, turn, 0.0}, growth};
    pw85_first_contact(r12.coordinates, x.q1.entries, x.q2.entries, &motion1, &motion2, 1.0, &t);
}

/// The arguments r12, q1 and q2 of the C API.
#define PW85_BENCH_PAIR(x) (x).r12.coordinates, (x).q1.entries, (x).q2.entries

inline constexpr Function functions[] = {
    {"contact_function",
     [](Pair const &x, double, Sink &s) { pw85_contact_function(PW85_BENCH_PAIR(x), s.a); }},
    {"contact", [](Pair const &x, double, Sink &s) { pw85_contact(PW85_BENCH_PAIR(x), s.a); }},
    {"overlap",
     [](Pair const &x, double, Sink &s) { pw85_overlap(PW85_BENCH_PAIR(x), &s.overlap); }},
    {"contact_geometry", [](Pair const &x, double l,
                            Sink &s) { pw85_contact_geometry(PW85_BENCH_PAIR(x), l, s.a, s.b); }},
    {"curvature", [](Pair const &x, double,
                     Sink &s) { pw85_curvature(x.r12.coordinates, x.q1.entries, s.a, s.b); }},
    {"hertz_contact",
     [](Pair const &x, double, Sink &s) {
         pw85_hertz_contact(PW85_BENCH_PAIR(x), x.r12.coordinates, s.a, s.a + 1, s.b, s.c, s.b + 2,
                            s.b + 3);
     }},
    {"contact_gradient",
     [](Pair const &x, double l, Sink &s) {
         pw85_contact_gradient(PW85_BENCH_PAIR(x), l, s.a, s.b, s.c);
     }},
    {"contact_torque", [](Pair const &x, double l,
                          Sink &s) { pw85_contact_torque(PW85_BENCH_PAIR(x), l, s.a, s.b); }},
    {"closest_approach",
     [](Pair const &x, double, Sink &s) { pw85_closest_approach(PW85_BENCH_PAIR(x), s.a); }},
    {"distance",
     [](Pair const &x, double, Sink &s) {
         pw85_distance(scaled_separation(x, 2.0).coordinates, x.q1.entries, x.q2.entries, s.a, s.b,
                       s.c);
     }},
    {"distance_plane",
     [](Pair const &x, double, Sink &s) {
         pw85_distance_plane(x.r12.coordinates, 1.0, x.q1.entries, s.a, s.b);
     }},
    {"penetration",
     [](Pair const &x, double, Sink &s) {
         pw85_penetration(scaled_separation(x, 0.5).coordinates, x.q1.entries, x.q2.entries, s.a,
                          s.b);
     }},
    {"overlap_volume",
     [](Pair const &x, double, Sink &s) {
         pw85_overlap_volume(scaled_separation(x, 0.5).coordinates, x.q1.entries, x.q2.entries,
                             s.a);
     }},
    {"overlap_volume_gradient",
     [](Pair const &x, double, Sink &s) {
         pw85_overlap_volume_gradient(scaled_separation(x, 0.5).coordinates, x.q1.entries,
                                      x.q2.entries, s.a, s.b, s.c);
     }},
    {"first_contact_translation",
     [](Pair const &x, double, Sink &s) { first_contact(x, 0.0, 0.0, s.a[0]); }},
    {"first_contact_rotation",
     [](Pair const &x, double, Sink &s) { first_contact(x, 1.0, 0.0, s.a[0]); }},
    {"first_contact_growth",
     [](Pair const &x, double, Sink &s) { first_contact(x, 0.0, 0.1, s.a[0]); }},
    {"contact_2d",
     [](Pair const &x, double, Sink &s) {
         // The lower right blocks of the forms serve as forms of ellipses.
         pw85_contact_2d(x.r12.coordinates, x.q1.entries + 3, x.q2.entries + 3, s.a);
     }},
    {"closest_approach_2d",
     [](Pair const &x, double, Sink &s) {
         pw85_closest_approach_2d(x.r12.coordinates, x.q1.entries + 3, x.q2.entries + 3, s.a);
     }},
    {"spheroid",
     [](Pair const &x, double, Sink &s) { pw85_spheroid(1.0, 2.0, x.r12.coordinates, s.a); }},
    {"ellipsoid_quaternion",
     [](Pair const &x, double, Sink &s) {
         double const axes[3] = {1.0, 2.0, 3.0};
         pw85_ellipsoid_quaternion(axes, x.q1.entries, s.a);
     }},
    {"ellipse", [](Pair const &, double l, Sink &s) { pw85_ellipse(1.0, 2.0, l, s.a); }},
    {"_cholesky_decomp",
     [](Pair const &x, double, Sink &s) { pw85__cholesky_decomp(x.q1.entries, s.a); }},
    {"_cholesky_solve",
     [](Pair const &x, double, Sink &s) {
         pw85__cholesky_solve(x.q1.entries, x.r12.coordinates, s.a);
     }},
    {"_residual",
     [](Pair const &x, double l, Sink &s) { pw85__residual(l, PW85_BENCH_PAIR(x), s.a); }},
    {"legacy_f1",
     [](Pair const &x, double l, Sink &s) { pw85_legacy_f1(l, PW85_BENCH_PAIR(x), s.a); }},
    {"legacy_f2",
     [](Pair const &x, double l, Sink &s) { pw85_legacy_f2(l, PW85_BENCH_PAIR(x), s.a); }},
    {"legacy_contact_function1",
     [](Pair const &x, double, Sink &s) {
         pw85_legacy_contact_function1(PW85_BENCH_PAIR(x), s.a);
     }},
    {"legacy_contact_function2",
     [](Pair const &x, double, Sink &s) {
         pw85_legacy_contact_function2(PW85_BENCH_PAIR(x), s.a);
     }},
    {"zheng_ellipses",
     [](Pair const &x, double, Sink &s) {
         pw85_zheng_ellipses(x.r12.coordinates, x.q1.entries + 3, x.q2.entries + 3, s.a);
     }},
    {"zheng_ellipsoids",
     [](Pair const &x, double, Sink &s) { pw85_zheng_ellipsoids(PW85_BENCH_PAIR(x), s.a); }},
};

#undef PW85_BENCH_PAIR

struct BatchFunction {
    char const *name;
    void (*call)(Block &);
};

inline constexpr BatchFunction batch_functions[] = {
    {"contact_batch",
     [](Block &b) {
         pw85_contact_batch(b.size(), b.r12.data(), b.q1.data(), b.q2.data(), b.mu2.data(),
                            b.lambda.data());
     }},
    {"overlap_batch",
     [](Block &b) {
         pw85_overlap_batch(b.size(), b.r12.data(), b.q1.data(), b.q2.data(), b.overlap.data());
     }},
    {"distance_batch",
     [](Block &b) {
         pw85_distance_batch(b.size(), b.apart.data(), b.q1.data(), b.q2.data(), b.mu2.data(),
                             b.point1.data(), b.point2.data());
     }},
    {"closest_passage_batch",
     [](Block &b) {
         pw85_closest_passage_batch(b.size(), b.r12.data(), b.q1.data(), b.q2.data(),
                                    b.velocity.data(), HUGE_VAL, b.mu2.data(), b.lambda.data());
     }},
};

} // namespace pw85_bench

#endif
