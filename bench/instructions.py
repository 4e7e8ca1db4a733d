#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts instructions per pair on 64-bit ARM by an emulator, for each instruction set. Without such a processor, speed cannot be
measured otherwise; the cost of an instruction is not taken into account. The table goes to docs/measurements.json.

Usage: instructions.py BUILD, a build directory of scripts/cross/aarch64-linux-gnu.ini with -Dgsl=disabled. Needs qemu-aarch64, gcc
and aarch64-linux-gnu-g++. Pairs are those of bench/speed.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

import measure

HERE = pathlib.Path(__file__).resolve().parent / "instructions"
ROOT = measure.ROOT
CROSS = "aarch64-linux-gnu-g++"
ASPECT = "10"
PAIRS = 4096  # block_size of pairs.hpp
PROCESSORS = {"baseline": "cortex-a72", "neon": "cortex-a72", "sve256": "max,sve256=on", "sve512": "max,sve512=on"}
FUNCTIONS = ["contact_batch", "overlap_batch", "distance_batch", "contact", "overlap"]


def build(build_dir, folder):
    """The plugin and the program that calls the functions."""
    plugin, program = folder / "count.so", folder / "calls"
    subprocess.run(["gcc", "-O2", "-shared", "-fPIC", HERE / "count.c", "-o", plugin], check=True)
    include = [f"-I{path}" for path in (ROOT / "include", build_dir / "include", ROOT / "tests")]
    subprocess.run([CROSS, "-std=c++20", "-O2", *include, HERE / "calls.cpp", "-o", program, f"-L{build_dir}/src",
                    "-lpw85_legacy", "-lpw85", f"-Wl,-rpath,{build_dir}/src", f"-Wl,-rpath-link,{build_dir}/src"], check=True)
    return plugin, program


def instructions(plugin, program, target, arguments):
    command = ["qemu-aarch64", "-plugin", plugin, "-L", "/usr/aarch64-linux-gnu", program, *arguments]
    environment = dict(os.environ, PW85_TARGET=target, QEMU_CPU=PROCESSORS[target], OMP_NUM_THREADS="1")
    return int(subprocess.run(command, env=environment, check=True, text=True, stderr=subprocess.PIPE).stderr)


def per_pair(plugin, program, target, function):
    """Instructions per pair, from the difference between three calls and one call."""
    one, three = (instructions(plugin, program, target, [function, ASPECT, times]) for times in ("1", "3"))
    return round((three - one) / (2 * PAIRS))


def rows(build_dir):
    with tempfile.TemporaryDirectory() as folder:
        plugin, program = build(build_dir, pathlib.Path(folder))
        return [{"function": function, **{target: per_pair(plugin, program, target, function) for target in PROCESSORS}}
                for function in FUNCTIONS]


def version_of(program):
    text = subprocess.run([program, "--version"], check=True, text=True, stdout=subprocess.PIPE).stdout
    return f"{program} {re.search(r'[0-9]+[.][0-9.]+[0-9]', text)[0]}"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    version = re.search(r"version: '(.*)'", (ROOT / "meson.build").read_text(encoding="utf-8"))[1]
    measure.put_apart("instructions", rows(pathlib.Path(sys.argv[1]).resolve()),
                      measure.conditions_of({"pw85": version, "compiler": version_of(CROSS), "num_cpus": 1},
                                            machine=version_of("qemu-aarch64")))


if __name__ == "__main__":
    main()
