# SPDX-License-Identifier: BSD-3-Clause
"""Superseded ways to compute the contact function, kept for reference and comparison.

The rational form (`f2`, `contact_function2`, the polynomials) loses accuracy with the square of the aspect ratio and
more. Arguments are as in `pypw85`.
"""

from __future__ import annotations

from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import plain
from ._documentation import listed
from ._typing import Floats, One, Row, Rows

__all__ = ["contact_function1", "contact_function2", "f1", "f2", "f2_derivatives"]


@declared
def _det_sym():
    """
    Examples
    --------
    >>> from pypw85 import legacy
    >>> legacy._det_sym([2, 0, 0, 3, 0, 4])
    24.0
    """


@declared
def _xT_adjA_x():
    """
    Examples
    --------
    >>> from pypw85 import legacy
    >>> legacy._xT_adjA_x([1, 0, 0], [2, 0, 0, 3, 0, 4])
    12.0
    """


def _outside(q1: ArrayLike, q2: ArrayLike) -> Any:
    """Value of the blend (1-λ) Q1 + λ Q2 at λ = -1."""
    return 2 * plain(q1) - plain(q2)


@declared
def _detQ_as_poly(q1, q2, q3=None, q4=None, b=None):
    """
    Parameters
    ----------
    q3 : (..., 6) array_like, optional
        2 Q1 - Q2, if it is at hand.
    q4 : (..., 6) array_like, optional
        (Q1 + Q2)/2, if it is at hand.

    Returns
    -------
    (..., 4) array
        ``b[0] + b[1] λ + b[2] λ² + b[3] λ³``; `b` if given.

    Examples
    --------
    >>> from pypw85 import legacy
    >>> legacy._detQ_as_poly([1, 0, 0, 1, 0, 1], [2, 0, 0, 2, 0, 2])
    array([1., 3., 3., 1.])
    """
    if q3 is None:
        q3 = _outside(q1, q2)
    if q4 is None:
        q4 = 0.5 * (plain(q1) + plain(q2))
    return _core.call_legacy_detQ_as_poly(q1, q2, q3, q4, b, kwargs)


@declared
def _rT_adjQ_r_as_poly(r, q1, q2, q3=None, a=None):
    """
    Parameters
    ----------
    q3 : (..., 6) array_like, optional
        2 Q1 - Q2, if it is at hand.

    Returns
    -------
    (..., 3) array
        ``a[0] + a[1] λ + a[2] λ²``; `a` if given.

    Examples
    --------
    >>> from pypw85 import legacy
    >>> legacy._rT_adjQ_r_as_poly([1, 0, 0], [1, 0, 0, 1, 0, 1], [2, 0, 0, 2, 0, 2])
    array([1., 2., 1.])
    """
    if q3 is None:
        q3 = _outside(q1, q2)
    return _core.call_legacy_rT_adjQ_r_as_poly(r, q1, q2, q3, a, kwargs)


def _check_last_dimension(out: Any, length: int) -> None:
    shape = np.shape(out)
    if shape[-1:] != (length,):
        raise ValueError(f"the last dimension of 'out' must be {length}, but its shape is {shape}")


@declared
def f1(lambda_, r12, q1, q2, out: Floats | None) -> float:
    """f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12 and its derivatives, by Cholesky factorisation.

    Parameters
    ----------
    out : (..., 3) array, optional
        Where to put f, f' and f''.

    Returns
    -------
    (...) array or number
        f(λ)

    Examples
    --------
    >>> import numpy as np
    >>> from pypw85 import legacy
    >>> out = np.empty(3)
    >>> legacy.f1(0.5, [2, 0, 0], [1, 0, 0, 1, 0, 1], [1, 0, 0, 1, 0, 1], out)
    1.0
    >>> out
    array([ 1.,  0., -8.])
    """
    if out is None:
        return _core.call_legacy_f1(lambda_, r12, q1, q2, None, kwargs)[0]
    _check_last_dimension(out, 3)
    return _core.call_legacy_f1(lambda_, r12, q1, q2, tuple(out[..., k] for k in range(3)), kwargs)[0][()]


@declared
def f2(lambda_, r12, q1, q2, out: Floats | None) -> float:
    """f(λ), as a rational function of λ, which loses accuracy with the square of the aspect ratio and more.

    Parameters
    ----------
    out : (..., 1) array, optional
        Where to put f.

    Returns
    -------
    (...) array or number
        f(λ)
    """
    if out is None:
        return _core.call_legacy_f2(lambda_, r12, q1, q2, None, kwargs)
    _check_last_dimension(out, 1)
    return _core.call_legacy_f2(lambda_, r12, q1, q2, out[..., 0], kwargs)[()]


@declared
def f2_derivatives(lambda_, r12, q1, q2, out: Floats | None):
    """
    Returns
    -------
    (..., 3) array
        f, f' and f''; `out` if given.

    Examples
    --------
    >>> from pypw85 import legacy
    >>> q = [1, 0, 0, 1, 0, 1]
    >>> legacy.f2_derivatives(0.5, [2, 0, 0], q, q).round(12)
    array([ 1.,  0., -8.])
    """


@declared
def contact_function1():
    """Contact function by plain Newton-Raphson iterations on f', which often fail.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, a form that is not positive definite, or ``Status.ECONVERGENCE`` when the
        iterations leave [0, 1] or do not settle. In arrays, invalid rows become NaN.
    """


@declared
def contact_function2():
    """Contact function by bisection on the numerator of f' in rational form."""
