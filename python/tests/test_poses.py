# SPDX-License-Identifier: BSD-3-Clause
"""Distances of an ellipsoid and a solid by their poses, against invariances and finite differences."""

import os
import pathlib
import re

import numpy as np
import pypw85
import pytest

SOLIDS = {"box": [1.0, 0.5, 0.7], "segment": [[-1, 0.2, 0], [1, 0.3, 0.5]], "triangle": [[-1, 0, 0], [1, 0.3, 0.5], [0.2, 1.5, -0.4]],
          "mesh": pypw85.Mesh([[-1, 0, 0], [1, 0.3, 0.5], [0.2, 1.5, -0.4], [0, 0.2, 1.5]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])}
AXES = [0.5, 1.0, 0.8]


def quaternion(rng):
    return rng.normal(size=4)


def matrix(q):
    """The matrix by the products of quaternions q i q*, which the package does not use."""
    def product(a, b):
        return np.concatenate([[a[0] * b[0] - a[1:] @ b[1:]], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])])

    q = np.asarray(q) / np.linalg.norm(q)
    back = q * [1, -1, -1, -1]
    return np.array([product(product(q, np.eye(4)[k]), back)[1:] for k in (1, 2, 3)]).T


def turned(omega):
    angle = np.linalg.norm(omega)
    return matrix(np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * omega / angle]))


@pytest.mark.parametrize("name", SOLIDS)
def test_kinds_of_poses_agree(name):
    rng = np.random.default_rng(1)
    for _ in range(20):
        q1, q2, t1, t2 = quaternion(rng), quaternion(rng), 2 * rng.normal(size=3), rng.normal(size=3)
        homogeneous = np.eye(4)
        homogeneous[:3, :3], homogeneous[:3, 3] = matrix(q1), t1
        first = pypw85.pose_distance(AXES, (q1, t1), SOLIDS[name], (q2, t2))
        for pose1 in ((matrix(q1), t1), homogeneous):
            other = pypw85.pose_distance(AXES, pose1, SOLIDS[name], (matrix(q2), t2))
            for a, b in zip(first, other):
                np.testing.assert_allclose(a, b, rtol=0, atol=1e-10)


@pytest.mark.parametrize("name", SOLIDS)
def test_common_motions_change_nothing_but_the_frame(name):
    rng = np.random.default_rng(2)
    for _ in range(20):
        r1, r2, t1, t2 = matrix(quaternion(rng)), matrix(quaternion(rng)), 2 * rng.normal(size=3), rng.normal(size=3)
        r, t = matrix(quaternion(rng)), rng.normal(size=3)
        here = pypw85.pose_distance(AXES, (r1, t1), SOLIDS[name], (r2, t2))
        there = pypw85.pose_distance(AXES, (r @ r1, r @ t1 + t), SOLIDS[name], (r @ r2, r @ t2 + t))
        assert abs(here.distance - there.distance) < 1e-13
        np.testing.assert_allclose(there.point1, r @ here.point1 + t, atol=1e-10)
        np.testing.assert_allclose(there.point2, r @ here.point2 + t, atol=1e-10)
        np.testing.assert_allclose(there.normal, r @ here.normal, atol=1e-10)
        np.testing.assert_allclose(there.point2 - there.point1, there.distance * there.normal, atol=1e-12)


@pytest.mark.parametrize("name", SOLIDS)
def test_derivatives_are_finite_differences(name):
    """Central differences err by h² = 1e-10 times third derivatives, and by 1e-15/h = 1e-10."""
    rng = np.random.default_rng(3)
    signs = set()
    for _ in range(40):
        poses = [(matrix(quaternion(rng)), 2 * rng.normal(size=3)), (matrix(quaternion(rng)), rng.normal(size=3))]
        found = pypw85.pose_distance(AXES, poses[0], SOLIDS[name], poses[1])
        signs.add(found.distance > 0)
        for which, derivative in enumerate((found.d_pose1, found.d_pose2)):
            for k in range(6):
                step, values = np.zeros(3), []
                for h in (1e-5, -1e-5):
                    step[k % 3] = h
                    rotation, translation = poses[which]
                    moved = list(poses)
                    moved[which] = (rotation, translation + step) if k < 3 else (turned(step) @ rotation, translation)
                    values.append(pypw85.pose_distance(AXES, moved[0], SOLIDS[name], moved[1]).distance)
                assert abs((values[0] - values[1]) / 2e-5 - derivative[k]) < 1e-7
    assert signs == {True, False}


def test_example_in_c():
    """The program in C prints the numbers of pose_distance()."""
    one = ([[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]], [1, 6, 2])
    found = pypw85.pose_distance([3, 2, 1], one, [1, 2, 0.5], ([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]], [0, 0.5, 0]))
    text = (pathlib.Path(os.environ["PYPW85_SOURCE"]) / "examples/c/poses.txt").read_text(encoding="utf-8")
    printed = [float(number) for number in re.findall(r"-?\d+\.\d+", text)]
    np.testing.assert_allclose(printed, [found.distance, *found.d_pose1], rtol=0, atol=5.1e-5)


def test_a_turned_box_by_hand():
    """The edge of a cube that is turned by 45 degrees points to a ball of radius 1: 4 - 1 - √2."""
    half = np.sqrt(0.5)
    found = pypw85.pose_distance([1, 1, 1], None, [1, 1, 1], ([[half, -half, 0], [half, half, 0], [0, 0, 1]], [4, 0, 0]))
    assert abs(found.distance - (3 - np.sqrt(2))) < 1e-15
    np.testing.assert_allclose(found.point1, [1, 0, 0], atol=1e-15)
    np.testing.assert_allclose(found.d_pose2, [1, 0, 0, 0, 0, 0], atol=1e-15)


@pytest.mark.parametrize(
    "pose, what",
    [
        (([0, 0, 0, 0], [0, 0, 0]), "quaternion"),
        ((np.diag([1, 1, -1]), [0, 0, 0]), "rotation"),
        ((2 * np.eye(3), [0, 0, 0]), "rotation"),
        ((np.eye(3), [0, 0, np.nan]), "translation"),
        ((np.eye(2), [0, 0, 0]), "orientation"),
        (np.ones((4, 4)), "last row"),
    ],
)
def test_wrong_poses(pose, what):
    for arguments in ((pose, [1, 1, 1]), (None, [1, 1, 1], pose)):
        with pytest.raises(ValueError, match=what):
            pypw85.pose_distance([1, 1, 1], *arguments)


def test_wrong_solids():
    with pytest.raises(ValueError, match="3 half lengths"):
        pypw85.pose_distance([1, 1, 1], None, [[1, 2]])
    with pytest.raises(ValueError, match="no triangles"):
        pypw85.pose_distance([1, 1, 1], None, pypw85.Mesh(np.empty((0, 3)), np.empty((0, 3), int)))
    with pytest.raises(ValueError, match="must be >= 0, not"):
        pypw85.pose_distance([1, 1, 1], None, [1, 1, -1])
    with pytest.raises(pypw85.PW85Error):
        pypw85.pose_distance([1, 1, -1], None, [1, 1, 1])
