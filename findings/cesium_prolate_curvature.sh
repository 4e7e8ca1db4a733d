#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The curvature of an ellipsoid along its meridians is too large by the sixth power of the ratio of the axes if the ellipsoid is longer
# than wide: 729 times for the semi-axes 1, 1, 3. For flat ellipsoids, as the Earth, it is right.
#
# Cesium (npm @cesium/engine 24.0.0), Ellipsoid.getLocalCurvature. Its documentation says: "Computes the ellipsoid curvatures at a given
# position on the surface", and "local curvature of the ellipsoid surface at the provided position, in east and north directions". At points
# whose normal is 0.6 above the equator, seen on 30 November 2026:
#
#   semi-axes         east      north, returned    north, true
#   1,   1,   0.5     0.8723      2.6548            2.6548
#   1,   1,   1.1     1.0329      1.6136            0.9108
#   1,   1,   2       1.3987     43.7852            0.6841
#   1,   1,   3       1.8843    541.9160            0.7434
#
# True is N^3 c² / a^4 for the radius, with N = 1 / east; the same comes out of the circle through three points of the meridian that are
# near each other. The function takes the larger of a and c for a, and the smaller one for c, and then has c/a for a/c. Other methods of the
# class are right for them (scaleToGeodeticSurface, geodeticSurfaceNormal, the whole surfaceArea), as is the curvature to the east.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @cesium/engine@24.0.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { Cartesian3, Ellipsoid, Rectangle } from '@cesium/engine';

const latitude = 0.6;
// The curvature of the circle through three points of the meridian (a, c) whose normals are near the latitude.
function through_points(a, c) {
  const at = (angle) => {
    const n = Math.hypot(a * Math.cos(angle), c * Math.sin(angle));
    return [a * a * Math.cos(angle) / n, c * c * Math.sin(angle) / n];
  };
  const [p, q, r] = [latitude - 1e-4, latitude, latitude + 1e-4].map(at), length = (u, v) => Math.hypot(u[0] - v[0], u[1] - v[1]);
  const area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return Math.abs(2 * area / (length(p, q) * length(q, r) * length(p, r)));
}
// The surface of a spheroid that is longer than wide.
function surface(a, c) {
  const e = Math.sqrt(1 - a * a / (c * c));
  return 2 * Math.PI * a * (a + c * Math.asin(e) / e);
}
for (const [a, c] of [[1, 0.5], [1, 1.1], [1, 2], [1, 3]]) {
  const body = new Ellipsoid(a, a, c), place = Cartesian3.fromRadians(0.3, latitude, 0, body);
  const { x: east, y: north } = body.getLocalCurvature(place);
  const radius = a * a / Math.hypot(a * Math.cos(latitude), c * Math.sin(latitude)), meridian = a ** 4 / (radius ** 3 * c * c);
  console.log(a, a, c, 'east', east.toFixed(4), 'north', north.toFixed(4), 'true', meridian.toFixed(4), through_points(a, c).toFixed(4));
  assert(Math.abs((place.x ** 2 + place.y ** 2) / (a * a) + place.z ** 2 / (c * c) - 1) < 1e-12);
  assert(Math.abs(east * radius - 1) < 1e-9);
  assert(Math.abs(through_points(a, c) / meridian - 1) < 1e-5);
  assert(Math.abs(north / meridian / Math.max(1, c / a) ** 6 - 1) < 1e-9);
  const around = body.surfaceArea(new Rectangle(-Math.PI, -Math.PI / 2, Math.PI, Math.PI / 2));
  assert(c < a || Math.abs(around / surface(a, c) - 1) < 1e-4);
  const outside = Cartesian3.add(place, body.geodeticSurfaceNormal(place), new Cartesian3());
  assert(Cartesian3.distance(body.scaleToGeodeticSurface(outside), place) < 1e-9);
}
END
node "$dir/check.mjs"
