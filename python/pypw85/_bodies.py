# SPDX-License-Identifier: BSD-3-Clause
"""Points in and on ellipsoids, triangle meshes of ellipsoids, and the ellipsoids that have the moments of meshes."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple, SupportsIndex
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._choices import choice
from ._conversions import from_moments
from ._errors import PW85Error, check_status
from ._forms import principal_axes
from ._functions import second_moments, shell_moments, surface_area, volume
from ._meshes import Mesh
from ._arrays import reals
from ._numbers import instance, integer, real, seed_of, truth
from ._typing import Floats

Fit = Literal["inscribed", "circumscribed", "volume"]
FITS: tuple[Fit, ...] = ("inscribed", "circumscribed", "volume")
# 20 n² triangles
_MOST_DIVISIONS = 512
# Beyond this ratio of the volume to the product of the extents, the moments of a closed mesh have lost most of their digits.
_LEAST_VOLUME = 1e-12
_BALL = float(volume([1, 0, 0, 1, 0, 1]))
# The memory of 2⁴⁰ points is 26 TB.
_MOST_POINTS = 2**40
_GOLDEN = (math.sqrt(5) - 1) / 2
# Steps of the tables for even points: the error of an angle is about 1e-6.
_STEPS = 1024


def inertia(q: ArrayLike, shell: bool = False) -> Floats:
    """Computes the tensors of inertia of ellipsoids of density 1 about their centres.

    The tensor is m (tr(M) I - M) with the second moments M (`second_moments`, or `shell_moments` for a shell) and the volume (the area of
    the surface) m. For a body of another density (mass per area), multiply the result by it. For a body of mass 1, divide the result by
    `volume` (`surface_area`).

    Parameters
    ----------
    q : (..., 6) array_like
        Forms of the ellipsoids.
    shell : bool
        True for a shell with the same mass per area everywhere, False for a solid body.

    Returns
    -------
    (..., 6) array
        Symmetric tensors, packed as (xx, xy, xz, yy, yz, zz), in the fifth power of the unit of length (fourth for a shell).

    Raises
    ------
    PW85Error
        A form is not finite or not positive definite.

    Examples
    --------
    A solid ellipsoid of mass 1 with the semi-axes 1, 2 and 3:

    >>> import pypw85
    >>> q = [1, 0, 0, 4, 0, 9]
    >>> (pypw85.inertia(q) / pypw85.volume(q)).round(12) + 0.0
    array([2.6, 0. , 0. , 2. , 0. , 1. ])
    """
    of_shell = truth(shell, "inertia: shell")
    moments = _as_inertia(shell_moments if of_shell else second_moments, q)
    with np.errstate(invalid="ignore"):  # the moments have told of bad rows
        mass = surface_area(q) if of_shell else volume(q)
    xx, xy, xz, yy, yz, zz = np.moveaxis(moments, -1, 0)
    tensors: Floats = np.stack([yy + zz, -xy, -xz, xx + zz, -yz, xx + yy], axis=-1) * np.asarray(mass)[..., None]
    return tensors


def _as_inertia(function: Callable[[ArrayLike], Floats], q: ArrayLike) -> Floats:
    """Calls a function of `q`. Its messages have the name of inertia()."""
    try:
        return function(q)
    except PW85Error as error:
        raise PW85Error(error.status, "inertia", error.reason, error.detail) from None
    except (TypeError, ValueError) as error:
        raise type(error)(f"inertia: {str(error).removeprefix(f'{function.__name__}: ')}") from None


def random_points(q: ArrayLike, n: SupportsIndex, seed: int = 0, surface: bool = False) -> Floats:
    """Draws random points that are uniform in the volume of an ellipsoid, or on its surface.

    Points on the surface come from uniform points on a sphere, which are stretched by the semi-axes a ≥ b ≥ c. A point (x, y, z) is then
    kept with the probability c √(x²/a⁴ + y²/b⁴ + z²/c⁴), which is proportional to the ratio of the area elements. Therefore the points
    are uniform. For every shape, at least half of the points are kept.

    Parameters
    ----------
    q : (6,) array_like
        Form of the ellipsoid, with its centre at 0.
    n : int
        Number of points.
    seed : int
        Seed of the random numbers, from 0 to 2**64 - 1. Point k depends only on `q`, `seed`, `surface` and k. The function
        ``pw85_random_points`` of C gives the same points.
    surface : bool
        True for points on the surface, False for points in the body.

    Returns
    -------
    (n, 3) array
        The points, relative to the centre of the ellipsoid.

    Raises
    ------
    PW85Error
        The form is not finite or not positive definite.

    Examples
    --------
    >>> import pypw85
    >>> points = pypw85.random_points([1, 0, 0, 4, 0, 9], 1000, seed=1, surface=True)
    >>> bool(abs(points**2 @ [1, 1/4, 1/9] - 1).max() < 1e-12)
    True
    """
    form, key = _one_form("random_points", q), seed_of(seed, "random_points: seed")
    on_surface = truth(surface, "random_points: surface")
    points = np.empty((integer(n, "random_points: n", 0, _MOST_POINTS), 3))
    check_status(_core.random_points(form, on_surface, key, points), "random_points", q=form)
    return points


def even_points(q: ArrayLike, n: SupportsIndex) -> Floats:
    """Computes points that cover the surface of an ellipsoid evenly: a Fibonacci spiral with the same area for each point.

    The points follow a spiral around the longest axis. The surface between one end of this axis and point i has the fraction
    (i + 1/2)/n of the whole area. For a sphere this is the usual Fibonacci spiral.

    Parameters
    ----------
    q : (6,) array_like
        Form of the ellipsoid, with its centre at 0.
    n : int
        Number of points.

    Returns
    -------
    (n, 3) array
        The points, relative to the centre of the ellipsoid.

    Raises
    ------
    PW85Error
        The form is not finite or not positive definite.

    Examples
    --------
    >>> import pypw85
    >>> points = pypw85.even_points([1, 0, 0, 1, 0, 1], 100)
    >>> bool(abs(points.mean(axis=0)).max() < 0.01)
    True
    """
    count = integer(n, "even_points: n", 0, _MOST_POINTS)
    semi_axes, rotation = _principal_axes_of("even_points", q)
    short, middle, long = semi_axes / semi_axes[2]
    polar = np.linspace(0, math.pi, 2 * _STEPS + 1)
    turn = np.linspace(0, 2 * math.pi, 4 * _STEPS + 1)

    def element(polar: Floats, turn: Floats) -> Floats:
        """The element of area over that of the sphere, times the shortest semi-axis."""
        across = np.cos(turn) ** 2 + (short * np.sin(turn) / middle) ** 2
        weight: Floats = np.sqrt(np.sin(polar) ** 2 * across + (short * np.cos(polar) / long) ** 2)
        return weight

    rings = np.array([element(angle, turn[1:]).sum() for angle in polar]) * np.sin(polar)
    heights = np.interp((np.arange(count) + 0.5) / max(count, 1), _shares(rings), polar)
    turns = np.empty(count)
    for i, angle in enumerate(heights):
        turns[i] = np.interp((i + 0.5) * _GOLDEN % 1, _shares(element(angle, turn)), turn)
    points = np.stack([np.sin(heights) * np.cos(turns), np.sin(heights) * np.sin(turns), np.cos(heights)], axis=-1)
    stretched: Floats = points * semi_axes
    return stretched @ rotation.T


class EllipsoidMesh(NamedTuple):
    """Result of `ellipsoid_mesh`: a triangle mesh of an ellipsoid with its centre at 0.

    - `vertices` (n, 3): coordinates of the vertices;
    - `triangles` (m, 3): indices of the vertices of each triangle, counter-clockwise as seen from outside;
    - `deviation`: upper bound of the distance between the mesh and the surface of the ellipsoid;
    - `volume`: volume of the mesh divided by that of the ellipsoid.
    """

    vertices: Floats
    triangles: NDArray[np.int32]
    deviation: float
    volume: float


def ellipsoid_mesh(q: ArrayLike, deviation: float, fit: Fit = "volume") -> EllipsoidMesh:
    """Makes a closed triangle mesh of the surface of an ellipsoid.

    The mesh is an icosahedron with divided edges, projected to the unit sphere and stretched by the semi-axes. Its number of triangles is
    chosen such that the deviation is not exceeded.

    Parameters
    ----------
    q : (6,) array_like
        Form of the ellipsoid, with its centre at 0.
    deviation : float
        Largest allowed distance between the mesh and the surface of the ellipsoid, in the unit of length, > 0.
    fit : "inscribed", "circumscribed" or "volume"
        "inscribed": the vertices are on the ellipsoid, and the volume of the mesh is too small. "circumscribed": the mesh contains the
        ellipsoid, which touches faces, and the volume is too large. "volume": the mesh has the volume of the ellipsoid.

    Returns
    -------
    vertices : (n, 3) array
        Coordinates of the vertices.
    triangles : (m, 3) array of int32
        Indices of the vertices of each triangle, counter-clockwise as seen from outside.
    deviation : float
        Upper bound of the distance between this mesh and the surface; at most the argument `deviation`.
    volume : float
        Volume of the mesh divided by the volume of the ellipsoid.

    Raises
    ------
    PW85Error
        The form is not finite or not positive definite.
    ValueError
        `deviation` is not positive, or is so small that the mesh would need more than 5 242 880 triangles.

    Examples
    --------
    >>> import pypw85
    >>> mesh = pypw85.ellipsoid_mesh([1, 0, 0, 4, 0, 9], 0.1, "inscribed")
    >>> len(mesh.triangles), round(mesh.volume, 3)
    (180, 0.941)
    """
    semi_axes, rotation = _principal_axes_of("ellipsoid_mesh", q)
    points, triangles, away, volume = sphere_mesh(deviation, semi_axes[2], fit)
    return EllipsoidMesh((points * semi_axes) @ rotation.T, triangles, away, volume)


def sphere_mesh(deviation: float, longest: float, fit: Fit) -> EllipsoidMesh:
    """The mesh of the unit sphere that is stretched. `longest` is the longest semi-axis of the ellipsoids, for which the deviation is."""
    choice(fit, "ellipsoid_mesh: fit", FITS)
    wanted = real(deviation, "ellipsoid_mesh: deviation") / longest
    if not wanted > 0:
        raise ValueError(f"ellipsoid_mesh: deviation must be positive, not {deviation}")
    # The distance falls like 1/n², up to a factor that is between 1 and 2.
    n = 1
    while True:
        points, triangles = _geodesic_sphere(n)
        h, volume = _least_height(points, triangles), _volume_of(points, triangles) / _BALL
        scale = {"inscribed": 1.0, "circumscribed": 1 / h, "volume": volume ** (-1 / 3)}[fit]
        away = max(abs(scale - 1), abs(1 - scale * h))
        if away <= wanted:
            return EllipsoidMesh(scale * points, triangles, float(away * longest), scale**3 * volume)
        needed = n * math.sqrt(away / wanted)
        n = max(n + 1, int(min(4.0 * n, needed)))
        if max(n, needed / 2) > _MOST_DIVISIONS:
            raise ValueError(f"ellipsoid_mesh: a deviation of {deviation} needs more than {20 * _MOST_DIVISIONS**2} triangles, because the "
                             f"longest semi-axis is {longest:g}: use a larger deviation")  # fmt: skip


def from_mesh(mesh: Mesh) -> tuple[Floats, Floats]:
    """Computes the ellipsoid that has the centre of mass and the second moments of the body in a closed mesh.

    The volume of the ellipsoid is that of the body only if the body is an ellipsoid.

    Parameters
    ----------
    mesh : Mesh
        Made from vertices and triangles (`pypw85.Mesh`), or read from a file (`pypw85.Mesh.read`). The mesh must be closed: each edge
        belongs to two triangles, which list its vertices in opposite orders. Vertices at the same position count as one vertex. All
        triangles may be clockwise or all counter-clockwise, as seen from outside.

    Returns
    -------
    center : (3,) array
        Centre of mass of the body.
    q : (6,) array
        Form of the ellipsoid.

    Raises
    ------
    ValueError
        The mesh is not closed, or its body has no volume.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> vertices, triangles, *_ = pypw85.ellipsoid_mesh([1, 0, 0, 4, 0, 9], 0.001)
    >>> center, q = pypw85.from_mesh(pypw85.Mesh(vertices + [1, 2, 3], triangles))
    >>> center.round(6), q.round(2) + 0.0
    (array([1., 2., 3.]), array([1., 0., 0., 4., 0., 9.]))
    """
    triangles = instance(mesh, Mesh, "from_mesh: mesh").triangles
    if not len(triangles):
        raise ValueError("from_mesh: the mesh has no triangles")
    _check_closed(mesh)
    origin = (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)) / 2
    extent = np.ptp(mesh.vertices, axis=0)
    unit = float(extent.max()) or 1.0
    points = (mesh.vertices - origin) / unit
    corners = points[triangles]
    volumes = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    volume = math.fsum(volumes)
    if not abs(volume) > _LEAST_VOLUME * np.prod(extent / unit):
        raise ValueError(f"from_mesh: the body in the mesh must have a volume, not {volume * unit**3:.3g} in a box of {extent.tolist()}")
    sums = corners.sum(axis=1)
    mean = np.einsum("i,ij->j", volumes, sums) / (4 * volume)
    outer = np.einsum("i,ikj,ikl->jl", volumes, corners, corners) + np.einsum("i,ij,il->jl", volumes, sums, sums)
    moments = outer / (20 * volume) - np.outer(mean, mean)
    return origin + unit * mean, from_moments((moments + moments.T) / 2) * unit**2


def _principal_axes_of(function: str, q: ArrayLike) -> tuple[Floats, Floats]:
    return principal_axes(_one_form(function, q))


def _one_form(function: str, q: ArrayLike) -> Floats:
    form = np.ascontiguousarray(reals(q, f"{function}: q"))
    if form.shape != (6,):
        raise ValueError(f"{function}: q must be one form with the shape (6,), not {form.shape}")
    return form


def _shares(density: Floats) -> Floats:
    """The integral of a density from its first point to each, over the whole one."""
    sums = np.concatenate([[0], np.cumsum(density[1:] + density[:-1])])
    shares: Floats = sums / sums[-1]
    return shares


def _geodesic_sphere(n: int) -> tuple[Floats, NDArray[np.int32]]:
    """Points of the unit sphere and triangles: those of an icosahedron, with edges that are divided into n parts."""
    corners, faces = _icosahedron()
    grid = np.array([(i, j) for i in range(n + 1) for j in range(n + 1 - i)])
    weights = np.column_stack([n - grid.sum(axis=1), grid]) / n
    points = np.concatenate([weights @ corners[face] for face in faces])
    number = {(int(i), int(j)): k for k, (i, j) in enumerate(grid)}
    cells = [(number[i, j], number[i + 1, j], number[i, j + 1]) for i in range(n) for j in range(n - i)]
    cells += [(number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]) for i in range(n - 1) for j in range(n - 1 - i)]
    triangles = np.concatenate([np.array(cells) + k * len(grid) for k in range(len(faces))])
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    # Points of edges belong to two faces. They differ by rounding errors, far below their distances.
    _, first, inverse = np.unique(np.round(points, 9) + 0.0, axis=0, return_index=True, return_inverse=True)
    return points[first], inverse.reshape(-1)[triangles].astype(np.int32)


def _icosahedron() -> tuple[Floats, NDArray[np.int64]]:
    golden = (1 + math.sqrt(5)) / 2
    corners = np.array([p for s in (-1, 1) for t in (-golden, golden) for p in ((0, s, t), (s, t, 0), (t, 0, s))], dtype=np.float64)
    corners /= np.linalg.norm(corners[0])
    near = corners @ corners.T > 0.4  # neighbours have the cosine 1/√5
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j) if near[i, j] and near[i, k] and near[j, k]]
    turned = [(i, j, k) if np.linalg.det(corners[[i, j, k]]) > 0 else (i, k, j) for i, j, k in faces]
    return corners, np.array(turned)


def _least_height(points: Floats, triangles: NDArray[np.int32]) -> float:
    """The least distance of the planes of faces from 0."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    return float((np.einsum("ij,ij->i", normals, a) / np.linalg.norm(normals, axis=1)).min())


def _volume_of(points: Floats, triangles: NDArray[np.int32]) -> float:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return math.fsum(np.einsum("ij,ij->i", a, np.cross(b, c))) / 6


def _check_closed(mesh: Mesh) -> None:
    """Refuses a mesh in which an edge does not have two triangles, one in each direction."""
    _, places = np.unique(mesh.vertices + 0.0, axis=0, return_inverse=True)
    merged = places.reshape(-1)[mesh.triangles].astype(np.int64)
    merged = merged[(merged != np.roll(merged, 1, axis=1)).all(axis=1)]  # those without area have no edges
    starts, ends = merged.reshape(-1), np.roll(merged, -1, axis=1).reshape(-1)
    n = len(mesh.vertices)
    ways, counts = np.unique(starts * n + ends, return_counts=True)
    one_way = ways[np.isin(ways // n + ways % n * n, ways, invert=True) | (counts > 1)]
    if not len(one_way):
        return
    start, end = (mesh.vertices[np.argmax(places.reshape(-1) == place)].tolist() for place in divmod(int(one_way[0]), n))
    raise ValueError(f"from_mesh: the mesh is not closed: {len(one_way)} edges, the first from {start} to {end}, do not have two triangles "
                     "that run along them in opposite directions: close the mesh, or turn triangles that are inside out")  # fmt: skip
