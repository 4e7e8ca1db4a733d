# SPDX-License-Identifier: BSD-3-Clause
"""Systems of ellipsoids in a cell: neighbours, contacts, overlaps, reports, pictures."""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._choices import choice
from ._errors import PW85Error
from ._forms import principal_axes
from ._forces import contact_derivatives_pairs
from ._functions import cell_reduce, ellipsoid_quaternion
from ._neighbors import Neighbors, neighbors
from ._arrays import reals
from ._numbers import flags, integer, positive
from ._words import counted, shown
from ._one_against_many import nearest_image_limit
from ._pairs import _cell, _rows, contact_pairs, overlap_pairs
from ._rotations import quaternions_along, quaternions_of_euler
from ._typing import Floats

Ints = NDArray[np.int32]


class Contacts(NamedTuple):
    """Pairs of a system in the order of increasing μ, one array per quantity.

    - `pairs` (k, 2): indices of the two particles, from 0;
    - `images` (k, 3): multiples of the cell vectors to add to the centre of the second particle;
    - `mu` (k): μ, the factor by which both ellipsoids must be scaled to touch;
    - `overlap` (k): True if the pair overlaps, by the exact test;
    - `point` (k, 3): contact point of the scaled ellipsoids, in the coordinates of the system; NaN for coincident centres;
    - `normal` (k, 3): unit normal at this point, from the first particle to the second; NaN for coincident centres.
    """

    pairs: Ints
    images: Ints
    mu: Floats
    overlap: NDArray[np.bool_]
    point: Floats
    normal: Floats


class Report(NamedTuple):
    """Result of `System.check`.

    - `particles`: number of particles with a shape;
    - `shapeless`: number of particles of the file that have no shape, and were not checked;
    - `volume`, `packing_fraction`: as the properties of `System`; None without a cell;
    - `pairs_tested`: number of pairs whose bounding boxes intersect, including images;
    - `overlaps`: number of overlapping pairs;
    - `smallest_mu`: smallest μ of all pairs; None if there is no pair;
    - `nearest_image_limit`: as `pypw85.nearest_image_limit`. If it is below 1, a program that tests only nearest images can miss overlaps
      (this package tests all images). None without a cell;
    - `contacts`: the pairs with μ < `below`;
    - `worst`: the `worst` pairs with the smallest μ;
    - `dimensions`: 3, or 2 for ellipses.
    """

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
    dimensions: int = 3


class System:
    """A system of ellipsoids in a cell, or of ellipses in a plane.

    Parameters
    ----------
    centers : (n, 3) array_like
        Centres of the particles.
    q : (n, 6) array_like
        Forms of the particles.
    cell : (3, 3) array_like, optional
        Rows are the vectors of the cell.
    periodic : bool or three bools
        The cell vectors along which the system is periodic. A system without a cell is not periodic.
    types : (n) array_like, optional
        Types of the particles, any numbers or strings. By default 0.
    ids : (n) array_like of int, optional
        Integers that identify the particles in files and messages. By default 1 to n.
    origin : (3) array_like
        Corner of the cell from which the cell vectors start. By default 0.
    step : int
        Time step.
    shapeless : int
        Number of particles of a file that have no shape, and therefore are not in the system.
    dimensions : int
        2 for a system of ellipses: all centres have the same z, and z is a principal axis of each ellipsoid. The ellipses are the
        sections of the ellipsoids with this plane. Densities, order parameters and correlations are then those of the plane. The third
        cell vector is ignored: it becomes (0, 0, 1), from z = -1/2, and is not periodic. The centres become z = 0.

    Attributes
    ----------
    source : str
        How the columns of the file were read, such as "lengths shapex shapey shapez as diameters"; empty if the system is not from a file.
    notes : tuple of str
        Warnings of the reader of the file.

    Raises
    ------
    ValueError
        Shapes of arrays do not match; or, with `dimensions` 2, the particles are not ellipses in one plane.

    Examples
    --------
    Two spheres of radius 1 in a periodic cube, which overlap through a face of the cube:

    >>> import numpy as np, pypw85
    >>> q = [[1, 0, 0, 1, 0, 1]] * 2
    >>> system = pypw85.System([[0.5, 5, 5], [9, 5, 5]], q, cell=10 * np.eye(3))
    >>> found = system.overlaps()
    >>> found.pairs.tolist(), found.images.tolist(), found.mu.tolist()
    ([[0, 1]], [[-1, 0, 0]], [0.75])
    """

    source: str
    notes: tuple[str, ...]
    # Implements draw(). The module _drawing imports this module, and sets the function.
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
        self.types = np.zeros(n, dtype=np.int64) if types is None else np.atleast_1d(types)
        self.ids = np.arange(1, n + 1) if ids is None else _different(np.atleast_1d(_whole_numbers(ids, "ids")))
        for name, rows in (("form", self.q), ("type", self.types), ("id", self.ids)):
            if len(rows) != n:
                raise ValueError(f"{counted(n, 'center')}, but {counted(len(rows), name, name + 's')}")
        self.periodic: tuple[bool, ...] = tuple(map(bool, flags(periodic, "periodic") & (self.cell is not None)))
        self.origin, self.step, self.shapeless = reals(origin, "origin"), integer(step, "step", None), integer(shapeless, "shapeless")
        if self.origin.shape != (3,) or not np.isfinite(self.origin).all():
            raise ValueError(f"origin must be three finite numbers, not {shown(origin)}")
        self.dimensions, self.source, self.notes = choice(dimensions, "dimensions", (2, 3)), "", ()
        self._axes: tuple[Floats, Floats] | None = None
        if dimensions == 2:
            self._flatten()
        if self.cell is not None:
            _check_vectors(self.cell)

    def _flatten(self) -> None:
        """Sets the coordinates and the cell vector along z to the values of all two-dimensional systems."""
        if not is_planar(self.centers, self.q):
            raise ValueError("ellipses must lie in a plane z = constant, with z as a principal axis of each ellipsoid")
        self.centers, self.q, self.origin = self.centers.copy(), self.q.copy(), self.origin.copy()
        self.centers[:, 2], self.q[:, [2, 4]] = 0, 0
        if self.cell is None:
            return
        if self.cell[:2, 2].any():
            raise ValueError("the first two vectors of the cell must lie in the plane of the ellipses, without components along z")
        self.cell = np.vstack([self.cell[:2], [0.0, 0.0, 1.0]])
        self.periodic, self.origin[2] = (*self.periodic[:2], False), -0.5

    @classmethod
    def from_axes(cls, centers: ArrayLike, semi_axes: ArrayLike, quaternions: ArrayLike, **others: Any) -> System:
        """Make a system from semi-axes and quaternions.

        Parameters
        ----------
        centers : (n, 3) array_like
            Centres of the particles.
        semi_axes : (n, 3) array_like
            Semi-axes along x, y and z of the body frame, > 0.
        quaternions : (n, 4) array_like
            Rotations (w, x, y, z) from the body frame to the space frame, of any length > 0.
        **others
            As for `System`. With ``dimensions=2`` the semi-axes and quaternions are reordered such that the quaternions are rotations about
            z, and the third semi-axis is along z.

        Returns
        -------
        System

        Raises
        ------
        ValueError
            Shapes of arrays do not match.

        Examples
        --------
        >>> import pypw85
        >>> system = pypw85.System.from_axes([[0, 0, 0]], [[1, 2, 3]], [[1, 0, 0, 0]])
        >>> system.q
        array([[1., 0., 0., 4., 0., 9.]])
        """
        given = _rows(semi_axes, 3, "semi_axes"), _rows(quaternions, 4, "quaternions")
        axes = given[0], unit_quaternions(given[1])
        system = cls(centers, _forms_of(axes, given), **others)
        system._axes = _about_z(*axes, system.q) if system.dimensions == 2 else axes
        if system._axes is not axes:
            system.q = ellipsoid_quaternion(*system._axes)
        return system

    @classmethod
    def from_euler(
        cls, centers: ArrayLike, semi_axes: ArrayLike, euler: str, angles: ArrayLike, angle: str = "radians", **others: Any
    ) -> System:
        """Make a system from semi-axes and Euler angles.

        Parameters
        ----------
        centers, semi_axes : (n, 3) array_like
        euler : str
            The axes of the rotations: lower case for fixed axes, upper case for axes that rotate with the body, as in `from_euler`.
        angles : (n, number of axes) array_like
        angle : str
            "radians" or "degrees".
        **others
            As for `System`.

        Returns
        -------
        System
        """
        choice(angle, "System.from_euler: angle", ("radians", "degrees"))
        turns = reals(angles, "angles")
        return cls.from_axes(centers, semi_axes, quaternions_of_euler(euler, np.radians(turns) if angle == "degrees" else turns), **others)

    @classmethod
    def from_directions(cls, centers: ArrayLike, across: ArrayLike, along: ArrayLike, directions: ArrayLike, **others: Any) -> System:
        """Make a system of spheroids from the directions of their axes of revolution.

        Parameters
        ----------
        centers : (n, 3) array_like
        across, along : (n) array_like
            Equatorial and polar radii: semi-axes perpendicular to the axis of revolution and along it.
        directions : (n, 3) array_like
            Of any length > 0.
        **others
            As for `System`.

        Returns
        -------
        System
        """
        turns = _rows(directions, 3, "directions")
        if not (np.isfinite(turns).all() and np.abs(turns).max(axis=1, initial=0).all()):
            raise ValueError("directions must be finite and not zero")
        size = np.broadcast_to(reals(across, "across"), len(turns))
        return cls.from_axes(centers, np.stack([size, size, np.broadcast_to(reals(along, "along"), len(turns))], axis=1),
                             quaternions_along(turns), **others)  # fmt: skip

    @classmethod
    def from_ellipses(
        cls,
        centers: ArrayLike,
        semi_axes: ArrayLike,
        angles: ArrayLike,
        cell: ArrayLike | None = None,
        periodic: bool | ArrayLike = True,
        origin: ArrayLike = (0.0, 0.0),
        **others: Any,
    ) -> System:
        """Make a two-dimensional system of ellipses.

        Parameters
        ----------
        centers : (n, 2) array_like
        semi_axes : (n, 2) array_like
        angles : (n) array_like
            Angles from x to the first semi-axis, in radians.
        cell : (2, 2) array_like, optional
            Rows are the vectors of the cell.
        periodic : bool or two bools
            The cell vectors along which the system is periodic.
        origin : (2) array_like
            Corner of the cell.
        **others
            As for `System`.

        Returns
        -------
        System
            The ellipses are sections of its ellipsoids. The semi-axis along z is the shorter semi-axis of the ellipse.

        Raises
        ------
        ValueError
            Shapes do not match.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> centers, semi_axes, angles = [[0, 0], [0, 2]], [[3, 1], [3, 1]], [0, np.pi / 2]
        >>> system = pypw85.System.from_ellipses(centers, semi_axes, angles, 9 * np.eye(2))
        >>> system.dimensions, len(system.overlaps().mu), round(system.packing_fraction, 4)
        (2, 1, 0.2327)
        """
        places, axes = _rows(centers, 2, "centers"), _rows(semi_axes, 2, "semi_axes")
        turns = reals(angles, "angles")
        if not len(places) == len(axes) == turns.size or turns.ndim != 1:
            raise ValueError("centers, semi_axes and angles must have the same length, "
                             f"not {len(places)}, {len(axes)} and the shape {turns.shape}")  # fmt: skip
        if not np.isfinite(turns).all():
            row = int(np.isfinite(turns).argmin())
            raise ValueError(f"System.from_ellipses: particle {row}: angles must be finite, not {turns[row]}")
        corner = reals(origin, "origin")
        if corner.shape != (2,):
            raise ValueError(f"the shape of origin must be (2,), not {corner.shape}")
        return cls.from_axes(
            np.column_stack([places, np.zeros(len(places))]), np.column_stack([axes, axes.min(axis=1)]), quaternions_about_z(turns),
            cell=None if cell is None else _cell_of_plane(cell), periodic=(*flags(periodic, "periodic", 2), False),
            origin=(*corner, -0.5), dimensions=2, **others,
        )  # fmt: skip

    def __len__(self) -> int:
        return len(self.centers)

    def __repr__(self) -> str:
        cell = "no cell" if self.cell is None else f"cell {self.cell.tolist()}, periodic {self.periodic}"
        return f"<System of {len(self)} {'ellipsoids' if self.dimensions == 3 else 'ellipses in a plane'}, {cell}>"

    @property
    def semi_axes(self) -> Floats:
        """Semi-axes (n, 3), as given to `from_axes`, or computed from the forms in increasing order."""
        return self._principal()[0]

    @property
    def quaternions(self) -> Floats:
        """Unit quaternions (n, 4), w first, as given to `from_axes`, or computed from the forms."""
        return self._principal()[1]

    def _principal(self) -> tuple[Floats, Floats]:
        if self._axes is None and self.dimensions == 2:
            self._axes = _axes_of_ellipses(self.q)
        if self._axes is None:
            semi_axes, rotation = principal_axes(self.q)
            self._axes = semi_axes, quaternions_of(rotation)
        return self._axes

    @property
    def angles(self) -> Floats:
        """Angles of ellipses from x to the first semi-axis, in radians, from -π/2 to π/2. ValueError in three dimensions."""
        if self.dimensions != 2:
            raise ValueError("the system must be two-dimensional: only ellipses have angles")
        turned = 2 * np.arctan2(self.quaternions[:, 3], self.quaternions[:, 0])
        angles: Floats = turned - np.pi * np.round(turned / np.pi)
        return angles

    @property
    def volume(self) -> float | None:
        """Volume of the cell, or its area in two dimensions; None without a cell."""
        if self.cell is None:
            return None
        (a, b), (c, d) = (map(float, vector) for vector in self.cell[:2, :2])  # exact for rectangles
        return abs(a * d - b * c) if self.dimensions == 2 else float(abs(np.linalg.det(self.cell)))

    @property
    def density(self) -> float | None:
        """Number of ellipsoids per volume, or per area in two dimensions; None without a cell."""
        volume = self.volume
        return None if volume is None else len(self) / volume

    @property
    def packing_fraction(self) -> float | None:
        """Volume of the ellipsoids over the volume of the cell, in two dimensions area over area. A region inside two ellipsoids counts
        twice. None without a cell."""
        volume = self.volume
        if volume is None:
            return None
        return float(UNIT_BALL[self.dimensions] * self.semi_axes[:, : self.dimensions].prod(axis=1).sum() / volume)

    def require_three_dimensions(self, what: str) -> None:
        """Raises ValueError for a system of two dimensions."""
        if self.dimensions == 2:
            raise ValueError(f"the system must be three-dimensional for {what}")

    def wrapped(self) -> Floats:
        """Returns the centres wrapped into the cell, along its periodic vectors."""
        if self.cell is None:
            return self.centers
        fractions = (self.centers - self.origin) @ np.linalg.inv(self.cell)
        return self.centers - np.where(self.periodic, np.floor(fractions), 0.0) @ self.cell

    def neighbors(self, scale: float = 1.0, skin: float = 0.0) -> Neighbors:
        """Find all pairs whose bounding boxes intersect: see `pypw85.neighbors`."""
        return neighbors(self.centers, self.q, self.cell, self.periodic, scale, skin)

    def contacts(self, below: float = 1.0) -> Contacts:
        """Find all pairs with μ < `below`, including images. For `below` = 1 the exact test decides.

        Parameters
        ----------
        below : float
            Limit of μ, > 0.

        Returns
        -------
        Contacts
        """
        below = positive(below, "System.contacts: below")
        return self._contacts(self._candidates(below), below)

    def overlaps(self) -> Contacts:
        """Find all pairs that overlap, including images, by the exact test.

        Returns
        -------
        Contacts
        """
        return self.contacts()

    def check(self, worst: int = 10, below: float = 1.0) -> Report:
        """Find the overlaps, the pairs with μ < `below`, and the `worst` pairs with the smallest μ, whether they overlap or not.

        Parameters
        ----------
        worst : int
            Number of pairs in ``worst`` of the result, at least 0.
        below : float
            Limit of μ for the pairs in ``contacts`` of the result, > 0. 1 means the overlapping pairs.

        Returns
        -------
        Report

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> q = [[1, 0, 0, 1, 0, 1]] * 2
        >>> system = pypw85.System([[0.5, 5, 5], [9, 5, 5]], q, cell=10 * np.eye(3))
        >>> report = system.check(worst=1)
        >>> report.overlaps, report.smallest_mu, round(report.packing_fraction, 4)
        (1, 0.75, 0.0084)
        """
        worst, below = integer(worst, "System.check: worst"), positive(below, "System.check: below")
        tested = self._candidates(1.0)
        counts = len(tested.pairs), int(tested.overlap.sum())
        lists = [tested if below <= 1 else self._candidates(below)]
        del tested
        contacts = self._contacts(lists[0], below)
        closest = self._closest(lists, max(below, 1.0), max(worst, 1))
        return Report(
            len(self),
            self.shapeless,
            self.volume,
            self.packing_fraction,
            *counts,
            float(closest.mu[0]) if len(closest.mu) else None,
            self._nearest_image_limit(),
            contacts,
            Contacts._make(np.asarray(column)[:worst] for column in closest),
            self.dimensions,
        )

    def _nearest_image_limit(self) -> float | None:
        """As `nearest_image_limit`; None unless the system is periodic in all directions."""
        if self.cell is None or not all(self.periodic[: self.dimensions]):
            return None
        cell = self.cell
        if self.dimensions == 2:  # a vector along z so long that its images do not matter
            cell = np.vstack([cell[:2], [0, 0, np.abs(cell).sum() + 4 * self.semi_axes.max(initial=0)]])
        return nearest_image_limit(self.q, cell)

    def draw(
        self,
        path: Any | None = None,
        *,
        ax: Any | None = None,
        contacts: bool = False,
        elevation: float = 20,
        azimuth: float = -60,
        size: int = 1200,
        color: str = "overlaps",
    ) -> Any:
        """Draw the ellipsoids. Ellipsoids that overlap are red. Pictures need Matplotlib; HTML pages do not.

        Centres are wrapped into the cell along its periodic vectors. If the nematic order is at least 0.2, an arrow shows the director;
        its length is the nematic order times half an edge of the cell. Ellipses in a plane are coloured by their angles, and have red
        edges if they overlap; images that extend into the cell are pale. HTML pages and angles of view are for three dimensions only.

        Parameters
        ----------
        path : path, optional
            File for a picture (.png, .pdf, .svg), or for an interactive page for a browser (.html).
        ax : matplotlib.axes.Axes, optional
            Axes to draw in. By default new axes are made.
        contacts : bool
            True to mark the contact points of overlapping pairs.
        elevation, azimuth : float
            Angles of view in degrees: above the plane of x and y, and around z.
        size : int
            Pixels of the longer side.
        color : str
            Meaning of the colours: `"overlaps"`; `"orientation"`, where the components of the main axis along x, y and z are red, green
            and blue; or `"type"`.

        Returns
        -------
        axes
            None for an HTML page.
        """
        return System._drawer(self, path, ax, contacts, elevation, azimuth, size, color)

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
        """Returns the `count` pairs with the smallest μ. `lists` has one element: the candidates for this scale.

        Candidates for a scale include all pairs with μ <= scale. If there are no such pairs, the scale is increased, and the candidates
        are found again. The old candidates are freed first: `lists` must hold the only reference to them.
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
        """Returns the chosen pairs in the order of increasing μ, at most `count`."""
        chosen = chosen[np.argsort(candidates.mu2[chosen], kind="stable")[:count]]
        pairs, images = candidates.pairs[chosen], candidates.images[chosen]
        # Point and normal of concentric ellipsoids are NaN: this is not an error of the input.
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
    """The square; infinity if it overflows, where the operator ** would raise OverflowError."""
    return scale * scale


# Volume of the ball of radius 1, by the number of dimensions
UNIT_BALL = {2: np.pi, 3: 4 / 3 * np.pi}
# Tolerance for quaternions in single precision. Errors of 2⁻²⁴ of the components tilt the axis z by up to 2⁻²², and change the form by
# up to this angle times its largest entry.
_TILTED = 2.0**-21


def is_planar(centers: Floats, q: Floats) -> bool:
    """Returns whether all centres have the same z, and z is a principal axis of all forms, up to quaternions in single precision."""
    if not len(centers):
        return True
    return bool(np.ptp(centers[:, 2]) == 0 and (np.abs(q[:, [2, 4]]).max(axis=1) <= _TILTED * q.max(axis=1)).all())


def quaternions_about_z(angles: Floats) -> Floats:
    """Unit quaternions (n, 4) of rotations about z by angles (n)."""
    zero = np.zeros(len(angles))
    return np.stack([np.cos(angles / 2), zero, zero, np.sin(angles / 2)], axis=1)


def _about_z(semi_axes: Floats, quaternions: Floats, q: Floats) -> tuple[Floats, Floats]:
    """Permutes the semi-axes so that the last one is along z, with quaternions that are rotations about z. The forms q do not change.
    Ellipsoids whose quaternions already are rotations about z are not changed."""
    others = np.flatnonzero(quaternions[:, 1:3].any(axis=1))
    if not len(others):
        return semi_axes, quaternions
    axes, turns = semi_axes.copy(), quaternions.copy()
    axes[others], turns[others] = _axes_of_ellipses(q[others])
    w, v = quaternions[others, :1], quaternions[others, 1:]
    columns = [unit + 2 * (w * np.cross(v, unit) + np.cross(v, np.cross(v, unit))) for unit in np.eye(3)]
    for up in range(3):  # if semi-axis `up` is along z, the semi-axes are only permuted, without rounding
        upright = np.abs(columns[up][:, 2]) > 1 - _TILTED
        rows, first, second = others[upright], (up + 1) % 3, (up + 2) % 3
        axes[rows] = semi_axes[rows][:, [first, second, up]]
        turns[rows] = quaternions_about_z(np.arctan2(columns[first][upright, 1], columns[first][upright, 0]))
    return axes, turns


def _axes_of_ellipses(q: Floats) -> tuple[Floats, Floats]:
    """Semi-axes, of which the last is along z, and quaternions about z, from forms."""
    squares, rotation = np.linalg.eigh(q[:, [0, 1, 1, 3]].reshape(-1, 2, 2))
    semi_axes = np.sqrt(np.column_stack([squares, q[:, 5]]))
    return semi_axes, quaternions_about_z(np.arctan2(rotation[:, 1, 0], rotation[:, 0, 0]))


def _forms_of(axes: tuple[Floats, Floats], given: tuple[Floats, Floats]) -> Floats:
    """Forms from semi-axes and unit quaternions. The message for an invalid particle shows the numbers as the user gave them."""
    with np.errstate(invalid="ignore"):
        q: Floats = np.asarray(ellipsoid_quaternion(*axes))
    bad = np.isnan(q).any(axis=1)
    if bad.any():
        row = int(bad.argmax())
        try:
            ellipsoid_quaternion(given[0][row], given[1][row])
        except PW85Error as error:
            detail = f"particle {row}: {error.detail.replace('quaternion_wxyz', 'quaternions')}"
            raise PW85Error(error.status, "System.from_axes", error.reason, detail) from None
    return q


def _cell_of_plane(cell: ArrayLike) -> Floats:
    rows = reals(cell, "cell")
    if rows.shape != (2, 2):
        raise ValueError(f"the shape of the cell of a plane must be (2, 2), not {rows.shape}")
    result = np.eye(3)
    result[:2, :2] = rows
    return result


# Tolerance on the length of a unit quaternion. In single precision (GSD files) lengths are within 2⁻²⁴ of 1; these are not normalised.
_UNIT = 2.0**-23


def unit_quaternions(quaternions: Floats) -> Floats:
    """Normalises quaternions (n, 4). The result is NaN for zero or not finite. Unit quaternions are not changed."""
    units: Floats = quaternions.copy()
    with np.errstate(invalid="ignore", over="ignore"):
        others = ~(np.abs(np.sqrt(np.einsum("ij,ij->i", units, units)) - 1) <= _UNIT)
        # Division by the largest component: no length overflows or underflows
        scaled = units[others] / np.abs(units[others]).max(axis=1, keepdims=True)
        units[others] = scaled / np.linalg.norm(scaled, axis=1, keepdims=True)
    return units


def _whole_numbers(values: ArrayLike, name: str) -> NDArray[Any]:
    numbers = np.asarray(values)
    if numbers.dtype.kind == "f" and (np.abs(numbers) < 2.0**53).all() and (numbers == np.trunc(numbers)).all():
        numbers = numbers.astype(np.int64)
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name} must be integers, not {numbers.dtype}")
    return numbers


def _different(ids: NDArray[Any]) -> NDArray[Any]:
    """Checks that all ids differ."""
    known, counts = np.unique(ids, return_counts=True)
    if len(known) < ids.size:
        raise ValueError(f"ids must be different, not {known[counts > 1][0]} twice")
    return ids


def _check_vectors(cell: Floats) -> None:
    """Checks that the cell vectors are independent. They are scaled first, because in two dimensions the third one has length 1 in any
    unit."""
    lengths = np.frexp(np.abs(cell).max(axis=1, keepdims=True))[1]
    try:
        cell_reduce(np.ldexp(cell, -lengths) if np.isfinite(cell).all() else cell)
    except PW85Error as error:
        raise PW85Error(error.status, "System", error.reason, error.detail) from None


def quaternions_of(rotation: Floats) -> Floats:
    """Unit quaternions (n, 4; w, x, y, z) of rotation matrices (n, 3, 3).

    q is the eigenvector of the largest eigenvalue of a symmetric 4×4 matrix (Bar-Itzhack, J. Guid. Control Dyn. 23, 1085, 2000). This
    method is accurate for all angles.
    """
    k = np.empty((len(rotation), 4, 4))
    k[:, 0, 0] = np.trace(rotation, axis1=1, axis2=2)
    k[:, 0, 1:] = k[:, 1:, 0] = (np.swapaxes(rotation, 1, 2) - rotation)[:, (1, 2, 0), (2, 0, 1)]
    k[:, 1:, 1:] = rotation + np.swapaxes(rotation, 1, 2) - k[:, 0, 0, np.newaxis, np.newaxis] * np.eye(3)
    result: Floats = np.linalg.eigh(k)[1][:, :, 3]
    return result
