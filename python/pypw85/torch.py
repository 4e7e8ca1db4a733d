# SPDX-License-Identifier: BSD-3-Clause
"""The contact function and the signed distance of tensors of PyTorch, differentiable twice.

Import it by name, ``import pypw85.torch``: `pypw85` itself does not need PyTorch.

Tensors are on the CPU; they are broadcast against each other, and computed with in double precision, whatever their type. First
derivatives are those of `pypw85.contact_gradient` and `pypw85.signed_distance_derivatives`. Second derivatives serve what PyTorch
builds of them: Hessians, products of Hessians with vectors, gradients of functions of forces.
"""

# mypy: allow-subclassing-any, allow-untyped-decorators, no-warn-unused-ignores

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import torch

from . import _core
from ._typing import Floats

__all__ = ["contact", "ellipsoid_quaternion", "signed_distance"]

ROWS, COLUMNS = (0, 0, 0, 1, 1, 2), (0, 1, 2, 1, 2, 2)
FULL = ((0, 1, 2), (1, 3, 4), (2, 4, 5))


def contact(r12: torch.Tensor, q1: torch.Tensor, q2: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """Contact function of two ellipsoids; see `pypw85.contact`.

    Parameters
    ----------
    r12 : (..., 3) tensor
        From the centre of ellipsoid 1 to that of ellipsoid 2. At zero, second derivatives are NaN.
    q1, q2 : (..., 6) tensors
        Forms of the ellipsoids, in the square of the unit of `r12`; for instance from `ellipsoid_quaternion`.

    Returns
    -------
    mu2, lambda_ : (...) tensors
        μ², differentiable twice with respect to all arguments, and the maximiser λ, which is not differentiable.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, or a form that is not positive definite. Rows of several become NaN.
    ValueError
        The last dimensions are not 3, 6 and 6.
    TypeError
        A tensor is not on the CPU, or is complex.

    Examples
    --------
    For spheres of radius 1, μ² = |r12|²/4:

    >>> import torch, pypw85.torch
    >>> r12 = torch.tensor([3.0, 0.0, 0.0], requires_grad=True)
    >>> q = torch.tensor([1.0, 0.0, 0.0, 1.0, 0.0, 1.0])
    >>> mu2, lambda_ = pypw85.torch.contact(r12, q, q)
    >>> mu2.backward()
    >>> r12.grad
    tensor([1.5000, 0.0000, 0.0000])
    """
    mu2, lambda_ = _Contact.apply(*_pair(r12, q1, q2))
    result = _result_type(r12, q1, q2)
    return mu2.to(result), lambda_.to(result)


def signed_distance(r12: torch.Tensor, q1: torch.Tensor, q2: torch.Tensor) -> torch.Tensor:
    """Signed distance of two ellipsoids; see `pypw85.signed_distance`.

    Parameters
    ----------
    r12 : (..., 3) tensor
        From the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) tensors
        Forms of the ellipsoids, in the square of the unit of `r12`; for instance from `ellipsoid_quaternion`.

    Returns
    -------
    (...) tensor
        The distance of pairs that are apart, minus the depth of pairs that overlap. It is differentiable twice with
        respect to all arguments, also at contact. Where several directions of a depth are equally good, the first
        derivatives are those of one of them, and the second ones are NaN.

    Raises
    ------
    PW85Error
        For a single pair: invalid input, or a form that is not positive definite. Rows of several become NaN.
    ValueError
        The last dimensions are not 3, 6 and 6.
    TypeError
        A tensor is not on the CPU, or is complex.

    Examples
    --------
    The gradient with respect to `r12` is the unit normal, on both sides of contact:

    >>> import torch, pypw85.torch
    >>> r12 = torch.tensor([[3.0, 0.0, 0.0], [1.5, 0.0, 0.0]], requires_grad=True)
    >>> q = torch.tensor([1.0, 0.0, 0.0, 1.0, 0.0, 1.0])
    >>> distance = pypw85.torch.signed_distance(r12, q, q)
    >>> distance.detach()
    tensor([ 1.0000, -0.5000])
    >>> distance.sum().backward()
    >>> r12.grad
    tensor([[1., 0., 0.],
            [1., 0., 0.]])
    """
    distance, _ = _SignedDistance.apply(*_pair(r12, q1, q2))
    return distance.to(_result_type(r12, q1, q2))


def ellipsoid_quaternion(semi_axes: torch.Tensor, quaternion: torch.Tensor) -> torch.Tensor:
    """Form of an ellipsoid from its semi-axes and orientation; see `pypw85.ellipsoid_quaternion`.

    Parameters
    ----------
    semi_axes : (..., 3) tensor
        Lengths of the principal semi-axes, > 0.
    quaternion : (..., 4) tensor
        (w, x, y, z), of any length > 0.

    Returns
    -------
    (..., 6) tensor
        Differentiable as often as needed, with respect to both arguments.

    Examples
    --------
    >>> import torch, pypw85.torch
    >>> quaternion = torch.tensor([1.0, 0.0, 0.0, 0.0])
    >>> pypw85.torch.ellipsoid_quaternion(torch.tensor([3.0, 2.0, 1.0]), quaternion)
    tensor([9., 0., 0., 4., 0., 1.])
    """
    w, x, y, z = (quaternion / quaternion.norm(dim=-1, keepdim=True)).unbind(-1)
    axes = (
        torch.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], -1),
        torch.stack([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)], -1),
        torch.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], -1),
    )
    squares = (semi_axes * semi_axes).unbind(-1)
    parts = [s[..., None] * n[..., ROWS] * n[..., COLUMNS] for s, n in zip(squares, axes)]
    return parts[0] + parts[1] + parts[2]


def _pair(r12: torch.Tensor, q1: torch.Tensor, q2: torch.Tensor) -> list[torch.Tensor]:
    tensors = [_double(x, size) for x, size in ((r12, 3), (q1, 6), (q2, 6))]
    leading = torch.broadcast_shapes(*(x.shape[:-1] for x in tensors))
    return [x.expand(*leading, x.shape[-1]) for x in tensors]


def _result_type(*tensors: torch.Tensor) -> torch.dtype:
    result = functools.reduce(torch.promote_types, (x.dtype for x in tensors))
    return result if result.is_floating_point else torch.float64


def _double(x: torch.Tensor, size: int) -> torch.Tensor:
    if not isinstance(x, torch.Tensor) or x.device.type != "cpu" or x.is_complex():
        raise TypeError("arguments must be tensors of real numbers on the CPU")
    if x.dim() == 0 or x.shape[-1] != size:
        raise ValueError(f"the last dimension must be {size}, not {tuple(x.shape)}")
    return x.to(torch.float64)


def _arrays(tensors: Any) -> list[Floats]:
    return [x.detach().numpy() for x in tensors]


def _tensors(arrays: Any) -> tuple[torch.Tensor, ...]:
    return tuple(torch.from_numpy(np.array(x, dtype=np.float64)) for x in arrays)


class _Value(torch.autograd.Function):
    """A value of r12, q1, q2, whose gradient is a function of the saved tensors, and what is found with it."""

    @staticmethod
    def backward(ctx: Any, d_value: torch.Tensor, _: torch.Tensor) -> tuple[torch.Tensor, ...]:  # type: ignore[override]
        return tuple(d_value[..., None] * d for d in ctx.gradient.apply(*ctx.saved_tensors))


class _Contact(_Value):
    """μ² and λ of r12, q1, q2."""

    @staticmethod
    def forward(ctx: Any, *pair: torch.Tensor) -> tuple[torch.Tensor, ...]:  # type: ignore[override]
        mu2, lambda_ = _tensors(_core.call_contact(*_arrays(pair), None, {}))
        ctx.save_for_backward(*pair, lambda_)
        ctx.mark_non_differentiable(lambda_)
        ctx.gradient = _Gradient
        return mu2, lambda_


class _Gradient(torch.autograd.Function):
    """∂μ²/∂(r12, q1, q2), of r12, q1, q2 and λ, which follows them."""

    @staticmethod
    def forward(ctx: Any, *pair: torch.Tensor) -> tuple[torch.Tensor, ...]:  # type: ignore[override]
        ctx.save_for_backward(*pair)
        return _tensors(_core.contact_gradient(*_arrays(pair)))

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(ctx: Any, *change: torch.Tensor) -> tuple[Any, ...]:
        with np.errstate(invalid="ignore", divide="ignore"):
            return (*_tensors(_change_of_gradient(*_arrays(ctx.saved_tensors), *_arrays(change))), None)


def _product(q: Floats, x: Floats) -> Floats:
    return np.asarray((q[..., FULL] @ x[..., None])[..., 0])


def _dot(x: Floats, y: Floats) -> Floats:
    return np.asarray((x * y).sum(axis=-1, keepdims=True))


def _outer(x: Floats, y: Floats) -> Floats:
    """The derivatives of xᵀQy with respect to the stored entries of Q."""
    both = x[..., ROWS] * y[..., COLUMNS]
    return np.where(np.equal(ROWS, COLUMNS), both, both + x[..., COLUMNS] * y[..., ROWS])


def _change_of_gradient(
    r12: Floats, q1: Floats, q2: Floats, lambda_: Floats, d_r12: Floats, d_q1: Floats, d_q2: Floats
) -> tuple[Floats, Floats, Floats]:
    """The Hessian, which is symmetric, times a change of the arguments: the change of the gradient.

    In the notation of the chapter on forces, n and λ change by dn and dλ, for which N n = r12 and f' = 0 hold on. f'' is
    -2 (Q1 n)·N⁻¹(Q2 n).
    """
    b = lambda_[..., None]
    a = np.maximum(1 - b, 2.0**-54)
    factors = _core.cholesky_decomp(a * q1 + b * q2)
    n = _core.cholesky_solve(factors, r12)
    p1, p2 = _product(q1, n), _product(q2, n)
    s1, s2 = _core.cholesky_solve(factors, p1), _core.cholesky_solve(factors, p2)
    change1, change2 = _product(d_q1, n), _product(d_q2, n)
    dn = _core.cholesky_solve(factors, d_r12 - a * change1 - b * change2)
    slope = a * a * _dot(2 * dn, p1) + a * a * _dot(n, change1) - b * b * _dot(2 * dn, p2) - b * b * _dot(n, change2)
    d_lambda = slope / (2 * _dot(p1, s2))
    dn = dn + d_lambda * (s1 - s2)
    squares, products = _outer(n, n), 2 * _outer(n, dn)
    return (
        2 * ((a - b) * d_lambda * n + a * b * dn),
        -a * ((a - 2 * b) * d_lambda * squares + a * b * products),
        -b * ((2 * a - b) * d_lambda * squares + a * b * products),
    )


class _SignedDistance(_Value):
    """The signed distance and the normal of r12, q1, q2."""

    @staticmethod
    def forward(ctx: Any, *pair: torch.Tensor) -> tuple[torch.Tensor, ...]:  # type: ignore[override]
        arrays = _arrays(pair)
        distance, _, _, normal = _tensors(_core.signed_distance_geometry(*arrays))
        ctx.save_for_backward(*pair, distance, normal)
        ctx.mark_non_differentiable(normal)
        ctx.gradient = _GradientOfDistance
        return distance, normal


class _GradientOfDistance(torch.autograd.Function):
    """∂d/∂(r12, q1, q2), of r12, q1, q2, and the distance and the normal, which follow them."""

    @staticmethod
    def forward(ctx: Any, *pair: torch.Tensor) -> tuple[torch.Tensor, ...]:  # type: ignore[override]
        ctx.save_for_backward(*pair)
        _, q1, q2, _, n = _arrays(pair)
        squares = _outer(n, n)
        return _tensors((n, -squares / (2 * _half_width(q1, n)), -squares / (2 * _half_width(q2, n))))

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(ctx: Any, *change: torch.Tensor) -> tuple[Any, ...]:
        with np.errstate(invalid="ignore", divide="ignore"):
            return (*_tensors(_change_of_normal(*_arrays(ctx.saved_tensors)[1:], *_arrays(change))), None, None)


def _half_width(q: Floats, n: Floats) -> Floats:
    return np.asarray(np.sqrt(_dot(n, _product(q, n))))


def _change_of_normal(
    q1: Floats, q2: Floats, distance: Floats, n: Floats, d_r12: Floats, d_q1: Floats, d_q2: Floats
) -> tuple[Floats, Floats, Floats]:
    """The Hessian of the signed distance, which is symmetric, times a change of the arguments.

    In the notation of the chapter on distances, r12 = p1 + p2 + d n holds on, where p is Q n/α and changes by A dn, with
    A = (Q - p pᵀ)/α, and by the change of Q.
    """
    a = [_half_width(q, n) for q in (q1, q2)]
    p = [_product(q, n) / x for q, x in zip((q1, q2), a)]
    turn = sum((q - _outer(y, y) / _TWICE) / x for q, x, y in zip((q1, q2), a, p))
    unit = np.equal(ROWS, COLUMNS)
    stiffness = turn + distance[..., None] * unit + _dot(turn, unit) * _outer(n, n) / _TWICE
    widths = [_dot(n, _product(d, n)) / (2 * x) for d, x in zip((d_q1, d_q2), a)]
    points = [(_product(d, n) - w * y) / x for d, w, x, y in zip((d_q1, d_q2), widths, a, p)]
    force = d_r12 - points[0] - points[1]
    dn = _core.cholesky_solve(_core.cholesky_decomp(stiffness), force - _dot(force, n) * n)
    dn = dn - _dot(dn, n) * n
    squares, products = _outer(n, n), 2 * _outer(n, dn)
    forms = [
        -products / (2 * x) + squares * (w + _dot(y, dn)) / (2 * x * x) for w, x, y in zip(widths, a, p)
    ]
    return dn, forms[0], forms[1]


_TWICE = np.where(np.equal(ROWS, COLUMNS), 1, 2)
