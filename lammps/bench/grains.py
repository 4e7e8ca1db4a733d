# SPDX-License-Identifier: GPL-2.0-only
"""Measures the time per contact of pair_style pw85/granular beside that of LAMMPS's gran/hertz/history for spheres.

    python3 grains.py path/to/pw85.in [--edge 12] [--repeat 3] [--sets baseline avx2 avx512] [--ranks]

Runs grains.in through lmp, in which each grain has twelve contacts. The time is the processor time of a step and contact in nanoseconds,
all of LAMMPS included, from runs of two lengths, of which each is the fastest of several; all runs take turns. Prints a table with commas.
With --sets, there is a row for each of these instruction sets (PW85_TARGET), by default for the newest one of the processor.

With --ranks, 1e5 ellipsoids run on one rank and on two ranks (mpirun), and beside them two independent runs on one rank with half of
the ellipsoids each, at the same time: the machine does not allow more than these. The times are those of LAMMPS's loop, in milliseconds
for a step. The bytes of a grain are the difference of the largest resident sizes of the one-rank runs over that of their numbers of
grains.
"""

import argparse
import functools
from pathlib import Path

import runs

STYLES = {"lammps": ("spheres", "gran/hertz/history"), "spheres": ("spheres", "pw85/granular"),
          "ellipsoids": ("ellipsoids", "pw85/granular"), "superellipsoids": ("ellipsoids", "granular/superellipsoid")}
STEPS = 20, 120
LARGE_EDGE, LARGE_HEIGHT, LARGE_STEPS = 29, 30, 40


def start(include, style, edge, height, steps, **how):
    """A run that has begun."""
    return runs.start("grains.in", **how, pw85=include, style=style, edge=edge, height=height, steps=steps)


def finish(process):
    """Seconds per step of LAMMPS's last loop, and the resources that the run has used."""
    seconds, _, usage = runs.finish(process)
    return seconds, usage


def measure_ranks(include, repeat):
    cells = LARGE_EDGE**2 * LARGE_HEIGHT
    grains, half = 4 * cells, LARGE_HEIGHT // 2
    seconds = {"one rank": [], "two ranks": [], "two independent runs with half of the grains each": []}
    for _ in range(repeat):
        one, whole_usage = finish(start(include, "ellipsoids", LARGE_EDGE, LARGE_HEIGHT, LARGE_STEPS))
        two, _ = finish(start(include, "ellipsoids", LARGE_EDGE, LARGE_HEIGHT, LARGE_STEPS, ranks=2))
        copies = [start(include, "ellipsoids", LARGE_EDGE, half, LARGE_STEPS) for _ in range(2)]
        results = [finish(copy) for copy in copies]
        for times, time in zip(seconds.values(), (one, two, max(time for time, _ in results)), strict=True):
            times.append(time)
    memory = 1024 * (whole_usage.ru_maxrss - results[0][1].ru_maxrss) / (grains / 2)
    print("run,grains,ms,speedup,bytes")
    for name, times in seconds.items():
        print(f"{name},{grains},{1e3 * min(times):.3g},{min(seconds['one rank']) / min(times):.2f},{memory:.2g}")


def starts(styles, include, edge, program=("lmp",)):
    """For styles of STYLES: functions that start a run with a number of steps."""
    return {STYLES[style]: functools.partial(start, include, style, edge, edge, program=program) for style in styles}


def starts_by_set(include, edge, sets):
    """Functions that start a run, by grains, style and instruction set, of which LAMMPS's own style has none."""
    rows = [("lammps", ""), *((style, instructions) for style in ("spheres", "ellipsoids") for instructions in sets)]
    return {(*STYLES[style], instructions): functools.partial(start, include, style, edge, edge, instructions=instructions)
            for style, instructions in rows}  # fmt: skip


def times_of_contacts(starts, edge, repeat):
    """The names and the nanoseconds of a step and contact, for functions by names."""
    contacts = 4 * edge**3 * 6
    times = {(name, steps): [] for name in starts for steps in STEPS}
    for _ in range(repeat):
        for name, steps in times:
            _, usage = finish(starts[name](steps))
            times[name, steps].append(usage.ru_utime)
    for name in starts:
        seconds = (min(times[name, STEPS[1]]) - min(times[name, STEPS[0]])) / (STEPS[1] - STEPS[0])
        yield *name, f"{1e9 * seconds / contacts:.3g}"


def measure_contacts(include, edge, repeat, sets):
    print("grains,style,set,ns")
    for row in times_of_contacts(starts_by_set(include, edge, sets), edge, repeat):
        print(*row, sep=",")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include")
    parser.add_argument("--edge", type=int, default=12)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--sets", nargs="+", default=["newest"], help="names of PW85_TARGET")
    parser.add_argument("--ranks", action="store_true", help="one and two ranks instead of the styles")
    arguments = parser.parse_args()
    include = Path(arguments.include).resolve()
    if arguments.ranks:
        measure_ranks(include, arguments.repeat)
    else:
        measure_contacts(include, arguments.edge, arguments.repeat, arguments.sets)


if __name__ == "__main__":
    main()
