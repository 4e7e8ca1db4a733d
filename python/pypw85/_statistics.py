# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of a suspension of ellipsoids: nematic order, the distribution of μ, and the pressure that follows from it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._choices import choice
from ._functions import closest_approach
from ._neighbors import neighbors
from ._arrays import reals
from ._numbers import integer, positive, real
from ._pairs import contact_pairs
from ._system import UNIT_BALL, System
from ._typing import Floats

# Numbers of pairs and directions for the average of excluded volumes. The standard deviation is about half the mean, so the error
# is 0.4 %.
_SAMPLES = 20_000


# The cubic K for which the integral of K(x) p(x) over [0, 1] is p(0) for each cubic p: Σ (2j + 1) (-1)^j P_j(2x - 1) for j = 0 to 3, with
# the polynomials P_j of Legendre.
_AT_ZERO = np.array([16.0, -120.0, 240.0, -140.0])


# A particle is a sphere if its semi-axes differ by no more than this, relatively: 16 units of rounding of single precision, in which
# some files have forms and quaternions.
_ROUND = 2.0**-20

# The density of μ - 1 is taken as a cubic polynomial up to this width at most: beyond it, the second particles around each come in.
_LARGEST_WIDTH = 1.0


class Compressibility(NamedTuple):
    """Result of `compressibility`: `value`, βP/ρ, and `error`, its standard error."""

    value: float
    error: float


class Correlation(NamedTuple):
    """Result of `correlation`: a histogram of μ over the pairs of a system, in k bins.

    `edges` (k + 1) are the edges of the bins, `pairs` (k) the numbers of pairs, and `uncorrelated` (k) the expected numbers of pairs
    without correlations. The pair correlation in μ is ``pairs / uncorrelated``.
    """

    edges: Floats
    pairs: Floats
    uncorrelated: Floats


class PairCorrelation(NamedTuple):
    """Result of `pair_correlation` in k bins of the distance.

    - `edges` (k + 1): edges of the bins, in the unit of length;
    - `g` (k): number of pairs in a shell (in two dimensions, in a ring), divided by that of an ideal gas of the same density;
    - `p2` (k): mean of 3/2 cos² θ - 1/2 over the pairs in the shell, with the angle θ between the axes of the two particles; in two
      dimensions, mean of cos 2θ. NaN without pairs. Pairs with a sphere or a disc are left out, because it has no axis;
    - `g_error`, `p2_error` (k): standard errors; NaN for a single system.
    """

    edges: Floats
    g: Floats
    g_error: Floats
    p2: Floats
    p2_error: Floats


def nematic_order(system: System) -> float:
    """Computes the nematic order, the largest eigenvalue of 3/2 <u uᵀ> - 1/2. It is 1 if all axes u are parallel.

    For N axes without order it is about 1/√N. u is the axis whose length differs most from the middle one: the long axis of rods, the
    short axis of plates. Spheres have no such axis, and are ignored. In two dimensions, u is the long axis of an ellipse, and the order
    is the largest eigenvalue of 2 <u uᵀ> - 1, which equals <cos 2θ> for the angles θ to the director. Discs are ignored.

    Parameters
    ----------
    system : System

    Returns
    -------
    float
        NaN if all particles are spheres or discs.

    Raises
    ------
    ValueError
        There are no particles.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 3, [0, 0, 1])
    >>> pypw85.nematic_order(pypw85.System([[0, 0, 0], [9, 0, 0]], [q, q]))
    1.0
    """
    return largest_order(nematic_tensor(principal_directions(system), system.dimensions))


def tetratic_order(system: System) -> float:
    """Computes the tetratic order of ellipses: the largest <cos 4(θ - φ)> over all directions φ.

    It is 1 if the long axes of all ellipses are parallel to one of two perpendicular directions, and about 1/√N for N ellipses without
    order. Discs are ignored.

    Parameters
    ----------
    system : System
        Of two dimensions.

    Returns
    -------
    float
        NaN if all particles are discs.

    Raises
    ------
    ValueError
        The system is three-dimensional, or there are no particles.
    """
    if system.dimensions != 2:
        raise ValueError("the system must be two-dimensional for the tetratic order")
    if not len(system):
        raise ValueError("the system must have particles for the tetratic order")
    x, y, _ = principal_directions(system).T
    known = ~np.isnan(x)
    return float(np.abs(np.mean((x + 1j * y)[known] ** 4))) if known.any() else np.nan


def director(system: System) -> Floats:
    """Computes the director: the eigenvector that belongs to the eigenvalue `nematic_order`.

    The result is a unit vector. Its sign has no meaning; it is chosen such that the largest coordinate by magnitude is positive.

    Parameters
    ----------
    system : System

    Returns
    -------
    (3,) array
        NaN if all particles are spheres or discs. In two dimensions its z component is 0.

    Raises
    ------
    ValueError
        There are no particles.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 3, [0, -2, 0])
    >>> pypw85.director(pypw85.System([[0, 0, 0], [9, 0, 0]], [q, q])).round(12) + 0.0
    array([0., 1., 0.])
    """
    return main_direction(nematic_tensor(principal_directions(system), system.dimensions))


def principal_directions(system: System) -> Floats:
    """Returns unit vectors (n, 3) along the axes whose lengths differ most from the middle ones, or along the longer axes of ellipses; NaN
    for spheres and discs."""
    if system.dimensions == 2:
        return _long_axes(system)
    order = np.argsort(system.semi_axes, axis=1)
    short, middle, long = np.sort(system.semi_axes, axis=1).T
    axes = np.eye(3)[np.where(long * short >= middle**2, order[:, 2], order[:, 0])]
    w, v = system.quaternions[:, :1], system.quaternions[:, 1:]
    half = _cross(v, axes)
    directions: Floats = axes + 2 * (w * half + _cross(v, half))
    directions[long - short <= _ROUND * long] = np.nan
    return directions


def _cross(a: Floats, b: Floats) -> Floats:
    """Cross products of rows. numpy.cross() gives bitwise equal results, but takes several times as long for several hundred rows."""
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=1)


def _long_axes(system: System) -> Floats:
    """Unit vectors along the longer axes of ellipses; NaN for discs."""
    first, second, _ = system.semi_axes.T
    angles = system.angles + np.where(first < second, np.pi / 2, 0.0)
    directions: Floats = np.stack([np.cos(angles), np.sin(angles), np.zeros(len(angles))], axis=1)
    directions[np.abs(first - second) <= _ROUND * np.maximum(first, second)] = np.nan
    return directions


def nematic_tensor(directions: Floats, dimensions: int = 3) -> Floats:
    """Returns (d <u uᵀ> - 1)/(d - 1) in d dimensions, over the directions u that are not NaN; NaN if all are NaN."""
    if not len(directions):
        raise ValueError("the system must have particles for the nematic order")
    known = directions[~np.isnan(directions[:, 0])]
    if not len(known):
        return np.full((3, 3), np.nan)
    # Of directions in the plane, the eigenvalue for z is -1: never the largest one.
    tensor: Floats = (dimensions * known.T @ known / len(known) - np.eye(3)) / (dimensions - 1)
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


def compressibility(mu2: Iterable[ArrayLike], num_particles: int, width: float = 0.1, dimensions: int = 3) -> Compressibility:
    """Computes βP/ρ of hard ellipsoids from the pairs that nearly touch.

    If a cell and all centres shrink by a factor 1 - ε, the pairs with μ < 1/(1 - ε) overlap. Therefore the virial theorem is

        βP/ρ = 1 + n'(0)/(d N)

    in d dimensions, where n(ε) is the mean number of pairs with μ < 1 + ε. The derivative is extrapolated by a cubic polynomial on
    [0, `width`], as a sum over the pairs. The bias is of the order of `width` to the fourth power; the error falls with its square root.

    Parameters
    ----------
    mu2 : iterable of array_like
        One array of μ² for each configuration. It must contain all pairs with μ < 1 + `width`, and may contain others. Use
        `contact_pairs` with the list of ``System.neighbors(1 + width)``.
    num_particles : int
        Number N of particles in each configuration.
    width : float
        Width of the interval of μ - 1 that is extrapolated to contact, > 0 and at most 1. It must be small compared with the scale on
        which the density of μ changes.
    dimensions : int
        d: 3 for ellipsoids, 2 for ellipses.

    Returns
    -------
    Compressibility
        The error is valid for independent configurations. If they are correlated, call the function once for each block of them, and
        estimate the error from the values. If no pair is within the width, the error is NaN: use a larger width.

    Raises
    ------
    ValueError
        A pair overlaps, or its μ² is NaN; there are fewer than two configurations, or no particles; `width` is not > 0 and at most 1;
        or `dimensions` is neither 2 nor 3.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> start = pypw85.pack(np.tile([0.5, 0.5, 1], (50, 1)), 0.3, seed=1)
    >>> simulation = pypw85.HardEllipsoids(start)
    >>> simulation.tune(20)
    >>> mu2 = []
    >>> for _ in range(50):
    ...     simulation.sweep(5)
    ...     s = simulation.system()
    ...     near = s.neighbors(1.1)
    ...     others = {"cell": s.cell, "images": near.images}
    ...     found = pypw85.contact_pairs(near.pairs, s.centers, s.q, **others)
    ...     mu2.append(found[0])
    >>> found = pypw85.compressibility(mu2, num_particles=50)
    >>> bool(3 < found.value < 6)
    True
    """
    choice(dimensions, "compressibility: dimensions", UNIT_BALL)
    num_particles = integer(num_particles, "compressibility: num_particles", 1)
    check_width("compressibility", width)
    values: list[float] = []
    near = 0
    for one in mu2:
        excess = np.sqrt(reals(one, f"compressibility: mu2 of configuration {len(values)}")) - 1.0
        if not (excess >= 0).all():
            raise ValueError(f"a pair of configuration {len(values)} overlaps, or its μ² is NaN")
        values.append(compressibility_of(excess, num_particles, width, dimensions))
        near += int((excess < width).sum())
    if len(values) < 2:
        raise ValueError(f"there must be at least two configurations for an error, not {len(values)}")
    error = np.std(values, ddof=1) / np.sqrt(len(values)) if near else np.nan
    return Compressibility(float(np.mean(values)), float(error))


def check_width(name: str, width: float) -> None:
    """Checks that the width is in the range that allows an extrapolation."""
    if not 0 < real(width, f"{name}: width") <= _LARGEST_WIDTH:
        raise ValueError(f"{name}: width must be > 0 and at most {_LARGEST_WIDTH:g}, not {width}")


def compressibility_of(excess: Floats, num_particles: int, width: float, dimensions: int = 3) -> float:
    """The estimate of `compressibility` from one configuration, whose pairs have μ - 1 = `excess`."""
    near = excess[excess < width] / width
    return float(1 + np.polynomial.polynomial.polyval(near, _AT_ZERO).sum() / (dimensions * num_particles * width))


def pair_correlation(systems: System | Iterable[System], reach: float, bins: int = 50) -> PairCorrelation:
    """Computes the pair correlation as a function of distance, and the orientational correlation of pairs.

    The number of pairs in each shell (in two dimensions, in each ring) is divided by that of an ideal gas of the same density.

    Parameters
    ----------
    systems : System or iterable of System
        Systems with cells. The error is valid for independent configurations, and NaN for a single one.
    reach : float
        Largest distance, > 0. It may exceed the cell: all images count, except those of the particle itself.
    bins : int
        Number of bins between 0 and `reach`.

    Returns
    -------
    PairCorrelation
        Means over the systems.

    Raises
    ------
    ValueError
        There is no cell, or it is not periodic along all its vectors; there is no system, or the systems have different numbers of
        dimensions; reach or bins are not positive.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> random = np.random.default_rng(1)
    >>> places, angles = random.uniform(0, 40, (2000, 2)), random.uniform(0, 3, 2000)
    >>> gas = pypw85.System.from_ellipses(places, [[1, 0.5]] * 2000, angles, 40 * np.eye(2))
    >>> found = pypw85.pair_correlation(gas, reach=4, bins=2)
    >>> bool(np.abs(found.g - 1).max() < 0.05)
    True
    """
    reach, bins = positive(reach, "pair_correlation: reach"), integer(bins, "pair_correlation: bins", 1)
    edges = np.linspace(0, reach, bins + 1, dtype=np.float64)
    found, dimensions = [], set()
    for system in [systems] if isinstance(systems, System) else systems:
        found.append(count_pairs(system, principal_directions(system), edges))
        dimensions.add(system.dimensions)
    if len(dimensions) != 1:
        raise ValueError("pair_correlation: there must be at least one system, and all must have the same dimensions")
    rows = np.array(found)
    counts, axial, weighted = rows.mean(axis=0)[:3]
    with np.errstate(invalid="ignore", divide="ignore"):
        p2 = weighted / axial
        # Of a ratio of means: the error of the numbers weighted - p2 axial, whose mean is 0
        errors = [np.std(one, axis=0, ddof=1) / np.sqrt(len(rows)) if len(rows) > 1 else np.full(bins, np.nan)
                  for one in (rows[:, 0], (rows[:, 2] - p2 * rows[:, 1]) / axial)]  # fmt: skip
    return PairCorrelation(edges, counts, errors[0], p2, errors[1])


def count_pairs(system: System, directions: Floats, edges: Floats) -> Floats:
    """For each bin of distances the pairs over those of an ideal gas, the same of pairs with axes, this times the mean of 3/2 cos² - 1/2
    or, in two dimensions, cos 2θ of their angles, and the sum of the last two: (4, bins)."""
    n, volume, dimensions = len(system), system.volume, system.dimensions
    if system.cell is None or volume is None or not all(system.periodic[:dimensions]):
        raise ValueError("a pair correlation needs a cell that is periodic along its vectors, for the density: pass cell (of a file: "
                         "--cell)")  # fmt: skip
    reach, bins = edges[-1], len(edges) - 1
    ball = np.array([1, 0, 0, 1, 0, 1]) * (reach / 2) ** 2  # two balls of this radius meet at this distance
    found = neighbors(system.centers, np.tile(ball, (n, 1)), system.cell, system.periodic)
    first, second = found.pairs.T
    distance = np.linalg.norm(system.centers[second] + found.images @ system.cell - system.centers[first], axis=1)
    p2 = (dimensions * np.einsum("ij,ij->i", directions[first], directions[second]) ** 2 - 1) / (dimensions - 1)
    # The images of a particle itself are always there. They are not counted.
    chosen = np.flatnonzero((distance < reach) & (first != second))
    numbers = np.minimum(distance[chosen] * (bins / reach), bins - 1).astype(np.intp)
    ideal = n * (n - 1) / 2 / volume * UNIT_BALL[dimensions] * np.diff(edges**dimensions)
    with np.errstate(invalid="ignore"):  # for one particle, which has no others
        have_axes = ~np.isnan(p2[chosen])
        weights = np.ones(len(numbers)), have_axes, np.where(have_axes, p2[chosen], 0)
        counts, axial, weighted = (np.bincount(numbers, row, bins) / ideal for row in weights)
    return np.array([counts, axial, weighted, axial + weighted])


def correlation(system: System, reach: float = 2.0, bins: int = 100) -> Correlation:
    """Computes the histogram of μ over pairs with μ < `reach`, and the histogram that is expected without correlations.

    Without correlations, the centre of the second particle is uniform in the cell of volume V. Then μ < m with the probability m³ E / V,
    where E is the excluded volume of the pair, the mean over directions of 4π/3 (distance of closest approach)³. In two dimensions the
    probability is m² E / A, with the area A of the cell and the excluded area E, the mean of π (distance of closest approach)².

    Parameters
    ----------
    system : System
        Must have a cell.
    reach : float
        Largest μ, > 0.
    bins : int
        Number of bins between 0 and `reach`, at least 1.

    Returns
    -------
    Correlation

    Raises
    ------
    ValueError
        There is no cell; there are no particles; or `reach` or `bins` is not positive.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> system = pypw85.pack(np.tile([0.5, 0.5, 1], (50, 1)), 0.3, seed=1)
    >>> found = pypw85.correlation(system, reach=1.5, bins=3)
    >>> found.edges, found.pairs[:2]  # no pair overlaps
    (array([0. , 0.5, 1. , 1.5]), array([0., 0.]))
    """
    dimensions, volume = system.dimensions, system.volume
    reach, bins = positive(reach, "correlation: reach"), integer(bins, "correlation: bins", 1)
    if volume is None:
        raise ValueError("a pair correlation needs a cell, for the density: pass cell (of a file: --cell)")
    if not len(system):
        raise ValueError("correlation: the system must have particles")
    found = system.neighbors(reach)
    mu2 = contact_pairs(found.pairs, system.centers, system.q, system.cell, images=found.images)[0]
    edges = np.linspace(0, reach, bins + 1, dtype=np.float64)
    random = np.random.default_rng(0)
    first, second = random.integers(0, len(system), (2, _SAMPLES))
    directions = random.normal(size=(_SAMPLES, 3))
    directions[:, dimensions:] = 0
    distance = closest_approach(directions, system.q[first], system.q[second])
    excluded = UNIT_BALL[dimensions] * (distance**dimensions).mean()
    density = 0.5 * len(system) ** 2 * excluded / volume
    return Correlation(edges, np.histogram(np.sqrt(mu2), edges)[0].astype(np.float64), density * np.diff(edges**dimensions))
