# SPDX-License-Identifier: GPL-2.0-only
"""Runs of LAMMPS with one thread on some ranks, for the measurements of this folder."""

import argparse
import os
import re
import subprocess
from pathlib import Path

SETTINGS = {"OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def environment(instructions=None):
    """The environment of a run, in which pw85 uses an instruction set, by default the newest one."""
    return {**os.environ, **SETTINGS, **({"PW85_TARGET": instructions} if instructions else {})}


def start(script, ranks=1, program=("lmp",), instructions=None, **variables):
    """A run of a script of this folder that has begun."""
    launcher = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
    command = [*launcher, *program, "-log", "none", "-in", str(Path(__file__).parent / script)]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    return subprocess.Popen(command, env=environment(instructions), stdout=subprocess.PIPE, text=True)


def version(program):
    """The date by which LAMMPS names its release."""
    text = subprocess.run([*program, "-h"], env=environment(), stdout=subprocess.PIPE, text=True, check=True).stdout
    return re.search(r"Simulator - (\d+ \w+ \d+)", text)[1]


def finish(process):
    """Seconds per step of LAMMPS's last loop, what it printed, and the resources that the run has used."""
    text = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError(f"LAMMPS failed: {' '.join(process.args)}\n{text[-2000:]}")
    seconds, steps = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps", text)[-1]
    return float(seconds) / int(steps), text, usage


def options(description, largest):
    """The options of measurements of the efficiency on ranks."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include", type=lambda name: Path(name).resolve())
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--largest", type=int, default=largest)
    return parser


def on_ranks(ranks, script, found_in, **variables):
    """For each number of ranks: this number, seconds per step, the parallel efficiency, and what a pattern finds in the output. The
    fastest of three runs counts: what else the machine does can only add."""
    work = None
    for count in ranks:
        seconds, text, _ = min((finish(start(script, count, **variables)) for _ in range(3)), key=lambda found: found[0])
        work = work or count * seconds
        yield count, seconds, work / (count * seconds), float(re.search(found_in, text)[1])
