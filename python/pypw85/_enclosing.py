# SPDX-License-Identifier: BSD-3-Clause
"""The smallest ellipsoid around points, around ellipsoids, and around the most central share of samples."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._any_dimension import MAX_DIMENSION, packed_rows
from ._arrays import reals
from ._errors import PW85Error, Status, describe
from ._numbers import real
from ._typing import Floats

# The mean and the covariance of the most central samples are recomputed at most this many times. They are final when the samples stay the
# same.
MOST_STEPS = 100


def enclosing_ellipsoid(points: ArrayLike, tolerance: float = 1e-6) -> tuple[Floats, Floats, float]:
    """The ellipsoid of least volume around points in 1 to 16 dimensions, with a proof.

    Every point is inside the ellipsoid or on it, in exact arithmetic for the numbers that are returned. The volume is at most
    ``1 + excess`` times the least volume.

    Parameters
    ----------
    points : (m, n) array_like
        At least n + 1 points.
    tolerance : float
        Largest excess that is wanted. If double precision does not allow that, because points are far from the origin or the ellipsoid
        is thin, there is a `RuntimeWarning`, and the excess is larger.

    Returns
    -------
    center : (n) array
    q : (n (n + 1) / 2) array
        Form of the ellipsoid, the rows of the upper triangle: ``(xx, xy, xz, yy, yz, zz)`` for n = 3.
    excess : float
        If the points are in a hyperplane, or nearer to one than about 2⁻²⁴ of their extents, there is a `RuntimeWarning`: the result is the
        smallest ellipsoid in the affine hull of the points, up to rounding errors. Its form is singular.

    Raises
    ------
    PW85Error
        A number is not finite, or there are too few points.
    ValueError
        The points are not an (m, n) array with n from 1 to 16.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> points = [[0, 0], [2, 0], [0, 4], [2, 4], [1, 1]]
    >>> center, q, excess = pypw85.enclosing_ellipsoid(points, tolerance=1e-9)
    >>> print(center.round(6), abs(q).round(6), excess <= 1e-9)
    [1. 2.] [2. 0. 8.] True
    """
    name = "enclosing_ellipsoid"
    rows, tolerance = _points(points, f"{name}: points"), real(tolerance, f"{name}: tolerance")
    return _enclose(name, _core.enclosing_ellipsoid, tolerance, points=rows)


def enclosing_ellipsoid_of(centers: ArrayLike, forms: ArrayLike, tolerance: float = 1e-6) -> tuple[Floats, Floats, float]:
    """The ellipsoid of least volume around ellipsoids in 1 to 16 dimensions, with a proof.

    Every ellipsoid is inside, in exact arithmetic for the numbers that are given and returned. The volume is at most ``1 + excess`` times
    the least volume.

    Parameters
    ----------
    centers : (m, n) array_like
        At least one.
    forms : (m, n, n) or (m, n (n + 1) / 2) array_like
        Symmetric matrices, or their upper triangles row by row.
    tolerance : float
        As for `enclosing_ellipsoid`.

    Returns
    -------
    center, q, excess
        As for `enclosing_ellipsoid`.

    Raises
    ------
    PW85Error
        A number is not finite, a form is not positive definite, there is no ellipsoid, or the result is too flat to be certified.
    ValueError
        The centres are not an (m, n) array with n from 1 to 16, or the forms do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> centers, forms = [[0, 0], [4, 0], [2, 0.5]], [np.eye(2), np.eye(2), 0.1 * np.eye(2)]
    >>> center, q, excess = pypw85.enclosing_ellipsoid_of(centers, forms)
    >>> print(center.round(3) + 0, excess <= 1e-6)
    [2. 0.] True
    """
    name = "enclosing_ellipsoid_of"
    rows = _points(centers, f"{name}: centers")
    m, n = rows.shape
    tolerance = real(tolerance, f"{name}: tolerance")
    given = reals(forms, f"{name}: forms")
    packed = np.require(given if n == 1 and given.ndim == 2 else packed_rows(given, n, name, "forms"), np.float64, ["C", "A"])
    if packed.shape != (m, n * (n + 1) // 2):
        raise ValueError(f"{name}: forms must have one row for each of {m} centers, not the shape {packed.shape}")
    return _enclose(name, _core.enclosing_ellipsoid_of, tolerance, centers=rows, forms=packed)


def credible_ellipsoid(samples: ArrayLike, share: float, tolerance: float = 1e-6) -> tuple[Floats, Floats, float]:
    """An ellipsoid that contains a given fraction of samples: the smallest one around the most central of them.

    The most central samples are those with the smallest distances from the mean in the norm of the covariance. The mean and the
    covariance are computed again from these samples, until the samples stay the same. This is a heuristic: the ellipsoid is the smallest
    around the samples that are chosen, and another choice may have a smaller one. Samples of several clusters, or of a curved cloud, need
    several ellipsoids.

    Parameters
    ----------
    samples : (m, n) array_like
    share : float
        Above 0 and at most 1. The ellipsoid holds at least ``ceil(share * m)`` samples.
    tolerance : float
        As for `enclosing_ellipsoid`.

    Returns
    -------
    center, q, excess
        As for `enclosing_ellipsoid`; the excess is that of the samples that were chosen.

    Raises
    ------
    PW85Error
        A number is not finite, or there are less than n + 1 samples. As for `enclosing_ellipsoid`, samples in a hyperplane give a
        `RuntimeWarning` and the ellipsoid of their affine hull.
    ValueError
        The samples are not an (m, n) array with n from 1 to 16, or the share is out of range, or takes less than n + 1 samples.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> samples = np.random.default_rng(1).normal(size=(1000, 4))
    >>> center, q, excess = pypw85.credible_ellipsoid(samples, 0.9)
    >>> excess <= 1e-6
    True
    """
    name = "credible_ellipsoid"
    rows, share, tolerance = _points(samples, f"{name}: samples"), real(share, f"{name}: share"), real(tolerance, f"{name}: tolerance")
    if not 0 < share <= 1:
        raise ValueError(f"{name}: share must be above 0 and at most 1, not {share}")
    count, (m, n) = math.ceil(share * len(rows)), rows.shape
    if n < m and count <= n:
        raise ValueError(f"{name}: share must take at least {n + 1} of the {m} samples in {n} dimensions, not {count}, as {share:g} does")
    if m <= n or not np.isfinite(rows).all():  # the library refuses them, or warns
        return _enclose(name, _core.enclosing_ellipsoid, tolerance, samples=rows)
    # In units of the extents, because coordinates may have different units. Powers of two change no digit.
    extents = rows.max(axis=0) / 2 - rows.min(axis=0) / 2
    scaled = np.ldexp(rows, -np.frexp(extents)[1])
    kept = np.arange(len(rows))
    for _ in range(MOST_STEPS if count < len(rows) else 0):
        nearest = np.argsort(_distances(scaled, scaled[kept]), kind="stable")[:count]
        if np.array_equal(np.sort(nearest), kept):
            break
        kept = np.sort(nearest)
    return _enclose(name, _core.enclosing_ellipsoid, tolerance, samples=rows[kept])


def _enclose(name: str, function: Any, tolerance: float, **inputs: Floats) -> tuple[Floats, Floats, float]:
    """Calls a function of C for points or samples, or for centres and forms."""
    what, rows = next(iter(inputs.items()))
    m, n = rows.shape
    center, q = np.empty(n), np.empty(n * (n + 1) // 2)
    status, excess = function(n, *inputs.values(), tolerance, center, q)
    if not status:
        return center, q, excess
    if status not in (Status.ECONVERGENCE, Status.ENOTPD) or math.isnan(excess):
        raise PW85Error(status, name, _core.strerror(status), _cause(tolerance, m, what, inputs))
    cause = f"the excess is {excess:.3g}, above the tolerance {tolerance:g}"
    if status == Status.ENOTPD:
        cause = f"the {what} are in a hyperplane: the form is singular, and is that of their affine hull"
    warnings.warn(f"{name}: {cause}", RuntimeWarning, stacklevel=3)
    return center, q, excess


def _cause(tolerance: float, m: int, what: str, inputs: dict[str, Floats]) -> str:
    """Why C refused a call, in the words of the Python function."""
    cause = _core.last_error()
    if cause is None:
        return ""
    function, argument, requirement, row, entry, value = cause
    if argument is None:
        return requirement
    if argument == "m":
        return f"{what}: m {requirement}, not {m}"
    if argument == "points":
        argument = what
    if argument == what and math.isnan(value) and not math.isnan(inputs[what][row, entry]):  # all rows together are the cause
        return f"{what} {requirement}"
    return describe((function, argument, requirement, row, entry, value), "row", tolerance=tolerance, **inputs)


def _points(points: ArrayLike, name: str) -> Floats:
    rows = np.require(reals(points, name), np.float64, ["C", "A"])
    if rows.ndim != 2 or not 1 <= rows.shape[1] <= MAX_DIMENSION:
        raise ValueError(f"{name} must have the shape (m, n) with n from 1 to {MAX_DIMENSION}, not {rows.shape}")
    return rows


def _distances(rows: Floats, chosen: Floats) -> Floats:
    """Squares of the distances from the mean in the norm of the covariance; along directions without any variance they count as zero."""
    mean = chosen.mean(axis=0)
    values, vectors = np.linalg.eigh(np.atleast_2d(np.cov(chosen, rowvar=False, bias=True)))
    inverse = np.where(values > 1e-14 * values[-1], 1 / np.where(values > 0, values, 1), 0)
    squares: Floats = (((rows - mean) @ vectors) ** 2 * inverse).sum(axis=1)
    return squares
