# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of a suspension of ellipsoids: nematic order, the distribution of μ, and the pressure that follows from it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._functions import closest_approach
from ._pairs import contact_pairs
from ._system import System
from ._typing import Floats

# Numbers of pairs and directions for the average of excluded volumes. The standard deviation is about half the mean, so the error
# is 0.4 %.
_SAMPLES = 20_000


# The cubic K for which the integral of K(x) p(x) over [0, 1] is p(0) for each cubic p: Σ (2j + 1) (-1)^j P_j(2x - 1) for j = 0 to 3, with
# the polynomials P_j of Legendre.
_AT_ZERO = np.polynomial.Polynomial([16, -120, 240, -140])


# A particle is a sphere if its semi-axes differ by no more than this, relatively: 16 units of rounding of single precision, in which
# some files have forms and quaternions.
_ROUND = 2.0**-20

# The density of μ - 1 is taken for a cubic up to this width at most: beyond it, the second particles around each come in.
_LARGEST_WIDTH = 1.0


class Compressibility(NamedTuple):
    """βP/ρ and its standard error."""

    value: float
    error: float


class Correlation(NamedTuple):
    """Pairs by μ: `edges` (k + 1) of bins, how many pairs are in each, and how many there would be without correlation."""

    edges: Floats
    pairs: Floats
    uncorrelated: Floats


def nematic_order(system: System) -> float:
    """The largest eigenvalue of 3/2 <u uᵀ> - 1/2: 1 if all axes u are parallel, 0 on average if they have no order.

    u is the axis whose length differs most from the middle one: the long axis of rods, the short one of plates. Spheres have none, and do
    not count.

    Parameters
    ----------
    system : System

    Returns
    -------
    float
        NaN if all particles are spheres.
    """
    return largest_order(nematic_tensor(principal_directions(system)))


def director(system: System) -> Floats:
    """The direction of the nematic order: the eigenvector for the eigenvalue that is `nematic_order`.

    It is a unit vector. Since u and -u are the same direction, its coordinate of the largest magnitude is positive.

    Parameters
    ----------
    system : System

    Returns
    -------
    (3,) array
        NaN if all particles are spheres.
    """
    return main_direction(nematic_tensor(principal_directions(system)))


def principal_directions(system: System) -> Floats:
    """Unit vectors (n, 3) along the axes whose lengths differ most from the middle ones; NaN for spheres, which have no such axes."""
    system.require_three_dimensions("the nematic order")
    order = np.argsort(system.semi_axes, axis=1)
    short, middle, long = np.take_along_axis(system.semi_axes, order, axis=1).T
    axes = np.eye(3)[np.where(long * short >= middle**2, order[:, 2], order[:, 0])]
    w, v = system.quaternions[:, :1], system.quaternions[:, 1:]
    half = np.cross(v, axes)
    directions: Floats = axes + 2 * (w * half + np.cross(v, half))
    directions[long - short <= _ROUND * long] = np.nan
    return directions


def nematic_tensor(directions: Floats) -> Floats:
    """3/2 <u uᵀ> - 1/2 of the directions that are not NaN; NaN if all are."""
    if not len(directions):
        raise ValueError("nematic order needs particles: there are none")
    known = directions[~np.isnan(directions[:, 0])]
    if not len(known):
        return np.full((3, 3), np.nan)
    tensor: Floats = 1.5 * known.T @ known / len(known) - 0.5 * np.eye(3)
    return tensor


def largest_order(tensor: Floats) -> float:
    """The largest eigenvalue."""
    return float(np.linalg.eigvalsh(tensor)[2]) if np.isfinite(tensor).all() else np.nan


def main_direction(tensor: Floats) -> Floats:
    """The eigenvector for the largest eigenvalue, with the sign of `director`."""
    if not np.isfinite(tensor).all():
        return np.full(3, np.nan)
    found = np.linalg.eigh(tensor)[1][:, 2]
    direction: Floats = found * np.sign(found[np.abs(found).argmax()])
    return direction


def compressibility(mu2: Iterable[ArrayLike], num_particles: int, width: float = 0.1) -> Compressibility:
    """βP/ρ of hard ellipsoids, from the pairs that nearly touch.

    If a cell and all centres shrink by a factor 1 - ε, the pairs with μ < 1/(1 - ε) overlap. So the virial theorem reads

        βP/ρ = 1 + n'(0)/(3 N),

    where n(ε) is the mean number of pairs with μ < 1 + ε. The derivative is extrapolated by a cubic polynomial on [0, `width`], as a sum
    over the pairs. The bias is of the order of `width` to the fourth power; the error falls with its square root.

    Parameters
    ----------
    mu2 : iterable of array_like
        μ² of pairs, an array for each configuration: of all pairs with μ < 1 + `width` and any others, as `contact_pairs` gives them for
        `System.neighbors`.
    num_particles : int
    width : float
        Of the interval of μ, which must be small compared with the scale on which the density of μ changes.

    Returns
    -------
    Compressibility
        The error is right for independent configurations. Otherwise estimate it from blocks, with one call for each block. If no pair is
        within the width, it is NaN: the width is too small.

    Raises
    ------
    ValueError
        A pair overlaps, or its μ² is NaN; there are fewer than two configurations or no particles; or the width is not > 0 and at most 1.
    """
    if num_particles < 1:
        raise ValueError(f"compressibility: num_particles is {num_particles}: it must be at least 1")
    check_width("compressibility", width)
    values: list[float] = []
    near = 0
    for one in mu2:
        excess = np.sqrt(np.asarray(one, dtype=np.float64)) - 1.0
        if not (excess >= 0).all():
            raise ValueError(f"a pair of configuration {len(values)} overlaps, or its μ² is NaN")
        values.append(compressibility_of(excess, num_particles, width))
        near += int((excess < width).sum())
    if len(values) < 2:
        raise ValueError(f"an error needs two configurations or more, not {len(values)}")
    error = np.std(values, ddof=1) / np.sqrt(len(values)) if near else np.nan
    return Compressibility(float(np.mean(values)), float(error))


def check_width(name: str, width: float) -> None:
    """Refuses a width for which no extrapolation makes sense."""
    if not 0 < width <= _LARGEST_WIDTH:
        raise ValueError(f"{name}: width is {width}: it must be > 0 and at most {_LARGEST_WIDTH:g}")


def compressibility_of(excess: Floats, num_particles: int, width: float) -> float:
    """The estimate of `compressibility` from one configuration, whose pairs have μ - 1 = `excess`."""
    near = excess[excess < width] / width
    return float(1 + _AT_ZERO(near).sum() / (3 * num_particles * width))


def correlation(system: System, reach: float = 2.0, bins: int = 100) -> Correlation:
    """Pairs with μ < `reach`, binned; the cell must be given.

    Without correlation, the second centre is anywhere: μ < m with the probability m³ E / V, where E is the volume that
    the first excludes for the second, the mean over directions of 4π/3 (distance of closest approach)³.

    Parameters
    ----------
    system : System
    reach : float
        Largest μ.
    bins : int
        How many there are between 0 and `reach`.

    Returns
    -------
    Correlation

    Raises
    ------
    ValueError
        There is no cell.
    """
    system.require_three_dimensions("a pair correlation")
    if system.cell is None:
        raise ValueError("a pair correlation needs a cell, for the density: give one (--cell)")
    found = system.neighbors(reach)
    mu2 = contact_pairs(found.pairs, system.centers, system.q, system.cell, images=found.images)[0]
    edges = np.linspace(0, reach, bins + 1, dtype=np.float64)
    random = np.random.default_rng(0)
    first, second = random.integers(0, len(system), (2, _SAMPLES))
    distance = closest_approach(random.normal(size=(_SAMPLES, 3)), system.q[first], system.q[second])
    excluded = 4 / 3 * np.pi * (distance**3).mean()
    density = 0.5 * len(system) ** 2 * excluded / abs(np.linalg.det(system.cell))
    return Correlation(edges, np.histogram(np.sqrt(mu2), edges)[0].astype(np.float64), density * np.diff(edges**3))
