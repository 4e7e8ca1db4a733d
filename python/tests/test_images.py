# SPDX-License-Identifier: BSD-3-Clause
"""Ellipsoids from second moments, tensors of inertia and labelled images."""

import itertools
import tracemalloc
import warnings

import numpy as np
import pytest

import pypw85
from systems import random_system

def voxel_ellipsoid(shape, center, semi_axes, rotation, label=1, image=None):
    """Voxels whose centres are inside."""
    image = np.zeros(shape, dtype=np.uint16) if image is None else image
    offsets = np.moveaxis(np.indices(shape), 0, -1) - center
    image[(((offsets @ rotation) / semi_axes) ** 2).sum(axis=-1) <= 1] = label
    return image


@pytest.mark.parametrize("unit", [2.0**-40, 1, 2.0**40])
def test_from_moments(unit):
    """By the moments of points, drawn uniformly: their covariance errs by a few times 1/√n."""
    chance = np.random.default_rng(11)
    n, q = 200_000, np.array([4, 1, 0.5, 2, -0.3, 1])
    directions = chance.normal(size=(n, 3))
    points = directions / np.linalg.norm(directions, axis=1)[:, None] * chance.uniform(size=n)[:, None] ** (1 / 3)
    points = unit * points @ np.linalg.cholesky(pypw85.full(q)).T
    np.testing.assert_allclose(pypw85.from_moments(np.cov(points.T)), unit**2 * q, atol=4 * 4 / np.sqrt(n) * unit**2)
    inertia = np.einsum("ni,ni->", points, points) / n * np.eye(3) - points.T @ points / n
    np.testing.assert_allclose(pypw85.from_inertia(7 * inertia, mass=7), 5 * pypw85.packed(points.T @ points / n), rtol=1e-13,
                               atol=1e-13 * unit**2)  # fmt: skip
    # In the plane a uniform disc has the covariance r²/4.
    turns, radii = chance.uniform(0, 2 * np.pi, n), np.sqrt(chance.uniform(size=n))
    plane = unit * np.column_stack([3 * radii * np.cos(turns), radii * np.sin(turns)])
    np.testing.assert_allclose(pypw85.from_moments(np.cov(plane.T)), unit**2 * np.array([9, 0, 1]), atol=4 * 9 / np.sqrt(n) * unit**2)


def test_closed_forms():
    for q in random_system().q[:9]:
        moments = pypw85.full(q) / 5
        np.testing.assert_allclose(pypw85.from_moments(moments), q, rtol=1e-14, atol=1e-16)
        np.testing.assert_allclose(pypw85.from_inertia(np.trace(moments) * np.eye(3) - moments), q, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(pypw85.from_inertia(np.diag([1 / 4, 9 / 4])), [9, 0, 1], rtol=1e-14)
    stack = pypw85.full(random_system().q).reshape(2, 20, 3, 3)
    assert pypw85.from_moments(stack).shape == (2, 20, 6)


def test_moments_of_no_body():
    """The cause and the row are those that the library tells."""
    for entry, cause in ((-1, "be positive definite"), (0, "be positive definite"), (np.nan, "be finite"), (np.inf, "be finite")):
        for n in (2, 3):
            matrix = np.diag([1, entry, 1][:n])
            with pytest.raises(ValueError, match=f"from_moments: second_moments must {cause}.*: check that"):
                pypw85.from_moments(matrix)
            with pytest.raises(ValueError, match=rf"from_moments: row \(1, 0\): second_moments must {cause}.*: check that"):
                pypw85.from_moments([[np.eye(n)], [matrix]])
    with pytest.raises(ValueError, match=r"from_inertia: row \(1,\): second_moments must be positive definite, .* smaller than"):
        pypw85.from_inertia([np.eye(3), np.diag([1, 2, 4])])  # 4 > 1 + 2
    with pytest.raises(ValueError, match="3×3 or 2×2, not the shape"):
        pypw85.from_inertia(np.eye(4))
    with pytest.raises(ValueError, match="not symmetric"):
        pypw85.from_moments([[1, 0.5], [0.1, 1]])


def discrepancy(semi_axes):
    """Grid points in a smooth body differ from its volume by about R^(131/96) (Heath-Brown 1999): their share."""
    volume = 4 / 3 * np.pi * np.prod(semi_axes)
    return np.cbrt(np.prod(semi_axes)) ** (131 / 96) / volume


@pytest.mark.parametrize("spacing", [1.0, 2.0**-40, 2.0**40])
def test_voxel_ellipsoid(spacing):
    chance = np.random.default_rng(3)
    rotation = np.linalg.qr(chance.normal(size=(3, 3)))[0]
    image = voxel_ellipsoid((110, 112, 108), [54.3, 55.1, 53.8], [10, 20, 50], rotation, label=40_000)
    system = pypw85.from_labels(image, spacing)
    assert system.ids.tolist() == [40_000] and system.dimensions == 3 and system.notes == ()
    # What differs lies at the surface, up to 50 from the centre, with squares five times the mean; an axis errs by half of that.
    share = discrepancy([10, 20, 50])
    np.testing.assert_allclose(system.semi_axes[0] / spacing, [10, 20, 50], rtol=2.5 * share)
    np.testing.assert_allclose(system.centers[0] / spacing, [54.3, 55.1, 53.8], atol=50 * share)
    axes = pypw85.principal_axes(system.q)[1][0]
    assert np.abs((axes * rotation).sum(axis=0)).min() > 1 - 5 * share


def test_extent_of_pixels():
    """Nothing is added for it: on average over places, the moments are those of the body. They would be larger by 1/12 each."""
    chance, n, semi_axes = np.random.default_rng(4), 600, np.array([4.0, 5.5, 7.0])
    image = np.zeros((n * 16, 16, 16), dtype=np.int32)
    for k in range(n):
        offsets = np.moveaxis(np.indices((16, 16, 16)), 0, -1) - 7.5 - chance.uniform(-0.5, 0.5, 3)
        image[16 * k : 16 * k + 16][((offsets / semi_axes) ** 2).sum(axis=-1) <= 1] = k + 1
    moments = pypw85.from_labels(image).q[:, [0, 3, 5]] / 5
    error = moments.std(axis=0) / np.sqrt(n)
    assert (5 * error < 1 / 24).all()
    assert (np.abs(moments.mean(axis=0) - semi_axes**2 / 5) < 5 * error).all(), (moments.mean(axis=0), error)


def brute_force(image, label):
    """By Python's whole numbers and fractions alone: mean and covariance of the places of a label."""
    places = [place for place in itertools.product(*map(range, image.shape)) if image[place] == label]
    mean = [sum(one) / len(places) for one in zip(*places)]
    return mean, [[sum((p[i] - mean[i]) * (p[j] - mean[j]) for p in places) / len(places) for j in range(image.ndim)]
                  for i in range(image.ndim)]  # fmt: skip


@pytest.mark.parametrize("shape", [(9, 14), (7, 8, 9)])
@pytest.mark.parametrize("kind", [np.uint8, np.int32, np.uint64, ">i4"])
def test_any_labels(shape, kind):
    """Against sums by hand, for scattered labels, other orders in memory, and blocks of one slice."""
    chance = np.random.default_rng(11)
    image = chance.integers(0, 4, shape).astype(kind) * 60
    steps, start = np.array([0.5, 2, 3][: len(shape)]), np.array([1.0, -2, 5][: len(shape)])
    for one in (image, np.asfortranarray(image), image[::-1][::-1]):
        system = pypw85.from_labels(one, steps, start)
        assert system.ids.tolist() == [60, 120, 180] and system.dimensions == len(shape)
        for k, label in enumerate(system.ids):
            mean, covariance = brute_force(image, label)
            np.testing.assert_allclose(system.centers[k, : len(shape)], np.array(mean) * steps + start, rtol=1e-13)
            forms = pypw85.full(system.q[k])[: len(shape), : len(shape)]
            np.testing.assert_allclose(forms, (len(shape) + 2) * np.array(covariance) * np.outer(steps, steps), rtol=1e-11, atol=1e-11)


def test_large_labels_and_blocks(monkeypatch):
    chance = np.random.default_rng(11)
    image = chance.integers(0, 3, (20, 5, 6)).astype(np.int64)
    truth = pypw85.from_labels(image)
    monkeypatch.setattr("pypw85._images._BLOCK", 40)
    np.testing.assert_array_equal(pypw85.from_labels(image).q, truth.q)
    system = pypw85.from_labels(image * 2**52)
    np.testing.assert_array_equal(system.q, truth.q)
    assert system.ids.tolist() == [2**52, 2**53]


def test_images_of_voxels():
    """There and back."""
    cell = np.diag([8.0, 12, 10])
    system = pypw85.System.from_axes([[2, 3, 5], [6, 8, 4]], [[1, 1.5, 2], [1.2, 2, 1.5]], [[1, 0, 0, 0], [2, 1, 1, 0]], cell=cell)
    spacing = np.diag(cell) / 60
    again = pypw85.from_labels(pypw85.voxels(system, 60), spacing, origin=spacing / 2)
    share = discrepancy([1 / spacing[0], 1.5 / spacing[1], 1.5 / spacing[2]])
    np.testing.assert_allclose(again.centers, system.centers, atol=2 * share)
    np.testing.assert_allclose(again.q, system.q, atol=5 * share * 4)


def test_thin_and_flat_grains():
    image = np.zeros((9, 9, 9), dtype=int)
    # Two voxels thick: the covariance of their centres is that of a body with 2 √(5/4) = 2.2
    image[2:4, 2:7, 2:7] = 3
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert pypw85.from_labels(image).notes == ()
    image[7, 2:7, 2:7], image[8, 4, 4] = 5, 5
    with pytest.warns(UserWarning, match="1 grain is thinner than two pixels, .* label 5; use smaller pixels"):
        assert len(pypw85.from_labels(image).notes) == 1
    image[8, 4, 4] = 0
    with pytest.raises(ValueError, match="all pixels of the label 5 lie in a plane or on a line"):
        pypw85.from_labels(image)
    slanted = np.zeros((1000, 9, 9), dtype=int)
    for k in range(900, 909):
        slanted[k, k - 900] = 1
    with pytest.raises(ValueError, match="all pixels of the label 1 lie in a plane"):
        pypw85.from_labels(slanted)


def test_labels_in_parts():
    """Two discs of radius r at ±d fill 2 / √(1 + 4d²/r²) of the ellipse with their moments: half at d/r = √(15)/2 = 1.94."""
    x, y = np.indices((120, 40))
    for distance, is_said in ((17, False), (22, True)):
        image = np.zeros((120, 40), int)
        for centre in (60 - distance, 60 + distance):
            image[np.hypot(x - centre, y - 20) <= 10] = 4
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            notes = pypw85.from_labels(image).notes
        assert len(notes) == is_said and all("1 grain fills less than half" in note and "label 4" in note for note in notes)


BAD_IMAGES = [
    (np.ones((4, 4)), "labels must be integers, not float64"), (np.full((4, 4), np.nan), "labels must be integers"),
    (np.array([[1, -2], [1, 1]]), r"labels must be from 0 to 2⁵³, not -2 at \[0, 1\]"),
    (np.ones((2, 2, 2, 2), int), r"shape \(2, 2, 2, 2\)"),
    (np.zeros((3, 3), int), r"must have labels, not background alone \(9 pixels\)"),
    (np.zeros((0, 3), int), r"must have labels, not background alone \(0 pixels\)"),
    (np.ones((4, 4), bool), "is a mask"), (np.array([["a"]]), "labels must be integers"), (np.array([1, 2]), r"shape \(2,\)"),
    (np.full((3, 3), 2**63, dtype=np.uint64), "must be from 0 to 2⁵³, not 9223372036854775808"),
    (np.eye(4, dtype=np.uint8) * 255, "only label is 255, so the image is a mask"),
    (np.ones((8, 9, 3), np.uint8), r"shape \(8, 9, 3\) of bytes is that of a colour picture: .* labels in 3 planes"),
    (np.ones((4, 8, 9), np.uint8), r"shape \(4, 8, 9\) of bytes is that of a colour picture: .* labels in 4 planes"),
]  # fmt: skip


@pytest.mark.parametrize("image, reason", BAD_IMAGES)
def test_bad_images(image, reason, tmp_path):
    with pytest.raises(ValueError, match=f"from_labels: .*{reason}"):
        pypw85.from_labels(image)
    np.save(tmp_path / "a.npy", image)
    with pytest.raises(pypw85.FileError, match=rf"a\.npy, frame 0: (?!from_labels).*{reason}"):
        pypw85.read(tmp_path / "a.npy")


def test_bad_spacing():
    image = np.ones((3, 3), dtype=int)
    for spacing in (0, -1, np.nan, [1, 2, 3], "wide"):
        with pytest.raises((TypeError, ValueError), match="^from_labels: "):
            pypw85.from_labels(image, spacing)
    with pytest.raises(ValueError, match="the origin must be a finite number, or 2 of them"):
        pypw85.from_labels(image, 1, [1, 2, 3])


def test_masked_pixels_are_background():
    image = np.ones((6, 6), dtype=int)
    hidden = np.ma.MaskedArray(image, np.indices((6, 6))[0] > 3)
    assert pypw85.from_labels(hidden).centers[0, 0] == 1.5


def test_files(tmp_path):
    """Truncated at each byte, with bits changed, or with a shape that the file has no room for."""
    path, image = tmp_path / "a.npy", voxel_ellipsoid((12, 11, 10), [5, 5, 5], [3, 4, 3], np.eye(3))
    np.save(path, image)
    np.testing.assert_array_equal(pypw85.read(path, spacing=[1, 2, 3]).q, pypw85.from_labels(image, [1, 2, 3]).q)
    content = path.read_bytes()
    for k in range(0, len(content), 7):
        path.write_bytes(content[:k])
        with pytest.raises(pypw85.FileError):
            pypw85.read(path)
    for k in range(128):
        path.write_bytes(content[:k] + bytes([content[k] ^ 1 << k % 8]) + content[k + 1 :])
        try:
            pypw85.read(path)
        except pypw85.FileError as error:
            assert str(error).startswith(str(path))
    path.write_bytes(content.replace(b"(12, 11", b"(99999999, 11"))
    with pytest.raises(pypw85.FileError, match="NumPy cannot read it"):
        pypw85.read(path)
    with pytest.raises(pypw85.FileError, match="--spacing applies to the format labels only, not to csv"):
        (tmp_path / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n")
        pypw85.read(tmp_path / "a.csv", spacing=2)


def test_memory(tmp_path):
    """That of a block, and not of the image: 64 MB here."""
    image = np.lib.format.open_memmap(tmp_path / "a.npy", mode="w+", dtype=np.int32, shape=(256, 256, 256))
    image[100:103, 10:90, 10:90] = 9
    image.flush()
    tracemalloc.start()
    pypw85.from_labels(np.load(tmp_path / "a.npy", mmap_mode="r"))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    # A block of 2²⁰ labels: places, their numbers and products, eight bytes each, of which the labelled pixels are few.
    assert peak < 20 * 2**20
