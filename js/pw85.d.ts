// SPDX-License-Identifier: BSD-3-Clause
// Made by api/javascript.py from the headers of the C API.

/**
 * Numbers of one row or of many, row behind row: an array of numbers or a typed array, of any length that
 * is a multiple of the numbers in a row. Integers of 64 bits are refused. Where arguments have several rows,
 * those with one row are repeated. Row i of the results belongs to row i of the arguments.
 */
export type Numbers =
    | readonly number[]
    | Float64Array
    | Float32Array
    | Int8Array
    | Uint8Array
    | Uint8ClampedArray
    | Int16Array
    | Uint16Array
    | Int32Array
    | Uint32Array;

/** Arrays for results that are doubles; those of 32 bits receive rounded numbers. */
export type Doubles = Float64Array | Float32Array;

/** What is wrong with an argument. All functions throw it. */
export class Pw85Error extends Error {
    /** The argument that is refused, if it is one. */
    readonly argument: string | null;
    /** Its row, from 0; null where the function has one row, or if the cause is not one row. */
    readonly row: number | null;
    /** The entry of the row, from 0, if it is one. */
    readonly entry: number | null;
    /** What it must be. */
    readonly requirement: string;
}

export interface Options {
    /** The module, where it is not the file pw85.wasm, or plane.wasm, beside pw85.js: its bytes, or what WebAssembly.compile() made of them. */
    wasm?: BufferSource | WebAssembly.Module;
    /** The numbers that allocate() may give, from 0 (without this option) to 2^28. */
    doubles?: number;
}

/** Loads the functions of ellipsoids. Each call makes an instance with a memory of its own. */
export function load(options?: Options): Promise<Pw85>;

/** Loads the functions of ellipses, which are in a module of their own, plane.wasm: see load(). */
export function loadPlane(options?: Options): Promise<Plane>;

/** The memory of an instance. */
export interface Memory {
    /**
     * An array in the memory of the library. Arguments and results of many rows that are such arrays are not copied.
     * @param length How many numbers it has.
     */
    allocate(length: number): Float64Array;

    /** Takes the memory of all arrays of allocate() back: they must not be used any more. */
    release(): void;
}

/**
 * The functions of ellipsoids. The function with `Rows` behind its name takes many rows. It returns new
 * arrays, or writes to the arrays `out` that are given, and returns these: of several results, those that
 * `out` names. Arrays `out` must not share memory with arguments.
 */
export interface Pw85 extends Memory {
    /**
     * Quadratic form of a general ellipsoid, Q = R diag(semi_axes²) Rᵀ.
     * @param semiAxes Lengths of the principal semi-axes (not diameters), whose squares are in the range of
     *   double; > 0. 3 numbers.
     * @param rotation Matrix R in row-major order. Its columns are the principal directions: R takes the body
     *   frame to the space frame. RᵀR may differ from I by at most 1e-6 in any entry (single precision is
     *   accepted); reflections are accepted. 9 numbers.
     */
    ellipsoid(semiAxes: Numbers, rotation: Numbers): Float64Array;
    /**
     * ellipsoid() of many rows: see {@link Numbers}.
     */
    ellipsoidRows(semiAxes: Numbers, rotation: Numbers): Float64Array;
    ellipsoidRows<Out extends Doubles>(semiAxes: Numbers, rotation: Numbers, out: Out): Out;

    /**
     * Quadratic form of a general ellipsoid whose orientation is a quaternion.
     * @param semiAxes Lengths of the principal semi-axes (not diameters), whose squares are in the range of
     *   double; > 0. 3 numbers.
     * @param quaternion (w, x, y, z), scalar first, of any length; the function normalises it. It takes the body
     *   frame to the space frame; not zero. 4 numbers.
     */
    ellipsoidQuaternion(semiAxes: Numbers, quaternion: Numbers): Float64Array;
    /**
     * ellipsoidQuaternion() of many rows: see {@link Numbers}.
     */
    ellipsoidQuaternionRows(semiAxes: Numbers, quaternion: Numbers): Float64Array;
    ellipsoidQuaternionRows<Out extends Doubles>(semiAxes: Numbers, quaternion: Numbers, out: Out): Out;

    /**
     * Contact function of two ellipsoids, by a third-order iteration on log(λ/(1-λ)).
     * The relative error of μ² is below 4 u cond, with u = 2⁻⁵³ and the entrywise condition number of
     * `pw85_condition()` of the C API, also for forms that are singular to working precision. The function
     * evaluates f at most 157 times.
     * @param r12 From the centre of ellipsoid 1 to that of ellipsoid 2; zero is valid: μ² = 0, λ = 1/2. 3
     *   numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     */
    contact(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: number; lambda: number };
    /**
     * contact() of many rows: see {@link Numbers}.
     */
    contactRows(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: Float64Array; lambda: Float64Array };
    contactRows<Out extends { mu2?: Doubles; lambda?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Point at which the ellipsoids, scaled by μ, touch, and their common normal.
     * @param r12 From the centre of ellipsoid 1 to that of ellipsoid 2; not zero. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param lambda From `contact()`. Any other value in (0, 1) gives the point x0(λ) of the chapter on theory:
     *   it is on both ellipsoids when they are scaled by the factors μ1 and μ2 for which f(λ) = λ μ1² + (1-λ)
     *   μ2².
     */
    contactGeometry(r12: Numbers, q1: Numbers, q2: Numbers, lambda: number): { point: Float64Array; normal: Float64Array };
    /**
     * contactGeometry() of many rows: see {@link Numbers}.
     */
    contactGeometryRows(r12: Numbers, q1: Numbers, q2: Numbers, lambda: Numbers | number): { point: Float64Array; normal: Float64Array };
    contactGeometryRows<Out extends { point?: Doubles; normal?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, lambda: Numbers | number, out: Out): Out;

    /**
     * Tests whether two ellipsoids overlap, μ² < 1.
     * Tangent ellipsoids (μ² = 1) do not overlap.
     * The answer is exact for the numbers given. Bounds that account for rounding decide almost all pairs; exact
     * arithmetic decides the others.
     * @param r12 From the centre of ellipsoid 1 to that of ellipsoid 2; zero is an overlap. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     */
    overlap(r12: Numbers, q1: Numbers, q2: Numbers): boolean;
    /**
     * overlap() of many rows: see {@link Numbers}.
     */
    overlapRows(r12: Numbers, q1: Numbers, q2: Numbers): Uint8Array;
    overlapRows<Out extends Uint8Array>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Volume of the common part of two ellipsoids.
     * The volume is 0 exactly if `overlap()` says that the ellipsoids do not overlap. It is `pw85_volume()` of
     * the C API of the smaller ellipsoid exactly if `pw85_contains()` of the C API says that this one is inside
     * the other one. Otherwise the error is below u (64 v + 16 s), with u = 2⁻⁵³, the volume v of the smaller
     * one, and s = Σ|r12_i ∂V/∂r12_i| + Σ √(q1_ii q1_jj) |∂V/∂q1_ij| + the same sum for q2, over the entries and
     * derivatives of `pw85_overlap_volume_gradient()` of the C API. If the common part, or what remains of the
     * smaller ellipsoid, is as thin as rounding errors, it may count as empty: the volume is then 0, or that of
     * the smaller ellipsoid.
     * @param r12 From the centre of ellipsoid 1 to that of ellipsoid 2; zero is valid. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     */
    overlapVolume(r12: Numbers, q1: Numbers, q2: Numbers): number;
    /**
     * overlapVolume() of many rows: see {@link Numbers}.
     */
    overlapVolumeRows(r12: Numbers, q1: Numbers, q2: Numbers): Float64Array;
    overlapVolumeRows<Out extends Doubles>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Distance of the surfaces of two ellipsoids, and the points where they are closest.
     * The error of the distance is below 8 u Σ, with u = 2⁻⁵³ and Σ = Σ|n_i r12_i| + Σ|n_i q1_ij n_j|/(2α) +
     * Σ|n_i q2_ij n_j|/(2β), the sums over all i and j. Rounding the data entry by entry can change the distance
     * by u Σ. Here n is the unit normal, and α and β are the half-widths of the ellipsoids along it. The answer
     * can be checked independently: any unit vector n gives a lower bound n·r12 - α - β of the distance, and any
     * two points of the ellipsoids give an upper bound. `distance` is the lower bound for the normal that
     * `pw85_distance_derivatives()` of the C API returns, and |point2 - point1| is an upper bound.
     * The vector point2 - point1 differs from `distance` times n by less than 2¹⁸ u (|r12| + |point1| + |r12 -
     * point2|), and |point2 - point1| differs from `distance` by no more than that. The points are the closest
     * points of a pair whose r12 differs by no more than that. The distance of each point from the surface is
     * below 2¹⁸ u times the longest semi-axis of its ellipsoid, plus the rounding error u |point2| of its
     * coordinates.
     * @param r12 From the centre of ellipsoid 1 to that of ellipsoid 2. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     */
    distance(r12: Numbers, q1: Numbers, q2: Numbers): { distance: number; point1: Float64Array; point2: Float64Array };
    /**
     * distance() of many rows: see {@link Numbers}.
     */
    distanceRows(r12: Numbers, q1: Numbers, q2: Numbers): { distance: Float64Array; point1: Float64Array; point2: Float64Array };
    distanceRows<Out extends { distance?: Doubles; point1?: Doubles; point2?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Time of the first contact of two moving ellipsoids.
     * @param r12 From the centre of ellipsoid 1 to that of ellipsoid 2; at time 0. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`; at time 0. 6 numbers.
     * @param q2 Forms of the ellipsoids, in the square of the unit of `r12`; at time 0. 6 numbers.
     * @param motion1 Motions of the ellipsoids, whose semi-axes must be > 0 until t_max. Velocity (3 numbers),
     *   angular velocity (3 numbers), growth of the semi-axes per unit of time. 7 numbers.
     * @param motion2 Motions of the ellipsoids, whose semi-axes must be > 0 until t_max. Velocity (3 numbers),
     *   angular velocity (3 numbers), growth of the semi-axes per unit of time. 7 numbers.
     * @param tMax The time up to which contacts count; >= 0; may be infinite.
     */
    firstContact(r12: Numbers, q1: Numbers, q2: Numbers, motion1: Numbers, motion2: Numbers, tMax?: number): number;
    /**
     * firstContact() of many rows: see {@link Numbers}.
     */
    firstContactRows(r12: Numbers, q1: Numbers, q2: Numbers, motion1: Numbers, motion2: Numbers, tMax?: Numbers | number): Float64Array;
    firstContactRows<Out extends Doubles>(r12: Numbers, q1: Numbers, q2: Numbers, motion1: Numbers, motion2: Numbers, tMax: Numbers | number | undefined, out: Out): Out;
}

/** The functions of ellipses: see {@link Pw85}. */
export interface Plane extends Memory {
    /**
     * Quadratic form (xx, xy, yy) of an ellipse.
     * @param a Semi-axes, whose squares are in the range of double; > 0.
     * @param b Semi-axes, whose squares are in the range of double; > 0.
     * @param angle From the x axis to the first semi-axis, counter-clockwise, in radians.
     */
    ellipse(a: number, b: number, angle: number): Float64Array;
    /**
     * ellipse() of many rows: see {@link Numbers}.
     */
    ellipseRows(a: Numbers | number, b: Numbers | number, angle: Numbers | number): Float64Array;
    ellipseRows<Out extends Doubles>(a: Numbers | number, b: Numbers | number, angle: Numbers | number, out: Out): Out;

    /**
     * Area of the common part of two ellipses; see `overlapVolume()`.
     * The bound on the error is the same, with areas.
     * @param r12 From the centre of ellipse 1 to that of ellipse 2; zero is valid. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     */
    overlapArea2d(r12: Numbers, q1: Numbers, q2: Numbers): number;
    /**
     * overlapArea2d() of many rows: see {@link Numbers}.
     */
    overlapArea2dRows(r12: Numbers, q1: Numbers, q2: Numbers): Float64Array;
    overlapArea2dRows<Out extends Doubles>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Contact function of two ellipses; see `contact()`.
     * @param r12 From the centre of ellipse 1 to that of ellipse 2; zero is valid: μ² = 0, λ = 1/2. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     */
    contact2d(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: number; lambda: number };
    /**
     * contact2d() of many rows: see {@link Numbers}.
     */
    contact2dRows(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: Float64Array; lambda: Float64Array };
    contact2dRows<Out extends { mu2?: Doubles; lambda?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Point at which the ellipses, scaled by μ, touch, and their common normal; see `contactGeometry()`.
     * @param r12 From the centre of ellipse 1 to that of ellipse 2; not zero. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param lambda From `contact()`. Any other value in (0, 1) gives the point x0(λ) of the chapter on theory:
     *   it is on both ellipses when they are scaled by the factors μ1 and μ2 for which f(λ) = λ μ1² + (1-λ) μ2².
     */
    contactGeometry2d(r12: Numbers, q1: Numbers, q2: Numbers, lambda: number): { point: Float64Array; normal: Float64Array };
    /**
     * contactGeometry2d() of many rows: see {@link Numbers}.
     */
    contactGeometry2dRows(r12: Numbers, q1: Numbers, q2: Numbers, lambda: Numbers | number): { point: Float64Array; normal: Float64Array };
    contactGeometry2dRows<Out extends { point?: Doubles; normal?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, lambda: Numbers | number, out: Out): Out;

    /**
     * Tests whether two ellipses overlap; see `overlap()`.
     * @param r12 From the centre of ellipse 1 to that of ellipse 2; zero is an overlap. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     */
    overlap2d(r12: Numbers, q1: Numbers, q2: Numbers): boolean;
    /**
     * overlap2d() of many rows: see {@link Numbers}.
     */
    overlap2dRows(r12: Numbers, q1: Numbers, q2: Numbers): Uint8Array;
    overlap2dRows<Out extends Uint8Array>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Distance of two ellipses; see `distance()`.
     * @param r12 From the centre of ellipse 1 to that of ellipse 2. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     */
    distance2d(r12: Numbers, q1: Numbers, q2: Numbers): { distance: number; point1: Float64Array; point2: Float64Array };
    /**
     * distance2d() of many rows: see {@link Numbers}.
     */
    distance2dRows(r12: Numbers, q1: Numbers, q2: Numbers): { distance: Float64Array; point1: Float64Array; point2: Float64Array };
    distance2dRows<Out extends { distance?: Doubles; point1?: Doubles; point2?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;
}
