#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A geom that is a flat ellipsoid may be refused for its size: "inertia must satisfy A + B >= C; use 'balanceinertia' to fix".
#
# MuJoCo (npm @mujoco/mujoco 3.14.0), seen on 29 November 2026.
#
# The moments of an ellipsoid (a, b, c) are in proportion to b^2 + c^2, a^2 + c^2 and a^2 + b^2, so that the sum of two is never below the
# third. For flat ones it is equal to rounding, and MuJoCo compares its rounded moments without a tolerance. Of free bodies with one geom
# each of type ellipsoid, for all a < b from 0.1 to 3 in steps of 0.1, it refuses with c = 1e-8: 70 of 435; with c = 0.01: none.
# <compiler balanceinertia="true"/> lets all through.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @mujoco/mujoco@3.14.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import load from '@mujoco/mujoco';
const M = await load();
function refused(c, options = '') {
  let count = 0, all = 0;
  for (let i = 1; i <= 30; i++)
    for (let j = i + 1; j <= 30; j++, all++) {
      const geom = `<geom type="ellipsoid" size="${i / 10} ${j / 10} ${c}"/>`;
      try {
        M.MjModel.from_xml_string(`<mujoco>${options}<worldbody><body><freejoint/>${geom}</body></worldbody></mujoco>`).delete();
      } catch (error) {
        assert(String(error).includes('A + B >= C'), String(error));
        count++;
      }
    }
  console.log(`c = ${c}: ${count} of ${all} are refused ${options}`);
  return count;
}
assert.equal(refused(1e-8), 70);
assert.equal(refused(0.01), 0);
assert.equal(refused(1e-8, '<compiler balanceinertia="true"/>'), 0);
EOF
cd "$dir"
node check.mjs
