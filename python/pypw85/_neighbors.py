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
    """A neighbour list, from `neighbors`: ``contact_pairs(list.pairs, centers, q, cell, images=list.images)``.

    Attributes
    ----------
    pairs : (n, 2) array of int32
        Indices i <= j; cannot be written to.
    images : (n, 3) array of int32
        Multiples of the cell vectors, to be added to the centre of j; 0 without a cell. Cannot be written to.
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
        """Returns whether the list still contains all pairs whose boxes intersect, without skin, after the particles and the cell have
        changed.

        It does if the box of each particle is within its old box, enlarged by half the skin on each side, up to a motion that all
        particles share. If the cell has changed, this holds after the linear map from the present cell vectors to the old ones.

        Parameters
        ----------
        centers : (n, 3) array_like
            Centres that have moved continuously, and were not wrapped into the cell in between.
        q : (n, 6) array_like
            Forms.
        cell : (3, 3) array_like, optional
            The present cell, with vectors that have changed continuously: needed if the list has a cell.

        Returns
        -------
        bool

        Raises
        ------
        PW85Error
            The list is of another number of particles, or a particle or the cell is bad.
        ValueError
            Shapes do not match, or there is no cell though the list has one, or the other way round.
        """
        if (cell is not None) is not self._has_cell:
            raise ValueError(
                "the list has a cell: pass the present cell" if self._has_cell else "the list has no cell: leave out cell"
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
    """All pairs of ellipsoids whose bounding boxes intersect, with images, each once.

    The list contains all pairs with μ² <= scale², also after the particles have moved, while `holds` returns True. Pairs have i < j, or i
    = j and an image of i itself. Their order is that of the particles in space.

    Parameters
    ----------
    centers : (n, 3) array_like
        Anywhere in space.
    q : (n, 6) array_like
        Forms.
    cell : (3, 3) array_like, optional
        Rows are the vectors of the periodic cell, however skewed and small.
    periodic : bool or three bools
        Along which vectors of the cell there are images. The other vectors do not matter.
    scale : float
        Factor of the ellipsoids, > 0.
    skin : float
        Boxes that are no farther apart than this along any axis are neighbours, too; >= 0.

    Returns
    -------
    Neighbors

    Raises
    ------
    PW85Error
        A particle is bad (its number is in the text), the cell is singular or not finite, scale or skin are out of range.
    MemoryError
        There is not enough memory.
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
    """The cell for the library: None if no vector is periodic."""
    vectors = _cell(cell)
    return vectors if periodic.any() else None, periodic
