#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# cannon-es computes the volume of a convex body as 4/3 pi times the radius of its bounding sphere, without the cube. The moments of
# inertia of a body are those of its bounding box in world axes at the moment when the shape was added.
#
# cannon-es (npm cannon-es 0.20.0). A bipyramid of semi-axes (1, 2, 3), whose volume is 4/3 * 1 * 2 * 3 = 8:
#
#   ConvexPolyhedron.volume()                      12.566 = 4 pi      (true: 8)
#   the same body, ten times as large              125.66 = 40 pi     (true: 8000)
#
# and, with the mass 1,
#
#   Body.inertia                                   4.333 3.333 1.667  (its box; the ellipsoid has 2.6 2 1, the bipyramid 1.3 1 0.5)
#   of a body turned by 45 degrees about z first   3.667 3.667 1.333  (the box of the turned body)
#
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" cannon-es@0.20.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import { Body, ConvexPolyhedron, Vec3 } from 'cannon-es';

function bipyramid(a, b, c) {
  const vertices = [[a, 0, 0], [-a, 0, 0], [0, b, 0], [0, -b, 0], [0, 0, c], [0, 0, -c]].map((p) => new Vec3(...p));
  const faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]; // from outside, anticlockwise
  return new ConvexPolyhedron({ vertices, faces });
}
function close(what, found, expected) {
  console.log(what, found);
  expected.forEach((x, i) => assert(Math.abs(found[i] - x) < 1e-4 * x, `${what}: ${found} is not ${expected}`));
}

close('volume', [bipyramid(1, 2, 3).volume(), bipyramid(10, 20, 30).volume()], [4 * Math.PI, 40 * Math.PI]);
close('inertia', new Body({ mass: 1, shape: bipyramid(1, 2, 3) }).inertia.toArray(), [13 / 3, 10 / 3, 5 / 3]);
const turned = new Body({ mass: 1 });
turned.quaternion.setFromAxisAngle(new Vec3(0, 0, 1), Math.PI / 4);
turned.addShape(bipyramid(1, 2, 3));
const side = 2 * Math.SQRT2; // of the box of the turned body along x and y
close('turned before', turned.inertia.toArray(), [(side ** 2 + 36) / 12, (side ** 2 + 36) / 12, (2 * side ** 2) / 12]);
EOF
node "$dir/check.mjs"
