# SPDX-License-Identifier: BSD-3-Clause
"""Rotations that are not said by quaternions: by Euler angles, and by the direction of an axis."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._typing import Floats
from ._words import shown

SEQUENCES = "one to three of xyz (fixed axes) or of XYZ (axes that rotate with the body), no two alike side by side"
_SEQUENCE = re.compile("[xyz]{1,3}|[XYZ]{1,3}")


def is_sequence(sequence: str) -> bool:
    """Returns whether these are one to three letters of axes, of which no two neighbours are the same."""
    return _SEQUENCE.fullmatch(sequence) is not None and not re.search(r"(.)\1", sequence)


def check_sequence(value: Any, name: str) -> str:
    """Refuses what is not a sequence of axes."""
    if not isinstance(value, str) or not is_sequence(value):
        raise ValueError(f"{name} must be {SEQUENCES}, not {shown(value)}")
    return value


def quaternions_of_euler(sequence: str, angles: ArrayLike) -> Floats:
    """Quaternions w x y z of rotations by angles (n, k) in radians about k axes, one after the other.

    Lower case means axes that are fixed in space, upper case axes that rotate with the body, as in
    `scipy.spatial.transform.Rotation.from_euler`. """
    check_sequence(sequence, "System.from_euler: euler")
    half = 0.5 * np.atleast_2d(np.asarray(angles, dtype=np.float64))
    if half.ndim != 2 or half.shape[1] != len(sequence):
        raise ValueError(f"the sequence {sequence} must have {len(sequence)} angles for each particle")
    result = np.tile([1.0, 0.0, 0.0, 0.0], (len(half), 1))
    for axis, turn in zip(sequence, half.T):
        one = np.zeros((len(half), 4))
        one[:, 0], one[:, 1 + "xyz".index(axis.lower())] = np.cos(turn), np.sin(turn)
        result = product(result, one) if sequence.isupper() else product(one, result)
    return result


def product(first: Floats, second: Floats) -> Floats:
    """Products of quaternions: the rotation by the second, then by the first."""
    w, v, s, u = first[:, :1], first[:, 1:], second[:, :1], second[:, 1:]
    return np.hstack([w * s - np.sum(v * u, axis=1, keepdims=True), w * u + s * v + np.cross(v, u)])


def quaternions_along(directions: Floats) -> Floats:
    """Quaternions w x y z of half turns that take the axis z to directions (n, 3) of any length > 0, up to the sign of these."""
    largest = np.abs(directions).max(axis=1, keepdims=True)
    unit = directions / largest
    unit = unit / np.linalg.norm(unit, axis=1, keepdims=True)
    # The axis of the half turn lies midway; the sign is chosen such that nothing cancels there.
    middle = np.where(unit[:, 2:] < 0, -unit, unit) + [0.0, 0.0, 1.0]
    return np.hstack([np.zeros((len(unit), 1)), middle / np.linalg.norm(middle, axis=1, keepdims=True)])


def directions_of_polar(polar: Floats, azimuth: Floats) -> Floats:
    """Directions (n, 3) of angles in radians from the axis z, and about it from x towards y."""
    return np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=1)
