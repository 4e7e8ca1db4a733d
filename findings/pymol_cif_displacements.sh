#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Displacement ellipsoids of a crystal that is read from a CIF file are drawn in the wrong axes, unless all angles of the cell are right ones:
# an atom that moves alike in all directions becomes an ellipsoid. A PDB file that is saved from it has the wrong tensor, too.
#
# PyMOL 2.5.0 (Debian 12, python3-pymol 2.5.0+dfsg-1+b3). Its log of changes says: "ellipsoid representation (show ellipsoid, if ANISOU
# provided)"; records ANISOU are in Cartesian axes. U_11 ... U_23 of CIF refer to the axes of the cell, by its dictionary. The reader makes
# the coordinates Cartesian ("Detected small molecule CIF"), but copies the six numbers. An atom with displacements of 0.2 in all directions
# (U = 0.04), in a cell 10, 10, 10 with the angles 90, 90, gamma, where U_12 is 0.02 or 0; seen on 30 November 2026:
#
#                          gamma = 120                       gamma = 90
#   u_aniso                0.04 0.04 0.04 0.02 0 0           0.04 0.04 0.04 0 0 0
#   its mean squares       0.06 0.04 0.02                    0.04 0.04 0.04
#   ANISOU that it saves   400 400 400 200 0 0               400 400 400 0 0 0
#   outline, ray-traced    1.74 times as long as wide        a circle
#   true                   0.04 0.04 0.04, a circle          the same
#
# From a PDB file of the same atom, 400 400 400 0 0 0, it draws the circle in both cells. Cartesian is A N U N A', where A turns fractional
# coordinates into Cartesian ones and N = diag(a*, b*, c*).
# Needs python3 with NumPy and Matplotlib, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
missing=$(apt-get install -s --no-install-recommends python3-pymol=2.5.0+dfsg-1+b3 2>/dev/null | awk '/^Inst/ && !/pymol/ { print $2 }')
# shellcheck disable=SC2086 # a list of words
apt-get download -qq python3-pymol=2.5.0+dfsg-1+b3 pymol-data=2.5.0+dfsg-1 $missing 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.py <<'EOP'
import math

import matplotlib.image
import numpy as np
from pymol import cmd

CELL = """data_one
_cell_length_a 10
_cell_length_b 10
_cell_length_c 10
_cell_angle_alpha 90
_cell_angle_beta 90
_cell_angle_gamma {gamma}
_symmetry_space_group_name_H-M 'P 1'
loop_
_atom_site_label
_atom_site_type_symbol
_atom_site_fract_x
_atom_site_fract_y
_atom_site_fract_z
C1 C 0 0 0
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
PDB = """CRYST1   10.000   10.000   10.000  90.00  90.00 {gamma:6.2f} P 1           1
ATOM      1  C1  LIG A   1       0.000   0.000   0.000  1.00  3.16           C
ANISOU    1  C1  LIG A   1      400    400    400      0      0      0       C
END
"""


def matrix(u):
    return np.array([[u[0], u[3], u[4]], [u[3], u[1], u[5]], [u[4], u[5], u[2]]])


def aspect():
    """Length of the ray-traced outline divided by its width, from its second moments."""
    cmd.hide("everything")
    cmd.show("ellipsoids")
    cmd.set("orthoscopic", 1)
    cmd.set("ray_opaque_background", 0)
    cmd.set("antialias", 0)
    cmd.zoom("all", 0.1)
    cmd.png("one.png", width=600, height=600, ray=1, quiet=1)
    y, x = np.nonzero(matplotlib.image.imread("one.png")[:, :, 3] > 0.5)
    assert len(x) > 1000, len(x)
    low, high = np.linalg.eigvalsh(np.cov(x, y))
    return math.sqrt(high / low)


def read(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)
    cmd.delete("all")
    cmd.load(name, "one")
    return cmd.get_model("one").atom[0].u_aniso


def cartesian(u, gamma):
    """A N U N A' for a = b = c = 10 and two right angles."""
    c, s = math.cos(math.radians(gamma)), math.sin(math.radians(gamma))
    a = 10 * np.array([[1, c, 0], [0, s, 0], [0, 0, 1]])
    an = a @ np.diag(np.linalg.norm(np.linalg.inv(a), axis=1))
    return an @ u @ an.T


version = cmd.get_version()[0]
for gamma, expected, u12 in ((90, [0.04, 0.04, 0.04], 0), (120, [0.02, 0.04, 0.06], 0.02)):
    u = read("one.cif", CELL.format(gamma=gamma, u12=u12))
    of_cif = aspect()
    cmd.save("saved.pdb")
    with open("saved.pdb", encoding="utf-8") as file:
        saved = [int(word) for line in file if line.startswith("ANISOU") for word in line[28:70].split()]
    squares, true = np.linalg.eigvalsh(matrix(u)), np.linalg.eigvalsh(cartesian(matrix(u), gamma))
    of_pdb = np.linalg.eigvalsh(matrix(read("one.pdb", PDB.format(gamma=gamma))))
    print(f"PyMOL {version}, gamma {gamma}: mean squares {squares.round(4)}, ANISOU {saved}, outline {of_cif:.2f}; true {true.round(4)}")
    assert np.allclose(squares, expected, atol=1e-6) and np.allclose(true, 0.04, atol=1e-6) and np.allclose(of_pdb, 0.04, atol=1e-6)
    assert saved == [400, 400, 400, round(1e4 * u12), 0, 0]
    assert abs(of_cif - math.sqrt(expected[2] / expected[0])) < 0.03 and abs(aspect() - 1) < 0.01
EOP
LD_LIBRARY_PATH=$dir/usr/lib/x86_64-linux-gnu PYTHONPATH=$dir/usr/lib/python3/dist-packages /usr/bin/python3 check.py
