# SPDX-License-Identifier: GPL-2.0-only
"""The styles in a LAMMPS that a program drives: values are right at any time, or there is a clear error."""

import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import brute_force
import numpy as np
from lammps_runs import preamble, random_system

SYSTEM = random_system(31, 300, np.diag([11.0, 12.0, 13.0]))

PROGRAM = """
import ctypes
from lammps import *
lmp = lammps(cmdargs=["-log", "none"])
def start():
    ctypes.CDLL({plugin!r}).pw85_lammps_register(lmp.lmp)
    lmp.commands_string({script!r})
def pairs():
    return int(lmp.extract_compute("o", LMP_STYLE_GLOBAL, LMP_TYPE_SCALAR))
def contacts():
    return int(lmp.extract_compute("c", LMP_STYLE_GLOBAL, LMP_TYPE_SCALAR))
def rows():
    return lmp.extract_compute("c", LMP_STYLE_LOCAL, LMP_SIZE_ROWS)
def smallest():
    return lmp.numpy.extract_compute("c", LMP_STYLE_ATOM, LMP_TYPE_VECTOR).min()
start()
"""


@unittest.skipIf(importlib.util.find_spec("lammps") is None, "the Python module of LAMMPS is not installed")
class Library(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected = brute_force.Expected(SYSTEM, SYSTEM.cutoff)

    def execute(self, program):
        """What a program prints that continues PROGRAM, and whether it ended well; it must not die of a signal."""
        script = "\n".join(line for line in preamble(SYSTEM).splitlines() if not line.startswith("include"))
        script += (f"\npair_style zero {SYSTEM.cutoff:.17g}\npair_coeff * *\ncompute o all pw85/overlap\n"
                   "compute c all pw85/contact below 1.0\n")
        start = PROGRAM.format(plugin=os.environ["PW85_LAMMPS_PLUGIN"], script=script)
        with tempfile.TemporaryDirectory() as directory:
            Path(directory, "system.data").write_text(SYSTEM.data_file())
            # MALLOC_PERTURB_ fills memory, which shows what LAMMPS and the styles leave uninitialised.
            result = subprocess.run([sys.executable, "-c", start + program], cwd=directory, check=False, text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                    env={**os.environ, "MALLOC_PERTURB_": "85"})
        self.assertGreaterEqual(result.returncode, 0, f"{program}\n{result.stdout[-3000:]}")
        return result.stdout, result.returncode == 0

    def expect_values(self, program):
        text, ok = self.execute(program + "\nprint('values', pairs(), contacts(), rows(), smallest().hex())")
        self.assertTrue(ok, text[-3000:])
        words = text[text.index("values"):].split()[1:5]
        self.assertEqual([int(word) for word in words[:3]], [self.expected.overlapping_pairs] * 3)
        self.assertAlmostEqual(float.fromhex(words[3]), self.expected.smallest.min(), delta=1e-14)

    def expect_error(self, program, *messages):
        text, ok = self.execute(program)
        self.assertFalse(ok, text[-3000:])
        for message in messages:
            self.assertIn(message, text)

    def test_after_a_run(self):
        self.expect_values("lmp.command('run 0')")

    def test_before_a_run(self):
        for ask in ("pairs()", "contacts()", "rows()", "smallest()",
                    "lmp.numpy.extract_compute('o', LMP_STYLE_ATOM, LMP_TYPE_VECTOR)"):
            with self.subTest(ask=ask):
                self.expect_error(ask, "before a run", "use run 0 first")
        self.expect_error("lmp.command('run 0'); lmp.command('compute n all pw85/overlap'); "
                          "lmp.extract_compute('n', LMP_STYLE_GLOBAL, LMP_TYPE_SCALAR)", "before a run")

    def test_the_pair_style_changes_after_a_run(self):
        for command in ("pair_style none", "pair_style lj/cut 2.5"):
            with self.subTest(command=command):
                self.expect_values(f"lmp.command('run 0'); lmp.command('{command}')")
        self.expect_error("lmp.command('run 0'); lmp.command('pair_style none'); lmp.command('run 0')", "pair_style zero")

    def test_atoms_change_after_a_run(self):
        for command in ("delete_atoms group all", "displace_atoms all random 3 3 3 1", "change_box all x scale 0.7 remap",
                        "create_atoms 1 random 50 1 NULL"):
            with self.subTest(command=command):
                self.expect_error(f"lmp.command('run 0'); lmp.command('{command}'); pairs()", "use run 0 first")
                self.expect_error(f"lmp.command('run 0'); lmp.command('{command}'); rows()", "use run 0 first")

    def test_a_part_is_gone(self):
        self.expect_error("lmp.command('run 0'); lmp.command('unfix PW85_BUILD_o'); pairs()", "define the compute again")
        self.expect_values("lmp.command('compute n all pw85/overlap'); lmp.command('run 0'); "
                           "lmp.command('uncompute n'); lmp.command('run 0')")

    def test_clear(self):
        self.expect_values("lmp.command('run 0'); lmp.command('clear'); start(); lmp.command('run 0')")


if __name__ == "__main__":
    unittest.main()
