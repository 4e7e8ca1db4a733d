# SPDX-License-Identifier: GPL-2.0-only
"""The scripts of examples/lammps, on four ranks or one, with the pictures they are made for."""

import itertools
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from lammps_runs import launch, thermo

EXAMPLES = Path(os.environ["PW85_LAMMPS_EXAMPLES"])
sys.path.append(str(EXAMPLES))
from draw import forms, read_last_snapshot  # noqa: E402
from heap_angle import slope  # noqa: E402
from orifice import write_ring  # noqa: E402


class Examples(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def run_example(self, name, end="", axis="z", ranks=4, draws=True, **variables):
        """Runs a script, with more commands at its end, and draws its dump file if asked; returns what LAMMPS printed."""
        variables["pw85"] = os.environ["PW85_LAMMPS_INCLUDE"]
        start = "".join(f"variable {name} index {value}\n" for name, value in variables.items())
        Path(self.directory, "in.lammps").write_text(start + (EXAMPLES / f"{name}.in").read_text() + end)
        result = launch(self.directory, ranks)
        self.assertEqual(result.returncode, 0, result.stdout[-4000:])
        if not draws:
            return result.stdout
        draw = [sys.executable, EXAMPLES / "draw.py", f"{name}.dump", f"{name}.png", axis]
        subprocess.run(draw, cwd=self.directory, check=True, env={**os.environ, "MPLCONFIGDIR": self.directory})
        self.assertTrue(Path(self.directory, f"{name}.png").read_bytes().startswith(b"\x89PNG"))
        return result.stdout

    def number(self, label, text):
        return float(re.search(rf"^{label}(\S+)", text, re.MULTILINE).group(1))

    def test_check_overlaps(self):
        text = self.run_example("check_overlaps", "write_data snapshot.data nocoeff\n")
        self.assertGreater(self.number("overlapping pairs: ", text), 0)
        self.assertLess(self.number("deepest overlap: mu2 = ", text), 1)
        again = self.run_example("check_overlaps", draws=False, ranks=1, snapshot="snapshot.data")
        on_eight = self.run_example("check_overlaps", draws=False, ranks=8)
        for label in ("overlapping pairs: ", "deepest overlap: mu2 = "):
            self.assertEqual(self.number(label, again), self.number(label, text))
            self.assertEqual(self.number(label, on_eight), self.number(label, text))

    def test_pack(self):
        text = self.run_example("pack", ranks=1)
        self.assertEqual(self.number("overlapping pairs: ", text), 0)
        self.assertGreaterEqual(self.number("smallest mu2: ", text), 1)
        self.assertAlmostEqual(self.number("volume fraction: ", text), 0.64, delta=1e-9)
        self.check_steps_printed_twice(text)
        checked = self.run_example("check_overlaps", draws=False, snapshot="pack.data", cutoff=1.5)
        self.assertEqual(self.number("overlapping pairs: ", checked), 0)

    def test_relax(self):
        text = self.run_example("relax")
        self.assertEqual(self.number("overlapping pairs: ", text), 0)
        self.assertAlmostEqual(self.number("volume fraction: ", text), 0.68, delta=1e-9)

    def test_hard(self):
        text = self.run_example("hard", ranks=1, sweeps=1000)
        self.assertEqual(self.number("overlapping pairs: ", text), 0)
        rows = thermo(text)
        self.assertLess(rows[0, 1], 0.23)
        self.assertGreater(rows[-1, 1], 0.27)
        self.assertGreater(self.number("volume fraction: ", text), rows[0, 1])

    def test_hard_on_any_number_of_ranks(self):
        """The same dump file, bit by bit, on 1, 4 and 8 ranks."""
        dumps = set()
        for ranks in (1, 4, 8):
            self.run_example("hard", "dump_modify atoms format float %.17g\nrun 20\n", ranks=ranks, draws=False, sweeps=20)
            dumps.add(Path(self.directory, "hard.dump").read_text())
        self.assertEqual(len(dumps), 1)

    def test_dynamics(self):
        """With the energy of rotation the total is conserved; without it, etotal is not."""
        rows = thermo(self.run_example("dynamics"))
        energy, translation, rotation, etotal, total = rows[:, 1:].T
        np.testing.assert_allclose(etotal, energy + translation, rtol=1e-9)
        np.testing.assert_allclose(total, etotal + rotation, rtol=1e-9)
        # 5e-6 is what this time step leaves (test_dynamics.py: its square), 0.28 the part that goes into rotation.
        self.assertLess(np.ptp(total), 1e-5 * total[0])
        self.assertGreater(np.ptp(etotal), 0.25 * total[0])

    def test_pour(self):
        """Grains at rest under their own weight, with friction, have between four and six contacts."""
        text = self.run_example("pour", ranks=1, steps=9500)
        self.assertEqual(self.number("grains: ", text), 300)
        self.assertEqual(thermo(text)[0, 1], 0)
        self.assertLess(self.number("kinetic energy of a grain: ", text), 1e-2)
        self.assertGreater(self.number("contacts of a grain: ", text), 4.0)
        self.assertLess(self.number("contacts of a grain: ", text), 6.0)

    def test_heap(self):
        """Prolate grains with friction make a slope; without friction they would flow away.

        The slope of so few grains is uncertain by some degrees: five sets of random places and orientations gave 13 to 24.
        """
        text = self.run_example("heap", axis="y", ranks=1)
        self.assertEqual(self.number("grains: ", text), 200)
        columns = read_last_snapshot(Path(self.directory, "heap.dump"))[2]
        self.assertGreater(slope(columns), 8)
        self.assertLess(slope(columns), 34)
        self.assertLess(self.number("kinetic energy of a grain: ", text), 0.1)

    def test_slope(self):
        """Layers of spheres below two planes that fall to both sides by 25 degrees, and a sphere that falls beside them."""
        tangent = np.tan(np.radians(25))
        x, y = (grid.ravel() for grid in np.meshgrid(np.arange(-15, 15.1, 0.5), np.arange(0.25, 4, 0.5)))
        x, y, z = np.tile(x, 2), np.tile(y, 2), np.concatenate([8 - tangent * np.abs(x), 7 - tangent * np.abs(x)])
        x, y, z = np.append(x, 20.0), np.append(y, 2.0), np.append(z, 7.0)
        columns = {"x": x, "y": y, "z": z, "c_overlap": np.append(np.ones(x.size - 1), 0)}
        columns |= {f"c_shape[{k}]": np.full(x.size, 1.0 if k < 5 else 0.0) for k in range(1, 8)}
        self.assertAlmostEqual(slope(columns), 25, delta=1e-9)

    def test_hopper(self):
        """Flows through two holes are those of Beverloo's law, roughly.

        A hundred grains leave, and the filling is only as high as the hole is wide: the flows are some 0.8 of those of the law.
        """
        for hole in (4, 5):
            write_ring(hole, 9, Path(self.directory, "orifice.stl"))
            text = self.run_example("hopper", axis="y", ranks=1, draws=hole == 4, hole=hole, fill=3500, steps=1600)
            self.assertEqual(self.number("grains: ", text), 480)
            ratio = self.number("flow of grains: ", text) / self.number("flow by the law: ", text)
            print(f"hole {hole}: {ratio} of the flow by the law")
            self.assertGreater(ratio, 0.5, hole)
            self.assertLess(ratio, 1.1, hole)

    def test_drum(self):
        """The wall lifts the grains on one side, and none leaves the drum.

        A grain of mass 0.31 falls by at most 2 R = 8. The energy of a contact is 2/5 K sqrt(radius) depth^(5/2), with K = 7100 for
        this material and an equivalent radius of at least 0.15 (two grains, rim on rim). So an impact is no deeper than 0.09.
        """
        text = self.run_example("drum", axis="y", ranks=1)
        self.assertEqual(self.number("grains: ", text), 111)
        self.assertGreater(self.number("angle of repose in degrees: ", text), 30)
        self.assertLess(self.number("angle of repose in degrees: ", text), 50)
        columns = read_last_snapshot(Path(self.directory, "drum.dump"))[2]
        q = forms(columns)
        angles = np.linspace(0, 2 * np.pi, 720, endpoint=False)
        normals = np.stack([np.cos(angles), 0 * angles, np.sin(angles)], axis=1)
        centers = np.stack([columns[axis] for axis in "xyz"], axis=1)
        reach = (centers @ normals.T + np.sqrt(np.einsum("ka,nab,kb->nk", normals, q, normals))).max()
        self.assertGreater(reach, 4)  # grains press on the wall
        self.assertLess(reach, 4.09)
        self.assertLess((np.abs(centers[:, 1] - 2) + np.sqrt(q[:, 1, 1])).max(), 2.09)
        # 1 - mu is at most the depth over the sum of the half widths along the normal, which is at least 0.6.
        self.assertGreater(self.number("smallest mu2: ", text), 1 - 2 * 0.09 / 0.6)

    def check_steps_printed_twice(self, text):
        """The last line of a run and the first of the next have the same step, and the same ellipsoids."""
        rows = [line.split() for line in text.splitlines() if re.fullmatch(r" *\d+( +\S+){6} *", line)]
        pairs = [(a, b) for a, b in itertools.pairwise(rows) if a[0] == b[0]]
        self.assertEqual([a[0] for a, _ in pairs], ["3000", "4000", "5000"])
        for a, b in pairs[:2]:  # after the third change, that of the shapes, other ellipsoids overlap
            self.assertEqual(a[5], b[5])


if __name__ == "__main__":
    unittest.main()
