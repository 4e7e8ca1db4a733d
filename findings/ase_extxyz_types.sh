#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Extended XYZ with the types 1 and 2 in its column species cannot be read: KeyError. The same column under the
# name type is read, but all atoms become element 0.
#
# ASE 3.22.1 (Debian 12, 3.22.1-3+deb12u1): the names are looked up among the symbols of chemical elements, after the first letter was made a
# capital: "rod" ends with KeyError: 'Rod', 1 with KeyError: '1', and neither the file nor the line is named. "X" is element 0.
# Needs apt-get, python3-numpy, python3-scipy and python3-matplotlib.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq python3-ase=3.22.1-3+deb12u1 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 -W ignore - <<'EOF'
import io

import ase
from ase.io import read


def outcome(name, column="species:S:1"):
    text = f"1\nProperties={column}:pos:R:3\n{name} 0 0 0\n"
    try:
        return read(io.StringIO(text), format="extxyz").get_atomic_numbers().tolist()
    except KeyError as error:
        return f"KeyError: {error}"


seen = {name: outcome(name) for name in ("1", "rod", "he", "X")} | {"type": outcome("1", "type:I:1")}
print(ase.__version__, seen)
assert ase.__version__ == "3.22.1"
assert seen == {"1": "KeyError: '1'", "rod": "KeyError: 'Rod'", "he": [2], "X": [0], "type": [0]}
EOF
