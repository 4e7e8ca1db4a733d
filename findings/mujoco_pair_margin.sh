#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The margin of a pair was the larger of the two margins in MuJoCo 3.3.8, and is their sum in 3.9.0 and 3.14.0. The same model file
# has contacts in one version and none in the other.
#
# npm mujoco-js 0.0.7 (MuJoCo 3.3.8), @mujoco/mujoco 3.9.0 and 3.14.0. Two ellipsoids that are balls of radius 1, with margins
# 0.3 and 0.2, are in contact up to this gap (seen on 29 November 2026): 0.3 in 3.3.8, 0.5 in the other two.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" mujoco-js@0.0.7 mujoco39@npm:@mujoco/mujoco@3.9.0 \
  mujoco314@npm:@mujoco/mujoco@3.14.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';

const geom = (margin) => `<freejoint/><geom type="ellipsoid" size="1 1 1" margin="${margin}"/>`;
const model = (gap) => `<mujoco><worldbody><body>${geom(0.3)}</body><body pos="${2 + gap} 0 0">${geom(0.2)}</body></worldbody></mujoco>`;

async function largest_gap(name) {
  const M = await (await import(name)).default();
  const read = (text) => {
    if (M.MjModel.from_xml_string) return M.MjModel.from_xml_string(text);
    M.FS.writeFile('/model.xml', text);
    return M.MjModel.loadFromXML('/model.xml');
  };
  let inside = 0, outside = 2;
  for (let i = 0; i < 20; i++) {
    const gap = (inside + outside) / 2, made = read(model(gap)), data = new M.MjData(made);
    M.mj_forward(made, data);
    if (data.ncon > 0) inside = gap; else outside = gap;
    data.delete();
    made.delete();
  }
  console.log(name, inside);
  return inside;
}

for (const [name, expected] of [['mujoco-js', 0.3], ['mujoco39', 0.5], ['mujoco314', 0.5]])
  assert(Math.abs(await largest_gap(name) - expected) < 1e-3);
EOF
node "$dir/check.mjs"
