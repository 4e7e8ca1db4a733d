# SPDX-License-Identifier: BSD-3-Clause
"""The contact function and the signed distance of PyTorch's tensors: derivatives against differences, and against the library's own."""

import subprocess
import sys

import numpy as np
import pytest

import pypw85

torch = pytest.importorskip("torch")
import pypw85.torch  # noqa: E402


@pytest.fixture
def pairs(rng):
    """Some pairs near contact, with moderate forms, so that differences are good derivatives."""
    n = 6
    q1, q2 = (pypw85.ellipsoid_quaternion(rng.uniform(0.5, 2, (n, 3)), rng.normal(size=(n, 4))) for _ in range(2))
    return [torch.tensor(x, requires_grad=True) for x in (rng.uniform(0.5, 2, (n, 3)), q1, q2)]


def mu2(*pair):
    return pypw85.torch.contact(*pair)[0]


def test_values(pairs):
    expected = pypw85.contact(*(x.detach().numpy() for x in pairs))
    for actual, numbers in zip(pypw85.torch.contact(*pairs), expected):
        np.testing.assert_array_equal(actual.detach().numpy(), numbers)


def test_first_derivatives(pairs):
    assert torch.autograd.gradcheck(mu2, pairs)


def test_second_derivatives(pairs):
    assert torch.autograd.gradgradcheck(mu2, pairs)


def test_broadcasting(pairs):
    r12, q1, q2 = pairs
    assert torch.autograd.gradcheck(mu2, (r12, q1[0], q2[:1]))
    assert torch.autograd.gradgradcheck(mu2, (r12, q1[0], q2[:1]))


def test_hessian_is_that_of_the_library(rng):
    """Rotation vectors act as exp: quaternions (1, ω/2) and their second-order term."""
    r12, axes1, axes2 = rng.uniform(0.5, 2, (3, 3))
    turn1, turn2 = rng.normal(size=(2, 4))
    q1, q2 = pypw85.ellipsoid_quaternion(axes1, turn1), pypw85.ellipsoid_quaternion(axes2, turn2)

    def turned(q, omega):
        x, y, z = omega
        zero = torch.zeros((), dtype=torch.float64)
        generator = torch.stack([torch.stack(row) for row in ((zero, -z, y), (z, zero, -x), (-y, x, zero))])
        rotation = torch.matrix_exp(generator)
        full = rotation @ torch.tensor(pypw85.full(q)) @ rotation.T
        return full[[0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]

    def moved(x):
        return mu2(torch.tensor(r12) + x[:3], turned(q1, x[3:6]), turned(q2, x[6:]))

    actual = torch.autograd.functional.hessian(moved, torch.zeros(9, dtype=torch.float64))
    expected = pypw85.contact_hessian(r12, q1, q2, pypw85.contact(r12, q1, q2)[1])
    np.testing.assert_allclose(actual.numpy(), expected, rtol=0, atol=1e-11 * np.abs(expected).max())


def test_unlike_sizes(rng):
    """Second derivatives along r12 follow from the degree of μ², also where λ is next to an end."""
    q1, q2 = (torch.tensor(pypw85.ellipsoid_quaternion(x * rng.uniform(1, 2, 3), rng.normal(size=4))) for x in (1, 1e6))
    for first, second in ((q1, q2), (q2, q1)):
        r12 = torch.tensor(1e6 * rng.uniform(1, 2, 3))
        hessian = torch.autograd.functional.hessian(lambda x: mu2(x, first, second), r12)
        gradient = torch.autograd.functional.jacobian(lambda x: mu2(x, first, second), r12)
        np.testing.assert_allclose(hessian @ r12, gradient, rtol=1e-8)


def test_forms(rng):
    semi_axes, quaternions = rng.uniform(1, 2, (5, 3)), rng.normal(size=(5, 4))
    tensors = [torch.tensor(x, requires_grad=True) for x in (semi_axes, quaternions)]
    q = pypw85.torch.ellipsoid_quaternion(*tensors)
    np.testing.assert_allclose(q.detach(), pypw85.ellipsoid_quaternion(semi_axes, quaternions), rtol=0, atol=1e-14)
    assert torch.autograd.gradcheck(pypw85.torch.ellipsoid_quaternion, tensors)
    assert torch.autograd.gradgradcheck(pypw85.torch.ellipsoid_quaternion, tensors)


def test_single_precision():
    q = torch.tensor([1.0, 0.0, 0.0, 1.0, 0.0, 1.0])
    r12 = torch.tensor([3.0, 0.0, 0.0], requires_grad=True)
    value, lambda_ = pypw85.torch.contact(r12, q, q)
    assert (value.dtype, value.item(), lambda_.item()) == (torch.float32, 2.25, 0.5)
    assert not lambda_.requires_grad
    value.backward()
    assert r12.grad.dtype == torch.float32


def test_bad_input(pairs):
    r12, q1, q2 = pairs
    for wrong, error in (((r12[:, :2], q1, q2), ValueError), ((r12, q1[0, 0], q2), ValueError),
                         ((r12, q1.to(torch.complex128), q2), TypeError), ((r12.detach().numpy(), q1, q2), TypeError)):
        with pytest.raises(error):
            pypw85.torch.contact(*wrong)
    with pytest.raises(pypw85.PW85Error):
        pypw85.torch.contact(r12[0], -q1[0], q2[0])
    with torch.no_grad():
        q1[2] *= -1
    with np.errstate(invalid="ignore"):
        value = mu2(r12, q1, q2)
        (gradient,) = torch.autograd.grad(value.sum(), r12, create_graph=True)
        gradient.sum().backward()
    bad = np.arange(6) == 2
    for x in (value, gradient[:, 0], r12.grad[:, 0]):
        np.testing.assert_array_equal(np.isnan(x.detach().numpy()), bad)


def test_package_does_not_import_torch():
    subprocess.run([sys.executable, "-c", "import sys, pypw85; assert 'torch' not in sys.modules"], check=True)


@pytest.fixture
def both_sides(rng):
    """Pairs that overlap by a little, and pairs that are apart."""
    n = 8
    q1, q2 = (pypw85.ellipsoid_quaternion(rng.uniform(0.7, 1.4, (n, 3)), rng.normal(size=(n, 4))) for _ in range(2))
    r12 = rng.normal(size=(n, 3))
    r12 *= (pypw85.closest_approach(r12, q1, q2) / np.linalg.norm(r12, axis=-1) * np.repeat([0.9, 1.3], n // 2))[:, None]
    return [torch.tensor(x, requires_grad=True) for x in (r12, q1, q2)]


def test_signed_distance(both_sides):
    arrays = [x.detach().numpy() for x in both_sides]
    distance = pypw85.torch.signed_distance(*both_sides)
    np.testing.assert_array_equal(distance.detach().numpy(), pypw85.signed_distance(*arrays)[0])
    assert (distance[:4] < 0).all() and (distance[4:] > 0).all()
    assert torch.autograd.gradcheck(pypw85.torch.signed_distance, both_sides)
    assert torch.autograd.gradgradcheck(pypw85.torch.signed_distance, both_sides)
    r12, q1, q2 = both_sides
    assert torch.autograd.gradgradcheck(pypw85.torch.signed_distance, (r12, q1[0], q2[:1] / 2))


def test_signed_distance_at_contact():
    """The derivatives are those of both sides; of pairs with no best direction the second ones are NaN."""
    sphere = torch.tensor([1.0, 0, 0, 1, 0, 1], dtype=torch.float64)
    r12 = torch.tensor([0.0, 2, 0], dtype=torch.float64)

    def along(x):
        return pypw85.torch.signed_distance(x, sphere, sphere)

    assert along(r12) == 0
    np.testing.assert_allclose(torch.autograd.functional.jacobian(along, r12), [0, 1, 0], atol=1e-15)
    np.testing.assert_allclose(torch.autograd.functional.hessian(along, r12), np.diag([0.5, 0, 0.5]), atol=1e-15)
    assert torch.isnan(torch.autograd.functional.hessian(along, 0 * r12)).all()
