#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The reader of GSD files takes tilt factors of a sheared box for cosines, and those of xy, xz, yz for the angles alpha, beta, gamma.
#
# MDAnalysis 2.4.2 (Debian 12, 2.4.2+dfsg1-1+b1) and GSD files (python3-gsd of the system). A box with edges 10 and the tilts
# xy = 0.5, xz = yz = 0 has the vectors (10, 0, 0), (5, 10, 0), (0, 0, 10): lengths 10, 11.180, 10, alpha = beta = 90, gamma = 63.43.
# MDAnalysis has [10 10 10 60 90 90], the vectors (10, 0, 0), (0, 10, 0), (0, 5, 8.66): another cell, whose volume is 866 instead of 1000.
# A tilt beyond 1, which files may have, becomes NaN. Coordinates are right; distances with the minimum image are not.
# Needs apt-get, python3-numpy, python3-scipy, python3-matplotlib, python3-tqdm and python3-gsd.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-biopython python3-citeproc python3-duecredit python3-fasteners \
  python3-griddataformats python3-joblib python3-mmtf python3-monotonic python3-mrcfile python3-msgpack python3-networkx \
  python3-threadpoolctl 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 -W ignore - <<'EOF'
import gsd.hoomd
import MDAnalysis
import numpy as np

frame = gsd.hoomd.Snapshot()
frame.particles.N = 2
frame.particles.types = ["A"]
frame.particles.typeid = [0, 0]
frame.particles.position = [[0, 0, 0], [1, 1, 1]]
frame.configuration.box = [10, 10, 10, 0.5, 0, 0]
with gsd.hoomd.open("sheared.gsd", "wb") as file:
    file.append(frame)
step = MDAnalysis.Universe("sheared.gsd").trajectory.ts
print(MDAnalysis.__version__, step.dimensions, step.triclinic_dimensions, step.volume)
assert np.allclose(step.dimensions, [10, 10, 10, 60, 90, 90])
assert np.allclose(step.triclinic_dimensions[1], [0, 10, 0]) and abs(step.volume - 866.025) < 1e-2
EOF
