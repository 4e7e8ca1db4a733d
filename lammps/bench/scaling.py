# SPDX-License-Identifier: GPL-2.0-only
"""Measures the time per ellipsoid and per pair of each style, and the parallel efficiency.

    python3 scaling.py path/to/pw85.in [--ranks 1 2] [--largest 256000]

Runs ellipsoids.in through lmp and mpirun. The time is that of a step in which LAMMPS does nothing but run the compute
(overlap, contact), or a step of molecular dynamics with the soft potential (soft). Prints a table with commas: pairs of the neighbour list
and nanoseconds of a step for each ellipsoid, and the time of the first number of ranks times this number, over that of all ranks together.
"""

import argparse
import os
import re
import subprocess
from pathlib import Path

EDGES = {1_000: (10, 10, 10), 10_000: (20, 20, 25), 100_000: (40, 50, 50), 256_000: (40, 80, 80)}
SETTINGS = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}


def measure(include, style, count, ranks, steps):
    """Seconds per step, and pairs in the neighbour list."""
    variables = dict(zip(("nx", "ny", "nz"), EDGES[count]), style=style, steps=steps, pw85=include)
    command = ["mpirun", "-n", str(ranks), "lmp", "-log", "none", "-in", str(Path(__file__).parent / "ellipsoids.in")]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    text = subprocess.run(command, env={**os.environ, **SETTINGS}, text=True, capture_output=True, check=True).stdout
    loops = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps", text)
    return float(loops[-1][0]) / int(loops[-1][1]), int(re.search(r"Total # of neighbors = (\d+)", text).group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--largest", type=int, default=256_000)
    arguments = parser.parse_args()
    include = Path(arguments.include).resolve()
    print("style,ellipsoids,ranks,pairs,ns,efficiency")
    for style in ("overlap", "contact", "soft"):
        for count in (n for n in EDGES if n <= arguments.largest):
            steps = max(5, 1_000_000 // count)
            for ranks in arguments.ranks:
                # The fastest of three: what else the machine does can only add.
                seconds, pairs = min(measure(include, style, count, ranks, steps) for _ in range(3))
                if ranks == arguments.ranks[0]:
                    work = ranks * seconds
                print(f"{style},{count},{ranks},{pairs / count:.3g},{1e9 * seconds / count:.3g},{work / (ranks * seconds):.2f}", flush=True)


if __name__ == "__main__":
    main()
