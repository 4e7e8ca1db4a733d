# SPDX-License-Identifier: BSD-3-Clause
"""Smallest ellipsoids around points beside R, CGAL and NumPy: python3 compare_enclosing.py LIBRARY_OF_ENCLOSING_PEERS

Prints CSV: the cloud, dimensions and points, the program with its tolerance, milliseconds, by how much the volume is above the least
volume, and by how much the farthest point is outside: the largest (x - c)ᵀ Q⁻¹ (x - c) - 1. A program that leaves points outside can have
less than the least volume. One thread works. The shortest time of a few runs counts; that of reading the points does not. Programs
that are not available have no rows: ``Rscript`` with the package cluster, and CGAL where the library was built.

The least volume is that of this library with a tolerance of 1e-11, which is proved. "NumPy" is Khachiyan's algorithm as it is often
written, on arrays.
"""

import ctypes
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import pypw85

R_SCRIPT = """
library(cluster)
arguments <- commandArgs(trailingOnly = TRUE)
n <- as.integer(arguments[1])
points <- matrix(readBin(arguments[2], "double", 1e8), ncol = n, byrow = TRUE)
times <- replicate(3, system.time(found <<- ellipsoidhull(points, tol = 0.01))["elapsed"])
writeBin(c(min(times), found$loc, as.vector(found$cov * found$d2)), arguments[3])
"""
CLOUDS = (("normal", 2, 1000), ("normal", 3, 10_000), ("sphere", 3, 10_000), ("normal", 6, 10_000), ("normal", 16, 1000))
if "PW85_MEASURE_ONCE" in os.environ:
    CLOUDS = CLOUDS[:1]


def cloud_of(kind, n, m):
    points = np.random.default_rng(n).normal(size=(m, n))
    return points / np.linalg.norm(points, axis=1)[:, None] if kind == "sphere" else points


def matrix_of(q, n):
    matrix = np.zeros((n, n))
    matrix[np.triu_indices(n)] = q
    return matrix + np.triu(matrix, 1).T


def pw85(points, tolerance=1e-7):
    center, q, _ = pypw85.enclosing_ellipsoid(points, tolerance)
    return center, matrix_of(q, points.shape[1])


def khachiyan(points, tolerance):
    m, n = points.shape
    lifted = np.vstack([points.T, np.ones(m)])
    weights = np.full(m, 1 / m)
    while True:
        kappa = np.einsum("ij,ij->j", lifted, np.linalg.solve((lifted * weights) @ lifted.T, lifted))
        farthest = kappa.argmax()
        if kappa[farthest] <= (n + 1) * (1 + tolerance):
            break
        step = (kappa[farthest] - n - 1) / ((n + 1) * (kappa[farthest] - 1))
        weights *= 1 - step
        weights[farthest] += step
    center = weights @ points
    return center, n * ((points.T * weights) @ points - np.outer(center, center))


def timed(function, *arguments):
    """The shortest time of three calls, or that of a slow one, and the result."""
    least = np.inf
    for _ in range(3):
        start = time.perf_counter()
        result = function(*arguments)
        least = min(least, time.perf_counter() - start)
        if least > 1:
            break
    return least, *result


def by_r(points):
    n = points.shape[1]
    with tempfile.TemporaryDirectory() as folder:
        script, given, found = (Path(folder) / name for name in ("script.R", "points", "found"))
        script.write_text(R_SCRIPT)
        points.tofile(given)
        if subprocess.run(["Rscript", script, str(n), given, found], capture_output=True).returncode:
            return None
        numbers = np.fromfile(found)
    return numbers[0], numbers[1 : n + 1], numbers[n + 1 :].reshape(n, n)


def of_quadric(matrix, vector, scalar):
    """Centre and form of xᵀAx + bᵀx + c <= 0."""
    center = -np.linalg.solve(2 * matrix, vector)
    return center, np.linalg.inv(matrix) * (center @ matrix @ center - scalar)


def by_cgal(library, points, epsilon):
    m, n = points.shape
    result, seconds = np.empty(n * n + n + 1), ctypes.c_double()
    pointers = [ctypes.c_void_p(x.ctypes.data) for x in (points, result)]
    if not library.cgal_ellipsoid(n, ctypes.c_size_t(m), pointers[0], ctypes.c_double(epsilon), pointers[1], ctypes.byref(seconds)):
        return None
    return seconds.value, *of_quadric(result[: n * n].reshape(n, n), result[n * n : -1], result[-1])


def by_cgal_2d(library, points):
    result, seconds = np.empty(6), ctypes.c_double()
    pointers = [ctypes.c_void_p(x.ctypes.data) for x in (points, result)]
    if not library.cgal_ellipse(ctypes.c_size_t(len(points)), *pointers, ctypes.byref(seconds)):
        return None
    r, s, t, u, v, w = result * np.sign(result[0])
    return seconds.value, *of_quadric(np.array([[r, t / 2], [t / 2, s]]), np.array([u, v]), w)


def programs(library, points):
    """(program, function)"""
    yield "pw85, 1e-7", lambda: timed(pw85, points)
    yield "NumPy, 0.01", lambda: timed(khachiyan, points, 0.01)
    if shutil.which("Rscript"):
        yield "R, ellipsoidhull, 0.01", lambda: by_r(points)
    yield "CGAL, Approximate_min_ellipsoid_d, 0.01", lambda: by_cgal(library, points, 0.01)
    if points.shape[1] == 2:
        yield "CGAL, Min_ellipse_2", lambda: by_cgal_2d(library, points)


def compare(library):
    for kind, n, m in CLOUDS:
        points = cloud_of(kind, n, m)
        least = np.linalg.slogdet(pw85(points, 1e-11)[1])[1]
        for program, function in programs(library, points):
            found = function()
            if found is None:
                continue
            seconds, center, form = found
            z = points - center
            outside = np.einsum("ij,ij->i", z, np.linalg.solve(form, z.T).T).max() - 1
            excess = np.expm1((np.linalg.slogdet(form)[1] - least) / 2)
            yield f"{kind}, {n} dimensions", m, program, f"{1e3 * seconds:.3g}", f"{excess:.1e}", f"{max(outside, 0):.1e}"


if __name__ == "__main__":
    print("cloud,points,program,milliseconds,excess,outside")
    for row in compare(ctypes.CDLL(sys.argv[1])):
        print(",".join(f'"{cell}"' if "," in str(cell) else str(cell) for cell in row))
