#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A convex hull has the mass and the moments of inertia of its bounding box, nearly twice the mass of the ellipsoid whose points were given,
# and collides as a body that is thicker by 0.05 on all sides, in any unit of length.
#
# OimoPhysics (npm oimophysics 1.2.2), ConvexHullGeometry, "the smallest convex polyhedron which contains all vertices" by its
# documentation. 266 points on ellipsoids, the ends of the axes among them; density 1. Mass divided by that of the ellipsoid, moments
# divided by the mass and a², and what contacts of two parallel ones, and rays, find too far on each axis, seen on 1 December 2026:
#
#   semi-axes         mass     moments                contacts   rays
#   1, 2, 3           1.910    4.333  3.333  1.667    0.1        0.05
#   0.1, 0.2, 0.3     1.910    4.333  3.333  1.667    0.1        0.05
#   the hull itself   0.972    2.561  1.975  0.977    0          0
#
# The mass is 48 = 2 * 4 * 6, as that of BoxGeometry (1, 2, 3). Mass, contacts and rays of a cylinder, which has the same margin, are right:
# its margin is taken off the inside. After setGjkMergin(0), contacts and rays are right to 0.0001; set mass and moments by setMassData.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" oimophysics@1.2.2
cat >"$dir/check.cjs" <<'END'
const assert = require('node:assert');
const { collision: { geometry: shapes }, common: { Vec3 }, dynamics } = require('oimophysics').oimo;
const { RigidBody, RigidBodyConfig, RigidBodyType, Shape, ShapeConfig } = dynamics.rigidbody;

const around = 24, down = 12;
// The points on circles about z and at its ends, and the triangles between them, counterclockwise from outside.
function points([a, b, c]) {
  const list = [[0, 0, c]];
  for (let i = 1; i < down; i++) {
    const s = Math.sin(Math.PI * i / down), z = c * Math.cos(Math.PI * i / down);
    for (let j = 0; j < around; j++) list.push([a * s * Math.cos(2 * Math.PI * j / around), b * s * Math.sin(2 * Math.PI * j / around), z]);
  }
  return [...list, [0, 0, -c]];
}
const at = (i, j) => (i === 0 ? 0 : i === down ? 1 + (down - 1) * around : 1 + (i - 1) * around + j % around);
function triangles() {
  const list = [];
  for (let i = 0; i < down; i++) {
    for (let j = 0; j < around; j++) {
      if (i < down - 1) list.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      if (i > 0) list.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return list;
}
// Volume and moments / volume of the hull, as sums of tetrahedra with a corner at the centre: the integral of x² is V/10 times the sum of
// x_i x_k over i <= k.
function hull(axes) {
  const vertices = points(axes), squares = [0, 0, 0];
  let volume = 0;
  for (const [p, q, r] of triangles().map((t) => t.map((i) => vertices[i]))) {
    const v = (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0])) / 6;
    assert(v > 0);
    volume += v;
    for (let k = 0; k < 3; k++) squares[k] += v / 10 * (p[k] ** 2 + q[k] ** 2 + r[k] ** 2 + p[k] * q[k] + q[k] * r[k] + r[k] * p[k]);
  }
  const [x, y, z] = squares.map((s) => s / volume);
  return [volume, [y + z, z + x, x + y]];
}

function body(world, shape, place, type) {
  const configuration = new RigidBodyConfig(), settings = new ShapeConfig();
  configuration.type = type;
  configuration.position = new Vec3(...place);
  settings.geometry = shape;
  settings.density = 1;
  const made = new RigidBody(configuration);
  made.addShape(new Shape(settings));
  world.addRigidBody(made);
  return made;
}
const still = () => new dynamics.World(2, new Vec3(0, 0, 0)), along = (k, x) => [0, 1, 2].map((i) => (i === k ? x : 0));
function touch(shape, place) {
  const world = still();
  body(world, shape(), [0, 0, 0], RigidBodyType.STATIC);
  body(world, shape(), place, RigidBodyType.DYNAMIC);
  world.step(1e-9);
  for (let c = world.getContactManager().getContactList(); c; c = c.getNext()) if (c.isTouching()) return true;
  return false;
}
// Where contacts begin along axis k, less the distance where the bodies touch.
function excess(shape, half, k) {
  let inside = 1.5 * half, outside = 4 * half;
  for (let i = 0; i < 45; i++) {
    const middle = (inside + outside) / 2;
    if (touch(shape, along(k, middle))) inside = middle; else outside = middle;
  }
  return inside - 2 * half;
}
function ray(shape, half, k) {
  const world = still(), hit = new dynamics.callback.RayCastClosest();
  body(world, shape(), [0, 0, 0], RigidBodyType.STATIC);
  world.rayCast(new Vec3(...along(k, 50)), new Vec3(0, 0, 0), hit);
  return [hit.position.x, hit.position.y, hit.position.z][k] - half;
}
function masses(shape) {
  const made = body(still(), shape, [0, 0, 0], RigidBodyType.DYNAMIC), m = made.getMass(), moments = made.getLocalInertia();
  return [m, [moments.e00 / m, moments.e11 / m, moments.e22 / m]];
}
const near = (x, y, tolerance) => assert(Math.abs(x - y) <= tolerance, `${x} instead of ${y}`);

for (const axes of [[1, 2, 3], [0.1, 0.2, 0.3]]) {
  const vertices = points(axes), make = () => new shapes.ConvexHullGeometry(vertices.map((p) => new Vec3(...p)));
  const bare = () => { const shape = make(); shape.setGjkMergin(0); return shape; };
  const [mass, moments] = masses(make()), [volume, true_moments] = hull(axes), [a, b, c] = axes, ellipsoid = 4 / 3 * Math.PI * a * b * c;
  const scaled = (list) => list.map((x) => x / (a * a));
  console.log(axes, vertices.length, 'points, mass', mass / ellipsoid, 'moments', scaled(moments));
  console.log('  true mass of the hull', volume / ellipsoid, 'moments', scaled(true_moments));
  assert.equal(vertices.length, 266);
  near(mass, 8 * a * b * c, 1e-9);
  near(mass / ellipsoid, 1.910, 5e-4);
  near(volume / ellipsoid, 0.972, 5e-4);
  scaled(moments).forEach((x, i) => near(x, [13 / 3, 10 / 3, 5 / 3][i], 1e-9));
  scaled(true_moments).forEach((x, i) => near(x, [2.561, 1.975, 0.977][i], 5e-4));
  for (let k = 0; k < 3; k++) {
    const found = [excess(make, axes[k], k), ray(make, axes[k], k)];
    console.log('  axis', k, 'contacts and rays too far by', found, 'without margin', excess(bare, axes[k], k), ray(bare, axes[k], k));
    near(found[0], 0.1, 1e-6);
    near(found[1], 0.05, 1e-6);
    near(excess(bare, axes[k], k), 0, 2e-4);
    near(ray(bare, axes[k], k), 0, 2e-4);
  }
}
const all = points([1, 2, 3]).map((p) => new Vec3(...p));
assert.deepEqual(masses(new shapes.BoxGeometry(new Vec3(1, 2, 3))), masses(new shapes.ConvexHullGeometry(all)));
const cylinder = () => new shapes.CylinderGeometry(1, 2), [mass] = masses(cylinder());
console.log('cylinder', mass, excess(cylinder, 1, 0), ray(cylinder, 1, 0));
near(mass, 4 * Math.PI, 1e-9);
near(excess(cylinder, 1, 0), 0, 1e-3);
near(ray(cylinder, 1, 0), 0, 1e-3);
END
node "$dir/check.cjs"
