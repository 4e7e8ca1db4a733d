# SPDX-License-Identifier: BSD-3-Clause
"""Structure of a suspension of ellipsoids: structure factor, layers and columns, bond order, angular correlations, displacements."""

from __future__ import annotations

import warnings
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._blocking import Blocking
from ._choices import choice
from ._neighbors import neighbors
from ._numbers import integer, positive, real
from ._statistics import director, principal_directions
from ._system import UNIT_BALL, System
from ._typing import Floats
from ._words import shown

Ints = NDArray[np.int64]

# Particles whose phases are in memory at the same time
_CHUNK = 4096
# Two wave vectors belong to one set of layers if the angle between them is smaller.
_LEAST_ANGLE = np.radians(30.0)
# Without limits, layers are as far apart as half the longest diameter to twice it.
_USUAL_SPACING = np.array([0.5, 2.0])

# More samples do not fit into any memory.
_LONGEST_LAG = 2**31 - 1


class StructureFactor(NamedTuple):
    """Result of `structure_factor`: S(q) in bins of the length of the wave vectors.

    - `edges` (k + 1): edges of the bins, in the inverse unit of length;
    - `vectors` (k): number of wave vectors in each bin, as a mean over the systems; q and -q count as one vector;
    - `q` (k): mean length of these vectors; NaN in a bin without vectors;
    - `s` (k): mean structure factor; NaN in a bin without vectors;
    - `s_error` (k): standard error of `s`, by `Blocking`; NaN for fewer than 32 systems.
    """

    edges: Floats
    vectors: Floats
    q: Floats
    s: Floats
    s_error: Floats


class LayerOrder(NamedTuple):
    """Result of `smectic_order` and `columnar_order`.

    - `order`: \\|<exp(i q·r)>\\|, the mean over the centres r of the particles; from 0 to 1;
    - `wave_vector` (3): the wave vector q;
    - `spacing`: the distance of the layers, 2π/\\|q\\|.

    All three are NaN, with a warning, if the cell has no wave vector within the limits of angle and spacing.
    """

    order: float
    wave_vector: Floats
    spacing: float


class BondOrder(NamedTuple):
    """Result of `bond_order` for n particles and k degrees l.

    - `local` (n, k): Q_l of the bonds of each particle; NaN for a particle without bonds, or with a bond to a coincident centre;
    - `mean` (k): Q_l of all bonds of the system, by the mean of Y_lm over these;
    - `bonds` (n): number of bonds of each particle.
    """

    local: Floats
    mean: Floats
    bonds: Ints


class AngularPairCorrelation(NamedTuple):
    """Result of `angular_pair_correlation` in k bins of the distance and m bins of \\|cos θ\\|.

    - `edges` (k + 1): edges of the bins of the distance, in the unit of length;
    - `cosines` (m + 1): edges of the bins of \\|cos θ\\|, from 0 to 1;
    - `g` (k, m): pair correlation; 1 in an ideal gas;
    - `g_error` (k, m): standard errors, by `Blocking`; NaN for fewer than 32 systems.
    """

    edges: Floats
    cosines: Floats
    g: Floats
    g_error: Floats


class Displacements(NamedTuple):
    """Result of `mean_square_displacement` for k lags.

    - `lags` (k): numbers of samples between start and end, as given;
    - `translation` (k): mean square displacement of a particle, in the square of the unit of length;
    - `rotation` (k): mean square rotation of the axis of a particle, in radians squared; NaN without axes;
    - `translation_error`, `rotation_error` (k): standard errors, by `Blocking`; NaN for fewer than 32 starts.
    """

    lags: Ints
    translation: Floats
    translation_error: Floats
    rotation: Floats
    rotation_error: Floats


# More multiples of one reciprocal vector than memory can hold; whole numbers of 64 bits hold it and its double.
_MOST_MULTIPLE = 2.0**40


def wave_vectors(system: System, reach: float) -> tuple[Ints, Floats]:
    """Wave vectors of a periodic cell up to a given length. Of q and -q only one is listed, and 0 is not listed.

    Parameters
    ----------
    system : System
        Must have a cell that is periodic along all its vectors (in two dimensions, along two).
    reach : float
        Largest length of a wave vector, in the inverse unit of length, > 0.

    Returns
    -------
    multiples : (k, 3) array of int
        The wave vectors as multiples of the reciprocal vectors. In two dimensions the third multiple is 0.
    vectors : (k, 3) array
        The wave vectors q, one in each row: the multiples times 2π times the transposed inverse of the cell.

    Raises
    ------
    ValueError
        There is no cell, or it is not periodic along its vectors; or `reach` is not positive.
    MemoryError
        There is not enough memory for the wave vectors.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> system = pypw85.System([[0, 0, 0]], [[1, 0, 0, 1, 0, 1]], cell=10 * np.eye(3))
    >>> multiples, vectors = pypw85.wave_vectors(system, reach=0.7)
    >>> multiples.tolist(), vectors[0].round(4).tolist()
    ([[0, 0, 1], [0, 1, 0], [1, 0, 0]], [0.0, 0.0, 0.6283])
    """
    reciprocal, reach = _reciprocal(system), positive(reach, "wave_vectors: reach")
    assert system.cell is not None
    # |n_k| = |q·a_k|/2π <= |q| |a_k|/2π for the vectors a_k of the cell
    multiple = np.linalg.norm(system.cell, axis=1)[: system.dimensions] * reach / (2 * np.pi)
    if not multiple.max() < _MOST_MULTIPLE:
        raise MemoryError(f"there is not enough memory for all wave vectors up to the length {reach:g}")
    most = np.zeros(3, dtype=np.int64)
    most[: system.dimensions] = np.floor(multiple)
    multiples = np.stack(np.meshgrid(*(np.arange(-m, m + 1) for m in most), indexing="ij"), axis=-1).reshape(-1, 3)
    multiples = multiples[len(multiples) // 2 + 1 :]  # the others are their negatives, and 0 is between them
    vectors = multiples @ reciprocal
    chosen = np.linalg.norm(vectors, axis=1) <= reach
    return multiples[chosen], vectors[chosen]


def _integers(values: Iterable[int], name: str, least: int, most: int | None = None) -> list[int]:
    try:
        return [integer(value, f"{name}[{k}]", least, most) for k, value in enumerate(values)]
    except TypeError as error:
        raise error if name in str(error) else TypeError(f"{name} must be a list of integers, not {shown(values)}") from None


def _reciprocal(system: System) -> Floats:
    """The reciprocal vectors as rows."""
    if system.cell is None or system.volume is None or not all(system.periodic[: system.dimensions]):
        raise ValueError("wave vectors need a cell that is periodic along its vectors: pass cell (of a file: --cell)")
    vectors: Floats = 2 * np.pi * np.linalg.inv(system.cell).T
    return vectors


def density_modes(system: System, multiples: ArrayLike) -> NDArray[np.complex128]:
    """Fourier modes of the density: Σ exp(i q·r) over the centres r of the particles, for wave vectors q of the cell.

    Parameters
    ----------
    system : System
        Must have a cell that is periodic along all its vectors (in two dimensions, along two).
    multiples : (k, 3) array_like of int
        Wave vectors as multiples of the reciprocal vectors, such as the first result of `wave_vectors`.

    Returns
    -------
    (k,) array of complex

    Raises
    ------
    ValueError
        There is no cell, or it is not periodic along its vectors; the multiples are not rows of three integers; or, in two dimensions,
        a third multiple is not 0.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> ball = [1, 0, 0, 1, 0, 1]
    >>> two = pypw85.System([[0, 0, 0], [2.5, 0, 0]], [ball, ball], cell=10 * np.eye(3))
    >>> pypw85.density_modes(two, [[2, 0, 0], [4, 0, 0]]).round(12).real + 0.0
    array([0., 2.])
    """
    reciprocal, numbers = _reciprocal(system), np.asarray(multiples)
    if numbers.ndim != 2 or numbers.shape[1] != 3 or not np.issubdtype(numbers.dtype, np.integer):
        raise ValueError("density_modes: multiples must be rows of three integers")
    if system.dimensions == 2 and numbers[:, 2].any():
        raise ValueError("density_modes: the third multiple must be 0 in two dimensions")
    modes = np.zeros(len(numbers), dtype=np.complex128)
    if not len(numbers):
        return modes
    least, most = numbers.min(axis=0), numbers.max(axis=0)
    places = (system.centers - system.origin) @ reciprocal.T  # 2π times the coordinates in the cell
    for start in range(0, len(places), _CHUNK):
        # The phase of each multiple along each axis. Along the last axis the sums over particles are products of matrices.
        x, y, z = (np.exp(1j * np.outer(np.arange(a, b + 1), row)) for a, b, row in zip(least, most, places[start : start + _CHUNK].T))
        for first in np.unique(numbers[:, 0]):
            rows = np.flatnonzero(numbers[:, 0] == first)
            sums = (x[first - least[0]] * y) @ z.T
            modes[rows] += sums[numbers[rows, 1] - least[1], numbers[rows, 2] - least[2]]
    return modes


def structure_factor(systems: System | Iterable[System], reach: float, bins: int = 50) -> StructureFactor:
    """Static structure factor S(q) = \\|Σ exp(i q·r)\\|²/N of the centres r, averaged over the directions of q.

    The function uses the wave vectors of the periodic cell (`wave_vectors`), because S has a meaning only for these. The smallest q is
    2π over the edge of the cell, so small q need a large cell. In an ideal gas S = 1. In a fluid, 1/S(0) is the derivative of βP with
    respect to the density.

    Parameters
    ----------
    systems : System or iterable of System
        Samples, in the order in which a simulation gave them. Each cell must be periodic along all its vectors.
    reach : float
        Largest length of q, in the inverse unit of length, > 0.
    bins : int
        Number of bins between 0 and `reach`, at least 1.

    Returns
    -------
    StructureFactor

    Raises
    ------
    ValueError
        A cell is not periodic along its vectors; a system has no particles; there is no system; or `reach` or `bins` is not positive.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> places = np.random.default_rng(1).uniform(0, 20, (1000, 3))
    >>> gas = pypw85.System(places, [[1, 0, 0, 1, 0, 1]] * 1000, 20 * np.eye(3))
    >>> found = pypw85.structure_factor(gas, reach=4, bins=4)
    >>> bool(np.abs(found.s[1:] - 1).max() < 0.2)
    True
    """
    bins, reach = integer(bins, "structure_factor: bins", 1), positive(reach, "structure_factor: reach")
    edges, averages = np.linspace(0, reach, bins + 1, dtype=np.float64), Blocking(3 * bins)
    for system in _all_systems(systems, "structure_factor"):
        multiples, vectors = wave_vectors(system, reach)
        length = np.linalg.norm(vectors, axis=1)
        s = np.abs(density_modes(system, multiples)) ** 2 / len(system)
        numbers = np.minimum(length * (bins / reach), bins - 1).astype(np.intp)
        averages.add(np.concatenate([np.bincount(numbers, row, bins) for row in (np.ones(len(s)), length, s)]))
    vectors_of_bins, lengths, sums = averages.estimate().value.reshape(3, bins)
    with np.errstate(invalid="ignore", divide="ignore"):
        s, q = sums / vectors_of_bins, lengths / vectors_of_bins
        error = averages.estimate().error.reshape(3, bins)[2] / vectors_of_bins
    return StructureFactor(edges, vectors_of_bins, q, s, error)


def _all_systems(systems: System | Iterable[System], name: str) -> Iterator[System]:
    """Systems of the same dimensions, with particles. There is at least one."""
    dimensions = set()
    for system in [systems] if isinstance(systems, System) else systems:
        dimensions.add(system.dimensions)
        if len(dimensions) > 1 or not len(system):
            raise ValueError(f"{name}: each system must have particles, and all must have the same dimensions")
        yield system
    if not dimensions:
        raise ValueError(f"{name}: there must be at least one system")


def smectic_order(system: System, axis: ArrayLike | None = None, spacing: ArrayLike | None = None, angle: float = 15.0) -> LayerOrder:
    """Computes the smectic order: the largest \\|<exp(i q·r)>\\| over the wave vectors q of the cell nearly parallel to an axis.

    The order is 1 if all centres lie in equally spaced planes perpendicular to q. Without layers it is about √(ln M / N) for M wave
    vectors and N particles. A crystal also consists of layers, and has a large order.

    Parameters
    ----------
    system : System
        Must have a cell that is periodic along all its vectors (in two dimensions, along two).
    axis : (3) array_like, optional
        Normal of the layers, a vector of any length > 0. By default the `director`.
    spacing : (2) array_like, optional
        Smallest and largest distance between two layers. By default half the longest diameter of a particle, and twice this diameter.
    angle : float
        Largest angle between q and the axis, in degrees, from 0 to 90. Layers must fit into the periodic cell. Therefore they can be
        slightly oblique to the axis, and an angle of 0 may exclude them.

    Returns
    -------
    LayerOrder

    Raises
    ------
    ValueError
        The cell is not periodic along its vectors; there are no particles; or `axis`, `spacing` or `angle` is out of range.

    Examples
    --------
    Four layers of spheres, 2.5 apart along z:

    >>> import numpy as np, pypw85
    >>> centers = np.random.default_rng(1).uniform(0, 10, (400, 3))
    >>> centers[:, 2] = np.repeat([0, 2.5, 5, 7.5], 100)
    >>> q = [[0.01, 0, 0, 0.01, 0, 0.01]] * 400
    >>> system = pypw85.System(centers, q, cell=10 * np.eye(3))
    >>> found = pypw85.smectic_order(system, axis=[0, 0, 1], spacing=[1, 4])
    >>> round(found.order, 12), round(found.spacing, 12)
    (1.0, 2.5)
    """
    cosine, vectors, order = _modes_by_angle(system, axis, spacing, angle, "smectic_order")
    chosen = np.flatnonzero(np.abs(cosine) >= np.cos(np.radians(angle)))
    return _largest(vectors[chosen], order[chosen], "smectic_order", f"within {angle:g}° of the axis")


def columnar_order(
    system: System, axis: ArrayLike | None = None, spacing: ArrayLike | None = None, angle: float = 15.0
) -> tuple[LayerOrder, LayerOrder]:
    """Computes the columnar order: the two largest \\|<exp(i q·r)>\\| over wave vectors q nearly perpendicular to an axis.

    The angle between the two wave vectors is at least 30°. Columns along the axis give two large orders; layers that contain the axis
    give only one. Therefore the second order is the order of the columns. A crystal also has columns.

    Parameters
    ----------
    system : System
        Three-dimensional, with a cell that is periodic along all its vectors.
    axis : (3) array_like, optional
        Direction of the columns, a vector of any length > 0. By default the `director`.
    spacing : (2) array_like, optional
        Smallest and largest distance between two rows of columns. By default half the longest diameter of a particle, and twice this
        diameter.
    angle : float
        Largest angle between q and the plane perpendicular to the axis, in degrees, from 0 to 90.

    Returns
    -------
    first, second : LayerOrder
        The largest order, and the largest one at least 30° away from the first.

    Raises
    ------
    ValueError
        As for `smectic_order`, or the system is two-dimensional.
    """
    if system.dimensions == 2:
        raise ValueError("columnar_order: the system must be three-dimensional")
    cosine, vectors, order = _modes_by_angle(system, axis, spacing, angle, "columnar_order")
    chosen = np.flatnonzero(np.abs(cosine) <= np.sin(np.radians(angle)))
    vectors, order = vectors[chosen], order[chosen]
    first = _largest(vectors, order, "columnar_order", f"within {angle:g}° of the plane across the axis")
    if np.isnan(first.order):
        return first, first
    with np.errstate(invalid="ignore"):
        between = np.abs(vectors @ first.wave_vector) / (np.linalg.norm(vectors, axis=1) * np.linalg.norm(first.wave_vector))
    others = np.flatnonzero(between <= np.cos(_LEAST_ANGLE))
    return first, _largest(vectors[others], order[others], "columnar_order", "across the axis and 30° from the first one")


def _modes_by_angle(
    system: System, axis: ArrayLike | None, spacing: ArrayLike | None, angle: float, name: str
) -> tuple[Floats, Floats, Floats]:
    """For the wave vectors within the limits of the spacing: the cosine of the angle to the axis, the vector, |<exp(i q·r)>|."""
    if not len(system):
        raise ValueError(f"{name}: the system must have particles")
    along = director(system) if axis is None else np.asarray(axis, dtype=np.float64)
    limits = _USUAL_SPACING * 2 * system.semi_axes.max() if spacing is None else np.asarray(spacing, dtype=np.float64)
    if along.shape != (3,) or not 0 < np.linalg.norm(along) < np.inf:
        raise ValueError(f"{name}: axis must be three finite numbers that are not all 0: pass one if the particles have no director")
    if limits.shape != (2,) or not 0 < limits[0] <= limits[1] < np.inf:
        raise ValueError(f"{name}: spacing must be two positive numbers, the smaller one first, not {limits.tolist()}")
    if not 0 <= real(angle, f"{name}: angle") <= 90:
        raise ValueError(f"{name}: angle must be from 0 to 90, not {angle}")
    # The limits take part, in spite of rounding errors.
    multiples, vectors = wave_vectors(system, 2 * np.pi / limits[0] * (1 + 2.0**-40))
    length = np.linalg.norm(vectors, axis=1)
    chosen = np.flatnonzero(length * (1 + 2.0**-40) >= 2 * np.pi / limits[1])
    order = np.abs(density_modes(system, multiples[chosen])) / len(system)
    return vectors[chosen] @ along / (length[chosen] * np.linalg.norm(along)), vectors[chosen], order


def _largest(vectors: Floats, order: Floats, name: str, where: str) -> LayerOrder:
    """The largest order of some wave vectors. Warns if there are none, where they should be."""
    if not len(order):
        warnings.warn(f"{name}: no wave vector of the cell is {where} and within the limits of spacing: there is no order", stacklevel=3)
        return LayerOrder(np.nan, np.full(3, np.nan), np.nan)
    k = order.argmax()
    return LayerOrder(float(order[k]), vectors[k], float(2 * np.pi / np.linalg.norm(vectors[k])))


def bond_order(system: System, degrees: Sequence[int] = (4, 6), nearest: int | None = 12, reach: float | None = None) -> BondOrder:
    """Steinhardt's bond order Q_l = √(4π/(2l + 1) Σ \\|<Y_lm>\\|²) of the directions from each particle to its neighbours.

    The sum is over m from -l to l, and the mean <Y_lm> is over the bonds (Steinhardt et al., Phys. Rev. B 28, 784, 1983). With 12
    neighbours, Q4 and Q6 are 0.1909 and 0.5745 in a face-centred cubic lattice, and 0.0972 and 0.4848 in a hexagonal close packing. With
    14 neighbours, they are 0.0364 and 0.5107 in a body-centred cubic lattice. If the number of neighbours is not clear, use the Python
    package freud, which defines bonds by Voronoi cells.

    Parameters
    ----------
    system : System
        Three-dimensional. Along the periodic vectors of a cell, images are neighbours, too.
    degrees : sequence of int
        The degrees l, at least 0.
    nearest : int or None
        Number of neighbours of each particle: those with the nearest centres. Pass None to use `reach`.
    reach : float, optional
        Instead of `nearest`: all particles whose centres are at most this far away are neighbours.

    Returns
    -------
    BondOrder

    Raises
    ------
    ValueError
        The system is two-dimensional; neither or both of `nearest` and `reach` are given; one of them is not positive; a degree is
        negative; or a particle has fewer than `nearest` neighbours.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> corners = np.stack(np.meshgrid(*[np.arange(4)] * 3), axis=-1).reshape(-1, 1, 3)
    >>> basis = np.array([[0, 0, 0], [0, 1, 1], [1, 0, 1], [1, 1, 0]]) / 2
    >>> fcc = (corners + basis).reshape(-1, 3)
    >>> crystal = pypw85.System(fcc, [[0.01, 0, 0, 0.01, 0, 0.01]] * 256, 4 * np.eye(3))
    >>> pypw85.bond_order(crystal).mean.round(4).tolist()
    [0.1909, 0.5745]
    """
    if system.dimensions != 3:
        raise ValueError("bond_order: the system must be three-dimensional")
    degrees = _integers(degrees, "bond_order: degrees", 0)
    nearest = None if nearest is None else integer(nearest, "bond_order: nearest", 1)
    reach = None if reach is None else positive(reach, "bond_order: reach")
    if (nearest is None) == (reach is None):
        raise ValueError(f"bond_order: one of nearest and reach must be positive, and the other None, not {nearest} and {reach}")
    n = len(system)
    owner, bonds = _bonds_within(system, reach)[:2] if reach is not None else _nearest_bonds(system, int(nearest or 0))
    numbers = np.bincount(owner, minlength=n)
    with np.errstate(invalid="ignore"):
        directions = bonds / np.linalg.norm(bonds, axis=1, keepdims=True)
    local, mean = np.full((n, len(degrees)), np.nan), np.full(len(degrees), np.nan)
    for k, degree in enumerate(degrees):
        squares = np.zeros(n)
        of_all = 0.0
        for m, harmonic in enumerate(_harmonics(directions, degree)):
            sums = np.bincount(owner, harmonic.real, n) + 1j * np.bincount(owner, harmonic.imag, n)
            times = 1 if m == 0 else 2  # Y_l,-m is the conjugate of Y_lm up to its sign
            with np.errstate(invalid="ignore"):
                squares = squares + times * np.abs(sums / numbers) ** 2
            of_all += times * np.abs(sums.sum()) ** 2
        local[:, k] = np.sqrt(4 * np.pi / (2 * degree + 1) * squares)
        mean[k] = np.sqrt(4 * np.pi / (2 * degree + 1) * of_all) / len(owner) if len(owner) else np.nan
    return BondOrder(local, mean, numbers)


def _bonds_within(system: System, reach: float) -> tuple[Ints, Floats, Ints]:
    """The first particle, the vector and the second particle of each bond that is at most so long, in both directions."""
    ball = np.array([1, 0, 0, 1, 0, 1]) * (reach / 2) ** 2  # two balls of this radius meet at this distance
    found = neighbors(system.centers, np.tile(ball, (len(system), 1)), system.cell, system.periodic)
    first, second = found.pairs.T.astype(np.int64)
    bonds = system.centers[second] - system.centers[first]
    if system.cell is not None:
        bonds = bonds + found.images @ system.cell
    near = np.flatnonzero(np.einsum("ij,ij->i", bonds, bonds) <= reach**2)
    first, second, bonds = first[near], second[near], bonds[near]
    return np.concatenate([first, second]), np.concatenate([bonds, -bonds]), np.concatenate([second, first])


def _nearest_bonds(system: System, nearest: int) -> tuple[Ints, Floats]:
    """The first particle and the vector of the bonds to the nearest neighbours of each particle."""
    n = len(system)
    extent = np.ptp(system.centers, axis=0).max() if n else 0.0
    edge = system.volume ** (1 / 3) if system.volume else extent
    limit = 2 * extent if not any(system.periodic) else np.inf  # no particle is farther away
    reach = edge * (2 * nearest / (max(n, 1) * UNIT_BALL[3])) ** (1 / 3)
    while True:
        owner, bonds, _ = _bonds_within(system, min(reach, limit) or 1.0)
        if n and np.bincount(owner, minlength=n).min() >= nearest:
            break
        if not n or reach >= limit:
            raise ValueError(f"bond_order: each particle must have {nearest} neighbours: take a smaller number, or a reach")
        reach *= 1.25
    order = np.lexsort([np.einsum("ij,ij->i", bonds, bonds), owner])
    owner, bonds = owner[order], bonds[order]
    rank = np.arange(len(owner)) - np.searchsorted(owner, owner)
    return owner[rank < nearest], bonds[rank < nearest]


def _harmonics(directions: Floats, degree: int) -> Iterator[NDArray[np.complex128]]:
    """Y_lm of unit vectors for m = 0 to l, by the recurrence of normalised Legendre functions in the degree."""
    x, y, z = directions.T
    across = x + 1j * y
    sectoral: NDArray[np.complex128] = np.full(len(z), np.sqrt(0.25 / np.pi), dtype=np.complex128)  # Y_mm
    for m in range(degree + 1):
        if m > 0:
            sectoral = -np.sqrt((2 * m + 1) / (2 * m)) * across * sectoral
        before, now = np.zeros(len(z), dtype=np.complex128), sectoral
        for n in range(m + 1, degree + 1):
            a = np.sqrt((4 * n**2 - 1) / (n**2 - m**2))
            b = np.sqrt(((n - 1) ** 2 - m**2) / (4 * (n - 1) ** 2 - 1))
            before, now = now, a * (z * now - b * before)
        yield now


def angular_pair_correlation(
    systems: System | Iterable[System], reach: float, bins: int = 50, angles: int = 10, between: str = "axes"
) -> AngularPairCorrelation:
    """Pair correlation g(r, \\|cos θ\\|) as a function of the distance r of two centres and an angle θ; 1 in an ideal gas.

    Parameters
    ----------
    systems : System or iterable of System
        Three-dimensional samples, in the order in which a simulation gave them. Each cell must be periodic along all its vectors. If
        the angle needs the axis of a particle, particles without an axis (spheres, see `nematic_order`) are left out.
    reach : float
        Largest distance, > 0. It may exceed the cell: all images count, except those of the particle itself.
    bins, angles : int
        Numbers of bins of the distance and of \\|cos θ\\|, at least 1.
    between : "axes", "separation" or "director"
        Definition of θ. "axes": between the axes of the two particles. "separation": between the axis of a particle and the line to
        the other particle; each pair counts twice. "director": between this line and the `director`.

    Returns
    -------
    AngularPairCorrelation

    Raises
    ------
    ValueError
        A system is two-dimensional, or its cell is not periodic along its vectors; there is no system; or an argument is out of range.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> centers = np.random.default_rng(1).uniform(0, 9, (2000, 3))
    >>> gas = pypw85.System(centers, [[1, 0, 0, 1, 0, 4]] * 2000, 9 * np.eye(3))
    >>> found = pypw85.angular_pair_correlation(gas, 3, 1, 2, "separation")
    >>> bool(abs(found.g - 1).max() < 0.05)
    True
    """
    name = "angular_pair_correlation"
    reach, bins, angles = positive(reach, f"{name}: reach"), integer(bins, f"{name}: bins", 1), integer(angles, f"{name}: angles", 1)
    between = choice(between, f"{name}: between", ("axes", "separation", "director"))
    edges, cosines = np.linspace(0, reach, bins + 1, dtype=np.float64), np.linspace(0, 1, angles + 1, dtype=np.float64)
    averages = Blocking(bins * angles)
    for system in _all_systems(systems, "angular_pair_correlation"):
        if system.dimensions != 3:
            raise ValueError("angular_pair_correlation: the system must be three-dimensional")
        _reciprocal(system)
        averages.add(_count_by_angle(system, edges, angles, between))
    found = averages.estimate()
    return AngularPairCorrelation(edges, cosines, found.value.reshape(bins, angles), found.error.reshape(bins, angles))


def _count_by_angle(system: System, edges: Floats, angles: int, between: str) -> Floats:
    """The numbers of pairs in bins over those of an ideal gas of the particles that have what the angle needs."""
    reach, bins = float(edges[-1]), len(edges) - 1
    axes = principal_directions(system)
    owner, bonds, other = _bonds_within(system, reach)
    length = np.linalg.norm(bonds, axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        lines = bonds / length[:, None]
    second = {"axes": axes[other], "separation": lines, "director": lines}[between]
    first = np.broadcast_to(director(system), bonds.shape) if between == "director" else axes[owner]
    cosine = np.abs(np.einsum("ij,ij->i", first, second))
    known = np.count_nonzero(~np.isnan(axes[:, 0]))
    n = len(system)
    number = {"axes": known * (known - 1), "separation": known * (n - 1), "director": n * (n - 1) if known else 0}[between]
    chosen = np.flatnonzero((owner != other) & (length < reach) & ~np.isnan(cosine))
    k = np.minimum(length[chosen] * (bins / reach), bins - 1).astype(np.intp)
    m = np.minimum(cosine[chosen] * angles, angles - 1).astype(np.intp)
    counts = np.bincount(k * angles + m, minlength=bins * angles).reshape(bins, angles)
    assert system.volume is not None
    with np.errstate(invalid="ignore"):
        ideal = number / angles / system.volume * UNIT_BALL[3] * np.diff(edges**3)
        result: Floats = counts / ideal[:, None]
    return result.ravel()


def mean_square_displacement(systems: Iterable[System], lags: Iterable[int]) -> Displacements:
    """Mean square displacements and rotations of the particles over given numbers of samples (lags).

    The mean is over all particles, and over all samples as starts. Between two successive samples, the function takes the shortest
    motion: each coordinate in the cell changes by less than one half, and each axis rotates by less than a right angle. Therefore the
    samples must follow each other closely. The centres may be wrapped into the cell or not. If the cell changes, the displacement of
    the coordinates in the cell is converted by the cell at the end of the lag. The rotation of a particle is the sum of the rotation
    vectors that rotate its axis from sample to sample; rotations about the axis itself do not count.

    Parameters
    ----------
    systems : iterable of System
        Samples at equal intervals, with the same particles in the same order.
    lags : iterable of int
        Numbers of samples between start and end, at least 1. As many samples as the largest lag are in memory at the same time.

    Returns
    -------
    Displacements
        NaN, with a warning, for a lag that is longer than the run.

    Raises
    ------
    ValueError
        A lag is not positive; there is no lag or no system; or the number of particles or of dimensions changes.

    Examples
    --------
    A particle that moves by 0.5 between two samples:

    >>> import numpy as np, pypw85
    >>> ball, cell = [1, 0, 0, 1, 0, 1], 4 * np.eye(3)
    >>> centers = [[0.5 * k % 4, 0, 0] for k in range(10)]
    >>> samples = [pypw85.System([center], [ball], cell) for center in centers]
    >>> pypw85.mean_square_displacement(samples, lags=[1, 4]).translation
    array([0.25, 4.  ])
    """
    wanted = np.unique(_integers(lags, "mean_square_displacement: lags", 1, _LONGEST_LAG))
    if not len(wanted):
        raise ValueError("mean_square_displacement: lags must have at least one number")
    averages = [(Blocking(1), Blocking(1)) for _ in wanted]
    past: deque[tuple[Floats, Floats]] = deque(maxlen=int(wanted[-1]))
    number = 0
    for cell, place, turned in _unwrapped(systems):
        number += 1
        for lag, (translation, rotation) in zip(wanted, averages):
            if lag <= len(past):
                then = past[-lag]
                translation.add([_mean_square((place - then[0]) @ cell)])
                rotation.add([_mean_square(turned - then[1])])
        past.append((place, turned))
    rows = np.full((4, len(wanted)), np.nan)
    for k, pair in enumerate(averages):
        for j, one in enumerate(pair):
            if len(one):
                found = one.estimate()
                rows[2 * j : 2 * j + 2, k] = found.value[0], found.error[0]
    if number <= wanted[-1]:
        warnings.warn(f"mean_square_displacement: lags must be below the number of systems, {number}: those that are not, as "
                      f"{wanted[-1]}, have no displacement", stacklevel=2)  # fmt: skip
    return Displacements(wanted, *rows)


def _mean_square(vectors: Floats) -> float:
    squares = np.einsum("ij,ij->i", vectors, vectors)
    known = ~np.isnan(squares)
    return float(squares[known].mean()) if known.any() else np.nan


def _unwrapped(systems: Iterable[System]) -> Iterator[tuple[Floats, Floats, Floats]]:
    """The cell of each system, or unit vectors; the coordinates of its centres in it, which do not jump; and the sums of rotations."""
    place = turned = axes = np.zeros((0, 3))
    for k, system in enumerate(_all_systems(systems, "mean_square_displacement")):
        cell = np.eye(3) if system.cell is None else system.cell
        inside, now = system.centers @ np.linalg.inv(cell), principal_directions(system)
        if k == 0:
            place, turned, axes = inside, np.zeros_like(inside), now
        elif len(system) != len(place):
            raise ValueError("mean_square_displacement: all systems must have the same number of particles")
        steps = inside - place
        place = place + steps - np.where(system.periodic, np.round(steps), 0)
        now = now * np.where(np.einsum("ij,ij->i", axes, now) < 0, -1, 1)[:, None]
        across = np.cross(axes, now)
        sine, cosine = np.linalg.norm(across, axis=1), np.einsum("ij,ij->i", axes, now)
        with np.errstate(invalid="ignore", divide="ignore"):
            turned = turned + across * np.where(sine > 0, np.arctan2(sine, cosine) / sine, 1)[:, None]
        axes = now
        yield cell, place, turned
