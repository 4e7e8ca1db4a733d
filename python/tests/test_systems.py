# SPDX-License-Identifier: BSD-3-Clause
"""Derivatives of many pairs, images, cells, neighbour lists, one against many, boxes: against the functions of one pair."""

import itertools

import numpy as np
import pytest

import pypw85

CELL = np.array([[6.0, 0, 0], [2, 5, 0], [-1, 2, 7]])


@pytest.fixture
def particles():
    rng = np.random.default_rng(5)
    q = pypw85.ellipsoid_quaternion(rng.uniform(0.5, 1.5, (30, 3)), rng.normal(size=(30, 4)))
    pairs = rng.integers(0, 30, (200, 2))
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    return pairs, rng.uniform(0, 6, (30, 3)), q


def separate(result):
    """What `contact_derivatives` gives, by the functions of one purpose."""
    def check(r12, q1, q2):
        mu2, lambda_ = pypw85.contact(r12, q1, q2)
        np.testing.assert_allclose(result.mu2, mu2, rtol=1e-12)
        np.testing.assert_allclose(result.lambda_, lambda_, rtol=1e-6)
        point, normal = pypw85.contact_geometry(r12, q1, q2, result.lambda_)
        d_rot1, d_rot2 = pypw85.contact_torque(r12, q1, q2, result.lambda_)
        d_r12, _, _ = pypw85.contact_gradient(r12, q1, q2, result.lambda_)
        for actual, expected in zip(result[2:], (point, normal, d_r12, d_rot1, d_rot2)):
            np.testing.assert_allclose(actual, expected, rtol=1e-10, atol=1e-11)
    return check


@pytest.mark.parametrize("rows", [(), (1,), (5, 200), (2000,)])
def test_contact_derivatives(particles, rows):
    rng = np.random.default_rng(6)
    _, _, q = particles
    r12, q1, q2 = rng.normal(size=rows + (3,)), q[rng.integers(0, 30, rows)], q[rng.integers(0, 30, rows)]
    separate(pypw85.contact_derivatives(r12, q1, q2))(r12, q1, q2)
    scattered = [np.asfortranarray(x) for x in (r12, q1, q2)]
    result = pypw85.contact_derivatives(*scattered)
    for actual, expected in zip(result, pypw85.contact_derivatives(r12, q1, q2)):
        np.testing.assert_array_equal(actual, expected)


def test_derivatives_of_pairs(particles):
    pairs, centers, q = particles
    i, j = pairs.T
    images = np.random.default_rng(7).integers(-1, 2, (len(pairs), 3))
    r12 = centers[j] + images @ CELL - centers[i]
    separate(pypw85.contact_derivatives_pairs(pairs, centers, q, CELL, images))(r12, q[i], q[j])
    separate(pypw85.contact_derivatives_pairs(pairs, centers, q))(centers[j] - centers[i], q[i], q[j])


def test_images(particles):
    pairs, centers, q = particles
    i, j = pairs.T
    images = np.random.default_rng(8).integers(-2, 3, (len(pairs), 3))
    expected, _ = pypw85.contact(centers[j] + images @ CELL - centers[i], q[i], q[j])
    for kind in (np.int32, np.int64, np.uint8):
        given = images.astype(kind) if kind != np.uint8 else np.abs(images).astype(kind)
        mu2, _ = pypw85.contact_pairs(pairs, centers, q, CELL, images=given)
        if kind != np.uint8:
            np.testing.assert_allclose(mu2, expected, rtol=1e-12)
            np.testing.assert_array_equal(pypw85.overlap_pairs(pairs, centers, q, CELL, images=given), expected < 1)


def test_wrong_images(particles):
    pairs, centers, q = particles
    images = np.ones((len(pairs), 3), dtype=int)
    for function in (pypw85.contact_pairs, pypw85.overlap_pairs, pypw85.contact_derivatives_pairs):
        with pytest.raises(ValueError, match="images are multiples of the cell vectors: pass cell"):
            function(pairs, centers, q, images=images)
        with pytest.raises(ValueError, match="shape"):
            function(pairs, centers, q, CELL, images=images[1:])
        with pytest.raises(TypeError, match="integers"):
            function(pairs, centers, q, CELL, images=images * 1.0)
        with pytest.raises(OverflowError, match="32 bits"):
            function(pairs, centers, q, CELL, images=images + 2**40)


def test_closest_approach_of_arrays(particles):
    rng = np.random.default_rng(9)
    _, _, q = particles
    direction = rng.normal(size=(100, 3)) * 10.0 ** rng.uniform(-200, 200, (100, 1))
    q1, q2 = q[rng.integers(0, 30, 100)], q[rng.integers(0, 30, 100)]
    one_by_one = [pypw85.closest_approach(*row) for row in zip(direction, q1, q2)]
    np.testing.assert_allclose(pypw85.closest_approach(direction, q1, q2), one_by_one, rtol=1e-13)
    direction[3] = 0
    with pytest.warns(RuntimeWarning, match="invalid value"):
        distance = pypw85.closest_approach(direction, q1, q2)
    assert np.isnan(distance).tolist() == [k == 3 for k in range(100)]


def test_overlap_any(particles):
    _, centers, q = particles
    for k in range(30):
        others = np.arange(30) != k
        expected = pypw85.overlap(2 * (centers[others] - centers[k]), q[k], q[others]).any()
        assert pypw85.overlap_any(q[k], 2 * (centers[others] - centers[k]), q[others]) is bool(expected)
    assert pypw85.overlap_any(q[0], np.empty((0, 3)), np.empty((0, 6))) is False
    with pytest.raises(pypw85.PW85Error):
        pypw85.overlap_any(q[0], [[np.nan, 0, 0]], q[:1])
    with pytest.raises(ValueError):
        pypw85.overlap_any(q[0], [[9, 0, 0]], q[:2])


def brute_force(centers, q, cell, periodic, scale, skin):
    """All (i, j, image) whose boxes are near enough."""
    half_widths = scale * pypw85.bounding_boxes(q)
    steps = [np.arange(-4, 5) if flag else [0] for flag in periodic]
    found = set()
    for image in np.stack(np.meshgrid(*steps), -1).reshape(-1, 3):
        for i, j in itertools.combinations_with_replacement(range(len(q)), 2):
            separation = centers[j] - centers[i] + image @ cell
            near = (abs(separation) <= half_widths[i] + half_widths[j] + skin).all()
            if near and (i < j or tuple(image) > (0, 0, 0)):
                found.add((i, j, *image))
    return found


@pytest.mark.parametrize("periodic", [True, False, (True, False, True)])
def test_neighbors(particles, periodic):
    _, centers, q = particles
    options = {"scale": 0.7, "skin": 0.1}
    found = pypw85.neighbors(centers, q, CELL, periodic, **options)
    expected = brute_force(centers, q, CELL, np.broadcast_to(periodic, 3), **options)
    assert sorted(map(tuple, np.hstack([found.pairs, found.images]))) == sorted(expected)
    assert len(found) == len(found.pairs) > 0
    moved = centers.copy()
    moved[3] += 0.09
    assert found.holds(moved, q, CELL)
    moved[3] += 0.02
    assert not found.holds(moved, q, CELL)
    assert found.holds(0.999 * centers, q, 0.999 * CELL)
    assert found.holds(centers, q, 0.9 * CELL) == (not np.any(periodic))
    with pytest.raises(ValueError, match="pass the present cell"):
        found.holds(centers, q)
    if np.any(periodic):
        with pytest.raises(pypw85.PW85Error):
            found.holds(centers, q, np.nan * CELL)
    mu2, _ = pypw85.contact_pairs(found.pairs, centers, q, CELL, images=found.images)
    assert np.isfinite(mu2).all()


def test_neighbors_without_cell(particles):
    _, centers, q = particles
    found = pypw85.neighbors(centers, q)
    assert found.images.shape == (len(found), 3) and not found.images.any()
    mu2, _ = pypw85.contact_pairs(found.pairs, centers, q, images=found.images)
    all_mu2, _ = pypw85.contact_pairs(list(itertools.combinations(range(len(q)), 2)), centers, q)
    assert (mu2 < 1).sum() == (all_mu2 < 1).sum()
    with pytest.raises(ValueError, match="images are multiples of the cell vectors: pass cell"):
        pypw85.contact_pairs(found.pairs, centers, q, images=found.images + 1)
    pairs = found.pairs
    del found
    assert pairs.max() < len(q)  # the arrays keep their memory
    assert len(pypw85.neighbors(np.empty((0, 3)), np.empty((0, 6)))) == 0


def test_neighbors_errors(particles):
    _, centers, q = particles
    bad = centers.copy()
    bad[7, 1] = np.nan
    with pytest.raises(pypw85.PW85Error, match="particle 7: centers must be finite"):
        pypw85.neighbors(bad, q, CELL)
    with pytest.raises(pypw85.PW85Error, match="neighbors: cell must have finite, independent vectors, one of them periodic"):
        pypw85.neighbors(centers, q, np.ones((3, 3)))
    with pytest.raises(pypw85.PW85Error):
        pypw85.neighbors(centers, q, scale=0)
    with pytest.raises(MemoryError):
        pypw85.neighbors(centers, q, 1e-6 * np.eye(3))
    with pytest.raises(ValueError):
        pypw85.neighbors(centers, q[1:])
    with pytest.raises(pypw85.PW85Error):
        pypw85.neighbors(centers, q).holds(centers[1:], q[1:])
    with pytest.raises(ValueError, match="no cell"):
        pypw85.neighbors(centers, q).holds(centers, q, CELL)


def test_overlap_any_indices(particles):
    _, centers, q = particles
    for k in range(30):
        others = np.flatnonzero(np.arange(30) != k)[k % 5 :: 3]
        pairs = np.stack([np.full_like(others, k), others], axis=1)
        for cell in (None, 3 * CELL):
            expected = pypw85.overlap_pairs(pairs, 2 * centers, q, cell).any()
            found = pypw85.overlap_any_indices(2 * centers[k], q[k], others, 2 * centers, q, cell)
            assert found is bool(expected)
    assert pypw85.overlap_any_indices(centers[0], q[0], [], centers, q) is False
    assert pypw85.overlap_any_indices(centers[0], q[0], [], centers, q, 0.1 * CELL, np.empty((0, 3))) is False
    with pytest.raises(pypw85.PW85Error):
        pypw85.overlap_any_indices(centers[0], q[0], [], centers, q, 0.1 * CELL)  # which meets images of itself
    assert pypw85.overlap_any_indices(centers[0], q[0], [0], centers, q, 0.1 * CELL, [[1, 0, 0]])
    with pytest.raises(ValueError, match="shape"):
        pypw85.overlap_any_indices(centers[0], q[0], [0], centers, q, CELL, [[1, 0]])
    with pytest.raises(pypw85.PW85Error):
        pypw85.overlap_any_indices(centers[0], q[0], [30], centers, q)
    with pytest.raises(ValueError):
        pypw85.overlap_any_indices(centers[0], q[0], [[1]], centers, q)


def test_contact_forces(particles):
    _, centers, q = particles
    found = pypw85.neighbors(centers, q, CELL)
    system = (found.pairs, centers, q)
    derivatives = pypw85.contact_derivatives_pairs(*system, CELL, found.images)
    d_u = np.where(derivatives.mu2 < 1, 2 * (derivatives.mu2 - 1), 0)
    sums = pypw85.contact_forces_pairs(*system[:2], d_u, derivatives, CELL, found.images)
    forces, torques = np.zeros((30, 3)), np.zeros((30, 3))
    i, j = found.pairs.T
    np.add.at(forces, i, d_u[:, None] * derivatives.d_r12)
    np.add.at(forces, j, -d_u[:, None] * derivatives.d_r12)
    np.add.at(torques, i, -d_u[:, None] * derivatives.d_rot1)
    np.add.at(torques, j, -d_u[:, None] * derivatives.d_rot2)
    np.testing.assert_allclose(sums.forces, forces, atol=1e-12)
    np.testing.assert_allclose(sums.torques, torques, atol=1e-12)
    assert np.trace(sums.virial) == pytest.approx(-2 * (derivatives.mu2 * d_u).sum())
    with pytest.raises(ValueError, match="d_u"):
        pypw85.contact_forces_pairs(*system[:2], d_u[1:], derivatives, CELL, found.images)
    with pytest.raises(ValueError):
        pypw85.contact_forces_pairs(*system[:2], d_u, derivatives, np.ones((3, 3)))


@pytest.mark.parametrize(
    ("law", "u", "d_u"),
    [
        (pypw85.Law.soft_repulsion(3.0), lambda x: 1.5 * (1 - np.sqrt(x)) ** 2 * (x < 1),
         lambda x: -1.5 * (1 / np.sqrt(x) - 1) * (x < 1)),
        (pypw85.Law.inverse_powers(4, 12, 4, 6), lambda x: 4 * (x**-6 - x**-3), lambda x: 4 * (3 * x**-4 - 6 * x**-7)),
        (pypw85.Law.table(0, 4, [0, 8, 64], [0, 12, 48]), lambda x: x**3 * (x < 4), lambda x: 3 * x**2 * (x < 4)),
    ],
)  # fmt: skip
def test_laws(particles, law, u, d_u):
    """The sums of a law are those of its derivative in two steps."""
    _, centers, q = particles
    found = pypw85.neighbors(centers, q, CELL)
    system = found.pairs, centers, q
    derivatives = pypw85.contact_derivatives_pairs(*system, CELL, found.images)
    two_steps = pypw85.contact_forces_pairs(*system[:2], d_u(derivatives.mu2), derivatives, CELL, found.images)
    sums = pypw85.law_forces_pairs(*system, law, CELL, found.images)
    assert sums.energy == pytest.approx(u(derivatives.mu2).sum(), rel=1e-12)
    for one, other in zip(sums[1:], two_steps):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-12 * np.abs(other).max())


def test_wrong_laws(particles):
    pairs, centers, q = particles
    with pytest.raises(ValueError, match="law"):
        pypw85.law_forces_pairs(pairs, centers, q, pypw85.Law.soft_repulsion(1, 0.5))
    with pytest.raises(ValueError, match="cell"):
        pypw85.law_forces_pairs(pairs, centers, q, pypw85.Law.soft_repulsion(1), np.ones((3, 3)))
    with np.errstate(invalid="ignore"):
        assert np.isnan(pypw85.law_forces_pairs(pairs, centers, -q, pypw85.Law.soft_repulsion(1)).energy)


def test_cells(particles):
    pairs, centers, q = particles
    skewed = np.array([[1, 0, 0], [3, 1, 0], [-4, 7, 1]]) @ CELL
    reduced = pypw85.cell_reduce(skewed)
    assert abs(np.linalg.det(reduced)) == pytest.approx(np.linalg.det(CELL))
    assert np.linalg.norm(reduced, axis=1).max() <= np.linalg.norm(CELL, axis=1).max() * (1 + 1e-12)
    np.testing.assert_allclose(
        pypw85.contact_pairs(pairs, centers, q, skewed), pypw85.contact_pairs(pairs, centers, q, reduced), rtol=1e-6
    )
    with pytest.raises(pypw85.PW85Error):
        pypw85.cell_reduce(np.ones((3, 3)))
    assert pypw85.nearest_image_limit(q, 4 * CELL) == pytest.approx(16 * pypw85.nearest_image_limit(q, skewed))
    with pytest.raises(pypw85.PW85Error):
        pypw85.nearest_image_limit(q, np.ones((3, 3)))
    np.testing.assert_array_equal(pypw85.bounding_boxes(q), np.sqrt(q[:, [0, 3, 5]]))
