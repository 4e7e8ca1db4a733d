# SPDX-License-Identifier: BSD-3-Clause
"""Voxel images of systems, as input of solvers that use fast Fourier transforms."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._forms import full
from ._numbers import instance, integer
from ._system import System
from ._typing import Floats
from .formats import FileError, check_output, refuse_standard_output, replacing


# Voxels along a vector of which the bytes of an image can be counted
MOST_VOXELS = 2**20 - 1


def voxels(system: System, resolution: int) -> NDArray[np.int32]:
    """Makes a voxel image of a system. The value of a voxel is 1 + the index of the ellipsoid that contains its centre, or 0.

    If several ellipsoids contain the centre, the value is that of the last one.

    Parameters
    ----------
    system : System
    resolution : int
        Voxels along each vector of the cell, in whose order the result is indexed.

    Returns
    -------
    (resolution, resolution, resolution) array of int32

    Raises
    ------
    ValueError
        There is no cell, or not enough memory.
    """
    instance(system, System, "voxels: system").require_three_dimensions("a voxel image")
    resolution = integer(resolution, "voxels: resolution", 1, MOST_VOXELS)
    if system.cell is None:
        raise ValueError("voxels need a cell: pass cell (of a file: --cell)")
    try:
        return _image(system, system.cell, resolution)
    except MemoryError:
        raise ValueError(f"not enough memory for {resolution}³ voxels: use a smaller resolution (--resolution)") from None


def _image(system: System, cell: Floats, resolution: int) -> NDArray[np.int32]:
    image = np.zeros((resolution,) * 3, dtype=np.int32)
    to_grid = resolution * np.linalg.inv(cell)
    # Voxel k has its centre at k + 1/2 in units of voxels.
    centers = (system.centers - system.origin) @ to_grid - 0.5
    forms = to_grid.T @ full(system.q) @ to_grid
    for k, (center, form, inverse) in enumerate(zip(centers, forms, np.linalg.inv(forms))):
        reach = np.sqrt(np.diag(form))
        ranges = [np.arange(low, high) for low, high in zip(np.ceil(center - reach), np.floor(center + reach) + 1)]
        offset = np.stack(np.meshgrid(*ranges, indexing="ij"), axis=-1) - center
        inside = np.einsum("...i,ij,...j", offset, inverse, offset) <= 1
        cells = (offset[inside] + center).round().astype(np.intp)
        kept = np.all((cells >= 0) & (cells < resolution) | system.periodic, axis=1)
        image[tuple((cells[kept] % resolution).T)] = k + 1
    return image


def check_voxels_name(path: str, cell: Floats | None = None) -> None:
    """Checks the name and the format of the file, which may not support the cell. Call it before the work."""
    refuse_standard_output(path, "the suffix of the name chooses the format of a voxel image")
    if not path.lower().endswith((".h5", ".hdf5", ".vtk")):
        raise FileError(path, "the name of a voxel image must end with .h5, .hdf5 or .vtk")
    check_output(path)
    if cell is not None and path.lower().endswith(".vtk") and (cell != np.diag(np.diag(cell))).any():
        raise ValueError("the cell must be rectangular for an image of VTK: write the voxels as .h5")


def save_voxels(path: str, system: System, resolution: int) -> None:
    """Writes a data set "voxels" of HDF5 with cell and origin, or an image of VTK's legacy format (rectangular cells only)."""
    check_voxels_name(path, system.cell)
    image = voxels(system, resolution)
    with replacing(path) as temporary:
        if path.lower().endswith((".h5", ".hdf5")):
            _save_hdf5(temporary, system, image)
        else:
            _save_vtk(temporary, system, image)


def _save_hdf5(path: str, system: System, image: NDArray[Any]) -> None:
    import h5py

    with h5py.File(path, "w") as file:
        data = file.create_dataset("voxels", data=image, compression="gzip")
        data.attrs["cell"], data.attrs["origin"] = system.cell, system.origin


def _save_vtk(path: str, system: System, image: NDArray[Any]) -> None:
    """Writes VTK's legacy format. The index of x varies fastest, and numbers are big-endian."""
    assert system.cell is not None
    n = len(image)
    spacing, origin = np.diag(system.cell) / n, system.origin
    header = [
        "# vtk DataFile Version 3.0", "voxels of pw85", "BINARY", "DATASET STRUCTURED_POINTS",
        f"DIMENSIONS {n + 1} {n + 1} {n + 1}", "ORIGIN {:.17g} {:.17g} {:.17g}".format(*origin),
        "SPACING {:.17g} {:.17g} {:.17g}".format(*spacing), f"CELL_DATA {n**3}", "SCALARS ellipsoid int 1", "LOOKUP_TABLE default",
    ]  # fmt: skip
    with open(path, "wb") as file:
        file.write("\n".join([*header, ""]).encode())
        file.write(image.transpose(2, 1, 0).astype(">i4").tobytes())
