# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that are no plain arrays: masked, labelled, of other types; and outputs in which results would get lost."""

import decimal
import fractions
import warnings

import dask.array
import numpy as np
import pandas
import pytest
import xarray

import pypw85
from pypw85 import legacy

Q = [1.0, 0, 0, 1, 0, 1]


@pytest.fixture
def expected(random_pairs):
    pairs = random_pairs(20)
    return pairs, pypw85.contact(*pairs)


@pytest.fixture(autouse=True)
def no_warnings():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def assert_equal_arrays(actual, expected):
    for a, b in zip(actual, expected):
        assert type(a) is type(b)
        np.testing.assert_array_equal(a, b)


@pytest.mark.parametrize("dtype", [np.longdouble, ">f16", object])
def test_wide_types(expected, dtype):
    pairs, result = expected
    wide = [x.astype(dtype) for x in pairs]
    assert_equal_arrays(pypw85.contact(*wide), result)
    assert_equal_arrays(pypw85.contact(*(x[0] for x in wide)), pypw85.contact(*(x[0] for x in pairs)))
    assert_equal_arrays(pypw85.contact(*(x.tolist() for x in wide)), result)
    np.testing.assert_array_equal(pypw85.from_lammps(abs(wide[0]), [1, 0, 0, 0]),
                                  pypw85.from_lammps(abs(pairs[0]), [1, 0, 0, 0]))
    np.testing.assert_array_equal(pypw85.principal_axes(wide[1])[0], pypw85.principal_axes(pairs[1])[0])
    assert_equal_arrays(pypw85.distance(*wide), pypw85.distance(*pairs))
    assert_equal_arrays(pypw85.distance_point(*wide[:2]), pypw85.distance_point(*pairs[:2]))
    np.testing.assert_array_equal(legacy._detQ_as_poly(*wide[1:]), legacy._detQ_as_poly(*pairs[1:]))


@pytest.mark.parametrize("number", [fractions.Fraction, decimal.Decimal, np.longdouble, np.float32, np.int8, int])
def test_numbers(number):
    r12 = [number(3), number(0), number(0)]
    assert pypw85.contact(r12, Q, Q) == (2.25, 0.5)
    assert pypw85.overlap([r12], Q, Q) == [False]
    assert pypw85.f(number(1), r12, Q, Q) == 0
    assert pypw85.spheroid(number(2), 1, r12)[0] == 1


@pytest.mark.parametrize("argument", [np.ones(3, dtype=complex), np.array([1j, 0, 0], dtype=object), ["1", "2", "3"],
                                      np.array(["x"] * 3, dtype=object), np.ones(3, dtype="m8[s]"), {"x": 1}])
@pytest.mark.parametrize("rows", [False, True])
def test_refused_types(argument, rows):
    argument = [argument] * 2 if rows else argument
    with pytest.raises((TypeError, ValueError)):
        pypw85.contact(argument, Q, Q)


def test_no_imaginary_part_is_dropped():
    for wrong in (np.ones((1, 6), dtype=complex), np.ma.ones((1, 6), dtype=complex), pandas.DataFrame([[1j] * 6])):
        with pytest.raises(TypeError):
            pypw85.principal_axes(wrong)
        with pytest.raises(TypeError):
            pypw85.closest_approach([1, 0, 0], wrong, Q)
        with pytest.raises(TypeError):
            pypw85.contact_pairs([[0, 0]], [[0, 0, 0]], wrong)


@pytest.mark.parametrize("name", ["contact", "contact_function", "closest_approach", "distance"])
def test_masked_rows(expected, name):
    pairs, _ = expected
    function = getattr(pypw85, name)
    masked = [np.ma.array(x, copy=True) for x in pairs]
    masked[0][3, 1] = masked[1][5] = np.ma.masked
    with np.errstate(invalid="ignore"):
        result = function(*masked)
    mu2 = result[0] if isinstance(result, tuple) else result
    assert type(mu2) is np.ndarray
    np.testing.assert_array_equal(pypw85.bad_rows(mu2), [3, 5])
    good = np.delete(np.arange(20), [3, 5])
    same = function(*(x[good] for x in pairs))
    np.testing.assert_allclose(mu2[good], same[0] if isinstance(same, tuple) else same, rtol=1e-14)
    with pytest.raises(pypw85.PW85Error):
        function(*(x[3] for x in masked))
    with np.errstate(invalid="ignore"):
        rows = function(list(masked[0]), pairs[1], pairs[2])
    np.testing.assert_array_equal(pypw85.bad_rows(rows), [3])


def test_masked_elsewhere(expected):
    (r12, q, _), _ = expected
    q = np.ma.array(q)
    q[2, 1] = np.ma.masked
    assert np.isnan(pypw85.full(q)[2, 0, 1]) and np.isnan(pypw85.full(q)[2, 1, 0])
    with np.errstate(invalid="ignore"):
        np.testing.assert_array_equal(pypw85.bad_rows(pypw85.principal_axes(q), core_ndim=1), [2])
        mu2, _ = pypw85.contact_pairs([[0, 1], [2, 3], [4, 2]], r12, q)
        assert pypw85.overlap(r12, q, Q)[2]
    np.testing.assert_array_equal(pypw85.bad_rows(mu2), [1, 2])
    integers = np.ma.array([[4, 0, 0, 4, 0, 4]], mask=[[1, 0, 0, 0, 0, 0]])
    assert np.isnan(pypw85.full(integers)[0, 0, 0])
    with pytest.raises(TypeError, match="masked"):
        pypw85.contact_pairs(np.ma.array([[0, 1]], mask=[[True, False]]), r12, q)
    with pytest.raises(ValueError, match="cell"):
        pypw85.contact_pairs([[0, 1]], r12, q, np.ma.array(np.eye(3), mask=np.eye(3)))
    with pytest.raises(TypeError, match="typeid"):
        pypw85.from_gsd([{"type": "Sphere", "diameter": 1}], np.ma.array([0], mask=[True]), [[1, 0, 0, 0]])
    lower = np.ma.array(np.eye(3), mask=[[0, 0, 0], [1, 0, 0], [0, 0, 0]])
    with pytest.raises(ValueError, match="symmetric"):
        pypw85.packed(lower)


def test_masked_results_are_bad_rows():
    np.testing.assert_array_equal(pypw85.bad_rows(np.ma.array([1.0, 2, np.nan], mask=[1, 0, 0])), [0, 2])
    codes = np.ma.array(np.array([1, 255, 0], dtype=np.uint8), mask=[1, 0, 0])
    np.testing.assert_array_equal(pypw85.bad_rows(codes), [0, 1])


def test_types_of_particles_are_integers():
    with pytest.raises(TypeError, match="typeid must be integers"):
        pypw85.from_gsd([{"type": "Sphere", "diameter": 1}], [0.7], [[1, 0, 0, 0]])
    assert pypw85.from_gsd([], [], np.empty((0, 4))).shape == (0, 6)


def test_pandas(expected):
    (r12, q1, q2), result = expected
    frames = pandas.DataFrame(r12, columns=list("xyz")), pandas.DataFrame(q1, index=range(5, 25)), pandas.DataFrame(q2)
    assert_equal_arrays(pypw85.contact(*frames), result)
    assert_equal_arrays(pypw85.contact(*(x.iloc[0] for x in frames)), pypw85.contact(r12[0], q1[0], q2[0]))
    lambdas = pandas.Series(result[1], index=range(20, 0, -1))
    np.testing.assert_array_equal(pypw85.f(lambdas, *frames), pypw85.f(result[1], r12, q1, q2))
    np.testing.assert_array_equal(pypw85.full(frames[1]), pypw85.full(q1))
    np.testing.assert_array_equal(pypw85.contact_pairs(pandas.DataFrame([[0, 1]]), frames[0], frames[1]),
                                  pypw85.contact_pairs([[0, 1]], r12, q1))
    nullable = frames[0].astype("Float64")
    nullable.iloc[4, 0] = pandas.NA
    with np.errstate(invalid="ignore"):
        np.testing.assert_array_equal(pypw85.bad_rows(pypw85.contact(nullable, q1, q2)), [4])


def test_xarray(expected):
    pairs, result = expected
    arrays = [xarray.DataArray(x, dims=("pair", "component")) for x in pairs]
    assert_equal_arrays(pypw85.contact(*arrays), result)
    assert_equal_arrays(pypw85.contact(*(x.variable for x in arrays)), result)
    assert_equal_arrays(pypw85.contact(arrays[0], *pairs[1:]), result)
    assert_equal_arrays(pypw85.distance(*arrays), pypw85.distance(*pairs))
    assert_equal_arrays(pypw85.distance_plane(arrays[0], 1.0, arrays[1]), pypw85.distance_plane(pairs[0], 1.0, pairs[1]))
    np.testing.assert_array_equal(pypw85.principal_axes(arrays[1])[0], pypw85.principal_axes(pairs[1])[0])
    mu2, _ = pypw85.contact(*(x.chunk(7) for x in arrays))
    assert isinstance(mu2, dask.array.Array)
    np.testing.assert_array_equal(mu2.compute(), result[0])
    with pytest.raises(NotImplementedError, match="xarray"):
        pypw85.contact(xarray.Dataset({"r12": arrays[0]}), *pairs[1:])
    with pytest.raises(TypeError, match="a dask collection must be a dask.array.Array, not Dataset"):
        pypw85.contact(xarray.Dataset({"r12": arrays[0].chunk(7)}), *pairs[1:])


@pytest.mark.parametrize("rows", [0, 4])
@pytest.mark.parametrize("out", [[0.0], np.ma.zeros(4), pandas.Series(np.zeros(4)), xarray.DataArray(np.zeros(4))])
def test_refused_outputs(random_pairs, rows, out):
    pairs = random_pairs(4)
    pairs = pairs if rows else [x[0] for x in pairs]
    with pytest.raises(TypeError, match="out, which follows the inputs, must be an array of NumPy without a mask"):
        pypw85.closest_approach(*pairs, out)
    with pytest.raises(TypeError, match="out, which follows the inputs, must be an array of NumPy without a mask"):
        pypw85.contact(*pairs, (np.empty(4), out))
    with pytest.raises(TypeError, match="out, which follows the inputs, must be an array of NumPy without a mask"):
        pypw85.distance(*pairs, (out, None, None))
    with pytest.raises(TypeError, match="contact_pairs: out, .* must be"):
        pypw85.contact_pairs([[0, 1]] * 4, np.zeros((2, 3)), [Q, Q], out=(np.empty(4), out))


def test_outputs_of_neighbour_lists_are_a_tuple():
    centers, q = np.zeros((2, 3)), np.array([Q, Q])
    for out in (np.empty((2, 2)), [np.empty(2), np.empty(2)], (np.empty(2),), (None, np.empty(2))):
        with pytest.raises(TypeError, match="tuple of two"):
            pypw85.contact_pairs([[0, 1], [1, 0]], centers, q, out=out)


def test_one_array_for_both_numbers(expected):
    pairs, result = expected
    for out in (np.empty((20, 2)), np.empty((20, 2), order="F"), np.empty((20, 4))[:, ::2], np.empty((3, 20, 2))):
        mu2, lambda_ = pypw85.contact(*pairs, out)
        for k, column in enumerate((mu2, lambda_)):
            np.testing.assert_array_equal(column, np.broadcast_to(result[k], out.shape[:-1]))
            np.testing.assert_array_equal(out[..., k], column)
            assert np.shares_memory(column, out)
    one = [x[0] for x in pairs]
    for out in (np.empty(2), np.empty(4)[::2]):
        assert pypw85.contact(*one, out) == tuple(out) == pypw85.contact(*one)
    with pytest.raises(ValueError, match=r"contact: out must have the shape \(\), not \(3,\)"):
        pypw85.contact(*one, np.empty((3, 2)))
    for wrong in (np.empty(3), np.empty(()), np.empty((20, 3))):
        with pytest.raises(ValueError, match="out, if it is one array, must have 2 numbers in the last dimension"):
            pypw85.contact(*one, wrong)
    with pytest.raises(TypeError, match="contact: out must be an array of float64, not int"):
        pypw85.contact(*one, np.empty(2, dtype=int))
    with pytest.raises(ValueError, match="read-only|readonly"):
        pypw85.contact(*one, np.broadcast_to(0.0, 2))


def test_output_as_keyword():
    """Some functions have another name for it; the keyword of ufuncs works all the same."""
    for names in ({}, {"order": "C"}):
        q = np.empty(6)
        assert pypw85.spheroid(1, 2, [0, 0, 1], out=q, **names) is q
        np.testing.assert_array_equal(q, [1, 0, 0, 1, 0, 4])
    with pytest.raises(pypw85.PW85Error):
        pypw85.spheroid(-1, 2, [0, 0, 1], out=q)
    assert np.isnan(q).all()
    with pytest.raises(TypeError, match="out must not be given twice"):
        pypw85.spheroid(1, 2, [0, 0, 1], np.empty(6), out=q)
    with pytest.raises(TypeError, match="without a mask"):
        pypw85.spheroid(1, 2, [0, 0, 1], out=np.ma.zeros(6))


@pytest.mark.parametrize("dtype", ["M8[s]", "U3", complex])
def test_output_types_of_one_row_are_those_of_many(dtype):
    def outcome(rows):
        try:
            return pypw85.overlap(rows, Q, Q, np.empty(rows.shape[:-1], dtype=dtype)).tolist()
        except TypeError:
            return "refused"

    one, many = outcome(np.array([3.0, 0, 0])), outcome(np.array([[3.0, 0, 0]]))
    assert many in ("refused", [one])


def test_sizes_in_conversions():
    for wrong in ([0, 0, 1], [0, 0, 0, 1, 7], 1.0):
        with pytest.raises(ValueError, match="from_ovito: the last dimension must be 4"):
            pypw85.from_ovito([1, 2, 3], wrong)
    for shape in ({"type": "Ellipsoid", "a": 1}, {"type": "Sphere"}):
        with pytest.raises(ValueError, match="a shape must be an Ellipsoid with a, b and c"):
            pypw85.from_gsd([shape], [0], [[1, 0, 0, 0]])


def test_bad_dimensions():
    with pytest.raises(ValueError, match="core_ndim"):
        pypw85.bad_rows(np.full(3, np.nan), core_ndim=-1)
    with pytest.raises(ValueError, match="2 columns"):
        pypw85.contact_pairs(np.empty((0, 5), dtype=int), [[0, 0, 0]], [Q])
