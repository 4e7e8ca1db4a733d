#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The point of an ellipsoid below a point inside it can be one of the opposite side, nearly twice as far as the nearest one, and the height
# of the point is then positive, as if it were outside. For a quarter of the points inside the ellipsoid (1, 2, 3), the result is not the
# nearest.
#
# Cesium (npm @cesium/engine 24.0.0), Ellipsoid.scaleToGeodeticSurface. Its documentation says: "Scales the provided Cartesian position
# along the geodetic surface normal so that it is on the surface of this ellipsoid", and names the centre as the only exception. The height
# is that of cartesianToCartographic. Seen on 1 December 2026:
#
#   semi-axes   point              returned                 height    nearest                 height
#   1, 2, 3     0.3, 0.3, 0.3      -0.968, 0.446, 0.351      1.277    0.977, 0.363, 0.325     -0.681
#   1, 2, 3     0.2, 0.8, 0.6      -0.152, 1.902, 0.808     -1.175    0.841, 0.988, 0.656     -0.671
#   1, 2, 3     0.05, 0.05, 0.05    0.857, 0.857, 0.857     -1.398    0.999, 0.066, 0.056     -0.949
#   1, 2, 3     0.5, 0.5, 0.5       0.943, 0.567, 0.528     -0.449    the same                -0.449
#   1, 1, 2     0.2, 0.2, 0.6      -0.632, -0.632, 0.894     1.214    0.659, 0.659, 0.726     -0.661
#
# Of 528 points of a grid inside the octant, the distance to the returned point is more than 1 % too large for 136 at (1, 2, 3), of which 29
# have a positive height, for 96 at (1, 1, 0.5) and 44 at (1, 1, 2), and for none at the ellipsoid of the Earth. All of these have x²/a² +
# y²/b² + z²/c² below 0.63. If this is below 0.1, the result is the point times a number, as in the third row. Points outside, and those
# nearer to the surface, are right.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @cesium/engine@24.0.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { Cartesian3, Ellipsoid } from '@cesium/engine';

// The nearest point is (a² x / (t + a²), ...), where t > -c² with the least semi-axis c is the root of a decreasing function: bisection.
function nearest(axes, point) {
  const sum = (t) => axes.reduce((s, a, i) => s + (a * point[i] / (t + a * a)) ** 2, 0), least = Math.min(...axes);
  let low = Math.abs(point[axes.indexOf(least)]) * least - least ** 2, high = Math.hypot(...axes.map((a, i) => a * point[i])) - least ** 2;
  for (let i = 0; i < 100; i++) {
    const middle = (low + high) / 2;
    if (sum(middle) > 1) low = middle; else high = middle;
  }
  return axes.map((a, i) => a * a * point[i] / (high + a * a));
}
const between = (p, q) => Math.hypot(...p.map((x, i) => x - q[i])), norm = (axes, p) => Math.hypot(...p.map((x, i) => x / axes[i]));
function returned(body, point) {
  const found = body.scaleToGeodeticSurface(new Cartesian3(...point));
  return [found.x, found.y, found.z];
}

// No point of a fine grid of angles is nearer than the one called nearest, so the bisection has the right root.
function confirm(axes, point, distance) {
  let least = Infinity;
  for (let i = 0; i <= 400; i++) {
    for (let j = 0; j < 400; j++) {
      const theta = Math.PI * i / 400, phi = 2 * Math.PI * j / 400, s = Math.sin(theta);
      const unit = [s * Math.cos(phi), s * Math.sin(phi), Math.cos(theta)];
      least = Math.min(least, between(point, unit.map((u, k) => axes[k] * u)));
    }
  }
  assert(least > distance - 1e-9 && least < distance + 1e-3);
}

function row(axes, point, place, height, depth) {
  const body = new Ellipsoid(...axes), found = returned(body, point), truth = nearest(axes, point), distance = between(point, truth);
  const stated = body.cartesianToCartographic(new Cartesian3(...point)).height;
  console.log(axes, point, 'returned', found, 'height', stated, 'nearest', truth, 'height', -distance);
  assert(Math.abs(norm(axes, truth) - 1) < 1e-9 && Math.abs(norm(axes, found) - 1) < 1e-6);
  assert(between(found, place) < 1e-3 && Math.abs(stated - height) < 1e-3 && Math.abs(distance - depth) < 1e-3);
  confirm(axes, point, distance);
}
row([1, 2, 3], [0.3, 0.3, 0.3], [-0.968, 0.446, 0.351], 1.277, 0.681);
row([1, 2, 3], [0.2, 0.8, 0.6], [-0.152, 1.902, 0.808], -1.175, 0.671);
row([1, 2, 3], [0.05, 0.05, 0.05], [0.857, 0.857, 0.857], -1.398, 0.949);
row([1, 2, 3], [0.5, 0.5, 0.5], [0.943, 0.567, 0.528], -0.449, 0.449);
row([1, 1, 2], [0.2, 0.2, 0.6], [-0.632, -0.632, 0.894], 1.214, 0.661);

const steps = Array.from({ length: 10 }, (_, i) => (i + 0.5) / 10);
const grid = steps.flatMap((x) => steps.flatMap((y) => steps.map((z) => [x, y, z])));
function count(axes) {
  const body = new Ellipsoid(...axes), points = grid.filter((u) => Math.hypot(...u) < 1).map((u) => u.map((x, i) => x * axes[i]));
  const distances = (p) => [between(p, returned(body, p)), between(p, nearest(axes, p))];
  const wrong = points.filter((p) => distances(p)[0] > 1.01 * distances(p)[1]);
  const outside = wrong.filter((p) => p.reduce((s, x, i) => s + x * (x - returned(body, p)[i]), 0) > 0);
  console.log(axes, 'points', points.length, 'wrong', wrong.length, 'of them outside', outside.length);
  assert(points.length === 528 && wrong.every((p) => norm(axes, p) ** 2 < 0.63));
  return [wrong.length, outside.length];
}
assert.deepEqual(count([1, 2, 3]), [136, 29]);
assert.equal(count([1, 1, 0.5])[0], 96);
assert.equal(count([1, 1, 2])[0], 44);
assert.equal(count([6378137, 6378137, 6356752.3142])[0], 0);
END
node "$dir/check.mjs"
