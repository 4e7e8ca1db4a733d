"""The contact function of two ellipsoids, and what follows from it."""

from __future__ import annotations

from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Floats = NDArray[np.float64]
Values = Union[np.float64, Floats]


def contact_call(call: Callable[..., Any], args: tuple[Any, ...], out: Any, kwargs: dict[str, Any]) -> Any:
    """Call a function that returns (μ², λ) when `out` may be one array (..., 2) for both."""
    if not isinstance(out, np.ndarray):
        return call(*args, out, kwargs)
    if out.ndim == 0 or out.shape[-1] != 2:
        raise ValueError(f"the last dimension of 'out' must be 2, but its shape is {out.shape}")
    call(*args, (out[..., 0], out[..., 1]), kwargs)
    return out[..., 0][()], out[..., 1][()]


def f(lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Values:
    """f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12, whose maximum over λ is the contact function.

    Parameters
    ----------
    lambda_ : (...) array_like
        In [0, 1].
    r12 : (..., 3) array_like
        From the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.
    out : (...) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (...) array or number

    Raises
    ------
    PW85Error
        For a single value: invalid input. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.f(0.5, [3, 0, 0], q, q)
    2.25
    """
    return _core.call_f(lambda_, r12, q1, q2, out, kwargs)


def contact_function(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Values, Values]:
    """Contact function of two ellipsoids, by Brent's method and Newton-Raphson iterations (that of pw85 1.0).

    μ is the common factor by which both ellipsoids must be scaled, their centres fixed, to touch: they overlap if
    μ² < 1. Same results as `contact`, which is several times faster.

    Parameters
    ----------
    r12 : (..., 3) array_like
        From the centre of ellipsoid 1 to that of ellipsoid 2; zero is valid (μ² = 0, λ = 1/2).
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids, in the square of the unit of `r12`.
    out : (..., 2) array, or a tuple of two (...) arrays, optional
        Where to put μ² and λ.
    **kwargs
        As for any ufunc.

    Returns
    -------
    mu2, lambda_ : (...) arrays or numbers
        μ² and the maximiser λ in [0, 1]; no unit.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, or a form that is not positive definite. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_function([3, 0, 0], q, q)
    (2.25, 0.5)
    """
    if out is None:
        return _core.call_contact_function(r12, q1, q2, None, kwargs)
    return contact_call(_core.call_contact_function, (r12, q1, q2), out, kwargs)


def contact(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Values, Values]:
    """Contact function of two ellipsoids, by the fast solver. See `contact_function` for everything else.

    Arrays go through the batch of the library: SIMD and, where it is built with OpenMP, threads.

    Examples
    --------
    One ellipsoid against many:

    >>> import numpy as np, pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> r12 = np.array([[1, 0, 0], [3, 0, 0], [0, 0, 3]])
    >>> mu2, lambda_ = pypw85.contact(r12, q, q)
    >>> mu2
    array([0.25  , 2.25  , 0.5625])
    """
    if out is None:
        return _core.call_contact(r12, q1, q2, None, kwargs)
    return contact_call(_core.call_contact, (r12, q1, q2), out, kwargs)


def overlap(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> Union[np.bool_, NDArray[Any]]:
    """Whether two ellipsoids overlap (μ² < 1), several times faster than μ² itself. Tangent ellipsoids do not.

    Parameters
    ----------
    r12 : (..., 3) array_like
        From the centre of ellipsoid 1 to that of ellipsoid 2; zero is an overlap.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids, in the square of the unit of `r12`.
    out : (...) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc. With ``dtype=np.uint8`` the result is 1, 0, or 255 for a bad row, for `bad_rows`.

    Returns
    -------
    (...) array of bool, or bool
        A bad row counts as an overlap, so that a simulation refuses it.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, or a form that is not positive definite.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.overlap([[3, 0, 0], [0, 0, 3]], q, q)
    array([False,  True])
    """
    return _core.call_overlap(r12, q1, q2, out, kwargs)


def contact_geometry(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Point at which the ellipsoids, scaled by μ, touch, and their common normal.

    Parameters
    ----------
    r12 : (..., 3) array_like
        From the centre of ellipsoid 1 to that of ellipsoid 2, not zero.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.
    lambda_ : (...) array_like
        From `contact`.
    out : tuple of two (..., 3) arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    point : (..., 3) array
        Relative to the centre of ellipsoid 1, in the unit of `r12`.
    normal : (..., 3) array
        Unit vector from ellipsoid 1 to ellipsoid 2.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, `r12` = 0, λ outside [0, 1]. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_geometry([4, 0, 0], q, q, 0.5)
    (array([2., 0., 0.]), array([1., 0., 0.]))
    """
    return _core.call_contact_geometry(r12, q1, q2, lambda_, out, kwargs)


def contact_gradient(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats]:
    """Derivatives of μ².

    Parameters
    ----------
    r12 : (..., 3) array_like
        From the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.
    lambda_ : (...) array_like
        From `contact`.
    out : tuple of three arrays, (..., 3), (..., 6) and (..., 6), optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    d_r12 : (..., 3) array
        With respect to `r12`; minus this is the derivative with respect to centre 1.
    d_q1, d_q2 : (..., 6) arrays
        With respect to the stored entries of `q1` and `q2`: an off-diagonal entry stands for two of the matrix.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, λ outside [0, 1]. Rows of arrays become NaN.

    Examples
    --------
    For spheres of radius 1, μ² = |r12|²/4:

    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_gradient([4, 0, 0], q, q, 0.5)[0]
    array([2., 0., 0.])
    """
    return _core.call_contact_gradient(r12, q1, q2, lambda_, out, kwargs)


def contact_torque(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Derivatives of μ² with respect to rotations of each ellipsoid about its own centre.

    For a small rotation vector ω, dμ² = d_rot·ω; the torque of an energy U(μ²) is -U'(μ²) d_rot.

    Parameters
    ----------
    r12 : (..., 3) array_like
        From the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.
    lambda_ : (...) array_like
        From `contact`.
    out : tuple of two (..., 3) arrays, optional
        Where to put the results.
    **kwargs
        As for any ufunc.

    Returns
    -------
    d_rot1, d_rot2 : (..., 3) arrays
        Per radian.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, λ outside [0, 1]. Rows of arrays become NaN.

    Examples
    --------
    Spheres may turn:

    >>> import numpy as np, pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> np.abs(pypw85.contact_torque([4, 0, 0], q, q, 0.5))
    array([[0., 0., 0.],
           [0., 0., 0.]])
    """
    return _core.call_contact_torque(r12, q1, q2, lambda_, out, kwargs)


def closest_approach(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Values:
    """Distance of the centres at which two ellipsoids touch from outside, on a line of given direction.

    Parameters
    ----------
    direction : (..., 3) array_like
        From centre 1 to centre 2, of any length > 0.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.
    out : (...) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (...) array or number
        In the unit of the semi-axes.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, a zero direction. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.closest_approach([[1, 0, 0], [0, 0, 1]], q, q)
    array([2., 4.])
    """
    return _core.call_closest_approach(direction, q1, q2, out, kwargs)


def contact_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Values, Values]:
    """Contact function of two ellipses; see `contact`.

    Parameters
    ----------
    r12 : (..., 2) array_like
        From centre 1 to centre 2.
    q1, q2 : (..., 3) array_like
        Forms (xx, xy, yy).
    out : (..., 2) array, or a tuple of two (...) arrays, optional
        Where to put μ² and λ.
    **kwargs
        As for any ufunc.

    Returns
    -------
    mu2, lambda_ : (...) arrays or numbers

    Raises
    ------
    PW85Error
        For a single pair: invalid input, or a form that is not positive definite. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.ellipse(1, 1, 0)
    >>> pypw85.contact_2d([3, 0], q, q)
    (2.25, 0.5)
    """
    return contact_call(_core.call_contact_2d, (r12, q1, q2), out, kwargs)


def closest_approach_2d(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Values:
    """Distance of closest approach of two ellipses; see `closest_approach`.

    Parameters
    ----------
    direction : (..., 2) array_like
        From centre 1 to centre 2, of any length > 0.
    q1, q2 : (..., 3) array_like
        Forms (xx, xy, yy).
    out : (...) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (...) array or number
        In the unit of the semi-axes.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, a zero direction. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.closest_approach_2d([1, 0], pypw85.ellipse(2, 1, 0), pypw85.ellipse(1, 1, 0))
    3.0
    """
    return _core.call_closest_approach_2d(direction, q1, q2, out, kwargs)


def zheng_ellipses(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Values:
    """Distance of closest approach of two ellipses by the closed form of Zheng and Palffy-Muhoray.

    An independent check of `closest_approach_2d`, which is faster and more accurate and has the same parameters.
    """
    return _core.call_zheng_ellipses(direction, q1, q2, out, kwargs)


def zheng_ellipsoids(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Values:
    """Distance of closest approach of two ellipsoids by the rotating plane of Zheng, Iglesias and Palffy-Muhoray.

    An independent check of `closest_approach`, which is faster and more accurate and has the same parameters.
    """
    return _core.call_zheng_ellipsoids(direction, q1, q2, out, kwargs)


def _cholesky_decomp(a: ArrayLike, l: Optional[Floats] = None, **kwargs: Any) -> Floats:
    """Cholesky factorisation A = L Lᵀ of 3×3 matrices.

    Parameters
    ----------
    a : (..., 6) array_like
        Packed symmetric positive definite matrices.
    l : (..., 6) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (..., 6) array
        Lower triangle of L by columns, (l11, l21, l31, l22, l32, l33); `l` if given.

    Raises
    ------
    PW85Error
        For a single matrix: it is not finite or not positive definite. Rows of arrays become NaN.
    """
    return _core.call_cholesky_decomp(a, l, kwargs)


def _cholesky_solve(l: ArrayLike, b: ArrayLike, x: Optional[Floats] = None, **kwargs: Any) -> Floats:
    """Solution of L Lᵀ x = b.

    Parameters
    ----------
    l : (..., 6) array_like
        From `_cholesky_decomp`.
    b : (..., 3) array_like
        Right-hand sides.
    x : (..., 3) array, optional
        Where to put the result; may be `b`.
    **kwargs
        As for any ufunc.

    Returns
    -------
    (..., 3) array
        The solution; `x` if given.
    """
    return _core.call_cholesky_solve(l, b, x, kwargs)
