# SPDX-License-Identifier: BSD-3-Clause
"""Columns of orientations other than quaternions: the angle of an ellipse, Euler angles, polar angles, directions.

Angles of three dimensions have many meanings: they are refused until an option says theirs.
"""

from __future__ import annotations

import re
from typing import NamedTuple
from collections.abc import Collection, Iterable, Sequence

import numpy as np

from .._rotations import directions_of_polar, quaternions_of_euler
from .._typing import Floats
from .._words import counted
from ._conventions import Convention, Names, sense_in_words, sequence_in_words
from ._errors import Error, for_option
from ._options import Options
from ._table import Table


# In texts in Latin-1, ° is a character that is not read (\ufffd).
_UNITS = re.compile(r"(.*?)(?:[\s_]in(?=[\s_]))?[\s_.,:/(\[-]*(?:(deg|degs|degrees?|°|\ufffd)\.?|(rad|rads|radians?)\.?)?"
                    r"(?:\s|\)|(?<!\d)\])*")  # fmt: skip
# Units of angles that are neither degrees nor radians, at the end of a name
_OTHER_UNITS = re.compile(r".*[\W_](([mcuµμ]|milli|centi|micro|tenths?|pi|x?10+)[\W_]*(deg|rad)\w*|gon|grads?|turns?|rev\w*|"
                          r"arc\w*|m?as|hours?|hrs?|hourangle|pi|rad/pi)\W*", re.IGNORECASE)  # fmt: skip
# The axis about which an angle of this name turns
_AXES = {"yaw": "z", "heading": "z", "azim": "z", "azimuth": "z", "pitch": "y", "elev": "y", "elevation": "y", "roll": "x", "bank": "x"}
_AXES |= {stem + axis: axis for stem in ("rot", "rotation", "angle", "euler", "eulerangle", "theta") for axis in "xyz"}
_TRIPLES: list[Names] = [
    ("phi1", "phi", "phi2"), ("phi", "theta", "psi"), ("alpha", "beta", "gamma"),
    *(tuple(stem + end for end in ends) for stem in ("euler", "eulers", "eulerangle", "eulerangles", "angle", "angles")
      for ends in (("1", "2", "3"), ("0", "1", "2"), ("[1]", "[2]", "[3]"), ("a", "b", "c"))),
]  # fmt: skip
_PAIRS: list[Names] = [("theta", "phi"), ("polar", "azimuth"), ("inclination", "azimuth"), ("elevation", "azimuth"), ("elev", "azim"),
                       ("zenith", "azimuth"), ("colatitude", "azimuth"), ("tilt", "azimuth"), ("polar", "azimuthal"),
                       ("plunge", "trend")]  # fmt: skip
# Components of directions with two digits make lengths of 1 within this.
ROUNDED_DIRECTION = 0.02
# Names of the angle of an ellipse
_OF_ELLIPSES = ("angle", "theta", "phi", "orientation", "rotation", "psi", "alpha")
_DIRECTIONS: list[Names] = [
    *(tuple(stem + end for end in "xyz") for stem in ("u", "n", "director", "dir", "direction", "axis", "orient", "orientation", "e")),
    *(tuple(stem + end for end in "xyz") for stem in ("major", "majoraxis")),
    *(tuple(stem + end for end in ends) for stem in ("director", "direction", "u", "n", "axis", "orientation")
      for ends in (("[1]", "[2]", "[3]"), ("0", "1", "2"), ("1", "2", "3"))),
]  # fmt: skip

_DIRECTION_IN_PLANE = ("{0} may be the direction of the axis a of ellipses: say so (--direction-columns {1}), or leave the "
                       "columns out (--ignore-columns {1})")  # fmt: skip
_TWO_COMPONENTS = ("{0} may be the direction of an axis of ellipses, which needs three components: write a column of zeros for that along "
                   "z (and name all three, --direction-columns), or leave the columns out (--ignore-columns {1})")  # fmt: skip
_TWO_UNITS = "{} may be in degrees or in radians: use --angle degrees or --angle radians"
_SEQUENCES = ("{0} may be Euler angles of several sequences: say which, with fixed axes (--euler zyx) or with axes that rotate with the "
              "body (--euler ZYX), for the angles in this order, or leave the columns out (--ignore-columns {1})")  # fmt: skip
_POLAR = ("{0} may be the angle from the axis z and that about it, or others: say so (--polar and the two columns in this order, as "
          "--polar {1}), or the sequence of Euler angles (--euler), or leave them out (--ignore-columns {1})")  # fmt: skip
_ONE_ANGLE = ("{0} may be the angle of ellipses in a plane, or a rotation in space: say --dimensions 2, or the axis (--euler z), or leave "
              "the column out (--ignore-columns {1})")  # fmt: skip
# Names of angles of ellipses that programs count from y: orientations in pictures, directions from north
_FROM_NORTH = re.compile(r".*(bearing|heading|strike|trend|course|north|dipdir).*")
_FROM_EITHER = re.compile(rf"orientation|direction|{_FROM_NORTH.pattern}|.*(azim|posang|positionangle|vertical|fromy|toy|(?<!c)cw|"
                          r"(?<!counter)clockwise).*|angley|az|.*pa|eor|dir|aspect|"
                          r".*(sky|j2000|b1950|icrs|fk5|world)|tilt|inc|inclination|rake|dip")  # fmt: skip
# Names of functions of angles, of their errors, and of angles of other axes or between bodies
_OTHER_ANGLES = re.compile(r"(half|\d(?!d)|neg|minus|delta|err|std).*|.*minor.*|.*(std|err(or)?|var(iance)?|misorient\w*)|"
                           r"a?(cos|sin|tan)2?(theta|phi|psi|angle|alpha|beta|orientation)?")  # fmt: skip
# Angles from the plane of x and y, in which those from the axis z are 90°
_FROM_PLANE = ("elevation", "elev", "latitude", "lat", "altitude", "alt", "plunge", "pitch", "dip", "declination")
_ELEVATION = ("{0} may be an angle from the plane of x and y, and is not that from the axis z which --polar takes: write 90 degrees less "
              "it in a column of another name, or leave it out (--ignore-columns {1})")  # fmt: skip
_ZERO = ("{} may be counted from the axis x or from y: use --angle-zero x or --angle-zero y (with --angle-sense yx if it grows the other "
         "way than from x towards y)")  # fmt: skip
_BEARING = ("{0} may be counted from north, and is not the angle from the axis x towards y that --polar takes: write 90 degrees less it in "
            "a column of another name, or leave it out (--ignore-columns {1})")  # fmt: skip
# Names of an angle about an axis that others give
_ABOUT_AXES = ("angle", "axisangle", "rotationangle", "rotangle", "theta", "axisw")
_AXIS_AND_ANGLE = ("{0} may be an axis and the angle of a rotation about it, which is not read: write quaternions, or say that the axis is "
                   "that of revolution (--direction-columns {1})")  # fmt: skip


class Turn(NamedTuple):
    """Columns that say how particles are turned. `kind` is "", "angle", "euler", "polar" or "direction"; `units` are those of the columns,
    and `signs` their factors; `zero`, `sense`, `largest` and `is_reversed` are those of `Convention`; of directions that may be angles by
    their names, `largest` is their length."""

    kind: str = ""
    columns: Names = ()
    units: Names = ()
    sequence: str = ""
    signs: tuple[float, ...] = (1.0, 1.0, 1.0)
    zero: str = "x"
    sense: str = "xy"
    largest: float = 0.0
    is_reversed: bool = False

    @property
    def is_of_longest_axis(self) -> bool:
        """Returns whether a direction is that of the longest axis, by its name."""
        return self.kind == "direction" and base(self.columns[0])[0].startswith("major")

    @property
    def may_be_velocity(self) -> bool:
        """Returns whether a direction may be a displacement or a velocity, by its name."""
        return self.kind == "direction" and base(self.columns[0])[0] == "ux"

    def describe(self) -> str:
        if not self.kind:
            return ""
        if self.kind == "direction":
            return f"directions {' '.join(self.columns)} of the axis of revolution"
        units = self.units[:1] if len(set(self.units)) == 1 else self.units
        what = f"{' '.join(self.columns)} in {' '.join(units)}"
        if self.kind == "angle":
            return f"angle {what}, {sense_in_words(self.zero, self.sense)}"
        if self.kind == "polar":
            return f"angles {what} from z, and about it from x"
        turned = [name for name, sign in zip(self.columns, self.signs) if sign < 0]
        changed = f", {' '.join(turned)} with its sign changed" if turned else ""
        return f"angles {what}, sequence {sequence_in_words(self.sequence)}{changed}"

    def radians(self, table: Table) -> Floats:
        columns = table.stack(self.columns)
        return columns * [sign * (np.pi / 180 if unit == "degrees" else 1.0) for sign, unit in zip(self.signs, self.units)]

    def angles(self, table: Table) -> Floats:
        """Of ellipses, from x towards y."""
        values = self.radians(table)[:, 0]
        values = values if self.sense == "xy" else -values
        return values if self.zero == "x" else values + 0.5 * np.pi

    def quaternions(self, table: Table) -> Floats:
        return quaternions_of_euler(self.sequence, self.radians(table))

    def directions(self, table: Table) -> Floats:
        return table.stack(self.columns) if self.kind == "direction" else directions_of_polar(*self.radians(table).T)


def by_convention(convention: Convention, names: Names, options: Options) -> Turn:
    if not names:
        return Turn()
    units = tuple(options.angle or base(name)[1] or convention.unit for name in names)
    largest = convention.largest if set(units) == {convention.unit} and not options.angle else 0.0
    if convention.sequence:
        return Turn("euler", names, units, options.euler or convention.sequence, convention.signs, largest=largest)
    zero, sense = options.angle_zero or convention.zero, options.angle_sense or convention.sense
    return Turn("angle", names, units, zero=zero, sense=sense, largest=largest,
                is_reversed=convention.is_reversed and not options.angle_sense)


def find(columns: Sequence[str], options: Options, error: Error, is_flat: bool, has_quaternions: bool) -> Turn:
    """Finds how the particles are turned, by the names of the columns and the options."""
    if options.direction_columns:
        return Turn("direction", _given(columns, options.direction_columns, error))
    if options.polar:
        names = _given(columns, options.polar, error)
        _refuse_geographic(names, error)
        return Turn("polar", names, _units_of(names, options, error))
    if options.euler:
        return _euler(columns, options.euler, options, error)
    if has_quaternions:
        return Turn()
    return _of_ellipses(columns, options, error) if is_flat else _of_bodies(columns, options, error)


def base(name: str) -> tuple[str, str]:
    """The name of an angle without its unit, and the unit: "degrees", "radians" or ""."""
    found = _UNITS.fullmatch(name.lower())
    if found is None:
        return name.lower(), ""
    plain = re.sub(r"[\s_.:/\-]", "", found[1])
    return plain, "degrees" if found[2] else "radians" if found[3] else ""


def is_other_unit(name: str, turn: Turn) -> bool:
    """Returns whether a column is the angle that was read, in the other unit: both names say their unit."""
    plain, unit = base(name)
    taken = base(turn.columns[0]) if turn.kind == "angle" else ("", "")
    return plain == taken[0] and {unit, taken[1]} == {"degrees", "radians"}


def _of_ellipses(columns: Sequence[str], options: Options, error: Error) -> Turn:
    found = {key: name for key, name in _bases(columns, _OF_ELLIPSES).items() if name not in _triple(columns)}
    if options.angle_columns:
        found = {name: name for name in _given(columns, options.angle_columns, error)}
    if not found:
        if names := _first(columns, [one for one in _DIRECTIONS if one[0].endswith("x")]):
            raise error(_DIRECTION_IN_PLANE.format(" ".join(names), for_option(names)))
        if names := _first(columns, [one[:2] for one in _DIRECTIONS if one[0].endswith("x")]):
            raise error(_TWO_COMPONENTS.format(" ".join(names), for_option(names)))
        return Turn()
    # A table may have the same angle in both units; the one that says its unit decides.
    first = next(iter(found))
    same = [name for name in columns if base(name)[0] == base(found[first])[0]]
    name = min(same, key=lambda one: (base(one)[1] != "degrees", base(one)[1] != "radians")) if not options.angle_columns else found[first]
    # Beside XStdDist and YStdDist, the column Rotation of ArcGIS is counted clockwise from north.
    is_of_arcgis = base(name)[0] == "rotation" and any("stddist" in base(one)[0] for one in (*columns, *(options.shape_columns or ())))
    if (is_of_arcgis or _FROM_EITHER.fullmatch(base(name)[0])) and options.angle_zero is None:
        raise error(_ZERO.format(name))
    return Turn("angle", (name,), _units_of((name,), options, error), zero=options.angle_zero or "x", sense=options.angle_sense or "xy")


def _of_bodies(columns: Sequence[str], options: Options, error: Error) -> Turn:
    if names := _triple(columns):
        raise error(_SEQUENCES.format(" ".join(names), for_option(names)))
    if names := _first(columns, _PAIRS):
        _refuse_geographic(names, error)
        raise error(_POLAR.format(" ".join(names), for_option(names)))
    if names := _first(columns, _DIRECTIONS):
        if base(names[0])[0].startswith("axis") and (angles := _bases(columns, _ABOUT_AXES)):
            raise error(_AXIS_AND_ANGLE.format(" ".join((*names, *angles.values())), for_option(names)))
        # Three numbered columns u or n may be displacements, exponents or counts, too.
        is_unit = re.match(r"orient|[un]\W?\d", base(names[0])[0]) is not None
        return Turn("direction", names, largest=1.0 if is_unit else 0.0)
    if found := _bases(columns, (*_OF_ELLIPSES, *_AXES)):
        names = tuple(found.values())
        raise error((_ONE_ANGLE if len(names) == 1 else _SEQUENCES).format(" ".join(names), for_option(names)))
    return Turn()


def _refuse_geographic(names: Names, error: Error) -> None:
    if base(names[0])[0] in _FROM_PLANE:
        raise error(_ELEVATION.format(names[0], for_option(names)))
    if _FROM_NORTH.fullmatch(base(names[1])[0]):
        raise error(_BEARING.format(names[1], for_option(names)))


def _euler(columns: Sequence[str], sequence: str, options: Options, error: Error) -> Turn:
    if options.angle_columns:
        names = _given(columns, options.angle_columns, error)
    else:
        names = _by_axis(columns, sequence) or _triple(columns) or tuple(_bases(columns, (*_OF_ELLIPSES, *_AXES)).values())
    if len(names) != len(sequence):
        found = f"only {' '.join(names)} look like angles" if names else "no column looks like an angle"
        raise error(f"--euler {sequence} needs {counted(len(sequence), 'column')} of angles, and {found}: name them in the order of "
                    f"{sequence} (--angle-columns)")  # fmt: skip
    if not options.angle_columns and len(names) == 3 and any(base(one)[0] in _AXES for one in names) and not _by_axis(columns, sequence):
        raise error(f"{' '.join(names)} are named by axes, which are not those of --euler {sequence}: name them in its order "
                    "(--angle-columns)")  # fmt: skip
    return Turn("euler", names, _units_of(names, options, error), sequence)


def _by_axis(columns: Sequence[str], sequence: str) -> Names:
    """Columns that are named by the axes of the sequence."""
    found = {_AXES[base(name)[0]]: name for name in reversed(columns) if base(name)[0] in _AXES}
    axes = sequence.lower()
    return tuple(found[axis] for axis in axes) if len(set(axes)) == len(axes) and set(axes) <= found.keys() else ()


def _triple(columns: Sequence[str]) -> Names:
    if names := _first(columns, _TRIPLES):
        return names
    found = [name for name in columns if base(name)[0] in _AXES]
    return tuple(found) if len({_AXES[base(name)[0]] for name in found}) == len(found) == 3 else ()


def _first(columns: Iterable[str], wanted: list[Names]) -> Names:
    found = {base(name)[0]: name for name in reversed(list(columns))}
    there = (names for names in wanted if set(names) <= found.keys() and not is_continued(names, found))
    return next((tuple(found[name] for name in names) for names in there), ())


def is_continued(names: Names, there: Collection[str]) -> bool:
    """Returns whether NAME[1] and so on are only the first components of a property, such as three of the six of a matrix."""
    last = f"[{len(names)}]"
    return names[-1].endswith(last) and f"{names[-1].removesuffix(last)}[{len(names) + 1}]" in there


def _bases(columns: Sequence[str], wanted: Sequence[str]) -> dict[str, str]:
    found = {base(name)[0]: name for name in reversed(columns)}
    return {name: found[name] for name in wanted if name in found}


def _units_of(names: Names, options: Options, error: Error) -> Names:
    check_units(names, error)
    units = tuple(options.angle or base(name)[1] for name in names)
    if unknown := [name for name, unit in zip(names, units) if not unit]:
        raise error(_TWO_UNITS.format(" ".join(unknown)))
    return units


def check_units(names: Iterable[str], error: Error) -> None:
    for name in names:
        if _OTHER_ANGLES.fullmatch(base(name)[0]):
            raise error(f"the name of the column '{name}' says another quantity than the angle of the axis a: convert it, and rename it")
        if _OTHER_UNITS.fullmatch(name):
            raise error(f"{name} has another unit than degrees and radians by its name: convert it, and rename the column")


def _given(columns: Sequence[str], names: Sequence[str], error: Error) -> Names:
    for name in names:
        if name not in columns:
            raise error(f"there is no column '{name}', but {' '.join(columns)}: name one of these")
    return tuple(names)
