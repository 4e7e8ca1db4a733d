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
     * Computes the quadratic form of an ellipsoid, Q = R diag(semiAxes²) Rᵀ.
     * @param semiAxes Lengths of the principal semi-axes (not diameters), whose squares are in the range of
     *   double; > 0. 3 numbers.
     * @param rotation Row-major matrix R, which takes the body frame to the space frame; its columns are the
     *   directions of the semi-axes. Each entry of RᵀR - I must be at most 1e-6 in magnitude: single precision is
     *   enough. R may be a reflection. 9 numbers.
     */
    ellipsoid(semiAxes: Numbers, rotation: Numbers): Float64Array;
    /**
     * ellipsoid() of many rows: see {@link Numbers}.
     */
    ellipsoidRows(semiAxes: Numbers, rotation: Numbers): Float64Array;
    ellipsoidRows<Out extends Doubles>(semiAxes: Numbers, rotation: Numbers, out: Out): Out;

    /**
     * Computes the quadratic form of an ellipsoid whose orientation is a quaternion.
     * @param semiAxes Lengths of the principal semi-axes (not diameters), whose squares are in the range of
     *   double; > 0. 3 numbers.
     * @param quaternion (w, x, y, z), scalar first, which rotates the body frame into the space frame; of any
     *   length, because the function normalises it; not zero. 4 numbers.
     */
    ellipsoidQuaternion(semiAxes: Numbers, quaternion: Numbers): Float64Array;
    /**
     * ellipsoidQuaternion() of many rows: see {@link Numbers}.
     */
    ellipsoidQuaternionRows(semiAxes: Numbers, quaternion: Numbers): Float64Array;
    ellipsoidQuaternionRows<Out extends Doubles>(semiAxes: Numbers, quaternion: Numbers, out: Out): Out;

    /**
     * Computes the contact function of two ellipsoids.
     * The method is a third-order iteration on log(λ/(1-λ)), which evaluates f at most 157 times. The relative
     * error of μ² is below 4 u cond, with u = 2⁻⁵³ and the condition number cond of `pw85_condition()` of the C
     * API. The bound also holds for forms that are singular to working precision.
     * @param r12 Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero: then μ² = 0 and λ
     *   = 1/2. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 As `q1`.
     */
    contact(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: number; lambda: number };
    /**
     * contact() of many rows: see {@link Numbers}.
     */
    contactRows(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: Float64Array; lambda: Float64Array };
    contactRows<Out extends { mu2?: Doubles; lambda?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Computes the point at which the ellipsoids, scaled by μ, touch, and their common normal there.
     * @param r12 Vector from the centre of ellipsoid 1 to that of ellipsoid 2; not zero. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 As `q1`.
     * @param lambda The maximiser λ of f, from `contact()`. For another λ in [0, 1] the point is x0(λ) of the
     *   chapter on theory. It is on the surface of ellipsoid 1 scaled by μ1, and on that of ellipsoid 2 scaled by
     *   μ2, where f(λ) = λ μ1² + (1-λ) μ2².
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
     * The answer is exact for the numbers given. Bounds that account for rounding decide almost all pairs, and
     * exact arithmetic decides the others.
     * @param r12 Vector from the centre of ellipsoid 1 to that of ellipsoid 2; zero is an overlap. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 As `q1`.
     */
    overlap(r12: Numbers, q1: Numbers, q2: Numbers): boolean;
    /**
     * overlap() of many rows: see {@link Numbers}.
     */
    overlapRows(r12: Numbers, q1: Numbers, q2: Numbers): Uint8Array;
    overlapRows<Out extends Uint8Array>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Computes the volume V of the intersection of two ellipsoids.
     * V is 0 if the ellipsoids do not overlap, as `overlap()` decides. V is `pw85_volume()` of the C API of the
     * smaller ellipsoid if it is inside the other one, as `pw85_contains()` of the C API decides. Otherwise the
     * error is below u (64 v + 16 s), with u = 2⁻⁵³ and the volume v of the smaller ellipsoid. The term s is
     * Σ|r12_i ∂V/∂r12_i| + Σ √(q1_ii q1_jj) |∂V/∂q1_ij| + Σ √(q2_ii q2_jj) |∂V/∂q2_ij|, summed over coordinates
     * and stored entries, with the derivatives of `pw85_overlap_volume_gradient()` of the C API.
     * If the intersection is as thin as rounding errors, V may be 0. If the part of the smaller ellipsoid outside
     * the other one is as thin as rounding errors, V may be the volume of the smaller ellipsoid.
     * @param r12 Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 As `q1`.
     */
    overlapVolume(r12: Numbers, q1: Numbers, q2: Numbers): number;
    /**
     * overlapVolume() of many rows: see {@link Numbers}.
     */
    overlapVolumeRows(r12: Numbers, q1: Numbers, q2: Numbers): Float64Array;
    overlapVolumeRows<Out extends Doubles>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Computes the distance of the surfaces of two ellipsoids, and the points where they are closest.
     * The distance is the largest value of n·r12 - α - β over unit vectors n, with the half-widths α and β of the
     * ellipsoids along n. Its error is below 8 u Σ, with u = 2⁻⁵³. Here Σ = Σ|n_i r12_i| + Σ|n_i q1_ij
     * n_j|/(2α) + Σ|n_i q2_ij n_j|/(2β), summed over all i and j, with n, α and β at the closest points. Rounding
     * the data entry by entry can change the distance by u Σ.
     * A program can verify the result by a lower and an upper bound. For any unit vector n, n·r12 - α - β is a
     * lower bound of the distance; `distance` is this bound for the normal of `pw85_distance_derivatives()` of
     * the C API. The distance between any point of ellipsoid 1 and any point of ellipsoid 2 is an upper bound,
     * such as |point2 - point1|.
     * Let ε = 2¹⁸ u (|r12| + |point1| + |r12 - point2|). The vector point2 - point1 differs from `distance` times
     * n by less than ε, and the length of this vector differs from `distance` by at most ε. The points are the
     * exact closest points for a pair whose r12 differs by at most ε. Each point is off its surface by less than
     * 2¹⁸ u times the longest semi-axis of its ellipsoid, plus the rounding error u |point2| of its coordinates.
     * @param r12 Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`. 6 numbers.
     * @param q2 As `q1`.
     */
    distance(r12: Numbers, q1: Numbers, q2: Numbers): { distance: number; point1: Float64Array; point2: Float64Array };
    /**
     * distance() of many rows: see {@link Numbers}.
     */
    distanceRows(r12: Numbers, q1: Numbers, q2: Numbers): { distance: Float64Array; point1: Float64Array; point2: Float64Array };
    distanceRows<Out extends { distance?: Doubles; point1?: Doubles; point2?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Computes the time of the first contact of two moving ellipsoids.
     * @param r12 Vector from the centre of ellipsoid 1 to that of ellipsoid 2; at time 0. 3 numbers.
     * @param q1 Forms of the ellipsoids, in the square of the unit of `r12`; at time 0. 6 numbers.
     * @param q2 As `q1`.
     * @param motion1 Motions of the ellipsoids; their semi-axes must be > 0 until tMax. Velocity (3 numbers),
     *   angular velocity (3 numbers), growth of the semi-axes per unit of time. 7 numbers.
     * @param motion2 As `motion1`.
     * @param tMax The last time at which a contact counts; >= 0; may be infinite.
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
     * Computes the quadratic form (xx, xy, yy) of an ellipse.
     * @param a Semi-axes, whose squares are in the range of double; > 0.
     * @param b As `a`.
     * @param angle From the x axis to the first semi-axis, counter-clockwise, in radians.
     */
    ellipse(a: number, b: number, angle: number): Float64Array;
    /**
     * ellipse() of many rows: see {@link Numbers}.
     */
    ellipseRows(a: Numbers | number, b: Numbers | number, angle: Numbers | number): Float64Array;
    ellipseRows<Out extends Doubles>(a: Numbers | number, b: Numbers | number, angle: Numbers | number, out: Out): Out;

    /**
     * Computes the area of the intersection of two ellipses; see `overlapVolume()`.
     * The bound on the error is that of `overlapVolume()`, with areas instead of volumes.
     * @param r12 Vector from the centre of ellipse 1 to that of ellipse 2; it may be zero. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 As `q1`.
     */
    overlapArea2d(r12: Numbers, q1: Numbers, q2: Numbers): number;
    /**
     * overlapArea2d() of many rows: see {@link Numbers}.
     */
    overlapArea2dRows(r12: Numbers, q1: Numbers, q2: Numbers): Float64Array;
    overlapArea2dRows<Out extends Doubles>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Computes the contact function of two ellipses; see `contact()`.
     * @param r12 Vector from the centre of ellipse 1 to that of ellipse 2; it may be zero: then μ² = 0 and λ =
     *   1/2. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 As `q1`.
     */
    contact2d(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: number; lambda: number };
    /**
     * contact2d() of many rows: see {@link Numbers}.
     */
    contact2dRows(r12: Numbers, q1: Numbers, q2: Numbers): { mu2: Float64Array; lambda: Float64Array };
    contact2dRows<Out extends { mu2?: Doubles; lambda?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Computes the point at which the ellipses, scaled by μ, touch, and their common normal there.
     * See `contactGeometry()`.
     * @param r12 Vector from the centre of ellipse 1 to that of ellipse 2; not zero. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 As `q1`.
     * @param lambda The maximiser λ of f, from `contact2d()`. For another λ in [0, 1] the point is x0(λ) of the
     *   chapter on theory. It is on the surface of ellipse 1 scaled by μ1, and on that of ellipse 2 scaled by μ2,
     *   where f(λ) = λ μ1² + (1-λ) μ2².
     */
    contactGeometry2d(r12: Numbers, q1: Numbers, q2: Numbers, lambda: number): { point: Float64Array; normal: Float64Array };
    /**
     * contactGeometry2d() of many rows: see {@link Numbers}.
     */
    contactGeometry2dRows(r12: Numbers, q1: Numbers, q2: Numbers, lambda: Numbers | number): { point: Float64Array; normal: Float64Array };
    contactGeometry2dRows<Out extends { point?: Doubles; normal?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, lambda: Numbers | number, out: Out): Out;

    /**
     * Tests whether two ellipses overlap; see `overlap()`.
     * @param r12 Vector from the centre of ellipse 1 to that of ellipse 2; zero is an overlap. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 As `q1`.
     */
    overlap2d(r12: Numbers, q1: Numbers, q2: Numbers): boolean;
    /**
     * overlap2d() of many rows: see {@link Numbers}.
     */
    overlap2dRows(r12: Numbers, q1: Numbers, q2: Numbers): Uint8Array;
    overlap2dRows<Out extends Uint8Array>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;

    /**
     * Computes the distance of two ellipses; see `distance()`.
     * @param r12 Vector from the centre of ellipse 1 to that of ellipse 2. 2 numbers.
     * @param q1 Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. 3 numbers.
     * @param q2 As `q1`.
     */
    distance2d(r12: Numbers, q1: Numbers, q2: Numbers): { distance: number; point1: Float64Array; point2: Float64Array };
    /**
     * distance2d() of many rows: see {@link Numbers}.
     */
    distance2dRows(r12: Numbers, q1: Numbers, q2: Numbers): { distance: Float64Array; point1: Float64Array; point2: Float64Array };
    distance2dRows<Out extends { distance?: Doubles; point1?: Doubles; point2?: Doubles }>(r12: Numbers, q1: Numbers, q2: Numbers, out: Out): Out;
}
