# SPDX-License-Identifier: GPL-2.0-only
"""The computes against brute force while fixes move atoms and the box at the end of a step, on 1, 2 and 4 ranks."""

import dataclasses
import re
import unittest

import brute_force
import numpy as np
from lammps_runs import preamble, random_system, run, thermo

BOX = random_system(21, 300, np.diag([11.0, 12.0, 13.0]), aspect=2.0)

RESTING = "pair_style zero {cutoff:.17g}\npair_coeff * *\n"
SOFT = ("pair_style pw85/contact {cutoff:.17g}\npair_coeff * * 20.0\n"
        "velocity all create 0.5 4711 loop geom\ntimestep 0.005\n")

# What moves.
MOTIONS = {
    "deform": RESTING + "fix box all deform 10 x scale 0.8 y scale 0.9 remap x\n",
    "deform every step, sheared": RESTING + "change_box all triclinic\n"
                                  "fix box all deform 1 x scale 0.85 xy delta 3.0 yz delta -2.0 remap x\n",
    "berendsen": SOFT + "fix move all nve/asphere\nfix box all press/berendsen iso 40.0 40.0 1.0 modulus 50.0\n",
    "npt": SOFT + "fix move all npt/asphere temp 0.5 0.5 0.1 iso 40.0 40.0 2.0\n",
}

SNAPSHOT = """
neighbor 0.4 bin
neigh_modify delay 0
{motion}
compute overlap all pw85/overlap
compute contact all pw85/contact below 1.5
compute quaternions all property/atom quatw quati quatj quatk
variable pairs equal c_overlap
thermo 1000
thermo_style custom step c_overlap press
dump atoms all custom 100 atoms.txt id x y z c_quaternions[*] c_overlap c_contact
dump contacts all local 100 contacts.txt c_contact[*]
dump_modify atoms sort id format float %.17g
dump_modify contacts format float %.17g
run 100
print "pairs = $(v_pairs:%.17g)"
print "cell = $(lx:%.17g) $(xy:%.17g) $(ly:%.17g) $(xz:%.17g) $(yz:%.17g) $(lz:%.17g)"
run 0 pre no
print "again = $(v_pairs:%.17g)"
"""

REACH = np.sqrt(1.5)
WARNING = "may miss pairs"


def printed(label, text):
    return [float(word) for word in re.search(rf"^{label} = (.*)$", text, re.MULTILINE).group(1).split()]


def snapshot(motion, ranks):
    """The system after 100 steps, what the computes say of it then, and the counts printed then and after run 0."""
    script = preamble(BOX) + SNAPSHOT.format(motion=motion.format(cutoff=BOX.cutoff * REACH))
    text, (atoms, contacts) = run(script, BOX, ranks, ("atoms.txt", "contacts.txt"))
    if WARNING in text:
        raise AssertionError(f"a skin of 0.4 does not suffice\n{motion}\n{text}")
    lx, xy, ly, xz, yz, lz = printed("cell", text)
    system = dataclasses.replace(BOX, cell=np.array([[lx, 0, 0], [xy, ly, 0], [xz, yz, lz]]),
                                 centers=atoms[-1][:, 1:4].copy(), quaternions=atoms[-1][:, 4:8].copy())
    return system, atoms[-1][:, 8:], contacts[-1], printed("pairs", text) + printed("again", text)


class Moving(unittest.TestCase):
    def check(self, motion, ranks):
        system, values, contacts, counts = snapshot(motion, ranks)
        self.assertGreater(np.abs(system.cell - BOX.cell).max(), 0.5, "the box hardly changed")
        expected = brute_force.Expected(system, BOX.cutoff * REACH)
        self.assertEqual(counts, [expected.overlapping_pairs] * 2)
        np.testing.assert_array_equal(values[:, 0], expected.neighbours)
        below = [c for found in expected.contacts.values() for c in found if c[0] < 1.5]
        self.assertEqual(len(contacts), len(below))
        bound = max(c[1] for c in below)
        np.testing.assert_allclose(np.sort(contacts[:, 2]), np.sort([c[0] for c in below]), rtol=0, atol=bound)
        closest = np.where(expected.smallest < 1.5, expected.smallest, np.inf)
        np.testing.assert_allclose(values[:, 1], closest, rtol=0, atol=bound)
        return counts[0]

    def test_against_brute_force(self):
        for name, motion in MOTIONS.items():
            counts = {}
            for ranks in (1, 2, 4):
                with self.subTest(motion=name, ranks=ranks):
                    counts[ranks] = self.check(motion, ranks)
            with self.subTest(motion=name):
                self.assertEqual(len(counts), 3)
                self.assertEqual(len(set(counts.values())), 1, counts)

    def check_warning(self, motion, slight, strong):
        """Two spheres too far apart for the neighbour list, that a strong motion brings into contact."""
        spheres = random_system(22, 2, np.diag([8.0, 8.0, 8.0]), aspect=1.0)
        spheres.centers[:] = [[3.3, 4.0, 4.0], [4.7, 4.0, 4.0]]
        spheres.semi_axes[:] = 0.5
        script = preamble(spheres) + RESTING.format(cutoff=1.0) + (
            "neighbor 0.3 bin\nneigh_modify delay 20\ncompute overlap all pw85/overlap\nthermo 1\n"
            f"thermo_style custom step c_overlap\n{motion}\nunfix motion\nrun 0\n")
        for ranks in (1, 2):
            text, _ = run(script.format(slight), spheres, ranks)
            self.assertNotIn(WARNING, text)
            text, _ = run(script.format(strong), spheres, ranks)
            self.assertEqual(text.count(WARNING), 1, text)
            self.assertEqual(thermo(text)[0, 1], 1)

    def test_warning(self):
        self.check_warning("fix motion all deform 1 x scale {} remap x\nrun 1", 0.9, 0.6)
        self.check_warning("group first id 1\ntimestep 0.01\nfix motion first move linear {} 0 0\nrun 10", 1.0, 6.0)


if __name__ == "__main__":
    unittest.main()
