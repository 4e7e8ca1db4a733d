# SPDX-License-Identifier: GPL-2.0-only
"""The soft potential beside others: in hybrid styles, with mixed coefficients, under fix adapt, pair by pair."""

import os
import unittest

import brute_force
import numpy as np
from lammps_runs import failure, preamble, random_system, run, thermo

SYSTEM = random_system(41, 200, np.diag([10.0, 10.0, 10.0]), aspect=2.0)
CUTOFF = SYSTEM.cutoff
# Of like types: twice the longest semi-axis of each.
CUTOFFS = [2.0 * SYSTEM.semi_axes[SYSTEM.types == t].max() for t in (1, 2)]

ENERGY = "thermo_style custom step pe\nthermo_modify norm no format float %.17g\nrun 0\n"

BONDED = """
units lj
atom_style hybrid ellipsoid bond
include {include}
comm_modify vel yes
region box block 0 4 0 4 0 4
create_box 1 box bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
create_atoms 1 single 1.0 2.0 2.0
create_atoms 1 single 1.8 2.1 2.0
set type 1 shape 1.0 1.2 0.9
set type 1 quat/random 1234
set type 1 density 1.0
bond_style zero
bond_coeff *
special_bonds lj {weight} 1 1
create_bonds single/bond 1 1 2
{pair}
neighbor 0.3 bin
thermo_style custom step pe
thermo_modify norm no format float %.17g
dump forces all custom 1 forces.txt id fx fy fz tqx tqy tqz
dump_modify forces sort id format float %.17g
run 0
"""


class Hybrid(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.contacts = brute_force.Expected(SYSTEM, CUTOFF).contacts

    def expected(self, epsilon, exponent=2.0):
        """Energy by brute force; epsilon by types (smaller, larger), those left out have none."""
        energy = 0.0
        for (i, j), found in self.contacts.items():
            types = tuple(sorted((SYSTEM.types[i - 1], SYSTEM.types[j - 1])))
            for mu2, *_ in found:
                if mu2 < 1.0:
                    energy += epsilon.get(types, 0.0) / exponent * (1.0 - np.sqrt(mu2)) ** exponent
        return energy

    def check(self, commands, epsilon, ranks=1):
        text, _ = run(preamble(SYSTEM) + commands + ENERGY, SYSTEM, ranks)
        energy = self.expected(epsilon)
        # Sums of some 500 terms of one sign, each right to some 1e-13.
        self.assertAlmostEqual(thermo(text)[-1, 1], energy, delta=1e-12 * abs(energy), msg=commands)

    def test_pairs_of_other_styles_need_no_cutoff(self):
        # The other style has no forces, and a cutoff much too short for ellipsoids.
        other = f"pair_style hybrid lj/cut 0.5 pw85/contact {CUTOFF:.17g}\n"
        for ranks in (1, 2):
            self.check(other + "pair_coeff 1 * lj/cut 0.0 1.0\npair_coeff 2 2 pw85/contact 50.0\n", {(2, 2): 50.0}, ranks)
        self.check(other + "pair_coeff 1 1 lj/cut 0.0 1.0\npair_coeff 2 2 pw85/contact 50.0\n"
                   "pair_coeff 1 2 pw85/contact 20.0\n", {(1, 2): 20.0, (2, 2): 50.0})

    def test_none(self):
        self.check(f"pair_style hybrid pw85/contact {CUTOFF:.17g}\npair_coeff * * pw85/contact 30.0\n"
                   "pair_coeff 1 1 none\n", {(1, 2): 30.0, (2, 2): 30.0})

    def test_none_for_all_pairs_of_a_type_needs_no_shapes(self):
        commands = ("set type 1 shape 0 0 0\n"
                    f"pair_style hybrid pw85/contact {CUTOFF:.17g}\npair_coeff * * pw85/contact 30.0\n"
                    "pair_coeff 1 * none\n")
        self.check(commands, {(2, 2): 30.0})

    def test_own_pairs_need_a_cutoff(self):
        text = failure(preamble(SYSTEM) + "pair_style hybrid lj/cut 9.0 pw85/contact 0.5\npair_coeff 1 * lj/cut 0.0 1.0\n"
                       "pair_coeff 2 2 pw85/contact 50.0\nrun 0\n", SYSTEM)
        self.assertIn("of types 2 and 2 misses contacts", text)

    def test_weights_of_special_bonds(self):
        """The weight of a pair is a power of two, so that its energy, forces and torques are multiplied without rounding."""
        grains = "pair_style pw85/granular\npair_coeff * * hertz 1000 10 tangential mindlin 500 0.5 0.5"
        for pair in ("pair_style pw85/contact 1.2\npair_coeff * * 50.0", grains, grains + " conservative"):
            found = []
            for weight in (1.0, 0.25):
                script = BONDED.format(include=os.environ["PW85_LAMMPS_INCLUDE"], weight=weight, pair=pair)
                text, ((forces,),) = run(script, outputs=("forces.txt",))
                found.append(np.append(forces[:, 1:], thermo(text)[0, 1]))
            self.assertGreater(np.abs(found[0]).min(), 0.0)
            np.testing.assert_array_equal(found[1], 0.25 * found[0], err_msg=pair)

    def test_computes_beside_other_styles(self):
        computes = ("compute overlap all pw85/overlap\ncompute contact all pw85/contact below 1.0\n"
                    "thermo_style custom step c_overlap c_contact\nrun 0\n")
        styles = f"pw85/contact {CUTOFF:.17g}\npair_coeff 2 2 pw85/contact 50.0\n"
        text = failure(preamble(SYSTEM) + f"pair_style hybrid {styles}pair_coeff 1 * none\n{computes}", SYSTEM)
        self.assertIn("the pair cutoff 0 of types 1 and 1 misses contacts", text)
        text, _ = run(preamble(SYSTEM) + f"pair_style hybrid/overlay zero {CUTOFF:.17g} {styles}pair_coeff * * zero\n"
                      "pair_coeff 2 2 pw85/contact 50.0\n" + computes, SYSTEM, 2)
        overlapping = sum(mu2 < 1.0 for found in self.contacts.values() for mu2, *_ in found)
        np.testing.assert_array_equal(thermo(text)[0, 1:], [overlapping, overlapping])

    def test_mixing(self):
        """Cutoffs that suffice for like types do so for unlike ones; geometric means, if asked for, need not."""
        self.assertLess(CUTOFFS[1], 0.8 * CUTOFFS[0])
        commands = ("pair_style pw85/contact 1.0\n"
                    f"pair_coeff 1 1 80.0 {CUTOFFS[0]:.17g}\npair_coeff 2 2 20.0 {CUTOFFS[1]:.17g}\n")
        self.check(commands, {(1, 1): 80.0, (1, 2): 40.0, (2, 2): 20.0})
        text = failure(preamble(SYSTEM) + commands + "pair_modify mix geometric\n" + ENERGY, SYSTEM)
        self.assertIn("of types 1 and 2 misses contacts", text)

    def test_negative_epsilon_is_not_mixed(self):
        start = f"pair_style pw85/contact {CUTOFF:.17g}\n"
        for first, second in ((-80.0, 20.0), (80.0, -20.0), (-80.0, -20.0)):
            commands = start + f"pair_coeff 1 1 {first}\npair_coeff 2 2 {second}\n"
            text = failure(preamble(SYSTEM) + commands + ENERGY, SYSTEM)
            self.assertIn("negative epsilon cannot be mixed: add pair_coeff 1 2", text)
            self.check(commands + "pair_coeff 1 2 -10.0\n", {(1, 1): first, (2, 2): second, (1, 2): -10.0})

    def test_fix_adapt(self):
        double = "variable double equal 100.0\nfix adapted all adapt 0 pair pw85/contact epsilon 1 1 v_double\n"
        self.check(f"pair_style pw85/contact {CUTOFF:.17g}\npair_coeff 1 1 20.0\npair_coeff 2 2 25.0\n" + double,
                   {(1, 1): 100.0, (1, 2): 50.0, (2, 2): 25.0})
        self.check(f"pair_style hybrid lj/cut 0.5 pw85/contact {CUTOFF:.17g}\npair_coeff * 2 lj/cut 0.0 1.0\n"
                   "pair_coeff 1 1 pw85/contact 20.0\n" + double, {(1, 1): 100.0})


class Single(unittest.TestCase):
    SCRIPT = (f"pair_style pw85/contact {CUTOFF:.17g}\npair_coeff 1 1 80.0\npair_coeff 2 2 20.0\n"
              "compute tags all property/local patom1 patom2\n"
              "compute pairs all pair/local eng force dist p1 p2 p3 p4\n"
              "dump pairs all local 1 pairs.txt c_tags[*] c_pairs[*]\ndump_modify pairs format float %.17g\n"
              "dump atoms all custom 1 atoms.txt id x y z fx fy fz\ndump_modify atoms sort id format float %.17g\n")

    def test_pair_local(self):
        for ranks in (1, 2):
            text, ((pairs,), (atoms,)) = run(preamble(SYSTEM) + self.SCRIPT + ENERGY, SYSTEM, ranks,
                                             ("pairs.txt", "atoms.txt"))
            first, second = (pairs[:, :2].astype(int) - 1).T
            energies, central, distances, mu2, forces = *pairs[:, 2:6].T, pairs[:, 6:9]
            self.assertAlmostEqual(energies.sum(), thermo(text)[0, 1], delta=1e-12 * energies.sum())
            self.assertEqual(np.count_nonzero(energies), np.count_nonzero(mu2 < 1.0))
            sums = np.zeros((len(atoms), 3))
            np.add.at(sums, first, forces)
            np.add.at(sums, second, -forces)
            np.testing.assert_allclose(sums, atoms[:, 4:7], rtol=0, atol=1e-11 * np.abs(atoms[:, 4:7]).max())
            self.check_central(atoms[first, 1:4] - atoms[second, 1:4], central, distances, forces)

    def check_central(self, separations, central, distances, forces):
        separations -= np.round(separations / np.diag(SYSTEM.cell)) * np.diag(SYSTEM.cell)
        near = distances < 0.499 * SYSTEM.cell[0, 0]  # where the nearest image is that of the pair
        self.assertGreater(np.count_nonzero(near), 0.99 * len(near))
        along = (forces * separations).sum(axis=1) / distances
        np.testing.assert_allclose(central[near], along[near], rtol=0, atol=1e-11 * np.abs(forces).max())

    def test_elsewhere(self):
        """Where the atoms are not, there is no energy of a pair."""
        text = failure(preamble(SYSTEM) + self.SCRIPT + "run 0\npair_write 1 1 10 r 0.5 1.0 table.txt key\n", SYSTEM)
        self.assertIn("has the energy of a pair only for the positions and orientations", text)


if __name__ == "__main__":
    unittest.main()
