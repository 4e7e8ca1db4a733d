# SPDX-License-Identifier: BSD-3-Clause
"""Options for the walls and fields of a simulation."""

from __future__ import annotations

from typing import Any, NamedTuple
from collections.abc import Callable, Iterable

import click

from .._errors import PW85Error
from .._simulations import HardEllipsoids
from .._surroundings import Field, Wall
from ..formats import FileError
from ._input import Numbers


class Surrounding(NamedTuple):
    """A wall or a field, and how it was given."""

    text: str
    made: Wall | Field


class _Kind(NamedTuple):
    """The numbers of a kind of walls or fields, and what is made of them."""

    form: str
    make: Callable[[list[float]], Wall | Field]

    @property
    def counts(self) -> tuple[int, ...]:
        """How many numbers there may be. What stands between brackets may be left out."""
        most, least = self.form.count(",") + 1, self.form.partition("[")[0].count(",") + 1
        return tuple(range(least, most + 1))


def _aligning(numbers: list[float]) -> Field:
    axis = numbers[4] if len(numbers) > 4 else 2
    if axis not in (0, 1, 2):
        raise ValueError(f"{axis:g} is no axis, which is 0, 1 or 2")
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
    """A kind of walls or fields, a colon, and its numbers."""

    name = "surrounding"

    def __init__(self, what: str, kinds: dict[str, _Kind]) -> None:
        self.what, self.kinds = what, kinds

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Surrounding:
        name, _, numbers = value.partition(":")
        kind = self.kinds.get(name)
        if kind is None:
            self.fail(f"'{name}' is no {self.what}: name one of {', '.join(self.kinds)}, as in {self.forms()}", param, ctx)
        try:
            return Surrounding(value, kind.make(Numbers(*kind.counts).convert(numbers, param, ctx).tolist()))
        except (click.UsageError, ValueError) as error:
            self.fail(f"'{value}': {error}: write {name}:{kind.form}", param, ctx)

    def forms(self) -> str:
        """How each kind is written."""
        return "; ".join(f"{name}:{kind.form}" for name, kind in self.kinds.items())


WALL, FIELD = _SurroundingType("wall", _WALLS), _SurroundingType("field", _FIELDS)


def surround(path: str, ids: Any, simulation: HardEllipsoids, walls: Iterable[Surrounding], fields: Iterable[Surrounding]) -> None:
    """Sets walls and fields. Raises FileError with the first one that the simulation of a file cannot have."""
    both: list[tuple[str, Iterable[Surrounding], Callable[..., None]]] = [
        ("--wall", walls, simulation.set_walls),
        ("--field", fields, simulation.set_fields),
    ]
    for option, given, set_all in both:
        for one in given:  # alone, to name it
            try:
                set_all([one.made])
            except PW85Error as error:
                particle = simulation._replace_walls([one.made])[1] if isinstance(one.made, Wall) else -1
                reason = error.detail if particle < 0 else f"it cuts particle {ids[particle]}: move one of them"
                raise FileError(path, f"{option} {one.text}: {reason}") from None
        set_all([one.made for one in given])
