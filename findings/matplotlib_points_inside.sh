#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# An ellipse that is drawn as an outline contains points outside it: half the width of the line, a length on paper, is added to it in the
# unit of the data. A small ellipse contains 17 times its area. A filled one without an outline is right.
#
# matplotlib 3.6.3 (Debian 12, python3-matplotlib 3.6.3-1+b1), matplotlib.patches.Ellipse, contains_points, "whether the given points are
# inside the patch". The area is the part of 200,000 random points, divided by the true area; an ellipse with the semi-axes (3, 1) times the
# size, which was added to no axes, so that the coordinates are its own. The line is 1 wide by default. Seen on 1 December 2026:
#
#   size   filled, no line   fill=False or edgecolor="k"   fill=False, radius=0   reaches along x, y for fill=False, in its size
#   10     1.00              1.07                          1.00                   3.05, 1.05
#   1      1.00              1.79                          1.00                   3.54, 1.50
#   0.1    0.99              16.8                          0.99                   8.39, 6.00
#
# Without the argument radius, the width of the line is taken for it if the patch has a line, and half of it counts: the area is that
# within the parallel curve 1/2 away (1.07, 1.79, 16.4), but for a corner at each tip. So whether a point is inside depends on the unit of
# length and on colours. In axes the same calls take pixels: the point (0, 0) is then the corner of the picture. Pass radius=0.
# Needs apt-get, python3-numpy, python3-scipy and the modules on which matplotlib depends.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q python3-matplotlib=3.6.3-1+b1 python-matplotlib-data=3.6.3-1 >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done
cat >check.py <<'END'
import sys

import matplotlib
import numpy as np

assert matplotlib.__file__.startswith(sys.argv[1]), matplotlib.__file__
matplotlib.use("Agg")
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.patches import Ellipse  # noqa: E402
from scipy.special import ellipe  # noqa: E402

unit = np.random.default_rng(1).uniform(-1, 1, (200000, 2))
print(matplotlib.__version__)


def measured(size, radius=None, **look):
    """The area divided by the true one, and how far the ellipse reaches along x and y, in its size."""
    ellipse = Ellipse((0, 0), 6 * size, 2 * size, **look)
    assert look or ellipse.get_linewidth() == 1
    side = 4 * size + 1
    area = np.mean(ellipse.contains_points(side * unit, radius)) * (2 * side) ** 2
    steps = np.linspace(0, side, 4001)
    along = [steps[ellipse.contains_points(np.outer(steps, axis), radius)].max() / size for axis in ((1, 0), (0, 1))]
    return area / (np.pi * 3 * size**2), *along


perimeter = 4 * 3 * ellipe(1 - 1 / 9)
for size in (10, 1, 0.1):
    filled, outline = measured(size), measured(size, fill=False)
    edge, mended = measured(size, edgecolor="k"), measured(size, radius=0, fill=False)
    parallel = 1 + (perimeter * size / 2 + np.pi / 4) / (np.pi * 3 * size**2)  # Steiner's formula for the distance 1/2
    print(size, "filled", filled, "outline", outline, "parallel curve", parallel, "outline, radius=0", mended)
    # A part p of n points varies by sqrt((1 - p)/(p n)), relative: by 0.02 for the smallest ellipse, p = 0.012, and below 0.01 for others.
    assert abs(filled[0] - 1) < 0.1 and abs(mended[0] - 1) < 0.1 and outline == edge
    assert abs(outline[0] / parallel - 1) < 0.05
    assert np.allclose(filled[1:], (3, 1), atol=0.01) and np.allclose(mended[1:], (3, 1), atol=0.01)
    assert np.allclose(outline[1:], (3 + 0.5 / size, 1 + 0.5 / size), rtol=0.06)

turned = Ellipse((0, 0), 6, 2, angle=30)
assert turned.contains_point((2.5, 1.44)) and not turned.contains_point((2.5, -1.44))

axes = Figure().add_subplot()
axes.set(xlim=(-5, 5), ylim=(-5, 5))
ellipse = axes.add_patch(Ellipse((0, 0), 6, 2))
in_axes = ellipse.contains_point((0, 0)), ellipse.contains_point(axes.transData.transform((0, 0)))
print("in axes", in_axes)
assert in_axes == (False, True)
END
PYTHONPATH="$dir/usr/lib/python3/dist-packages" /usr/bin/python3 check.py "$dir"
