"""Arrays in the memory of a GPU, of any library whose arrays have ``__cuda_array_interface__`` (CuPy, PyTorch, Numba).

They are not copied; results are new arrays of the same library, on the same stream. Nothing waits for the device: bad rows are
marked, but not reported.
"""

from __future__ import annotations

import sys
from typing import Any, NamedTuple, Optional, Sequence

import numpy as np

from . import _core
from ._errors import PW85Error
from ._typing import Floats

# Columns of the results after the rows, or 0 for numbers.
_OUTPUTS = {"contact": (0, 0), "overlap": (0,), "contact_derivatives": (0, 0, 3, 3, 3, 3, 3)}


class _View(NamedTuple):
    """What the interface says of an array."""

    pointer: int
    shape: tuple[int, ...]
    stream: Optional[int]


def is_device_array(x: Any) -> bool:
    return hasattr(x, "__cuda_array_interface__")


def _strides(shape: Sequence[int], size: int) -> tuple[int, ...]:
    """Those of a contiguous array."""
    strides = []
    for length in reversed(shape):
        strides.append(size)
        size *= length
    return tuple(reversed(strides))


def _stream(x: Any, interface: dict[str, Any]) -> Optional[int]:
    """The stream in whose order an array is; PyTorch does not say it in the interface."""
    torch = sys.modules.get("torch")
    if torch is not None and isinstance(x, torch.Tensor):
        return int(torch.cuda.current_stream(x.device).cuda_stream)
    stream: Optional[int] = interface.get("stream")
    return stream


def _view(x: Any, name: str, columns: int, typestr: str = "<f8") -> _View:
    """An array of rows of so many numbers."""
    if not is_device_array(x):
        raise TypeError(f"{name} must be on the GPU like the others, but it is {type(x).__qualname__}")
    interface = x.__cuda_array_interface__
    shape = tuple(interface["shape"])
    if interface["typestr"] != typestr:
        raise TypeError(f"{name} must have the type {typestr} on the GPU, but it has {interface['typestr']}")
    if not shape or shape[-1] != columns:
        raise ValueError(f"{name} must have {columns} columns, but the shape is {shape}")
    strides = interface.get("strides")
    if strides is not None and tuple(strides) != _strides(shape, int(typestr[2:])):
        raise ValueError(f"{name} must be contiguous on the GPU")
    return _View(interface["data"][0], shape, _stream(x, interface))


def _common_stream(views: Sequence[_View]) -> int:
    streams = {view.stream for view in views if view.stream is not None}
    if len(streams) > 1:
        raise ValueError("arrays that are in the order of different streams")
    return streams.pop() if streams else 0


def _new(like: Any, shape: tuple[int, ...], kind: str) -> Any:
    """An array of the library of another one."""
    library: Any = sys.modules[type(like).__module__.partition(".")[0]]
    dtype = getattr(library, kind)
    return like.new_empty(shape, dtype=dtype) if hasattr(like, "new_empty") else library.empty(shape, dtype=dtype)


def _outputs(function: str, like: Any, rows: tuple[int, ...]) -> tuple[Any, ...]:
    kind = "uint8" if function == "overlap" else "float64"
    return tuple(_new(like, (*rows, columns) if columns else rows, kind) for columns in _OUTPUTS[function])


def _pointer(x: Any) -> int:
    pointer: int = x.__cuda_array_interface__["data"][0]
    return pointer


def _call(name: str, stream: int, count: int, *numbers: int) -> None:
    status = _core.gpu(name, stream, count, *numbers)
    if status:
        raise PW85Error(status, name, _core.strerror(status))


def _result(function: str, outputs: tuple[Any, ...], dtype: Any) -> Any:
    """A bad pair counts as an overlap."""
    if function != "overlap":
        return outputs
    return outputs[0] if dtype is not None and np.dtype(dtype) == np.uint8 else outputs[0] != 0


def apply(function: str, inputs: tuple[Any, ...], out: Any, keywords: dict[str, Any]) -> Any:
    """The ufunc of this name where an input is on a GPU."""
    if function not in _OUTPUTS:
        raise TypeError(f"{function}: there is no such function for arrays on a GPU")
    refused = sorted(keywords.keys() - {"dtype"}) + (["out"] if out is not None else [])
    if refused:
        raise TypeError(f"{function}: with arrays on a GPU, there can be no {' or '.join(map(repr, refused))}")
    views = [_view(x, name, columns) for x, name, columns in zip(inputs, ("r12", "q1", "q2"), (3, 6, 6))]
    rows = views[0].shape[:-1]
    if any(view.shape[:-1] != rows for view in views):
        raise ValueError(f"{function}: arrays on a GPU must have the same number of rows")
    outputs = _outputs(function, inputs[0], rows)
    count = int(np.prod(rows, dtype=np.int64))
    _call(function, _common_stream(views), count, *(view.pointer for view in views), *map(_pointer, outputs))
    return _result(function, outputs, keywords.get("dtype"))


def apply_to_pairs(
    function: str, pairs: Any, centers: Any, q: Any, cell: Optional[Floats], images: Any, dtype: Any = None
) -> Any:
    """One of the functions for neighbour lists where these are on a GPU; the cell is not."""
    views = [_view(pairs, "pairs", 2, "<i4"), _view(centers, "centers", 3), _view(q, "q", 6)]
    if images is not None:
        views.append(_view(images, "images", 3, "<i4"))
        if views[3].shape[0] != views[0].shape[0]:
            raise ValueError("there must be one image for each pair")
    if any(len(view.shape) != 2 for view in views) or views[1].shape[0] != views[2].shape[0]:
        raise ValueError("pairs, centers and q must be rows, and there must be a form for each centre")
    outputs = _outputs(function, centers, views[0].shape[:1])
    _call(
        f"{function}_pairs",
        _common_stream(views),
        views[0].shape[0],
        views[0].pointer,
        0 if images is None else views[3].pointer,
        views[1].shape[0],
        views[1].pointer,
        views[2].pointer,
        0 if cell is None else cell.ctypes.data,
        *map(_pointer, outputs),
    )
    return _result(function, outputs, dtype)
