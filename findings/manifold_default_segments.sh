#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# An ellipsoid made as a scaled ball of radius 1 has 70 % of its volume; the same ellipsoid made from a larger ball has 99 %.
#
# Manifold (npm manifold-3d 3.5.4), Manifold.sphere(radius).scale(...). The number of segments, if not given, depends on the radius in
# absolute units: segments of at most 10 degrees and at least 1 unit of length. Later scaling changes no triangle. All vertices are on
# the surface, so the body is inscribed. Volume divided by that of the ellipsoid, seen on 29 November 2026:
#
#   sphere(0.02)      0.318  (6 vertices, an octahedron)
#   sphere(1)         0.703  (18 vertices), also after scale([100, 200, 300])
#   sphere(100)       0.982  (326 vertices), also after scale([1, 2, 3]), which is the same ellipsoid
#   sphere(1, 100)    0.998
#
# So give the segments. Segments that are no multiple of four are rounded up: 30 and 32 give the same body.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" manifold-3d@3.5.4
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import load from 'manifold-3d';
const M = await load();
M.setup();

function ratio(what, solid, a, b, c) {
  const value = solid.volume() / ((4 / 3) * Math.PI * a * b * c);
  console.log(what, solid.numVert(), value);
  return value;
}
const close = (x, y) => assert(Math.abs(x - y) < 1e-3, `${x} is not ${y}`);

close(ratio('sphere(0.02)', M.Manifold.sphere(0.02), 0.02, 0.02, 0.02), 0.3183);
close(ratio('sphere(1), scaled', M.Manifold.sphere(1).scale([100, 200, 300]), 100, 200, 300), 0.7025);
close(ratio('sphere(100), scaled', M.Manifold.sphere(100).scale([1, 2, 3]), 100, 200, 300), 0.9823);
close(ratio('sphere(1, 100)', M.Manifold.sphere(1, 100), 1, 1, 1), 0.9977);
assert(M.Manifold.sphere(1, 30).numVert() === M.Manifold.sphere(1, 32).numVert());
EOF
node "$dir/check.mjs"
