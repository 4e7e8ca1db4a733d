#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The contact function in n dimensions beside the way of NumPy and SciPy: generalised eigenvalues and a bounded minimisation.

    PYTHONPATH=BUILD/python bench/any_dimension.py

SciPy gets the pencil's eigenbasis once for each pair (scipy.linalg.eigh), so that f costs n operations, and minimises -f over [0, 1]
(scipy.optimize.minimize_scalar). pw85 gets the same pairs one by one, in the calls of Python, and all at once.
"""

import time

import numpy as np
from scipy.linalg import eigh
from scipy.optimize import minimize_scalar

import pypw85


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
    best = np.inf
    for _ in range(5):
        start = time.perf_counter()
        function()
        best = min(best, time.perf_counter() - start)
    return best


def main():
    rng = np.random.default_rng(1)
    count = 200
    print("  n    SciPy  one call   in rows (µs per pair)   ratio of SciPy to rows   largest difference")
    for n in (2, 3, 4, 6, 8, 12, 16):
        r12 = rng.normal(size=(count, n))
        full = [np.array([random_form(rng, n, 10) for _ in range(count)]) for _ in range(2)]
        packed = [q[(..., *np.triu_indices(n))] for q in full]
        others = np.array([scipy_contact(r, a, b) for r, a, b in zip(r12, *full)])
        worst = np.max(np.abs(others / pypw85.nd_contact(r12, *packed)[0] - 1))
        times = [
            seconds(lambda: [scipy_contact(r, a, b) for r, a, b in zip(r12, *full)]),
            seconds(lambda: [pypw85.nd_contact(r, a, b) for r, a, b in zip(r12, *packed)]),
            seconds(lambda: pypw85.nd_contact(r12, *packed)),
        ]
        scipy_time, one, rows = (1e6 * t / count for t in times)
        print(f"{n:3} {scipy_time:8.0f} {one:9.1f} {rows:9.2f} {scipy_time / rows:29.0f} {worst:24.1e}")


main()
