# SPDX-License-Identifier: BSD-3-Clause
"""Dask arrays: chunk by chunk, lazily, mixed with anything, and no keyword that is swallowed."""

import dask
import dask.array as da
import dask.bag
import numpy as np
import pytest

import pypw85
from pypw85 import gufuncs, legacy


@pytest.fixture
def chunked(random_pairs):
    pairs = random_pairs(1000)
    return pairs, [da.from_array(x, chunks=(100, -1)) for x in pairs]


def assert_same(lazy, eager):
    """Equal results, of which the first are lazy and know their shape and type."""
    lazy, eager = (x if isinstance(x, tuple) else (x,) for x in (lazy, eager))
    assert len(lazy) == len(eager)
    for a, b in zip(lazy, eager):
        assert isinstance(a, da.Array)
        assert (a.shape, a.dtype) == (b.shape, b.dtype)
    for a, b in zip(dask.compute(*lazy, scheduler="threads"), eager):
        assert a.dtype == b.dtype
        np.testing.assert_array_equal(a, b)


def test_contact(chunked):
    pairs, arrays = chunked
    lazy = pypw85.contact(*arrays)
    assert lazy[0].chunks == ((100,) * 10,)
    assert_same(lazy, pypw85.contact(*pairs))


@pytest.mark.parametrize("name", ["contact", "contact_function", "overlap", "closest_approach", "zheng_ellipsoids"])
def test_functions_of_pairs(chunked, name):
    pairs, arrays = ([x[:30] for x in side] for side in chunked)
    assert_same(getattr(pypw85, name)(*arrays), getattr(pypw85, name)(*pairs))


@pytest.mark.parametrize("name", ["contact_geometry", "contact_gradient", "contact_torque", "contact_hessian"])
def test_outputs_with_sizes_of_their_own(chunked, name):
    pairs, arrays = chunked
    assert_same(getattr(pypw85, name)(*arrays, 0.5), getattr(pypw85, name)(*pairs, 0.5))


@pytest.mark.parametrize("name", ["distance", "distance_derivatives"])
def test_distances(chunked, name):
    pairs, arrays = chunked
    assert_same(getattr(pypw85, name)(*arrays), getattr(pypw85, name)(*pairs))


def test_walls(chunked):
    (r, q, _), (lazy_r, lazy_q, _) = chunked
    for name, scalars in (("distance_plane", (2.0,)), ("contact_plane", (2.0,)), ("distance_plane_derivatives", ()),
                          ("contact_plane_derivatives", (2.0,)),
                          ("distance_cylinder", (9.0, [1, 0, 0])), ("distance_point", ()),
                          ("intersect_line", ([0, 0, 1],))):
        function = getattr(pypw85, name)
        assert_same(function(lazy_r, *scalars, lazy_q), function(r, *scalars, q))
    assert_same(pypw85.distance_box(-abs(lazy_r), abs(r), lazy_q), pypw85.distance_box(-abs(r), abs(r), q))


@pytest.mark.parametrize("function", [legacy.f1, legacy.f2, pypw85.f, pypw85.f_neg])
def test_functions_of_lambda(chunked, function):
    pairs, arrays = chunked
    lambdas = np.linspace(0, 1, 1000)
    assert_same(function(lambdas, *arrays), function(lambdas, *pairs))


def test_polynomials(chunked):
    (r12, q1, q2), arrays = chunked
    assert_same(legacy._detQ_as_poly(*arrays[1:]), legacy._detQ_as_poly(q1, q2))
    assert_same(legacy._rT_adjQ_r_as_poly(*arrays), legacy._rT_adjQ_r_as_poly(r12, q1, q2))


def test_forms(rng):
    semi_axes, quaternions = rng.uniform(1, 2, (10, 3)), rng.normal(size=(10, 4))
    lazy_axes, lazy_quaternions = da.from_array(semi_axes, chunks=5), da.from_array(quaternions, chunks=5)
    expected = pypw85.ellipsoid_quaternion(semi_axes, quaternions)
    assert_same(pypw85.ellipsoid_quaternion(lazy_axes, lazy_quaternions), expected)
    assert_same(pypw85.ellipsoid_quaternion(semi_axes.tolist(), lazy_quaternions), expected)
    assert_same(pypw85.ellipsoid(lazy_axes, np.eye(3)), pypw85.ellipsoid(semi_axes, np.eye(3)))
    assert_same(pypw85.spheroid(lazy_axes[:, 0], 2, [0, 0, 1]), pypw85.spheroid(semi_axes[:, 0], 2, [0, 0, 1]))
    assert_same(pypw85.from_lammps(2 * lazy_axes, lazy_quaternions), expected)
    assert_same(pypw85.from_ovito(lazy_axes, lazy_quaternions[:, [1, 2, 3, 0]]), expected)
    shapes = [{"type": "Sphere", "diameter": 2}]
    types = np.zeros(10, dtype=np.uint32)
    assert_same(pypw85.from_gsd(shapes, da.from_array(types), lazy_quaternions),
                pypw85.from_gsd(shapes, types, quaternions))


def test_packing(chunked):
    (_, q, _), (_, lazy, _) = chunked
    assert_same(pypw85.full(lazy), pypw85.full(q))
    assert_same(pypw85.packed(pypw85.full(lazy)), q)
    assert_same(pypw85.principal_axes(lazy), pypw85.principal_axes(q))
    assert_same(pypw85.principal_axes(lazy.astype(int) + [8, 0, 0, 8, 0, 8]),
                pypw85.principal_axes(q.astype(int) + [8, 0, 0, 8, 0, 8]))
    asymmetric = pypw85.packed(da.from_array(np.arange(9.0).reshape(3, 3)))
    with pytest.raises(ValueError, match="not symmetric"):
        asymmetric.compute()
    with pytest.raises(ValueError, match="full"):
        pypw85.full(lazy[:, :5])


def test_mixed_with_arrays_and_lists(chunked):
    pairs, arrays = chunked
    expected = pypw85.contact(*pairs)
    for k in range(3):
        mixed = list(pairs)
        mixed[k] = arrays[k]
        assert_same(pypw85.contact(*mixed), expected)
        assert_same(pypw85.contact(*(x if isinstance(x, da.Array) else x.tolist() for x in mixed)), expected)
    assert_same(pypw85.contact(arrays[0], pairs[1][0], list(pairs[2][0])),
                pypw85.contact(pairs[0], pairs[1][0], pairs[2][0]))


def test_any_chunks(chunked):
    pairs, _ = chunked
    arrays = [da.from_array(x, chunks=chunks) for x, chunks in zip(pairs, ((300, 2), (1000, 1), (150, 6)))]
    assert_same(pypw85.contact(*arrays), pypw85.contact(*pairs))


def test_chunks_of_other_kinds(chunked):
    pairs, arrays = chunked
    for dtype in (np.longdouble, np.float32, object):
        same = [x.astype(np.float32) for x in pairs]
        assert_same(pypw85.contact(*(x.astype(np.float32).astype(dtype) for x in arrays)), pypw85.contact(*same))
    masked = da.ma.masked_where(arrays[0] > 1, arrays[0])
    with pytest.warns(RuntimeWarning, match="invalid value encountered in contact"):
        mu2 = pypw85.contact(masked, *arrays[1:])[0].compute()
    np.testing.assert_array_equal(pypw85.bad_rows(mu2), np.flatnonzero((pairs[0] > 1).any(axis=1)))


def test_type_of_overlaps(chunked):
    (r12, q1, q2), (lazy, *_) = chunked
    q1 = q1.copy()
    q1[7] = 0
    codes = pypw85.overlap(lazy, q1, q2, dtype=np.uint8)
    assert codes.dtype == np.uint8
    with pytest.warns(RuntimeWarning, match="invalid value encountered in overlap"):
        np.testing.assert_array_equal(codes.compute(), pypw85.overlap(r12, q1, q2, dtype=np.uint8))
        np.testing.assert_array_equal(pypw85.bad_rows(codes), [7])
    with pytest.raises(TypeError, match="float32"):
        pypw85.contact(lazy, q1, q2, dtype=np.float32)
    with pytest.raises(TypeError, match="int64"):
        pypw85.overlap(lazy, q1, q2, dtype=np.int64)


def test_forwarded_keywords(chunked):
    (r12, q1, q2), (lazy, *_) = chunked
    axes = [0, 1, 1, ()]
    assert_same(pypw85.overlap(lazy.T, q1, q2, axes=axes), pypw85.overlap(r12.T, q1, q2, axes=axes))
    assert_same(pypw85.contact(lazy, q1, q2, order="C", casting="safe", dtype=float), pypw85.contact(r12, q1, q2))
    with pytest.raises(TypeError, match="casting rule 'no'"):
        pypw85.contact(lazy.astype(np.float32), q1, q2, casting="no")[0].compute()


@pytest.mark.parametrize("keyword", ["where", "signature", "subok", "keepdims", "nonsense"])
def test_refused_keywords(chunked, keyword):
    _, arrays = chunked
    with pytest.raises(TypeError, match=f"closest_approach: .*'{keyword}'"):
        pypw85.closest_approach(*arrays, **{keyword: True})


def test_refused_out(chunked):
    pairs, arrays = chunked
    for out in (np.empty((1000, 2)), (np.empty(1000), np.empty(1000)), (None, np.empty(1000))):
        with pytest.raises(TypeError, match="contact: .*'out'"):
            pypw85.contact(*arrays, out)
    with pytest.raises(TypeError, match="spheroid: .*'out'"):
        pypw85.spheroid(arrays[0][:, 0], 1, [0, 0, 1], np.empty((1000, 6)))
    with pytest.raises(TypeError, match="legacy_f1: .*'out'"):
        legacy.f1(0.5, *arrays, np.empty((1000, 3)))
    with pytest.raises(TypeError, match="out, .* must be an array of NumPy"):
        pypw85.closest_approach(*pairs, da.empty(1000))
    assert_same(pypw85.contact(*arrays, (None, None)), pypw85.contact(*pairs))


def test_wrong_sizes_are_refused_at_once(chunked):
    _, (r12, q1, q2) = chunked
    with pytest.raises(ValueError, match=r"contact: .* input 0 must be \(3,\), not \(1000, 2\)"):
        pypw85.contact(r12[:, :2], q1, q2)
    with pytest.raises(ValueError, match=r"input 1 must be \(6,\), not \(\)"):
        pypw85.contact(r12, da.from_array(np.float64(1)), q2)
    with pytest.raises(ValueError, match=r"input 0 must be \(3,\), not \(1000, 1\)"):
        pypw85.contact(r12[:, :1], q1, q2)


def test_other_collections_are_refused(chunked):
    pairs, _ = chunked
    for other in (dask.delayed(pairs[0]), dask.bag.from_sequence([1, 2, 3])):
        with pytest.raises(TypeError, match="a dask collection must be a dask.array.Array, not (Delayed|Bag)"):
            pypw85.contact(other, *pairs[1:])


def test_neighbour_lists_are_computed(chunked):
    (centers, q, _), (lazy_centers, lazy_q, _) = chunked
    pairs = np.array([[0, 1], [2, 3]])
    np.testing.assert_array_equal(pypw85.contact_pairs(da.from_array(pairs), lazy_centers, lazy_q),
                                  pypw85.contact_pairs(pairs, centers, q))


def test_apply_gufunc(chunked):
    pairs, arrays = chunked
    ufunc = gufuncs.closest_approach
    distance = da.apply_gufunc(ufunc, ufunc.signature, *arrays, output_dtypes=float)
    np.testing.assert_array_equal(distance.compute(), pypw85.closest_approach(*pairs))
