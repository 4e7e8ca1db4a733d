"""One ellipsoid and walls, points, lines."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from . import _core
from ._contact import Floats, Values


def distance_plane(
    normal: ArrayLike, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Floats]:
    """Distance from an ellipsoid with its centre at 0 to the half-space normal·x >= offset.

    Parameters
    ----------
    normal : (..., 3) array_like
        Into the half-space, of any length > 0.
    offset : (...) array_like
        In the unit of normal·x; negative if the centre is in the half-space.
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : tuple of arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    distance : (...) array or number
        In the unit of the semi-axes; minus the depth if the two overlap.
    point : (..., 3) array
        Of the ellipsoid, nearest to the half-space or deepest in it.

    Raises
    ------
    PW85Error
        For a single row: invalid input, or a form that is not positive definite. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_plane([0, 0, 1], 5, q)
    (3.0, array([0., 0., 2.]))
    """
    return _core.call_distance_plane(normal, offset, q, out, kwargs)


def distance_plane_derivatives(
    normal: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Derivatives of the distance from an ellipsoid to a half-space, whatever its offset.

    Parameters
    ----------
    normal : (..., 3) array_like
        Into the half-space, of any length > 0.
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : tuple of arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    d_center : (..., 3) array
        With respect to the position of the centre: minus the unit normal.
    d_rot : (..., 3) array
        With respect to rotations about the centre, per radian.

    Raises
    ------
    PW85Error
        For a single row: invalid input, or a form that is not positive definite. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_plane_derivatives([0, 0, 1], q)[0]
    array([-0., -0., -1.])
    """
    return _core.call_distance_plane_derivatives(normal, q, out, kwargs)


def contact_plane(
    normal: ArrayLike, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Floats]:
    """Contact function of an ellipsoid with its centre at 0 and the half-space normal·x >= offset.

    Parameters
    ----------
    normal : (..., 3) array_like
        Into the half-space, of any length > 0.
    offset : (...) array_like
        In the unit of normal·x; negative if the centre is in the half-space.
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : tuple of arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    mu2 : (...) array or number
        Square of the factor by which the ellipsoid must be scaled to touch; 0 if its centre is in the half-space.
    point : (..., 3) array
        Where it then touches.

    Raises
    ------
    PW85Error
        For a single row: invalid input, or a form that is not positive definite. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.contact_plane([0, 0, 1], 3, q)
    (2.25, array([0., 0., 3.]))
    """
    return _core.call_contact_plane(normal, offset, q, out, kwargs)


def distance_box(
    lower: ArrayLike, upper: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Floats, Floats]:
    """Distance from an ellipsoid with its centre at 0 to the nearest face of a box around it.

    Parameters
    ----------
    lower, upper : (..., 3) array_like
        Corners of the box, relative to the centre; lower <= upper.
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : tuple of arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    distance : (...) array or number
        Negative if the ellipsoid is not inside of the box.
    point : (..., 3) array
        Of the ellipsoid, nearest to that face or farthest beyond it.
    normal : (..., 3) array
        Outward unit normal of that face.

    Raises
    ------
    PW85Error
        For a single row: invalid input, or a form that is not positive definite, or lower > upper.
        Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_box([-2, -2, -3], [2, 2, 2.5], q)
    (0.5, array([0., 0., 2.]), array([0., 0., 1.]))
    """
    return _core.call_distance_box(lower, upper, q, out, kwargs)


def distance_cylinder(
    axis: ArrayLike, radius: ArrayLike, center: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Floats, Floats]:
    """Distance from an ellipsoid to the wall of a cylinder of infinite length around it.

    Parameters
    ----------
    axis : (..., 3) array_like
        Direction of the axis, which goes through 0; of any length > 0.
    radius : (...) array_like
        Of the cylinder, > 0.
    center : (..., 3) array_like
        Of the ellipsoid.
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : tuple of arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    distance : (...) array or number
        Negative if the ellipsoid is not inside of the cylinder.
    point : (..., 3) array
        Of the ellipsoid, farthest from the axis, relative to its centre.
    normal : (..., 3) array
        Outward unit normal of the wall there.

    Raises
    ------
    PW85Error
        For a single row: invalid input, or a form that is not positive definite, or a radius
        that is not positive. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> distance, point, normal = pypw85.distance_cylinder([0, 0, 1], 4, [1, 0, 0], q)
    >>> distance
    2.0
    """
    return _core.call_distance_cylinder(axis, radius, center, q, out, kwargs)


def distance_point(r: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Values, Floats, Floats]:
    """Distance from a point to the surface of an ellipsoid; negative inside.

    Parameters
    ----------
    r : (..., 3) array_like
        The point, relative to the centre of the ellipsoid.
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : tuple of arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    distance : (...) array or number
        In the unit of the semi-axes.
    point : (..., 3) array
        Of the surface, nearest to `r`; one of them if there are several.
    normal : (..., 3) array
        Unit vector out of the ellipsoid at this point.

    Raises
    ------
    PW85Error
        For a single row: invalid input, or a form that is not positive definite. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_point([0, 0, 5], q)
    (3.0, array([0., 0., 2.]), array([0., 0., 1.]))
    """
    return _core.call_distance_point(r, q, out, kwargs)


def intersect_line(
    origin: ArrayLike, direction: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Values]:
    """The part enter <= t <= leave of the line origin + t direction that is in an ellipsoid.

    Parameters
    ----------
    origin : (..., 3) array_like
        Of the line, relative to the centre of the ellipsoid.
    direction : (..., 3) array_like
        Of any length > 0.
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : tuple of arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    enter, leave : (...) arrays or numbers
        NaN where the line misses the ellipsoid.

    Raises
    ------
    PW85Error
        For a single row: invalid input, or a form that is not positive definite. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.intersect_line([0, 0, -5], [0, 0, 1], q)
    (3.0, 7.0)
    """
    return _core.call_intersect_line(origin, direction, q, out, kwargs)
