#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The bounding box of an ellipsoid, made as usual by dilating a sphere, reaches twice as far as the body on one side, and 1.7 times as far on
# two others. A search by a box that encloses the ellipsoid with a margin does not find it.
#
# Gmsh 4.8.4 (Debian 12, python3-gmsh 4.8.4+ds2-3) with Open CASCADE 7.6.3: addSphere(0, 0, 0, 1), dilate(...), getBoundingBox, which
# is the same of the model and of its geometry kernel. Seen on 30 November 2026:
#
#   dilated by   x from, to    y from, to         z from, to    volume / true one
#   nothing      -1  1         -1      1          -1  1         1
#   1, 1, 1      -2  1         -1.732  1.732      -1  1         0.99956
#   1, 2, 3      -2  1         -3.464  3.464      -3  3         0.99956
#   3, 1, 1      -6  3         -1.732  1.732      -1  1         0.99956
#
# Dilation, even by equal factors, makes the sphere a surface of splines, and the box is that of its control points. Those of a circle
# about z are on the triangle around it, with one side at x = 1 and a corner at x = -2. getEntitiesInBoundingBox tests this
# box: it finds no ellipsoid (1, 2, 3) within +-(1.9, 3.4, 5). Boxes overlap of bodies with a gap of nearly a semi-axis.
# The mesh is right. After setNumber("Geometry.OCCBoundsUseStl", 1) the box is that of a triangulation, and at most 0.6 % too long.
# The volume and the moments of inertia are by numerical integration: moments divided by the mass are up to 0.6 % off.
# Needs apt-get, python3-numpy and the libraries on which Gmsh depends.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
version=4.8.4+ds2-3
missing=$(apt-get install -s --no-install-recommends python3-gmsh=$version 2>/dev/null | awk '/^Inst/ { print $2 }' | grep -v gmsh || true)
# shellcheck disable=SC2086 # a list of words
apt-get download -qq python3-gmsh=$version libgmsh4.8=$version $missing 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
libraries=$dir/usr/lib/x86_64-linux-gnu
modules=$dir/usr/lib/python3/dist-packages
ln -s "$libraries/libgmsh.so.4.8" "$modules/libgmsh.so"
export LD_LIBRARY_PATH="$libraries:$libraries/occt" PYTHONPATH="$modules"
/usr/bin/python3 - <<'END'
import gmsh
import numpy as np

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
kernel = gmsh.model.occ


def ellipsoid(axes, triangles=0):
    """Return the number of the body."""
    gmsh.clear()
    gmsh.option.setNumber("Geometry.OCCBoundsUseStl", triangles)
    body = kernel.addSphere(0, 0, 0, 1)
    if axes:
        kernel.dilate([(3, body)], 0, 0, 0, *axes)
    kernel.synchronize()
    return body


def measured(axes, triangles=0):
    """Return the bounding box, the volume and the moments divided by the mass, both in units of the true ones."""
    body, squares = ellipsoid(axes, triangles), np.square(axes or (1, 1, 1))
    box = np.reshape(kernel.getBoundingBox(3, body), (2, 3))
    assert np.array_equal(box.ravel(), gmsh.model.getBoundingBox(3, body))
    mass = kernel.getMass(3, body)
    moments = np.diag(np.reshape(kernel.getMatrixOfInertia(3, body), (3, 3))) / mass
    volume = mass / (4 / 3 * np.pi * np.sqrt(squares.prod()))
    print(axes, box.T.round(4).tolist(), round(volume, 5), (moments * 5 / (squares.sum() - squares)).round(4))
    return box, volume, moments * 5 / (squares.sum() - squares)


box, volume, moments = measured(())
assert np.allclose(box, [[-1] * 3, [1] * 3], atol=1e-6) and abs(volume - 1) < 1e-6 and np.allclose(moments, 1, atol=1e-6)
for axes in (1, 1, 1), (1, 2, 3), (3, 1, 1):
    box, volume, moments = measured(axes)
    assert np.allclose(box / axes, [[-2, -np.sqrt(3), -1], [1, np.sqrt(3), 1]], atol=1e-5)
    assert abs(volume - 0.99956) < 1e-4 and 0.001 < np.abs(moments - 1).max() < 0.007
box, volume, moments = measured((1, 2, 3), triangles=1)
assert np.allclose(box / (1, 2, 3), [[-1] * 3, [1] * 3], atol=0.006)

ellipsoid((1, 2, 3))
assert gmsh.model.getEntitiesInBoundingBox(-1.9, -3.4, -5, 1.9, 3.4, 5, 3) == []
assert len(gmsh.model.getEntitiesInBoundingBox(-2.1, -3.5, -5, 1.9, 3.5, 5, 3)) == 1
gmsh.option.setNumber("Mesh.MeshSizeMax", 0.3)
gmsh.model.mesh.generate(2)
nodes = np.reshape(gmsh.model.mesh.getNodes()[1], (-1, 3)) / (1, 2, 3)
assert np.allclose([nodes.min(0), nodes.max(0)], [[-1] * 3, [1] * 3], atol=0.002)
gmsh.finalize()
END
