#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Ellipses that are not parallel to the axes are drawn as other ellipses, unless the scales of x and y are equal. No choice of "units"
# helps. Lengths are whole axes.
#
# gnuplot 5.4.4 (Debian 12, gnuplot-nox 5.4.4+dfsg1-2+b2), "plot ... with ellipses" of the line 5 5 6 2 45: centre, lengths and angle in
# degrees. An ellipse with the semi-axes 3 and 1 at 45 degrees reaches 2.236 = sqrt(5) from its centre along x and along y. Seen on
# 30 November 2026, in the units of the axes x and y, on a picture of 600 by 300 for 10 by 10:
#
#   units xy, the default          2.151 along x, 4.301 along y
#   units xx                       2.236          4.472
#   units yy                       1.118          2.236
#   with "set size ratio -1"       2.236          2.236
#
# Angles are those on the paper, and each length is measured along one axis of the plot before it is turned. So ellipses that are free of
# overlaps overlap in the picture. The documentation says that the ratio of the axes is not correct after rotation.
# Needs apt-get, dpkg and python3.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
version=5.4.4+dfsg1-2+b2
missing=$(apt-get install -s --no-install-recommends gnuplot-nox=$version 2>/dev/null | awk '/^Inst/ { print $2 }' | grep -v aglfn || true)
# shellcheck disable=SC2086 # a list of words
apt-get download -qq gnuplot-nox=$version $missing 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.py <<'EOF'
import re
import subprocess
import sys

EXPECTED = {"units xy": (2.151, 4.301), "units xx": (2.236, 4.472), "units yy": (1.118, 2.236), "": (2.151, 4.301), "equal": (2.236, 2.236)}


def extents(name):
    """How far the drawn outline reaches from its middle along x and y, in the units of the axes. The plot has 10 by 10 of them, and fills
    the picture; with equal scales it is the square of 300 by 300 in its middle."""
    equal = name == "equal"
    commands = f"""set terminal svg size 600,300; set output '{name}.svg'; set xrange [0:10]; set yrange [0:10]
        unset key; unset border; unset tics; set margins 0,0,0,0; {'set size ratio -1' if equal else ''}
        $one << E\n5 5 6 2 45\nE\nplot $one using 1:2:3:4:5 with ellipses {'' if equal else name} fill empty"""
    subprocess.run(["usr/bin/gnuplot-nox", "-"], input=commands, text=True, check=True)
    with open(f"{name}.svg", encoding="utf-8") as file:
        outlines = [re.findall(r"(-?[\d.]+),(-?[\d.]+)", path) for path in re.findall(r"<path[^>]* d='(M[^']*)'", file.read())]
    outline = max(outlines, key=len)
    x, y = ([float(point[axis]) for point in outline] for axis in (0, 1))
    return (max(x) - min(x)) / 2 / (30 if equal else 60), (max(y) - min(y)) / 2 / 30


wrong = False
for name, expected in EXPECTED.items():
    found = extents(name)
    print(f"{name or 'the default':12} {found[0]:.3f} along x, {found[1]:.3f} along y")
    wrong |= any(abs(f - e) > 0.02 * e for f, e in zip(found, expected))
sys.exit(wrong)
EOF
LD_LIBRARY_PATH="$dir/usr/lib/x86_64-linux-gnu" /usr/bin/python3 check.py
