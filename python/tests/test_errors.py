# SPDX-License-Identifier: BSD-3-Clause
"""Bad input: exceptions for single calls, marked rows and one signal for arrays."""

import pickle
import re
import warnings

import numpy as np
import pytest

import pypw85
from pypw85 import PW85Error, Status, _core, _documentation, legacy

Q = np.array([1.0, 0, 0, 1, 0, 1])
R = np.array([3.0, 0, 0])
FLAT = np.array([1.0, 0, 0, 1, 0, 0])
NAN = np.full(6, np.nan)

FAILURES = [
    (pypw85.spheroid, (0, 1, [0, 0, 1]), Status.EINVAL),
    (pypw85.spheroid, (1, 1, [0, 0, 0]), Status.EINVAL),
    (pypw85.ellipsoid, ([1, 2, 3], np.ones((3, 3))), Status.EINVAL),
    (pypw85.ellipsoid_quaternion, ([1, 2, -3], [1, 0, 0, 0]), Status.EINVAL),
    (pypw85.ellipse, (1, 1, np.inf), Status.EINVAL),
    (pypw85.principal_axes, (FLAT,), Status.ENOTPD),
    (pypw85.principal_axes, (NAN,), Status.EINVAL),
    (pypw85.f, (0.5, R, Q, -Q), Status.ENOTPD),
    (pypw85.f, (1.5, R, Q, Q), Status.EINVAL),
    (pypw85.contact, (R, Q, FLAT), Status.ENOTPD),
    (pypw85.contact, (R, NAN, Q), Status.EINVAL),
    (pypw85.contact_function, (R, FLAT, Q), Status.ENOTPD),
    (pypw85.contact_function, ([np.inf, 0, 0], Q, Q), Status.EINVAL),
    (pypw85.overlap, (R, Q, FLAT), Status.ENOTPD),
    (pypw85.compare, (R, Q, FLAT, 1), Status.ENOTPD),
    (pypw85.compare, (R, Q, Q, -1), Status.EINVAL),
    (pypw85.contains, (R, Q, FLAT), Status.ENOTPD),
    (pypw85.contact_geometry, (0 * R, Q, Q, 0.5), Status.EINVAL),
    (pypw85.contact_gradient, (R, Q, Q, 2.0), Status.EINVAL),
    (pypw85.contact_torque, (R, Q, FLAT, 0.5), Status.ENOTPD),
    (pypw85.closest_approach, (0 * R, Q, Q), Status.EINVAL),
    (pypw85.contact_2d, ([1, 0], [1, 0, 1], [1, 1, 1]), Status.ENOTPD),
    (pypw85.closest_approach_2d, ([0, 0], [1, 0, 1], [1, 0, 1]), Status.EINVAL),
    (pypw85.zheng_ellipses, ([0, 0], [1, 0, 1], [1, 0, 1]), Status.EINVAL),
    (pypw85.zheng_ellipsoids, (R, Q, FLAT), Status.ENOTPD),
    (pypw85._cholesky_decomp, (FLAT,), Status.ENOTPD),
    (pypw85._cholesky_decomp, (NAN,), Status.EINVAL),
    (legacy.f1, (2.0, R, Q, Q), Status.EINVAL),
    (legacy.f2, (0.5, R, Q, NAN), Status.EINVAL),
    (legacy.f2_derivatives, (0.5, R, Q, FLAT), Status.ENOTPD),
    (legacy.contact_function1, (R, Q, FLAT), Status.ENOTPD),
    (legacy.contact_function2, (R, Q, FLAT), Status.ENOTPD),
]


@pytest.mark.parametrize("function, args, status", FAILURES)
def test_single_call_raises(function, args, status):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(PW85Error) as caught:
            function(*args)
    assert caught.value.status is status
    assert caught.value.reason == pypw85.strerror(status)
    assert caught.value.detail and caught.value.detail in str(caught.value)
    assert caught.value.function.removeprefix("legacy_") in str(function)
    assert isinstance(caught.value, ValueError) and isinstance(caught.value, ArithmeticError)


@pytest.mark.parametrize("function, args, status", FAILURES)
def test_bad_row_of_array(function, args, status):
    rows = [np.stack([np.asarray(arg, dtype=float)] * 3) for arg in args]
    with pytest.warns(RuntimeWarning, match="invalid value encountered in") as caught:
        result = function(*rows)
    assert len(caught) == 1
    for output in result if isinstance(result, tuple) else (result,):
        if output.dtype == bool:  # a bad pair counts as one that overlaps, and as one that is not inside
            assert (output == (function is not pypw85.contains)).all()
        else:
            assert np.isnan(output).all()


def mixed_rows():
    q = np.tile(Q, (1000, 1))
    q[[17, 600]] = FLAT
    return np.tile(R, (1000, 1)), q, np.tile(Q, (1000, 1))


@pytest.mark.parametrize("function", [pypw85.contact, pypw85.contact_function])
def test_good_rows_are_computed_all_the_same(function):
    with np.errstate(invalid="ignore"):
        mu2, lambda_ = function(*mixed_rows())
    np.testing.assert_array_equal(pypw85.bad_rows(mu2), [17, 600])
    np.testing.assert_array_equal(pypw85.bad_rows((mu2, lambda_)), [17, 600])
    # The bound of the library, 4 u cond, with cond = 3 for spheres.
    np.testing.assert_allclose(np.delete(mu2, [17, 600]), 2.25, rtol=12 * 2.0**-53)
    np.testing.assert_allclose(np.delete(lambda_, [17, 600]), 0.5, rtol=1e-12)


def test_bad_rows_of_vectors_and_overlaps():
    r12, q1, q2 = mixed_rows()
    with np.errstate(invalid="ignore"):
        gradient = pypw85.contact_gradient(r12, q1, q2, 0.5)
        codes = pypw85.overlap(r12, q1, q2, dtype=np.uint8)
        truths = pypw85.overlap(r12, q1, q2)
    np.testing.assert_array_equal(pypw85.bad_rows(gradient, core_ndim=1), [17, 600])
    np.testing.assert_array_equal(pypw85.bad_rows(codes), [17, 600])
    np.testing.assert_array_equal(np.flatnonzero(truths), [17, 600])
    with pytest.raises(TypeError, match="uint8"):
        pypw85.bad_rows(truths)


def test_bad_rows_of_containment():
    r12, q1, q2 = mixed_rows()
    with np.errstate(invalid="ignore"):
        codes = pypw85.contains(0.0 * r12, 2.0 * q1, q2, dtype=np.uint8)
        truths = pypw85.contains(0.0 * r12, 2.0 * q1, q2)
    np.testing.assert_array_equal(pypw85.bad_rows(codes), [17, 600])
    np.testing.assert_array_equal(np.flatnonzero(~truths), [17, 600])


@pytest.mark.parametrize("scattered", [False, True])
@pytest.mark.parametrize("name", ["contact", "contact_function", "overlap", "closest_approach"])
def test_errstate(name, scattered):
    function = getattr(pypw85, name)
    rows = [x.repeat(2, axis=0)[::2] if scattered else x for x in mixed_rows()]
    with np.errstate(invalid="ignore"), warnings.catch_warnings():
        warnings.simplefilter("error")
        function(*rows)
    with np.errstate(invalid="warn"), pytest.warns(RuntimeWarning, match=f"invalid value encountered in {name}"):
        function(*rows)
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match=name):
        function(*rows)


def test_no_signal_for_good_rows():
    """Whatever happens inside, a good result says nothing: not for extreme sizes either."""
    sizes = 10.0 ** np.arange(-140, 141, 20)
    q = pypw85.spheroid(sizes, 3 * sizes, [0, 0, 1])
    r12 = sizes[:, None] * [1, 2, 3]
    with np.errstate(all="raise"):
        for function in (pypw85.contact, pypw85.contact_function, pypw85.overlap, pypw85.closest_approach):
            function(r12, q, q)
        mu2, lambda_ = pypw85.contact(0 * r12, q, q)
        pypw85.contact_geometry(r12, q, q, lambda_)
    assert (mu2 == 0).all() and (lambda_ == 0.5).all()


def test_signal_of_earlier_operations_is_not_inherited():
    with np.errstate(invalid="ignore"):
        np.log(-np.ones(10))
    with np.errstate(all="raise"):
        pypw85.contact(*(x[:10] for x in mixed_rows()))


@pytest.mark.parametrize("out", [np.zeros(2), (np.zeros(()), np.zeros(()))])
def test_failed_call_leaves_nan_in_out(out):
    with pytest.raises(PW85Error):
        pypw85.contact(R, Q, FLAT, out)
    assert np.isnan(out).all()


def test_failed_form_leaves_nan_in_out():
    q = np.zeros(6)
    with pytest.raises(PW85Error):
        pypw85.spheroid(-1, 1, [0, 0, 1], q)
    assert np.isnan(q).all()


def test_exception_survives_pickling():
    with pytest.raises(PW85Error) as caught:
        pypw85.contact(R, Q, FLAT)
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (copy.status, str(copy)) == (Status.ENOTPD, str(caught.value))


def test_statuses():
    assert {s.name: int(s) for s in Status} == _core.STATUSES
    assert [int(s) for s in Status] == list(range(8))
    assert len({pypw85.strerror(s) for s in Status}) == 8
    assert pypw85.strerror(12345) == pypw85.strerror(-1) == pypw85.strerror(2**40)
    with pytest.raises(TypeError):
        pypw85.strerror("x")


def test_version():
    assert pypw85.version() == pypw85.__version__
    assert all(part.isdigit() for part in pypw85.version().split("."))


# A good row of each argument, by its name and shape; and what may be bad about one, with the words for it.
GOOD = {"lambda_": 0.5, "semi_axes": [1, 2, 3], "rotation": np.eye(3), "cell": np.eye(3), "quaternion_wxyz": [1, 0, 0, 0],
        "s1": np.eye(3), "s2": np.eye(3), "curvatures": [1, 2],
        "lower": [-9.0] * 3, "upper": [9.0] * 3, "motion1": [0.0] * 7, "motion2": [0.0] * 7, "offset": 5.0, "t_max": 1.0}  # fmt: skip
FORMS = {(6,): [1, 0, 0, 1, 0, 1], (3,): [1, 0, 1]}
REASONS = {
    **dict.fromkeys(["a", "b", "c", "curvatures", "radius", "semi_axes"], ((0, "must be > 0"), (-1, "must be > 0"))),
    **dict.fromkeys(["motion1", "motion2"], ((-2.0, "must not shrink to nothing before t_max"),)),
    **dict.fromkeys(["axis", "direction", "n", "normal", "quaternion_wxyz"], ((0, "must not be zero"),)),
    "lambda_": [(-0.5, "must be in [0, 1]"), (1.5, "must be in [0, 1]")],
    **dict.fromkeys(["t_max", "mu2"], ((-1, "must be >= 0"),)),
    "rotation": [(1, "must be a rotation matrix")],
    "cell": [(1, "must have independent rows")],
    **dict.fromkeys(["s1", "s2"], ((1, "must have columns that"), (0, "must have columns that"))),
    "lower": [(10, "must be at most upper")],
    **dict.fromkeys((f"{what}_capsule radius" for what in ("contact", "overlap", "distance")), ((-1, "must be >= 0"),)),
}


def causes():
    for name in sorted(name for name in dir(_core) if f"call_{name}" in dir(_core)):
        cores, names = _documentation.cores_of_inputs(name), _documentation.names_of_inputs(name)
        good = [np.array(good_row(argument, core), dtype=float) for argument, core in zip(names, cores)]
        for k, (argument, core) in enumerate(zip(names, cores)):
            bad = [(np.inf, "must be finite"), (np.nan, "must be finite")]
            bad = [(np.nan, "must not be NaN")] if argument in ("t_max", "mu2") else bad
            if is_form(argument, core):
                bad.append((-1, "must be positive definite"))
            elif argument == "r12" and name.startswith(("contact_geometry", "contact_hessian")):
                bad.append((0, "must not be zero"))
            reasons = REASONS.get(f"{name} {argument}", REASONS.get(argument, ()))
            for value, words in [*bad, *(() if is_form(argument, core) else reasons)]:
                if not name.startswith(("cholesky_solve", "legacy_det", "legacy_xT", "legacy_rT")):  # plain formulas
                    words = f"{argument} .*{re.escape(words)}"
                    yield pytest.param(name, good, k, value, words, id=f"{name}-{argument}-{value}")


def is_form(argument, core):
    return core == (6,) or (argument in ("q", "q1", "q2", "second_moments") and core == (3,))


def good_row(argument, core):
    if is_form(argument, core):
        return FORMS[core]
    row = GOOD.get(argument, [3.0, 0, 0] if core else 1.0)
    return row[: core[0]] if argument in ("lower", "upper") or (argument not in GOOD and core) else row


@pytest.mark.parametrize("name, good, k, value, words", causes())
def test_cause_is_named(name, good, k, value, words):
    """The argument, by its name, and what is wrong with it; of many rows also which one is the first that is bad."""
    call = getattr(_core, f"call_{name}")
    bad = [np.full_like(x, value) if i == k else x for i, x in enumerate(good)]
    call(*good, None, {})
    with pytest.raises(PW85Error, match=f"^{name}: {words}"):
        call(*bad, None, {})
    rows = [np.stack([[g, g], [g, b], [b, g]]) if i == k else g for i, (g, b) in enumerate(zip(good, bad))]
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match=rf"{name}: row \(1, 1\): {words}"):
        call(*rows, None, {})


def test_shapes_are_named():
    matrix = np.eye(3)
    with pytest.raises(ValueError, match=r"^contact: q2 has shape \(3, 3\); a form has 6 entries in the last axis: "
                                         r"pypw85.packed\(matrix\) converts$"):  # fmt: skip
        pypw85.contact(R, Q, matrix)
    with pytest.raises(ValueError, match=r"q1 has shape \(4, 3, 3\).*packed"):
        pypw85.distance(R, [matrix] * 4, Q)
    with pytest.raises(ValueError, match=r"q must be rows of 6 numbers, not an array of the shape \(2, 3, 3\): pypw85.packed"):
        pypw85.contact_pairs([[0, 1]], np.zeros((2, 3)), [matrix] * 2)
    with pytest.raises(ValueError, match=r"^spheroid: n has shape \(2,\); it must have 3 entries in the last axis$"):
        pypw85.spheroid(1, 2, [0, 1])
    with pytest.raises(ValueError, match=r"^ellipsoid: rotation has shape \(3,\); its last axes must be \(3, 3\)$"):
        pypw85.ellipsoid([1, 2, 3], [1, 2, 3])
    with pytest.raises(ValueError, match=r"^overlap: the numbers of rows do not fit: r12 \(3,\), q1 \(\), q2 \(4,\)$"):
        pypw85.overlap([R] * 3, Q, [Q] * 4)


def test_causes_in_systems():
    centers, q = np.array([R, 2 * R]), np.array([Q, Q])
    flat = np.array([Q, FLAT])
    for call, words in [
        (lambda: pypw85.overlap_any(Q, centers, flat), r"overlap_any: row 1: q2 must be positive definite, not \[1.0"),
        (lambda: pypw85.overlap_any(FLAT, centers, q), r"overlap_any: q1 must be positive definite, not \[1.0"),
        (lambda: pypw85.overlap_any_indices(0 * R, Q, [1], centers, flat), r"row 0: q2 must be positive definite, not \[1.0"),
        (lambda: pypw85.overlap_any_indices(0 * R, FLAT, [1], centers, q), r"indices: q1 must be positive definite, not \[1.0"),
        (lambda: pypw85.overlap_any_indices(np.nan * R, Q, [1], centers, q), r"row 0: r12 must be finite, not \[nan, nan, nan\]"),
        (lambda: pypw85.overlap_any_indices(0 * R, Q, [1, 2], centers, q), r"row 1: indices must be an index of the 2 particles, not 2"),
        (lambda: pypw85.overlap_any_indices(0 * R, Q, [1], centers, q, np.zeros((3, 3))), r"cell must have independent rows, not \[\[0.0"),
        (lambda: pypw85.nearest_image_limit(flat, np.eye(3)), r"row 1: q must be positive definite, not \[1.0"),
        (lambda: pypw85.nearest_image_limit(q, np.zeros((3, 3))), r"cell must have independent rows, not \[\[0.0, 0"),
        (lambda: pypw85.neighbors(centers, flat), r"neighbors: particle 1: q must be positive definite"),
        (lambda: pypw85.neighbors(centers * [[1], [np.nan]], q), "particle 1: centers must be finite, not"),
        (lambda: pypw85.neighbors(centers, q, scale=-1), "neighbors: scale must be > 0, not -1.0$"),
        (lambda: pypw85.neighbors(centers, q, scale=np.inf), "neighbors: scale must be finite, not inf$"),
        (lambda: pypw85.neighbors(centers, q, skin=-1), "neighbors: skin must be >= 0, not -1.0$"),
        (lambda: pypw85.neighbors(centers, q, np.ones((3, 3))), "neighbors: cell must have finite, independent vectors, one of them per"),
        (lambda: pypw85.neighbors(centers * [[1], [1e15]], q, np.eye(3)), "particle 1: centers must not be too far away"),
        (lambda: pypw85.principal_axes(FLAT), "principal_axes: q must be positive definite"),
    ]:
        with pytest.raises(PW85Error, match=words):
            call()
