#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The normal of a contact between ellipsoids of a few centimetres can point the wrong way, so that the contact pulls the bodies together.
# This happens if the depth is small, even if it is several hundred times the tolerance of 1e-6.
#
# MuJoCo (npm @mujoco/mujoco 3.14.0), two parallel geoms of type ellipsoid at rest without gravity, default options. The cosine is that
# between the normal of the contact (its frame points from the first geom to the second) and the common normal of the surfaces; the speed
# is that at which the centres move apart after one step. Seen on 30 November 2026:
#
#   semi-axes        centre of the second     depth        true depth   cosine    speed
#   10, 20, 30 cm    (-10.9, -29.5, 23.8)     0.256 mm     0.257 mm     -1.000    -0.86 mm/s
#   1, 2, 3 cm       (1.45, 1.03, -3.82)      0.035 mm     0.036 mm     -1.000    -0.094 mm/s
#   1, 2, 3 mm       (1.06, -1.54, 4.53)      0.0008 mm    0.0014 mm    -1.000    -0.0022 mm/s
#
# Of 1500 directions, each with an overlap of a thousandth of the distance of the centres, the normal is reversed in 23 for semi-axes of
# 1, 2, 3 mm, in 1 for 1, 2, 3 cm, and in none for 1, 2, 3 m. mujoco_missed_contacts.sh has contacts that are not found at all.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @mujoco/mujoco@3.14.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import load from '@mujoco/mujoco';
const M = await load();
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

// Lengths are in units of s metres; the cosine is that between the contact's normal and the true one
function contact(s, center) {
  const geom = `<freejoint/><geom type="ellipsoid" size="${[1, 2, 3].map((a) => a * s).join(' ')}"/>`;
  const bodies = `<body>${geom}</body><body pos="${center.map((x) => x * s).join(' ')}">${geom}</body>`;
  const model = M.MjModel.from_xml_string(`<mujoco><option gravity="0 0 0"/><worldbody>${bodies}</worldbody></mujoco>`);
  const data = new M.MjData(model), n = center.map((x, i) => x / (i + 1) ** 2);
  M.mj_forward(model, data);
  assert(data.ncon === 1);
  const found = data.contact.get(0), depth = -found.dist / s;
  const cosine = dot(Array.from(found.frame).slice(0, 3), n) / Math.hypot(...n);
  M.mj_step(model, data);
  const v = Array.from(data.qvel), speed = dot(center.map((_, i) => v[6 + i] - v[i]), center) / Math.hypot(...center);
  data.delete();
  model.delete();
  return { depth, cosine, speed };
}
// Equal parallel ellipsoids touch where |S⁻¹ center| = 2. The depth to first order in the overlap
function trueDepth(center) {
  const mu = Math.hypot(center[0], center[1] / 2, center[2] / 3);
  return (2 - mu) * mu / Math.hypot(...center.map((x, i) => x / (i + 1) ** 2));
}

for (const [s, center] of [[0.1, [-1.09, -2.95, 2.38]], [0.01, [1.45, 1.03, -3.82]], [0.001, [1.06, -1.54, 4.53]]]) {
  const { depth, cosine, speed } = contact(s, center);
  console.log(s, center, { depth, trueDepth: trueDepth(center), cosine, speed });
  assert(cosine < -0.99 && speed < 0);
}
function reversed(s) {
  let count = 0;
  for (let i = 0; i < 1500; i++) {
    const z = 1 - (2 * i + 1) / 1500, r = Math.sqrt(1 - z * z), angle = i * Math.PI * (3 - Math.sqrt(5));
    const u = [r * Math.cos(angle), r * Math.sin(angle), z], c = u.map((x, k) => 1.998 * (k + 1) * x);
    count += contact(s, c).cosine < 0;
  }
  console.log(`semi-axes of 1, 2, 3 times ${s} m: ${count} of 1500 reversed`);
  return count;
}
for (const [s, expected] of [[1, 0], [0.01, 1], [0.001, 23]]) assert(reversed(s) === expected);
EOF
node "$dir/check.mjs"
