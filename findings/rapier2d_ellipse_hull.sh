#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The convex hull of points on an ellipse is cut flat at its broad sides, and the finer the points, the flatter.
#
# Rapier in the plane (npm @dimforge/rapier2d-compat 0.21.0), ColliderDesc.convexHull with n points at equal steps of the parameter, on an
# ellipse of semi-axes (a, b). Extent along y divided by b, and mass divided by the density and by pi a b, seen on 30 November 2026:
#
#   a, b       n = 20           n = 50           n = 200
#   1, 1       1.000   0.984    0.998   0.997    1.000   1.000
#   3, 1       1.000   0.984    0.998   0.997    0.562   0.676
#   1, 0.1     1.000   0.984    0.685   0.796    0.309   0.387
#
# The hull lacks points that are nearly on a line with their neighbours: of the 200 points on (3, 1), 78 are left, and the top is a chord.
# Extents along x are right. A ray stops at the chord, so the body itself is cut, where the hull in space (rapier_flat_hull_mass.sh) only
# loses mass. ColliderDesc.convexPolyline, for points that are in order, loses the same ones. With 20 points all are kept.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @dimforge/rapier2d-compat@0.21.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import R from '@dimforge/rapier2d-compat';
await R.init();

function points(a, b, n) {
  const angles = Array.from({ length: n }, (_, i) => 2 * Math.PI * i / n);
  return new Float32Array(angles.flatMap((t) => [a * Math.cos(t), b * Math.sin(t)]));
}

function body(make, a, b, n) {
  const world = new R.World({ x: 0, y: 0 });
  const collider = world.createCollider(make(points(a, b, n)).setDensity(1));
  world.step();
  const hit = world.castRay(new R.Ray({ x: 0, y: 2 * b }, { x: 0, y: -1 }), 10, true);
  const vertices = collider.vertices(), height = Math.max(...vertices.filter((_, i) => i % 2)) / b;
  const width = Math.max(...vertices.filter((_, i) => i % 2 === 0)) / a;
  const ray = (2 * b - hit.timeOfImpact) / b, mass = collider.mass() / (Math.PI * a * b);
  const found = { width, height, ray, mass, left: vertices.length / 2 };
  console.log(make.name, a, b, n, found);
  return found;
}

const near = (x, y, tolerance) => assert(Math.abs(x - y) < tolerance, `${x} instead of ${y}`);
const { convexHull, convexPolyline } = R.ColliderDesc;
const disc = body(convexHull, 1, 1, 200), coarse = body(convexHull, 3, 1, 20), fine = body(convexHull, 3, 1, 200);
const flat = [20, 50, 200].map((n) => body(convexHull, 1, 0.1, n)), polyline = body(convexPolyline, 3, 1, 200);
near(disc.height, 1, 1e-3);
near(coarse.height, 1, 1e-3);
near(fine.height, 0.562, 0.01);
near(fine.ray, fine.height, 1e-3);
near(fine.mass, 0.676, 0.01);
near(fine.width, 1, 1e-3);
flat.forEach(({ height }, i) => near(height, [1, 0.685, 0.309][i], 0.01));
near(polyline.height, fine.height, 1e-3);
END
node "$dir/check.mjs"
