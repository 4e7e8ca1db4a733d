# SPDX-License-Identifier: BSD-3-Clause
"""Files for MuJoCo and Gazebo: sizes, orientations, masses, moments of inertia, by an XML parser; with PYPW85_FORMATS by MuJoCo itself."""

import json
import os
import shutil
import subprocess
import warnings
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import pypw85

VERSION = "3.14.0"
MODEL = """
import fs from 'node:fs'; import load from '@mujoco/mujoco';
const M = await load(), text = fs.readFileSync(process.argv[2], 'utf8');
const model = M.MjModel.from_xml_string(text), data = new M.MjData(model);
M.mj_forward(model, data);
const rows = (array, first) => Array.from(array).slice(first);
console.log(JSON.stringify({mass: rows(model.body_mass, 1), inertia: rows(model.body_inertia, 3), frame: rows(data.ximat, 9),
  size: rows(model.geom_size, 0), turn: rows(data.geom_xmat, 0), center: rows(data.geom_xpos, 0), own: rows(data.xipos, 3)}));
"""


def bodies(rng, count=200, flattest=1e-8):
    """Ellipsoids from balls to discs and needles, of different sizes, all large enough for MuJoCo."""
    semi_axes = 10.0 ** rng.uniform(0, 1, (count, 1)) * 10.0 ** rng.uniform(-2, 0, (count, 3))
    semi_axes[:100, 2] = flattest ** rng.uniform(0.5, 1, 100)
    semi_axes[:100, :2] = rng.uniform(0.1, 10, (100, 2))
    semi_axes[-1] = 0.5
    quaternions = rng.normal(size=(count, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    return pypw85.System.from_axes(rng.normal(size=(count, 3)), semi_axes, quaternions, ids=3 * np.arange(count) + 5)


def true_inertia(system):
    """Masses for the density 1000, and tensors, by quadrature: the integrals of 1, and of |x|² 1 - x⊗x, over the body R diag(a) (ball).

    Gauss's rules with three nodes in the radius and the height, and four angles, are exact for polynomials of degree 2."""
    nodes, weights = np.polynomial.legendre.leggauss(3)
    radius, height = np.meshgrid(0.5 + 0.5 * nodes, nodes, indexing="ij")
    weight = np.outer(0.5 * weights * (0.5 + 0.5 * nodes)**2, weights) * np.pi / 2
    angles = np.arange(4) * np.pi / 2
    across = radius * np.sqrt(1 - height**2)
    x, y, z = across[..., None] * np.cos(angles), across[..., None] * np.sin(angles), np.repeat((radius * height)[..., None], 4, axis=-1)
    points = np.stack([x, y, z], -1)
    points, weight = points.reshape(-1, 3), np.repeat(weight.ravel(), 4)
    images = np.einsum("nij,nj,kj->nki", turns(system.quaternions), system.semi_axes, points)
    weight = 1000 * weight * system.semi_axes.prod(axis=1)[:, None]
    second = np.einsum("nk,nki,nkj->nij", weight, images, images)
    return weight.sum(axis=1), np.trace(second, axis1=1, axis2=2)[:, None, None] * np.eye(3) - second


def turns(quaternions):
    w, v = quaternions[:, :1, None], quaternions[:, 1:]
    cross = np.cross(np.eye(3)[None], v[:, None])
    return (w**2 - (v**2).sum(axis=1)[:, None, None]) * np.eye(3) + 2 * v[:, :, None] * v[:, None, :] + 2 * w * cross


def check(system, mass, moments, frames, sizes, geom_frames, centers):
    """Errors of forms and tensors are some ten roundings, of the largest entry."""
    true_mass, true_tensor = true_inertia(system)
    np.testing.assert_allclose(mass, true_mass, rtol=2e-15 * 8)
    tensor = np.einsum("nij,nj,nkj->nik", frames, moments, frames)
    scale = np.abs(true_tensor).max(axis=(1, 2), keepdims=True)
    np.testing.assert_allclose(tensor / scale, true_tensor / scale, rtol=0, atol=1e-14)
    form = np.einsum("nij,nj,nkj->nik", geom_frames, sizes**2, geom_frames)
    scale = np.square(system.semi_axes.max(axis=1))[:, None, None]
    np.testing.assert_allclose(form / scale, pypw85.full(system.q) / scale, rtol=0, atol=1e-14)
    np.testing.assert_array_equal(centers, system.centers)


def test_bodies(tmp_path, rng):
    system = bodies(rng)
    pypw85.write(tmp_path / "a.xml", system)
    found = list(ET.parse(tmp_path / "a.xml").getroot().iter("body"))
    assert [body.get("name") for body in found] == [f"particle_{k}" for k in system.ids]

    def numbers(key, child=None):
        return np.array([[float(word) for word in (body.find(child) if child else body).get(key).split()] for body in found])

    frames = turns(numbers("quat"))
    moments = numbers("diaginertia", "inertial")
    assert all(body.find("geom").get("type") == "ellipsoid" and body.find("freejoint") is not None for body in found)
    check(system, numbers("mass", "inertial")[:, 0], moments, frames, numbers("size", "geom"), frames, numbers("pos"))
    np.testing.assert_array_equal(numbers("pos", "inertial"), 0)
    assert (moments <= moments[:, [1, 2, 0]] + moments[:, [2, 0, 1]]).all()


def test_sdf(tmp_path, rng):
    """The frame of a link is that of its model, and its tensor is diagonal in it."""
    system = bodies(rng)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pypw85.write(tmp_path / "a.sdf", system)
    root = ET.parse(tmp_path / "a.sdf").getroot()
    models = list(root.iter("model"))
    assert [model.get("name") for model in models] == [f"particle_{k}" for k in system.ids]
    assert root.get("version") == "1.9" and {model.find("pose").get("rotation_format") for model in models} == {"quat_xyzw"}

    def numbers(path):
        return np.array([[float(word) for word in model.find(path).text.split()] for model in models])

    def entries(*keys):
        return np.hstack([numbers(f"link/inertial/inertia/{key}") for key in keys])

    poses = numbers("pose")
    frames, radii = turns(poses[:, [6, 3, 4, 5]]), numbers("link/collision/geometry/ellipsoid/radii")
    moments = entries("ixx", "iyy", "izz")
    check(system, numbers("link/inertial/mass")[:, 0], moments, frames, radii, frames, poses[:, :3])
    np.testing.assert_array_equal(entries("ixy", "ixz", "iyz"), 0)
    np.testing.assert_array_equal(numbers("link/visual/geometry/ellipsoid/radii"), radii)
    assert (moments <= moments[:, [1, 2, 0]] + moments[:, [2, 0, 1]]).all()


def test_what_is_lost(tmp_path, rng):
    system = bodies(rng, 101)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pypw85.write(tmp_path / "a.mjcf", system)
    for name, program in (("a.xml", "MuJoCo"), ("a.sdf", "SDFormat")):
        system.cell, system.types = np.eye(3), np.zeros(101, dtype=int)
        with pytest.warns(UserWarning, match=f"{program} has no periodic boxes: the cell is left out"):
            pypw85.write(tmp_path / name, system)
        system.cell, system.types = None, np.arange(101) % 2
        with pytest.warns(UserWarning, match=f"of {program} have no types: they are left out"):
            pypw85.write(tmp_path / name, system)
    tiny = pypw85.System.from_axes(np.zeros((1, 3)), np.full((1, 3), 1e-4), np.array([[1.0, 0, 0, 0]]))
    with pytest.warns(UserWarning, match="that are not above 1e-15, and the smallest is 1.68e-17 for the density 1000"):
        pypw85.write(tmp_path / "a.xml", tiny)


def test_what_is_refused(tmp_path, rng):
    system = bodies(rng, 101)
    for name, reason in (("a.urdf", "URDF has no ellipsoids"), ("a.sdf.gz", "is not written compressed"),
                         ("a.xml.gz", "is not written compressed")):
        with pytest.raises(pypw85.FileError, match=reason):
            pypw85.write(tmp_path / name, system)
    ellipses = pypw85.System.from_ellipses(np.zeros((1, 2)), np.ones((1, 2)), np.zeros(1))
    doubled = bodies(rng, 101)
    doubled.ids = np.full(101, 7)
    for name, holder, models in (("a.xml", "an MJCF file", "bodies of MuJoCo"), ("a.sdf", "a file of SDFormat", "models of SDFormat")):
        with pytest.raises(ValueError, match=f"{holder} holds one frame"):
            pypw85.write(tmp_path / name, [system, system])
        with pytest.raises(ValueError, match="the system must be three-dimensional"):
            pypw85.write(tmp_path / name, ellipses)
        with pytest.raises(ValueError, match=f"{models} have different names, but several particles have the same id"):
            pypw85.write(tmp_path / name, doubled)
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(not (os.environ.get("PYPW85_FORMATS") and shutil.which("npm")), reason="needs PYPW85_FORMATS, and npm to get MuJoCo")
def test_mujoco(tmp_path, rng):
    """MuJoCo computes the same ellipsoids and tensors from the file; it turns and sorts the axes of inertia."""
    options = ["--silent", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix", str(tmp_path)]
    subprocess.run(["npm", "install", *options, f"@mujoco/mujoco@{VERSION}"], check=True)
    (tmp_path / "model.mjs").write_text(MODEL)
    system = bodies(rng)
    pypw85.write(tmp_path / "a.xml", system)
    text = subprocess.run(["node", "model.mjs", "a.xml"], cwd=tmp_path, check=True, stdout=subprocess.PIPE, text=True).stdout
    model = {key: np.array(values) for key, values in json.loads(text).items()}
    check(system, model["mass"], model["inertia"].reshape(-1, 3), model["frame"].reshape(-1, 3, 3), model["size"].reshape(-1, 3),
          model["turn"].reshape(-1, 3, 3), model["center"].reshape(-1, 3))
    np.testing.assert_array_equal(model["own"].reshape(-1, 3), system.centers)
