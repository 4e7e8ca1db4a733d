# SPDX-License-Identifier: GPL-2.0-only
"""Random ellipsoids, and runs of LAMMPS on them."""

import functools
import os
import re
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@functools.cache
def release():
    """The day of the release of LAMMPS, as (year, month, day)."""
    text = subprocess.run([os.environ["PW85_LMP"], "-h"], text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False).stdout
    day, month, year = re.search(r"Simulator - (\d+) (\w{3})\w* (\d{4})", text).groups()
    return int(year), 1 + "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec".split().index(month), int(day)


def has_friction_of_walls():
    """Whether LAMMPS's own walls have the friction of its styles gran/hooke/history and gran/hertz/history, as in September 2021 and
    July 2026. In the release of February 2025 they have another one; of those between nothing is known here."""
    return release() < (2022, 1, 1) or release() >= (2026, 7, 4)


@dataclass
class System:
    """Ellipsoids in a box; tags are 1, 2, ..."""

    cell: np.ndarray  # rows: the vectors of the box, lower triangular; origin in 0
    periodic: bool
    centers: np.ndarray
    semi_axes: np.ndarray
    quaternions: np.ndarray  # w, i, j, k
    types: np.ndarray

    @property
    def cutoff(self):
        """Largest distance at which two of them can touch."""
        return 2.0 * self.semi_axes.max()

    def data_file(self):
        ((lx, _, _), (xy, ly, _), (xz, yz, lz)) = self.cell
        rows = range(len(self.centers))
        lines = ["ellipsoids", "", f"{len(rows)} atoms", f"{len(rows)} ellipsoids", f"{self.types.max()} atom types",
                 f"0 {lx:.17g} xlo xhi", f"0 {ly:.17g} ylo yhi", f"0 {lz:.17g} zlo zhi"]
        if xy or xz or yz:
            lines += [f"{xy:.17g} {xz:.17g} {yz:.17g} xy xz yz"]
        lines += ["", "Atoms # ellipsoid", ""]
        lines += [f"{i + 1} {self.types[i]} 1 1.0 " + numbers(self.centers[i]) for i in rows]
        lines += ["", "Ellipsoids", ""]
        lines += [f"{i + 1} " + numbers([*(2.0 * self.semi_axes[i]), *self.quaternions[i]]) for i in rows]
        return "\n".join(lines) + "\n"


def numbers(values):
    return " ".join(f"{value:.17g}" for value in values)


def random_system(seed, count, cell, periodic=True, aspect=3.0):
    """General ellipsoids of two types, the second smaller, at uniformly random places and orientations."""
    random = np.random.default_rng(seed)
    cell = np.asarray(cell, dtype=float)
    types = 1 + (np.arange(count) % 2)
    semi_axes = aspect ** random.uniform(-0.5, 0.5, (count, 3)) * np.where(types == 1, 1.0, 0.6)[:, None]
    quaternions = random.normal(size=(count, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    return System(cell, periodic, random.uniform(0.0, 1.0, (count, 3)) @ cell, semi_axes, quaternions, types)


PREAMBLE = """
units lj
atom_style ellipsoid
newton {newton}
boundary {boundary}
include {include}
read_data system.data
"""


def preamble(system, newton="on"):
    return PREAMBLE.format(newton=newton, boundary="p p p" if system.periodic else "f f f",
                           include=os.environ["PW85_LAMMPS_INCLUDE"])


def launch(directory, ranks):
    """Runs in.lammps in a directory; Open MPI (4, 5) takes settings from the environment, others need none.

    A rank that waits sleeps (yield.c), and no rank is bound to a processor: other programs run beside the tests."""
    settings = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                "OMPI_MCA_rmaps_base_oversubscribe": "1", "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
                "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
                "PRTE_MCA_hwloc_default_binding_policy": "none", "OMPI_MCA_ess_singleton_isolated": "1",
                "OMP_NUM_THREADS": "1"}
    launcher = []
    if ranks > 1:
        launcher = [os.environ["PW85_MPIRUN"], "-n", str(ranks)]
        settings["LD_PRELOAD"] = os.environ["PW85_LAMMPS_YIELD"]
    command = [*launcher, os.environ["PW85_LMP"], "-in", "in.lammps"]
    return subprocess.run(command, cwd=directory, env={**os.environ, **settings}, text=True, timeout=600,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)


def run(script, system=None, ranks=1, outputs=(), files=None):
    """Runs a script in a folder with the files of a dict, name: text.

    Returns the text it printed and the arrays of its dump files, one array for each snapshot."""
    with tempfile.TemporaryDirectory() as directory:
        Path(directory, "in.lammps").write_text(script)
        if system is not None:
            Path(directory, "system.data").write_text(system.data_file())
        for name, text in (files or {}).items():
            Path(directory, name).write_text(text)
        result = launch(directory, ranks)
        if result.returncode != 0:
            raise RuntimeError(f"LAMMPS on {ranks} ranks failed\n{script}\n{result.stdout[-4000:]}")
        return result.stdout, [read_dump(Path(directory, output)) for output in outputs]


def failure(script, system=None, ranks=1, files=None):
    """Runs a script that must stop with an error; returns what it printed, in one line."""
    try:
        text, _ = run(script, system, ranks, files=files)
    except RuntimeError as error:
        return " ".join(str(error).split())
    raise AssertionError(f"LAMMPS did not stop\n{script}\n{text[-2000:]}")


def read_dump(path):
    """Snapshots of a dump file in text form."""
    snapshots = []
    lines = path.read_text().splitlines()
    position = 0
    while position < len(lines):
        count = int(lines[position + 3])
        columns = len(lines[position + 8].split()) - 2
        rows = [[float(word) for word in line.split()] for line in lines[position + 9:position + 9 + count]]
        snapshots.append(np.array(rows).reshape(count, columns))
        position += 9 + count
    return snapshots


def thermo(text):
    """Rows of the last table of thermo output."""
    lines = text.splitlines()
    start = max(i for i, line in enumerate(lines) if line.split()[:1] == ["Step"])
    stop = next(i for i, line in enumerate(lines[start:], start) if line.startswith("Loop time"))
    rows = (line for line in lines[start + 1:stop] if not line.startswith("WARNING"))
    return np.array([[float(word) for word in line.split()] for line in rows])
