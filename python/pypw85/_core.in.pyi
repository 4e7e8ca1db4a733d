from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._typing import Floats

STATUSES: dict[str, int]
LAMBDA_ATOL: float

def version() -> str: ...
def strerror(status: int, /) -> str: ...
def contact_pairs(
    pairs: NDArray[np.int32],
    centers: NDArray[np.float64],
    q: NDArray[np.float64] | None,
    cell: NDArray[np.float64] | None,
    images: NDArray[np.int32] | None,
    mu2: NDArray[np.float64],
    lambda_: NDArray[np.float64],
    /,
) -> int: ...
def overlap_pairs(
    pairs: NDArray[np.int32],
    centers: NDArray[np.float64],
    q: NDArray[np.float64] | None,
    cell: NDArray[np.float64] | None,
    images: NDArray[np.int32] | None,
    overlap: NDArray[np.uint8],
    /,
) -> int: ...

def first_contact_pairs(*args: Any) -> int: ...
def contact_derivatives_pairs(*args: Any) -> int: ...
def gpu(name: str, stream: int, count: int, /, *numbers: int) -> int: ...
def dlpack_view(capsule: Any, /) -> tuple[int, tuple[int, ...], tuple[int, ...] | None, str]: ...
def dlpack_export(owner: Any, address: int, device: int, shape: tuple[int, ...], number_size: int, /) -> Any: ...
def device_memory(size: int, /) -> tuple[Any, int, int] | None: ...
def device_wait(stream: int, /) -> bool: ...
def overlap_any(q1: NDArray[np.float64], r12: NDArray[np.float64], q2: NDArray[np.float64], /) -> tuple[int, int]: ...
def overlap_any_indices(*args: Any) -> tuple[int, int]: ...
def contact_forces_pairs(*args: Any) -> int: ...
def neighbors(
    centers: NDArray[np.float64],
    q: NDArray[np.float64],
    cell: NDArray[np.float64] | None,
    periodic: NDArray[np.int32],
    scale: float,
    skin: float,
    /,
) -> tuple[int, int, Any, Any, Any]: ...
def neighbors_hold(*args: Any) -> tuple[int, int]: ...
def nearest_images(*args: Any) -> int: ...
def parse_rows(
    block: bytes, separator: int, kinds: bytes, /
) -> tuple[NDArray[np.float64], NDArray[np.int32], tuple[list[bytes], ...]] | None: ...
def nearest_image_limit(q: NDArray[np.float64], cell: NDArray[np.float64] | None, /) -> tuple[int, float]: ...

report_contact_pairs: np.ufunc
report_overlap_pairs: np.ufunc

#@ ufuncs

# input..., out, keywords
#@ calls
