#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The tensor "aniso" of an atom is in Cartesian axes if it was read as a macromolecule, and in those of the cell if it was read as a small
# molecule. Its eigenvalues are mean squares of displacements in the first case only, and both have the same methods.
#
# gemmi 0.5.7 (Debian 12, python3-gemmi 0.5.7+ds-2+b1). An atom whose displacements are 0.2 in all directions (U = 0.04), in the cell
# 10, 10, 10 with the angles 90, 90, 120. The CIF file has U11 = U22 = U33 = 0.04 and U12 = 0.02, as its dictionary defines them; the PDB
# file has 400 400 400 0 0 0. calculate_eigenvalues(), seen on 30 November 2026:
#
#   read_pdb, Atom.aniso                              0.04 0.04 0.04
#   SmallStructure of the CIF file, Site.aniso        0.06 0.04 0.02
#
# Semi-axes of 0.245, 0.2 and 0.141 instead of a ball; in cells with right angles both agree. Site.aniso becomes Cartesian as A N U N A',
# where A turns fractional coordinates into Cartesian ones (cell.orthogonalization_matrix) and N = diag(a*, b*, c*). The six numbers are
# 11, 22, 33, 12, 13, 23.
# Needs python3 with NumPy, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q python3-gemmi=0.5.7+ds-2+b1 >/dev/null
dpkg -x python3-gemmi*.deb .
cat >check.py <<'EOF'
import gemmi
import numpy as np

CIF = """data_one
_cell_length_a 10
_cell_length_b 10
_cell_length_c 10
_cell_angle_alpha 90
_cell_angle_beta 90
_cell_angle_gamma {gamma}
loop_
_atom_site_label
_atom_site_type_symbol
_atom_site_fract_x
_atom_site_fract_y
_atom_site_fract_z
C1 C 0.1 0.2 0.3
loop_
_atom_site_aniso_label
_atom_site_aniso_U_11
_atom_site_aniso_U_22
_atom_site_aniso_U_33
_atom_site_aniso_U_12
_atom_site_aniso_U_13
_atom_site_aniso_U_23
C1 0.04 0.04 0.04 {u12} 0 0
"""
PDB = """CRYST1   10.000   10.000   10.000  90.00  90.00 120.00 P 1           1
ATOM      1  CA  GLY A   1       0.000   1.732   3.000  1.00  3.16           C
ANISOU    1  CA  GLY A   1      400    400    400      0      0      0       C
END
"""


def small(gamma, u12):
    """The cell and the tensor of the site of the CIF file."""
    text = CIF.format(gamma=gamma, u12=u12)
    structure = gemmi.make_small_structure_from_block(gemmi.cif.read_string(text).sole_block())
    return structure.cell, structure.sites[0].aniso


def cartesian(cell, u):
    star = cell.reciprocal()
    m = np.array(cell.orthogonalization_matrix.tolist()) @ np.diag([star.a, star.b, star.c])
    return m @ np.array(u.as_mat33().tolist()) @ m.T


with open("one.pdb", "w", encoding="utf-8") as file:
    file.write(PDB)
atom = gemmi.read_pdb("one.pdb")[0][0][0][0]
print(gemmi.__version__, "PDB", sorted(atom.aniso.calculate_eigenvalues()), type(atom.aniso).__name__)
assert np.allclose(atom.aniso.calculate_eigenvalues(), 0.04, rtol=1e-6)
cell, u = small(120, 0.02)
print("CIF", sorted(u.calculate_eigenvalues()), type(u).__name__, "in Cartesian axes", np.linalg.eigvalsh(cartesian(cell, u)))
assert np.allclose(sorted(u.calculate_eigenvalues()), [0.02, 0.04, 0.06])
assert np.allclose(np.linalg.eigvalsh(cartesian(cell, u)), 0.04)
cell, u = small(90, 0)
assert np.allclose(u.calculate_eigenvalues(), 0.04)
EOF
PYTHONPATH="$dir/usr/lib/python3/dist-packages" /usr/bin/python3 check.py
