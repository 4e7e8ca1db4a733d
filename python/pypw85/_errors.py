# SPDX-License-Identifier: BSD-3-Clause
"""Errors: exceptions of single calls, and invalid rows of arrays."""

from __future__ import annotations

import contextlib
import enum
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._numbers import integer
from ._words import shown


class Status(enum.IntEnum):
    """Status codes of the library; `strerror` returns their meanings."""

    SUCCESS = _core.STATUSES["SUCCESS"]
    EINVAL = _core.STATUSES["EINVAL"]
    ENOTPD = _core.STATUSES["ENOTPD"]
    ECONVERGENCE = _core.STATUSES["ECONVERGENCE"]
    ENOMEM = _core.STATUSES["ENOMEM"]
    EDEVICE = _core.STATUSES["EDEVICE"]
    EOVERLAP = _core.STATUSES["EOVERLAP"]
    EPOTENTIAL = _core.STATUSES["EPOTENTIAL"]


class PW85Error(ValueError, ArithmeticError):
    """Exception of a call that failed, for example because an argument is invalid.

    Attributes
    ----------
    status : Status
        Status code of the library.
    function : str
        Name of the function that failed.
    reason : str
        Meaning of the status: ``strerror(status)``.
    detail : str
        The invalid argument, the requirement that it does not meet, and its value; empty if the cause is unknown.
    """

    def __init__(self, status: int, function: str, reason: str, detail: str = "") -> None:
        super().__init__(status, function, reason, detail)
        self.status = Status(status)
        self.function = function
        self.reason = reason
        self.detail = detail

    def __str__(self) -> str:
        return f"{self.function}: {self.detail or self.reason}"


@contextlib.contextmanager
def named(function: str) -> Iterator[None]:
    """Context manager: errors of the library in its body get the name of the public function that the user called."""
    try:
        yield
    except PW85Error as error:
        raise PW85Error(error.status, function, error.reason, error.detail) from None


def bad_rows(result: Any, core_ndim: int = 0) -> NDArray[np.intp]:
    """Returns the indices of the rows of a result that could not be computed.

    To find out why a row is invalid, call the function for this row alone: the message of the exception states the reason.

    Parameters
    ----------
    result : array or tuple of arrays
        Result of a function of this package. Invalid rows are NaN, or 255 in an array of overlap codes (``uint8``). A
        masked entry also marks an invalid row. Dask arrays are computed.
    core_ndim : int
        Number of trailing dimensions of one row: 0 for numbers (the default), 1 for vectors and forms. For a tuple, the
        number of its first array.

    Returns
    -------
    array of int
        Indices, from 0, in C order over all leading dimensions (see `numpy.unravel_index`).

    Raises
    ------
    TypeError
        The result is a boolean array, which cannot mark invalid rows: call ``overlap(..., dtype=np.uint8)`` instead.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 2, [0, 0, 1])] * 3)
    >>> q[1] = 0
    >>> with np.errstate(invalid="ignore"):
    ...     mu2, lambda_ = pypw85.contact([3, 0, 0], q[0], q)
    >>> pypw85.bad_rows(mu2)
    array([1])
    >>> pypw85.contact([3, 0, 0], q[0], q[1])  # doctest: +ELLIPSIS
    Traceback (most recent call last):
        ...
    pypw85.PW85Error: contact: q2 must be positive definite, not [0.0, 0.0, 0.0, 0.0, ...
    """
    trailing = integer(core_ndim, "bad_rows: core_ndim")
    values = np.ma.asarray(result[0] if isinstance(result, tuple) else result)
    if values.dtype == np.bool_:
        raise TypeError("boolean results do not mark bad rows; call overlap(..., dtype=np.uint8)")
    if values.dtype.kind not in "iuf":
        raise TypeError(f"bad_rows: result must be real numbers, not {shown(values.data)}")
    bad = values.data == 255 if values.dtype == np.uint8 else np.isnan(values.data)
    bad = bad | np.ma.getmaskarray(values)
    if trailing:
        bad = bad.any(axis=tuple(range(-trailing, 0)))
    return np.flatnonzero(bad)


def check_status(status: int, function: str, rows: str = "row", /, **arguments: Any) -> None:
    """Raises PW85Error if the status is not zero, with the cause from the library: see `describe`."""
    if status:
        raise PW85Error(status, function, _core.strerror(status), last_cause(rows, **arguments))


def last_cause(rows: str = "row", /, **arguments: Any) -> str:
    """Describes the last error of this thread, from pw85_last_error(): see `describe`; empty if there is none."""
    cause = _core.last_error()
    return "" if cause is None else describe(cause, rows, **arguments)


def describe(cause: tuple[str, str | None, str, int, int, float], rows: str = "row", /, **arguments: Any) -> str:
    """Returns the text of an error: argument, requirement and value.

    `arguments` are the arguments of the call. Lists and two-dimensional arrays, except `cell`, have one value per row. `rows` is the word
    for a row, such as "particle"; if it is empty, the text does not contain the row. In a list of named tuples, the invalid argument
    may be a member. A tuple of strings has the names of the entries of an array.
    """
    _, name, requirement, row, entry, value = cause
    if name is None:
        return requirement
    given = arguments.get(name)
    for one in arguments.values():
        if isinstance(one, list) and row < len(one) and name in getattr(one[row], "_fields", ()):
            return f"{_place(rows, row, ': ')}{name} {requirement}, not {getattr(one[row], name)}"
    if given is None:
        return f"{name} {requirement}"
    if isinstance(given, tuple) and given and isinstance(given[0], str):
        return f"{given[entry]} {requirement}, not {value}"
    if isinstance(given, list) and isinstance(given[row], tuple):
        return f"{_place(rows, row, ' ')}{requirement}, not {given[row]}"
    if np.ndim(given) == 2 and name != "cell":
        row += entry // np.shape(given)[1]  # the whole array is one argument: its row follows from the entry
    if isinstance(given, list) or (np.ndim(given) == 2 and name != "cell"):
        return f"{_place(rows, row, ': ')}{name} {requirement}, not {_shown(given[row])}"
    if np.size(given) > _MOST_SHOWN:
        return f"{name} {requirement}, not {value} (entry {entry})"
    return f"{name} {requirement}, not {_shown(given)}"


def _place(rows: str, row: int, end: str) -> str:
    return f"{rows} {row}{end}" if rows else ""


# Longer arrays are not shown as a whole.
_MOST_SHOWN = 9


def _shown(value: Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray) else value


PW85Error.__module__ = "pypw85"
Status.__module__ = "pypw85"
