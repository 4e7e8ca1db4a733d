"""Monte Carlo of hard ellipsoids."""

from __future__ import annotations

import operator
import threading
from typing import Any, Literal, NamedTuple, SupportsIndex
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._errors import PW85Error, Status
from ._explanations import explain_values
from ._neighbors import _periodic_cell
from ._system import System
from ._typing import Floats

Change = Literal["isotropic", "axis", "triclinic"]

_CHANGES = {"isotropic": 0, "axis": 1, "triclinic": 2}
_MOVES = ("translation", "rotation", "both", "exchange", "volume")


class TrialCounts(NamedTuple):
    """How many trials of a kind there were, and how many of them were accepted."""

    trials: int
    accepted: int


class TrialSteps(NamedTuple):
    """The largest changes of a trial: see `HardEllipsoids.set_steps`."""

    translation: float
    rotation: float
    volume: float


class NearImages(NamedTuple):
    """Images of particles near one particle, of `HardEllipsoids.neighbors`."""

    particles: Any
    images: Any
    separations: Any


class HardEllipsoids:
    """Monte Carlo of hard ellipsoids, which never overlap.

    The exact overlap test decides each trial. The same calls give the same trajectory, bit by bit, with any number of threads. Calls
    from several threads of Python wait for each other.

    Parameters
    ----------
    system : System
        Without overlaps. Centres, semi-axes, quaternions and cell are copied.
    seed : int
        Selects the random numbers; from 0 to 2**64 - 1.

    Attributes
    ----------
    centers : (n, 3) array
        Not wrapped into the cell. This array and the following ones are views of the present state, and cannot be written to.
    semi_axes : (n, 3) array
    quaternions : (n, 4) array
        Of length one: (w, x, y, z).
    q : (n, 6) array
        Forms.
    cell : (3, 3) array or None
    periodic : tuple of bool
        Along which vectors of the cell the system is repeated.

    Raises
    ------
    PW85Error
        Two ellipsoids overlap, or a number is bad. The text says which.
    MemoryError
        There is not enough memory.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> places = 1.5 * np.stack(np.meshgrid(*[np.arange(4)] * 3), -1).reshape(-1, 3)
    >>> axes, upright = np.tile([0.5, 0.5, 0.7], (64, 1)), np.tile([1, 0, 0, 0], (64, 1))
    >>> start = pypw85.System.from_axes(places, axes, upright, cell=6 * np.eye(3))
    >>> simulation = pypw85.HardEllipsoids(start, seed=1)
    >>> simulation.tune(50, acceptance=0.4)
    >>> simulation.sweep(50)
    >>> simulation.check()
    >>> counts = simulation.counts
    >>> counts["translation"].trials + counts["rotation"].trials
    3200
    """

    __slots__ = ("_lock", "_simulation", "cell", "centers", "periodic", "q", "quaternions", "semi_axes")

    centers: Floats
    semi_axes: Floats
    quaternions: Floats
    q: Floats
    cell: Floats | None
    periodic: tuple[bool, bool, bool]

    def __init__(self, system: System, seed: SupportsIndex = 1) -> None:
        number = operator.index(seed)
        if not 0 <= number < 2**64:
            raise ValueError(f"seed is no integer from 0 to 2**64 - 1: {number}")
        arrays = (
            np.ascontiguousarray(system.centers),
            np.ascontiguousarray(system.semi_axes),
            np.ascontiguousarray(system.quaternions),
        )
        cell, periodic = _periodic_cell(system.cell, np.array(system.periodic, np.int32))
        status, pair, made = _core.hard_ellipsoids_create(*arrays, cell, periodic, number)
        if status:
            _fail(status, "HardEllipsoids", _overlap(pair) or _blame(*arrays, cell))
        self._take(made)

    @classmethod
    def restore(cls, state: bytes) -> HardEllipsoids:
        """Makes a simulation from the bytes of `save`, which it continues bit by bit.

        Parameters
        ----------
        state : bytes
            Of the same kind of machine, and of the same version of the library.

        Returns
        -------
        HardEllipsoids

        Raises
        ------
        PW85Error
            These are no such bytes.
        MemoryError
            There is not enough memory.
        """
        simulation = cls.__new__(cls)
        status, _, made = _core.hard_ellipsoids_restore(state)
        if status:
            _fail(status, "HardEllipsoids.restore", "these are no bytes of save() of this version on this kind of machine")
        simulation._take(made)
        return simulation

    def __len__(self) -> int:
        """Number of particles."""
        return len(self.centers)

    def __repr__(self) -> str:
        return f"<pypw85.HardEllipsoids: {len(self)} particles>"

    def sweep(self, number: SupportsIndex = 1) -> None:
        """Makes sweeps. A sweep has as many trials as there are particles. It can be interrupted after each sweep.

        Parameters
        ----------
        number : int
            How many.

        Raises
        ------
        MemoryError
            There is not enough memory. The last sweep is not complete.
        """
        self._repeat("sweep", number, _core.hard_ellipsoids_sweep)

    def chain(self, number: SupportsIndex, length: float, direction: ArrayLike | None = None) -> float:
        """Makes event chains, which translate many particles without rejections, and gives the pressure.

        Chains do not rotate particles: use `sweep`, too. They are interrupted only after all of them.

        Parameters
        ----------
        number : int
            How many chains.
        length : float
            Of each chain, > 0. A chain is long if its length is the mean way between contacts times the number of particles.
        direction : (3,) array_like, optional
            Of any length > 0. Without it, each chain has a random direction.

        Returns
        -------
        float
            βP/ρ along the directions, by these chains.

        Raises
        ------
        PW85Error
            The length is not positive, the direction is zero, or particles block each other within rounding errors.
        MemoryError
            There is not enough memory. The last chain is not complete.
        """
        times = _number("chain", number)
        vector = None if direction is None else np.asarray(direction, float).reshape(3)
        along = None if vector is None else (float(vector[0]), float(vector[1]), float(vector[2]))
        with self._lock:
            status, compressibility = _core.hard_ellipsoids_chain(self._simulation, times, float(length), along)
        if status:
            _fail(status, "HardEllipsoids.chain", f"length {float(length)}, direction {along}")
        return compressibility

    def volume_moves(self, number: SupportsIndex, pressure: float, change: Change = "isotropic") -> None:
        """Tries changes of the cell and of all centres with it, at constant pressure. Volumes then have the density V^N exp(-βPV).

        Parameters
        ----------
        number : int
            How many trials.
        pressure : float
            βP > 0, in the inverse cube of the unit of length.
        change : {"isotropic", "axis", "triclinic"}
            Scales all axes alike; scales one of them; or scales one of them or shears the cell.

        Raises
        ------
        PW85Error
            The pressure is not positive, or the cell is not periodic along its three vectors.
        MemoryError
            There is not enough memory. The configuration is that before the trial.
        """
        self._repeat("volume_moves", number, _core.hard_ellipsoids_volume_move, float(pressure), _change(change))

    def tune(
        self, number: SupportsIndex, acceptance: float = 0.4, pressure: float = 0.0, change: Change = "isotropic"
    ) -> None:
        """Makes sweeps to equilibrate, and changes the steps after each of them towards an acceptance. Then all counts are zero.

        Trials are not in detailed balance while the steps change.

        Parameters
        ----------
        number : int
            How many sweeps.
        acceptance : float
            The desired part of the trials that is accepted, > 0 and at most 1.
        pressure : float
            βP for one trial of the volume after each sweep; 0 for none.
        change : {"isotropic", "axis", "triclinic"}
            As for `volume_moves`.

        Raises
        ------
        PW85Error
            Acceptance or pressure are out of range, or the cell is not periodic along its three vectors though there is a pressure.
        MemoryError
            There is not enough memory.
        """
        self._repeat("tune", number, _core.hard_ellipsoids_tune, float(acceptance), float(pressure), _change(change))

    def neighbors(self, particle: SupportsIndex) -> NearImages:
        """The images of particles whose bounding boxes meet that of one particle, ordered by their indices, then by their images.

        Parameters
        ----------
        particle : int

        Returns
        -------
        NearImages
            `particles` are the indices, `images`, (n, 3), the multiples of the vectors of the cell to be added to the centres, and
            `separations`, (n, 3), from the centre of the given particle to those of the images.

        Raises
        ------
        IndexError
            There is no such particle.
        MemoryError
            There is not enough memory.
        """
        with self._lock:
            status, found = _core.hard_ellipsoids_neighbors(self._simulation, self._index("neighbors", particle))
        if status:
            _fail(status, "HardEllipsoids.neighbors", "")
        return NearImages(*found)

    def try_placement(
        self,
        particle: SupportsIndex,
        center: ArrayLike | None = None,
        quaternion: ArrayLike | None = None,
        take: bool = False,
    ) -> bool:
        """Whether a particle would be free of overlaps at another place, by the exact test; and moves it there, if wanted.

        Parameters
        ----------
        particle : int
        center : (3,) array_like, optional
            New centre; without it, the present one.
        quaternion : (4,) array_like, optional
            New orientation (w, x, y, z), of any length > 0; without it, the present one.
        take : bool
            Whether the particle shall stay there if it is free.

        Returns
        -------
        bool

        Raises
        ------
        IndexError
            There is no such particle.
        PW85Error
            A number is not finite, the quaternion is zero, or the centre is too far away.
        MemoryError
            There is not enough memory.
        """
        index = self._index("try_placement", particle)
        place = None if center is None else tuple(np.asarray(center, float).reshape(3).tolist())
        turn = None if quaternion is None else tuple(np.asarray(quaternion, float).reshape(4).tolist())
        with self._lock:
            status, is_free = _core.hard_ellipsoids_try(self._simulation, index, place, turn, bool(take))
        if status:
            _fail(status, "HardEllipsoids.try_placement", f"center {place}, quaternion {turn}")
        return bool(is_free)

    def compress(self, take: bool = False) -> float:
        """How far cell and centres can be compressed before particles touch; and compresses them, if wanted.

        Parameters
        ----------
        take : bool
            Whether the cell and the centres shall be multiplied by the factor.

        Returns
        -------
        float
            The factor of all lengths, at most 1. The exact test finds no overlap after a compression by it. It is 0, and nothing is
            changed, if there are no pairs of particles or images.

        Raises
        ------
        PW85Error
            Particles are too far apart for a list of neighbours.
        MemoryError
            There is not enough memory.
        """
        with self._lock:
            status, factor = _core.hard_ellipsoids_compress(self._simulation, bool(take))
        if status:
            _fail(status, "HardEllipsoids.compress", "")
        return factor

    def check(self) -> None:
        """Searches all particles for overlaps, by a neighbour list of its own.

        Raises
        ------
        PW85Error
            Particles overlap, which never happens unless the program has an error.
        MemoryError
            There is not enough memory.
        """
        with self._lock:
            status, pair = _core.hard_ellipsoids_check(self._simulation)
        if status:
            _fail(status, "HardEllipsoids.check", _overlap(pair))

    def save(self) -> bytes:
        """The whole state as bytes, for `restore`: 80 for each particle and some hundreds."""
        with self._lock:
            return _core.hard_ellipsoids_save(self._simulation)

    def system(self) -> System:
        """A copy of the present state."""
        with self._lock:
            cell = None if self.cell is None else self.cell.copy()
            system = System(self.centers.copy(), self.q.copy(), cell, self.periodic)
            system._axes = self.semi_axes.copy(), self.quaternions.copy()
        return system

    @property
    def counts(self) -> dict[str, TrialCounts]:
        """The trials of each kind since the simulation was made or tuned.

        The kinds are "translation", "rotation", "both", "exchange" and "volume".
        """
        with self._lock:
            counts = _core.hard_ellipsoids_counts(self._simulation)
        return {move: TrialCounts(*pair) for move, pair in zip(_MOVES, counts)}

    @property
    def steps(self) -> TrialSteps:
        """The largest changes of a trial."""
        with self._lock:
            return TrialSteps(*_core.hard_ellipsoids_steps(self._simulation))

    def set_steps(self, translation: float, rotation: float, volume: float) -> None:
        """Sets the largest changes of a trial.

        Parameters
        ----------
        translation : float
            The length of a translation, > 0.
        rotation : float
            The tangent of half of the angle of a rotation, > 0 and at most 1.
        volume : float
            The relative change of a length of the cell, or the shear, > 0 and at most 1.

        Raises
        ------
        PW85Error
            A number is out of range.
        """
        self._repeat("set_steps", 1, _core.hard_ellipsoids_set_steps, float(translation), float(rotation), float(volume))

    def set_fractions(
        self, translation: float = 0.0, rotation: float = 0.0, both: float = 0.0, exchange: float = 0.0
    ) -> None:
        """Sets the parts of the trials of a sweep that are translations, rotations, both at once, and exchanges of semi-axes.

        Parameters
        ----------
        translation, rotation, both, exchange : float
            Not negative. They are divided by their sum, which is positive.

        Raises
        ------
        PW85Error
            A number is negative, or the sum is 0 or not finite.
        """
        fractions = map(float, (translation, rotation, both, exchange))
        self._repeat("set_fractions", 1, _core.hard_ellipsoids_set_fractions, *fractions)

    def _take(self, made: tuple[Any, ...] | None) -> None:
        """Takes what the core has made."""
        assert made is not None
        self._lock = threading.Lock()
        self._simulation, self.centers, self.q, self.semi_axes, self.quaternions, self.cell, periodic = made
        self.periodic = (bool(periodic[0]), bool(periodic[1]), bool(periodic[2]))

    def _index(self, name: str, particle: SupportsIndex) -> int:
        """The index of a particle."""
        index = operator.index(particle)
        if not 0 <= index < len(self):
            raise IndexError(f"HardEllipsoids.{name}: there is no particle {index} among {len(self)}")
        return index

    def _repeat(self, name: str, number: SupportsIndex, function: Callable[..., int], *arguments: float) -> None:
        """Calls a function of the core as often as wanted. Python sees to signals between the calls."""
        with self._lock:
            for _ in range(_number(name, number)):
                status = function(self._simulation, *arguments)
                if status:
                    _fail(status, f"HardEllipsoids.{name}", self._complaint(name, arguments))

    def _complaint(self, name: str, arguments: tuple[float, ...]) -> str:
        """Says what is wrong with the arguments of _repeat()."""
        if name in {"tune", "volume_moves"} and not all(self.periodic) and arguments[-2] > 0:
            return "the cell is not periodic along its three vectors"
        return f"a number is out of range: {', '.join(str(x) for x in arguments if isinstance(x, float))}"


def _number(name: str, number: SupportsIndex) -> int:
    """How often a method shall do something."""
    times = operator.index(number)
    if times < 0:
        raise ValueError(f"HardEllipsoids.{name}: number is negative: {times}")
    return times


def _change(change: Change) -> int:
    if change not in _CHANGES:
        raise ValueError(f"change is none of {', '.join(_CHANGES)}: {change!r}")
    return _CHANGES[change]


def _fail(status: int, function: str, detail: str) -> None:
    if status == Status.ENOMEM:
        raise MemoryError(f"{function}: {_core.strerror(status)}")
    raise PW85Error(status, function, _core.strerror(status), detail)


def _overlap(pair: tuple[int, int]) -> str:
    """Says which particles overlap; nothing for the pair of no overlap."""
    if pair[0] < 0:
        return ""
    return f"particle {pair[0]} overlaps " + ("its own image" if pair[0] == pair[1] else f"particle {pair[1]}")


def _blame(centers: Floats, semi_axes: Floats, quaternions: Floats, cell: Floats | None) -> str:
    """Says which number is bad."""
    bad = ~np.isfinite(centers).all(axis=1)
    if bad.any():
        particle = int(bad.argmax())
        return f"particle {particle}: centers is not finite: {centers[particle].tolist()}"
    found = explain_values("ellipsoid_quaternion", (semi_axes, quaternions))
    return found or ("" if cell is None else explain_values("cell_reduce", (cell,)))
