#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Pushed off its centre, a body of mass m turns m times too fast in p2-es, and a body made of n equal shapes has n times its moment of inertia.
# In p2.js, every shape of a body has the same mass, whatever its area, and a capsule counts as a rectangle.
#
# p2-es 1.2.3 ("a maintained fork of p2.js") and p2.js (npm p2 0.7.1). Both describe setDensity as setting "the total density of the body",
# adjustCenterOfMass as moving shapes "so their center of mass becomes the body center of mass", updateMassProperties as updating .inertia,
# .invMass and .invInertia. Moments divided by the mass, after these calls with the density 1, seen on 1 December 2026:
#
#   body                                              p2-es     p2.js     true
#   ellipse (3, 1), a polygon of 400 points           2.500     2.500     2.5 = (a² + b²)/4
#   the same, made of its halves left and right       5.000     2.500     2.5
#   circles of radius 2 and 1 that touch              8.62      4.31      3.14
#   L of 6 x 1 and 1 x 2, by fromPolygon              8.573     4.286     4.010
#   capsule, length 2 (without its ends), radius 0.5  0.7361    0.6042    0.7361
#
#   angular speed / speed after a force at (3, 0) along y, on the ellipse of mass 0.1, 1, 10: p2-es 0.12, 1.2, 12; p2.js and true 1.2
#
# In p2-es invInertia is mass/inertia; the solver uses it. The moments there are each shape's own number for the mass 1, added up and then
# multiplied by the whole mass. To get true motion, set body.inertia and body.invInertia after the last call that changes mass or shapes.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" p2-es@1.2.3 p2@0.7.1
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import * as es from 'p2-es';
import old from 'p2';

// Points of the ellipse (3, 1) between two angles, relative to the place (x, 0) of the shape.
const arc = (from, to, x, n) => Array.from({ length: n }, (_, i) => from + (to - from) * i / n).map((t) => [3 * Math.cos(t) - x, Math.sin(t)]);
const centroid = 4 / Math.PI; // of half of the ellipse, 4 a/(3 pi)
const half = Math.PI / 2;
const bodies = {
  ellipse: (p2, b) => b.addShape(new p2.Convex({ vertices: arc(0, 2 * Math.PI, 0, 400) })),
  halves: (p2, b) => [1, -1].forEach((side) => {
    const vertices = arc(side * half - Math.PI, side * half, side * centroid, 200).concat([[-side * centroid, side]]);
    b.addShape(new p2.Convex({ vertices }), [side * centroid, 0]);
  }),
  circles: (p2, b) => [[2, 0], [1, 3]].forEach(([radius, x]) => b.addShape(new p2.Circle({ radius }), [x, 0])),
  L: (p2, b) => assert(b.fromPolygon([[0, 0], [6, 0], [6, 1], [1, 1], [1, 3], [0, 3]])),
  capsule: (p2, b) => b.addShape(new p2.Capsule({ length: 2, radius: 0.5 })),
};
const inside = {
  ellipse: (x, y) => x * x / 9 + y * y < 1,
  halves: (x, y) => x * x / 9 + y * y < 1,
  circles: (x, y) => Math.hypot(x, y) < 2 || Math.hypot(x - 3, y) < 1,
  L: (x, y) => (x > 0 && y > 0) && ((x < 6 && y < 1) || (x < 1 && y < 3)),
  capsule: (x, y) => Math.hypot(Math.max(0, Math.abs(x) - 1), y) < 0.5,
};
// The moment about the centre of mass, divided by the mass, from the middles of squares with the side 1/100.
function counted(within) {
  let area = 0, sx = 0, sy = 0, second = 0;
  for (let i = -400; i < 700; i++) {
    for (let j = -300; j < 400; j++) {
      const x = (i + 0.5) / 100, y = (j + 0.5) / 100;
      if (within(x, y)) area++, sx += x, sy += y, second += x * x + y * y;
    }
  }
  return second / area - (sx * sx + sy * sy) / (area * area);
}
function moment(p2, make) {
  const body = new p2.Body({ mass: 1 });
  make(p2, body);
  body.setDensity(1);
  body.adjustCenterOfMass();
  return body.inertia / body.mass;
}
function rate(p2, mass) {
  const world = new p2.World({ gravity: [0, 0] }), body = new p2.Body({ mass, damping: 0, angularDamping: 0 });
  bodies.ellipse(p2, body);
  world.addBody(body);
  body.applyForce([0, mass], [3, 0]);
  world.step(1 / 60);
  return body.angularVelocity / body.velocity[1];
}
const near = (x, y, what) => assert(Math.abs(x / y - 1) < 3e-3, `${what}: ${x} instead of ${y}`);

const discs = (4 * (2 + 0.6 ** 2) + 1 * (0.5 + 2.4 ** 2)) / 5; // areas 4 pi, pi; half the squared radii, distances from the centre of mass
const box = (w, h, x, y) => w * h * ((w * w + h * h) / 12 + x * x + y * y);
const angle = (box(6, 1, 3 - 2.375, 0.5 - 0.875) + box(1, 2, 0.5 - 2.375, 2 - 0.875)) / 8; // centre of mass (2.375, 0.875)
const ends = Math.PI / 4 * (0.5 ** 2 / 2 + 1) + 2 * 4 / 3 * 0.5 ** 3 * 1; // of the disc, its halves moved apart: A (r²/2 + l²/4) + 2 l (2/3) r³
const stadium = (box(2, 1, 0, 0) + ends) / (2 + Math.PI / 4);
const rows = { ellipse: [2.5, 2.5, 2.5], halves: [5, 2.5, 2.5], circles: [8.62, 4.31, discs], L: [8.573, 4.2865, angle], capsule: [stadium, 0.6042, stadium] };
for (const [name, [withEs, inOld, right]] of Object.entries(rows)) {
  console.log(name, 'p2-es', moment(es, bodies[name]), 'p2', moment(old, bodies[name]), 'true', right, counted(inside[name]));
  near(counted(inside[name]), right, `${name}, true`);
  near(moment(es, bodies[name]), withEs, `${name}, p2-es`);
  near(moment(old, bodies[name]), inOld, `${name}, p2`);
}
for (const mass of [0.1, 1, 10]) {
  console.log('mass', mass, 'angular speed / speed', rate(es, mass), rate(old, mass));
  near(rate(es, mass), 3 / 2.5 * mass, 'p2-es');
  near(rate(old, mass), 3 / 2.5, 'p2');
}
END
node "$dir/check.mjs"
