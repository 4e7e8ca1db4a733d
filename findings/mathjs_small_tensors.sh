#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The principal moments and axes of a grain of a tenth of a millimetre are wrong if its tensor of inertia is in SI units: the diagonal
# comes back as eigenvalues, with the axes of the coordinates. A smaller "precision" makes a ball of it.
#
# mathjs (npm mathjs 15.2.0), eigs of a real symmetric matrix, an iteration that stops when all other entries are below "precision". Its
# documentation says that U, made of the eigenvectors, "diagonalizes H if possible", and that "precision" is relTol by default, which is
# 1e-12 and described as "minimum relative difference between two compared values". But both are compared with the entries themselves.
# Grains of quartz, 2650 kg/m³, ellipsoids with the semi-axes s, 2 s, 3 s, turned about x by the angle whose cosine is 4/5 and then about z
# by 30 degrees. Eigenvalues divided by m s², and the angle between the last eigenvector and the true axis, seen on 30 November 2026:
#
#   s          m s² / (kg m²)    eigs(I)                       eigs(I, { precision: 1e-18 })
#   1 m        6.7e4             1.000 2.000 2.600    0.0°     1.000 2.000 2.600    0.0°
#   1 mm       6.7e-11           1.000 2.000 2.600    0.2°     1.000 2.000 2.600    0.0°
#   0.5 mm     2.1e-12           1.005 2.061 2.534   19.1°     1.001 2.298 2.301
#   0.3 mm     1.6e-13           1.360 1.880 2.360   30.0°     1.867 1.867 1.867
#   0.1 mm     6.7e-16           1.360 1.880 2.360   30.0°     1.864 1.866 1.870
#   true                         1     2     2.6               1     2     2.6
#
# No message. Forms and covariances of micrometres in metres are such matrices, too. Divide the matrix by its largest entry first, and
# multiply the eigenvalues by it.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" mathjs@15.2.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { eigs } from 'mathjs';

// Columns are the axes of the grain in space, in the order of the moments.
const c = Math.sqrt(3) / 2, s = 0.5;
const axes = [[c, -0.8 * s, 0.6 * s], [s, 0.8 * c, -0.6 * c], [0, 0.6, 0.8]], moments = [2.6, 2, 1];

const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const entry = (a, b) => dot(a.map((x, k) => x * b[k]), moments);
const tensor = axes.map((a, i) => axes.map((b, j) => (i < j ? entry(a, b) : entry(b, a)))); // exactly symmetric

// Eigenvalues and the angle of the last eigenvector; "residual": the longest I v - value v, without any knowledge of the axes.
function principal(unit, options) {
  const matrix = tensor.map((row) => row.map((x) => x * unit)), { values, eigenvectors } = eigs(matrix, options);
  const angle = Math.acos(Math.min(1, Math.abs(dot(eigenvectors[2].vector, axes.map((row) => row[0]))))) * 180 / Math.PI;
  const residual = Math.max(...eigenvectors.map(({ value, vector }) => Math.hypot(...matrix.map((row, i) => dot(row, vector) - value * vector[i]))));
  return { values: values.map((v) => v / unit), angle, residual: residual / unit };
}
function check(size, options, values, angle, right) {
  const unit = 2650 * 8 * Math.PI * size ** 5, found = principal(unit, options); // mass times size squared
  console.log(size, unit.toExponential(1), options, found.values.map((v) => v.toFixed(3)).join(' '), found.angle.toFixed(1), found.residual.toExponential(1));
  values.forEach((v, k) => assert(Math.abs(found.values[k] - v) < 1e-3));
  assert(angle === null || Math.abs(found.angle - angle) < 0.1);
  assert.equal(found.residual < 3e-3, right);
}
const wrong = tensor.map((row, i) => row[i]).sort();
check(1, {}, [1, 2, 2.6], 0, true);
check(1e-3, {}, [1, 2, 2.6], 0.2, true);
check(5e-4, {}, [1.005, 2.061, 2.534], 19.1, false);
check(3e-4, {}, wrong, 30, false);
check(1e-4, {}, wrong, 30, false);
const smaller = { precision: 1e-18 };
check(1e-3, smaller, [1, 2, 2.6], 0, true);
check(5e-4, smaller, [1.001, 2.298, 2.301], null, false);
check(3e-4, smaller, [1.867, 1.867, 1.867], null, false);
check(1e-4, smaller, [1.864, 1.866, 1.870], null, false);
END
node "$dir/check.mjs"
