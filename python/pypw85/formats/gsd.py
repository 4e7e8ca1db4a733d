# SPDX-License-Identifier: BSD-3-Clause
"""GSD files of HOOMD-blue, by the library gsd: shapes belong to types.

Numbers have single precision, or, since HOOMD-blue 7 and its schema 2.0, double precision. gsd.hoomd refuses schemas that are newer
than it is. gsd.fl, which is used here, reads all of them.
"""

from __future__ import annotations

import collections
import contextlib
import itertools
import json
import os
import time
from pathlib import Path
from typing import Any, NamedTuple
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from .._conversions import _gsd_semi_axes
from .._core import version
from .._system import System
from .._typing import Floats
from .._words import counted
from ._boxes import box, lost_periodicity
from ._errors import FileError, for_option, guarded
from ._files import check_input, locked, replacing
from ._frames import Frame, Location, check_lengths_of_names
from ._options import Options
from ._names import Rule, checked_names, type_names

SUFFIXES = (".gsd",)
# Centres that far from the border, as a share of the cell, may be outside of it by rounding only.
_ROUNDED = 2.0**-40
# How often a file that seems to be broken is opened again, and after how many seconds
_TRIALS, _PAUSE = 4, 0.005
# For how many seconds a reader waits for the end of a frame that is written, and a writer for readers that open the file
_WAIT = 2.0
_ASCII: Rule = (str.isascii, "is not ASCII, which the library gsd asks for")


def recognise(start: bytes) -> bool:
    return start[:8] == bytes.fromhex("DF65DF65DF65DF65")


def _open(path: os.PathLike[str] | str, mode: str = "r", **schema: Any) -> Any:
    """Opens a file. Before gsd 2.8, modes end with b.

    The file is not valid while a frame is added to it: its index points beyond what is there. A reader waits for the end of a frame that
    this package writes, and tries again where another program may do so.
    """
    import gsd.fl
    import gsd.hoomd

    for trial in itertools.count():
        try:
            with locked(path, False, _WAIT) if mode == "r" else contextlib.nullcontext():
                return gsd.fl.open(os.fspath(path), mode if hasattr(gsd.hoomd, "Frame") else mode + "b", **schema)
        except (MemoryError, OSError, RuntimeError, ValueError) as error:
            if trial == _TRIALS or mode != "r" or not isinstance(error, RuntimeError):
                raise FileError(path, f"no readable GSD file ({error}): it is broken or truncated; write it again") from None
            time.sleep(_PAUSE)


def _open_hoomd(path: os.PathLike[str]) -> Any:
    file = _open(path)
    if file.schema != "hoomd":
        file.close()
        raise FileError(path, f"the schema of this GSD file is '{file.schema}', not that of HOOMD-blue: it has no particles to check")
    return file


@guarded
def _count(path: os.PathLike[str]) -> int:
    check_input(path)
    with _open_hoomd(path) as file:
        return int(file.nframes)


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield from map(Location, range(_count(path)))


class _Chunks:
    """Chunks of a frame, read one by one: gsd's own function reads velocities and bonds, too, of which there may be any number.

    What a frame lacks is that of the first one, or a default.
    """

    def __init__(self, path: os.PathLike[str], file: Any, frame: int) -> None:
        self._path, self._file, self._frame = path, file, frame
        self.count = int(self.get("particles/N", [0])[0])
        # Without positions, all are at 0.
        if 12 * self.count > max(os.path.getsize(path), 1 << 20):
            raise FileError(path, f"says that it has {counted(self.count, 'particle')}, but is too small for them: it is broken", frame)

    def _read(self, name: str, frame: int) -> Any | None:
        if not self._file.chunk_exists(frame=frame, name=name):
            return None
        try:
            return self._file.read_chunk(frame=frame, name=name)
        except MemoryError:
            raise FileError(self._path, f"{name} needs more memory than there is: the file is broken", self._frame) from None

    def get(self, name: str, default: Any) -> Any:
        for frame in (self._frame, 0):
            if (chunk := self._read(name, frame)) is not None:
                return chunk
        return default

    def rows(self, name: str, default: Any, kinds: str) -> Any:
        """An array with a row for each particle. The array of the first frame is the default if it has as many rows."""
        row = np.asarray(default)
        shape = (self.count, *row.shape)
        rows = self._read(name, self._frame)
        if rows is None and (first := self._read("particles/N", 0)) is not None and first[0] == self.count:
            rows = self._read(name, 0)
        if rows is None:
            return np.broadcast_to(row, shape)
        if rows.shape != shape or rows.dtype.kind not in kinds:
            raise FileError(self._path, f"{name} must have the shape {shape}, not {rows.shape}, of numbers", self._frame)
        return rows

    def strings(self, name: str, default: list[str]) -> list[str]:
        rows = self.get(name, None)
        if rows is None:
            return default
        if rows.ndim != 2 or rows.dtype.itemsize != 1:
            raise FileError(self._path, f"{name} must be text", self._frame)
        return [bytes(row).split(b"\0")[0].decode("utf-8") for row in rows.view(np.uint8)]


@guarded
def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    check_input(path)
    with _open_hoomd(path) as file:
        chunks = _Chunks(path, file, location.frame)
        typeid = chunks.rows("particles/typeid", 0, "ui").astype(np.int64)
        names = chunks.strings("particles/types", ["A"])
        shapes, of_state = chunks.strings("particles/type_shapes", []), _shapes_of_state(chunks)
        diameters = ", particles/diameter is not used" if chunks.get("particles/diameter", None) is not None else ""
        _refuse_other_states(path, file)
        body = chunks.rows("particles/body", -1, "iu").astype(np.int32)
        dimensions = int(chunks.get("configuration/dimensions", [3])[0])
        cell, origin, periodic = _cell(chunks.get("configuration/box", [1, 1, 1, 0, 0, 0]), dimensions)
        frame = Frame(
            path, location, chunks.rows("particles/position", [0.0] * 3, "f").astype(np.float64),
            quaternions=chunks.rows("particles/orientation", [1.0, 0, 0, 0], "f").astype(np.float64),
            ids=np.arange(chunks.count), cell=cell, origin=origin, periodic=periodic,
            step=int(chunks.get("configuration/step", [0])[0]), dimensions=2 if dimensions == 2 else 3,
            source=f"lengths of {'type_shapes' if any(map(_says, shapes)) or not of_state else 'state/hpmc'} as radii, quaternions "
                   f"orientation as w x y z{diameters}",
        )  # fmt: skip
    if np.unique(body[body >= 0], return_counts=True)[1].max(initial=0) > 1:
        frame.notes.append("some particles are parts of one rigid body (particles/body), and overlaps within a body are counted, too")
    check_lengths_of_names(names, frame.error)
    wrong = ~((typeid >= 0) & (typeid < len(names)))
    if wrong.any():
        raise frame.error(f"has the type {typeid[wrong][0]}, but there are {len(names)}: the file is broken", int(wrong.argmax()))
    frame.types = np.array(names)[typeid]
    points = options.points or ()
    frame.shapes = _shapes(frame, shapes if any(map(_says, shapes)) else of_state, typeid, points)
    if of_state and (frame.shapes != _shapes(frame, of_state, typeid, points)).any():
        raise frame.error("the shapes of particles/type_shapes are not those of state/hpmc: write the file again")
    return frame.system(options)


def _cell(lengths_and_tilts: Any, dimensions: int) -> tuple[Floats, Floats, Sequence[bool]]:
    """Cell, its corner (HOOMD's origin is in the middle), and what is periodic: not z in two dimensions, where Lz may be 0."""
    lx, ly, lz, xy, xz, yz = np.asarray(lengths_and_tilts, dtype=np.float64)
    periodic = [True, True, bool(lz) and dimensions != 2]
    lz = lz or 1.0
    cell = np.array([[lx, 0, 0], [xy * ly, ly, 0], [xz * lz, yz * lz, lz]])
    return cell, -cell.sum(axis=0) / 2, periodic


def _says(shape: str) -> bool:
    """Returns whether a type has a shape."""
    return shape.strip() not in ("", "{}")


def _refuse_other_states(path: os.PathLike[str], file: Any) -> None:
    """Refuses the state of an integrator of HOOMD-blue 2 (gsd, HOOMD schema, State data) for shapes other than spheres and ellipsoids."""
    kinds = {name.split("/")[2] for name in file.find_matching_chunk_names("state/hpmc/") if name.count("/") > 2}
    if others := sorted(kinds - {"ellipsoid", "integrate", "sphere"}):
        raise FileError(path, f"the particles are of the kind {others[0]} (state/hpmc), and only ellipsoids and spheres can be checked")


def _shapes_of_state(chunks: _Chunks) -> list[str]:
    """Shapes of types as HOOMD-blue 2 wrote the state of its integrators, in the form of type_shapes."""
    radii = chunks.get("state/hpmc/sphere/radius", None)
    axes = [chunks.get(f"state/hpmc/ellipsoid/{name}", None) for name in "abc"]
    shapes = [] if radii is None else [{"type": "Sphere", "diameter": 2.0 * float(radius)} for radius in np.ravel(radii)]
    if all(one is not None for one in axes):
        rows = zip(*(np.ravel(one).tolist() for one in axes))
        shapes = [dict(zip(("type", *"abc"), ("Ellipsoid", *row))) for row in rows]
    return [json.dumps(shape) for shape in shapes]


def _shapes(frame: Frame, type_shapes: Sequence[str], typeid: Any, points: Sequence[str]) -> Floats:
    """Semi-axes; 0 for the types that have no shape. Those without particles, and those that are left out as points, may have any."""
    types = np.asarray(frame.types)
    read = np.unique(typeid[~np.isin(types, points)])
    shapes = np.zeros((max(len(type_shapes), int(typeid.max(initial=0)) + 1), 3))
    for k, text in enumerate(type_shapes):
        try:
            shape = json.loads(text)
            if frame.dimensions == 2 and shape.get("type") == "Ellipsoid" and "c" not in shape:
                shape["c"] = min(shape["a"], shape["b"])
            shapes[k] = np.asarray(_gsd_semi_axes(shape), dtype=np.float64) if shape else 0.0
        except (AttributeError, KeyError, OverflowError, RecursionError, TypeError, ValueError):
            if k not in read:
                continue
            cure = f": leave out its particles (--points {for_option([types[typeid == k][0]])})" if (typeid != k).any() else ""
            raise frame.error(f"the type {k} is not an ellipsoid: {text[:80]}: only ellipsoids and spheres can be checked{cure}") from None
    selected: Floats = shapes[typeid]
    return selected


def losses(system: System, precision: str = "single") -> Iterator[tuple[str, str]]:
    yield from lost_periodicity(system)
    moved, turned, stretched = (
        np.abs(_PRECISIONS[precision].rounded(values) - values).max()
        for values in (_positions(system), system.quaternions, _box(system))
    )
    if moved or turned or stretched:
        yield ("precision", f"GSD has single precision: positions change by up to {moved:.1e}, components of quaternions by {turned:.1e}, "
               f"of the box by {stretched:.1e} (HOOMD-blue since 7 also reads --precision double)")  # fmt: skip
    if (np.diff(system.ids) != 1).any():
        yield "ids", "GSD has no ids: particles are numbered in their order, from 0"
    if len(_distinct_types(system)[0]) > len(np.unique(type_names(system))):
        yield "types", "GSD has one shape for each type: types with several are divided, and their names get a number"


def save(path: os.PathLike[str], systems: Iterator[System], precision: str = "single") -> None:
    with _create(path, precision) as file:
        for system in systems:
            _append(file, system, precision)


def _create(path: os.PathLike[str] | str, precision: str, mode: str = "w") -> Any:
    return _open(path, mode, application=f"pw85 {version()}", schema="hoomd", schema_version=_PRECISIONS[precision].schema)


def _append(file: Any, system: System, precision: str) -> None:
    if system.step < 0:
        raise ValueError(f"GSD has no negative time steps, as {system.step}")
    for name, values in _chunks_of(system, _PRECISIONS[precision]).items():
        file.write_chunk(name, values)
    file.end_frame()


class Growing:
    """A file to which frames are added. Each of them is in the file as soon as it is added: other programs may read it, and nothing
    is lost if this one is killed.

    `frames` says how many of those that are there already are kept, 0 for a new file. A GSD file cannot be made shorter, so the others are
    left out of a copy.
    """

    def __init__(self, path: str, frames: int, precision: str = "double") -> None:
        self.name, self._precision = path, precision
        if not frames:
            with replacing(path) as temporary:  # a reader finds no file that is half made
                _create(temporary, precision).close()
        else:
            _keep(path, frames, precision)
        self._file = _create(path, precision, "a")

    def add(self, system: System) -> None:
        with locked(self.name, True, _WAIT):
            _append(self._file, system, self._precision)
            if hasattr(self._file, "flush"):  # since gsd 3, which keeps frames in memory
                self._file.flush()

    def sync(self) -> int:
        """Waits until all frames are on the disk, and says how many there are."""
        descriptor = os.open(self.name, os.O_RDWR)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        return int(self._file.nframes)

    def close(self) -> None:
        self._file.close()


def _keep(path: str, frames: int, precision: str) -> None:
    """Shortens a file to a number of frames."""
    with _open_hoomd(Path(path)) as file:
        found = int(file.nframes)
        if found < frames:
            raise FileError(path, f"has {counted(found, 'frame')}, and had {frames} at the checkpoint: bring back the trajectory of this "
                            "run")  # fmt: skip
        if found == frames:
            return
        with replacing(path) as temporary, _create(temporary, precision) as copy:
            for frame in range(frames):
                for name in file.find_matching_chunk_names(""):
                    if file.chunk_exists(frame=frame, name=name):
                        copy.write_chunk(name, file.read_chunk(frame=frame, name=name))
                copy.end_frame()


class _Precision(NamedTuple):
    schema: tuple[int, int]
    rounded: Callable[[Floats], NDArray[Any]]


def _chunks_of(system: System, kind: _Precision) -> dict[str, NDArray[Any]]:
    first, typeid = _distinct_types(system)
    shapes = [dict(zip(("type", *"abc"), ("Ellipsoid", *map(float, system.semi_axes[k])))) for k in first]
    return {
        "configuration/step": np.array([system.step], np.uint64),
        "configuration/dimensions": np.array([system.dimensions], np.uint8),
        "configuration/box": kind.rounded(_box(system)),
        "particles/N": np.array([len(system)], np.uint32),
        "particles/types": _text(_names([str(name) for name in checked_names(system, _ASCII)[first]])),
        "particles/typeid": typeid.astype(np.uint32),
        "particles/type_shapes": _text([json.dumps(shape) for shape in shapes]),
        "particles/position": kind.rounded(_positions(system)),
        "particles/orientation": kind.rounded(system.quaternions),
    }


def _text(rows: list[str]) -> NDArray[np.int8]:
    """Rows of bytes, each of which ends with a null."""
    words = np.array([row.encode() for row in rows] or [b""])
    return words.astype(f"S{words.dtype.itemsize + 1}").view(np.int8).reshape(len(words), -1)


def _box(system: System) -> Floats:
    cell, _ = box(system)
    lengths = np.diag(cell)
    tilts = cell[[1, 2, 2], [0, 0, 1]] / lengths[[1, 2, 2]]
    return np.array([*lengths[:2], 0, tilts[0], 0, 0]) if system.dimensions == 2 else np.concatenate([lengths, tilts])


def _positions(system: System) -> Floats:
    """HOOMD's origin is in the middle of the box."""
    cell, low = box(system)
    # The middle is 0 in what was read from such a file, and positions keep their bits.
    positions: Floats = _inside(system) - (low + cell.sum(axis=0) / 2)
    return positions


def _inside(system: System) -> Floats:
    """Wrapped centres; but centres at the border, or outside of it by rounding, stay as they are."""
    if system.cell is None:
        return system.centers
    fractions = (system.centers - system.origin) @ np.linalg.inv(system.cell)
    is_inside = ((fractions >= -_ROUNDED) & (fractions <= 1 + _ROUNDED)).all(axis=1, keepdims=True)
    return np.where(is_inside, system.centers, system.wrapped())


def _single(values: Floats) -> NDArray[np.float32]:
    """In single precision, whose relative error is 2⁻²⁴ unless numbers are too large or too small for it."""
    with np.errstate(over="ignore", under="ignore"):
        rounded = values.astype(np.float32)
    if not (np.abs(rounded - values) <= 2.0**-23 * np.abs(values).max()).all():
        raise ValueError("lengths are beyond single precision, which GSD has: choose another unit of length")
    return rounded


_PRECISIONS = {"single": _Precision((1, 4), _single), "double": _Precision((2, 0), lambda values: values.astype(np.float64))}


def _distinct_types(system: System) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The first particle of each pair of type and shape, and for each particle which one it has."""
    codes = np.unique(type_names(system), return_inverse=True)[1]
    rows = np.column_stack([codes, system.semi_axes])
    _, first, which = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return first, which.ravel()


def _names(types: list[str]) -> list[str]:
    """Names of types, which must differ: a type with several shapes gets numbers."""
    counts = collections.Counter(types)
    numbers: Any = {name: itertools.count() for name in counts}
    return [
        name if counts[name] == 1 else next(new for k in numbers[name] if (new := f"{name}_{k}") not in counts)
        for name in types
    ]
