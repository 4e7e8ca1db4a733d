# SPDX-License-Identifier: BSD-3-Clause
"""The contact function in n dimensions beside NumPy and SciPy: python3 compare_any_dimension.py LIBRARY_OF_ANY_DIMENSION_LOOPS

Prints CSV: dimensions, nanoseconds for a pair in rows, evaluations of f for a pair, nanoseconds for one factorisation of a form, the time
of a pair over that of as many factorisations, the same ratio of floating-point operations, nanoseconds of SciPy, its ratio to a pair in
rows and to one call, and the largest relative difference of μ². One thread works. All take turns, and the shortest time of each counts.

SciPy gets the generalised eigenvectors of a pair (scipy.linalg.eigh), so that f costs n operations, and minimises -f over [0, 1]
(scipy.optimize.minimize_scalar, bounded).
"""

import ctypes
import os
import sys
import time

import numpy as np
from scipy.linalg import eigh
from scipy.optimize import minimize_scalar

import pypw85

DIMENSIONS = (2, 3, 4, 6, 8, 12, 16)
COUNT = 200
ROUNDS = 1 if "PW85_MEASURE_ONCE" in os.environ else 15


def random_form(rng, n, aspect):
    axes = np.linalg.qr(rng.normal(size=(n, n)))[0]
    return (axes * aspect ** (2 * rng.uniform(-1, 0, size=n))) @ axes.T


def scipy_contact(r12, q1, q2):
    values, vectors = eigh(q2, q1)
    weights = (vectors.T @ r12) ** 2
    found = minimize_scalar(
        lambda x: -x * (1 - x) * np.sum(weights / (1 - x + x * values)), bounds=(0, 1), method="bounded", options={"xatol": 1e-10}
    )
    return -found.fun


def seconds(function):
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def operations(n):
    """Of a factorisation, and of one evaluation with its derivatives: M, its factors, two solutions, a product, a quadratic form, sums."""
    factorisation = n**3 / 3 + n**2 / 2 + n / 6
    return factorisation, factorisation + 8 * n**2 + 13 * n


def compare(library):
    library.any_dimension_evaluations.restype = ctypes.c_long
    rng = np.random.default_rng(1)
    for n in DIMENSIONS:
        r12 = rng.normal(size=(COUNT, n))
        full = [np.array([random_form(rng, n, 10) for _ in range(COUNT)]) for _ in range(2)]
        packed = [np.ascontiguousarray(q[(..., *np.triu_indices(n))]) for q in full]
        pointers = [ctypes.c_void_p(x.ctypes.data) for x in (r12, *packed)]
        evaluations = library.any_dimension_evaluations(n, ctypes.c_size_t(COUNT), *pointers) / COUNT
        functions = (
            lambda: pypw85.nd_contact(r12, *packed),
            lambda: library.any_dimension_factorize(n, ctypes.c_size_t(COUNT), pointers[1]),
            lambda: [pypw85.nd_contact(r, a, b) for r, a, b in zip(r12, *packed)],
            lambda: [scipy_contact(r, a, b) for r, a, b in zip(r12, *full)],
        )
        rows, factorisation, calls, others = 1e9 / COUNT * np.min([[seconds(f) for f in functions] for _ in range(ROUNDS)], axis=0)
        truth = np.array([scipy_contact(r, a, b) for r, a, b in zip(r12, *full)])
        difference = np.max(np.abs(truth / pypw85.nd_contact(r12, *packed)[0] - 1))
        one, whole = operations(n)
        yield (n, rows, evaluations, factorisation, rows / (evaluations * factorisation), whole / one, others, others / rows,
               others / calls, difference)  # fmt: skip


if __name__ == "__main__":
    print("dimensions,rows,evaluations,factorisation,times,operations,scipy,ratio,ratio_of_calls,difference")
    for n, *numbers, difference in compare(ctypes.CDLL(sys.argv[1])):
        print(",".join([str(n), *(f"{float(f'{x:.3g}'):g}" for x in numbers), f"{difference:.1e}"]))
