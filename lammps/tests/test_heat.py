# SPDX-License-Identifier: GPL-2.0-only
"""Heat between grains: pairs against closed laws, areas of contacts against the library, conservation, ranks, restart, and errors."""

import ctypes
import dataclasses
import os
import unittest

import numpy as np
from lammps_runs import failure, preamble, run, thermo
from scipy.special import ellipk
from test_granular import Grains, granular, lattice

NO_TURN = [1.0, 0.0, 0.0, 0.0]


def pair_of(semi_axes, centers, quaternions=(NO_TURN, NO_TURN), types=(1, 1), box=8.0, periodic=True):
    """Two grains at rest."""
    still = np.zeros((2, 3))
    return Grains(np.diag([box] * 3), periodic, np.array(centers, dtype=float), np.array(semi_axes, dtype=float),
                  np.array(quaternions, dtype=float), np.array(types), still, still)


TEMPERATURES = """
variable t0 atom {start}
fix heat all pw85/heat {heat}
dump state all custom {every} state.txt id f_heat
dump_modify state sort id format float %.17g
thermo {every}
thermo_style custom step f_heat {columns}
thermo_modify norm no format float %.17g
timestep {timestep}
"""


def temperatures(grains, commands, steps, heat="constant 1.0 temperature 0 start v_t0", start="x", every=1, columns="", timestep=0.01,
                 ranks=1, newton="on", runs=None):
    """Rows of temperatures by step and grain, and the rows of thermo output: step, heat, columns."""
    script = preamble(grains, newton) + "comm_modify vel yes\n" + commands + TEMPERATURES.format(
        heat=heat, start=start, every=every, columns=columns, timestep=timestep)
    text, (snapshots,) = run(script + (runs or f"run {steps}\n"), grains, ranks, ("state.txt",))
    return np.array(snapshots)[:, :, 1], thermo(text)


def hertz_contact(grains):
    """The depth, the radius and the ellipse of the contact of the first two grains, by the library: pw85_hertz_contact() with the normal
    of the least depth, which is that of the pair's symmetry."""
    library = ctypes.CDLL(os.environ["PW85_LIBRARY"])
    forms = [(ctypes.c_double * 6)() for _ in range(2)]
    for k, form in enumerate(forms):
        library.pw85_ellipsoid_quaternion((ctypes.c_double * 3)(*grains.semi_axes[k]), (ctypes.c_double * 4)(*grains.quaternions[k]), form)
    r12 = grains.centers[1] - grains.centers[0]
    depth, radius, ellipse = ctypes.c_double(), ctypes.c_double(), (ctypes.c_double * 2)()
    status = library.pw85_hertz_contact((ctypes.c_double * 3)(*r12), *forms, (ctypes.c_double * 3)(*r12), ctypes.byref(depth), None, None,
                                        None, ctypes.byref(radius), ellipse)
    assert status == 0, status
    return depth.value, radius.value, np.array(ellipse)


class Pairs(unittest.TestCase):
    """Two grains whose contact does not change: the difference of their temperatures falls as (1 - G dt (1/C1 + 1/C2))^n."""

    COEFFICIENT = 3.0

    def check(self, grains, heat, conductance, law="hertz 1 0"):
        words = f"{granular(law)} heat {heat} {self.COEFFICIENT}\n"
        found, rows = temperatures(grains, words, 200, "type 0.7 1.9 temperature 0 start v_t0")
        capacities = grains.masses * np.array([0.7, 1.9])[grains.types - 1]
        rate = conductance * (1 / capacities).sum()
        start = grains.centers[:, 0]
        mean = capacities @ start / capacities.sum()
        steps = np.arange(201)
        for k in range(2):
            expected = mean + (start[k] - mean) * (1 - 0.01 * rate)**steps
            np.testing.assert_allclose(found[:, k], expected, rtol=2e-12, err_msg=heat)
        # This is Euler's method for the exponential law, with an error of (rate dt)² / 2 each step.
        self.assertLess(0.01 * rate, 0.1)
        exact = mean + (start[0] - mean) * np.exp(-0.01 * rate * steps)
        error = np.abs(found[:, 0] - exact).max()
        self.assertLess(error, 0.01 * rate * abs(start[0] - mean))
        self.assertGreater(np.abs(found[-1] - found[0]).max(), 0.05, "heat has flowed")
        np.testing.assert_allclose(rows[:, 1], rows[0, 1], rtol=1e-14)

    def spheres(self):
        return pair_of([[0.5] * 3, [0.7] * 3], [[2.0, 2, 2], [3.1, 2, 2]], types=(1, 2))

    def test_spheres(self):
        """LAMMPS's formulas: 2 k a ΔT and h π a² ΔT with a = √(R δ), for all laws but jkr."""
        size2 = 0.5 * 0.7 / 1.2 * 0.1
        for law in ("hertz 1e-9 0", "hooke 1e-9 0", "dmt 1e-9 0 0.3 1e-9"):
            self.check(self.spheres(), "radius", 2 * self.COEFFICIENT * np.sqrt(size2), law)
            self.check(self.spheres(), "area", self.COEFFICIENT * np.pi * size2, law)

    def test_jkr(self):
        """The radius of the contact is the root of the equation of Johnson, Kendall and Roberts."""
        radius, young, gamma = 0.5 * 0.7 / 1.2, 1e-6, 5e-8
        slope = 2 * np.sqrt(np.pi * gamma * 2 * (1 - 0.3**2) / young)
        size = np.real(max(np.roots([1 / radius, 0, 0, -slope, -0.1]), key=np.real))**2
        self.assertGreater(size, 1.2 * np.sqrt(radius * 0.1))
        law = f"jkr {young} 0 0.3 {gamma}"
        self.check(self.spheres(), "radius", 2 * self.COEFFICIENT * size, law)
        self.check(self.spheres(), "area", self.COEFFICIENT * np.pi * size**2, law)

    def ellipsoids(self):
        """The long axis of one grain is across that of the other, and both are across the line of centres."""
        turn = [np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0]
        return pair_of([[0.5, 0.3, 0.9], [0.6, 0.4, 1.0]], [[2.0, 2, 2], [3.04, 2, 2]], (NO_TURN, turn), (1, 2))

    def test_ellipsoids(self):
        """The area is that of Hertz's ellipse, and the radius that of a disc that conducts as much."""
        grains = self.ellipsoids()
        for quaternions in (grains.quaternions, np.array([NO_TURN, NO_TURN])):
            grains = dataclasses.replace(grains, quaternions=quaternions)
            depth, radius, ellipse = hertz_contact(grains)
            self.assertAlmostEqual(depth, 0.06, delta=1e-12)
            self.check(grains, "area", self.COEFFICIENT * np.pi * np.sqrt(ellipse.prod()) * depth)
            self.check(grains, "radius", 2 * self.COEFFICIENT * np.sqrt(radius * depth))
            # An elliptic disc of constant temperature gives a half-space the heat 2π k b/K(e) for a difference of 1, with the larger
            # semi-axis b; two half-spaces conduct half of it.
            b2, c2 = ellipse.max() * depth, ellipse.min() * depth
            self.assertAlmostEqual(np.pi * np.sqrt(b2) / ellipk(1 - c2 / b2), 2 * np.sqrt(radius * depth), delta=1e-12)
        self.assertGreater(b2, 2 * c2)

    def test_turned_contact(self):
        """The ellipse is that of the new normal where the search for it is restarted: it has turned by a right angle in a step."""
        grains = self.ellipsoids()
        depth, _, ellipse = hertz_contact(grains)
        start = grains.centers - [[0, 0, 0], [1.04, -1.27, 0]]
        moving = dataclasses.replace(grains, centers=start, velocities=np.array([[0, 0, 0], [104.0, -127.0, 0]]))
        commands = granular("hertz 1e-9 0 heat area 3") + "\nneighbor 4.0 bin\nfix move all nve/asphere"
        found, _ = temperatures(moving, commands, 1, start="id")
        conductance = 3 * np.pi * np.sqrt(ellipse.prod()) * depth
        np.testing.assert_allclose(found[1] - found[0], 0.01 * conductance / grains.masses * [1, -1], rtol=1e-9)

    def test_exponential_law(self):
        """The error of the method falls with the time step."""
        errors = []
        for timestep, steps in ((0.02, 100), (0.01, 200)):
            grains = pair_of([[0.5] * 3] * 2, [[2.0, 2, 2], [2.9, 2, 2]])
            found, _ = temperatures(grains, granular("hertz 1e-9 0 heat radius 3"), steps, timestep=timestep)
            rate = 2 * 3.0 * np.sqrt(0.25 * 0.1) * 2 / grains.masses[0]
            errors.append(abs(found[-1, 1] - found[-1, 0] - 0.9 * np.exp(-2 * rate)))
        self.assertAlmostEqual(errors[0] / errors[1], 2.0, delta=0.1)

    def test_end_of_contact(self):
        """Grains that separate keep their temperatures, also where a liquid bridge holds them."""
        grains = self.spheres()
        grains = dataclasses.replace(grains, velocities=np.array([[-1.0, 0, 0], [1.0, 0, 0]]))
        for law in ("hertz 1e-9 0", "hertz 1e-9 0 liquid 1e-9 1 0"):
            found, _ = temperatures(grains, granular(law) + " heat area 3\nfix move all nve/asphere", 100)
            separated = found[7:]  # 2 dt for each step
            self.assertGreater(np.abs(found[4] - found[0]).max(), 0.01)
            np.testing.assert_array_equal(separated, np.tile(found[7], (len(separated), 1)))

    def test_mixed_laws(self):
        """Coefficients of unlike types are geometric means; other words are refused."""
        grains = self.spheres()
        like = "pair_style pw85/granular\npair_coeff 1 1 hertz 1 0 heat area 2\npair_coeff 2 2 hertz 1 0 heat area 8\n"
        expected, _ = temperatures(grains, like + "pair_coeff 1 2 hertz 1 0 heat area 4\n", 20)
        np.testing.assert_allclose(temperatures(grains, like, 20)[0], expected, rtol=1e-14)
        other = like.replace("heat area 8", "heat radius 8")
        self.assertIn("cannot be mixed, because their words differ",
                      failure(preamble(grains) + "comm_modify vel yes\n" + other + "fix h all pw85/heat constant 1 temperature 0\nrun 0\n",
                              grains))

    def test_group(self):
        """Grains outside of the group keep their temperatures, and heat the others."""
        grains = self.spheres()
        commands = granular("hertz 1e-9 0 heat radius 3") + "\ngroup cold id 1\n"
        found, _ = temperatures(grains, commands + "variable ice atom 0\n", 200)
        script = preamble(grains) + "comm_modify vel yes\n" + commands + TEMPERATURES.format(
            heat="constant 1.0 temperature 0 start v_t0", start="x", every=1, columns="", timestep=0.01).replace("heat all", "heat cold")
        _, (snapshots,) = run(script + "run 200\n", grains, 1, ("state.txt",))
        half = np.array(snapshots)[:, :, 1]
        np.testing.assert_array_equal(half[:, 1], 3.1)
        rate = 2 * 3.0 * np.sqrt(0.5 * 0.7 / 1.2 * 0.1) / grains.masses[0]
        np.testing.assert_allclose(half[:, 0], 3.1 - 1.1 * (1 - 0.01 * rate)**np.arange(201), rtol=1e-12)
        self.assertGreater(np.abs(half[-1] - found[-1]).max(), 0.1)


class Walls(unittest.TestCase):
    """A grain on a wall whose temperature is constant, or a variable."""

    def grain(self, semi_axes=(0.5, 0.5, 0.5), place=(4.0, 4.0, 0.45)):
        return Grains(np.diag([8.0] * 3), False, np.array([place]), np.array([semi_axes], dtype=float), np.array([NO_TURN]),
                      np.ones(1, dtype=int), np.zeros((1, 3)), np.zeros((1, 3)))

    def check(self, grain, shape, heat, conductance):
        wall = ("pair_style zero 2\npair_coeff * *\n"
                f"fix wall all wall/pw85 {shape} temperature 10 law hertz 1e-9 0 heat {heat} 3\n")
        found, rows = temperatures(grain, wall, 100, start="1", columns="f_wall[14]")
        capacity = grain.masses[0]
        expected = 10 - 9 * (1 - 0.01 * conductance / capacity)**np.arange(101)
        np.testing.assert_allclose(found[:, 0], expected, rtol=1e-12)
        # The heat that the wall gives in a step is that which the grain gets.
        np.testing.assert_allclose(np.diff(rows[:, 1]), -0.01 * rows[1:, 2], rtol=1e-9)
        self.assertLess(rows[1, 2], -1.0)

    def test_planes(self):
        self.check(self.grain(), "zplane 0 NULL", "radius", 6 * np.sqrt(0.5 * 0.05))
        self.check(self.grain(), "zplane 0 NULL", "area", 3 * np.pi * 0.5 * 0.05)

    def test_cylinders(self):
        """Hertz's ellipse for the sum of the curvatures of the grain and of the wall."""
        library = ctypes.CDLL(os.environ["PW85_LIBRARY"])
        for side, sign, place in (("in", -1.0, 4.0 + 3.0 - 0.45), ("out", 1.0, 4.0 + 3.0 + 0.45)):
            curvatures = (ctypes.c_double * 2)(0.5 / 0.8**2, 0.5 / 0.6**2 + sign / 3.0)
            radius, ellipse = ctypes.c_double(), (ctypes.c_double * 2)()
            library.pw85_hertz(curvatures, ctypes.byref(radius), ellipse)
            grain = self.grain((0.5, 0.6, 0.8), (place, 4.0, 4.0))
            shape = f"zcylinder 3 at 4 4 side {side}"
            self.check(grain, shape, "radius", 6 * np.sqrt(radius.value * 0.05))
            self.check(grain, shape, "area", 3 * np.pi * np.sqrt(ellipse[0] * ellipse[1]) * 0.05)

    def test_variable(self):
        """The temperature of a wall may be a variable, which has its value of the step."""
        wall = ("pair_style zero 2\npair_coeff * *\nvariable hot equal 10+sin(step)\n"
                "fix wall all wall/pw85 zplane 0 NULL temperature v_hot law hertz 1e-9 0 heat radius 3\n")
        found, _ = temperatures(self.grain(), wall, 50, start="1")
        expected, rate = [1.0], 0.01 * 6 * np.sqrt(0.025) / self.grain().masses[0]
        for step in range(1, 51):
            expected.append(expected[-1] + rate * (10 + np.sin(step) - expected[-1]))
        np.testing.assert_allclose(found[:, 0], expected, rtol=1e-12)


    def test_loss(self):
        """What many grains lose in a step is what the walls get, on any number of processors."""
        grains = dataclasses.replace(lattice(Grains, 4, 1.06, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5), periodic=False)
        commands = (f"{granular('hertz 40000 40 damping velocity heat area 2000')}\nneighbor 0.1 bin\nfix move all nve/asphere\n"
                    "fix floor all wall/pw85 zplane 0 NULL temperature 10 law hertz 40000 40 damping velocity heat area 2000\n"
                    "fix sides all wall/pw85 zcylinder 2.8 at 2.12 2.12 temperature 90 law hertz 40000 40 damping velocity heat radius 9\n")
        expected = None
        for ranks in (1, 2, 4):
            found, rows = temperatures(grains, commands, 50, start="50+z", columns="f_floor[14] f_sides[14]", timestep=0.0005, ranks=ranks)
            np.testing.assert_allclose(np.diff(rows[:, 1]), -0.0005 * rows[1:, 2:].sum(axis=1), rtol=1e-6, atol=1e-11)
            self.assertGreater(rows[:, 2].max(), 100.0)
            self.assertLess(rows[:, 3].min(), -0.1)
            expected = found if expected is None else expected
            np.testing.assert_allclose(found, expected, rtol=1e-10)


class Clouds(unittest.TestCase):
    """Many ellipsoids that collide while heat flows."""

    LAW = "hertz 40000 40 damping velocity tangential linear_history 3000 0.5 0.4 heat area 2000"
    HEAT = "type 1.0 2.0 temperature 300 start v_t0"
    START = "300+x*y-z"
    MOVE = "neighbor 0.1 bin\nneigh_modify delay 0\nfix move all nve/asphere\n"

    def grains(self):
        grains = lattice(Grains, 4, 1.06, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)
        return dataclasses.replace(grains, velocities=grains.velocities + [20.0, 13.0, -7.0])

    def found(self, ranks=1, newton="on", runs=None):
        return temperatures(self.grains(), f"{granular(self.LAW)}\n{self.MOVE}", 150, self.HEAT, self.START, 150, "", 0.0005, ranks, newton,
                            runs)

    def test_conservation_and_ranks(self):
        """Grains go to other processors with their temperatures. Orders of sums differ, as for forces."""
        expected, rows = self.found()
        np.testing.assert_allclose(rows[-1, 1], rows[0, 1], rtol=1e-13)
        self.assertGreater(np.abs(expected[-1] - expected[0]).max(), 1.0)
        self.assertLess(np.ptp(expected[-1]), np.ptp(expected[0]))
        for ranks, newton in ((2, "on"), (4, "on"), (4, "off")):
            found, rows = self.found(ranks, newton)
            np.testing.assert_allclose(found, expected, rtol=1e-10)
            np.testing.assert_allclose(rows[-1, 1], rows[0, 1], rtol=1e-13)

    def test_without_motion_bits_are_equal(self):
        """Temperatures do not act on forces: grains move with the same bits as without heat."""
        dump = "dump f all custom 50 f.txt id x y z vx vy vz fx fy fz\ndump_modify f sort id format float %.17g\ntimestep 0.0005\nrun 50\n"
        start = preamble(self.grains()) + "comm_modify vel yes\n"
        states = []
        for heat, fix in (("", ""), ("heat area 2000", "fix heat all pw85/heat constant 1 temperature 3\n"), ("heat none", "")):
            law = self.LAW.replace("heat area 2000", heat)
            _, (snapshots,) = run(f"{start}{granular(law)}\n{self.MOVE}{fix}{dump}", self.grains(), 1, ("f.txt",))
            states.append(snapshots[-1])
        np.testing.assert_array_equal(states[1], states[0])
        np.testing.assert_array_equal(states[2], states[0])

    def test_flows(self):
        """The column of compute pw85/grains is the heat that fix pw85/heat adds to each grain, and that the fix takes from the walls."""
        grains = dataclasses.replace(self.grains(), periodic=False)
        law = self.LAW + "\n"
        commands = (f"{granular(law)}{self.MOVE}fix floor all wall/pw85 zplane 0 NULL temperature 10 law {law}"
                    f"fix side all wall/pw85 zcylinder 2.8 at 2.12 2.12 temperature 500 law {law.replace('area 2000', 'radius 9')}"
                    "compute contacts all pw85/grains walls\ndump flows all local 1 flows.txt c_contacts[1] c_contacts[2] c_contacts[28]\n"
                    "dump_modify flows format float %.17g\n")
        script = commands + TEMPERATURES.format(heat=self.HEAT, start=self.START, every=1, timestep=0.0005,
                                                columns="f_floor[14] f_side[14]")
        capacities = grains.masses * np.array([1.0, 2.0])[grains.types - 1]
        for ranks, newton in ((1, "on"), (2, "off")):
            text, (states, flows) = run(f"{preamble(grains, newton)}comm_modify vel yes\n{script}run 40\n", grains, ranks,
                                        ("state.txt", "flows.txt"))
            walls = thermo(text)[:, 2:]
            num_pairs = 0
            for k in range(1, 41):
                first, second = flows[k][:, :2].astype(int).T
                heat, gained = flows[k][:, 2], np.zeros(len(grains.centers))
                np.add.at(gained, first - 1, heat)
                pairs = second > 0
                np.add.at(gained, second[pairs] - 1, -heat[pairs])
                change = capacities * (states[k][:, 1] - states[k - 1][:, 1])
                # Temperatures of some 300 are rounded.
                np.testing.assert_allclose(0.0005 * gained, change, rtol=0, atol=1e-13 * 300)
                taken = [-heat[second == -wall].sum() for wall in (1, 2)]
                np.testing.assert_allclose(taken, walls[k], rtol=1e-10, atol=1e-9)
                num_pairs += np.count_nonzero(heat[pairs])
            self.assertGreater(num_pairs, 1000)
            self.assertTrue((np.abs(walls).max(axis=0) > 1.0).all())

    def test_restart(self):
        """Also on another number of processors. A new start is that of the file, not of the command."""
        expected, _ = self.found(runs="run 75\nrun 75\n")
        again = (preamble(self.grains()).replace("read_data system.data", "read_restart half.restart")
                 .replace("units lj\natom_style ellipsoid\n", "") + "comm_modify vel yes\n" + f"{granular(self.LAW)}\n{self.MOVE}"
                 + TEMPERATURES.format(heat=self.HEAT, start="7", every=150, columns="", timestep=0.0005))
        found, _ = self.found(2, runs=f"run 75\nwrite_restart half.restart\nclear\n{again}run 75\n")
        np.testing.assert_allclose(found[-1], expected[-1], rtol=1e-10)

    def test_new_grains(self):
        """Grains that fix pw85/pour inserts have the temperature of the command."""
        grains = self.grains()
        box = np.diag([4.24, 4.24, 12.0])
        grains = dataclasses.replace(grains, cell=box)
        commands = (f"{granular(self.LAW)}\n{self.MOVE}region top block 0.5 3.5 0.5 3.5 8 11\n"
                    "fix pour all pw85/pour 5 1 region top grain 1 0.5 0.5 0.5 every 10 count 5\n")
        script = preamble(grains) + "comm_modify vel yes\n" + commands + TEMPERATURES.format(
            heat="constant 1 temperature 42 start v_t0", start="300", every=10, columns="", timestep=0.0005) + "run 20\n"
        for ranks in (1, 2):
            _, (snapshots,) = run(script, grains, ranks, ("state.txt",))
            self.assertEqual(len(snapshots[-1]), 69)
            np.testing.assert_array_equal(snapshots[-1][64:, 1], 42.0)
            self.assertGreater(snapshots[-1][:64, 1].min(), 299.0)

    def test_time_step(self):
        """A warning names the time step below which each new temperature is a mean of those before."""
        grains = pair_of([[0.5] * 3] * 2, [[2.0, 2, 2], [2.9, 2, 2]])
        conductance = 2 * 3.0 * np.sqrt(0.25 * 0.1)
        limit = grains.masses[0] / conductance
        start = preamble(grains) + "comm_modify vel yes\n" + granular("hertz 1e-9 0 heat radius 3")
        start += "\nfix heat all pw85/heat constant 1 temperature 0\n"
        text, _ = run(f"{start}timestep {1.001 * limit}\nrun 3\n", grains)
        self.assertEqual(text.count("temperatures leave the range"), 1)
        named = float(text.split("use timestep ")[1].split()[0])
        self.assertLessEqual(named, limit)
        self.assertGreater(named, 0.99 * limit)
        self.assertNotIn("WARNING", run(f"{start}timestep {0.999 * limit}\nrun 3\n", grains)[0])

    def test_errors(self):
        start = preamble(self.grains()) + "comm_modify vel yes\n"
        pair = granular("hertz 1 0 heat area 1") + "\n"
        heat = "fix heat all pw85/heat constant 1 temperature 0"
        wall = "pair_style zero 2\npair_coeff * *\nfix w all wall/pw85 zcylinder 3"
        for commands, message in {
            "pair_style pw85/granular\npair_coeff * * hertz 1 0 heat disc": "unknown law of heat disc: use one of area, none, radius",
            "pair_style pw85/granular\npair_coeff * * hertz 1 0 heat area": "lacks heat transfer coefficient",
            "pair_style pw85/granular\npair_coeff * * hertz 1 0 heat radius -1": "bad thermal conductivity: -1",
            pair: "has a law with heat, but grains have no temperatures: add fix pw85/heat",
            f"{pair}{heat}\nfix more all pw85/heat constant 1 temperature 0": "is there more than once",
            f"{pair}{heat} start v_none": "starts from v_none, which is not an atom-style variable",
            f"{pair}variable bad atom 1/(id-7)\n{heat} start v_bad": "Divide by 0",
            f"{pair}{heat}\nrun_style respa 2 2 pair 1": "does not work with run_style respa",
            f"{pair}{heat} start": "lacks an atom-style variable",
            f"{pair}{heat} again": "has too many words",
            f"{pair}fix heat all pw85/heat constant 0 temperature 0": "has a specific heat of zero",
            f"{pair}fix heat all pw85/heat constant 1": "lacks the word temperature",
            f"{pair}fix heat all pw85/heat type 1 temperature 0": "temperature",
            f"{pair}fix heat all pw85/heat 1": "unknown kind of specific heat 1: use one of constant, type",
            f"{wall} law hertz 1 0 heat area 1": "has a law with heat, but no temperature: add temperature T",
            f"{wall} temperature 1 law hertz 1 0": "has a temperature, but its law does not conduct heat",
            f"{wall} temperature NULL law hertz 1 0 heat area 1": "has a bad temperature: NULL",
        }.items():
            with self.subTest(commands=commands):
                self.assertIn(message, failure(f"{start}{commands}\nrun 1\n", self.grains()))
        open_box = dataclasses.replace(self.grains(), periodic=False)
        start = preamble(open_box) + "comm_modify vel yes\n"
        for commands, message in {
            f"{wall} temperature 1 law hertz 1 0 heat area 1": "Fix wall/pw85 has a law with heat, but grains have no temperatures",
            f"{heat}\n{wall} temperature v_no law hertz 1 0 heat area 1": "there is no equal-style variable no",
        }.items():
            self.assertIn(message.lower(), failure(f"{start}{commands}\nrun 1\n", open_box).lower())
        atoms = f"units lj\ninclude {os.environ['PW85_LAMMPS_INCLUDE']}\nregion r block 0 1 0 1 0 1\ncreate_box 1 r\n"
        self.assertIn("needs atoms with masses of their own: use atom_style ellipsoid", failure(atoms + heat))


if __name__ == "__main__":
    unittest.main()
