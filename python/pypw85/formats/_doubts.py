# SPDX-License-Identifier: BSD-3-Clause
"""Columns whose names could be those of a shape or a turn, and whose values may say that they are neither."""

from __future__ import annotations

import re
from typing import NamedTuple
from collections.abc import Sequence

import numpy as np

from .._typing import Floats
from ._column_names import matches, plain_name
from ._conventions import Names
from ._errors import for_option
from ._frames import Frame
from ._table import Table
from ._turns import ROUNDED_DIRECTION

# Components of quaternions with two digits make lengths of 1 within this.
_ROUNDED_QUATERNION = 0.01
# Quaternions with three digits that mean one rotation have a scalar product of ±1 within this.
_SAME = 1e-2
# The confidence of a detection differs between bodies, and the level of ellipsoids of errors does not.
_CONFIDENCE = re.compile(r"conf(idence)?")
# Stems of components along x, y and z: directions or displacements, velocities and fields, and those that may be lengths, too, which
# are not negative
_DIRECTIONS, _LENGTHS = ("u", "n", "e"), ("a", "b", "d", "h", "l")
# Names that say orientations, and those that may
_OF_TURNS, _OF_QUATERNIONS = re.compile(r".*(quat|orient|rot).*"), re.compile(r".*(q|quat\w*|orient\w*|rot\w*)")

_SENTENCES = {
    "level": "{values} in all rows, as a level of confidence is",
    "charge": "it has only positive values, as a ratio of axes or an exponent has",
    "velocity": "most rows have the length 1, as directions have",
    "lengths": "they may be lengths or directions",
    "quaternion": "they may be a quaternion other than the one that is taken",
}


class Doubt(NamedTuple):
    """Columns and what they may be: the "level" of confidence, a "charge", a "velocity", "lengths" or a "quaternion"."""

    names: Names
    kind: str


def doubts_of(unused: Sequence[str], columns: Sequence[str]) -> list[Doubt]:
    """Of columns that could change bodies by their names, those whose values may say otherwise."""
    plain = {plain_name(name): name for name in reversed(columns)}
    found = [Doubt((name,), "level") for name in unused if matches(_CONFIDENCE, name)]
    found += [Doubt((name,), "charge") for name in unused if plain_name(name) == "q"]
    for stems, kind in ((_DIRECTIONS, "velocity"), (_LENGTHS, "lengths")):
        for names in (tuple(plain.get(stem + axis, "") for axis in "xyz") for stem in stems):
            if all(names[:2]):
                found.append(Doubt(tuple(filter(None, names)), kind))
    if {"u", "v", "w"} <= plain.keys():
        found.append(Doubt((plain["u"], plain["v"], plain["w"]), "velocity"))
    return [one for one in found if {*one.names} & {*unused}]


def second_quaternions(columns: Sequence[str], used: Sequence[str]) -> list[Doubt]:
    """Properties of exactly four columns that are not used, which may be quaternions."""
    stems = dict.fromkeys(name.removesuffix("[1]") for name in columns if name.endswith("[1]"))
    found = [tuple(f"{stem}[{k}]" for k in range(1, 6)) for stem in stems]
    return [Doubt(names[:4], "quaternion") for names in found
            if {*names[:4]} <= {*columns} and names[4] not in columns and not {*names[:4]} & {*used}]  # fmt: skip


def check_doubts(frame: Frame, doubts: Sequence[Doubt], table: Table) -> None:
    """Refuses columns whose values are those of a shape or a turn."""
    for names, kind in doubts:
        values = table.stack(names)
        with np.errstate(over="ignore", invalid="ignore"):
            if not len(values) or not _is_possible(names, kind, values, frame):
                continue
        what, verb, pronoun = ("column", "is", "it is") if len(names) == 1 else ("columns", "are", "they are")
        reason = _SENTENCES[kind].format(values=f"it is {values[0, 0]:g}")
        raise frame.error(f"the {what} {' '.join(names)} could change the shapes or how they are turned, because {reason}, and {verb} not "
                          f"used: say what {pronoun} (--shape-columns, --quaternion-columns or --direction-columns), or leave "
                          f"{'it' if len(names) == 1 else 'them'} out (--ignore-columns {for_option(names)})")  # fmt: skip


def _is_possible(names: Names, kind: str, values: Floats, frame: Frame) -> bool:
    """Returns whether the values may be what a doubt says."""
    if kind == "level":
        return bool((values == values[0]).all())
    if kind == "charge":
        return bool((values > 0).all())
    norms = np.linalg.norm(values, axis=1)
    if kind == "quaternion":
        return _is_other_quaternion(names, values, norms, frame)
    are_directions = 2 * int((np.abs(norms - 1) < ROUNDED_DIRECTION).sum()) >= max(int((norms > 0).sum()), 1)
    return are_directions or (kind == "lengths" and bool((values >= 0).all() and values.any()))


def _is_other_quaternion(names: Names, values: Floats, norms: Floats, frame: Frame) -> bool:
    """Returns whether these may be quaternions of other orientations than those taken. Four numbers of which one is 1, and the others 0,
    may be counts or flags, unless the name says otherwise."""
    name = names[0].removesuffix("[1]")
    if frame.quaternions is None or not (np.abs(norms - 1) < _ROUNDED_QUATERNION).all():
        return matches(_OF_TURNS, name)
    are_plain = bool(np.isin(np.abs(values), (0, 1)).all())
    if are_plain and not matches(_OF_QUATERNIONS, name):
        return False
    taken = frame.quaternions if frame.order == "wxyz" else np.roll(frame.quaternions, 1, axis=1)
    lengths = np.linalg.norm(taken, axis=1)  # 0 for spheres
    # Quaternions that are equal if w is the last number have this order, unless all numbers are 0 or 1.
    orders = [values] if are_plain else [values, np.roll(values, 1, axis=1)]
    return not any((np.abs(np.sum(taken * one, axis=1)) >= (1 - _SAME) * lengths).all() for one in orders)
