"""Ellipsoids fill a hopper, a mesh of triangles in an STL file: one after the other they fall and slide until they rest."""

from pathlib import Path

import numpy as np
import pypw85

SEMI_AXES = np.array([0.6, 0.4, 0.3])
TRIALS = 24  # at a time


def fill(mesh, count, seed=1):
    """Centres and forms of particles that come to rest in turn.

    No particle ever overlaps the mesh or another particle.
    """
    random = np.random.default_rng(seed)
    centers, q = np.empty((count, 3)), np.empty((count, 6))
    for n in range(count):
        center = np.append(random.uniform(-1.5, 1.5, 2), 11.0)
        quaternion = random.normal(size=4)
        # In steps below twice the shortest semi-axis no centre passes the mesh unseen.
        step = 0.9 * SEMI_AXES.min()
        while step > 1e-3:
            offset = step * random.uniform([-1, -1, -1], [1, 1, 0], (TRIALS, 3))
            trial = center + offset
            turned = quaternion + step * random.normal(size=(TRIALS, 4))
            form = pypw85.ellipsoid_quaternion(SEMI_AXES, turned)
            r12 = centers[:n] - trial[:, None]
            blocked = pypw85.overlap(r12, form[:, None], q[:n]).any(axis=1)
            blocked |= mesh.overlap(trial, form)
            if blocked.all():
                step /= 2
                continue
            best = np.where(blocked, np.inf, trial[:, 2]).argmin()
            center = trial[best]
            quaternion = turned[best] / np.linalg.norm(turned[best])
            centers[n], q[n] = center, form[best]
    return centers, q


if __name__ == "__main__":
    hopper = pypw85.Mesh.read(Path(__file__).with_name("hopper.stl"))
    centers, q = fill(hopper, 150)
    pairs = pypw85.neighbors(centers, q).pairs
    mu2, point, triangle = hopper.contact(centers, q)
    print(hopper)
    print(len(centers), "particles, the highest at", centers[:, 2].max().round(2))
    between = pypw85.overlap_pairs(pairs, centers, q).sum()
    with_mesh = hopper.overlap(centers, q).sum()
    print("overlaps:", between, "of particles,", with_mesh, "with the hopper")
    lean = mu2 < 1.05
    touched = len(np.unique(triangle[lean]))
    print(lean.sum(), "particles lean on the hopper, on", touched, "of its triangles")
