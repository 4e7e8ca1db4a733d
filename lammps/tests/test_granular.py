# SPDX-License-Identifier: GPL-2.0-only
"""Grains: spheres against LAMMPS's own styles, conservation laws, restart, and errors."""

import dataclasses
import itertools
import os
import unittest

import numpy as np
from lammps_runs import System, failure, numbers, preamble, run, thermo


@dataclasses.dataclass
class Grains(System):
    """Ellipsoids of density 1 that move."""

    velocities: np.ndarray
    spins: np.ndarray  # angular velocities

    @property
    def masses(self):
        return 4.0 / 3.0 * np.pi * self.semi_axes.prod(axis=1)

    def with_velocities(self, second):
        rows = (f"{i + 1} {numbers([*self.velocities[i], *second[i]])}" for i in range(len(self.centers)))
        return "\nVelocities\n\n" + "\n".join(rows) + "\n"

    def data_file(self):
        return super().data_file() + self.with_velocities(self.angular_momenta())

    def angular_momenta(self):
        inertia = self.masses[:, None] / 5.0 * (np.square(self.semi_axes).sum(axis=1)[:, None] - np.square(self.semi_axes))
        axes = np.array([rotation(q) for q in self.quaternions])
        return np.einsum("nij,nj,nkj,nk->ni", axes, inertia, axes, self.spins)


class Spheres(Grains):
    """The same bodies as atoms of style sphere."""

    def data_file(self):
        edges = [f"0 {edge:.17g} {axis}lo {axis}hi" for axis, edge in zip("xyz", np.diag(self.cell), strict=True)]
        head = ["spheres", "", f"{len(self.centers)} atoms", f"{self.types.max()} atom types", *edges, "", "Atoms # sphere", ""]
        rows = [f"{i + 1} {self.types[i]} " + numbers([2.0 * self.semi_axes[i, 0], 1.0, *self.centers[i]])
                for i in range(len(self.centers))]
        return "\n".join(head + rows) + "\n" + self.with_velocities(self.spins)


def rotation(quaternion):
    """Rotation matrix of a quaternion (w, i, j, k)."""
    w, v = quaternion[0], quaternion[1:]
    skew = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return (w * w - v @ v) * np.eye(3) + 2 * np.outer(v, v) + 2 * w * skew


def lattice(kind, edge, spacing, semi_axes, seed, speed=1.0, jitter=0.02):
    """Grains on a cubic lattice, somewhat displaced, with random orientations and velocities. `semi_axes`: a row for each type."""
    random = np.random.default_rng(seed)
    count = edge**3
    places = np.array(list(itertools.product(range(edge), repeat=3)), dtype=float) + 0.5
    types = 1 + (places.sum(axis=1) - 1.5).astype(int) % len(semi_axes)
    quaternions = random.normal(size=(count, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    centers = spacing * (places + random.uniform(-jitter, jitter, (count, 3)))
    velocities, spins = speed * random.normal(size=(2, count, 3))
    return kind(np.diag(np.full(3, edge * spacing)), True, centers, np.asarray(semi_axes, dtype=float)[types - 1],
                quaternions, types, velocities, spins)


STATE = "id x y z vx vy vz fx fy fz tqx tqy tqz"

MOVE = """
comm_modify vel yes
neighbor 0.1 bin
neigh_modify delay 0
{pair}
fix move all nve/{integrator}
timestep {timestep}
thermo 10
thermo_style custom step pe ke press
thermo_modify norm no format float %.17g
dump state all custom {steps} state.txt {state}
dump_modify state sort id format float %.17g
run {steps}
"""


def move(grains, pair, steps, ranks=1, newton="on", timestep=0.0005):
    """The state of all grains before and after a run."""
    start = preamble(grains, newton)
    if isinstance(grains, Spheres):
        start = start.replace("atom_style ellipsoid", "atom_style sphere")
    script = start + MOVE.format(pair=pair, integrator="sphere" if isinstance(grains, Spheres) else "asphere",
                                 timestep=timestep, steps=steps, state=STATE)
    return run(script, grains, ranks, ("state.txt",))[1][0]


SIZES = [[0.5, 0.5, 0.5], [0.52, 0.52, 0.52]]


class SpheresAsLammps(unittest.TestCase):
    """Each style of LAMMPS, and the same law here."""

    LAWS = {
        "gran/hooke/history 10000 4000 20 10 0.4 1\npair_coeff * *":
            "arms surface\npair_coeff * * hooke 10000 20 damping mass_velocity tangential linear_history 4000 0.5 0.4",
        "gran/hertz/history 100000 80000 200 100 0.5 1\npair_coeff * *":
            "arms surface\npair_coeff * * hertz 100000 200 tangential mindlin 80000 0.5 0.5",
    }

    # A depth has an error of some u = 1e-16 times the distance of the centres, 1. The stiffest force grows by less than 2e4 for each unit
    # of depth and is some 200, so that it errs by some 1e-14. It grows along the trajectory.
    forces, trajectory = 1e-12, 1e-9

    def check(self, theirs, ours, ranks, newton="on"):
        spheres = lattice(Spheres, 4, 1.0, SIZES, 5)
        grains = Grains(**vars(spheres))
        expected = move(spheres, f"pair_style {theirs}", 200)
        found = move(grains, f"pair_style pw85/granular {ours}", 200, ranks, newton)
        self.assertGreater(np.count_nonzero(np.abs(expected[0][:, 7:10]).max(axis=1)), 40, "hardly any contacts")
        for k, tolerance in ((0, self.forces), (-1, self.trajectory)):
            for columns in (slice(1, 4), slice(4, 7), slice(7, 10), slice(10, 13)):
                scale = np.abs(expected[k][:, columns]).max()
                np.testing.assert_allclose(found[k][:, columns], expected[k][:, columns], rtol=0, atol=tolerance * scale,
                                           err_msg=f"{theirs} {ranks} {newton} {k} {columns}")

    def test_gran(self):
        for theirs, ours in self.LAWS.items():
            for ranks, newton in ((1, "on"), (2, "on"), (2, "off")):
                with self.subTest(theirs=theirs, ranks=ranks, newton=newton):
                    self.check(theirs, ours, ranks, newton)


if __name__ == "__main__":
    unittest.main()
