# SPDX-License-Identifier: BSD-3-Clause
"""The conventions of NumPy: signatures, broadcasting, types, memory layouts, outputs."""

import os
import pickle
import subprocess
import sys
import tracemalloc

import numpy as np
import pytest

import pypw85
from pypw85 import _core, gufuncs

sys.path.insert(0, os.path.join(os.environ["PYPW85_SOURCE"], "api"))
from rows import row_functions, rows_by_hand

# Functions of each kind, as one would write them by the manual: numbers and matrices, several results, those in one array in C,
# truth values, motions, results of two extents, two dimensions, what is made by hand.
KNOWN = {
    "spheroid": "(),(),(3)->(6)",
    "ellipsoid": "(3),(3,3)->(6)",
    "f": "(),(3),(6),(6)->()",
    "contact": "(3),(6),(6)->(),()",
    "contact_derivatives": "(3),(6),(6)->(),(),(3),(3),(3),(3),(3)",
    "contact_hessian": "(3),(6),(6),()->(9,9)",
    "contact_torque_2d": "(2),(3),(3),()->(),()",
    "overlap": "(3),(6),(6)->()",
    "compare": "(3),(6),(6),()->()",
    "overlap_witness": "(3),(6),(6)->(),(),(3)",
    "distance_2d": "(2),(3),(3)->(),(2),(2)",
    "distance_cylinder": "(3),(),(3),(6)->(),(3),(3)",
    "contact_capsule": "(3),(3),(),(6)->(),(3)",
    "overlap_capsule": "(3),(3),(),(6)->()",
    "first_contact": "(3),(6),(6),(7),(7),()->()",
    "cell_reduce": "(3,3)->(3,3)",
    "bounding_boxes": "(6)->(3)",
    "cholesky_solve": "(6),(3)->(3)",
    "legacy_f1": "(),(3),(6),(6)->(),(),()",
    "legacy_f2_derivatives": "(),(3),(6),(6)->(3)",
}
SIGNATURES = {row.name: row.signature() for row in (*row_functions(), *rows_by_hand())}
HAS_UPPER_CORNER = {row.name for row in row_functions() if any(one.name == "upper" for one in row.inputs)}


def core_shapes(name):
    inputs = SIGNATURES[name].split("->")[0]
    return [tuple(int(d) for d in core.split(",") if d) for core in inputs[1:-1].split("),(")]


def arguments(name, leading, rng):
    """Valid random arguments of any function, with the given leading dimensions: forms near the identity."""
    args = []
    for shape in core_shapes(name):
        values = rng.uniform(0.1, 0.4, leading + shape)
        if shape == (6,):
            values[..., [0, 3, 5]] += 1
        if name.endswith(("2d", "ellipses")) and shape == (3,):
            values[..., [0, 2]] += 1
        if shape == (3, 3):
            values = np.broadcast_to(np.eye(3)[[1, 2, 0]], leading + (3, 3)).copy()
        args.append(values)
    _, *forms = core_shapes(name)
    if name.startswith("distance") and forms in ([(6,), (6,)], [(3,), (3,)]):
        args[0] += 3  # two ellipsoids, apart
    if name in ("grain_contact", "grain_radius_gradient"):
        args[0] += 1  # a small overlap
    if name in HAS_UPPER_CORNER:
        args[1] += 1  # lower <= upper
    return args


def call_name(name):
    return getattr(_core, "call_" + name)


def as_tuple(result):
    return result if isinstance(result, tuple) else (result,)


@pytest.mark.parametrize("name", SIGNATURES)
def test_signature(name):
    assert isinstance(getattr(gufuncs, name), np.ufunc)
    assert getattr(gufuncs, name).signature == SIGNATURES[name]


def test_known_signatures():
    assert {name: SIGNATURES.get(name) for name in KNOWN} == KNOWN


def test_all_gufuncs_are_tested():
    assert {name for name in gufuncs.__all__ if isinstance(getattr(gufuncs, name), np.ufunc)} == set(SIGNATURES)


@pytest.mark.parametrize("name", SIGNATURES)
def test_single_call_equals_rows_of_array(name, rng):
    args = arguments(name, (5, 4), rng)
    rows = as_tuple(getattr(gufuncs, name)(*args))
    # The batches of these promise a bound, not the bits of the single call.
    same = np.testing.assert_array_equal
    if name in ("contact_segment", "contact_triangle", "contact_box"):
        # The eigenvalues of these forms are between 0.3 and 2.2, so that S is below 22 μ² and the error of μ² below 80 u S. The points
        # are about as well-conditioned.
        def same(a, b):
            return np.testing.assert_allclose(a, b, rtol=80 * 22 * 2.0**-53, atol=80 * 22 * 2.0**-53)
    elif name in ("contact", "contact_2d", "closest_approach", "closest_passage", "distance", "distance_geometry"):
        # Closest points err by 2¹⁸ u times lengths that add up to less than 18 here.
        atol = 18 * 2.0**-35 if name.startswith("distance") else 0.0

        def same(a, b):
            return np.testing.assert_allclose(a, b, rtol=1e-14, atol=atol if np.ndim(a) else 0.0)
    elif name == "grain_contact":
        # After a step below 2⁻²² the normal errs by its square times a number below 100: see tests/test_grain_contact.cpp.
        def same(a, b):
            return np.testing.assert_allclose(a, b, rtol=6e-12, atol=6e-12)
    for index in np.ndindex(5, 4):
        single = as_tuple(call_name(name)(*(arg[index] for arg in args), None, {}))
        for row, value in zip(rows, single):
            same(row[index], value)
            assert row.dtype == value.dtype


@pytest.mark.parametrize("name", SIGNATURES)
def test_many_rows(name, rng):
    """More rows than a thread takes at a time, one block of memory or not, are as rows on their own, and a bad one harms no other."""
    count, bad = 5000, 4500
    args = arguments(name, (count,), rng)
    args[0][bad] = np.nan
    ufunc = getattr(gufuncs, name)
    with np.errstate(invalid="ignore"):
        expected = as_tuple(ufunc(*args))
        scattered = as_tuple(ufunc(*(np.repeat(x, 2, axis=0)[::2] for x in args)))
        out = tuple(np.empty((count, 2, *x.shape[1:]), dtype=x.dtype)[:, 0] for x in expected)
        ufunc(*args, out=out)
        alone = {i: as_tuple(ufunc(*(x[i : i + 1] for x in args))) for i in (0, 1023, 1024, 4095, 4096, bad, count - 1)}
    for k, rows in enumerate(expected):
        np.testing.assert_array_equal(rows, scattered[k])
        np.testing.assert_array_equal(rows, out[k])
        for i, row in alone.items():
            np.testing.assert_array_equal(rows[i], row[k][0])
        assert (rows[bad] != rows[bad]).any() or rows.dtype == bool
        if name.startswith(("overlap_witness", "gap_inside")) and k > 0:
            continue  # there is a number or a point, and there are points only if one ellipsoid contains the other
        assert (rows[:bad] == rows[:bad]).all() and (rows[bad + 1 :] == rows[bad + 1 :]).all()


@pytest.mark.parametrize("name", [row.name for row in row_functions() if row.is_truth()])
def test_truth_values_as_numbers(name, rng):
    """1, 0, or 255 for a bad row, as the docstrings say."""
    function, args = getattr(pypw85, name), arguments(name, (20,), rng)
    args[0][7] = np.nan
    with np.errstate(invalid="ignore"):
        truths, codes = function(*args), function(*args, dtype=np.uint8)
    assert truths.dtype == bool and codes.dtype == np.uint8
    np.testing.assert_array_equal(pypw85.bad_rows(codes), [7])
    assert codes[7] == 255
    np.testing.assert_array_equal(np.delete(codes, 7), np.delete(truths, 7))
    assert "the result is 1, 0, or 255 for an invalid row" in function.__doc__
    assert "(...) array of bool, or bool" in function.__doc__


def test_first_contact_with_one_end_or_many(rng):
    """The function of many pairs takes one `t_max`: arrays of them are cut into runs."""
    args = arguments("first_contact", (600,), rng)
    args[0] += 3
    args[5] = np.repeat(rng.uniform(0.1, 40, 6), 100)
    expected = [gufuncs.first_contact(*(x[i] for x in args)) for i in range(600)]
    np.testing.assert_array_equal(gufuncs.first_contact(*args), expected)
    np.testing.assert_array_equal(gufuncs.first_contact(*args[:5], args[5][0])[:100], expected[:100])


@pytest.mark.parametrize("name", SIGNATURES)
def test_memory_layouts(name, rng):
    args = arguments(name, (6, 50), rng)
    expected = as_tuple(getattr(gufuncs, name)(*args))
    layouts = {
        "strided rows": lambda x: np.repeat(x, 2, axis=1)[:, ::2],
        "reversed rows": lambda x: x[:, ::-1].copy()[:, ::-1],
        "fortran order": np.asfortranarray,
        "unaligned": unaligned,
        "big-endian": lambda x: x.astype(">f8"),
        "read-only": read_only,
    }
    for layout, change in layouts.items():
        actual = as_tuple(getattr(gufuncs, name)(*map(change, args)))
        for a, b in zip(actual, expected):
            np.testing.assert_array_equal(a, b, err_msg=layout)
        single = as_tuple(call_name(name)(*(change(arg)[3, 7] for arg in args), None, {}))
        for a, b in zip(single, as_tuple(call_name(name)(*(arg[3, 7] for arg in args), None, {}))):
            np.testing.assert_array_equal(a, b, err_msg=layout)


def unaligned(x):
    raw = np.empty(x.nbytes + 1, dtype=np.uint8)[1:]
    copy = raw.view(np.float64).reshape(x.shape)
    copy[...] = x
    return copy


def read_only(x):
    copy = x.copy()
    copy.flags.writeable = False
    return copy


@pytest.mark.parametrize("name", SIGNATURES)
def test_outputs(name, rng):
    args = arguments(name, (6, 50), rng)
    expected = as_tuple(getattr(gufuncs, name)(*args))
    outs = tuple(np.repeat(np.zeros_like(x), 2, axis=1)[:, ::2] for x in expected)
    actual = as_tuple(call_name(name)(*args, outs if len(outs) > 1 else outs[0], {}))
    for a, out, b in zip(actual, outs, expected):
        assert a is out
        np.testing.assert_array_equal(a, b)


@pytest.mark.parametrize("count", [0, 1, 511, 512, 513, 5000])
def test_blocks_of_scattered_rows(random_pairs, count):
    r12, q1, q2 = random_pairs(count)
    mu2, lambda_ = pypw85.contact(r12, q1, q2)
    scattered = [np.repeat(x, 2, axis=0)[::2] for x in (r12, q1, q2)]
    actual = pypw85.contact(*scattered)
    np.testing.assert_array_equal(actual, (mu2, lambda_))
    np.testing.assert_array_equal(pypw85.overlap(*scattered), mu2 < 1)
    np.testing.assert_array_equal(pypw85.overlap(r12, q1, q2, dtype=np.uint8), (mu2 < 1).astype(np.uint8))


def test_broadcasting(random_pairs):
    r12, q1, q2 = random_pairs(7)
    mu2, lambda_ = pypw85.contact(r12[:, None, None], q1[:5, None], q2[:3])
    assert mu2.shape == lambda_.shape == (7, 5, 3)
    for i, j, k in np.ndindex(7, 5, 3):
        assert mu2[i, j, k] == pytest.approx(pypw85.contact(r12[i], q1[j], q2[k])[0], rel=1e-14)
    assert pypw85.overlap(r12[:, None], q1[0], q2).shape == (7, 7)


@pytest.mark.parametrize("dtype", [np.int8, np.int64, np.uint16, np.float16, np.float32, bool])
def test_other_types(dtype):
    q1, q2 = np.array([1, 0, 0, 1, 0, 1], dtype=dtype), np.ones((4, 6)) * [1, 0, 0, 1, 0, 1]
    r12 = np.array([1, 0, 1], dtype=dtype)
    assert pypw85.contact(r12, q1, q1) == (0.5, 0.5)
    np.testing.assert_array_equal(pypw85.contact(r12, q1, q2.astype(dtype))[0], 0.5)
    assert pypw85.f(dtype(1) * 0.5, r12, q1, q1) == 0.5


def test_lists_and_numbers():
    assert pypw85.contact([2, 0, 0], (1, 0, 0, 1, 0, 1), [1, 0, 0, 1, 0, 1]) == (1.0, 0.5)
    np.testing.assert_array_equal(pypw85.spheroid(np.array(1), np.float32(2), [0, 0, 1]), [1, 0, 0, 1, 0, 4])


@pytest.mark.parametrize("argument", [np.ones(3, dtype=complex), ["a", "b", "c"], np.array(["x"] * 3), None])
def test_types_that_are_not_real(argument):
    q = [1, 0, 0, 1, 0, 1]
    with pytest.raises((TypeError, ValueError)):
        pypw85.contact(argument, q, q)


@pytest.mark.parametrize("shapes", [((2,), (6,), (6,)), ((3,), (5,), (6,)), ((4, 3), (3, 6), (6,)), ((), (6,), (6,))])
def test_wrong_shapes(shapes):
    with pytest.raises(ValueError, match="contact|broadcast"):
        pypw85.contact(*(np.ones(shape) for shape in shapes))


def test_wrong_outputs(random_pairs):
    pairs = random_pairs(4)
    with pytest.raises(ValueError):
        pypw85.contact(*pairs, np.empty((4, 3)))
    with pytest.raises(ValueError):
        pypw85.closest_approach(*pairs, np.empty(3))
    with pytest.raises(TypeError):
        pypw85.closest_approach(*pairs, np.empty(4, dtype=np.int64))
    with pytest.raises(TypeError):
        pypw85.closest_approach(*(x[0] for x in pairs), np.empty((), dtype=np.int64))
    with pytest.raises(ValueError):
        pypw85.contact(*(x[0] for x in pairs), (np.empty(()),))


def test_where_is_refused(random_pairs):
    with pytest.raises(TypeError):
        pypw85.contact(*random_pairs(4), where=np.ones(4, dtype=bool))


def test_keywords_of_ufuncs(random_pairs):
    r12, q1, q2 = random_pairs(4)
    expected = pypw85.closest_approach(r12, q1, q2)
    actual = pypw85.closest_approach(r12.T, q1.T, q2.T, axes=[0, 0, 0, ()])
    np.testing.assert_array_equal(actual, expected)


def test_output_that_overlaps_an_input(random_pairs):
    r12, q1, q2 = random_pairs(100)
    expected = pypw85.contact_gradient(r12, q1, q2, 0.5)
    pypw85.contact_gradient(r12, q1, q2, 0.5, (r12, q1, q2))
    for actual, value in zip((r12, q1, q2), expected):
        np.testing.assert_array_equal(actual, value)


def test_subclasses_are_kept(random_pairs):
    class Tagged(np.ndarray):
        pass

    r12, q1, q2 = random_pairs(4)
    assert type(pypw85.closest_approach(r12.view(Tagged), q1, q2)) is Tagged


@pytest.mark.parametrize("name", ["contact", "overlap", "contact_function"])
def test_no_copies_of_contiguous_input(name, random_pairs):
    count = 20000
    pairs = random_pairs(count)
    function = getattr(pypw85, name)
    function(*pairs)
    tracemalloc.start()
    result = function(*pairs)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    # The outputs, and some kilobytes for objects of Python; a copy of the smallest input would be 480 kB.
    assert peak <= sum(x.nbytes for x in as_tuple(result)) + 50_000


def test_pickled_ufunc_works_in_another_process():
    program = "import pickle, sys; print(pickle.loads(sys.stdin.buffer.read()).signature)"
    dump = pickle.dumps(gufuncs.contact)
    done = subprocess.run([sys.executable, "-c", program], input=dump, capture_output=True, check=True)
    assert done.stdout.decode().strip() == SIGNATURES["contact"]
