"""Superseded ways to compute the contact function, kept for reference and comparison.

The rational form (`f2`, `contact_function2`, the polynomials) loses accuracy with the square of the aspect ratio and
more. Arguments are as in `pypw85`: leading dimensions broadcast, and arrays may be of any real type.
"""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._contact import Floats, Values, contact_call

__all__ = ["contact_function1", "contact_function2", "f1", "f2", "f2_derivatives"]


def _det_sym(a: ArrayLike, out: Any = None, **kwargs: Any) -> Values:
    """Determinants of symmetric matrices.

    Parameters
    ----------
    a : (..., 6) array_like
        Packed matrices.
    out : (...) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (...) array or number

    Examples
    --------
    >>> from pypw85 import legacy
    >>> legacy._det_sym([2, 0, 0, 3, 0, 4])
    24.0
    """
    return _core.call_legacy_det_sym(a, out, kwargs)


def _xT_adjA_x(x: ArrayLike, a: ArrayLike, out: Any = None, **kwargs: Any) -> Values:
    """xᵀ adj(A) x, where adj(A) is the adjugate, the transpose of the matrix of cofactors.

    Parameters
    ----------
    x : (..., 3) array_like
        Vectors.
    a : (..., 6) array_like
        Packed matrices.
    out : (...) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (...) array or number

    Examples
    --------
    >>> from pypw85 import legacy
    >>> legacy._xT_adjA_x([1, 0, 0], [2, 0, 0, 3, 0, 4])
    12.0
    """
    return _core.call_legacy_xT_adjA_x(x, a, out, kwargs)


def _outside(q1: ArrayLike, q2: ArrayLike) -> Any:
    """Value of the blend (1-λ) Q1 + λ Q2 at λ = -1."""
    return 2 * np.asarray(q1) - np.asarray(q2)


def _detQ_as_poly(
    q1: ArrayLike,
    q2: ArrayLike,
    q3: Optional[ArrayLike] = None,
    q4: Optional[ArrayLike] = None,
    b: Optional[Floats] = None,
    **kwargs: Any,
) -> Floats:
    """Coefficients of det[(1-λ) Q1 + λ Q2] in increasing powers of λ.

    Parameters
    ----------
    q1, q2 : (..., 6) array_like
        Forms.
    q3 : (..., 6) array_like, optional
        2 Q1 - Q2, if it is at hand.
    q4 : (..., 6) array_like, optional
        (Q1 + Q2)/2, if it is at hand.
    b : (..., 4) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

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
        q4 = 0.5 * (np.asarray(q1) + np.asarray(q2))
    return _core.call_legacy_detQ_as_poly(q1, q2, q3, q4, b, kwargs)


def _rT_adjQ_r_as_poly(
    r: ArrayLike,
    q1: ArrayLike,
    q2: ArrayLike,
    q3: Optional[ArrayLike] = None,
    a: Optional[Floats] = None,
    **kwargs: Any,
) -> Floats:
    """Coefficients of rᵀ adj[(1-λ) Q1 + λ Q2] r in increasing powers of λ.

    Parameters
    ----------
    r : (..., 3) array_like
        Vectors.
    q1, q2 : (..., 6) array_like
        Forms.
    q3 : (..., 6) array_like, optional
        2 Q1 - Q2, if it is at hand.
    a : (..., 3) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

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


def _check_last_dimension(out: Floats, length: int) -> None:
    if out.ndim == 0 or out.shape[-1] != length:
        raise ValueError(f"the last dimension of 'out' must be {length}, but its shape is {out.shape}")


def f1(
    lambda_: ArrayLike,
    r12: ArrayLike,
    q1: ArrayLike,
    q2: ArrayLike,
    out: Optional[Floats] = None,
    **kwargs: Any,
) -> Values:
    """f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12 and its derivatives, by Cholesky factorisation.

    Parameters
    ----------
    lambda_ : (...) array_like
        In [0, 1].
    r12 : (..., 3) array_like
        From the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.
    out : (..., 3) array, optional
        Where to put f, f' and f''.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (...) array or number
        f(λ)

    Raises
    ------
    PW85Error
        For a single value: invalid input. Rows of arrays become NaN.

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


def f2(
    lambda_: ArrayLike,
    r12: ArrayLike,
    q1: ArrayLike,
    q2: ArrayLike,
    out: Optional[Floats] = None,
    **kwargs: Any,
) -> Values:
    """f(λ), as a rational function of λ.

    Parameters, result and errors are those of `f1`, except for `out`, of shape (..., 1), which receives f alone.
    """
    if out is None:
        return _core.call_legacy_f2(lambda_, r12, q1, q2, None, kwargs)
    _check_last_dimension(out, 1)
    return _core.call_legacy_f2(lambda_, r12, q1, q2, out[..., 0], kwargs)[()]


def f2_derivatives(
    lambda_: ArrayLike,
    r12: ArrayLike,
    q1: ArrayLike,
    q2: ArrayLike,
    out: Optional[Floats] = None,
    **kwargs: Any,
) -> Floats:
    """f(λ), f'(λ) and f''(λ), as a rational function of λ.

    Parameters and errors are those of `f1`.

    Returns
    -------
    (..., 3) array
        f, f' and f''; `out` if given.

    Examples
    --------
    >>> from pypw85 import legacy
    >>> legacy.f2_derivatives(0.5, [2, 0, 0], [1, 0, 0, 1, 0, 1], [1, 0, 0, 1, 0, 1]).round(12)
    array([ 1.,  0., -8.])
    """
    return _core.call_legacy_f2_derivatives(lambda_, r12, q1, q2, out, kwargs)


def contact_function1(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Values]:
    """Contact function by plain Newton-Raphson iterations on f', which often fail.

    Parameters, results and errors are those of `pypw85.contact_function`; ``Status.ECONVERGENCE`` when the iterations
    leave [0, 1] or do not settle.
    """
    return contact_call(_core.call_legacy_contact_function1, (r12, q1, q2), out, kwargs)


def contact_function2(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Values]:
    """Contact function by bisection on the numerator of f' in rational form.

    Parameters, results and errors are those of `pypw85.contact_function`, except for accuracy.
    """
    return contact_call(_core.call_legacy_contact_function2, (r12, q1, q2), out, kwargs)
