# SPDX-License-Identifier: BSD-3-Clause
"""Random packings: a soft repulsion removes the overlaps of ellipsoids."""

from __future__ import annotations

import itertools
from typing import Any, NamedTuple
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from ._choices import choice
from ._functions import cell_reduce, ellipsoid_quaternion
from ._arrays import reals
from ._numbers import function, instance, integer, real
from ._words import shown
from ._neighbors import Neighbors, neighbors
from ._pairs import overlap_pairs
from ._system import UNIT_BALL, System
from ._forces import contact_derivatives_pairs, contact_forces_pairs
from ._typing import Floats

# Minimisation of a soft repulsion ends with small overlaps. Therefore ellipsoids are enlarged by these factors while they move. A large
# factor separates them in fewer steps, a small one finds denser packings.
_MUCH_SWOLLEN, _SLIGHTLY_SWOLLEN = 1.01, 1.001
# FIRE (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006), with the constants of that article; times and masses are dimensionless.
_STEP, _LONGEST_STEP, _MIXING = 0.05, 0.5, 0.1
_FASTER, _SLOWER, _LESS_MIXING, _PATIENCE = 1.1, 0.5, 0.99, 5
# Longest displacement in a step, in units of the shortest semi-axis: no ellipsoid passes through another one.
_LONGEST_DISPLACEMENT = 0.25
# A quench ends if the energy falls by less than this fraction in this number of steps. Annealing then makes faster progress.
_STUCK_AFTER, _STUCK = 100, 0.05
# Annealing starts at the temperature T at which pairs with (1 - μ²)²/2 = kT are 7 % too close. Dense packings then melt, as if their
# packing fraction were smaller by the factor 0.93³ = 0.8. The second number is that of the steps of the first annealing; each further
# annealing takes twice as many.
_MELTING, _ANNEALING_STEPS = 0.01, 2000
# The stiffness of a contact is (2 / shortest semi-axis)²/4 in these units, and an ellipsoid has about ten contacts. Therefore Verlet's
# method is stable for steps up to 2/√(10 stiffness) = 0.63 times the shortest semi-axis.
_VERLET_STEP = 0.4
# The volume of a cell with vectors of length one has rounding errors of about 1e-16. If it is below this limit, the cell counts as flat.
_FLAT = 1e-12
# Largest aspect ratio κ. The rounding errors of a form are a few u times its largest eigenvalue, which is κ² times the smallest one. For
# κ = 1e6 they are about κ² u = 1e-4 of the smallest eigenvalue.
_MOST_SLENDER = 1e6
# Skin of the neighbour lists, in units of the shortest semi-axis. A list is rebuilt when a surface has moved by half of it.
_SKIN = 0.2


# Relative tolerance for rounding errors of the edges of the cell.
_ROUNDING = 1e-9


class OverlapsLeft(ValueError):
    """Exception of `relax` and `pack`: overlaps remain after all steps.

    Attributes
    ----------
    system : System
        The best configuration that was found.
    overlaps : int
        Number of overlapping pairs in this configuration.
    steps : int
        Number of steps that were made.
    """

    def __init__(self, system: System, overlaps: int, steps: int) -> None:
        super().__init__(system, overlaps, steps)
        self.system, self.overlaps, self.steps = system, overlaps, steps

    def __str__(self) -> str:
        return f"overlaps that remain after {self.steps} steps: {self.overlaps}; use a larger cell or more steps"


class RelaxationInterrupted(KeyboardInterrupt):
    """Exception of `relax` and `pack`: the user pressed Ctrl-C.

    Attributes
    ----------
    system : System
        The best configuration that was found until then.
    overlaps : int
        Number of overlapping pairs in this configuration.
    """

    def __init__(self, system: System, overlaps: int) -> None:
        super().__init__(system, overlaps)
        self.system, self.overlaps = system, overlaps

    def __str__(self) -> str:
        return f"overlaps that remain: {self.overlaps}"


class _Push(NamedTuple):
    """Forces and torques (2, n, 3) on the enlarged ellipsoids, and their energy. For the ellipsoids of true size: the number of
    overlapping pairs, their energy `depth` (0 without overlaps), and the smallest μ² of the listed pairs."""

    force: Floats
    energy: float
    overlaps: int
    depth: float
    smallest: float


class _Soft:
    """Enlarged ellipsoids with a soft repulsion: the energy is Σ (1 - μ²)²/2 over the pairs that overlap.

    The unit of length is the mean semi-axis. Masses and moments of inertia are 1.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self.centers, self.quaternions = system.centers.copy(), system.quaternions.copy()
        axes = system.semi_axes[:, : system.dimensions]
        self.length, self.shortest = float(axes.mean()), float(axes.min())
        # Degrees of freedom: in two dimensions, translations in the plane and rotations about z
        self.free = np.ones((2, 1, 3))
        if system.dimensions == 2:
            self.free[:, 0] = [1, 1, 0], [0, 0, 1]
        self._list: Neighbors | None = None

    def push(self, swelling: float) -> _Push:
        q = ellipsoid_quaternion(swelling * self.system.semi_axes, self.quaternions)
        cell, found = self.system.cell, self._neighbors(q)
        images = None if cell is None else found.images
        near = overlap_pairs(found.pairs, self.centers, q, cell, images=images)
        arrays = found.pairs[near], self.centers, q
        images = None if images is None else images[near]
        derivatives = contact_derivatives_pairs(*arrays, cell, images)
        mu2 = swelling**2 * derivatives.mu2
        slope, true_slope = np.minimum(derivatives.mu2 - 1, 0), np.minimum(mu2 - 1, 0)
        result = contact_forces_pairs(found.pairs[near], self.centers, slope, derivatives, cell, images)
        force = self.free * np.stack([result.forces * self.length, result.torques])
        return _Push(force, 0.5 * float(slope @ slope),
                     int((mu2 < 1).sum()), 0.5 * float(true_slope @ true_slope), float(mu2.min(initial=swelling**2)))  # fmt: skip

    def _neighbors(self, q: Floats) -> Neighbors:
        if self._list is None or not self._list.holds(self.centers, q, self.system.cell):
            self._list = neighbors(self.centers, q, self.system.cell, self.system.periodic, skin=_SKIN * self.shortest)
        return self._list

    def move(self, displacement: Floats) -> None:
        """Moves by translations and rotation vectors (2, n, 3), which are shortened if they are too long for one step."""
        longest = max(float(np.abs(displacement).max()), 1e-300)
        displacement = displacement * min(1.0, _LONGEST_DISPLACEMENT * self.shortest / self.length / longest)
        self.centers = self.centers + self.length * displacement[0]
        self.quaternions = _rotated(self.quaternions, displacement[1])


def _quench(soft: _Soft, swelling: float) -> Iterator[_Push]:
    """Minimises the energy by FIRE, until it hardly decreases."""
    velocity, step, mixing, downhill = np.zeros((2, len(soft.system), 3)), _STEP, _MIXING, 0
    before = np.inf
    for k in itertools.count():
        push = soft.push(swelling)
        yield push
        if k % _STUCK_AFTER == 0:
            if push.energy > (1 - _STUCK) * before:
                return
            before = push.energy
        force = push.force
        if (force * velocity).sum() > 0:
            velocity = (1 - mixing) * velocity + mixing * force * np.linalg.norm(velocity) / np.linalg.norm(force)
            downhill += 1
            if downhill > _PATIENCE:
                step, mixing = min(step * _FASTER, _LONGEST_STEP), mixing * _LESS_MIXING
        else:
            velocity[:] = 0
            step, mixing, downhill = step * _SLOWER if downhill else step, _MIXING, 0
        velocity += step * force
        soft.move(step * velocity)


def _anneal(soft: _Soft, steps: int, swelling: float, random: np.random.Generator) -> Iterator[_Push]:
    """Molecular dynamics with a velocity scale that falls linearly to zero. Dense packings rearrange, and may order.

    The depth of overlaps is proportional to √T, which falls linearly. Therefore the hard cores grow linearly, as in the algorithm of
    Lubachevsky and Stillinger (J. Stat. Phys. 60, 561, 1990).
    """
    step = _VERLET_STEP * soft.shortest / soft.length
    velocity = soft.free * random.normal(size=(2, len(soft.system), 3))
    for k in range(steps):
        push = soft.push(swelling)
        yield push
        velocity += step * push.force
        velocity[0] -= velocity[0].mean(axis=0)
        velocity *= np.sqrt(_MELTING * soft.free.mean() / np.mean(velocity**2)) * (1 - k / steps)
        soft.move(step * velocity)


def _pushes(soft: _Soft) -> Iterator[_Push]:
    """Attempts of increasing cost, for packings of increasing density. Each push is one step."""
    yield from _quench(soft, _MUCH_SWOLLEN)
    yield from _quench(soft, _SLIGHTLY_SWOLLEN)
    random = np.random.default_rng(1)
    for k in itertools.count():
        yield from _anneal(soft, _ANNEALING_STEPS * 2**k, _SLIGHTLY_SWOLLEN, random)
        yield from _quench(soft, _SLIGHTLY_SWOLLEN)


def relax(system: System, steps: int = 20000, stage: Callable[[str], object] = str) -> System:
    """Move and rotate ellipsoids until none overlap, as the exact test decides.

    Shapes and cell do not change, and ellipses stay in their plane. A soft repulsion separates the ellipsoids that overlap. If overlaps
    remain because the packing is dense, simulated annealing follows: all ellipsoids receive random velocities, which are then reduced to
    zero. Annealing is repeated, each time with twice as many steps.

    Parameters
    ----------
    system : System
    steps : int
        Maximum number of steps.
    stage : callable
        Called at each step with a string that states the number of overlapping pairs. If it raises KeyboardInterrupt, the relaxation ends
        as after Ctrl-C.

    Returns
    -------
    System

    Raises
    ------
    OverlapsLeft
        Overlaps remain after all steps: the density is too high for the shapes or for the number of steps. The attribute `system` of the
        exception is the best configuration that was found, that is, the one with the smallest Σ (1 - μ²)². The exception is a
        ValueError.
    RelaxationInterrupted
        The user pressed Ctrl-C. The exception has the same attribute, and is a KeyboardInterrupt.
    ValueError
        The cell is so small or thin that an ellipsoid overlaps its own image in every orientation.
    """
    soft, steps = _Soft(instance(system, System, "relax: system")), integer(steps, "relax: steps", 1)
    function(stage, "relax: stage")
    if reason := too_thin(system):
        raise ValueError(reason)
    best, least = (soft.centers, soft.quaternions), np.inf
    try:
        for k, push in zip(range(steps), _pushes(soft)):
            if push.depth <= least:
                best, least = (soft.centers, soft.quaternions), push.depth
                if push.overlaps == 0 and not len((moved := _moved(system, *best)).overlaps().mu):
                    return moved
            stage(f"step {k}, {push.overlaps} pairs overlap, smallest μ {np.sqrt(push.smallest):.4f}")
    except KeyboardInterrupt:
        left = _moved(system, *best)
        raise RelaxationInterrupted(left, len(left.overlaps().mu)) from None
    left = _moved(system, *best)
    raise OverlapsLeft(left, len(left.overlaps().mu), steps)


def too_thin(system: System) -> str:
    """Returns a message if an ellipsoid overlaps its own image in every orientation, and otherwise an empty string.

    The test is a necessary condition. An ellipsoid with the semi-axes a <= b <= c contains a ball of radius a, and its section with any
    plane through its centre has at least the area π a b. Its images along one, two or three vectors, which span the length, area or
    volume D, form a lattice packing of segments, ellipses or ellipsoids. The densest packing fractions are 1, π/√12 and π/√18. Therefore
    D >= 2 a, √12 a b or √32 a b c, if no images overlap.
    """
    periodic = np.asarray(system.periodic, dtype=bool)
    if system.cell is None or not periodic.any():
        return ""
    count = int(periodic.sum())
    # Long vectors along the directions that are not periodic: they are the last vectors of the reduced cell
    others = np.linalg.svd(system.cell[periodic])[2][count:] * (10 * float(np.abs(system.cell).sum()))
    vectors = cell_reduce(np.vstack([system.cell[periodic], others]))
    vectors = vectors[np.linalg.norm(vectors, axis=1).argsort()[:count]]
    axes = np.sort(system.semi_axes[:, : system.dimensions], axis=1)
    # Determinants have up to six factors: in this unit, a power of two, they neither overflow nor underflow
    unit = float(np.exp2(np.frexp(axes.max(initial=1e-300))[1] - 1))
    for number, factor, what in ((1, 2.0, "length"), (2, 12**0.5, "area"), (3, 32**0.5, "volume")):
        for chosen in itertools.combinations(vectors, number):
            edges = np.array(chosen) / unit
            spanned = float(np.sqrt(np.linalg.det(edges @ edges.T)))
            least = factor * (axes[:, :number] / unit).prod(axis=1)
            if (spanned < (1 - _ROUNDING) * least).any():
                k = int(least.argmax())
                return (f"the cell is too small or too thin: ellipsoid {system.ids[k]} overlaps its own image in every orientation. "
                        f"Its images are apart by the {what} {spanned * unit**number:.6g}; with the semi-axes "
                        f"{' '.join(f'{x:g}' for x in axes[k])} it needs at least {least[k] * unit**number:.6g}. "
                        "Use a thicker cell or a smaller packing fraction")  # fmt: skip
    return ""


def _moved(system: System, centers: Floats, quaternions: Floats) -> System:
    def make(places: Floats) -> System:
        return System.from_axes(
            places, system.semi_axes, quaternions, cell=system.cell, periodic=system.periodic, types=system.types,
            ids=system.ids, origin=system.origin, step=system.step, dimensions=system.dimensions,
        )  # fmt: skip

    return make(make(centers).wrapped())


def _rotated(quaternions: Floats, rotations: Floats) -> Floats:
    """Quaternions after rotations by rotation vectors."""
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
    steps: int = 20000,
    stage: Callable[[str], object] = str,
    dimensions: int = 3,
) -> System:
    """Make a random packing of ellipsoids in a periodic cell, without overlaps as the exact test decides.

    The ellipsoids start at random positions, and `relax` removes the overlaps. Dense packings take longer, and have local order: see
    `nematic_order`.

    Parameters
    ----------
    semi_axes : (n, 3) array_like
        One row for each ellipsoid; (n, 2) for ellipses.
    fraction : float
        Packing fraction: the volume of the ellipsoids over the volume of the cell, or area over area; between 0 and 1.
    cell : (3, 3) array_like, optional
        Shape of the cell, (2, 2) for ellipses. The cell is scaled to obtain the packing fraction. By default a cube or a square.
    seed : int, optional
        Seed of `numpy.random.default_rng`. The same seed gives the same packing. Without a seed, each call gives another packing.
    types : (n) array_like, optional
        As for `System`.
    steps, stage
        As for `relax`.
    dimensions : int
        2 for a packing of ellipses.

    Returns
    -------
    System

    Raises
    ------
    OverlapsLeft, RelaxationInterrupted
        As for `relax`.
    ValueError
        Semi-axes, fraction or cell are invalid, or the cell is too thin, as for `relax`.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> system = pypw85.pack(np.tile([1, 1, 2], (50, 1)), 0.4, seed=1)
    >>> len(system.overlaps().mu), round(system.packing_fraction, 12)
    (0, 0.4)
    """
    choice(dimensions, "pack: dimensions", UNIT_BALL)
    axes, fraction = reals(semi_axes, "pack: semi_axes"), real(fraction, "pack: fraction")
    occupied = check_axes(axes, dimensions)
    if not 0 < fraction < 1:
        raise ValueError(f"pack: fraction must be between 0 and 1, not {fraction}")
    shape, volume = check_cell(np.eye(dimensions) if cell is None else cell, dimensions)
    shape = shape * (occupied / fraction / volume) ** (1 / dimensions)
    random = _generator(seed)
    if dimensions == 2:
        places, angles = random.uniform(size=(len(axes), 2)) @ shape, random.uniform(0, np.pi, len(axes))
        return relax(System.from_ellipses(places, axes, angles, cell=shape, types=types), steps, stage)
    quaternions = random.normal(size=(len(axes), 4))
    quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
    system = System.from_axes(random.uniform(size=(len(axes), 3)) @ shape, axes, quaternions, cell=shape, types=types)
    return relax(system, steps, stage)


def _generator(seed: Any) -> np.random.Generator:
    try:
        return np.random.default_rng(seed)
    except (TypeError, ValueError):
        raise ValueError(f"pack: seed must be an integer >= 0, not {shown(seed)}") from None


_COUNTS = {2: "two", 3: "three"}


def check_cell(cell: ArrayLike, dimensions: int) -> tuple[Floats, float]:
    """Checks a cell. Returns the cell and its volume."""
    shape, count = reals(cell, "cell"), _COUNTS[dimensions]
    if shape.shape != (dimensions, dimensions) or not np.isfinite(shape).all():
        raise ValueError(f"the cell must be {count} vectors of finite numbers, not {shape.tolist()}")
    volume = float(abs(np.linalg.det(shape)))
    if not volume > _FLAT * np.linalg.norm(shape, axis=1).prod():
        raise ValueError(f"the vectors of the cell must not lie in a {'plane' if dimensions == 3 else 'line'}: {shape.tolist()}")
    return shape, volume


def check_axes(axes: Floats, dimensions: int = 3) -> float:
    """Checks semi-axes. Returns the volume of the ellipsoids."""
    if axes.ndim != 2 or axes.shape[1] != dimensions or not len(axes):
        raise ValueError(f"semi_axes must be rows of {_COUNTS[dimensions]} numbers, not an array of the shape {axes.shape}")
    bad = ~((axes > 0) & np.isfinite(axes)).all(axis=1)
    if bad.any():
        row = int(bad.argmax())
        raise ValueError(f"semi_axes must be finite and > 0, not {axes[row].tolist()} of ellipsoid {row}")
    with np.errstate(over="ignore", under="ignore"):
        volume = UNIT_BALL[dimensions] * float(axes.prod(axis=1).sum())
        if not (np.isfinite(axes**2).all() and (axes**2).all() and 0 < volume < np.inf):
            raise ValueError("the squares of the semi-axes or their product are beyond double precision: choose another unit of length")
    slenderness = axes.max(axis=1) / axes.min(axis=1)
    if slenderness.max() > _MOST_SLENDER:
        row = int(slenderness.argmax())
        raise ValueError(f"the longest semi-axis must be at most {_MOST_SLENDER:g} times the shortest one, as forms in double "
                         f"precision lose shorter ones, not {axes[row].tolist()} of ellipsoid {row}")  # fmt: skip
    return volume


OverlapsLeft.__module__ = RelaxationInterrupted.__module__ = "pypw85"
