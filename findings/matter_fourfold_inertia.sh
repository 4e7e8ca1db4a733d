#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Each body has four times the moment of inertia of its shape: pushed off its centre, an ellipse turns at a quarter of the rate. If it is
# made with a mass, its moment is that of another mass.
#
# Matter.js (npm matter-js 0.20.0), a polygon of 200 points on the ellipse (3, 1) with the density 1, seen on 30 November 2026:
#
#   mass / (pi a b)                                                    0.9998
#   inertia / mass                                                     9.998    (the ellipse: (a² + b²)/4 = 2.5)
#   the same, made with { mass: 1 } instead of a density               0.0942   (four times the ellipse of mass 0.001 area)
#   angular speed / speed, after one force along y at the end (3, 0)   0.300    (the ellipse: a/2.5 = 1.2)
#
# A rectangle has four times its moment, too, and so do bodies that were scaled. Body.setInertia(body, body.inertia/4) gives the true one of
# a body made with a density; after Body.scale it must be set again. Body.setMass, called later, keeps inertia/mass.
# Needs node and npm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$dir" matter-js@0.20.0
cat >"$dir/check.mjs" <<'END'
import assert from 'node:assert';
import Matter from 'matter-js';
const { Bodies, Body, Composite, Engine } = Matter;
const a = 3, b = 1, n = 200, moment = (a * a + b * b) / 4;

function ellipse(options = { density: 1 }) {
  const vertices = Array.from({ length: n }, (_, i) => ({ x: a * Math.cos(2 * Math.PI * i / n), y: b * Math.sin(2 * Math.PI * i / n) }));
  return Bodies.fromVertices(0, 0, [vertices], { ...options, frictionAir: 0 });
}

function rateAfterPush(body) {
  const engine = Engine.create();
  engine.gravity.y = 0;
  Composite.add(engine.world, body);
  Body.applyForce(body, { x: a, y: 0 }, { x: 0, y: 1e-3 * body.mass });
  Engine.update(engine, 1000 / 60);
  return Body.getAngularVelocity(body) / Body.getVelocity(body).y;
}

const near = (x, y, tolerance) => assert(Math.abs(x - y) < tolerance, `${x} instead of ${y}`);
const body = ellipse(), box = Bodies.rectangle(0, 0, 6, 2, { density: 1 }), set = ellipse(), scaled = ellipse();
const massive = ellipse({ mass: 1 }), later = ellipse();
Body.setMass(later, 1);
Body.setInertia(set, set.inertia / 4);
Body.setInertia(scaled, scaled.inertia / 4);
Body.scale(scaled, 2, 2);
const rows = {
  mass: body.mass / (Math.PI * a * b), moment: body.inertia / body.mass / moment, box: box.inertia / box.mass / ((36 + 4) / 12),
  scaled: scaled.inertia / scaled.mass / (4 * moment), massive: massive.inertia / massive.mass,
  later: later.inertia / later.mass / moment, rate: rateAfterPush(body), rateSet: rateAfterPush(set),
};
console.log(rows);
near(rows.mass, 1, 1e-3);
near(rows.moment, 4, 2e-3);
near(rows.box, 4, 1e-9);
near(rows.scaled, 4, 2e-3); // what was set is lost
near(rows.massive, 4 * moment * 0.001 * Math.PI * a * b, 1e-3);
near(rows.later, 4, 2e-3);
near(rows.rate, 0.3, 1e-3);
near(rows.rateSet, a / moment, 2e-3);
END
node "$dir/check.mjs"
