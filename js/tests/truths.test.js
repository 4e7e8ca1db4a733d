// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are known without the library: those of balls, and of README.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "pw85";

const pw85 = await load();
const ball = radius => [radius ** 2, 0, 0, radius ** 2, 0, radius ** 2];
// Balls of the radii 1 and 2 with the centres 7 apart, along (2, 3, 6), and scales.
const scales = [2 ** -40, 1, 2 ** 40];
const direction = [2 / 7, 3 / 7, 6 / 7];

/** A few roundings of sums and products, of numbers of the size of `scale`. */
function isNear(found, truth, scale) {
    assert.ok(Math.abs(found - truth) <= 32 * 2 ** -53 * scale, `${found} instead of ${truth}`);
}

test("balls apart", () => {
    for (const scale of scales) {
        const given = [[2 * scale, 3 * scale, 6 * scale], ball(scale), ball(2 * scale)];
        assert.equal(pw85.overlap(...given), false);
        const { mu2, lambda } = pw85.contact(...given), { distance, point1, point2 } = pw85.distance(...given);
        isNear(mu2, 49 / 9, 49 / 9);
        isNear(lambda, 1 / 3, 1);
        isNear(distance, 4 * scale, 7 * scale);
        direction.forEach((x, k) => {
            isNear(point1[k], scale * x, 7 * scale);
            isNear(point2[k], 5 * scale * x, 7 * scale);
        });
        const { point, normal } = pw85.contactGeometry(...given, lambda);
        direction.forEach((x, k) => {
            isNear(point[k], 7 / 3 * scale * x, 7 * scale);
            isNear(normal[k], x, 1);
        });
        assert.equal(pw85.overlapVolume(...given), 0);
    }
});

test("balls that overlap: a lens", () => {
    for (const scale of scales) {
        // Centres 2 apart, radii 2: two caps of the height 1.
        const cap = Math.PI / 3 * (3 * 2 - 1), given = [[0, 2 * scale, 0], ball(2 * scale), ball(2 * scale)];
        assert.equal(pw85.overlap(...given), true);
        // 64 u of the volume of a ball, and 16 u of its derivatives: below 100 u of the ball's volume, 32/3 pi
        assert.ok(Math.abs(pw85.overlapVolume(...given) / scale ** 3 - 2 * cap) <= 100 * 2 ** -53 * 34);
        isNear(pw85.contact(...given).mu2, 1 / 4, 1);
        assert.equal(pw85.overlapVolume([0, 0, 0], ball(scale), ball(4 * scale)) > 4 * scale ** 3, true);
    }
});

test("exact decisions next to contact", () => {
    const touching = [2, 0, 0], one = ball(1);
    assert.equal(pw85.overlap(touching, one, one), false);
    assert.equal(pw85.overlap([2 - 2 ** -52, 0, 0], one, one), true);
    assert.deepEqual([...pw85.overlapRows([...touching, 2 - 2 ** -52, 0, 0, 2 + 2 ** -51, 0, 0], one, one)], [0, 1, 0]);
});

test("moving balls", () => {
    const motion = [2, 0, 0, 0, 0, 0, 0], still = new Float32Array(7);
    isNear(pw85.firstContact([10, 0, 0], ball(1), ball(2), motion, still), 3.5, 10);
    assert.equal(pw85.firstContact([10, 0, 0], ball(1), ball(2), motion, still, 3), Infinity);
    const times = pw85.firstContactRows([10, 0, 0], ball(1), ball(2), motion, [...motion.map(x => -x), ...still], [9, 3]);
    isNear(times[0], 1.75, 10);
    assert.equal(times[1], Infinity);
});

test("rotation matrices", () => {
    const turned = pw85.ellipsoid([3, 2, 1], [0, -1, 0, 1, 0, 0, 0, 0, 1]);
    assert.deepEqual([...turned], [4, 0, 0, 9, 0, 1]);
    assert.deepEqual([...pw85.ellipsoidRows([3, 2, 1, 1, 1, 1], [0, -1, 0, 1, 0, 0, 0, 0, 1])], [...turned, 1, 0, 0, 1, 0, 1]);
});
