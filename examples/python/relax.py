"""Random ellipsoids in a periodic box, moved and turned until none overlap: SciPy's L-BFGS on a soft repulsion.

Usage: relax.py [number [packing fraction [seed]]]
"""

import sys

import numpy as np
from scipy.optimize import minimize

import pypw85


def quaternion_product(p, q):
    (a, b, c, d), (w, x, y, z) = p.T, q.T
    return np.stack([a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
                     a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w], axis=1)


class Packing:
    """The energy Σ ½(1-μ)² over the pairs that overlap, as a function of displacements and rotation vectors."""

    def __init__(self, semi_axes, edge, centers, quaternions):
        self.semi_axes, self.cell, self.centers, self.quaternions = semi_axes, edge * np.eye(3), centers, quaternions
        self.skin = 0.3 * semi_axes.min()
        self.neighbors = None

    def place(self, x):
        """Centres and orientations for an argument of the energy."""
        moves, omega = x.reshape(2, -1, 3)
        angle = np.linalg.norm(omega, axis=1, keepdims=True)
        turn = np.hstack([np.cos(angle / 2), 0.5 * np.sinc(angle / (2 * np.pi)) * omega])
        return self.centers + moves, quaternion_product(turn, self.quaternions)

    def energy(self, x):
        """The energy and its gradient."""
        centers, quaternions = self.place(x)
        q = pypw85.ellipsoid_quaternion(self.semi_axes, quaternions)
        if self.neighbors is None or not self.neighbors.holds(centers, q, self.cell):
            self.neighbors = pypw85.neighbors(centers, q, self.cell, skin=self.skin)
        pairs, images = self.neighbors.pairs, self.neighbors.images
        near = pypw85.overlap_pairs(pairs, centers, q, self.cell, images=images)
        pairs, images = pairs[near], images[near]
        d = pypw85.contact_derivatives_pairs(pairs, centers, q, self.cell, images=images)
        mu = np.sqrt(d.mu2)
        slope = ((mu - 1) / (2 * np.maximum(mu, 1e-12)))[:, None]  # dU/dμ²
        force, torque = np.zeros_like(centers), np.zeros_like(centers)
        for sums, k, rows in ((force, 0, -d.d_r12), (force, 1, d.d_r12), (torque, 0, d.d_rot1), (torque, 1, d.d_rot2)):
            for axis in range(3):
                sums[:, axis] += np.bincount(pairs[:, k], (slope * rows)[:, axis], len(centers))
        gradient = np.concatenate([force, self.along_rotation_vectors(x.reshape(2, -1, 3)[1], torque)])
        return 0.5 * np.sum((1 - mu) ** 2), gradient.ravel()

    @staticmethod
    def along_rotation_vectors(omega, torque):
        """Derivatives by rotation vectors from those by small rotations: exp(ω + dω) is exp(J dω) exp(ω), and this is Jᵀ."""
        angle = np.linalg.norm(omega, axis=1, keepdims=True)
        a = 0.5 * np.sinc(angle / (2 * np.pi)) ** 2  # (1 - cos)/angle²
        safe = np.maximum(angle, 1e-3)
        b = np.where(angle < 1e-3, 1 / 6, (safe - np.sin(safe)) / safe**3)
        once = np.cross(omega, torque)
        return torque - a * once + b * np.cross(omega, once)

    def relax(self, steps):
        """Minimises, and takes the result as the new origin of displacements and rotations."""
        found = minimize(self.energy, np.zeros(6 * len(self.centers)), jac=True, method="L-BFGS-B",
                         options={"maxiter": steps, "maxfun": 2 * steps, "ftol": 0, "gtol": 1e-12})
        self.centers, self.quaternions = self.place(found.x)
        return found.fun

    def overlaps(self):
        """The number of pairs that overlap, and the least μ."""
        q = pypw85.ellipsoid_quaternion(self.semi_axes, self.quaternions)
        near = pypw85.neighbors(self.centers, q, self.cell)
        if len(near) == 0:
            return 0, np.inf
        mu2, _ = pypw85.contact_pairs(near.pairs, self.centers, q, self.cell, images=near.images)
        return int((mu2 < 1).sum()), float(np.sqrt(mu2.min()))


def random_packing(count, fraction, rng):
    """Semi-axes from 1 to 2, centres and orientations at random."""
    semi_axes = rng.uniform(1, 2, (count, 3))
    volume = pypw85.volume(pypw85.ellipsoid_quaternion(semi_axes, [1, 0, 0, 0])).sum()
    edge = (volume / fraction) ** (1 / 3)
    return Packing(semi_axes, edge, rng.uniform(0, edge, (count, 3)), rng.normal(size=(count, 4)))


def main(count=10_000, fraction=0.6, seed=1):
    packing = random_packing(int(count), float(fraction), np.random.default_rng(int(seed)))
    # Minima of the soft energy touch: a little room, and ellipsoids of full size do not.
    actual, packing.semi_axes = packing.semi_axes, 1.001 * packing.semi_axes
    overlapping, least = packing.overlaps()
    print(f"overlaps, least μ: {overlapping}, {least:.3f}")
    for _ in range(20):
        energy = packing.relax(100)
        print(f"energy {energy:.1e}", file=sys.stderr)
        overlapping, least = packing.overlaps()
        if least >= 1 / 1.001:
            break
    packing.semi_axes = actual
    print(f"overlaps when relaxed: {packing.overlaps()[0]}")


if __name__ == "__main__":
    main(*sys.argv[1:])
