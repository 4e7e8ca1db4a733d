# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces, tensors of inertia and random points beside Boost and SciPy: python3 compare_bodies.py LIBRARY_OF_BODY_LOOPS

Prints CSV: what is computed, the program, from what it computes ("form" or "semi-axes"), nanoseconds for each ellipsoid or point by the
aspect ratio, and the largest relative error in units of u = 2^-53. One thread works. All programs take turns in short runs, and the
shortest time of each counts, which leaves out most of what else the machine does.

The shapes have semi-axes (aspect, a random one between, 1). SciPy gets whole arrays, and Boost's loops are compiled. Both get
semi-axes, the longest one first; "NumPy and SciPy" begin with the forms, as this library does, and find their eigenvalues first. Areas and
perimeters are compared with those of 50 digits (mpmath). The errors of moments of inertia are those of the trace, and compare programs that
begin with semi-axes with moments of the same axes, others with those of the form.
"""

import ctypes
import sys
import time

import mpmath
import numpy as np
from scipy import special

import pypw85

ASPECTS = (2, 100, 10_000)
ROUNDS = 200
SHAPES, POINTS = 128, 2048  # one round takes some 0.5 ms
FEW = 32  # shapes whose errors are found


class Shapes:
    """Random ellipsoids of an aspect ratio. The last two coordinates of a form are the form of an ellipse."""

    def __init__(self, aspect, rng):
        self.aspect = aspect
        self.axes = np.stack([np.full(SHAPES, float(aspect)), aspect ** rng.uniform(0.01, 0.99, SHAPES), np.ones(SHAPES)], axis=1)
        self.q = pypw85.ellipsoid_quaternion(self.axes, rng.normal(size=(SHAPES, 4)))
        self.matrices = self.q[:, [0, 1, 2, 1, 3, 4, 2, 4, 5]].reshape(-1, 3, 3)
        self.flat_axes = np.ascontiguousarray(self.axes[:, [0, 2]])
        self.flat_q = pypw85.ellipse(*self.flat_axes.T, rng.uniform(0, np.pi, SHAPES))


def scipy_area(a):
    return 4 * np.pi * a.prod(axis=1) * special.elliprg(*(a**-2.0).T)


def scipy_legendre_area(axes):
    a, b, c = axes.T
    cosine = c / a
    sine, phi, m = np.sqrt(1 - cosine**2), np.arccos(cosine), a**2 * (b**2 - c**2) / (b**2 * (a**2 - c**2))
    integrals = sine**2 * special.ellipeinc(phi, m) + cosine**2 * special.ellipkinc(phi, m)
    return 2 * np.pi * (c**2 + a * b / sine * integrals)


def scipy_shell(a):
    """The principal moments of inertia."""
    p = a.T**-2.0
    r_g = special.elliprg(*p)
    parts = np.stack([p[i] * special.elliprd(p[i - 2], p[i - 1], p[i]) for i in range(3)])
    moments = a.T**2 / 4 + (parts.sum(axis=0) - parts) / (24 * r_g)
    return (4 * np.pi * a.prod(axis=1) * r_g * (moments.sum(axis=0) - moments)).T


def numpy_solid(matrices):
    trace = np.trace(matrices, axis1=1, axis2=2)[:, None, None]
    mass = 4 / 3 * np.pi * np.sqrt(np.linalg.det(matrices)) / 5
    return mass[:, None, None] * (trace * np.eye(3) - matrices)


def scipy_shell_of_form(matrices):
    squares, turn = np.linalg.eigh(matrices)
    return turn * scipy_shell(np.sqrt(squares))[:, None, :] @ turn.transpose(0, 2, 1)


def numpy_inside(a, n):
    rng = np.random.default_rng(1)
    x = rng.normal(size=(n, 3))
    return x * (np.cbrt(rng.uniform(size=n)) / np.linalg.norm(x, axis=1))[:, None] * a


def numpy_on_surface(a, n):
    """Blocks with the expected number of points, until there are enough."""
    rng, found, missing = np.random.default_rng(1), [], n
    while missing > 0:
        x = rng.normal(size=(2 * missing, 3))
        x /= np.linalg.norm(x, axis=1)[:, None]
        kept = rng.uniform(size=len(x)) ** 2 < ((x * (a.min() / a)) ** 2).sum(axis=1)
        found.append(x[kept] * a)
        missing -= len(found[-1])
    return np.concatenate(found)[:n]


def loop(library, name, inputs, width, n=None):
    """A compiled loop over rows, or one that makes n points, and its results."""
    function, count = getattr(library, name), len(inputs) if n is None else n
    function.restype = None
    results = np.empty((count, width)) if width > 1 else np.empty(count)
    arguments = (ctypes.c_size_t(count), ctypes.c_void_p(inputs.ctypes.data), ctypes.c_void_p(results.ctypes.data))

    def call():
        function(*arguments)
        return results

    return call


def methods(library, shapes):
    """(quantity, program, what it gets, function)"""
    axes, flat, matrices, q = shapes.axes, shapes.flat_axes, shapes.matrices, shapes.q
    return [
        ("area", "pw85", "form", loop(library, "pw85_loop_area", q, 1)),
        ("area", "NumPy and SciPy", "form", lambda: scipy_area(np.sqrt(np.linalg.eigvalsh(matrices)))),
        ("area", "Boost (Carlson)", "semi-axes", loop(library, "boost_loop_area", axes, 1)),
        ("area", "Boost (Legendre)", "semi-axes", loop(library, "boost_loop_legendre_area", axes, 1)),
        ("area", "SciPy (Carlson)", "semi-axes", lambda: scipy_area(axes)),
        ("area", "SciPy (Legendre)", "semi-axes", lambda: scipy_legendre_area(axes)),
        ("perimeter", "pw85", "form", loop(library, "pw85_loop_perimeter", shapes.flat_q, 1)),
        ("perimeter", "Boost (Legendre)", "semi-axes", loop(library, "boost_loop_perimeter", flat, 1)),
        ("perimeter", "SciPy (Legendre)", "semi-axes", lambda: 4 * flat[:, 0] * special.ellipe(1 - (flat[:, 1] / flat[:, 0]) ** 2)),
        ("inertia of a body", "pw85", "form", loop(library, "pw85_loop_solid", q, 6)),
        ("inertia of a body", "NumPy", "form", lambda: numpy_solid(matrices)),
        ("inertia of a shell", "pw85", "form", loop(library, "pw85_loop_shell", q, 6)),
        ("inertia of a shell", "NumPy and SciPy", "form", lambda: scipy_shell_of_form(matrices)),
        ("inertia of a shell", "Boost (Carlson)", "semi-axes", loop(library, "boost_loop_shell", axes, 3)),
        ("inertia of a shell", "SciPy (Carlson)", "semi-axes", lambda: scipy_shell(axes)),
        ("points in a body", "pw85", "form", loop(library, "pw85_loop_inside", q[0], 3, POINTS)),
        ("points in a body", "Boost", "semi-axes", loop(library, "boost_loop_inside", axes[0], 3, POINTS)),
        ("points in a body", "NumPy", "semi-axes", lambda: numpy_inside(axes[0], POINTS)),
        ("points on a surface", "pw85", "form", loop(library, "pw85_loop_on_surface", q[0], 3, POINTS)),
        ("points on a surface", "Boost", "semi-axes", loop(library, "boost_loop_on_surface", axes[0], 3, POINTS)),
        ("points on a surface", "NumPy", "semi-axes", lambda: numpy_on_surface(axes[0], POINTS)),
    ]  # fmt: skip


def squares_of(entries, given):
    """Squares of the semi-axes, of those or of a form, with 50 digits."""
    if given == "semi-axes":
        return [mpmath.mpf(a) ** 2 for a in entries]
    return list(mpmath.eigsy(mpmath.matrix(entries.tolist()), eigvals_only=True))


def area_truth(squares):
    p = [1 / x for x in squares]
    return 4 * mpmath.pi * mpmath.sqrt(mpmath.fprod(squares)) * mpmath.elliprg(*p)


def truth(quantity, squares):
    """The number, or the trace of the tensor."""
    if quantity == "perimeter":
        return 8 * mpmath.elliprg(0, *squares)
    if quantity == "area":
        return area_truth(squares)
    if quantity == "inertia of a body":
        return mpmath.pi * mpmath.sqrt(mpmath.fprod(squares)) * 4 / 3 * 2 * mpmath.fsum(squares) / 5
    p = [1 / x for x in squares]
    r_d = [p[i] * mpmath.elliprd(p[i - 2], p[i - 1], p[i]) for i in range(3)]
    return 2 * area_truth(squares) * (mpmath.fsum(squares) / 4 + mpmath.fsum(r_d) / (12 * mpmath.elliprg(*p)))


def number_of(result):
    """The number, or the trace of a tensor, with all digits of the entries."""
    entries = np.asarray(result)
    if entries.ndim == 0:
        return mpmath.mpf(float(entries))
    diagonal = np.diag(entries) if entries.ndim == 2 else entries[[0, 3, 5]] if len(entries) == 6 else entries
    return mpmath.fsum(mpmath.mpf(float(x)) for x in diagonal)


def largest_error(quantity, given, shapes, results):
    inputs = {"form": shapes.matrices, "semi-axes": shapes.axes}[given]
    if quantity == "perimeter":
        inputs = {"form": shapes.flat_q[:, [0, 1, 1, 2]].reshape(-1, 2, 2), "semi-axes": shapes.flat_axes}[given]
    errors = [abs(number_of(found) / truth(quantity, squares_of(entries, given)) - 1) for found, entries in zip(results[:FEW], inputs)]
    return float(max(errors)) * 2**53


def three_digits(number):
    return f"{float(f'{number:.3g}'):g}"


def seconds(function):
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def compare(library):
    rng = np.random.default_rng(1)
    rows = {}
    for aspect in ASPECTS:
        shapes = Shapes(aspect, rng)
        all_methods = methods(library, shapes)
        least = np.min([[seconds(method[-1]) for method in all_methods] for _ in range(ROUNDS)], axis=0)
        for (quantity, program, given, function), time_taken in zip(all_methods, least):
            row = rows.setdefault((quantity, program), {"quantity": quantity, "program": program, "given": given})
            results = function()
            row[f"aspect_{aspect}"] = three_digits(1e9 * time_taken / len(results))
            if not quantity.startswith("points"):
                row["error"] = max(row.get("error", 0), largest_error(quantity, given, shapes, results))
    return rows.values()


if __name__ == "__main__":
    mpmath.mp.dps = 50
    np.seterr(invalid="ignore", divide="ignore")  # Legendre's formulas for thin shapes
    columns = ["quantity", "program", "given", *(f"aspect_{aspect}" for aspect in ASPECTS), "error"]
    print(",".join(columns))
    for row in compare(ctypes.CDLL(sys.argv[1])):
        row["error"] = f"{row['error']:.2g}" if "error" in row else ""
        print(",".join(row[column] for column in columns))
