#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# An ellipsoid made as a ball of radius 1 with the scale (1, 2, 3) is three different bodies in three engines.
#
#                          mass / density   moments / mass    bounding box    rays stop at   contacts begin at
#   the ellipsoid          25.1327          2.6  2    1       1 2 3           1 2 3          1 2 3
#   Jolt (npm jolt-physics 1.1.0)
#                          25.1327          2.6  2    1       1 2 3           1 2 3          1 1 1
#   Havok (npm @babylonjs/havok 1.3.14)
#                          25.1327          2.6  2    1       1 1 1           1 1 1
#   Bullet (npm ammo.js 0.0.10)
#                          set by hand      0.4  0.4  0.4     1 1 1
#
# Jolt touches a ball whose radius is the scale along x, cut by the bounding box of the ellipsoid: the scale (3, 2, 1) touches at
# 3, 2 and 1 on the axes, but not in between. Only SphereShape.IsValidScale says that the scale is not one for balls; the constructor
# and the simulation say nothing.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" jolt-physics@1.1.0 @babylonjs/havok@1.3.14 ammo.js@0.0.10
cat >"$dir/check.mjs" <<'EOF'
import assert from 'node:assert';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import initJolt from 'jolt-physics';
import initHavok from '@babylonjs/havok';

const volume = 8 * Math.PI, moments = [13 / 5, 10 / 5, 5 / 5], axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
function close(found, expected, what) {
  console.log(what, found);
  expected.forEach((x, i) => assert(Math.abs(found[i] - x) < 1e-4 * (1 + Math.abs(x)), `${what}: ${found} is not ${expected}`));
}

async function jolt() {
  const J = await initJolt();
  const pairs = new J.ObjectLayerPairFilterTable(1), layers = new J.BroadPhaseLayerInterfaceTable(1, 1), settings = new J.JoltSettings();
  pairs.EnableCollision(0, 0);
  layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
  settings.mMaxWorkerThreads = 1;
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
  const system = new J.JoltInterface(settings).GetPhysicsSystem(), bodies = system.GetBodyInterface();
  const ball = new J.SphereShapeSettings(1);
  ball.mDensity = 1;
  const made = new J.ScaledShapeSettings(ball, new J.Vec3(1, 2, 3)).Create();
  assert(!made.HasError());
  const shape = made.Get(), mass = shape.GetMassProperties(), box = shape.GetLocalBounds().mMax;
  assert(!new J.SphereShape(1).IsValidScale(new J.Vec3(1, 2, 3)));
  close([shape.GetVolume(), mass.mMass], [volume, volume], 'Jolt: volume, mass');
  const I = mass.mInertia.GetDiagonal3();
  close([I.GetX(), I.GetY(), I.GetZ()].map((x) => x / mass.mMass), moments, 'Jolt: moments / mass');
  close([box.GetX(), box.GetY(), box.GetZ()], [1, 2, 3], 'Jolt: bounding box');
  const settingsOfBody = new J.BodyCreationSettings(shape, new J.RVec3(0, 0, 0), new J.Quat(0, 0, 0, 1), J.EMotionType_Static, 0);
  bodies.AddBody(bodies.CreateBody(settingsOfBody).GetID(), J.EActivation_DontActivate);
  const query = system.GetNarrowPhaseQuery();
  const filters = [new J.BroadPhaseLayerFilter(), new J.ObjectLayerFilter(), new J.BodyFilter(), new J.ShapeFilter()];
  const rays = axes.map((d) => {
    const hit = new J.CastRayClosestHitCollisionCollector(), far = d.map((x) => 10 * x);
    const ray = new J.RRayCast(new J.RVec3(...far), new J.Vec3(...far.map((x) => -x)));
    query.CastRay(ray, new J.RayCastSettings(), hit, ...filters);
    return 10 - 10 * hit.mHit.mFraction;
  });
  close(rays, [1, 2, 3], 'Jolt: rays stop at');
  const probe = new J.SphereShape(0.01);
  const touches = (d, t) => {
    const hit = new J.CollideShapeAnyHitCollisionCollector();
    const place = J.RMat44.prototype.sTranslation(new J.RVec3(...d.map((x) => x * t)));
    query.CollideShape(probe, new J.Vec3(1, 1, 1), place, new J.CollideShapeSettings(), new J.RVec3(0, 0, 0), hit, ...filters);
    return hit.HadHit();
  };
  const reach = axes.map((d) => {
    let inside = 0, outside = 10;
    for (let i = 0; i < 30; i++) {
      const middle = (inside + outside) / 2;
      if (touches(d, middle)) inside = middle; else outside = middle;
    }
    return inside - 0.01;
  });
  close(reach, [1, 1, 1], 'Jolt: contacts begin at');
}

async function havok() {
  const require = createRequire(import.meta.url);
  const H = await initHavok({ wasmBinary: readFileSync(require.resolve('@babylonjs/havok/lib/esm/HavokPhysics.wasm')) });
  const ball = H.HP_Shape_CreateSphere([0, 0, 0], 1)[1], shape = H.HP_Shape_CreateContainer()[1];
  H.HP_Shape_SetDensity(ball, 1);
  H.HP_Shape_AddChild(shape, ball, [[0, 0, 0], [0, 0, 0, 1], [1, 2, 3]]);
  const [, mass, I] = H.HP_Shape_BuildMassProperties(shape)[1];
  close([mass], [volume], 'Havok: mass');
  close(I, moments, 'Havok: moments / mass'); // this interface gives moments of unit mass
  close(H.HP_Shape_GetBoundingBox(shape, [[0, 0, 0], [0, 0, 0, 1]])[1][1], [1, 1, 1], 'Havok: bounding box');
  const world = H.HP_World_Create()[1], body = H.HP_Body_Create()[1], hits = H.HP_QueryCollector_Create(1)[1];
  H.HP_Body_SetShape(body, shape);
  H.HP_World_AddBody(world, body, false);
  const rays = axes.map((d) => {
    const far = d.map((x) => 10 * x);
    H.HP_World_CastRayWithCollector(world, hits, [far, far.map((x) => -x), [~0, ~0], false, [0n]]);
    return 10 - 20 * H.HP_QueryCollector_GetCastRayResult(hits, 0)[1][0];
  });
  close(rays, [1, 1, 1], 'Havok: rays stop at');
}

async function bullet() {
  const made = createRequire(import.meta.url)('ammo.js'), A = typeof made === 'function' ? await made() : made;
  const ball = new A.btSphereShape(1), I = new A.btVector3(0, 0, 0);
  ball.setLocalScaling(new A.btVector3(1, 2, 3));
  ball.calculateLocalInertia(1, I);
  close([I.x(), I.y(), I.z()], [0.4, 0.4, 0.4], 'Bullet: moments / mass');
  ball.setLocalScaling(new A.btVector3(3, 2, 1));
  ball.calculateLocalInertia(1, I);
  close([I.x(), I.y(), I.z()], [3.6, 3.6, 3.6], 'Bullet: moments / mass, scale (3, 2, 1)');
}

await jolt();
await havok();
await bullet();
EOF
node "$dir/check.mjs"
