#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Two ellipses that overlap are taken for apart, and depths are too small: an ellipse is a polygon of 14 to 20 points by default, and of 8 if it
# is small in the unit of length, where no step makes it finer.
#
# check2d (npm check2d 9.36.4, once detect-collisions), "providing fast and accurate collision checks across many shape types", among them
# ellipses. createEllipse(position, radiusX, radiusY, step) of the radii 2 and 1 times the unit; step is (radiusX + radiusY)/pi by default.
# Lengths in this unit, seen on 1 December 2026:
#
#   unit, step                     points   area / (pi a b)   depth at (3.9, 0)   at (0, 1.9)   apart, of 2000 that overlap by 0 to 10 %
#   0.1, default                   8        0.900             0.077               0.098         1031
#   0.1, 0.001                     8        0.900             0.077               0.098
#   1, default                     15       0.971             0.056               0.089         182
#   1, 0.1 or 0.01                 15       0.971             0.056               0.089
#   100, default                   15       0.971             0.056               0.089         182
#   100, 1                         1405     1.000             0.100               0.100         0
#   true                                    1                 0.1                 0.1           0
#
# The polygon is inside the ellipse, and has no point at (-2, 0) if their number is odd. Steps below 1 count as 1. Circles are exact.
# Take a unit in which the radii are hundreds, and the step 1.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" check2d@9.36.4
cat >"$dir/check.cjs" <<'END'
const assert = require('node:assert');
const { System } = require('check2d');

// The depth of the ellipse (2, 1) at the place in the same one at the origin, in the unit, or 0.
function depth([x, y], unit, step) {
  const system = new System(), make = (px, py) => system.createEllipse({ x: px * unit, y: py * unit }, 2 * unit, unit, step);
  return system.checkCollision(make(0, 0), make(x, y)) ? system.response.overlap / unit : 0;
}
// The sum of the two is the ellipse (4, 2): the true depth is the distance from the place to it, and they overlap if it is inside.
function sampled([x, y]) {
  const distances = Array.from({ length: 20000 }, (_, i) => Math.PI * i / 10000).map((t) => Math.hypot(4 * Math.cos(t) - x, 2 * Math.sin(t) - y));
  return Math.min(...distances);
}
function measure(unit, step) {
  const points = new System().createEllipse({ x: 0, y: 0 }, 2 * unit, unit, step).calcPoints;
  const twice = points.reduce((sum, p, i) => sum + p.x * points[(i + 1) % points.length].y - p.y * points[(i + 1) % points.length].x, 0);
  return { points: points.length, area: twice / (4 * Math.PI * unit * unit) };
}
let state;
const random = () => (state = state * 16807 % 2147483647) / 2147483647;
function apart(unit, step, number = 2000) {
  state = 7;
  let count = 0;
  for (let i = 0; i < number; i++) {
    const t = 2 * Math.PI * random(), k = 0.9 + 0.1 * random();
    count += depth([4 * k * Math.cos(t), 2 * k * Math.sin(t)], unit, step) === 0;
  }
  return count;
}
const near = (x, y, tolerance) => assert(Math.abs(x - y) < tolerance, `${x} instead of ${y}`);

const across = [3.9, 0], along = [0, 1.9]; // 4 - 3.9 and 2 - 1.9: beyond the centres of curvature, the ends of the axes are nearest
near(sampled(across), 0.1, 1e-6);
near(sampled(along), 0.1, 1e-6);
function check(unit, step, points, area, x, y) {
  const found = measure(unit, step);
  console.log(unit, step, found, depth(across, unit, step), depth(along, unit, step));
  assert.equal(found.points, points);
  near(found.area, area, 1e-3);
  near(depth(across, unit, step), x, 1e-3);
  near(depth(along, unit, step), y, 1e-3);
}
check(0.1, undefined, 8, 0.9003, 0.077, 0.0979);
check(0.1, 0.001, 8, 0.9003, 0.077, 0.0979);
for (const step of [undefined, 0.1, 0.01]) check(1, step, 15, 0.971, 0.0563, 0.0889);
check(100, undefined, 15, 0.971, 0.0563, 0.0889);
check(100, 1, 1405, 1, 0.1, 0.1);
const counts = [apart(0.1), apart(1), apart(100), apart(100, 1, 40)];
console.log('apart', counts);
near(counts[0], 1031, 10);
near(counts[1], 182, 10);
near(counts[2], 182, 10);
assert.equal(counts[3], 0);

const system = new System(), circles = [0, 1.99].map((x) => system.createCircle({ x, y: 0 }, 1));
assert(system.checkCollision(...circles));
near(system.response.overlap, 0.01, 1e-12);
END
node "$dir/check.cjs"
