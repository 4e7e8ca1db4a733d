#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The depth of two slender ellipsoids that lie side by side is up to eight times too large by one of the two algorithms of libccd, and zero
# at some places by the other. Smaller tolerances change neither.
#
# libccd 2.1 (Debian 12, 2.1-2+b1). Two parallel ellipsoids (1, 1, 10), the second centre at (0.5, 0, z). The depth of such a pair is the
# distance of that point from the surface of the ellipsoid (2, 2, 20), here by bisection. Both functions return 0, for success, with depths
# seen on 30 November 2026, the tolerances at their defaults of 1e-4 and at 1e-12:
#
#   z      true      ccdGJKPenetration    at 1e-12     ccdMPRPenetration    at 1e-12
#   0      1.5       1.493                1.500        1.5                  1.5
#   2.5    1.484     1.482                1.484        6.55                 6.57
#   5      1.436     1.433                1.436        9.12                 9.19
#   7.5    1.353     3e-15                3e-15        9.14                 9.16
#   10     1.230     5e-15                5e-15        7.84                 7.90
#
# MPR moves the bodies apart roughly along the line of their centres, not along the shortest way: its depth is enough to part them,
# and its direction at z = 5 is (0.10, 0, 0.99), where the shortest way is (1, 0, 0.03).
# Of 2000 random places of overlapping pairs, the depth of MPR is more than twice the true one at three of four (1543), and up to 8.4 times;
# that of GJK (followed by EPA) is below half of it at 14.
# Needs gcc and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libccd2=2.1-2+b1 libccd-dev=2.1-2+b1 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.c <<'END'
#include <ccd/ccd.h>
#include <math.h>
#include <stdio.h>

typedef struct {
  ccd_vec3_t centre;
  double axes[3];
} Body;

static void support(const void *body, const ccd_vec3_t *direction, ccd_vec3_t *point) {
  const Body *e = body;
  double scaled[3], norm = 0;
  for (int i = 0; i < 3; i++) {
    scaled[i] = e->axes[i] * direction->v[i];
    norm = hypot(norm, scaled[i]);
  }
  for (int i = 0; i < 3; i++) point->v[i] = e->centre.v[i] + e->axes[i] * scaled[i] / norm;
}

static void centre(const void *body, ccd_vec3_t *point) { *point = ((const Body *)body)->centre; }

/* Distance of p, inside, from the ellipsoid (2, 2, 20): the nearest point is p a²/(a² + t) along each axis a, -4 < t < 0. */
static double true_depth(const double *p) {
  double low = -4, high = 0;
  for (int i = 0; i < 200; i++) {
    double const t = (low + high) / 2;
    if (hypot(2 * hypot(p[0], p[1]) / (4 + t), 20 * p[2] / (400 + t)) > 1) low = t;
    else high = t;
  }
  return hypot(low * hypot(p[0], p[1]) / (4 + low), low * p[2] / (400 + low));
}

typedef struct {
  double gjk, mpr;
  ccd_vec3_t along;
  int failed;
} Depths;

static Depths depths(const double *p, double tolerance) {
  Body const one = {{{0, 0, 0}}, {1, 1, 10}}, two = {{{p[0], p[1], p[2]}}, {1, 1, 10}};
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = support;
  settings.center1 = settings.center2 = centre;
  settings.max_iterations = 1000;
  settings.epa_tolerance = settings.mpr_tolerance = tolerance;
  Depths found = {-1, -1, {{0, 0, 0}}, 0};
  ccd_vec3_t along, point;
  found.failed = ccdGJKPenetration(&one, &two, &settings, &found.gjk, &along, &point) ||
                 ccdMPRPenetration(&one, &two, &settings, &found.mpr, &found.along, &point);
  return found;
}

static int wrong(double z, double tolerance, double gjk, double mpr) {
  double const p[3] = {0.5, 0, z};
  Depths const found = depths(p, tolerance);
  printf("z %-4g tolerance %-6g true %.4f GJK %.4g MPR %.4g along %.2f %.2f %.2f\n", z, tolerance, true_depth(p), found.gjk, found.mpr,
         found.along.v[0], found.along.v[1], found.along.v[2]);
  return found.failed || fabs(found.gjk - gjk) > 0.01 || fabs(found.mpr - mpr) > 0.05;
}

static double uniform(void) { /* in (-1, 1) */
  static unsigned long long state = 1;
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(state >> 11) / 4503599627370496.0 - 1;
}

static int random_places(void) {
  int places = 0, small = 0, large = 0;
  double largest = 0;
  while (places < 2000) {
    double const p[3] = {2 * uniform(), 2 * uniform(), 20 * uniform()};
    if (p[0] * p[0] / 4 + p[1] * p[1] / 4 + p[2] * p[2] / 400 > 0.98) continue;
    Depths const found = depths(p, 1e-4);
    double const true_one = true_depth(p);
    places++;
    small += found.gjk < true_one / 2;
    large += found.mpr > 2 * true_one;
    largest = fmax(largest, found.mpr / true_one);
  }
  printf("of %d places GJK is below half at %d, MPR above twice at %d, at most %.2f times\n", places, small, large, largest);
  return small < 2 || small > 40 || large < 1400 || large > 1650 || largest < 7;
}

int main(void) {
  int failures = random_places();
  for (int i = 0; i < 2; i++) {
    double const tolerance = i ? 1e-12 : 1e-4;
    failures += wrong(0, tolerance, 1.5, 1.5);
    failures += wrong(2.5, tolerance, 1.484, 6.57);
    failures += wrong(5, tolerance, 1.436, i ? 9.19 : 9.12);
    failures += wrong(7.5, tolerance, 0, 9.15);
    failures += wrong(10, tolerance, 0, i ? 7.90 : 7.84);
  }
  return failures != 0;
}
END
libraries=$dir/usr/lib/x86_64-linux-gnu
gcc -O1 -I usr/include check.c -L "$libraries" -Wl,-rpath,"$libraries" -lccd -lm -o check
./check
