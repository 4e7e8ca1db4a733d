#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# An ellipsoid that flies through another one "does not collide" by continuousCollide: conservative advancement is not implemented for
# ellipsoids and still answers, and the default solver tests ten poses.
#
# FCL 0.7.0 (Debian 12, 0.7.0-3+b1). Two parallel ellipsoids (1, 2, 3), the second centre moves along x from d to -d and meets the first one
# at x = 2. is_collide and time_of_contact of the result, seen on 30 November 2026:
#
#   d      true time    CCDC_NAIVE, the default    CCDC_CONSERVATIVE_ADVANCEMENT    CCDC_RAY_SHOOTING
#   10     0.4          yes, 0.444                 no, 1                            no, 1
#   100    0.49         no, 1                      no, 1                            no, 1
#
# At the time 0.444 the bodies overlap by 0.89 of 2. The naive solver tests the times 0, 1/9, 2/9 ... 1: num_max_iterations = 1000 finds
# both, at the next 1/999. The last two solvers return -1, with a warning on the standard error at most, and is_collide is false then.
# Needs g++, libeigen3-dev and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libfcl0.7=0.7.0-3+b1 libfcl-dev=0.7.0-3+b1 libccd2=2.1-2+b1 libccd-dev=2.1-2+b1 \
  liboctomap1.9=1.9.7+dfsg-3+b1 liboctomap-dev=1.9.7+dfsg-3+b1 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'END'
#include <fcl/fcl.h>

#include <cmath>
#include <cstdio>
#include <memory>

struct Answer {
  double returned, time;
  bool collides;
};

static Answer fly(double distance, fcl::CCDSolverType solver, int poses) {
  auto const body = std::make_shared<fcl::Ellipsoidd>(1, 2, 3);
  fcl::Transform3d const still = fcl::Transform3d::Identity();
  fcl::Transform3d begin = still, end = still;
  begin.translation() = fcl::Vector3d(distance, 0, 0);
  end.translation() = fcl::Vector3d(-distance, 0, 0);
  fcl::ContinuousCollisionRequestd request;
  request.ccd_solver_type = solver;
  request.num_max_iterations = poses;
  fcl::ContinuousCollisionResultd result;
  double const returned = fcl::continuousCollide(body.get(), still, still, body.get(), begin, end, request, result);
  std::printf("from %g, solver %d, %d poses: returned %g, collides %d, time %g (true %g)\n", distance, solver, poses, returned,
              result.is_collide, result.time_of_contact, (distance - 2) / (2 * distance));
  return {returned, result.time_of_contact, result.is_collide};
}

int main() {
  bool const as_default = fcl::ContinuousCollisionRequestd().ccd_solver_type == fcl::CCDC_NAIVE &&
                          fcl::ContinuousCollisionRequestd().num_max_iterations == 10;
  bool same = as_default;
  Answer const near = fly(10, fcl::CCDC_NAIVE, 10), far = fly(100, fcl::CCDC_NAIVE, 10), fine = fly(100, fcl::CCDC_NAIVE, 1000);
  same &= near.collides && std::abs(near.time - 4.0 / 9) < 1e-6;
  same &= !far.collides && far.time == 1;
  same &= fine.collides && std::abs(fine.time - 0.49) < 0.0011;
  for (auto const solver : {fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDC_RAY_SHOOTING})
    for (double const distance : {10.0, 100.0}) {
      Answer const none = fly(distance, solver, 10);
      same &= !none.collides && none.returned == -1 && none.time == 1;
    }
  return same ? 0 : 1;
}
END
libraries=$dir/usr/lib/x86_64-linux-gnu
g++ -std=c++14 -O1 -w -I usr/include -I /usr/include/eigen3 check.cpp -L "$libraries" -Wl,-rpath,"$libraries" \
  -lfcl -lccd -loctomap -loctomath -o check
./check
