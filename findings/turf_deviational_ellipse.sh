#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The "semi-major" axis of a standard deviational ellipse is the shorter one, a round cloud far from the equator has a long ellipse, and
# points in mirror symmetry about a meridian, as long along it as across or longer, are refused.
#
# Turf (npm @turf/standard-deviational-ellipse 7.4.0). The documentation promises an ellipse that "contains about one standard deviation's
# worth (~ 70%) of the data" and names no units of semiMajorAxis and semiMinorAxis. They are degrees, with the factor sqrt(2) of Yuill, for
# which 1 - 1/e = 63.2 % of a normal distribution are inside. Normal clouds of 4000 points on the ground, seen on 1 December 2026:
#
#   latitude   standard deviations, km       semiMajorAxis   semiMinorAxis   angle   true angle   points inside
#   0          5 and 15, turned by 30°       0.0635          0.1904          30.0    30           63 %
#   60°        5 and 15, turned by 30°       0.0927          0.2607          54.9    30           74 %
#   60°        5 and 5                       0.0635          0.1270          90      -            80 %
#   70°        5 and 15, turned by 30°       0.1015          0.3482          66.3    30           72 %
#
# 0.0635 degrees of latitude are 7.06 km, nearly 5 km sqrt(2) (the outermost part of the distribution has no point). Degrees of longitude
# count as much as those of latitude. The angle is that of the longer axis, from north to east. For the four points (0, 2), (0, -2),
# (1, 0), (-1, 0) the angle is the arctangent of 0/0, and the error "xSemiAxis is required" comes; (2, 0), (-2, 0), (0, 1), (0, -1) are
# taken. Far from the equator, project the points to a plane first.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @turf/standard-deviational-ellipse@7.4.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { standardDeviationalEllipse } from '@turf/standard-deviational-ellipse';

const radian = Math.PI / 180, radius = 6371.0088, middle = 10; // km; degrees of longitude
function ellipse(points) {
  const features = points.map((coordinates) => ({ type: 'Feature', properties: {}, geometry: { type: 'Point', coordinates } }));
  return standardDeviationalEllipse({ type: 'FeatureCollection', features }).properties.standardDeviationalEllipse;
}
// 100 rings of 40 points; each ring stands for a hundredth of a normal distribution. The axis of "along" points to the azimuth.
function cloud(latitude, across, along, azimuth) {
  const c = Math.cos(azimuth * radian), s = Math.sin(azimuth * radian), points = [];
  for (let ring = 0; ring < 100; ring++) {
    const r = Math.sqrt(-2 * Math.log(1 - (ring + 0.5) / 100));
    for (let i = 0; i < 40; i++) {
      const t = 2 * Math.PI * (i + 0.37 + 0.618 * ring) / 40, u = across * r * Math.cos(t), v = along * r * Math.sin(t);
      const east = c * u + s * v, north = c * v - s * u;
      points.push([middle + east / (radius * Math.cos(latitude * radian) * radian), latitude + north / (radius * radian)]);
    }
  }
  return points;
}
// East and north components, in km, of the great circle from the middle of the cloud to a point.
function onGround([longitude, latitude], from) {
  const a = from * radian, b = latitude * radian, l = (longitude - middle) * radian;
  const east = Math.cos(b) * Math.sin(l), north = Math.cos(a) * Math.sin(b) - Math.sin(a) * Math.cos(b) * Math.cos(l);
  const distance = 2 * radius * Math.asin(Math.sqrt(Math.sin((b - a) / 2) ** 2 + Math.cos(a) * Math.cos(b) * Math.sin(l / 2) ** 2));
  return [distance * east / Math.hypot(east, north), distance * north / Math.hypot(east, north)];
}
// The directions of the largest and the least sum of squares on the ground, by trial of all tenths of degrees.
function principal(points, latitude) {
  const ground = points.map((p) => onGround(p, latitude));
  const trials = Array.from({ length: 1800 }, (_, i) => {
    const s = Math.sin(i / 10 * radian), c = Math.cos(i / 10 * radian);
    return { azimuth: i / 10, axis: Math.sqrt(2 * ground.reduce((sum, [x, y]) => sum + (s * x + c * y) ** 2, 0) / points.length) };
  }).sort((p, q) => q.axis - p.axis);
  return { long: trials[0].axis, short: trials[1799].axis, azimuth: trials[0].azimuth };
}
const near = (x, y, tolerance) => assert(Math.abs(x - y) <= tolerance, `${x} instead of ${y}`);

function check([latitude, across, along, azimuth], [major, minor, angle, inside]) {
  const points = cloud(latitude, across, along, azimuth), found = ellipse(points), truth = principal(points, latitude);
  console.log(latitude, across, along, azimuth, found, 'true', truth);
  near(found.semiMajorAxis, major, 1e-4);
  near(found.semiMinorAxis, minor, 1e-4);
  near(Math.abs(found.angle), angle, 0.1);
  near(found.percentageWithinEllipse, inside, 1);
  near(truth.long / (along * Math.SQRT2), 1, 3e-3);
  near(truth.short / (across * Math.SQRT2), 1, 3e-3);
  if (across !== along) near(truth.azimuth, azimuth, 0.3);
}
check([0, 5, 15, 30], [0.0635, 0.1904, 30, 63]);
check([60, 5, 15, 30], [0.0927, 0.2607, 54.9, 74.2]);
check([60, 5, 5, 0], [0.0635, 0.1270, 90, 80.2]);
check([70, 5, 15, 30], [0.1015, 0.3482, 66.3, 72.4]);
assert.throws(() => ellipse([[0, 2], [0, -2], [1, 0], [-1, 0]]), /xSemiAxis is required/);
assert.throws(() => ellipse([[0, 1], [0, -1], [1, 0], [-1, 0]]), /xSemiAxis is required/);
const wide = ellipse([[2, 0], [-2, 0], [0, 1], [0, -1]]);
assert(wide.semiMajorAxis === 1 && wide.semiMinorAxis === 2);
END
node "$dir/check.mjs"
