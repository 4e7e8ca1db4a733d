#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A scene of splats that is stretched along y has its positions stretched along y, but each splat along its own second axis: one that is
# turned by 90 degrees becomes wider instead of higher.
#
# gsplat.js (npm gsplat 1.2.9), Splat.scale with applyScale, and SplatData.scale. One splat with the standard deviations 1, 0.2, 0.1, turned
# about z, and the factors (1, 3, 1). Standard deviations along the axes x and y of space, seen on 1 December 2026:
#
#   turned by   before         after           true
#   0°          1      0.2     1      0.6      1      0.6
#   45°         0.721  0.721   0.825  0.825    0.721  2.163
#   90°         0.2    1       0.6    1        0.2    3
#
# The quaternion is not changed, and the lengths are multiplied by the factors. True is S C S for the covariance C and S = diag(1, 3, 1); at
# 45°, its quaternion and its lengths (2.265, 0.265, 0.1) are others. Three equal factors are right, as are rotations.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" gsplat@1.2.9
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { Quaternion, Splat, SplatData, Vector3 } from 'gsplat';

const radian = Math.PI / 180, lengths = [1, 0.2, 0.1], factors = [1, 3, 1];
const near = (x, y) => assert(Math.abs(x - y) < 1e-3, `${x} instead of ${y}`);
const product = (a, b) => a.map((row) => b[0].map((_, j) => row.reduce((sum, x, k) => sum + x * b[k][j], 0)));
const transposed = (a) => a[0].map((_, j) => a.map((row) => row[j]));
const diagonal = (d) => d.map((x, i) => d.map((_, j) => (i === j ? x : 0)));

function rotation([w, x, y, z]) {
  return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]];
}
function covariance(data) {
  const root = product(rotation([...data.rotations]), diagonal([...data.scales]));
  return product(root, transposed(root));
}
const extents = (c) => [Math.sqrt(c[0][0]), Math.sqrt(c[1][1]), Math.sqrt(c[2][2])];
function made(degrees) {
  const quaternion = new Float32Array([Math.cos(degrees * radian / 2), 0, 0, Math.sin(degrees * radian / 2)]);
  return new SplatData(1, new Float32Array([1, 2, 3]), quaternion, new Float32Array(lengths), new Uint8Array(4).fill(255));
}

function check(degrees, before, after, truth) {
  const splat = new Splat(made(degrees)), start = extents(covariance(splat.data)), s = diagonal(factors);
  const expected = extents(product(product(s, covariance(splat.data)), s));
  splat.scale = new Vector3(...factors);
  splat.applyScale();
  const direct = made(degrees);
  direct.scale(new Vector3(...factors));
  assert.deepEqual([...direct.scales], [...splat.data.scales]);
  assert.deepEqual([...splat.data.positions], [1, 6, 3]);
  assert.deepEqual([...splat.data.rotations], [...made(degrees).rotations]);
  const found = extents(covariance(splat.data));
  console.log(`${degrees}°`, 'before', start, 'after', found, 'true', expected);
  for (let i = 0; i < 2; i++) {
    near(start[i], before[i]);
    near(found[i], after[i]);
    near(expected[i], truth[i]);
  }
}
check(0, [1, 0.2], [1, 0.6], [1, 0.6]);
check(45, [0.721, 0.721], [0.825, 0.825], [0.721, 2.163]);
check(90, [0.2, 1], [0.6, 1], [0.2, 3]);

// The lengths of the true splat at 45 degrees: roots of the eigenvalues of the block of x and y.
const [[xx, xy], [, yy]] = [[0.52, 3 * 0.48], [0, 9 * 0.52]], middle = (xx + yy) / 2, half = Math.hypot((xx - yy) / 2, xy);
near(Math.sqrt(middle + half), 2.265);
near(Math.sqrt(middle - half), 0.265);

// Equal factors, and rotations about another axis.
const even = made(45), turned = made(45), doubled = covariance(even), c = covariance(turned), q = [Math.cos(0.4), Math.sin(0.4), 0, 0];
even.scale(new Vector3(2, 2, 2));
turned.rotate(new Quaternion(q[1], q[2], q[3], q[0]));
const expected = product(product(rotation(q), c), transposed(rotation(q)));
covariance(even).forEach((row, i) => row.forEach((x, j) => near(x, 4 * doubled[i][j])));
covariance(turned).forEach((row, i) => row.forEach((x, j) => near(x, expected[i][j])));
END
node "$dir/check.mjs"
