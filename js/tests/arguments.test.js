// SPDX-License-Identifier: BSD-3-Clause
// What users of JavaScript pass: results as they expect them, or errors that name argument, row and entry.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load, Pw85Error } from "pw85";

const pw85 = await load({ doubles: 100 });
const r12 = [3, 2, 1], one = [1, 0, 0, 1, 0, 1], two = [...one, ...one];

function refused(call, message, { argument = null, row = null, entry = null } = {}) {
    assert.throws(call, error => {
        assert.ok(error instanceof Pw85Error && error instanceof Error, String(error));
        assert.equal(error.message, message);
        assert.deepEqual([error.argument, error.row, error.entry], [argument, row, entry], message);
        assert.ok(message.endsWith(error.requirement));
        return true;
    });
}

test("arrays of all types of numbers", () => {
    const truth = pw85.contact(r12, one, one);
    for (const Type of [Float64Array, Float32Array, Int8Array, Uint8Array, Uint8ClampedArray, Int16Array, Uint16Array, Int32Array, Uint32Array]) {
        assert.deepEqual(pw85.contact(new Type(r12), new Type(one), new Type(one)), truth, Type.name);
        assert.deepEqual(pw85.contactRows(new Type([...r12, ...r12]), new Type(one), new Type(two)).mu2, new Float64Array([truth.mu2, truth.mu2]));
    }
    const wide = new Float64Array([9, ...r12, 9]);
    assert.deepEqual(pw85.contact(wide.subarray(1, 4), one, one), truth);
    assert.deepEqual(pw85.contact(new Float64Array(wide.buffer, 8, 3), one, one), truth);
    const shared = new Float64Array(new SharedArrayBuffer(24));
    shared.set(r12);
    assert.deepEqual(pw85.contact(shared, one, one), truth);
    const many = new Float64Array(new SharedArrayBuffer(24 * 1000)), out = new Float64Array(new SharedArrayBuffer(8 * 1000));
    for (let i = 0; i < 1000; ++i) many.set(r12, 3 * i);
    pw85.contactRows(many, one, one, { mu2: out });
    assert.ok(out.every(x => x === truth.mu2));
});

test("wrong types", () => {
    const bad = [
        [undefined, "undefined"], [null, "null"], ["3,2,1", "string"], [true, "boolean"], [1n, "bigint"], [{ x: 1 }, "Object"], [() => 1, "function"],
        [new BigInt64Array(3), "BigInt64Array"], [new BigUint64Array(3), "BigUint64Array"], [new ArrayBuffer(24), "ArrayBuffer"],
        [new DataView(new ArrayBuffer(24)), "DataView"], [3, "number"], [new Set(r12), "Set"], [Object.create(null), "object"],
    ];
    for (const [value, kind] of bad) {
        refused(() => pw85.contact(value, one, one), `r12: must be an array of numbers, not ${kind}`, { argument: "r12" });
        refused(() => pw85.contactRows(r12, one, value), `q2: must be an array of numbers, not ${kind}`, { argument: "q2" });
    }
    for (const [value, kind] of [["1", "string"], [undefined, "undefined"], [null, "null"], [1n, "bigint"], [[1], "Array"], [new Date(0), "Date"]]) {
        refused(() => pw85.overlap([3, value, 1], one, one), `r12, entry 1: must be a number, not ${kind}`, { argument: "r12", entry: 1 });
        refused(() => pw85.overlapRows(r12, one, [...one, 1, 0, 0, 1, 0, value]), `q2, row 1, entry 5: must be a number, not ${kind}`, {
            argument: "q2", row: 1, entry: 5,
        });
    }
    refused(() => pw85.contactGeometry(r12, one, one, "0.5"), "lambda: must be a number or an array of numbers, not string", { argument: "lambda" });
    refused(() => pw85.contact(r12, one, one, one), "contact() takes at most 3 arguments, not 4");
    refused(() => pw85.contactRows(r12, one, one, {}, 1), "contactRows() takes at most 4 arguments, not 5");
});

test("wrong lengths", () => {
    refused(() => pw85.contact([3, 2], one, one), "r12: must have 3 numbers in each row, and has 2 in all", { argument: "r12" });
    refused(() => pw85.contact(r12, one.slice(1), one), "q1: must have 6 numbers in each row, and has 5 in all", { argument: "q1" });
    for (const nested of [[r12, r12], [[3], [2], [1]], [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [new Float64Array(3)]]) {
        const requirement = "must be one array of numbers, row after row, not an array of arrays";
        refused(() => pw85.contactRows(nested, one, one), `r12: ${requirement}`, { argument: "r12" });
        refused(() => pw85.contact(r12, nested, one), `q1: ${requirement}`, { argument: "q1" });
    }
    refused(() => pw85.contact(r12, two, one), "q1: must have 1 row, and has 2: see contactRows()", { argument: "q1" });
    refused(() => pw85.contact([], one, one), "r12: must have 1 row, and has 0: see contactRows()", { argument: "r12" });
    refused(() => pw85.contactRows(new Float64Array(9), one, two), "q2: must have 1 row or 3 rows, as r12, and has 2", { argument: "q2" });
    refused(() => pw85.contactRows(new Float64Array(9), [], one), "q1: must have 1 row or 3 rows, as r12, and has 0", { argument: "q1" });
});

test("arrays whose memory was transferred", () => {
    const gone = () => {
        const array = new Float64Array(r12);
        structuredClone(array.buffer, { transfer: [array.buffer] });
        return array;
    };
    const requirement = "must not be detached: its memory was transferred";
    refused(() => pw85.contact(gone(), one, one), `r12: ${requirement}`, { argument: "r12" });
    refused(() => pw85.contactRows(gone(), one, one), `r12: ${requirement}`, { argument: "r12" });
    refused(() => pw85.overlapVolumeRows(r12, one, one, gone()), `out: ${requirement}`, { argument: "out" });
    refused(() => pw85.contactRows([], one, one, { mu2: gone() }), `out.mu2: ${requirement}`, { argument: "out.mu2" });
    assert.deepEqual(pw85.overlapRows(new Float64Array(new ArrayBuffer(8), 8), one, one), new Uint8Array(0)); // empty, and not detached
});

test("no rows", () => {
    assert.deepEqual(pw85.contactRows([], one, []), { mu2: new Float64Array(0), lambda: new Float64Array(0) });
    assert.deepEqual(pw85.overlapRows(new Float32Array(0), one, one), new Uint8Array(0));
    assert.deepEqual(pw85.ellipsoidRows([], []), new Float64Array(0));
});

test("numbers that the library refuses", () => {
    for (const bad of [NaN, Infinity, -Infinity]) {
        refused(() => pw85.contact([3, bad, 1], one, one), "r12, entry 1: must be finite", { argument: "r12", entry: 1 });
        const rows = new Float64Array(3 * 600).fill(9), place = { argument: "r12", row: 599, entry: 2 };
        rows[1799] = bad;
        refused(() => pw85.overlapRows(rows, one, one), "r12, row 599, entry 2: must be finite", place);
        refused(() => pw85.contactGeometry(r12, one, one, bad), `lambda: must be finite`, { argument: "lambda" });
        refused(() => pw85.ellipsoid([1, 2, bad], [1, 0, 0, 0, 1, 0, 0, 0, 1]), "semiAxes, entry 2: must be finite", { argument: "semiAxes", entry: 2 });
    }
    const flat = [1, 0, 0, 1, 0, -1], far = new Float64Array(3 * 300).fill(9);
    refused(() => pw85.distance(r12, one, flat), "q2: must be positive definite", { argument: "q2" });
    // The row of an argument that is repeated is its own.
    refused(() => pw85.distanceRows(far, one, flat), "q2, row 0: must be positive definite", { argument: "q2", row: 0 });
    refused(() => pw85.distanceRows(r12, one, [...two, ...flat]), "q2, row 2: must be positive definite", { argument: "q2", row: 2 });
    refused(() => pw85.ellipsoidQuaternion([3, 2, 0], one.slice(2)), "semiAxes, entry 2: must be > 0", { argument: "semiAxes", entry: 2 });
    refused(() => pw85.ellipsoidQuaternion([3, 2, 1], [0, 0, 0, 0]), "quaternion: must not be zero", { argument: "quaternion" });
    refused(() => pw85.ellipsoidRows([3, 2, 1], [1, 0, 0, 0, 1, 0, 0, 0, 1, ...Array(9).fill(1)]),
        "rotation, row 1: must be a rotation matrix, whose columns are orthonormal", { argument: "rotation", row: 1 });
    refused(() => pw85.contactGeometry([0, 0, 0], one, one, 0.5), "r12: must not be zero", { argument: "r12" });
    const still = Array(7).fill(0), shrinking = [0, 0, 0, 0, 0, 0, -1];
    refused(() => pw85.firstContact(r12, one, one, still, still, -1), "tMax: must be >= 0", { argument: "tMax" });
    refused(() => pw85.firstContact(r12, one, one, still, shrinking, 2), "motion2, entry 6: must not shrink to nothing before t_max", {
        argument: "motion2", entry: 6,
    });
    // After an error, results are as before.
    assert.equal(pw85.overlap(r12, one, one), false);
});

test("arrays for results", () => {
    const rows = [...r12, ...r12, 0, 0, 0], call = out => pw85.distanceRows(rows, one, one, out), alone = out => pw85.overlapVolumeRows(rows, one, one, out);
    const single = call({ distance: new Float32Array(3) }).distance;
    assert.equal(single[0], Math.fround(Math.sqrt(14) - 2));
    refused(() => call(new Float64Array(3)), "out: must be an object with some of the arrays distance, point1, point2, not Float64Array", { argument: "out" });
    refused(() => call(null), "out: must be an object with some of the arrays distance, point1, point2, not null", { argument: "out" });
    refused(() => call(7), "out: must be an object with some of the arrays distance, point1, point2, not number", { argument: "out" });
    refused(() => call({ mu2: new Float64Array(3) }), "out.mu2: is not a result: these are distance, point1, point2", { argument: "out.mu2" });
    refused(() => call({ distance: [0, 0, 0] }), "out.distance: must be a Float64Array or Float32Array, not Array", { argument: "out.distance" });
    refused(() => call({ point1: new Float64Array(8) }), "out.point1: must have 9 elements, not 8", { argument: "out.point1" });
    refused(() => alone(null), "out: must be a Float64Array or Float32Array, not null", { argument: "out" });
    refused(() => alone(new Float64Array(2)), "out: must have 3 elements, not 2", { argument: "out" });
    refused(() => pw85.overlapRows(rows, one, one, new Float64Array(3)), "out: must be a Uint8Array, not Float64Array", { argument: "out" });
    const same = new Float64Array(rows);
    refused(() => pw85.overlapVolumeRows(same, one, one, same.subarray(6)), "out: must not share memory with r12", { argument: "out" });
    for (const [from, to] of [[0, 9], [3, 0]]) { // next to each other
        const both = new Float64Array(12), input = both.subarray(from, from + 9);
        assert.deepEqual(pw85.overlapVolumeRows(input, one, one, both.subarray(to, to + 3)), pw85.overlapVolumeRows(Array(9).fill(0), one, one));
    }
    const points = new Float64Array(9);
    refused(() => call({ point1: points, point2: points }), "out.point2: must not share memory with out.point1", { argument: "out.point2" });
    assert.deepEqual(pw85.overlapRows(rows, one, one, new Uint8Array(3)), new Uint8Array([0, 0, 1]));
    const named = Object.assign(Object.create(null), { distance: new Float64Array(3) });
    assert.equal(call(named), named);
});

test("memory of the library", async () => {
    pw85.release();
    const array = pw85.allocate(60);
    array.set(r12, 1);
    assert.deepEqual(pw85.contact(array.subarray(1, 4), one, one), pw85.contact(r12, one, one));
    assert.deepEqual(pw85.contactRows(array.subarray(1, 4), one, one), pw85.contactRows(r12, one, one));
    refused(() => pw85.allocate(41), "length: must be at most 40: load() reserves memory for allocate()", { argument: "length" });
    assert.equal(pw85.allocate(40).length, 40);
    pw85.release();
    assert.equal(pw85.allocate(100).byteOffset, array.byteOffset);
    for (const bad of [-1, 0.5, NaN, "1", undefined, 1n]) {
        refused(() => pw85.allocate(bad), `length: must be an integer >= 0, not ${bad}`, { argument: "length" });
        if (bad === undefined) continue;
        await assert.rejects(load({ doubles: bad }), { message: `doubles: must be an integer from 0 to 268435456, not ${bad}` });
    }
    await assert.rejects(load({ wasm: new Uint8Array(8) }), WebAssembly.CompileError);
    for (const [bad, kind] of [["pw85.wasm", "string"], [null, "null"], [new URL("file:///pw85.wasm"), "URL"], [[0, 97], "Array"]]) {
        await assert.rejects(load({ wasm: bad }), { message: `wasm: must be the bytes of a module or a compiled module, not ${kind}` });
    }
    await assert.rejects(load({ double: 1 }), { message: "options.double: is not an option: these are wasm, doubles" });
    await assert.rejects(load(100), { message: "options: must be an object with some of wasm, doubles, not number" });
    await assert.rejects(load(null), { message: "options: must be an object with some of wasm, doubles, not null" });
    const bytes = readFileSync(new URL(import.meta.resolve("pw85/pw85.wasm")));
    for (const wasm of [bytes, new Uint8Array(bytes).buffer, new WebAssembly.Module(bytes)]) {
        assert.equal((await load({ wasm })).overlap(r12, one, one), false);
    }
});
