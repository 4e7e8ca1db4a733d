#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# In space, the longest semi-axis of CGAL's smallest enclosing ellipsoid comes with the direction of the shortest one, and the shortest with
# that of the longest. In the plane the directions are right, but the lengths are in the other order than in space.
#
# CGAL 5.5.1 (Debian 12, libcgal-dev 5.5.1-2), Approximate_min_ellipsoid_d. The reference of axis_direction_cartesian_begin(i) says: "An
# approximation to the length of axis i is given by the i-th entry of axes_lengths_begin()", and that of axes_lengths_begin: "descendantly
# sorted". Points on ellipsoids that are turned by 40 degrees about z; length, angle of the direction to the axis of the body that is 3, 2 or
# 1 long, and the square of the norm of the ellipsoid, (x - c)' Q^-1 (x - c), at the end of the semi-axis, which is 1 for any ellipsoid,
# seen on 30 November 2026:
#
#                length    to the axis 3    2     1     square, of the points' ellipsoid    of CGAL's own matrix
#   in space     3.000     90°              90°   0°    9.00                                9.00
#                2.000     90°              0°    90°   1.00                                1.00
#                1.000     0°               90°   90°   0.11                                0.11
#   in the plane 1.000           90°        90°   0°    1.00                                1.00
#                3.000           0°         90°   90°   1.00                                1.00
#
# The ellipsoid itself is right (defining_matrix, is_valid), but these pairs describe another one, which does not enclose the points: the
# farthest is at three times its semi-axis. Pair lengths[i] with direction 2 - i in space, or diagonalise defining_matrix.
# Needs g++ and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libcgal-dev=5.5.1-2 libboost1.74-dev=1.74.0+ds1-21 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'END'
#include <CGAL/Approximate_min_ellipsoid_d.h>
#include <CGAL/Approximate_min_ellipsoid_d_traits_d.h>
#include <CGAL/Cartesian_d.h>
#include <CGAL/MP_Float.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using Traits = CGAL::Approximate_min_ellipsoid_d_traits_d<CGAL::Cartesian_d<double>, CGAL::MP_Float>;
using Ellipsoid = CGAL::Approximate_min_ellipsoid_d<Traits>;

static double const pi = std::acos(-1.0), cosine = std::cos(40 * pi / 180), sine = std::sin(40 * pi / 180);

struct Body {
  int dimensions;
  double semi_axes[3]; // along the axes of the body

  // From the axes of the body to those of the space, and back.
  void turn(double const x[3], double y[3], double s) const {
    y[0] = cosine * x[0] - s * x[1], y[1] = s * x[0] + cosine * x[1], y[2] = x[2];
  }
  double square(double const y[3]) const {
    double x[3], sum = 0;
    turn(y, x, -sine);
    for (int k = 0; k < dimensions; k++) sum += std::pow(x[k] / semi_axes[k], 2);
    return sum;
  }
  std::vector<Traits::Point> points() const {
    std::vector<Traits::Point> list;
    int const rows = dimensions == 3 ? 20 : 0, columns = 40;
    for (int i = 0; i <= rows; i++)
      for (int j = 0; j < columns; j++) {
        double const t = rows ? pi * i / rows : pi / 2, p = 2 * pi * j / columns;
        double const x[3] = {semi_axes[0] * std::sin(t) * std::cos(p), semi_axes[1] * std::sin(t) * std::sin(p), semi_axes[2] * std::cos(t)};
        double y[3];
        turn(x, y, sine);
        list.emplace_back(dimensions, y, y + dimensions);
      }
    return list;
  }
};

static bool near(double x, double expected) { return std::fabs(x - expected) < 1e-2 * (1 + expected); }

// "lengths": in the order that is expected. "places": of the axis of the body that each direction is parallel to.
static int check(Body const &body, std::vector<double> const &lengths, std::vector<int> const &places) {
  auto const points = body.points();
  Traits const traits;
  Ellipsoid found(1e-5, points.begin(), points.end(), traits);
  int const n = body.dimensions;
  int wrong = !found.is_full_dimensional() || !found.is_valid(false);
  double const scale = 1 / ((1 + found.achieved_epsilon()) * (n + 1));
  for (int i = 0; i < n; i++) {
    double const length = found.axes_lengths_begin()[i];
    double end[3] = {0, 0, 0}, axis[3], direction[3] = {0, 0, 0}, own = 0, constant = 1 - found.defining_scalar() * scale;
    for (int k = 0; k < n; k++) direction[k] = found.axis_direction_cartesian_begin(i)[k], end[k] = length * direction[k];
    for (int k = 0; k < n; k++)
      for (int l = 0; l < n; l++) own += end[k] * found.defining_matrix(k, l) * scale * end[l]; // its centre is 0 to 1e-4
    body.turn(direction, axis, -sine);
    double const expected = std::pow(lengths[i] / body.semi_axes[places[i]], 2);
    printf("length %.3f, angles to the axes of the body", length);
    for (int k = 0; k < n; k++) printf(" %.0f", std::acos(std::fmin(1, std::fabs(axis[k]))) * 180 / pi);
    printf(", square %.3f, of its own matrix %.3f\n", body.square(end), own / constant);
    wrong |= !near(length, lengths[i]) || std::fabs(std::fabs(axis[places[i]]) - 1) > 1e-2 || !near(body.square(end), expected) ||
             !near(own / constant, expected);
  }
  return wrong;
}

int main() {
  return check({3, {1, 2, 3}}, {3, 2, 1}, {0, 1, 2}) | check({3, {2, 1, 3}}, {3, 2, 1}, {1, 0, 2}) | check({2, {3, 1, 0}}, {1, 3}, {1, 0});
}
END
g++ -std=c++17 -O1 -w -DCGAL_DISABLE_GMP -DNDEBUG -Iusr/include check.cpp -o check
./check
