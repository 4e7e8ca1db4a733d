# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that are not plain: labelled, masked and lazy arrays, long doubles, objects.

The compiled part (`_core.call_...`) takes numbers, sequences and arrays of NumPy itself and hands everything else to
`apply`. Functions written in Python use `plain` and `by_rows`.
"""

from __future__ import annotations

import functools
import importlib
import sys
from typing import Any, TypeVar, cast
from collections.abc import Callable

import numpy as np

from . import _device
from ._documentation import names_of_inputs
from ._typing import Floats
from ._words import shown

# Keywords that a ufunc gets with the chunks of dask arrays. dask itself moves the keyword "axes".
_OF_CHUNKS = frozenset({"casting", "dtype", "order"})

Result = TypeVar("Result")


def plain(x: Any) -> Any:
    """Converts `x` to an array that ufuncs take: of NumPy, of dask, or of another library that implements ufuncs.

    Labelled arrays (pandas, xarray) are taken by position. Masked entries become NaN; long doubles and objects become
    float64. Rotations of SciPy become matrices.
    """
    if _is_instance(x, "xarray", "DataArray", "Variable"):
        x = x.data
    elif _is_instance(x, "pandas", "DataFrame", "Series", "Index"):
        x = x.to_numpy(na_value=np.nan)
    elif _is_instance(x, "scipy.spatial.transform", "Rotation"):
        x = x.as_matrix()
    elif isinstance(x, (list, tuple)) and any(isinstance(row, np.ma.MaskedArray) for row in x):
        x = np.ma.asarray(x)
    if isinstance(x, np.ma.MaskedArray):
        return _to_double(x).filled(np.nan)
    if _is_other_dask_collection(x):
        raise TypeError(f"a dask collection must be a dask.array.Array, not {type(x).__qualname__}")
    if not hasattr(type(x), "__array_ufunc__"):
        x = np.asarray(x)
    return _to_double(x) if getattr(getattr(x, "dtype", None), "char", "") in ("g", "O") else x


def reals(value: Any, name: str) -> Floats:
    """An array of float64. Masked entries become NaN."""
    if type(value) is np.ndarray and value.dtype == np.float64:
        return value
    try:
        array = np.asarray(plain(value))
    except (TypeError, ValueError, OverflowError):  # rows of several lengths, or objects that are not numbers
        array = np.asarray("")
    if value is None or array.dtype.kind not in "biuf":
        raise TypeError(f"{name} must be real numbers, not {shown(value)}")
    return np.asarray(array, dtype=np.float64)


def _to_double(x: Any) -> Any:
    return x.astype(np.float64, casting="unsafe" if x.dtype == np.object_ else "same_kind")


def doubles(x: Any) -> Any:
    """The array of plain() as float64, for formulas of the package.

    NumPy computes in the type of the numbers that it is given: it would lose digits of single precision, and small integers overflow.
    """
    x = plain(x)
    return x if getattr(x, "dtype", None) == np.float64 else _to_double(x)


def is_dask_array(x: Any) -> bool:
    return _is_instance(x, "dask.array", "Array")


def _is_other_dask_collection(x: Any) -> bool:
    """Returns whether `x` is a dask collection other than an array. All objects of xarray have `__dask_graph__`, perhaps returning None."""
    if isinstance(x, type) or not hasattr(x, "__dask_graph__") or is_dask_array(x):
        return False
    return x.__dask_graph__() is not None


def _is_instance(x: Any, module: str, *names: str) -> bool:
    """Returns whether `x` is of one of these classes of a library, without importing the library."""
    library = sys.modules.get(module)
    return library is not None and isinstance(x, tuple(getattr(library, name) for name in names))


def apply(
    call: Callable[..., Any], ufunc: np.ufunc, inputs: tuple[Any, ...], out: Any, keywords: dict[str, Any]
) -> Any:
    """Called by the compiled `call` if an input is not plain. Calls that again if this has converted an input, else the ufunc."""
    if any(map(_device.is_device_array, inputs)):
        return _device.apply(ufunc.__name__, inputs, out, keywords)
    arrays = _numeric(ufunc.__name__, inputs)
    if any(map(is_dask_array, arrays)):
        return _apply_lazily(ufunc, arrays, out, keywords)
    if any(array is not x for array, x in zip(arrays, inputs)):
        return call(*arrays, out, keywords)
    return ufunc(*arrays, **keywords) if out is None else ufunc(*arrays, out=out, **keywords)


def _numeric(name: str, inputs: tuple[Any, ...]) -> tuple[Any, ...]:
    """The inputs of a function as arrays that ufuncs take. Refuses those that are not real numbers, by their names."""
    arrays = []
    for k, x in enumerate(inputs):
        try:
            array = plain(x)
        except (TypeError, ValueError, OverflowError):
            array = None  # rows of several lengths, or objects that are not numbers
            if _is_other_dask_collection(x):
                raise
        if x is None or array is None or getattr(getattr(array, "dtype", None), "kind", "f") not in "biuf":
            raise TypeError(f"{name}: {names_of_inputs(name)[k]} must be real numbers, not {shown(x)}")
        arrays.append(array)
    return tuple(arrays)


def apply_to_columns(
    call: Callable[..., Any], inputs: tuple[Any, ...], out: Any, keywords: dict[str, Any], nout: int
) -> tuple[Any, ...]:
    """Called by the compiled `call` if one array `out` (..., nout) receives the `nout` numbers of each row."""
    if out.ndim == 0 or out.shape[-1] != nout:
        raise ValueError(f"out, if it is one array, must have {nout} numbers in the last dimension, not the shape {out.shape}")
    columns = tuple(out[..., k] for k in range(nout))
    call(*inputs, columns, keywords)
    return tuple(column[()] for column in columns)


def check_out(out: Any, name: str) -> None:
    """Refuse outputs in which results would get lost: all but arrays of NumPy without a mask."""
    for array in out if isinstance(out, tuple) else (out,):
        if array is not None and (not isinstance(array, np.ndarray) or isinstance(array, np.ma.MaskedArray)):
            masked = "a masked array" if isinstance(array, np.ndarray) else shown(array)
            raise TypeError(f"{name}: out, which follows the inputs, must be an array of NumPy without a mask, not {masked}")


def by_rows(function: Callable[..., Result], name: str, signature: str, x: Any) -> Result:
    """Call a function of one NumPy array, which has this signature as a gufunc and keeps the type; lazily with dask."""
    array = plain(x)
    if not is_dask_array(array):
        return function(np.asarray(array))
    _check_shapes(name, signature, (array,))
    return cast(Result, _by_chunks(functools.partial(_chunk, function, {}), signature, (array,), (array.dtype,) * 2))


def _apply_lazily(ufunc: np.ufunc, arrays: tuple[Any, ...], out: Any, keywords: dict[str, Any]) -> Any:
    """A ufunc of this package on plain arrays of which one at least is of dask.

    Raises TypeError for a keyword that makes no sense for a result that does not exist yet.
    """
    name, signature = ufunc.__name__, str(ufunc.signature)
    given = {key: value for key, value in keywords.items() if value is not None}
    refused = sorted(given.keys() - _OF_CHUNKS - {"axes"})
    if any(array is not None for array in (out if isinstance(out, tuple) else (out,))):
        refused.append("out")
    if refused:
        raise TypeError(f"{name}: with dask arrays, there can be no {' or '.join(map(repr, refused))}")
    axes = given.pop("axes", None)
    if axes is None:
        _check_shapes(name, signature, arrays)
    types = _output_types(ufunc, given.get("dtype"))
    return _by_chunks(functools.partial(_chunk, ufunc, given), signature, arrays, types, axes)


def _chunk(function: Callable[..., Any], keywords: dict[str, Any], *chunks: Any) -> Any:
    return function(*map(plain, chunks), **keywords)


def _by_chunks(
    function: Any, signature: str, arrays: tuple[Any, ...], types: tuple[Any, ...], axes: Any = None
) -> Any:
    """Calls apply_gufunc() with types and sizes of outputs. Dask would look for them with arrays of size 1, which are refused."""
    outputs = signature.split("->")[1]
    return importlib.import_module("dask.array").apply_gufunc(
        function,
        signature,
        *arrays,
        output_dtypes=types if outputs.count("(") > 1 else types[0],
        output_sizes={size: int(size) for size in outputs if size.isdigit()},
        allow_rechunk=True,
        axes=axes,
    )


def _output_types(ufunc: np.ufunc, dtype: Any) -> tuple[np.dtype[Any], ...]:
    """Types of the outputs of the loop that NumPy takes for ``dtype=...``."""
    for loop in ufunc.types:
        types = tuple(map(np.dtype, loop.split("->")[1]))
        if dtype is None or set(types) == {np.dtype(dtype)}:
            return types
    raise TypeError(f"{ufunc.__name__}: no loop has results of the type {np.dtype(dtype)}")


def _check_shapes(name: str, signature: str, arrays: tuple[Any, ...]) -> None:
    """Refuse wrong sizes at once, not when the result is computed."""
    for number, (core, array) in enumerate(zip(signature.split("->")[0][1:-1].split("),("), arrays)):
        shape = tuple(int(size) for size in core.split(",") if size)
        if array.shape[array.ndim - len(shape) :] != shape or array.ndim < len(shape):
            raise ValueError(f"{name}: the last dimensions of input {number} must be {shape}, not {array.shape}")
