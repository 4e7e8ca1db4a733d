# SPDX-License-Identifier: BSD-3-Clause
"""Calls for one pair from Python against calls from C: python3 compare_calls.py LIBRARY_OF_C_LOOPS

Prints CSV: nanoseconds of a call, and what Python adds. Python and C take turns, and the shortest time of each counts, which leaves
out most of what else the machine does. compare_batches.py does the same for arrays.
"""

import ctypes
import sys
import time

import numpy as np

import pypw85

ROUNDS = 15
CALLS = 20_000


def seconds(function, *args):
    start = time.perf_counter()
    function(*args)
    return time.perf_counter() - start


def shortest(*functions):
    """Shortest time of each function, all taking turns."""
    return np.min([[seconds(function) for function in functions] for _ in range(ROUNDS)], axis=0)


def c_function(library, name):
    function = getattr(library, name)
    function.restype = None
    return lambda n, *arrays: function(ctypes.c_size_t(n), *(ctypes.c_void_p(x.ctypes.data) for x in arrays))


def random_pairs(count):
    rng = np.random.default_rng(1)

    def forms():
        return pypw85.ellipsoid_quaternion(rng.uniform(0.5, 2, (count, 3)), rng.normal(size=(count, 4)))

    return rng.normal(scale=1.5, size=(count, 3)), forms(), forms()


def compare_single(library, name):
    pair = [x[0] for x in random_pairs(1)]
    from_c, from_python = c_function(library, f"c_{name}_again"), getattr(pypw85, name)

    def python_calls():
        for _ in range(CALLS):
            from_python(*pair)

    c, python = shortest(lambda: from_c(CALLS, *pair, np.empty(2)), python_calls)
    print(f"{name},{1e9 * c / CALLS:.0f},{1e9 * python / CALLS:.0f},{1e9 * (python - c) / CALLS:.0f}")


if __name__ == "__main__":
    loops = ctypes.CDLL(sys.argv[1])
    print("function,c,python,overhead")
    for function_name in ("contact", "contact_function"):
        compare_single(loops, function_name)
