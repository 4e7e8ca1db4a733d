#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Half of all ellipsoids that are drawn as glyphs of symmetric tensors are inverted: their normals point inwards. Tensors of six numbers
# are read in the order xx, yy, zz, xy, yz, xz.
#
# VTK 9.1.0 (Debian 12, 9.1.0+really9.1.0+dfsg2-5+deb12u1), vtkTensorGlyph with a sphere of radius 1. The matrix of eigenvectors has the
# determinant -1 for about half of all tensors. Then triangles are clockwise and normals point inwards. Seen on 29 November 2026:
#
#   tensor           volume by the orientation of the triangles, divided by 8 pi
#   diag(3, 2, 1)    +0.997
#   diag(1, 2, 3)    -0.997, although the ellipsoid is the same but for a rotation
#   200 random rotations of diag(1, 2, 3): 97 are negative
#
# The semi-axes are the eigenvalues (times the radius of the source), not their roots.
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
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTensorGlyph, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource


def glyph(tensor):
    """The points, their normals, and the volume within the triangles, whose sign is that of their orientation."""
    place, source, filter_, triangles = vtkPolyData(), vtkSphereSource(), vtkTensorGlyph(), vtkTriangleFilter()
    points = vtkPoints()
    points.InsertNextPoint(0, 0, 0)
    place.SetPoints(points)
    place.GetPointData().SetTensors(numpy_to_vtk(np.array([tensor], float), deep=True))
    source.SetRadius(1)
    source.SetThetaResolution(60)
    source.SetPhiResolution(61)
    filter_.SetInputData(place)
    filter_.SetSourceConnection(source.GetOutputPort())
    filter_.ColorGlyphsOff()
    triangles.SetInputConnection(filter_.GetOutputPort())
    triangles.Update()
    made = triangles.GetOutput()
    p, n = vtk_to_numpy(made.GetPoints().GetData()).astype(float), vtk_to_numpy(made.GetPointData().GetNormals())
    c = vtk_to_numpy(made.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return p, n, np.einsum("ij,ij", p[c[:, 0]], np.cross(p[c[:, 1]], p[c[:, 2]])) / 6


print(vtkVersion.GetVTKVersion())
for tensor, sign in (((3, 0, 0, 0, 2, 0, 0, 0, 1), 1), ((1, 0, 0, 0, 2, 0, 0, 0, 3), -1)):
    p, n, volume = glyph(tensor)
    print(tensor, volume / (8 * np.pi), "normals point", "out" if (p * n).sum() > 0 else "in")
    assert np.allclose(np.abs(p).max(axis=0), np.diag(np.reshape(tensor, (3, 3))), rtol=2e-3)
    assert abs(sign * volume / (8 * np.pi) - 1) < 0.01 and np.sign((p * n).sum()) == sign

random = np.random.default_rng(1)
rotations = [np.linalg.qr(random.normal(size=(3, 3)))[0] for _ in range(200)]
negative = sum(glyph((r @ np.diag([1, 2, 3]) @ r.T).ravel())[2] < 0 for r in rotations)
print(negative, "of 200 are inside out")
assert 60 < negative < 140

for i, (row, column) in enumerate(((0, 1), (1, 2), (0, 2))):  # xy, yz, xz
    tensor = np.array([1, 2, 3, 0, 0, 0], float)
    tensor[3 + i] = 0.5
    p = glyph(tensor)[0]
    moments = p.T @ p - np.diag(np.diag(p.T @ p))
    print(tensor, "correlates", "xyz"[row] + "xyz"[column])
    assert moments[row, column] > 100 and np.abs(moments).sum() < 2.01 * moments[row, column]
EOF
