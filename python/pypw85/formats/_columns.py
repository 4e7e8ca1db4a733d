# SPDX-License-Identifier: BSD-3-Clause
"""What the columns of other programs mean: which hold shapes and quaternions, in which order, as semi-axes or as diameters.

One table for dumps, extended XYZ and CSV. Names are compared without capitals, blanks, dots, hyphens and underscores. A property
of several columns has the names NAME[1], NAME[2] and so on, as in a dump.
"""

from __future__ import annotations

import re
from typing import NamedTuple
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from .._typing import Floats
from ._errors import FileError
from ._frames import Frame, Options
from ._table import Table

Names = tuple[str, ...]
Error = Callable[[str], FileError]

_XYZ, _INDEX, _FROM_1, _FROM_0 = ("x", "y", "z"), ("[1]", "[2]", "[3]"), ("1", "2", "3"), ("0", "1", "2")
_ASK = ""  # Two programs mean different things.
# Stems of names of lengths, their ends, and what they are
_LENGTHS: list[tuple[str, list[Names], str]] = [
    ("shape", [_XYZ], "diameters"),
    ("asphericalshape", [_XYZ, _INDEX], "radii"),
    ("semiaxes|semiaxis|halfaxes|halfaxis", [_XYZ, _INDEX, _FROM_1, _FROM_0, ("a", "b", "c")], "radii"),
    ("radius|radii", [_XYZ, _INDEX, _FROM_1, _FROM_0], "radii"),
    ("r", [_XYZ, _FROM_1], "radii"),
    ("diameter|diameters", [_XYZ, _INDEX, _FROM_1, _FROM_0], "diameters"),
    ("axislengths", [_INDEX, _FROM_0], "radii"),
    (r"c\w*(?:shape|diam)\w*", [_INDEX, _FROM_1], "diameters"),
    ("", [("a", "b", "c")], "radii"),
]
# The same of ellipses, which have two. The axes of an ellipse may be whole or half.
_LENGTHS_OF_ELLIPSES: list[tuple[str, list[Names], str]] = [
    *((stems, [one[:2] for one in ends], meaning) for stems, ends, meaning in _LENGTHS),
    ("semi", [("major", "minor"), ("majoraxis", "minoraxis")], "radii"),
    ("", [("major", "minor"), ("majoraxis", "minoraxis")], _ASK),
]
_LETTERS: list[Names] = [("w", "x", "y", "z"), ("w", "i", "j", "k")]
_QUADRUPLE = ("[1]", "[2]", "[3]", "[4]")
_QUATERNIONS: list[tuple[str, list[Names], str]] = [
    ("quat|q|quaternion|quaternions|quats|orientation|orient", _LETTERS, "wxyz"),
    ("orientation", [_QUADRUPLE], "xyzw"),
    ("quat", [("1", "2", "3", "4")], "wxyz"),
    ("q|quat|quaternion", [("0", "1", "2", "3")], "wxyz"),
    ("quat|quats|quaternion|quaternions", [_QUADRUPLE], "wxyz"),
    (r"c\w*orient\w*", [_QUADRUPLE], _ASK),
    (r"cq|c\w*quat\w*", [_QUADRUPLE], "wxyz"),
    (r"c\w*shape\w*", [("[4]", "[5]", "[6]", "[7]")], "wxyz"),
]
# The angle of an ellipse, and its unit
_ANGLE = re.compile(r"(?:angle|theta)[\s_.:/(\[-]*(?:(deg|degs|degrees?|°)|(rad|rads|radians?))?[\s)\]]*")
_EULER = ("axiseulerangles0", "axiseulerangles1", "axiseulerangles2")
_SPHERES = {"radius": "radii", "r": "radii", "diameter": "diameters"}
# Exponents of superquadrics, and the values with which these are ellipsoids. OVITO's are inverse, and 0 means 1 there.
_EXPONENTS: list[tuple[str, tuple[float, ...]]] = [
    ("blockiness1", (2.0,)), ("blockiness2", (2.0,)), ("block1", (2.0,)), ("block2", (2.0,)),
    ("superquadricroundnessphi", (0.0, 1.0)), ("superquadricroundnesstheta", (0.0, 1.0)),
    ("superquadricroundness[1]", (0.0, 1.0)), ("superquadricroundness[2]", (0.0, 1.0)),
]  # fmt: skip
_SHAPE_OF_SMD = ("{} may be lengths of property/atom, which are diameters, or of smd/tlsph/shape, which are radii: say which "
                 "(--lengths diameters or --lengths radii)")  # fmt: skip
_TWO_ORDERS = ("{} is x y z w for OVITO and moltemplate, and w x y z for others: say which (--quaternion xyzw or --quaternion wxyz), "
               "or name the four columns in the order w x y z (--quaternion-columns)")  # fmt: skip


_TWO_UNITS = "{} may be in degrees or in radians: say which (--angle degrees or --angle radians)"
_WHOLE_OR_HALF = "{} may be whole axes or semi-axes: say which (--lengths diameters or --lengths radii)"


class Taken(NamedTuple):
    """What is taken of a table. `euler` are Bunge's angles in radians; `sphere` is the size of particles whose lengths are all 0; `angle`
    is that of ellipses, in `unit`."""

    shape: Names
    lengths: str
    quaternion: Names
    order: str
    euler: Names
    sphere: Names
    exponents: list[tuple[str, tuple[float, ...]]]
    source: str
    notes: list[str]
    angle: Names
    unit: str

    @property
    def columns(self) -> Iterator[str]:
        yield from (*self.shape, *self.quaternion, *self.euler, *self.sphere, *(name for name, _ in self.exponents), *self.angle)


def plain_name(name: str) -> str:
    """A name without its unit in brackets, capitals, blanks, dots, hyphens and underscores."""
    without_unit = re.sub(r"\([^)]*\)|\[(?!\d+\])[^]]*\]", "", name.lower())
    return re.sub(r"[\s_.:/\-]", "", without_unit)


def take(columns: Sequence[str], options: Options, error: Error, lengths: str, order: str) -> Taken:
    """The columns that hold shapes and quaternions. `lengths` and `order` are those of columns that options name."""
    plain = {plain_name(name): name for name in reversed(columns)}
    shape, lengths = _shape(columns, plain, options, error, lengths)
    quaternion, order = _quaternion(columns, plain, options, error, order)
    angle, unit = ((), "") if quaternion else _angle(columns, options, error)
    euler = tuple(plain[name] for name in _EULER) if not quaternion and set(_EULER) <= plain.keys() else ()
    sphere: Names = next(((plain[name],) for name in _SPHERES if name in plain), ())
    exponents = [(plain[name], values) for name, values in _EXPONENTS if name in plain]
    if not shape and sphere and quaternion and options.shape is None:
        raise error(f"there are quaternions, but no shapes: {sphere[0]} may be that of the circumscribed sphere, as in LAMMPS since "
                    f"2026: write shapes, name their columns (--shape-columns {','.join(3 * sphere)} for spheres), or give one "
                    "shape for all particles (--shape)")  # fmt: skip
    if not shape and sphere:
        if not quaternion:
            shape, lengths = sphere, options.lengths or _SPHERES[plain_name(sphere[0])]
        sphere = ()
    notes = []
    if is_liggghts(plain) and not exponents:
        notes.append("there are no columns blockiness1 and blockiness2: superquadrics of LIGGGHTS are taken as ellipsoids")
    source = describe(shape, lengths, quaternion or euler, "Bunge's angles" if euler else order, sphere)
    source = ", ".join(filter(None, [source, f"{angle[0]} in {unit}" if angle else ""]))
    return Taken(shape, lengths, quaternion, order, () if angle else euler, sphere, exponents, source, notes, angle, unit)


def fill(frame: Frame, taken: Taken, table: Table) -> None:
    """Gives a frame its shapes and quaternions, unless it has shapes of another kind than ellipsoids."""
    for name, values in taken.exponents:
        wrong = ~np.isin(table[name], values)
        if wrong.any():
            raise frame.error(f"is no ellipsoid, but a superquadric with {name} {table[name][wrong][0]:g}: only ellipsoids can be checked",
                              int(wrong.argmax()))  # fmt: skip
    if taken.shape:
        frame.shapes = table.stack(3 * taken.shape if len(taken.shape) == 1 else taken.shape)
    if taken.quaternion:
        frame.quaternions = table.stack(taken.quaternion)
    if taken.euler:
        frame.quaternions = _from_bunge(table.stack(taken.euler))
    if taken.angle:
        frame.angles = np.radians(table[taken.angle[0]]) if taken.unit == "degrees" else table[taken.angle[0]]
    if taken.sphere:
        frame.sizes = (0.5 if _SPHERES[plain_name(taken.sphere[0])] == "diameters" else 1.0) * table[taken.sphere[0]]
    frame.lengths, frame.order, frame.source = taken.lengths, taken.order, taken.source
    frame.notes += taken.notes


def _angle(columns: Sequence[str], options: Options, error: Error) -> tuple[Names, str]:
    """The column with the angles of ellipses, and their unit."""
    found = {name: match for name in columns if (match := _ANGLE.fullmatch(name.lower()))}
    if not found:
        return (), ""
    # A table may have both; the one that says its unit decides
    name = min(found, key=lambda one: (not found[one][2], not found[one][1]))
    unit = options.angle or ("radians" if found[name][2] else "degrees" if found[name][1] else _ASK)
    if unit == _ASK:
        raise error(_TWO_UNITS.format(name))
    return (name,), unit


def _from_bunge(angles: Floats) -> Floats:
    """Quaternions w x y z of rotations about z by the first angle, then about the new x, then about the new z."""
    first, tilt, last = 0.5 * angles.T
    c, s = np.cos(tilt), np.sin(tilt)
    return np.stack([c * np.cos(first + last), s * np.cos(first - last), s * np.sin(first - last), c * np.sin(first + last)], axis=1)


def is_liggghts(plain: dict[str, str]) -> bool:
    return {"quat1", "quat2", "quat3", "quat4"} <= plain.keys() or "blockiness1" in plain


def _shape(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, lengths: str) -> tuple[Names, str]:
    given = _given(columns, options.shape_columns, error)
    names = {plain_name(name): name for name in given} if given else plain
    found, meaning = _first(_LENGTHS, names)
    if not found and not plain.keys() & _SPHERES.keys():
        found, meaning = _first(_LENGTHS_OF_ELLIPSES, names)
    if given and set(given) <= {plain.get(name) for name in _SPHERES}:
        found, meaning = given, _SPHERES[plain_name(given[0])]
    if given and found != given:
        found, meaning = given, lengths
    if found and meaning == "diameters" and plain_name(found[0]).startswith("shape") and is_liggghts(plain):
        meaning = "radii"
    stem = plain_name(found[0])[:-3] if found else ""
    if re.fullmatch(r"c\w*shape\w*", stem) and f"{stem}[4]" in plain:
        meaning = _ASK
    if meaning == _ASK and found and options.lengths is None:
        raise error((_WHOLE_OR_HALF if len(found) == 2 else _SHAPE_OF_SMD).format(_short(found)))
    return found, options.lengths or (meaning if found else lengths)


def _quaternion(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, order: str) -> tuple[Names, str]:
    given = _given(columns, options.quaternion_columns, error)
    found, meaning = _first(_QUATERNIONS, {plain_name(name): name for name in given} if given else plain)
    if given and found != given:
        # The letters of the names say the order; otherwise it is that of the option
        is_scalar_last = bool(found) and meaning == "wxyz" and given[-1:] + given[:-1] == found
        found, meaning = given, "xyzw" if is_scalar_last and not found[0].endswith("]") else order
    if meaning == _ASK and found and options.quaternion is None:
        raise error(_TWO_ORDERS.format(_short(found)))
    if options.quaternion is not None and not given:  # of the columns as they stand in the file
        found = tuple(sorted(found, key=list(columns).index))
    return found, options.quaternion or (meaning if found else order)


def _given(columns: Sequence[str], names: Sequence[str] | None, error: Error) -> Names:
    """The columns that an option names."""
    for name in names or ():
        if name not in columns:
            raise error(f"there is no column '{name}', but {' '.join(columns)}")
    return tuple(names or ())


def _first(table: list[tuple[str, list[Names], str]], plain: dict[str, str]) -> tuple[Names, str]:
    """The first columns that a row of a table describes, and their meaning."""
    for stems, ends, meaning in table:
        for end in ends:
            for name in plain:
                stem = name.removesuffix(end[0])
                if stem + end[0] == name and re.fullmatch(stems, stem) and {stem + one for one in end} <= plain.keys():
                    return tuple(plain[stem + one] for one in end), meaning
    return (), _ASK


def describe(shape: Sequence[str], lengths: str, quaternion: Sequence[str], order: str, sphere: Sequence[str] = ()) -> str:
    """What was taken, in words."""
    parts = [f"lengths {_short(shape)} as {lengths}"] if shape else []
    parts += [f"{sphere[0]} where these are 0"] if sphere and shape else []
    parts += [f"quaternions {_short(quaternion)} as {' '.join(order) if order.islower() else order}"] if quaternion else []
    return ", ".join(parts)


def _short(names: Sequence[str]) -> str:
    """c_q[1..4] for c_q[1] to c_q[4]."""
    first, last = (re.fullmatch(r"(.*)\[(\d+)\]", name) for name in (names[0], names[-1]))
    if len(names) > 1 and first and last and first[1] == last[1] and int(last[2]) - int(first[2]) == len(names) - 1:
        return f"{first[1]}[{first[2]}..{last[2]}]"
    return " ".join(names)
