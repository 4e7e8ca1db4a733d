#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The lengths a and b of sep.extract are half the semi-axes of a uniform ellipse, and its ellipse of these lengths holds a quarter of it.
#
# sep (Debian 12, 1.2.1-6+b2) on a picture whose pixels are 100 within an ellipse of semi-axes 24 and 8, turned by 30 degrees from x to y:
#   a 11.91, b 4.01, theta 0.5234 (radians)
# They are standard deviations along the axes, as A_IMAGE of SExtractor. The area pi a b is 150 pixels, and the ellipse has 601.
# If a and b are used as semi-axes, ellipses have half their size.
# Needs python3 with NumPy, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q python3-sep=1.2.1-6+b2 libsep0=1.2.1-6+b2 >/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.py <<'EOF'
import numpy as np
import sep

y, x = np.mgrid[:130, :150]
c, s = np.cos(np.radians(30)), np.sin(np.radians(30))
u, v = c * (x - 70) + s * (y - 60), -s * (x - 70) + c * (y - 60)
inside = (u / 24) ** 2 + (v / 8) ** 2 <= 1
found = sep.extract(100.0 * inside, 50.0, filter_kernel=None, deblend_cont=1.0)
assert len(found) == 1, found
a, b, theta = (float(found[name][0]) for name in ("a", "b", "theta"))
print(f"a {a:.2f}, b {b:.2f}, theta {theta:.4f}; pi a b {np.pi * a * b:.0f} of {inside.sum()} pixels")
assert abs(a - 12) < 0.1 and abs(b - 4) < 0.1 and abs(theta - np.radians(30)) < 0.01
EOF
LD_LIBRARY_PATH=$(echo "$dir"/usr/lib/*-linux-gnu) PYTHONPATH="$dir/usr/lib/python3/dist-packages" /usr/bin/python3 check.py
