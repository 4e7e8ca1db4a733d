# SPDX-License-Identifier: BSD-3-Clause
"""Moving ellipsoids in Python: what the gufunc gives is what the mathematics says."""

import numpy as np
import pytest

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


def test_lists(random_pairs, rng):
    centers, q, _ = random_pairs(30)
    motions = pypw85.motion(rng.uniform(-1, 1, (30, 3)), rng.uniform(-1, 1, (30, 3)), 0.1)
    pairs = np.stack(np.triu_indices(30, 1), axis=1)
    time, next_time, next_pair = pypw85.first_contact_pairs(pairs, centers, q, motions, 5.0)
    i, j = pairs.T
    np.testing.assert_array_equal(
        time, pypw85.first_contact(centers[j] - centers[i], q[i], q[j], motions[i], motions[j], 5.0)
    )
    for particle in range(30):
        own = time[(pairs == particle).any(axis=1)]
        assert next_time[particle] == own.min()
        assert next_pair[particle] == -1 if np.isinf(own.min()) else time[next_pair[particle]] == own.min()


def test_bad_lists():
    q = [pypw85.spheroid(1, 1, [0, 0, 1])] * 2
    centers, motions = [[0, 0, 0], [3, 0, 0]], pypw85.motion(np.zeros((2, 3)))
    with pytest.raises(IndexError):
        pypw85.first_contact_pairs([[0, 2]], centers, q, motions)
    with pytest.raises(ValueError):
        pypw85.first_contact_pairs([[0, 1]], centers, q, motions[:1])
    with pytest.raises(ValueError):
        pypw85.first_contact_pairs([[0, 1]], centers, q, motions, cell=np.zeros((3, 3)))
    with pytest.raises(ValueError):
        pypw85.first_contact_pairs([[0, 1]], centers, q, motions, "soon")
    empty = pypw85.first_contact_pairs([], centers, q, motions)
    assert np.isinf(empty.next_time).all() and (empty.next_pair == -1).all()
