# SPDX-License-Identifier: BSD-3-Clause
"""Functions of one pair or of arrays of pairs: forms, contact, distance, time of contact, walls, ellipses."""

from __future__ import annotations

from typing import Any, NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._documentation import listed
from ._typing import Floats, One, Row, Rows


class ContactDerivatives(NamedTuple):
    """Result of `contact_derivatives`, one array per quantity.

    - `mu2`, `lambda_` (...): the contact function μ², and the maximiser λ;
    - `point`, `normal` (..., 3): contact point of the scaled ellipsoids, relative to the centre of ellipsoid 1, and unit normal there;
    - `d_r12` (..., 3): derivative of μ² with respect to `r12`;
    - `d_rot1`, `d_rot2` (..., 3): derivatives of μ² with respect to small rotations of ellipsoids 1 and 2 about their centres, per radian.
    """

    mu2: Any
    lambda_: Any
    point: Any
    normal: Any
    d_r12: Any
    d_rot1: Any
    d_rot2: Any


@declared
def spheroid(a, c, n, q):
    """
    Returns
    -------
    (..., 6) array
        The form, in the square of the unit of `a` and `c`; `q` if given.

    Raises
    ------
    PW85Error
        For a single form: a radius is not positive, or `n` is zero or not finite. In arrays, invalid rows become NaN.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.spheroid(0.5, 5.0, [1, 0, 0])
    array([25.  ,  0.  ,  0.  ,  0.25,  0.  ,  0.25])
    """


@declared
def ellipsoid():
    """
    Parameters
    ----------
    rotation : (..., 3, 3) array_like
        Matrix R, which takes the body frame to the space frame. Its columns are the directions of the semi-axes. RᵀR
        may differ from the identity by at most 1e-6 in any entry. R may be a reflection. A
        ``scipy.spatial.transform.Rotation`` is accepted, too.

    See Also
    --------
    principal_axes : the inverse: semi-axes and directions of a form
    from_euler, from_rotation_vector, from_covariance, from_moments, from_inertia : forms from other input

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.ellipsoid([1, 2, 3], np.eye(3))
    array([1., 0., 0., 4., 0., 9.])
    """


@declared
def ellipsoid_quaternion(semi_axes, quaternion_wxyz):
    """
    See Also
    --------
    from_lammps, from_ovito, from_gsd : forms from the data of other programs

    Examples
    --------
    >>> import pypw85
    >>> pypw85.ellipsoid_quaternion([1, 2, 3], [1, 0, 0, 0])
    array([1., 0., 0., 4., 0., 9.])
    """


@declared
def ellipsoid_factor(semi_axes, quaternion_wxyz):
    """
    Examples
    --------
    >>> import pypw85
    >>> pypw85.ellipsoid_factor([1, 2, 3], [1, 0, 0, 0])
    array([[1., 0., 0.],
           [0., 2., 0.],
           [0., 0., 3.]])
    """


@declared
def contact_factored():
    """
    Examples
    --------
    >>> import pypw85
    >>> needle = pypw85.ellipsoid_factor([1, 1, 1e6], [1, 0, 0, 0])
    >>> mu2, lambda_ = pypw85.contact_factored([3, 0, 4e6], needle, needle)
    >>> round(float(mu2), 12)
    6.25
    """


@declared
def overlap_factored():
    """
    Examples
    --------
    >>> import pypw85
    >>> needle = pypw85.ellipsoid_factor([1, 1, 1e6], [1, 0, 0, 0])
    >>> pypw85.overlap_factored([[1.9, 0, 1e5], [2, 0, 0]], needle, needle)
    array([ True, False])
    """


@declared
def contact_geometry_factored():
    """
    Examples
    --------
    >>> import pypw85
    >>> needle = pypw85.ellipsoid_factor([1, 1, 1e6], [1, 0, 0, 0])
    >>> pypw85.contact_geometry_factored([0, 0, 4e6], needle, needle, 0.5)
    (array([      0.,       0., 2000000.]), array([0., 0., 1.]))
    """


@declared
def contact_gradient_factored():
    """
    Examples
    --------
    >>> import numpy as np, pypw85
    >>> sphere = np.eye(3)
    >>> d_r12, d_s1, d_s2 = pypw85.contact_gradient_factored([4, 0, 0], sphere, sphere, 0.5)
    >>> d_r12
    array([2., 0., 0.])
    >>> np.round(d_s1, 12) + 0.0
    array([[-4.,  0.,  0.],
           [ 0.,  0.,  0.],
           [ 0.,  0.,  0.]])
    """


@declared
def ellipse():
    """
    Examples
    --------
    >>> import pypw85
    >>> pypw85.ellipse(2, 1, 0)
    array([4., 0., 1.])
    """


@declared
def f():
    """Computes f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12, whose maximum over λ is the contact function.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.f(0.5, [3, 0, 0], q, q)
    2.25
    """


@overload
def f_neg(lambda_: float, r12: Row, q1: One, q2: One) -> float: ...
@overload
def f_neg(lambda_: ArrayLike, r12: Rows, q1: ArrayLike, q2: ArrayLike) -> Floats: ...
@overload
def f_neg(lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any: ...
def f_neg(lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Computes -f(λ), the function that pw85 2.0 minimises; see `f`.

    Parameters
    ----------
    lambda_ : (...) array_like
        In [0, 1].
    r12 : (..., 3) array_like
        Vector from the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids, in the square of the unit of `r12`.

    Returns
    -------
    (...) array or number

    Raises
    ------
    PW85Error
        For a single pair: invalid input. In arrays, invalid rows become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.f_neg(0.5, [3, 0, 0], q, q)
    -2.25
    """
    arguments: Any = lambda_, r12, q1, q2  # Any, because mypy takes seconds to try all combinations of the overloads
    return -f(*arguments)


@declared
def contact_function():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_function([3, 0, 0], q, q)
    (2.25, 0.5)
    """


@declared
def contact():
    """Computes the contact function of two ellipsoids.

    If both ellipsoids are scaled by μ about their centres, they touch. They overlap if μ² < 1, and are apart if μ² > 1.
    For arrays, the library uses SIMD instructions and, if it was built with OpenMP, several threads.

    See Also
    --------
    overlap : exact and faster test, if you do not need μ²
    contact_geometry : contact point and normal
    contact_gradient, contact_torque : derivatives of μ²

    Examples
    --------
    One pair:

    >>> import numpy as np, pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.contact([0, 0, 6], q, q)
    (2.25, 0.5)

    One ellipsoid against many:

    >>> r12 = np.array([[1, 0, 0], [3, 0, 0], [0, 0, 3]])
    >>> mu2, lambda_ = pypw85.contact(r12, q, q)
    >>> mu2
    array([0.25  , 2.25  , 0.5625])
    """


@declared
def overlap():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.overlap([[3, 0, 0], [0, 0, 3]], q, q)
    array([False,  True])
    """


@declared
def overlap_witness():
    """
    Returns
    -------
    overlap : (...) array or number
        1 if the ellipsoids overlap, otherwise 0.
    lambda_ : (...) array or number
        A number λ with f(λ) > 1, if the ellipsoids are apart; otherwise NaN.
    point : (..., 3) array
        A point inside both ellipsoids, relative to the centre of ellipsoid 1, if they overlap; otherwise NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> r12 = [[3, 0, 0], [2, 0, 0], [1, 0, 0]]
    >>> overlap, lambda_, point = pypw85.overlap_witness(r12, q, q)
    >>> overlap, lambda_
    (array([0., 0., 1.]), array([0.5, nan, nan]))
    >>> point[2]
    array([0.5, 0. , 0. ])
    """


@declared
def compare():
    """
    Returns
    -------
    (...) array or number
        -1 if μ² < `mu2`, 0 if they are equal, 1 if μ² > `mu2`.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(2, 2, [0, 0, 1])
    >>> pypw85.compare([3, 4, 0], q, q, [25 / 16, 1.5, 1.6])
    array([ 0.,  1., -1.])
    """


@declared
def contains():
    """
    Examples
    --------
    >>> import pypw85
    >>> q1, q2 = pypw85.spheroid(2, 2, [0, 0, 1]), pypw85.spheroid(0.5, 1, [0, 0, 1])
    >>> pypw85.contains([[0, 0, 1], [0, 0, 1.5]], q1, q2)
    array([ True, False])
    """


@declared
def containment():
    """
    Examples
    --------
    >>> import pypw85
    >>> q1, q2 = pypw85.spheroid(2, 2, [0, 0, 1]), pypw85.spheroid(0.5, 1, [0, 0, 1])
    >>> pypw85.containment([0, 0, 2], q1, q2)
    (2.25, array([0., 0., 3.]))
    """


@declared
def contact_geometry():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_geometry([4, 0, 0], q, q, 0.5)
    (array([2., 0., 0.]), array([1., 0., 0.]))
    """


@declared
def contact_gradient():
    """
    Examples
    --------
    For spheres of radius 1, μ² = |r12|²/4:

    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_gradient([4, 0, 0], q, q, 0.5)[0]
    array([2., 0., 0.])
    """


@declared
def contact_torque():
    """
    Examples
    --------
    Rotations of spheres do not change μ²:

    >>> import numpy as np, pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> np.abs(pypw85.contact_torque([4, 0, 0], q, q, 0.5))
    array([[0., 0., 0.],
           [0., 0., 0.]])
    """


@declared
def contact_hessian():
    """
    Examples
    --------
    For spheres of radius 1, μ² = |r12|²/4:

    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_hessian([4, 0, 0], q, q, 0.5)[0, 0]
    0.5
    """


@declared
def closest_approach():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.closest_approach([[1, 0, 0], [0, 0, 1]], q, q)
    array([2., 4.])
    """


@declared
def zheng_ellipses():
    """Computes the distance of closest approach of two ellipses by the closed form of Zheng and Palffy-Muhoray.

    Use it as an independent check of `closest_approach_2d`, which is faster and more accurate.
    """


@declared
def zheng_ellipsoids():
    """Computes the distance of closest approach of two ellipsoids by the method of Zheng, Iglesias and Palffy-Muhoray.

    Use it as an independent check of `closest_approach`, which is faster and more accurate.
    """


@declared
def _cholesky_decomp(a, l):
    """
    Raises
    ------
    PW85Error
        For a single matrix: it is not finite or not positive definite. In arrays, invalid rows become NaN.
    """


@declared
def _cholesky_solve(l, b, x):
    """
    Parameters
    ----------
    x : (..., 3) array, optional
        Output array, which is also returned; may be `b`.
    """


@declared
def contact_derivatives() -> ContactDerivatives:
    """Computes μ², λ, the contact point, the normal and the derivatives of μ² in one call.

    The forces and torques of an energy U(μ²) follow from these derivatives. This call is faster than calling `contact`,
    `contact_geometry`, `contact_gradient` and `contact_torque`.

    Parameters
    ----------
    r12 : (..., 3) array_like
        Vector from the centre of ellipsoid 1 to that of ellipsoid 2. If it is zero, the derivatives are 0, and the
        point and the normal are NaN.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids, in the square of the unit of `r12`.

    Returns
    -------
    ContactDerivatives
        A named tuple of `mu2` (...), `lambda_` (...), `point` (..., 3) relative to the centre of ellipsoid 1, `normal`
        (..., 3) from ellipsoid 1 to ellipsoid 2, and the derivatives of μ²: `d_r12` (..., 3), and `d_rot1` and `d_rot2`
        (..., 3) for rotations of each ellipsoid about its own centre.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> result = pypw85.contact_derivatives([3, 0, 0], q, q)
    >>> result.point, result.d_r12
    (array([1.5, 0. , 0. ]), array([1.5, 0. , 0. ]))
    """
    return ContactDerivatives(*_core.call_contact_derivatives(r12, q1, q2, out, kwargs))


@declared
def cell_reduce():
    """
    Parameters
    ----------
    cell : (..., 3, 3) array_like
        Rows are the vectors.

    Raises
    ------
    PW85Error
        For a single cell: it is singular or not finite. In arrays, invalid cells become NaN.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.cell_reduce([[1, 0, 0], [5, 1, 0], [0, -3, 1]])
    array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """


@declared
def bounding_boxes():
    """Computes the half-widths of the bounding boxes of ellipsoids, with sides along the coordinate axes.

    Parameters
    ----------
    q : (..., 6) array_like
        Forms of the ellipsoids.

    Raises
    ------
    PW85Error
        For a single form: it is not finite or not positive definite. In arrays, invalid rows become NaN.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.bounding_boxes(pypw85.spheroid(1, 2, [0, 0, 1]))
    array([1., 1., 2.])
    """


@declared
def distance():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.distance([5, 0, 0], q, q)
    (3.0, array([1., 0., 0.]), array([4., 0., 0.]))
    """


@declared
def distance_derivatives():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.distance_derivatives([5, 0, 0], q, q)[0]
    array([1., 0., 0.])
    """


@declared
def distance_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.distance_2d([5, 0], q, q)
    (3.0, array([1., 0.]), array([4., 0.]))
    """


@declared
def penetration():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.penetration([1.5, 0, 0], q, q)
    (0.5, array([1., 0., 0.]))
    """


@declared
def penetration_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.penetration_2d([1.5, 0], q, q)
    (0.5, array([1., 0.]))
    """


@declared
def gap_inside():
    """
    Examples
    --------
    >>> import pypw85
    >>> ball = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> gap, *_, normal = pypw85.gap_inside([1, 0, 0], 9 * ball, ball)
    >>> print(gap, normal)
    1.0 [1. 0. 0.]
    """


@declared
def gap_inside_2d():
    """
    Examples
    --------
    >>> import math, pypw85
    >>> hole, inclusion = pypw85.ellipse(25, 30, 0), pypw85.ellipse(10, 8, 0)
    >>> gap, point1, point2, normal = pypw85.gap_inside_2d([-10, 10], hole, inclusion)
    >>> print(f"{gap:.5f} {math.dist(point1, point2):.5f}")
    2.99197 2.99197
    """


@declared
def distance_geometry():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> distance, point1, point2, normal = pypw85.distance_geometry([0, 5, 0], q, q)
    >>> print(distance, normal)
    3.0 [0. 1. 0.]
    """


@declared
def signed_distance_geometry():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> distance, *_, normal = pypw85.signed_distance_geometry([0, 1.5, 0], q, q)
    >>> print(distance, normal)
    -0.5 [0. 1. 0.]
    """


@declared
def signed_distance_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.signed_distance_2d([1.5, 0], q, q)
    (-0.5, array([1., 0.]), array([0.5, 0. ]))
    """


@declared
def signed_distance():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> for x in (5, 1.5):
    ...     print(pypw85.signed_distance([x, 0, 0], q, q))
    (3.0, array([1., 0., 0.]), array([4., 0., 0.]))
    (-0.5, array([1., 0., 0.]), array([0.5, 0. , 0. ]))
    """


@declared
def signed_distance_derivatives():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.signed_distance_derivatives([1.5, 0, 0], q, q)[0]
    array([1., 0., 0.])
    """


@declared
def first_contact(r12, q1, q2, motion1, motion2, t_max=np.inf):
    """Computes the time of the first contact of two ellipsoids that translate, rotate and grow.

    Parameters
    ----------
    motion1, motion2 : (..., 7) array_like
        Motions of the ellipsoids, as returned by `motion`. The semi-axes must be positive until `t_max`.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> still, coming = pypw85.motion(), pypw85.motion([-0.5, 0, 0])
    >>> pypw85.first_contact([5, 0, 0], q, q, still, coming)
    6.0
    >>> pypw85.first_contact([5, 0, 0], q, q, still, coming, 1)
    inf
    """


@declared
def closest_passage(r12, q1, q2, velocity, t_max=np.inf):
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.closest_passage([-6, 3, 0], q, q, [2, 0, 0])
    (2.25, 3.0)
    """


@declared
def free_path(r12, q1, q2, direction, t_max=np.inf):
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> t = pypw85.free_path([5, 0, 0], q, q, [1, 0, 0])
    >>> 3 - 1e-14 < t <= 3
    True
    """


@declared
def curvature():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.curvature([1, 0, 0], q)[0]
    array([0.25, 1.  ])
    """


@declared
def hertz():
    """
    Examples
    --------
    >>> import pypw85
    >>> pypw85.hertz([0.5, 0.5])  # a sphere of radius 2 on a plane
    (2.0, array([2., 2.]))
    """


@declared
def hertz_contact():
    """
    Examples
    --------
    >>> import pypw85
    >>> q1, q2 = pypw85.spheroid(1, 1, [0, 0, 1]), pypw85.spheroid(3, 3, [0, 0, 1])
    >>> depth, point, curvatures, directions, radius, ellipse = pypw85.hertz_contact(
    ...     [0, 0, 3.5], q1, q2, [0, 0, 1]
    ... )
    >>> depth, point, round(radius, 12)
    (0.5, array([0.  , 0.  , 0.75]), 0.75)
    """


@declared
def distance_plane():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_plane([0, 0, 1], 5, q)
    (3.0, array([0., 0., 2.]))
    """


@declared
def distance_plane_derivatives():
    """Computes the derivatives of the distance to a half-space, which do not depend on its offset.

    The derivatives are -n and n × point, with the unit normal n and the point of `distance_plane`.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_plane_derivatives([0, 0, 1], q)[0]
    array([-0., -0., -1.])
    """


@declared
def contact_plane():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.contact_plane([0, 0, 1], 3, q)
    (2.25, array([0., 0., 3.]))
    """


@declared
def contact_plane_derivatives():
    """Computes the derivatives of μ² of `contact_plane`. They are zero if the centre is in the half-space.

    The derivatives are -2μ n/α and 2μ² (n × p)/α, with the normal n as given, the point p of the ellipsoid that is nearest
    to the half-space, and α = n·p.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.contact_plane_derivatives([0, 0, 1], 3, q)[0]
    array([-0. , -0. , -1.5])
    """


@declared
def distance_box():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_box([-2, -2, -3], [2, 2, 2.5], q)
    (0.5, array([0., 0., 2.]), array([0., 0., 1.]))
    """


@declared
def distance_segment():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> distance, point1, point2, normal = pypw85.distance_segment([3, -1, 0], [3, 5, 0], q)
    >>> distance
    2.0
    """


@declared
def distance_triangle():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_triangle([-9, -9, 3], [9, -9, 3], [0, 9, 3], q)[0]
    1.0
    """


@declared
def distance_solid_box():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_solid_box([-2, -2, 3], [2, 2, 4], q)[0]
    1.0
    >>> pypw85.distance_solid_box([-2, -2, 1.5], [2, 2, 4], q)[0]
    -0.5
    """


@declared
def distance_cylinder():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> distance, point, normal = pypw85.distance_cylinder([0, 0, 1], 4, [1, 0, 0], q)
    >>> distance
    2.0
    """


@declared
def distance_point():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_point([0, 0, 5], q)
    (3.0, array([0., 0., 2.]), array([0., 0., 1.]))
    """


@declared
def distance_point_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(2, 1, 0)
    >>> pypw85.distance_point_2d([5, 0], q)
    (3.0, array([2., 0.]), array([1., 0.]))
    """


@declared
def contact_segment_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(2, 1, 0)
    >>> pypw85.contact_segment_2d([4, -1], [4, 1], q)
    (4.0, array([4., 0.]))
    """


@declared
def overlap_box_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(2, 1, 0)
    >>> pypw85.overlap_box_2d([[1, -1], [2, -1]], [3, 1], q)
    array([ True, False])
    """


@declared
def intersect_line():
    """Computes the interval enter <= t <= leave in which the line origin + t direction is inside an ellipsoid.

    Returns
    -------
    enter, leave : (...) arrays or numbers
        NaN where the line misses the ellipsoid.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.intersect_line([0, 0, -5], [0, 0, 1], q)
    (3.0, 7.0)
    """


@declared
def contact_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_2d([3, 0], q, q)
    (2.25, 0.5)
    """


@declared
def overlap_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(2, 1, 0)
    >>> pypw85.overlap_2d([[3, 0], [0, 3]], q, q)
    array([ True, False])
    """


@declared
def contains_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q1, q2 = pypw85.ellipse(2, 2, 0), pypw85.ellipse(1, 0.5, 0)
    >>> pypw85.contains_2d([[1, 0], [1.5, 0]], q1, q2)
    array([ True, False])
    """


@declared
def contact_geometry_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_geometry_2d([4, 0], q, q, 0.5)
    (array([2., 0.]), array([1., 0.]))
    """


@declared
def contact_gradient_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_gradient_2d([4, 0], q, q, 0.5)[0]
    array([2., 0.])
    """


@declared
def contact_torque_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_torque_2d([4, 0], q, q, 0.5)
    (0.0, 0.0)
    """


@declared
def contact_hessian_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_hessian_2d([4, 0], q, q, 0.5)[0, 0]
    0.5
    """


@declared
def closest_approach_2d():
    """
    Examples
    --------
    >>> import pypw85
    >>> pypw85.closest_approach_2d([1, 0], pypw85.ellipse(2, 1, 0), pypw85.ellipse(1, 1, 0))
    3.0
    """
