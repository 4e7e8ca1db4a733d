// SPDX-License-Identifier: BSD-3-Clause
// Questions of ellipsoids and ellipses, answered by the C library in WebAssembly. The functions are those of the tables in questions.js.
// Here their arguments are read, the functions of C are called for blocks of rows, and the results are returned. pw85.d.ts documents
// everything.
import { PLANE, PW85 } from "./questions.js";

// Rows of a block. Arrays outside of the memory of the module are copied block by block, so that any number of rows takes little of it.
const BLOCK = 256;
const PAGE = 65536;
const MOST_DOUBLES = 2 ** 28;
const OPTIONS = ["wasm", "doubles"];
const TYPES = { f64: Float64Array, i32: Int32Array, u8: Uint8Array };
// Numbers of 4 bytes in a pw85_error: status, function, argument, requirement, row, entry, and the value, which has 8 bytes.
const WORDS_OF_ERROR = 8;

export class Pw85Error extends Error {
    constructor(argument, row, entry, requirement) {
        const places = [argument ?? [], row === null ? [] : `row ${row}`, entry === null ? [] : `entry ${entry}`].flat();
        super(places.length > 0 ? `${places.join(", ")}: ${requirement}` : requirement);
        Object.assign(this, { name: "Pw85Error", argument, row, entry, requirement });
    }
}

function refuse(argument, requirement, row = null, entry = null) {
    throw new Pw85Error(argument, row, entry, requirement);
}

/** What a value is, for messages. */
function kindOf(value) {
    if (value === null || typeof value !== "object") return value === null ? "null" : typeof value;
    return value.constructor?.name ?? "object";
}

/** Whether a value is a typed array whose elements are numbers, as those of 64-bit integers are not. */
function isTyped(value) {
    return ArrayBuffer.isView(value) && !(value instanceof DataView || value instanceof BigInt64Array || value instanceof BigUint64Array);
}

/** Refuses a typed array whose memory is gone, because it was transferred, for example to a worker. Its length is 0. */
function checkAttached(name, value) {
    if (value.length > 0) return;
    try {
        new Uint8Array(value.buffer);
    } catch {
        refuse(name, "must not be detached: its memory was transferred");
    }
}

/** Returns how many rows an argument has. A number is a row of one number. */
function countRows({ name, size }, value) {
    if (typeof value === "number" && size === 1) return 1;
    if (!Array.isArray(value) && !isTyped(value)) {
        refuse(name, `must be ${size === 1 ? "a number or " : ""}an array of numbers, not ${kindOf(value)}`);
    }
    if (isTyped(value)) checkAttached(name, value);
    if (Array.isArray(value[0]) || isTyped(value[0])) refuse(name, "must be one array of numbers, row after row, not an array of arrays");
    if (value.length % size !== 0) refuse(name, `must have ${size} numbers in each row, and has ${value.length} in all`);
    return value.length / size;
}

/** Returns the number of rows of all arguments, of which those with one row are repeated. */
function commonRows(inputs, rows) {
    const first = rows.findIndex(count => count !== 1), n = first < 0 ? 1 : rows[first];
    rows.forEach((count, k) => {
        if (count !== 1 && count !== n) refuse(inputs[k].name, `must have 1 row or ${n} rows, as ${inputs[first].name}, and has ${count}`);
    });
    return n;
}

/** Copies the elements of an array of JavaScript, which may be anything, to `to`, where they begin at `at`. */
function copyElements({ name, size }, value, from, count, to, at, isOne) {
    for (let k = from; k < from + count; ++k) {
        const x = value[k];
        if (typeof x !== "number") {
            refuse(name, `must be a number, not ${kindOf(x)}`, isOne ? null : Math.floor(k / size), size === 1 ? null : k % size);
        }
        to[at + k - from] = x;
    }
}

/** Copies `count` numbers of an argument from the index `from` on. Few are faster one by one. */
function copyNumbers(input, value, from, count, to, at, isOne) {
    if (typeof value === "number") {
        to[at] = value;
    } else if (Array.isArray(value)) {
        copyElements(input, value, from, count, to, at, isOne);
    } else if (count > 32) {
        to.set(value.subarray(from, from + count), at);
    } else {
        for (let k = 0; k < count; ++k) to[at + k] = value[from + k];
    }
}

/** Whether two typed arrays have bytes in common. */
function shareBytes(x, y) {
    return x.buffer === y.buffer && x.byteOffset < y.byteOffset + y.byteLength && y.byteOffset < x.byteOffset + x.byteLength;
}

/** The memory of a module: the numbers of a block, a pw85_error, and the arrays that the caller allocates. It never grows again. */
class Memory {
    constructor(memory, questions, doubles) {
        const numbersOf = ({ inputs, outputs }) => [...inputs, ...outputs].reduce((sum, one) => sum + one.size, 0);
        const block = BLOCK * Math.max(...questions.map(numbersOf));
        const bytes = 8 * (block + doubles) + 4 * WORDS_OF_ERROR;
        this.block = memory.grow(Math.ceil(bytes / PAGE)) * PAGE;
        this.error = this.block + 8 * block;
        this.start = this.free = this.error + 4 * WORDS_OF_ERROR;
        this.end = this.start + 8 * doubles;
        this.buffer = memory.buffer;
        for (const [name, Type] of Object.entries(TYPES)) this[name] = new Type(this.buffer);
    }

    allocate(length) {
        const left = (this.end - this.free) / 8;
        if (!Number.isInteger(length) || length < 0) refuse("length", `must be an integer >= 0, not ${String(length)}`);
        if (length > left) refuse("length", `must be at most ${left}: load() reserves memory for allocate()`);
        const made = new Float64Array(this.buffer, this.free, length);
        this.free += 8 * length;
        return made;
    }

    release() {
        this.free = this.start;
    }

    /** The address of an array if it is in this memory, and otherwise null. */
    addressOf(value, type) {
        return value instanceof TYPES[type] && value.buffer === this.buffer ? value.byteOffset : null;
    }

    text(address) {
        return address === 0 ? null : new TextDecoder().decode(this.u8.subarray(address, this.u8.indexOf(0, address)));
    }
}

/** A function for one row, one(), and its relative for many, rows(). */
class Question {
    constructor(exports, memory, table) {
        Object.assign(this, table, { exports, memory, call: exports[table.function] });
        let end = memory.block;
        const placeOf = ({ size }) => (end += 8 * BLOCK * size) - 8 * BLOCK * size;
        this.places = table.inputs.map(placeOf); // in a block
        this.results = table.outputs.map(placeOf);
        this.given = [...this.places, ...this.results];
    }

    one(values) {
        const { inputs, outputs, memory, places, results } = this;
        this.complete(values, inputs.length, this.name);
        for (let k = 0; k < inputs.length; ++k) {
            const count = countRows(inputs[k], values[k]);
            if (count !== 1) refuse(inputs[k].name, `must have 1 row, and has ${count}: see ${this.name}Rows()`);
            copyNumbers(inputs[k], values[k], 0, inputs[k].size, memory.f64, places[k] / 8, true);
        }
        const status = this.isOfRows ? this.call(1, ...this.given) : this.call(...this.argumentsOf(0, places, results));
        if (status !== 0) this.refuseLast(status, 0, places, () => null);
        return this.named(k => this.resultOf(outputs[k], results[k]));
    }

    /** A result of one row. */
    resultOf({ size, type, isTruth, shape }, address) {
        const numbers = this.memory[type], at = address / TYPES[type].BYTES_PER_ELEMENT;
        if (!shape) return isTruth ? numbers[at] !== 0 : numbers[at];
        const found = new TYPES[type](size); // slice() takes longer
        for (let k = 0; k < size; ++k) found[k] = numbers[at + k];
        return found;
    }

    rows(values) {
        const { inputs, outputs, memory } = this, out = values[inputs.length];
        this.complete(values, inputs.length + 1, `${this.name}Rows`);
        const rows = inputs.map((input, k) => countRows(input, values[k])), n = commonRows(inputs, rows);
        const targets = out === undefined ? outputs.map(({ size, type }) => new TYPES[type](size * n)) : this.targetsOf(out, n, values);
        const inside = outputs.map(({ type }, k) => memory.addressOf(targets[k], type));
        for (let from = 0; from < n; from += BLOCK) {
            const count = Math.min(BLOCK, n - from);
            const places = inputs.map((input, k) => this.readRows(k, values[k], rows[k] < n, from, count));
            const results = outputs.map(({ size, type }, k) =>
                inside[k] === null ? this.results[k] : inside[k] + TYPES[type].BYTES_PER_ELEMENT * size * from);
            this.compute(count, places, results, (status, row) => this.refuseLast(status, row, places, i => from + i));
            outputs.forEach(({ size, type }, k) => {
                if (targets[k] === undefined || inside[k] !== null) return;
                const at = results[k] / TYPES[type].BYTES_PER_ELEMENT;
                targets[k].set(memory[type].subarray(at, at + size * count), size * from);
            });
        }
        return out === undefined ? this.named(k => targets[k]) : out;
    }

    /** Refuses more arguments than there are, and adds the one that may be missing. */
    complete(values, most, name) {
        const last = this.inputs.length - 1;
        if (values.length > most) refuse(null, `${name}() takes at most ${most} arguments, not ${values.length}`);
        if (this.inputs[last].name === "tMax") values[last] ??= Infinity;
    }

    /** Returns the address of `count` rows of an argument. They are copied unless they are in the memory of the module. */
    readRows(k, value, isRepeated, from, count) {
        const input = this.inputs[k], { size } = input, { memory } = this, at = this.places[k] / 8;
        const address = isRepeated ? null : memory.addressOf(value, "f64");
        if (address !== null) return address + 8 * size * from;
        if (!isRepeated) {
            copyNumbers(input, value, size * from, size * count, memory.f64, at, false);
        } else if (from === 0) { // the first block has the most rows
            copyNumbers(input, value, 0, size, memory.f64, at, false);
            for (let i = size; i < size * count; ++i) memory.f64[at + i] = memory.f64[at + i - size];
        }
        return this.places[k];
    }

    /** Calls the function of C for all rows, or for each of them. `refused` is called with a status that is not 0 and the first row. */
    compute(count, places, results, refused) {
        if (this.isOfRows) {
            const status = this.call(count, ...places, ...results);
            if (status !== 0) refused(status, 0);
            return;
        }
        for (let i = 0; i < count; ++i) {
            const status = this.call(...this.argumentsOf(i, places, results));
            if (status !== 0) refused(status, i);
        }
    }

    /** The arguments of a function of C of one row. */
    argumentsOf(i, places, results) {
        const { f64 } = this.memory;
        const given = this.inputs.map(({ size, isNumber }, k) => (isNumber ? f64[places[k] / 8 + i] : places[k] + 8 * size * i));
        return [...given, ...this.outputs.map(({ size, type }, k) => results[k] + TYPES[type].BYTES_PER_ELEMENT * size * i)];
    }

    /** Throws what pw85_last_error() says. `rowOf` gives the row for messages by that in the block. */
    refuseLast(status, first, places, rowOf) {
        const { inputs, memory, exports } = this, at = memory.error / 4;
        exports.pw85_last_error(memory.error);
        const [isKnown, argument, requirement, row, entry] = memory.i32.subarray(at + 1, at + 6), value = memory.f64[at / 2 + 3];
        const text = memory.text(isKnown ? requirement : exports.pw85_strerror(status)), name = memory.text(argument);
        const k = isKnown ? inputs.findIndex(one => one.cName === name) : -1;
        if (k < 0) refuse(null, text, rowOf(first + row));
        const isOfEntry = inputs[k].size > 1 &&
            !(Number.isNaN(value) && Number.isFinite(memory.f64[places[k] / 8 + inputs[k].size * (first + row) + entry]));
        refuse(inputs[k].name, text, rowOf(first + row), isOfEntry ? entry : null);
    }

    /** Returns the one result, of(0), itself, or several by their names. */
    named(of) {
        const { outputs } = this, found = {};
        if (outputs.length === 1) return of(0);
        for (let k = 0; k < outputs.length; ++k) found[outputs[k].name] = of(k);
        return found;
    }

    /** The arrays that the caller gives for results, in the order of the outputs; undefined where there is none. */
    targetsOf(out, n, values) {
        const { outputs } = this, names = outputs.map(one => one.name), isAlone = names.length === 1;
        if (!isAlone && (kindOf(out) !== "Object" && Object.getPrototypeOf(Object(out)) !== null)) {
            refuse("out", `must be an object with some of the arrays ${names.join(", ")}, not ${kindOf(out)}`);
        }
        for (const name of isAlone ? [] : Object.keys(out)) {
            if (!names.includes(name)) refuse(`out.${name}`, `is not a result: these are ${names.join(", ")}`);
        }
        const targets = names.map(name => (isAlone ? out : out[name])), labels = names.map(name => (isAlone ? "out" : `out.${name}`));
        targets.forEach((target, k) => target !== undefined && checkTarget(outputs[k], labels[k], target, n));
        targets.forEach((target, k) => target !== undefined && this.checkShared(labels, targets, k, values));
        return targets;
    }

    /** Refuses an array for results that shares memory with another array of the call, which would change while it is read. */
    checkShared(labels, targets, k, values) {
        const input = values.slice(0, this.inputs.length).findIndex(one => isTyped(one) && shareBytes(one, targets[k]));
        if (input >= 0) refuse(labels[k], `must not share memory with ${this.inputs[input].name}`);
        const other = targets.findIndex((one, j) => j < k && one !== undefined && shareBytes(one, targets[k]));
        if (other >= 0) refuse(labels[k], `must not share memory with ${labels[other]}`);
    }
}

/** Refuses an array for results of another type or length. */
function checkTarget({ size, type }, label, target, n) {
    const isFloat = type === "f64" && target instanceof Float32Array;
    if (!isFloat && !(target instanceof TYPES[type])) {
        refuse(label, `must be a ${TYPES[type].name}${type === "f64" ? " or Float32Array" : ""}, not ${kindOf(target)}`);
    }
    checkAttached(label, target);
    if (target.length !== n * size) refuse(label, `must have ${n * size} elements, not ${target.length}`);
}

async function bytesAt(url) {
    if (url.protocol === "file:" && globalThis.process?.versions?.node) { // fetch() of Node knows no files
        const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs/promises");
        return readFile(url);
    }
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: status ${response.status}`);
    return response.arrayBuffer();
}

/** Returns a function that compiles a module once, and again after a failure. addressOf() gives its address. */
function compiledOnce(addressOf) {
    let own = null;
    return () => {
        own ??= bytesAt(addressOf()).then(bytes => WebAssembly.compile(bytes)).catch(error => {
            own = null;
            throw error;
        });
        return own;
    };
}

/** The module that the caller gives. */
async function givenModule(wasm) {
    if (wasm instanceof WebAssembly.Module) return wasm;
    if (!ArrayBuffer.isView(wasm) && !/Buffer\]$/.test(Object.prototype.toString.call(wasm))) {
        refuse("wasm", `must be the bytes of a module or a compiled module, not ${kindOf(wasm)}`);
    }
    return WebAssembly.compile(wasm);
}

/** Refuses a module with other functions. */
function checkModule(exports, questions) {
    const missing = questions.find(one => !(one.function in exports));
    if (missing) refuse("wasm", `must be the module with ${missing.function}()`);
}

/** Refuses options that do not exist. */
function checkOptions(options) {
    if (kindOf(options).toLowerCase() !== "object") {
        refuse("options", `must be an object with some of ${OPTIONS.join(", ")}, not ${kindOf(options)}`);
    }
    for (const name of Object.keys(options)) {
        if (!OPTIONS.includes(name)) refuse(`options.${name}`, `is not an option: these are ${OPTIONS.join(", ")}`);
    }
}

/** Returns load() for a table of questions, whose own module ownModule() compiles. */
function loadOf(questions, ownModule) {
    return async (options = {}) => {
        checkOptions(options);
        const { wasm, doubles = 0 } = options;
        if (!Number.isInteger(doubles) || doubles < 0 || doubles > MOST_DOUBLES) {
            refuse("doubles", `must be an integer from 0 to ${MOST_DOUBLES}, not ${String(doubles)}`);
        }
        const { exports } = await WebAssembly.instantiate(await (wasm === undefined ? ownModule() : givenModule(wasm)));
        checkModule(exports, questions);
        const memory = new Memory(exports.memory, questions, doubles);
        const functions = questions.flatMap(table => {
            const question = new Question(exports, memory, table);
            return [[table.name, (...values) => question.one(values)], [`${table.name}Rows`, (...values) => question.rows(values)]];
        });
        const own = { allocate: length => memory.allocate(length), release: () => memory.release() };
        return Object.freeze({ ...own, ...Object.fromEntries(functions) });
    };
}

export const load = loadOf(PW85, compiledOnce(() => new URL("pw85.wasm", import.meta.url)));
export const loadPlane = loadOf(PLANE, compiledOnce(() => new URL("plane.wasm", import.meta.url)));
