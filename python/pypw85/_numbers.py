# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that callers pass. A value that is not one is refused: the message has the argument, what is allowed, and the value."""

from __future__ import annotations

import operator
from typing import Any, SupportsIndex, TypeVar, cast
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ._words import shown

Type = TypeVar("Type")


def real(value: Any, name: str) -> float:
    """A number as float."""
    if not isinstance(value, (str, bytes, bytearray, complex, np.complexfloating)):
        try:
            return float(value)
        except (TypeError, ValueError, OverflowError):
            pass
    raise TypeError(f"{name} must be a real number, not {shown(value)}")


def positive(value: Any, name: str) -> float:
    """A finite number > 0."""
    number = real(value, name)
    if not 0 < number < np.inf:
        raise ValueError(f"{name} must be > 0 and finite, not {number}")
    return number


def integer(value: Any, name: str, least: int | None = 0, most: int | None = None) -> int:
    """An integer from `least` to `most`, where there are such."""
    allowed = "an integer" if least is None else f"an integer >= {least}" if most is None else f"an integer from {least} to {_power(most)}"
    try:
        number = operator.index(cast("SupportsIndex", value))
    except TypeError:
        raise TypeError(f"{name} must be {allowed}, not {shown(value)}") from None
    if (least is not None and number < least) or (most is not None and number > most):
        raise ValueError(f"{name} must be {allowed}, not {shown(number)}")
    return number


def seed_of(value: Any, name: str) -> int:
    """A number that selects random numbers."""
    return integer(value, name, 0, 2**64 - 1)


def truth(value: Any, name: str) -> bool:
    """True or False, also as 1 or 0."""
    if isinstance(value, (bool, np.bool_)) or (isinstance(value, (int, np.integer)) and value in (0, 1)):
        return bool(value)
    raise TypeError(f"{name} must be True or False, not {shown(value)}")


def flags(value: Any, name: str, count: int = 3) -> NDArray[np.bool_]:
    """True or False for each vector of a cell, from one for all of them or one for each."""
    array = np.asarray(value)
    if array.dtype.kind not in "biu" or not ((array == 0) | (array == 1)).all() or array.shape not in ((), (count,)):
        words = {2: "two", 3: "three"}
        raise ValueError(f"{name} must be True, False or {words[count]} of them, not {shown(value)}")
    return np.broadcast_to(array.astype(bool), count)


def function(value: Any, name: str) -> Any:
    """A function, or another object that can be called."""
    if not callable(value):
        raise TypeError(f"{name} must be a function, not {shown(value)}")
    return value


def instance(value: Any, kind: type[Type], name: str) -> Type:
    """An object of a class of this package."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a pypw85.{kind.__name__}, not {type(value).__qualname__}")
    return value


def instances(values: Any, kind: type[Type], name: str) -> list[Type]:
    """Several objects of a class of this package. One alone, which may be a tuple, is not several."""
    if isinstance(values, kind) or not isinstance(values, Iterable):
        raise TypeError(f"{name} must be a list of pypw85.{kind.__name__}, not {type(values).__qualname__}")
    return [instance(value, kind, f"{name}[{k}]") for k, value in enumerate(values)]


def _power(most: int) -> str:
    """A largest number, as people write it."""
    for text, number in ((f"2**{most.bit_length()} - 1", most + 1), (f"2**{most.bit_length() - 1}", most)):
        if number >= 2**31 and not number & (number - 1):
            return text
    return str(most)
