#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The convex hull of an ellipsoid loses most of its volume if lengths are in metres and the body is a grain of millimetres, without an
# error. A smaller tolerance does not help: the hull then fails.
#
# Jolt (npm jolt-physics 1.1.0), a hull of 400 points on the ellipsoid with semi-axes (1, 2, 3) units. Its volume in cubic units, and
# where its bounding box ends along x, for a unit of
#
#   10 m, 1 m, 0.1 m       24.395     0.998   (the ellipsoid: 25.133, 1)
#   1 cm                   22.581     0.990
#   3 mm                   17.622     0.968
#   1 mm                    4.004     0.296
#   0.1 mm                 an error: no suitable initial triangle
#
# With mHullTolerance = 1e-6 m, a thousandth of the unit, a unit of 1 mm ends in "Hull building failed, point 159 had an error of 0.00191";
# the same tolerance gives 24.395 for a unit of 1 m.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" jolt-physics@1.1.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import initJolt from 'jolt-physics/wasm-compat';

const J = await initJolt(), count = 400, goldenAngle = Math.PI * (3 - Math.sqrt(5));

// The volume of the hull and the end of its box along x, in units; or what the error says
function hull(unit, tolerance) {
  const settings = new J.ConvexHullShapeSettings();
  for (let i = 0; i < count; i++) {
    const z = 1 - (2 * i + 1) / count, r = Math.sqrt(1 - z * z), angle = i * goldenAngle;
    settings.mPoints.push_back(new J.Vec3(unit * r * Math.cos(angle), 2 * unit * r * Math.sin(angle), 3 * unit * z));
  }
  if (tolerance) settings.mHullTolerance = tolerance;
  const made = settings.Create();
  if (made.HasError()) return made.GetError().c_str();
  return [made.Get().GetVolume() / unit ** 3, made.Get().GetLocalBounds().mMax.GetX() / unit];
}
function check(unit, tolerance, expected) {
  const found = hull(unit, tolerance);
  console.log(`a unit of ${unit} m${tolerance ? `, tolerance ${tolerance} m` : ''}:`, found);
  if (typeof expected === 'string') assert(found.startsWith(expected));
  else expected.forEach((x, i) => assert(Math.abs(found[i] - x) < 1e-3 * x, `${found} is not ${expected}`));
}

for (const unit of [10, 1, 0.1]) check(unit, 0, [24.395, 0.9975]);
check(0.01, 0, [22.581, 0.9898]);
check(0.003, 0, [17.622, 0.9681]);
check(0.001, 0, [4.0038, 0.29573]);
check(0.0001, 0, 'Could not find a suitable initial triangle');
check(0.001, 1e-6, 'Hull building failed, point 159 had an error of 0.00191');
check(1, 1e-6, [24.395, 0.9975]);
EOF
node "$dir/check.mjs"
