#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Displacement ellipsoids that are labelled 50 % contain 53 % of the density. If two principal values are equal, the axes are NaN or
# parallel.
#
# Mol* (npm molstar 5.11.0), lib/mol-repr/structure/visual/ellipsoid-mesh.js: "show 50% probability surface", semi-axes 1.5958 times the
# roots of the eigenvalues of U. 1.5958 = sqrt(8/pi) is the mean distance of a normal distribution; half of it is within 1.5382.
# Semi-axes are 3.7 % longer, volumes 12 % larger than those of ORTEP.
# Mat3.eigenvector, which gives two of the three axes, seen on 29 November 2026:
#
#   U = diag(1, 1, 4)       NaN for the eigenvalue 1, (0, 0, 1) for 4
#   U = diag(2, 1, 1) turned by 45 degrees about z: the two eigenvalues are 1, and both vectors are along z, +z and -z
#
# Mat3.symmetricEigenvalues sorts the values in descending order, unless the matrix is diagonal: then they stay in place.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
npm pack --silent molstar@5.11.0 >name
tar -xzf "$(cat name)" package/package.json package/lib/mol-math package/lib/mol-util package/lib/mol-repr/structure/visual
grep "50% probability" package/lib/mol-repr/structure/visual/ellipsoid-mesh.js
cat >package/check.mjs <<'EOF'
import assert from 'node:assert';
import { readFileSync } from 'node:fs';
import { Mat3 } from './lib/mol-math/linear-algebra/3d/mat3.js';

const source = readFileSync(new URL('lib/mol-repr/structure/visual/ellipsoid-mesh.js', import.meta.url), 'utf8');
const factor = Number(/sizeFactor \* ([0-9.]+) \* Math\.sqrt/.exec(source)[1]);

function inside(r) { // the part of a normal distribution in space within r standard deviations
  let sum = 0;
  const n = 100000, h = r / n;
  for (let i = 0; i < n; i++) sum += ((i + 0.5) * h) ** 2 * Math.exp(-(((i + 0.5) * h) ** 2) / 2) * h;
  return Math.sqrt(2 / Math.PI) * sum;
}
console.log(factor, inside(factor), inside(1.5382));
assert(Math.abs(factor - Math.sqrt(8 / Math.PI)) < 1e-4 && Math.abs(inside(factor) - 0.5331) < 1e-3 && Math.abs(inside(1.5382) - 0.5) < 1e-4);

function axes(...u) {
  const matrix = Mat3.fromArray(Mat3(), u, 0), values = Mat3.symmetricEigenvalues([0, 0, 0], matrix);
  const vectors = values.map((value) => Array.from(Mat3.eigenvector([0, 0, 0], matrix, value)));
  console.log(u, values, vectors);
  return { values, vectors };
}
const uniaxial = axes(1, 0, 0, 0, 1, 0, 0, 0, 4), turned = axes(1.5, 0.5, 0, 0.5, 1.5, 0, 0, 0, 1), general = axes(1, 0.1, 0, 0.1, 2, 0, 0, 0, 4);
assert(uniaxial.vectors[0].every(Number.isNaN) && uniaxial.vectors[1].every(Number.isNaN) && uniaxial.vectors[2][2] === 1);
assert(Math.abs(turned.vectors[1][2]) > 0.999 && Math.abs(turned.vectors[2][2]) > 0.999);
assert(uniaxial.values[0] < uniaxial.values[2] && general.values[0] > general.values[2]);
EOF
node package/check.mjs
