// SPDX-License-Identifier: BSD-3-Clause
// What the types let through, and what they refuse.
import { load, loadPlane, Plane, Pw85Error, Pw85 } from "pw85";

export async function main(): Promise<number> {
    const pw85: Pw85 = await load({ doubles: 100 });
    const q: Float64Array = pw85.ellipsoidQuaternion([3, 2, 1], new Float32Array([1, 0, 0, 0]));
    const both: { mu2: number; lambda: number } = pw85.contact([3, 2, 1], q, q);
    const apart: boolean = pw85.overlap([3, 2, 1], q, q);
    const many: Uint8Array = pw85.overlapRows(new Float64Array(6), q, q);
    const out: { mu2: Float32Array } = pw85.contactRows(pw85.allocate(6), q, q, { mu2: new Float32Array(2) });
    const t: number = pw85.firstContact([9, 0, 0], q, q, new Float64Array(7), new Float64Array(7));
    const times: Float64Array = pw85.firstContactRows([9, 0, 0], q, q, new Float64Array(7), new Float64Array(7), [1, 2]);
    pw85.firstContactRows([9, 0, 0], q, q, new Float64Array(7), new Float64Array(7), undefined, times.subarray(1));
    const plane: Plane = await loadPlane();
    const area: number = plane.overlapArea2d([1, 0], plane.ellipse(2, 1, 0.5), new Float32Array([1, 0, 1]));
    const error: string | null = new Error() instanceof Pw85Error ? (new Error() as Pw85Error).argument : null;
    // @ts-expect-error: strings
    pw85.contact("3", q, q);
    // @ts-expect-error: integers of 64 bits
    pw85.contact(new BigInt64Array(3), q, q);
    // @ts-expect-error: not a result
    pw85.contactRows([3, 2, 1], q, q, { distance: new Float64Array(1) });
    // @ts-expect-error: another type
    pw85.overlapRows([3, 2, 1], q, q, new Float64Array(1));
    return area + both.mu2 + t + times[0] + out.mu2[0] + many[0] + Number(apart) + (error ?? "").length;
}
