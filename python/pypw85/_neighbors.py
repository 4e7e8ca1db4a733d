# SPDX-License-Identifier: BSD-3-Clause
"""Neighbour lists."""

from __future__ import annotations

from typing import Any
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import Status, check_status
from ._numbers import flags, real
from ._pairs import _cell, _particles
from ._typing import Floats
from ._words import counted


class Neighbors:
    """A neighbour list, as returned by `neighbors`. Use it as ``contact_pairs(list.pairs, centers, q, cell, images=list.images)``.

    Attributes
    ----------
    pairs : (n, 2) array of int32
        Indices (i, j) of particles, with i <= j; read-only.
    images : (n, 3) array of int32
        Multiples of the cell vectors to add to the centre of j; 0 without a cell. Read-only.
    """

    __slots__ = ("_has_cell", "_list", "_periodic", "images", "pairs")

    pairs: NDArray[np.int32]
    images: NDArray[np.int32]

    def __init__(
        self, _list: Any, pairs: NDArray[np.int32], images: NDArray[np.int32] | None, has_cell: bool, periodic: NDArray[np.int32]
    ) -> None:
        self._list = _list
        self._has_cell = has_cell
        self._periodic = periodic
        self.pairs = pairs
        self.images = np.zeros((len(pairs), 3), np.int32) if images is None else images

    def __len__(self) -> int:
        """Number of pairs."""
        return len(self.pairs)

    def __repr__(self) -> str:
        return f"<pypw85.Neighbors: {counted(len(self), 'pair')}>"

    def holds(self, centers: ArrayLike, q: ArrayLike, cell: ArrayLike | None = None) -> bool:
        """Tests whether the list still contains all pairs that can overlap, after the particles or the cell have changed.

        The list is complete if the bounding box of each particle is within its old box, enlarged by half the skin on each side. A
        translation that all particles share does not matter. If the cell has changed, the boxes are first mapped back by the linear map
        from the present cell vectors to the old ones.

        Parameters
        ----------
        centers : (n, 3) array_like
            Present centres. Do not wrap them into the cell while the list is in use.
        q : (n, 6) array_like
            Present forms.
        cell : (3, 3) array_like, optional
            Present cell; required if the list has a cell. Do not replace its vectors by others of the same lattice.

        Returns
        -------
        bool

        Raises
        ------
        PW85Error
            The number of particles differs from that of the list, or a particle or the cell is invalid.
        ValueError
            Shapes do not match, or only one of the list and the call has a cell.
        """
        if (cell is not None) is not self._has_cell:
            raise ValueError(
                "the list has a cell: pass the present cell" if self._has_cell else "the list has no cell: omit cell"
            )
        points, forms = _particles(centers, q)
        status, holds = _core.neighbors_holds(self._list, points, forms, *_periodic_cell(cell, self._periodic))
        check_status(status, "Neighbors.holds", "particle", centers=points, q=forms)
        return bool(holds)


def neighbors(
    centers: ArrayLike,
    q: ArrayLike,
    cell: ArrayLike | None = None,
    periodic: bool | Sequence[bool] = True,
    scale: float = 1.0,
    skin: float = 0.0,
) -> Neighbors:
    """Finds all pairs of ellipsoids whose bounding boxes intersect, including periodic images. Each pair is listed once.

    The list contains all pairs with μ² <= scale². After the particles have moved, it still contains them as long as `Neighbors.holds`
    returns True. Pairs have i < j; if a particle can overlap its own image, i = j. Pairs that are near each other in the list are also
    near each other in space.

    Parameters
    ----------
    centers : (n, 3) array_like
        Centres, inside or outside the cell.
    q : (n, 6) array_like
        Forms of the ellipsoids.
    cell : (3, 3) array_like, optional
        Rows are the vectors of the periodic cell, which may be skewed and small.
    periodic : bool or three bools
        The cell vectors along which the system is periodic. Other cell vectors are ignored.
    scale : float
        Factor by which the ellipsoids are scaled, > 0.
    skin : float
        The list also contains pairs whose boxes are at most this far apart along each axis; >= 0.

    Returns
    -------
    Neighbors

    Raises
    ------
    PW85Error
        A particle is invalid (the message contains its index), the cell is singular or not finite, or scale or skin is out of range.
    MemoryError
        Not enough memory.
    ValueError
        Shapes do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 2, [0, 0, 1])] * 2)
    >>> found = pypw85.neighbors([[0, 0, 0], [7, 0, 1]], q, cell=8 * np.eye(3))
    >>> found.pairs, found.images
    (array([[0, 1]], dtype=int32), array([[-1,  0,  0]], dtype=int32))
    """
    arrays = _particles(centers, q)
    scale, skin = real(scale, "neighbors: scale"), real(skin, "neighbors: skin")
    along = np.require(flags(periodic, "neighbors: periodic"), np.int32, ["C", "A"])
    vectors, along = _periodic_cell(cell, along)
    status, found = _core.neighbors_create(*arrays, vectors, along, scale, skin)
    if status == Status.ENOMEM:
        raise MemoryError("neighbors: " + _core.strerror(status))
    check_status(status, "neighbors", "particle", centers=arrays[0], q=arrays[1], cell=vectors, scale=scale, skin=skin)
    pairs, images = _core.neighbors_list(found)
    return Neighbors(found, pairs, None if vectors is None else images, cell is not None, along)


def _periodic_cell(cell: ArrayLike | None, periodic: NDArray[np.int32]) -> tuple[Floats | None, NDArray[np.int32]]:
    """Returns the arguments `cell` and `periodic` of the C functions: the cell is None if no vector is periodic."""
    vectors = _cell(cell)
    return vectors if periodic.any() else None, periodic
