#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A data file of LAMMPS whose section says "Atoms # ellipsoid" is read as a file of the style full, without a warning: the flag of
# ellipsoids becomes the type of the atoms, the type becomes the molecule, and the density becomes the charge.
#
# The columns of atom_style ellipsoid are id type ellipsoidflag density x y z, those of full are id molecule type charge x y z: seven in
# both. LAMMPS writes the style behind Atoms (write_data).
# ASE 3.22.1 (Debian 12, 3.22.1-3+deb12u1): atoms of the types 3 and 2 with densities 5 and 7 have type [1, 1], mol-id [3, 2] and
# initial_charges [5, 7]; it has no style for ellipsoids. MDAnalysis 2.4.2 (2.4.2+dfsg1-1+b1): types ['1', '1'], resids [3, 2],
# charges [5, 7]; with atom_style="id type ellipsoid density x y z" the types are ['3', '2'], and there are no charges.
# Positions are right in all cases.
# Needs apt-get, python3-numpy, python3-scipy, python3-matplotlib and python3-tqdm.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq python3-ase=3.22.1-3+deb12u1 python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-biopython python3-citeproc \
  python3-duecredit python3-fasteners python3-griddataformats python3-joblib python3-mmtf python3-monotonic python3-mrcfile \
  python3-msgpack python3-networkx python3-threadpoolctl 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >a.data <<'EOF'
two ellipsoids of the types 3 and 2, densities 5 and 7

2 atoms
2 ellipsoids
3 atom types
0 10 xlo xhi
0 10 ylo yhi
0 10 zlo zhi

Atoms # ellipsoid

1 3 1 5.0 1 2 3
2 2 1 7.0 4 5 6

Ellipsoids

1 1 1 3 1 0 0 0
2 1 1 3 1 0 0 0
EOF
PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 -W ignore - <<'EOF'
import ase
import MDAnalysis
from ase.io import read

arrays = read("a.data", format="lammps-data").arrays
seen = {name: arrays[name].tolist() for name in ("type", "mol-id", "initial_charges")}
print("ASE", ase.__version__, seen)
atoms = MDAnalysis.Universe("a.data", format="DATA").atoms
said = MDAnalysis.Universe("a.data", format="DATA", atom_style="id type ellipsoid density x y z").atoms
print("MDAnalysis", MDAnalysis.__version__, atoms.types.tolist(), atoms.resids.tolist(), atoms.charges.tolist(), said.types.tolist())
assert (ase.__version__, MDAnalysis.__version__) == ("3.22.1", "2.4.2")
assert seen == {"type": [1, 1], "mol-id": [3, 2], "initial_charges": [5.0, 7.0]}
assert (atoms.types.tolist(), atoms.resids.tolist(), atoms.charges.tolist()) == (["1", "1"], [3, 2], [5.0, 7.0])
assert said.types.tolist() == ["3", "2"] and not hasattr(said, "charges")
EOF
