# SPDX-License-Identifier: GPL-2.0-only
"""Impacts of two ellipsoids against an integration of their equations of motion, and a stack that keeps still."""

import os
import unittest

import numpy as np
from lammps_runs import preamble, run
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar
from scipy.special import ellipk
from test_granular import Grains, granular

STIFFNESS, DAMPING, SLIDING, FRICTION = 50000.0, 1000.0, 10.0, 0.1

IMPACT = """
comm_modify vel yes
neighbor 0.1 bin
neigh_modify delay 0
{pair}
fix move all nve/asphere
timestep {timestep:.17g}
dump state all custom {steps} state.txt id x y z vx vy vz angmomx angmomy angmomz
dump_modify state sort id format float %.17g
run {steps}
"""


class Plane:
    """Two ellipsoids that stay in the plane of x and z, each with an axis along y. Their law is that of the runs, from its formulas.

    The state is x, z and the angle about y of both, then their rates."""

    def __init__(self, semi_axes, masses):
        self.semi_axes, self.masses = semi_axes, masses
        self.inertia = masses / 5.0 * (semi_axes[:, 0]**2 + semi_axes[:, 2]**2)

    def support(self, i, angle, normal):
        """The half-width of body i along a normal, and the point of its surface there."""
        axes = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        image = axes.T @ (self.semi_axes[i, ::2]**2 * (axes @ normal))
        height = np.sqrt(normal @ image)
        return height, image / height

    def contact(self, state):
        """The least depth over all normals in the plane, the normal, the point relative to both centres, and the curvatures."""
        (x1, z1, angle1), (x2, z2, angle2) = state[:6].reshape(2, 3)
        r = np.array([x2 - x1, z2 - z1])
        phi = np.arctan2(r[1], r[0])
        for _ in range(50):
            normal, along = np.array([np.cos(phi), np.sin(phi)]), np.array([-np.sin(phi), np.cos(phi)])
            (h1, p1), (h2, p2) = self.support(0, angle1, normal), self.support(1, angle2, normal)
            heights = np.array([h1, h2])
            slope = p1 + p2 - r
            radii = (self.semi_axes[:, 0] * self.semi_axes[:, 2])**2 / heights**3
            step = -(along @ slope) / (radii.sum() - normal @ slope)
            phi += step
            if abs(step) < 1e-9:
                break
        depth = normal @ slope
        across = heights / self.semi_axes[:, 1]**2
        return depth, normal, p1 - 0.5 * depth * normal, 0.5 * depth * normal - p2, sorted([(1.0 / radii).sum(), across.sum()])

    def rates(self, state):
        depth, normal, arm1, arm2, curvatures = self.contact(state)
        push, torques = np.zeros(2), np.zeros(2)
        if depth > 0.0:
            radius = hertz_radius(*curvatures)
            (*v1, spin1), (*v2, spin2) = state[6:].reshape(2, 3)
            slip = np.array(v1) + spin1 * turned(arm1) - np.array(v2) - spin2 * turned(arm2)
            approach = slip @ normal
            damped = DAMPING * self.masses.prod() / self.masses.sum() * np.sqrt(radius * depth)
            pressure = STIFFNESS * np.sqrt(radius * depth) * depth + damped * approach
            slip -= approach * normal
            size = np.linalg.norm(slip)
            drag = min(SLIDING * damped, FRICTION * abs(pressure) / size) if size > 0.0 else 0.0
            push = -pressure * normal - drag * slip
            torques = np.array([push @ turned(arm1), -push @ turned(arm2)])
        return np.concatenate([state[6:], push / self.masses[0], torques[:1] / self.inertia[0],
                               -push / self.masses[1], torques[1:] / self.inertia[1]])


def turned(arm):
    """The motion of the point (x, z) by a rotation about y with unit speed."""
    return np.array([arm[1], -arm[0]])


def hertz_radius(small, large):
    """Of Hertz's pressures, the one with the least energy: the largest 2 agm(1, k)²/(κ1 + κ2 k²), with agm(1, k) = π/(2 K(1 - k²))."""
    found = minimize_scalar(lambda k: -2.0 * (0.5 * np.pi / ellipk(1.0 - k * k))**2 / (small + large * k * k), bounds=(0.01, 1.0),
                            method="bounded", options={"xatol": 1e-6})
    return -found.fun


class Impacts(unittest.TestCase):
    LAW = f"hertz {STIFFNESS} {DAMPING} tangential linear_nohistory {SLIDING} {FRICTION}"
    SHAPES = np.array([[0.5, 0.4, 0.8], [0.3, 0.6, 0.45]])
    TIME = 0.16

    def rates_after(self, places, rates):
        """The rates (vx, vz, spin) after an impact, by LAMMPS and by the equations of motion."""
        angles = places[:, 2]
        quaternions = np.zeros((2, 4))
        quaternions[:, 0], quaternions[:, 2] = np.cos(0.5 * angles), np.sin(0.5 * angles)
        middle = np.array([3.0, 3.0, 3.0])
        spread = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
        up = np.array([0.0, 1.0, 0.0])
        grains = Grains(np.diag([6.0, 6.0, 6.0]), False, middle + places[:, :2] @ spread, self.SHAPES, quaternions,
                        np.ones(2, dtype=int), rates[:, :2] @ spread, rates[:, 2:] * up)
        timestep = 2e-5
        steps = round(self.TIME / timestep)
        commands = IMPACT.format(pair=granular(self.LAW), timestep=timestep, steps=steps)
        final = run(preamble(grains) + commands, grains, 1, ("state.txt",))[1][0][-1]
        plane = Plane(self.SHAPES, grains.masses)
        found = np.column_stack([final[:, 4], final[:, 6], final[:, 8] / plane.inertia])
        np.testing.assert_allclose(final[:, [5, 7, 9]], 0.0, atol=1e-9)  # they stay in the plane
        motion = solve_ivp(lambda _, y: plane.rates(y), (0.0, self.TIME), np.concatenate([places.ravel(), rates.ravel()]),
                           method="RK45", rtol=1e-8, atol=1e-10, max_step=0.001)
        self.assertLess(plane.contact(motion.y[:, -1])[0], 0.0, "the impact is not over")
        return found, motion.y[6:, -1].reshape(2, 3)

    def compare(self, places, rates):
        found, expected = self.rates_after(np.array(places), np.array(rates))
        print(f"rates after the impact: {found.ravel()}, by the equations of motion {expected.ravel()}")
        # The impact takes some 0.06, or 3000 steps. It starts and ends between two steps, so that the rates err by less than the mean
        # change in a step, some 1e-3. Verlet's own error is far smaller.
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-3)
        return found

    def test_head_on(self):
        """Tip to tip, so that nothing turns."""
        found = self.compare([[0.0, -0.63, 0.0], [0.0, 0.63, 0.0]], [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]])
        np.testing.assert_allclose(found[:, [0, 2]], 0.0, atol=1e-9)
        restitution = (found[1, 1] - found[0, 1]) / 2.0
        print(f"coefficient of restitution {restitution}")
        self.assertLess(restitution, 0.9, "hardly any damping")

    def test_oblique(self):
        """Tilted grains that spin, so that the contact moves over both surfaces and slides."""
        found = self.compare([[-0.15, -0.58, 0.4], [0.1, 0.56, -0.7]], [[0.3, 1.0, 1.5], [-0.2, -1.0, -0.5]])
        self.assertGreater(np.abs(found[:, 2] - [1.5, -0.5]).max(), 0.5, "the impact does not turn them")


STACK = """
comm_modify vel yes
neighbor 0.1 bin
neigh_modify delay 0
{pair}
fix floor all wall/pw85 zplane 0.0 NULL law {law}
fix weight all gravity 1.0 vector 0 0 -1
fix move all nve/asphere
timestep 0.001
fix drag all viscous 2.0
run 30000
unfix drag
compute turn all property/atom quatw quati quatj quatk
dump state all custom {steps} state.txt id x y z vx vy vz c_turn[*]
dump_modify state sort id first yes format float %.17g
run {steps}
"""


class Stack(unittest.TestCase):
    STEPS = int(os.environ.get("PW85_STACK_STEPS", "10000"))

    def test_still(self):
        """Flat ellipsoids on each other, whose tops are flat enough to carry the next one. They settle, and keep still."""
        count, law = 4, "hertz 20000 200 tangential mindlin 10000 0.5 0.5"
        shapes = np.array([[0.9, 0.8, 0.15]] * count)
        centers = np.array([[2.0 + 0.01 * (k % 2), 2.0, 0.149 + 0.299 * k] for k in range(count)])
        upright = np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
        grains = Grains(np.diag([4.0, 4.0, 4.0]), False, centers, shapes, upright, np.ones(count, dtype=int), *np.zeros((2, count, 3)))
        commands = STACK.format(pair=granular(law), law=law, steps=self.STEPS)
        before, *_, after = run(preamble(grains) + commands, grains, 1, ("state.txt",))[1][0]
        moved, speed = np.abs(after - before)[:, [1, 2, 3, 7, 8, 9, 10]].max(), np.abs(after[:, 4:7]).max()
        print(f"in {self.STEPS} steps the stack moves and turns by {moved}; the largest speed is {speed}")
        # The drag leaves some 1e-8 of the rocking, which decays slowly, because rolling has no friction.
        self.assertLess(moved, 1e-7)
        self.assertLess(speed, 1e-7)


if __name__ == "__main__":
    unittest.main()
