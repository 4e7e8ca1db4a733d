// SPDX-License-Identifier: BSD-3-Clause
//@ mark

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
    //@ pw85
}

/** The functions of ellipses: see {@link Pw85}. */
export interface Plane extends Memory {
    //@ plane
}
