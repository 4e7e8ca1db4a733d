// SPDX-License-Identifier: BSD-3-Clause
// The bits that the C API gives in the reproducible mode, by each way to pass rows.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load } from "pw85";
import { linesOf, linesOfPairs, makePairs } from "./pairs.js";

const pw85 = await load({ doubles: 40000 });
const pairs = makePairs(pw85), { r12, q1, q2 } = pairs;
const truth = readFileSync(process.env.PW85_PAIRS, "utf-8").trim().split("\n");

test("many rows", () => assert.deepEqual(linesOfPairs(pw85, pairs), truth));

test("one by one", () => {
    const row = (x, size, i) => x.slice(size * i, size * (i + 1));
    truth.forEach((line, i) => {
        const given = [row(r12, 3, i), row(q1, 6, i), row(q2, 6, i)], { mu2, lambda } = pw85.contact(...given);
        const found = linesOf([mu2], [lambda], [pw85.distance(...given).distance], [pw85.overlapVolume(...given)]);
        assert.equal(found[0], line, `pair ${i}`);
    });
});

test("arrays in the memory of the library, and results in given arrays", () => {
    pw85.release();
    const own = [r12, q1, q2].map(x => {
        const array = pw85.allocate(x.length);
        array.set(x);
        return array;
    });
    const mu2 = pw85.allocate(1000), lambda = new Float64Array(1000), distance = pw85.allocate(1000);
    const out = { mu2, lambda };
    assert.equal(pw85.contactRows(...own, out), out);
    assert.deepEqual(Object.keys(pw85.distanceRows(...own, { distance })), ["distance"]);
    const volume = new Float64Array(1002).subarray(1, 1001);
    assert.equal(pw85.overlapVolumeRows(own[0], q1, own[2], volume), volume);
    assert.deepEqual(linesOf(mu2, lambda, distance, volume), truth);
    assert.deepEqual([...new Float64Array(volume.buffer)].filter((_, i) => i < 1 || i > 1000), [0, 0]);
});

test("instances have memories of their own", async () => {
    const other = await load({ wasm: readFileSync(new URL(import.meta.resolve("pw85/pw85.wasm"))) });
    assert.deepEqual(linesOfPairs(other, pairs), truth);
    assert.throws(() => other.allocate(1), /^Pw85Error: length: must be at most 0/);
});
