# SPDX-License-Identifier: BSD-3-Clause
"""Options for the walls, the fields and the energies of pairs of a simulation."""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple
from collections.abc import Callable, Iterable

import click
import numpy as np

from .._errors import PW85Error
from .._forces import Law
from .._simulations import HardEllipsoids
from .._surroundings import Field, Wall
from ..formats import FileError
from ._input import Numbers


class Surrounding(NamedTuple):
    """A wall, a field or a law of pairs, and how it was given."""

    text: str
    made: Wall | Field | Law


class _Kind(NamedTuple):
    """The numbers of a kind of walls, fields or laws, and what is made of them."""

    form: str
    make: Callable[[list[float]], Wall | Field | Law]

    @property
    def counts(self) -> tuple[int, ...]:
        """The allowed counts of numbers. Numbers in brackets may be left out."""
        most, least = self.form.count(",") + 1, self.form.partition("[")[0].count(",") + 1
        return tuple(range(least, most + 1))


def _aligning(numbers: list[float]) -> Field:
    axis = numbers[4] if len(numbers) > 4 else 2
    if axis not in (0, 1, 2):
        raise ValueError(f"the axis must be 0, 1 or 2, not {axis:g}")
    return Field.aligning(numbers[:3], numbers[3], int(axis))


_WALLS = {
    "plane": _Kind("NX,NY,NZ,OFFSET", lambda n: Wall.plane(n[:3], n[3])),
    "sphere": _Kind("X,Y,Z,RADIUS", lambda n: Wall.sphere(n[:3], n[3])),
    "cylinder": _Kind("X,Y,Z,AX,AY,AZ,RADIUS", lambda n: Wall.cylinder(n[:3], n[3:6], n[6])),
    "box": _Kind("LX,LY,LZ,UX,UY,UZ", lambda n: Wall.box(n[:3], n[3:])),
}
_FIELDS = {
    "linear": _Kind("GX,GY,GZ", Field.linear),
    "weight": _Kind("GX,GY,GZ", Field.weight),
    "harmonic": _Kind("X,Y,Z,KX,KY,KZ", lambda n: Field.harmonic(n[:3], n[3:])),
    "aligning": _Kind("DX,DY,DZ,STRENGTH[,AXIS]", _aligning),
}


class _SurroundingType(click.ParamType):
    """A kind of walls, fields or laws, a colon, and its numbers."""

    name = "surrounding"

    def __init__(self, what: str, kinds: dict[str, _Kind]) -> None:
        self.what, self.kinds = what, kinds

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Surrounding:
        name, _, numbers = value.partition(":")
        kind = self.kinds.get(name)
        if kind is None:
            self.fail(f"a {self.what} must be one of {', '.join(self.kinds)}, as in {self.forms()}, not '{name}'", param, ctx)
        try:
            return Surrounding(value, self.make(kind, numbers, param, ctx))
        except (click.UsageError, ValueError) as error:
            self.fail(f"'{value}': {error}: write {name}:{kind.form}", param, ctx)

    def make(self, kind: _Kind, text: str, param: click.Parameter | None, ctx: click.Context | None) -> Wall | Field | Law:
        """Makes the wall, field or law of the numbers that follow the colon."""
        return kind.make(Numbers(*kind.counts).convert(text, param, ctx).tolist())

    def forms(self) -> str:
        """The words and numbers of all walls, fields or laws, for help and messages."""
        return "; ".join(f"{name}:{kind.form}" for name, kind in self.kinds.items())


class _LawType(_SurroundingType):
    """A table is in a file. The run takes its numbers, and needs the file no more."""

    def make(self, kind: _Kind, text: str, param: click.Parameter | None, ctx: click.Context | None) -> Wall | Field | Law:
        return _read_table(text) if kind is _LAWS["table"] else super().make(kind, text, param, ctx)


def _read_table(name: str) -> Law:
    """A law of the lines μ², U and dU/dμ² of a file. Raises ValueError."""
    try:
        with open(name, encoding="utf-8") as file, warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # of a file without numbers, which is refused below
            rows = np.loadtxt(file, ndmin=2)
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}") from None
    except ValueError:
        rows = np.empty((0, 0))
    if len(rows) < 2 or rows.shape[1] != 3 or not np.isfinite(rows).all():
        raise ValueError(f"{name} must have two lines or more, each of three finite numbers: μ², U and dU/dμ²")
    mu2, u, d_u = rows.T
    even = np.linspace(mu2[0], mu2[-1], len(mu2))
    if not mu2[-1] > mu2[0] or abs(mu2 - even).max() > _UNEVEN * (even[1] - even[0]):
        raise ValueError(f"{name}: μ² must increase by the same step from line to line")
    return Law.table(mu2[0], mu2[-1], u, d_u)


# Of a step: numbers of a table have been rounded to a few digits.
_UNEVEN = 1e-3
_LAWS = {
    "powers": _Kind("A,N,B,M,MU2_MAX", lambda n: Law.inverse_powers(*n)),
    "table": _Kind("FILE", lambda n: Law(0, np.array(n))),
}
WALL, FIELD, LAW = _SurroundingType("wall", _WALLS), _SurroundingType("field", _FIELDS), _LawType("law", _LAWS)


def set_law(path: str, simulation: HardEllipsoids, law: Surrounding) -> None:
    """Sets the energy of pairs. Raises FileError if the simulation of a file cannot have it."""
    try:
        simulation.set_law(law.made)  # type: ignore[arg-type]
    except PW85Error as error:
        raise FileError(path, f"--law {law.text}: {error.detail}") from None


def refuse_idle_fields(path: str, dimensions: int, fields: Iterable[Surrounding]) -> None:
    """Refuses fields in which the energy of a particle never changes."""
    for field in fields:
        made: Any = field.made
        if not any(made.vector[:dimensions]) or made.strength == 0:
            plane = " on particles that stay in a plane z = constant" if any(made.vector) and made.strength else ""
            raise FileError(path, f"--field {field.text}: has no effect{plane}: leave it out, or change its numbers")
        if dimensions == 2 and field.text.startswith("aligning") and made.axis == 2:
            raise FileError(path, f"--field {field.text}: has no effect on ellipses, whose axis 2 is along z: append the AXIS 0 or 1")


_IN_ALL_IMAGES = "must be the same in all images of the cell"


def _in_words_of_options(detail: str, one: Surrounding) -> str:
    """The cause of an error, without the Python object that the user did not write, and with what helps."""
    if detail.startswith(_IN_ALL_IMAGES):
        return f"{_IN_ALL_IMAGES}: change its numbers, or name only the cell vectors along which it does not change (--periodic)"
    return detail.removesuffix(f", not {one.made}")


def surround(path: str, ids: Any, simulation: HardEllipsoids, walls: Iterable[Surrounding], fields: Iterable[Surrounding]) -> None:
    """Sets walls and fields. Raises FileError with the first one that the simulation of a file cannot have."""
    both: list[tuple[str, Iterable[Surrounding], Callable[..., None]]] = [
        ("--wall", walls, lambda walls: simulation._set_walls(walls, ids, rows="")),
        ("--field", fields, lambda fields: simulation._set_fields(fields, rows="")),
    ]
    for option, given, set_all in both:
        for one in given:  # alone, to name it
            try:
                set_all([one.made])
            except PW85Error as error:
                raise FileError(path, f"{option} {one.text}: {_in_words_of_options(error.detail, one)}") from None
        set_all([one.made for one in given])
