# SPDX-License-Identifier: BSD-3-Clause
"""Monte Carlo of hard ellipsoids."""

from __future__ import annotations

import threading
import warnings
from typing import Any, Literal, NamedTuple, SupportsIndex
from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._choices import choice
from ._errors import PW85Error, Status, last_cause
from ._forces import Law, checked_law
from ._neighbors import _periodic_cell
from ._arrays import reals
from ._numbers import instance, instances, integer, real, seed_of, truth
from ._words import shown
from ._meshes import Mesh
from ._surroundings import (
    CompiledPotential,
    Field,
    Potential,
    Wall,
    checked_field,
    checked_wall,
    compile_potential,
)
from ._system import System
from ._typing import Floats

Change = Literal["isotropic", "axis", "triclinic", "aspect"]

_CHANGES = {"isotropic": 0, "axis": 1, "triclinic": 2, "aspect": 3}
_MOVES = ("translation", "rotation", "both", "exchange", "volume")

# Walls and fields as the library has them.
_VECTOR = (np.float64, 3)
_WALL = np.dtype([("kind", np.int32), ("point", *_VECTOR), ("vector", *_VECTOR), ("size", np.float64)], align=True)
_FIELD = np.dtype(
    [("kind", np.int32), ("axis", np.int32), ("point", *_VECTOR), ("vector", *_VECTOR), ("strength", np.float64)], align=True
)


class TrialCounts(NamedTuple):
    """Numbers of trial moves of one type since the last `HardEllipsoids.tune`: all `trials`, and those that were `accepted`."""

    trials: int
    accepted: int


class TrialSteps(NamedTuple):
    """Step sizes: the largest changes of a trial move. `translation`, `rotation` and `volume` are as for `HardEllipsoids.set_steps`."""

    translation: float
    rotation: float
    volume: float


class NearImages(NamedTuple):
    """Result of `HardEllipsoids.neighbors`: the images of particles near a given particle.

    - `particles` (n): indices of the particles;
    - `images` (n, 3): multiples of the cell vectors to add to their centres;
    - `separations` (n, 3): vectors from the centre of the given particle to the centres of the images.
    """

    particles: Any
    images: Any
    separations: Any


class InsertionCounts(NamedTuple):
    """Result of `HardEllipsoids.insertion_moves`.

    `insertions` and `removals` are the numbers of trials, and `inserted` and `removed` those of the accepted ones.
    """

    insertions: int
    inserted: int
    removals: int
    removed: int


class HardEllipsoids:
    """A Monte Carlo simulation of hard ellipsoids, which never overlap.

    The exact overlap test decides each trial move. The same calls give bitwise equal trajectories, with any number of threads. Calls from
    several Python threads run one after the other. Every method that needs memory raises MemoryError if there is not enough.

    A two-dimensional `System` gives a simulation of hard ellipses in a plane. Rotations are then about z, areas replace volumes, and
    points and directions may be given as (x, y).

    Parameters
    ----------
    system : System
        The start, without overlaps; it is copied. Without a cell, or along cell vectors that are not periodic, walls or fields must hold
        the particles.
    seed : int
        Seed of the random numbers, from 0 to 2**64 - 1.

    Raises
    ------
    PW85Error
        Ellipsoids overlap, or a number is not allowed. The message names the particles.

    Notes
    -----
    The arrays ``centers``, ``semi_axes``, ``quaternions``, ``q`` and ``cell`` are read-only views of the present state: they change with
    each sweep. Copy an array to keep it. Copies of the object (by `copy.copy` or `pickle`) are independent simulations that continue with
    bitwise equal results.

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

    __slots__ = ("_lock", "_potential", "_simulation", "_views")

    _lock: threading.Lock
    _potential: CompiledPotential | None
    _simulation: Any
    _views: _Views

    def __init__(self, system: System, seed: SupportsIndex = 1) -> None:
        instance(system, System, "HardEllipsoids: system")
        number = seed_of(seed, "HardEllipsoids: seed")
        given = {
            name: np.ascontiguousarray(getattr(system, name), np.float64) for name in ("centers", "semi_axes", "quaternions")
        }
        cell, periodic = _periodic_cell(system.cell, np.array(system.periodic, np.int32))
        status, pair, made = _core.hard_ellipsoids_create(
            given["centers"], cell, periodic, given["semi_axes"], given["quaternions"], number
        )
        if status:
            cause = last_cause("particle", **given)
            _fail(status, "HardEllipsoids", _overlaps(system, pair) if pair[0] >= 0 else cause)
        self._take(made)
        status = _core.hard_ellipsoids_set_dimensions(self._simulation, system.dimensions)
        if status:
            _fail(status, "HardEllipsoids", last_cause("particle", **given))

    @classmethod
    def restore(cls, state: bytes) -> HardEllipsoids:
        """Makes a simulation from the result of `save`. It continues the saved simulation with bitwise equal results.

        If the saved simulation had a potential, call `set_potential` before anything else.

        Parameters
        ----------
        state : bytes
            From `save`, on any machine, by this version of the library or by an earlier one since 3.1.

        Returns
        -------
        HardEllipsoids

        Raises
        ------
        PW85Error
            The bytes are not such a state.
        """
        simulation = cls.__new__(cls)
        if not isinstance(state, bytes):
            raise TypeError(f"HardEllipsoids.restore: state must be bytes, not {shown(state)}")
        status, made = _core.hard_ellipsoids_restore(np.frombuffer(state, np.uint8))
        if status:
            _fail(status, "HardEllipsoids.restore", last_cause())
        simulation._take(made)
        return simulation

    def __copy__(self) -> HardEllipsoids:
        made = type(self).restore(self.save())
        if self._potential is not None:
            made._set_potential(self._potential)
        return made

    def __deepcopy__(self, memo: Any) -> HardEllipsoids:
        return self.__copy__()

    def __reduce__(self) -> tuple[Callable[[bytes], HardEllipsoids], tuple[bytes]]:
        return type(self).restore, (self.save(),)

    def __len__(self) -> int:
        """Number of particles."""
        return len(self.centers)

    def __repr__(self) -> str:
        return f"<pypw85.HardEllipsoids: {len(self)} {'particles' if self.dimensions == 3 else 'ellipses'}>"

    def set_walls(self, walls: Iterable[Wall] = ()) -> None:
        """Sets the hard walls, and removes all walls that were set before. A particle may touch a wall.

        The periodic vectors of the cell must be parallel to the walls. With walls, `chain` and `compress` are not possible.

        Parameters
        ----------
        walls : iterable of Wall
            From `Wall.plane`, `Wall.sphere`, `Wall.cylinder` and `Wall.box`. Without an argument, all walls are removed.

        Raises
        ------
        PW85Error
            A wall cuts a particle, or the cell or the number of dimensions does not allow a wall. The walls are not changed.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> one = pypw85.System.from_axes([[0, 0, 0]], [[0.3, 0.3, 0.9]], [[1, 0, 0, 0]])
        >>> simulation = pypw85.HardEllipsoids(one)
        >>> simulation.set_walls([pypw85.Wall.sphere([0, 0, 0], 1.0)])
        >>> simulation.sweep(1000)
        >>> bool(np.linalg.norm(simulation.centers) < 0.7)
        True
        """
        self._set_walls(walls, range(len(self)))

    def _set_walls(self, walls: Iterable[Wall], ids: Sequence[int], rows: str = "wall") -> None:
        """As `set_walls`. The message about a particle that a wall cuts names it by its id; walls have no numbers if `rows` is empty."""
        name = "HardEllipsoids.set_walls: walls"
        given = [checked_wall(wall, f"{name}[{k}]") for k, wall in enumerate(instances(walls, Wall, name))]
        with self._lock:
            status, (particle, cutting) = _core.hard_ellipsoids_set_walls(self._simulation, _records(given, _WALL))
        if status:
            is_cut = particle >= 0
            where = (f"{rows} {cutting}, {given[cutting]}, " if rows else "") + f"particle {ids[particle]}: " if is_cut else ""
            self._fail(status, "set_walls", where + (last_cause() if is_cut else last_cause(rows, walls=given)))

    def set_mesh(self, mesh: Mesh | None) -> None:
        """Sets a hard mesh of triangles, and removes the mesh that was set before. No particle may overlap a triangle.

        Particles may be on both sides of the surface. In sweeps they stay on their side, because translations are limited to less than
        twice the shortest semi-axis of a particle. In a periodic cell the mesh is also periodic. With a mesh, `volume_moves`, `chain` and
        `compress` are not possible.

        Parameters
        ----------
        mesh : Mesh or None
            The triangles, which are copied; None for no mesh.

        Raises
        ------
        PW85Error
            The mesh cuts a particle, is wider than 16 periods of the cell, or the simulation has two dimensions. The mesh is not changed.

        Examples
        --------
        >>> import pypw85
        >>> one = pypw85.System.from_axes([[0, 0, 0]], [[0.3, 0.3, 0.9]], [[1, 0, 0, 0]])
        >>> simulation = pypw85.HardEllipsoids(one)
        >>> floor = pypw85.Mesh([[-9, -9, -1], [9, -9, -1], [0, 9, -1]], [[0, 1, 2]])
        >>> simulation.set_mesh(floor)
        >>> simulation.try_placement(0, [0, 0, -0.2], None)
        False
        """
        if mesh is not None:
            instance(mesh, Mesh, "HardEllipsoids.set_mesh: mesh")
        vertices = np.empty((0, 3)) if mesh is None else mesh.vertices
        triangles = np.empty((0, 3), np.int32) if mesh is None else mesh.triangles
        with self._lock:
            status, (particle, triangle) = _core.hard_ellipsoids_set_mesh(self._simulation, vertices, triangles)
        if status:
            cause = last_cause()
            self._fail(status, "set_mesh", f"the mesh cuts particle {particle}, next to triangle {triangle}" if particle >= 0 else cause)

    def set_fields(self, fields: Iterable[Field] = ()) -> None:
        """Sets the external fields, and removes all fields that were set before.

        The probability density of a configuration is then proportional to exp(-βU), where βU is the sum of the energies of all particles
        in all fields. A field must be the same in all images of a periodic cell. With fields, `chain` and `compress` are not possible.

        Parameters
        ----------
        fields : iterable of Field
            From `Field.linear`, `Field.weight`, `Field.harmonic` and `Field.aligning`. Without an argument, all fields are removed.

        Raises
        ------
        PW85Error
            A field is not the same in all images of the cell, or the energy of a particle is not finite. The fields are not changed.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> one = pypw85.System.from_axes([[0, 0, 0]], [[0.5, 0.5, 0.5]], [[1, 0, 0, 0]])
        >>> simulation = pypw85.HardEllipsoids(one)
        >>> simulation.set_fields([pypw85.Field.harmonic([0, 0, 0], [1, 1, 1])])
        >>> simulation.energy()
        0.0
        >>> simulation.sweep(1000)
        >>> bool(simulation.energy() == (simulation.centers**2).sum() / 2)
        True
        """
        self._set_fields(fields)

    def _set_fields(self, fields: Iterable[Field], rows: str = "field") -> None:
        """As `set_fields`. In messages fields have no numbers if `rows` is empty."""
        name = "HardEllipsoids.set_fields: fields"
        given = [checked_field(field, f"{name}[{k}]") for k, field in enumerate(instances(fields, Field, name))]
        with self._lock:
            status = _core.hard_ellipsoids_set_fields(self._simulation, _records(given, _FIELD))
        self._check(status, "set_fields", rows, fields=given)

    def set_law(self, law: Law | None) -> None:
        """Sets or removes a law: a pair potential outside the hard cores, with βU as a function of μ².

        The probability density of a configuration is then proportional to exp(-βU), where U is the sum over all pairs, including images.
        With a law, `chain` is not possible; `try_placement`, `try_insertion` and `compress` test only for overlaps.

        Parameters
        ----------
        law : Law or None
            From `Law.inverse_powers`, with a cutoff, or `Law.table`; its energies are in units of k_B T. None for no law.

        Raises
        ------
        PW85Error
            The law is a soft repulsion, which is 0 outside the hard cores; its parameters are not allowed; βU of a pair could exceed
            2**20; or the cutoff, a value of μ², is 1 or less, or above 10**6. The law is not changed.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> axes, upright = [[0.5, 0.5, 1]] * 2, [[1, 0, 0, 0]] * 2
        >>> two = pypw85.System.from_axes([[0, 0, 0], [0, 0, 2.2]], axes, upright)
        >>> simulation = pypw85.HardEllipsoids(two)
        >>> simulation.set_law(pypw85.Law.inverse_powers(4, 12, 4, 6, mu2_max=6.25))
        >>> at_cutoff = 4 * (2.5**-12 - 2.5**-6)
        >>> bool(abs(simulation.energy() - (4 * (1.1**-12 - 1.1**-6) - at_cutoff)) < 1e-9)
        True
        """
        given = Law(0, np.empty(0)) if law is None else checked_law(law, "HardEllipsoids.set_law: law")
        parameters = np.require(given.parameters, np.float64, ["C", "A"])
        with self._lock:
            status = _core.hard_ellipsoids_set_law(self._simulation, given.kind, parameters)
        self._check(status, "set_law", num_parameters=len(parameters), parameters=parameters)

    def set_potential(self, potential: Potential | int | None, context: int = 0) -> None:
        """Sets or removes an external potential that you program yourself, in addition to the fields.

        A Python function is slow, and only one thread calls it at a time. A compiled function (by Numba or in C), given by its address,
        has no such cost.

        Parameters
        ----------
        potential : callable, int or None
            ``potential(particle, center, quaternion, semi_axes)`` returns βU of a particle. Its arguments are the index of the particle
            and three arrays, which are valid only during the call. A result of infinity forbids the position. The function must not call
            methods of this simulation: that would be a deadlock. Instead of a Python function, pass the address of a C function of the
            type ``pw85_potential``, or None for no potential.
        context : int
            First argument of the C function; a Python function does not receive it.

        Raises
        ------
        PW85Error
            The energy of a particle is not finite; or the simulation was restored, and the saved one had another potential. To replace
            the potential of a restored simulation, first set None.

        Notes
        -----
        If the potential returns NaN or raises an exception, the method that called it raises an exception, too, and the simulation
        returns to the state before the last sweep or trial. A restored simulation needs its potential again; a copy keeps it.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> one = pypw85.System.from_axes([[0, 0, 0]], [[0.5, 0.5, 0.5]], [[1, 0, 0, 0]])
        >>> simulation = pypw85.HardEllipsoids(one)
        >>> simulation.set_potential(lambda particle, center, *others: abs(center).sum())
        >>> simulation.sweep(100)
        >>> bool(simulation.energy() == abs(simulation.centers).sum())
        True
        """
        self._set_potential(None if potential is None else compile_potential(potential, context))

    def _set_potential(self, made: CompiledPotential | None) -> None:
        with self._lock:
            address, context = (0, 0) if made is None else (made.address, made.context)
            status = _core.hard_ellipsoids_set_potential(self._simulation, address, context)
            if not status:  # before another thread sets another one: what the simulation calls must live
                self._potential = made
        if status:
            error = None if made is None else made.take_error()
            if error is not None:
                raise error
            self._fail(status, "set_potential", last_cause())

    def energy(self) -> float:
        """Computes the energy βU of all particles in the fields and the potential, and of all pairs by the law; 0 without these.

        Returns
        -------
        float

        Raises
        ------
        PW85Error
            The potential of a restored simulation is not set, or it returns NaN.
        """
        with self._lock:
            status, energy = _core.hard_ellipsoids_energy(self._simulation)
        self._check(status, "energy")
        return energy

    def law_virial(self) -> float:
        """Computes the virial of the law, W = -2 Σ μ² dβU/dμ² over all pairs; 0 without a law.

        In d dimensions, βP/ρ = 1 + (n'(0) + <W>)/(d N), where n(ε) is the mean number of pairs with μ < 1 + ε. `Observables` computes this
        average.

        Returns
        -------
        float

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> axes, upright = [[0.5, 0.5, 1]] * 2, [[1, 0, 0, 0]] * 2
        >>> two = pypw85.System.from_axes([[0, 0, 0], [0, 0, 2.2]], axes, upright)
        >>> simulation = pypw85.HardEllipsoids(two)
        >>> simulation.set_law(pypw85.Law.inverse_powers(4, 12, 4, 6, mu2_max=6.25))
        >>> expected = 48 * 1.1**-12 - 24 * 1.1**-6  # -μ dU/dμ
        >>> bool(abs(simulation.law_virial() - expected) < 1e-9)
        True
        """
        with self._lock:
            status, virial = _core.hard_ellipsoids_law_virial(self._simulation)
        self._check(status, "law_virial")
        return virial

    def sweep(self, number: SupportsIndex = 1) -> None:
        """Makes sweeps. A sweep has as many trial moves as there are particles. Ctrl-C takes effect after the current sweep.

        Parameters
        ----------
        number : int
            Number of sweeps, at least 0.

        Raises
        ------
        MemoryError
            There is not enough memory. The last sweep is then incomplete. Shorter translations (`set_steps`) need less memory.
        """
        self._repeat("sweep", number)

    def chain(self, number: SupportsIndex, length: float | None = None, direction: ArrayLike | None = None) -> float:
        """Makes event chains, and returns the pressure that follows from them.

        In an event chain a particle moves along a line until it touches another particle, which then moves along the same direction, and
        so on, without rejections (Michel, Kapfer and Krauth, J. Chem. Phys. 140, 054116, 2014). Chains do not rotate particles: alternate
        them with `sweep`. Ctrl-C takes effect after all chains of a call.

        Parameters
        ----------
        number : int
            Number of chains, at least 0.
        length : float, optional
            Length of each chain, the sum of its displacements, > 0. By default the cube root of the volume of the cell, in two
            dimensions the square root of its area. A chain visits about all particles if its length is the mean free path times the
            number of particles.
        direction : (3,) array_like, optional
            Direction of all chains, a vector of any length > 0. By default each chain has a random direction.

        Returns
        -------
        float
            βP/ρ along the directions, averaged over these chains. NaN without chains or particles. Also NaN if a particle could touch
            its own image, that is, if the shortest lattice vector is not longer than twice the longest semi-axis: chains do not see such
            contacts, which contribute to the pressure. In that case use the pressure from contacts (`Observables`).

        Raises
        ------
        PW85Error
            `length` is not positive; `direction` is zero or out of the plane; there are walls, a mesh, fields, a potential or a law; or
            particles block each other within rounding errors.
        ValueError
            `length` is missing, and the cell is not periodic along all its vectors.
        MemoryError
            There is not enough memory. The last chain is then incomplete.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> start = pypw85.pack(np.tile([0.5, 0.5, 1], (50, 1)), 0.3, seed=1)
        >>> simulation = pypw85.HardEllipsoids(start, seed=1)
        >>> simulation.tune(50)
        >>> simulation.sweep(50)
        >>> bool(3 < simulation.chain(20) < 6)  # βP/ρ
        True
        """
        times = _number("chain", number)
        along = None if direction is None else self._point("chain", "direction", direction, 0.0)
        length = self._usual_length() if length is None else real(length, "HardEllipsoids.chain: length")
        with self._lock:
            status, compressibility = _core.hard_ellipsoids_chain(self._simulation, times, length, along)
        if status:
            _fail(status, "HardEllipsoids.chain", last_cause(length=length, direction=along))
        return compressibility

    def volume_moves(self, number: SupportsIndex, pressure: float, change: Change = "isotropic") -> None:
        """Makes volume moves: trial changes of the cell, and of all centres with it, at constant pressure.

        Alternate them with `sweep` for the ensemble of constant pressure, for instance one volume move after each sweep.

        Parameters
        ----------
        number : int
            Number of trials, at least 0.
        pressure : float
            Reduced pressure βP = P/(k_B T) > 0, in the inverse cube of the unit of length (in two dimensions, the inverse square). If
            `change` is "aspect", any finite number: it has no effect.
        change : "isotropic", "axis", "triclinic" or "aspect"
            "isotropic" scales all cell vectors by the same factor; "axis" scales the cell along one of its vectors; "triclinic" does this
            or shears the cell; "aspect" scales along one vector and along the others such that the volume is constant.

        Raises
        ------
        PW85Error
            `pressure` is not positive; the cell is not periodic along its three vectors (in two dimensions, its first two); or there is a
            mesh.
        MemoryError
            There is not enough memory. The configuration is that before the trial.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> start = pypw85.pack(np.tile([0.5, 0.5, 1], (50, 1)), 0.2, seed=1)
        >>> simulation = pypw85.HardEllipsoids(start)
        >>> before = simulation.system().packing_fraction
        >>> for _ in range(200):
        ...     simulation.sweep()
        ...     simulation.volume_moves(1, pressure=10)
        >>> simulation.system().packing_fraction > before
        True
        """
        (pressure,) = _reals("volume_moves", pressure=pressure)
        self._repeat("volume_moves", number, pressure=pressure, change=_change("volume_moves", change))

    def tune(
        self, number: SupportsIndex, acceptance: float = 0.4, pressure: float = 0.0, change: Change = "isotropic"
    ) -> None:
        """Makes sweeps to equilibrate, and adjusts the step sizes after each of them. At the end all `counts` are set to zero.

        Detailed balance does not hold while the step sizes change: do not average over these sweeps. Translations become at most half as
        long as the longest semi-axis, unless the particles are far apart.

        Parameters
        ----------
        number : int
            Number of sweeps, at least 0.
        acceptance : float
            The fraction of trials that is to be accepted, > 0 and at most 1.
        pressure : float
            βP for one volume move after each sweep, as for `volume_moves`; 0 for no volume moves.
        change : "isotropic", "axis", "triclinic" or "aspect"
            As for `volume_moves`. With "aspect" there is a trial after each sweep even if the pressure is 0.

        Raises
        ------
        PW85Error
            `acceptance` or `pressure` is out of range; or there is a pressure, and the cell is not periodic as `volume_moves` needs it.
        """
        acceptance, pressure = _reals("tune", acceptance=acceptance, pressure=pressure)
        self._repeat("tune", number, acceptance=acceptance, pressure=pressure, change=_change("tune", change))

    def neighbors(self, particle: SupportsIndex) -> NearImages:
        """Lists the images of particles whose bounding boxes intersect that of a given particle.

        Parameters
        ----------
        particle : int
            Index of the particle, from 0.

        Returns
        -------
        NearImages
            Sorted by the indices of the particles, then by their images.

        Raises
        ------
        IndexError
            There is no such particle.
        """
        index, found = self._index("neighbors", particle), NearImages(None, None, None)
        with self._lock:
            status, count = _core.hard_ellipsoids_neighbors(self._simulation, index, *found)
            if not status:
                found = NearImages(np.empty(count, np.int32), np.empty((count, 3), np.int32), np.empty((count, 3)))
                status, _ = _core.hard_ellipsoids_neighbors(self._simulation, index, *found)
        if status:
            _fail(status, "HardEllipsoids.neighbors", "")
        return found

    def try_placement(
        self,
        particle: SupportsIndex,
        center: ArrayLike | None = None,
        quaternion: ArrayLike | None = None,
        take: bool = False,
    ) -> bool:
        """Decides exactly whether a particle overlaps nothing at another position. If `take` is true, it also moves the particle there.

        Parameters
        ----------
        particle : int
            Index of the particle, from 0.
        center : (3,) array_like, optional
            New centre. By default the present one.
        quaternion : (4,) array_like, optional
            New orientation (w, x, y, z), of any length > 0. By default the present one.
        take : bool
            True to move the particle there if it overlaps nothing.

        Returns
        -------
        bool
            True if the particle overlaps nothing at the new position.

        Raises
        ------
        IndexError
            There is no such particle.
        PW85Error
            A number is not finite; the quaternion is zero; or the centre is too far away or, in two dimensions, out of the plane.
        """
        index = self._index("try_placement", particle)
        place = None if center is None else self._point("try_placement", "center", center, float(self.centers[index, 2]))
        turn = None if quaternion is None else _vector("try_placement", "quaternion", quaternion, 4)
        moves = truth(take, "HardEllipsoids.try_placement: take")
        with self._lock:
            status, is_free = _core.hard_ellipsoids_try(self._simulation, index, place, turn, moves)
        self._check(status, "try_placement", center=place, quaternion=turn)
        return bool(is_free)

    def try_insertion(self, center: ArrayLike, quaternion: ArrayLike, semi_axes: ArrayLike, take: bool = False) -> bool:
        """Decides exactly whether a new particle would overlap nothing. If `take` is true, it also inserts the particle.

        The new particle gets the last index. Arrays such as ``centers`` that were obtained before do not contain it.

        Parameters
        ----------
        center : (3,) array_like
            Its centre.
        quaternion : (4,) array_like
            Its orientation (w, x, y, z), of any length > 0.
        semi_axes : (3,) array_like
            Its semi-axes, > 0.
        take : bool
            True to insert the particle if it overlaps nothing.

        Returns
        -------
        bool
            True if the new particle overlaps nothing.

        Raises
        ------
        PW85Error
            A number is not allowed; a semi-axis is longer than 32 times the shortest lattice vector; or the centre is too far away or, in
            two dimensions, out of the plane.
        """
        height = float(self.centers[0, 2]) if len(self) else 0.0
        place = self._point("try_insertion", "center", center, height)
        turn = _vector("try_insertion", "quaternion", quaternion, 4)
        axes = _vector("try_insertion", "semi_axes", semi_axes, 3)
        stays = truth(take, "HardEllipsoids.try_insertion: take")
        with self._lock:
            status, is_free = _core.hard_ellipsoids_insert(self._simulation, place, turn, axes, stays)
            self._renew()
        self._check(status, "try_insertion", center=place, quaternion=turn, semi_axes=axes)
        return bool(is_free)

    def remove(self, particle: SupportsIndex) -> None:
        """Removes a particle. The last particle gets its index.

        Arrays such as ``centers`` that were obtained before show the old particles.

        Parameters
        ----------
        particle : int
            Index of the particle, from 0.

        Raises
        ------
        IndexError
            There is no such particle.
        PW85Error
            The potential of a restored simulation is not set.
        """
        index = self._index("remove", particle)
        with self._lock:
            status = _core.hard_ellipsoids_remove(self._simulation, index)
            self._renew()
        self._check(status, "remove")

    def insertion_weight(self, number: SupportsIndex, semi_axes: ArrayLike) -> float:
        """Computes the mean of exp(-βU) of a test particle at random positions and orientations (Widom's method).

        An overlap counts as 0. The test particle is not inserted. Positions are uniform in the cell, which begins at the origin, also along
        vectors that are not periodic. If w is the mean of the results over many states, the chemical potential of this species at the
        density ρ is βμ = ln ρ - ln w, up to the constant ln Λ³.

        Parameters
        ----------
        number : int
            Number of test insertions, at least 0.
        semi_axes : (3,) array_like
            Semi-axes of the test particle, > 0.

        Returns
        -------
        float
            Without energies, the fraction of the insertions without an overlap. NaN without insertions.

        Raises
        ------
        PW85Error
            There is no cell, or its vectors are linearly dependent; or a semi-axis is not allowed.
        """
        times, axes = _number("insertion_weight", number), _vector("insertion_weight", "semi_axes", semi_axes, 3)
        with self._lock:
            status, weight = _core.hard_ellipsoids_insertion_weight(self._simulation, times, axes)
        self._check(status, "insertion_weight", semi_axes=axes)
        return weight

    def insertion_moves(self, number: SupportsIndex, semi_axes: ArrayLike, activities: ArrayLike) -> InsertionCounts:
        """Makes trial insertions and removals of particles at constant activities. Together with `sweep`, they sample the grand canonical
        ensemble.

        The semi-axes define the species of a particle. Particles of other species are never removed, nor are particles that are outside
        the cell along vectors that are not periodic. Arrays such as ``centers`` that were obtained before show the old particles.

        Parameters
        ----------
        number : int
            Number of trials, at least 0. Each trial is an insertion or a removal, with equal probability, of a particle of one of the
            species, all equally probable.
        semi_axes : (3,) or (species, 3) array_like
            Semi-axes of each species, > 0.
        activities : float or (species,) array_like
            Activity z = exp(βμ)/Λ³ of each species, > 0: the density of an ideal gas with the same chemical potential.

        Returns
        -------
        InsertionCounts

        Raises
        ------
        PW85Error
            There is no cell, or its vectors are linearly dependent; a semi-axis or an activity is not allowed; or two species are the
            same.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> start = pypw85.pack(np.tile([0.5, 0.5, 0.5], (64, 1)), 0.2, seed=1)
        >>> simulation = pypw85.HardEllipsoids(start)
        >>> tried = simulation.insertion_moves(1000, [0.5, 0.5, 0.5], 1.0)
        >>> len(simulation) == 64 + tried.inserted - tried.removed
        True
        """
        times = _number("insertion_moves", number)
        name = "HardEllipsoids.insertion_moves"
        axes = np.atleast_2d(reals(semi_axes, f"{name}: semi_axes").copy())
        z = np.atleast_1d(reals(activities, f"{name}: activities").copy())
        if axes.ndim != 2 or axes.shape[1] != 3 or z.shape != axes.shape[:1]:
            raise ValueError(f"{name}: the shapes of semi_axes and activities must be (species, 3) and (species,), "
                             f"not {np.shape(semi_axes)} and {np.shape(activities)}")  # fmt: skip
        with self._lock:
            status, counts = _core.hard_ellipsoids_insertion_moves(self._simulation, times, axes, z)
            self._renew()
        self._check(status, "insertion_moves", "species", semi_axes=axes, activities=z.tolist())
        return InsertionCounts(*counts)

    def compress(self, take: bool = False) -> float:
        """Finds the smallest factor by which cell and centres can be multiplied without overlaps. If `take` is true, it also does so.

        Shapes and orientations do not change.

        Parameters
        ----------
        take : bool
            True to multiply the cell and the centres by the factor.

        Returns
        -------
        float
            The factor, > 0 and at most 1. The exact test finds no overlap at this factor. If there are no pairs of particles or images, the
            result is 0, and nothing is changed.

        Raises
        ------
        PW85Error
            The particles are too far apart for a neighbour list; or there are walls, a mesh, fields or a potential.
        """
        with self._lock:
            status, factor = _core.hard_ellipsoids_compress(self._simulation, truth(take, "HardEllipsoids.compress: take"))
        if status:
            _fail(status, "HardEllipsoids.compress", last_cause())
        return factor

    def check(self) -> None:
        """Tests all particles for overlaps, independently of the neighbour list of the simulation. It returns nothing if there are none.

        Raises
        ------
        PW85Error
            Particles overlap. This never happens unless the library has an error.
        """
        with self._lock:
            status, pair = _core.hard_ellipsoids_check(self._simulation)
        if status:
            _fail(status, "HardEllipsoids.check", f"a wall cuts particle {pair[0]}" if pair[1] < 0 <= pair[0] else
                  name_pairs([pair]) if pair[0] >= 0 else "")  # fmt: skip

    def save(self) -> bytes:
        """Returns the whole state as bytes, for `restore`: 80 bytes for each particle and several hundred more.

        The state contains walls, mesh, fields and law, but not a potential, of which it contains only the energy. If the potential raises
        an exception, or its energy is not finite, the method raises this exception, or `PW85Error`.

        Examples
        --------
        >>> import pypw85
        >>> ball = [1, 0, 0, 1, 0, 1]
        >>> two = pypw85.System([[0, 0, 0], [0, 0, 3]], [ball, ball])
        >>> simulation = pypw85.HardEllipsoids(two)
        >>> again = pypw85.HardEllipsoids.restore(simulation.save())
        >>> simulation.sweep(10)
        >>> again.sweep(10)
        >>> bool((again.centers == simulation.centers).all())
        True
        """
        with self._lock:
            state = np.empty(_core.hard_ellipsoids_num_bytes(self._simulation), np.uint8)
            status = _core.hard_ellipsoids_save(self._simulation, state)
        self._check(status, "save")
        return state.tobytes()

    def system(self) -> System:
        """Returns a copy of the present state."""
        with self._lock:
            cell = None if self.cell is None else self.cell.copy()
            system = System(self.centers.copy(), self.q.copy(), cell, self.periodic, dimensions=self.dimensions)
            system._axes = self.semi_axes.copy(), self.quaternions.copy()
        return system

    @property
    def dimensions(self) -> int:
        """3, or 2 for ellipses in a plane."""
        _, dimensions = _core.hard_ellipsoids_dimensions(self._simulation)
        return int(dimensions)

    @property
    def centers(self) -> Floats:
        """Centres (n, 3), not wrapped into the cell. Read-only."""
        return self._views.centers

    @property
    def semi_axes(self) -> Floats:
        """Semi-axes (n, 3). Read-only."""
        return self._views.semi_axes

    @property
    def quaternions(self) -> Floats:
        """Orientations (n, 4), unit quaternions (w, x, y, z). Read-only."""
        return self._views.quaternions

    @property
    def q(self) -> Floats:
        """Forms (n, 6). Read-only."""
        return self._views.q

    @property
    def cell(self) -> Floats | None:
        """Cell vectors (3, 3), one in each row; None without a cell. Read-only."""
        return self._views.cell

    @property
    def periodic(self) -> tuple[bool, bool, bool]:
        """True for each cell vector along which the system is periodic."""
        return self._views.periodic

    @property
    def counts(self) -> dict[str, TrialCounts]:
        """Numbers of trial moves of each type since the simulation was made or tuned.

        The types are "translation", "rotation", "both" (translation and rotation at once), "exchange" (of the semi-axes of two particles)
        and "volume".
        """
        with self._lock:
            _, trials, accepted = _core.hard_ellipsoids_counts(self._simulation)
        return {move: TrialCounts(*pair) for move, *pair in zip(_MOVES, trials, accepted)}

    @property
    def steps(self) -> TrialSteps:
        """The largest changes of a trial move. See `set_steps`."""
        with self._lock:
            return TrialSteps(*_core.hard_ellipsoids_steps(self._simulation)[1])

    def set_steps(self, translation: float, rotation: float, volume: float) -> None:
        """Sets the step sizes: the largest changes of a trial move. `tune` chooses them automatically.

        Parameters
        ----------
        translation : float
            Largest length of a translation, > 0; in a periodic cell at most the length of its longest vector. The memory for neighbour
            lists grows with its third power, in two dimensions with its square.
        rotation : float
            ``tan(angle/2)`` of the largest angle of a rotation, > 0 and at most 1.
        volume : float
            Largest relative change of a length of the cell, or largest shear, > 0 and at most 1.

        Raises
        ------
        PW85Error
            A number is out of range.
        """
        steps = np.array([*_reals("set_steps", translation=translation, rotation=rotation, volume=volume)])
        with self._lock:
            status = _core.hard_ellipsoids_set_steps(self._simulation, steps)
        self._check(status, "set_steps", steps=TrialSteps._fields)

    def set_kind_steps(self, semi_axes: ArrayLike, translation: ArrayLike, rotation: ArrayLike) -> None:
        """Sets step sizes for particles with given semi-axes (species), and removes all step sizes for species that were set before.

        Other particles have the step sizes of `set_steps`. `tune` adjusts the step sizes of each species by the trials of this species. If
        no particle has the given semi-axes, there is a warning (`UserWarning`).

        Parameters
        ----------
        semi_axes : (3,) or (species, 3) array_like
            Semi-axes of each species, exactly as those of its particles; at most 16 species, or none.
        translation, rotation : float or (species,) array_like
            As for `set_steps`, for each species.

        Raises
        ------
        PW85Error
            A number is out of range, or two species are the same.
        """
        name = "HardEllipsoids.set_kind_steps"
        given = reals(semi_axes, f"{name}: semi_axes")
        if given.size and (given.ndim > 2 or given.shape[-1:] != (3,)):
            raise ValueError(f"{name}: semi_axes must have the shape (3,) or (species, 3), not {given.shape}")
        axes = np.ascontiguousarray(given.reshape(-1, 3))
        steps = np.empty((len(axes), 2))
        for column, (argument, value) in enumerate((("translation", translation), ("rotation", rotation))):
            numbers = reals(value, f"{name}: {argument}")
            if numbers.shape not in ((), (1,), (len(axes),)):
                raise ValueError(f"{name}: {argument} must be one number, or one for each of the {len(axes)} species, "
                                 f"not the shape {numbers.shape}")  # fmt: skip
            steps[:, column] = numbers
        self._warn_of_absent(axes, name)
        with self._lock:
            status = _core.hard_ellipsoids_set_kind_steps(self._simulation, axes, steps)
        self._check(status, "set_kind_steps", "species", semi_axes=axes, steps=TrialSteps._fields)

    def _warn_of_absent(self, axes: Floats, name: str) -> None:
        """Warns of species of which there is no particle, as those whose semi-axes are misspelt."""
        for row in axes:
            if not (self.semi_axes == row).all(axis=1).any():
                warnings.warn(f"{name}: no particle has the semi-axes {row.tolist()}: these steps are for particles that are yet to be "
                              "inserted", stacklevel=3)  # fmt: skip

    def kind_steps(self, semi_axes: ArrayLike) -> TrialSteps:
        """Returns the step sizes of particles with given semi-axes.

        These are the step sizes of `set_kind_steps`, or those of `set_steps` if none were set for these semi-axes. There need not be such a
        particle.

        Parameters
        ----------
        semi_axes : (3,) array_like
            Semi-axes of the species.

        Returns
        -------
        TrialSteps
        """
        steps = np.empty((1, 2))
        axes = _vector("kind_steps", "semi_axes", semi_axes, 3)
        with self._lock:
            _core.hard_ellipsoids_kind_steps(self._simulation, axes[None], steps)
        translation, rotation = map(float, steps[0])
        return TrialSteps(translation, rotation, self.steps.volume)

    def set_fractions(
        self, translation: float = 0.0, rotation: float = 0.0, both: float = 0.0, exchange: float = 0.0
    ) -> None:
        """Sets the fractions of the trials of a sweep that are translations, rotations, both at once, and exchanges of semi-axes.

        An exchange gives two particles the semi-axes of each other. At the start, half of the trials are translations and half are
        rotations.

        Parameters
        ----------
        translation, rotation, both, exchange : float
            At least 0. They are divided by their sum, which must be positive.

        Raises
        ------
        PW85Error
            A number is negative, or the sum is 0 or not finite.
        """
        fractions = np.array([*_reals("set_fractions", translation=translation, rotation=rotation, both=both, exchange=exchange)])
        with self._lock:
            status = _core.hard_ellipsoids_set_fractions(self._simulation, fractions)
        self._check(status, "set_fractions", fractions=fractions)

    def _take(self, made: Any) -> None:
        """Takes what the core has made."""
        self._lock = threading.Lock()
        self._potential = None
        self._simulation = made
        self._renew()

    def _renew(self) -> None:
        """Takes the arrays of the present particles."""
        centers, q, semi_axes, quaternions, cell, (a, b, c) = _core.hard_ellipsoids_views(self._simulation)
        self._views = _Views(centers, q, semi_axes, quaternions, cell, (bool(a), bool(b), bool(c)))

    def _check(self, status: int, name: str, rows: str = "row", /, **arguments: Any) -> None:
        """Raises the error of a status other than zero, with the cause that the library gives."""
        if status:
            self._fail(status, name, last_cause(rows, **arguments))

    def _fail(self, status: int, name: str, detail: str) -> None:
        """Raises what the potential has raised, or an error of the library."""
        error = None if self._potential is None else self._potential.take_error()
        if error is not None:
            raise error
        _fail(status, f"HardEllipsoids.{name}", detail)

    def _usual_length(self) -> float:
        """Of chains."""
        if self.cell is None or not is_bulk(self):
            raise ValueError(f"HardEllipsoids.chain: pass length, because {self._unbounded()}")
        return usual_length(self.cell, self.dimensions)

    def _unbounded(self) -> str:
        return f"the cell is not periodic along its {'three' if self.dimensions == 3 else 'two'} vectors"

    def _point(self, name: str, argument: str, value: ArrayLike, height: float) -> Floats:
        """The numbers of a vector. In two dimensions (x, y) are enough."""
        if self.dimensions == 2 and np.shape(value) == (2,):
            return np.append(_vector(name, argument, value, 2), height)
        return _vector(name, argument, value, 3)

    def _index(self, name: str, particle: SupportsIndex) -> int:
        """The index of a particle."""
        index = integer(particle, f"HardEllipsoids.{name}: particle", None)
        if not 0 <= index < len(self):
            raise IndexError(f"HardEllipsoids.{name}: particle must be an index of the {len(self)} particles, not {index}")
        return index

    def _repeat(self, name: str, number: SupportsIndex, **arguments: float) -> None:
        """Calls a function of the core as often as wanted. Python sees to signals between the calls."""
        function = getattr(_core, f"hard_ellipsoids_{name}")
        with self._lock:
            for _ in range(_number(name, number)):
                status = function(self._simulation, 1, *arguments.values())
                if status == Status.ENOMEM:
                    step = _core.hard_ellipsoids_steps(self._simulation)[1][0]
                    power = "third" if self.dimensions == 3 else "second"
                    raise MemoryError(f"HardEllipsoids.{name}: there is not enough memory. The Verlet lists grow with the {power} power of "
                                      f"the largest translation, {step:g}: set a shorter one by set_steps()")  # fmt: skip
                self._check(status, name, **arguments)


class _Views(NamedTuple):
    """The arrays of a simulation, and its periodic directions."""

    centers: Floats
    q: Floats
    semi_axes: Floats
    quaternions: Floats
    cell: Floats | None
    periodic: tuple[bool, bool, bool]


def _number(name: str, number: SupportsIndex) -> int:
    """The number of repetitions of a method."""
    return integer(number, f"HardEllipsoids.{name}: number")


def _reals(name: str, **numbers: float) -> list[float]:
    """Numbers of a method, by the names of its arguments."""
    return [real(number, f"HardEllipsoids.{name}: {argument}") for argument, number in numbers.items()]


def _vector(name: str, argument: str, value: ArrayLike, size: int) -> Floats:
    """The numbers of an argument of a method."""
    array = reals(value, f"HardEllipsoids.{name}: {argument}")
    if array.size != size:
        raise ValueError(f"HardEllipsoids.{name}: the shape of {argument} must be ({size},), not {array.shape}")
    return np.array(array.ravel())


def _records(rows: Sequence[tuple[Any, ...]], kind: np.dtype[Any]) -> NDArray[Any]:
    """Walls or fields as the library has them. Numbers that are not an index become -1, which it refuses."""
    index = [kind[name] == np.int32 for name in kind.names or ()]
    return np.array([tuple((int(x) if 0 <= x < 100 else -1) if one else x for one, x in zip(index, row)) for row in rows], kind)


def _change(name: str, change: Change) -> int:
    return _CHANGES[choice(change, f"HardEllipsoids.{name}: change", _CHANGES)]


def _fail(status: int, function: str, detail: str) -> None:
    if status == Status.ENOMEM:
        raise MemoryError(f"{function}: {detail or _core.strerror(status)}")
    raise PW85Error(status, function, _core.strerror(status), detail)


def is_bulk(system: System | HardEllipsoids) -> bool:
    """Returns whether a system is repeated along the vectors of its cell, those of the plane in two dimensions."""
    return all(system.periodic[: system.dimensions])


def usual_length(cell: Floats, dimensions: int) -> float:
    """The edge of a cube as large as a cell, or of a square."""
    if dimensions == 3:
        return float(np.cbrt(abs(np.linalg.det(cell))))
    (a, b, _), (c, d, _) = cell[:2]
    return float(np.sqrt(abs(a * d - b * c)))


def name_pairs(pairs: ArrayLike) -> str:
    """Says how many pairs overlap, rows of two numbers, and names the first of them."""
    pairs = np.asarray(pairs)
    names = ", ".join(f"{i} and {'its image' if i == j else j}" for i, j in pairs[:3])
    return f"pairs that overlap: {len(pairs)} (the particles {names}{' and others' * (len(pairs) > 3)})"


def _overlaps(system: System, first: tuple[int, int]) -> str:
    """Names the pairs of a system that overlap, of which the first is known, and the cure."""
    found = system.overlaps().pairs
    return f"{name_pairs(found if len(found) else [first])}: separate them (pypw85.relax), or enlarge the cell"
