"""Moving ellipsoids in Python: what the gufunc gives is what the mathematics says."""

import numpy as np

import pypw85


def test_contact_at_the_time_given(random_pairs, assert_rows, rng):
    r12, q1, q2 = random_pairs(500)
    r12 = 3 * r12
    direction = r12 / np.linalg.norm(r12, axis=1)[:, None]
    still, coming = pypw85.motion(), pypw85.motion(-direction + rng.uniform(-0.1, 0.1, r12.shape))
    time = pypw85.first_contact(r12, q1, q2, still, coming)
    assert time.shape == (500,)
    touching = np.isfinite(time) & (time > 0)
    assert touching.sum() > 100
    r12, q1, q2, coming, time = (x[touching] for x in (r12, q1, q2, coming, time))
    mu2 = pypw85.contact(r12 + time[:, None] * coming[:, :3], q1, q2)[0]
    assert_rows(np.abs(mu2 - 1) <= 1e-11, r12, q1, q2)
    np.testing.assert_array_equal(pypw85.first_contact(r12, q1, q2, still, coming, 0.5 * time), np.inf)


def test_growth_and_rotation():
    q = pypw85.spheroid(1, 1, [0, 0, 1])
    growing = pypw85.motion(angular_velocity=[1, 2, 3], growth=[0.25, 0.5])
    np.testing.assert_allclose(pypw85.first_contact([3, 0, 0], q, q, growing, growing), [2, 1], rtol=1e-14)


def test_bad_rows_become_nan():
    q = pypw85.spheroid(1, 1, [0, 0, 1])
    with np.errstate(invalid="ignore"):
        time = pypw85.first_contact([3, 0, 0], q, q, pypw85.motion(), pypw85.motion([[np.nan, 0, 0], [-1, 0, 0]]))
    np.testing.assert_array_equal(time, [np.nan, 1])
