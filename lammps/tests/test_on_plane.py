# SPDX-License-Identifier: GPL-2.0-only
"""Grains that slide, roll and rock on a plane, against closed forms and an integration of their equations of motion."""

import unittest

import numpy as np
from lammps_runs import preamble, run
from scipy.integrate import solve_ivp
from test_granular import Grains, rotation

STIFFNESS, SLIDING, FRICTION = 1e4, 8e3, 0.3
LAW = f"hooke {STIFFNESS} {{}} damping velocity tangential linear_history {SLIDING} {{}} {{}}"
TIMESTEP = 2e-4  # some 0.03 √(m/k)

# The gravity is 1. While a grain slides, friction changes its velocity in a step by FRICTION TIMESTEP. The first step has half of
# that, because new contacts have no friction while a run is set up; and a grain stops sliding between two steps.
VELOCITY_ERROR = 3.0 * FRICTION * TIMESTEP

ON_PLANE = """
pair_style zero 4.0
pair_coeff * *
neighbor 0.3 bin
comm_modify vel yes
fix floor all wall/pw85 zplane 0.0 NULL law {law}
fix weight all gravity 1.0 vector 0 0 -1
fix move all nve/asphere
timestep {timestep}
compute turn all property/atom quatw quati quatj quatk angmomx angmomy angmomz
dump state all custom {every} state.txt id x y z vx vy vz c_turn[*]
dump_modify state sort id format float %.17g
run {steps}
"""


def about(angle, *axis):
    """The quaternion of a rotation by an angle about an axis."""
    return np.array([np.cos(0.5 * angle), *(np.sin(0.5 * angle) * np.array(axis, dtype=float))])


def trajectory(grains, time, samples, damping=(0.0, 0.0), friction=FRICTION):
    """The states of all grains at equidistant times, in the order of Body. No grain feels another one."""
    every = round(time / samples / TIMESTEP)
    commands = ON_PLANE.format(law=LAW.format(*damping, friction), timestep=TIMESTEP, every=every, steps=every * samples)
    return np.array(run(preamble(grains) + commands, grains, 1, ("state.txt",))[1][0])[:, :, 1:]


class Body:
    """An ellipsoid of density 1 on the floor z = 0, with the springs of the law and without damping.

    The state is position, velocity, quaternion, angular momentum, and the force of the tangential spring. While the grain slides, this
    force has the size that Coulomb's limit allows."""

    def __init__(self, semi_axes):
        self.square = np.square(semi_axes)
        self.mass = 4.0 / 3.0 * np.pi * np.prod(semi_axes)
        self.inertia = 0.2 * self.mass * (self.square.sum() - self.square)

    def lowest(self, axes):
        """The lowest point of the grain, from its centre."""
        return -axes @ (self.square * axes[2]) / np.sqrt(self.square @ np.square(axes[2]))

    def contact(self, y):
        """The spin, the middle of the overlap from the centre, the depth, its rate, and the velocity along the floor."""
        axes = rotation(y[6:10])
        spin = axes @ (axes.T @ y[10:13] / self.inertia)
        low = self.lowest(axes)
        depth = -low[2] - y[2]
        middle = low + [0.0, 0.0, 0.5 * depth]
        return spin, middle, depth, -(y[3:6] + cross(spin, low))[2], (y[3:6] + cross(spin, middle))[:2]

    def rates(self, y, slides):
        spin, middle, depth, sinking, slip = self.contact(y)
        drag, change = y[13:], -SLIDING * slip
        if slides:
            along = drag / np.sqrt(drag @ drag)
            drag = FRICTION * STIFFNESS * depth * along
            change = change + (FRICTION * STIFFNESS * sinking - change @ along) * along
        force = np.array([*drag, STIFFNESS * depth])
        turn = 0.5 * np.array([-spin @ y[7:10], *(y[6] * spin + cross(spin, y[7:10]))])
        return np.concatenate([y[3:6], force / self.mass - [0.0, 0.0, 1.0], turn, cross(middle, force), change])

    def excess(self, y, slides):
        """By how much the spring of a rolling grain exceeds the limit; of a sliding one, how fast it would do so."""
        _, _, depth, sinking, slip = self.contact(y)
        size = np.sqrt(y[13:] @ y[13:])
        if slides:
            return -SLIDING * slip @ y[13:] / size - FRICTION * STIFFNESS * sinking
        return size - FRICTION * STIFFNESS * depth

    def integrate(self, start, times):
        """The states at some times, and the number of changes from sliding to rolling."""
        y, time, slides, states, stops = np.concatenate([start, np.zeros(2)]), 0.0, False, [], 0
        while len(states) < len(times):
            def event(_, y, s=slides):
                return self.excess(y, s)
            event.terminal, event.direction = True, -1.0 if slides else 1.0
            motion = solve_ivp(lambda _, y, s=slides: self.rates(y, s), (time, times[-1]), y, method="LSODA", rtol=1e-7, atol=1e-9,
                               t_eval=times[len(states):], events=event)
            states += list(np.transpose(motion.y))
            if motion.status == 1:
                time, y = motion.t_events[0][0], motion.y_events[0][0]
                if slides:
                    y[13:] *= FRICTION * STIFFNESS * self.contact(y)[2] / np.linalg.norm(y[13:])
                slides, stops = not slides, stops + slides
        return np.array(states), stops

    def energy(self, y):
        """Without that of the tangential spring."""
        spin, _, depth, _, _ = self.contact(y)
        return 0.5 * self.mass * y[3:6] @ y[3:6] + 0.5 * spin @ y[10:13] + self.mass * y[2] + 0.5 * STIFFNESS * depth**2


def cross(a, b):
    """np.cross takes ten times as long."""
    (a0, a1, a2), (b0, b1, b2) = a.tolist(), b.tolist()
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])


def placed(shapes, quaternions, velocities, spins):
    """Grains on the floor, as deep as the spring needs to carry them. Their contacts do not rise at first.

    A velocity of None is that of rolling."""
    shapes, spins = np.array(shapes, dtype=float), np.array(spins, dtype=float)
    count = len(shapes)
    grains = Grains(np.diag([40.0, 40.0, 40.0]), False, np.full((count, 3), 20.0), shapes, np.array(quaternions),
                    np.ones(count, dtype=int), np.zeros((count, 3)), spins)
    for i, velocity in enumerate(velocities):
        low = Body(shapes[i]).lowest(rotation(quaternions[i]))
        depth = grains.masses[i] / STIFFNESS
        grains.centers[i, 2] = -low[2] - depth
        rolling = -np.cross(spins[i], low + [0.0, 0.0, 0.5 * depth])
        grains.velocities[i] = rolling if velocity is None else [*velocity, rolling[2]]
    return grains


class OnPlane(unittest.TestCase):
    def test_sliding_sphere(self):
        """A sphere that slides rolls in the end, with 5/7 of its velocity; so does a spheroid across its axis of symmetry."""
        shapes, speed, time, samples = np.array([[0.5, 0.5, 0.5], [0.4, 0.9, 0.4]]), 0.6, 1.0, 20
        grains = placed(shapes, [about(0.0, 0, 0, 1)] * 2, [[speed, 0.0]] * 2, np.zeros((2, 3)))
        states = trajectory(grains, time, samples, damping=(20.0, 1.0))
        times = np.linspace(0.0, time, samples + 1)
        for i, radius in enumerate(shapes[:, 0]):
            arm = radius - 0.5 * grains.masses[i] / STIFFNESS
            final = speed / (1.0 + 0.4 * (radius / arm)**2)
            stop = (speed - final) / FRICTION
            slides = times < stop
            self.assertGreater(np.count_nonzero(slides), 5)
            np.testing.assert_allclose(states[slides, i, 3], speed - FRICTION * times[slides], rtol=0, atol=VELOCITY_ERROR)
            # The angular momentum about a point of contact does not change, whatever the steps.
            np.testing.assert_allclose(states[-1, i, 3:6], [final, 0.0, 0.0], rtol=0, atol=1e-9)
            spin = states[-1, i, 10:13] / Body(shapes[i]).inertia
            np.testing.assert_allclose(spin, [0.0, final / arm, 0.0], rtol=0, atol=1e-9)
            path = speed * stop - 0.5 * FRICTION * stop**2 + final * (time - stop)
            self.assertAlmostEqual(states[-1, i, 0] - states[0, i, 0], path, delta=VELOCITY_ERROR * time)

    def test_equations_of_motion(self):
        """Tilted grains slide and turn in space, and roll in the end; a grain rolls over its long axis."""
        shapes = [[0.6, 0.5, 0.4], [0.8, 0.5, 0.5]]
        spins = [[0.2, -0.1, 0.8], [0.0, 0.9, 0.2]]
        grains = placed(shapes, [about(0.8, 0.6, 0.0, 0.8), about(0.3, 0, 0, 1)], [[0.3, 0.1], None], spins)
        time, samples = 1.0, 10
        found = trajectory(grains, time, samples)
        for i, least in enumerate((1, 0)):
            body = Body(shapes[i])
            expected, stops = body.integrate(found[0, i], np.linspace(0.0, time, samples + 1))
            self.assertGreaterEqual(stops, least)
            self.assertGreater(min(body.contact(y)[2] for y in expected), 0.0, "a grain leaves the floor")
            errors = np.abs(found[:, i] - expected[:, :13]).max(axis=0)
            print(f"grain {i}: {stops} times from sliding to rolling, largest errors {errors}")
            bounds = VELOCITY_ERROR * np.repeat([time, 1.0, time / min(shapes[i]), body.mass * max(shapes[i])], [3, 3, 4, 3])
            self.assertTrue((errors < bounds).all(), f"{errors} {bounds}")

    def test_rolling(self):
        """A grain rolls over its long axis without sliding and without a loss of energy, as far as the springs are stiff."""
        shape, speed, time = [0.8, 0.5, 0.5], 1.3, 2.0
        body = Body(shape)
        grains = placed([shape], [about(0.0, 0, 0, 1)], [None], [[0.0, speed, 0.0]])
        states = trajectory(grains, time, 40, friction=1.0)[:, 0]
        self.assertGreater(states[:, 2].max(), 0.79, "it does not reach its long axis")
        energies = np.array([body.energy(y) for y in states])
        contacts = [body.contact(y) for y in states]
        depth, slip = max(c[2] for c in contacts), max(np.abs(c[4]).max() for c in contacts)
        self.assertGreater(min(c[2] for c in contacts), 0.0, "the grain leaves the floor")
        print(f"rolling: energies differ by {np.ptp(energies)}, the contact moves by up to {slip}")
        # The tangential spring, whose energy is left out, has less than the force of the normal one. Its force oscillates with the
        # frequency ω, so that the ends of the spring move by less than ω times its greatest length.
        largest = STIFFNESS * depth
        self.assertLess(np.ptp(energies), 0.5 * largest**2 / SLIDING)
        self.assertLess(slip, largest * np.sqrt((1.0 / body.mass + max(shape)**2 / body.inertia[1]) / SLIDING))

    def test_rocking(self):
        """A grain that lies on its shortest axis rocks about both others, with the frequencies of a rigid body that rolls.

        Across one of the others, with the semi-axis a, the lowest point has the radius of curvature a²/c. So a tilt by θ raises the
        centre by (a²/c - c) θ²/2, and the inertia is that about the point of contact."""
        shape, angle, time, samples = np.array([1.0, 0.8, 0.3]), 2e-3, 2.0, 500
        grains = placed([shape, shape], [about(angle, 0, 1, 0), about(angle, 1, 0, 0)], [[0.0, 0.0]] * 2, np.zeros((2, 3)))
        states = trajectory(grains, time, samples)
        for i, (a, column) in enumerate(((shape[0], 8), (shape[1], 7))):
            c = shape[2]
            period = 2.0 * np.pi * np.sqrt((0.2 * (a**2 + c**2) + c**2) / (a**2 / c - c))
            tilts = states[:, i, column]
            before = np.flatnonzero(tilts[:-1] * tilts[1:] < 0.0)[:2]
            first, second = (time / samples) * (before + tilts[before] / (tilts[before] - tilts[before + 1]))
            print(f"period {2.0 * (second - first)}, of the rigid body {period}")
            # The springs yield by m/K, which is 3e-4 of c. The tilt changes the period by some (θ a/c)², 4e-5 of it.
            self.assertAlmostEqual(2.0 * (second - first), period, delta=1e-3 * period)


if __name__ == "__main__":
    unittest.main()
