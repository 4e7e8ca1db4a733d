# SPDX-License-Identifier: GPL-2.0-only
"""fix pw85/hpmc: Monte Carlo of hard ellipsoids."""

import csv
import dataclasses
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from brute_force import overlaps
from lammps_runs import System, failure, launch, preamble, read_dump, run, thermo

HARD = """
neighbor 0.3 bin
pair_style pw85/hard {cutoff:.17g}
pair_coeff * *
"""
COMPUTES = """
compute overlap all pw85/overlap
compute q all property/atom quatw quati quatj quatk
"""
FINAL = """
dump final all custom 1 final.txt id x y z ix iy iz c_q[*]
dump_modify final sort id format float %.17g
run 0
"""


def stretched_lattice(cells, spacing, axes, small=0.8):
    """A face-centred cubic lattice, stretched like ellipsoids that are aligned. Every second one is smaller and of type 2."""
    corners = np.stack(np.meshgrid(*(np.arange(n) for n in cells), indexing="ij"), axis=-1).reshape(-1, 1, 3)
    basis = np.array([[0, 0, 0], [0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]])
    edges = 2.0 * np.sqrt(2.0) * spacing * np.asarray(axes)
    centers = ((corners + basis).reshape(-1, 3) + 0.1) * edges
    types = 1 + np.arange(len(centers)) % 2
    semi_axes = np.where(types == 1, 1.0, small)[:, None] * np.asarray(axes)
    quaternions = np.tile([1.0, 0.0, 0.0, 0.0], (len(centers), 1))
    return System(np.diag(np.asarray(cells) * edges), True, centers, semi_axes, quaternions, types)


# Spheres that have room to move far in a sweep.
DILUTE = stretched_lattice((4, 4, 4), 2.0, (0.5, 0.5, 0.5))
# 300 ellipsoids that fill 0.34 of the box.
MIXTURE = stretched_lattice((5, 5, 3), 1.18, (0.5, 0.5, 1.0))


def sheared(system, tilts):
    """The same lattice in a triclinic box, whose tilts are vectors of the lattice."""
    cell = system.cell.copy()
    (cell[1, 0], cell[2, 0], cell[2, 1]) = tilts
    return dataclasses.replace(system, cell=cell)


UNIT = MIXTURE.cell.diagonal() / (5, 5, 3)
SHEARED = sheared(MIXTURE, (UNIT[0], -UNIT[0], UNIT[1]))


def hard(system, words, computes=COMPUTES):
    return preamble(system) + HARD.format(cutoff=system.cutoff) + computes + f"fix mc all pw85/hpmc {words}\n"


class Ranks(unittest.TestCase):
    WORDS = "1 7 translate 0.2 rotate 0.4 trials 3 tune 10"

    def final(self, ranks, grid="* * *", words=WORDS, runs="run 40\n", system=MIXTURE, change=""):
        script = f"processors {grid}\n" + hard(system, words).replace("pair_style", change + "pair_style", 1) + (
            "thermo_style custom step c_overlap\nthermo_modify norm no\nthermo 1\n")
        text, ((columns,),) = run(script + runs + FINAL, system, ranks, ("final.txt",))
        np.testing.assert_array_equal(thermo(text[:text.index("Loop time")] + "Loop time")[:, 1], 0.0)
        return columns

    def test_same_bits(self):
        one = self.final(1)
        moved = np.abs(one[:, 1:4] + one[:, 4:7] * MIXTURE.cell.diagonal() - MIXTURE.centers).max(axis=1)
        self.assertGreater(np.median(moved), 0.2)
        self.assertGreater(np.median(np.abs(one[:, 8:]).max(axis=1)), 0.2)
        for ranks, grid in ((2, "2 1 1"), (4, "1 2 2"), (4, "1 1 4"), (8, "2 2 2")):
            with self.subTest(ranks=ranks, grid=grid):
                np.testing.assert_array_equal(self.final(ranks, grid), one)
        np.testing.assert_array_equal(self.final(1, runs="run 17\nrun 0\nrun 23\n"), one, "several runs")
        self.assertFalse((self.final(1, words=self.WORDS.replace("1 7", "1 8")) == one)[:, 1:4].any(), "another seed")

    def test_triclinic(self):
        """A sheared box, and one without tilts, in which LAMMPS converts positions, too."""
        for system, change in ((SHEARED, ""), (MIXTURE, "change_box all triclinic\n")):
            for words in (self.WORDS, self.WORDS + " pressure iso 5 volume 0.01", self.WORDS + " pressure aniso 5 volume 0.01"):
                one = self.final(1, words=words, system=system, change=change)
                self.assertGreater(np.median(np.abs(one[:, 8:]).max(axis=1)), 0.2)
                for ranks, grid in ((4, "1 2 2"), (4, "2 1 2")):
                    with self.subTest(words=words, grid=grid, sheared=not change):
                        np.testing.assert_array_equal(self.final(ranks, grid, words, system=system, change=change), one)
                np.testing.assert_array_equal(
                    self.final(1, words=words, runs="run 17\nrun 0\nrun 23\n", system=system, change=change), one)

    def test_restart(self):
        """Also in the middle of tuning, with other numbers of ranks."""
        for system in (MIXTURE, SHEARED):
            self.check_restart(system)

    def check_restart(self, system):
        one = self.final(1, system=system)
        start = hard(system, self.WORDS)
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory)
            (folder / "system.data").write_text(system.data_file())
            for ranks, script in ((4, start + "run 7\nwrite_restart half\n"),
                                  (2, start.replace("read_data system.data", "read_restart half") + "run 33\n" + FINAL)):
                (folder / "in.lammps").write_text(script)
                done = launch(folder, ranks)
                self.assertEqual(done.returncode, 0, done.stdout[-2000:])
            (columns,) = read_dump(folder / "final.txt")
        np.testing.assert_array_equal(columns, one)

    def test_pressure(self):
        for kind in ("iso", "aniso"):
            words = self.WORDS + f" pressure {kind} 5 volume 0.01"
            one = self.final(1, words=words)
            for ranks, grid in ((2, "1 2 1"), (4, "2 1 2")):
                with self.subTest(kind=kind, ranks=ranks):
                    np.testing.assert_array_equal(self.final(ranks, grid, words), one)

    def test_box_that_is_not_exact(self):
        """Positions on the sides of cells and sub-domains, and sides of the box with many digits."""
        third = MIXTURE.cell.diagonal() / 3.0
        script = hard(MIXTURE, self.WORDS).replace(
            "pair_style", "displace_atoms all move {:.17g} {:.17g} {:.17g}\nchange_box all x final {:.17g} {:.17g}\npair_style".format(
                *(-0.1 * third / third * MIXTURE.centers[0]), -third[0], 2.0 * third[0]), 1)
        results = []
        for ranks in (1, 4):
            _, ((columns,),) = run(f"processors {'1 1 1' if ranks == 1 else '4 1 1'}\n" + script + "run 20\n" + FINAL,
                                   MIXTURE, ranks, ("final.txt",))
            results.append(columns)
        np.testing.assert_array_equal(*results)


class SmallestBox(unittest.TestCase):
    """Boxes of exactly two of the largest diameter, D, and exactly D high where they are not periodic. The unit of such a box is 2^-49 D,
    or 2^-50 D if it is only D high. Between multiples of the unit, its sides are rounded outwards."""

    REFUSAL = "needs a box of at least {} along z, where it is "

    def check(self, scale, boundary, high, accepted, most_ranks=1):
        corners = np.stack(np.meshgrid(*3 * [[0.5, 1.5]], indexing="ij"), axis=-1).reshape(-1, 3) * [1.0, 1.0, 0.5 * high]
        count = len(corners)
        system = System(scale * np.diag([2.0, 2.0, high]), True, scale * corners, np.tile(scale * np.array([0.15, 0.2, 0.5]), (count, 1)),
                        np.tile([np.sqrt(0.5), 0.0, np.sqrt(0.5), 0.0], (count, 1)), np.ones(count, dtype=int))
        script = hard(system, f"1 7 translate {0.1 * scale} rotate 0.4").replace("p p p", boundary).replace(
            "neighbor 0.3", f"neighbor {0.3 * scale}") + "thermo_style custom step c_overlap\nthermo_modify norm no\nthermo 1\nrun 12\n"
        if not accepted:
            room = f"two of the largest diameter, {2 * scale:.15g}" if boundary == "p p p" else f"the largest diameter, {scale:.15g}"
            self.assertIn(self.REFUSAL.format(room), failure(script, system))
            return
        results = []
        for ranks in {1, most_ranks}:
            text, ((columns,),) = run(script + FINAL, system, ranks, ("final.txt",))
            np.testing.assert_array_equal(thermo(text[:text.index("Loop time")] + "Loop time")[:, 1], 0.0)
            results.append(columns)
        np.testing.assert_array_equal(results[0], results[-1])
        self.assertGreater(np.abs(results[0][:, 8:]).max(), 0.2)

    def test_sizes(self):
        for scale in (1.0, 1.9, 2.0**-40 / 3.0, 0.7 * 2.0**40):
            with self.subTest(scale=scale.hex()):
                self.check(scale, "p p p", 2.0, True, most_ranks=8 if scale == 1.9 else 1)

    def test_limits(self):
        for boundary, least in (("p p p", 2.0), ("p p f", 1.0)):
            for high, accepted in ((least, True), (np.nextafter(least, 0.0), True), (least * (1 - 2.0**-50), False)):
                with self.subTest(boundary=boundary, high=float(high).hex()):
                    self.check(1.0, boundary, high, accepted)


class Pressure(unittest.TestCase):
    """compute pw85/pressure."""

    def test_spheres(self):
        """The equation of state of Carnahan and Starling, whose error is less than 0.3 %, at two densities, and in a triclinic box."""
        for spacing, width, tolerance, tilts in ((1.35, 0.02, 0.01, (0, 0, 0)), (1.25, 0.01, 0.015, (0, 0, 0)),
                                                 (1.25, 0.01, 0.015, (2, 1, -2))):
            fluid = stretched_lattice((5, 5, 5), spacing, (0.5, 0.5, 0.5), small=1.0)
            fluid.types[:] = 1
            fluid = sheared(fluid, np.array(tilts) * fluid.cell[0, 0] / 5)
            fraction = 500 * np.pi / 6 / np.prod(fluid.cell.diagonal())
            expected = (1 + fraction + fraction**2 - fraction**3) / (1 - fraction)**3
            script = hard(fluid, "1 7 translate 0.2 rotate 0").replace("pw85/hard 1", "pw85/hard 1.05") + (
                f"compute p all pw85/pressure {width}\nfix p all ave/time 2 1000 2500 c_p start 500\n"
                "thermo_style custom step vol f_p\nthermo_modify norm no format float %.17g\nrun 2500\n")
            volume, pressure = thermo(run(script, fluid)[0])[-1, 1:]
            factor = pressure * volume / 500
            print(f"fraction {fraction:.3f}: Z = {factor:.3f}, {expected:.3f} by Carnahan and Starling")
            self.assertAlmostEqual(factor, expected, delta=tolerance * expected)

    def test_counts(self):
        """The pairs in both ranges, by the rows of compute pw85/contact, also with newton off, in a sheared box, and images."""
        small = stretched_lattice((2, 2, 2), 1.1, (0.5, 0.5, 0.6))
        for system, ranks, newton in ((MIXTURE, 1, "on"), (MIXTURE, 2, "off"), (small, 1, "on")):
            script = hard(system, "1 7 translate 0.2 rotate 0.4").replace("newton on", f"newton {newton}").replace(
                f"pw85/hard {system.cutoff:.17g}", f"pw85/hard {1.1 * system.cutoff:.17g}")
            script += ("compute p all pw85/pressure 0.03\ncompute c all pw85/contact below 1.2\ndump c all local 20 c.txt c_c[3]\n"
                       "dump_modify c format float %.17g\nthermo_style custom step c_p c_p[*] vol\n"
                       "thermo_modify norm no format float %.17g\nrun 20\n")
            text, (dumps,) = run(script, system, ranks, ("c.txt",))
            _, pressure, first, second, volume = thermo(text)[-1]
            logarithms = 0.5 * np.log(dumps[-1][:, 0])
            self.assertEqual([first, second], [((logarithms >= 0.03 * k) & (logarithms < 0.03 * (k + 1))).sum() for k in (0, 1)])
            self.assertGreater(first, 3)
            count = len(system.centers)
            np.testing.assert_allclose(pressure, (count + (1.5 * first - 0.5 * second) / 0.09) / volume, rtol=1e-14)

    def test_errors(self):
        start = preamble(MIXTURE) + HARD.format(cutoff=2.0)
        for words, message in {"0": "the width of ln mu must be from 1e-6 to 0.1", "0.01 1": "it takes one number"}.items():
            self.assertIn(message, failure(f"{start}compute p all pw85/pressure {words}\n", MIXTURE))
        self.assertIn("needs the group all", failure(f"{start}group a id 1\ncompute p a pw85/pressure\n", MIXTURE))
        self.assertIn("misses contacts", failure(
            f"{preamble(MIXTURE)}{HARD.format(cutoff=2.0)}compute p all pw85/pressure\nthermo_style custom step c_p\nrun 0\n", MIXTURE))


class Moves(unittest.TestCase):
    def test_no_overlaps(self):
        """At any step, with any keyword; the group that does not move is where it was."""
        for words in ("1 3", "1 3 pressure aniso 3 volume 0.01", "2 3 translate 5 rotate 3 trials 20 cells 2 4 2", "1 3 tune 100"):
            with self.subTest(words=words):
                script = "processors 2 1 1\n" + hard(MIXTURE, words)
                if "pressure" not in words:
                    script = script.replace("fix mc all", "group big type 1\nfix mc big")
                text, ((columns,),) = run(script + "thermo_style custom step c_overlap\nthermo_modify norm no\nthermo 1\n"
                                          "run 60\n" + FINAL, MIXTURE, 2, ("final.txt",))
                table = thermo(text[:text.index("Loop time")] + "Loop time")
                self.assertEqual(len(table), 61)
                np.testing.assert_array_equal(table[:, 1], 0.0)
                if "pressure" in words:
                    continue
                unit = 2.0 ** (np.floor(np.log2(MIXTURE.cell.diagonal())) - 50)
                moved = (columns[:, 1:4] != unit * np.rint(MIXTURE.centers / unit)).any(axis=1)
                self.assertFalse(moved[MIXTURE.types == 2].any())
                # Few of the long moves of the second command are accepted.
                self.assertGreater(moved[MIXTURE.types == 1].mean(), 0.02 if words.startswith("2") else 0.9)

    def test_atom_style_hybrid(self):
        """Quaternions reach LAMMPS through the part of the style that has them."""
        finals = []
        for style, steps in (("ellipsoid", 5), ("hybrid charge ellipsoid", 5), ("hybrid charge ellipsoid", 0)):
            script = preamble(MIXTURE).replace("atom_style ellipsoid", f"atom_style {style}").replace("read_data system.data", """
                lattice sc $(1.0/2.1^3)
                region box block 0 4 0 4 0 4
                create_box 2 box
                create_atoms 1 box
                set type 1 shape 1.0 1.0 2.0
                set type 1 quat/random 77
                set type 1 density 1.0""") + HARD.format(cutoff=2.0) + COMPUTES + f"fix mc all pw85/hpmc 1 1\nrun {steps}\n" + FINAL
            _, ((columns,),) = run(script, None, 1, ("final.txt",))
            finals.append(columns)
        np.testing.assert_array_equal(finals[0], finals[1])
        self.assertTrue((finals[1][:, 7:] != finals[2][:, 7:]).any(axis=1).all())

    def test_one_trial(self):
        """Of spheres that move by a diameter at once: others look for them where they are, not where they were."""
        fluid = stretched_lattice((4, 4, 4), 1.6, (0.5, 0.5, 0.5), small=1.0)
        text, _ = run(hard(fluid, "1 3 translate 1 trials 1") + "thermo_style custom step c_overlap f_mc[1]\nthermo_modify norm no\n"
                      "thermo 1\nrun 400\n", fluid)
        table = thermo(text)
        np.testing.assert_array_equal(table[:, 1], 0.0)
        self.assertGreater(table[-1, 2], 0.05)

    def test_far_moves(self):
        """Atoms that have moved far in a sweep are found where they are."""
        edge = DILUTE.cell[0, 0]
        for system, pressure in ((DILUTE, ""), (DILUTE, " pressure iso 0.2 volume 0.05"), (sheared(DILUTE, (edge / 4, edge / 4, 0)), "")):
            results = []
            for grid in ("1 1 1", "4 1 1", "2 2 2"):
                script = f"processors {grid}\n" + hard(system, "1 3 translate 2 trials 30 cells 4 4 4" + pressure)
                ranks = np.prod([int(word) for word in grid.split()])
                text, ((columns,),) = run(script + "thermo_style custom step c_overlap f_mc[1]\nthermo_modify norm no\nthermo 1\n"
                                          "run 20\n" + FINAL, system, ranks, ("final.txt",))
                table = thermo(text[:text.index("Loop time")] + "Loop time")
                np.testing.assert_array_equal(table[:, 1], 0.0)
                self.assertGreater(table[-1, 2], 0.2)
                results.append(columns)
            np.testing.assert_array_equal(results[1], results[0])
            np.testing.assert_array_equal(results[2], results[0])

    def table(self, words, steps, system=MIXTURE):
        text, _ = run(hard(system, words) + f"thermo_style custom step f_mc[*]\nthermo_modify format float %.17g\nrun {steps}\n", system)
        return thermo(text)[-1, 1:]

    def test_vector(self):
        shares, trials, steps = self.table("2 3 translate 1e-9 rotate 1e-9 trials 5", 20).reshape(3, 3)[:, :2]
        self.assertEqual(trials.sum(), 10 * 5 * 300)
        self.assertLess(abs(trials[0] - trials[1]), 6.0 * np.sqrt(trials.sum()))
        np.testing.assert_allclose(shares, 1.0, atol=1e-6)
        np.testing.assert_array_equal(steps, 1e-9)
        shares, trials, steps = self.table("1 3 translate 0.2 rotate 0 trials 2", 10).reshape(3, 3)[:, :2]
        np.testing.assert_array_equal(trials, [10 * 2 * 300, 0])
        np.testing.assert_array_equal(steps, [0.2, 0.0])
        self.assertTrue(0.1 < shares[0] < 0.9)

    def test_tuning(self):
        for translate, rotate in ((0.02, 0.02), (2.0, 2.9)):
            tuned = self.table(f"1 3 translate {translate} rotate {rotate} tune 150", 150)[6:8]
            shares = self.table(f"1 3 translate {tuned[0]:.17g} rotate {tuned[1]:.17g}", 100)[:2]
            np.testing.assert_allclose(shares, 0.3, atol=0.05)
        np.testing.assert_array_equal(self.table("1 3 translate 0.02 tune 0", 10)[6], 0.02)


def axis_of(quaternions, column):
    w, x, y, z = quaternions.T
    return np.array([[w*w + x*x - y*y - z*z, 2*(x*y + w*z), 2*(x*z - w*y)],
                     [2*(x*y - w*z), w*w - x*x + y*y - z*z, 2*(y*z + w*x)],
                     [2*(x*z + w*y), 2*(y*z - w*x), w*w - x*x - y*y + z*z]])[column].T


def forms_of(semi_axes, quaternions):
    """Matrices, by formulas of their own."""
    axes = np.stack([axis_of(quaternions, k) for k in range(3)], axis=1)  # rows: the axes
    return np.einsum("nki,nk,nkj->nij", axes, np.asarray(semi_axes)**2 * np.ones((len(quaternions), 3)), axes)


class Distribution(unittest.TestCase):
    """Means, against samples that are independent of each other or known functions."""

    PAIR = System(4.05 * np.eye(3), True, np.array([[1.0, 1.0, 1.0], [3.0, 3.0, 3.0]]), np.array([[0.5, 0.4, 1.0], [0.6, 0.9, 0.5]]),
                  np.tile([1.0, 0.0, 0.0, 0.0], (2, 1)), np.array([1, 2]))

    def observables(self, r12, quaternions1, quaternions2):
        """Rows: whether the two are close, and, if they are, squares of cosines of angles between axes and the line of centres."""
        distance = np.linalg.norm(r12, axis=1)
        direction = r12 / distance[:, None]
        close = distance < 1.5
        a, b = axis_of(quaternions1, 2), axis_of(quaternions2, 1)
        return np.array([close, close * (a * direction).sum(axis=1)**2, close * (b * direction).sum(axis=1)**2,
                         close * (a * b).sum(axis=1)**2])

    # Heights of at least 4.04
    SHEARED_PAIR = sheared(System(4.8 * np.eye(3), True, PAIR.centers, PAIR.semi_axes, PAIR.quaternions, PAIR.types), (2.0, -1.0, 1.5))

    def nearest(self, r12, cell):
        """The shortest images of vectors."""
        images = np.stack(np.meshgrid(*3 * [[-1, 0, 1]]), axis=-1).reshape(-1, 3) @ cell
        fractions = r12 @ np.linalg.inv(cell)
        candidates = ((fractions - np.round(fractions)) @ cell)[:, None] + images
        best = (candidates**2).sum(axis=2).argmin(axis=1)
        return candidates[np.arange(len(r12)), best]

    def sampled(self, count, pair):
        random = np.random.default_rng(11)
        r12 = self.nearest(random.uniform(0.0, 1.0, (count, 3)) @ pair.cell, pair.cell)
        quaternions = random.normal(size=(2, count, 4))
        quaternions /= np.linalg.norm(quaternions, axis=2)[:, :, None]
        q1, q2 = (forms_of(a, q)[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]] for a, q in zip(pair.semi_axes, quaternions))
        free = overlaps(r12, q1, q2) == 0
        return self.observables(r12[free], quaternions[0][free], quaternions[1][free])

    def test_two_ellipsoids(self):
        """A mean of independent samples has the error of its variance; that of the sweeps follows from 20 blocks. Five standard errors."""
        for pair, steps in ((self.PAIR, 80_000), (self.SHEARED_PAIR, 80_000)):
            script = hard(pair, "1 5 translate 1.5 rotate 2.5 trials 10 cells 2 2 2") + (
                f"dump all all custom 4 all.txt id x y z c_q[*]\ndump_modify all sort id format float %.17g\nthermo 10000\nrun {steps}\n")
            _, (snapshots,) = run(script, pair, 1, ("all.txt",))
            rows = np.array(snapshots[1:])
            found = self.observables(self.nearest(rows[:, 1, 1:4] - rows[:, 0, 1:4], pair.cell), rows[:, 0, 4:], rows[:, 1, 4:])
            expected = self.sampled(100_000, pair)
            blocks = found.reshape(4, 20, -1).mean(axis=2)
            error = np.hypot(blocks.std(axis=1, ddof=1) / np.sqrt(20), expected.std(axis=1) / np.sqrt(expected.shape[1]))
            difference = found.mean(axis=1) - expected.mean(axis=1)
            self.assertTrue((error < 0.05 * expected.mean(axis=1)).all(), error / expected.mean(axis=1))
            self.assertLess(np.abs(difference / error).max(), 5.0, (difference, error))

    def volumes(self, system, words, steps, cutoff=None):
        script = hard(system, words)
        if cutoff:
            script = script.replace(f"pw85/hard {system.cutoff:.17g}", f"pw85/hard {cutoff}")
        tilts = "xy xz yz" if system.cell[1, 0] else ""
        text, _ = run(script + f"thermo_style custom step vol lx ly lz {tilts}\nthermo_modify norm no\nthermo 1\nrun {steps}\n", system)
        return thermo(text)[1:, 1:]

    def test_ideal_gas(self):
        """Four ellipsoids without size: their volume has the density V⁴ exp(-PV), and so the mean and the variance 5 at P = 1."""
        gas = System(1.6 * np.eye(3), True, np.array([[0.2, 0.2, 0.2], [1, 1, 1], [0.2, 1, 0.2], [0.2, 0.2, 1]]), np.full((4, 3), 0.005),
                     np.tile([1.0, 0.0, 0.0, 0.0], (4, 1)), np.ones(4, dtype=int))
        tilted = sheared(gas, (0.4, -0.3, 0.5))
        for kind, system in (("iso", gas), ("y", gas), ("iso", tilted), ("y", tilted)):
            rows = self.volumes(system, f"1 3 trials 1 volume 0.5 pressure {kind} 1 cells 2 2 2", 20_000, 0.3)
            for values, expected in ((rows[:, 0], 5.0), ((rows[:, 0] - 5.0)**2, 5.0)):
                blocks = values.reshape(20, -1).mean(axis=1)
                self.assertLess(abs(blocks.mean() - expected), 5.0 * blocks.std(ddof=1) / np.sqrt(20))
            np.testing.assert_allclose(rows[:, 1:4].prod(axis=1), rows[:, 0], rtol=1e-5)
            if system is tilted:
                # The tilts change with the edges along their axes.
                expected = np.tile(np.array([0.4, -0.3, 0.5]) / 1.6, (len(rows), 1))
                np.testing.assert_allclose(rows[:, 4:] / rows[:, [1, 1, 2]], expected, rtol=1e-5)
            if kind == "y":
                np.testing.assert_allclose(rows[:, [1, 3]], 1.6, rtol=1e-7)
            else:
                np.testing.assert_allclose(rows[:, 1], rows[:, 2], rtol=1e-6)

    def test_equation_of_state(self):
        """Prolate spheroids of aspect ratio 3 have the volume fraction of the library's own engine, within five standard errors."""
        table = Path(os.environ["PW85_SOURCE"], "reference", "equation_of_state", "equation_of_state.csv")
        with table.open() as file:
            row = next(row for row in csv.DictReader(file) if (row["aspect"], row["start"], row["ensemble"]) == ("3", "random", "NPT"))
        system = stretched_lattice((4, 4, 2), 1.35, (0.5, 0.5, 1.5), small=1.0)
        size = 4.0 / 3.0 * np.pi * system.semi_axes[0].prod()
        self.assertEqual(len(system.centers), int(row["particles"]))
        words = f"1 3 translate 0.26 rotate 0.66 volume 0.02 pressure iso {float(row['pressure']) / size:.17g}"
        fractions = len(system.centers) * size / self.volumes(system, words, 4500)[500:, 0]
        blocks = fractions.reshape(10, -1).mean(axis=1)
        error = np.hypot(blocks.std(ddof=1) / np.sqrt(10), float(row["fraction_error"]))
        self.assertLess(error, 0.005)
        self.assertLess(abs(blocks.mean() - float(row["fraction"])), 5.0 * error)


SLIT_EDGES = (-1.2, MIXTURE.cell[2, 2] + 0.8)
SLIT = (f"change_box all z final {SLIT_EDGES[0]:.17g} {SLIT_EDGES[1]:.17g} boundary p p f\n"
        f"fix plates all wall/pw85 zplane -1.0 {MIXTURE.cell[2, 2] + 0.5:.17g} hard\n")
ALL_SIDES = "".join(f"change_box all {axis} final -1.7 {edge + 1.7:.17g} boundary {' '.join((k + 1) * 'f' + (2 - k) * 'p')}\n"
                    for k, (axis, edge) in enumerate(zip("xyz", MIXTURE.cell.diagonal())))
CONTAINER = ALL_SIDES + "fix plates all wall/pw85 box " + " ".join(
    f"-1.25 {edge + 1.4:.17g}" for edge in MIXTURE.cell.diagonal()) + " hard\n"


class Walls(unittest.TestCase):
    """Boxes with sides that are not periodic, and hard walls."""

    WORDS = "1 7 translate 0.3 rotate 0.5 trials 3 tune 10 walls plates"

    def script(self, walls, words=WORDS, system=MIXTURE):
        return hard(system, words).replace("pair_style", walls + "pair_style", 1)

    def final(self, walls, ranks, grid="* * *", runs="run 40\n", words=WORDS):
        script = f"processors {grid}\n" + self.script(walls, words) + (
            "thermo_style custom step c_overlap\nthermo_modify norm no\nthermo 1\n")
        text, ((columns,),) = run(script + runs + FINAL, MIXTURE, ranks, ("final.txt",))
        table = thermo(text[:text.index("Loop time")] + "Loop time")
        np.testing.assert_array_equal(table[:, 1], 0.0)
        return columns

    def test_same_bits(self):
        for walls, sides, grids in (
                (SLIT, {2: (-1.0, MIXTURE.cell[2, 2] + 0.5)}, ((2, "1 1 2"), (4, "1 2 2"), (3, "1 1 3"))),
                (CONTAINER, {k: (-1.25, MIXTURE.cell[k, k] + 1.4) for k in range(3)}, ((2, "2 1 1"), (4, "1 2 2"), (8, "2 2 2"))),
                ("change_box all triclinic xy final $(lx/5) remap\n" + SLIT, {2: (-1.0, MIXTURE.cell[2, 2] + 0.5)},
                 ((2, "1 1 2"), (4, "2 1 2")))):
            one = self.final(walls, 1)
            moved = np.abs(one[:, 1:4] - MIXTURE.centers)
            self.assertGreater(np.median(moved[:, 2]), 0.1)
            forms = forms_of(MIXTURE.semi_axes, one[:, 7:])
            for k, (lower, upper) in sides.items():
                half = np.sqrt(forms[:, k, k])
                self.assertGreater((one[:, 1 + k] - half).min(), lower - 1e-14)
                self.assertLess((one[:, 1 + k] + half).max(), upper + 1e-14)
                self.assertLess((one[:, 1 + k] - half).min(), lower + 0.1)
            for ranks, grid in grids:
                with self.subTest(grid=grid, sides=len(sides)):
                    np.testing.assert_array_equal(self.final(walls, ranks, grid), one)
            np.testing.assert_array_equal(self.final(walls, 1, runs="run 17\nrun 0\nrun 23\n"), one, "several runs")

    def test_restart(self):
        one = self.final(SLIT, 1)
        start = self.script(SLIT)
        again = start.replace("read_data system.data", "read_restart half").replace(SLIT.split("\n")[0] + "\n", "")
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory)
            (folder / "system.data").write_text(MIXTURE.data_file())
            for ranks, script in ((4, start + "run 7\nwrite_restart half\n"), (2, again + "run 33\n" + FINAL)):
                (folder / "in.lammps").write_text(script)
                done = launch(folder, ranks)
                self.assertEqual(done.returncode, 0, done.stdout[-2000:])
            (columns,) = read_dump(folder / "final.txt")
        np.testing.assert_array_equal(columns, one)

    def test_pressure_on_ranks(self):
        """Along plates, also of a triclinic box."""
        for tilt in ("", "change_box all triclinic xy final $(lx/5)\n"):
            for kind in "xy":
                words = f"{self.WORDS} pressure {kind} 4 volume 0.02"
                one = self.final(tilt + SLIT, 1, words=words)
                half = np.sqrt(forms_of(MIXTURE.semi_axes, one[:, 7:])[:, 2, 2])
                self.assertGreater((one[:, 3] - half).min(), -1.0 - 1e-14)
                self.assertLess((one[:, 3] + half).max(), MIXTURE.cell[2, 2] + 0.5 + 1e-14)
                for ranks, grid in ((2, "1 1 2"), (4, "2 1 2")):
                    with self.subTest(kind=kind, grid=grid, tilt=tilt):
                        np.testing.assert_array_equal(self.final(tilt + SLIT, ranks, grid, words=words), one)

    def snapshots(self, words, walls, boundary, steps=40_000):
        """Centres and quaternions of one ellipsoid with semi-axes 0.4, 0.4, 0.95 in a box from 0 to 4."""
        one = System(4.0 * np.eye(3), True, np.array([[2.0, 2.0, 2.0]]), np.array([[0.4, 0.4, 0.95]]), np.array([[1.0, 0.0, 0.0, 0.0]]),
                     np.array([1]))
        script = self.script(walls, f"1 5 translate 1.5 rotate 2.5 trials 10 {words}", one)
        script = script.replace("boundary p p p", f"boundary {boundary}")
        _, (snapshots,) = run(script + "dump all all custom 4 all.txt id x y z c_q[*]\ndump_modify all format float %.17g\n"
                              f"thermo 10000\nrun {steps}\n", one, 1, ("all.txt",))
        rows = np.array(snapshots[1:])[:, 0]
        return rows[:, 1:4], rows[:, 4:]

    def check_means(self, found, expected, error=0.0):
        """Rows of observables: their means, within five standard errors, which follow from 20 blocks."""
        blocks = found.reshape(len(found), 20, -1).mean(axis=2)
        error = np.hypot(blocks.std(axis=1, ddof=1) / np.sqrt(20), error)
        difference = np.abs(blocks.mean(axis=1) - expected)
        self.assertTrue((error < 0.05 * np.abs(expected)).all(), error / expected)
        self.assertTrue((difference < 5.0 * error).all(), (difference / error, expected))

    def test_between_plates(self):
        """The profile of the density and the orientation, against quadrature.

        With c the cosine of the angle between the long axis and the normal, the half width is h(c) = sqrt(0.16 + 0.7425 c²), and z is
        uniform between the places that leave room for it."""
        x, q = self.snapshots("walls low walls high", "fix low all wall/pw85 zplane 0.6 NULL hard\nfix high all wall/pw85 zplane NULL 3.2 "
                              "law hertz 1e4 0\n", "p p f")
        z, c = np.abs(x[:, 2] - 1.9), axis_of(q, 2)[:, 2]
        self.assertLess((z + np.sqrt(0.16 + 0.7425 * c**2)).max(), 1.3 + 1e-15)
        nodes, weights = np.polynomial.legendre.leggauss(2000)
        nodes, weights = 0.5 + 0.5 * nodes, 0.5 * weights  # of c from 0 to 1
        room = 1.3 - np.sqrt(0.16 + 0.7425 * nodes**2)  # of abs(z)
        partition = (weights * room).sum()
        edges = np.array([0.0, 0.2, 0.4, 0.6, 0.8])
        profile = [(weights * np.clip(room - edge, 0.0, 0.2)).sum() / partition for edge in edges[:-1]]
        expected = [*profile, *((weights * room * nodes**2).sum() / partition, (weights * room**3 / 3.0).sum() / partition,
                                (weights * room**3 / 3.0 * nodes**2).sum() / partition)]
        found = [*((z >= edge) & (z < edge + 0.2) for edge in edges[:-1]), c**2, z**2, z**2 * c**2]
        self.check_means(np.array(found, dtype=float), np.array(expected))

    def test_without_walls(self):
        """Centres are uniform in a box that is not periodic, whatever the orientations, and stay in it."""
        x, q = self.snapshots("", "", "f p f")
        self.assertTrue((x[:, [0, 2]] >= 0.0).all())
        self.assertTrue((x[:, [0, 2]] < 4.0).all())
        self.assertLess(x[:, 2].min(), 0.01)
        self.assertGreater(x[:, 2].max(), 3.99)
        found = np.stack([x[:, 0] < 1, x[:, 0] > 3, x[:, 2] < 1, x[:, 2] > 3, np.abs(x[:, 2] - 2) < 0.5, axis_of(q, 2)[:, 2]**2])
        self.check_means(found, np.array([*5 * [0.25], 1 / 3]))

    def test_cylinders(self):
        """One ellipsoid in or around a cylinder, against independent samples that points on its outline decide."""
        angles = np.linspace(0.0, 2.0 * np.pi, 180, endpoint=False)
        circle = np.stack([np.cos(angles), np.sin(angles)])
        random = np.random.default_rng(3)
        for axis, first, second in ((0, 1, 2), (1, 0, 2)):
            for side, radius in (("in", 1.3), ("out", 0.9)):
                x, q = self.snapshots("walls tube", f"fix tube all wall/pw85 {'xyz'[axis]}cylinder {radius} at 2 1.9 side {side} hard\n"
                                      + ("set atom 1 x 0.6 y 0.6 z 0.6\n" if side == "out" else ""),
                                      "p f f" if axis == 0 else "f p f", 20_000)
                trials = np.concatenate([random.uniform(0.0, 4.0, (40_000, 3)), random.normal(size=(40_000, 4))], axis=1)
                results = []
                for centers, quaternions in ((x, q), (trials[:, :3], trials[:, 3:])):
                    quaternions = quaternions / np.linalg.norm(quaternions, axis=1)[:, None]
                    forms = forms_of([0.4, 0.4, 0.95], quaternions)[:, [first, second]][:, :, [first, second]]
                    place = centers[:, [first, second]] - [2.0, 1.9]
                    outline = place[:, :, None] + np.linalg.cholesky(forms) @ circle
                    distances = np.linalg.norm(outline, axis=1)
                    inside = np.einsum("ni,nij,nj->n", place, np.linalg.inv(forms), place) < 1.0
                    free = distances.max(axis=1) < radius if side == "in" else (distances.min(axis=1) > radius) & ~inside
                    r2, c2 = (place**2).sum(axis=1), axis_of(quaternions, 2)[:, axis]**2
                    results.append((free, np.stack([r2, c2, r2 * c2, r2**2])))
                # 180 points see the outline to (pi/180)² / 2 = 1.5e-4 of its size, less than a tenth of a standard error.
                self.assertGreater(results[0][0].mean(), 0.999)
                free, samples = results[1]
                samples = samples[:, free]
                self.check_means(results[0][1], samples.mean(axis=1), samples.std(axis=1) / np.sqrt(samples.shape[1]))

    def test_start(self):
        """An ellipsoid that cuts a wall is refused, and one that touches it is not; the group of the wall counts."""
        message = "atom 1 cuts a wall at the start: move the atom or the wall"
        boxed = f"change_box all z final -3 {MIXTURE.cell[2, 2] + 3:.17g} boundary p p f\n"
        place = "fix plates all wall/pw85 zplane {:.17g} NULL hard\n"
        # The first ellipsoid is lower than the others, and reaches down to -0.6875.
        for lower, refused in ((-0.6875, False), (np.nextafter(-0.6875, 0.0), True), (-0.6, True)):
            script = self.script(boxed + "set atom 1 z 0.3125\n" + place.format(lower)) + "run 1\n"
            script = script.replace("fix plates all", "group one id 1\nfix plates one")
            if refused:
                self.assertIn(message, failure(script, MIXTURE))
            else:
                run(script, MIXTURE)
        # The wall cuts many atoms, which are not in its group.
        run(self.script(boxed + "group one id 1\nfix plates one wall/pw85 zplane NULL 4 hard\n") + "run 1\n", MIXTURE)
        # An atom that does not move may be a part of a wall.
        frozen = self.script(boxed + "set atom 1 z 0.25\n" + place.format(-0.7)).replace("fix mc all", "group rest id > 1\nfix mc rest")
        run(frozen + "run 1\n", MIXTURE)

    def test_large_cylinder(self):
        """A sphere cuts a cylinder that is a million times as large by 2^-35 of its radius, which sums of rounded distances do not see."""
        edge, radius = 2.0**22, 2.0**20
        middle = 0.5 * edge
        for x, refused in ((radius - 1.0, True), (radius - 1.0 - 2.0**-20, False)):
            one = System(edge * np.eye(3), False, np.array([[middle + x, middle + 2.0**-7, middle]]), np.ones((1, 3)),
                         np.array([[1.0, 0.0, 0.0, 0.0]]), np.array([1]))
            script = self.script(f"fix plates all wall/pw85 zcylinder {radius} at {middle} {middle} hard\n", system=one).replace(
                f"pw85/hard {one.cutoff:.17g}", f"pw85/hard {edge / 16}") + "run 1\n"
            if refused:
                self.assertIn("atom 1 cuts a wall at the start", failure(script, one))
            else:
                run(script, one)

    def test_sides(self):
        """An atom that rounding would put on the upper side stays in the box, and one that is out of it is lost, as in any LAMMPS."""
        one = System(11.0 * np.eye(3), True, np.array([[2.0, 2.0, 2.0]]), np.array([[0.4, 0.4, 0.95]]), np.array([[1.0, 0.0, 0.0, 0.0]]),
                     np.array([1]))
        below = np.nextafter(10.5, 0.0)  # Positions are multiples of 2^-47.
        for place, lost in ((below, False), (1.0, False), (12.0, True)):
            box = f"change_box all z final 0.0 10.5 boundary p p f\nset atom 1 z {place}\n"
            script = "processors 1 1 2\n" + self.script(box, "1 7 translate 0.3 cells 2 2 6", one) + "run 3\n"
            if lost:
                self.assertIn("Lost atoms", failure(script, one, 2))
            else:
                run(script, one, 2)

    def test_errors(self):
        start = self.script(SLIT)
        for old, new, message in (
                (" hard", " hard law hooke 1 1", "has words behind the word hard"),
                (" hard", "", "lacks the word law"),
                ("walls plates", "", "does not know the walls of fix plates: add walls plates to its command"),
                ("walls plates", "walls plate", "no fix wall/pw85 has this ID"),
                ("walls plates", "walls mc", "no fix wall/pw85 has this ID"),
                ("walls plates", "walls plates pressure z 1", "cannot have a pressure along z, where the box is not periodic"),
                ("walls plates", "walls plates pressure iso 1", "cannot have a pressure along z, where the box is not periodic"),
                (" hard", " linear 0 0 1 law hooke 1 0", "cannot have walls that fix plates has, which moves"),
                ("zplane", "box 0 1 0 1 0 1 side out law hooke 1 0 #", "which has triangles: use planes, cylinders or the inside of a box"),
                ("zplane", "xplane", "the box is periodic across the wall"),
                ("fix mc all pw85/hpmc " + self.WORDS, "", "hard walls are for fix pw85/hpmc"),
                ("fix mc", "compute p all pw85/pressure 1e-6\nthermo_style custom c_p\nfix mc", "does not see what walls carry"),
                ("walls plates", "walls plates cells 2 2 14", "which is less than the largest diameter 2: use at most"),
                (f"{SLIT_EDGES[0]:.17g} {SLIT_EDGES[1]:.17g}", "2 3.9",
                 "needs a box of at least the largest diameter, 2 along z, where it is 1.9: use a larger box, with walls inside of it")):
            with self.subTest(message=message):
                self.assertIn(old, start)
                self.assertIn(message, failure(start.replace(old, new) + "run 1\n", MIXTURE))

    def test_pressure(self):
        """Along plates: four ellipsoids without size, with the mean volume 5 at P = 1, as in a periodic box."""
        gas = System(1.6 * np.eye(3), True, np.array([[0.2, 0.2, 0.2], [1, 1, 1], [0.2, 1, 0.2], [0.2, 0.2, 1]]), np.full((4, 3), 0.005),
                     np.tile([1.0, 0.0, 0.0, 0.0], (4, 1)), np.ones(4, dtype=int))
        script = self.script("fix plates all wall/pw85 zplane 0.1 1.5 hard\n",
                             "1 3 trials 1 volume 0.5 pressure y 1 cells 2 2 2 walls plates", gas)
        script = script.replace("boundary p p p", "boundary p p f").replace(f"pw85/hard {gas.cutoff:.17g}", "pw85/hard 0.3")
        text, _ = run(script + "thermo_style custom step vol lz\nthermo_modify norm no\nthermo 1\nrun 20000\n", gas)
        rows = thermo(text)[1:]
        np.testing.assert_allclose(rows[:, 2], 1.6, rtol=1e-7)
        self.check_means(rows[None, :, 1], np.array([5.0]))


class Errors(unittest.TestCase):
    def expect(self, message, script, system=MIXTURE, ranks=1):
        self.assertIn(message, failure(script, system, ranks))

    def test_words(self):
        for words, message in (("0 1", "bad number of steps between sweeps: 0"), ("1 0", "bad seed: 0"), ("1", "lacks seed"),
                               ("1 1 rotate 4", "bad largest rotation: 4"), ("1 1 translate 0", "largest translation of zero"),
                               ("1 1 trials 0", "bad number of trials: 0"), ("1 1 shake 2", "unknown keyword shake: use one of cells,"),
                               ("1 1 cells 2 2", "lacks number of cells"),
                               ("1 1 pressure all 2", "unknown kind of pressure all: use one of aniso, iso, x, y, z"),
                               ("1 1 pressure iso -2", "bad pressure: -2"), ("1 1 volume 0.6", "bad largest change of the volume: 0.6"),
                               ("1 1 tune -1", "bad last step of tuning: -1")):
            with self.subTest(words=words):
                self.expect(message, hard(MIXTURE, words) + "run 0\n")

    def test_cells(self):
        self.expect("needs an even number of cells along x: use 4 instead of 3", hard(MIXTURE, "1 1 cells 3 2 2") + "run 0\n")
        self.expect("has cells with an edge of 1.39064333633354 along y, which is less than the largest diameter 2: use at most 4 cells",
                    hard(MIXTURE, "1 1 cells 2 6 2") + "run 0\n")
        self.expect("has 4 cells along z, which 3 sub-domains cannot share: use cells with a multiple of this number, at most 4",
                    "processors 1 1 3\n" + hard(MIXTURE, "1 1") + "run 0\n", ranks=3)
        thin = stretched_lattice((2, 5, 3), 1.18, (0.5, 0.5, 1.0))
        self.expect("needs a box of at least two of the largest diameter, 4 along x, where it is 3.3375",
                    hard(thin, "1 1") + "run 0\n", thin)

    def test_state(self):
        start, end = hard(MIXTURE, "1 1"), "run 30\n"
        for old, new, message in (
                ("pair_style pw85/hard 2", "pair_style pw85/hard 1.9", "the pair cutoff 1.9 of types 1 and 1 misses contacts: raise the "
                 "cutoff in pair_style or pair_coeff to 2 or more"),
                ("fix mc", "set atom 3 shape 2 2 2\nfix mc", "and atom 3 overlap at the start"),
                ("fix mc", "set atom 3 shape 0 0 0\nfix mc", "atom 3 has no shape"),
                ("fix mc", "fix other all nve/asphere\nfix mc",
                 "cannot run beside fix other (nve/asphere), which moves, adds or removes atoms or changes the box, too: unfix it"),
                ("fix mc", "fix other all pw85/hpmc 1 1\nfix mc", "cannot run beside fix mc (pw85/hpmc)"),
                ("fix mc", "region ball sphere 4 4 4 9\nfix other all evaporate 10 1 ball 7\nfix mc",
                 "cannot run beside fix other (evaporate)"),
                ("fix mc", "fix other all deform 1 x scale 1.1\nfix mc", "cannot run beside fix other (deform)"),
                ("fix mc all pw85/hpmc 1 1", "group big type 1\nfix mc big pw85/hpmc 1 1 pressure iso 1", "needs the group all"),
                ("fix mc", "region ball sphere 4 4 4 9\nfix other all wall/region ball lj93 1 1 1\nfix mc",
                 "does not see the walls of fix other (wall/region): use fix wall/pw85"),
                ("pair_style pw85/hard 2\npair_coeff * *", "pair_style pw85/contact 2\npair_coeff * * 1",
                 "energies of pair_style pw85/contact"),
                ("pair_style pw85/hard 2\npair_coeff * *\n" + COMPUTES, "", "energies of pair_style none"),
                ("fix mc", "run_style respa 2 2\nfix mc", "run_style verlet"),
                ("fix mc", "change_box all boundary p p s\nfix mc", "use boundary p or f instead of s or m"),
                ("fix mc", "balance 0.9 x uniform y 0.3\nfix mc", "sub-domains of equal size"),
                ("fix mc", "comm_style tiled\nfix mc", "sub-domains of equal size"),
                ("fix mc", "group big type 1\natom_modify first big\nfix mc", "remove atom_modify first"),
                ("fix mc", "neighbor 0.3 multi\ncomm_modify mode multi\nfix mc", "comm_modify mode single"),
                ("pair_style pw85/hard 2", "pair_style pw85/hard -1", "the cutoff must be positive and finite"),
                ("pair_coeff * *", "pair_coeff 1 1", "use pair_coeff * *"),
                ("neighbor", "dimension 2\nneighbor", "imension")):
            with self.subTest(message=message):
                self.assertIn(old, start)
                self.expect(message, ("processors 1 2 1\n" if "balance" in new else "") + start.replace(old, new) + end,
                            ranks=2 if "balance" in new else 1)
        self.expect("samples in runs, not in minimize: give this fix after minimize, or unfix it before", start + "minimize 0 0 1 1\n")
        self.expect("has no atoms in its group none: nothing would move",
                    start.replace("fix mc all", "group none empty\nfix mc none") + end)


if __name__ == "__main__":
    unittest.main()
