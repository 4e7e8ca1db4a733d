# SPDX-License-Identifier: GPL-2.0-only
"""Attraction: spheres against LAMMPS's own styles, ellipsoids in a row against an integration of their equations of motion."""

import ctypes
import dataclasses
import os
import unittest

import numpy as np
from lammps_runs import failure, preamble, release, run, thermo
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq
from test_granular import AgainstLammps, Grains, granular, lattice, move
from test_rolling import AgainstGranular

YOUNG, POISSON = 2e5, 0.3
MODULUS = YOUNG / (2 * (1 - POISSON**2))
# In the release of February 2025, each resistance to rolling and twisting has the forces of the formulas, but not both together.
TWISTING = "" if (2022, 1, 1) <= release() < (2026, 1, 1) else " twisting marshall"
FRICTION = "tangential mindlin NULL 0.6 0.5 rolling sds 3000 5 0.1" + TWISTING


def without_tsuji(*laws):
    """The laws that LAMMPS has: releases from 2022 on refuse tsuji with attraction."""
    return [law for law in laws if release() < (2022, 1, 1) or "tsuji" not in law]


class AgainstCohesion(unittest.TestCase):
    """The deepest overlaps of these spheres press with some 200. The surface energies give pull-off forces of up to 100."""

    compare, spheres, check = AgainstLammps.compare, AgainstGranular.spheres, AgainstGranular.check

    def check_pairs(self, law, steps, style="arms granular"):
        theirs, ours = f"pair_style granular\npair_coeff * * {law}{AgainstGranular.LISTS}", granular(law, style) + AgainstGranular.LISTS
        self.check(theirs, ours, 10, 1e-12, 1)
        self.check(theirs, ours, steps, 1e-9, 2)

    def test_dmt(self):
        """In the release of September 2021 the limits of friction of dmt lack the attraction, unlike in its documentation and in later
        releases: there it is compared without friction."""
        for law in without_tsuji(f"dmt {YOUNG} 40 {POISSON} 10 damping velocity", f"dmt {YOUNG} 0.7 {POISSON} 20 damping tsuji"):
            if release() >= (2022, 6, 1):
                self.check_pairs(f"{law} {FRICTION}", 100)
            grains = self.spheres()
            for steps, ranks, tolerance in ((10, 1, 1e-12), (100, 2, 1e-9)):
                theirs = f"pair_style granular\npair_coeff * * {law} tangential linear_nohistory 0 0{AgainstGranular.LISTS}"
                expected = move(grains, theirs, steps)[-1]
                found = move(Grains(**vars(grains)), granular(law) + AgainstGranular.LISTS, steps, ranks)[-1]
                for columns in (slice(1, 4), slice(4, 7), slice(7, 10)):
                    scale = np.abs(expected[:, columns]).max()
                    np.testing.assert_allclose(found[:, columns], expected[:, columns], rtol=0, atol=tolerance * scale, err_msg=law)

    def test_friction_of_dmt(self):
        """Two spheres that slide have the friction of the limit, |F + 2 F_pulloff|."""
        gamma, friction, radius = 10.0, 0.4, 0.25
        spheres = Grains(np.diag([4.0, 4.0, 4.0]), True, np.array([[2.0, 2, 2], [2.0, 2, 2.99]]), np.full((2, 3), 0.5),
                         np.array([[1.0, 0, 0, 0]] * 2), np.ones(2, dtype=int), np.array([[1e-3, 0, 0], [-1e-3, 0, 0]]), np.zeros((2, 3)))
        found = move(spheres, granular(f"dmt {YOUNG} 0 {POISSON} {gamma} tangential linear_history 1e9 0 {friction}"), 1)[-1]
        pull = 4 * np.pi * gamma * radius
        depth = 1.0 - np.linalg.norm(found[1, 1:4] - found[0, 1:4])
        force = 4 / 3 * MODULUS * np.sqrt(radius) * depth**1.5 - pull
        # The normal is along z but for 1e-6.
        np.testing.assert_allclose(found[0, 7:10], [-friction * (force + 2 * pull), 0, -force], rtol=1e-5, atol=1e-9)

    def test_jkr(self):
        """LAMMPS's root of the quartic for the contact's radius has another rounding, which the stiffness turns into errors of forces."""
        for law in without_tsuji(f"jkr {YOUNG} 40 {POISSON} 10 damping velocity {FRICTION}",
                                 f"jkr {YOUNG} 0.7 {POISSON} 20 damping tsuji {FRICTION}",
                                 f"jkr {YOUNG} 40 {POISSON} 10 tangential linear_history 3000 0.5 0.4"):
            self.check_pairs(law, 100)

    def test_jkr_on_walls(self):
        """Between planes. The walls of September 2021 have the modulus E/(2 (1 - ν)), by which E is less there."""
        if release() >= (2022, 1, 1):
            self.skipTest("the moduli of the walls of this release are not known here")
        for damping in ("40 {} 10 damping velocity", "0.7 {} 20 damping tsuji"):
            words = f"{damping.format(POISSON)} tangential linear_history 3000 0.5 0.4 rolling sds 3000 5 0.1 twisting marshall"
            pairs = f"jkr {YOUNG} {words}"
            theirs = f"pair_style granular\npair_coeff * * {pairs}{AgainstGranular.LISTS}\nfix wall all wall/gran granular "
            theirs += f"jkr {YOUNG / (1 + POISSON)} {words} zplane 0.05 3.95"
            ours = granular(pairs, "arms granular") + AgainstGranular.LISTS
            ours += f"\nfix wall all wall/pw85 zplane 0.05 3.95 arms granular law {pairs}"
            self.check(theirs, ours, 10, 1e-12, 1)
            self.check(theirs, ours, 100, 1e-9, 2)

    def test_walls(self):
        """Forces on a plane, which has the material of the sphere. LAMMPS's walls of September 2021 have another modulus."""
        gamma, friction, radius = 10.0, 0.4, 0.5
        sphere = Grains(np.diag([4.0, 4.0, 4.0]), False, np.array([[2.0, 2, 0.49]]), np.full((1, 3), radius), np.array([[1.0, 0, 0, 0]]),
                        np.ones(1, dtype=int), np.array([[1e-3, 0, 0]]), np.zeros((1, 3)))
        law = f"dmt {YOUNG} 0 {POISSON} {gamma} tangential linear_history 1e9 0 {friction}"
        found = move(sphere, f"pair_style zero 2\npair_coeff * *\nfix wall all wall/pw85 zplane 0 NULL law {law}", 1)[-1][0]
        pull = 4 * np.pi * gamma * radius
        force = 4 / 3 * MODULUS * np.sqrt(radius) * (radius - found[3])**1.5 - pull
        np.testing.assert_allclose(found[7:10], [-friction * (force + 2 * pull), 0, force], rtol=1e-9)

    def test_mixing(self):
        """Surface energies and liquids are geometric means, moduli those of Hertz's theory."""
        grains = lattice(Grains, 4, 1.06, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)
        for name in ("dmt", "jkr"):
            like = (f"pair_style pw85/granular\npair_coeff 1 1 {name} 40000 40 0.3 4 liquid 2 0.001 30\n"
                    f"pair_coeff 2 2 {name} 40000 40 0.3 9 liquid 8 0.004 30")
            expected = move(grains, f"{like}\npair_coeff 1 2 {name} 40000 40 0.3 6 liquid 4 0.002 30", 20)[-1]
            np.testing.assert_allclose(move(grains, like, 20)[-1], expected, rtol=0, atol=1e-9 * np.abs(expected).max())

    def test_new_laws(self):
        """Gaps of mixed laws are those of the laws of this run: without liquid, a cutoff of the largest diameter is enough again."""
        grains = lattice(Grains, 4, 1.06, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)
        laws = "pair_style pw85/granular {0}\npair_coeff 1 1 hooke 1000 0 {1}\npair_coeff 2 2 hooke 1000 0 {1}\nrun 0\n"
        start = preamble(grains) + "comm_modify vel yes\n" + laws.format(1.35, "liquid 1 0.001 0")
        self.assertIn("misses contacts", failure(start + laws.format(1.2, "liquid 1 0.001 0"), grains))
        run(start + laws.format(1.2, ""), grains)


class Pair:
    """Two like prolate grains on their common axis, of which one approaches the other."""

    SEMI_AXES = np.array([0.5, 0.5, 0.8])
    RADIUS = 0.5 * 0.25 / 0.8  # half of the radius of curvature at the ends
    MASS = 4 / 3 * np.pi * SEMI_AXES.prod()

    def __init__(self, speed, gap=0.01, quaternions=((1.0, 0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))):
        self.gap = gap
        self.grains = Grains(np.diag([6.0, 6.0, 8.0]), False, np.array([[3.0, 3.0, 3.0], [3.0, 3.0, 4.6 + gap]]),
                             np.tile(self.SEMI_AXES, (2, 1)), np.array(quaternions), np.ones(2, dtype=int),
                             np.array([[0.0, 0.0, speed], [0.0, 0.0, -speed]]), np.zeros((2, 3)))

    def run(self, law, steps, timestep, ranks=1, halves=False):
        """Rows: step, gap between the surfaces, speed of approach, energy, kinetic energy."""
        settings = (f"{granular(law)}\ncomm_modify vel yes\nneighbor 0.1 bin\nfix move all nve/asphere\ntimestep {timestep}\n"
                    "variable gap equal z[2]-z[1]-1.6\nvariable speed equal vz[2]-vz[1]\nthermo 1\n"
                    "thermo_style custom step v_gap v_speed pe ke\nthermo_modify norm no format float %.17g\n")
        commands = preamble(self.grains).replace("atom_style ellipsoid", "atom_style ellipsoid\natom_modify map array") + settings
        if halves:
            commands += f"run {steps // 2}\nwrite_restart half.restart\nclear\n" + preamble(self.grains).replace(
                "read_data system.data", "read_restart half.restart").replace("units lj\natom_style ellipsoid\n", "") + settings
            steps //= 2
        text, _ = run(f"{commands}run {steps}\n", self.grains, ranks)
        return thermo(text)

    def motion(self, force, begin, end, speed, times):
        """The gap, by an integration with the force of attraction as a function of the gap, from the first touch to the end of the
        contact."""
        def slopes(_, y):
            return [y[1], -2 * force(y[0]) / self.MASS]

        def event(gap, direction):
            def reached(_, y):
                return y[0] - gap
            reached.terminal, reached.direction = True, direction
            return reached

        start = (self.gap - begin) / (2 * speed)
        result = np.interp(times, [0, start], [self.gap, begin])
        solution = solve_ivp(slopes, (start, times[-1]), [begin, -2 * speed], rtol=1e-11, atol=1e-14, events=event(end, 1),
                             dense_output=True, max_step=1e-4)
        within = (times > start) & (times <= solution.t[-1])
        result[within] = solution.sol(times[within])[0]
        after = times > solution.t[-1]
        result[after] = solution.y[0, -1] + solution.y[1, -1] * (times[after] - solution.t[-1])
        return result, len(solution.t_events[0]) > 0


class JkrFormulas:
    """Johnson, Kendall and Roberts with the work of adhesion 2γ, by the root of their equation for the radius of the contact."""

    def __init__(self, energy, radius):
        self.energy, self.radius = energy, radius
        self.pull_off_size = np.cbrt(9 * np.pi * energy * radius**2 / (4 * MODULUS))

    def depth(self, size):
        return size**2 / self.radius - 2 * np.sqrt(np.pi * self.energy * size / MODULUS)

    def pull(self, gap):
        """The attraction at a gap between surfaces."""
        size = brentq(lambda a: self.depth(a) + gap, 0.9 * self.pull_off_size, 1.0, xtol=1e-15)
        return -(4 * MODULUS * size**3 / (3 * self.radius) - np.sqrt(16 * np.pi * self.energy * MODULUS * size**3))

    @property
    def end(self):
        return -self.depth(self.pull_off_size)


class Jkr(unittest.TestCase):
    GAMMA = 5.0
    LAW = f"jkr {YOUNG} 0 {POISSON} {GAMMA}"

    def check(self, speed, separates, ranks=(1,), gap=0.01, timestep=5e-6):
        pair, formulas = Pair(speed, gap), JkrFormulas(self.GAMMA, Pair.RADIUS)
        for count in ranks:
            rows = pair.run(self.LAW, 6000, timestep, count)
            times = timestep * rows[:, 0]
            expected, has_ended = pair.motion(formulas.pull, 0.0, formulas.end, speed, times)
            self.assertEqual(has_ended, separates)
            # The contact begins and ends between two steps: each time the speed errs by a force times a step.
            np.testing.assert_allclose(rows[:, 1], expected, rtol=0, atol=2e-3 * np.ptp(expected))
        return rows, formulas

    def test_pull_off(self):
        """Fast grains separate, at a gap beyond their surfaces, with the kinetic energy that this costs less."""
        rows, formulas = self.check(4.0, True, (1, 2))
        self.assertAlmostEqual(formulas.pull(formulas.end), 3 * np.pi * self.GAMMA * Pair.RADIUS, delta=1e-9)
        held = rows[rows[:, 3] != 0.0]
        self.assertGreater(held[:, 1].max(), 0.9 * formulas.end)
        self.assertLess(held[:, 1].max(), formulas.end)
        lost = quad(formulas.pull, 0.0, formulas.end)[0]
        self.assertAlmostEqual(rows[0, 4] - rows[-1, 4], lost, delta=0.02 * lost)

    def test_stick(self):
        """Slow grains stay together, with a constant sum of energies."""
        rows, _ = self.check(0.03, False, gap=1e-4, timestep=2e-5)
        touching = rows[rows[:, 3] != 0.0]
        total = (touching[:, 3] + touching[:, 4])[2:]
        self.assertLess(np.ptp(total), 1e-3 * np.ptp(touching[:, 3]))

    def test_restart(self):
        """A contact of surfaces that are apart is in restart files."""
        pair = Pair(0.03, 1e-4)
        rows = pair.run(self.LAW, 6000, 2e-5)
        held = rows[(rows[:, 1] > 0.1 * JkrFormulas(self.GAMMA, Pair.RADIUS).end) & (rows[:, 2] > 0)]
        steps = int(held[0, 0])
        found = pair.run(self.LAW, 2 * steps, 2e-5, halves=True)
        expected = pair.run(self.LAW, 2 * steps, 2e-5)
        np.testing.assert_allclose(found[-1], expected[-1], rtol=1e-9, atol=1e-12)


class Liquid(unittest.TestCase):
    TENSION, VOLUME, ANGLE = 3.0, 2e-5, np.radians(20)
    LAW = f"hooke 20000 0 liquid {TENSION} {VOLUME} 20"
    END = (1 + ANGLE / 2) * np.cbrt(VOLUME)

    @classmethod
    def bridge(cls, gap, *curvatures):
        """Willett, Adams, Johnson and Seville, eq. 12, for spheres of the radius 2/√(κ1 κ2) with the curvatures of the gap."""
        sphere = 2 / np.sqrt(np.prod(curvatures))
        scaled = max(0.0, gap) / 2 * np.sqrt(sphere / cls.VOLUME)
        return 2 * np.pi * sphere * cls.TENSION * np.cos(cls.ANGLE) / (1 + 2.1 * scaled + 10 * scaled**2)

    @classmethod
    def attraction(cls, *curvatures):
        """That of the bridge less the force of the spring, as a function of the gap."""
        return lambda gap: cls.bridge(gap, *curvatures) - 20000 * max(0.0, -gap)

    def pull(self, gap):
        return self.attraction(*[1 / Pair.RADIUS] * 2)(gap)

    def test_equations_of_motion(self):
        for speed, separates in ((0.9, True), (0.12, False)):
            pair = Pair(speed)
            rows = pair.run(self.LAW, 8000, 2e-5, 2 if separates else 1)
            expected, has_ended = pair.motion(self.pull, 0.0, self.END, speed, 2e-5 * rows[:, 0])
            self.assertEqual(has_ended, separates)
            np.testing.assert_allclose(rows[:, 1], expected, rtol=0, atol=2e-3 * np.ptp(expected))
            held = rows[rows[:, 3] != 0.0]
            total = (held[:, 3] + held[:, 4])[2:]
            self.assertLess(np.ptp(total), 2e-3 * np.ptp(held[:, 3]))
            if separates:
                lost = quad(self.pull, 0.0, self.END)[0]
                self.assertAlmostEqual(rows[0, 4] - rows[-1, 4], lost, delta=0.02 * lost)
                self.assertGreater(held[:, 1].max(), 0.97 * self.END)

    def test_wet_jkr(self):
        """Both attractions add up; the bridge lasts longer than the contact."""
        rows = Pair(0.05, -0.0005).run(f"jkr {YOUNG} 70 {POISSON} 1 damping velocity liquid {self.TENSION} {self.VOLUME} 20", 30000, 5e-6)
        formulas = JkrFormulas(1.0, Pair.RADIUS)
        bridge = self.bridge(0.0, *[1 / Pair.RADIUS] * 2)
        # At rest, both attractions hold each other by the pressure of the contact.
        self.assertAlmostEqual(formulas.pull(rows[-1, 1]) + bridge, 0.0, delta=1e-3 * bridge)

    def test_wet_jkr_apart(self):
        """Where the contact has ended and the bridge has not, the bridge pulls alone."""
        formulas, speed = JkrFormulas(1.0, Pair.RADIUS), 2.0
        self.assertLess(5.0 * formulas.end, self.END)

        def pull(gap):
            bridge = self.pull(max(0.0, gap))
            return bridge + (formulas.pull(gap) if gap < formulas.end else 0.0)

        pair = Pair(speed)
        rows = pair.run(f"jkr {YOUNG} 0 {POISSON} 1 liquid {self.TENSION} {self.VOLUME} 20", 8000, 5e-6)
        expected, has_ended = pair.motion(pull, 0.0, self.END, speed, 5e-6 * rows[:, 0])
        self.assertTrue(has_ended)
        np.testing.assert_allclose(rows[:, 1], expected, rtol=0, atol=2e-3 * np.ptp(expected))
        lost = quad(pull, 0.0, self.END, points=[formulas.end], limit=200)[0]
        self.assertAlmostEqual(rows[0, 4] - rows[-1, 4], lost, delta=0.01 * lost)


class Impact:
    """A grain that hits a wall with its end, and sticks to it or leaves it."""

    SEMI_AXES, STEPS = Pair.SEMI_AXES, 6000
    END = SEMI_AXES[2]
    RADIUS = 2.0 * Pair.RADIUS  # of curvature at the end

    @property
    def mass(self):
        return 4 / 3 * np.pi * self.SEMI_AXES.prod()

    def run_grain(self, law, speed, steps, timestep, shape="zplane 1 NULL", halves=False, ranks=1, slide=0.0):
        """Rows: step, gap, speed, energy of the wall, number of its contacts."""
        grain = Grains(np.diag([6.0, 6.0, 6.0]), False, np.array([[3.0, 3.0, 1.0 + self.END + 0.002]]), np.array([self.SEMI_AXES]),
                       np.array([[1.0, 0.0, 0.0, 0.0]]), np.ones(1, dtype=int), np.array([[slide, 0.5 * slide, -speed]]), np.zeros((1, 3)))
        settings = ("pair_style zero 2\npair_coeff * *\nfix move all nve/asphere\n"
                    f"fix wall all wall/pw85 {shape} law {law}\ntimestep {timestep}\n"
                    f"variable gap equal z[1]-{self.END}-1\nvariable speed equal vz[1]\nthermo 1\n"
                    "thermo_style custom step v_gap v_speed f_wall f_wall[7]\nthermo_modify norm no format float %.17g\n")
        start = preamble(grain).replace("atom_style ellipsoid", "atom_style ellipsoid\natom_modify map array")
        commands = start + settings
        if halves:
            commands += f"run {steps // 2}\nwrite_restart half.restart\nclear\n" + start.replace(
                "read_data system.data", "read_restart half.restart").replace("units lj\natom_style ellipsoid\n", "") + settings
            steps //= 2
        return thermo(run(f"{commands}run {steps}\n", grain, ranks)[0])

    def motion(self, pull, end, speed, times):
        """The gap by an integration, from the first touch to the end of the contact, and the rebound after it."""
        def slopes(_, y):
            return [y[1], -pull(y[0]) / self.mass]

        def ends(_, y):
            return y[0] - end
        ends.terminal, ends.direction = True, 1
        start = 0.002 / speed
        solution = solve_ivp(slopes, (start, times[-1]), [0.0, -speed], rtol=1e-11, atol=1e-14, events=ends, dense_output=True,
                             max_step=1e-4)
        result = np.where(times <= start, 0.002 - speed * times, solution.sol(np.clip(times, start, solution.t[-1]))[0])
        after = times > solution.t[-1]
        result[after] = end + solution.y[1, -1] * (times[after] - solution.t[-1])
        return result, len(solution.t_events[0]) > 0

    def check(self, law, pull, end, speed, separates, timestep=1e-5, shape="zplane 1 NULL"):
        rows = self.run_grain(law, speed, self.STEPS, timestep, shape)
        expected, has_ended = self.motion(pull, end, speed, timestep * rows[:, 0])
        self.assertEqual(has_ended, separates)
        np.testing.assert_allclose(rows[:, 1], expected, rtol=0, atol=2e-3 * np.ptp(expected))
        held = rows[rows[:, 3] != 0.0]
        kinetic = 0.5 * self.mass * rows[:, 2]**2
        total = (held[:, 3] + kinetic[rows[:, 3] != 0.0])[2:]
        self.assertLess(np.ptp(total), 3e-3 * np.ptp(held[:, 3]))
        np.testing.assert_array_equal(rows[:, 4], rows[:, 3] != 0.0)
        if separates:
            self.assertGreater(held[:, 1].max(), 0.9 * end)
            self.assertLess(held[:, 1].max(), end)
            lost = quad(pull, 0.0, end)[0]
            self.assertAlmostEqual(kinetic[0] - kinetic[-1], lost, delta=0.02 * lost)

    def check_restart(self, law, end, speed, shape="zplane 1 NULL"):
        rows = self.run_grain(law, speed, 6000, 1e-5, shape)
        held = rows[(rows[:, 1] > 0.1 * end) & (rows[:, 2] > 0.0) & (rows[:, 3] != 0.0)]
        steps = int(held[0, 0])
        expected, found = (self.run_grain(law, speed, 2 * steps, 1e-5, shape, halves)[-1] for halves in (False, True))
        np.testing.assert_allclose(found[1:], expected[1:], rtol=1e-9, atol=1e-12)
        self.assertLess(expected[2], held[0, 2])


BOXES = {"diagonal": "1 5 1 5 0 1", "face": "0.9 5.5 1 5 0 1", "edge": "3 5 1 5.5 0 1", "corner": "3 5 3 5 0 1"}


class Walls(Impact, unittest.TestCase):
    """Planes, boxes, and triangles with the same surface: a face, a diagonal of a face, an edge and a corner, above each of which a grain
    that falls along the vertical has the curvatures of its end."""

    def test_jkr_on_triangles(self):
        formulas = JkrFormulas(5.0, self.RADIUS)
        for name, box in BOXES.items():
            with self.subTest(name):
                for speed, separates in ((4.0, True), (0.2, False)):
                    self.check(Jkr.LAW, formulas.pull, formulas.end, speed, separates, shape=f"box {box} side out")

    def test_liquid_on_triangles(self):
        for name, box in BOXES.items():
            with self.subTest(name):
                for speed, separates in ((1.5, True), (0.2, False)):
                    self.check(Liquid.LAW, self.liquid, Liquid.END, speed, separates, shape=f"box {box} side out")

    def test_slide_over_triangles(self):
        """A grain that hangs on a surface of triangles slides from one to the next as on a plane, with one contact."""
        # The diagonal of the face is there where (x - 2.21)/2.79 = (y - 1)/4 for x = 3 + 20 t, y = 3 + 10 t.
        crossing = round((2.0 / 4 - 0.79 / 2.79) / (20.0 / 2.79 - 10.0 / 4) / 1e-5)
        for law, speed in ((Jkr.LAW, 0.5), (Liquid.LAW, 0.2)):
            with self.subTest(law):
                expected = self.run_grain(law, speed, 6000, 1e-5, slide=20.0)
                found = self.run_grain(law, speed, 6000, 1e-5, "box 2.21 5 1 5 0 1 side out", slide=20.0)
                np.testing.assert_allclose(found[:, 1:], expected[:, 1:], rtol=0, atol=1e-9)
                held = found[crossing - 20:crossing + 20]
                self.assertTrue((held[:, 4] == 1.0).all(), "the contact lasts")
                self.assertTrue(law == Liquid.LAW or held[:, 1].min() > 1e-5, "the surfaces are apart")

    def test_restart_on_triangles(self):
        for law, end, speed in ((Jkr.LAW, JkrFormulas(5.0, self.RADIUS).end, 4.0), (Liquid.LAW, Liquid.END, 1.5)):
            self.check_restart(law, end, speed, "box 1 5 1 5 0 1 side out")

    def test_no_touch_on_triangles(self):
        for law in (Jkr.LAW, Liquid.LAW):
            rows = self.run_grain(law, -0.1, 500, 1e-5, "box 1 5 1 5 0 1 side out")
            np.testing.assert_array_equal(rows[:, 3], 0.0)

    def test_jkr(self):
        formulas = JkrFormulas(5.0, self.RADIUS)
        self.assertAlmostEqual(formulas.pull(formulas.end), 3 * np.pi * 5.0 * self.RADIUS, delta=1e-9)
        for speed, separates in ((4.0, True), (0.2, False)):
            for shape in ("zplane 1 NULL", "box 1 5 1 5 1 5"):
                self.check(Jkr.LAW, formulas.pull, formulas.end, speed, separates, shape=shape)

    def liquid(self, gap):
        return Liquid.attraction(*[1 / self.RADIUS] * 2)(gap)

    def test_liquid(self):
        for speed, separates in ((1.5, True), (0.2, False)):
            self.check(Liquid.LAW, self.liquid, Liquid.END, speed, separates)

    def test_restart(self):
        """A bridge between surfaces that are apart is in restart files."""
        self.check_restart(Liquid.LAW, Liquid.END, 1.5)

    def test_no_touch(self):
        """A grain that passes within the reach of a bridge, and has not touched the plane, has none."""
        rows = self.run_grain(Liquid.LAW, -0.1, 2000, 1e-5)
        np.testing.assert_array_equal(rows[:, 3], 0.0)
        np.testing.assert_allclose(rows[:, 2], 0.1, rtol=1e-15)


class Cylinders(Impact, unittest.TestCase):
    """Cohesion in and around cylinders, with Hertz's radius for the sum of the curvatures."""

    CYLINDERS = (("out", 0.7), ("in", 2.2))

    def cylinders(self):
        """Words of the wall, and the curvatures of the gap, along x and along y."""
        end = self.SEMI_AXES[2] / np.square(self.SEMI_AXES[:2])
        for side, radius in self.CYLINDERS:
            sign = -1.0 if side == "in" else 1.0
            yield f"xcylinder {radius} at 3 {1.0 - sign * radius} side {side}", (end[0], end[1] + sign / radius)

    def test_jkr(self):
        for shape, curvatures in self.cylinders():
            formulas = JkrFormulas(5.0, hertz_radius(*curvatures))
            for speed, separates in ((4.0, True), (0.2, False)):
                with self.subTest(f"{shape} {speed}"):
                    self.check(Jkr.LAW, formulas.pull, formulas.end, speed, separates, shape=shape)

    def test_liquid(self):
        for shape, curvatures in self.cylinders():
            for speed, separates in ((1.5, True), (0.2, False)):
                with self.subTest(f"{shape} {speed}"):
                    self.check(Liquid.LAW, Liquid.attraction(*curvatures), Liquid.END, speed, separates, shape=shape)

    def test_restart(self):
        for law, end, speed in ((Jkr.LAW, JkrFormulas(5.0, hertz_radius(3.2, 3.2 - 1 / 2.2)).end, 4.0), (Liquid.LAW, Liquid.END, 1.5)):
            self.check_restart(law, end, speed, "xcylinder 2.2 at 3 3.2 side in")

    def test_wide(self):
        """A cylinder of the radius 10⁶ is a plane, but for its curvature, which is 3e-7 of that of the grain."""
        expected = self.run_grain(Liquid.LAW, 1.5, 6000, 1e-5)
        for shape in ("xcylinder 1e6 at 3 -999999 side out", "xcylinder 1e6 at 3 1000001 side in"):
            found = self.run_grain(Liquid.LAW, 1.5, 6000, 1e-5, shape)
            np.testing.assert_allclose(found[:, 1:], expected[:, 1:], rtol=0, atol=1e-6)
            np.testing.assert_array_equal(found[:, 4], expected[:, 4])


class Conformal(Cylinders):
    """A sphere in a cylinder that is hardly wider: the equivalent radius is twice that of the sphere."""

    SEMI_AXES, STEPS = np.array([0.5, 0.5, 0.5]), 3000  # so few that it does not meet the other side
    END = 0.5
    CYLINDERS = (("in", 0.55),)
    test_liquid = test_restart = test_wide = None

    def test_jkr(self):
        ((_, curvatures),) = self.cylinders()
        self.assertGreater(hertz_radius(*curvatures), 2 * 0.5)
        super().test_jkr()


class Bridges(unittest.TestCase):
    """Forces of bridges in gaps with two curvatures, of which one is up to 50 times the other."""

    SEMI_AXES, DEPTH = np.array([0.9, 0.4, 0.3]), 1e-4

    def force(self, places, quaternions, commands):
        count = len(places)
        grains = Grains(np.diag([6.0, 6.0, 6.0]), False, np.array(places), np.tile(self.SEMI_AXES, (count, 1)), np.array(quaternions),
                        np.ones(count, dtype=int), np.zeros((count, 3)), np.zeros((count, 3)))
        return move(grains, commands, 1)[0][-1, 7:10]

    def test_pairs(self):
        """The long axes of both are parallel, or across each other."""
        along, beside = 0.3 / 0.9**2, 0.3 / 0.4**2
        turned = [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]
        for quaternion, curvatures in (([1.0, 0, 0, 0], (2 * along, 2 * beside)), (turned, (along + beside, along + beside))):
            found = self.force([[3.0, 3.0, 2.0], [3.0, 3.0, 2.6 - self.DEPTH]], [[1.0, 0, 0, 0], quaternion], granular(Liquid.LAW))
            np.testing.assert_allclose(found, [0, 0, 20000 * self.DEPTH - Liquid.bridge(0.0, *curvatures)], rtol=1e-10, atol=1e-9)

    def test_walls(self):
        along, beside = 0.3 / 0.9**2, 0.3 / 0.4**2
        for shape, curvatures in (("zplane 1 NULL", (along, beside)), ("box 1 5 1 5 0 1 side out", (along, beside)),
                                  ("xcylinder 0.8 at 3 0.2 side out", (along, beside + 1 / 0.8)),
                                  ("ycylinder 0.8 at 3 0.2 side out", (along + 1 / 0.8, beside)),
                                  ("ycylinder 3 at 3 4 side in", (along - 1 / 3, beside))):
            found = self.force([[3.0, 3.0, 1.3 - self.DEPTH]], [[1.0, 0, 0, 0]],
                               f"pair_style zero 2\npair_coeff * *\nfix wall all wall/pw85 {shape} law {Liquid.LAW}")
            np.testing.assert_allclose(found, [0, 0, 20000 * self.DEPTH - Liquid.bridge(0.0, *curvatures)], rtol=1e-10, atol=1e-9)


def hertz_radius(*curvatures):
    """Hertz's equivalent radius."""
    radius = ctypes.c_double()
    ctypes.CDLL(os.environ["PW85_LIBRARY"]).pw85_hertz((ctypes.c_double * 2)(*curvatures), ctypes.byref(radius), None)
    return radius.value


class Clouds(unittest.TestCase):
    """Many ellipsoids that stick to each other."""

    LAW = f"jkr 40000 40 {POISSON} 5 damping velocity liquid 3 2e-5 20 {FRICTION}"

    def grains(self):
        grains = lattice(Grains, 4, 1.06, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)
        return dataclasses.replace(grains, velocities=grains.velocities + [20.0, 13.0, -7.0])

    def test_ranks_and_restart(self):
        grains = self.grains()
        expected = move(grains, granular(self.LAW), 150, first_half="pause")[-1]
        cell = np.diag(grains.cell)
        for ranks, newton, half in ((2, "on", "middle"), (4, "off", "pause")):
            found = move(grains, granular(self.LAW), 150, ranks, newton, half)[-1]
            found[:, 1:4] -= cell * np.round((found[:, 1:4] - expected[:, 1:4]) / cell)
            np.testing.assert_allclose(found[:, 1:7], expected[:, 1:7], rtol=0, atol=1e-8 * 30.0)
        np.testing.assert_allclose(expected[:, 7:10].sum(axis=0), 0, rtol=0, atol=1e-10 * np.abs(expected[:, 7:10]).max())
        momenta = grains.masses @ grains.velocities
        np.testing.assert_allclose(grains.masses @ expected[:, 4:7], momenta, rtol=1e-11)

    def test_ranks_and_restart_on_walls(self):
        """Grains in a cylinder, on a block of triangles, whose bridges hold them."""
        grains = dataclasses.replace(self.grains(), periodic=False, velocities=lattice(
            Grains, 4, 1.06, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5, speed=2.0).velocities)
        walls = "".join(f"\nfix {name} all wall/pw85 {shape} law {self.LAW}" for name, shape in
                        (("side", "zcylinder 2.8 at 2.12 2.12"), ("floor", "box -1 5 -1 5 -1 0.02 side out")))
        results = [move(grains, granular(self.LAW) + walls, 150, ranks, newton, half)[-1] for ranks, newton, half in
                   ((1, "on", "pause"), (2, "on", "middle"), (4, "off", "end"))]
        dry = move(grains, granular(self.LAW) + walls.replace("liquid 3 2e-5 20", ""), 150, first_half="pause")[-1]
        self.assertGreater(np.abs(dry[:, 4:7] - results[0][:, 4:7]).max(), 0.1, "bridges act")
        for found in results[1:]:
            np.testing.assert_allclose(found[:, 1:7], results[0][:, 1:7], rtol=0, atol=1e-8 * 30.0)

    def test_errors(self):
        start = preamble(self.grains()) + "comm_modify vel yes\n"
        pair = "pair_style pw85/granular\npair_coeff * * "
        wider = "pair_style pw85/granular 1.2\npair_coeff * * "
        for commands, message in {
            f"{pair}dmt 1e5 0 0.3": "lacks surface energy",
            f"{pair}jkr 1e5 0 0.3 0": "has a surface energy of zero",
            f"{pair}jkr 1e5 0 0.3 1 limit_damping": "has limit_damping, which forbids the attraction",
            f"{pair}jkr 1e5 0 0.3 1 conservative": "conservative is not offered with dmt, jkr and liquid",
            f"{pair}hooke 1e5 0 liquid 1 0 10": "has a volume of the liquid of zero",
            f"{pair}hooke 1e5 0 liquid 1 1 100": "bad angle of contact in degrees: 100",
            f"{wider}hooke 1e5 0 liquid 1 0.001 0": "raise the cutoff in pair_style or pair_coeff to 1.3",
        }.items():
            self.assertIn(message, failure(f"{start}{commands}\nrun 1\n", self.grains()))


if __name__ == "__main__":
    unittest.main()
