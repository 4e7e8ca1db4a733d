# SPDX-License-Identifier: BSD-3-Clause
"""Options of the user, which say what a file lacks, or replace what it says."""

from __future__ import annotations

import dataclasses
from typing import Any
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from .._arrays import reals
from .._choices import choice, names_of
from .._numbers import flags, positive, truth
from .._rotations import check_sequence
from .._typing import Floats
from .._words import shown
from ._conventions import CONVENTION_NAMES, NONE
from ._errors import FileError
from ._files import Path

# What lengths and quaternions are in formats that say so
_FIXED = {
    "gsd": ("radii", "wxyz"), "splats": ("radii", "wxyz"), "microstructpy": ("radii", "no quaternions"), "ds9": ("radii", "no quaternions"),
    "labels": ("radii", "no quaternions"), "hdf5": ("radii", ""), "lammps-data": ("diameters", "wxyz"),
}  # fmt: skip
# The name that stands for all types in `Options.shapes`
ALL_TYPES = "*"
_WORDS = {"rms": "RMS lengths, of which a semi-axis of a uniform body is 2 in a plane and √5 in space"}
# The values of `Options` that are one of a few, and how many columns others may name
LENGTHS, ORDERS, ANGLES, SCALES = ("radii", "diameters", "rms"), ("wxyz", "xyzw"), ("degrees", "radians"), ("log", "linear")
_CHOICES: dict[str, Sequence[str] | Sequence[int]] = {
    "lengths": LENGTHS, "quaternion": ORDERS, "dimensions": (2, 3), "angle": ANGLES, "scales": SCALES,
    "convention": (*CONVENTION_NAMES, NONE), "angle_zero": ("x", "y"), "angle_sense": ("xy", "yx"),
}  # fmt: skip
_NAMES: dict[str, Sequence[int]] = {
    "shape_columns": (1, 2, 3), "quaternion_columns": (4,), "angle_columns": (1, 2, 3), "polar": (2,), "direction_columns": (3,),
    "ignore_columns": (), "points": (),
}  # fmt: skip


def lengths_in_words(lengths: str) -> str:
    return _WORDS.get(lengths, lengths)


@dataclasses.dataclass(frozen=True)
class Options:
    """Options of the user, which replace what the file says.

    `lengths` is "radii" or "diameters", `quaternion` "wxyz" or "xyzw", `cell` rows of vectors, `periodic` three flags,
    `shape` the lengths of particles without any, `shape_columns` and `quaternion_columns` names of columns, `dimensions` 2 or 3,
    `angle` "degrees" or "radians". `points` are types of particles that are points. Of splats, `sigma` is how many standard deviations the
    semi-axes are, `scales` "log" or "linear", and with `strict` none of them is raised.
    `spacing` is the distance of the pixels of an image. `lengths` may also be "rms". `convention` is the name of one (`_conventions`), or
    "none"; `euler` a sequence of axes; `angle_columns`, `polar` (two) and `direction_columns` (three) name columns, and `ignore_columns`
    those that do not matter; `angle_zero` is "x" or "y", `angle_sense` "xy" or "yx". `shapes` are the lengths of types of particles, and
    under "*" those of all types that have none.

    Raises ValueError or TypeError for a value that an option never has, whatever the file is.
    """

    lengths: str | None = None
    quaternion: str | None = None
    cell: Any | None = None
    periodic: Sequence[bool] | None = None
    shape: Sequence[float] | None = None
    shape_columns: Sequence[str] | None = None
    quaternion_columns: Sequence[str] | None = None
    dimensions: int | None = None
    angle: str | None = None
    points: Sequence[str] | None = None
    sigma: float | None = None
    scales: str | None = None
    strict: bool = False
    spacing: Any | None = None
    convention: str | None = None
    euler: str | None = None
    angle_columns: Sequence[str] | None = None
    polar: Sequence[str] | None = None
    direction_columns: Sequence[str] | None = None
    ignore_columns: Sequence[str] | None = None
    angle_zero: str | None = None
    angle_sense: str | None = None
    shapes: Mapping[str, Sequence[float]] | None = None

    def __post_init__(self) -> None:
        for name, allowed in _CHOICES.items():
            self._replace(name, choice, allowed)
        for name, counts in _NAMES.items():
            self._replace(name, names_of, counts)
        self._replace("cell", _cell)
        self._replace("periodic", lambda value, name: tuple(map(bool, flags(value, name))))
        self._replace("shape", _lengths)
        self._replace("shapes", _lengths_of_types)
        self._replace("sigma", positive)
        self._replace("strict", truth)
        self._replace("euler", check_sequence)

    def _replace(self, name: str, checked: Callable[..., Any], *others: Any) -> None:
        """Replaces a value that is given by what a check returns."""
        if (value := getattr(self, name)) is not None:
            object.__setattr__(self, name, checked(value, f"read: {name}", *others))

    @property
    def says_turns(self) -> bool:
        """Returns whether an option other than that of quaternions gives the orientations."""
        return bool(self.euler or self.polar or self.direction_columns)

    def check(self, path: Path, format: str, has_columns: bool) -> None:
        """Refuses options that a format has no use for."""
        given = {"--shape-columns": self.shape_columns, "--quaternion-columns": self.quaternion_columns, "--angle": self.angle,
                 "--euler": self.euler, "--angle-columns": self.angle_columns, "--polar": self.polar, "--convention": self.convention,
                 "--direction-columns": self.direction_columns, "--ignore-columns": self.ignore_columns,
                 "--angle-zero": self.angle_zero, "--angle-sense": self.angle_sense}  # fmt: skip
        for name, value in given.items():
            is_ignored = name == "--ignore-columns" and format in ("hdf5", "splats")
            if value is not None and not has_columns and value != format and not is_ignored:
                raise FileError(path, f"files of the format {format} have no named columns: leave out {name}")
        fixed = _FIXED.get(format, ("", ""))
        for name, value, meaning in (("--lengths", self.lengths, fixed[0]), ("--quaternion", self.quaternion, fixed[1])):
            if value is not None and meaning and value != meaning:
                raise FileError(path, f"files of the format {format} have {meaning}, whatever {name} says: leave it out")
        of_splats = {"--sigma": self.sigma, "--scales": self.scales, "--strict": self.strict or None}
        for name, one in of_splats.items():
            if one is not None and format != "splats":
                raise FileError(path, f"{name} applies to the format splats only, not to {format}: leave it out")
        if self.spacing is not None and format != "labels":
            raise FileError(path, f"--spacing applies to the format labels only, not to {format}: leave it out")


def _cell(value: Any, name: str) -> Floats:
    cell = reals(value, name)
    if cell.shape != (3, 3):
        raise ValueError(f"{name} must be three vectors of three numbers, one in each row, not {shown(value)}")
    return cell


def _lengths(value: Any, name: str) -> Floats:
    lengths = reals(value, name)
    if lengths.shape != (3,) or not ((lengths > 0) & (lengths < np.inf)).all():
        raise ValueError(f"{name} must be three finite numbers > 0, not {shown(value)}")
    return lengths


def _lengths_of_types(value: Any, name: str) -> dict[str, Floats]:
    if not isinstance(value, Mapping) or not all(isinstance(one, str) for one in value):
        raise TypeError(f"{name} must map names of types to three lengths, not be {shown(value)}")
    return {one: _lengths(lengths, f"{name} of '{one}'") for one, lengths in value.items()}
