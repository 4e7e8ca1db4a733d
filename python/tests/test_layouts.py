# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of any order, strides, byte order and type that holds the numbers, read-only or not aligned: every function of the package
that takes arrays gives the same results as for plain arrays, and leaves its arguments as they are."""

import copy
import re

import numpy as np
import pytest

import pypw85
from pypw85 import gufuncs

N = 4
CELL = np.array([[16.0, 0, 0], [1, 16, 0], [2, 1, 16]])
CENTERS = np.array([[0.0, 0, 0], [3, 0, 1], [0, 4, 0], [1, 3, 4]])
TURNS = np.array([[0.0, 0, 0], [3, 0, 1], [0, 14, 0], [1, 3, -12]])
ELLIPSES = np.array([[4.0, 0, 1], [1, 0, 4], [2, 1, 2], [1, 0, 1]])
FORMS = np.array([[4.0, 0, 0, 1, 0, 1], [1, 0, 0, 4, 0, 1], [2, 1, 0, 2, 0, 1], [1, 0, 0, 1, 0, 4]])
AXES = np.array([[2.0, 1, 1], [1, 2, 1], [1, 1, 2], [3, 1, 1]])
QUATERNIONS = np.array([[1.0, 0, 0, 0], [1, 1, 0, 0], [1, 0, 1, 0], [0, 1, 1, 2]])
PAIRS = np.array([[0, 1], [1, 2], [3, 0], [2, 3]], np.int32)
IMAGES = np.array([[0, 0, 0], [0, 0, 0], [0, 0, 0], [1, 0, 0]], np.int32)
SQUARE = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
CUBE = np.array([[1.0, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
REACH = np.array([9.0, 1, 9, 1, 9, 1])
MOTIONS = np.array([[1.0, 0, 0, 0, 0, 1, 0], [0, 0, 1, 0, 0, 0, 0], [0, -1, 0, 1, 0, 0, 0], [0, 0, -1, 0, 1, 0, 0]])
SLOPES = np.array([1.0, 2, 3, 4])
CORNERS = np.array([[-9.0, -9, -2], [9, -9, -2], [9, 9, -2], [-9, 9, -2]])
INERTIA = pypw85.full(FORMS).trace(axis1=1, axis2=2)[:, None, None] * np.eye(3) - pypw85.full(FORMS)


def derivatives():
    return pypw85.contact_derivatives_pairs(PAIRS, CENTERS, FORMS, CELL, IMAGES)


def numbers_of(system):
    return system.centers, system.q, system.cell, system.types, system.ids, system.origin


def neighbours(centers, q, cell):
    found = pypw85.neighbors(centers, q, cell, scale=2.0, skin=0.5)
    return found.pairs, found.images, found.holds(centers, q, cell)


# Points in four dimensions.
CLOUD = np.random.default_rng(1).normal(scale=4, size=(24, 4)).round()


def mesh(vertices, triangles, centers, q):
    made = pypw85.Mesh(vertices, triangles)
    return made.vertices, made.triangles, *made.contact(centers, q), *made.distance(centers, q), made.overlap(centers, q)


# Arguments and a call for each function that is no generalised ufunc.
CALLS = {
    "Mesh": (mesh, CORNERS, SQUARE, CENTERS, FORMS),
    "System": (lambda *x: numbers_of(pypw85.System(x[0], x[1], x[2], types=x[3], ids=x[4], origin=x[5])),
               CENTERS, FORMS, CELL, np.arange(N), np.arange(N) + 7, CENTERS[1]),
    "System.from_axes": (lambda *x: numbers_of(pypw85.System.from_axes(*x, cell=CELL)), CENTERS, AXES, QUATERNIONS),
    "bad_rows": (pypw85.bad_rows, np.array([1.0, np.nan, 2, np.nan])),
    "compressibility": (lambda x: pypw85.compressibility([x] * 30, 9), 1 + 0.0625 * SLOPES),
    "contact_derivatives_pairs": (pypw85.contact_derivatives_pairs, PAIRS, CENTERS, FORMS, CELL, IMAGES),
    "contact_forces_pairs": (lambda *x: pypw85.contact_forces_pairs(*x[:3], derivatives(), *x[3:]), PAIRS, CENTERS, SLOPES, CELL, IMAGES),
    "contact_pairs": (lambda *x: pypw85.contact_pairs(*x[:4], images=x[4]), PAIRS, CENTERS, FORMS, CELL, IMAGES),
    "contact_polytope": (pypw85.contact_polytope, CENTERS, FORMS, CUBE, REACH),
    "credible_ellipsoid": (lambda x: pypw85.credible_ellipsoid(x, 0.75), CLOUD),
    "enclosing_ellipsoid": (pypw85.enclosing_ellipsoid, CLOUD),
    "enclosing_ellipsoid_of": (pypw85.enclosing_ellipsoid_of, CENTERS, FORMS),
    "f_neg": (pypw85.f_neg, 0.125 * SLOPES, CENTERS, FORMS, FORMS[::-1].copy()),
    "first_contact_pairs": (
        lambda *x: pypw85.first_contact_pairs(*x[:4], cell=x[4], images=x[5]), PAIRS, CENTERS, FORMS, MOTIONS, CELL, IMAGES),
    "from_covariance": (lambda x: pypw85.from_covariance(x, 0.5), pypw85.full(FORMS)),
    "from_euler": (lambda *x: pypw85.from_euler(x[0], "xyz", x[1]), AXES, TURNS),
    "from_gsd": (lambda *x: pypw85.from_gsd([{"type": "Ellipsoid", "a": 1, "b": 2, "c": 3}], *x), np.zeros(N, np.int32), QUATERNIONS),
    "from_inertia": (lambda x: pypw85.from_inertia(x, 2), INERTIA),
    "from_lammps": (pypw85.from_lammps, AXES, QUATERNIONS),
    "from_moments": (pypw85.from_moments, pypw85.full(FORMS)),
    "from_ovito": (pypw85.from_ovito, AXES, QUATERNIONS),
    "from_rotation_vector": (pypw85.from_rotation_vector, AXES, TURNS),
    "full": (pypw85.full, FORMS),
    "jaccard": (pypw85.jaccard, CENTERS, FORMS, FORMS[::-1].copy()),
    "jaccard_2d": (pypw85.jaccard_2d, CENTERS[:, :2].copy(), ELLIPSES, ELLIPSES[::-1].copy()),
    "law_forces_pairs": (
        lambda *x: pypw85.law_forces_pairs(*x[:3], pypw85.Law.soft_repulsion(2.0), *x[3:]), PAIRS, CENTERS, FORMS, CELL, IMAGES),
    "motion": (pypw85.motion, CENTERS, CENTERS[::-1].copy(), SLOPES),
    "nearest_image_limit": (pypw85.nearest_image_limit, FORMS, CELL),
    "nearest_images": (pypw85.nearest_images, PAIRS, CENTERS, CELL),
    "neighbors": (neighbours, CENTERS, FORMS, CELL),
    "overlap_any": (pypw85.overlap_any, FORMS[0], CENTERS[1:], FORMS[1:]),
    "overlap_any_indices": (pypw85.overlap_any_indices, CENTERS[0], FORMS[0], PAIRS[1], CENTERS, FORMS, CELL, IMAGES[:2]),
    "overlap_pairs": (lambda *x: pypw85.overlap_pairs(*x[:4], images=x[4]), PAIRS, CENTERS, FORMS, CELL, IMAGES),
    "overlap_polytope": (pypw85.overlap_polytope, CENTERS, FORMS, CUBE, REACH),
    "overlap_table": (pypw85.overlap_table, CENTERS, FORMS, CENTERS[1:].copy(), FORMS[1:].copy()),
    "overlap_table_2d": (pypw85.overlap_table_2d, CENTERS[:, :2].copy(), ELLIPSES, CENTERS[:, 1:].copy(), ELLIPSES),
    "overlap_volume_pairs": (lambda *x: pypw85.overlap_volume_pairs(*x[:4], images=x[4]), PAIRS, CENTERS, FORMS, CELL, IMAGES),
    "random_addition": (lambda *x: numbers_of(pypw85.random_addition(x[0], x[1], number=6).system), AXES, 4 * CELL),
    "pack": (lambda *x: numbers_of(pypw85.pack(x[0], 0.0625, x[1], seed=1, types=x[2])), AXES, 4 * CELL, np.arange(N)),
    "packed": (pypw85.packed, pypw85.full(FORMS)),
    "principal_axes": (pypw85.principal_axes, FORMS),
    "nd_contact": (pypw85.nd_contact, CENTERS, FORMS, FORMS[::-1].copy()),
    "nd_contact_geometry": (pypw85.nd_contact_geometry, AXES, FORMS, FORMS[::-1].copy(), 0.125 * SLOPES),
    "nd_overlap": (pypw85.nd_overlap, CENTERS, FORMS, FORMS[::-1].copy()),
    "nd_compare": (pypw85.nd_compare, CENTERS, FORMS, FORMS[::-1].copy(), SLOPES),
    "nd_distance": (pypw85.nd_distance, AXES, FORMS, FORMS[::-1].copy()),
    "nd_contains": (pypw85.nd_contains, CENTERS, FORMS, FORMS[::-1].copy()),
    "nd_containment": (pypw85.nd_containment, CENTERS, FORMS, FORMS[::-1].copy()),
    "sorensen": (pypw85.sorensen, CENTERS, FORMS, FORMS[::-1].copy()),
    "sorensen_2d": (pypw85.sorensen_2d, CENTERS[:, :2].copy(), ELLIPSES, ELLIPSES[::-1].copy()),
    "union_area_2d": (pypw85.union_area_2d, CENTERS[:, :2].copy(), ELLIPSES, ELLIPSES[::-1].copy()),
    "union_volume": (pypw85.union_volume, CENTERS, FORMS, FORMS[::-1].copy()),
}  # fmt: skip

# Functions whose arguments are systems, files, texts or numbers.
OTHERS = {
    "AdditionInterrupted", "Blocking", "FileError", "HardEllipsoids", "Neighbors", "Observables", "OverlapsLeft", "PW85Error",
    "RelaxationInterrupted", "Status", "angular_pair_correlation", "bond_order", "columnar_order", "correlation", "density_modes",
    "director", "ellipsoid_mesh", "enclosing", "even_points", "frames", "from_labels", "from_mesh", "gufuncs", "inertia",
    "is_reproducible", "lambda_atol", "lattice", "legacy", "mean_square_displacement", "metadata", "nematic_order",
    "pair_correlation", "plot", "pose_distance", "random_points", "read", "relax", "set_reproducible", "smectic_order", "strerror",
    "structure_factor", "tetratic_order", "utils", "version", "voxels", "wave_vectors", "write",
}  # fmt: skip


def not_aligned(x):
    buffer = np.zeros(x.nbytes + 1, np.uint8)
    moved = buffer[1:].view(x.dtype).reshape(x.shape)
    moved[...] = x
    return moved


def read_only(x):
    x = x.copy()
    x.flags.writeable = False
    return x


def as_other_numbers(x):
    """Numbers of fewer bytes, or integers of more, which hold the same values."""
    return x.astype(np.int64 if x.dtype.kind == "i" else np.float32)


def as_bytes(x):
    """Integers whose squares may leave the range of their type."""
    return x.astype(np.int8) if (x == np.round(x)).all() else x


LAYOUTS = {
    "Fortran": np.asfortranarray,
    "every other": lambda x: np.repeat(x, 2, axis=0)[::2],
    "columns of a wider array": lambda x: np.concatenate([x, x], axis=-1)[..., : x.shape[-1]],
    "reversed": lambda x: x[::-1].copy()[::-1],
    "read-only": read_only,
    "other byte order": lambda x: x.astype(x.dtype.newbyteorder()),
    "not aligned": not_aligned,
    "other numbers": as_other_numbers,
    "bytes": as_bytes,
    "unsigned": lambda x: x.astype(np.uint64) if x.dtype.kind == "i" and (x >= 0).all() else x,
    "list": lambda x: x.tolist(),
}


def assert_same(actual, expected):
    if isinstance(expected, (tuple, list)):
        assert len(actual) == len(expected)
        for a, e in zip(actual, expected):
            assert_same(a, e)
        return
    assert type(actual) is type(expected)
    np.testing.assert_array_equal(actual, expected)


CASES = [(name, layout) for name in CALLS for layout in LAYOUTS if (name, layout) != ("bad_rows", "other numbers")]  # NaN is no integer


@pytest.mark.parametrize(("name", "layout"), CASES)
def test_layouts(name, layout):
    call, *arguments = CALLS[name]
    given = [LAYOUTS[layout](x) for x in arguments]
    kept = copy.deepcopy(given)
    assert_same(call(*given), call(*arguments))
    for now, before in zip(given, kept):
        np.testing.assert_array_equal(now, before)


def test_no_function_is_left_out():
    public = {name for name in pypw85.__all__ if name not in gufuncs.__all__ and not hasattr(getattr(pypw85, name), "_fields")}
    assert public == {name for name in CALLS if "." not in name and name not in gufuncs.__all__} | OTHERS


# The only numbers of a row that are truth values are of the functions of these names; others are signs or mark bad rows by NaN.
TRUTHS = [name for name in gufuncs.__all__ if re.match("overlap|contains", name) and not re.search("witness|volume|area", name)]


@pytest.mark.parametrize("name", TRUTHS)
def test_truth_values(name):
    function, signature = getattr(pypw85, name), getattr(gufuncs, name).signature
    shapes = [tuple(map(int, filter(None, core.split(",")))) for core in signature.split("->")[0].strip("()").split("),(")]
    form = {(3,): [1.0, 0, 1], (6,): FORMS[0], (9,): np.eye(3), (3, 3): np.eye(3)}
    arguments = [np.asarray(form.get(shape, np.ones(shape))) for shape in shapes]
    one = function(*arguments)
    many = function(np.stack([arguments[0]] * 3), *arguments[1:])
    assert type(one) is np.bool_ and many.dtype == np.bool_ and many.shape == (3,)
    assert function(np.stack([arguments[0]] * 3), *arguments[1:], dtype=np.uint8).dtype == np.uint8
