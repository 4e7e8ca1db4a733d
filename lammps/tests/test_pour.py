# SPDX-License-Identifier: GPL-2.0-only
"""fix pw85/pour: the grains that it inserts, on any number of processors and after restarts."""

import os
import re
import unittest

import numpy as np
from lammps_runs import failure, run, thermo
from scipy import stats

START = """
units lj
atom_style ellipsoid
newton {newton}
boundary {boundary}
include {include}
comm_modify vel yes
region box {box} units box
create_box 2 box
pair_style pw85/granular
pair_coeff * * hertz 1000 1 damping tsuji
{neighbor}
neigh_modify delay 0
timestep 0.005
"""
COMPUTES = """
compute shape all property/atom shapex shapey shapez quatw quati quatj quatk mass
compute overlap all pw85/overlap
dump state all custom {steps} state.txt id type x y z vx vy vz c_shape[*] c_overlap
dump_modify state sort id format float %.17g
thermo 1
thermo_style custom step atoms f_pour f_pour[1] f_pour[2] f_pour[3] f_pour[4]
thermo_modify norm no lost error
"""
MIXTURE = "grain 1 1.0 1.0 1.5 share 2 density 2.0 grain 2 1.2 1.2 0.6 size uniform 0.5 1.0"
REGION = "region filling block 1 7 1 7 1 9 units box"
POUR = "fix pour all pw85/pour 60 4711 region filling " + MIXTURE + " every 10 count 12 attempts 500"
GRAVITY = "fix gravity all gravity 1.0 vector 0 0 -1\nfix move all nve/asphere\n"
WALLS = "fix wall all wall/pw85 box 0.5 7.5 0.5 7.5 0.5 11.5 law hertz 1000 1 damping tsuji\n"


def start(boundary="f f f", box="block 0 8 0 8 0 12", newton="on", neighbor="neighbor 0.3 bin"):
    return START.format(boundary=boundary, box=box, newton=newton, neighbor=neighbor, include=os.environ["PW85_LAMMPS_INCLUDE"])


def poured(commands, steps=60, ranks=1, runs=None, **more):
    """What LAMMPS printed, and the rows of its last dump: id, type, x y z, velocity, diameters, quaternion, mass, overlaps."""
    script = start(**more) + commands + COMPUTES.format(steps=steps) + (runs or f"run {steps}\n")
    text, (snapshots,) = run(script, None, ranks, ("state.txt",))
    return text, snapshots[-1]


class Ranks(unittest.TestCase):
    def test_same_grains(self):
        """Grains that stay where they are have the same bits."""
        commands = f"{REGION}\n{WALLS}{POUR}\n"
        expected = poured(commands)[1]
        self.assertEqual(len(expected), 60)
        self.assertTrue((expected[:, -1] == 0).all())
        for ranks, newton in ((2, "on"), (4, "on"), (4, "off")):
            np.testing.assert_array_equal(poured(commands, ranks=ranks, newton=newton)[1], expected)
        np.testing.assert_array_equal(poured(commands, ranks=2, runs="run 7\nrun 23\nrun 30\n")[1], expected)

    def test_while_grains_fall(self):
        commands = f"{REGION}\n{WALLS}{GRAVITY}{POUR} velocity 0 0 -1\n"
        expected = poured(commands, 200)[1]
        self.assertEqual(len(expected), 60)
        self.assertLess(expected[:, 4].min(), 1.2)
        for ranks in (2, 4):
            found = poured(commands, 200, ranks)[1]
            # The order of sums differs. In these collisions differences grow to less than 1e-10.
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-8)

    def test_sub_domains_of_different_size(self):
        """With comm_style tiled and balance, also while grains with friction move."""
        expected = poured(f"{REGION}\n{WALLS}{POUR}\n")[1]
        tiled = f"comm_style tiled\n{REGION}\n{WALLS}{POUR}\nfix even all balance 20 1.0 rcb\n"
        np.testing.assert_array_equal(poured(tiled, ranks=4)[1], expected)
        law = "pair_coeff * * hertz 1000 1 damping tsuji tangential mindlin 800 1 0.5 rolling sds 100 1 0.1\n"
        falling = f"{law}{REGION}\n{WALLS}{GRAVITY}{POUR} velocity 0 0 -2\n"
        found = poured(falling + "comm_style tiled\nfix even all balance 20 1.0 rcb\n", 300, 4)[1]
        np.testing.assert_allclose(found, poured(falling, 300)[1], rtol=0, atol=1e-6)

    def test_restart(self):
        commands = f"{REGION}\n{WALLS}{POUR}\n"
        expected = poured(commands)[1]
        again = start().split("region box")[0] + "read_restart half.restart\n" + start().split("create_box 2 box\n")[1] + commands
        again += COMPUTES.format(steps=60) + "run 35\n"
        for ranks in (1, 2):
            halves = start() + commands + "run 25\nwrite_restart half.restart\nclear\n" + again
            _, (snapshots,) = run(halves, None, ranks, ("state.txt",))
            np.testing.assert_array_equal(snapshots[-1], expected)

    def test_fewer_than_before_the_restart(self):
        commands = f"{REGION}\n{POUR}\n"
        again = start().split("region box")[0] + "read_restart half.restart\n" + start().split("create_box 2 box\n")[1]
        text = failure(start() + commands + "run 25\nwrite_restart half.restart\nclear\n" + again
                       + commands.replace("pour 60", "pour 20") + "run 1\n")
        self.assertIn("has inserted 36 grains before the restart", text)


class Boxes(unittest.TestCase):
    """Grains overlap neither each other nor walls, whatever the box."""

    def check(self, commands, count, **more):
        for ranks in (1, 2):
            text, rows = poured(commands, ranks=ranks, **more)
            self.assertEqual(len(rows), count)
            self.assertTrue((rows[:, -1] == 0).all())
            if ranks == 1:
                first = rows
            np.testing.assert_array_equal(rows, first)
        return text, rows

    def test_periodic(self):
        region = "region filling block -1 9 -1 9 -1 13 units box"
        _, expected = self.check(f"{region}\n{POUR}\n", 60, boundary="p p p")
        slices = poured(f"{region}\n{POUR}\n", ranks=4, boundary="p p p", newton="on\nprocessors 4 1 1")[1]
        np.testing.assert_array_equal(slices, expected)

    def test_small_periodic(self):
        """Grains touch two images of others, and nearly themselves."""
        region = "region filling block 0 1.7 0 1.7 0 12 units box"
        pour = "fix pour all pw85/pour 200 1 region filling grain 1 0.6 0.6 1.5 every 1 count 200 attempts 2000\n"
        text, rows = poured(f"{region}\n{pour}", 2, boundary="p p p", box="block 0 1.7 0 1.7 0 12")
        self.assertGreater(len(rows), 20)
        self.assertIn("region filling is full", text)
        self.assertTrue((rows[:, -1] == 0).all())

    def test_triclinic(self):
        region = "region filling block 0 8 0 8 0 12 units box"
        self.check(f"{region}\n{POUR}\n", 60, boundary="p p p", box="prism 0 8 0 8 0 12 3 -2 1")
        region = "region filling block 0 2.5 0 8 0 2.5 units box"  # which others touch from the other side of a strongly tilted box
        self.check(f"{region}\n{POUR.replace('60', '15')} attempts 2000\n", 15, boundary="p p p", box="prism 0 8 0 8 0 4 4 -4 4")

    def test_shrink_wrapped(self):
        self.check(f"{REGION.replace('9 units', '30 units')}\n{POUR}\n", 60, boundary="f f s")

    def test_walls(self):
        """The extents along axes of all grains are inside of a box and a cylinder."""
        walls = WALLS + "fix tube all wall/pw85 zcylinder 3.4 at 4 4 law hertz 1000 1\n"
        text, rows = self.check(f"region filling block 0 8 0 8 0 12 units box\n{walls}{POUR}\n", 60)
        self.assertLess(np.hypot(rows[:, 2] - 4, rows[:, 3] - 4).max(), 3.4)
        quaternions, semi_axes = rows[:, 11:15], 0.5 * rows[:, 8:11]
        axes = np.array([rotation(q) for q in quaternions])
        extents = np.sqrt(np.einsum("nij,nj->ni", axes**2, semi_axes**2))
        self.assertGreaterEqual((rows[:, 2:5] - extents).min(), 0.5)
        self.assertLessEqual((rows[:, 2:4] + extents[:, :2]).max(), 7.5)
        self.assertGreater(thermo(text)[-1, 6], 60)

    def grains_at_wall(self, motion, start_of_insertion=39):
        """The grains that a moving block does not push in the step in which they are inserted."""
        wall = f"variable height equal 100*step*dt\nfix block all wall/pw85 box 2 6 2 6 1 3 side out {motion} law hertz 1000 1\n"
        pour = POUR.replace("count 12", "count 60")
        commands = start() + f"{REGION}\n{wall}run {start_of_insertion}\n{pour}\n" + COMPUTES.format(steps=1)
        text, (snapshots,) = run(commands + 'variable e equal f_block\nrun 1\nprint "energy = ${e}"', None, 1, ("state.txt",))
        self.assertEqual(len(snapshots[-1]), 60)
        self.assertIn("energy = 0\n", text)
        return snapshots[-1]

    def test_moving_wall(self):
        """The wall is where it will be when it pushes the grains that are inserted: half a period away from its first place, or a step
        further at a speed of 0.5 in a step."""
        rows = self.grains_at_wall("wiggle z 2.0 0.4")
        self.grains_at_wall("linear 0 0 100", start_of_insertion=3)
        self.grains_at_wall("variable NULL NULL v_height NULL NULL 100", start_of_insertion=3)
        inside = (np.abs(rows[:, 2:4] - 4) < 2).all(axis=1)
        self.assertTrue((inside & (rows[:, 4] < 3)).any())
        self.assertFalse((inside & (rows[:, 4] > 5) & (rows[:, 4] < 7)).any())

    def test_memory_of_lost_grains(self):
        """A new grain has no bridge to the floor from the grain whose place in memory it takes."""
        floor = "fix floor all wall/pw85 zplane 0 NULL law hooke 1000 0 liquid 1 0.001 0"
        commands = f"""
            create_atoms 1 single 2 2 0.4999 units box
            create_atoms 1 single 5 5 0.4999 units box
            set type 1 shape 1 1 1
            {floor}
            run 0
            group second id 2
            delete_atoms group second compress no
            region low block 4 6 4 6 0.52 0.58 units box
            fix pour all pw85/pour 1 4711 region low grain 1 1 1 1
            thermo_style custom step atoms f_floor[7]
            run 2
        """
        rows = thermo(run(start() + commands, None, 1)[0])
        np.testing.assert_array_equal(rows[-1], [2, 2, 1])

    def test_plane(self):
        commands = ("region filling block 0 8 0 12 -0.1 0.1 units box\n"
                    "fix pour all pw85/pour 30 5 region filling grain 1 1.0 0.6 0.6 every 5 count 10 attempts 500\n")
        script = start("p p p", "block 0 8 0 12 -0.5 0.5").replace("atom_style", "dimension 2\natom_style")
        _, (snapshots,) = run(script + commands + COMPUTES.format(steps=60) + "run 60\n", None, 1, ("state.txt",))
        rows = snapshots[-1]
        self.assertEqual(len(rows), 30)
        self.assertTrue((rows[:, -1] == 0).all())
        self.assertTrue((rows[:, [4, 12, 13]] == 0).all())


def rotation(quaternion):
    w, v = quaternion[0], quaternion[1:]
    skew = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return (w * w - v @ v) * np.eye(3) + 2 * np.outer(v, v) + 2 * w * skew


class Mixtures(unittest.TestCase):
    """Thousands of grains in a large box, each quantity against its distribution. The seed is fixed, so that a test that passes once
    passes always; the limits are those of probabilities of some 1e-4."""

    @classmethod
    def setUpClass(cls):
        region = "region filling sphere 100 100 100 100 units box"
        pour = ("fix pour all pw85/pour 4000 7 region filling grain 1 1 1 2 share 1 density 3 size lognormal 1.0 0.5 0.5 4 "
                "grain 2 1.5 1 1 share 3 size normal 1 0.2 0.5 1.2 velocity 1 2 3 spread 0.5 0 1 every 1 count 4000")
        cls.text, cls.rows = poured(f"{region}\n{pour}\n", 1, box="block 0 200 0 200 0 200")

    def test_shares(self):
        self.assertEqual(len(self.rows), 4000)
        self.assertGreater(stats.binomtest(int((self.rows[:, 1] == 1).sum()), 4000, 0.25).pvalue, 1e-4)

    def check_sizes(self, kind, shape, distribution, lower, upper):
        diameters = self.rows[self.rows[:, 1] == kind, 8:11]
        sizes = diameters[:, 0] / shape[0]
        np.testing.assert_allclose(diameters, np.outer(sizes, shape), rtol=1e-15)
        self.assertGreaterEqual(sizes.min(), lower)
        self.assertLessEqual(sizes.max(), upper)
        below, above = distribution.cdf([lower, upper])
        self.assertGreater(stats.kstest(sizes, lambda x: (distribution.cdf(x) - below) / (above - below)).pvalue, 1e-4)

    def test_sizes(self):
        self.check_sizes(1, [1, 1, 2], stats.lognorm(0.5), 0.5, 4)
        self.check_sizes(2, [1.5, 1, 1], stats.norm(1, 0.2), 0.5, 1.2)

    def test_masses(self):
        density = np.where(self.rows[:, 1] == 1, 3.0, 1.0)
        masses = np.pi / 6 * density * self.rows[:, 8:11].prod(axis=1)
        np.testing.assert_allclose(self.rows[:, 15], masses, rtol=1e-14)
        # Thermo output has 8 digits.
        np.testing.assert_allclose(thermo(self.text)[-1, 2:6], [4000, 4000, masses.sum(), 0], rtol=1e-7)

    def test_places(self):
        """A third of the cube of the radius is uniform, and so is the height."""
        r = self.rows[:, 2:5] - 100
        radii = np.linalg.norm(r, axis=1)
        self.assertLess(radii.max(), 100)
        self.assertGreater(stats.kstest((radii / 100)**3, "uniform").pvalue, 1e-4)
        for k in range(3):
            self.assertGreater(stats.kstest(r[:, k] / radii, stats.uniform(-1, 2).cdf).pvalue, 1e-4)

    def test_orientations(self):
        """All components of all axes are uniform from -1 to 1."""
        axes = np.array([rotation(q) for q in self.rows[:, 11:15]])
        for k in range(9):
            self.assertGreater(stats.kstest(axes.reshape(-1, 9)[:, k], stats.uniform(-1, 2).cdf).pvalue, 1e-4)
        np.testing.assert_allclose(np.linalg.norm(self.rows[:, 11:15], axis=1), 1, rtol=1e-15)

    def test_velocities(self):
        velocities = self.rows[:, 5:8]
        self.assertTrue((velocities[:, 1] == 2).all())
        self.assertGreater(stats.kstest(velocities[:, 0], stats.uniform(0.5, 1).cdf).pvalue, 1e-4)
        self.assertGreater(stats.kstest(velocities[:, 2], stats.uniform(2, 2).cdf).pvalue, 1e-4)

    def test_given_orientation(self):
        _, rows = poured(f"{REGION}\n{POUR} quat 1 1 0 0\n")
        self.assertEqual(len(rows), 60)
        np.testing.assert_allclose(rows[:, 11:15], np.tile([np.sqrt(0.5), np.sqrt(0.5), 0, 0], (60, 1)), rtol=1e-15)


class Schedule(unittest.TestCase):
    def test_count(self):
        text, _ = poured(f"{REGION}\n{POUR}\n")
        atoms = thermo(text)[:, 1]
        self.assertEqual([atoms[step] for step in (0, 1, 10, 11, 40, 41, 60)], [0, 12, 12, 24, 48, 60, 60])

    def test_rate(self):
        """100 grains in a unit of time are 0.5 in a step."""
        text, _ = poured(f"{REGION}\n{POUR} every 6 rate 100\n".replace("pour 60", "pour 25"))
        atoms = thermo(text)[:, 1]
        self.assertEqual([atoms[step] for step in (0, 1, 6, 7, 49, 60)], [0, 3, 3, 6, 25, 25])

    def test_reset_timestep(self):
        dump = "dump state all custom 45 state.txt id\n"  # Releases from 2022 on do not set the step again under a dump.
        runs = f"run 15\nundump state\nreset_timestep 0\n{dump}run 45\n"
        _, rows = poured(f"{REGION}\n{POUR}\n", 45, runs=runs)
        self.assertEqual(len(rows), 60)

    def test_lost_grains(self):
        """Grains that leave the box do not leave their IDs to others."""
        commands = f"{REGION}\n{POUR} velocity 0 0 -40\nfix move all nve/asphere\n"
        fall = start() + commands + COMPUTES.format(steps=84).replace("lost error", "lost ignore")
        for runs in ("run 84\n", "run 40\nrun 44\n"):
            text, (snapshots,) = run(fall.replace("every 10 count 12", "every 20 count 12") + runs, None, 2, ("state.txt",))
            self.assertEqual(thermo(text)[-1, 2], 60)
            self.assertLess(thermo(text)[-1, 1], 40)
            np.testing.assert_array_equal(snapshots[-1][-12:, 0], np.arange(49, 61))

    def test_full_region(self):
        """A grain that finds no place waits, so that the mixture stays the same; the warning comes once."""
        region = "region filling block 3 5 3 5 3 5 units box"
        text, rows = poured(f"{region}\n{POUR}\n")
        self.assertLess(len(rows), 40)
        self.assertEqual(text.count("region filling is full in step 1: 500 places of grain"), 1)
        self.assertIn(" overlap other grains or walls. It waits, and is tried again in later insertions. Use a larger region", text)
        last = thermo(text)[-1]
        self.assertEqual(last[2] + last[5], 60)
        self.assertGreater(last[6], 500 * 5)
        _, free = poured(f"{REGION}\n{POUR}\n")
        np.testing.assert_array_equal(rows[:, [0, 1, *range(8, 16)]], free[:len(rows), [0, 1, *range(8, 16)]])

    def test_grains_of_other_sizes(self):
        """The pair style knows the sizes before the grains are there, with neighbor multi, too: large grains push small ones.

        The walls are stiff, so that no small grain is pushed through them."""
        region = "region filling block 1 7 1 7 1 11 units box"
        pour = ("fix pour all pw85/pour 150 3 region filling grain 1 4 3 2 share 1 grain 2 0.4 0.4 0.4 share 30 every 20 count 50 "
                "attempts 1000 velocity 0 0 -4")
        results = []
        for neighbor in ("neighbor 0.2 bin", "neighbor 0.2 multi"):
            stiff = WALLS.replace("hertz 1000", "hertz 10000")
            _, rows = poured(f"{region}\n{stiff}{GRAVITY}{pour}\n", 300, neighbor=neighbor, ranks=2)
            self.assertEqual(len(rows), 150)
            results.append(rows)
        self.assertGreater((results[0][:, -1] > 0).sum(), 10)
        np.testing.assert_allclose(results[1], results[0], rtol=0, atol=1e-6)


class Refused(unittest.TestCase):
    def check(self, message, commands, **more):
        self.assertIn(message, failure(start(**more) + commands + "\nrun 1\n"))

    def test_words(self):
        for words, message in {
            "0 1": "bad number of grains: 0, which must be a whole number from 1",
            "10 0.5": "bad seed: 0.5, which must be a whole number",
            "10 1": "lacks its region",
            "10 1 region filling": "lacks the shapes of its grains: add grain TYPE DX DY DZ",
            "10 1 region nowhere grain 1 1 1 1": "does not find region nowhere: define it with the region command before",
            "10 1 region endless grain 1 1 1 1": "needs a region of finite size, unlike region endless",
            "10 1 region column grain 1 1 1 1": "needs a region of finite size, unlike region column",
            "10 1 region filling grain 3 1 1 1": "bad type of grain: 3, which must be a whole number from 1 to 2",
            "10 1 region filling grain 1 1 0 1": "diameter of zero",
            "10 1 region filling grain 1 1 1": "lacks diameter",
            "10 1 region filling grain 1 1 1 1 size normal 1 0.01 2 3": "less than a thousandth",
            "10 1 region filling grain 1 1 1 1 size uniform 2 1": "has its sizes in the wrong order",
            "10 1 region filling grain 1 1 1 1 size power 2 1": "unknown distribution of sizes power: use one of lognormal",
            "10 1 region filling grain 1 1 1 1 quat 0 0 0 0": "quaternion of zero",
            "10 1 region filling grain 1 1 1 1 every 0": "bad number of steps between insertions",
            "10 1 region filling grain 1 1 1 1 rate 0": "rate of zero",
            "10 1 region filling grain 1 1 1 1 molecule m": "unknown keyword molecule: use one of attempts",
        }.items():
            with self.subTest(words=words):
                regions = f"{REGION}\nregion endless block 0 1 0 1 0 1 side out units box"
                regions += "\nregion column cylinder z 4 4 2 INF 9 units box"
                self.check(message, f"{regions}\nfix pour all pw85/pour {words}")

    def test_boxes(self):
        out = "region filling block -1 7 1 7 1 9 units box"
        self.check("reaches out of the box along x", f"{out}\n{POUR}")
        self.check("diameters of 9 that overlap their own images along x",
                   f"{REGION}\nfix pour all pw85/pour 1 1 region filling grain 1 1 9 1", boundary="p p p")

    def test_region_without_volume(self):
        region = "region a block 1 2 1 2 1 2 units box\nregion b block 3 4 3 4 3 4 units box\nregion filling intersect 2 a b"
        self.check("finds no point in region filling", f"{region}\n{POUR}")

    def test_cutoff(self):
        commands = f"pair_style pw85/granular 1.4\npair_coeff * * hertz 1000 1\n{REGION}\n{POUR}"
        text = failure(start() + commands + "\nrun 1\n")
        self.assertTrue(re.search(r"the pair cutoff 1.4 of types 1 and 1 misses contacts: raise the cutoff .* 1.5 or more", text), text)


if __name__ == "__main__":
    unittest.main()
