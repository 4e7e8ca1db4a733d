# SPDX-License-Identifier: BSD-3-Clause
"""Finds the argument because of which a call failed, its row, and the cause. Nothing here runs before a call has failed."""

from __future__ import annotations

import inspect
import re
from typing import Any
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import plain
from ._documentation import FUNCTIONS
from ._errors import PW85Error

_Rows = NDArray[np.float64]
_FORM = re.compile(r"q\d?$")
_POSITIVE = {"a", "b", "c", "curvatures", "radius", "semi_axes"}
_NOT_ZERO = {"axis", "direction", "n", "normal", "quaternion_wxyz"}
_FROM_ZERO = {"t_max", "mu2"}  # not negative; may be infinite
# Functions for which ellipsoids must not have one centre.
_APART = re.compile(r"contact_(geometry|hessian)")
# Smallest volume that the columns of a factor span, scaled to length one, as for pw85_contact_factored().
_LEAST_VOLUME = 2.0**-39
# Largest error of an entry of RᵀR, as for pw85_ellipsoid().
_ROTATION_ATOL = 1e-6


def raise_status(status: int, name: str, arguments: tuple[Any, ...]) -> None:
    """Called by the compiled part when a call for one row has failed."""
    raise PW85Error(status, name, _core.strerror(status), explain_values(name, arguments))


def raise_better(error: Exception, name: str, arguments: tuple[Any, ...]) -> None:
    """Called by the compiled part when a ufunc has raised an exception. Names the argument that caused it, if that can be found."""
    try:
        text = explain_shapes(name, arguments)
        if not text and isinstance(error, FloatingPointError):
            text = f"{error}: {explain_values(name, arguments)}".removesuffix(": ")
    except (TypeError, ValueError):  # as of arguments that are not numbers
        raise error from None
    if text:
        raise type(error)(text) from None
    raise error


def explain_values(name: str, arguments: tuple[Any, ...]) -> str:
    """About the first row that is bad, as "row (2, 0): q1 is not positive definite: [...]"; empty if nothing is found."""
    cores = _cores(name)
    arrays = [np.asarray(plain(x), dtype=np.float64) for x in arguments]
    rows = np.broadcast_shapes(*(x.shape[: x.ndim - len(core)] for x, core in zip(arrays, cores)))
    flat = {argument: np.broadcast_to(x, rows + core).reshape(-1, *core)
            for argument, x, core in zip(_names(name), arrays, cores)}  # fmt: skip
    first, found = int(np.prod(rows)), ""
    with np.errstate(all="ignore"):
        for argument, bad, reason in _complaints(name, flat):
            if bad[:first].any():
                first = int(bad.argmax())
                found = f"{argument} {reason}: {flat[argument][first].tolist()}"
    where = f"row {tuple(map(int, np.unravel_index(first, rows)))}: " if found and rows else ""
    return where + found


def _complaints(name: str, flat: dict[str, _Rows]) -> Iterator[tuple[str, NDArray[np.bool_], str]]:
    """Arguments, which of their rows are bad, and the causes. NaN comes first, since other causes follow from it."""
    for argument, x in flat.items():
        axes = tuple(range(1, x.ndim))
        yield argument, np.logical_or.reduce(np.isnan(x), axis=axes), "is NaN" if x.ndim == 1 else "has a NaN"
        if argument not in _FROM_ZERO:
            yield argument, np.logical_or.reduce(np.isinf(x), axis=axes), "is infinite"
    for argument, x in flat.items():
        axes = tuple(range(1, x.ndim))
        if _FORM.match(argument) or x.shape[1:] == (6,):
            yield argument, _not_definite(x), "is not positive definite"
        elif argument in _POSITIVE:
            yield argument, np.logical_or.reduce(x <= 0, axis=axes), "is not positive" if x.ndim == 1 else "are not positive"
        elif argument in _NOT_ZERO or (argument == "r12" and _APART.match(name)):
            yield argument, np.logical_and.reduce(x == 0, axis=axes), "is zero"
        elif argument == "lambda_":
            yield argument, (x < 0) | (x > 1), "is not in [0, 1]"
        elif argument in _FROM_ZERO:
            yield argument, x < 0, "is negative"
        elif argument.startswith("motion"):  # whose last number is the growth
            yield argument, (x[:, 6] < 0) & (1 + x[:, 6] * flat["t_max"] <= 0), "shrinks to nothing before t_max"
        elif argument == "rotation":
            errors = np.abs(np.swapaxes(x, 1, 2) @ x - np.eye(3)).max(axis=axes)
            yield argument, errors > _ROTATION_ATOL, "is not a rotation matrix: its columns must be orthonormal"
        elif argument in ("s1", "s2"):
            lengths = np.sqrt((x * x).sum(axis=1))
            volumes = np.abs(np.linalg.det(x / lengths[:, None, :]))
            yield argument, ~(volumes > _LEAST_VOLUME), "is a factor whose columns are zero or nearly dependent"
        elif argument == "cell":
            yield argument, np.logical_or.reduce(np.isnan(_core.cell_reduce(x)), axis=axes), "is singular"
        elif argument == "lower":
            yield argument, np.logical_or.reduce(x > flat["upper"], axis=1), "is larger than upper"


def _not_definite(q: _Rows) -> NDArray[np.bool_]:
    """Decides by the pivots of the factorisation, as the library does."""
    if q.shape[1] == 6:
        bad: NDArray[np.bool_] = np.isnan(_core.cholesky_decomp(q)).any(axis=1)
    else:
        xx, xy, yy = q.T
        bad = ~((xx > 0) & (yy - xy / xx * xy > 0))
    return bad


def explain_shapes(name: str, arguments: tuple[Any, ...]) -> str:
    """About the first argument whose shape does not fit, or rows that do not; empty if all do."""
    names, cores = _names(name), _cores(name)
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
        return f"it should have {core[0]} entries in the last axis"
    return f"its last axes should be {core}"


def _names(name: str) -> list[str]:
    """Of the inputs of a function: the first parameters of the Python function of this name."""
    return list(inspect.signature(FUNCTIONS[name]).parameters)[: len(_cores(name))]


def _cores(name: str) -> list[tuple[int, ...]]:
    """Shapes of one row of each input."""
    inputs = getattr(_core, name).signature.split("->")[0][1:-1].split("),(")
    return [tuple(int(size) for size in core.split(",") if size) for core in inputs]
