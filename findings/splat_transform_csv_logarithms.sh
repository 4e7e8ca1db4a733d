#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# In the tables of splats that splat-transform writes, the columns scale_0 to scale_2 are logarithms of lengths. Nothing in the file
# states this, and splat-transform does not read these tables.
#
# splat-transform (npm @playcanvas/splat-transform 3.7.0): standard deviations 1, 2 and 0.1 are scales 0, 0.693 and -2.303 in PLY.
# The CSV file has the same numbers, beside positions that are lengths: a reader that takes them as semi-axes has a zero and a negative one,
# and for a scene in small units (all lengths > 1) it has positive ones, all wrong, with no hint. The program refuses .csv as input, so
# that PLY must be made of what the table was made of.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @playcanvas/splat-transform@3.7.0
cd "$dir"
node - <<'EOF'
const names = ['x', 'y', 'z', 'f_dc_0', 'f_dc_1', 'f_dc_2', 'opacity', 'scale_0', 'scale_1', 'scale_2', 'rot_0', 'rot_1', 'rot_2', 'rot_3'];
const row = [5, 6, 7, 0, 0, 0, 1, Math.log(1), Math.log(2), Math.log(0.1), 1, 0, 0, 0];
const header = `ply\nformat binary_little_endian 1.0\nelement vertex 1\n${names.map(n => `property float ${n}\n`).join('')}end_header\n`;
require('fs').writeFileSync('one.ply', Buffer.concat([Buffer.from(header), Buffer.from(new Float32Array(row).buffer)]));
EOF
tool=node_modules/.bin/splat-transform
node "$tool" -q one.ply one.csv
cat one.csv
node - <<'EOF'
const assert = require('assert');
const [names, values] = require('fs').readFileSync('one.csv', 'utf8').trim().split('\n').map(line => line.split(','));
const value = name => Number(values[names.indexOf(name)]);
assert(value('x') === 5 && value('scale_0') === 0);
assert(Math.abs(value('scale_1') - Math.LN2) < 1e-6 && Math.abs(value('scale_2') + Math.log(10)) < 1e-6);
EOF
if node "$tool" -q one.csv back.ply 2>said; then
  echo "CSV is read now" && exit 1
fi
cat said
grep -qi 'csv' said
