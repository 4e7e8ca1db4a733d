# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in the memory of a GPU, of any library whose arrays have ``__cuda_array_interface__`` (CuPy, PyTorch, Numba) or are handed
over by DLPack (JAX).

They are not copied; results are new arrays of the same library. Bad rows are marked, but not reported. Where an array says in the
order of which stream it is, the work is queued there, and nothing waits for the device; otherwise the call waits for its work.
"""

from __future__ import annotations

import math
import sys
from typing import Any, NamedTuple
from collections.abc import Sequence

import numpy as np

from . import _core
from ._errors import PW85Error, Status
from ._typing import Floats

# Columns of the results after the rows, or 0 for numbers.
_OUTPUTS = {"contact": (0, 0), "overlap": (0,), "contact_derivatives": (0, 0, 3, 3, 3, 3, 3)}


_CUDA = (2, 13)  # of DLPack: memory of the device, and memory that it shares with the host


class _View(NamedTuple):
    """Description of an array on a GPU. `owner` keeps its memory."""

    pointer: int
    shape: tuple[int, ...]
    owner: Any


class DeviceArray:
    """A new array on the GPU, for libraries that cannot make arrays for others to fill: they take it by DLPack or by
    ``__cuda_array_interface__``. Its numbers are there: nothing need be waited for.
    """

    def __init__(self, shape: tuple[int, ...], kind: str) -> None:
        self.shape, self.dtype = shape, np.dtype(kind)
        memory = _core.device_memory(max(1, math.prod(shape) * self.dtype.itemsize))
        if memory is None:
            raise _no_device("DeviceArray")
        self._owner, self._pointer, self._device = memory

    @property
    def __cuda_array_interface__(self) -> dict[str, Any]:
        return {"shape": self.shape, "typestr": self.dtype.str, "data": (self._pointer, False), "version": 3}

    def __dlpack_device__(self) -> tuple[int, int]:
        return (_CUDA[0], self._device)

    def __dlpack__(
        self,
        *,
        stream: Any = None,
        max_version: Any = None,
        dl_device: tuple[int, int] | None = None,
        copy: bool | None = None,
    ) -> Any:
        if copy or (dl_device is not None and tuple(dl_device) != self.__dlpack_device__()):
            raise BufferError("the array can be passed on without a copy only: leave out copy and dl_device")
        return _core.dlpack_export(self._owner, self._pointer, self._device, self.shape, self.dtype.itemsize)


def _no_device(name: str) -> PW85Error:
    status = int(Status.EDEVICE)
    return PW85Error(status, name, _core.strerror(status))


def _has_interface(x: Any) -> bool:
    return hasattr(x, "__cuda_array_interface__")


def is_device_array(x: Any) -> bool:
    if isinstance(x, np.ndarray):
        return False
    return _has_interface(x) or (hasattr(x, "__dlpack_device__") and x.__dlpack_device__()[0] in _CUDA)


def _strides(shape: Sequence[int], size: int) -> tuple[int, ...]:
    """Strides of a contiguous array."""
    strides = []
    for length in reversed(shape):
        strides.append(size)
        size *= length
    return tuple(reversed(strides))


def _is_contiguous(shape: tuple[int, ...], strides: Sequence[int] | None, size: int) -> bool:
    """Returns whether strides are those of a contiguous array. The stride of a single row does not matter."""
    if strides is None or 0 in shape:
        return True
    return all(n == 1 or has == needs for n, has, needs in zip(shape, strides, _strides(shape, size)))


def _stream(x: Any) -> int | None:
    """The stream in whose order an array is; PyTorch does not say it in the interface."""
    torch = sys.modules.get("torch")
    if torch is not None and isinstance(x, torch.Tensor) and x.is_cuda:
        return int(torch.cuda.current_stream(x.device).cuda_stream)
    stream: int | None = x.__cuda_array_interface__.get("stream") if _has_interface(x) else None
    return stream


def _is_handed_over(x: Any) -> bool:
    """Returns whether the array is taken by DLPack, which orders its work before that of the stream that is asked for."""
    return hasattr(x, "__dlpack__") and _stream(x) is None


def _read(x: Any, stream: int) -> tuple[int, tuple[int, ...], Sequence[int] | None, str, Any]:
    """Pointer, shape, strides, type, and what keeps the memory; from now on the array is in the order of the stream."""
    if _is_handed_over(x):
        capsule = x.__dlpack__(stream=stream or 1)  # 1 is the default stream
        return (*_core.dlpack_view(capsule), capsule)
    interface = x.__cuda_array_interface__
    return interface["data"][0], tuple(interface["shape"]), interface.get("strides"), interface["typestr"], x


def _view(x: Any, name: str, columns: int, stream: int, typestr: str = "<f8") -> _View:
    """An array of rows with a given number of columns."""
    if not is_device_array(x):
        raise TypeError(f"{name} must be on the GPU like the others, not a {type(x).__qualname__}")
    pointer, shape, strides, kind, owner = _read(x, stream)
    if kind != typestr:
        raise TypeError(f"{name} must have the type {typestr} on the GPU, but it has {kind}")
    if not shape or shape[-1] != columns:
        raise ValueError(f"{name} must have {columns} columns, not the shape {shape}")
    if not _is_contiguous(shape, strides, int(typestr[2:])):
        raise ValueError(f"{name} must be contiguous on the GPU")
    return _View(pointer, shape, owner)


def _common_stream(arrays: Sequence[Any]) -> int | None:
    streams = {stream for stream in map(_stream, arrays) if stream is not None}
    if len(streams) > 1:
        raise ValueError("all arrays must belong to one stream, not to several: synchronise the streams, and pass arrays of one of them")
    return streams.pop() if streams else None


def _library(like: Any) -> Any:
    """The library of an array: by the standard of array libraries, or by the package of its class."""
    if hasattr(like, "__array_namespace__"):
        return like.__array_namespace__()
    return sys.modules[type(like).__module__.partition(".")[0]]


def _new(like: Any, shape: tuple[int, ...], kind: str) -> Any:
    """A new array of the library of another array, or an array that this library can take."""
    if hasattr(like, "new_empty"):
        return like.new_empty(shape, dtype=getattr(_library(like), kind))
    library = _library(like)
    if hasattr(library, "empty") and not _is_handed_over(like):
        return library.empty(shape, dtype=getattr(library, kind))
    return DeviceArray(shape, kind)


def _taken(like: Any, output: Any) -> Any:
    """The array as one of the library."""
    library = _library(like)
    is_own = isinstance(output, DeviceArray) and hasattr(library, "from_dlpack")
    return library.from_dlpack(output) if is_own else output


def _outputs(function: str, like: Any, rows: tuple[int, ...]) -> tuple[Any, ...]:
    kind = "uint8" if function == "overlap" else "float64"
    return tuple(_new(like, (*rows, columns) if columns else rows, kind) for columns in _OUTPUTS[function])


def _pointer(x: Any) -> int:
    pointer: int = x.__cuda_array_interface__["data"][0]
    return pointer


def _call(
    name: str, like: Any, stream: int | None, outputs: tuple[Any, ...], numbers: Sequence[int]
) -> tuple[Any, ...]:
    """The results, which are arrays of the library of `like`."""
    status = _core.gpu(name, stream or 0, *numbers, *map(_pointer, outputs))
    if status:
        raise PW85Error(status, name, _core.strerror(status))
    if stream is None and not _core.device_wait(0):
        raise _no_device(name)
    return tuple(_taken(like, output) for output in outputs)


def _result(function: str, outputs: tuple[Any, ...], dtype: Any) -> Any:
    """Converts codes to truth values. A bad pair counts as an overlap."""
    if function != "overlap":
        return outputs
    if dtype is not None and np.dtype(dtype) == np.uint8:
        return outputs[0]
    if isinstance(outputs[0], DeviceArray):
        raise TypeError("overlap: dtype must be uint8 for arrays of a library that cannot compare them")
    return outputs[0] != 0


def apply(function: str, inputs: tuple[Any, ...], out: Any, keywords: dict[str, Any]) -> Any:
    """The ufunc of this name where an input is on a GPU."""
    if function not in _OUTPUTS:
        raise TypeError(f"{function}: the arrays must be on the host, because this function does not run on a GPU")
    refused = sorted(keywords.keys() - {"dtype"}) + (["out"] if out is not None else [])
    if refused:
        raise TypeError(f"{function}: leave out {' and '.join(map(repr, refused))} with arrays on a GPU")
    stream = _common_stream(inputs)
    views = [_view(x, name, columns, stream or 0) for x, name, columns in zip(inputs, ("r12", "q1", "q2"), (3, 6, 6))]
    rows = views[0].shape[:-1]
    if any(view.shape[:-1] != rows for view in views):
        raise ValueError(f"{function}: arrays on a GPU must have the same number of rows")
    outputs = _outputs(function, inputs[0], rows)
    numbers = [math.prod(rows), *(view.pointer for view in views)]
    return _result(function, _call(function, inputs[0], stream, outputs, numbers), keywords.get("dtype"))


def apply_to_pairs(
    function: str, pairs: Any, centers: Any, q: Any, cell: Floats | None, images: Any, dtype: Any = None
) -> Any:
    """One of the functions for neighbour lists where these are on a GPU; the cell is not."""
    arrays = [pairs, centers, q] + ([] if images is None else [images])
    stream = _common_stream(arrays)
    kinds = [("pairs", 2, "<i4"), ("centers", 3, "<f8"), ("q", 6, "<f8"), ("images", 3, "<i4")]
    views = [_view(x, name, columns, stream or 0, kind) for x, (name, columns, kind) in zip(arrays, kinds)]
    if any(len(view.shape) != 2 for view in views) or views[1].shape[0] != views[2].shape[0]:
        raise ValueError("pairs, centers and q must be rows, and there must be a form for each centre")
    if images is not None and views[3].shape[0] != views[0].shape[0]:
        raise ValueError("there must be one image for each pair")
    numbers = [
        views[0].shape[0],
        views[0].pointer,
        0 if images is None else views[3].pointer,
        views[1].shape[0],
        views[1].pointer,
        views[2].pointer,
        0 if cell is None else cell.ctypes.data,
    ]
    outputs = _outputs(function, centers, views[0].shape[:1])
    return _result(function, _call(f"{function}_pairs", centers, stream, outputs, numbers), dtype)
