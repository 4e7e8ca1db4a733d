// SPDX-License-Identifier: BSD-3-Clause
// Ellipses: the bits of C by each way to pass rows, numbers that are known without the library, and errors.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load, loadPlane } from "pw85";
import { linesOf, makeUniform } from "./pairs.js";

const plane = await loadPlane({ doubles: 1000 });
const circle = radius => [radius ** 2, 0, radius ** 2];

function makeEllipses() {
    const uniform = makeUniform(), found = { r12: [], q1: [], q2: [] };
    for (let i = 0; i < 100; ++i) {
        found.r12.push(5 * uniform() - 2, 5 * uniform() - 2);
        for (const q of [found.q1, found.q2]) {
            const axes = [0, 0].map(() => 0.25 + 2 * uniform());
            q.push(...plane.ellipse(...axes, 4 * uniform()));
        }
    }
    return found;
}

test("the bits of C, in rows and one by one", () => {
    const { r12, q1, q2 } = makeEllipses(), truth = readFileSync(new URL("ellipses.txt", import.meta.url), "utf-8").trim().split("\n");
    const rows = (x, y, z, out) => {
        const { mu2, lambda } = plane.contact2dRows(x, y, z);
        return linesOf(mu2, lambda, plane.distance2dRows(x, y, z).distance, plane.overlapArea2dRows(x, y, z, out));
    };
    assert.deepEqual(rows(r12, q1, q2), truth);
    const own = [r12, q1, q2].map(x => {
        const array = plane.allocate(x.length);
        array.set(x);
        return array;
    });
    assert.deepEqual(rows(...own, plane.allocate(100)), truth);
    truth.forEach((line, i) => {
        const given = [r12.slice(2 * i, 2 * i + 2), q1.slice(3 * i, 3 * i + 3), q2.slice(3 * i, 3 * i + 3)], { mu2, lambda } = plane.contact2d(...given);
        assert.equal(linesOf([mu2], [lambda], [plane.distance2d(...given).distance], [plane.overlapArea2d(...given)])[0], line, `pair ${i}`);
    });
});

test("circles", () => {
    for (const scale of [2 ** -40, 1, 2 ** 40]) {
        // Radii 1 and 2, and the centres 5 apart, along (3, 4).
        const apart = [[3 * scale, 4 * scale], circle(scale), circle(2 * scale)], error = 32 * 2 ** -53;
        assert.equal(plane.overlap2d(...apart), false);
        const { mu2, lambda } = plane.contact2d(...apart), { distance, point1 } = plane.distance2d(...apart);
        assert.ok(Math.abs(mu2 - 25 / 9) <= error * 25 / 9, String(mu2));
        assert.ok(Math.abs(distance - 2 * scale) <= error * 5 * scale, String(distance));
        assert.ok(Math.abs(point1[0] - 0.6 * scale) <= error * 5 * scale, String(point1));
        assert.ok(Math.abs(plane.contactGeometry2d(...apart, lambda).normal[1] - 0.8) <= error);
        assert.equal(plane.overlapArea2d(...apart), 0);
        // Radii 1, centres 1 apart: two sectors less two triangles, 2 pi/3 - sqrt(3)/2. The magnitudes of the terms add up to less than 4.
        const lens = plane.overlapArea2d([0, scale], circle(scale), circle(scale)) / scale ** 2;
        assert.ok(Math.abs(lens - (2 * Math.PI / 3 - Math.sqrt(3) / 2)) <= error * 4, String(lens));
    }
    assert.deepEqual([...plane.overlap2dRows([2, 0, 2 - 2 ** -52, 0, 2 + 2 ** -51, 0], circle(1), circle(1))], [0, 1, 0]);
    assert.deepEqual([...plane.ellipse(2, 3, 0)], [4, 0, 9]);
});

test("errors", async () => {
    const far = new Float32Array(600).fill(9);
    assert.throws(() => plane.distance2dRows(far, circle(1), [1, 2, 1]), { message: "q2, row 0: must be positive definite" });
    far[599] = NaN;
    assert.throws(() => plane.contact2dRows(far, circle(1), circle(1)), { message: "r12, row 299, entry 1: must be finite" });
    assert.throws(() => plane.overlap2d([1, 2, 3], circle(1), circle(1)), { message: "r12: must have 2 numbers in each row, and has 3 in all" });
    assert.throws(() => plane.ellipse(1, 0, 0), { message: "b: must be > 0" });
    // Modules have their own functions.
    const bytes = name => readFileSync(new URL(import.meta.resolve(`pw85/${name}.wasm`)));
    await assert.rejects(load({ wasm: bytes("plane") }), { message: "wasm: must be the module with pw85_ellipsoid()" });
    await assert.rejects(loadPlane({ wasm: bytes("pw85") }), { message: "wasm: must be the module with pw85_ellipse()" });
    assert.equal((await loadPlane({ wasm: bytes("plane") })).overlap2d([1, 1], circle(1), circle(1)), true);
});
