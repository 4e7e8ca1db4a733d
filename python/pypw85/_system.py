# SPDX-License-Identifier: BSD-3-Clause
"""Systems of many ellipsoids in a cell: neighbours, contacts, overlaps, a report, a picture."""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._forms import principal_axes
from ._forces import contact_derivatives_pairs
from ._functions import ellipsoid_quaternion
from ._neighbors import Neighbors, neighbors
from ._one_against_many import nearest_image_limit
from ._pairs import _cell, _rows, contact_pairs, overlap_pairs
from ._typing import Floats

Ints = NDArray[np.int32]


class Contacts(NamedTuple):
    """Pairs of a system, by columns, in the order of μ.

    `pairs` (k, 2) are indices, `images` (k, 3) the multiples of the cell's vectors to add to the second centre, `point` (k, 3)
    lies where the first centre is counted from, `normal` (k, 3) points from the first to the second.
    """

    pairs: Ints
    images: Ints
    mu: Floats
    overlap: NDArray[np.bool_]
    point: Floats
    normal: Floats


class Report(NamedTuple):
    """Result of `System.check`."""

    particles: int
    shapeless: int
    volume: float | None
    packing_fraction: float | None
    pairs_tested: int
    overlaps: int
    smallest_mu: float | None
    nearest_image_limit: float | None
    contacts: Contacts
    worst: Contacts


class System:
    """Ellipsoids in a cell.

    Parameters
    ----------
    centers : (n, 3) array_like
    q : (n, 6) array_like
        Forms.
    cell : (3, 3) array_like, optional
        Its rows are the vectors of the cell.
    periodic : bool or three of them
        Along which vectors of the cell the system is repeated; nothing is without a cell.
    types, ids : (n) array_like, optional
        Names of types (any numbers or strings), 0 if absent; whole numbers to call particles by, else 1 to n.
    origin : (3) array_like
        Corner of the cell.
    step : int
        Time step.
    shapeless : int
        How many particles without a shape a file had besides these.
    dimensions : int
        2 if all ellipsoids lie in a plane of z and turn about z. Densities, orders and correlations are those of three dimensions,
        and are refused then.

    Attributes
    ----------
    source : str
        What was taken of the file that the system was read from, as "lengths shapex shapey shapez as diameters"; otherwise empty.
    notes : tuple of str
        What to know about that.
    """

    source: str
    notes: tuple[str, ...]
    # Implements draw(). The module that draws imports this one, and sets the function.
    _drawer: ClassVar[Callable[..., Any]]

    def __init__(
        self,
        centers: ArrayLike,
        q: ArrayLike,
        cell: ArrayLike | None = None,
        periodic: bool | ArrayLike = True,
        types: ArrayLike | None = None,
        ids: ArrayLike | None = None,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        step: int = 0,
        shapeless: int = 0,
        dimensions: int = 3,
    ) -> None:
        self.centers, self.q, self.cell = _rows(centers, 3, "centers"), _rows(q, 6, "q"), _cell(cell)
        n = len(self.centers)
        self.types = np.zeros(n, dtype=np.int64) if types is None else np.asarray(types)
        self.ids = np.arange(1, n + 1) if ids is None else _whole_numbers(ids, "ids")
        for name, rows in (("forms", self.q), ("types", self.types), ("ids", self.ids)):
            if len(rows) != n:
                raise ValueError(f"{n} centers, but {len(rows)} {name}")
        self.periodic: tuple[bool, ...] = tuple(
            map(bool, np.broadcast_to(np.asarray(periodic, dtype=bool) & (self.cell is not None), 3))
        )
        self.origin, self.step, self.shapeless = np.asarray(origin, dtype=np.float64), int(step), shapeless
        if dimensions not in (2, 3):
            raise ValueError(f"dimensions must be 2 or 3, not {dimensions}")
        self.dimensions, self.source, self.notes = dimensions, "", ()
        self._axes: tuple[Floats, Floats] | None = None

    @classmethod
    def from_axes(cls, centers: ArrayLike, semi_axes: ArrayLike, quaternions: ArrayLike, **others: Any) -> System:
        """A system from semi-axes (n, 3) and quaternions (n, 4; w, x, y, z; of any length > 0); `others` as for `System`."""
        axes = _rows(semi_axes, 3, "semi_axes"), unit_quaternions(_rows(quaternions, 4, "quaternions"))
        system = cls(centers, ellipsoid_quaternion(*axes), **others)
        system._axes = axes
        return system

    def __len__(self) -> int:
        return len(self.centers)

    def __repr__(self) -> str:
        cell = "no cell" if self.cell is None else f"cell {self.cell.tolist()}, periodic {self.periodic}"
        return f"<System of {len(self)} ellipsoids, {cell}>"

    @property
    def semi_axes(self) -> Floats:
        """Semi-axes, one row for each ellipsoid, as given to `from_axes`, or from the forms in increasing order."""
        return self._principal()[0]

    @property
    def quaternions(self) -> Floats:
        """Unit quaternions (w, x, y, z), one row for each ellipsoid, as given to `from_axes`, or from the forms."""
        return self._principal()[1]

    def _principal(self) -> tuple[Floats, Floats]:
        if self._axes is None:
            semi_axes, rotation = principal_axes(self.q)
            self._axes = semi_axes, quaternions_of(rotation)
        return self._axes

    @property
    def packing_fraction(self) -> float | None:
        """Volume of the ellipsoids over that of the cell; overlaps count twice. None without a cell, or in two dimensions."""
        if self.cell is None or self.dimensions == 2:
            return None
        return float(4 / 3 * np.pi * self.semi_axes.prod(axis=1).sum() / abs(np.linalg.det(self.cell)))

    def require_three_dimensions(self, what: str) -> None:
        """Raises ValueError for a system of two dimensions."""
        if self.dimensions == 2:
            raise ValueError(f"the system is two-dimensional, and {what} is that of three dimensions")

    def wrapped(self) -> Floats:
        """Centers within the cell, along the vectors along which it is periodic."""
        if self.cell is None:
            return self.centers
        fractions = (self.centers - self.origin) @ np.linalg.inv(self.cell)
        return self.centers - np.where(self.periodic, np.floor(fractions), 0.0) @ self.cell

    def neighbors(self, scale: float = 1.0, skin: float = 0.0) -> Neighbors:
        """Pairs whose boxes meet: see `pypw85.neighbors`."""
        return neighbors(self.centers, self.q, self.cell, self.periodic, scale, skin)

    def contacts(self, below: float = 1.0) -> Contacts:
        """All pairs with μ < `below`; with 1, those that overlap, exactly."""
        return self._contacts(self._candidates(below), below)

    def overlaps(self) -> Contacts:
        """All pairs that overlap."""
        return self.contacts()

    def check(self, worst: int = 10, below: float = 1.0) -> Report:
        """Overlaps, contacts below a μ, and the pairs with the smallest μ, whether or not these overlap."""
        tested = self._candidates(1.0)
        counts = len(tested.pairs), int(tested.overlap.sum())
        lists = [tested if below <= 1 else self._candidates(below)]
        del tested
        contacts = self._contacts(lists[0], below)
        closest = self._closest(lists, max(below, 1.0), max(worst, 1))
        return Report(
            len(self),
            self.shapeless,
            None if self.cell is None or self.dimensions == 2 else float(abs(np.linalg.det(self.cell))),
            self.packing_fraction,
            *counts,
            float(closest.mu[0]) if len(closest.mu) else None,
            nearest_image_limit(self.q, self.cell) if self.cell is not None and all(self.periodic) else None,
            contacts,
            Contacts._make(np.asarray(column)[:worst] for column in closest),
        )

    def draw(
        self,
        path: Any | None = None,
        *,
        ax: Any | None = None,
        contacts: bool = False,
        elevation: float = 20,
        azimuth: float = -60,
        size: int = 1200,
    ) -> Any:
        """Draw the ellipsoids, those that overlap in red; needs Matplotlib, except for HTML.

        Parameters
        ----------
        path : path, optional
            Of a picture (.png, .pdf, .svg), or of a page that a browser shows and turns (.html).
        ax : axes of Matplotlib, optional
            Where to draw, new ones if absent.
        contacts : bool
            Whether to mark the contact points of overlapping pairs.
        elevation, azimuth : float
            Angles of view in degrees: above the plane of x and y, and around z.
        size : int
            Pixels of the longer side.

        Returns
        -------
        axes
            None for a page.
        """
        return System._drawer(self, path, ax, contacts, elevation, azimuth, size)

    def _candidates(self, scale: float) -> _Candidates:
        found = self.neighbors(scale)
        images = None if self.cell is None else found.images
        arrays = found.pairs, self.centers, self.q, self.cell
        overlap = overlap_pairs(*arrays, images=images)
        return _Candidates(found.pairs, found.images, contact_pairs(*arrays, images=images)[0], overlap)

    def _contacts(self, candidates: _Candidates, below: float) -> Contacts:
        chosen = candidates.overlap if below == 1 else candidates.mu2 < _squared(below)
        return self._details(candidates, np.flatnonzero(chosen))

    def _closest(self, lists: list[_Candidates], scale: float, count: int) -> Contacts:
        """The pairs with the smallest μ, found from the only one of `lists`, which is for this scale.

        A list for a scale has all pairs whose μ is not larger. While it has none of these, a list for a larger scale replaces it. The
        old one is freed first: `lists` holds the only reference.
        """
        candidates = lists.pop()
        size = float(np.ptp(self.centers, axis=0).max()) if len(self) else 0.0
        reach = size + np.sqrt(self.q[:, [0, 3, 5]].max(initial=0))
        smallest_box = np.sqrt(self.q[:, [0, 3, 5]].min(initial=np.inf))
        while not (candidates.mu2 <= _squared(scale)).any() and scale * smallest_box <= reach:
            scale *= 1.25 if len(candidates.pairs) else 2.0
            del candidates
            candidates = self._candidates(scale)
        bound = _squared(scale)
        if len(candidates.mu2) > count:
            bound = min(bound, np.partition(candidates.mu2, count - 1)[count - 1])
        return self._details(candidates, np.flatnonzero(candidates.mu2 <= bound), count)

    def _details(self, candidates: _Candidates, chosen: NDArray[np.intp], count: int | None = None) -> Contacts:
        """The chosen pairs in the order of μ, up to `count` of them."""
        chosen = chosen[np.argsort(candidates.mu2[chosen], kind="stable")[:count]]
        pairs, images = candidates.pairs[chosen], candidates.images[chosen]
        # At a common centre, point and normal are NaN, which is no mistake of the input.
        with np.errstate(invalid="ignore"):
            found = contact_derivatives_pairs(
                pairs, self.centers, self.q, self.cell, None if self.cell is None else images
            )
        overlap = candidates.overlap[chosen]
        point = self.centers[pairs[:, 0]] + found.point
        return Contacts(pairs, images, np.sqrt(candidates.mu2[chosen]), overlap, point, found.normal)


class _Candidates(NamedTuple):
    pairs: Ints
    images: Ints
    mu2: Floats
    overlap: NDArray[np.bool_]


def _squared(scale: float) -> float:
    """Infinity if the square overflows, as μ² does. The operator ** would raise OverflowError."""
    return scale * scale


# In single precision, unit quaternions have lengths within 2⁻²⁴ of 1; those of GSD files stay as they are.
_UNIT = 2.0**-23


def unit_quaternions(quaternions: Floats) -> Floats:
    """Quaternions (n, 4) of length 1; NaN for those that are zero or not finite. Quaternions of length 1 stay as they are."""
    units: Floats = quaternions.copy()
    with np.errstate(invalid="ignore", over="ignore"):
        others = ~(np.abs(np.sqrt(np.einsum("ij,ij->i", units, units)) - 1) <= _UNIT)
        # Divided by their largest component first, so that no length overflows or underflows
        scaled = units[others] / np.abs(units[others]).max(axis=1, keepdims=True)
        units[others] = scaled / np.linalg.norm(scaled, axis=1, keepdims=True)
    return units


def _whole_numbers(values: ArrayLike, name: str) -> NDArray[Any]:
    numbers = np.asarray(values)
    if numbers.dtype.kind == "f" and (np.abs(numbers) < 2.0**53).all() and (numbers == np.trunc(numbers)).all():
        numbers = numbers.astype(np.int64)
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name} must be whole numbers, but they are {numbers.dtype}")
    return numbers


def quaternions_of(rotation: Floats) -> Floats:
    """Unit quaternions (n, 4; w, x, y, z) of rotation matrices (n, 3, 3).

    q is the eigenvector, for the eigenvalue 1, of the symmetric matrix that holds R as quadratic forms of q (Bar-Itzhack,
    J. Guid. Control Dyn. 23, 1085, 2000): accurate whatever the angle.
    """
    k = np.empty((len(rotation), 4, 4))
    k[:, 0, 0] = np.trace(rotation, axis1=1, axis2=2)
    k[:, 0, 1:] = k[:, 1:, 0] = (np.swapaxes(rotation, 1, 2) - rotation)[:, (1, 2, 0), (2, 0, 1)]
    k[:, 1:, 1:] = rotation + np.swapaxes(rotation, 1, 2) - k[:, 0, 0, np.newaxis, np.newaxis] * np.eye(3)
    result: Floats = np.linalg.eigh(k)[1][:, :, 3]
    return result
