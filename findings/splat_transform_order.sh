#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A compressed PLY file stores the splats in another order, so row numbers and tables of labels no longer match. A single flat splat makes
# all lengths of its chunk inaccurate.
#
# splat-transform (npm @playcanvas/splat-transform 3.7.0), which sorts along a Morton curve only for .compressed.ply; .spz keeps the order.
# Lengths have 11, 10 and 11 bits of the range of logarithms within 256 splats, cut at -20. Of five splats whose lengths are between 0.05
# and 2.7, the logarithm of one is -20 along y: those along y then err by 1 %, half a step of 21.0 / 1023. Without that splat, 0.1 %.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" @playcanvas/splat-transform@3.7.0
cd "$dir"
cat >write.js <<'EOF'
const names = ['x', 'y', 'z', 'f_dc_0', 'f_dc_1', 'f_dc_2', 'opacity', 'scale_0', 'scale_1', 'scale_2', 'rot_0', 'rot_1', 'rot_2', 'rot_3'];
function write(file, flat) {
  const places = [[9, 9, 9], [-9, -9, -9], [8, -8, 8], [0, 0, 0], [-8, 8, -8]];
  const lengths = [-2.9, -1.1, 0.3, 1, flat];
  const rows = places.map((at, k) => [...at, 0, 0, 0, 1, -1, lengths[k], -1, 1, 0, 0, 0]);
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex 5\n${names.map(n => `property float ${n}\n`).join('')}end_header\n`;
  require('fs').writeFileSync(file, Buffer.concat([Buffer.from(header), Buffer.from(new Float32Array(rows.flat()).buffer)]));
}
write('flat.ply', -20);
write('plain.ply', -1);
EOF
cat >read.js <<'EOF'
const assert = require('assert');
function rows(file) {
  const bytes = require('fs').readFileSync(file), end = bytes.indexOf('end_header\n') + 11;
  const names = [...bytes.subarray(0, end).toString().matchAll(/property float (\w+)/g)].map(found => found[1]);
  const values = new Float32Array(bytes.buffer.slice(bytes.byteOffset + end, bytes.byteOffset + bytes.length));
  return Array.from({ length: values.length / names.length }, (_, k) =>
    Object.fromEntries(names.map((name, i) => [name, values[k * names.length + i]])));
}
const near = (row, list) => list.findIndex(one => Math.hypot(one.x - row.x, one.y - row.y, one.z - row.z) < 0.1);
const error = (before, after) => Math.max(...before.filter(one => one.scale_1 > -10).map(one =>
  Math.abs(after[near(one, after)].scale_1 - one.scale_1)));
const flat = rows('flat.ply'), plain = rows('plain.ply');
const order = rows('flat.back.ply').map(row => near(row, flat)), kept = rows('flat.spz.ply').map(row => near(row, flat));
const errors = [error(flat, rows('flat.back.ply')), error(plain, rows('plain.back.ply'))];
console.log('order', order, 'of .spz', kept, 'errors of logarithms', errors);
assert.notDeepStrictEqual(order, [0, 1, 2, 3, 4]);
assert.deepStrictEqual([...order].sort(), [0, 1, 2, 3, 4]);
assert.deepStrictEqual(kept, [0, 1, 2, 3, 4]);
assert(errors[0] > 0.004 && errors[0] < 21.01 / 2046 && errors[1] < 4 / 2046);
EOF
node write.js
tool=node_modules/.bin/splat-transform
for name in flat plain; do
  node "$tool" -q $name.ply $name.compressed.ply
  node "$tool" -q $name.compressed.ply $name.back.ply
done
node "$tool" -q --spz-version 3 flat.ply flat.spz
node "$tool" -q flat.spz flat.spz.ply
node read.js
