// The functions of the C API of one pair, as calls on a BenchPair.
#ifndef PW85_BENCH_FUNCTIONS_HPP_INCLUDED
#define PW85_BENCH_FUNCTIONS_HPP_INCLUDED

#include <pw85.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

#include "pairs.hpp"

namespace pw85_bench {

/// Where results go that nobody reads.
struct Sink {
    double a[6], b[6], c[6];
    int overlap;
};

struct Function {
    char const *name;
    void (*call)(BenchPair const &, Sink &);
};

/// r12, q1, q2 as the C API takes them.
#define PW85_BENCH_PAIR(x) (x).pair.r12.coordinates, (x).pair.q1.entries, (x).pair.q2.entries

inline constexpr Function functions[] = {
    {"contact_function", [](BenchPair const &x, Sink &s) { pw85_contact_function(PW85_BENCH_PAIR(x), s.a); }},
    {"contact", [](BenchPair const &x, Sink &s) { pw85_contact(PW85_BENCH_PAIR(x), s.a); }},
    {"overlap", [](BenchPair const &x, Sink &s) { pw85_overlap(PW85_BENCH_PAIR(x), &s.overlap); }},
    {"contact_geometry",
     [](BenchPair const &x, Sink &s) { pw85_contact_geometry(PW85_BENCH_PAIR(x), x.lambda, s.a, s.b); }},
    {"contact_gradient",
     [](BenchPair const &x, Sink &s) { pw85_contact_gradient(PW85_BENCH_PAIR(x), x.lambda, s.a, s.b, s.c); }},
    {"contact_torque",
     [](BenchPair const &x, Sink &s) { pw85_contact_torque(PW85_BENCH_PAIR(x), x.lambda, s.a, s.b); }},
    {"closest_approach", [](BenchPair const &x, Sink &s) { pw85_closest_approach(PW85_BENCH_PAIR(x), s.a); }},
    {"distance", [](BenchPair const &x, Sink &s) { pw85_distance(PW85_BENCH_PAIR(x), s.a, s.b, s.c); }},
    {"distance_plane", [](BenchPair const &x,
                          Sink &s) { pw85_distance_plane(x.pair.r12.coordinates, 1.0, x.pair.q1.entries, s.a, s.b); }},
    {"contact_2d",
     [](BenchPair const &x, Sink &s) {
         // The lower right blocks of the forms are forms of ellipses.
         pw85_contact_2d(x.pair.r12.coordinates, x.pair.q1.entries + 3, x.pair.q2.entries + 3, s.a);
     }},
    {"closest_approach_2d",
     [](BenchPair const &x, Sink &s) {
         pw85_closest_approach_2d(x.pair.r12.coordinates, x.pair.q1.entries + 3, x.pair.q2.entries + 3, s.a);
     }},
    {"spheroid", [](BenchPair const &x, Sink &s) { pw85_spheroid(1.0, 2.0, x.pair.r12.coordinates, s.a); }},
    {"ellipsoid_quaternion",
     [](BenchPair const &x, Sink &s) {
         double const axes[3] = {1.0, 2.0, 3.0};
         pw85_ellipsoid_quaternion(axes, x.pair.q1.entries, s.a);
     }},
    {"ellipse", [](BenchPair const &x, Sink &s) { pw85_ellipse(1.0, 2.0, x.lambda, s.a); }},
    {"_cholesky_decomp", [](BenchPair const &x, Sink &s) { pw85__cholesky_decomp(x.pair.q1.entries, s.a); }},
    {"_cholesky_solve",
     [](BenchPair const &x, Sink &s) { pw85__cholesky_solve(x.pair.q1.entries, x.pair.r12.coordinates, s.a); }},
    {"_residual", [](BenchPair const &x, Sink &s) { pw85__residual(x.lambda, PW85_BENCH_PAIR(x), s.a); }},
    {"legacy_f1", [](BenchPair const &x, Sink &s) { pw85_legacy_f1(x.lambda, PW85_BENCH_PAIR(x), s.a); }},
    {"legacy_f2", [](BenchPair const &x, Sink &s) { pw85_legacy_f2(x.lambda, PW85_BENCH_PAIR(x), s.a); }},
    {"legacy_contact_function1",
     [](BenchPair const &x, Sink &s) { pw85_legacy_contact_function1(PW85_BENCH_PAIR(x), s.a); }},
    {"legacy_contact_function2",
     [](BenchPair const &x, Sink &s) { pw85_legacy_contact_function2(PW85_BENCH_PAIR(x), s.a); }},
    {"zheng_ellipses",
     [](BenchPair const &x, Sink &s) {
         pw85_zheng_ellipses(x.pair.r12.coordinates, x.pair.q1.entries + 3, x.pair.q2.entries + 3, s.a);
     }},
    {"zheng_ellipsoids", [](BenchPair const &x, Sink &s) { pw85_zheng_ellipsoids(PW85_BENCH_PAIR(x), s.a); }},
};

#undef PW85_BENCH_PAIR

} // namespace pw85_bench

#endif
