# SPDX-License-Identifier: GPL-2.0-only
"""Measures the trials per second of fix pw85/hpmc, the parallel efficiency, and what processors send each other.

    python3 hard.py path/to/pw85.in [--ranks 1 2] [--largest 100000] [--trials 4]

Runs hard.in through lmp and mpirun: ellipsoids with axes 1 : 1 : 1.5 that fill 0.4 of space. Prints a table with commas: millions of trials
per second; the time of the first number of ranks times this number, over that of all ranks together; and for each rank its ghosts, and the
megabytes that it receives in a sweep for them: at its start and after each of the eight colours 10 numbers for each ghost, in six messages
or more. LAMMPS itself sends atoms and borders twice in a sweep, as when it builds neighbour lists.
"""

import argparse
import os
import re
import subprocess
from pathlib import Path

CELLS = {864: (6, 6, 6), 9_408: (14, 14, 12), 97_556: (29, 29, 29), 1_000_188: (63, 63, 63)}
SETTINGS = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
NUMBERS_OF_A_GHOST, EXCHANGES = 10, 9


def measure(include, count, ranks, trials, steps):
    """Seconds per sweep, and ghosts of each rank."""
    variables = dict(zip(("nx", "ny", "nz"), CELLS[count]), trials=trials, steps=steps, pw85=include)
    command = ["mpirun", "-n", str(ranks), "lmp", "-log", "none", "-in", str(Path(__file__).parent / "hard.in")]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    text = subprocess.run(command, env={**os.environ, **SETTINGS}, text=True, capture_output=True, check=True).stdout
    loops = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps", text)
    return float(loops[-1][0]) / int(loops[-1][1]), float(re.search(r"Nghost: +(\S+) ave", text).group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--largest", type=int, default=100_000)
    parser.add_argument("--trials", type=int, default=4)
    arguments = parser.parse_args()
    include = Path(arguments.include).resolve()
    print("ellipsoids,ranks,million_trials_per_second,efficiency,ghosts,megabytes")
    for count in (n for n in CELLS if n <= arguments.largest):
        steps = max(4, 200_000 // count)
        for ranks in arguments.ranks:
            # The fastest of three: what else the machine does can only add.
            seconds, ghosts = min(measure(include, count, ranks, arguments.trials, steps) for _ in range(3))
            if ranks == arguments.ranks[0]:
                work = ranks * seconds
            megabytes = 8e-6 * NUMBERS_OF_A_GHOST * EXCHANGES * ghosts
            print(f"{count},{ranks},{1e-6 * arguments.trials * count / seconds:.3g},{work / (ranks * seconds):.2f},{ghosts:.0f},"
                  f"{megabytes:.3g}", flush=True)


if __name__ == "__main__":
    main()
