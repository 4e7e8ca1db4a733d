#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A polygon of more than 12 points is cut, without an error: only its first 12 points are used. An ellipse of 24 points is half an ellipse.
#
# planck 1.4.2 and 1.5.0 (npm), ellipses with the semi-axes 3 and 1 from points at equal steps of the parameter, seen on 30 November 2026:
#
#   points   used   area of the polygon   mass at density 1   centre of mass (1.5.0)   (1.4.2)       overlaps missed
#   12       12     9.00                  9.00                0, 0                     0, 0          0 of 2000
#   16       12     9.18                  7.70                -0.24, 0.12              -0.24, 0.52   676
#   24       12     9.32                  3.88                0.19, 0.49               0.19, 0.58    1582
#   32       12     9.36                  1.97                0.97, 0.61               0.97, 0.55    2000
#
# The centre of mass of 1.4.2 is wrong even for the part that is left; that of 1.5.0 is right for it.
# Overlaps: of two parallel ellipses, the second centre goes around the first one on the ellipse with the semi-axes 5.4 and 1.8, where it
# always overlaps (ellipses that touch are at 6 and 2). The limit is Settings.maxPolygonVertices, which can be changed. Other ports of
# Box2D refuse such polygons.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
cat >check.mjs <<'END'
import assert from "node:assert";
import { Polygon, Transform, Vec2, testOverlap } from "planck";

const around = (n, a, b) => Array.from({ length: n }, (_, k) => new Vec2(a * Math.cos((2 * Math.PI * k) / n), b * Math.sin((2 * Math.PI * k) / n)));
const at = (p) => new Transform(p, 0);
for (const [n, missed, y] of [[12, 0, 0], [16, 676, 0.117], [24, 1582, 0.489], [32, 2000, 0.606]]) {
  const ellipse = new Polygon(around(n, 3, 1));
  const body = { mass: 0, center: new Vec2(), I: 0 };
  ellipse.computeMass(body, 1);
  const apart = around(2000, 5.4, 1.8).filter((p) => !testOverlap(ellipse, 0, ellipse, 0, at(new Vec2(0, 0)), at(p))).length;
  const area = (n / 2) * 3 * Math.sin((2 * Math.PI) / n);
  console.log(n, ellipse.m_count, area.toFixed(2), body.mass.toFixed(2), body.center.x.toFixed(2), body.center.y.toFixed(2), apart);
  assert.equal(ellipse.m_count, 12);
  assert.ok(n === 12 ? Math.abs(body.mass - area) < 1e-6 : body.mass < 0.85 * area);
  assert.equal(apart, missed);
  assert.equal(Math.abs(body.center.y - y) < 1e-3, n === 12 || process.argv[2] === "planck@1.5.0");
}
END
for package in planck@1.4.2 planck@1.5.0; do
  npm install --silent --no-fund --no-audit "$package" >/dev/null
  echo "$package"
  node check.mjs "$package"
done
