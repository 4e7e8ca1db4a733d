# SPDX-License-Identifier: GPL-2.0-only
"""What may change between two steps and between two runs: the time step, the numbers of steps and atoms, atoms, processors, bodies."""

import dataclasses
import os
import re
import tempfile
import unittest
from pathlib import Path

import numpy as np
from lammps_runs import failure, preamble, run
from test_granular import Grains, granular, lattice, move, script
from test_walls import divided_box, write_text

# A sphere that nothing moves shows where the wall is: its force is that of the depth alone.
PROBE = """
neighbor 0.3 bin
comm_modify vel yes
pair_style zero 3.0
pair_coeff * *
{wall}
timestep 0.002
dump state all custom 1 state.txt id fx fy fz
dump_modify state sort id format float %.17g
"""
STIFFNESS, RADIUS, AMPLITUDE, PERIOD = 1000.0, 0.5, 0.05, 0.7
# A quarter of a turn takes longer than any run, so that the sphere stays in front of the plane.
TURN = 1.6
LAW = f"law hooke {STIFFNESS} 0"


def probe(place):
    """One sphere at a place in a box of 4³."""
    return Grains(np.diag([4.0, 4.0, 4.0]), False, np.array([place]), np.full((1, 3), RADIUS), np.array([[1.0, 0.0, 0.0, 0.0]]),
                  np.ones(1, dtype=int), *np.zeros((2, 1, 3)))


def wiggled(time):
    """The force of a plane that goes up from z = 1.8 on a sphere at z = 2.2, and further."""
    return STIFFNESS * (1.8 + AMPLITUDE * (1.0 - np.cos(2.0 * np.pi * time / PERIOD)) + RADIUS - 2.2) * np.array([0.0, 0.0, 1.0])


def rotated(time):
    """The force of a plane through (2, 2, 2) that turns about the y axis, on a sphere at (2, 2, 2.4)."""
    angle = 2.0 * np.pi * time / TURN
    normal = np.array([np.sin(angle), 0.0, np.cos(angle)])
    return STIFFNESS * max(RADIUS - 0.4 * normal[2], 0.0) * normal


class Time(unittest.TestCase):
    """Walls move with the time that passes in the steps of runs."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.file = str(Path(directory.name, "wall.stl"))
        write_text(self.file, divided_box((0.5, 0.5, 0.3), (3.5, 3.5, 1.8), 2))

    def walls(self):
        wiggle = f"wiggle z {AMPLITUDE} {PERIOD}"
        return ((f"zplane 1.8 NULL {wiggle}", (2.0, 2.0, 2.2), wiggled),
                (f"box 0.5 3.5 0.5 3.5 0.3 1.8 side out {wiggle}", (2.0, 2.0, 2.2), wiggled),
                (f"mesh {self.file} {wiggle}", (2.0, 2.0, 2.2), wiggled),
                (f"zplane 2 NULL rotate 2 2 2 0 1 0 {TURN}", (2.0, 2.0, 2.4), rotated))

    def check(self, commands, times, walls=None):
        """The forces at the steps of a run that follows some commands."""
        for shape, place, force in walls or self.walls():
            wall = f"fix wall all wall/pw85 {shape} {LAW}"
            sphere = probe(place)
            found = run(preamble(sphere) + PROBE.format(wall=wall) + commands.replace("WALL", wall), sphere, 1, ("state.txt",))[1][0]
            forces = np.array([rows[0, 1:] for rows in found])
            self.assertGreater(np.ptp(forces[:, 2]), 10.0, "the wall hardly moves")
            # The place of the wall errs by some u, and the time by some u times the number of changes.
            np.testing.assert_allclose(forces, [force(time) for time in times], rtol=0, atol=1e-11 * STIFFNESS, err_msg=shape)

    def test_time_step(self):
        before, after = 0.002 * np.arange(71), 0.14 + 0.0005 * np.arange(101)
        for runs in ("run 100", "run 30 pre no\nrun 70 pre no"):
            self.check(f"run 70\ntimestep 0.0005\n{runs}\n", [*before, *after[1:]])

    def test_number_of_the_step(self):
        """Numbers of steps forwards and backwards; LAMMPS forbids them while a dump is on."""
        again = "dump state all custom 1 state.txt id fx fy fz\ndump_modify state sort id format float %.17g\n"
        for number in (0, 1000):
            self.check(f"run 70\nundump state\nreset_timestep {number}\n{again}run 100\n", 0.14 + 0.002 * np.arange(101))

    def test_minimize(self):
        """The iterations of a minimiser take no time."""
        self.check("run 70\nundump state\nfix still all setforce 0 0 0\nminimize 0 0 10 10\nunfix still\n"
                   "dump state all custom 1 state.txt id fx fy fz\ndump_modify state sort id format float %.17g\nrun 50\n",
                   0.14 + 0.002 * np.arange(51))

    def test_restart(self):
        """A restart file has the time, at other numbers of steps and with other time steps than later."""
        start = (f"run 30\ntimestep 0.001\nrun 40\nwrite_restart half.restart\nclear\ninclude {os.environ['PW85_LAMMPS_INCLUDE']}\n"
                 "read_restart half.restart\nreset_timestep 5\n")
        self.check(start + PROBE.replace("0.002", "0.003").format(wall="WALL") + "run 60\n", 0.1 + 0.003 * np.arange(61))

    def test_steps_that_vary(self):
        """A fix that changes the time step during a run. Beside the probe a sphere moves faster and faster."""
        pair = dataclasses.replace(
            probe((2.0, 2.0, 2.2)), centers=np.array([[2.0, 2.0, 2.2], [0.5, 1.0, 3.0]]), semi_axes=np.full((2, 3), RADIUS),
            quaternions=np.array([[1.0, 0.0, 0.0, 0.0]] * 2), types=np.array([1, 2]),
            velocities=np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), spins=np.zeros((2, 3)))
        commands = (PROBE.format(wall=f"group probe type 1\nfix wall probe wall/pw85 zplane 1.8 NULL wiggle z {AMPLITUDE} {PERIOD} {LAW}")
                    + "group mover type 2\nfix pull mover addforce 30 0 0\nfix move mover nve/asphere\n"
                    "fix steps mover dt/reset 5 0.0001 0.004 0.004\nvariable dt equal dt\n"
                    'fix dts all print 1 "$(dt:%.17g)" file steps.txt screen no\nrun 150\n')
        text, (states, steps) = run_with_file(preamble(pair) + commands, pair)
        self.assertGreater(len(set(steps)), 5, text)
        # `fix print` prints after the step; the time step that it prints is that of the next one.
        times = np.concatenate([[0.0], np.cumsum(steps[:-1])])
        found = [rows[0, 3] for rows in states]
        np.testing.assert_allclose(found, [wiggled(t)[2] for t in times], rtol=0, atol=1e-11 * STIFFNESS)

    def test_rerun(self):
        """The states of a rerun are at the times that follow from the numbers of their steps."""
        sphere = probe((2.0, 2.0, 2.2))
        wall = f"fix wall all wall/pw85 zplane 1.8 NULL wiggle z {AMPLITUDE} {PERIOD} {LAW}"
        dump = "dump state all custom 1 {} id x y z fx fy fz\ndump_modify state sort id format float %.17g\n"
        commands = (preamble(sphere) + PROBE.format(wall=wall) + "undump state\n" + dump.format("first.txt") +
                    "run 150\nundump state\n" + dump.format("again.txt") + "rerun first.txt every 10 dump x y z\n")
        found = run(commands, sphere, 1, ("again.txt",))[1][0]
        np.testing.assert_allclose([rows[0, 6] for rows in found], [wiggled(0.02 * k)[2] for k in range(16)], rtol=0,
                                   atol=1e-11 * STIFFNESS)


def run_with_file(commands, system):
    """The text, the dump and the numbers of steps.txt of a run."""
    with tempfile.TemporaryDirectory() as directory:
        file = Path(directory, "steps.txt")
        text, (states,) = run(commands.replace("file steps.txt", f"file {file}"), system, 1, ("state.txt",))
        return text, (states, np.loadtxt(file))


SLIDING = granular("hooke 10000 20 damping mass_velocity tangential linear_history 4000 0.5 0.4")


class Atoms(unittest.TestCase):
    """Springs stay with their pairs, whatever commands do with the numbers of atoms."""

    def grains(self):
        return lattice(Grains, 4, 1.0, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)

    def forces(self, commands, ranks=1):
        """The last positions, forces and torques, in the order of the places."""
        grains = self.grains()
        text = script(grains, SLIDING, 1, "on").split("dump state")[0]
        text += f"run 60\n{commands}\n" + "dump state all custom 1 state.txt id x y z fx fy fz tqx tqy tqz\n" \
            "dump_modify state sort id format float %.17g\nrun 20\n"
        first, *_, last = run(text, grains, ranks, ("state.txt",))[1][0]
        return [rows[np.lexsort(np.round(rows[:, 1:4], 6).T)][:, 1:] for rows in (first, last)]

    def test_reset_atom_ids(self):
        """LAMMPS refuses the command, because the springs store numbers of atoms."""
        grains = self.grains()
        start = script(grains, SLIDING, 1, "on").split("dump state")[0]
        self.assertIn("stor", failure(start + "run 60\nreset_atom_ids sort yes\nrun 1\n", grains).split("ERROR")[1])

    def test_history_is_gone(self):
        """Without the fix that keeps the contacts, a run stops with an error that names it."""
        grains = self.grains()
        start = script(grains, SLIDING, 1, "on").split("dump state")[0]
        printed = failure(start + "run 0\nunfix PW85_HISTORY_0\nrun 0\n", grains)
        self.assertIn("fix PW85_HISTORY_0, which keeps the contacts, is missing", printed)

    def test_no_law(self):
        """The error names all laws."""
        start = script(self.grains(), SLIDING, 1, "on").split("dump state")[0]
        printed = failure(re.sub(r"pair_coeff .*", "pair_coeff * *", start), self.grains()).split("ERROR")[1]
        for law in ("hooke K ETA", "hertz K ETA", "hertz/material E ETA NU", "dmt E ETA NU GAMMA", "jkr E ETA NU GAMMA"):
            self.assertIn(law, printed)

    def test_delete_atoms(self):
        """The command renumbers the remaining atoms, unless it says `compress no`."""
        removed = "group gone id 1:30:7 41\ndelete_atoms group gone compress {}"
        for ranks in (1, 2):
            found, expected = (self.forces(removed.format(words), ranks) for words in ("yes", "no"))
            for a, b in zip(found, expected, strict=True):
                self.assertEqual(len(a), 58)
                np.testing.assert_allclose(a, b, rtol=0, atol=1e-9 * np.abs(b).max())

    def test_number_of_a_removed_atom(self):
        """A new atom with the number of a removed one at its place has no springs: forces are those with a new number."""
        last = self.grains().centers[-1]
        new = "create_atoms {0} single {1} {2} {3}\nset atom {4} shape 1 1 1.2\nset atom {4} mass 0.6\nset atom {4} quat 1 0 0 90"
        removed = "group gone id 64\ndelete_atoms group gone compress no\n"
        words = self.grains().types[-1], *last
        found, expected = (self.forces(commands) for commands in (
            removed + new.format(*words, 64), "create_atoms 1 single 0.01 0.01 0.01\nset atom 65 shape 1e-9 1e-9 1e-9\n"
            "group gone id 64\ndelete_atoms group gone compress no\n" + new.format(*words, 66) +
            "\ngroup far id 65\ndelete_atoms group far compress no"))
        np.testing.assert_allclose(found[0], expected[0], rtol=0, atol=1e-9 * np.abs(expected[0]).max())


class Rerun(unittest.TestCase):
    """A rerun gives the forces of the run for laws without springs, and knows no springs."""

    DUMP = "dump state all custom 10 {} id x y z vx vy vz fx fy fz\ndump_modify state sort id format float %.17g\n"

    def spheres(self):
        spheres = lattice(Grains, 4, 1.0, [[0.5, 0.5, 0.5], [0.52, 0.52, 0.52]], 5)
        return dataclasses.replace(spheres, velocities=spheres.velocities + [20.0, 13.0, -7.0], spins=0.0 * spheres.spins,
                                   periodic=True)

    def forces(self, law, ranks, after_run=True):
        """The forces of the run and those of the rerun."""
        spheres = self.spheres()
        pair = granular(law) + f"\nfix wall all wall/pw85 zplane 0.05 3.95 law {law}"
        start = script(spheres, pair, 1, "on").split("dump state")[0].replace("timestep 0.0005", "timestep 0.0002")
        again = "set group all angmom 0 0 0\n" if after_run else f"clear\n{start}"
        text = (start + self.DUMP.format("first.txt") + "run 100\nundump state\n" + again + self.DUMP.format("again.txt") +
                "rerun first.txt dump x y z vx vy vz\n")
        return [np.array(states)[:, :, 7:] for states in run(text, spheres, ranks, ("first.txt", "again.txt"))[1]]

    def test_without_springs(self):
        for ranks in (1, 4):
            first, again = self.forces("hooke 10000 0", ranks)
            self.assertEqual(len(again), 11)
            # Positions are wrapped into the box, which changes depths by some u times its edge, 4, and the stiffness is 10000.
            np.testing.assert_allclose(again, first, rtol=0, atol=1e-10)

    def test_springs(self):
        law = "hooke 10000 20 damping mass_velocity tangential linear_history 4000 0.5 0.4"
        after_run, alone = (self.forces(law, 2, after_run)[1] for after_run in (True, False))
        np.testing.assert_allclose(after_run, alone, rtol=0, atol=1e-9 * np.abs(alone).max())


class Tiles(unittest.TestCase):
    """`comm_style tiled`, on domains of unequal sizes."""

    def test_springs(self):
        grains = lattice(Grains, 4, 1.0, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)
        grains = dataclasses.replace(grains, velocities=grains.velocities + [20.0, 13.0, -7.0])
        law = SLIDING + "\nfix wall all wall/pw85 zplane 0.05 3.95 law hooke 10000 20 tangential linear_history 4000 0.5 0.4"
        expected = move(grains, law, 200)[-1]
        cell = np.diag(grains.cell)
        for ranks, newton in ((2, "on"), (4, "on"), (4, "off")):
            found = move(grains, f"{law}\ncomm_style tiled\nbalance 1.0 rcb", 200, ranks, newton)[-1]
            found[:, 1:4] -= cell * np.round((found[:, 1:4] - expected[:, 1:4]) / cell)
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9 * np.abs(expected).max(), err_msg=f"{ranks} {newton}")


class Rigid(unittest.TestCase):
    """Grains of a rigid body are as heavy as the body. Damping by mass shows it."""

    DAMPING, STIFFNESS, DEPTH, SPEED = 30.0, 1000.0, 0.01, 2.0

    def forces(self, fix, start, ranks):
        """Two pairs of spheres, of which the first spheres are a rigid body; the second ones are above them and go down. Below the first
        one is a plane, in which it is, too."""
        radius, up = 0.5, np.array([0.0, 0.0, 1.0])
        gap = 2.0 * radius - self.DEPTH
        centers = np.array([[2.0, 2.0, radius - self.DEPTH], [3.0, 2.0, 1.0], [2.0, 2.0, radius - self.DEPTH + gap], [3.0, 2.0, 1.0 + gap]])
        grains = Grains(np.diag([6.0, 6.0, 6.0]), False, centers, np.full((4, 3), radius), np.array([[1.0, 0, 0, 0]] * 4),
                        np.array([1, 1, 2, 2]), -self.SPEED * np.outer([1, 1, 3, 3], up), np.zeros((4, 3)))
        law = f"hooke {self.STIFFNESS} {self.DAMPING} damping mass_velocity"
        # An exclusion, because the spheres of the body touch.
        pair = (granular(law) + f"\nfix wall all wall/pw85 zplane 0.0 NULL law {law}\nneigh_modify exclude type 1 1 exclude type 2 2\n"
                f"group body type 1\ngroup free type 2\n{start}fix rigid body {fix}")
        commands = script(grains, pair, 1, "on").replace("fix move all", "fix move free")
        commands = commands.replace("read_data", "atom_modify map yes\ncomm_modify cutoff 3.0\nread_data")
        return grains.masses[0], run(commands, grains, ranks, ("state.txt",))[1][0][0][:, 7:10]

    def test_masses(self):
        small = "rigid/small custom i_body", "fix body all property/atom i_body ghost yes\nset type 1 i_body 1\n"
        for fix, start in (("rigid single", ""), small):
            for ranks in (1, 2):
                mass, found = self.forces(fix, start, ranks)
                body = 2.0 * mass
                pair = self.STIFFNESS * self.DEPTH + self.DAMPING * (mass * body / (mass + body)) * 2.0 * self.SPEED
                wall = self.STIFFNESS * self.DEPTH + self.DAMPING * body * self.SPEED
                expected = np.outer([wall - pair, -pair, pair, pair], [0.0, 0.0, 1.0])
                # Depths have errors of some u times the largest coordinate, 3.
                np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * self.STIFFNESS, err_msg=f"{fix} {ranks}")


if __name__ == "__main__":
    unittest.main()
