# SPDX-License-Identifier: GPL-2.0-only
"""compute pw85/grains: every contact against the geometry of both ellipsoids, the sums of forces, and LAMMPS's own computes."""

import unittest

import numpy as np
from lammps_runs import failure, preamble, run
from test_granular import SHAPES, Grains, Spheres, granular, lattice, rotation, script

LAW = "hooke 20000 30 damping mass_velocity tangential linear_history 8000 0.5 0.3"
OUTPUT = """
compute shape all property/atom quatw quati quatj quatk
compute grains all pw85/grains
compute overlap all pw85/overlap
compute virial all pressure NULL pair
dump rows all local {steps} rows.txt c_grains[*]
dump atoms all custom {steps} atoms.txt id x y z c_shape[*] fx fy fz tqx tqy tqz c_grains c_overlap
dump_modify rows format float %.17g
dump_modify atoms sort id format float %.17g
thermo_style custom step c_grains c_grains[*] c_virial[*] vol
thermo_modify norm no format float %.17g
run {steps}
print "count = $(c_grains:%.17g)"
print "sums = $(c_grains[1]:%.17g) $(c_grains[2]:%.17g) $(c_grains[3]:%.17g) $(c_grains[4]:%.17g) $(c_grains[5]:%.17g) &
$(c_grains[6]:%.17g) $(c_grains[7]:%.17g) $(c_grains[8]:%.17g) $(c_grains[9]:%.17g)"
print "virial = $(c_virial[1]:%.17g) $(c_virial[2]:%.17g) $(c_virial[3]:%.17g) $(c_virial[4]:%.17g) $(c_virial[5]:%.17g) &
$(c_virial[6]:%.17g)"
print "volume = $(vol:%.17g)"
"""


def words_after(label, text):
    line = next(line for line in reversed(text.splitlines()) if line.startswith(f"{label} = "))
    return np.array([float(word) for word in line.split("=")[1].split()])


class Contacts(unittest.TestCase):
    GRAINS = lattice(Grains, 4, 1.1, SHAPES, 7)

    def contacts(self, ranks, newton, steps=60):
        """The text that LAMMPS printed, and the rows of contacts and atoms at the end."""
        commands = script(self.GRAINS, granular(LAW), steps, newton)
        commands = commands[:commands.index("\ndump state")] + OUTPUT.format(steps=steps)
        text, (rows, atoms) = run(commands, self.GRAINS, ranks, ("rows.txt", "atoms.txt"))
        return text, rows[-1], atoms[-1]

    def nearest(self, offset):
        cell = np.diag(self.GRAINS.cell)
        return offset - cell * np.round(offset / cell)

    def check_geometry(self, row, atoms):
        """The points that are half of the depth before and behind the contact are on both surfaces, with opposite normals."""
        point, normal, depth = row[2:5], row[5:8], row[8]
        for tag, sign in ((int(row[0]), 1.0), (int(row[1]), -1.0)):
            atom = atoms[tag - 1]
            axes = rotation(atom[4:8])
            inverse = axes @ np.diag(self.GRAINS.semi_axes[tag - 1]**-2.0) @ axes.T
            x = self.nearest(point - atom[1:4]) + sign * 0.5 * depth * normal
            gradient = sign * inverse @ x
            context = f"{[float(v).hex() for v in row]}"
            # Newton's method leaves an error of the normal of some 1e-12, times the largest curvature, 8.
            self.assertAlmostEqual(x @ inverse @ x, 1.0, delta=1e-10, msg=context)
            np.testing.assert_allclose(gradient / np.linalg.norm(gradient), normal, rtol=0, atol=1e-10, err_msg=context)

    def check(self, ranks, newton):
        text, rows, atoms = self.contacts(ranks, newton)
        self.assertGreater(len(rows), 20)
        self.assertEqual(len({tuple(row[:2]) for row in rows}), len(rows))
        self.assertEqual(words_after("count", text), len(rows))
        np.testing.assert_array_equal(atoms[:, 14], atoms[:, 15], err_msg="contacts of each atom: pw85/overlap")
        forces, torques, sums = np.zeros((64, 3)), np.zeros((64, 3)), np.zeros((3, 3))
        for row in rows:
            self.assertLess(row[0], row[1])
            self.check_geometry(row, atoms)
            i, j, push = int(row[0]) - 1, int(row[1]) - 1, row[9:12]
            for atom, sign in ((i, 1.0), (j, -1.0)):
                forces[atom] += sign * push
                torques[atom] += np.cross(self.nearest(row[2:5] - atoms[atom, 1:4]), sign * push)
            stress = -np.outer(self.nearest(atoms[j, 1:4] - atoms[i, 1:4]), push)
            np.testing.assert_allclose(row[12:21].reshape(3, 3), stress, rtol=0, atol=1e-11 * np.abs(push).max())
            sums += stress
            np.testing.assert_allclose(row[21:24], push - (push @ row[5:8]) * row[5:8], rtol=0, atol=1e-11 * np.abs(push).max())
            self.assertLess(np.abs(row[24:27] @ row[5:8]), 1e-12)
        scale = np.abs(forces).max()
        np.testing.assert_allclose(forces, atoms[:, 8:11], rtol=0, atol=1e-12 * scale)
        np.testing.assert_allclose(torques, atoms[:, 11:14], rtol=0, atol=1e-12 * scale)
        np.testing.assert_allclose(words_after("sums", text), sums.ravel(), rtol=0, atol=1e-12 * np.abs(sums).max() * len(rows))
        # LAMMPS's virial has one triangle: xx, yy, zz, xy, xz, yz.
        virial = words_after("virial", text) * words_after("volume", text)
        expected = sums.ravel()[[0, 4, 8, 1, 2, 5]]
        np.testing.assert_allclose(virial, expected, rtol=0, atol=1e-12 * np.abs(sums).max() * len(rows))
        self.assertGreater(np.abs(sums - sums.T).max(), 1e-6 * scale, "the sum is symmetric: friction has no part in it")

    def test_ellipsoids(self):
        for ranks, newton in ((1, "on"), (2, "off")):
            self.check(ranks, newton)

    def test_spheres(self):
        """Forces and numbers of contacts of LAMMPS's own computes for its own spheres."""
        spheres = lattice(Spheres, 4, 1.0, [[0.5, 0.5, 0.5], [0.52, 0.52, 0.52]], 5)
        pair = "pair_style gran/hooke/history 10000 4000 20 10 0.4 1\npair_coeff * *"
        theirs = script(spheres, pair, 100, "on")
        theirs = theirs[:theirs.index("\ndump state")] + (
            "\ncompute number all contact/atom\n"
            "dump atoms all custom 100 atoms.txt id fx fy fz c_number\ndump_modify atoms sort id format float %.17g\nrun 100\n")
        atoms = run(theirs, spheres, 1, ("atoms.txt",))[1][0][-1]
        ours = script(Grains(**vars(spheres)), granular(
            "hooke 10000 20 damping mass_velocity tangential linear_history 4000 0.5 0.4", "arms surface"), 100, "on")
        ours = ours[:ours.index("\ndump state")] + (
            "\ncompute grains all pw85/grains\ndump atoms all custom 100 atoms.txt id fx fy fz c_grains\n"
            "dump_modify atoms sort id format float %.17g\nrun 100\n")
        found = run(ours, Grains(**vars(spheres)), 2, ("atoms.txt",))[1][0][-1]
        self.assertGreater(atoms[:, 4].sum(), 40)
        np.testing.assert_array_equal(found[:, 4], atoms[:, 4])
        np.testing.assert_allclose(found[:, 1:4], atoms[:, 1:4], rtol=0, atol=1e-9 * np.abs(atoms[:, 1:4]).max())

    def test_errors(self):
        start = preamble(self.GRAINS) + "comm_modify vel yes\n"
        pair = "pair_style pw85/granular\npair_coeff * * hooke 1000 0\n"
        for commands, words in ((f"{pair}compute g all pw85/grains below 1\n", "takes no arguments but the word walls"),
                                ("pair_style zero 4.0\npair_coeff * *\ncompute g all pw85/grains\nthermo_style custom step c_g\nrun 0\n",
                                 "use this pair style")):
            self.assertIn(words, failure(start + commands, self.GRAINS))


if __name__ == "__main__":
    unittest.main()
