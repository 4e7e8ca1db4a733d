#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The three lengths of an ellipsoid are whole axes, and whether two ellipsoids touch depends on the collision detector.
#
# DART 6.12.1 (Debian 12, 6.12.1+dfsg4-12+b2), EllipsoidShape(Vector3d(1, 2, 3)): volume pi = 4/3 pi (1/2) (1) (3/2), bounding box +-(0.5, 1, 1.5).
# Two of them, parallel, with centres x apart along the shortest axis, touch at x = 1. Contacts seen on 29 November 2026:
#
#   x       depth    fcl (the default)           bullet    dart
#   0.5     0.5      26, depth of the first 0.14 none      1, depth 0.5
#   0.99    0.01     7, depth of the first 0.0099 none     1, depth 0.01
#   1.01    none     none                        none      none
#
# fcl: the ellipsoid is a triangle mesh. bullet: a scaled btMultiSphereShape, no contact and no message. dart: a ball with the first
# axis as diameter, with a message of an error.
# Needs g++, libeigen3-dev and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libdart6.12=6.12.1+dfsg4-12+b2 libdart-collision-bullet6.12=6.12.1+dfsg4-12+b2 libdart-dev \
  libdart-collision-bullet-dev libdart-external-odelcpsolver6.12 libdart-external-convhull-3d-dev libdart-external-ikfast-dev libfcl0.7 \
  libfcl-dev libccd2 libccd-dev liboctomap1.9 liboctomap-dev libbullet3.24 libbullet-dev libassimp5 libassimp-dev libdraco7 \
  libminizip1 libboost-filesystem1.74.0 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'EOF'
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <dart/collision/CollisionGroup.hpp>
#include <dart/collision/CollisionOption.hpp>
#include <dart/collision/CollisionResult.hpp>
#include <dart/collision/bullet/BulletCollisionDetector.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/collision/fcl/FCLCollisionDetector.hpp>
#include <dart/dynamics/EllipsoidShape.hpp>
#include <dart/dynamics/SimpleFrame.hpp>

using namespace dart;

static void expect(char const *what, double found, double expected) {
  std::printf("%s: %.4g\n", what, found);
  if (!(std::fabs(found - expected) < 1e-3)) std::printf("is not %g\n", expected), std::exit(1);
}

static collision::CollisionResult contacts(collision::CollisionDetectorPtr const &detector, double x) {
  auto const shape = std::make_shared<dynamics::EllipsoidShape>(Eigen::Vector3d(1, 2, 3));
  dynamics::SimpleFrame one(dynamics::Frame::World()), two(dynamics::Frame::World());
  one.setShape(shape);
  two.setShape(shape);
  two.setTranslation(Eigen::Vector3d(x, 0, 0));
  auto const group = detector->createCollisionGroup(&one, &two);
  collision::CollisionOption option;
  option.enableContact = true;
  collision::CollisionResult result;
  group->collide(option, &result);
  return result;
}

int main() {
  dynamics::EllipsoidShape const shape(Eigen::Vector3d(1, 2, 3));
  expect("volume", shape.getVolume(), M_PI);
  expect("half box along z", shape.getBoundingBox().getMax()[2], 1.5);
  auto const fcl = collision::FCLCollisionDetector::create();
  auto const bullet = collision::BulletCollisionDetector::create();
  auto const own = collision::DARTCollisionDetector::create();
  expect("fcl at 0.5, depth", contacts(fcl, 0.5).getContact(0).penetrationDepth, 0.1407);
  if (contacts(fcl, 0.5).getNumContacts() < 10) return 1;
  expect("bullet at 0.5, contacts", contacts(bullet, 0.5).getNumContacts(), 0);
  expect("bullet at 0.99, contacts", contacts(bullet, 0.99).getNumContacts(), 0);
  expect("dart at 0.5, depth", contacts(own, 0.5).getContact(0).penetrationDepth, 0.5);
  expect("fcl at 1.01, contacts", contacts(fcl, 1.01).getNumContacts(), 0);
}
EOF
libraries=usr/lib/x86_64-linux-gnu
g++ -w -std=c++17 -O0 -I usr/include -I usr/include/bullet -I /usr/include/eigen3 check.cpp -o check -L $libraries \
  -ldart-collision-bullet -ldart -lfcl -lccd -loctomap -loctomath -lassimp -lBulletCollision -lLinearMath -Wl,-rpath-link,$libraries
LD_LIBRARY_PATH=$libraries ./check 2>messages
grep -q "not supported by DARTCollisionDetector" messages
