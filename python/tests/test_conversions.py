# SPDX-License-Identifier: BSD-3-Clause
"""Forms, and the conventions of other programs."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pypw85

U = 2.0**-53


def rotation_matrix(w, x, y, z):
    """Rotation of a vector v by the quaternion: v + 2 w (u × v) + 2 u × (u × v)."""
    w, *u = np.array([w, x, y, z]) / np.linalg.norm([w, x, y, z])
    cross = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


@pytest.fixture
def bodies(rng):
    semi_axes, wxyz = rng.uniform(0.1, 3, (50, 3)), rng.normal(size=(50, 4))
    rotations = np.array([rotation_matrix(*w) for w in wxyz])
    expected = pypw85.packed(np.einsum("nij,nj,nkj->nik", rotations, semi_axes**2, rotations))
    return semi_axes, wxyz, rotations, expected


def assert_close(actual, expected):
    # Each entry sums three products of rotation entries (some ten roundings each way) and squares up to 9.
    np.testing.assert_allclose(actual, expected, rtol=0, atol=3 * 20 * U * 9)


def test_ellipsoid(bodies):
    semi_axes, wxyz, rotations, expected = bodies
    assert_close(pypw85.ellipsoid(semi_axes, rotations), expected)
    assert_close(pypw85.ellipsoid_quaternion(semi_axes, wxyz), expected)


def test_from_lammps(bodies):
    semi_axes, wxyz, _, expected = bodies
    assert_close(pypw85.from_lammps(2 * semi_axes, wxyz), expected)


def test_from_ovito(bodies):
    semi_axes, wxyz, _, expected = bodies
    assert_close(pypw85.from_ovito(semi_axes, wxyz[:, [1, 2, 3, 0]]), expected)


def test_from_gsd(bodies):
    _semi_axes, wxyz, rotations, _ = bodies
    shapes = [{"type": "Ellipsoid", "a": 1.0, "b": 2.0, "c": 3.0}, {"type": "Sphere", "diameter": 3.0}, {}]
    actual = pypw85.from_gsd(shapes, np.arange(50, dtype=np.uint32) % 2, wxyz)
    assert_close(actual[::2], pypw85.ellipsoid([1, 2, 3], rotations[::2]))
    assert_close(actual[1::2], np.tile([2.25, 0, 0, 2.25, 0, 2.25], (25, 1)))
    with pytest.raises(ValueError, match="a shape must be an Ellipsoid with a, b and c"):
        pypw85.from_gsd(shapes, [2], wxyz[:1])
    with pytest.raises(ValueError, match="a shape must be an Ellipsoid with a, b and c"):
        pypw85.from_gsd([{"type": "Polygon", "vertices": []}], [0], wxyz[:1])
    with pytest.raises(IndexError):
        pypw85.from_gsd(shapes, [3], wxyz[:1])


def test_zero_sizes_are_refused():
    with pytest.raises(pypw85.PW85Error):
        pypw85.from_lammps([0, 0, 0], [1, 0, 0, 0])


def test_ellipse():
    angle = np.pi / 6
    rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    expected = (rotation @ np.diag([4, 1]) @ rotation.T)[np.triu_indices(2)]
    np.testing.assert_allclose(pypw85.ellipse(2, 1, angle), expected, rtol=0, atol=20 * U * 4)


def test_full_and_packed(rng):
    q = rng.normal(size=(3, 4, 6))
    matrices = pypw85.full(q)
    assert matrices.shape == (3, 4, 3, 3)
    np.testing.assert_array_equal(matrices, np.swapaxes(matrices, -1, -2))
    np.testing.assert_array_equal(pypw85.packed(matrices), q)
    np.testing.assert_array_equal(matrices[..., 1, 2], q[..., 4])
    assert pypw85.packed(np.empty((0, 3, 3))).shape == (0, 6)


def test_packed_refuses_what_is_not_symmetric():
    matrix = np.diag([1.0, 2.0, 3.0])
    matrix[0, 1] = 3e-7
    pypw85.packed(matrix)
    matrix[0, 1] = 3e-5
    with pytest.raises(ValueError, match="not symmetric"):
        pypw85.packed(matrix)
    with pytest.raises(ValueError, match="3×3"):
        pypw85.packed(np.eye(2))
    with pytest.raises(ValueError, match="must be 6"):
        pypw85.full(np.ones(5))


def test_principal_axes(bodies):
    semi_axes, _, _, q = bodies
    actual, axes = pypw85.principal_axes(q)
    # Squares are known to some u times the largest square; roots to that over twice the square.
    bound = 20 * U * 9 / (2 * semi_axes.min() ** 2)
    np.testing.assert_allclose(actual, np.sort(semi_axes, axis=-1), rtol=bound)
    np.testing.assert_allclose(np.linalg.det(axes), 1, rtol=20 * U)
    assert_close(pypw85.ellipsoid(actual, axes), q)


def test_principal_axes_of_bad_rows(bodies):
    q = bodies[-1].copy()
    q[3], q[5, 2] = 0, np.inf
    with pytest.warns(RuntimeWarning, match="invalid") as caught:
        semi_axes, axes = pypw85.principal_axes(q)
    assert len(caught) == 1
    np.testing.assert_array_equal(pypw85.bad_rows(semi_axes, core_ndim=1), [3, 5])
    np.testing.assert_array_equal(pypw85.bad_rows(axes, core_ndim=2), [3, 5])


def test_rotations_of_scipy(rng):
    """The same ellipsoids from SciPy's rotations, Euler angles and rotation vectors as from quaternions."""
    rotation = Rotation.random(20, random_state=7)
    axes = rng.uniform(0.5, 3, (20, 3))
    expected = pypw85.ellipsoid_quaternion(axes, rotation.as_quat()[:, [3, 0, 1, 2]])
    np.testing.assert_allclose(pypw85.ellipsoid(axes, rotation), expected, atol=1e-14)
    np.testing.assert_allclose(pypw85.ellipsoid(axes[0], rotation[0]), expected[0], atol=1e-14)
    np.testing.assert_allclose(pypw85.from_rotation_vector(axes, rotation.as_rotvec()), expected, atol=1e-13)
    for seq in ("zxz", "ZYX", "xyz"):
        degrees = rotation.as_euler(seq, degrees=True)
        np.testing.assert_allclose(pypw85.from_euler(axes, seq, degrees, degrees=True), expected, atol=1e-13)
        grid = np.radians(degrees).reshape(4, 5, 3)
        np.testing.assert_allclose(pypw85.from_euler(axes.reshape(4, 5, 3), seq, grid).reshape(20, 6), expected, atol=1e-13)
    np.testing.assert_allclose(pypw85.from_euler([1, 2, 3], "z", [[0.0, np.pi / 2]])[0, 1], [4, 0, 0, 1, 0, 9], atol=1e-14)
    assert pypw85.from_euler([1, 2, 3], "xyz", np.empty((0, 3))).shape == (0, 6)


def test_small_and_large_rotation_vectors():
    np.testing.assert_array_equal(pypw85.from_rotation_vector([1, 2, 3], [0, 0, 0]), [1, 0, 0, 4, 0, 9])
    np.testing.assert_allclose(pypw85.from_rotation_vector([1, 2, 3], [0, 0, 1e-200]), [1, 0, 0, 4, 0, 9], atol=1e-199)
    np.testing.assert_allclose(pypw85.from_rotation_vector([1, 2, 3], [0, 0, 2 * np.pi]), [1, 0, 0, 4, 0, 9], atol=1e-14)


def test_bad_rotations():
    with pytest.raises(ValueError, match="last dimension must be 3"):
        pypw85.from_rotation_vector([1, 2, 3], [1, 2])
    with pytest.raises(pypw85.PW85Error):
        pypw85.from_rotation_vector([1, 2, 3], [np.nan, 0, 0])
    with pytest.raises(pypw85.PW85Error):
        pypw85.from_euler([1, -2, 3], "zyx", [0, 0, 0])
    for seq, angles in (("zYx", [0, 0, 0]), ("q", [0]), ("zyx", [0, 0])):
        with pytest.raises(ValueError):
            pypw85.from_euler([1, 2, 3], seq, angles)


def test_covariance(rng):
    """As many samples of a normal distribution are in the ellipsoid as its confidence says."""
    root = rng.normal(size=(3, 3))
    covariance = root @ root.T
    points = rng.normal(size=(40000, 3)) @ root.T
    for confidence in (0.1, 0.5, 0.95):
        q = pypw85.from_covariance(covariance, confidence)
        inside = (np.einsum("ni,ij,nj->n", points, np.linalg.inv(pypw85.full(q)), points) < 1).mean()
        assert abs(inside - confidence) < 5 * np.sqrt(confidence * (1 - confidence) / len(points))
    for confidence in (0, 1, -1, np.nan):
        with pytest.raises(ValueError, match="between 0 and 1"):
            pypw85.from_covariance(covariance, confidence)
    with pytest.raises(ValueError, match="not symmetric"):
        pypw85.from_covariance(root, 0.5)
