# SPDX-License-Identifier: GPL-2.0-only
"""Spheres with friction, by velocity Verlet and the formulas of docs/lammps.md: the truth of tests, whatever release of LAMMPS runs."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Law:
    """hooke: F = K δ; hertz: F = K a δ with a = √(R δ). The damper is ETA m, or ETA m a for hertz; the spring of friction is KT, or
    KT a."""

    form: str
    stiffness: float
    damping: float
    spring: float = 0.0
    sliding: float = 0.0
    friction: float = 0.0

    def words(self):
        normal = f"{self.form} {self.stiffness} {self.damping}"
        damping = " damping mass_velocity" if self.form == "hooke" else ""
        if self.spring == 0.0:
            return normal + damping
        history = "linear_history" if self.form == "hooke" else "mindlin"
        return f"{normal}{damping} tangential {history} {self.spring} {self.sliding} {self.friction}"

    def lammps(self):
        """The arguments of LAMMPS's styles gran/hooke/history and gran/hertz/history."""
        return f"{self.form}/history {self.stiffness} {self.spring} {self.damping} {self.sliding * self.damping} {self.friction} 1"

    def react(self, contacts, springs, dt):
        """The forces on the first bodies of contacts, and the new springs."""
        n, depth, slip = contacts.normal, contacts.depth[:, None], contacts.velocity
        size = np.sqrt(contacts.radius[:, None] * depth) if self.form == "hertz" else 1.0
        damper = self.damping * contacts.mass[:, None] * size
        approach = dot(slip, n)
        pressure = self.stiffness * size * depth + damper * approach
        slip = slip - approach * n
        if self.spring == 0.0:
            return -pressure * n, springs
        if contacts.keeps_length:
            springs = turned(springs, n) + dt * slip
        else:
            springs = springs + dt * slip
            springs = springs - dot(springs, n) * n
        stiffness, drag = self.spring * size, self.sliding * damper * slip
        force = -stiffness * springs - drag
        length, limit = np.sqrt(dot(force, force)), self.friction * np.abs(pressure)
        slides, known = length > limit, dot(springs, springs) > 0.0
        limited = np.where(slides, limit / np.where(slides, length, 1.0) * force, force)
        springs = np.where(slides & known, -(limited + drag) / stiffness, springs)
        # The first contact that slides has no friction in the set-up of a run.
        return np.where(slides & ~known, 0.0, limited) - pressure * n, springs


def dot(a, b):
    return np.sum(a * b, axis=1, keepdims=True)


def turned(springs, normals):
    """Springs in the planes of the contacts, as long as before."""
    part = springs - dot(springs, normals) * normals
    lengths = np.sqrt(dot(part, part))
    return np.where(lengths > 0.0, np.sqrt(dot(springs, springs)) / np.where(lengths > 0.0, lengths, 1.0), 0.0) * part


@dataclass
class Contacts:
    """Unit normals out of the first bodies, depths, equivalent radii and masses, and the velocities of the first bodies relative to the
    second ones; the arms at which forces act, from the centres along the normal and against it."""

    normal: np.ndarray
    depth: np.ndarray
    radius: np.ndarray
    mass: np.ndarray
    velocity: np.ndarray
    arm1: np.ndarray
    arm2: np.ndarray
    keeps_length: bool


@dataclass
class Wall:
    """`faces(time)` gives functions of places, whose values are the depths of points behind the face, negative outside, and the unit
    normals into the wall. `velocity(time)` is a function of places, too. `curvature` is that of the wall: positive if it is convex."""

    law: Law
    faces: object
    velocity: object = None
    curvature: float = 0.0
    springs: dict = field(default_factory=dict)


class Motion:
    """The state of spheres of density 1 in a periodic box, or in the open."""

    def __init__(self, spheres, law, walls=(), arms="surface", dt=0.0005, periodic=(True, True, True)):
        self.x, self.v, self.w = (np.array(a, dtype=float) for a in (spheres.centers, spheres.velocities, spheres.spins))
        self.radii, self.masses = spheres.semi_axes[:, 0], spheres.masses
        self.edges = np.where(periodic, np.diag(spheres.cell), np.inf)
        self.law, self.walls, self.arms, self.dt, self.steps = law, walls, arms, dt, 0
        self.first, self.second = np.triu_indices(len(self.x), 1)
        self.springs = np.zeros((len(self.first), 3))
        for wall in walls:
            wall.springs.clear()
        self.set_up()

    def set_up(self):
        """At the start of a run forces are those of the velocities of whole steps. In a step they are those of its half."""
        self.forces, self.torques = self.react(0.0)

    def state(self):
        """Rows as those of the dumps in test_granular.py."""
        return np.column_stack([np.arange(1, len(self.x) + 1), self.x, self.v, self.forces, self.torques])

    def run(self, steps):
        for _ in range(steps):
            self.kick()
            self.x += self.dt * self.v
            self.steps += 1
            self.forces, self.torques = self.react(self.dt)
            self.kick()
        return self

    def kick(self):
        self.v += 0.5 * self.dt * self.forces / self.masses[:, None]
        self.w += 0.5 * self.dt * self.torques / (0.4 * self.masses * self.radii**2)[:, None]

    def react(self, dt):
        forces, torques = np.zeros_like(self.x), np.zeros_like(self.x)
        self.touch_pairs(dt, forces, torques)
        for wall in self.walls:
            for k, (depth, normal) in enumerate(wall.faces(self.steps * self.dt)(self.x)):
                self.touch_wall(wall, k, depth + self.radii, normal, dt, forces, torques)
        return forces, torques

    def arm_factors(self):
        """The parts of the depth by which the arms of velocities and of torques are shorter than the radii."""
        return {"surface": (0.0, 0.0), "contact": (0.5, 0.5), "granular": (0.0, 0.5)}[self.arms]

    def touch_pairs(self, dt, forces, torques):
        i, j = self.first, self.second
        r = self.x[j] - self.x[i]
        with np.errstate(invalid="ignore"):
            r = r - np.where(np.isfinite(self.edges), self.edges * np.round(r / self.edges), 0.0)
        length = np.sqrt(dot(r, r))[:, 0]
        depth = self.radii[i] + self.radii[j] - length
        near = depth > 0.0
        self.springs[~near] = 0.0
        i, j, n, d = i[near], j[near], (r / length[:, None])[near], depth[near]
        motion, force = self.arm_factors()
        slip = self.v[i] - self.v[j] + np.cross((self.radii[i] - motion * d)[:, None] * self.w[i]
                                                + (self.radii[j] - motion * d)[:, None] * self.w[j], n)
        a, b, m, o = self.radii[i], self.radii[j], self.masses[i], self.masses[j]
        contacts = Contacts(n, d, a * b / (a + b), m * o / (m + o), slip, a - force * d, b - force * d, self.arms == "granular")
        push, self.springs[near] = self.law.react(contacts, self.springs[near], dt)
        np.add.at(forces, i, push)
        np.add.at(forces, j, -push)
        np.add.at(torques, i, np.cross(contacts.arm1[:, None] * n, push))
        np.add.at(torques, j, np.cross(contacts.arm2[:, None] * n, push))

    def touch_wall(self, wall, k, depth, normal, dt, forces, torques):
        springs = wall.springs.setdefault(k, np.zeros_like(self.x))
        near = depth > 0.0
        springs[~near] = 0.0
        n, d, radii = normal[near], depth[near], self.radii[near]
        # Walls take the torque at the surface of the sphere with `granular`, too.
        motion, force = (0.0, 0.0) if self.arms == "granular" else self.arm_factors()
        place = self.x[near] + (radii - d + motion * d)[:, None] * n
        slip = self.v[near] + np.cross(self.w[near], (radii - motion * d)[:, None] * n)
        if wall.velocity:
            slip = slip - wall.velocity(self.steps * self.dt)(place)
        contacts = Contacts(n, d, 1.0 / (1.0 / radii + wall.curvature), self.masses[near], slip, radii - force * d, None,
                            self.arms == "granular")
        push, springs[near] = wall.law.react(contacts, springs[near], dt)
        forces[near] += push
        torques[near] += np.cross(contacts.arm1[:, None] * n, push)


def fixed(faces):
    return lambda time: faces


def planes(*places):
    """Planes (axis, side, place), with side -1 for one below the spheres and 1 for one above them."""
    def faces(x):
        for axis, side, place in places:
            normal = np.zeros_like(x)
            normal[:, axis] = side
            yield side * (x[:, axis] - place), normal
    return fixed(faces)


def cylinder(axis, radius, at, side=1.0):
    """The inside of a cylinder, or for side -1 the outside. `at`: the coordinates of its axis, in the order of the others."""
    across = [k for k in range(3) if k != axis]
    def faces(x):
        r = np.zeros_like(x)
        r[:, across] = x[:, across] - np.asarray(at)
        length = np.sqrt(dot(r, r))
        yield side * (length[:, 0] - radius), side * r / length
    return fixed(faces)


def solid_box(lower, upper):
    """The surface of a box, outside of which the spheres are."""
    def faces(x):
        r = np.clip(x, lower, upper) - x
        length = np.sqrt(dot(r, r))
        yield -length[:, 0], r / np.where(length > 0.0, length, 1.0)
    return fixed(faces)


def moved(faces, shift):
    """Faces that are shifted by a function of time."""
    return lambda time: lambda x: faces(time)(x - shift(time))


def rotated(faces, pivot, axis, period):
    """Faces that turn about an axis, and their velocity."""
    axis, pivot, rate = np.asarray(axis) / np.linalg.norm(axis), np.asarray(pivot), 2.0 * np.pi / period

    def turn(x, angle):
        along = (x @ axis)[:, None] * axis
        return along + np.cos(angle) * (x - along) + np.sin(angle) * np.cross(axis, x)

    def faces_at(time):
        def in_space(x):
            for depth, normal in faces(time)(pivot + turn(x - pivot, -rate * time)):
                yield depth, turn(normal, rate * time)
        return in_space
    return faces_at, lambda time: lambda x: rate * np.cross(axis, x - pivot)
