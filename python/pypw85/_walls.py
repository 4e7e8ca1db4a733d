"""One ellipsoid and walls, points, lines."""

from __future__ import annotations

from typing import Any, overload

from numpy.typing import ArrayLike

from . import _core
from ._documentation import documented
from ._typing import Floats, One, Row, Rows


@overload
def distance_plane(normal: Row, offset: float, q: One, out: Floats | None = None) -> tuple[float, Floats]: ...
@overload
def distance_plane(
    normal: Rows, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]: ...
@overload
def distance_plane(
    normal: ArrayLike, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats]: ...
@documented
def distance_plane(
    normal: ArrayLike, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats]:
    """Distance from an ellipsoid with its centre at 0 to the half-space normal·x >= offset.

    Parameters
    ----------
    {half_space}
    {form}
    {out_several}

    Returns
    -------
    distance : (...) array or number
        In the unit of the semi-axes; minus the depth if the two overlap.
    point : (..., 3) array
        Of the ellipsoid, nearest to the half-space or deepest in it.

    {raises_row}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_plane([0, 0, 1], 5, q)
    (3.0, array([0., 0., 2.]))
    """
    return _core.call_distance_plane(normal, offset, q, out, kwargs)


@documented
def distance_plane_derivatives(
    normal: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Derivatives of the distance from an ellipsoid to a half-space, whatever its offset.

    Parameters
    ----------
    normal : (..., 3) array_like
        Into the half-space, of any length > 0.
    {form}
    {out_several}

    Returns
    -------
    d_center : (..., 3) array
        With respect to the position of the centre: minus the unit normal.
    d_rot : (..., 3) array
        With respect to rotations about the centre, per radian.

    {raises_row}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_plane_derivatives([0, 0, 1], q)[0]
    array([-0., -0., -1.])
    """
    return _core.call_distance_plane_derivatives(normal, q, out, kwargs)


@overload
def contact_plane(normal: Row, offset: float, q: One, out: Floats | None = None) -> tuple[float, Floats]: ...
@overload
def contact_plane(
    normal: Rows, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]: ...
@overload
def contact_plane(
    normal: ArrayLike, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats]: ...
@documented
def contact_plane(
    normal: ArrayLike, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats]:
    """Contact function of an ellipsoid with its centre at 0 and the half-space normal·x >= offset.

    Parameters
    ----------
    {half_space}
    {form}
    {out_several}

    Returns
    -------
    mu2 : (...) array or number
        Square of the factor by which the ellipsoid must be scaled to touch; 0 if its centre is in the half-space.
    point : (..., 3) array
        Where it then touches.

    {raises_row}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.contact_plane([0, 0, 1], 3, q)
    (2.25, array([0., 0., 3.]))
    """
    return _core.call_contact_plane(normal, offset, q, out, kwargs)


@documented
def contact_plane_derivatives(
    normal: ArrayLike, offset: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Derivatives of the contact function of an ellipsoid and a half-space; zero if its centre is in the half-space.

    Parameters
    ----------
    {half_space}
    {form}
    {out_several}

    Returns
    -------
    d_center : (..., 3) array
        With respect to the position of the centre.
    d_rot : (..., 3) array
        With respect to rotations about the centre, per radian.

    {raises_row}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.contact_plane_derivatives([0, 0, 1], 3, q)[0]
    array([-0. , -0. , -1.5])
    """
    return _core.call_contact_plane_derivatives(normal, offset, q, out, kwargs)


@overload
def distance_box(lower: Row, upper: Row, q: One, out: Floats | None = None) -> tuple[float, Floats, Floats]: ...
@overload
def distance_box(
    lower: Rows, upper: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats]: ...
@overload
def distance_box(
    lower: ArrayLike, upper: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]: ...
@documented
def distance_box(
    lower: ArrayLike, upper: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]:
    """Distance from an ellipsoid with its centre at 0 to the nearest face of a box around it.

    Parameters
    ----------
    lower, upper : (..., 3) array_like
        Corners of the box, relative to the centre; lower <= upper.
    {form}
    {out_several}

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


@overload
def distance_cylinder(
    axis: Row, radius: float, center: Row, q: One, out: Floats | None = None
) -> tuple[float, Floats, Floats]: ...
@overload
def distance_cylinder(
    axis: Rows, radius: ArrayLike, center: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats]: ...
@overload
def distance_cylinder(
    axis: ArrayLike, radius: ArrayLike, center: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]: ...
@documented
def distance_cylinder(
    axis: ArrayLike, radius: ArrayLike, center: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]:
    """Distance from an ellipsoid to the wall of a cylinder of infinite length around it.

    Parameters
    ----------
    axis : (..., 3) array_like
        Direction of the axis, which goes through 0; of any length > 0.
    radius : (...) array_like
        Of the cylinder, > 0.
    center : (..., 3) array_like
        Of the ellipsoid.
    {form}
    {out_several}

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


@overload
def distance_point(r: Row, q: One, out: Floats | None = None) -> tuple[float, Floats, Floats]: ...
@overload
def distance_point(r: Rows, q: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Floats, Floats, Floats]: ...
@overload
def distance_point(r: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Floats, Floats]: ...
@documented
def distance_point(r: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Floats, Floats]:
    """Distance from a point to the surface of an ellipsoid; negative inside.

    Parameters
    ----------
    r : (..., 3) array_like
        The point, relative to the centre of the ellipsoid.
    {form}
    {out_several}

    Returns
    -------
    distance : (...) array or number
        In the unit of the semi-axes.
    point : (..., 3) array
        Of the surface, nearest to `r`; one of them if there are several.
    normal : (..., 3) array
        Unit vector out of the ellipsoid at this point.

    {raises_row}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.distance_point([0, 0, 5], q)
    (3.0, array([0., 0., 2.]), array([0., 0., 1.]))
    """
    return _core.call_distance_point(r, q, out, kwargs)


@overload
def intersect_line(origin: Row, direction: Row, q: One, out: Floats | None = None) -> tuple[float, float]: ...
@overload
def intersect_line(
    origin: Rows, direction: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]: ...
@overload
def intersect_line(
    origin: ArrayLike, direction: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]: ...
@documented
def intersect_line(
    origin: ArrayLike, direction: ArrayLike, q: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]:
    """The part enter <= t <= leave of the line origin + t direction that is in an ellipsoid.

    Parameters
    ----------
    origin : (..., 3) array_like
        Of the line, relative to the centre of the ellipsoid.
    direction : (..., 3) array_like
        Of any length > 0.
    {form}
    {out_several}

    Returns
    -------
    enter, leave : (...) arrays or numbers
        NaN where the line misses the ellipsoid.

    {raises_row}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.intersect_line([0, 0, -5], [0, 0, 1], q)
    (3.0, 7.0)
    """
    return _core.call_intersect_line(origin, direction, q, out, kwargs)
