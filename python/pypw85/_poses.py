# SPDX-License-Identifier: BSD-3-Clause
"""Distances of an ellipsoid and a solid that are given by their poses, with the derivatives with respect to these."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._functions import distance_segment, distance_solid_box, distance_triangle, ellipsoid
from ._meshes import Mesh
from ._typing import Floats

# The largest deviation of RᵀR from the identity, as for pypw85.ellipsoid().
_TOLERANCE = 1e-6


class PoseDistance(NamedTuple):
    """Result of `pose_distance`: the signed distance of an ellipsoid and a solid, in the world frame.

    `distance`, `point1`, `point2`, `normal`, `d_pose1` and `d_pose2` are described there.
    """

    distance: float
    point1: Floats
    point2: Floats
    normal: Floats
    d_pose1: Floats
    d_pose2: Floats


def _rotation(orientation: Any, name: str) -> Floats:
    """The matrix of a rotation matrix, a quaternion w x y z or a Rotation of SciPy."""
    given = np.asarray(orientation.as_matrix() if hasattr(orientation, "as_matrix") else orientation, dtype=np.float64)
    if given.shape == (4,):
        norm = np.linalg.norm(given)
        if not (np.isfinite(norm) and norm > 0):
            raise ValueError(f"{name}: the quaternion must be finite and not zero, not {given.tolist()}")
        w, v = given[0] / norm, given[1:] / norm
        cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
        return np.asarray(np.eye(3) + 2 * w * cross + 2 * cross @ cross)
    if given.shape != (3, 3):
        raise ValueError(f"{name}: an orientation must be a 3x3 matrix or a quaternion w x y z, not an array of shape {given.shape}")
    if not (np.abs(given.T @ given - np.eye(3)) <= _TOLERANCE).all() or np.linalg.det(given) < 0:
        raise ValueError(f"{name}: the 3x3 matrix must be a rotation: RᵀR = I to {_TOLERANCE} and det R = 1")
    return given


def _pose(pose: Any, name: str) -> tuple[Floats, Floats]:
    """The rotation matrix and the translation of a pose."""
    if pose is None:
        return np.eye(3), np.zeros(3)
    if isinstance(pose, (tuple, list)) and len(pose) == 2:
        rotation, translation = _rotation(pose[0], name), np.asarray(pose[1], dtype=np.float64)
    else:
        matrix = np.asarray(pose, dtype=np.float64)
        if matrix.shape != (4, 4) or (matrix[3] != [0, 0, 0, 1]).any():
            raise ValueError(f"{name} must be (orientation, translation), or a 4x4 matrix with the last row 0 0 0 1")
        rotation, translation = _rotation(matrix[:3, :3], name), matrix[:3, 3]
    if translation.shape != (3,) or not np.isfinite(translation).all():
        raise ValueError(f"{name}: the translation must be three finite numbers, not {translation.tolist()}")
    return rotation, translation


def _solid(solid: Any) -> Floats | Mesh:
    """Checks the shape of a solid that is not a mesh."""
    if isinstance(solid, Mesh):
        return solid
    body = np.asarray(solid, dtype=np.float64)
    if body.shape not in ((3,), (2, 3), (3, 3)):
        raise ValueError(f"a solid must be 3 half lengths, 2 ends, 3 vertices or a pypw85.Mesh, not an array of shape {body.shape}")
    return body


def _distance(solid: Floats | Mesh, center: Floats, q: Floats) -> tuple[Any, ...]:
    """The signed distance in the frame of the solid, with points relative to the centre of the ellipsoid."""
    if isinstance(solid, Mesh):
        if not len(solid):
            raise ValueError("the mesh has no triangles")
        return tuple(rows[0] for rows in solid.distance([center], [q])[:4])
    if solid.shape == (3,):
        if not (solid >= 0).all():
            raise ValueError(f"the half lengths of a box must be >= 0, not {solid.tolist()}")
        return tuple(distance_solid_box(-solid - center, solid - center, q))
    points = solid - center
    if solid.shape == (2, 3):
        return tuple(distance_segment(points[0], points[1], q))
    return tuple(distance_triangle(points[0], points[1], points[2], q))


def pose_distance(semi_axes: ArrayLike, pose1: Any, solid: ArrayLike | Mesh, pose2: Any = None) -> PoseDistance:
    """Computes the signed distance of an ellipsoid and a box, a segment, a triangle or a mesh, each with a pose.

    A pose maps the body frame to the world frame: x becomes R x + t. It is a pair of an orientation and a translation, a 4×4
    matrix with the last row 0 0 0 1, or None for the identity. The orientation is a rotation matrix (3×3), a quaternion w x y z of any
    length, or a ``scipy.spatial.transform.Rotation``.

    Parameters
    ----------
    semi_axes : (3) array_like
        Semi-axes of the ellipsoid along the axes of its body frame, > 0.
    pose1 : pose
        Pose of the ellipsoid.
    solid : (3), (2, 3) or (3, 3) array_like, or Mesh
        The half lengths (3) of a solid box around the origin of its body frame, the ends (2, 3) of a segment, the vertices (3, 3) of a
        triangle, or a mesh, which is a surface (see `Mesh.distance`).
    pose2 : pose
        Pose of the solid. By default the identity.

    Returns
    -------
    PoseDistance
        - `distance`: signed distance. If the bodies overlap, it is minus the length of the shortest translation that separates them.
        - `point1`, `point2`: the closest points (of an overlap, the deepest points) of the ellipsoid and of the solid, in the world frame.
        - `normal`: unit vector from the ellipsoid into the solid.
        - `d_pose1`, `d_pose2`: derivatives of the distance with respect to each pose: three numbers for the translation, and three for a
          small rotation vector (radians, world frame) about the origin of the body.

    Raises
    ------
    ValueError
        A pose or the solid is of another type.
    PW85Error
        A semi-axis is not positive, or a number is not finite.

    Examples
    --------
    >>> import pypw85
    >>> upright = ([1, 0, 0, 0], [0, 0, 5])
    >>> found = pypw85.pose_distance([1, 1, 2], upright, [1, 1, 1])
    >>> found.distance
    2.0
    >>> found.d_pose1
    array([0., 0., 1., 0., 0., 0.])
    """
    body = _solid(solid)
    rotation1, translation1 = _pose(pose1, "pose1")
    rotation2, translation2 = _pose(pose2, "pose2")
    center = rotation2.T @ (translation1 - translation2)
    distance, *vectors = _distance(body, center, ellipsoid(semi_axes, rotation2.T @ rotation1))
    arm1, arm2, normal = (rotation2 @ vector for vector in vectors)
    point1, point2 = translation1 + arm1, translation1 + arm2
    return PoseDistance(
        float(distance), point1, point2, normal,
        np.concatenate([-normal, np.cross(normal, arm1)]) + 0.0,
        np.concatenate([normal, np.cross(point2 - translation2, normal)]) + 0.0,
    )  # fmt: skip
