# SPDX-License-Identifier: BSD-3-Clause
"""HDF5 in the layout of H5MD (nongnu.org/h5md), by h5py.

In the first group of /particles: position, and either semi_axes and orientation (w, x, y, z) or form; species, id; its attribute
``dimensions`` is 2 if these are ellipses, which may have an angle, whose attribute ``unit`` is rad or deg, and two columns. Each of these
may have a group for time (value, step) or be one data set for all frames; box with its attribute boundary, edges and offset.
Data in other files is not read: a file must not lead to what its user did not name.
"""

from __future__ import annotations

import contextlib
import math
import os
import zlib
from typing import Any, NamedTuple
from collections.abc import Iterator

import numpy as np

from .._core import version
from .._forms import principal_axes
from .._system import System, quaternions_of
from .._typing import Floats
from .._words import counted
from ._column_names import could_change
from ._comments import Meaning, check
from ._errors import FileError, for_option, guarded
from ._files import check_input, checksum
from ._frames import Frame, Location, check_lengths_of_names
from ._options import Options
from ._names import checked_names, numbers_if_all_are
from ._series import columns_of_clumps

SUFFIXES = (".h5", ".hdf5", ".h5md")
# The elements of a group that are read, and the box
_USED = ("position", "semi_axes", "orientation", "form", "species", "id", "angle", "box", "image")
# Largest number of soft links that lead to one another. More of them are a loop.
_LINKS = 16
# The largest ratio of deflate, 1032, and its headers: a data set that claims more than that of its bytes was never written.
_COMPRESSION = 1100
# Before the checksum of a file of a run
_SEAL = b"pw85 crc"
# Bytes of a chunk. A chunk has one frame, to make a file not larger than its content, and is small enough for the cache of HDF5.
_CHUNK = 1 << 18
# Several frames of less than this share one.
_SMALL_CHUNK = 1 << 11


class _Source(NamedTuple):
    """A group of a file of which a frame is read. `step` is that of its positions, None if the file has no steps."""

    path: os.PathLike[str]
    group: Any
    frame: int
    step: int | None = None

    def error(self, name: str, reason: str) -> FileError:
        return FileError(self.path, f"the data set {name} {reason}", self.frame)


def recognise(start: bytes) -> bool:
    return start[:8] == b"\x89HDF\r\n\x1a\n"


def sealed(content: bytes) -> bytes:
    """The bytes of a file with their checksum behind them, where readers of HDF5 do not look.

    In a damaged file HDF5 1.10 may follow addresses out of its memory, and the process ends. So the bytes are checked first.
    """
    return content + _SEAL + zlib.crc32(content).to_bytes(4, "little")


def _check_seal(path: str | os.PathLike[str]) -> None:
    """Refuses a file that has a checksum of other bytes."""
    size = os.path.getsize(path) - len(_SEAL) - 4
    with open(path, "rb") as file:
        file.seek(max(size, 0))
        seal = file.read()
    if size > 0 and seal.startswith(_SEAL) and checksum(path, size) != int.from_bytes(seal[len(_SEAL) :], "little"):
        raise FileError(path, "is damaged, or was changed after pw85 mc had written it: write it again")


def opened(path: str | os.PathLike[str]) -> Any:
    """A file to be read. Use it in functions that are guarded()."""
    import h5py

    check_input(path)
    _check_seal(path)
    try:
        return h5py.File(path, "r")
    except PermissionError:
        raise
    except (OSError, RuntimeError) as error:
        raise FileError(path, f"no readable HDF5 file ({error}): it is broken or truncated; write it again") from None


def _find(path: os.PathLike[str], group: Any, name: str) -> Any | None:
    """An object by its name within a group, None if there is none. Links to other files are refused."""
    import h5py

    todo, links = name.split("/"), 0
    while todo and group is not None:
        part = todo.pop(0)
        if not part:
            continue
        link = group.get(part, getlink=True) if isinstance(group, h5py.Group) else None
        if isinstance(link, h5py.SoftLink):
            links += 1
            todo = link.path.split("/") + todo
            group = group.file if link.path.startswith("/") else group
        elif isinstance(link, h5py.ExternalLink):
            raise FileError(path, f"{group.name}/{part} is a link to another file, which is not followed: copy the data")
        else:
            group = None if link is None else group[part]
        if links > _LINKS:
            raise FileError(path, f"the links of {name} lead in a circle: repair them")
    return group


def _group(path: os.PathLike[str], file: Any) -> Any:
    import h5py

    particles = _find(path, file, "particles")
    name = next(iter(particles), None) if isinstance(particles, h5py.Group) else None
    group = None if name is None else _find(path, particles, name)
    if group is None or _find(path, group, "position") is None:
        raise FileError(path, "there is no /particles/.../position, as in H5MD: name the data sets so")
    return group


def _values(source: _Source, name: str) -> tuple[Any | None, bool]:
    """The data set of an element of H5MD, and whether its first dimension is time; None if there is no such element."""
    import h5py

    element = _find(source.path, source.group, name)
    has_time = isinstance(element, h5py.Group)
    values = _find(source.path, element, "value") if has_time else element
    if element is None:
        return None, False
    if not isinstance(values, h5py.Dataset):
        raise source.error(name, "is neither a data set nor a group with a data set 'value': write it again")
    if values.is_virtual or values.external:
        raise source.error(name, "is in another file, which is not read: copy the data")
    return values, has_time


@guarded
def _count(path: os.PathLike[str]) -> int:
    with opened(path) as file:
        values, has_time = _values(_Source(path, _group(path, file), 0), "position")
        return len(values) if values is not None and has_time else 1


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield from map(Location, range(_count(path)))


@guarded
def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with opened(path) as file:
        source = _Source(path, _group(path, file), location.frame)
        source = source._replace(step=_step(source, "position", location.frame))
        columns = _width(source, "position")
        positions = _floats(source, "position", -1, columns)
        assert positions is not None
        n = len(positions)
        frame = Frame(
            path, location, positions, shapes=_floats(source, "semi_axes", n, _width(source, "semi_axes")), types=_species(source, n),
            quaternions=_floats(source, "orientation", n, 4), ids=_read(source, "id", (n,), "iu", "whole numbers"),
            step=source.step or 0,
            source=f"lengths semi_axes as radii, quaternions orientation as {' '.join(options.quaternion or 'wxyz')}",
            dimensions=_said_dimensions(source),
        )  # fmt: skip
        if frame.shapes is None and (forms := _floats(source, "form", n, 6)) is not None:
            unused = ["orientation", "angle"]
            _take_forms(frame, forms)
        else:
            unused = ["form"] if frame.quaternions is None else ["form", "angle"]
            _take_angles(frame, source, n)
        _take_box(frame, source)
        _check_units(source)
        _check_attributes(source, options, frame)
        _check_names(source, frame, options, unused)
        _check_clumps(source, n, options)
    return frame.system(options)


def _check_names(source: _Source, frame: Frame, options: Options, unused: list[str]) -> None:
    """Refuses elements that could change bodies and are not used, and says which others are not. Of several groups of particles, one is
    read. Of those that are known, `unused` are not used here."""
    ignored = options.ignore_columns or ()
    for name in ignored:
        if name not in source.group:
            raise source.error(name, f"of --ignore-columns is not there, but {' '.join(source.group)[:200]}: name one of these")
    said = " ".join(name for name in source.group if (name not in _USED or name in unused) and name not in ignored)
    frame.source += said and f", data sets that are not used: {said}"
    for name in source.group:
        if name not in (*_USED, *ignored) and could_change(name):
            raise source.error(name, "could change the shapes or how they are turned, and is not used: write it as semi_axes (three "
                               "lengths of each particle), orientation or form if it is one of these, or leave it out "
                               f"(--ignore-columns {name})")  # fmt: skip
    groups = list(source.group.parent)
    if len(groups) > 1:
        frame.notes.append(f"only the first of the groups {' '.join(groups)[:200]} of /particles is read: copy another one to a file of "
                           "its own")  # fmt: skip


def _check_clumps(source: _Source, count: int, options: Options) -> None:
    """Refuses bodies of several spheres. LIGGGHTS writes 0 for single spheres."""
    for name in columns_of_clumps(list(source.group), options):
        rows = None
        with contextlib.suppress(FileError):  # of what is not a number for each particle
            rows = _read(source, name, (count,), "iu", "whole numbers")
        if rows is not None and len(np.unique(rows[rows > 0])) < (rows > 0).sum():
            raise source.error(name, "has a number twice, as for one body of several spheres: write the centres of bodies, or say that all "
                               f"are bodies of one system (--ignore-columns {for_option([name])})")  # fmt: skip


def _take_forms(frame: Frame, forms: Floats) -> None:
    with np.errstate(invalid="ignore"):
        frame.shapes, rotation = principal_axes(forms)
    bad = np.isnan(frame.shapes).any(axis=1)
    if bad.any():
        raise frame.error("has a form that is not positive definite: correct it", int(bad.argmax()))
    frame.quaternions = quaternions_of(rotation)
    frame.source = "forms"


def _width(source: _Source, name: str) -> int:
    """2 if a data set has two columns, as for ellipses; otherwise 3."""
    values, has_time = _values(source, name)
    return 2 if values is not None and values.ndim > has_time + 1 and values.shape[-1] == 2 else 3


def _said_dimensions(source: _Source) -> int | None:
    said = source.group.attrs.get("dimensions")
    if said is None:
        return None
    if np.size(said) == 1 and np.ravel(said)[0] in (2, 3):
        return int(np.ravel(said)[0])
    raise FileError(source.path, f"the attribute dimensions must be 2 or 3, not {said}", source.frame)


def _take_angles(frame: Frame, source: _Source, n: int) -> None:
    """Angles of ellipses, unless there are quaternions."""
    angles = None if frame.quaternions is not None else _floats(source, "angle", n)
    if angles is None:
        return
    unit = _unit(source, "angle")
    if unit not in ("rad", "deg"):
        raise source.error("angle", "may be in degrees or in radians: give it the attribute unit, 'deg' or 'rad'")
    frame.angles = np.radians(angles) if unit == "deg" else angles
    frame.source = f"lengths semi_axes as radii, angle in {'degrees' if unit == 'deg' else 'radians'}"


def _unit(source: _Source, name: str) -> str:
    """The attribute unit of an element, or of its data set; empty if there is none."""
    found = (_find(source.path, source.group, name), _values(source, name)[0])
    units = [value for one in found if one is not None for key, value in one.attrs.items() if key.lower() in ("unit", "units")]
    return "" if not units else units[0].decode() if isinstance(units[0], bytes) else str(units[0])


def _check_units(source: _Source) -> None:
    """Refuses lengths in several units: numbers are taken as they are."""
    units = {unit: name for name in ("position", "semi_axes", "box/edges", "box/offset") if (unit := _unit(source, name))}
    if len(units) > 1:
        named = " and ".join(f"{name} ({unit})" for unit, name in units.items())
        raise FileError(source.path, f"the data sets {named} have different units: convert them to one", source.frame)


def _check_attributes(source: _Source, options: Options, frame: Frame) -> None:
    """Refuses attributes that could change bodies: of the file, of the groups, and of what is read."""
    meaning = Meaning("" if options.lengths else "radii", "" if options.quaternion else "wxyz", "", frame.angles is not None,
                      frame.quaternions is not None)  # fmt: skip
    for name in ("/", "", "position", "semi_axes", "orientation", "form", "angle"):
        if name == "/":
            found = (source.group.file, source.group.parent)
        else:
            found = (_find(source.path, source.group, name), _values(source, name)[0] if name else None)
        for one in found:
            texts = [] if one is None else [f"{key}={value}" for key, value in one.attrs.items()]
            check(texts, meaning, lambda reason: FileError(source.path, f"the attribute {reason}", source.frame))


def _take_box(frame: Frame, source: _Source) -> None:
    box = _find(source.path, source.group, "box")
    if box is None:
        return
    inside = source._replace(group=box)
    values, _ = _values(inside, "edges")
    n = 2 if values is not None and values.shape[-1:] == (2,) else 3  # 2 for a plane
    frame.dimensions = frame.dimensions or (2 if n == 2 else None)
    edges = _floats(inside, "edges", *([n] if _dimensions(inside, "edges") == 1 else [n, n]))
    if edges is None:
        frame.periodic = (False, False, False)
        return
    frame.cell = np.eye(3)
    frame.cell[:n, :n] = np.diag(edges) if edges.ndim == 1 else edges
    offset = _floats(inside, "offset", n)
    corner = np.asarray(box.attrs.get("offset", n * [0.0]) if offset is None else offset, dtype=np.float64)
    frame.origin = np.append(corner, (3 - n) * [-0.5])
    names = [name.decode() if isinstance(name, bytes) else str(name) for name in np.ravel(box.attrs.get("boundary", ["periodic"] * n))]
    if len(names) != n or not set(names) <= {"periodic", "none"}:
        count = "three" if n == 3 else "two"
        raise FileError(source.path, f"the attribute boundary of the box must be {count} of 'periodic' and 'none'", source.frame)
    frame.periodic = [name == "periodic" for name in (names + ["none"])[:3]]


def _dimensions(source: _Source, name: str) -> int:
    values, has_time = _values(source, name)
    return 0 if values is None else int(values.ndim) - has_time


def _read(source: _Source, name: str, shape: tuple[int, ...], kinds: str, what: str) -> Any | None:
    """An element of this shape, of which -1 is any number, and of one of these kinds."""
    values, has_time = _values(source, name)
    if values is None:
        return None
    there = values.shape[has_time:] if values.shape is not None else ()
    if len(there) != len(shape) or any(a != b != -1 for a, b in zip(there, shape)):
        raise source.error(name, f"must have the shape {shape}, not {there}")
    row = _row(source, name, len(values)) if has_time else 0
    if values.dtype.kind not in kinds:
        raise source.error(name, f"must have {what}, not {values.dtype}")
    # What has a row for each position, and no long rows, needs no more memory than positions.
    _check_size(source, name, values, math.prod(there) if -1 in shape or values.dtype.itemsize > 8 else 0)
    return values[row] if has_time else values[()]


def _row(source: _Source, name: str, count: int) -> int:
    """The row of an element that belongs to the frame: elements of H5MD may be written at other steps than the positions."""
    if source.frame < count and _step(source, name, source.frame) in (None, source.step):
        return source.frame
    if source.step is not None and 0 <= (row := _row_of_step(source, name, source.step, count)) < count:
        return row
    if source.frame >= count:
        raise source.error(name, f"has {counted(count, 'frame')}, fewer than there are positions: write the file again")
    raise source.error(name, f"has nothing at the step {source.step} of the positions: write both at the same steps, or choose other "
                       "frames (--frames)")  # fmt: skip


def _floats(source: _Source, name: str, *shape: int) -> Floats | None:
    data = _read(source, name, shape, "fiu", "numbers")
    return None if data is None else data.astype(np.float64)


def _check_size(source: _Source, name: str, values: Any, count: int) -> None:
    """Refuses more rows than the bytes of a file can hold, before memory is allocated for them."""
    stored = values.id.get_storage_size()
    if values.size and not stored:
        raise source.error(name, "was never written: write the file again")
    if max(count, math.prod(values.chunks or ())) * values.dtype.itemsize > _COMPRESSION * stored + _CHUNK:
        raise source.error(name, f"claims more than its {stored} bytes can hold: write the file again")


def _species(source: _Source, n: int) -> Any | None:
    """Whole numbers, or names."""
    data = _read(source, "species", (n,), "iuSO", "whole numbers or names")
    if data is None or data.dtype.kind in "iu":
        return data
    names = [name.decode("utf-8") if isinstance(name, bytes) else str(name) for name in data.tolist()]
    check_lengths_of_names(sorted(set(names)), lambda reason: FileError(source.path, reason, source.frame))
    return np.array(names)


def _said_steps(source: _Source, name: str) -> Any | None:
    """The data set of the steps of an element: one number for each row, or their distance. None if there is none."""
    import h5py

    element = _find(source.path, source.group, name)
    steps = _find(source.path, element, "step") if isinstance(element, h5py.Group) else None
    if steps is not None and (not isinstance(steps, h5py.Dataset) or steps.dtype.kind not in "iu" or steps.ndim > 1):
        raise source.error(f"{name}/step", "must be whole numbers")
    return steps


def _step(source: _Source, name: str, row: int) -> int | None:
    """The step of a row of an element; None if it does not say steps."""
    steps = _said_steps(source, name)
    if steps is None:
        return None
    if not steps.ndim:
        return int(steps[()]) * row + int(steps.attrs.get("offset", 0))
    if len(steps) <= row:
        raise source.error(f"{name}/step", f"has {counted(len(steps), 'frame')}, fewer than there are positions: write the file again")
    return int(steps[row])


def _row_of_step(source: _Source, name: str, step: int, count: int) -> int:
    """The one row of the `count` of an element that has a step; -1 if none has, or several have."""
    steps = _said_steps(source, name)
    if steps is None:
        return -1
    if not steps.ndim:
        increment = int(steps[()])
        row, rest = divmod(step - int(steps.attrs.get("offset", 0)), increment) if increment else (-1, 0)
        return -1 if rest else row
    _check_size(source, f"{name}/step", steps, len(steps))
    rows = np.flatnonzero(steps[()] == step)
    return int(rows[0]) if len(rows) == 1 and len(steps) == count else -1


def save(path: os.PathLike[str], systems: Iterator[System]) -> None:
    import h5py

    with h5py.File(path, "w") as file:
        _write_origin(file)
        group = file.create_group("particles/all")
        dimensions: int | None = None
        for frame, system in enumerate(systems):
            elements: dict[str, Any] = {
                "position": system.centers, "semi_axes": system.semi_axes, "orientation": system.quaternions,
                "id": system.ids, "species": _stored_types(system, group.get("species")),
            }  # fmt: skip
            if system.cell is not None:
                elements |= {"box/edges": system.cell, "box/offset": system.origin}
            if dimensions not in (None, system.dimensions):
                raise ValueError(f"frame {frame} has another number of dimensions, and a file has only one: choose frames (--frames)")
            dimensions = system.dimensions
            if frame == 0:
                group.attrs["dimensions"] = dimensions
                _write_box(group, system)
            else:
                _check_same(group, system, elements, frame)
            for name, values in elements.items():
                _append(group, name, values, system.step)


def _write_origin(file: Any) -> None:
    """Writes the group h5md of each file. MDAnalysis reads no file without times, and writes author and creator into copies."""
    h5md = file.create_group("h5md")
    h5md.attrs["version"] = (1, 1)
    h5md.create_group("author").attrs["name"] = "not given"
    h5md.create_group("creator").attrs.update(name="pypw85", version=version())


def _stored_types(system: System, before: Any | None) -> Any:
    """Whole numbers, unless there were names before."""
    names = checked_names(system)
    types = numbers_if_all_are(names)
    if types.dtype.kind == "i" and (before is None or before["value"].dtype.kind == "i"):
        return types
    if before is not None and before["value"].dtype.kind == "i":
        raise ValueError("types are names in this frame, but numbers in the first: choose frames (--frames)")
    return names.astype(object)


def _write_box(group: Any, system: System) -> None:
    box = group.create_group("box")
    box.attrs["dimension"] = 3
    box.attrs["boundary"] = _boundary(system)


def _boundary(system: System) -> Any:
    return np.array([b"periodic" if flag else b"none" for flag in system.periodic])


def _check_same(group: Any, system: System, elements: dict[str, Any], frame: int) -> None:
    """Refuses a system that differs from the first frame in data that H5MD stores once."""
    if len(system) != group["position/value"].shape[1]:
        raise ValueError(f"frame {frame} has another number of particles, which H5MD does not allow: choose frames (--frames)")
    if ("box/edges" in group) != ("box/edges" in elements) or (group["box"].attrs["boundary"] != _boundary(system)).any():
        raise ValueError(f"frame {frame} is periodic along other vectors, which H5MD does not allow: choose frames (--frames)")


def _append(group: Any, name: str, values: Any, step: int) -> None:
    import h5py

    if name not in group:
        element = group.create_group(name)
        kind = h5py.string_dtype() if values.dtype.kind == "O" else values.dtype
        _create(element, "value", values.shape, kind)
        if name == "position":
            _create(element, "step", (), np.dtype(np.int64))
            _create(element, "time", (), np.dtype(np.float64))
        else:
            element["step"], element["time"] = group["position/step"], group["position/time"]
    element = group[name]
    # The time is that in units of steps: a system has no other.
    for key, row in (("value", values), ("step", step), ("time", float(step))):
        data = element[key]
        if key == "value" or name == "position":
            data.resize(len(data) + 1, axis=0)
            data[-1] = row


def _create(element: Any, name: str, shape: tuple[int, ...], kind: Any) -> None:
    row = max(1, kind.itemsize * math.prod(shape[1:]))
    rows = min(shape[0], max(1, _CHUNK // row)) if shape else 1
    frames = max(1, _SMALL_CHUNK // (row * rows))
    chunks = (frames, rows, *shape[1:]) if shape else (frames,)
    element.create_dataset(name, (0, *shape), kind, maxshape=(None, *shape), chunks=chunks)
