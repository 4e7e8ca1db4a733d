# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory of reading, checking and writing a file: python3 measure_files.py [PARTICLES]

Prints CSV: what is done with a dump of LAMMPS, the number of particles, seconds, and bytes of memory for each particle. Each row is a
process of its own. Its memory is its largest, less that of the same process for a file of 1000 particles. The last rows read the same
lines into an array of numbers, by what `pypw85.read` uses and by other means.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

HEAD = 9
IMPORT = "import os, sys, time, warnings, numpy as np, pypw85; path = sys.argv[1]; warnings.simplefilter('ignore')\n"
# The process prints the seconds of its work, and its largest memory in bytes.
RUN = IMPORT + """{before}
start = time.perf_counter()
{work}
seconds = time.perf_counter() - start
memory = next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM"))
os.write(1, f"{{seconds}} {{1024 * int(memory)}}".encode())
"""
PROGRAMS = {
    "pypw85.read": ("", "pypw85.read(path)"),
    "pw85 check": ("from pypw85 import cli; sys.stdout = open(os.devnull, 'w')", "cli.pw85.main(['check', path], standalone_mode=False)"),
    "pypw85.write": ("system = pypw85.read(path)", "pypw85.write(path + '.written', system, 'lammps-dump')"),
    "lines of pypw85": (
        "from pypw85.formats import _frames, _table",
        f"lines = _table.Lines(path, _frames.Location(0)); head = [lines.next() for _ in range({HEAD})]; "
        "lines.table(int(head[3]), head[-1].split()[2:])",
    ),
    "numpy.loadtxt": ("", f"np.loadtxt(path, skiprows={HEAD})"),
    "pandas.read_csv": (
        "import pandas",
        f"pandas.read_csv(path, sep=' ', skiprows={HEAD}, header=None, float_precision='round_trip')",
    ),
}
REPEATS = 3


def write_dump(path, count):
    """Ellipsoids of random orientations on a cubic lattice, some of which overlap; some 30 boxes meet each box of a particle."""
    import numpy as np

    import pypw85

    rng = np.random.default_rng(1)
    side = round(count ** (1 / 3))
    centers = np.stack(np.meshgrid(*3 * [np.arange(side, dtype=float)], indexing="ij"), axis=-1).reshape(-1, 3)
    centers += rng.uniform(-0.1, 0.1, centers.shape)
    system = pypw85.System.from_axes(
        centers, np.tile([0.62, 0.42, 0.34], (len(centers), 1)), rng.normal(size=(len(centers), 4)), cell=side * np.eye(3)
    )
    pypw85.write(path, system, "lammps-dump")
    return len(centers)


def run(program, path):
    """Seconds and the largest memory in bytes."""
    before, work = program
    command = [sys.executable, "-c", RUN.format(before=before, work=work), path]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    seconds, memory = map(float, done.stdout.split())
    return seconds, memory


def main(count):
    with tempfile.TemporaryDirectory() as folder:
        small, large = (str(Path(folder) / name) for name in ("small.dump", "large.dump"))
        write_dump(small, 1000)
        count = write_dump(large, count)
        print("work,particles,seconds,bytes")
        for name, program in PROGRAMS.items():
            results = [run(program, large) for _ in range(REPEATS)]
            memory = min(memory for _, memory in results) - run(program, small)[1]
            print(f"{name},{count},{min(seconds for seconds, _ in results):.3g},{memory / count:.3g}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000)
