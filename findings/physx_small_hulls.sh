#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The convex hull of points on a grain of millimetres, in metres, has half of its volume; that of a tenth of a millimetre is a tetrahedron
# that sticks out to eight times a semi-axis. No message comes, and the unit of length that PxTolerancesScale states makes no difference.
#
# PhysX 5.6.1 (npm physx-js-webidl 2.7.3), CreateConvexMesh with eCOMPUTE_CONVEX. 100 points on the ellipsoid s (1, 2, 3). Volume divided by
# that of the ellipsoid, bounds of the mesh divided by s, and where a ray along x from (10 s, 0, 0) stops, seen on 1 December 2026:
#
#   s         vertices   volume   x from, to      y from, to      ray      with planeTolerance = 0.0007 s
#   1         100        0.942    -0.99   0.99    -1.96   1.99    0.980    the same
#   0.01      93         0.932    -0.97   0.99    -1.96   1.99    0.964    the first row
#   0.003     27         0.762    -0.97   0.99    -1.93   1.99    0.934    the first row
#   0.001     10         0.471    -0.97   0.99    -1.93   1.99    0.876    the first row
#   0.0001    4          2.012    -7.97   0.14    -1.96   8.98    0.091    the first row
#
# The rows are the same if PxTolerancesScale.length is s: the PxCookingParams made of it have planeTolerance = 0.0007 nevertheless. So set
# it, or cook the hull of larger points and scale the mesh (PxMeshScale). The module is made for browsers and refuses to start if it sees
# the version of node; the script hides this version.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" physx-js-webidl@2.7.3
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const wasm = createRequire(import.meta.url).resolve('physx-js-webidl').replace(/mjs$/, 'wasm');
Object.defineProperty(process, 'versions', { value: {} });
globalThis.window = globalThis;
const P = await (await import('physx-js-webidl')).default({ wasmBinary: readFileSync(wasm) }), version = P.PHYSICS_VERSION;
assert.equal([version >>> 24, (version >> 16) & 255, (version >> 8) & 255].join('.'), '5.6.1');
const foundation = P.CreateFoundation(version, new P.PxDefaultAllocator(), new P.PxDefaultErrorCallback());
P.CreatePhysics(version, foundation, new P.PxTolerancesScale());

const number = 100;
const points = Array.from({ length: number }, (_, i) => {
  const z = 1 - (2 * i + 1) / number, phi = i * Math.PI * (3 - Math.sqrt(5)), r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), 2 * r * Math.sin(phi), 3 * z];
});
function hull(s, length, tolerance) {
  const scale = new P.PxTolerancesScale(), list = new P.PxArray_PxVec3(number), description = new P.PxConvexMeshDesc();
  scale.length = length;
  const cooking = new P.PxCookingParams(scale);
  assert(Math.abs(cooking.planeTolerance - 0.0007) < 1e-9);
  if (tolerance) cooking.planeTolerance = tolerance;
  points.forEach((p, i) => list.set(i, new P.PxVec3(...p.map((x) => s * x))));
  description.points.count = number;
  description.points.stride = 12;
  description.points.data = list.begin();
  description.flags = new P.PxConvexFlags(P.PxConvexFlagEnum.eCOMPUTE_CONVEX);
  description.vertexLimit = 255;
  return P.CreateConvexMesh(cooking, description);
}
function measure(mesh, s, scaled = s) {
  const factor = new P.PxMeshScale(scaled / s), shape = new P.PxConvexMeshGeometry(mesh, factor), bounds = mesh.getLocalBounds();
  const hit = new P.PxRaycastHit(), place = new P.PxTransform(P.PxIDENTITYEnum.PxIdentity), far = 10 * scaled;
  const flags = new P.PxHitFlags(P.PxHitFlagEnum.eDEFAULT);
  const hits = P.PxGeometryQuery.prototype.raycast(new P.PxVec3(far, 0, 0), new P.PxVec3(-1, 0, 0), shape, place, 10 * far, flags, 1, hit);
  assert.equal(hits, 1);
  return {
    vertices: mesh.getNbVertices(),
    volume: new P.PxMassProperties(shape).mass / (8 * Math.PI * scaled ** 3),
    x: [bounds.minimum.x / s, bounds.maximum.x / s],
    y: [bounds.minimum.y / s, bounds.maximum.y / s],
    ray: 10 - hit.distance / scaled,
  };
}
const near = (x, y, tolerance) => assert(Math.abs(x - y) <= tolerance, `${x} instead of ${y}`);
function agree(found, [vertices, volume, ...coordinates]) {
  assert.equal(found.vertices, vertices);
  near(found.volume, volume, 2e-3);
  [...found.x, ...found.y, found.ray].forEach((x, i) => near(x, coordinates[i], 0.01));
}

// Volume of the hull of all points, as the sum over the planes through three of them that have all others on one side.
function volume() {
  const minus = (p, q) => p.map((x, i) => x - q[i]), dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  let sum = 0;
  for (let i = 0; i < number; i++) {
    for (let j = i + 1; j < number; j++) {
      for (let k = j + 1; k < number; k++) {
        const normal = cross(minus(points[j], points[i]), minus(points[k], points[i]));
        const height = dot(normal, points[i]), side = Math.sign(height);
        if (points.every((p, m) => m === i || m === j || m === k || side * dot(normal, p) < side * height)) sum += Math.abs(height) / 6;
      }
    }
  }
  return sum / (8 * Math.PI);
}
const first = [100, 0.942, -0.99, 0.99, -1.96, 1.99, 0.980];
console.log('volume of the hull', volume());
near(volume(), 0.942, 1e-3);
const rows = [
  [1, first],
  [0.01, [93, 0.932, -0.97, 0.99, -1.96, 1.99, 0.964]],
  [0.003, [27, 0.762, -0.97, 0.99, -1.93, 1.99, 0.934]],
  [0.001, [10, 0.471, -0.97, 0.99, -1.93, 1.99, 0.876]],
  [0.0001, [4, 2.012, -7.97, 0.14, -1.96, 8.98, 0.091]],
];
for (const [s, expected] of rows) {
  const found = measure(hull(s, 1), s);
  console.log(s, found);
  agree(found, expected);
  agree(measure(hull(s, s), s), expected);
  agree(measure(hull(s, 1, 0.0007 * s), s), first);
}
agree(measure(hull(1, 1), 1, 0.001), first);
END
node "$dir/check.mjs"
