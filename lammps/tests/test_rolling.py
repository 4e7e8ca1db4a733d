# SPDX-License-Identifier: GPL-2.0-only
"""Rolling resistance: spheres against LAMMPS's own granular styles, and an ellipsoid that comes to rest."""

import dataclasses
import unittest

import numpy as np
import spheres
from test_granular import HERTZ_LAW, HOOKE_LAW, AgainstLammps, Grains, Spheres, granular, lattice, move

# The spring, the damper and the limit all act: the spheres start to roll, slide through the limit, and turn back.
ROLLING = "rolling sds 3000 5 0.1"


class AgainstGranular:
    """LAMMPS's pair_style granular has other arms for friction than the default here. Other tests compare with it, too."""

    compare = AgainstLammps.compare

    # Neighbour lists that hold for the whole run. When LAMMPS's style finds a pair in the other order in a new list, it reverses the
    # rolling spring, which is the same from both sides.
    LISTS = "\nneighbor 0.5 bin"

    def spheres(self):
        grains = lattice(Spheres, 4, 1.0, [[0.5, 0.5, 0.5], [0.52, 0.52, 0.52]], 5)
        return dataclasses.replace(grains, spins=3.0 * grains.spins)

    def check(self, theirs, ours, steps, tolerance, ranks, least=20):
        grains = self.spheres()
        expected = move(grains, theirs, steps)[-1]
        self.assertGreater(np.count_nonzero(np.abs(expected[:, 10:13]).max(axis=1) > 0.1), least, "hardly any torques")
        self.compare(move(Grains(**vars(grains)), ours, steps, ranks)[-1], expected, tolerance, ours)


class RollingSpheres(AgainstGranular, unittest.TestCase):
    NO_FRICTION = (("hooke 10000 20 damping mass_velocity tangential linear_nohistory 0 0 ", "hooke 10000 20 damping mass_velocity "),
                   ("hertz/material 200000 40 0.3 damping velocity tangential linear_nohistory 0 0 ",
                    "hertz/material 200000 40 0.3 damping velocity "))
    FRICTION = (HOOKE_LAW.words(), HERTZ_LAW.words(),
                "hertz/material 200000 0.7 0.3 damping tsuji tangential mindlin NULL 0.6 0.5",
                "hooke 10000 20 damping mass_velocity tangential linear_nohistory 0.5 0.4")

    def check_pairs(self, theirs, ours, style=""):
        laws = f"pair_style granular\npair_coeff * * {theirs}{ROLLING}{self.LISTS}", granular(ours + ROLLING, style) + self.LISTS
        # Each step adds some u to positions, and the stiffness turns them into errors of forces: see AgainstLammps.
        self.check(*laws, 10, 1e-12, 1)
        self.check(*laws, 100, 1e-9, 2)

    def test_pairs(self):
        for theirs, ours in self.NO_FRICTION:
            self.check_pairs(theirs, ours)

    def test_friction_of_pairs(self):
        for law in self.FRICTION:
            self.check_pairs(f"{law} ", f"{law} ", "arms granular")

    def check_wall(self, theirs, ours, wall, arms, steps, tolerance):
        self.check(f"pair_style granular\npair_coeff * * {theirs}\nfix wall all wall/gran granular {theirs}{ROLLING} {wall}",
                   granular(ours, arms) + f"\nfix wall all wall/pw85 {wall} {arms} law {ours}{ROLLING}", steps, tolerance, 2, least=5)

    def test_walls(self):
        self.check_wall(*self.NO_FRICTION[0], "zplane 0.05 3.95", "", 200, 1e-9)

    def test_friction_of_walls(self):
        for law in self.FRICTION[:2]:
            self.check_wall(f"{law} ", f"{law} ", "zplane 0.05 3.95", "arms granular", 100, 1e-9)

    def test_formulas(self):
        """The same forces follow from the formulas, without rolling, which these do not have."""
        grains = self.spheres()
        for law in (HOOKE_LAW, HERTZ_LAW):
            motion = spheres.Motion(grains, law, arms="granular").run(200).state()
            found = move(Grains(**vars(grains)), granular(law.words(), "arms granular"), 200, 2)[-1]
            self.compare(found, motion, 1e-9, law.words())


class Walls(unittest.TestCase):
    def test_spin_of_the_wall(self):
        """A sphere at rest on a plane that turns about a horizontal axis through the contact: ω is minus the spin of the wall, so that the
        damper gives the couple R² GR Ω."""
        radius, damper, period = 0.5, 0.3, 4.0
        sphere = Grains(np.diag([4.0, 4.0, 4.0]), False, np.array([[2.0, 2.0, 0.49]]), np.full((1, 3), radius),
                        np.array([[1.0, 0.0, 0.0, 0.0]]), np.ones(1, dtype=int), *np.zeros((2, 1, 3)))
        wall = f"zplane 0.0 NULL rotate 2 2 0 0 1 0 {period} law hooke 1000 0 rolling sds 100 {damper} 0.5"
        found = move(sphere, f"pair_style zero 2.0\npair_coeff * *\nfix wall all wall/pw85 {wall}", 1)[0][0, 7:13]
        couple = radius**2 * damper * 2.0 * np.pi / period
        # The depth has an error of some u, and the stiffness is 1000.
        np.testing.assert_allclose(found, [0.0, 0.0, 10.0, 0.0, couple, 0.0], rtol=0, atol=1e-12)


class Ellipsoids(unittest.TestCase):
    def test_new_lists_and_restart(self):
        """Springs follow their pairs through new lists, other processors and a restart file."""
        grains = lattice(Grains, 4, 1.0, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)
        grains = dataclasses.replace(grains, velocities=grains.velocities + [20.0, 13.0, -7.0])
        pair = granular(f"hooke 10000 20 damping mass_velocity tangential linear_history 4000 0.5 0.4 {ROLLING}")
        expected = move(grains, pair, 150, first_half="pause")[-1]
        found = move(grains, pair, 150, 2, "on", "middle")[-1]
        cell = np.diag(grains.cell)
        found[:, 1:4] -= cell * np.round((found[:, 1:4] - expected[:, 1:4]) / cell)
        np.testing.assert_allclose(found[:, 1:7], expected[:, 1:7], rtol=0, atol=1e-9 * 30.0)


if __name__ == "__main__":
    unittest.main()
