#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The surface vtkSuperquadricSource with the scale (1, 2, 3) has the semi-axes 1, 3, 2, and vtkSuperquadric, the implicit function with the
# same parameters, has 1, 2, 3: the function says that some points of the surface are inside the body, and others outside.
#
# VTK 9.1.0 (Debian 12, 9.1.0+really9.1.0+dfsg2-5+deb12u1). Both classes say that the scale acts "in x, y, and z". Roundness 1 in both
# directions, which is an ellipsoid, and size 1; values of the function at the points of the surface are 0 on the body. Seen on
# 1 December 2026:
#
#   AxisOfSymmetry      scale     extents of the surface   values of vtkSuperquadric with the scale (1, 2, 3)
#   1 (y, the default)  1, 2, 3   1, 3, 2                  -0.56 to 1.25
#   0 (x)               1, 2, 3   3, 2, 1                  -0.89 to 8
#   2 (z)               1, 2, 3   1, 2, 3                  0
#   1 (y, the default)  1, 3, 2   1, 2, 3                  0
#
# The source makes a body about z and then exchanges coordinates, which carries the scale along, but not the centre. The function is always
# about y. For superquadrics that are no ellipsoids, PhiRoundness 0.3 or ThetaRoundness 0.3, the axis decides on the shape as well: both
# agree if the scale of the source has its last two numbers exchanged and the axis is y; with the axis z the extents agree and the shapes do
# not.
# Needs apt-get and python3-numpy.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
missing=$(apt-get install -s --no-install-recommends python3-vtk9=$version 2>/dev/null | awk '/^Inst/ { print $2 }')
# shellcheck disable=SC2086 # a list of words
apt-get download -qq python3-vtk9=$version libvtk9.1=$version libvtk9.1-qt=$version $missing 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
LD_LIBRARY_PATH=usr/lib/x86_64-linux-gnu PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 - <<'EOF'
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkSuperquadric
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource

CENTRE, AXES = np.array([10, 20, 30]), np.array([1, 2, 3])


def give(body, scale, phi, theta):
    body.SetCenter(CENTRE)
    body.SetSize(1)
    body.SetScale(scale)
    body.SetPhiRoundness(phi)
    body.SetThetaRoundness(theta)
    return body


def surface(scale, axis=None, phi=1, theta=1):
    """Points of the surface from its centre."""
    source = give(vtkSuperquadricSource(), scale, phi, theta)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    if axis is not None:
        source.SetAxisOfSymmetry(axis)
    source.Update()
    p = vtk_to_numpy(source.GetOutput().GetPoints().GetData()).astype(float)
    assert np.allclose((p.max(axis=0) + p.min(axis=0)) / 2, CENTRE, atol=1e-5)
    return p - CENTRE


def values(p, phi=1, theta=1):
    """Least and largest value of the implicit function."""
    function = give(vtkSuperquadric(), AXES, phi, theta)
    v = [function.EvaluateFunction(x) for x in p + CENTRE]
    return min(v), max(v)


def is_about(axis, p, phi, theta):
    """Whether points are on the superquadric with the semi-axes 1, 2, 3 about this axis, by its formula."""
    u = np.abs(p) / AXES
    v, w = np.delete(u, axis, axis=1).T
    return np.allclose((v ** (2 / theta) + w ** (2 / theta)) ** (theta / phi) + u[:, axis] ** (2 / phi), 1, atol=1e-3)


print(vtkVersion.GetVTKVersion())
assert vtkSuperquadricSource().GetSize() == 0.5
for axis, scale, extents, least, most in (
    (None, (1, 2, 3), (1, 3, 2), -0.556, 1.25),
    (0, (1, 2, 3), (3, 2, 1), -0.889, 8),
    (2, (1, 2, 3), (1, 2, 3), 0, 0),
    (None, (1, 3, 2), (1, 2, 3), 0, 0),
):
    p = surface(scale, axis)
    print("axis", axis, "scale", scale, "extents", np.abs(p).max(axis=0), "function", values(p))
    assert np.allclose(np.abs(p).max(axis=0), extents, atol=1e-5)
    assert np.allclose(((p / extents) ** 2).sum(axis=1), 1, atol=1e-5)
    assert np.allclose(values(p), (least, most), atol=1e-3)

for phi, theta in ((0.3, 1), (1, 0.3)):
    about_y, about_z = surface((1, 3, 2), None, phi, theta), surface((1, 2, 3), 2, phi, theta)
    print("roundness", phi, theta, "about y", values(about_y, phi, theta), "about z", values(about_z, phi, theta))
    assert is_about(1, about_y, phi, theta) and np.allclose(values(about_y, phi, theta), 0, atol=1e-3)
    assert is_about(2, about_z, phi, theta) and values(about_z, phi, theta)[1] > 0.5
    assert np.allclose(np.abs(about_z).max(axis=0), AXES, atol=1e-5)
EOF
