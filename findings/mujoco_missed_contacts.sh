#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Two ellipsoids that overlap by half have no contact and a positive distance, if one centre is exactly on the other surface; the same
# happens for ellipsoids of a few micrometres that overlap by a tenth of their size.
#
# MuJoCo (npm @mujoco/mujoco 3.14.0), two parallel geoms of type ellipsoid, size s (1, 2, 3), centres x s apart along the shortest axis
# (they touch at x = 2; the depth is (2 - x) s). Number of contacts and mj_geomDistance / s, seen on 29 November 2026:
#
#   s        x = 0.99         x = 1        x = 1.01         x = 1.9
#   1        1, -1.0099       0, +1        1, -0.9899       1, -0.0999872
#   1e-5                      0, +1                         0, +0.1
#
# The same holds for balls given as ellipsoids (1, 1, 1) at x = 1, and for equal centres. Of 2000 random places that overlap, none is missed at s = 1: it takes
# the exact place, such as a grid gives it. Depths are right to 1e-4 of the size. Sizes below 2e-5 are missed because a tolerance is a length.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @mujoco/mujoco@3.14.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import load from '@mujoco/mujoco';
const M = await load();

function contact(axes, s, x, y = 0) { // the density keeps the mass above MuJoCo's least mass
  const geom = `<freejoint/><geom type="ellipsoid" size="${axes.map((a) => a * s).join(' ')}" density="${1 / s ** 3}"/>`;
  const options = '<compiler boundmass="1e-3" boundinertia="1e-3"/>';
  const bodies = `<body>${geom}</body><body pos="${x * s} ${y * s} 0">${geom}</body>`;
  const model = M.MjModel.from_xml_string(`<mujoco>${options}<worldbody>${bodies}</worldbody></mujoco>`), data = new M.MjData(model);
  M.mj_forward(model, data);
  const result = [data.ncon, M.mj_geomDistance(model, data, 0, 1, 10 * s, null) / s];
  data.delete();
  model.delete();
  return result;
}

function expect(axes, s, x, contacts, distance) {
  const [n, d] = contact(axes, s, x);
  console.log(axes, s, x, n, d);
  assert(n === contacts && Math.abs(d - distance) < 2e-3, `expected ${contacts} ${distance}`);
}

expect([1, 2, 3], 1, 0.99, 1, -1.0099);
expect([1, 2, 3], 1, 1, 0, 1);
expect([1, 2, 3], 1, 1.01, 1, -0.9899);
expect([1, 1, 1], 1, 1, 0, 1);
expect([1, 2, 3], 1, 1.9, 1, -0.1);
expect([1, 2, 3], 1e-5, 1.9, 0, 0.1);
console.log('same centre', contact([1, 2, 3], 1, 0));
assert(contact([1, 2, 3], 1, 0)[0] === 0);
let missed = 0;
for (let i = 1; i <= 2000; i++) missed += contact([1, 2, 3], 1, (i * 0.6180339887) % 1.3, (i * 0.7548776662) % 1.3)[0] === 0;
console.log(missed, 'of 2000 places missed');
assert(missed === 0);
EOF
node "$dir/check.mjs"
