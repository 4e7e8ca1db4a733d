#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# meshio ignores z in a text PLY file if another property of the vertices is between y and z.
#
# meshio (Debian 12, python3-meshio 7.0.0-3): in text files x, y and z are coordinates only if they are the first, second and third
# property. The same vertices in a binary file are read by their names:
#   x y z      text (4, 3), binary (4, 3)
#   x y red z  text (4, 2), binary (4, 3)
# A reader that pads points of two coordinates with 0, as those of plane meshes, flattens the mesh.
# Needs python3 with NumPy and rich, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q python3-meshio=7.0.0-3 >/dev/null
dpkg -x python3-meshio_*.deb .
cat >check.py <<'EOF'
import io

import meshio
import numpy as np

corners = {"x": [0, 2, 2, 0], "y": [0, 0, 1, 1], "z": [0, 0, 1, 1], "red": [9, 9, 9, 9]}
for names, wanted in (("x y z", 3), ("x y red z", 2)):
    rows = np.array([corners[name] for name in names.split()], "<f4").T
    shapes = []
    for kind in ("ascii", "binary_little_endian"):
        header = f"ply\nformat {kind} 1.0\nelement vertex 4\n" + "".join(f"property float {name}\n" for name in names.split())
        header += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        text = "".join(" ".join(f"{number:g}" for number in row) + "\n" for row in rows) + "4 0 1 2 3\n"
        data = text.encode() if kind == "ascii" else rows.tobytes() + b"\4" + np.arange(4, dtype="<i4").tobytes()
        shapes.append(meshio.read(io.BytesIO(header.encode() + data), file_format="ply").points.shape)
    print(f"{names:10} text {shapes[0]}, binary {shapes[1]}")
    assert shapes == [(4, wanted), (4, 3)], shapes
EOF
PYTHONPATH="$dir/usr/lib/python3/dist-packages" /usr/bin/python3 check.py
