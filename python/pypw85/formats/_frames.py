# SPDX-License-Identifier: BSD-3-Clause
"""Parts common to all formats: locations of frames, the content of a frame as it was read, and systems made from it."""

from __future__ import annotations

import dataclasses
import functools
import shlex
from typing import Any, NamedTuple
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from .._functions import ellipsoid_quaternion
from .._rotations import quaternions_along
from .._system import System, is_planar, quaternions_about_z
from .._typing import Floats
from .._words import counted, printable
from ._dimensions import is_flat
from ._errors import FileError, for_option
from ._files import Path
from ._names import LONGEST, numbers_if_all_are
from ._options import ALL_TYPES, Options

# Numbers written with two digits make unit quaternions of lengths 0.99 to 1.01; other lengths are those of other columns.
_QUATERNION_TOLERANCE = 0.01
# Diameters are twice as large, forms hold squares, and of a system contacts are asked with scaled forms: none of these overflow.
_SMALLEST, _LARGEST = 1e-150, 1e150
# Types that are not ellipsoids
_OTHER_BODIES = set("box cuboid cube cylinder capsule spherocylinder cone mesh polyhedron superquadric superellipsoid tetrahedron "
                    "octahedron icosahedron dodecahedron prism pyramid torus clump multisphere wall plane "
                    "facet triangle".split())  # fmt: skip
# Lengths of spheroids across their axes agree so far if they are written with six digits.
_SAME = 1e-6
# Whole numbers up to here are exact as float64, which tables of text are read as.
_LARGEST_ID = 2**53


class Location(NamedTuple):
    """Of a frame in its file: `offset` in bytes, `line` counted from 1; both 0 where the format finds frames itself."""

    frame: int
    offset: int = 0
    line: int = 0


@dataclasses.dataclass
class Frame:
    """A frame as a file has it. `lines` are those of the particles.

    `sizes` are radii of spheres, for particles whose lengths are 0. `angles` in radians are those of ellipses, which have no quaternions;
    `directions` are those of the axes of revolution of spheroids, which must be the longest ones if `are_longest`.
    Positions and shapes of ellipses may have two columns. `tolerance` is how far the length of a quaternion may be from 1.
    `dimensions` is None where the file does not say. `has_columns` says that options can name columns. `source` says what was taken of the
    file, `notes` what the user should know.
    """

    path: Path
    location: Location
    positions: Floats
    shapes: Floats | None = None
    quaternions: Floats | None = None
    lengths: str = "radii"
    order: str = "wxyz"
    types: NDArray[Any] | None = None
    ids: NDArray[Any] | None = None
    cell: Floats | None = None
    origin: Any = (0.0, 0.0, 0.0)
    periodic: Sequence[bool] = (True, True, True)
    step: int = 0
    lines: Sequence[int] | None = None
    sizes: Floats | None = None
    angles: Floats | None = None
    directions: Floats | None = None
    are_longest: bool = False
    tolerance: float = _QUATERNION_TOLERANCE
    dimensions: int | None = None
    has_columns: bool = False
    source: str = ""
    notes: list[str] = dataclasses.field(default_factory=list)

    def __post_init__(self) -> None:
        self._says_dimensions = self.dimensions is not None

    @classmethod
    def of(cls, path: Path, frame: int, system: System) -> Frame:
        """Makes the frame of a system that is to be written."""
        return cls(
            path, Location(frame), system.centers, system.semi_axes, system.quaternions,
            types=system.types, ids=system.ids, cell=system.cell, origin=system.origin, periodic=system.periodic,
            step=system.step, dimensions=system.dimensions,
        )  # fmt: skip

    def error(self, reason: str, particle: int | None = None) -> FileError:
        line = None
        if particle is not None:
            name = particle + 1 if self.ids is None else self.ids[particle]
            reason = f"particle {name} {reason}"
            line = None if self.lines is None else int(self.lines[particle])
        return FileError(self.path, reason, self.location.frame, line)

    def system(self, options: Options) -> System:
        """The system of this frame, once nothing is found wrong with it. Then the frame has no particles any more: their table, of
        which the arrays are views, would be as large as the system."""
        if not len(self.positions):
            return self._empty()
        if options.points:
            self._leave_out(options.points)
        self._complete_ellipses(options)
        self._take(options)
        if self.directions is not None:
            self._turn_along(self.directions)
        has_shape = self.check()
        self._number_repeated()
        scale = self._scale(options)
        assert self.shapes is not None and self.quaternions is not None
        quaternions = self.quaternions if self.order == "wxyz" else self.quaternions[:, [3, 0, 1, 2]]
        arrays = self.positions[has_shape], scale * self.shapes[has_shape], quaternions[has_shape]
        types = None if self.types is None else numbers_if_all_are(self.types[has_shape])
        ids = None if self.ids is None else self.ids[has_shape]
        del quaternions
        self.positions = arrays[0][:0]
        self.shapes = self.quaternions = self.types = self.ids = None
        system = self._made(options, arrays, types=types, ids=ids, shapeless=int((~has_shape).sum()))
        system.source, system.notes = printable(self.source), tuple(map(printable, self.notes))
        return system

    def _number_repeated(self) -> None:
        """Gives particles other ids if two have the same one."""
        if self.ids is None:
            return
        ids, counts = np.unique(self.ids, return_counts=True)
        if len(ids) < len(self.ids):
            k = int(np.flatnonzero(counts > 1)[0])
            self.notes.append(f"{counts[k]} particles have the id {ids[k]}: the particles are numbered from 1 in their order instead")
            self.ids = None

    def refuse_other_bodies(self, options: Options) -> None:
        """Refuses types that are named after bodies that are not ellipsoids."""
        names = [] if self.types is None else np.unique(np.asarray(self.types).astype(np.str_)).tolist()
        others = [name for name in names if name.lower() in _OTHER_BODIES and name not in (options.points or ())]
        if others:
            raise self.error(f"particles of the type {others[0]} are not ellipsoids: leave them out (--points {for_option(others)}), or "
                             "rename the type if it is only a name")  # fmt: skip

    def _leave_out(self, types: Sequence[str]) -> None:
        """Takes particles away that the user says are points."""
        if self.types is None:
            raise self.error("the particles have no types: leave out --points")
        names = np.asarray(self.types).astype(np.str_)
        known = np.unique(names).tolist()
        for name in types:
            if name not in known:
                raise self.error(f"there is no type {name}, but {' '.join(known)[:200]}: use one of these with --points")
        kept = ~np.isin(names, list(types))
        if not kept.any():
            raise self.error(f"all particles have the type {' '.join(types)}, which --points leaves out: choose others")
        for field in ("positions", "shapes", "quaternions", "types", "ids", "lines", "sizes", "angles", "directions"):
            if (rows := getattr(self, field)) is not None:
                setattr(self, field, np.asarray(rows)[kept])
        left = f"{counted(int((~kept).sum()), 'particle')} of the type {' '.join(types)} left out as points"
        self.source = ", ".join(filter(None, [self.source, left]))

    def _complete_ellipses(self, options: Options) -> None:
        """Gives ellipses z = 0, a semi-axis along z, and quaternions. What has these is taken as two-dimensional from then on."""
        has_two = self.shapes is not None and self.shapes.shape[1] == 2
        if has_two and options.dimensions == 3:
            raise self.error("there are two lengths, which are those of ellipses: three dimensions need three")
        if has_two or self.positions.shape[1] == 2 or self.angles is not None:
            self.dimensions = 2
        if self.positions.shape[1] == 2:
            self.positions = np.column_stack([self.positions, np.zeros(len(self.positions))])
        if has_two:
            assert self.shapes is not None
            self.shapes = np.column_stack([self.shapes, self.shapes.min(axis=1)])
        if self.angles is not None:
            self._first(~np.isfinite(self.angles), "has an angle that is not finite: correct it")
            quaternions = quaternions_about_z(self.angles)
            self.quaternions = quaternions if (options.quaternion or self.order) == "wxyz" else np.roll(quaternions, -1, axis=1)

    def _empty(self) -> System:
        """A frame may be empty: frames behind it are not. A file without any particles is refused where its frames are read."""
        self._check_cell()
        dimensions = 2 if self.dimensions == 2 and (self.cell is None or not self.cell[:2, 2].any()) else 3
        system = System(
            np.empty((0, 3)), np.empty((0, 6)), self.cell, self.periodic, origin=self.origin, step=self.step, dimensions=dimensions
        )
        system.source = printable(self.source)
        return system

    def _made(self, options: Options, arrays: tuple[Floats, ...], **others: Any) -> System:
        """The system, of two dimensions where the file or the user says so, or where particles lie in a plane as in LAMMPS."""
        said = options.dimensions or self.dimensions
        if said == 2 and not options.dimensions and np.ptp(arrays[0][:, 2]) != 0:
            arrays = (arrays[0] * [1.0, 1.0, 0.0], *arrays[1:])
            self.notes.append("the file says that the system is two-dimensional, but its centres have several z, which do not count then")
        given = functools.partial(
            System.from_axes, *arrays, cell=self.cell, periodic=self.periodic, origin=self.origin, step=self.step, **others
        )
        if said == 2:
            self._check_planar(options, *arrays)
            system = given(dimensions=2)
        else:
            system = given()
            if said == 3 or not is_flat(system):
                layered = list(system.periodic) == [True, True, False]
                if not said and layered and len(system) > 2 and is_planar(system.centers, system.q):
                    self.notes.append("all centres lie in one plane of z, and the system is taken as three-dimensional "
                                      "(--dimensions 2 if its particles are ellipses)")  # fmt: skip
                return system
            system = given(dimensions=2)
        if options.dimensions == 2:
            return system
        if self._says_dimensions:
            self.source = ", ".join(filter(None, [self.source, "two-dimensional, as the file says"]))
            return system
        reason = "" if said else (", because all centres lie in one plane of z, and the cell is no higher than the particles, as with "
                                  "dimension 2 in LAMMPS")  # fmt: skip
        self.notes.append(f"the system is taken as two-dimensional{reason} (--dimensions 3 if it is not): its particles are ellipses, and "
                          "densities, orders and correlations are those of the plane")  # fmt: skip
        return system

    def _check_planar(self, options: Options, centers: Floats, semi_axes: Floats, quaternions: Floats) -> None:
        cure = "leave out --dimensions 2" if options.dimensions else (
            "the file says that these are ellipses in a plane: say --dimensions 3 if they are not")  # fmt: skip
        if not is_planar(centers, ellipsoid_quaternion(semi_axes, quaternions)):
            raise self.error(f"the centres do not lie in one plane of z, or the particles are rotated out of it: {cure}")
        if self.cell is not None and self.cell[:2, 2].any():
            raise self.error(f"the first two vectors of the cell do not lie in the plane of x and y: {cure}")

    def check(self) -> NDArray[np.bool_]:
        """A boolean for each particle: it has a shape.

        Raises
        ------
        FileError
            Something is wrong. What is written passes the same checks as what is read.
        """
        self._check_particles()
        has_shape = self._check_shapes()
        self._check_quaternions(has_shape)
        self._check_cell()
        return has_shape

    def _take(self, options: Options) -> None:
        self.lengths = options.lengths or self.lengths
        self.order = options.quaternion or self.order
        self.cell = self.cell if options.cell is None else options.cell
        self.periodic = self.periodic if options.periodic is None else options.periodic
        if options.periodic is not None and self.cell is None and any(options.periodic):
            raise self.error("there is no cell that could be periodic: add --cell, or leave out --periodic")
        self._take_spheres(options)
        self._take_shapes(options)

    def _take_shapes(self, options: Options) -> None:
        """Gives lengths to particles that have none: those of their types, or those of all."""
        if options.shape is None and not options.shapes:
            return
        names = np.zeros(len(self.positions), np.int64) if self.types is None else np.asarray(self.types)
        names = names.astype(np.str_)
        by_type = dict(options.shapes or {})
        of_all = by_type.pop(ALL_TYPES, None)
        self.shapes = np.zeros((len(self.positions), 3)) if self.shapes is None else self.shapes
        for name, lengths in by_type.items():
            if name not in names:
                raise self.error(f"there is no type {name} for --shape, but {' '.join(np.unique(names).tolist())[:200]}: use one of these")
            self._give_shape(names == name, lengths, f" of the type {name}")
        if options.shape is not None or of_all is not None:
            types = np.unique(names[(self.shapes == 0).all(axis=1)]).tolist()
            if len(types) > 1 and of_all is None:
                one = shlex.quote(f"{types[0]}:A,B,C")
                raise self.error(f"particles of the types {' '.join(types)[:200]} have no shapes: say which of them has that of --shape "
                                 f"(--shape {one}), or that all have it (--shape '{ALL_TYPES}:A,B,C')")  # fmt: skip
            self._give_shape(names == names, options.shape if of_all is None else of_all, "")

    def _give_shape(self, chosen: NDArray[np.bool_], lengths: Any, which: str) -> None:
        """Gives these lengths to the chosen particles that have none, and says so."""
        assert self.shapes is not None
        chosen = chosen & (self.shapes == 0).all(axis=1)
        self.shapes = np.where(chosen[:, None], np.asarray(lengths, dtype=np.float64), self.shapes)
        if not chosen.any():
            self.notes.append(f"--shape has no effect, because all particles{which} have shapes")
            return
        have = counted(int(chosen.sum()), f"particle{which} has", f"particles{which} have")
        self.source = ", ".join(filter(None, [self.source, f"{have} the lengths of --shape as {self.lengths}"]))

    def _scale(self, options: Options) -> float:
        """The factor from the lengths to semi-axes."""
        flat = (options.dimensions or self.dimensions) == 2
        return {"diameters": 0.5, "radii": 1.0, "rms": 2.0 if flat else 5**0.5}[self.lengths]

    def _turn_along(self, directions: Floats) -> None:
        """Turns spheroids such that their axes of revolution have these directions. Their lengths may be in any order."""
        self._first(~(np.abs(directions).max(axis=1) > 0), "has a direction that is zero")
        self.quaternions, self.order = quaternions_along(directions), "wxyz"
        if self.shapes is None:
            return
        # The length that differs from the two others comes last.
        spread = np.abs(self.shapes[:, [1, 2, 0]] - self.shapes[:, [2, 0, 1]])
        last = spread.argmin(axis=1)
        self._first(spread.min(axis=1) > _SAME * self.shapes.max(axis=1),
                    "has three different lengths, which a direction does not turn: give Euler angles (--euler) or quaternions")  # fmt: skip
        self.shapes = np.take_along_axis(self.shapes, (last[:, None] + [1, 2, 3]) % 3, axis=1)
        if self.are_longest:
            self._first(self.shapes[:, 2] < self.shapes[:, 1] * (1 - _SAME),
                        "has two long axes, and a direction of one of them, which does not turn it: give quaternions, or the direction of "
                        "the axis of revolution (--direction-columns)")  # fmt: skip

    def _take_spheres(self, options: Options) -> None:
        """Particles whose lengths are all 0 may be spheres."""
        if self.sizes is None or self.shapes is None:
            return
        without = (self.shapes == 0).all(axis=1) & ~(self.sizes == 0)
        if without.any():
            sizes = self.sizes / self._scale(options)
            self.shapes = np.where(without[:, None], sizes[:, None], self.shapes)
            if self.quaternions is not None:  # which may be 0 0 0 0
                unit = np.array([1.0, 0, 0, 0] if self.order == "wxyz" else [0.0, 0, 0, 1])
                self.quaternions = np.where(without[:, None], unit, self.quaternions)

    def _first(self, wrong: NDArray[np.bool_], reason: str) -> None:
        if wrong.any():
            raise self.error(reason, int(wrong.argmax()))

    def _check_particles(self) -> None:
        if not -(2**63) <= self.step < 2**63:
            raise self.error(f"the time step {self.step} has more than 64 bits")
        if self.ids is not None:
            ids, self.ids = self.ids, None  # an id that is wrong must not name the particle
            self._first((ids > _LARGEST_ID) | (ids < -_LARGEST_ID), "has an id beyond 2⁵³: renumber the particles")
            self.ids = ids
        self._first(~np.all(np.isfinite(self.positions), axis=1), "has a position that is not finite: remove or repair it")
        self._first(np.any(np.abs(self.positions) > _LARGEST, axis=1),
                    f"has a position beyond {_LARGEST:g}: repair it, or choose another unit of length")  # fmt: skip

    def _check_shapes(self) -> NDArray[np.bool_]:
        if self.shapes is None:
            named = "name their columns (--shape-columns), or " * self.has_columns
            raise self.error(f"there are no shapes: {named}set one shape for all particles with --shape")
        has_shape: NDArray[np.bool_] = ~np.all(self.shapes == 0, axis=1)
        if not has_shape.any():
            raise self.error("no particle has a shape: write shapes, or set them (--shape A,B,C for one type of particles, TYPE:A,B,C for "
                             "each of several)")  # fmt: skip
        self._first(~np.isfinite(self.shapes).all(axis=1),
                    "has a length that is not finite: correct it, or write 0 for all its lengths, for none")  # fmt: skip
        self._first(~np.all((self.shapes > 0) | ~has_shape[:, None], axis=1),
                    "has a length that is not positive: correct it, or write 0 for all its lengths, for none")  # fmt: skip
        self._first(np.any((self.shapes > _LARGEST) | (self.shapes < _SMALLEST), axis=1) & has_shape,
                    f"has a length beyond {_SMALLEST:g} to {_LARGEST:g}: choose another unit of length")  # fmt: skip
        return has_shape

    def _check_quaternions(self, has_shape: NDArray[np.bool_]) -> None:
        if self.quaternions is None:
            assert self.shapes is not None
            named = ", or name columns (--quaternion-columns, --direction-columns, --euler, or --angle-columns of ellipses)"
            self._first((np.ptp(self.shapes, axis=1) > 0), "is not a sphere, and lacks an orientation: write quaternions, or the angles of "
                        f"ellipses{named * self.has_columns}")  # fmt: skip
            self.quaternions = np.tile([1.0, 0, 0, 0] if self.order == "wxyz" else [0.0, 0, 0, 1], (len(self.shapes), 1))
        with np.errstate(over="ignore"):
            norms = np.linalg.norm(self.quaternions, axis=1)
        is_finite = (norms > 0) & (norms < np.inf)
        self._first(has_shape & ~is_finite, "has a quaternion that is zero or not a number: 1 0 0 0 means no rotation")
        self._first(has_shape & ~(np.abs(norms - 1) <= self.tolerance),
                    "has a quaternion whose length is not 1: normalise it, or check that these are its columns")  # fmt: skip

    def _check_cell(self) -> None:
        origin = np.asarray(self.origin, dtype=np.float64)
        if origin.shape != (3,) or not (np.abs(origin) <= _LARGEST).all():
            raise self.error(f"the corner of the cell must be three numbers up to {_LARGEST:g}: correct it")
        if len(self.periodic) != 3:
            raise self.error("the file does not say along which vectors of the cell the system is periodic: use --periodic")
        if self.cell is None:
            return
        lengths = np.abs(self.cell).max(axis=1) if self.cell.shape == (3, 3) else np.zeros(3)
        if not (np.isfinite(lengths) & (lengths > 0)).all():
            raise self.error("the cell has a vector that is zero or not finite: correct it, or give another (--cell)")
        if lengths.max() > _LARGEST or lengths.min() < _SMALLEST:
            raise self.error(f"the cell has a vector beyond {_SMALLEST:g} to {_LARGEST:g}: choose another unit of length")
        if np.linalg.matrix_rank(self.cell / lengths[:, np.newaxis]) < 3:
            raise self.error("the vectors of the cell lie in a plane: correct them, or give others (--cell)")


def check_lengths_of_names(names: Sequence[str], error: Callable[[str], FileError]) -> None:
    """Names of types of a file, before arrays are made of them."""
    for name in names:
        if len(name) > LONGEST:
            raise error(f"the type '{name[:40]}…' has more than {LONGEST} characters: shorten its name")
