"""The distance of two ellipsoids."""

from __future__ import annotations

from typing import Any, overload

from numpy.typing import ArrayLike

from . import _core
from ._documentation import documented
from ._typing import Floats, One, Row, Rows


@overload
def distance(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, Floats, Floats]: ...
@overload
def distance(
    r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats]: ...
@overload
def distance(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]: ...
@documented
def distance(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]:
    """Distance of the surfaces of two ellipsoids, and the points where they are closest.

    The distance is that of the exact forms to a few units of rounding: see ``pw85_distance`` in the C API for the bound.

    Parameters
    ----------
    {r12}
    {forms}
    out : tuple of three arrays, (...), (..., 3) and (..., 3), optional
        Where to put the results.
    {keywords}

    Returns
    -------
    distance : (...) array or number
        Zero where the ellipsoids overlap.
    point1, point2 : (..., 3) arrays
        The closest points of ellipsoids 1 and 2, relative to the centre of ellipsoid 1; NaN where they overlap.

    {raises_pair}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.distance([5, 0, 0], q, q)
    (3.0, array([1., 0., 0.]), array([4., 0., 0.]))
    """
    return _core.call_distance(r12, q1, q2, out, kwargs)


@documented
def distance_derivatives(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats, Floats]:
    """First and second derivatives of the distance of two ellipsoids; NaN where they overlap.

    Parameters
    ----------
    {r12}
    {forms}
    out : tuple of four arrays, three (..., 3) and one (..., 9, 9), optional
        Where to put the results.
    {keywords}

    Returns
    -------
    d_r12 : (..., 3) array
        With respect to `r12`: the unit vector normal to both surfaces at the closest points, from 1 to 2.
    d_rot1, d_rot2 : (..., 3) arrays
        With respect to rotations of each ellipsoid about its own centre, per radian.
    hessian : (..., 9, 9) array
        Second derivatives with respect to `r12`, rotation 1 and rotation 2.

    {raises_pair}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.distance_derivatives([5, 0, 0], q, q)[0]
    array([1., 0., 0.])
    """
    return _core.call_distance_derivatives(r12, q1, q2, out, kwargs)


@overload
def distance_2d(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, Floats, Floats]: ...
@overload
def distance_2d(
    r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats]: ...
@overload
def distance_2d(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]: ...
@documented
def distance_2d(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats, Floats]:
    """Distance of two ellipses; see `distance`.

    Parameters
    ----------
    r12 : (..., 2) array_like
        From centre 1 to centre 2.
    q1, q2 : (..., 3) array_like
        Forms (xx, xy, yy).
    out : tuple of three arrays, (...), (..., 2) and (..., 2), optional
        Where to put the results.
    {keywords}

    Returns
    -------
    distance : (...) array or number
    point1, point2 : (..., 2) arrays

    {raises_pair}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.distance_2d([5, 0], q, q)
    (3.0, array([1., 0.]), array([4., 0.]))
    """
    return _core.call_distance_2d(r12, q1, q2, out, kwargs)


@overload
def penetration(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, Floats]: ...
@overload
def penetration(
    r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]: ...
@overload
def penetration(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Floats]: ...
@documented
def penetration(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Floats]:
    """The depth of an overlap: the shortest translation of ellipsoid 2 that separates two ellipsoids.

    It is proved to be the shortest: see ``pw85_penetration`` in the C API.

    Parameters
    ----------
    {r12}
    {forms}
    out : tuple of two arrays, (...) and (..., 3), optional
        Where to put the results.
    {keywords}

    Returns
    -------
    depth : (...) array or number
        Zero where the ellipsoids do not overlap.
    direction : (..., 3) array
        Unit vector along which ellipsoid 2 is to move; NaN where they do not overlap.

    {raises_pair}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.penetration([1.5, 0, 0], q, q)
    (0.5, array([1., 0., 0.]))
    """
    return _core.call_penetration(r12, q1, q2, out, kwargs)
