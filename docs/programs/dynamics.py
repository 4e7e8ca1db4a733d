"""Two soft ellipsoids on a spring: forces and torques from the contact function, and how
well they conserve energy.

The pair potential is U(μ²) = ε μ⁻¹², so that forces are -U' ∂μ²/∂r and torques -U' ∂μ²/∂ω. A spring between the centres
brings the ellipsoids together again and again. Translation: velocity Verlet. Rotation: the splitting of the free rigid
rotor into rotations about its principal axes (A. Dullweber, B. Leimkuhler and R. McLachlan, J. Chem. Phys. 107, 5840,
1997). Both are symplectic and of second order: half the step, a quarter of the error in energy, and no drift.
"""

import numpy as np
import pypw85

EPSILON, SPRING = 1.0, 0.2
MASSES = np.array([1.0, 2.0])
SEMI_AXES = np.array([[1.5, 1.0, 0.6], [0.8, 0.8, 2.0]])


def moments_of_inertia():
    """(2, 3) of solid ellipsoids, in the body frames."""
    squares = SEMI_AXES**2
    return MASSES[:, np.newaxis] / 5 * (squares.sum(axis=1, keepdims=True) - squares)


def turn(angle, axis):
    """Matrix of the rotation by an angle about a coordinate axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = np.cos(angle)
    matrix[j, i] = np.sin(angle)
    matrix[i, j] = -matrix[j, i]
    return matrix


class Pair:
    """Positions, rotations (body to space), momenta, and angular momenta in the space frame."""

    def __init__(self):
        self.positions = np.array([[-1.5, 0.3, 0.0], [1.5, -0.3, 0.4]])
        self.rotations = np.array([np.eye(3), turn(0.7, 0)])
        self.momenta = np.array([[0.5, 0.1, 0.0], [-0.5, -0.1, 0.0]])
        self.angular_momenta = np.array([[0.0, 0.2, 0.1], [0.1, 0.0, -0.3]])
        self.inertia = moments_of_inertia()
        self.update_forces()

    # start of forces
    def update_forces(self):
        r12 = self.positions[1] - self.positions[0]
        q1, q2 = pypw85.ellipsoid(SEMI_AXES, self.rotations)
        mu2, lambda_ = pypw85.contact(r12, q1, q2)
        d_r12, _, _ = pypw85.contact_gradient(r12, q1, q2, lambda_)
        torques = pypw85.contact_torque(r12, q1, q2, lambda_)

        slope = -6 * EPSILON * mu2**-7  # dU/d(μ²)
        force2 = -slope * d_r12 - SPRING * r12
        self.forces = np.array([-force2, force2])
        self.torques = -slope * np.array(torques)
        self.potential = EPSILON * mu2**-6 + SPRING / 2 * (r12 @ r12)

    # end of forces

    def rotate_freely(self, time):
        """Turns both bodies about x, y, z, y, x of their own frames."""
        for k in range(2):
            for axis, part in ((0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)):
                rate = self.rotations[k, :, axis] @ self.angular_momenta[k] / self.inertia[k, axis]
                self.rotations[k] = self.rotations[k] @ turn(part * time * rate, axis)

    def step(self, time):
        self.momenta += time / 2 * self.forces
        self.angular_momenta += time / 2 * self.torques
        self.positions += time * self.momenta / MASSES[:, np.newaxis]
        self.rotate_freely(time)
        self.update_forces()
        self.momenta += time / 2 * self.forces
        self.angular_momenta += time / 2 * self.torques

    def energy(self):
        body = np.einsum("kji,kj->ki", self.rotations, self.angular_momenta)
        kinetic = np.sum(self.momenta**2 / MASSES[:, np.newaxis]) + np.sum(body**2 / self.inertia)
        return kinetic / 2 + self.potential

    def total_angular_momentum(self):
        return np.sum(self.angular_momenta + np.cross(self.positions, self.momenta), axis=0)


def run(time_step, duration=20.0):
    """Energies at all times, and the largest changes of the total momentum and angular momentum."""
    pair = Pair()
    momentum, angular_momentum = pair.momenta.sum(axis=0), pair.total_angular_momentum()
    energies, drift = [pair.energy()], 0.0
    for _ in range(round(duration / time_step)):
        pair.step(time_step)
        energies.append(pair.energy())
        changes = (pair.momenta.sum(axis=0) - momentum, pair.total_angular_momentum() - angular_momentum)
        drift = max(drift, np.max(np.abs(changes)))
    return np.array(energies), drift


def main():
    print("time step   largest |E - E0|/E0   ratio   momenta conserved to 1e-11")
    previous = None
    for time_step in (0.04, 0.02, 0.01, 0.005):
        energies, drift = run(time_step)
        error = np.max(np.abs(energies / energies[0] - 1))
        ratio = f"{previous / error:5.1f}" if previous else "     "
        print(f"{time_step:9.3f}   {error:19.1e}   {ratio}   {'yes' if drift < 1e-11 else 'no'}")
        previous = error


if __name__ == "__main__":
    main()
