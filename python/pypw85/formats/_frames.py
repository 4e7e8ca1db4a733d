"""What every format has in common: where a frame is, what one holds as it was read, and how a system is made of that."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, NamedTuple
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .._system import System
from .._typing import Floats
from ._errors import FileError

# Numbers written with two digits make unit quaternions of lengths 0.99 to 1.01; other lengths are those of other columns.
_QUATERNION_TOLERANCE = 0.01


class Location(NamedTuple):
    """Of a frame in its file: `offset` in bytes, `line` counted from 1; both 0 where the format finds frames itself."""

    frame: int
    offset: int = 0
    line: int = 0


@dataclasses.dataclass(frozen=True)
class Options:
    """What the user knows better than the file.

    `lengths` is "radii" or "diameters", `quaternion` "wxyz" or "xyzw", `cell` rows of vectors, `periodic` three flags,
    `shape` the lengths of particles without any, `shape_columns` and `quaternion_columns` names of columns.
    """

    lengths: str | None = None
    quaternion: str | None = None
    cell: Any | None = None
    periodic: Sequence[bool] | None = None
    shape: Sequence[float] | None = None
    shape_columns: Sequence[str] | None = None
    quaternion_columns: Sequence[str] | None = None


@dataclasses.dataclass
class Frame:
    """A frame as a file has it. `lines` are those of the particles."""

    path: os.PathLike[str]
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

    def error(self, reason: str, particle: int | None = None) -> FileError:
        line = None
        if particle is not None:
            name = particle + 1 if self.ids is None else self.ids[particle]
            reason = f"particle {name} {reason}"
            line = None if self.lines is None else int(self.lines[particle])
        return FileError(self.path, reason, self.location.frame, line)

    def system(self, options: Options) -> System:
        """The system of this frame, once nothing is found wrong with it."""
        self._take(options)
        self._check_positions()
        has_shape = self._check_shapes()
        self._check_quaternions(has_shape)
        self._check_cell()
        scale = 0.5 if self.lengths == "diameters" else 1.0
        assert self.shapes is not None and self.quaternions is not None
        quaternions = self.quaternions if self.order == "wxyz" else self.quaternions[:, [3, 0, 1, 2]]
        return System.from_axes(
            self.positions[has_shape],
            scale * self.shapes[has_shape],
            quaternions[has_shape],
            cell=self.cell,
            periodic=self.periodic,
            types=None if self.types is None else self.types[has_shape],
            ids=None if self.ids is None else self.ids[has_shape],
            origin=self.origin,
            step=self.step,
            shapeless=int((~has_shape).sum()),
        )

    def _take(self, options: Options) -> None:
        self.lengths = options.lengths or self.lengths
        self.order = options.quaternion or self.order
        self.cell = self.cell if options.cell is None else np.asarray(options.cell, dtype=np.float64)
        self.periodic = self.periodic if options.periodic is None else options.periodic
        if options.shape is not None:
            shape = np.asarray(options.shape, dtype=np.float64)
            known = np.zeros((len(self.positions), 3)) if self.shapes is None else self.shapes
            self.shapes = np.where((known == 0).all(axis=1, keepdims=True), shape, known)

    def _first(self, wrong: NDArray[np.bool_], reason: str) -> None:
        if wrong.any():
            raise self.error(reason, int(wrong.argmax()))

    def _check_positions(self) -> None:
        if not len(self.positions):
            raise self.error("there are no particles")
        self._first(~np.all(np.isfinite(self.positions), axis=1), "has a position that is not finite: remove or repair it")

    def _check_shapes(self) -> NDArray[np.bool_]:
        if self.shapes is None:
            raise self.error("there are no shapes: name their columns, or give one shape for all particles (--shape)")
        has_shape: NDArray[np.bool_] = ~np.all(self.shapes == 0, axis=1)
        if not has_shape.any():
            raise self.error("no particle has a shape: write shapes, or give one for all particles (--shape)")
        self._first(~np.all(np.isfinite(self.shapes) & ((self.shapes > 0) | ~has_shape[:, None]), axis=1),
                    "has a length that is not positive: correct its shape, or write 0 0 0 for none")  # fmt: skip
        return has_shape

    def _check_quaternions(self, has_shape: NDArray[np.bool_]) -> None:
        if self.quaternions is None:
            assert self.shapes is not None
            self._first((np.ptp(self.shapes, axis=1) > 0), "is no sphere, but has no orientation: write quaternions")
            self.quaternions = np.tile([1.0, 0, 0, 0] if self.order == "wxyz" else [0.0, 0, 0, 1], (len(self.shapes), 1))
        norms = np.linalg.norm(self.quaternions, axis=1)
        self._first(has_shape & ~(norms > 0), "has a quaternion that is zero or not a number: 1 0 0 0 means no rotation")
        self._first(has_shape & ~(np.abs(norms - 1) <= _QUATERNION_TOLERANCE),
                    "has a quaternion whose length is not 1: normalise it, or see whether these are its columns")  # fmt: skip

    def _check_cell(self) -> None:
        if self.cell is None:
            return
        lengths = np.linalg.norm(self.cell, axis=1)
        if self.cell.shape != (3, 3) or not np.isfinite(self.cell).all() or not lengths.all():
            raise self.error("the cell has a vector that is zero or not finite: correct it, or give another (--cell)")
        if np.linalg.matrix_rank(self.cell / lengths[:, np.newaxis]) < 3:
            raise self.error("the vectors of the cell lie in a plane: correct them, or give others (--cell)")
