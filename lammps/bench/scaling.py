# SPDX-License-Identifier: GPL-2.0-only
"""Measures the time per ellipsoid and per pair of each style, and the parallel efficiency.

    python3 scaling.py path/to/pw85.in [--ranks 1 2] [--largest 256000]

Runs ellipsoids.in through lmp and mpirun. The time is that of a step in which LAMMPS does nothing but run the compute
(overlap, contact), or a step of molecular dynamics with the soft potential (soft). Prints a table with commas: pairs of the neighbour list
and nanoseconds of a step for each ellipsoid, and the time of the first number of ranks times this number, over that of all ranks together.
"""

import runs

EDGES = {1_000: (10, 10, 10), 10_000: (20, 20, 25), 100_000: (40, 50, 50), 256_000: (40, 80, 80)}


def main():
    arguments = runs.options(__doc__, 256_000).parse_args()
    print("style,ellipsoids,ranks,pairs,ns,efficiency")
    for style in ("overlap", "contact", "soft"):
        for count in (n for n in EDGES if n <= arguments.largest):
            variables = dict(zip(("nx", "ny", "nz"), EDGES[count]), style=style, steps=max(5, 1_000_000 // count),
                             pw85=arguments.include)  # fmt: skip
            pattern = r"Total # of neighbors = (\d+)"
            for ranks, seconds, efficiency, pairs in runs.on_ranks(arguments.ranks, "ellipsoids.in", pattern, **variables):
                print(f"{style},{count},{ranks},{pairs / count:.3g},{1e9 * seconds / count:.3g},{efficiency:.2f}", flush=True)


if __name__ == "__main__":
    main()
