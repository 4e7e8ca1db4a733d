# SPDX-License-Identifier: GPL-2.0-only
"""Twisting resistance: spheres against LAMMPS's own granular styles, and ellipsoids that spin on a plane."""

import dataclasses
import unittest

import numpy as np
from lammps_runs import failure, preamble, run
from test_granular import HERTZ_LAW, HOOKE_LAW, AgainstLammps, Grains, granular, lattice, move
from test_rolling import AgainstGranular

SDS = "twisting sds 300 0.5 0.02"
LISTS = AgainstGranular.LISTS


class AgainstTwisting(unittest.TestCase):
    compare, spheres, check = AgainstLammps.compare, AgainstGranular.spheres, AgainstGranular.check
    LAWS = tuple(f"{law} {words}" for law in (HOOKE_LAW.words(), HERTZ_LAW.words(),
                                              "hertz/material 200000 0.7 0.3 damping tsuji tangential mindlin NULL 0.6 0.5")
                 for words in (SDS, "twisting marshall", "rolling sds 3000 5 0.1 twisting marshall"))

    def test_pairs(self):
        for law in self.LAWS:
            theirs, ours = f"pair_style granular\npair_coeff * * {law}{LISTS}", granular(law, "arms granular") + LISTS
            # As in test_rolling.py.
            self.check(theirs, ours, 10, 1e-12, 1)
            self.check(theirs, ours, 100, 1e-9, 2)

    def test_walls(self):
        for law in self.LAWS[:6]:
            wall = "zplane 0.05 3.95"
            theirs = f"pair_style granular\npair_coeff * * {law}\nfix wall all wall/gran granular {law} {wall}"
            ours = granular(law, "arms granular") + f"\nfix wall all wall/pw85 {wall} arms granular law {law}"
            self.check(theirs, ours, 100, 1e-9, 2, least=5)

    def test_it_acts(self):
        """Without twisting, torques are others: the comparison would show it."""
        expected = move(self.spheres(), f"pair_style granular\npair_coeff * * {self.LAWS[0]}{LISTS}", 10)[-1]
        found = move(Grains(**vars(self.spheres())), granular(HOOKE_LAW.words(), "arms granular") + LISTS, 10)[-1]
        self.assertGreater(np.abs(found[:, 10:13] - expected[:, 10:13]).max(), 1e-3 * np.abs(expected[:, 10:13]).max())


class OnPlane(unittest.TestCase):
    """A flat grain that lies on a plane with a weight of its own, and spins about the vertical."""

    SEMI_AXES, STIFFNESS = np.array([0.5, 0.5, 0.3]), 1e4
    MASS = 4 / 3 * np.pi * SEMI_AXES.prod()
    INERTIA = 0.4 * MASS * 0.25
    DEPTH = MASS / STIFFNESS
    RADIUS = 0.25 / 0.3  # of curvature

    def spins(self, words, spin=2.0, steps=20000, timestep=2e-4, arms=""):
        """Rows: time, angular velocity about the vertical, height."""
        grain = Grains(np.diag([8.0, 8.0, 8.0]), False, np.array([[4.0, 4.0, 0.3 - self.DEPTH]]), self.SEMI_AXES[None, :],
                       np.array([[1.0, 0.0, 0.0, 0.0]]), np.ones(1, dtype=int), np.zeros((1, 3)), np.array([[0.0, 0.0, spin]]))
        commands = preamble(grain) + (
            "pair_style zero 4.0\npair_coeff * *\ncomm_modify vel yes\nneighbor 0.3 bin\n"
            f"fix floor all wall/pw85 zplane 0 NULL {arms} law hooke {self.STIFFNESS} 0 {words}\n"
            f"fix weight all gravity 1.0 vector 0 0 -1\nfix move all nve/asphere\ntimestep {timestep}\n"
            "compute l all property/atom angmomz\ndump state all custom 20 state.txt id z c_l\ndump_modify state format float %.17g\n"
            f"run {steps}\n")
        _, (snapshots,) = run(commands, grain, 1, ("state.txt",))
        rows = np.array(snapshots)[:, 0]
        return 20 * timestep * np.arange(len(rows)), rows[:, 2] / self.INERTIA, rows[:, 1]

    def check_stop(self, words, limit, stiffness):
        """The couple of the limit slows the grain down; then it turns back and forth about the place at which the spring holds it."""
        times, spins, heights = self.spins(words, spin=1.0)
        np.testing.assert_allclose(heights, 0.3 - self.DEPTH, rtol=0, atol=1e-12)
        slowing = limit / self.INERTIA
        stop = 1.0 / slowing
        self.assertLess(stop, 0.7 * times[-1])
        before = times < 0.95 * stop
        # The spring reaches the limit after less than a step's time of 1e-3; it bends by limit/stiffness before.
        np.testing.assert_allclose(spins[before], 1.0 - slowing * times[before], rtol=0, atol=2 * slowing * (1e-3 + limit / stiffness))
        self.assertLess(np.abs(spins[-100:]).max(), 1e-6, "the grain is at rest")
        free = self.spins("")[1]
        np.testing.assert_allclose(free, 2.0, rtol=1e-12)

    def test_sds(self):
        self.check_stop("twisting sds 20 0.5 0.05", 0.05 * self.MASS, 20)

    def test_marshall(self):
        """The contact's radius a of a flat grain is the root of its radius of curvature times the depth."""
        size = np.sqrt(self.RADIUS * self.DEPTH)
        friction, spring = 4.0, 2e6
        # The damper is that of viscoelastic damping, which is zero without normal damping: velocity 100.
        words = f"tangential linear_history {spring} 20 {friction}"
        law = f"damping velocity {words} twisting marshall"
        times, spins, _ = self.spins(law.replace("damping velocity ", ""))
        slowing = 2 / 3 * size * friction * self.MASS / self.INERTIA
        before = times < 0.9 * 2.0 / slowing
        self.assertGreater(before.sum(), 100)
        np.testing.assert_allclose(spins[before], 2.0 - slowing * times[before], rtol=0, atol=0.02)

    def test_spring(self):
        """Below the limit the spring makes the grain swing with the frequency √(k/I), and keeps its energy."""
        stiffness = 40.0
        times, spins, _ = self.spins(f"twisting sds {stiffness} 0 100", spin=0.5, steps=10000)
        frequency = np.sqrt(stiffness / self.INERTIA)
        # Verlet's frequency is too large by (ω dt)²/24 = 1.4e-5 of itself.
        np.testing.assert_allclose(spins, 0.5 * np.cos(frequency * times), rtol=0, atol=0.5 * frequency * times[-1] * 3e-5)

    def test_energy(self):
        """The energy of spin and spring changes with the square of the time step."""
        errors = []
        for timestep in (1e-3, 5e-4):
            times, spins, _ = self.spins("twisting sds 40 0 100", spin=0.5, steps=round(2 / timestep), timestep=timestep)
            errors.append(np.abs(spins - 0.5 * np.cos(np.sqrt(40 / self.INERTIA) * times)).max())
        self.assertGreater(errors[0] / errors[1], 3.5, errors)


class Ellipsoids(unittest.TestCase):
    def grains(self):
        return lattice(Grains, 4, 1.0, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)

    LAW = f"hooke 10000 20 damping mass_velocity tangential linear_history 4000 0.5 0.4 {SDS}"

    def test_new_lists_and_restart(self):
        """Springs follow their pairs through new lists, other processors and a restart file."""
        grains = dataclasses.replace(self.grains(), velocities=self.grains().velocities + [20.0, 13.0, -7.0])
        for law in (self.LAW, self.LAW + " rolling sds 3000 5 0.1"):
            expected = move(grains, granular(law), 150, first_half="pause")[-1]
            found = move(grains, granular(law), 150, 2, "on", "middle")[-1]
            cell = np.diag(grains.cell)
            found[:, 1:4] -= cell * np.round((found[:, 1:4] - expected[:, 1:4]) / cell)
            np.testing.assert_allclose(found[:, 1:7], expected[:, 1:7], rtol=0, atol=1e-9 * 30.0)

    def test_angular_momentum(self):
        """Couples of both grains of a contact are opposite."""
        rows = move(self.grains(), granular(self.LAW), 150)[-1]
        np.testing.assert_allclose(rows[:, 7:10].sum(axis=0), 0, rtol=0, atol=1e-10 * np.abs(rows[:, 7:10]).max())

    def test_errors(self):
        start = preamble(self.grains()) + "comm_modify vel yes\npair_style pw85/granular\n"
        for words, message in {
            "hooke 1 0 twisting marshall": "has twisting marshall, which follows from the tangential spring",
            "hooke 1 0 tangential linear_nohistory 1 0.5 twisting marshall": "has twisting marshall",
            "hooke 1 0 twisting sds 0 1 1": "twisting stiffness of zero",
            "hooke 1 0 twisting sds 1 1": "lacks coefficient of twisting friction",
            "hooke 1 0 twisting disc": "unknown twisting law disc: use one of marshall, none, sds",
        }.items():
            self.assertIn(message, failure(f"{start}pair_coeff * * {words}\nrun 1\n", self.grains()))
        mixed = "pair_coeff 1 1 hooke 1 0 twisting sds 1 1 1\npair_coeff 2 2 hooke 1 0\nrun 1\n"
        self.assertIn("cannot be mixed, because their words differ", failure(start + mixed, self.grains()))


if __name__ == "__main__":
    unittest.main()
