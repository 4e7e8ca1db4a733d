# SPDX-License-Identifier: GPL-2.0-only
"""fix pw85/fire: minimisation over positions and orientations."""

import re
import unittest

import numpy as np
from lammps_runs import failure, preamble, random_system, run, thermo

# Denser than any packing (0.84 of the volume), so that forces are not zero at the minimum.
DENSE = random_system(7, 60, [[5.7, 0, 0], [1.0, 5.7, 0], [-0.5, 0.7, 5.7]], aspect=1.6)
# Dense (0.63), but with room for all.
LOOSE = random_system(8, 200, [[9.5, 0, 0], [0, 9.5, 0], [0, 0, 9.5]], aspect=2.0)

SOFT = """
neighbor 0.4 bin
neigh_modify delay 0
pair_style pw85/contact {cutoff:.17g}
pair_coeff * * 100.0
compute overlap all pw85/overlap
timestep 0.005
"""

RELAX = """
fix relax all pw85/fire
thermo_style custom step pe c_overlap f_relax dt
thermo_modify norm no format float %.17g
thermo 100
run {steps}
"""

DUMP = """
dump final all custom 1 final.txt id type mass x y z vx vy vz angmomx angmomy angmomz fx fy fz tqx tqy tqz
dump_modify final sort id format float %.17g
run 0
"""


def soft(system):
    return preamble(system) + SOFT.format(cutoff=system.cutoff)


def relaxed(system, steps, ranks=1):
    text, ((columns,),) = run(soft(system) + RELAX.format(steps=steps) + DUMP, system, ranks, ("final.txt",))
    first = text[:text.index("Loop time")] + "Loop time"
    return thermo(first), columns


def inverse_inertia(system):
    """Of solid ellipsoids of density 1: m/5 (b² + c²) about the axis of a, and so on."""
    w, i, j, k = system.quaternions.T
    rotation = np.array([[w*w + i*i - j*j - k*k, 2*(i*j - w*k), 2*(i*k + w*j)],
                         [2*(i*j + w*k), w*w - i*i + j*j - k*k, 2*(j*k - w*i)],
                         [2*(i*k - w*j), 2*(j*k + w*i), w*w - i*i - j*j + k*k]]).transpose(2, 0, 1)
    squares = system.semi_axes**2
    mass = 4.0 / 3.0 * np.pi * system.semi_axes.prod(axis=1)
    inertia = mass[:, None] / 5.0 * (squares.sum(axis=1)[:, None] - squares)
    return mass, np.einsum("nab,nb,ncb->nac", rotation, 1.0 / inertia, rotation)


class Relaxation(unittest.TestCase):
    def test_a_minimum_in_positions_and_orientations(self):
        table, columns = relaxed(DENSE, 4000)
        start, end = table[0], table[-1]
        self.assertGreater(start[3], 10.0)
        self.assertLess(end[3], 1e-9 * start[3])
        self.assertGreater(end[1], 1.0)
        # Forces of single pairs are of order 10, so that these zeros are balances.
        self.assertLess(np.abs(columns[:, 12:]).max(), 1e-7)

    def test_residual(self):
        table, columns = relaxed(DENSE, 0)
        mass, turn = inverse_inertia(DENSE)
        np.testing.assert_allclose(columns[:, 2], mass, rtol=1e-12)
        forces, torques = columns[:, 12:15], columns[:, 15:18]
        expected = ((forces**2).sum(axis=1) / mass + np.einsum("na,nab,nb->n", torques, turn, torques)).sum()
        self.assertAlmostEqual(table[0, 3] / np.sqrt(expected), 1.0, delta=1e-11)

    def test_more_than_the_minimisers_of_lammps(self):
        table, _ = relaxed(LOOSE, 1000)
        self.assertGreater(table[0, 2], 400)
        self.assertEqual(table[-1, 1], 0.0)
        for style in ("cg", "fire"):
            text, _ = run(soft(LOOSE) + f"thermo_style custom step pe c_overlap\nthermo_modify norm no\nmin_style {style}\n"
                          "minimize 0 1e-9 2000 20000\n", LOOSE)
            self.assertGreater(thermo(text)[-1, 2], 400, style)

    def test_end(self):
        """All is at rest, and the time step is what it was."""
        table, columns = relaxed(DENSE, 100)
        np.testing.assert_array_equal(columns[:, 6:12], 0.0)
        text, _ = run(soft(DENSE) + RELAX.format(steps=100) + 'print "timestep $(dt:%.17g)"\n', DENSE)
        self.assertEqual(float(re.findall(r"^timestep (\S+)", text, re.MULTILINE)[-1]), 0.005)
        self.assertGreater(table[-1, 4], 0.005)

    def test_ranks(self):
        one, two = relaxed(DENSE, 100)[0], relaxed(DENSE, 100, ranks=2)[0]
        np.testing.assert_allclose(two[:, :2], one[:, :2], rtol=1e-6)

    def test_group(self):
        """Only atoms of the group move."""
        script = soft(DENSE).replace("timestep", "group few type 2\ntimestep") + RELAX.format(steps=50) + DUMP
        _, ((columns,),) = run(script.replace("relax all", "relax few"), DENSE, 1, ("final.txt",))
        moved = np.abs(columns[:, 3:6] - DENSE.centers).max(axis=1) > 1e-12
        np.testing.assert_array_equal(moved, DENSE.types == 2)

    def test_errors(self):
        script = soft(DENSE) + RELAX.format(steps=1)
        self.assertIn("takes no arguments", failure(script.replace("pw85/fire", "pw85/fire 7"), DENSE))
        self.assertIn("run_style verlet", failure(script.replace("run 1", "run_style respa 2 2\nrun 1"), DENSE))
        bare = script.replace("fix relax", "set atom 3 shape 0 0 0\nfix relax")
        self.assertIn("atom 3 has no shape", failure(bare.replace("pw85/contact", "zero").replace("* * 100.0", "* *"), DENSE))

    def test_unfix(self):
        """The fix that moves the ellipsoids goes with this one."""
        _, ((columns,),) = run(soft(DENSE) + "fix relax all pw85/fire\nunfix relax\nrun 3\n" + DUMP,
                               DENSE, 1, ("final.txt",))
        np.testing.assert_allclose(columns[:, 3:6], DENSE.centers, rtol=0.0, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
