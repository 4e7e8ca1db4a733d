# SPDX-License-Identifier: GPL-2.0-only
"""The scripts of examples/lammps, on two ranks, with the pictures they are made for."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from lammps_runs import launch

EXAMPLES = Path(os.environ["PW85_LAMMPS_EXAMPLES"])


class Examples(unittest.TestCase):
    def run_example(self, name):
        """Runs a script and draws its dump file; returns what LAMMPS printed, and the path and bytes of the picture."""
        with tempfile.TemporaryDirectory() as directory:
            include = f"variable pw85 index {os.environ['PW85_LAMMPS_INCLUDE']}\n"
            Path(directory, "in.lammps").write_text(include + (EXAMPLES / f"{name}.in").read_text())
            result = launch(directory, 2)
            self.assertEqual(result.returncode, 0, result.stdout[-4000:])
            draw = [sys.executable, EXAMPLES / "draw.py", f"{name}.dump", f"{name}.png"]
            subprocess.run(draw, cwd=directory, check=True, env={**os.environ, "MPLCONFIGDIR": directory})
            self.assertTrue(Path(directory, f"{name}.png").read_bytes().startswith(b"\x89PNG"))
            return result.stdout

    def number(self, label, text):
        return float(re.search(rf"^{label}(\S+)", text, re.MULTILINE).group(1))

    def test_check_overlaps(self):
        text = self.run_example("check_overlaps")
        self.assertGreater(self.number("overlapping pairs: ", text), 0)
        self.assertLess(self.number("deepest overlap: mu2 = ", text), 1)

    def test_pack(self):
        text = self.run_example("pack")
        self.assertEqual(self.number("overlapping pairs: ", text), 0)
        self.assertGreaterEqual(self.number("smallest mu2: ", text), 1)
        self.assertAlmostEqual(self.number("volume fraction: ", text), 0.64, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
