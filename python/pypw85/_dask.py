"""Generalised ufuncs on dask arrays."""

from __future__ import annotations

from typing import Any

import numpy as np


def apply_gufunc(ufunc: np.ufunc, *args: Any) -> Any:
    """Apply a ufunc of this package to dask arrays, chunk by chunk.

    Dask would find the types and sizes of the outputs by a call with arrays of size one, which fixed core dimensions
    rightly refuse.
    """
    import dask.array

    assert ufunc.signature is not None
    outputs = ufunc.signature.split("->")[1]
    types = tuple(np.dtype(code) for code in ufunc.types[0].split("->")[1])
    return dask.array.apply_gufunc(
        ufunc,
        ufunc.signature,
        *args,
        output_dtypes=types if ufunc.nout > 1 else types[0],
        output_sizes={size: int(size) for size in outputs if size.isdigit()},
    )
