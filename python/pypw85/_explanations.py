# SPDX-License-Identifier: BSD-3-Clause
"""Messages of errors: the invalid argument, its row, and the cause. This code runs only after a call has failed.

NumPy checks types and shapes of arrays before it calls the library, and its messages number the operands. The messages here contain the
names of the arguments.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from . import _core
from ._arrays import plain
from ._documentation import cores_of_inputs, names_of_inputs
from ._errors import PW85Error, bad_rows

_FORM = re.compile(r"q\d?$")


def raise_status(status: int, name: str, arguments: tuple[Any, ...]) -> None:
    """Raises PW85Error. The extension module calls this function when a call for one row has failed."""
    raise PW85Error(status, name, _core.strerror(status), _last_cause(name, arguments))


def raise_better(error: Exception, name: str, arguments: tuple[Any, ...], out: Any, keywords: dict[str, Any]) -> None:
    """Raises an exception that names the invalid argument, if it can be found. The extension module calls this function when a ufunc
    has raised `error`."""
    try:
        text = _explain_types(name, out, keywords) if isinstance(error, TypeError) else ""
        if not keywords:  # which may move axes
            text = text or explain_shapes(name, arguments) or _explain_outputs(name, arguments, out)
            if not text and isinstance(error, FloatingPointError):
                text = f"{error}: {explain_values(name, arguments)}".removesuffix(": ")
    except (TypeError, ValueError):  # as of arguments that are not numbers
        raise error from None
    if text:
        if isinstance(error, TypeError):  # the subclasses of NumPy cannot be made from a message
            raise TypeError(text) from None
        raise type(error)(text) from None
    raise error


def _explain_types(name: str, out: Any, keywords: dict[str, Any]) -> str:
    """Returns the message for a type of results that the function does not have; empty if all types are valid."""
    types = list(dict.fromkeys(str(np.dtype(loop.split("->")[1][0])) for loop in getattr(_core, name).types))
    if keywords.get("dtype") is not None:
        return f"{name}: dtype must be {' or '.join(types)}, not {np.dtype(keywords['dtype'])}"
    for array in out if isinstance(out, tuple) else (out,):
        if array is not None and not np.can_cast(np.dtype(types[0]), array.dtype, "same_kind"):
            return f"{name}: out must be an array of {' or '.join(types)}, not {array.dtype}"
    return ""


def _explain_outputs(name: str, arguments: tuple[Any, ...], out: Any) -> str:
    """Returns the message for the first output array of a wrong shape; empty if all shapes are valid."""
    cores = cores_of_inputs(name)
    rows = np.broadcast_shapes(*(np.shape(plain(x))[: np.ndim(plain(x)) - len(core)] for x, core in zip(arguments, cores)))
    results = getattr(_core, name).signature.split("->")[1][1:-1].split("),(")
    for array, core in zip(out if isinstance(out, tuple) else (out,), results):
        shape = (*rows, *(int(size) for size in core.split(",") if size))
        if array is not None and array.shape != shape:
            return f"{name}: out must have the shape {shape}, not {array.shape}"
    return ""


def explain_values(name: str, arguments: tuple[Any, ...]) -> str:
    """Returns the message for the first invalid row, such as "row (2, 0): q1 must be positive definite, not [...]"; empty if all are valid.
    """
    cores = cores_of_inputs(name)
    arrays = [np.asarray(plain(x), dtype=np.float64) for x in arguments]
    rows = np.broadcast_shapes(*(x.shape[: x.ndim - len(core)] for x, core in zip(arrays, cores)))
    flat = [np.broadcast_to(x, rows + core).reshape(-1, *core) for x, core in zip(arrays, cores)]
    function = getattr(_core, name)
    codes = {"dtype": np.uint8} if function.types[0].endswith("?") else {}  # truth values do not mark rows
    with np.errstate(all="ignore"):
        results = function(*flat, **codes)
    first = results[0] if isinstance(results, tuple) else results
    for k in bad_rows(results, first.ndim - 1):
        try:
            getattr(_core, f"call_{name}")(*(x[k] for x in flat), None, {})
        except PW85Error as error:
            return (f"row {tuple(map(int, np.unravel_index(k, rows)))}: " if rows else "") + str(error).partition(": ")[2]
    return ""


def _last_cause(name: str, arguments: tuple[Any, ...]) -> str:
    """Describes the last error of a call for one row, with the value of the argument."""
    names, cause = names_of_inputs(name), _core.last_error()
    if cause is None or cause[1] is None:
        return ""
    argument = next((one for one in names if one.startswith(cause[1])), cause[1])
    if argument not in names:
        return ""
    if cause[2].endswith("NaN"):  # which is the value
        return f"{argument} {cause[2]}"
    return f"{argument} {cause[2]}, not {np.asarray(plain(arguments[names.index(argument)]), dtype=np.float64).tolist()}"


def explain_shapes(name: str, arguments: tuple[Any, ...]) -> str:
    """About the first argument whose shape does not fit, or rows that do not; empty if all do."""
    names, cores = names_of_inputs(name), cores_of_inputs(name)
    shapes = [np.shape(plain(x)) for x in arguments]
    for argument, shape, core in zip(names, shapes, cores):
        if shape[max(len(shape) - len(core), 0) :] != core:
            return f"{name}: {argument} has shape {shape}; {_wanted(argument, shape, core)}"
    rows = [shape[: len(shape) - len(core)] for shape, core in zip(shapes, cores)]
    try:
        np.broadcast_shapes(*rows)
    except ValueError:
        listed = ", ".join(f"{argument} {row}" for argument, row in zip(names, rows))
        return f"{name}: the numbers of rows do not fit: {listed}"
    return ""


def form_hint(shape: tuple[int, ...], core: tuple[int, ...]) -> str:
    """Advice if this is the shape of matrices instead of forms."""
    return ": pypw85.packed(matrix) converts" if shape[-2:] == (3, 3) and core == (6,) else ""


def _wanted(argument: str, shape: tuple[int, ...], core: tuple[int, ...]) -> str:
    if _FORM.match(argument):
        return f"a form has {core[0]} entries in the last axis{form_hint(shape, core)}"
    if len(core) == 1:
        return f"it must have {core[0]} entries in the last axis"
    return f"its last axes must be {core}"
