# SPDX-License-Identifier: GPL-2.0-only
"""Measures the time per contact of pair_style pw85/granular beside that of LAMMPS's gran/hertz/history for spheres.

    python3 grains.py path/to/pw85.in [--edge 12]

Runs grains.in through lmp, in which each grain has twelve contacts. The time is the processor time of a step, all of LAMMPS
included, from runs of two lengths, of which each is the fastest of several.
"""

import argparse
import os
import subprocess
from pathlib import Path

STYLES = {"lammps": "spheres, gran/hertz/history", "spheres": "spheres, pw85/granular",
          "ellipsoids": "ellipsoids, pw85/granular"}
STEPS = 20, 120


def processor_time(include, style, edge, steps):
    """Seconds that a run takes."""
    command = ["lmp", "-log", "none", "-in", str(Path(__file__).parent / "grains.in")]
    for name, value in {"pw85": include, "style": style, "edge": edge, "steps": steps}.items():
        command += ["-var", name, str(value)]
    process = subprocess.Popen(command, env={**os.environ, "OMP_NUM_THREADS": "1"}, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError(f"LAMMPS failed: {' '.join(command)}")
    return usage.ru_utime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include")
    parser.add_argument("--edge", type=int, default=12)
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    include = Path(arguments.include).resolve()
    contacts = 4 * arguments.edge**3 * 6
    times = {(style, steps): [] for style in STYLES for steps in STEPS}
    for _ in range(arguments.repeat):
        for style, steps in times:
            times[style, steps].append(processor_time(include, style, arguments.edge, steps))
    for style, text in STYLES.items():
        seconds = (min(times[style, STEPS[1]]) - min(times[style, STEPS[0]])) / (STEPS[1] - STEPS[0])
        print(f"{text:30} {1e9 * seconds / contacts:6.0f} ns per contact and step", flush=True)


if __name__ == "__main__":
    main()
