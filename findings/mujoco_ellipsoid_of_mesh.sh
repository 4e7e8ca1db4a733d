#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# An ellipsoid that is fitted to a mesh of that very ellipsoid comes out too small by sqrt(3/5), and the moments of an ellipsoidal
# shell are up to 19 % low.
#
# MuJoCo (npm @mujoco/mujoco 3.14.0), seen on 29 November 2026.
#
# A mesh of 2000 points on the ellipsoid (1, 2, 3), density 1, as a geom of type mesh weighs 25.06 (the ellipsoid: 25.13). The same mesh
# as a geom of type ellipsoid has the size (0.774, 1.548, 2.321) and weighs 11.65. The semi-axes are the half-sides of the box with the
# same moments, sqrt(3) times the standard deviation; those of an ellipsoid are sqrt(5) times as large as that. With
# <compiler fitaabb="true"/> the size is (0.9996, 1.9985, 2.9985), as long as the axes of the mesh are parallel to those of its frame.
#
# With shellinertia="true" (a sheet of uniform thickness), moment / mass of an ellipsoid of semi-axes
#
#   (1, 1, 1)          0.6667 about each axis   true: 2/3
#   (1, 1, 0.01)       0.4078 about z           true: 0.5002 (a disc: 1/2)
#   (0.01, 0.01, 1)    0.2020 about x           true: 0.2500 (a needle whose width is that of an ellipsoid: 1/4)
#
# The true moments are integrals over the surface that this script computes.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @mujoco/mujoco@3.14.0
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import load from '@mujoco/mujoco';
const M = await load();

function check(what, found, expected, tolerance) {
  console.log(what, Array.from(found));
  expected.forEach((x, i) => assert(Math.abs(found[i] - x) < tolerance * Math.abs(x), `${what}: ${found} is not ${expected}`));
}

function vertices(a, b, c, n) { // a Fibonacci lattice
  const list = [];
  for (let i = 0; i < n; i++) {
    const z = 1 - (2 * i + 1) / n, r = Math.sqrt(1 - z * z), angle = Math.PI * (3 - Math.sqrt(5)) * i;
    list.push([a * r * Math.cos(angle), b * r * Math.sin(angle), c * z].map((x) => x.toPrecision(9)).join(' '));
  }
  return list.join('  ');
}

function fitted(options) {
  const asset = `<asset><mesh name="m" vertex="${vertices(1, 2, 3, 2000)}"/></asset>`;
  const body = (type) => `<body><freejoint/><geom type="${type}" mesh="m" density="1"/></body>`;
  return M.MjModel.from_xml_string(`<mujoco>${options}${asset}<worldbody>${body('mesh')}${body('ellipsoid')}</worldbody></mujoco>`);
}

const made = fitted(''), k = Math.sqrt(3 / 5);
check('mass of the mesh, of the ellipsoid', made.body_mass.slice(1), [8 * Math.PI, 8 * Math.PI * k ** 3], 5e-3);
check('size', Array.from(made.geom_size.slice(3, 6)).sort(), [k, 2 * k, 3 * k], 2e-3);
check('size with fitaabb', Array.from(fitted('<compiler fitaabb="true"/>').geom_size.slice(3, 6)).sort(), [1, 2, 3], 1e-2);

// Area and moments of a thin sheet on the spheroid (a, a, c): the surface is r = a sin(t), z = c cos(t).
function sheet(a, c) {
  let area = 0, xx = 0, zz = 0;
  const n = 200000;
  for (let i = 0; i < n; i++) {
    const t = (Math.PI * (i + 0.5)) / n, r = a * Math.sin(t), z = c * Math.cos(t);
    const strip = 2 * Math.PI * r * Math.hypot(a * Math.cos(t), c * Math.sin(t)) * (Math.PI / n);
    area += strip;
    xx += strip * (r * r / 2 + z * z);
    zz += strip * r * r;
  }
  return { x: xx / area, z: zz / area };
}

function shell(a, c, axis) {
  const geom = `<geom type="ellipsoid" size="${a} ${a} ${c}" density="1" shellinertia="true"/>`;
  const model = M.MjModel.from_xml_string(`<mujoco><worldbody><body><freejoint/>${geom}</body></worldbody></mujoco>`);
  // body_inertia is sorted, the largest moment first
  const moments = Array.from(model.body_inertia.slice(3, 6)).sort((x, y) => x - y).map((x) => x / model.body_mass[1]);
  return [moments[2], sheet(a, c)[axis]];
}

check('shell (1, 1, 1): moment, true', shell(1, 1, 'z'), [2 / 3, 2 / 3], 1e-4);
check('shell (1, 1, 0.01): moment, true', shell(1, 0.01, 'z'), [0.4078, 0.5002], 1e-3);
check('shell (0.01, 0.01, 1): moment, true', shell(0.01, 1, 'x'), [0.2020, 0.2500], 1e-3);
EOF
node "$dir/check.mjs"
