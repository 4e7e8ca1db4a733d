"""The contact function of two ellipses, and what follows from it."""

from __future__ import annotations

from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._documentation import documented
from ._typing import Floats, One, Row, Rows


@overload
def contact_2d(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, float]: ...
@overload
def contact_2d(r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Floats, Floats]: ...
@overload
def contact_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Any]: ...
@documented
def contact_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Any]:
    """Contact function of two ellipses.

    μ is the common factor by which both ellipses must be scaled, their centres fixed, to touch: they overlap if μ² < 1
    and are apart if μ² > 1.

    Parameters
    ----------
    r12 : (..., 2) array_like
        From the centre of ellipse 1 to that of ellipse 2. Zero is valid (μ² = 0, λ = 1/2).
    q1, q2 : (..., 3) array_like
        Forms (xx, xy, yy), in the square of the unit of `r12`.
    {out_contact}

    {returns_contact}

    {raises_pair}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_2d([3, 0], q, q)
    (2.25, 0.5)
    """
    return _core.call_contact_2d(r12, q1, q2, out, kwargs)


@overload
def overlap_2d(r12: Row, q1: One, q2: One, out: Floats | None = None) -> np.bool_: ...
@overload
def overlap_2d(r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None) -> NDArray[np.bool_]: ...
@overload
def overlap_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def overlap_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Whether two ellipses overlap (μ² < 1); see `overlap`.

    Parameters
    ----------
    {pair_2d}
    {out}

    Returns
    -------
    (...) array of bool, or bool
        A bad row counts as an overlap.

    {raises_pair}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(2, 1, 0)
    >>> pypw85.overlap_2d([[3, 0], [0, 3]], q, q)
    array([ True, False])
    """
    return _core.call_overlap_2d(r12, q1, q2, out, kwargs)


@documented
def contact_geometry_2d(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Point at which the ellipses, scaled by μ, touch, and their common normal; see `contact_geometry`.

    Parameters
    ----------
    {pair_2d}
    {lambda_found_2d}
    out : tuple of two (..., 2) arrays, optional
        Where to put the results.
    {keywords}

    Returns
    -------
    point, normal : (..., 2) arrays

    {raises_lambda}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_geometry_2d([4, 0], q, q, 0.5)
    (array([2., 0.]), array([1., 0.]))
    """
    return _core.call_contact_geometry_2d(r12, q1, q2, lambda_, out, kwargs)


@documented
def contact_gradient_2d(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats]:
    """Derivatives of μ² of two ellipses; see `contact_gradient`.

    Parameters
    ----------
    {pair_2d}
    {lambda_found_2d}
    out : tuple of three arrays, (..., 2), (..., 3) and (..., 3), optional
        Where to put the results.
    {keywords}

    Returns
    -------
    d_r12 : (..., 2) array
    d_q1, d_q2 : (..., 3) arrays

    {raises_lambda}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_gradient_2d([4, 0], q, q, 0.5)[0]
    array([2., 0.])
    """
    return _core.call_contact_gradient_2d(r12, q1, q2, lambda_, out, kwargs)


@documented
def contact_torque_2d(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]:
    """Derivatives of μ² with respect to the angles of two ellipses, counter-clockwise; see `contact_torque`.

    Parameters
    ----------
    {pair_2d}
    {lambda_found_2d}
    out : tuple of two (...) arrays, optional
        Where to put the results.
    {keywords}

    Returns
    -------
    d_rot1, d_rot2 : (...) arrays or numbers
        Per radian.

    {raises_lambda}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_torque_2d([4, 0], q, q, 0.5)
    (0.0, 0.0)
    """
    return _core.call_contact_torque_2d(r12, q1, q2, lambda_, out, kwargs)


@documented
def contact_hessian_2d(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> Floats:
    """Second derivatives of μ² of two ellipses with respect to positions and angles; see `contact_hessian`.

    Parameters
    ----------
    {pair_2d}
    {lambda_found_2d}
    out : (..., 4, 4) array, optional
        Where to put the result.
    {keywords}

    Returns
    -------
    (..., 4, 4) array
        Symmetric; rows and columns for `r12`, angle 1 and angle 2.

    {raises_lambda}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_hessian_2d([4, 0], q, q, 0.5)[0, 0]
    0.5
    """
    return _core.call_contact_hessian_2d(r12, q1, q2, lambda_, out, kwargs)


@overload
def closest_approach_2d(direction: Row, q1: One, q2: One, out: Floats | None = None) -> float: ...
@overload
def closest_approach_2d(direction: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def closest_approach_2d(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def closest_approach_2d(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Distance of the centres at which two ellipses touch from outside, on a line of given direction.

    Parameters
    ----------
    {direction_2d}
    {out}

    {returns_distance}

    {raises_direction}

    Examples
    --------
    >>> import pypw85
    >>> pypw85.closest_approach_2d([1, 0], pypw85.ellipse(2, 1, 0), pypw85.ellipse(1, 1, 0))
    3.0
    """
    return _core.call_closest_approach_2d(direction, q1, q2, out, kwargs)
