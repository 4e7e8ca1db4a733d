"""GSD files of HOOMD-blue, by the library gsd: shapes belong to types, and numbers have single precision."""

from __future__ import annotations

import os
from typing import Any
from collections.abc import Iterator, Sequence

import numpy as np

from .._conversions import _gsd_semi_axes
from .._system import System
from .._typing import Floats
from ._boxes import box
from ._errors import FileError
from ._frames import Frame, Location, Options

SUFFIXES = (".gsd",)


def recognise(start: bytes) -> bool:
    return start[:8] == bytes.fromhex("DF65DF65DF65DF65")


def _open(path: os.PathLike[str], mode: str = "r") -> Any:
    """Before gsd 2.8, modes end with b, and frames are snapshots."""
    import gsd.hoomd

    try:
        return gsd.hoomd.open(os.fspath(path), mode if hasattr(gsd.hoomd, "Frame") else mode + "b")
    except (RuntimeError, OSError) as error:
        raise FileError(path, f"no readable GSD file ({error}): it is broken or truncated; write it again") from None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    with _open(path) as file:
        count = len(file)
    yield from map(Location, range(count))


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with _open(path) as file:
        try:
            snapshot = file[location.frame]
        except (RuntimeError, OSError, KeyError, ValueError) as error:
            raise FileError(path, f"cannot be read ({error}): the file is broken", location.frame) from None
    particles, configuration = snapshot.particles, snapshot.configuration
    cell, origin, periodic = _cell(configuration.box)
    frame = Frame(
        path, location, particles.position.astype(np.float64),
        quaternions=particles.orientation.astype(np.float64),
        types=np.array(particles.types)[particles.typeid] if particles.types else particles.typeid,
        ids=np.arange(particles.N), cell=cell, origin=origin, periodic=periodic, step=configuration.step,
    )  # fmt: skip
    frame.shapes = _shapes(frame, particles.type_shapes or [], particles.typeid)
    return frame.system(options)


def _cell(lengths_and_tilts: Any) -> tuple[Floats, Floats, Sequence[bool]]:
    """Cell, its corner (HOOMD's origin is in the middle), and what is periodic: not z in two dimensions, where Lz is 0."""
    lx, ly, lz, xy, xz, yz = np.asarray(lengths_and_tilts, dtype=np.float64)
    periodic = [True, True, bool(lz)]
    lz = lz or 1.0
    cell = np.array([[lx, 0, 0], [xy * ly, ly, 0], [xz * lz, yz * lz, lz]])
    return cell, -cell.sum(axis=0) / 2, periodic


def _shapes(frame: Frame, type_shapes: Sequence[Any], typeid: Any) -> Floats:
    """Semi-axes; 0 for the types that have no shape."""
    shapes = np.zeros((max(len(type_shapes), int(typeid.max(initial=0)) + 1), 3))
    for k, shape in enumerate(type_shapes):
        try:
            shapes[k] = _gsd_semi_axes(shape) if shape else 0.0
        except ValueError as error:
            raise frame.error(f"type {k} is {error}: only ellipsoids and spheres can be checked") from None
    selected: Floats = shapes[typeid]
    return selected


def save(path: os.PathLike[str], systems: Iterator[System]) -> None:
    import gsd.hoomd

    with _open(path, "w") as file:
        for system in systems:
            cell, low = box(system)
            snapshot = gsd.hoomd.Frame() if hasattr(gsd.hoomd, "Frame") else gsd.hoomd.Snapshot()
            lengths = np.diag(cell)
            tilts = cell[[1, 2, 2], [0, 0, 1]] / lengths[[1, 2, 2]]
            snapshot.configuration.box, snapshot.configuration.step = [*lengths, *tilts], system.step
            names, first, typeid = np.unique(
                np.column_stack([system.types.astype("U32"), system.semi_axes.astype("U32")]),
                axis=0, return_index=True, return_inverse=True,
            )[:3]  # fmt: skip
            particles = snapshot.particles
            particles.N, particles.typeid = len(system), typeid.ravel()
            particles.types = _names(names[:, 0])
            particles.type_shapes = [dict(zip(("type", *"abc"), ("Ellipsoid", *map(float, system.semi_axes[k])))) for k in first]
            particles.position = system.wrapped() - low - cell.sum(axis=0) / 2
            particles.orientation = system.quaternions
            file.append(snapshot)


def _names(types: Any) -> list[str]:
    """Names of types, which must differ: a type with several shapes gets numbers."""
    return [str(name) if (types == name).sum() == 1 else f"{name}_{k}" for k, name in enumerate(types)]
