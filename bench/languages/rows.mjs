// SPDX-License-Identifier: BSD-3-Clause
// The program of bench/languages.py in JavaScript, which is always in the reproducible mode: see there.
import { readFileSync, writeFileSync } from "node:fs";
import { load } from "../../js/pw85.js";

const PAIRS = 1000;
const COPIES = { overlap: 16, contact: 16, distance: 4, overlapVolume: 1 }; // of the pairs, that are computed as rows
const RESULTS = { overlap: [], contact: ["mu2", "lambda"], distance: ["distance", "point1", "point2"], overlapVolume: [] };

const [given, out, rounds] = process.argv.slice(2);
const bytes = readFileSync(given), numbers = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const parts = [[0, 3], [3, 6], [9, 6]].map(([from, size]) => ({ size, values: numbers.subarray(from * PAIRS, (from + size) * PAIRS) }));
const rows = Array.from({ length: PAIRS }, (_, i) => parts.map(({ size, values }) => values.slice(size * i, size * (i + 1))));
const pw85 = await load();

/** The least nanoseconds of several runs, from run(0) on. */
function nanoseconds(run) {
    let least = Infinity;
    for (let k = 0; k < Number(rounds); ++k) {
        const start = process.hrtime.bigint();
        run(k);
        least = Math.min(least, Number(process.hrtime.bigint() - start));
    }
    return least;
}

const written = [];
for (const [name, outputs] of Object.entries(RESULTS)) {
    const many = parts.map(({ values }) => Float64Array.from({ length: COPIES[name] * values.length }, (_, k) => values[k % values.length]));
    // The first form of the pair that is k places behind
    const call = nanoseconds(k => rows.forEach(([r12, , q2], i) => pw85[name](r12, rows[(i + k) % PAIRS][1], q2)));
    const row = nanoseconds(() => pw85[`${name}Rows`](...many));
    const numbersOf = found => (outputs.length > 0 ? outputs.map(key => found[key]) : [found]);
    const together = numbersOf(pw85[`${name}Rows`](...many));
    written.push(...together.map(column => Float64Array.from(column.subarray(0, column.length / COPIES[name]))));
    const alone = rows.map(row => numbersOf(pw85[name](...row)));
    written.push(...together.map((_, k) => Float64Array.from(alone.flatMap(found => (found[k].length ? [...found[k]] : Number(found[k]))))));
    const label = name === "overlapVolume" ? "overlap_volume" : name;
    console.log(`${label},${call / PAIRS},${row / (PAIRS * COPIES[name])}`);
}
writeFileSync(out, Buffer.concat(written.map(column => Buffer.from(column.buffer))));
