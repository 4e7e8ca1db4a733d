# SPDX-License-Identifier: BSD-3-Clause
"""Columns that could change bodies and are not used: they are refused."""

from __future__ import annotations

import re
from collections.abc import Sequence

from . import _turns
from ._column_names import DERIVED, OTHERS, SIZES, matches, plain_name, sounds_like_turn
from ._conventions import Convention, is_harmless
from ._doubts import Doubt, doubts_of, second_quaternions
from ._errors import Error, for_option
from ._options import Options
from ._taken import Taken


_COMPONENTS = {f"q{k}" for k in range(5)}

_UNUSED = ("the column {0} could change the shapes or how they are turned, and is not used: say what it is ({1}), or leave it out "
           "(--ignore-columns {2})")  # fmt: skip
_SEVERAL_UNUSED = ("the columns {0} could change the shapes or how they are turned, and are not used: say what they are ({1}), or leave "
                   "them out (--ignore-columns {2})")  # fmt: skip


def check_unused(columns: Sequence[str], taken: Taken, known: Sequence[str], options: Options, error: Error, is_flat: bool,
                  convention: Convention | None) -> list[Doubt]:  # fmt: skip
    """Refuses columns that could change bodies and are not used. Returns those whose values must say that they could not."""
    used = {*known, *taken.columns}
    has_all = len(taken.shape) > 1
    names_turns = options.quaternion_columns or options.angle_columns or options.polar or options.direction_columns
    says_sizes = options.shape_columns or (not taken.shape and (options.shape is not None or options.shapes))
    exponents = _possible_exponents(columns, len(taken.shape))
    found: dict[str, tuple[bool, bool]] = {}  # names, and whether these are of lengths and of turns
    for name in columns:
        plain = plain_name(name)
        if name in used or matches(OTHERS, name) or (convention is not None and is_harmless(convention, plain)):
            continue
        if _turns.is_other_unit(name, taken.turn) or (has_all and not taken.spheroid and matches(DERIVED, name)):
            continue
        if re.fullmatch("q[0-4]", plain) and len({plain_name(one) for one in columns} & _COMPONENTS) < 3:
            continue  # of bond order, as q4 beside q6: an orientation has three components or more
        is_size, is_turn = matches(SIZES, name) or name.lower() in exponents, sounds_like_turn(name)
        if (is_size and not says_sizes) or (is_turn and not names_turns):
            found[name] = is_size, is_turn
    doubts = doubts_of([*found], columns)
    lengths = [name for name, (is_size, _) in found.items() if is_size]
    doubts += second_quaternions(columns, [*used, *lengths]) if taken.quaternion else []
    found = {name: what for name, what in found.items() if not any(name in doubt.names for doubt in doubts)}
    if found:
        sizes, turns = map(any, zip(*found.values()))
        how_turned = "--angle-columns" if is_flat else "--quaternion-columns, --euler, --polar or --direction-columns"
        how = ", ".join(["--shape-columns"] * sizes + [how_turned] * turns)
        raise error((_UNUSED if len(found) == 1 else _SEVERAL_UNUSED).format(" ".join(found), how, for_option(found)))
    return doubts


def _possible_exponents(columns: Sequence[str], lengths: int) -> set[str]:
    """Letters that may be exponents of superquadrics: m beside n, as in MFIX, and n or p beside three lengths. A first column of that name
    numbers the rows."""
    names = [*map(str.lower, columns)]
    pair = {"m", "n"} if {"m", "n"} <= {*names} else set[str]()
    return pair | ({"n", "p"} - {names[0]} if lengths == 3 else set[str]())
