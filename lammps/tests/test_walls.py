# SPDX-License-Identifier: GPL-2.0-only
"""Walls of all shapes: spheres against the formulas of their law and LAMMPS's own walls, ellipsoids against brute force, meshes against
planes and cylinders."""

import ctypes
import dataclasses
import os
import struct
import tempfile
import unittest
from pathlib import Path

import numpy as np
import spheres
from lammps_runs import failure, has_friction_of_walls, preamble
from scipy.optimize import brentq
from test_granular import HOOKE, HOOKE_LAW, SHAPES, AgainstLammps, Grains, Spheres, energies, granular, lattice, move, rotation

WALL_LAW = spheres.Law("hooke", 20000, 30, 8000, 0.5, 0.3)
LAW = WALL_LAW.words()
MIDDLE = np.array([6.0, 6.0, 6.0])  # of the box of 12³ in which all tests take place


def wall(shape, law=LAW):
    return f"\nfix wall all wall/pw85 {shape} arms surface law {law}"


def in_large_box(grains, keep=slice(None)):
    """Some of the grains, in the middle of a box whose sides are far away."""
    shifted = grains.centers + (MIDDLE - 0.5 * np.diag(grains.cell))
    rows = {name: getattr(grains, name)[keep] for name in ("semi_axes", "quaternions", "types", "velocities", "spins")}
    return dataclasses.replace(grains, cell=np.diag(2.0 * MIDDLE), periodic=False, centers=shifted[keep], **rows)


class AgainstRegions(unittest.TestCase):
    """Spheres and walls by the formulas of the law, to rounding; beside them LAMMPS's own fix wall/gran/region, where its release has
    this law."""

    forces, trajectory = AgainstLammps.forces, AgainstLammps.trajectory
    compare = AgainstLammps.compare

    def spheres(self):
        grains = lattice(Spheres, 4, 1.0, [[0.5, 0.5, 0.5], [0.52, 0.52, 0.52]], 5)
        return in_large_box(dataclasses.replace(grains, velocities=9.0 * grains.velocities))

    def check_region(self, region, ours, *others, **more):
        self.check_wall(f"{region}\nfix wall all wall/gran/region {WALL_LAW.lammps()} region wall", ours, *others, **more)

    def check_wall(self, theirs, ours, faces, velocity=None, keep=slice(None), first=True, ranks=(1,)):
        """`first`: whether spheres touch the wall at the start. LAMMPS's regions have no velocity then, even if they move."""
        grains = in_large_box(self.spheres(), keep)
        alone, touching = (spheres.Motion(grains, HOOKE_LAW, walls, periodic=(False, False, False))
                           for walls in ((), (spheres.Wall(WALL_LAW, faces, velocity),)))
        self.assertEqual(first, np.abs(touching.forces - alone.forces).max() > 0.0)
        start, end = touching.state(), touching.run(200).state()
        touched = np.count_nonzero(np.abs(end - alone.run(200).state()).max(axis=1) > 1e-6)
        self.assertGreater(touched, 5, f"hardly any sphere touches {ours}")
        if has_friction_of_walls():
            self.compare(move(grains, f"{HOOKE[0]}\n{theirs}", 200)[-1], end, self.trajectory, theirs)
        for count in ranks:
            found = move(Grains(**vars(grains)), HOOKE[1] + wall(ours), 200, count)
            self.compare(found[0], start, self.forces, ours)
            self.compare(found[-1], end, self.trajectory, ours)

    def test_cylinders(self):
        for k, axis in enumerate("xyz"):
            self.check_region(f"region wall cylinder {axis} 6.1 5.9 2.3 INF INF side in", f"{axis}cylinder 2.3 at 6.1 5.9",
                              spheres.cylinder(k, 2.3, (6.1, 5.9)), ranks=(2,) if axis == "z" else (1,))

    def test_outside_of_a_cylinder(self):
        keep = np.hypot(*(self.spheres().centers - MIDDLE)[:, :2].T) > 0.8
        self.check_region("region wall cylinder z 6.1 6.0 0.4 INF INF side out", "zcylinder 0.4 at 6.1 6.0 side out",
                          spheres.cylinder(2, 0.4, (6.1, 6.0), -1.0), keep=keep, first=False)

    def test_boxes(self):
        # Three fixes with planes: LAMMPS's region of a box moves a sphere that touches two faces in another way.
        places = (0, 4.1, 7.9), (1, 4.05, 8.1), (2, 3.9, 8.0)
        theirs = "".join(f"\nfix {k} all wall/gran {WALL_LAW.lammps()} {'xyz'[k]}plane {low} {high}" for k, low, high in places)
        faces = spheres.planes(*((k, side, place) for k, low, high in places for side, place in ((-1.0, low), (1.0, high))))
        self.check_wall(theirs, "box 4.1 7.9 4.05 8.1 3.9 8.0", faces, ranks=(2,))
        keep = np.abs(self.spheres().centers - MIDDLE).max(axis=1) > 0.8
        self.check_region("region wall block 5.0 6.9 5.1 7.0 5.0 7.1 side out", "box 5.0 6.9 5.1 7.0 5.0 7.1 side out",
                          spheres.solid_box((5.0, 5.1, 5.0), (6.9, 7.0, 7.1)), keep=keep)

    def test_motions(self):
        turn = "variable turn equal 2*PI*step*dt/0.7\nregion wall {} rotate v_turn 6.1 5.9 6 {}"
        pivot = (6.1, 5.9, 6.0)
        self.check_region(turn.format("cylinder z 6.1 5.9 2.9 INF INF side in", "0 0 1"),
                          "zcylinder 2.9 at 6.1 5.9 rotate 6.1 5.9 6 0 0 1 0.7",
                          *spheres.rotated(spheres.cylinder(2, 2.9, (6.1, 5.9)), pivot, (0, 0, 1), 0.7), first=False)
        # The length of the axis is 1, because LAMMPS's regions take the velocity of a point to be proportional to it. No sphere reaches
        # two faces: see test_boxes().
        self.check_region(turn.format("block 3.5 8.5 -20 20 -20 20 side in", "0.48 0.6 0.64"),
                          "box 3.5 8.5 -20 20 -20 20 rotate 6.1 5.9 6 0.48 0.6 0.64 0.7",
                          *spheres.rotated(spheres.planes((0, -1.0, 3.5), (0, 1.0, 8.5)), pivot, (0.48, 0.6, 0.64), 0.7), first=False)


def forces_of(grains, fix, ranks=1):
    """Forces and torques of a wall alone: no pair of grains has a force."""
    rows = move(grains, f"pair_style zero 4.0\npair_coeff * *\n{fix}", 1, ranks)[0]
    return rows[:, 7:10], rows[:, 10:13]


def random_grains(count, semi_axes, seed):
    """Grains at random places near the z axis through the middle, with random orientations."""
    random = np.random.default_rng(seed)
    quaternions = random.normal(size=(count, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    centers = MIDDLE + random.uniform(-1.0, 1.0, (count, 3))
    return Grains(np.diag(2.0 * MIDDLE), False, centers, np.asarray(semi_axes)[np.arange(count) % len(semi_axes)], quaternions,
                  np.ones(count, dtype=int), *np.zeros((2, count, 3)))


def forms(grains):
    axes = np.array([rotation(q) for q in grains.quaternions])
    return np.einsum("nij,nj,nkj->nik", axes, np.square(grains.semi_axes), axes)


def maxima(f, derivative):
    """Angles of the local maxima of a smooth function, from the changes of sign of its derivative."""
    angles = np.linspace(0.0, 2.0 * np.pi, 721)
    slopes = derivative(angles)
    for k in np.flatnonzero((slopes[:-1] > 0.0) & (slopes[1:] <= 0.0)):
        angle = brentq(derivative, angles[k], angles[k + 1], xtol=1e-15)
        yield angle, f(angle)


class Cylinders(unittest.TestCase):
    """Each local maximum of the depth over all normals across the axis is a contact."""

    RADIUS = 1.6
    STIFFNESS = 1000.0

    def expected(self, center, q):
        """Force and torque of the springs at the middles of the overlaps, and the number of contacts."""
        force, torque, count = np.zeros(3), np.zeros(3), 0
        normal = lambda t: np.array([np.cos(t), np.sin(t), np.zeros_like(t)])  # noqa: E731
        tangent = lambda t: np.array([-np.sin(t), np.cos(t), np.zeros_like(t)])  # noqa: E731
        height = lambda n: np.sqrt(np.einsum("i...,ij,j...->...", n, q, n))  # noqa: E731
        depth = lambda t: center @ normal(t) + height(normal(t)) - self.RADIUS  # noqa: E731
        slope = lambda t: (center @ tangent(t) + np.einsum("i...,ij,j...->...", tangent(t), q, normal(t))  # noqa: E731
                           / height(normal(t)))
        for angle, delta in maxima(depth, slope):
            if delta <= 0.0:
                continue
            n = normal(angle)
            push = -self.STIFFNESS * delta * n
            force, torque, count = force + push, torque + np.cross(q @ n / height(n) - 0.5 * delta * n, push), count + 1
        return force, torque, count

    def place(self, grains, depth):
        """Moves grains away from the axis until they are so deep in the wall."""
        for i, q in enumerate(forms(grains)):
            across = (grains.centers[i] - MIDDLE) * [1, 1, 0]
            across /= np.linalg.norm(across)
            t = np.linspace(0.0, 2.0 * np.pi, 2001)
            n = np.array([np.cos(t), np.sin(t), 0.0 * t])
            rooms = self.RADIUS + depth - np.sqrt(np.einsum("it,ij,jt->t", n, q, n))
            with np.errstate(divide="ignore"):
                far = np.where(across @ n > 0.0, rooms / (across @ n), np.inf)
            grains.centers[i] = MIDDLE + far.min() * across + [0.0, 0.0, grains.centers[i, 2] - 6.0]
        return grains

    def test_inside(self):
        """Long and flat grains touch the wall with one end or with both."""
        grains = random_grains(300, [[0.3, 0.3, 0.9], [1.2, 1.0, 0.2], [0.5, 0.4, 0.3], [1.4, 0.14, 0.14]], 1)
        for i in range(3, 300, 4):  # long grains that lie across the axis, nearly at right angles to the way to the wall
            x, y, tilt = *(grains.centers[i, :2] - MIDDLE[:2]), 0.05 * grains.quaternions[i, 2]
            half = 0.5 * (np.arctan2(y, x) + 0.5 * np.pi + tilt)
            grains.quaternions[i] = [np.cos(half), 0.0, 0.0, np.sin(half)]
        self.place(grains, 0.02)
        fix = f"fix wall all wall/pw85 zcylinder {self.RADIUS} at 6 6 law hooke {self.STIFFNESS} 0"
        forces, torques = forces_of(grains, fix, 2)
        counts = []
        for center, q, force, torque in zip(grains.centers, forms(grains), forces, torques, strict=True):
            expected = self.expected(center - MIDDLE, q)
            # Depths have errors of some u 12, the largest coordinate.
            context = f"{[x.hex() for x in center]} {[x.hex() for x in q.ravel()]}"
            np.testing.assert_allclose(force, expected[0], rtol=0, atol=1e-12 * self.STIFFNESS, err_msg=context)
            np.testing.assert_allclose(torque, expected[1], rtol=0, atol=2e-12 * self.STIFFNESS, err_msg=context)
            counts.append(expected[2])
        self.assertGreater(counts.count(1), 50)
        self.assertGreater(counts.count(2), 20)

    def test_second_end_on_the_axis(self):
        """A grain whose centre is on the axis, or beside it along a semi-axis, touches the wall with both ends alike."""
        grains = random_grains(2, [[1.61, 0.3, 0.3]], 2)
        grains = dataclasses.replace(grains, quaternions=np.tile([1.0, 0, 0, 0], (2, 1)), centers=MIDDLE + [[0, 0, 0], [0, 0.01, 0]])
        forces, torques = forces_of(grains, f"fix wall all wall/pw85 zcylinder {self.RADIUS} at 6 6 law hooke 1000 0")
        np.testing.assert_allclose(forces[0], 0.0, atol=1e-11)
        force, torque, count = self.expected(np.array([0.0, 0.01, 0.0]), np.diag([1.61**2, 0.09, 0.09]))
        self.assertEqual(count, 2)
        np.testing.assert_allclose([forces[1], torques[1]], [force, torque], rtol=0, atol=1e-9)

    def test_curvature(self):
        """A sphere of radius r in a cylinder of radius R has the curvatures 1/r and 1/r - 1/R; around it, 1/r + 1/R."""
        hertz = ctypes.CDLL(os.environ["PW85_LIBRARY"]).pw85_hertz
        radius, depth = 0.5, 0.01
        sphere = dataclasses.replace(random_grains(1, [[radius] * 3], 3), centers=MIDDLE[None, :] + [[1.1 + depth, 0.0, 0.0]])
        for shape, curvature in (("at 6 6", -1.0 / 1.6), ("at 9.2 6 side out", 1.0 / 1.6)):
            force = forces_of(sphere, f"fix wall all wall/pw85 zcylinder 1.6 {shape} law hertz 1000 0")[0][0]
            curvatures = (ctypes.c_double * 2)(*sorted([1.0 / radius, 1.0 / radius + curvature]))
            equivalent = ctypes.c_double()
            self.assertEqual(hertz(curvatures, ctypes.byref(equivalent), None), 0)
            expected = 1000.0 * np.sqrt(equivalent.value * depth) * depth
            np.testing.assert_allclose(force, [-expected, 0.0, 0.0], rtol=0, atol=1e-12 * expected / depth, err_msg=shape)


def facets(corners, triangles):
    return np.asarray(corners, dtype=float)[np.asarray(triangles)]


def divided_box(lower, upper, parts):
    """The surface of a box; each face is divided into parts² squares of two triangles."""
    lower, upper = np.asarray(lower, dtype=float), np.asarray(upper, dtype=float)
    faces = []
    for k in range(3):
        a, b = (k + 1) % 3, (k + 2) % 3
        for side in (lower, upper):
            for i in range(parts):
                for j in range(parts):
                    def corner(m, n):
                        x = side.copy()
                        x[a] = lower[a] + (upper[a] - lower[a]) * m / parts
                        x[b] = lower[b] + (upper[b] - lower[b]) * n / parts
                        return x
                    p, q, r, s = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
                    faces += [[p, q, r], [p, r, s]]
    return np.array(faces)


def tube(radius, half, parts):
    """An open cylinder around the z axis through the middle, of flat parts whose middles have this radius."""
    turns = 2.0 * np.pi * np.arange(parts) / parts
    ring = radius / np.cos(np.pi / parts) * np.array([np.cos(turns), np.sin(turns), 0.0 * turns]).T
    low, high = MIDDLE + ring - [0, 0, half], MIDDLE + ring + [0, 0, half]
    after = np.roll(np.arange(parts), -1)
    return np.concatenate([np.stack([low, low[after], high[after]], axis=1), np.stack([low, high[after], high], axis=1)])


def write_text(path, soup):
    facet = "facet normal 0 0 0\nouter loop\n{}\nendloop\nendfacet\n"
    rows = (facet.format("\n".join("vertex " + " ".join(f"{x:.17g}" for x in corner) for corner in t)) for t in soup)
    Path(path).write_text("solid wall\n" + "".join(rows) + "endsolid wall\n")


def write_binary(path, soup):
    records = b"".join(struct.pack("<12fH", *np.zeros(3), *np.ravel(t), 0) for t in soup)
    Path(path).write_bytes(b"solid".ljust(80) + struct.pack("<I", len(soup)) + records)


class Meshes(unittest.TestCase):
    compare = AgainstLammps.compare
    spheres = AgainstRegions.spheres

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.file = str(Path(directory.name, "wall.stl"))

    def trajectory(self, shape, ranks=1):
        grains = in_large_box(lattice(Grains, 3, 1.3, SHAPES, 11, speed=6.0))
        return move(grains, granular(LAW) + wall(shape), 400, ranks)

    def test_box(self):
        """Triangles do not show: ellipsoids move in a closed box of them as between planes."""
        lower, upper = (4.0, 4.0, 4.0), (8.0, 8.0, 8.0)
        planes = self.trajectory("box 4 8 4 8 4 8")
        for parts, ranks, write in ((1, 1, write_text), (4, 2, write_binary)):
            write(self.file, divided_box(np.divide(lower, 4.0), np.divide(upper, 4.0), parts))
            found = self.trajectory(f"mesh {self.file} scale 4", ranks)
            self.compare(found[0], planes[0], 1e-12, f"{parts} parts")
            self.compare(found[-1], planes[-1], 1e-9, f"{parts} parts")

    def test_restart(self):
        """Springs and the time of the motion are in restart files, whatever the number of contacts of a grain."""
        write_text(self.file, divided_box((4.0, 4.0, 4.0), (8.0, 8.0, 8.0), 2))
        grains = in_large_box(lattice(Grains, 3, 1.3, SHAPES, 11, speed=6.0))
        later = '\nif "$(step) == 0" then "reset_timestep 1000"'  # before the wall begins to move
        pair = granular(LAW) + later + wall(f"mesh {self.file} rotate 6 6 6 1 -2 0.5 0.9")
        expected, found = (move(grains, pair, 150, ranks, first_half=first_half)[-1]
                           for ranks, first_half in ((1, "pause"), (2, "end")))
        self.compare(found, expected, 1e-9, "restart")

    def test_turning_box(self):
        write_text(self.file, divided_box((3.0, 3.0, 3.0), (7.0, 7.0, 7.0), 2))
        turn = "rotate 6 6 6 1 -2 0.5 0.9"
        found, planes = self.trajectory(f"mesh {self.file} shift 1 1 1 {turn}"), self.trajectory(f"box 4 8 4 8 4 8 {turn}")
        self.compare(found[-1], planes[-1], 1e-9, turn)

    def test_solid_box(self):
        """Inside and outside are the same surface; the grains say on which side they are."""
        write_text(self.file, divided_box((5.0, 5.1, 5.0), (6.9, 7.0, 7.1), 3))
        keep = np.abs(self.spheres().centers - MIDDLE).max(axis=1) > 0.8
        grains = in_large_box(Grains(**vars(self.spheres())), keep)
        found, expected = (move(grains, granular(LAW) + wall(shape), 200) for shape in
                           (f"mesh {self.file}", "box 5.0 6.9 5.1 7.0 5.0 7.1 side out"))
        self.compare(found[-1], expected[-1], 1e-9, "solid box")

    def test_capitals(self):
        """Words of the format in capitals, or in any letters."""
        write_text(self.file, divided_box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), 1))
        text = Path(self.file).read_text()
        expected = self.trajectory(f"mesh {self.file} scale 4 shift 4 4 4")[-1]
        for written in (text.upper(), text.title()):
            Path(self.file).write_text(written)
            np.testing.assert_array_equal(self.trajectory(f"mesh {self.file} scale 4 shift 4 4 4")[-1], expected)

    def test_tube(self):
        """A cylinder of many flat parts is a cylinder, up to the square of their size."""
        cylinders = Cylinders()
        grains = cylinders.place(random_grains(60, [[0.3, 0.3, 0.9], [0.5, 0.4, 0.3]], 4), 0.05)
        law = "law hooke 1000 0"
        expected = forces_of(grains, f"fix wall all wall/pw85 zcylinder 1.6 at 6 6 {law}")[0]
        errors = []
        for parts in (60, 120):
            write_text(self.file, tube(1.6, 4.0, parts))
            found = forces_of(grains, f"fix wall all wall/pw85 mesh {self.file} open {law}")[0]
            # The normal jumps from part to part by 2π/parts, so that it errs by half of that. No contact counts twice.
            np.testing.assert_allclose(found, expected, rtol=0, atol=2.0 * np.pi / parts * np.abs(expected).max())
            errors.append(np.abs(found - expected).max())
        self.assertLess(errors[1], 0.7 * errors[0])

    def test_energy(self):
        """Ellipsoids that bounce in a box of triangles keep their energy, up to the square of the time step."""
        write_text(self.file, divided_box((0.0, 0.0, 0.0), (4.5, 4.5, 4.5), 3))
        box = dataclasses.replace(lattice(Grains, 3, 1.5, SHAPES, 9, speed=3.0), periodic=False)
        errors = []
        for timestep in (0.0006, 0.0003):
            total = energies(box, "hooke 3000 0", timestep, round(0.6 / timestep), 20, walls=[f"mesh {self.file}"])[:, 0]
            errors.append(np.abs(total - total[0]).max() / total[0])
        self.assertLess(errors[1], 1e-3)
        self.assertGreater(errors[0] / errors[1], 3.0, errors)


class Errors(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.file = str(Path(directory.name, "wall.stl"))

    def check(self, shape, *words, grains=None, settings=""):
        grains = grains or in_large_box(lattice(Grains, 2, 2.0, SHAPES[:2], 3))
        text = failure(preamble(grains) + f"{settings}\npair_style zero 4.0\npair_coeff * *\nneighbor 0.3 bin\n"
                       f"fix wall all wall/pw85 {shape}\nrun 1\n", grains)
        for word in words:
            self.assertIn(word, text)

    def test_words(self):
        law = "law hooke 1000 0"
        for words, message in ((f"zcone 1.0 {law}", "unknown shape zcone: use one of box, mesh, xcylinder"),
                               (f"zcylinder 0 {law}", "has a radius of zero"),
                               (f"xplane NULL NULL {law}", "has no plane: write one coordinate or two"),
                               (f"yplane 3 2 {law}", "has its planes in the wrong order: write the lower coordinate before the upper one"),
                               (f"zcylinder 1.0 side left {law}", "unknown side left: use one of in, out"),
                               (f"zcylinder 1.0 shear x 1.0 {law}", "shear that is not along the wall: use wiggle or rotate"),
                               (f"box 0 1 0 1 2 2 {law}", "has an empty box"),
                               (f"zplane 0 NULL rotate 0 0 0 0 0 0 1 {law}", "axis of rotation without direction"),
                               ("zplane 0 NULL hooke 1000 0", "lacks the word law"),
                               (f"mesh nowhere.stl {law}", "mesh that cannot be read: nowhere.stl")):
            self.check(words, "fix wall/pw85: the wall", message)

    def test_meshes(self):
        law = "law hooke 1000 0"
        soup = divided_box((4.0, 4.0, 4.0), (8.0, 8.0, 8.0), 1)
        write_text(self.file, soup[:-1])
        self.check(f"mesh {self.file} {law}", "a mesh that is not closed", "the edge from (", "add the word open")
        write_text(self.file, soup[:, :, [0, 0, 0]])
        self.check(f"mesh {self.file} {law}", "a mesh whose triangles are all lines or points")
        write_binary(self.file, soup)
        self.check(f"mesh {self.file} scale 1e308 {law}", "a mesh with a vertex that is not finite")
        soup[2, 1, 0] = np.nan
        write_binary(self.file, soup)
        self.check(f"mesh {self.file} open {law}", "has a bad vertex 8 in its mesh, which must be finite: export the file again")
        Path(self.file).write_text("solid\nvertex 1 2 three\n")
        self.check(f"mesh {self.file} {law}", "has a bad vertex 1 in its mesh")
        Path(self.file).write_text("ply\n")
        self.check(f"mesh {self.file} {law}", "has a mesh without triangles, or with an incomplete one", "as STL")

    def test_depth(self):
        """Grains whose centres are behind the surface, or nearly so."""
        one = random_grains(1, [[0.5, 0.4, 0.3]], 3)
        law = "law hooke 1000 0"
        write_text(self.file, divided_box(MIDDLE - 3.0, MIDDLE + 3.0, 1))
        for shape, x in (("zcylinder 1.0 at 6 6", 1.1), ("zcylinder 1.0 at 6 6 side out", 0.9), (f"mesh {self.file}", 2.95),
                         ("xplane 6.1 NULL", 0.0), ("xplane NULL 6.1", 0.1), ("xplane 6.1 9", 5.0), ("box 6.1 9 4 8 4 8", 0.0)):
            placed = dataclasses.replace(one, centers=MIDDLE[None, :] + [[x, 0.0, 0.0]])
            depth = "is so deep in the mesh of the wall" if "mesh" in shape else "is too deep in the wall"
            self.check(f"{shape} {law}", f"atom 1 (type 1) {depth}", "smaller time step", grains=placed)

    def test_shapes(self):
        wall = "zplane 0 NULL law hooke 1000 0"
        self.check(wall, "fix wall/pw85: atom 3 has no shape (type 2): set a shape", settings="set atom 3 shape 0 0 0")
        for shape in ("v_tiny 1 1", "v_bad 1 1"):
            self.check(wall, "fix wall/pw85: atom 3 has a bad shape or quaternion (type 2): correct it with the set command",
                       settings="variable bad atom exp(1000)-exp(1000)\nvariable tiny atom 2^(0-1074)\n"
                                f"set atom 3 shape {shape}")

    def test_periodic(self):
        grains = dataclasses.replace(in_large_box(lattice(Grains, 2, 2.0, SHAPES[:2], 3)), periodic=True)
        for shape in ("zcylinder 3.0 at 6 6", "box 1 11 1 11 1 11"):
            self.check(f"{shape} law hooke 1000 0", "the box is periodic across the wall", grains=grains)


if __name__ == "__main__":
    unittest.main()
