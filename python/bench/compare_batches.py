# SPDX-License-Identifier: BSD-3-Clause
"""Functions of arrays in Python against the batches of the C library: python3 compare_batches.py LIBRARY [ROWS] [FUNCTION...]

Prints CSV: the number of threads (OMP_NUM_THREADS) and of rows, nanoseconds for each row, and the ratio. Python and C take turns on
the same inputs and outputs, and the shortest time of each counts. Functions that are slow get fewer rows, so that a call takes a tenth
of a second at most.
"""

import ctypes
import os
import sys
import time

import numpy as np

import pypw85
from pypw85 import gufuncs

ROUNDS = 15
LONGEST = 0.1


def forms(rng, n):
    return pypw85.ellipsoid_quaternion(rng.uniform(0.5, 2, (n, 3)), rng.normal(size=(n, 4)))


def ellipses(rng, n):
    return pypw85.ellipse(*rng.uniform(0.5, 2, (3, n)))


def unit(rng, n, dim=3):
    directions = rng.normal(size=(n, dim))
    return directions / np.linalg.norm(directions, axis=1, keepdims=True)


def pairs(rng, n):
    """Random ellipsoids at distances around that of contact."""
    return rng.uniform(1, 4, (n, 1)) * unit(rng, n), forms(rng, n), forms(rng, n)


def close_pairs(rng, n):
    return rng.uniform(0.1, 0.9, (n, 1)) * unit(rng, n), forms(rng, n), forms(rng, n)


def flat_pairs(rng, n):
    return rng.uniform(1, 4, (n, 1)) * unit(rng, n, 2), ellipses(rng, n), ellipses(rng, n)


def moving_pairs(rng, n):
    r12 = rng.uniform(4, 6, (n, 1)) * unit(rng, n)
    motions = [np.concatenate([sign * r12 + rng.normal(size=(n, 3)), rng.normal(scale=0.3, size=(n, 3)), np.zeros((n, 1))], axis=1)
               for sign in (0.5, -0.5)]  # fmt: skip
    return r12, forms(rng, n), forms(rng, n), *motions, 1.0


def planes(rng, n):
    return unit(rng, n), rng.uniform(2, 3, n), forms(rng, n)


INPUTS = {
    "contact": pairs,
    "overlap": pairs,
    "closest_approach": lambda rng, n: (unit(rng, n), forms(rng, n), forms(rng, n)),
    "contact_function": pairs,
    "distance": pairs,
    "penetration": close_pairs,
    "first_contact": moving_pairs,
    "contact_2d": flat_pairs,
    "overlap_2d": flat_pairs,
    "distance_2d": flat_pairs,
    "distance_plane": planes,
    "contact_plane": planes,
    "distance_box": lambda rng, n: (rng.uniform(-6, -3, (n, 3)), rng.uniform(3, 6, (n, 3)), forms(rng, n)),
    "distance_cylinder": lambda rng, n: (unit(rng, n), rng.uniform(4, 6, n), rng.normal(size=(n, 3)), forms(rng, n)),
    "distance_point": lambda rng, n: (rng.uniform(1, 4, (n, 1)) * unit(rng, n), forms(rng, n)),
    "intersect_line": lambda rng, n: (rng.normal(size=(n, 3)), unit(rng, n), forms(rng, n)),
}


def outputs(ufunc, n):
    cores = ufunc.signature.split("->")[1][1:-1].split("),(")
    return [np.empty((n, *(int(size) for size in core.split(",") if size))) for core in cores]


def from_c(library, name):
    """The batch function, of arrays in the order of the gufunc."""
    stem, _, dimension = name.partition("_2d")
    function = getattr(library, f"pw85_{stem}_batch" + ("_2d" if name.endswith("_2d") else dimension))
    return lambda n, arguments: function(ctypes.c_size_t(n), *map(from_numpy, arguments))


def from_numpy(argument):
    return ctypes.c_void_p(argument.ctypes.data) if isinstance(argument, np.ndarray) else ctypes.c_double(argument)


def seconds(function):
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def compare(library, name, rows):
    rng = np.random.default_rng(1)
    ufunc, call, batch = getattr(gufuncs, name), getattr(pypw85, name), from_c(library, name)

    def times(n, rounds):
        inputs = INPUTS[name](rng, n)
        out = outputs(ufunc, n)
        if name.startswith("overlap"):
            out = [np.empty(n, np.uint8)]
        python_out = out[0].view(bool) if name.startswith("overlap") else out[0] if len(out) == 1 else tuple(out)
        turns = [(seconds(lambda: batch(n, [*inputs, *out])), seconds(lambda: call(*inputs, out=python_out))) for _ in range(rounds)]
        return 1e9 / n * np.min(turns, axis=0)

    few = min(rows, 4000)
    n = int(min(rows, max(few, 1e9 * LONGEST / times(few, 2)[0])))
    c, python = times(n, ROUNDS)
    print(f"{name},{os.environ.get('OMP_NUM_THREADS', os.cpu_count())},{n},{c:.4g},{python:.4g},{python / c:.2f}", flush=True)


if __name__ == "__main__":
    print("function,threads,rows,c,python,ratio")
    for function_name in sys.argv[3:] or INPUTS:
        compare(ctypes.CDLL(sys.argv[1]), function_name, int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000)
