"""Files of other programs: which format one has, its frames, and writing.

A format is a module. One that is read has ``recognise(start)``, ``locate(path)``, which finds frames without reading them, and
``load(path, location, options)``. One that is written has ``save``: of a frame to an open file, or of all frames to a path.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import shutil
import tempfile
from types import ModuleType
from typing import Any, Union
from collections.abc import Iterable, Iterator

from .._system import System
from . import csv, gsd, hdf5, lammps_data, lammps_dump, vtk, xyz
from ._errors import FileError
from ._frames import Location, Options

__all__ = [
    "FORMATS",
    "READABLE",
    "FileError",
    "Location",
    "Options",
    "frames",
    "guess",
    "guess_for_writing",
    "load",
    "locate",
    "read",
    "replacing",
    "write",
]

Path = Union[str, "os.PathLike[str]"]

FORMATS: dict[str, ModuleType] = {
    "lammps-dump": lammps_dump,
    "lammps-data": lammps_data,
    "gsd": gsd,
    "xyz": xyz,
    "hdf5": hdf5,
    "csv": csv,
    "vtk": vtk,
}
READABLE = [name for name, module in FORMATS.items() if hasattr(module, "load")]
_WHOLE_FILES = (gsd, hdf5)


def guess(path: Path) -> str:
    """The format of a file, by what is in it."""
    if os.path.isdir(path):
        raise FileError(path, "is a directory: name a file in it")
    with open(path, "rb") as file:
        start = file.read(4096)
    if not start.strip():
        raise FileError(path, "the file is empty: write it again")
    for name in READABLE:
        if FORMATS[name].recognise(start):
            return name
    raise FileError(path, f"the format is not recognised: give it (--format), one of {', '.join(READABLE)}")


def guess_for_writing(path: Path) -> str:
    """The format that the end of a name asks for."""
    for name, module in FORMATS.items():
        if os.fspath(path).lower().endswith(module.SUFFIXES):
            return name
    ends = ", ".join(suffix for module in FORMATS.values() for suffix in module.SUFFIXES)
    raise FileError(path, f"no format has such names: give it (--to), or end with one of {ends}")


def locate(path: Path, format: str, chosen: slice = slice(None)) -> Iterator[Location]:
    """Where the chosen frames are; found as they are asked for, unless counted from the last."""
    located = FORMATS[format].locate(path)
    if any(number is not None and number < 0 for number in (chosen.start, chosen.stop, chosen.step)):
        yield from list(located)[chosen]
    else:
        yield from itertools.islice(located, chosen.start, chosen.stop, chosen.step)


def load(path: Path, format: str, location: Location, options: Options) -> System:
    system: System = FORMATS[format].load(path, location, options)
    return system


def frames(path: Path, chosen: slice = slice(None), format: str | None = None, **options: Any) -> Iterator[System]:
    """The frames of a file, one after the other: no more than one is in memory.

    Parameters
    ----------
    path : path
    chosen : slice
        Which frames.
    format : str, optional
        "lammps-dump", "lammps-data", "gsd", "xyz", "hdf5" or "csv"; by what is in the file if absent.
    **options
        As for `read`.

    Returns
    -------
    iterator of System

    Raises
    ------
    FileError
        As `read`.
    """
    format = format or guess(path)
    for location in locate(path, format, chosen):
        yield load(path, format, location, Options(**options))


def read(path: Path, frame: int = 0, format: str | None = None, **options: Any) -> System:
    """One frame of a file of another program.

    Parameters
    ----------
    path : path
    frame : int
        From 0, or from the last with -1.
    format : str, optional
        "lammps-dump", "lammps-data", "gsd", "xyz", "hdf5" or "csv"; by what is in the file if absent.
    **options
        What the file does not say, or wrongly: `lengths`, "radii" or "diameters"; `quaternion`, "wxyz" or "xyzw"; `cell`, its
        vectors by rows; `periodic`, three flags; `shape`, the lengths of particles without any; `shape_columns` and
        `quaternion_columns`, names of columns of a dump or a CSV file.

    Returns
    -------
    System

    Raises
    ------
    FileError
        There is something wrong with the file, or the frame is not there.
    OSError
        It cannot be opened.
    """
    chosen = slice(frame, None if frame == -1 else frame + 1)
    for system in frames(path, chosen, format, **options):
        return system
    raise FileError(path, "there is no such frame: choose another", frame)


def write(path: Path, systems: System | Iterable[System], format: str | None = None) -> None:
    """Write a system, or several as frames. A file that was there stays whole until the new one is complete.

    Parameters
    ----------
    path : path
    systems : System or iterable of System
    format : str, optional
        As for `read`, or "vtk"; by the end of the name if absent.

    Returns
    -------
    None

    Raises
    ------
    ValueError
        The format cannot hold such a system, or no more than one frame.
    OSError
        The file cannot be written.
    """
    module = FORMATS[format or guess_for_writing(path)]
    several: Iterator[System] = iter([systems] if isinstance(systems, System) else systems)
    with replacing(path) as temporary:
        if module in _WHOLE_FILES:
            module.save(temporary, several)
            return
        with open(temporary, "w", encoding="utf-8") as file:
            for frame, system in enumerate(several):
                module.save(file, system, frame)


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[str]:
    """A temporary name beside `path`, which takes its place at the end unless something goes wrong."""
    folder, name = os.path.split(os.path.abspath(path))
    try:
        directory = tempfile.TemporaryDirectory(dir=folder, prefix=f".{name}.")
    except OSError as error:
        raise OSError(error.errno, error.strerror, os.fspath(path)) from None
    with directory as work:
        _unfinished.add(work)
        temporary = os.path.join(work, name)
        yield temporary
        os.replace(temporary, path)
    _unfinished.discard(work)


_unfinished: set[str] = set()


def discard_unfinished() -> None:
    """Removes temporary files of this process, which is about to end without the usual ceremonies."""
    for work in _unfinished:
        shutil.rmtree(work, ignore_errors=True)
