#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The convex hull of points on a flat ellipsoid collides as it should, but weighs a fraction of its volume, and less the more points
# it has.
#
# Rapier (npm @dimforge/rapier3d-compat 0.21.0), ColliderDesc.convexHull with n points on the ellipsoid of semi-axes (1, 1, c), density 1.
# Mass divided by that of the ellipsoid, seen on 29 November 2026:
#
#   c        n = 200   n = 2000
#   1        0.970     0.997      (what an inscribed hull has)
#   0.1      0.926     0.579
#   0.01     0.282     0.158
#   0.001    0.052     0.008
#
# All points remain vertices of the hull, and a ray along z stops at 0.99 c. A needle (1, 0.01, 0.01) has 0.970 and 0.991.
# So set the mass and moments by hand (setMassProperties), not the density.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @dimforge/rapier3d-compat@0.21.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import R from '@dimforge/rapier3d-compat';
await R.init();

function points(a, b, c, n) { // a Fibonacci lattice
  const list = [];
  for (let i = 0; i < n; i++) {
    const z = 1 - (2 * i + 1) / n, r = Math.sqrt(1 - z * z), angle = Math.PI * (3 - Math.sqrt(5)) * i;
    list.push(a * r * Math.cos(angle), b * r * Math.sin(angle), c * z);
  }
  return new Float32Array(list);
}

function body(a, b, c, n) {
  const world = new R.World({ x: 0, y: 0, z: 0 });
  const collider = world.createCollider(R.ColliderDesc.convexHull(points(a, b, c, n)).setDensity(1));
  world.step();
  const hit = world.castRay(new R.Ray({ x: 0.013 * a, y: 0.017 * b, z: 3 }, { x: 0, y: 0, z: -1 }), 10, true);
  const ratio = collider.mass() / ((4 / 3) * Math.PI * a * b * c);
  const result = { ratio, vertices: collider.shape.vertices.length / 3, reach: (3 - hit.timeOfImpact) / c };
  console.log(a, b, c, n, result);
  return result;
}

const ball = body(1, 1, 1, 200), disc = body(1, 1, 0.01, 200), finer = body(1, 1, 0.01, 2000), needle = body(1, 0.01, 0.01, 200);
assert(Math.abs(ball.ratio - 0.970) < 0.002 && Math.abs(needle.ratio - 0.970) < 0.002);
assert(disc.vertices === 200 && Math.abs(disc.reach - 0.99) < 0.005); // the hull itself is complete
assert(Math.abs(disc.ratio - 0.2815) < 0.01, `the flat hull weighs ${disc.ratio}`);
assert(finer.ratio < 0.2, `the finer flat hull weighs ${finer.ratio}`);
EOF
node "$dir/check.mjs"
