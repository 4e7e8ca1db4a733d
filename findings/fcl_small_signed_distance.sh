#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The signed distance of overlapping ellipsoids is positive for bodies of a millimetre in metres, although collide() says that the same
# bodies collide. The depth that collide() states is up to a half too large, for bodies of any size.
#
# FCL 0.7.0 (Debian 12, 0.7.0-3+b1), the default solver. Two parallel ellipsoids (s, 2 s, 3 s), the second centre f s (1.2, 1.92, 3.84)
# away (they touch at f = 1). In units of s: distance() with enable_signed_distance, and penetration_depth of collide(), seen on
# 30 November 2026:
#
#   f       true       distance(), s = 1    s = 0.01     s = 0.001    collide(), s = 1    s = 0.001
#   0.9     -0.2827    -0.2827              -0.2827      -0.2822      0.4435              0.4378
#   0.99    -0.0293    -0.0293              -0.0292      +0.0038      0.0424              0.0372
#   0.999   -0.00294   -0.00294             -0.00287     +0.0007      0.00296             0.0025
#
# fcl_indep_depth.sh is about the other solver, and about balls.
# Needs g++, libeigen3-dev and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libfcl0.7=0.7.0-3+b1 libfcl-dev=0.7.0-3+b1 libccd2=2.1-2+b1 libccd-dev=2.1-2+b1 \
  liboctomap1.9=1.9.7+dfsg-3+b1 liboctomap-dev=1.9.7+dfsg-3+b1 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'EOF'
#include <fcl/fcl.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

double const axes[3] = {1, 2, 3};

struct Pair {
  double s;
  fcl::Ellipsoidd shape;
  fcl::Transform3d first = fcl::Transform3d::Identity(), second = first;

  Pair(double s, double f) : s(s), shape(s, 2 * s, 3 * s) {
    second.translation() = f * s * fcl::Vector3d(1.2, 1.92, 3.84);
  }
};

// The distance from the centre of the second to the surface of the ellipsoid (2, 4, 6): the depth of equal parallel bodies.
// The nearest point is a² r/(a² + t), with t between -a² of the shortest axis and 0
double true_depth(double f) {
  double const r[3] = {1.2 * f, 1.92 * f, 3.84 * f};
  double low = -4, high = 0;
  for (int k = 0; k < 200; ++k) {
    double const t = (low + high) / 2;
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += std::pow(2 * axes[i] * r[i] / (4 * axes[i] * axes[i] + t), 2);
    (sum > 1 ? low : high) = t;
  }
  double distance2 = 0;
  for (int i = 0; i < 3; ++i) distance2 += std::pow(r[i] * high / (4 * axes[i] * axes[i] + high), 2);
  return std::sqrt(distance2);
}

double signed_distance(Pair const &p) {
  fcl::DistanceRequestd request(true, true);
  fcl::DistanceResultd result;
  return fcl::distance(&p.shape, p.first, &p.shape, p.second, request, result) / p.s;
}

double depth_of_collide(Pair const &p) {
  fcl::CollisionRequestd request(1, true);
  fcl::CollisionResultd result;
  if (fcl::collide(&p.shape, p.first, &p.shape, p.second, request, result) != 1) std::exit(2);
  return result.getContact(0).penetration_depth / p.s;
}

void expect(char const *what, double f, double s, double found, double expected) {
  std::printf("f = %g, s = %g: %s %.4g\n", f, s, what, found);
  if (!(std::fabs(found - expected) <= 0.02 * std::fabs(expected))) std::printf("is not %g\n", expected), std::exit(1);
}

struct Row {
  double f, truth, distance[3], collide[2];
};

int main() {
  for (Row const &row : {Row{0.9, 0.2827, {-0.2827, -0.2827, -0.2822}, {0.4435, 0.4378}},
                         {0.99, 0.0293, {-0.0293, -0.0292, 0.003844}, {0.0424, 0.0372}},
                         {0.999, 0.00294, {-0.00294, -0.00287, 0.0007217}, {0.00296, 0.0025}}}) {
    expect("true depth", row.f, 1, true_depth(row.f), row.truth);
    double const sizes[3] = {1, 0.01, 0.001};
    for (int i = 0; i < 3; ++i) expect("distance()", row.f, sizes[i], signed_distance(Pair(sizes[i], row.f)), row.distance[i]);
    for (int i = 0; i < 2; ++i) expect("collide()", row.f, sizes[2 * i], depth_of_collide(Pair(sizes[2 * i], row.f)), row.collide[i]);
  }
}
EOF
libraries=usr/lib/x86_64-linux-gnu
g++ -w -std=c++17 -O0 -I usr/include -I /usr/include/eigen3 check.cpp -o check -L $libraries -lfcl -lccd -loctomap -loctomath \
  -Wl,-rpath-link,$libraries
LD_LIBRARY_PATH=$libraries ./check
