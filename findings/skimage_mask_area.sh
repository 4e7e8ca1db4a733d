#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The surface area of a body of voxels, by marching cubes, is 7 to 9 % too large, and finer voxels do not help, although the volume within
# the same surface converges. The perimeter of a disc of pixels is 5 % too large at any size.
#
# scikit-image (Debian 12, 0.19.3-8): marching_cubes(mask, 0.5) and mesh_surface_area of an ellipsoid, 1 within and 0 outside; its distances as
# a picture of grey values (draw.ellipsoid with levelset=True); and the mask after gaussian(mask, 1). Divided by the true area
# (Carlson's R_G), or the true volume, seen on 1 December 2026:
#
#   semi-axes     mask, area   its volume   grey values, area   mask after gaussian, area
#   8  16  24     1.074        0.988        0.998               0.984
#   16 32  48     1.083        0.997        0.999               0.999
#   32 64  96     1.086        0.999        1.000               1.003
#
#   disc of radius   perimeter   perimeter_crofton
#   20               1.049       1.016
#   80               1.054       1.005
#
# The triangles of a mask have 26 normals, whatever the size of the voxels: steps become smaller, but not flatter. Sphericities of balls
# come out 8 % too small. An ellipsoid fitted by the moments of the voxels has no such error.
# draw.ellipsoid_stats has the true area, except that it divides by zero for a ball.
# Needs python3 with NumPy and SciPy, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q python3-skimage=0.19.3-8 python3-skimage-lib=0.19.3-8+b1 >/dev/null 2>&1
for package in python3-skimage*.deb; do dpkg -x "$package" .; done
cat >check.py <<'END'
import warnings

import numpy as np
from scipy.special import elliprg

warnings.simplefilter("ignore")
from skimage.draw import ellipsoid, ellipsoid_stats  # noqa: E402
from skimage.filters import gaussian  # noqa: E402
from skimage.measure import marching_cubes, mesh_surface_area, perimeter, perimeter_crofton  # noqa: E402


def measured(picture, level, axes):
    """Area and volume, divided by those of the ellipsoid, and the number of directions of the triangles."""
    p, faces = marching_cubes(picture, level)[:2]
    corners = p[faces].astype(float)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    directions = np.unique((normals[lengths > 0] / lengths[lengths > 0, None]).round(3) + 0.0, axis=0)
    volume = abs(np.einsum("ij,ij", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))) / 6
    a, b, c = axes
    area = 4 * np.pi * a * b * c * elliprg(a**-2, b**-2, c**-2)
    return mesh_surface_area(p, faces) / area, volume / (4 / 3 * np.pi * a * b * c), len(directions)


for size, expected in ((8, (1.074, 0.988, 0.998, 0.984)), (16, (1.083, 0.997, 0.999, 0.999)), (32, (1.086, 0.999, 1, 1.003))):
    axes = np.array([1.0, 2, 3]) * size
    mask = np.pad(ellipsoid(*axes).astype(float), 4)
    of_mask = measured(mask, 0.5, axes)
    grey = measured(ellipsoid(*axes, levelset=True), 0, axes)
    smooth = measured(gaussian(mask, 1), 0.5, axes)
    print(axes, "mask: area, volume, directions", of_mask, "grey values", grey, "gaussian", smooth)
    assert of_mask[2] == 26
    assert np.allclose((of_mask[0], of_mask[1], grey[0], smooth[0]), expected, atol=1e-3)

for radius, expected in ((20, (1.049, 1.016)), (80, (1.054, 1.005))):
    y, x = np.mgrid[-radius - 3 : radius + 4, -radius - 3 : radius + 4]
    disc = x * x + y * y <= radius * radius
    found = [measure(disc) / (2 * np.pi * radius) for measure in (perimeter, perimeter_crofton)]
    print(radius, "perimeters", found)
    assert np.allclose(found, expected, atol=1e-3)

assert np.isclose(ellipsoid_stats(1, 2, 3)[1], 4 * np.pi * 6 * elliprg(1, 1 / 4, 1 / 9))
try:
    ellipsoid_stats(1, 1, 1)
except ZeroDivisionError as error:
    print("ball:", error)
else:
    raise AssertionError("the ball has an area")
END
PYTHONPATH="$dir/usr/lib/python3/dist-packages" /usr/bin/python3 check.py
