# SPDX-License-Identifier: GPL-2.0-only
"""fix pw85/hpmc: Monte Carlo of hard ellipsoids."""

import re
import tempfile
import unittest
from pathlib import Path

import numpy as np
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


# 300 ellipsoids that fill 0.34 of the box.
MIXTURE = stretched_lattice((5, 5, 3), 1.18, (0.5, 0.5, 1.0))


def hard(system, words, computes=COMPUTES):
    return preamble(system) + HARD.format(cutoff=system.cutoff) + computes + f"fix mc all pw85/hpmc {words}\n"


class Ranks(unittest.TestCase):
    WORDS = "1 7 translate 0.2 rotate 0.4 trials 3"

    def final(self, ranks, grid="* * *", words=WORDS, runs="run 40\n"):
        script = f"processors {grid}\n" + hard(MIXTURE, words) + runs + FINAL
        _, ((columns,),) = run(script, MIXTURE, ranks, ("final.txt",))
        return columns

    def test_same_bits(self):
        one = self.final(1)
        moved = np.abs(one[:, 1:4] + one[:, 4:7] * MIXTURE.cell.diagonal() - MIXTURE.centers).max(axis=1)
        self.assertGreater(np.median(moved), 0.2)
        self.assertGreater(np.median(np.abs(one[:, 8:]).max(axis=1)), 0.2)
        for ranks, grid in ((2, "2 1 1"), (4, "1 2 2"), (4, "1 1 4"), (8, "2 2 2")):
            with self.subTest(ranks=ranks, grid=grid):
                np.testing.assert_array_equal(self.final(ranks, grid), one)


if __name__ == "__main__":
    unittest.main()
