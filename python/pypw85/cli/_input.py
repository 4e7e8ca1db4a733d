# SPDX-License-Identifier: BSD-3-Clause
"""Options of all commands that read a file."""

from __future__ import annotations

import functools
import itertools
import os
import warnings
from typing import Any, NamedTuple, TextIO
from collections.abc import Callable, Iterator, Mapping, Sequence

import click
import numpy as np

from ..formats import (
    CONVENTION_NAMES,
    NONE,
    READABLE,
    STANDARD_OUTPUT,
    FileError,
    Location,
    Options,
    check_output,
    format_of,
    load,
    locate,
    no_frames,
)
from ..formats._errors import names_of_option
from ..formats._options import ANGLES, LENGTHS, ORDERS, SCALES
from .._rotations import SEQUENCES, is_sequence
from .._system import System
from .._words import counted
from ._progress import say


class Input(NamedTuple):
    path: str
    format: str
    chosen: slice
    options: Options
    # Whether particles without a shape are points
    has_points: bool = False

    def locations(self) -> Iterator[Location]:
        """Locations of the chosen frames, of which there is at least one."""
        found = locate(self.path, self.format, self.chosen)
        if (first := next(found, None)) is None:
            raise no_frames(self.path, self.format, self.chosen)
        yield from itertools.chain([first], found)

    def load(self, location: Location) -> System:
        system = load(self.path, self.format, location, self.options)
        if self.has_points and len(system) and not system.shapeless:
            system.notes = (*system.notes, "--points has no effect, because all particles have shapes")
        return system

    def describe(self, source: str) -> str:
        """A line that describes how the file was read."""
        return f"{self.path}: " + ", ".join(filter(None, [self.format, source]))

    def systems(self, stream: TextIO | None = None) -> Iterator[System]:
        """The chosen frames. Prints how they were read to `stream`, if it is not None, and prints each warning once."""
        return (system for _, system in self.numbered_systems(stream))

    def numbered_systems(self, stream: TextIO | None = None) -> Iterator[tuple[int, System]]:
        said: set[str] = set()
        for location in self.locations():
            system = self.load(location)
            line = self.describe(system.source)
            if stream is not None and line not in said and (len(system) or system.shapeless):
                say(line, stream)
                said.add(line)
            for note in system.notes:
                if note not in said:
                    warnings.warn(f"{self.path}, frame {location.frame}: {note}", stacklevel=2)
                    said.add(note)
            yield location.frame, system


class Numbers(click.ParamType):
    """Numbers, separated by commas or spaces."""

    name = "numbers"

    def __init__(self, *counts: int, positive: bool = False) -> None:
        self.counts, self.positive = counts, positive

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        try:
            numbers = np.array(value.replace(",", " ").split(), dtype=np.float64)
        except ValueError:
            self.fail(f"'{value}' is not a list of numbers", param, ctx)
        if len(numbers) not in self.counts or not np.isfinite(numbers).all() or (self.positive and not (numbers > 0).all()):
            kind, count = "finite numbers > 0" if self.positive else "finite numbers", len(numbers)
            given = "" if count in self.counts else f", not {count}"
            self.fail(f"'{value}' must be {' or '.join(map(str, self.counts))} {kind}{given}", param, ctx)
        return numbers


def _number(text: Any) -> float:
    """Converts a string to a number; NaN if this is not possible."""
    try:
        return float(text)
    except ValueError:
        return np.nan


def _whole_number(text: Any) -> int | None:
    """Converts a string such as 5, 1e5 or 18446744073709551615 to an integer; None if this is not possible."""
    try:
        return int(text)
    except ValueError:
        number = _number(text)
        return int(number) if abs(number) < 2**53 and number == int(number) else None


class Shape(click.ParamType):
    """Three lengths, optionally after the name of a type and a colon."""

    name = "shape"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str | None, Any]:
        if not isinstance(value, str):
            return None, value
        kind, colon, numbers = value.rpartition(":")
        return kind if colon else None, Numbers(3, positive=True).convert(numbers, param, ctx)


class EulerSequence(click.ParamType):
    """Axes of Euler angles."""

    name = "sequence"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        if not is_sequence(value):
            self.fail(f"must be {SEQUENCES}, not '{value}'", param, ctx)
        return str(value)


class WholeNumber(click.ParamType):
    """A whole number within limits, > 0 by default, which may be written as 1e5."""

    name = "number"

    def __init__(self, least: int = 1, most: int = 2**53 - 1) -> None:
        self.least, self.most = least, most

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        number = _whole_number(value)
        if number is None or not self.least <= number <= self.most:
            bits = self.most.bit_length()
            most = f"2**{bits} - 1" if self.most == 2**bits - 1 else str(self.most)
            self.fail(f"must be a whole number from {self.least} to {most}, not '{value}'", param, ctx)
        return number


class Finite(click.ParamType):
    """A finite number > 0, or one that may be 0; below a limit, or at most another one, if there is one."""

    name = "number"

    def __init__(self, may_be_zero: bool = False, below: float = np.inf, most: float = np.inf) -> None:
        self.may_be_zero, self.below, self.most = may_be_zero, below, most

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        number = _number(value)
        if not ((0 < number < self.below and number <= self.most) or (self.may_be_zero and number == 0)):
            limit = f" and < {self.below:g}" * (self.below < np.inf) + f" and at most {self.most:g}" * (self.most < np.inf)
            self.fail(f"must be a finite number {'>=' if self.may_be_zero else '>'} 0{limit}, not '{value}'", param, ctx)
        return number


class Angle(click.ParamType):
    """A finite number of degrees."""

    name = "degrees"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        number = _number(value)
        if not np.isfinite(number):
            self.fail(f"must be a finite number of degrees, not '{value}'", param, ctx)
        return number


class Frames(click.ParamType):
    """A number, or start:stop:step as in Python."""

    name = "frames"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> slice:
        if isinstance(value, slice):
            return value
        try:
            words = [int(word) if word else None for word in value.split(":")]
            if len(words) == 1 and words[0] is not None:
                return slice(words[0], None if words[0] == -1 else words[0] + 1)
            chosen = slice(*words)
        except (TypeError, ValueError):
            self.fail(f"'{value}' is neither a number nor start:stop:step", param, ctx)
        if chosen.step == 0:
            self.fail("the step of frames must not be 0", param, ctx)
        return chosen


class _ReadingOption(click.Option):
    """An option that says how a file is read."""


class _Command(click.Command):
    """A command whose help lists its own options first, and then those that say how the file is read."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        for title, is_reading in (("Options", False), ("Options for reading the input file", True)):
            records = [one.get_help_record(ctx) for one in self.get_params(ctx) if isinstance(one, _ReadingOption) == is_reading]
            if rows := [record for record in records if record is not None]:
                with formatter.section(title):
                    formatter.write_dl(rows)


command = functools.partial(click.command, cls=_Command)

# The value of --points without a type
_SHAPELESS = ""
_FILE: Callable[..., Any] = click.argument("file")
_option = functools.partial(click.option, cls=_ReadingOption)
_OPTIONS = [
    _option("--format", type=click.Choice(READABLE), help="Format of the file. Default: recognised from its content."),
    _option("--frames", type=Frames(), default=":", metavar="START:STOP:STEP",
            help="One frame (0: the first, -1: the last), or a slice as in Python: every STEP-th frame from START up to, but not "
                 "including, STOP. Default: all."),
    _option("--lengths", type=click.Choice(LENGTHS),
            help="Meaning of the three lengths of a particle: radii (semi-axes), diameters, or rms (the standard deviation of the points "
                 "of a uniform body along an axis). By default the names of the columns decide; otherwise lengths are diameters in "
                 "files of LAMMPS, and radii in others."),
    _option("--quaternion", type=click.Choice(ORDERS),
            help="Order of the components of quaternions. By default the names of the columns decide; otherwise the order is "
                 "xyzw in extended XYZ, and wxyz in other formats."),
    _option("--cell", type=Numbers(3, 9), metavar="NUMBER,...",
            help="The cell, if the file has none or another one: three edges A,B,C of a rectangular cell, or nine numbers, the three "
                 "cell vectors a, b, c one after the other."),
    _option("--periodic", type=click.Choice(["none", "a", "b", "c", "ab", "ac", "bc", "abc"]),
            help="The cell vectors along which the system is periodic. By default the file decides; otherwise all of them."),
    _option("--shape", type=Shape(), multiple=True, metavar="[TYPE:]A,B,C",
            help="Lengths of the particles that have no shape in the file: of one type, or of all types ('*:A,B,C'). TYPE may be "
                 "omitted if these particles have one type. May be repeated."),
    _option("--shape-columns", metavar="A,B,C",
            help="Columns of a dump, CSV or XYZ file that contain the lengths: three, two for ellipses, one for spheres. The "
                 "components of a property are NAME[1], NAME[2] and so on."),
    _option("--quaternion-columns", metavar="A,B,C,D", help="Columns that contain the quaternion, in the order of --quaternion."),
    _option("--dimensions", type=click.Choice(["2", "3"]),
            help="2 for ellipses in a plane z = constant, 3 for ellipsoids. By default the file decides."),
    _option("--angle", type=click.Choice(ANGLES),
            help="Unit of the angles. By default the names of the columns decide."),
    _option("--convention", type=click.Choice([*CONVENTION_NAMES, NONE]), metavar="NAME",
            help=f"The program that wrote a table, which fixes the meaning of all columns: {', '.join(CONVENTION_NAMES)}. By default the "
                 f"program is recognised by the names of the columns; {NONE}: no program, each column is read by its own name."),
    _option("--euler", type=EulerSequence(), metavar="SEQUENCE",
            help="Axes of the Euler angles, in the order of the angles: zyx for fixed axes, ZYX for axes that rotate with the body."),
    _option("--angle-columns", metavar="A,...",
            help="Columns of the Euler angles, in the order of --euler; or, without --euler, the column of the angle of ellipses."),
    _option("--angle-zero", type=click.Choice(["x", "y"]),
            help="Axis at which the angle of an ellipse is 0. Default: x."),
    _option("--angle-sense", type=click.Choice(["xy", "yx"]),
            help="Positive sense of the angles of ellipses: from x towards y (xy), or from y towards x (yx), which is "
                 "counterclockwise in a picture whose y axis points down. Default: xy."),
    _option("--polar", metavar="A,B",
            help="Columns of the polar angle A (from z) and the azimuth B (about z, from x) of an axis of revolution."),
    _option("--direction-columns", metavar="A,B,C", help="Columns of the direction of an axis of revolution."),
    _option("--ignore-columns", metavar="A,...", help="Columns to ignore, as if the file did not have them."),
    _option("--points", is_flag=False, flag_value=_SHAPELESS, metavar="[TYPE,...]",
            help="Types of particles that are points, and are left out. Without TYPE, all particles without a shape are points."),
    _option("--sigma", type=Finite(), metavar="NUMBER",
            help="For splats: length of the semi-axes, in standard deviations. Default: 1."),
    _option("--scales", type=click.Choice(SCALES),
            help="For splats: meaning of the scales in the file: logarithms of lengths (log), or lengths (linear)."),
    _option("--strict", is_flag=True,
            help="For splats: refuse a file with splats that are too flat, instead of enlarging their semi-axes."),
    _option("--spacing", type=Numbers(1, 2, 3, positive=True), metavar="NUMBER,...",
            help="For a labelled image: the distance between pixels, one number for all dimensions or one for each. Default: 1."),
]  # fmt: skip


# The options that `_options` takes
_NAMES = ("lengths", "quaternion", "cell", "periodic", "shape", "shape_columns", "quaternion_columns", "dimensions", "angle", "sigma",
          "scales", "strict", "spacing", "convention", "euler", "angle_columns", "angle_zero", "angle_sense", "polar", "direction_columns",
          "ignore_columns")  # fmt: skip


def _options(points: str | None, *, cell: Any, periodic: str | None, shape: Any, dimensions: str | None, spacing: Any,
             shape_columns: str | None, quaternion_columns: str | None, euler: str | None, angle_columns: str | None,
             polar: str | None, direction_columns: str | None,
             ignore_columns: str | None, **others: Any) -> Options:  # fmt: skip
    """Converts the options of the command line to those of the readers."""
    if cell is not None:
        cell = np.diag(cell) if len(cell) == 3 else cell.reshape(3, 3)
    _refuse_repeated([kind for kind, _ in shape])
    return Options(
        cell=cell, periodic=None if periodic is None else [periodic != "none" and name in periodic for name in "abc"],
        shape=next((lengths for kind, lengths in shape if kind is None), None),
        shapes={kind: lengths for kind, lengths in shape if kind is not None} or None,
        dimensions=None if dimensions is None else int(dimensions), points=names_of_option(points) if points else None,
        spacing=spacing[0] if spacing is not None and len(spacing) == 1 else spacing, euler=euler,
        shape_columns=_names(shape_columns, 3, "--shape-columns", least=1),
        quaternion_columns=_names(quaternion_columns, 4, "--quaternion-columns"),
        angle_columns=_names(angle_columns, len(euler or "z"), "--angle-columns",
                             hint=": one for each letter of --euler" if euler else ": use --euler for more than one angle"),
        polar=_names(polar, 2, "--polar"),
        direction_columns=_names(direction_columns, 3, "--direction-columns"),
        ignore_columns=None if ignore_columns is None else names_of_option(ignore_columns), **others,
    )  # fmt: skip


def _refuse_repeated(kinds: Sequence[str | None]) -> None:
    """Checks that no two --shape options are for the same type."""
    for i, kind in enumerate(kinds):
        if kind in kinds[:i]:
            raise click.UsageError(f"--shape is given twice for {'one type' if kind is None else repr(kind)}: leave one of them out, or "
                                   "name another type")  # fmt: skip


def input_options(
    function: Callable[..., Any], argument: Callable[..., Any] = _FILE, is_other: Callable[[str], bool] = lambda _: False
) -> Callable[..., Any]:
    """Decorator: adds the options above, which the command receives as one `Input`, or as None if the argument is optional and absent.
    If `is_other` holds for a file, its format is not guessed, because the command reads it in another way."""

    @functools.wraps(function)
    def command(file: str | None, format: str | None, frames: slice, points: str | None, **others: Any) -> Any:
        options = _options(points, **{name: others.pop(name) for name in _NAMES})
        if file is None:
            return function(None, **others)
        known = "" if format is None and is_other(file) else format_of(file, format, options.convention)
        given = Input(file, known, frames, options, points == _SHAPELESS)
        return function(given, **others)

    for option in reversed(_OPTIONS):
        command = option(command)
    decorated: Callable[..., Any] = argument(command)
    return decorated


def given_options() -> dict[str, str]:
    """The parameters on the command line, by name, with the options or arguments that users see."""
    ctx = click.get_current_context()
    return {
        param.name: param.opts[0] if isinstance(param, click.Option) else param.make_metavar().strip("[]")
        for param in ctx.command.params
        if param.name and ctx.get_parameter_source(param.name) is click.core.ParameterSource.COMMANDLINE
    }


def refuse_idle(needed: Mapping[str, Sequence[str]]) -> None:
    """Raises a usage error for an option that has no effect without another option."""
    ctx, given = click.get_current_context(), given_options()
    options = {param.name: param.opts[0] for param in ctx.command.params}
    for name in needed:
        if name in given and not any(ctx.params[other] for other in needed[name]):
            if zero := [given[other] for other in needed[name] if other in given]:
                raise click.UsageError(f"{given[name]} has no effect with {zero[0]} 0: leave out one of both")
            others = " or ".join(options[other] for other in needed[name])
            raise click.UsageError(f"{given[name]} has no effect without {others}: add {others}, or leave out {given[name]}")


def refuse_given(name: str, where: str) -> None:
    """Raises a usage error for an option that has no effect."""
    if option := given_options().get(name):
        raise click.UsageError(f"{option} has no effect {where}: leave it out")


def check_outputs(given: Input, *paths: str | None) -> None:
    """Checks the names of output files: writable, different from the input, and all different. Call it before the work."""
    taken = {os.path.realpath(given.path): "is the input: name another file"}
    for path in paths:
        if path is None:
            continue
        target = check_output(path)
        if (target.is_replaced or path == STANDARD_OUTPUT) and (reason := taken.setdefault(target.path, "")):
            raise FileError(path, reason)
        taken[target.path] = "is named for two outputs: name another file"


def one_frame(given: Input, stream: TextIO | None = None) -> System:
    """The first of the chosen frames. Prints how it was read to `stream`, if it is not None."""
    frame, system = next(given.numbered_systems(stream))
    if not len(system):
        raise FileError(given.path, "there are no particles: choose another frame with --frames", frame)
    return system


def _names(text: str | None, count: int, option: str, least: int | None = None, hint: str = "") -> list[str] | None:
    """Names of `least` to `count` columns; of `count` if `least` is absent. The message ends with `hint`."""
    names = None if text is None else names_of_option(text)
    if names is not None and not (least or count) <= len(names) <= count:
        raise click.UsageError(f"{option} must name {f'{least} to ' if least else ''}{counted(count, 'column')}, not {len(names)}{hint}")
    return names
