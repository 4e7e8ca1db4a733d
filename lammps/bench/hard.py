# SPDX-License-Identifier: GPL-2.0-only
"""Measures the trials per second of fix pw85/hpmc, the parallel efficiency, and what processors send each other.

    python3 hard.py path/to/pw85.in [--ranks 1 2] [--largest 100000] [--trials 4]

Runs hard.in through lmp and mpirun: ellipsoids with axes 1 : 1 : 1.5 that fill 0.4 of space. Prints a table with commas: millions of trials
per second; the time of the first number of ranks times this number, over that of all ranks together; and for each rank its ghosts, and the
megabytes that it receives in a sweep for them: at its start and after each of the eight colours 10 numbers for each ghost, in six messages
or more. LAMMPS itself sends atoms and borders twice in a sweep, as when it builds neighbour lists.
"""

import runs

CELLS = {864: (6, 6, 6), 9_408: (14, 14, 12), 97_556: (29, 29, 29), 1_000_188: (63, 63, 63)}
NUMBERS_OF_A_GHOST, EXCHANGES = 10, 9


def main():
    parser = runs.options(__doc__, 100_000)
    parser.add_argument("--trials", type=int, default=4)
    arguments = parser.parse_args()
    print("ellipsoids,ranks,million_trials_per_second,efficiency,ghosts,megabytes")
    for count in (n for n in CELLS if n <= arguments.largest):
        variables = dict(zip(("nx", "ny", "nz"), CELLS[count]), trials=arguments.trials, steps=max(4, 200_000 // count),
                         pw85=arguments.include)  # fmt: skip
        for ranks, seconds, efficiency, ghosts in runs.on_ranks(arguments.ranks, "hard.in", r"Nghost: +(\S+) ave", **variables):
            megabytes = 8e-6 * NUMBERS_OF_A_GHOST * EXCHANGES * ghosts
            print(f"{count},{ranks},{1e-6 * arguments.trials * count / seconds:.3g},{efficiency:.2f},{ghosts:.0f},{megabytes:.3g}",
                  flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
