#!/usr/bin/python3
"""Instructions per pair on 64-bit ARM, by instruction set, as an emulator counts them: all that can be said of speed without the
processor, and without what its instructions cost.

    measure.py BUILD [ASPECT]

BUILD is a build directory of scripts/cross/aarch64-linux-gnu.ini with -Dgsl=disabled. Needs qemu-aarch64, gcc, and aarch64-linux-gnu-g++. Pairs are those
of bench/speed, of aspect ratio 10 unless stated otherwise.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PAIRS = 4096  # block_size of pairs.hpp
PROCESSORS = {"baseline": "cortex-a72", "neon": "cortex-a72", "sve256": "max,sve256=on", "sve512": "max,sve512=on"}
FUNCTIONS = ["contact_batch", "overlap_batch", "distance_batch", "contact", "overlap"]


def build(build_dir, folder):
    """The plugin and the program that calls the functions."""
    plugin, program = folder / "count.so", folder / "calls"
    subprocess.run(["gcc", "-O2", "-shared", "-fPIC", HERE / "count.c", "-o", plugin], check=True)
    include = [f"-I{path}" for path in (ROOT / "include", build_dir / "include", ROOT / "tests")]
    subprocess.run(["aarch64-linux-gnu-g++", "-std=c++20", "-O2", *include, HERE / "calls.cpp", "-o", program, f"-L{build_dir}/src",
                    "-lpw85_legacy", "-lpw85", f"-Wl,-rpath,{build_dir}/src", f"-Wl,-rpath-link,{build_dir}/src"], check=True)
    return plugin, program


def instructions(plugin, program, target, arguments):
    command = ["qemu-aarch64", "-plugin", plugin, "-L", "/usr/aarch64-linux-gnu", program, *arguments]
    environment = dict(os.environ, PW85_TARGET=target, QEMU_CPU=PROCESSORS[target], OMP_NUM_THREADS="1")
    return int(subprocess.run(command, env=environment, check=True, text=True, stderr=subprocess.PIPE).stderr)


def per_pair(plugin, program, target, function, aspect):
    """By the difference of three calls and one."""
    one, three = (instructions(plugin, program, target, [function, aspect, times]) for times in ("1", "3"))
    return (three - one) / (2 * PAIRS)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    aspect = sys.argv[2] if len(sys.argv) == 3 else "10"
    with tempfile.TemporaryDirectory() as folder:
        plugin, program = build(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(folder))
        print(f"{'aspect ratio ' + aspect:20}" + "".join(f"{target:>10}" for target in PROCESSORS))
        for function in FUNCTIONS:
            counts = [per_pair(plugin, program, target, function, aspect) for target in PROCESSORS]
            print(f"{function:20}" + "".join(f"{count:10.0f}" for count in counts), flush=True)


if __name__ == "__main__":
    main()
