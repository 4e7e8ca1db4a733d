# SPDX-License-Identifier: GPL-2.0-only
"""Counts the instructions of a contact and step of pair_style pw85/granular, and of LAMMPS's gran/hertz/history for spheres.

    python3 instructions.py path/to/pw85.in

Runs grains.in by valgrind --tool=callgrind, which has no instruction set newer than AVX2, with two numbers of steps, so that what comes
before the first step cancels. Counts depend on the compiler, not on what else the machine does. Prints a table with commas, with a row
for each part of a step.
"""

import argparse
import re
import subprocess
import tempfile
from pathlib import Path

import grains

EDGE, STEPS = 6, (5, 25)
# Parts of a step, and what the names of their functions contain; the first that fits counts.
PARTS = {
    "search of the common normal": ("GrainArrays",),
    "law of force": ("react_avx2",),
    "overlap test of new pairs": ("OverlapArray",),
    "integration, forms of ellipsoids": ("FixNVE", "MathExtra::", "pw85_ellipsoid_quaternion", "pw85_lammps::Ellipsoids"),
    "the rest of the pair style: list, atoms, springs, sums": ("PairGranHertzHistory", "pw85_lammps::"),
    "ghosts and the rest": ("",),
}


def functions(include, style, steps):
    """The instructions of each function of a run."""
    with tempfile.TemporaryDirectory() as directory:
        out = Path(directory, "out")
        program = ("valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "lmp")
        grains.finish(grains.start(include, style, EDGE, EDGE, steps, program=program))
        text = subprocess.run(["callgrind_annotate", "--threshold=100", out], stdout=subprocess.PIPE, text=True, check=True).stdout
    counts = {}
    for count, name in re.findall(r"^ *([\d,]+) \([ \d.]+%\)  (.*)$", text, re.M):
        counts[name] = counts.get(name, 0) + int(count.replace(",", ""))
    return counts


def count_parts(include, style):
    """The instructions of a contact and step, for each part, and all."""
    before, after = (functions(include, style, steps) for steps in STEPS)
    total = after.pop("PROGRAM TOTALS") - before.pop("PROGRAM TOTALS")
    contacts = 4 * EDGE**3 * 6 * (STEPS[1] - STEPS[0])
    parts = dict.fromkeys(PARTS, 0)
    for name, count in after.items():
        part = next(part for part, words in PARTS.items() if any(word in name for word in words))
        parts[part] += count - before.get(name, 0)
    return {**{part: count / contacts for part, count in parts.items()}, "all": total / contacts}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include", type=lambda name: Path(name).resolve())
    include = parser.parse_args().include
    lammps, ellipsoids = (count_parts(include, style) for style in ("lammps", "ellipsoids"))
    print("part,lammps,ellipsoids")
    for part in lammps:
        print(f'"{part}"', f"{lammps[part]:.0f}", f"{ellipsoids[part]:.0f}", sep=",")


if __name__ == "__main__":
    main()
