#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Whether two ellipses cross depends on the unit of length and on the place of the origin, and some points that are returned are on one of
# the two ellipses only.
#
# kld-intersections (npm kld-intersections 0.7.0), "a library of intersection algorithms covering all permutations for any two of the
# following SVG shapes", among them ellipses with axes along x and y. Its known issues are about Bézier curves. Seen on 1 December 2026:
#
#   radii, radii and displacement        unit, common offset      returned
#   (2, 1), (1, 2), (0.5, 0.3)           1 to 1000                4 points, true
#   the same                             0.016 or less            "No Intersection"
#   the same                             1, (300, 300) or more    "No Intersection"
#   300 random pairs that cross          0.01                     "No Intersection" for all
#   the same                             1, (1000, 1000)          "No Intersection" for 277
#   (3, 1), (3, 1), (0, 0.1)             1                        "No Intersection" (true: (±2.996, 0.05))
#   the same                             0.1                      the two true points, each twice
#   (3, 1), (3, 1), (0.1, 0)             1                        (0.05, ±0.99986), true, and (0.15, ±0.99986), on the first one only
#   (2, 1), (1, 1), (3.002, 0)           1                        (2.002, 0) twice, though they are 0.002 apart
#   (2, 1), (1.9, 0.9), (0, 0.001)       1                        RangeError: Y values of bounds must be of opposite sign
#
# Coefficients of a polynomial, which grow as the eighth to the twelfth power of the unit, are set to zero below 1e-12. A point counts as one
# of an ellipse if the equation, which has squares of radii for coefficients, holds to 0.001 times the sum of their squares. With the centre
# of one ellipse at the origin and radii near 1, more is found; check each point by both equations.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" kld-intersections@0.7.0
cat >"$dir/check.cjs" <<'END'
const assert = require('node:assert');
const { ShapeInfo, Intersection } = require('kld-intersections');

// A pair is [radii of the first ellipse, whose centre is the offset, radii of the second one, its displacement].
function crossings([[a, b], [c, d], [x, y]], unit = 1, offset = 0) {
  const shape = (cx, cy, rx, ry) => ShapeInfo.ellipse({ cx: offset + cx * unit, cy: offset + cy * unit, rx: rx * unit, ry: ry * unit });
  const { status, points } = Intersection.intersect(shape(0, 0, a, b), shape(x, y, c, d));
  assert.equal(status, points.length > 0 ? 'Intersection' : 'No Intersection');
  return points.map((p) => [(p.x - offset) / unit, (p.y - offset) / unit]);
}
const level = ([x, y], [a, b]) => (x / a) ** 2 + (y / b) ** 2 - 1;
const onSecond = ([, radii, [x, y]], p) => level([p[0] - x, p[1] - y], radii);
const on = (pair, p) => Math.abs(level(p, pair[0])) + Math.abs(onSecond(pair, p)) < 1e-6;
// How often the second equation changes its sign on the first ellipse: the number of crossings.
function signChanges(pair) {
  const n = 10000, sign = (i) => Math.sign(onSecond(pair, [pair[0][0] * Math.cos(2 * Math.PI * (i + 0.5) / n), pair[0][1] * Math.sin(2 * Math.PI * (i + 0.5) / n)]));
  return Array.from({ length: n }, (_, i) => sign(i) !== sign(i + 1)).filter(Boolean).length;
}
function show(what, pair, unit, offset) {
  const points = crossings(pair, unit, offset);
  console.log(what, JSON.stringify(pair), unit ?? 1, offset ?? 0, points.map((p) => p.map((v) => v.toFixed(5)).join(' ')), 'crossings', signChanges(pair));
  return points;
}
function same(points, expected) {
  assert.equal(points.length, expected.length);
  assert(expected.every((q) => points.some((p) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-5)));
}

const pair = [[2, 1], [1, 2], [0.5, 0.3]];
assert.equal(signChanges(pair), 4);
for (const unit of [1, 10, 1000]) assert(show('unit', pair, unit).filter((p) => on(pair, p)).length === 4);
for (const unit of [0.016, 0.01, 0.001]) same(show('unit', pair, unit), []);
for (const offset of [300, 1000, 10000]) same(show('offset', pair, 1, offset), []);

let state = 1;
const random = () => (state = state * 16807 % 2147483647) / 2147483647;
const pairs = [];
while (pairs.length < 300) {
  const next = [[0.5 + random(), 0.5 + random()], [0.5 + random(), 0.5 + random()], [2 * random() - 1, 2 * random() - 1]];
  if (signChanges(next) > 0) pairs.push(next);
}
const missed = (unit, offset) => pairs.filter((p) => crossings(p, unit, offset).length === 0).length;
console.log('missed of', pairs.length, missed(1, 0), missed(0.01, 0), missed(1, 1000));
assert(missed(1, 0) === 0 && missed(0.01, 0) === 300 && Math.abs(missed(1, 1000) - 277) <= 3);

// Equal ellipses cross where a parallel to the other axis, half way between the centres, meets them.
const up = [[3, 1], [3, 1], [0, 0.1]], x = 3 * Math.sqrt(1 - 0.05 ** 2), side = [[3, 1], [3, 1], [0.1, 0]], y = Math.sqrt(1 - (0.05 / 3) ** 2);
assert(signChanges(up) === 2 && on(up, [x, 0.05]) && signChanges(side) === 2 && on(side, [0.05, y]));
same(show('up', up), []);
same(show('up', up, 0.1), [[x, 0.05], [-x, 0.05], [x, 0.05], [-x, 0.05]]);
const beside = Math.sqrt(1 - 0.05 ** 2 / 9);
same(show('side', side), [[0.05, y], [0.05, -y], [0.15, beside], [0.15, -beside]]);
assert(!on(side, [0.15, beside]));

const apart = [[2, 1], [1, 1], [3.002, 0]];
assert.equal(signChanges(apart), 0);
same(show('apart', apart), [[2.002, 0], [2.002, 0]]);
const within = [[2, 1], [1.9, 0.9], [0, 0.001]];
assert.equal(signChanges(within), 0);
assert.throws(() => crossings(within), /Y values of bounds must be of opposite sign/);
END
node "$dir/check.cjs"
