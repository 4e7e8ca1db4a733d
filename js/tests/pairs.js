// SPDX-License-Identifier: BSD-3-Clause
// The 1,000 pairs of r/data-raw/pairs.c, and the lines of their numbers as that program prints them, in Node and in browsers.

export function makeUniform() {
    let state = 1;
    return () => {
        state = state * 16807 % 2147483647; // below 2^53
        return state % 65536 / 65536;
    };
}

/** The arguments of 1,000 pairs, row behind row. */
export function makePairs(pw85) {
    const uniform = makeUniform(), r12 = [], q1 = [], q2 = [];
    const form = () => {
        const axes = [0, 0, 0].map(() => 0.25 + 2 * uniform());
        return pw85.ellipsoidQuaternion(axes, [1, 0, 0, 0].map(x => uniform() - 0.5 + x));
    };
    for (let i = 0; i < 1000; ++i) {
        for (let k = 0; k < 3; ++k) r12.push(5 * uniform() - 2);
        q1.push(...form());
        q2.push(...form());
    }
    return { r12, q1, q2 };
}

export function bitsOf(x) {
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, x);
    return view.getBigUint64(0).toString(16).padStart(16, "0");
}

/** A line for each row of columns of numbers. */
export function linesOf(...columns) {
    return [...columns[0]].map((_, i) => columns.map(column => bitsOf(column[i])).join(" "));
}

/** The lines for all pairs, by the functions of many rows. */
export function linesOfPairs(pw85, { r12, q1, q2 }) {
    const { mu2, lambda } = pw85.contactRows(r12, q1, q2);
    return linesOf(mu2, lambda, pw85.distanceRows(r12, q1, q2).distance, pw85.overlapVolumeRows(r12, q1, q2));
}
