"""The contact function of tensors of PyTorch, differentiable twice.

Import it by name, ``import pypw85.torch``: `pypw85` itself does not need PyTorch.

Tensors are on the CPU; they are broadcast against each other, and computed with in double precision, whatever their type. First
derivatives are those of `pypw85.contact_gradient`. Second derivatives serve what PyTorch builds of them: Hessians, products
of Hessians with vectors, gradients of functions of forces.
"""

# mypy: allow-subclassing-any, allow-untyped-decorators, no-warn-unused-ignores

from __future__ import annotations

from typing import Any

import numpy as np
import torch

from . import _core
from ._typing import Floats

__all__ = ["contact", "ellipsoid_quaternion"]

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
    tensors = [_double(x, size) for x, size in ((r12, 3), (q1, 6), (q2, 6))]
    leading = torch.broadcast_shapes(*(x.shape[:-1] for x in tensors))
    mu2, lambda_ = _Contact.apply(*(x.expand(*leading, x.shape[-1]) for x in tensors))
    result = torch.promote_types(r12.dtype, torch.promote_types(q1.dtype, q2.dtype))
    result = result if result.is_floating_point else torch.float64
    return mu2.to(result), lambda_.to(result)


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


def _double(x: torch.Tensor, size: int) -> torch.Tensor:
    if not isinstance(x, torch.Tensor) or x.device.type != "cpu" or x.is_complex():
        raise TypeError("pypw85.torch takes tensors of real numbers on the CPU")
    if x.dim() == 0 or x.shape[-1] != size:
        raise ValueError(f"the last dimension must be {size}, not {tuple(x.shape)}")
    return x.to(torch.float64)


def _arrays(tensors: Any) -> list[Floats]:
    return [x.detach().numpy() for x in tensors]


def _tensors(arrays: Any) -> tuple[torch.Tensor, ...]:
    return tuple(torch.from_numpy(np.array(x, dtype=np.float64)) for x in arrays)


class _Contact(torch.autograd.Function):
    """μ² and λ of r12, q1, q2."""

    @staticmethod
    def forward(ctx: Any, *pair: torch.Tensor) -> tuple[torch.Tensor, ...]:  # type: ignore[override]
        mu2, lambda_ = _tensors(_core.call_contact(*_arrays(pair), None, {}))
        ctx.save_for_backward(*pair, lambda_)
        ctx.mark_non_differentiable(lambda_)
        return mu2, lambda_

    @staticmethod
    def backward(ctx: Any, d_mu2: torch.Tensor, _: torch.Tensor) -> tuple[torch.Tensor, ...]:  # type: ignore[override]
        return tuple(d_mu2[..., None] * d for d in _Gradient.apply(*ctx.saved_tensors))


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
