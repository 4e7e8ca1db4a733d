# SPDX-License-Identifier: BSD-3-Clause
"""Values of the columns of other programs: shapes and turns of the bodies of a frame, and checks of what the columns cannot hold."""

from __future__ import annotations

import numpy as np

from .._typing import Floats
from ._column_names import SPHERES, plain_name
from ._doubts import check_doubts
from ._frames import Frame
from ._table import Table
from ._taken import Taken
from ._turns import ROUNDED_DIRECTION, Turn


def fill(frame: Frame, taken: Taken, table: Table) -> None:
    """Gives a frame its shapes and quaternions, unless it has shapes of another kind than ellipsoids."""
    for name, values in taken.exponents:
        wrong = ~np.isin(table[name], values)
        if wrong.any():
            raise frame.error(f"is not an ellipsoid, but a superquadric with {name} {table[name][wrong][0]:g}: only ellipsoids are checked",
                              int(wrong.argmax()))  # fmt: skip
    if taken.spheroid:
        frame.shapes = _spheroids(taken, table)
    elif taken.shape:
        frame.shapes = table.stack(3 * taken.shape if len(taken.shape) == 1 else taken.shape)
    if taken.quaternion:
        frame.quaternions = table.stack(taken.quaternion)
    if taken.sphere:
        frame.sizes = (0.5 if SPHERES[plain_name(taken.sphere[0])] == "diameters" else 1.0) * table[taken.sphere[0]]
    frame.lengths, frame.order, frame.source, frame.has_columns = taken.lengths, taken.order, taken.source, True
    frame.notes += taken.notes
    _turn(frame, taken.turn, table)
    check_doubts(frame, taken.doubts, table)


def _turn(frame: Frame, turn: Turn, table: Table) -> None:
    _check_angles(frame, turn, table)
    if turn.kind == "direction" and turn.largest:
        _check_directions(frame, turn, table)
    if turn.kind == "angle":
        if turn.is_reversed:
            _check_eighths(frame, turn, table)
        frame.angles = turn.angles(table)
    elif turn.kind:
        for name in turn.columns:
            wrong = ~np.isfinite(table[name])
            if wrong.any():
                raise frame.error(f"has a {name} that is not finite: correct it", int(wrong.argmax()))
        if turn.kind == "euler":
            frame.quaternions, frame.order = turn.quaternions(table), "wxyz"
        else:
            frame.directions, frame.are_longest = turn.directions(table), turn.is_of_longest_axis


# A whole turn in radians, and angles that a program writes, have so much room.
_TURN = 6.2832
# Of angles and lengths that an eighth of a turn and a circle have, with seven digits
_ROUNDED = 1e-6


def _check_directions(frame: Frame, turn: Turn, table: Table) -> None:
    """Refuses directions that may be angles by their names, unless they have the length 1."""
    lengths = np.linalg.norm(table.stack(turn.columns), axis=1)
    wrong = ~(np.abs(lengths - turn.largest) < ROUNDED_DIRECTION)
    if wrong.any():
        names = ",".join(turn.columns)
        raise frame.error(f"has the length {lengths[wrong][0]:g} of {' '.join(turn.columns)}, which may be angles or a direction: say "
                          f"which (--direction-columns {names}, or --euler)", int(wrong.argmax()))  # fmt: skip


def _check_eighths(frame: Frame, turn: Turn, table: Table) -> None:
    """Refuses angles of exactly an eighth of a turn of ellipses that are not circles: scikit-image before 0.21 changes their sign (issue
    6815 there), also in CellProfiler."""
    assert frame.shapes is not None
    is_eighth = np.abs(np.abs(turn.radians(table)[:, 0]) - np.pi / 4) < _ROUNDED
    wrong = is_eighth & (np.abs(np.diff(frame.shapes)[:, 0]) > _ROUNDED * frame.shapes.max(axis=1))
    if wrong.any():
        name = turn.columns[0]
        raise frame.error(f"has the {name} {table[name][wrong][0]:.9g}, an eighth of a turn, whose sign scikit-image before 0.21 changes: "
                          f"say --angle-sense {turn.sense} if a later version was used, or change such signs first",
                          int(wrong.argmax()))  # fmt: skip


def _check_angles(frame: Frame, turn: Turn, table: Table) -> None:
    """Refuses angles that the columns cannot hold: of a program's own range in radians, and angles from an axis."""
    for k, (name, unit) in enumerate(zip(turn.columns, turn.units)):
        values = table[name]
        wrong = np.abs(values) > turn.largest if turn.largest else np.zeros(len(values), dtype=bool)
        if wrong.any():
            raise frame.error(f"has the {name} {values[wrong][0]:g}, and this program writes radians up to {turn.largest:.4g}: say the "
                              "unit (--angle degrees)", int(wrong.argmax()))  # fmt: skip
        half = 180.0 if unit == "degrees" else 0.5 * _TURN
        wrong = (values < -1e-9 * half) | (values > (1 + 1e-9) * half)
        if turn.kind == "polar" and k == 0 and wrong.any():
            raise frame.error(f"has the {name} {values[wrong][0]:g}, which is not an angle from the axis z, 0 to 180 degrees: check "
                              "which of the columns of --polar comes first, and their unit", int(wrong.argmax()))  # fmt: skip
        if unit == "radians" and (np.abs(values) > _TURN).any():
            frame.notes.append(f"{name} is taken in radians, and is up to {np.abs(values).max():g}, more than a whole turn (--angle "
                               "degrees if these are degrees)")  # fmt: skip


def _spheroids(taken: Taken, table: Table) -> Floats:
    """Lengths across the axis of revolution, twice, and along it."""
    across, along = (table.stack(taken.shape) * taken.factors).T
    along = across * table[taken.shape[1]] if taken.spheroid == "ratio" else along
    return np.stack([across, across, along], axis=1)
