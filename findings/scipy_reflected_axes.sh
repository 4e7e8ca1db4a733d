#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The quaternion of an ellipsoid, made of the eigenvectors of its tensor, is that of another orientation for three tensors of ten: their
# eigenvectors are a reflection, which is read as a rotation without a warning.
#
# SciPy 1.10.1 (Debian 12, python3-scipy 1.10.1-2), Rotation.from_matrix(numpy.linalg.eigh(tensor)[1]). The documentation says of the matrix:
# "If the input is not proper orthogonal, an approximation is created". If the columns are axes of the ellipsoid and the determinant is -1, a
# change of sign of any column gives a rotation that describes the same ellipsoid, at the distance 2 (Frobenius) from the matrix, and none is
# nearer. The function returns another one, as near or farther. Seen on 30 November 2026:
#
#   axes of the ellipsoid, one of them reversed    axes of the rotation are off by    distance
#   turned by 30 degrees about z                   30° 30° 0°: those of x, y, z       2
#   before that, by 36.9 degrees about x           30° 46° 37°                        2.0134
#
# Of 1000 tensors with the eigenvalues 1, 4, 9 in random orientations (NumPy 1.24.2), the determinant of the eigenvectors is -1 for 297. The
# longest axis is then off by 3 to 90 degrees, 68 in the median; for the other 703 it is right. Change the sign of one eigenvector where the
# determinant is negative.
# Needs python3 with NumPy, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq python3-scipy=1.10.1-2 2>/dev/null
dpkg -x python3-scipy_*.deb .
cat >check.py <<'EOP'
import numpy as np
import scipy
from scipy.spatial.transform import Rotation


def angles(columns, others):
    """Angles between axes, in degrees; signs do not matter."""
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(columns, others, axis=0), axis=0), np.abs(np.sum(columns * others, axis=0))))


def axes_of(matrix):
    """The rotation's axes, by way of the quaternion x, y, z, w and without SciPy."""
    x, y, z, w = Rotation.from_matrix(matrix).as_quat()
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


c, s = np.sqrt(0.75), 0.5
turned = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
general = turned @ np.array([[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]])
for proper, off, distance in ((turned, [30, 30, 0], 2), (general, [30, 46.15, 36.87], 2.0134)):
    assert angles(axes_of(proper), proper).max() < 1e-6
    for column in range(3):
        signs = np.where(np.arange(3) == column, -1, 1)
        found = axes_of(proper * signs)
        print("reversed", column, "axes off by", angles(found, proper).round(2), "distance", np.linalg.norm(found - proper * signs).round(4))
        assert np.isclose(np.linalg.norm(proper - proper * signs), 2) and np.isclose(np.linalg.det(found), 1)
        assert np.allclose(angles(found, proper), off, atol=0.01)
        assert np.isclose(np.linalg.norm(found - proper * signs), distance, atol=1e-4)

random = np.random.default_rng(0)
right, wrong = [], []
for q in random.normal(size=(1000, 4)):
    w, x, y, z = q / np.linalg.norm(q)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    axes = np.eye(3) + 2 * w * cross + 2 * cross @ cross
    tensor = axes @ np.diag([1, 4, 9]) @ axes.T
    vectors = np.linalg.eigh((tensor + tensor.T) / 2)[1]
    assert angles(vectors, axes).max() < 1e-5
    (right if np.linalg.det(vectors) > 0 else wrong).append(angles(axes_of(vectors), axes))
right, wrong = np.array(right), np.array(wrong)
print(f"SciPy {scipy.__version__}, NumPy {np.__version__}: right {len(right)}, to {right.max():.1g} degrees;", end=" ")
print(f"wrong {len(wrong)}, longest axis by {wrong[:, 2].min():.0f} to {wrong[:, 2].max():.0f}, median {np.median(wrong[:, 2]):.0f} degrees")
assert len(wrong) > 50 and right.max() < 1e-4 and wrong.max(axis=1).min() > 10 and np.median(wrong[:, 2]) > 30
EOP
PYTHONPATH="$dir/usr/lib/python3/dist-packages" /usr/bin/python3 -W error check.py
