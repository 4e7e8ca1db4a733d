# SPDX-License-Identifier: GPL-2.0-only
"""The soft potential: forces, torques, pressure, conservation of energy, and independence of the number of ranks."""

import dataclasses
import itertools
import unittest

import numpy as np
from lammps_runs import preamble, random_system, run, thermo

# About as dense as a liquid, with some 300 overlapping pairs.
LIQUID = random_system(11, 200, [[10.0, 0, 0], [2.0, 10.0, 0], [-1.0, 1.5, 10.0]], aspect=2.0)

SOFT = """
neighbor 0.4 bin
neigh_modify delay 0
pair_style pw85/contact {cutoff:.17g} {exponent}
pair_coeff 1 1 100.0
pair_coeff 2 2 50.0
compute overlap all pw85/overlap
"""

STATIC = """
compute stress all pressure NULL virial
thermo_style custom step pe c_stress[1] c_stress[2] c_stress[3] c_stress
thermo_modify norm no format float %.17g
dump forces all custom 1 forces.txt id fx fy fz tqx tqy tqz
dump_modify forces sort id format float %.17g
run 0
"""

MOVING = """
velocity all create 0.5 4711 loop geom
compute spin all erotate/asphere
variable total equal pe+ke+c_spin
fix integrate all nve/asphere
timestep {timestep:.17g}
thermo {every}
thermo_style custom step v_total pe ke c_spin c_overlap press
thermo_modify norm no format float %.17g
run {steps}
"""


def soft(system, newton="on", exponent=2.0):
    return preamble(system, newton) + SOFT.format(cutoff=system.cutoff, exponent=exponent)


def static(system, newton="on", ranks=1, exponent=2.0):
    """Energy, the diagonal of the virial pressure and its mean, and the forces and torques."""
    text, ((forces,),) = run(soft(system, newton, exponent) + STATIC, system, ranks, ("forces.txt",))
    return thermo(text)[0, 1], thermo(text)[0, 2:], forces[:, 1:]


def displaced(system, atom, vector):
    centers = system.centers.copy()
    centers[atom] += vector
    return dataclasses.replace(system, centers=centers)


def rotated(system, atom, vector):
    """One ellipsoid turned about its centre by a rotation vector."""
    angle = np.linalg.norm(vector)
    w, v = np.cos(angle / 2), np.sin(angle / 2) * vector / angle
    u, q = system.quaternions[atom, 0], system.quaternions[atom, 1:]
    quaternions = system.quaternions.copy()
    quaternions[atom] = [w * u - v @ q, *(w * q + u * v + np.cross(v, q))]
    return dataclasses.replace(system, quaternions=quaternions)


def stretched(system, factors):
    return dataclasses.replace(system, cell=system.cell * factors, centers=system.centers * factors)


def slope(function, step):
    """Derivative at zero by differences of fourth order."""
    far = function(2 * step) - function(-2 * step)
    return (8 * (function(step) - function(-step)) - far) / (12 * step)


class Forces(unittest.TestCase):
    # Differences of fourth order with step h of an energy E carry an error of h⁴ E⁗′/30 + u E/h: with h = 1e-4, E = 2e3
    # and derivatives that grow by less than a factor 30 each, 1e-8. A pair that begins to touch within the step adds up
    # to ε h = 1e-2, which the seeds exclude.
    tolerance = 1e-6
    step = 1e-4

    def check_gradient(self, exponent):
        _, _, forces = static(LIQUID, exponent=exponent)
        atom = int(np.abs(forces[:, 3:]).sum(axis=1).argmax())
        for axis in range(3):
            unit = np.eye(3)[axis]
            for change, value in ((displaced, forces[atom, axis]), (rotated, forces[atom, 3 + axis])):
                derivative = slope(lambda h: static(change(LIQUID, atom, h * unit), exponent=exponent)[0], self.step)
                scale = max(1.0, np.abs(forces[atom]).max())
                self.assertLessEqual(abs(value + derivative), self.tolerance * scale,
                                     f"{change.__name__} {atom} {axis}: {value.hex()} {(-derivative).hex()}")

    def test_forces_are_the_gradient(self):
        for exponent in (2.0, 2.5):
            with self.subTest(exponent=exponent):
                self.check_gradient(exponent)

    def check_pressure(self, system, newton, factors, value):
        """Compares a pressure with minus the derivative of the energy by strain, over the volume."""
        volume = abs(np.linalg.det(system.cell))
        derivative = slope(lambda h: static(stretched(system, factors(h)), newton)[0], 1e-5) / volume
        self.assertLessEqual(abs(value + derivative), self.tolerance * abs(value), (value.hex(), derivative.hex()))

    def test_pressure_is_the_volume_derivative(self):
        box = random_system(12, 200, np.diag([10.0, 10.0, 10.0]), aspect=2.0)
        for system, newton in ((LIQUID, "on"), (LIQUID, "off"), (box, "on")):
            _, stress, _ = static(system, newton)
            self.check_pressure(system, newton, lambda h: np.full(3, 1 + h / 3), stress[3])
        for axis in range(3):
            self.check_pressure(box, "on", lambda h: 1 + h * np.eye(3)[axis], stress[axis])

    def test_ranks_and_newton(self):
        energy, stress, forces = static(LIQUID)
        for newton, ranks in itertools.product(("on", "off"), (1, 2, 4)):
            with self.subTest(newton=newton, ranks=ranks):
                other_energy, other_stress, other_forces = static(LIQUID, newton, ranks)
                # Sums over some 300 pairs in another order, of terms no larger than the total.
                self.assertLessEqual(abs(other_energy - energy), 1e-12 * energy)
                np.testing.assert_allclose(other_stress, stress, rtol=0, atol=1e-12 * np.abs(stress).max())
                np.testing.assert_allclose(other_forces, forces, rtol=0, atol=1e-11 * np.abs(forces).max())


class Motion(unittest.TestCase):
    def relaxed(self):
        """A liquid whose overlaps are slight, as in a run."""
        return random_system(13, 200, np.diag([13.0, 13.0, 13.0]), aspect=2.0)

    def run_nve(self, timestep, exponent=2.0, ranks=1, newton="on", duration=1.0, every=0.02):
        system = self.relaxed()
        script = soft(system, newton, exponent) + MOVING.format(
            timestep=timestep, every=round(every / timestep), steps=round(duration / timestep))
        return thermo(run(script, system, ranks)[0])

    def test_energy_is_conserved(self):
        """The error of the total energy falls as the square of the time step."""
        for exponent in (2.0, 2.5):
            errors = []
            for timestep in (0.004, 0.002, 0.001):
                total = self.run_nve(timestep, exponent)[:, 1]
                errors.append(np.abs(total - total[0]).max() / total[0])
            print(f"exponent {exponent}: relative error of the energy for time steps 0.004, 0.002, 0.001: {errors}")
            self.assertGreater(errors[0] / errors[2], 8.0, errors)
            self.assertLess(errors[2], 1e-5)

    def test_same_counts_on_one_and_two_ranks(self):
        reference = self.run_nve(0.002)
        self.assertGreater(len(set(reference[:, 5])), 5, "the count of overlaps hardly changes")
        for ranks, newton in ((2, "on"), (2, "off"), (4, "on")):
            with self.subTest(ranks=ranks, newton=newton):
                other = self.run_nve(0.002, ranks=ranks, newton=newton)
                np.testing.assert_array_equal(other[:, 5], reference[:, 5])


if __name__ == "__main__":
    unittest.main()
