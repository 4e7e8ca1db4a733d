#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The length of a geodesic on an ellipsoid that is longer than wide is shorter than the straight line between its ends along a meridian, and
# too long along the equator. On a flat ellipsoid it is right for ratios of the axes near 1, and 1100 times too long for the ratio 0.4.
#
# Cesium (npm @cesium/engine 24.0.0), EllipsoidGeodesic.surfaceDistance and EllipsoidRhumbLine.surfaceDistance, of which the first is "the
# surface distance between the start and end point" in its documentation. Semi-axes (1, 1, c). Along the meridian from the equator to the
# latitude of 60 degrees, and along a sixth of the equator: both lines are geodesics and rhumb lines. Length divided by the true one, seen
# on 1 December 2026:
#
#   c       meridian, geodesic    rhumb     equator, both
#   0.9     1.000005              1.000     1
#   0.7     1.0093                1.0004    1
#   0.6     1.132                 1.003     1
#   0.5     1.745                 1.012     1
#   0.4     1132.5                1.042     1
#   1.1     0.888                 0.888     1.1
#   1.5     0.612                 0.598     1.5
#   2       0.700                 0.406     2
#
# The straight line along the meridian of (1, 1, 2) is 0.964 of the true length. The classes take the longer axis for the radius of the
# equator, and lengths are the first terms of series in a small flattening. No message says so.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @cesium/engine@24.0.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { Cartesian3, Cartographic, Ellipsoid, EllipsoidGeodesic, EllipsoidRhumbLine } from '@cesium/engine';

const sixth = Math.PI / 3, near = (x, y, digits) => assert(Math.abs(x - y) <= 0.51 * 10 ** -digits, `${x} instead of ${y}`);
// The radius of curvature of the meridian, a² c² / (a² cos² + c² sin²)^(3/2) in the latitude, by the midpoint rule.
function meridian(c) {
  const steps = 20000;
  let sum = 0;
  for (let i = 0; i < steps; i++) {
    const t = sixth * (i + 0.5) / steps;
    sum += c * c / (Math.cos(t) ** 2 + (c * Math.sin(t)) ** 2) ** 1.5;
  }
  return sum * sixth / steps;
}
function chords(body) {
  const steps = 2000, at = (i) => Cartesian3.fromRadians(0.3, sixth * i / steps, 0, body);
  let sum = 0;
  for (let i = 0; i < steps; i++) sum += Cartesian3.distance(at(i), at(i + 1));
  return [sum, Cartesian3.distance(at(0), at(steps))];
}

function row(c, expected, digits) {
  const body = new Ellipsoid(1, 1, c), truth = meridian(c), [polygon, straight] = chords(body);
  const length = (line, from, to) => new line(new Cartographic(...from), new Cartographic(...to), body).surfaceDistance;
  const found = [EllipsoidGeodesic, EllipsoidRhumbLine].map((line) => length(line, [0.3, 0], [0.3, sixth]) / truth);
  const equator = [EllipsoidGeodesic, EllipsoidRhumbLine].map((line) => length(line, [0, 0], [sixth, 0]) / sixth);
  console.log(c, 'meridian', found, 'equator', equator, 'straight line', straight / truth);
  assert(Math.abs(polygon / truth - 1) < 1e-6);
  found.forEach((x, i) => near(x, expected[i], digits[i]));
  equator.forEach((x) => assert(Math.abs(x - Math.max(1, c)) < 1e-9));
  assert(c < 1 || found[0] < straight / truth);
  if (c === 2) near(straight / truth, 0.964, 3);
}
row(0.9, [1.000005, 1], [6, 4]);
row(0.7, [1.0093, 1.0004], [4, 4]);
row(0.6, [1.132, 1.003], [3, 3]);
row(0.5, [1.745, 1.012], [3, 3]);
row(0.4, [1132.5, 1.042], [1, 3]);
row(1.1, [0.888, 0.888], [3, 3]);
row(1.5, [0.612, 0.598], [3, 3]);
row(2, [0.700, 0.406], [3, 3]);
END
node "$dir/check.mjs"
