#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The solver GST_INDEP of FCL returns penetration depths that are negative and have wrong magnitudes; GST_LIBCCD returns right ones. The
# tolerance of GST_INDEP is a length: small bodies collide at any gap.
#
# FCL 0.7.0 (Debian 12, 0.7.0-3+b1). Two ellipsoids with semi-axes (1, 1, 1), centres x apart, collide() with enable_contact.
# penetration_depth and the normal's x component, seen on 29 November 2026:
#
#   x      depth    GST_LIBCCD     GST_INDEP
#   0.5    1.5      1.5,  1        -2.44,    -0.05
#   1      1        1,    1        -2,        0.69
#   1.5    0.5      0.5,  1        -1,        0.69
#   1.99   0.01     0.01, 1        -0.0001,   1.00
#
# Two ellipsoids (s, 2 s, 3 s), centres 2.2 s apart along x, which is a gap of 0.2 s (touching at 2 s): both solvers find the gap for
# s = 1. For s = 1e-6, GST_LIBCCD finds it, and GST_INDEP reports a collision.
# GST_LIBCCD is the default. Balls as fcl::Sphere have exact formulas.
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

struct Row {
  double x, depth_libccd, depth_indep, normal_indep;
};

static fcl::Contactd contact(double x, fcl::GJKSolverType solver) {
  auto const shape = std::make_shared<fcl::Ellipsoidd>(1, 1, 1);
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  fcl::CollisionObjectd const one(shape, pose);
  pose.translation() = fcl::Vector3d(x, 0, 0);
  fcl::CollisionObjectd const two(shape, pose);
  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = solver;
  fcl::CollisionResultd result;
  if (fcl::collide(&one, &two, request, result) != 1) std::exit(2);
  return result.getContact(0);
}

static void expect(double x, char const *what, double found, double expected) {
  std::printf("x = %g: %s %.4g\n", x, what, found);
  if (!(std::fabs(found - expected) < 0.01)) std::printf("is not %g\n", expected), std::exit(1);
}

static bool collide_at_gap(double size, fcl::GJKSolverType solver) {
  auto const shape = std::make_shared<fcl::Ellipsoidd>(size, 2 * size, 3 * size);
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  fcl::CollisionObjectd const one(shape, pose);
  pose.translation() = fcl::Vector3d(2.2 * size, 0, 0);
  fcl::CollisionObjectd const two(shape, pose);
  fcl::CollisionRequestd request;
  request.gjk_solver_type = solver;
  fcl::CollisionResultd result;
  return fcl::collide(&one, &two, request, result) > 0;
}

int main() {
  bool const libccd = collide_at_gap(1, fcl::GST_LIBCCD) || collide_at_gap(1e-6, fcl::GST_LIBCCD);
  bool const indep = collide_at_gap(1, fcl::GST_INDEP), indep_small = collide_at_gap(1e-6, fcl::GST_INDEP);
  std::printf("collide across a gap: libccd %d, indep %d, indep and small %d\n", libccd, indep, indep_small);
  if (libccd || indep || !indep_small) return 1;

  for (Row const &row : {Row{0.5, 1.5, -2.443, -0.048}, {1, 1, -2, 0.695}, {1.5, 0.5, -1, 0.695}, {1.99, 0.01, -0.0001, 1}}) {
    fcl::Contactd const libccd = contact(row.x, fcl::GST_LIBCCD), indep = contact(row.x, fcl::GST_INDEP);
    expect(row.x, "libccd, depth", libccd.penetration_depth, row.depth_libccd);
    expect(row.x, "libccd, normal", libccd.normal.x(), 1);
    expect(row.x, "indep, depth", indep.penetration_depth, row.depth_indep);
    expect(row.x, "indep, normal", indep.normal.x(), row.normal_indep);
    if (indep.penetration_depth >= 0) return 1;
  }
}
EOF
libraries=usr/lib/x86_64-linux-gnu
g++ -w -std=c++17 -O0 -I usr/include -I /usr/include/eigen3 check.cpp -o check -L $libraries -lfcl -lccd -loctomap -loctomath \
  -Wl,-rpath-link,$libraries
LD_LIBRARY_PATH=$libraries ./check
