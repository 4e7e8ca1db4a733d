# SPDX-License-Identifier: GPL-2.0-only
"""What grains do to walls: forces, torques, contacts, loads on triangles; walls that follow their load or variables."""

import dataclasses
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from lammps_runs import failure, preamble, run, thermo
from scipy.integrate import solve_ivp
from test_granular import SHAPES, Grains, granular, lattice, move, script
from test_walls import divided_box, in_large_box, write_text

LAW = "hooke 20000 30 damping mass_velocity tangential linear_history 8000 0.5 0.3 rolling sds 3000 5 0.1"

OUTPUT = """
compute grains all pw85/grains walls
compute overlap all pw85/overlap
dump rows all local {steps} rows.txt c_grains[*]
dump_modify rows format float %.17g
dump atoms all custom {steps} atoms.txt id x y z fx fy fz tqx tqy tqz c_grains c_overlap
dump_modify atoms sort id format float %.17g
{more}
thermo 50
thermo_style custom step {columns}
thermo_modify norm no format float %.17g
run {steps}
"""


def measured(grains, walls, columns, steps=200, ranks=1, newton="on", more="", outputs=("rows.txt", "atoms.txt")):
    """Rows of the thermo output, and the last snapshots of the outputs."""
    commands = script(grains, granular(LAW) + "\n" + walls, steps, newton)
    commands = commands[:commands.index("\ndump state")] + OUTPUT.format(steps=steps, columns=columns, more=more)
    text, dumps = run(commands, grains, ranks, outputs)
    return thermo(text), [dump[-1] for dump in dumps]


def vector(wall, count=13):
    return " ".join(f"f_{wall}[{k + 1}]" for k in range(count))


class Loads(unittest.TestCase):
    """Forces and torques of grains in moving walls add up to those of the walls, so that momentum is conserved."""

    WALLS = ("fix tube all wall/pw85 zcylinder 2.6 at 6.1 5.9 rotate 6.1 5.9 0 0 0 1 0.7 law " + LAW + "\n"
             "fix ends all wall/pw85 zplane 4.2 7.9 wiggle z 0.02 0.13 law " + LAW + "\n")

    def grains(self):
        return in_large_box(lattice(Grains, 4, 1.1, SHAPES, 7, speed=6.0))

    def check(self, ranks, newton):
        rows, (contacts, atoms) = measured(self.grains(), self.WALLS, f"{vector('tube')} {vector('ends')}", ranks=ranks, newton=newton)
        loads, centers, forces, torques = rows[-1, 1:].reshape(2, 13), atoms[:, 1:4], atoms[:, 4:7], atoms[:, 7:10]
        scale = np.abs(forces).max()
        self.assertTrue((loads[:, 6] > 3).all(), loads)
        np.testing.assert_allclose(loads[:, :3].sum(axis=0), -forces.sum(axis=0), rtol=0, atol=1e-11 * scale)
        # The torque of the tube is about a point of its axis, that of the ends about the origin.
        torque = loads[:, 3:6] + np.cross([[6.1, 5.9, 0.0], [0.0, 0.0, 0.0]], loads[:, :3])
        expected = -(np.cross(centers, forces) + torques).sum(axis=0)
        np.testing.assert_allclose(torque.sum(axis=0), expected, rtol=0, atol=1e-10 * scale)
        time = 200 * 0.0005
        phase = 2 * np.pi / 0.13
        np.testing.assert_allclose(loads[1, 7:], [0, 0, 0.02 * (1 - np.cos(phase * time)), 0, 0, 0.02 * phase * np.sin(phase * time)],
                                   rtol=0, atol=1e-12)
        self.check_contacts(contacts, atoms, loads)

    def check_contacts(self, contacts, atoms, loads):
        """Rows with walls have negative numbers of these in place of second tags; all rows together are the forces of all atoms."""
        for wall in (0, 1):
            with_wall = contacts[contacts[:, 1] == -1 - wall]
            self.assertEqual(len(with_wall), loads[wall, 6])
            np.testing.assert_allclose(-with_wall[:, 9:12].sum(axis=0), loads[wall, :3], rtol=1e-11, atol=1e-9)
        forces, counts = np.zeros((64, 3)), np.zeros(64)
        for row in contacts:
            for tag, sign in ((int(row[0]), 1.0), (int(row[1]), -1.0)):
                if tag > 0:
                    forces[tag - 1] += sign * row[9:12]
                    counts[tag - 1] += 1
            offset = row[2:5] - atoms[int(row[0]) - 1, 1:4]
            if row[1] < 0:
                np.testing.assert_allclose(row[12:21].reshape(3, 3), -np.outer(offset, row[9:12]), rtol=0, atol=1e-9)
            self.assertGreater(offset @ row[5:8], 0, "the normal points out of the first grain")
            tangential = row[9:12] - (row[9:12] @ row[5:8]) * row[5:8]
            np.testing.assert_allclose(row[21:24], tangential, rtol=0, atol=1e-10)
            # The force of the spring, 8000 times its length, and of the damper: up to friction 0.3.
            pressure = -row[9:12] @ row[5:8]
            self.assertLessEqual(np.linalg.norm(row[21:24]), 0.3 * np.abs(pressure) * (1 + 1e-9))
            self.assertLess(np.abs(row[24:27] @ row[5:8]), 1e-12)
        np.testing.assert_allclose(forces, atoms[:, 4:7], rtol=0, atol=1e-11 * np.abs(forces).max())
        np.testing.assert_array_equal(counts, atoms[:, 10])
        self.assertGreater((atoms[:, 10] - atoms[:, 11]).sum(), 6)

    def test_loads(self):
        for ranks, newton in ((1, "on"), (2, "on"), (4, "off")):
            with self.subTest(ranks=ranks, newton=newton):
                self.check(ranks, newton)

    def test_springs(self):
        """A sphere that sticks to a plane: its tangential force is minus the stiffness times the spring, without damping."""
        sphere = Grains(np.diag([12.0, 12.0, 12.0]), False, np.array([[6.0, 6.0, 0.49]]), np.full((1, 3), 0.5),
                        np.array([[1.0, 0.0, 0.0, 0.0]]), np.ones(1, dtype=int), np.array([[0.1, 0.05, 0.0]]), np.zeros((1, 3)))
        law = "hooke 20000 0 tangential linear_history 8000 0 0.9"
        _, (contacts, _) = measured(sphere, f"fix floor all wall/pw85 zplane 0 NULL law {law}", "f_floor[3]", steps=10)
        self.assertEqual(contacts[0, 1], -1)
        self.assertGreater(np.abs(contacts[0, 21:23]).max(), 0.1)
        np.testing.assert_allclose(contacts[0, 21:24], -8000 * contacts[0, 24:27], rtol=1e-12, atol=1e-12)


class Triangles(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.file = str(Path(directory.name, "wall.stl"))
        write_text(self.file, divided_box((4.0, 4.0, 4.0), (8.0, 8.0, 8.0), 3))

    def table(self, motion, ranks=1):
        grains = in_large_box(lattice(Grains, 3, 1.25, SHAPES, 7, speed=6.0))
        more = "dump loads all local 200 loads.txt f_box[*]\ndump_modify loads format float %.17g"
        wall = f"fix box all wall/pw85 mesh {self.file} {motion} loads 100 law {LAW}"
        rows, (loads, contacts) = measured(grains, wall, vector("box"), ranks=ranks, more=more, outputs=("loads.txt", "rows.txt"))
        return rows[-1, 1:], loads, contacts[contacts[:, 1] < 0]

    def test_sums(self):
        for ranks in (1, 2, 4):
            load, rows, contacts = self.table("", ranks)
            self.assertEqual(len(rows), 6 * 2 * 9)
            np.testing.assert_array_equal(rows[:, 0], np.arange(len(rows)) + 1)
            self.assertGreater(load[6], 2)
            np.testing.assert_allclose(rows[:, 10:13].sum(axis=0), load[:3], rtol=1e-11, atol=1e-9)
            self.check_rows(rows, contacts)

    def check_rows(self, rows, contacts):
        """Contacts lie in the triangles that carry them, up to the depth; stresses are forces over areas."""
        corners = rows[:, 1:10].reshape(-1, 3, 3)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        areas = 0.5 * np.linalg.norm(normals, axis=1)
        np.testing.assert_allclose(areas, 0.5 * (4 / 3)**2, rtol=1e-12)
        along = np.einsum("nk,nk->n", rows[:, 10:13], normals) / (2 * areas)
        np.testing.assert_allclose(rows[:, 13], along / areas, rtol=1e-11, atol=1e-9)
        across = np.sqrt(np.maximum(0, np.square(rows[:, 10:13]).sum(axis=1) - along**2))
        np.testing.assert_allclose(rows[:, 14], across / areas, rtol=1e-6, atol=1e-4)
        centroids = corners.mean(axis=1)
        loaded = np.flatnonzero(np.abs(rows[:, 10:13]).max(axis=1) > 0)
        self.assertGreater(len(loaded), 2)
        for contact in contacts:
            nearest = np.linalg.norm(centroids[loaded] - contact[2:5], axis=1).min()
            self.assertLess(nearest, 1.1)  # a corner is 4/9 √5 = 0.99 away from the centroid

    def test_moving(self):
        """Corners are those of the wall where it is now."""
        load, rows, _ = self.table("linear 0.5 0 -0.25")
        _, still, _ = self.table("")
        shift = np.tile(0.1 * np.array([0.5, 0, -0.25]), 3)
        np.testing.assert_allclose(rows[:, 1:10], still[:, 1:10] + shift, rtol=0, atol=1e-14 * 8)
        np.testing.assert_allclose(load[7:], [0.05, 0, -0.025, 0.5, 0, -0.25], rtol=0, atol=1e-15)
        _, rows, _ = self.table("rotate 6 6 6 0 0 1 0.4")
        turned = still[:, 1:10].reshape(-1, 3, 3) - 6
        turned = np.stack([-turned[..., 1], turned[..., 0], turned[..., 2]], axis=-1) + 6  # by a quarter
        np.testing.assert_allclose(rows[:, 1:10].reshape(-1, 3, 3), turned, rtol=0, atol=1e-13)


class Motions(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.file = str(Path(directory.name, "wall.stl"))
        write_text(self.file, divided_box((4.0, 4.0, 4.0), (8.0, 8.0, 8.0), 2))

    def states(self, motion, boost=(0.0, 0.0, 0.0), before="", ranks=1, **more):
        grains = in_large_box(lattice(Grains, 3, 1.3, SHAPES, 11, speed=6.0))
        grains = dataclasses.replace(grains, velocities=grains.velocities + boost)
        return move(grains, f"{granular(LAW)}\n{before}fix wall all wall/pw85 mesh {self.file} {motion} law {LAW}", 200, ranks, **more)[-1]

    def compare(self, found, expected):
        for columns in (slice(1, 4), slice(4, 7), slice(7, 10), slice(10, 13)):
            scale = np.abs(expected[:, columns]).max()
            np.testing.assert_allclose(found[:, columns], expected[:, columns], rtol=0, atol=1e-9 * scale)

    def test_linear(self):
        """A box of triangles that flies with its grains is a box at rest."""
        boost = np.array([0.5, 3.0, -2.0])
        for ranks in (1, 2):
            found = self.states("linear 0.5 3.0 -2.0", boost, ranks=ranks)
            found[:, 1:4] -= 0.1 * boost
            found[:, 4:7] -= boost
            self.compare(found, self.states(""))

    VARIABLES = ("variable time equal (step-{start})*dt\nvariable x equal 0.1*(1-cos(2*PI*v_time/0.2))\n"
                 "variable vx equal 0.1*2*PI/0.2*sin(2*PI*v_time/0.2)\n")

    def test_variable(self):
        expected = self.states("wiggle x 0.1 0.2")
        for ranks in (1, 2):
            found = self.states("variable v_x NULL NULL v_vx NULL NULL", before=self.VARIABLES.format(start=0), ranks=ranks)
            self.compare(found, expected)
        found = self.states("variable v_x 0 0 v_vx 0 0", before=self.VARIABLES.format(start=0), first_half="pause")
        self.compare(found, self.states("wiggle x 0.1 0.2", first_half="pause"))

    def test_errors(self):
        grains = in_large_box(lattice(Grains, 2, 1.3, SHAPES, 11))
        start = preamble(grains) + "comm_modify vel yes\npair_style zero 2.0\npair_coeff * *\n"
        for words, message in {
            "zplane 0 NULL servo z -1 1 -2 law hooke 1 0": "bad damping of the servo: -2",
            "zplane 0 NULL variable v_x NULL NULL NULL NULL NULL law hooke 1 0": "there is no equal-style variable x: define it",
            "zplane 0 NULL servo z -1 0 1 law hooke 1 0": "mass of the servo of zero",
            "zplane 0 NULL servo z v_f 1 0 law hooke 1 0": "there is no equal-style variable f: define it",
            "zplane 0 NULL loads 10 law hooke 1 0": "has no triangles for the word loads: use a mesh",
            f"mesh {self.file} loads 0 law hooke 1 0": "bad number of steps between loads: 0",
        }.items():
            with self.subTest(words=words):
                self.assertIn(message, failure(start + f"fix wall all wall/pw85 {words}\nrun 1\n", grains))


class Servo(unittest.TestCase):
    """Lids with a mass that press on grains."""

    FORCE, MASS, STIFFNESS, TIMESTEP = -3.0, 0.8, 2000.0, 2e-4

    def sphere(self):
        return Grains(np.diag([4.0, 4.0, 4.0]), False, np.array([[2.0, 2.0, 0.9]]), np.full((1, 3), 0.5),
                      np.array([[1.0, 0.0, 0.0, 0.0]]), np.ones(1, dtype=int), np.array([[0.0, 0.0, -1.5]]), np.zeros((1, 3)))

    def bounces(self, drag=0.0, force=None, steps=10000, ranks=1, timestep=TIMESTEP, halves=None):
        """Rows: time, place and velocity of the sphere, place and speed of the lid, energy."""
        settings = (
            "pair_style zero 4.0\npair_coeff * *\ncomm_modify vel yes\nneighbor 0.3 bin\nvariable press equal -3.0\n"
            f"variable spring equal {self.FORCE}-6.0*f_lid[10]\n"
            f"fix floor all wall/pw85 zplane 0 NULL law hooke {self.STIFFNESS} 0\n"
            f"fix lid all wall/pw85 zplane NULL 1.6 servo z {force or self.FORCE} {self.MASS} {drag} law hooke {self.STIFFNESS} 0\n"
            f"fix move all nve/asphere\ntimestep {timestep}\ncompute z all reduce sum z\ncompute vz all reduce sum vz\nthermo 50\n"
            "thermo_style custom time c_z c_vz f_lid[10] f_lid[13] f_floor f_lid\nthermo_modify norm no format float %.17g\n")
        commands = preamble(self.sphere()) + settings
        if halves == "pause":
            commands += f"run {steps // 2}\nrun {steps // 2}\n"
        elif halves:
            commands += f"run {steps // 2}\nwrite_restart half.restart\nclear\ninclude {os.environ['PW85_LAMMPS_INCLUDE']}\n"
            commands += f"read_restart half.restart\n{settings}run {steps // 2}\n"
        else:
            commands += f"run {steps}\n"
        text, _ = run(commands.replace("thermo_style custom time", "thermo_style custom step"), self.sphere(), ranks)
        rows = thermo(text)
        rows[:, 0] *= timestep
        return rows

    def expected(self, times, drag=0.0, spring=0.0):
        mass = np.pi / 6

        def slopes(_, y):
            z, v, s, u = y
            floor, lid = self.STIFFNESS * max(0.0, 0.5 - z), self.STIFFNESS * max(0.0, z + 0.5 - (1.6 + s))
            return [v, (floor - lid) / mass, u, (self.FORCE - spring * s + lid - drag * u) / self.MASS]

        return solve_ivp(slopes, (0, times[-1]), [0.9, -1.5, 0, 0], t_eval=times, rtol=1e-10, atol=1e-12, max_step=1e-3).y.T

    def test_equations_of_motion(self):
        for drag in (0.0, 1.5):
            for ranks in (1, 2):
                rows = self.bounces(drag, ranks=ranks, force="v_press" if ranks == 2 else None)
                expected = self.expected(rows[:, 0], drag)
                self.assertGreater(np.ptp(rows[:, 3]), 0.2)
                # Verlet's phases err by (ω dt)²/24 = 6e-6 in each contact, and each of some ten bounces adds to the errors.
                np.testing.assert_allclose(rows[:, 1], expected[:, 0], rtol=0, atol=1e-3)
                np.testing.assert_allclose(rows[:, 3], expected[:, 2], rtol=0, atol=1e-3)

    def test_force_by_own_place(self):
        """A variable that reads the fix has its values of the step before, and the lid still feels the sphere. So a spring acts a step
        late, as a drag of minus its stiffness times the time step, 1.2e-3, which is neglected here."""
        rows = self.bounces(force="v_spring")
        expected = self.expected(rows[:, 0], spring=6.0)
        self.assertLess(rows[:, 3].min(), -0.1)
        np.testing.assert_allclose(rows[:, [1, 3]], expected[:, [0, 2]], rtol=0, atol=1e-2)

    def test_energy(self):
        """The sum of all energies and of the work of the force is conserved, up to the square of the time step."""
        errors = []
        for timestep in (4e-4, 2e-4):
            _, _, v, s, u, floor, lid = self.bounces(steps=round(2 / timestep), timestep=timestep).T
            total = 0.5 * np.pi / 6 * v**2 + 0.5 * self.MASS * u**2 + floor + lid - self.FORCE * s
            errors.append(np.abs(total - total[0]).max())
        self.assertLess(errors[1], 2e-3)
        self.assertGreater(errors[0] / errors[1], 3.0, errors)

    def test_restart(self):
        expected = self.bounces(0.5, halves="pause")
        found = self.bounces(0.5, halves="restart")
        np.testing.assert_allclose(found[-1], expected[-1], rtol=0, atol=1e-12)

    def test_equilibrium(self):
        """Grains carry the force of a lid, 50, to the floor, in the mean over the last third of a run in which they settle.

        Grains in a heap may slip at any time, so that no time is known after which they are at rest. Momentum is exact at all times. By
        velocity Verlet, the sum of the accelerations with half weights at both ends is the change of the velocity. So with the mass M,
        the drag c, the displacement s and the speed u of the lid, the mean load over a time T is 50 + (M Δu + c d)/T. Drag acts at the
        speed of half a step before, so that d = Δs - Δu dt/2, up to dt²/4 times the last acceleration, which is below 1 if loads are
        within 5 of 50: 40 dt²/4/T = 5e-7. For the lid and the walls together, the same holds with the momentum and the drag of the grains.
        """
        grains = dataclasses.replace(in_large_box(lattice(Grains, 3, 1.3, SHAPES, 11, speed=0.1)), periodic=False)
        walls = (f"fix sides all wall/pw85 box 4 8 4 8 3 20 law {LAW}\n"
                 f"fix lid all wall/pw85 zplane NULL 9 servo z -50 5 40 law {LAW}\nfix drag all viscous 2.0\n")
        mean = ("run 20000\nfix mean all ave/time 1 50 50 f_lid[3] f_sides[3]\ncompute z all reduce sum z vz\n"
                "variable p equal mass(all)*vcm(all,z)\n")
        columns = "f_mean[1] f_mean[2] f_lid[3] f_sides[3] f_lid[10] f_lid[13] c_z[1] c_z[2] v_p"
        rows, _ = measured(grains, walls, columns, steps=10000, more=mean)
        first, last = rows[[0, -1], 3:]
        timestep, time = 0.0005, 10000 * 0.0005
        load, support = rows[1:, 1:3].mean(axis=0) + (first[:2] - last[:2]) / 20000
        settled, accelerated, moved, hastened, gained = last[2:] - first[2:]
        drag = 40 * (settled - 0.5 * timestep * accelerated)
        drag_of_grains = 2 * (moved - 0.5 * timestep * hastened)
        self.assertLess(np.abs(rows[:, 3] - 50).max(), 5)
        self.assertLess(last[2], -0.5)
        self.assertLess(abs(settled), 0.01)
        self.assertAlmostEqual(load, 50 + (5 * accelerated + drag) / time, delta=1e-6)
        self.assertAlmostEqual(load + support, -(gained + drag_of_grains) / time, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
