# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes."""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import PW85Error, Status, check_status
from ._mesh_files import read_triangles
from ._pairs import _particles, _rows
from ._typing import Floats
from ._words import counted


class MeshDistance(NamedTuple):
    """Result of `Mesh.distance`, with one row for each of n ellipsoids.

    - `distance` (n): signed distance; negative if the ellipsoid overlaps a triangle, infinite if the mesh has no triangles;
    - `point1`, `point2` (n, 3): the closest points (of an overlap, the deepest points) of the ellipsoid and of the mesh, relative to the
      centre of the ellipsoid;
    - `normal` (n, 3): unit vector from the ellipsoid to the mesh;
    - `triangle` (n): index of the nearest triangle, the first of several; -1 if there is none;
    - `inside` (n): 1 if the centre is inside a closed mesh, 0 if it is outside, -1 if the mesh is not closed.
    """

    distance: Floats
    point1: Floats
    point2: Floats
    normal: Floats
    triangle: NDArray[np.int32]
    inside: NDArray[np.int32]


class Mesh:
    """A mesh of triangles, such as a wall.

    The mesh is a surface: an ellipsoid inside a closed mesh overlaps the mesh only if it overlaps a triangle. A triangle without area is
    the segment or the point that has all three vertices.

    Parameters
    ----------
    vertices : (n, 3) array_like
        Coordinates of the vertices, finite.
    triangles : (m, 3) array_like of int
        Indices of the three vertices of each triangle, from 0.

    Attributes
    ----------
    vertices : (n, 3) array
        Read-only.
    triangles : (m, 3) array of int32
        Read-only.

    Raises
    ------
    PW85Error
        A vertex is not finite, or an index is out of range.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> corners = [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]]
    >>> floor = pypw85.Mesh(corners, [[0, 1, 2], [0, 2, 3]])
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> mu2, point, triangle = floor.contact([[1, 0, 4], [0, 1, 1]], [q, q])
    >>> mu2
    array([4.  , 0.25])
    >>> triangle
    array([0, 1], dtype=int32)
    >>> floor.overlap([[1, 0, 4], [0, 1, 1]], [q, q])
    array([False,  True])
    """

    __slots__ = ("_mesh", "triangles", "vertices")

    vertices: Floats
    triangles: NDArray[np.int32]

    def __init__(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        self.vertices = _rows(vertices, 3, "vertices").copy()
        self.triangles = _indices(triangles)
        status, self._mesh = _core.mesh_create(self.vertices, self.triangles)
        if status == Status.ENOMEM:
            raise MemoryError("Mesh: " + _core.strerror(status))
        check_status(status, "Mesh", vertices=self.vertices, triangles=self.triangles)
        self.vertices.setflags(write=False)
        self.triangles.setflags(write=False)

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Mesh:
        """Reads the surface mesh of a file: STL, OBJ, PLY or OFF, and the other formats of the Python package meshio.

        Polygons are divided into triangles. Volume cells, such as tetrahedra, are left out. If some of the faces cannot be read, the whole
        file is refused.

        Parameters
        ----------
        path : path
            Name of the file. Its extension determines the format.

        Returns
        -------
        Mesh

        Raises
        ------
        ImportError
            The Python package meshio is not installed.
        ValueError
            The file is broken, or has no triangles, or has faces that cannot be read. The message begins with the name of the file.
        """
        try:
            import meshio  # noqa: F401
        except ImportError as error:
            raise ImportError("Mesh.read needs meshio (Debian: python3-meshio)") from error
        try:
            return cls(*read_triangles(path))
        except PW85Error as error:
            raise ValueError(f"{os.fspath(path)}: {error}") from None

    def __len__(self) -> int:
        """Number of triangles."""
        return len(self.triangles)

    def __repr__(self) -> str:
        return f"<pypw85.Mesh: {counted(len(self), 'triangle')}, {counted(len(self.vertices), 'vertex', 'vertices')}>"

    def contact(self, centers: ArrayLike, q: ArrayLike) -> tuple[Floats, Floats, NDArray[np.int32]]:
        """Computes the contact function of each ellipsoid and the mesh: the smallest μ² over all triangles.

        Parameters
        ----------
        centers : (n, 3) array_like
            Centres of the ellipsoids.
        q : (n, 6) array_like
            Forms of the ellipsoids.

        Returns
        -------
        mu2 : (n,) array
            Square of the factor by which the ellipsoid must be scaled about its centre to touch the mesh; infinity if the mesh has no
            triangles; NaN for an invalid row.
        point : (n, 3) array
            Point at which the scaled ellipsoid touches the mesh, relative to the centre.
        triangle : (n,) array of int32
            Indices of the nearest triangles, the first of several; -1 if there is none.
        """
        arrays = _particles(centers, q)
        n = len(arrays[0])
        mu2, point, triangle = np.empty(n), np.empty((n, 3)), np.empty(n, np.int32)
        status = _core.mesh_contact_batch(self._mesh, *arrays, mu2, point, triangle)
        if status:
            _core.report_mesh_contact(status)  # as np.errstate says
        return mu2, point, triangle

    def distance(self, centers: ArrayLike, q: ArrayLike) -> MeshDistance:
        """Computes the signed distance of each ellipsoid and the mesh: the smallest signed distance to a triangle (`distance_triangle`).

        If an ellipsoid overlaps no triangle, the result is the distance to the surface. If it overlaps triangles, the result is negative:
        its magnitude is the largest depth in a single triangle, a lower bound of the length of a translation that separates the ellipsoid
        from the mesh.

        A closed mesh also bounds a solid. For an ellipsoid that overlaps no triangle, the signed distance to the solid is `distance` if
        `inside` is 0, and minus `distance` if `inside` is 1. A mesh is closed if each edge of a triangle is also an edge of another
        triangle, in the opposite direction.

        Parameters
        ----------
        centers : (n, 3) array_like
            Centres of the ellipsoids.
        q : (n, 6) array_like
            Forms of the ellipsoids.

        Returns
        -------
        MeshDistance
            NaN for an invalid row.

        Examples
        --------
        >>> import numpy as np, pypw85
        >>> corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
        >>> solid = pypw85.Mesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        >>> ball = [0.25, 0, 0, 0.25, 0, 0.25]
        >>> found = solid.distance([[1, 0.75, 1], [1, -2, 1], [1, 0.25, 1]], [ball, ball, ball])
        >>> found.distance
        array([ 0.22168784,  1.5       , -0.25      ])
        >>> found.inside
        array([1, 0, 1], dtype=int32)
        """
        arrays = _particles(centers, q)
        n = len(arrays[0])
        found = MeshDistance(np.empty(n), *np.empty((3, n, 3)), *np.empty((2, n), np.int32))
        status = _core.mesh_distance_batch(self._mesh, *arrays, *found)
        if status:
            _core.report_mesh_distance(status)  # as np.errstate says
        return found

    def overlap(self, centers: ArrayLike, q: ArrayLike) -> NDArray[np.bool_]:
        """Decides exactly whether each ellipsoid overlaps a triangle of the mesh.

        Parameters
        ----------
        centers : (n, 3) array_like
            Centres of the ellipsoids.
        q : (n, 6) array_like
            Forms of the ellipsoids.

        Returns
        -------
        (n,) array of bool

        Raises
        ------
        PW85Error
            A centre is not finite, or a form is not finite or not positive definite. The message names the row.
        """
        arrays = _particles(centers, q)
        codes = np.empty(len(arrays[0]), np.uint8)
        status = _core.mesh_overlap_batch(self._mesh, *arrays, codes)
        check_status(status, "Mesh.overlap", centers=arrays[0], q=arrays[1])
        return codes.view(np.bool_)


def _indices(triangles: ArrayLike) -> NDArray[np.int32]:
    """A copy of the indices. Numbers that int32 cannot hold become -1, which is out of range."""
    array = np.asarray(triangles)
    if array.size == 0:
        array = np.empty((0, 3), np.int32)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "iu":
        raise ValueError(f"triangles must be integers of the shape (m, 3), not {array.dtype} of the shape {array.shape}")
    fits = (array >= 0) & (array <= np.iinfo(np.int32).max)
    return np.ascontiguousarray(np.where(fits, array, -1), dtype=np.int32)

