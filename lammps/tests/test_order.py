# SPDX-License-Identifier: GPL-2.0-only
"""compute pw85/order against the eigenvalues of the tensor of order by NumPy."""

import re
import unittest

import numpy as np
from lammps_runs import failure, preamble, random_system, run
from test_granular import rotation

SCRIPT = """
pair_style zero 2.0
pair_coeff * *
{more}
compute order {group} pw85/order
thermo_style custom step c_order c_order[*]
thermo_modify norm yes
run 0
print "order = $(c_order:%.17g) $(c_order[1]:%.17g) $(c_order[2]:%.17g) $(c_order[3]:%.17g) $(c_order[4]:%.17g) $(c_order[5]:%.17g) &
$(c_order[6]:%.17g)"
"""


def found(system, ranks=1, more="", group="all", start=""):
    script = start + preamble(system) + SCRIPT.format(more=more, group=group)
    text, _ = run(script, system, ranks)
    return np.array([float(word) for word in re.search(r"^order = (.*)$", text, re.MULTILINE).group(1).split()])


def axes(system):
    """The axis whose length differs most from the middle one."""
    order = np.argsort(system.semi_axes, axis=1)
    rows = np.arange(len(order))
    short, middle, long = (system.semi_axes[rows, order[:, k]] for k in range(3))
    chosen = np.where(long - middle >= middle - short, order[:, 2], order[:, 0])
    return np.array([rotation(q)[:, k] for q, k in zip(system.quaternions, chosen, strict=True)])


class Order(unittest.TestCase):
    def system(self, spread=0.3):
        """General ellipsoids around a direction."""
        system = random_system(3, 200, np.diag([20.0, 20.0, 20.0]))
        random = np.random.default_rng(1)
        system.quaternions[:] = [0.8, 0.3, -0.5, 0.1] + spread * random.normal(size=(200, 4))
        system.quaternions /= np.linalg.norm(system.quaternions, axis=1)[:, None]
        return system

    def check(self, values, u, factor=1.5):
        eigenvalues, vectors = np.linalg.eigh(factor * u.T @ u / len(u) - (factor - 1.0) * np.eye(3))
        np.testing.assert_allclose(values[4:], eigenvalues[::-1], rtol=0, atol=1e-14)
        self.assertEqual(values[0], values[4])
        director = vectors[:, 2] * np.sign(vectors[np.abs(vectors[:, 2]).argmax(), 2])
        np.testing.assert_allclose(values[1:4], director, rtol=0, atol=1e-13)

    def test_eigenvalues(self):
        for spread in (0.0, 0.2, 10.0):
            system = self.system(spread)
            for ranks in (1, 2):
                self.check(found(system, ranks), axes(system))

    def test_group(self):
        system = self.system()
        self.check(found(system, 2, "group small type 2", "small"), axes(system)[system.types == 2])

    def test_spheres(self):
        """They have no axis: they do not count, and have no order if they are alone."""
        system = self.system()
        system.semi_axes[::2] = 0.4
        self.check(found(system), axes(system)[1::2])
        system.semi_axes[:] = 0.4
        self.assertTrue(np.isnan(found(system)).all())

    def test_plane(self):
        """The order of the long axes in the plane, 2 <u u> - 1, whatever the third axis."""
        system = random_system(5, 100, np.diag([20.0, 20.0, 1.0]))
        system.centers[:, 2] = 0.5
        angles = np.random.default_rng(2).normal(size=100)
        system.quaternions[:] = np.stack([np.cos(angles / 2), 0 * angles, 0 * angles, np.sin(angles / 2)], axis=1)
        system.semi_axes[:] = [0.3, 0.5, 0.8]
        system.semi_axes[::2] = [0.5, 0.3, 0.1]
        long = np.where(np.arange(100) % 2 == 0, angles, angles + np.pi / 2)
        u = np.stack([np.cos(long), np.sin(long), 0 * long], axis=1)
        values = found(system, start="dimension 2\n")
        eigenvalues = np.linalg.eigvalsh((2 * u.T @ u / 100 - np.eye(3))[:2, :2])
        np.testing.assert_allclose(values[[0, 4, 5]], eigenvalues[[1, 1, 0]], rtol=0, atol=1e-14)
        self.assertEqual(values[3], 0)

    def test_errors(self):
        system = self.system()
        start = preamble(system) + "pair_style zero 2.0\npair_coeff * *\n"
        self.assertIn("it takes no arguments", failure(start + "compute order all pw85/order x\n", system))


if __name__ == "__main__":
    unittest.main()
