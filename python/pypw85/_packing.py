"""Configurations without overlaps: overlapping ellipsoids push one another apart."""

from __future__ import annotations

from typing import Any, NamedTuple
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ._system import System
from ._systems import contact_derivatives_pairs
from ._typing import Floats

# Ellipsoids that are pressed together end up a little too deep: so they are this much larger than they are meant to be.
_SWELLING = 1.01
# FIRE (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006), with its own constants; times and masses have no unit.
_STEP, _LONGEST_STEP, _MIXING = 0.05, 0.5, 0.1
_FASTER, _SLOWER, _LESS_MIXING, _PATIENCE = 1.1, 0.5, 0.99, 5
# Longest way of a step, in units of the shortest semi-axis: nothing passes through anything.
_WAY = 0.25


class _Push(NamedTuple):
    """Forces and torques, and the smallest μ² of the ellipsoids at their true size."""

    forces: Floats
    torques: Floats
    smallest: float


def relax(system: System, steps: int = 5000, stage: Callable[[str], object] = str) -> System:
    """Move and turn ellipsoids until none overlap, by the exact test; shapes and cell stay.

    Parameters
    ----------
    system : System
    steps : int
        How many steps to try.
    stage : callable
        Is told what is done.

    Returns
    -------
    System

    Raises
    ------
    ValueError
        Some still overlap after so many steps: there is not enough room for them, or for a way there.
    """
    centers, quaternions = system.centers.copy(), system.quaternions.copy()
    length, shortest = float(system.semi_axes.mean()), float(system.semi_axes.min())
    velocity, step, mixing, downhill = np.zeros((2, len(system), 3)), _STEP, _MIXING, 0
    for k in range(steps):
        push = _push(system, centers, quaternions)
        if push.smallest >= 1 and not len((moved := _moved(system, centers, quaternions)).overlaps().mu):
            return moved
        stage(f"step {k}, smallest μ {np.sqrt(push.smallest):.4f}")
        force = np.stack([push.forces * length, push.torques])
        if (force * velocity).sum() > 0:
            velocity = (1 - mixing) * velocity + mixing * force * np.linalg.norm(velocity) / np.linalg.norm(force)
            downhill += 1
            if downhill > _PATIENCE:
                step, mixing = min(step * _FASTER, _LONGEST_STEP), mixing * _LESS_MIXING
        else:
            velocity[:] = 0
            step, mixing, downhill = step * _SLOWER if downhill else step, _MIXING, 0
        velocity += step * force
        way = step * velocity
        way *= min(1.0, _WAY * shortest / length / max(np.abs(way).max(), 1e-300))
        centers += length * way[0]
        quaternions = _turned(quaternions, way[1])
    left = len(_moved(system, centers, quaternions).overlaps().mu)
    raise ValueError(f"{left} pairs still overlap after {steps} steps: give more room, or more steps (--steps)")


def _moved(system: System, centers: Floats, quaternions: Floats) -> System:
    def make(places: Floats) -> System:
        return System.from_axes(
            places, system.semi_axes, quaternions, cell=system.cell, periodic=system.periodic, types=system.types,
            ids=system.ids, origin=system.origin, step=system.step,
        )  # fmt: skip

    return make(make(centers).wrapped())


def _push(system: System, centers: Floats, quaternions: Floats) -> _Push:
    """Of the energy Σ (1 - μ²)²/2 over the pairs of swollen ellipsoids that overlap."""
    swollen = System.from_axes(
        centers, _SWELLING * system.semi_axes, quaternions, cell=system.cell, periodic=system.periodic
    )
    found = swollen.neighbors()
    images = None if system.cell is None else found.images
    derivatives = contact_derivatives_pairs(found.pairs, centers, swollen.q, system.cell, images)
    slope = np.maximum(1 - derivatives.mu2, 0)[:, np.newaxis]
    forces, torques = np.zeros((2, len(system), 3))
    first, second = found.pairs.T
    for target, particles, values in ((forces, first, -derivatives.d_r12), (forces, second, derivatives.d_r12),
                                      (torques, first, derivatives.d_rot1), (torques, second, derivatives.d_rot2)):  # fmt: skip
        for axis in range(3):
            target[:, axis] += np.bincount(particles, (slope * values)[:, axis], len(system))
    return _Push(forces, torques, float(_SWELLING**2 * derivatives.mu2.min(initial=np.inf)))


def _turned(quaternions: Floats, rotations: Floats) -> Floats:
    """Quaternions after a turn by rotation vectors."""
    angles = np.linalg.norm(rotations, axis=1, keepdims=True)
    # sin(angle/2) / angle, which is 1/2 at 0
    s, v = np.cos(angles / 2)[:, 0], rotations * np.sinc(angles / (2 * np.pi)) / 2
    w, u = quaternions[:, 0], quaternions[:, 1:]
    product = np.column_stack([s * w - (v * u).sum(axis=1), s[:, None] * u + w[:, None] * v + np.cross(v, u)])
    result: Floats = product / np.linalg.norm(product, axis=1, keepdims=True)
    return result


def pack(
    semi_axes: ArrayLike,
    fraction: float,
    cell: ArrayLike | None = None,
    seed: Any = None,
    types: ArrayLike | None = None,
    steps: int = 5000,
    stage: Callable[[str], object] = str,
) -> System:
    """A random packing without overlaps, by the exact test, in a periodic cell.

    Ellipsoids are thrown in at random, and push one another apart (`relax`).

    Parameters
    ----------
    semi_axes : (n, 3) array_like
        One row for each ellipsoid.
    fraction : float
        Of the volume, filled by them.
    cell : (3, 3) array_like, optional
        Its shape: it is scaled to the volume that the fraction asks for. A cube if absent.
    seed : int, optional
        For `numpy.random.default_rng`: the same one gives the same packing.
    types : (n) array_like, optional
        As of `System`.
    steps, stage
        As for `relax`.

    Returns
    -------
    System

    Raises
    ------
    ValueError
        Some still overlap after so many steps.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> system = pypw85.pack(np.tile([1, 1, 2], (50, 1)), 0.4, seed=1)
    >>> len(system.overlaps().mu), round(system.packing_fraction, 12)
    (0, 0.4)
    """
    axes, shape = np.asarray(semi_axes, dtype=np.float64), np.eye(3) if cell is None else np.asarray(cell, dtype=np.float64)
    if axes.ndim != 2 or axes.shape[1] != 3 or not len(axes) or not (axes > 0).all():
        raise ValueError("semi_axes must be rows of three positive numbers")
    if not 0 < fraction < 1:
        raise ValueError(f"the fraction must be between 0 and 1, but it is {fraction}")
    volume = abs(np.linalg.det(shape))
    if not volume > 0:
        raise ValueError("the vectors of the cell lie in a plane")
    shape = shape * (4 / 3 * np.pi * axes.prod(axis=1).sum() / fraction / volume) ** (1 / 3)
    random = np.random.default_rng(seed)
    quaternions = random.normal(size=(len(axes), 4))
    quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
    system = System.from_axes(random.uniform(size=(len(axes), 3)) @ shape, axes, quaternions, cell=shape, types=types)
    return relax(system, steps, stage)
