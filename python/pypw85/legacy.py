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
from ._documentation import documented
from ._typing import Floats, One, Row, Rows

__all__ = ["contact_function1", "contact_function2", "f1", "f2", "f2_derivatives"]


@overload
def _det_sym(a: Row, out: Floats | None = None) -> float: ...
@overload
def _det_sym(a: Rows, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def _det_sym(a: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def _det_sym(a: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Determinants of symmetric matrices.

    Parameters
    ----------
    a : (..., 6) array_like
        Packed matrices.
    {out}

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


@overload
def _xT_adjA_x(x: Row, a: One, out: Floats | None = None) -> float: ...
@overload
def _xT_adjA_x(x: Rows, a: ArrayLike, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def _xT_adjA_x(x: ArrayLike, a: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def _xT_adjA_x(x: ArrayLike, a: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """xᵀ adj(A) x, where adj(A) is the adjugate, the transpose of the matrix of cofactors.

    Parameters
    ----------
    x : (..., 3) array_like
        Vectors.
    a : (..., 6) array_like
        Packed matrices.
    {out}

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
    return 2 * plain(q1) - plain(q2)


@documented
def _detQ_as_poly(
    q1: ArrayLike,
    q2: ArrayLike,
    q3: ArrayLike | None = None,
    q4: ArrayLike | None = None,
    b: Floats | None = None,
    **kwargs: Any,
) -> Floats:
    """Coefficients of det[(1-λ) Q1 + λ Q2] in increasing powers of λ.

    Parameters
    ----------
    q1, q2 : (..., 6) array_like
        Forms.
    {q3}
    q4 : (..., 6) array_like, optional
        (Q1 + Q2)/2, if it is at hand.
    b : (..., 4) array, optional
        Where to put the result.
    {keywords}

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


@documented
def _rT_adjQ_r_as_poly(
    r: ArrayLike,
    q1: ArrayLike,
    q2: ArrayLike,
    q3: ArrayLike | None = None,
    a: Floats | None = None,
    **kwargs: Any,
) -> Floats:
    """Coefficients of rᵀ adj[(1-λ) Q1 + λ Q2] r in increasing powers of λ.

    Parameters
    ----------
    r : (..., 3) array_like
        Vectors.
    q1, q2 : (..., 6) array_like
        Forms.
    {q3}
    a : (..., 3) array, optional
        Where to put the result.
    {keywords}

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


@overload
def f1(lambda_: float, r12: Row, q1: One, q2: One, out: Floats | None = None) -> float: ...
@overload
def f1(
    lambda_: ArrayLike, r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Floats | None = None, **kwargs: Any
) -> Floats: ...
@overload
def f1(
    lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Floats | None = None, **kwargs: Any
) -> Any: ...
@documented
def f1(
    lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Floats | None = None, **kwargs: Any
) -> Any:
    """f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12 and its derivatives, by Cholesky factorisation.

    Parameters
    ----------
    {lambda_in}
    {r12}
    {forms}
    out : (..., 3) array, optional
        Where to put f, f' and f''.
    {keywords}

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


@overload
def f2(lambda_: float, r12: Row, q1: One, q2: One, out: Floats | None = None) -> float: ...
@overload
def f2(
    lambda_: ArrayLike, r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Floats | None = None, **kwargs: Any
) -> Floats: ...
@overload
def f2(
    lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Floats | None = None, **kwargs: Any
) -> Any: ...
@documented
def f2(
    lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Floats | None = None, **kwargs: Any
) -> Any:
    """f(λ), as a rational function of λ, which loses accuracy with the square of the aspect ratio and more.

    Parameters
    ----------
    {lambda_in}
    {r12}
    {forms}
    out : (..., 1) array, optional
        Where to put f.
    {keywords}

    Returns
    -------
    (...) array or number
        f(λ)

    Raises
    ------
    PW85Error
        For a single value: invalid input. Rows of arrays become NaN.
    """
    if out is None:
        return _core.call_legacy_f2(lambda_, r12, q1, q2, None, kwargs)
    _check_last_dimension(out, 1)
    return _core.call_legacy_f2(lambda_, r12, q1, q2, out[..., 0], kwargs)[()]


@documented
def f2_derivatives(
    lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Floats | None = None, **kwargs: Any
) -> Any:
    """f(λ), f'(λ) and f''(λ), as a rational function of λ.

    Parameters
    ----------
    {lambda_in}
    {r12}
    {forms}
    out : (..., 3) array, optional
        Where to put f, f' and f''.
    {keywords}

    Returns
    -------
    (..., 3) array
        f, f' and f''; `out` if given.

    Raises
    ------
    PW85Error
        For a single value: invalid input. Rows of arrays become NaN.

    Examples
    --------
    >>> from pypw85 import legacy
    >>> q = [1, 0, 0, 1, 0, 1]
    >>> legacy.f2_derivatives(0.5, [2, 0, 0], q, q).round(12)
    array([ 1.,  0., -8.])
    """
    return _core.call_legacy_f2_derivatives(lambda_, r12, q1, q2, out, kwargs)


@overload
def contact_function1(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, float]: ...
@overload
def contact_function1(
    r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]: ...
@overload
def contact_function1(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]: ...
@documented
def contact_function1(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]:
    """Contact function by plain Newton-Raphson iterations on f', which often fail.

    Parameters
    ----------
    {r12}
    {forms}
    {out_contact}

    {returns_contact}

    Raises
    ------
    PW85Error
        For a single pair: invalid input, a form that is not positive definite, or ``Status.ECONVERGENCE`` when the
        iterations leave [0, 1] or do not settle. Rows of arrays become NaN.
    """
    return _core.call_legacy_contact_function1(r12, q1, q2, out, kwargs)


@overload
def contact_function2(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, float]: ...
@overload
def contact_function2(
    r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]: ...
@overload
def contact_function2(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]: ...
@documented
def contact_function2(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]:
    """Contact function by bisection on the numerator of f' in rational form.

    Parameters
    ----------
    {r12}
    {forms}
    {out_contact}

    {returns_contact}

    {raises_pair}
    """
    return _core.call_legacy_contact_function2(r12, q1, q2, out, kwargs)
