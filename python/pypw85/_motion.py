"""Ellipsoids that move: the time of the first contact."""

from __future__ import annotations

from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._documentation import documented
from ._typing import Floats, Row


def motion(
    velocity: ArrayLike = (0.0, 0.0, 0.0), angular_velocity: ArrayLike = (0.0, 0.0, 0.0), growth: ArrayLike = 0.0
) -> Floats:
    """How ellipsoids move, in one row each.

    Parameters
    ----------
    velocity : (..., 3) array_like
        Of the centres.
    angular_velocity : (..., 3) array_like
        About the centres, in radians per unit of time.
    growth : (...) array_like
        At time t the semi-axes are 1 + growth·t times those at time 0.

    Returns
    -------
    (..., 7) array
        Velocity, angular velocity and growth.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.motion([1, 2, 3], growth=0.5)
    array([1. , 2. , 3. , 0. , 0. , 0. , 0.5])
    """
    v, w, g = (np.asarray(x, dtype=np.float64) for x in (velocity, angular_velocity, growth))
    leading = np.broadcast_shapes(v.shape[:-1], w.shape[:-1], g.shape)
    rows = np.empty((*leading, 7))
    rows[..., :3], rows[..., 3:6], rows[..., 6] = v, w, g
    return rows


@overload
def first_contact(
    r12: Row, q1: Row, q2: Row, motion1: Row, motion2: Row, t_max: float = np.inf, out: None = None
) -> float: ...
@overload
def first_contact(
    r12: ArrayLike,
    q1: ArrayLike,
    q2: ArrayLike,
    motion1: ArrayLike,
    motion2: ArrayLike,
    t_max: ArrayLike = np.inf,
    out: Any = None,
    **kwargs: Any,
) -> Any: ...
@documented
def first_contact(
    r12: ArrayLike,
    q1: ArrayLike,
    q2: ArrayLike,
    motion1: ArrayLike,
    motion2: ArrayLike,
    t_max: ArrayLike = np.inf,
    out: Any = None,
    **kwargs: Any,
) -> Any:
    """The time of the first contact of two ellipsoids that move, turn and grow.

    Parameters
    ----------
    {r12}
    {forms}
    motion1, motion2 : (..., 7) array_like
        How the ellipsoids move, from `motion`. `r12` and the forms are those at time 0.
    t_max : (...) array_like, optional
        The time up to which contacts count, >= 0.
    {out}

    Returns
    -------
    (...) array or number
        The time, infinity where there is none, zero for ellipsoids that overlap at time 0.

    {raises_pair}

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
    return _core.call_first_contact(r12, q1, q2, motion1, motion2, t_max, out, kwargs)
