"""HDF5 in the layout of H5MD (nongnu.org/h5md), by h5py.

In the first group of /particles: position, and either semi_axes and orientation (w, x, y, z) or form, each of which may have
a group for time (value, step) or be one data set for all frames; species, id; box with its attribute boundary and edges.
"""

from __future__ import annotations

import os
from typing import Any
from collections.abc import Iterator

import numpy as np

from .._forms import principal_axes
from .._system import System, quaternions_of
from .._typing import Floats
from ._errors import FileError
from ._frames import Frame, Location, Options

SUFFIXES = (".h5", ".hdf5", ".h5md")


def recognise(start: bytes) -> bool:
    return start[:8] == b"\x89HDF\r\n\x1a\n"


def _open(path: os.PathLike[str]) -> Any:
    import h5py

    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise FileError(path, f"no readable HDF5 file ({error}): it is broken or truncated; write it again") from None


def _group(path: os.PathLike[str], file: Any) -> Any:
    groups = list(file["particles"].values()) if "particles" in file else []
    if not groups or "position" not in groups[0]:
        raise FileError(path, "there is no /particles/.../position, as in H5MD: name the data sets so")
    return groups[0]


def _values(element: Any) -> Any:
    """The data set of an element of H5MD, and whether its first dimension is time."""
    return (element, False) if hasattr(element, "shape") else (element["value"], True)


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    with _open(path) as file:
        values, has_time = _values(_group(path, file)["position"])
        count = len(values) if has_time else 1
    yield from map(Location, range(count))


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with _open(path) as file:
        group = _group(path, file)

        def read(name: str, *shape: int) -> Any | None:
            return _read(path, group, name, location.frame, shape)

        positions = read("position", -1, 3)
        assert positions is not None
        n = len(positions)
        species = read("species", n)
        frame = Frame(
            path, location, positions, shapes=read("semi_axes", n, 3), quaternions=read("orientation", n, 4),
            types=None if species is None else species.astype("U") if species.dtype.kind in "SO" else species,
            ids=read("id", n), step=int(_step(group["position"], location.frame)),
        )  # fmt: skip
        if frame.shapes is None and (forms := read("form", n, 6)) is not None:
            with np.errstate(invalid="ignore"):
                frame.shapes, rotation = principal_axes(forms)
            bad = np.isnan(frame.shapes).any(axis=1)
            if bad.any():
                raise frame.error("has a form that is not positive definite: correct it", int(bad.argmax()))
            frame.quaternions = quaternions_of(rotation)
        if "box" in group:
            frame.cell, frame.origin, frame.periodic = _box(path, group["box"], location.frame)
    return frame.system(options)


def _read(path: os.PathLike[str], group: Any, name: str, frame: int, shape: tuple[int, ...]) -> Any | None:
    if name not in group:
        return None
    values, has_time = _values(group[name])
    try:
        data = values[frame] if has_time else values[()]
    except (OSError, ValueError, IndexError) as error:
        raise FileError(path, f"{name} cannot be read ({error}): the file is broken or has fewer frames of it", frame) from None
    if data.ndim != len(shape) or any(a not in (b, -1) and b != -1 for a, b in zip(data.shape, shape)):
        raise FileError(path, f"{name} should have the shape {shape}, not {data.shape}", frame)
    return data.astype(np.float64) if data.dtype.kind == "f" else data


def _step(element: Any, frame: int) -> Any:
    if hasattr(element, "shape") or "step" not in element:
        return 0
    steps = element["step"]
    return steps[frame] if steps.shape else steps[()] * frame


def _box(path: os.PathLike[str], group: Any, frame: int) -> tuple[Floats | None, Any, list[bool]]:
    boundary = [str(name, "ascii") if isinstance(name, bytes) else str(name) for name in group.attrs.get("boundary", ())]
    if "edges" not in group:
        return None, (0.0, 0.0, 0.0), [False] * 3
    values, has_time = _values(group["edges"])
    edges = np.asarray(values[frame] if has_time else values[()], dtype=np.float64)
    if edges.shape not in ((3,), (3, 3)):
        raise FileError(path, f"the edges of the box should have the shape (3,) or (3, 3), not {edges.shape}", frame)
    cell = np.diag(edges) if edges.ndim == 1 else edges
    return cell, group.attrs.get("offset", (0.0, 0.0, 0.0)), [name == "periodic" for name in boundary] or [True] * 3


def save(path: os.PathLike[str], systems: Iterator[System]) -> None:
    import h5py

    with h5py.File(path, "w") as file:
        file.create_group("h5md").attrs["version"] = (1, 1)
        group = file.create_group("particles/all")
        for frame, system in enumerate(systems):
            if frame == 0:
                _fixed(group, system)
            elif len(system) != len(group["id"]):
                raise ValueError(f"frame {frame} has another number of particles, which H5MD does not allow: choose frames")
            elements: dict[str, Any] = {"position": system.centers, "semi_axes": system.semi_axes,
                                        "orientation": system.quaternions}  # fmt: skip
            if system.cell is not None:
                elements["box/edges"] = system.cell
            for name, values in elements.items():
                _append(group, name, values, system.step)


def _fixed(group: Any, system: System) -> None:
    """What does not change with time."""
    names = system.types.dtype.kind == "U"
    group["species"] = system.types.astype("S") if names else system.types
    group["id"] = system.ids
    box = group.create_group("box")
    box.attrs["dimension"] = 3
    box.attrs["boundary"] = np.array([b"periodic" if flag else b"none" for flag in system.periodic])
    box.attrs["offset"] = system.origin


def _append(group: Any, name: str, values: Any, step: int) -> None:
    if name not in group:
        element = group.create_group(name)
        element.create_dataset("value", (0, *values.shape), values.dtype, maxshape=(None, *values.shape))
        element.create_dataset("step", (0,), np.int64, maxshape=(None,))
    for key, row in (("value", values), ("step", step)):
        data = group[name][key]
        data.resize(len(data) + 1, axis=0)
        data[-1] = row
