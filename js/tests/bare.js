// SPDX-License-Identifier: BSD-3-Clause
// Loads the package where there is nothing of Node: in a context with the globals of all runtimes, modules by their addresses, and a fetch()
// if the runtime has one. Prints a number of the library for each. Run by loaders.test.js.
import { readFileSync } from "node:fs";
import vm from "node:vm";

const folder = new URL(".", import.meta.resolve("pw85"));
const read = name => readFileSync(new URL(name, folder));

/** Runs a program in a new context that loads the package from an address. */
async function run(address, program, globals) {
    const requested = [];
    const fetch = async url => {
        requested.push(String(url));
        return { ok: true, arrayBuffer: async () => new Uint8Array(read("pw85.wasm")).buffer };
    };
    const context = vm.createContext({ TextDecoder, URL, ...(globals.hasFetch ? { fetch } : {}), bytes: globals.bytes });
    const nothing = name => { throw new Error(`${name} is imported`); };
    const made = (code, url) => new vm.SourceTextModule(code, {
        context, identifier: url, initializeImportMeta: meta => { meta.url = url; }, importModuleDynamically: nothing,
    });
    const files = { pw85: "pw85.js", "./questions.js": "questions.js" };
    const main = made(program, `${address}main.js`);
    await main.link(name => (name in files ? made(read(files[name]).toString(), address + files[name]) : nothing(name)));
    await main.evaluate();
    console.log(address, String(context.mu2), requested.join());
}

const program = options => `import { load } from "pw85";
const pw85 = await load(${options});
globalThis.mu2 = pw85.contact([3, 0, 0], [1, 0, 0, 1, 0, 1], [1, 0, 0, 1, 0, 1]).mu2;`;
await run("https://127.0.0.1/pw85@3/", program(""), { hasFetch: true });
await run("file:///srv/pw85/", program(""), { hasFetch: true });
await run("app://pw85/", program("{ wasm: bytes }"), { bytes: new Uint8Array(read("pw85.wasm")) });
