#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A valid H5MD file without times is not read: KeyError. The specification (H5MD 1.1) says that time is optional.
#
# MDAnalysis 2.4.2 (Debian 12, 2.4.2+dfsg1-1+b1) and h5py. With the data set "time" beside "step", the same file is read; without units in the
# file, only with convert_units=False.
# Needs apt-get, python3-h5py, python3-numpy, python3-scipy, python3-matplotlib, python3-tqdm and python3-gsd.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-biopython python3-citeproc python3-duecredit python3-fasteners \
  python3-griddataformats python3-joblib python3-mmtf python3-monotonic python3-mrcfile python3-msgpack python3-networkx \
  python3-threadpoolctl 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 -W ignore - <<'EOF'
import h5py
import MDAnalysis
import numpy as np


def outcome(path, has_time, **options):
    with h5py.File(path, "w") as file:
        h5md = file.create_group("h5md")
        h5md.attrs["version"] = (1, 1)
        h5md.create_group("author").attrs["name"] = "nobody"
        h5md.create_group("creator").attrs.update(name="hand", version="1")
        box = file.create_group("particles/all/box")
        box.attrs.update(dimension=3, boundary=np.array([b"periodic"] * 3))
        elements = {"position": np.array([[[1.0, 2, 3], [4, 5, 6]]]), "box/edges": 9 * np.eye(3)[None]}
        for name, values in elements.items():
            element = file.create_group(f"particles/all/{name}")
            element["value"], element["step"] = values, [7]
            if has_time:
                element["time"] = [0.5]
    universe = MDAnalysis.Universe.empty(2, trajectory=False)
    try:
        universe.load_new(path, format="H5MD", **options)
    except (KeyError, ValueError) as error:
        return type(error).__name__
    return universe.atoms.positions.tolist()


seen = [outcome("none.h5", False, convert_units=False), outcome("time.h5", True, convert_units=False), outcome("units.h5", True)]
print(MDAnalysis.__version__, seen)
assert seen == ["KeyError", [[1, 2, 3], [4, 5, 6]], "ValueError"]
EOF
