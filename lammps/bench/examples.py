# SPDX-License-Identifier: GPL-2.0-only
"""Runs the examples of grains in examples/lammps, and the relaxation, in the forms that docs/lammps.md describes.

    python3 examples.py path/to/pw85.in

Prints what they find as a table with commas. Takes some minutes on one core.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "lammps"
sys.path.append(str(EXAMPLES))
from draw import read_last_snapshot  # noqa: E402
from heap_angle import slope  # noqa: E402
from orifice import write_ring  # noqa: E402

LONG_DRUM = {"radius": 6, "length": 8, "grains": 680, "steps": 40000}
LONG_HEAP = {"width": 30, "depth": 6, "grains": 1200, "top": 14, "fill": 11000, "steps": 20000}
LONG_HOPPER = {"grains": 765, "fill": 6500, "steps": 5000}
SEEDS = 1234, 1, 2, 3, 4


def run(name, include, directory, **variables):
    """What LAMMPS prints in an example, on one rank."""
    command = ["lmp", "-log", "none", "-in", str(EXAMPLES / f"{name}.in"), "-var", "pw85", include]
    for variable, value in variables.items():
        command += ["-var", variable, str(value)]
    done = subprocess.run(command, cwd=directory, env={**os.environ, "OMP_NUM_THREADS": "1"}, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    if done.returncode:
        sys.exit(f"LAMMPS failed: {' '.join(command)}\n{done.stdout[-2000:]}")
    return done.stdout


def number(label, text):
    return re.search(rf"^{label}(\S+)", text, re.MULTILINE).group(1)


def drum(include, directory):
    for form, variables in {"long": LONG_DRUM, "short": {}}.items():
        text = run("drum", include, directory, **variables)
        yield form, "grains", number("grains: ", text)
        yield form, "angle", number("angle of repose in degrees: ", text)


def heap(include, directory):
    forms = {"long": LONG_HEAP, "spheres": {"aspect": 1}, **{f"seed {seed}": {"seed": seed} for seed in SEEDS}}
    for form, variables in forms.items():
        text = run("heap", include, directory, **variables)
        columns = read_last_snapshot(Path(directory, "heap.dump"))[2]
        yield form, "grains", number("grains: ", text)
        yield form, "grains that stay", len(columns["x"])
        yield form, "slope", f"{slope(columns):.1f}"


def hopper(include, directory):
    for hole in 4, 4.5, 5:
        write_ring(hole, 9, Path(directory, "orifice.stl"))
        text = run("hopper", include, directory, hole=hole, **LONG_HOPPER)
        columns = read_last_snapshot(Path(directory, "hopper.dump"))[2]
        yield hole, "grains that leave", int(number("grains: ", text)) - int((columns["z"] > 0).sum())
        for quantity, label in {"density": "density of the filling: ", "flow": "flow of grains: ", "law": "flow by the law: "}.items():
            yield hole, quantity, number(label, text)


def relax(include, directory):
    text = run("relax", include, directory)
    loop = re.search(r"Loop time of (\S+) on \d+ procs for (\d+) steps", text)
    share = re.search(r"^(\S+)% CPU use", text, re.MULTILINE)[1]  # Other programs may have the rest of the core.
    yield "", "steps", loop[2]
    yield "", "seconds", f"{float(loop[1]) * float(share) / 100:.1g}"
    yield "", "overlapping pairs", number("overlapping pairs: ", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include")
    include = str(Path(parser.parse_args().include).resolve())
    print("example,form,quantity,value")
    with tempfile.TemporaryDirectory() as directory:
        for example in (drum, heap, hopper, relax):
            for row in example(include, directory):
                print(example.__name__, *row, sep=",", flush=True)


if __name__ == "__main__":
    main()
