# SPDX-License-Identifier: BSD-3-Clause
"""Ordered starts: parallel ellipsoids on the sites of a lattice."""

from __future__ import annotations


import numpy as np
from numpy.typing import ArrayLike

from ._choices import choice
from ._functions import cell_reduce
from ._arrays import reals
from ._numbers import integer, real
from ._packing import check_axes
from ._system import System
from ._typing import Floats

# Sites of a cubic cell, in its edge. The primitive vectors of the face-centred one are the differences of its first site and the others.
_SITES = {
    "sc": np.zeros((1, 3)),
    "fcc": np.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]]),
}
_SITES["stretched"] = _SITES["fcc"]
# Ellipsoids that touch may overlap by rounding errors of their centres, some 1e-15 of the cell. So the lattice stays below the contact by
# this part of its density.
_ROUNDING = 1e-9


def lattice(
    semi_axes: ArrayLike, fraction: float, number: int, kind: str = "stretched", align: ArrayLike = (0, 0, 1), type: int = 1
) -> System:
    """Put parallel ellipsoids on a lattice in a periodic cell, without overlaps: an ordered start of a simulation.

    The axis of each ellipsoid whose length differs most from the middle one (the long axis of rods, the short axis of plates) is parallel
    to `align`.

    Parameters
    ----------
    semi_axes : (3) array_like
        Semi-axes of all ellipsoids, > 0. In the result the aligned axis is the last one.
    fraction : float
        Packing fraction: the volume of the ellipsoids divided by the volume of the cell, > 0.
    number : int
        Number of ellipsoids: a multiple of 4, or any number for "sc".
    kind : "stretched", "fcc" or "sc"
        "stretched": the face-centred cubic lattice of spheres, stretched such that the spheres become the ellipsoids. Its packing fraction
        can be as large as that of spheres, π/√18 = 0.7405. "fcc" and "sc": the face-centred and the simple cubic lattice along x, y and z,
        in which long ellipsoids touch at small packing fractions.
    align : (3) array_like
        Direction of the aligned axes, a vector of any length > 0.
    type : int
        Type of all particles.

    Returns
    -------
    System
        Its cell is as close to a cube as the number allows. With "stretched", the cell is rotated together with the ellipsoids.

    Raises
    ------
    ValueError
        The ellipsoids would overlap (the message states the largest packing fraction), or an argument is not allowed.

    Examples
    --------
    >>> import pypw85
    >>> system = pypw85.lattice([0.5, 0.5, 1.5], 0.6, 108)
    >>> len(system.overlaps().mu), round(system.packing_fraction, 12)
    (0, 0.6)
    >>> round(pypw85.nematic_order(system), 12)
    1.0
    """
    choice(kind, "lattice: kind", _SITES)
    axes, quaternion, rotation = _oriented(semi_axes, align)
    if not 0 < real(fraction, "lattice: fraction") < 1:
        raise ValueError(f"lattice: fraction must be between 0 and 1, not {fraction}")
    sites, count = _SITES[kind], integer(number, "lattice: number")
    if count < 1 or count % len(sites):
        more = (count // len(sites) + 1) * len(sites)
        others = f"{more - len(sites)} or {more}" if count > len(sites) else f"{more}"
        raise ValueError(f"lattice: number must be a multiple of {len(sites)}, the particles in a cell of the {kind} lattice, not "
                         f"{number}: take {others}")  # fmt: skip
    shape = rotation * axes if kind == "stretched" else np.eye(3)  # columns are the edges of a cell
    volume = check_axes(axes[np.newaxis]) * len(sites) / fraction
    edges: Floats = (shape * np.cbrt(volume / np.linalg.det(shape))).T
    _check_room(kind, fraction, sites, edges, (rotation * axes).T)
    repeats = _repeats(count // len(sites), np.linalg.norm(edges, axis=1))
    steps = np.stack(np.meshgrid(*map(np.arange, repeats), indexing="ij"), axis=-1).reshape(-1, 1, 3)
    centers = (steps + sites).reshape(-1, 3) @ edges
    cell = np.array(repeats)[:, np.newaxis] * edges
    return System.from_axes(centers, np.tile(axes, (count, 1)), np.tile(quaternion, (count, 1)), cell=cell, types=[type] * count)


def _oriented(semi_axes: ArrayLike, align: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """The semi-axes, that which is aligned last, and the quaternion and the matrix that turn z into the direction."""
    axes, direction = reals(semi_axes, "lattice: semi_axes"), reals(align, "lattice: align")
    if axes.shape != (3,):
        raise ValueError(f"lattice: semi_axes must be three numbers, not an array of the shape {axes.shape}")
    axes = np.sort(axes)
    check_axes(axes[np.newaxis])
    length = float(np.linalg.norm(direction)) if direction.shape == (3,) else 0.0
    if not 0 < length < np.inf:
        raise ValueError(f"lattice: align must be three finite numbers that are not all 0, not {direction.tolist()}")
    if axes[2] * axes[0] < axes[1] ** 2:
        axes = axes[[1, 2, 0]]
    direction = direction / length
    x, y, z = direction if direction[2] >= 0 else -direction  # both are the same axis
    cross = np.array([[0, 0, x], [0, 0, y], [-x, -y, 0]])
    quaternion = np.array([1 + z, -y, x, 0.0])
    return axes, quaternion / np.linalg.norm(quaternion), np.eye(3) + cross + cross @ cross / (1 + z)


def _check_room(kind: str, fraction: float, sites: Floats, edges: Floats, body: Floats) -> None:
    """Refuses a lattice whose ellipsoids overlap. With lengths in units of the semi-axes they are unit spheres, which touch if the shortest
    vector of the lattice is 2 long. `body` has the semi-axes as rows."""
    primitive = edges if len(sites) == 1 else sites[1:] @ edges
    shortest = np.linalg.norm(cell_reduce(primitive @ np.linalg.inv(body)), axis=1).min()
    largest = float(fraction * (shortest / 2) ** 3)
    if fraction > largest * (1 - _ROUNDING):
        cure = "" if kind == "stretched" else ', or the kind "stretched", which allows up to 0.7405'
        raise ValueError(f"lattice: fraction must be at most {largest:.6g}, beyond which parallel ellipsoids overlap on the {kind} lattice"
                         f", not {fraction:g}: take a smaller one{cure}")  # fmt: skip


def _repeats(cells: int, lengths: Floats) -> tuple[int, int, int]:
    """The numbers of repetitions of a cell with edges of these lengths that give a whole as close to a cube as possible."""
    divisors = [k for k in range(1, cells + 1) if cells % k == 0]
    triples = [(a, b, cells // (a * b)) for a in divisors for b in divisors if cells % (a * b) == 0]
    spreads = np.ptp(np.log(np.array(triples) * lengths), axis=1)
    a, b, c = triples[int(spreads.argmin())]
    return a, b, c
