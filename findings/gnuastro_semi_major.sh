#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The column SEMI_MAJOR of Gnuastro's catalogues, which says "semi-major axis", is half the semi-major axis of a uniform ellipse.
#
# astmkcatalog (Debian 12, 0.19-1+b2) on a labelled ellipse of semi-axes 24 and 8 that is turned by 30 degrees from x towards y writes:
#   # Column 4: SEMI_MAJOR     [pixel  ,f32,] Flux weighted semi-major axis.
#   ... 11.915 ... 4.015 ... 29.987 ...
# These are standard deviations along the axes; the help of --semimajor says "RMS along major axis". GEO_SEMI_MAJOR, "Geometric semi-major
# axis", is the same. POSITION_ANGLE is counted from the first axis of the picture, not from north. Who draws, or matches with photometry
# by apertures of these semi-axes, has a quarter of the area.
# Needs python3 with NumPy, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q gnuastro=0.19-1+b2 libgnuastro17=0.19-1+b2 libcfitsio10 libgsl27 libgslcblas0 libwcs7 >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done
LD_LIBRARY_PATH=$(dirname "$(find "$dir/usr/lib" -name 'libgnuastro.so.17')")
export LD_LIBRARY_PATH
PATH=$dir/usr/bin:$PATH
mv etc .gnuastro # where its programs look for their configuration
/usr/bin/python3 - <<'EOF2'
import numpy as np

y, x = np.mgrid[:130, :150]
c, s = np.cos(np.radians(30)), np.sin(np.radians(30))
u, v = c * (x - 70) + s * (y - 60), -s * (x - 70) + c * (y - 60)
np.savetxt("a.txt", ((u / 24) ** 2 + (v / 8) ** 2 <= 1).astype(int), fmt="%d")
EOF2
astconvertt a.txt --output=a.fits
astarithmetic a.fits int32 -g1 --output=labels.fits >/dev/null
astmkcatalog labels.fits --hdu=1 --valuesfile=a.fits --valueshdu=1 --ids --x --y --semimajor --semiminor --positionangle --geosemimajor \
  --area --output=cat.txt --tableformat=txt >/dev/null
grep -E 'Column [47]:.*[Ss]emi-major axis' cat.txt
/usr/bin/python3 - <<'EOF2'
import numpy as np

_, x, y, a, b, angle, geo, area = np.loadtxt("cat.txt")
print(f"SEMI_MAJOR {a}, SEMI_MINOR {b}, GEO_SEMI_MAJOR {geo}, POSITION_ANGLE {angle}; pi a b {np.pi * a * b:.0f} of {area:.0f} pixels")
assert abs(a - 12) < 0.1 and abs(b - 4) < 0.1 and abs(geo - 12) < 0.1 and abs(angle - 30) < 0.5
EOF2
