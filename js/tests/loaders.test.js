// SPDX-License-Identifier: BSD-3-Clause
// The package in runtimes without modules of Node, such as Deno, workers at the edge and web views.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

test("modules by address, the library by fetch() or from bytes", () => {
    const program = fileURLToPath(new URL("bare.js", import.meta.url));
    const { stdout, stderr } = spawnSync(process.execPath, ["--experimental-vm-modules", "--no-warnings", program], { encoding: "utf-8" });
    assert.deepEqual([stdout.split("\n"), stderr], [[
        "https://127.0.0.1/pw85@3/ 2.25 https://127.0.0.1/pw85@3/pw85.wasm",
        "file:///srv/pw85/ 2.25 file:///srv/pw85/pw85.wasm",
        "app://pw85/ 2.25 ",
        "",
    ], ""]);
});
