#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The principal axes of a spheroid are neither perpendicular nor of the length 1, if its tensor was computed as R D R^T: this is symmetric to the
# last digit only.
#
# ml-matrix (npm ml-matrix 6.15.1), EigenvalueDecomposition. Its README takes eigenvectorMatrix without a word on lengths, angles or the
# option assumeSymmetric, and the vectors of exactly symmetric matrices, and of all those with three different eigenvalues here, are orthonormal.
# 1000 tensors of random orientation, seen on 1 December 2026: "oblique", two vectors with a cosine above 0.1; V D V^T is the tensor rebuilt.
#
#   eigenvalues   oblique   lengths          oblique with { assumeSymmetric: true }
#   1, 2, 3       0         1                0
#   1, 1, 3       403       1 to 5.1         0
#   1, 3, 3       566       1 to 3.2         0
#
# For 1, 1, 3, turned about x by the angle whose cosine is 4/5 and then about z by that of 5/13, some entries differ from their mirror images
# by 1e-16, the third vector is (0.999, 1.145, -0.361), and V D V^T is wrong by 1.14. Each vector fulfils A v = value v: two vectors of the same
# eigenvalue may have any angle. Pass { assumeSymmetric: true }.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" ml-matrix@6.15.1
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { EigenvalueDecomposition, Matrix } from 'ml-matrix';

let state = 1;
const random = () => (state = state * 16807 % 2147483647) / 2147483647;
function rotation() {
  let q;
  do q = Array.from({ length: 4 }, () => 2 * random() - 1); while (Math.hypot(...q) > 1 || Math.hypot(...q) < 0.1);
  const [w, x, y, z] = q.map((v) => v / Math.hypot(...q));
  return new Matrix([
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ]);
}
const tensor = (axes, values) => axes.mmul(Matrix.diag(values)).mmul(axes.transpose());
const difference = (a, b) => Matrix.sub(a, b).abs().max();

function principal(matrix, values, options) {
  const { realEigenvalues, imaginaryEigenvalues, eigenvectorMatrix } = new EigenvalueDecomposition(matrix, options);
  const found = Matrix.diag(realEigenvalues), lengths = [0, 1, 2].map((i) => Math.hypot(...eigenvectorMatrix.getColumn(i)));
  const unit = eigenvectorMatrix.mmul(Matrix.diag(lengths.map((l) => 1 / l)));
  assert(difference(matrix, matrix.transpose()) < 1e-15);
  assert(imaginaryEigenvalues.every((v) => v === 0));
  assert([...realEigenvalues].sort().every((v, i) => Math.abs(v - values[i]) < 1e-13));
  assert(difference(matrix.mmul(unit), unit.mmul(found)) < 1e-13);
  const cosine = difference(unit.transpose().mmul(unit), Matrix.eye(3)), rebuilt = eigenvectorMatrix.mmul(found).mmul(eigenvectorMatrix.transpose());
  return { cosine, lengths, vectors: eigenvectorMatrix.to2DArray(), error: difference(rebuilt, matrix) };
}
function check(values, least, most, options) {
  let oblique = 0, lengths = [], right = 0;
  for (let i = 0; i < 1000; i++) {
    const found = principal(tensor(rotation(), values), values, options);
    oblique += found.cosine > 0.1;
    lengths = lengths.concat(found.lengths);
    right += found.error < 1e-13;
  }
  console.log(values, options, 'oblique', oblique, 'lengths', Math.min(...lengths), Math.max(...lengths), 'rebuilt', right);
  assert(oblique >= least && oblique <= most);
  assert.equal(right === 1000, most === 0);
  assert.equal(Math.max(...lengths) > 2, most > 0);
}
check([1, 2, 3], 0, 0);
check([1, 1, 3], 370, 440);
check([1, 3, 3], 530, 600);
for (const values of [[1, 2, 3], [1, 1, 3], [1, 3, 3]]) check(values, 0, 0, { assumeSymmetric: true });

const c = 5 / 13, s = 12 / 13;
const turned = new Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]]).mmul(new Matrix([[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]]));
const example = principal(tensor(turned, [1, 1, 3]), [1, 1, 3]);
console.log(example);
assert(Math.abs(example.error - 1.143) < 1e-3);
assert(Math.abs(example.lengths[2] - Math.hypot(0.9986, 1.1449, 0.3611)) < 1e-3);
END
node "$dir/check.mjs"
