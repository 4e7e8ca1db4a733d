#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The orientation of scikit-image's regionprops is measured from the axis of rows (y), not from x, and grows from y towards x.
#
# scikit-image (Debian 12, 0.19.3-8) on an ellipse of semi-axes 24 and 8 whose longer axis is turned by 30 degrees from x (columns)
# towards y (rows, downward):
#   orientation 60.0 degrees, axis_major_length 47.7 (the whole axis)
# An ellipse along x has 90 degrees and one along y 0. CellProfiler 4 hands the same number on, and its manual says that it is
# counted from the axis x. The axes are whole axes, where others write semi-axes.
# Needs python3 with NumPy and SciPy, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q python3-skimage=0.19.3-8 python3-skimage-lib=0.19.3-8+b1 >/dev/null
for package in python3-skimage*.deb; do dpkg -x "$package" .; done
cat >check.py <<'EOF'
import numpy as np
from skimage.measure import regionprops

y, x = np.mgrid[:130, :150]
for degrees, expected in ((30, 60), (-30, -60), (0, 90), (90, 0)):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    u, v = c * (x - 70) + s * (y - 60), -s * (x - 70) + c * (y - 60)
    one = regionprops(((u / 24) ** 2 + (v / 8) ** 2 <= 1).astype(int))[0]
    found = np.degrees(one.orientation)
    print(f"{degrees:4} from x towards y: orientation {found:.1f}, axis_major_length {one.axis_major_length:.1f}")
    assert min(abs(found - expected), abs(abs(found - expected) - 180)) < 0.5
    assert abs(one.axis_major_length - 48) < 0.6
EOF
PYTHONPATH="$dir/usr/lib/python3/dist-packages" /usr/bin/python3 -W ignore check.py
