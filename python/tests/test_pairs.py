# SPDX-License-Identifier: BSD-3-Clause
"""Neighbour lists."""

import functools
import tracemalloc

import numpy as np
import pytest

import pypw85

# Skewed by more than a half: rounding fractional coordinates does not find the nearest image here.
CELL = np.array([[4.0, 0, 0], [3.6, 4.0, 0], [3.5, 3.7, 4.0]])


@pytest.fixture
def particles(rng):
    count = 30
    q = pypw85.ellipsoid_quaternion(rng.uniform(0.3, 1, (count, 3)), rng.normal(size=(count, 4)))
    return rng.uniform(-8, 8, (count, 3)), q


@pytest.fixture
def pairs():
    return np.array([(i, j) for i in range(30) for j in range(30) if i != j], dtype=np.int32)


def vectors(pairs, centers):
    return centers[pairs[:, 1]] - centers[pairs[:, 0]]


def nearest_images(r12, cell):
    shifts = np.stack(np.meshgrid(*[np.arange(-9, 10)] * 3), axis=-1).reshape(-1, 3) @ cell
    images = r12[:, None] + shifts
    return images[np.arange(len(r12)), (images**2).sum(axis=-1).argmin(axis=1)]


@pytest.mark.parametrize("cell", [None, CELL])
def test_pairs(particles, pairs, cell, assert_rows):
    centers, q = particles
    r12 = vectors(pairs, centers)
    if cell is not None:
        r12 = nearest_images(r12, cell)
    expected, expected_lambda = pypw85.contact(r12, q[pairs[:, 0]], q[pairs[:, 1]])
    mu2, lambda_ = pypw85.contact_pairs(pairs, centers, q, cell)
    # r12 is rounded at another place: a few units in the last place of the largest coordinate, 20 or so with images.
    # μ² follows with a factor of at most twice the aspect ratio times |coordinate| / |r12|.
    shift = 8 * 2.0**-53 * 40 / np.linalg.norm(r12, axis=1)
    assert_rows(np.abs(mu2 - expected) <= 2 * 7 * shift * expected, pairs, r12, mu2, expected)
    np.testing.assert_allclose(lambda_, expected_lambda, rtol=1e-9)
    np.testing.assert_array_equal(pypw85.overlap_pairs(pairs, centers, q, cell), expected < 1)
    codes = pypw85.overlap_pairs(pairs, centers, q, cell, dtype=np.uint8)
    assert codes.dtype == np.uint8
    np.testing.assert_array_equal(codes, expected < 1)


@pytest.mark.parametrize("dtype", [np.int8, np.int64, np.uint32, ">i4"])
def test_other_types_and_layouts(particles, pairs, dtype):
    centers, q = particles
    expected = pypw85.contact_pairs(pairs, centers, q, CELL)
    pairs = np.asfortranarray(pairs.astype(dtype))
    actual = pypw85.contact_pairs(pairs, np.asfortranarray(centers), np.asfortranarray(q), CELL.tolist())
    np.testing.assert_array_equal(actual, expected)


def test_out(particles, pairs):
    centers, q = particles
    out = np.empty(len(pairs)), np.empty(len(pairs))
    mu2, lambda_ = pypw85.contact_pairs(pairs, centers, q, out=out)
    assert mu2 is out[0] and lambda_ is out[1]
    np.testing.assert_array_equal((mu2, lambda_), pypw85.contact_pairs(pairs, centers, q))
    for wrong in ((np.empty(3), np.empty(3)), (out[0][::2], out[1][::2]), (out[0].astype(np.float32), out[1])):
        with pytest.raises(TypeError):
            pypw85.contact_pairs(pairs, centers, q, out=wrong)


def test_no_pairs(particles):
    centers, q = particles
    for empty in ([], np.empty((0, 2), dtype=np.int32)):
        assert pypw85.contact_pairs(empty, centers, q)[0].shape == (0,)
        assert pypw85.overlap_pairs(empty, centers, q, CELL).shape == (0,)


@pytest.mark.parametrize("function", [pypw85.contact_pairs, pypw85.overlap_pairs])
@pytest.mark.parametrize("dtype", [np.int32, np.int64])
@pytest.mark.parametrize("index", [-1, 30, 2**31 - 1])
def test_index_out_of_range(particles, pairs, function, dtype, index):
    pairs = pairs.astype(dtype)
    pairs[7, 1] = index
    with pytest.raises(IndexError, match=rf"pair 7 is \(0, {index}\), but there are 30 particles"):
        function(pairs, *particles)


def calls_of_lists(centers, q):
    """Each function of lists of pairs that takes a cell, by its name: f(pairs, cell)."""
    derivatives = pypw85.contact_derivatives_pairs([[0, 1]], centers, [[1, 0, 0, 1, 0, 1]] * 2)
    others = {"contact_forces_pairs": (centers, [1.0], derivatives), "law_forces_pairs": (centers, q, pypw85.Law.soft_repulsion(1)),
              "first_contact_pairs": (centers, q, np.zeros((2, 7)), 1.0)}  # fmt: skip
    names = ["contact_pairs", "overlap_pairs", "overlap_volume_pairs", "contact_derivatives_pairs", *others]
    return {name: functools.partial(getattr(pypw85, name), [[0, 1]], *others.get(name, (centers, q))) for name in names}


@pytest.mark.parametrize("name", calls_of_lists([[0, 0, 0], [1, 0, 0]], [[1, 0, 0, 1, 0, 1]] * 2))
def test_refused_lists_differ_from_bad_pairs(name):
    """The cause tells a call that is refused as a whole, whatever its pairs are, from one whose first and only pair is bad."""
    bad = calls_of_lists([[0, 0, 0], [1, 0, 0]], [[1, 0, 0, 1, 0, 1], [0] * 6])[name]
    with pytest.raises(ValueError, match=rf"^{name}: cell must have independent rows, not \[\[1.0, 0.0, 0.0\], \[1.0"):
        bad(cell=[[1, 0, 0]] * 2 + [[0, 0, 1]])
    if name != "contact_forces_pairs":  # which reads no forms
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
            bad(cell=9 * np.eye(3))


def test_large_indices_are_not_wrapped(particles):
    with pytest.raises(IndexError):
        pypw85.contact_pairs(np.array([[0, 2**32 + 1]]), *particles)


@pytest.mark.parametrize("function", [pypw85.contact_pairs, pypw85.overlap_pairs])
@pytest.mark.parametrize("cell", [np.zeros((3, 3)), np.full((3, 3), np.nan), np.ones((3, 3))])
def test_bad_cell(particles, pairs, function, cell):
    with pytest.raises(ValueError, match="cell"):
        function(pairs, *particles, cell)


def test_wrong_shapes_and_types(particles, pairs):
    centers, q = particles
    wrong_shapes = [
        (pairs[:, :1], centers, q),
        (pairs, centers[:, :2], q),
        (pairs, centers, q[:-1]),
        (pairs, centers, q, CELL[:2]),
    ]
    for args in wrong_shapes:
        with pytest.raises(ValueError):
            pypw85.contact_pairs(*args)
    with pytest.raises(TypeError):
        pypw85.contact_pairs(pairs.astype(float), centers, q)
    with pytest.raises(TypeError):
        pypw85.overlap_pairs(pairs, centers, q, dtype=np.float64)


def test_bad_particle(particles, pairs):
    centers, q = particles
    q = q.copy()
    q[4] = 0
    bad = np.flatnonzero((pairs == 4).any(axis=1))
    with pytest.warns(RuntimeWarning, match="invalid value encountered in contact_pairs") as caught:
        result = pypw85.contact_pairs(pairs, centers, q)
    assert len(caught) == 1
    np.testing.assert_array_equal(pypw85.bad_rows(result), bad)
    with np.errstate(invalid="ignore"):
        codes = pypw85.overlap_pairs(pairs, centers, q, dtype=np.uint8)
        assert pypw85.overlap_pairs(pairs, centers, q)[bad].all()
    np.testing.assert_array_equal(pypw85.bad_rows(codes), bad)
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="overlap_pairs"):
        pypw85.overlap_pairs(pairs, centers, q)


def test_nearest_images(rng):
    cell = np.array([[3.0, 0, 0], [5, 4, 0], [-7, 2, 5]])
    centers, pairs = rng.uniform(-20, 20, (30, 3)), rng.integers(0, 30, (100, 2))
    r12, images = pypw85.nearest_images(pairs, centers, cell)
    np.testing.assert_allclose(np.diff(centers[pairs], axis=1)[:, 0] + images @ cell, r12, rtol=0, atol=1e-12)
    q = pypw85.ellipsoid_quaternion(rng.uniform(1, 2, (30, 3)), rng.normal(size=(30, 4)))
    mu2 = pypw85.contact(r12, *(q[pairs[:, k]] for k in range(2)))[0]
    np.testing.assert_allclose(pypw85.contact_pairs(pairs, centers, q, cell)[0], mu2, rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(pypw85.contact_pairs(pairs, centers, q, cell, images=images)[0], mu2, rtol=1e-11, atol=1e-11)


def test_nearest_images_of_bad_input():
    centers = np.array([[0, 0, 0], [np.nan, 0, 0]])
    r12, images = pypw85.nearest_images([[0, 1], [0, 0]], centers, np.eye(3))
    assert np.isnan(r12[0]).all() and (images[0] == -(2**31)).all() and not (r12[1].any() or images[1].any())
    with pytest.raises(ValueError, match=r"^nearest_images: cell must have independent rows, not \[\[0.0, 0.0, 0.0\], "):
        pypw85.nearest_images([[0, 0]], centers, np.zeros((3, 3)))
    with pytest.raises(ValueError, match=r"^nearest_images: cell must be finite along the periodic vectors, not \[\[inf, inf, inf\], "):
        pypw85.nearest_images([[0, 0]], centers, np.full((3, 3), np.inf))
    with pytest.raises(IndexError):
        pypw85.nearest_images(np.array([[0, 2]], dtype=np.int32), centers, np.eye(3))


@pytest.mark.parametrize("name", ["contact_pairs", "overlap_pairs", "nearest_images"])
def test_lists_are_used_in_place(name):
    """Index pairs and images of int32 are not copied: the memory of a call is that of its results."""
    n = 20_000
    pairs = np.tile(np.array([[0, 1]], np.int32), (n, 1))
    images = np.zeros((n, 3), np.int32)
    for array in (pairs, images):
        array.setflags(write=False)  # as those of Neighbors
    arguments = pairs, np.array([[0.0, 0, 0], [3, 0, 0]]), *([np.tile([1.0, 0, 0, 1, 0, 1], (2, 1))] if name != "nearest_images" else [])
    keywords = {"cell": 9 * np.eye(3)} | ({"images": images} if name != "nearest_images" else {})
    tracemalloc.start()
    try:
        results = getattr(pypw85, name)(*arguments, **keywords)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    own = sum(array.nbytes for array in (results if isinstance(results, tuple) else [results]))
    assert own <= peak < own + 2 * n, (peak, own)
