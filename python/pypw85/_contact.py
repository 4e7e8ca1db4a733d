"""The contact function of two ellipsoids, and what follows from it."""

from __future__ import annotations

from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._documentation import documented
from ._typing import Floats, One, Row, Rows


@overload
def f(lambda_: float, r12: Row, q1: One, q2: One, out: Floats | None = None) -> float: ...
@overload
def f(lambda_: ArrayLike, r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def f(lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def f(lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12, whose maximum over λ is the contact function.

    Parameters
    ----------
    {lambda_in}
    {r12}
    {forms}
    {out}

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


@overload
def f_neg(lambda_: float, r12: Row, q1: One, q2: One) -> float: ...
@overload
def f_neg(lambda_: ArrayLike, r12: Rows, q1: ArrayLike, q2: ArrayLike) -> Floats: ...
@overload
def f_neg(lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any: ...
@documented
def f_neg(lambda_: ArrayLike, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """-f(λ), what pw85 2.0 minimises; see `f`.

    Parameters
    ----------
    {lambda_in}
    {r12}
    {forms}

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
    >>> pypw85.f_neg(0.5, [3, 0, 0], q, q)
    -2.25
    """
    return -f(lambda_, r12, q1, q2)


@overload
def contact_function(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, float]: ...
@overload
def contact_function(
    r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]: ...
@overload
def contact_function(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Any, Any]: ...
@documented
def contact_function(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Any]:
    """Contact function of two ellipsoids, by Brent's method and Newton-Raphson iterations (that of pw85 1.0).

    μ is the common factor by which both ellipsoids must be scaled, their centres fixed, to touch: they overlap if
    μ² < 1. Same results as `contact`, which is several times faster.

    Parameters
    ----------
    {r12}
        Zero is valid (μ² = 0, λ = 1/2).
    {forms}
    {out_contact}

    {returns_contact}

    {raises_pair}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_function([3, 0, 0], q, q)
    (2.25, 0.5)
    """
    return _core.call_contact_function(r12, q1, q2, out, kwargs)


@overload
def contact(r12: Row, q1: One, q2: One, out: Floats | None = None) -> tuple[float, float]: ...
@overload
def contact(r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Floats, Floats]: ...
@overload
def contact(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Any]: ...
@documented
def contact(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> tuple[Any, Any]:
    """Contact function of two ellipsoids, by the fast solver.

    μ is the common factor by which both ellipsoids must be scaled, their centres fixed, to touch: they overlap if
    μ² < 1 and are apart if μ² > 1. Arrays go through the batch of the library: SIMD and, where it is built with OpenMP,
    threads.

    Parameters
    ----------
    {r12}
        Zero is valid (μ² = 0, λ = 1/2).
    {forms}
    {out_contact}

    {returns_contact}

    {raises_pair}

    See Also
    --------
    overlap : faster, if μ² itself is not needed
    contact_geometry, contact_gradient, contact_torque : what follows from λ

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
    return _core.call_contact(r12, q1, q2, out, kwargs)


@overload
def overlap(r12: Row, q1: One, q2: One, out: Floats | None = None) -> np.bool_: ...
@overload
def overlap(r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None) -> NDArray[np.bool_]: ...
@overload
def overlap(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def overlap(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Whether two ellipsoids overlap (μ² < 1), several times faster than μ² itself. Tangent ellipsoids do not.

    Parameters
    ----------
    {r12}
        Zero is an overlap.
    {forms}
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


@overload
def contains(r12: Row, q1: One, q2: One, out: Floats | None = None) -> np.bool_: ...
@overload
def contains(r12: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None) -> NDArray[np.bool_]: ...
@overload
def contains(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def contains(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Whether ellipsoid 2 is inside ellipsoid 1. One that touches it from inside is.

    Parameters
    ----------
    {r12}
    {forms}
    out : (...) array, optional
        Where to put the result.
    **kwargs
        As for any ufunc. With ``dtype=np.uint8`` the result is 1, 0, or 255 for a bad row, for `bad_rows`.

    Returns
    -------
    (...) array of bool, or bool
        A bad row is not inside.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, or a form that is not positive definite.

    Examples
    --------
    >>> import pypw85
    >>> q1, q2 = pypw85.spheroid(2, 2, [0, 0, 1]), pypw85.spheroid(0.5, 1, [0, 0, 1])
    >>> pypw85.contains([[0, 0, 1], [0, 0, 1.5]], q1, q2)
    array([ True, False])
    """
    return _core.call_contains(r12, q1, q2, out, kwargs)


@documented
def contact_geometry(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Point at which the ellipsoids, scaled by μ, touch, and their common normal.

    Parameters
    ----------
    {r12}
        Not zero.
    {forms}
    {lambda_found}
    {out_vectors}

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


@documented
def contact_gradient(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats, Floats]:
    """Derivatives of μ².

    Parameters
    ----------
    {r12}
    {forms}
    {lambda_found}
    out : tuple of three arrays, (..., 3), (..., 6) and (..., 6), optional
        Where to put the results.
    {keywords}

    Returns
    -------
    d_r12 : (..., 3) array
        With respect to `r12`; minus this is the derivative with respect to centre 1.
    d_q1, d_q2 : (..., 6) arrays
        With respect to the stored entries of `q1` and `q2`: an off-diagonal entry stands for two of the matrix.

    {raises_lambda}

    Examples
    --------
    For spheres of radius 1, μ² = |r12|²/4:

    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_gradient([4, 0, 0], q, q, 0.5)[0]
    array([2., 0., 0.])
    """
    return _core.call_contact_gradient(r12, q1, q2, lambda_, out, kwargs)


@documented
def contact_torque(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> tuple[Floats, Floats]:
    """Derivatives of μ² with respect to rotations of each ellipsoid about its own centre.

    For a small rotation vector ω, dμ² = d_rot·ω; the torque of an energy U(μ²) is -U'(μ²) d_rot.

    Parameters
    ----------
    {r12}
    {forms}
    {lambda_found}
    {out_vectors}

    Returns
    -------
    d_rot1, d_rot2 : (..., 3) arrays
        Per radian.

    {raises_lambda}

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


@documented
def contact_hessian(
    r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike, out: Any = None, **kwargs: Any
) -> Floats:
    """Second derivatives of μ² with respect to positions and rotations.

    A rotation vector ω stands for the rotation by |ω| about ω, of each ellipsoid about its own centre.

    Parameters
    ----------
    {r12}
        Not zero.
    {forms}
    {lambda_found}
    out : (..., 9, 9) array, optional
        Where to put the result.
    {keywords}

    Returns
    -------
    (..., 9, 9) array
        Symmetric; rows and columns for `r12`, rotation 1 and rotation 2.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, `r12` = 0, λ outside [0, 1]. Rows of arrays become NaN.

    Examples
    --------
    For spheres of radius 1, μ² = |r12|²/4:

    >>> import pypw85
    >>> q = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> pypw85.contact_hessian([4, 0, 0], q, q, 0.5)[0, 0]
    0.5
    """
    return _core.call_contact_hessian(r12, q1, q2, lambda_, out, kwargs)


@overload
def closest_approach(direction: Row, q1: One, q2: One, out: Floats | None = None) -> float: ...
@overload
def closest_approach(direction: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def closest_approach(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def closest_approach(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Distance of the centres at which two ellipsoids touch from outside, on a line of given direction.

    Parameters
    ----------
    {direction}
    {out}

    {returns_distance}

    {raises_direction}

    Examples
    --------
    >>> import pypw85
    >>> q = pypw85.spheroid(1, 2, [0, 0, 1])
    >>> pypw85.closest_approach([[1, 0, 0], [0, 0, 1]], q, q)
    array([2., 4.])
    """
    return _core.call_closest_approach(direction, q1, q2, out, kwargs)


@overload
def zheng_ellipses(direction: Row, q1: One, q2: One, out: Floats | None = None) -> float: ...
@overload
def zheng_ellipses(direction: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def zheng_ellipses(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def zheng_ellipses(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Distance of closest approach of two ellipses by the closed form of Zheng and Palffy-Muhoray.

    An independent check of `closest_approach_2d`, which is faster and more accurate.

    Parameters
    ----------
    {direction_2d}
    {out}

    {returns_distance}

    {raises_direction}
    """
    return _core.call_zheng_ellipses(direction, q1, q2, out, kwargs)


@overload
def zheng_ellipsoids(direction: Row, q1: One, q2: One, out: Floats | None = None) -> float: ...
@overload
def zheng_ellipsoids(direction: Rows, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def zheng_ellipsoids(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@documented
def zheng_ellipsoids(direction: ArrayLike, q1: ArrayLike, q2: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Distance of closest approach of two ellipsoids by the rotating plane of Zheng, Iglesias and Palffy-Muhoray.

    An independent check of `closest_approach`, which is faster and more accurate.

    Parameters
    ----------
    {direction}
    {out}

    {returns_distance}

    {raises_direction}
    """
    return _core.call_zheng_ellipsoids(direction, q1, q2, out, kwargs)


@documented
def _cholesky_decomp(a: ArrayLike, l: Floats | None = None, **kwargs: Any) -> Floats:
    """Cholesky factorisation A = L Lᵀ of 3×3 matrices.

    Parameters
    ----------
    a : (..., 6) array_like
        Packed symmetric positive definite matrices.
    l : (..., 6) array, optional
        Where to put the result.
    {keywords}

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


@documented
def _cholesky_solve(l: ArrayLike, b: ArrayLike, x: Floats | None = None, **kwargs: Any) -> Floats:
    """Solution of L Lᵀ x = b.

    Parameters
    ----------
    l : (..., 6) array_like
        From `_cholesky_decomp`.
    b : (..., 3) array_like
        Right-hand sides.
    x : (..., 3) array, optional
        Where to put the result; may be `b`.
    {keywords}

    Returns
    -------
    (..., 3) array
        The solution; `x` if given.
    """
    return _core.call_cholesky_solve(l, b, x, kwargs)
