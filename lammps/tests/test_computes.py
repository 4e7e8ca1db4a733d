# SPDX-License-Identifier: GPL-2.0-only
"""The computes against brute force: boxes of all kinds, newton on and off, 1, 2 and 4 ranks."""

import dataclasses
import itertools
import re
import unittest

import brute_force
import numpy as np
from lammps_runs import failure, preamble, random_system, release, run, thermo

BOXES = {
    "orthogonal": random_system(1, 300, np.diag([11.0, 12.0, 13.0])),
    "triclinic": random_system(2, 300, [[12.0, 0, 0], [5.0, 11.0, 0], [-4.0, 3.0, 12.0]]),
    "open": random_system(3, 300, np.diag([11.0, 12.0, 13.0]), periodic=False),
    # Ellipsoids meet several images of their neighbours, and of themselves.
    "smaller than the ellipsoids": random_system(4, 5, [[2.1, 0, 0], [0.4, 2.3, 0], [0.3, -0.2, 2.2]]),
}

SNAPSHOT = """
neighbor 0.3 bin
pair_style zero {cutoff:.17g}
pair_coeff * *
compute overlap all pw85/overlap
compute contact all pw85/contact
compute near all pw85/contact below 0.7
dump atoms all custom 1 atoms.txt id c_overlap c_contact c_near
dump contacts all local 1 contacts.txt c_contact[*]
dump near all local 1 near.txt c_near[*]
dump_modify atoms sort id format float %.17g
dump_modify contacts format float %.17g
dump_modify near format float %.17g
thermo_style custom step c_overlap c_contact c_near
run 0
print "pairs = $(c_overlap:%.17g) rows = $(c_contact:%.17g) $(c_near:%.17g)"
"""

OUTPUTS = ("atoms.txt", "contacts.txt", "near.txt")
# The solver leaves an error in log τ below 1e-8, which moves the point by less than that part of its distance.
GEOMETRY_TOLERANCE = 1e-7


def by_pair(rows):
    found = {}
    for row in rows:
        found.setdefault((int(row[0]), int(row[1])), []).append(row)
    return found


class Computes(unittest.TestCase):
    def check_contacts(self, system, expected, rows):
        found = by_pair(rows)
        self.assertEqual({k: len(v) for k, v in found.items()}, {k: len(v) for k, v in expected.items()})
        for pair, contacts in expected.items():
            for contact, row in zip(sorted(contacts, key=lambda c: c[0]), sorted(found[pair], key=lambda r: r[2])):
                mu2, bound = contact[:2]
                self.assertLessEqual(abs(row[2] - mu2), bound, f"{pair}: {row[2].hex()} instead of {mu2.hex()}")
            if len(contacts) == 1 and pair[0] != pair[1]:
                self.check_geometry(system, pair, contacts[0], found[pair][0])

    def check_geometry(self, system, pair, contact, row):
        _, _, point, normal = contact
        offset = row[3:6] - system.centers[pair[0] - 1] - point
        if system.periodic:  # the point is near whichever image of the first ellipsoid was at hand
            offset -= np.round(offset @ np.linalg.inv(system.cell)) @ system.cell
        size = system.semi_axes.max()
        self.assertLessEqual(np.abs(offset).max(), GEOMETRY_TOLERANCE * size, f"point of {pair}")
        self.assertLessEqual(np.abs(row[6:9] - normal).max(), GEOMETRY_TOLERANCE, f"normal of {pair}")

    def check(self, name, newton, ranks):
        system = BOXES[name]
        script = preamble(system, newton) + SNAPSHOT.format(cutoff=system.cutoff)
        text, ((atoms,), (contacts,), (near,)) = run(script, system, ranks, OUTPUTS)
        expected = self.expected[name]
        self.assertIn(f"pairs = {expected.overlapping_pairs} rows = {len(contacts)} {len(near)}\n", text)
        np.testing.assert_array_equal(atoms[:, 1], expected.neighbours)
        self.check_contacts(system, expected.contacts, contacts)
        inside = {pair: [c for c in found if c[0] < 0.7] for pair, found in expected.contacts.items()}
        self.check_contacts(system, {pair: found for pair, found in inside.items() if found}, near)
        # The bound on μ² of one pair holds for the smallest of many; take the largest of all.
        bound = max(c[1] for found in expected.contacts.values() for c in found)
        np.testing.assert_allclose(atoms[:, 2], expected.smallest, rtol=0.0, atol=bound)
        closest = np.where(expected.smallest < 0.7, expected.smallest, np.inf)
        np.testing.assert_allclose(atoms[:, 3], closest, rtol=0.0, atol=bound)

    def test_against_brute_force(self):
        self.expected = {name: brute_force.Expected(system, system.cutoff) for name, system in BOXES.items()}
        for name, newton, ranks in itertools.product(BOXES, ("on", "off"), (1, 2, 4)):
            with self.subTest(box=name, newton=newton, ranks=ranks):
                self.check(name, newton, ranks)

    def test_group(self):
        """Only pairs within the group count, and atoms outside it need no shape."""
        system = BOXES["orthogonal"]
        script = preamble(system) + (
            f"group large type 1\nset type 2 shape 0 0 0\npair_style zero {system.cutoff:.17g}\npair_coeff * *\n"
            "compute overlap large pw85/overlap\ncompute contact large pw85/contact below 1.0\n"
            "dump contacts all local 1 contacts.txt c_contact[*]\nthermo_style custom step c_overlap\nrun 0\n"
            'print "pairs = $(c_overlap:%.17g)"\n')
        text, ((contacts,),) = run(script, system, 2, ("contacts.txt",))
        large = [c for pair, found in brute_force.Expected(system, system.cutoff).contacts.items() for c in found
                 if system.types[pair[0] - 1] == 1 and system.types[pair[1] - 1] == 1 and c[0] < 1.0]
        self.assertIn(f"pairs = {len(large)}\n", text)
        self.assertEqual(len(contacts), len(large))

    def test_shapes_change_between_runs(self):
        system = BOXES["orthogonal"]
        script = preamble(system) + (
            f"atom_modify sort 0 0.0\npair_style zero {system.cutoff:.17g}\npair_coeff * *\n"
            "compute overlap all pw85/overlap\nthermo_style custom step c_overlap\nrun 0\n"
            "set type * shape 1e-3 1e-3 1e-3\nrun 0\n")
        self.assertEqual(thermo(run(script, system)[0])[0, 1], 0)

    def test_orientations_change_before_run_pre_no(self):
        """What was computed for the same step, before, is not taken for the present."""
        system = BOXES["orthogonal"]
        script = preamble(system) + (
            f"pair_style zero {system.cutoff:.17g}\npair_coeff * *\ncompute o all pw85/overlap\n"
            "thermo_style custom step c_o\nrun 0\nset type * quat 0 0 1 60\nrun 0 pre no\n")
        text, _ = run(script, system, 2)
        parallel = np.tile([np.cos(np.pi / 6), 0.0, 0.0, np.sin(np.pi / 6)], (len(system.centers), 1))
        turned = dataclasses.replace(system, quaternions=parallel)
        counts = [brute_force.Expected(s, system.cutoff).overlapping_pairs for s in (system, turned)]
        self.assertNotEqual(*counts)
        self.assertEqual(thermo(text)[0, 1], counts[1])

    def test_concentric(self):
        system = random_system(5, 2, np.diag([20.0, 20.0, 20.0]))
        system.centers[1] = system.centers[0]
        script = preamble(system) + SNAPSHOT.format(cutoff=system.cutoff)
        text, (_, (contacts,), _) = run(script, system, 1, OUTPUTS)
        self.assertIn("pairs = 1 rows = 1 1\n", text)
        np.testing.assert_array_equal(contacts, [[1, 2, 0.0, *system.centers[0], 0, 0, 0]])


class Errors(unittest.TestCase):
    """Each error says what to do."""

    system = BOXES["orthogonal"]

    def expect(self, script, *words, ranks=1):
        text = failure(script, self.system, ranks)
        for word in words:
            self.assertIn(word, text)

    def computes(self, cutoff, contact=""):
        return (f"pair_style zero {cutoff:.17g}\npair_coeff * *\ncompute o all pw85/overlap\n"
                f"compute c all pw85/contact {contact}\ncompute least all reduce min c_c\n"
                "thermo_style custom step c_o c_least\nrun 0\n")

    def check_cure(self, script, cutoff, ranks=1):
        match = re.search(r"raise the cutoff in pair_style or pair_coeff to (\S+) or more",
                          failure(script, self.system, ranks))
        self.assertIsNotNone(match)
        self.assertAlmostEqual(float(match.group(1)), cutoff, delta=1e-14 * cutoff)  # 15 digits are printed
        return match.group(1)

    def test_cutoff(self):
        cutoff, start = self.system.cutoff, preamble(self.system)
        for ranks in (1, 2):
            self.check_cure(start + self.computes(0.9 * cutoff), cutoff, ranks)
        self.check_cure(start + self.computes(cutoff, "below 1.21"), 1.1 * cutoff)
        cure = self.check_cure(start + f"pair_style pw85/contact {0.9 * cutoff}\npair_coeff * * 1.0\nrun 0\n", cutoff)
        run(start + self.computes(float(cure)), self.system)

    def test_cutoff_when_a_group_grows(self):
        """Large ellipsoids join the group during a run in which no list is rebuilt."""
        script = preamble(self.system) + (
            f"pair_style zero {0.99 * self.system.cutoff:.17g}\npair_coeff * *\n"
            "variable joined atom \"type == 2 || step > 5\"\ngroup some dynamic all var joined every 1\n"
            "compute o some pw85/overlap\nthermo 1\nthermo_style custom step c_o\nrun {steps}\n")
        run(script.format(steps=5), self.system)
        self.expect(script.format(steps=6), "raise the cutoff")

    def test_no_pair_style(self):
        self.expect(preamble(self.system) + "compute o all pw85/overlap\nthermo_style custom step c_o\nrun 0\n",
                    "pair_style zero")

    def test_missing_shape(self):
        start = preamble(self.system) + "set atom 17 shape 0 0 0\n"
        self.expect(start + self.computes(5.0), "atom 17 has no shape", "set ... shape")
        self.expect(start + "pair_style pw85/contact 5.0\npair_coeff * * 1.0\nrun 0\n", "atom 17 has no shape",
                    "pair_style hybrid")

    def test_atom_style(self):
        start = preamble(self.system).replace("atom_style ellipsoid", "atom_style sphere").replace(
            "read_data system.data", "region box block 0 9 0 9 0 9\ncreate_box 1 box\ncreate_atoms 1 single 1 1 1")
        self.expect(start + self.computes(5.0), "use atom_style ellipsoid")
        self.expect(start + "pair_style pw85/contact 5.0\npair_coeff * * 1.0\nrun 0\n", "use atom_style ellipsoid")

    def test_arguments(self):
        start = preamble(self.system) + "pair_style zero 5.0\npair_coeff * *\n"
        self.expect(start + "compute o all pw85/overlap 1\n", "takes no arguments")
        self.expect(start + "compute o all pw85/contact above 1\n", "the only keyword is below")
        self.expect(start + "compute o all pw85/contact below -1\n", "must be positive")
        self.expect(start + "pair_style pw85/contact\n", "cutoff [exponent]")
        self.expect(start + "pair_style pw85/contact 5.0 1.5\n", "exponent must be 2 or more")
        soft = start + "pair_style pw85/contact 5.0\n"
        self.expect(soft + "pair_coeff * *\n", "takes epsilon")
        # The releases from February 2025 on refuse this number themselves.
        self.expect(soft + "pair_coeff * * 1e999\n", "epsilon must be finite" if release() < (2025, 2, 4) else "is out of range")
        self.expect(soft + "pair_coeff * * 1.0 -5.0\n", "cutoff must be positive")


if __name__ == "__main__":
    unittest.main()
