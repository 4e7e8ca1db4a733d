# SPDX-License-Identifier: GPL-2.0-only
"""pypw85 reads files that LAMMPS wrote, and finds the same overlaps and contacts as the computes."""

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


if __name__ == "__main__":
    unittest.main()
