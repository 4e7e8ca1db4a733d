#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The nearest point of an ellipsoid to a point inside it, in the plane of its two longer axes, is not on the ellipsoid.
#
# Simbody 3.7 (Debian 12, 3.7+dfsg-3), SimTK::ContactGeometry::Ellipsoid(1, 2, 3).findNearestPoint. Seen on 29 November 2026:
#
#   point              returned                  distance   true distance   x²+y²/4+z²/9 there (1 on the surface)
#   (0, 0.5, 0.5)      (0, 0.667, 0.5625)        0.178      0.9410          0.146
#   (0, 0, 1)          (0, 0, 1.125)             0.125      0.9354          0.141
#   (1e-9, 0.5, 0.5)   (260, 0.667, 0.5625)      260        0.9410          67640
#   (1e-3, 0.5, 0.5)   (0.924, 0.666, 0.5624)    0.93998    0.93998         1
#
# The nearest points of the first two are a pair (+-0.924, ...) off the plane of symmetry. Points outside, and those inside that are
# farther from the middle, are right. The distance is the depth of a contact, whose normal is then wrong, too.
# Needs g++, liblapack3 and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libsimbody3.7=3.7+dfsg-3 libsimbody-dev=3.7+dfsg-3 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'EOF'
#include <SimTKmath.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

using SimTK::Vec3;

// The least distance to points of a grid on the surface: too large by at most half the distance of neighbours, squared over that distance.
static double sampled(Vec3 const &p) {
  double least = 1e300;
  for (int i = 0; i <= 500; ++i)
    for (int j = 0; j < 1000; ++j) {
      double const t = M_PI * i / 500, f = M_PI * j / 500;
      Vec3 const x(std::sin(t) * std::cos(f), 2 * std::sin(t) * std::sin(f), 3 * std::cos(t));
      least = std::fmin(least, (x - p).norm());
    }
  return least;
}

static void expect(Vec3 const &p, double distance, double level, double true_distance) {
  SimTK::ContactGeometry::Ellipsoid const ellipsoid(Vec3(1, 2, 3));
  bool inside;
  SimTK::UnitVec3 normal;
  Vec3 const q = ellipsoid.findNearestPoint(p, inside, normal);
  double const found = (q - p).norm(), form = q[0] * q[0] + q[1] * q[1] / 4 + q[2] * q[2] / 9;
  std::printf("(%g, %g, %g): (%.4g, %.4g, %.4g), distance %.5g, form %.4g, sampled distance %.5g\n", p[0], p[1], p[2], q[0], q[1], q[2],
              found, form, sampled(p));
  bool const same = std::fabs(found - distance) < 2e-3 * distance && std::fabs(form - level) < 2e-3 * level;
  if (!same || std::fabs(sampled(p) - true_distance) > 1e-4) std::printf("is not what it was\n"), std::exit(1);
}

int main() {
  expect(Vec3(0, 0.5, 0.5), 0.178, 0.1463, 0.9410);
  expect(Vec3(0, 0, 1), 0.125, 0.1406, 0.9354);
  expect(Vec3(1e-9, 0.5, 0.5), 260.1, 67640, 0.9410);
  expect(Vec3(1e-3, 0.5, 0.5), 0.93998, 1, 0.93998);
  expect(Vec3(0, 3, 4), 2.40832, 1, 2.40832); // outside, in the same plane
}
EOF
libraries=usr/lib/x86_64-linux-gnu
g++ -w -std=c++17 -O0 -I usr/include/simbody check.cpp -o check -L $libraries -lSimTKmath -lSimTKcommon -Wl,-rpath-link,$libraries
LD_LIBRARY_PATH=$libraries ./check
