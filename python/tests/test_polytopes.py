# SPDX-License-Identifier: BSD-3-Clause
"""Ellipsoids and a polytope, and the example that culls splats."""

import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import pypw85
from pypw85 import PW85Error

SPHERE = np.array([1.0, 0, 0, 1, 0, 1])
CULL = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "examples/python/cull_splats.py"


def test_shapes_of_arguments():
    q = np.tile(SPHERE, (3, 1))
    centers = np.array([[0.0, 0, 0], [2.5, 0, 0], [3, 0, 0]])
    normals, offsets = [[1, 0, 0], [0, 1, 0]], [2, 9]
    mu2, point = pypw85.contact_polytope(centers, q, normals, offsets)
    np.testing.assert_array_equal(mu2, [0, 0.25, 1])
    np.testing.assert_array_equal(point, [[0, 0, 0], [-0.5, 0, 0], [-1, 0, 0]])
    np.testing.assert_array_equal(pypw85.overlap_polytope(centers, q, normals, offsets), [True, True, False])
    assert pypw85.overlap_polytope(centers, q, [], []).all()
    assert pypw85.overlap_polytope(np.empty((0, 3)), np.empty((0, 6)), normals, offsets).shape == (0,)
    for bad in [(centers[:2], q, normals, offsets), (centers, q, normals, [1]), (centers, q, [[1, 0]], [1])]:
        with pytest.raises(ValueError):
            pypw85.overlap_polytope(*bad)


def test_causes_are_named():
    q, flat = np.tile(SPHERE, (2, 1)), np.array([SPHERE, [1, 0, 0, 1, 0, 0]])
    centers = np.zeros((2, 3))
    for arguments, words in [
        ((centers, flat, [[1, 0, 0]], [1]), r"row 1: q must be positive definite, not \[1.0"),
        ((centers, q, [[1, 0, 0], [0, 0, 0]], [1, 1]), r"row 1: normals must not be zero, not \[0.0, 0.0, 0.0\]"),
        ((centers, q, [[1, 0, 0], [0, np.nan, 0]], [1, 1]), r"row 1: normals must be finite, not \[0.0, nan, 0.0\]"),
        ((centers, q, [[1, 0, 0]], [np.nan]), r"offsets must be finite, not \[nan\]"),
        ((centers * [[1], [np.nan]], q, [[1, 0, 0]], [1]), r"row 1: center must be finite, not \[nan, nan, nan\]"),
    ]:
        for function in (pypw85.contact_polytope, pypw85.overlap_polytope):
            with pytest.raises(PW85Error, match=words):
                function(*arguments)


def run(path):
    return subprocess.run([sys.executable, CULL, path], capture_output=True, check=False, text=True)


def test_reader_takes_files_with_other_properties(tmp_path):
    """A splat before the camera and one behind it, with normals, colours, numbers of two kinds and another element."""
    names = ["x", "y", "z", "nx", "opacity", *(f"scale_{k}" for k in range(3)), *(f"rot_{k}" for k in range(4))]
    row = np.dtype([(name, "u1" if name == "nx" else "<f8" if name == "x" else "<f4") for name in names])
    splats = np.zeros(2, row)
    splats["x"], splats["y"], splats["rot_0"] = [2, -2], [4, -4], 1
    splats["scale_0"] = splats["scale_1"] = splats["scale_2"] = np.log(0.1)
    kinds = {"nx": "uchar", "x": "double"}
    head = "".join(f"property {kinds.get(name, 'float')} {name}\n" for name in names)
    text = f"ply\nformat binary_little_endian 1.0\ncomment made\nelement vertex 2\n{head}element face 1\nproperty int a\nend_header\n"
    path = tmp_path / "splats.ply"
    path.write_bytes(text.encode() + splats.tobytes() + b"\0\0\0\0")
    assert run(path).stdout.splitlines()[:2] == [
        "2 splats at 99%, of which the camera sees",
        "exactly                    1       0 missing       0 too many",
    ]
    path.write_bytes(text.replace("binary_little_endian", "ascii").encode())
    assert "is no binary PLY file" in run(path).stderr
