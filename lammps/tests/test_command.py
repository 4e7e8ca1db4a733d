# SPDX-License-Identifier: GPL-2.0-only
"""pypw85 reads files that LAMMPS wrote, and finds the same overlaps and contacts as the computes."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import pypw85

from lammps_runs import launch, preamble, random_system, read_dump

SNAPSHOT = """
pair_style zero {cutoff:.17g}
pair_coeff * *
compute overlap all pw85/overlap
compute contact all pw85/contact
compute shape all property/atom shapex shapey shapez quatw quati quatj quatk
dump atoms all custom 1 atoms.dump id type x y z c_shape[*]
dump_modify atoms format float %.17g
dump contacts all local 1 contacts.txt c_contact[*]
dump_modify contacts format float %.17g
thermo_style custom step c_overlap
run 0
print "pairs = $(c_overlap:%.17g)"
write_data written.data nocoeff
"""
CELLS = {
    "orthogonal": np.diag([21.0, 22.0, 23.0]),
    "triclinic": np.array([[21.0, 0, 0], [9.0, 22.0, 0], [-8.0, 7.0, 23.0]]),
}


class Command(unittest.TestCase):
    def check(self, cell, periodic, count=1000):
        system = random_system(7, count, cell, periodic)
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory)
            (folder / "system.data").write_text(system.data_file())
            (folder / "in.lammps").write_text(preamble(system) + SNAPSHOT.format(cutoff=system.cutoff))
            done = launch(folder, 2)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:])
            (contacts,) = read_dump(folder / "contacts.txt")
            dumped = pypw85.read(folder / "atoms.dump", lengths="diameters")
            data = pypw85.read(folder / "written.data")
        self.assertEqual(dumped.periodic, (periodic,) * 3)
        overlaps = dumped.overlaps()
        self.assertGreater(len(overlaps.mu), 500)
        self.assertIn(f"pairs = {len(overlaps.mu)}\n", done.stdout)
        expected = np.sort(np.sqrt(contacts[contacts[:, 2] < 1, 2]))
        np.testing.assert_allclose(overlaps.mu, expected, rtol=1e-9)  # the sorts need no more than the order of magnitude
        # LAMMPS writes data files with 16 digits of positions.
        if periodic:
            np.testing.assert_allclose(data.overlaps().mu, expected, rtol=1e-9)

    def test_boxes(self):
        for name, cell in CELLS.items():
            for periodic in (True, False):
                if periodic or name == "orthogonal":
                    with self.subTest(box=name, periodic=periodic):
                        self.check(cell, periodic)


def lines_after(heading, page):
    """The lines of the page after a heading that are commands."""
    section = page.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return [line[4:] for line in section.splitlines() if line.startswith("    ")]


class Pictures(unittest.TestCase):
    """The lines that docs/lammps.md prints."""

    SCRIPT = """
units lj
atom_style ellipsoid
boundary f f f
include {include}
comm_modify vel yes
region box block 0 6 0 6 0 12
create_box 1 box
pair_style pw85/granular
pair_coeff * * hertz 1e4 1 damping tsuji
fix walls all wall/pw85 box 0 6 0 6 0 12 law hertz 1e4 1 damping tsuji
fix gravity all gravity 1.0 vector 0 0 -1
fix move all nve/asphere
timestep 0.002
region top block 0.8 5.2 0.8 5.2 5 11
fix pour all pw85/pour 60 4711 region top count 20 grain 1 1.0 1.2 1.5
{lines}
run 3000
"""

    def test_lines(self):
        page = (Path(os.environ["PW85_SOURCE"]) / "docs" / "lammps.md").read_text()
        lines = lines_after("Pictures", page)
        commands = [line.split() for line in lines if line.startswith("pw85 ")]
        self.assertEqual([command[1] for command in commands], ["convert", "draw"])
        script = self.SCRIPT.format(include=os.environ["PW85_LAMMPS_INCLUDE"],
                                    lines="\n".join(line for line in lines if not line.startswith("pw85 ")))
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory)
            (folder / "in.lammps").write_text(script)
            done = launch(folder, 2)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:])
            for command in commands:
                subprocess.run([sys.executable, "-m", "pypw85", *command[1:]], cwd=folder, check=True,
                               env={**os.environ, "MPLCONFIGDIR": directory})
            system = list(pypw85.frames(folder / "run.dump", quaternion="xyzw"))[-1]
            self.check_tensors((folder / "run.vtk").read_text(), system)
            self.assertTrue((folder / "run.png").read_bytes().startswith(b"\x89PNG"))
            bonds = (folder / "contacts.dump").read_text()
        self.assertIn("ITEM: NUMBER OF BONDS", bonds)
        pairs = [tuple(map(int, line.split()[:2])) for line in bonds.split("ITEM: BONDS")[-1].splitlines()[1:]]
        overlaps = system.overlaps().pairs
        self.assertGreater(len(pairs), 10)
        self.assertEqual(sorted(pairs), sorted(tuple(sorted(pair)) for pair in system.ids[overlaps]))

    def check_tensors(self, text, system):
        """The square of the tensor of each glyph is the form of its grain."""
        rows = text.split("TENSORS6 shape double\n")[1].split("SCALARS")[0].split()
        xx, yy, zz, xy, yz, xz = np.array(rows, dtype=float).reshape(len(system), 6).T
        root = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).transpose(2, 0, 1)
        form = root @ root
        np.testing.assert_allclose(form[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]], system.q, rtol=0, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
