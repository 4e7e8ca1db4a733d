#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The lengths of the axes of a region's ellipse depend on its orientation, and those of a disc differ by a factor of 2.
#
# image-js (npm image-js 1.7.0), roi.ellipse, lengths of majorAxis and minorAxis, seen on 30 November 2026:
#
#   semi-axes of the region             true axes    majorAxis, minorAxis
#   24, 8, the longer one along x       48, 16       35.6, 21.2
#   24, 8, turned by 30° from x to y    48, 16       35.9, 21.3
#   24, 8, along y                      48, 16       68.3, 11.1
#   15, 15                              30, 30       42.5, 21.2
#
# The minor length is a distance across the columns of one end of each axis and the rows of the two ends of the minor axis. Both lengths are
# then scaled so that their ellipse has the area of the region. The two points of each axis have that wrong scale, but their distances are
# in the true ratio r: the true axes are the roots of (4 area/pi)/r and (4 area/pi) r. Centre and angle are right.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" image-js@1.7.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { Mask, fromMask } from 'image-js';

function measure(a, b, degrees) {
  const mask = new Mask(150, 130), c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180);
  for (let y = 0; y < 130; y++) {
    for (let x = 0; x < 150; x++) {
      const u = c * (x - 70) + s * (y - 60), v = -s * (x - 70) + c * (y - 60);
      if ((u / a) ** 2 + (v / b) ** 2 <= 1) mask.setBit(x, y, 1);
    }
  }
  const roi = fromMask(mask).getRois({ kind: 'white' })[0], { majorAxis, minorAxis } = roi.ellipse;
  const distance = ([p, q]) => Math.hypot(p.column - q.column, p.row - q.row);
  const ratio = distance(minorAxis.points) / distance(majorAxis.points), product = 4 * roi.surface / Math.PI;
  const found = { lengths: [majorAxis.length, minorAxis.length], restored: [Math.sqrt(product / ratio), Math.sqrt(product * ratio)] };
  console.log(a, b, degrees, found);
  return found;
}

function check(body, lengths) {
  const found = measure(...body), true_axes = [2 * body[0], 2 * body[1]];
  found.lengths.forEach((x, i) => assert(Math.abs(x - lengths[i]) < 0.01, `${x} instead of ${lengths[i]}`));
  found.restored.forEach((x, i) => assert(Math.abs(x - true_axes[i]) < 0.6, `${x} instead of ${true_axes[i]}`));
}

check([24, 8, 0], [35.60, 21.21]);
check([24, 8, 30], [35.89, 21.32]);
check([24, 8, 90], [68.31, 11.05]);
check([15, 15, 0], [42.49, 21.25]);
END
node "$dir/check.mjs"
