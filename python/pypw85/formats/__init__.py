# SPDX-License-Identifier: BSD-3-Clause
"""Files of other programs: recognising their format, finding and reading frames, writing.

A format is a module. One that is read has ``recognise(start)``, ``locate(path)``, which finds frames without reading them, and
``load(path, location, options)``. One that is written has ``save``: of a frame to an open file, or of all frames to a path;
and ``losses``, sentences on what of a system it cannot hold, if there is anything.
"""

from __future__ import annotations

import dataclasses
import gzip
import itertools
import os
import re
import sys
import warnings
import zlib
from types import ModuleType
from typing import Any
from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from .._bodies import Fit
from .._choices import choice
from .._numbers import instances, integer
from .._system import System
from .._words import counted, printable, shown
from . import csv, ds9, gsd, hdf5, labels, lammps_data, lammps_dump, microstructpy, mjcf, obj, ply, sdf, splats, stl, vtk, xyz
from ._conventions import CONVENTION_NAMES, NONE
from ._errors import FileError
from ._files import (
    STANDARD_OUTPUT,
    Path,
    check_input,
    check_output,
    create_text,
    discard_unfinished,
    is_compressed,
    is_compressed_name,
    refuse_standard_output,
    replacing,
)
from ._frames import Frame, Location
from ._options import Options
from ._names import type_names

__all__ = [
    "CONVENTION_NAMES",
    "FORMATS",
    "NONE",
    "READABLE",
    "REGIONS",
    "STANDARD_OUTPUT",
    "WITHOUT_TYPES",
    "WRITABLE",
    "FileError",
    "Location",
    "Options",
    "check_output",
    "check_precision",
    "check_storable",
    "check_written_name",
    "discard_unfinished",
    "format_of",
    "frames",
    "guess",
    "guess_for_writing",
    "is_mesh",
    "load",
    "locate",
    "no_frames",
    "printable",
    "read",
    "refuse_standard_output",
    "renamed_types",
    "replacing",
    "write",
]

FORMATS: dict[str, ModuleType] = {
    "lammps-dump": lammps_dump,
    "lammps-data": lammps_data,
    "gsd": gsd,
    "xyz": xyz,
    "hdf5": hdf5,
    "csv": csv,
    "ds9": ds9,
    "splats": splats,
    "microstructpy": microstructpy,
    "labels": labels,
    "vtk": vtk,
    "stl": stl,
    "obj": obj,
    "ply": ply,
    "mjcf": mjcf,
    "sdf": sdf,
}
READABLE = [name for name, module in FORMATS.items() if hasattr(module, "load")]
REGIONS = "ds9"
WRITABLE = [name for name, module in FORMATS.items() if hasattr(module, "save")]
_WHOLE_FILES = (gsd, hdf5)
_MESHES = (stl, obj, ply)
# Formats other than meshes that do not store types
WITHOUT_TYPES = ("vtk", "mjcf", "sdf")
_NOT_COMPRESSED = (*_WHOLE_FILES, splats, labels)
_WITH_COLUMNS = (lammps_dump, xyz, csv)
# What files begin with that look like another format, and what helps
_LOOKALIKES = [
    (rb"[^\n\x00\x80-\xff]*\r[^\n\x00]*\Z", "its lines end with carriage returns alone: convert these to line feeds"),
    (rb"[^\n]*\bscale_0\b", "the columns scale_0 scale_1 scale_2 are logarithms of lengths, as splat-transform writes them to CSV: write "
                             "the same splats as PLY (splat-transform INPUT OUTPUT.ply)"),
    (rb"(?:\\[^\n]*\n)*\|[^\n]*\n\| *(?:c|char|d|double|f|float|i|int|l|long|r|real) *\|", "tables of IPAC (.tbl) are not read: save the "
     "table as CSV, with Astropy by Table.read(INPUT, format='ipac').write('OUTPUT.csv')"),
    (rb"[^\n]*\n[ |]*:?--+:? *\|[-:| ]*\r?\n", "tables of Markdown are not read: save the table as CSV, with commas instead of bars "
                                             "and without the line of dashes"),
]  # fmt: skip
# What files begin with that are not read, and what helps
_OTHERS = [
    (rb"(?:creator:[^\n]*\n)?---\s*(creator|timestep):", "this is a dump of LAMMPS in YAML: write it with dump custom"),
    (rb".{8}DUMP(?:CUSTOM|ATOM)|LammpS RestartT", "it is a binary file of LAMMPS: write a dump or a data file as text"),
    (rb"Number of particles *=", "files of AtomEye (.cfg) are not read: write a dump of LAMMPS or extended XYZ"),
    (rb"CDF[\x01\x02\x05]", "files of NetCDF are not read: write a dump of LAMMPS, GSD or extended XYZ"),
    (rb"(?:HEADER|CRYST1|REMARK|MODEL |ATOM  |HETATM|ANISOU|COMPND|AUTHOR)[ \d].*\n|TITLE {5}\S|"
     rb"(?:#[^\n]*\n|\s)*data_", "files of PDB, CIF and STAR are not read, nor "
     "displacement ellipsoids in them: write a table of centres, semi-axes and quaternions"),
    (rb"(?:(?:TITL|REM) [^\n]*\n|\s)*CELL +\d", "files of SHELX are not read, nor displacement ellipsoids in them: write a table of "
     "centres, semi-axes and quaternions"),
    (rb"- of Ulm|SQLite format 3\0", "files of ASE (.traj, .db) are not read: write extended XYZ (ase convert INPUT OUTPUT.extxyz)"),
    (rb"T\0\0\0CORD|\0\0\x07[\xcb\xc9]", "trajectories of DCD, XTC and TRR have no shapes of particles: write a dump of LAMMPS, GSD or "
                                          "extended XYZ"),
    (rb"t = [^\n]*\nb = ", "configurations of oxDNA are not read: write a dump of LAMMPS, GSD or extended XYZ"),
    (rb"(?:#[^\n]*\n|\s)*(?:(?:unitcell|pbc)[ \t]+[\d.]|(?:a|atom|default)[ \t]+[\d:,]*[ \t]*(?:radius|r|name|n|type|t|resid)[ \t])",
     "files of VTF are not read: write a dump of LAMMPS, GSD or extended XYZ"),
    (rb"#F [AB] [01] ", "files of IMD are not read: write a dump of LAMMPS or extended XYZ"),
    (rb"\.(?:color|sphere|cylinder|transparency)\b", "scenes of Chimera (.bild) are not read: write a table of centres and lengths"),
    (rb"boxMatrix\s|//date", "files of injavis (.pos) are not read: write GSD or extended XYZ"),
    (rb"(?://[^\n]*\n|\s)*(?:#(?:include|version|declare)\b|(?:camera|sphere|light_source)\s*\{)", "scenes of POV-Ray are not read: "
     "write a table of centres, semi-axes and quaternions"),
    (rb"SIMPLE  =", "files of FITS are not read: save the table as text"),
    (rb"\x89PNG|II\*\0|MM\0\*", "pictures are not read: write their labels with numpy.save (.npy)"),
    (rb"PK\x03\x04.{26}[^/]{1,80}\.npy", "archives of NumPy (.npz) are not read: write one array with numpy.save (.npy)"),
    (rb"\s*[\[{]", "JSON and lists in braces are not read: save the table as CSV, with a line of names"),
    (rb"BZh|\x28\xb5\x2f\xfd|\xfd7zXZ", "it is compressed, but not by gzip: decompress it"),
    (rb"# vtk DataFile|(?:<\?xml[^>]*>\s*)?<VTKFile", "files of VTK and ParaView are not read: save the table as CSV"),
    (rb"(?:<\?xml[^>]*>|<!--.*?-->|\s)*<(?:mujoco|robot|sdf)\b", "models of bodies (MJCF, URDF, SDF) are not read: write a table of the "
                                                               "positions, quaternions and semi-axes of the ellipsoids"),
    (rb"\s*<[!?\w]", "XML and HTML are not read: save the table as CSV"),
    (rb"NRRD\d|ObjectType =|(?:\x5c\x01\0\0|\0\0\x01\x5c)", "pictures are not read: write their labels with numpy.save (.npy)"),
    (rb"MATLAB 5\.0|PAR1|\xd0\xcf\x11\xe0", "binary files of MATLAB, Parquet and Excel are not read: save the table as CSV"),
    (rb"\*\*\*tess", "tessellations of Neper are not read: write a table of the centres, semi-axes and orientations of the grains"),
    (rb"#CRTF", "regions of CASA are not read: save them as regions of DS9 in pixels"),
    (rb"[^\n]*\n *\d+ *\r?\n {0,4}\d+[A-Za-z]|TITLE *\r?\n[^\n]*\n(?:[^\n]*\n)?END", "files of GROMACS have no shapes of particles: write "
     "a dump of LAMMPS or extended XYZ"),
    (rb"ply\s(?!.*\belement (?:face|tristrips)\b).*\bend_header\b", "these are points without shapes, neither splats nor a mesh: save "
                                                                     "a table as CSV, with columns of lengths"),
    (rb"ply\s|(?i:solid)\s|(?:#[^\n]*\n|\s)*(?:mtllib|o|v)\s", "this is a mesh, not a file of particles: read it with pypw85.Mesh.read"),
    (rb"PK\x03\x04.{26}(?:meta\.json|\w+\.webp)", "splats in .sog are not read: convert them (splat-transform INPUT.sog OUT.ply)"),
    (rb"glTF", "files of .glb are not read: convert the splats of which it was made (splat-transform INPUT OUTPUT.ply)"),
    (rb"\xff\xfe|\xfe\xff", "the text is in UTF-16: save it in UTF-8"),
    (rb"PK\x03\x04", "it is an archive or a spreadsheet: unpack it, or save the table as CSV"),
]
# Ends of names of what is not written, and what helps
_NOT_WRITTEN = {
    ".urdf": "URDF has no ellipsoids: write SDFormat (.sdf) or MJCF for MuJoCo (.xml), or put the ellipsoids into the URDF file as meshes",
}


def guess(path: Path) -> str:
    """The format of a file, by its content."""
    check_input(path)
    is_packed = is_compressed(path)
    try:
        with gzip.open(path) if is_packed else open(path, "rb") as file:
            start = file.read(4096).removeprefix(b"\xef\xbb\xbf")  # a byte order mark
    except (EOFError, gzip.BadGzipFile, zlib.error) as error:
        raise FileError(path, f"what is compressed cannot be read ({error}): it is broken or truncated; write it again") from None
    if not start.strip():
        raise FileError(path, "the file is empty: write it again")
    _refuse(path, start, _LOOKALIKES)
    end = os.fspath(path).lower()
    for name in READABLE:
        module = FORMATS[name]
        if module.recognise(start) or end.endswith(getattr(module, "RECOGNISED_NAMES", ())):
            if is_packed and module in _NOT_COMPRESSED and not start.startswith(splats.SPZ):
                raise FileError(path, f"compressed files of the format {name} are not read: decompress it (gunzip)")
            return name
    if end.endswith(".ksplat"):
        raise FileError(path, "splats in .ksplat are not read: convert them (splat-transform INPUT.ksplat OUTPUT.ply)")
    _refuse(path, start, _OTHERS)
    if end.removesuffix(".gz").endswith((*csv.SUFFIXES, ".tsv")) and b"\0" not in start:  # it says which column is missing
        return "csv"
    raise FileError(path, f"the format is not recognised: use --format (format= in Python) with one of {', '.join(READABLE)}")


def _refuse(path: Path, start: bytes, patterns: list[tuple[bytes, str]]) -> None:
    for pattern, cure in patterns:
        if re.match(pattern, start, re.DOTALL):
            raise FileError(path, cure)


def format_of(path: Path, format: str | None, convention: str | None) -> str:
    """The format that is named, or that of a convention, or that of the content: a table whose program is named is CSV, whatever its
    columns are called; regions have a format of their own."""
    if format is None and convention in (None, NONE, REGIONS):
        return guess(path)
    return format or "csv"


def guess_for_writing(path: Path) -> str:
    """The format that the end of a name asks for."""
    plain = os.fspath(path).lower().removesuffix(".gz")
    for name, module in FORMATS.items():
        if plain.endswith(module.SUFFIXES):
            return name
    for end, reason in _NOT_WRITTEN.items():
        if plain.endswith(end):
            raise FileError(path, reason)
    ends = ", ".join(suffix for module in FORMATS.values() for suffix in module.SUFFIXES)
    raise FileError(path, f"no format has this suffix: use --to FORMAT (format= in Python), or end the name with one of {ends}")


def is_mesh(format: str) -> bool:
    """Returns whether files of a format are meshes of triangles."""
    return FORMATS[format] in _MESHES


def check_written_name(path: Path, format: str | None) -> str:
    """The format of a file that is going to be written. Call it before the work that makes its frames.

    Raises
    ------
    FileError
        No format has such a name, or the format is not written compressed.
    OSError
        Nothing can be written there.
    """
    name = guess_for_writing(path) if format is None else choice(format, "write: format", FORMATS)
    if name not in WRITABLE:
        raise FileError(path, f"the format {name} is only read: choose one of {', '.join(WRITABLE)}")
    if is_compressed_name(path) and (FORMATS[name] in _WHOLE_FILES or name not in READABLE):
        raise FileError(path, f"the format {name} is not written compressed: end the name without .gz")
    check_output(path)
    return name


def check_precision(path: Path, format: str, precision: str | None) -> None:
    """Refuses a precision of a format that has only one."""
    if precision is not None:
        choice(precision, "write: precision", ("single", "double"))
    if precision is not None and format != "gsd":
        raise FileError(path, f"the precision can be chosen for the format gsd only, not for {format}: leave out --precision")


def check_storable(path: Path, format: str, system: System, **others: str) -> None:
    """Checks that a format can store a system, and warns of what is lost. Call it before the work that makes such systems. `others` is the
    precision of GSD.

    Raises
    ------
    ValueError
        As `write`.
    """
    list(_storable(path, FORMATS[format], [system], **others))


def locate(path: Path, format: str, chosen: slice = slice(None)) -> Iterator[Location]:
    """Locations of the chosen frames. They are found one by one, unless frames are counted from the last."""
    located = FORMATS[format].locate(path)
    numbers = chosen.start, chosen.stop, chosen.step
    if any(number is not None and number < 0 for number in numbers):
        yield from list(located)[chosen]
    else:
        # islice() takes no larger numbers, and no file has so many frames.
        yield from itertools.islice(located, *(None if number is None else min(number, sys.maxsize) for number in numbers))


def no_frames(path: Path, format: str, chosen: slice) -> FileError:
    """The error for a choice of which a file has none."""
    ends = ["" if end is None else str(end) for end in (chosen.start, chosen.stop, chosen.step)]
    is_one = chosen.step is None and chosen.start is not None and chosen.stop == (None if chosen.start == -1 else chosen.start + 1)
    wanted = f"is no frame {chosen.start}" if is_one else f"are no frames {':'.join(ends).rstrip(':')}"
    count = sum(1 for _ in locate(path, format))
    has = "no frames" if not count else "one frame, 0" if count == 1 else f"{count} frames, 0 to {count - 1}"
    return FileError(path, f"there {wanted}: the file has {has}")


def load(path: Path, format: str, location: Location, options: Options) -> System:
    module = FORMATS[format]
    options.check(path, format, module in _WITH_COLUMNS)
    system: System = module.load(path, location, options)
    return system


def _options(given: dict[str, Any]) -> Options:
    names = [field.name for field in dataclasses.fields(Options)]
    for name in given:
        if name not in names:
            raise TypeError(f"read() got an unexpected keyword argument '{name}': the options are {', '.join(names)}")
    return Options(**given)


def _readable(format: str | None) -> str | None:
    return None if format is None else choice(format, "read: format", READABLE)


def frames(path: Path, chosen: slice = slice(None), format: str | None = None, **options: Any) -> Iterator[System]:
    """Read the frames of a file of another program, one after the other. Only one frame is in memory.

    Parameters
    ----------
    path : path
        Name of the file.
    chosen : slice
        Frames to read, counted from 0, such as ``slice(100, None, 10)``. By default all.
    format : str, optional
        As for `read`.
    **options
        As for `read`.

    Returns
    -------
    iterator of System

    Raises
    ------
    FileError, OSError
        As for `read`, when the iterator reaches the frame.

    Examples
    --------
    >>> import os, tempfile, numpy as np, pypw85
    >>> name = os.path.join(tempfile.mkdtemp(), "run.dump")
    >>> pypw85.write(name, [pypw85.pack(np.ones((10, 3)), 0.2, seed=1) for _ in range(3)])
    >>> [len(system) for system in pypw85.frames(name, slice(1, None))]
    [10, 10]
    """
    if not isinstance(chosen, slice):
        raise TypeError(f"frames: chosen must be a slice, as slice(0, 100, 10), not {shown(chosen)}")
    given, format = _options(options), _readable(format)
    format = format_of(path, format, given.convention)
    said: set[str] = set()
    first, has_particles = None, False
    for location in locate(path, format, chosen):
        system = load(path, format, location, given)
        for note in system.notes:
            if note not in said:
                warnings.warn(f"{os.fspath(path)}, frame {location.frame}: {note}", stacklevel=2)
                said.add(note)
        first = location.frame if first is None else first
        has_particles = has_particles or len(system) > 0
        yield system
    if first is not None and not has_particles:
        raise FileError(path, "there are no particles: choose other frames, or write the file again", first)


def read(path: Path, frame: int = 0, format: str | None = None, **options: Any) -> System:
    """Read one frame of a file of another program.

    The attribute `source` of the result says how the columns were interpreted; its `notes`, also given as warnings, say what may be
    wrong.

    Parameters
    ----------
    path : path
        Name of the file.
    frame : int
        Number of the frame, from 0; -1 is the last frame.
    format : str, optional
        "lammps-dump", "lammps-data", "gsd", "xyz", "hdf5", "csv", "ds9", "splats", "microstructpy" or "labels". By default the format is
        recognised by the content of the file.
    **options
        Information that the file lacks, or that is wrong in the file. The options of the command ``pw85`` have the same names and
        meanings: ``pw85 check --help`` describes them.

        For all files: `lengths`, "radii", "diameters" or "rms"; `quaternion`, "wxyz" or "xyzw"; `cell`, a (3, 3) array whose rows are the
        cell vectors; `periodic`, three bools; `shape`, the three lengths of all particles that have no shape in the file; `shapes`, a
        dictionary of such lengths by type, with "*" for all other types; `dimensions`, 2 or 3; `angle`, "degrees" or "radians"; `points`,
        a list of types of particles that are points, which are left out.

        For files with columns: `convention`, the name of the program that wrote the table, or "none"; `shape_columns`,
        `quaternion_columns`, `angle_columns`, `polar` (two), `direction_columns` (three) and `ignore_columns`, lists of names of columns;
        `euler`, the axes of the Euler angles, such as ``zyx`` (fixed axes) or ``ZYX`` (axes that rotate with the body); `angle_zero`,
        "x" or "y"; `angle_sense`, "xy" or "yx".

        For splats: `sigma`, the length of the semi-axes in standard deviations; `scales`, "log" or "linear"; `strict`, True to refuse
        splats that are too flat instead of enlarging their semi-axes. For a labelled image: `spacing`, the distance between pixels, one
        number or one for each dimension.

    Returns
    -------
    System

    Raises
    ------
    FileError
        The file is broken; it has no such frame; or names in the file have different meanings in different programs. In the last case
        the message names the options that decide, as the command spells them: ``--shape-columns`` is the argument `shape_columns`. The
        message names the file, the frame and the line.
    OSError
        The file cannot be opened.

    Examples
    --------
    >>> import os, tempfile, pypw85
    >>> name = os.path.join(tempfile.mkdtemp(), "grains.csv")
    >>> with open(name, "w") as file:
    ...     print("x,y,z,radius", "0,0,0,1", "0,0,1.5,1", sep="\\n", file=file)
    >>> system = pypw85.read(name, cell=[[9, 0, 0], [0, 9, 0], [0, 0, 9]])
    >>> system.source
    'lengths radius as radii'
    >>> len(system.overlaps().mu)
    1
    """
    number = integer(frame, "read: frame", None)
    chosen = slice(number, None if number == -1 else number + 1)
    for system in frames(path, chosen, format, **options):
        return system
    raise no_frames(path, format_of(path, format, options.get("convention")), chosen)


def write(path: Path, systems: System | Iterable[System], format: str | None = None, precision: str | None = None,
          deviation: float | None = None, fit: Fit | None = None) -> None:  # fmt: skip
    """Write a system, or several systems as frames, to a file of another program.

    The file is written atomically: a complete file replaces an old one. A text file whose name ends with .gz is compressed. If the format
    cannot hold something exactly, such as double precision in a GSD file, there is a warning (`UserWarning`).

    Parameters
    ----------
    path : path
        Name of the file.
    systems : System or iterable of System
        One frame, or several frames. Not every format can hold several.
    format : str, optional
        "lammps-dump", "lammps-data", "gsd", "xyz", "hdf5", "csv", "vtk", "mjcf" or "sdf", or for a mesh of triangles "stl", "obj" or
        "ply". By default the extension of the name decides.
    precision : str, optional
        For a GSD file: "single" (the default), or "double", which HOOMD-blue reads since its version 7.
    deviation : float, optional
        For a mesh: largest distance of the triangles from the surfaces, in the unit of length. By default a hundredth of the longest
        semi-axis.
    fit : str, optional
        For a mesh: "inscribed", "circumscribed" or "volume" (the default), as for `ellipsoid_mesh`. The file contains this word in a
        comment.

    Returns
    -------
    None

    Raises
    ------
    ValueError
        The format cannot hold such a system, for instance because of a name of a type; the format can hold only one frame; or an ellipsoid
        has a centre that is not finite or a semi-axis that is not positive.
    OSError
        The file cannot be written.

    Examples
    --------
    >>> import os, tempfile, pypw85
    >>> name = os.path.join(tempfile.mkdtemp(), "one.csv")
    >>> one = pypw85.System.from_axes([[1, 2, 3]], [[1, 1, 2]], [[1, 0, 0, 0]])
    >>> pypw85.write(name, one)
    >>> print(open(name).read(), end="")
    id,type,x,y,z,a,b,c,qw,qx,qy,qz
    1,0,1,2,3,1,1,2,1,0,0,0
    """
    if not isinstance(path, (str, os.PathLike)):
        raise TypeError(f"write: path must be the name of a file, not {type(path).__qualname__}")
    if isinstance(systems, (list, tuple)) or not isinstance(systems, Iterable):
        systems = systems if isinstance(systems, System) else instances(systems, System, "write: systems")
    name = check_written_name(path, format)
    check_precision(path, name, precision)
    module = FORMATS[name]
    of_mesh = {key: value for key, value in (("deviation", deviation), ("fit", fit)) if value is not None}
    if of_mesh and module not in _MESHES:
        raise FileError(path, f"only meshes of triangles have a deviation and a fit, not {name}: leave out --{', --'.join(of_mesh)}")
    others = {} if precision is None else {"precision": precision}
    several = _storable(path, module, [systems] if isinstance(systems, System) else systems, **others)
    with replacing(path) as temporary:
        if module in _WHOLE_FILES:
            module.save(temporary, several, **others)
            return
        with create_text(temporary, is_compressed_name(path)) as file:
            for frame, system in enumerate(several):
                module.save(file, system, frame, **of_mesh)


def renamed_types(path: Path, frame: int, system: System, names: Mapping[str, str]) -> System:
    """A system whose types have other names. Each name that is to be replaced must be that of a type.

    Raises
    ------
    FileError
        One is not.
    """
    types = type_names(system)
    known = np.unique(types).tolist()
    for name in names:
        if name not in known and len(system):
            raise FileError(path, f"there is no type {name}, but {' '.join(known)[:200]}: use one of these with --species", frame)
    system.types = np.array([names.get(name, name) for name in known])[np.searchsorted(known, types)] if known else system.types
    return system


def _storable(path: Path, module: ModuleType, systems: Iterable[System], **others: str) -> Iterator[System]:
    """Checks that systems can be read again. Warns once of each kind of loss."""
    said: set[str] = set()
    frame, has_particles = -1, False
    for frame, system in enumerate(systems):
        if len(system):
            Frame.of(path, frame, system).check()
            has_particles = True
        for kind, sentence in _losses(module, system, **others):
            if kind not in said:
                warnings.warn(f"{os.fspath(path)}, frame {frame}: {sentence}", stacklevel=4)
                said.add(kind)
        if len(system):
            yield system
    if frame < 0:
        raise FileError(path, "there are no frames to write: choose others with --frames")
    if not has_particles:
        raise FileError(path, "there are no particles", frame)


def _losses(module: ModuleType, system: System, **others: str) -> Iterator[tuple[str, str]]:
    """Yields the data of a system that a format cannot store: a word for each type of loss, and a sentence."""
    if not len(system):
        yield "empty", "there are no particles: frames without any are left out"
        return
    if hasattr(module, "losses"):
        yield from module.losses(system, **others)
    if system.shapeless:
        yield "shapeless", counted(system.shapeless, "particle without a shape is left out", "particles without a shape are left out")
