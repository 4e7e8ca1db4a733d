# SPDX-License-Identifier: GPL-2.0-only
"""Grains: spheres against LAMMPS's own styles, conservation laws, restart, and errors."""

import dataclasses
import itertools
import os
import unittest
import unittest.mock

import numpy as np
import spheres
from lammps_runs import System, failure, has_friction_of_walls, numbers, preamble, release, run, thermo


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


SETTINGS = """
comm_modify vel yes
neighbor 0.1 bin
neigh_modify delay 0
{pair}
fix move all nve/{integrator}
timestep 0.0005
"""

RUN = """
dump state all custom {steps} state.txt id x y z vx vy vz fx fy fz tqx tqy tqz
dump_modify state sort id format float %.17g
run {steps}
"""

# What comes before a run: the first half of the steps, and for two of them a restart, from a file that is written at the end of that
# half, or in the middle of a longer run.
FIRST_HALVES = {"": "", "pause": "run {steps}\n", "end": "run {steps}\nwrite_restart half.restart\n",
                "middle": "restart {steps} half.restart.*\nrun $(2*{steps}-1)\n"}
RESTART_FILES = {"end": "half.restart", "middle": "half.restart.{steps}"}


def script(grains, pair, steps, newton, first_half=""):
    style, integrator = ("sphere",) * 2 if isinstance(grains, Spheres) else ("ellipsoid", "asphere")
    start = preamble(grains, newton).replace("atom_style ellipsoid", f"atom_style {style}")
    if "zplane" in pair:
        start = start.replace("boundary p p p", "boundary p p f")
    settings = SETTINGS.format(pair=pair, integrator=integrator)
    commands = start + settings + FIRST_HALVES[first_half].format(steps=steps)
    if first_half in RESTART_FILES:
        # With newton off, a contact is looked up by the other atom, too.
        newton = "off" if first_half == "middle" else newton
        commands += (f"clear\nnewton {newton}\ninclude {os.environ['PW85_LAMMPS_INCLUDE']}\n"
                     f"read_restart {RESTART_FILES[first_half].format(steps=steps)}\n" + settings)
    return commands + RUN.format(steps=steps)


def move(grains, pair, steps, ranks=1, newton="on", first_half=""):
    """The state of all grains before and after a run."""
    return run(script(grains, pair, steps, newton, first_half), grains, ranks, ("state.txt",))[1][0]


def granular(law, style="", types="* *"):
    return f"pair_style pw85/granular {style}\npair_coeff {types} {law}"


class AgainstLammps:
    """Spheres, by the formulas of the law (spheres.py), by a style of LAMMPS, and by the same law here."""

    # A depth has an error of some u = 1e-16 times the distance of the centres, 1. The stiffest force grows by less than 2e4 for each unit
    # of depth and is some 200, so that it errs by some 1e-14. The errors grow along the trajectory.
    forces, trajectory = 1e-12, 1e-9

    def spheres(self, still=False):
        """Spheres of two sizes that collide, and fly through the box together, so that they change their processor."""
        spheres = lattice(Spheres, 4, 1.0, [[0.5, 0.5, 0.5], [0.52, 0.52, 0.52]], 5)
        spins = 0.0 * spheres.spins if still else spheres.spins
        return dataclasses.replace(spheres, velocities=spheres.velocities + [20.0, 13.0, -7.0], spins=spins)

    def compare(self, found, expected, tolerance, name):
        cell = np.diag(self.spheres().cell)
        found, expected = found.copy(), expected.copy()
        found[:, 1:4] -= cell * np.round((found[:, 1:4] - expected[:, 1:4]) / cell)
        for columns in (slice(1, 4), slice(4, 7), slice(7, 10), slice(10, 13)):
            scale = np.abs(expected[:, columns]).max()
            np.testing.assert_allclose(found[:, columns], expected[:, columns], rtol=0, atol=tolerance * scale, err_msg=name)

    def check(self, laws, *runs, first_half="", spheres=None, motion=None):
        """Compares with LAMMPS's style, or with a motion by the formulas; if it is given, LAMMPS's style is compared with it, too."""
        spheres = spheres or self.spheres()
        start = self.trajectory if first_half else self.forces
        expected = None
        if motion:
            if first_half:
                motion.run(200).set_up()
            expected = [motion.state(), motion.run(200).state()]
        if laws[0]:
            theirs = move(spheres, laws[0], 200, first_half="pause" if first_half else "")
            expected = expected or theirs
            self.compare(theirs[0], expected[0], start, laws[0])
            self.compare(theirs[-1], expected[-1], self.trajectory, laws[0])
        self.assertGreater(np.count_nonzero(np.abs(expected[-1][:, 7:10]).max(axis=1)), 40, "hardly any contacts")
        for ranks, newton in runs:
            found = move(Grains(**vars(spheres)), laws[1], 200, ranks, newton, first_half)
            name = f"{laws[1]} {ranks} {newton} {first_half}"
            self.compare(found[0], expected[0], start, name)
            self.compare(found[-1], expected[-1], self.trajectory, name)

    def check_motion(self, case, *runs, first_half=""):
        """A law and walls, with LAMMPS beside them where its release has them."""
        law, walls, words, lammps = case
        ours = granular(law.words(), "arms surface") + words
        theirs = f"pair_style gran/{law.lammps()}\npair_coeff * *{lammps}"
        has_law = not lammps or has_friction_of_walls()
        motion = spheres.Motion(self.spheres(), law, walls, periodic=(True, True, not walls))
        self.check((theirs if has_law else None, ours), *runs, first_half=first_half, motion=motion)

    def test_hooke(self):
        self.check_motion(self.HOOKE, (1, "on"), (2, "off"))

    def test_hertz(self):
        self.check_motion(self.HERTZ, (1, "on"), (4, "on"))

    def test_restart(self):
        """After a restart, spheres move as if nothing had happened."""
        self.check_motion(self.HOOKE, (2, "on"), first_half="end")
        self.check_motion(self.HERTZ, (2, "on"), first_half="middle")


HOOKE_LAW = spheres.Law("hooke", 10000, 20, 4000, 0.5, 0.4)
HERTZ_LAW = spheres.Law("hertz", 100000, 200, 80000, 0.5, 0.5)

# LAMMPS's own law, and the same one here.
HOOKE = (f"pair_style gran/{HOOKE_LAW.lammps()}\npair_coeff * *", granular(HOOKE_LAW.words(), "arms surface"))


class Pairs(AgainstLammps, unittest.TestCase):
    HOOKE = HOOKE_LAW, (), "", ""
    HERTZ = HERTZ_LAW, (), "", ""

    def test_frozen(self):
        """A sphere in the group of fix freeze is as heavy as an infinite mass, which damping depends on."""
        self.check([law + "\ngroup ice id 1:64:3\nfix ice ice freeze" for law in HOOKE], (2, "on"))

    def test_materials(self):
        """Forces without spin and without springs do not depend on the arms, which pair_style granular mixes."""
        spheres = self.spheres(still=True)
        for law in ("hertz/material 200000 0.7 0.3 damping tsuji tangential linear_history 1000 0.6 0.5",
                    "hertz/material 200000 40 0.2 tangential mindlin NULL 0.6 0.5 damping velocity",
                    "hooke 5000 0.5 damping tsuji tangential linear_history 1000 1.0 0.3 limit_damping"):
            expected = move(spheres, f"pair_style granular\npair_coeff * * {law}", 1)[0]
            self.compare(move(Grains(**vars(spheres)), granular(law), 1)[0], expected, self.forces, law)

    def spheres_of_types(self, still=False):
        """Each of two types at random, so that there are contacts of all pairs of types."""
        spheres = self.spheres(still)
        return dataclasses.replace(spheres, types=np.random.default_rng(3).integers(1, 3, len(spheres.types)))

    def test_forms(self):
        """Types with laws of different forms, of which one has no springs. LAMMPS has each of them in a style of its own: the one style
        granular of the release of September 2021 gives contacts without springs a wrong friction if other contacts have springs."""
        names = "gran/hooke/history 9000 4000 30 15 0.3 1", "gran/hertz/history 90000 80000 200 100 0.5 1", "gran/hooke 7000 0 20 10 0.4 1"
        laws = ("hooke 9000 30 damping mass_velocity tangential linear_history 4000 0.5 0.3",
                "hertz 90000 200 tangential mindlin 80000 0.5 0.5",
                "hooke 7000 20 damping mass_velocity tangential linear_nohistory 0.5 0.4")
        types = "1 1", "2 2", "1 2"
        lammps = f"pair_style hybrid {' '.join(names)}" + "".join(
            f"\npair_coeff {pair} {name.split()[0]}" for pair, name in zip(types, names, strict=True))
        ours = "pair_style pw85/granular arms surface" + "".join(
            f"\npair_coeff {pair} {law}" for pair, law in zip(types, laws, strict=True))
        self.check((lammps, ours), (1, "on"), (4, "off"), spheres=self.spheres_of_types())

    def test_laws_of_types(self):
        """Pairs of types that have different laws, in any order in the list of neighbours."""
        spheres = self.spheres_of_types(still=True)
        laws = {"1 1": "hooke 5000 20", "1 2": "hertz 90000 40", "2 2": "hooke 9000 30"}
        coefficients = "".join(f"\npair_coeff {types} {law} damping mass_velocity tangential linear_nohistory 0.6 0.5"
                               for types, law in laws.items())
        expected = move(spheres, "pair_style granular" + coefficients, 1)[0]
        found = move(Grains(**vars(spheres)), "pair_style pw85/granular" + coefficients, 1)[0]
        self.compare(found, expected, self.forces, coefficients)

    def test_mixing(self):
        """Moduli of unlike materials are those of Hertz's theory; other constants are geometric means."""
        grains = lattice(Grains, 4, 1.0, [[0.5, 0.5, 0.6], [0.55, 0.5, 0.45]], 5)
        modulus, ratio = np.array([[200000, 600000], [0.3, 0.2]])
        hertz = 4.0 / 3.0 / np.sum((1.0 - ratio**2) / modulus)
        mindlin = 8.0 / np.sum(2.0 * (2.0 - ratio) * (1.0 + ratio) / modulus)
        words = "{} {:.17g} {:.17g} {} tangential {} {} {:.17g} {:.17g} rolling sds {:.17g} {:.17g} {:.17g} " \
            "twisting sds {:.17g} {:.17g} {:.17g} {}"
        numbers = np.array([[40, 0.6, 0.5, 3000, 5, 0.1, 300, 0.5, 0.02], [90, 0.9, 0.3, 1000, 8, 0.4, 500, 0.2, 0.04]])
        mean = np.sqrt(numbers.prod(axis=0))

        def law(form, stiffness, ratio, spring, size, constants, *last):
            return words.format(form, stiffness, constants[0], ratio, spring, size, *constants[1:], *last)

        materials = [law("hertz/material", e, nu, "mindlin", "NULL", n, "conservative")
                     for e, nu, n in zip(modulus, ratio, numbers, strict=True)]
        springs = [law("hooke", 5000 * k, "", "linear_history", 1000 * k * k, n, "") for k, n in zip((1, 2), numbers, strict=True)]
        for (first, second), mixed in (
                (materials, law("hertz", hertz, "", "mindlin", f"{mindlin:.17g}", mean, "conservative")),
                (springs, law("hooke", 5000 * np.sqrt(2.0), "", "linear_history", 2000, mean, ""))):
            like = f"pair_style pw85/granular\npair_coeff 1 1 {first}\npair_coeff 2 2 {second}"
            expected = move(grains, f"{like}\npair_coeff 1 2 {mixed}", 20)[-1]
            self.compare(move(grains, like, 20)[-1], expected, self.trajectory, mixed)

    def test_contacts_begin_anew(self):
        """Three spheres in a row that hit each other again and again, with the same neighbour list for some time: the spring of a contact
        that has ended is forgotten."""
        spheres = dataclasses.replace(
            self.spheres(), centers=np.array([[0.5, 2.0, 2.0], [1.8, 2.02, 2.0], [3.1, 2.0, 1.99]]), semi_axes=np.full((3, 3), 0.64),
            quaternions=np.tile([1.0, 0.0, 0.0, 0.0], (3, 1)), types=np.ones(3, dtype=int),
            velocities=np.array([[15.0, 0.0, 1.0], [-9.0, 2.0, 0.0], [-3.0, -1.0, 0.0]]), spins=np.array([[0.0, 1.0, 2.0]] * 3))
        expected, found = (move(kind(**vars(spheres)), law + "\nneighbor 0.9 bin", 400)[-1]
                           for kind, law in zip((Spheres, Grains), HOOKE, strict=True))
        self.compare(found, expected, self.trajectory, HOOKE[1])

    def test_freeze(self):
        """A contact with a grain of fix freeze has the mass of the other one, as in LAMMPS."""
        self.check([law + "\ngroup still id <= 20\nfix still still freeze" for law in HOOKE], (2, "on"))

    def test_mixing_as_lammps(self):
        """LAMMPS's release of September 2021 mixes constants, but leaves the words of the mixed law as they are in its memory. If memory
        is zero, these are the first ones of each kind."""
        spheres = self.spheres(still=True)
        words = "hooke {} {} damping velocity tangential linear_nohistory {} {}"
        laws = "\npair_coeff 1 1 " + words.format(9000, 30, 0.5, 0.2) + "\npair_coeff 2 2 " + words.format(5000, 20, 0.8, 0.5)
        with unittest.mock.patch.dict(os.environ, MALLOC_PERTURB_="255"):
            expected = move(spheres, "pair_style granular" + laws, 1)[0]
        self.compare(move(Grains(**vars(spheres)), "pair_style pw85/granular" + laws, 1)[0], expected, self.forces, laws)

    def test_mindlin_by_material(self):
        """8 G* of two equal bodies is 4 G/(2 - ν) = 2 E/((1 + ν)(2 - ν))."""
        grains = Grains(**vars(self.spheres()))
        law = "hertz/material 200000 40 0.3 damping velocity tangential mindlin {} 0.6 0.5"
        found = move(grains, granular(law.format("NULL")), 20)[-1]
        self.compare(found, move(grains, granular(law.format(2 * 200000 / (1.3 * 1.7))), 20)[-1], self.forces, law)


class Walls(AgainstLammps, unittest.TestCase):
    """Spheres between planes, one of which may move."""

    HOOKE_WALL = spheres.Law("hooke", 20000, 30, 8000, 0.5, 0.3)
    HERTZ_WALL = spheres.Law("hertz", 200000, 300, 80000, 0.5, 0.3)
    SHEARED = spheres.Wall(HOOKE_WALL, spheres.planes((2, -1.0, 0.05), (2, 1.0, 3.95)),
                           lambda time: lambda x: np.broadcast_to([3.0, 0.0, 0.0], x.shape))
    HOOKE = (HOOKE_LAW, (SHEARED,), f"\nfix wall all wall/pw85 zplane 0.05 3.95 shear x 3.0 arms surface law {HOOKE_WALL.words()}",
             f"\nfix wall all wall/gran {HOOKE_WALL.lammps()} zplane 0.05 3.95 shear x 3.0")
    WIGGLED = spheres.Wall(
        HERTZ_WALL, spheres.moved(spheres.planes((2, -1.0, 0.05)),
                                  lambda time: 0.02 * (1.0 - np.cos(2.0 * np.pi * time / 0.13)) * np.array([0.0, 0.0, 1.0])),
        lambda time: lambda x: np.broadcast_to([0.0, 0.0, 0.02 * 2.0 * np.pi / 0.13 * np.sin(2.0 * np.pi * time / 0.13)], x.shape))
    TOP = spheres.Wall(HERTZ_WALL, spheres.planes((2, 1.0, 3.95)))
    HERTZ = (HERTZ_LAW, (WIGGLED, TOP),
             f"\nfix wall all wall/pw85 zplane 0.05 NULL wiggle z 0.02 0.13 arms surface law {HERTZ_WALL.words()}"
             f"\nfix top all wall/pw85 zplane NULL 3.95 arms surface law {HERTZ_WALL.words()}",
             f"\nfix wall all wall/gran {HERTZ_WALL.lammps()} zplane 0.05 NULL wiggle z 0.02 0.13"
             f"\nfix top all wall/gran {HERTZ_WALL.lammps()} zplane NULL 3.95")

    def spheres(self, still=False):
        grains = super().spheres(still)
        return dataclasses.replace(grains, velocities=grains.velocities + [0.0, 0.0, 7.0])


# Ellipsoids with axis ratios up to 3, prolate, oblate and triaxial, of two sizes.
SHAPES = [[0.5, 0.5, 0.75], [0.7, 0.65, 0.3], [0.25, 0.25, 0.4]]


def cloud(seed=7, speed=1.0, edge=4, spacing=1.1):
    """Ellipsoids in the middle of a box that is so large that none reaches its walls."""
    grains = lattice(Grains, edge, spacing, SHAPES, seed, speed)
    inward = -speed * (grains.centers / spacing - 0.5 * edge)  # so that they collide
    return dataclasses.replace(grains, cell=3.0 * grains.cell, centers=grains.centers + grains.cell.sum(axis=0),
                               velocities=grains.velocities + inward)


ENERGY = """
compute spin all erotate/asphere
compute mass all property/atom mass
compute momenta all property/atom angmomx angmomy angmomz
variable px atom c_mass*vx
variable py atom c_mass*vy
variable pz atom c_mass*vz
variable lx atom c_mass*(y*vz-z*vy)+c_momenta[1]
variable ly atom c_mass*(z*vx-x*vz)+c_momenta[2]
variable lz atom c_mass*(x*vy-y*vx)+c_momenta[3]
compute sums all reduce sum v_px v_py v_pz v_lx v_ly v_lz
comm_modify vel yes
neighbor 0.1 bin
neigh_modify delay 0
{pair}
{walls}
variable total equal pe+ke+c_spin{wall_energy}
fix move all nve/asphere
timestep {timestep:.17g}
thermo {every}
thermo_style custom step v_total pe ke c_sums[*]
thermo_modify norm no format float %.17g
run {steps}
"""


def energies(grains, law, timestep, steps, every, ranks=1, walls=()):
    """Rows of the total energy, the potential and the kinetic one, the momentum and the angular momentum."""
    fixes = "\n".join(f"fix wall{k} all wall/pw85 {wall} law {law}" for k, wall in enumerate(walls))
    commands = ENERGY.format(pair=granular(law), timestep=timestep, steps=steps, every=every, walls=fixes,
                             wall_energy="".join(f"+f_wall{k}" for k in range(len(walls))))
    return thermo(run(preamble(grains) + commands, grains, ranks)[0])[:, 1:]


class Conservation(unittest.TestCase):
    def test_energy_without_damping(self):
        """The law hooke has an energy, which Verlet's method keeps up to the square of the time step."""
        errors = []
        for timestep in (0.001, 0.0005):
            total, potential = energies(cloud(), "hooke 2000 0", timestep, round(0.5 / timestep), 10).T[:2]
            self.assertGreater(np.ptp(potential), 0.1 * total[0], "hardly any contacts")
            errors.append(np.abs(total - total[0]).max() / total[0])
        print(f"relative error of the energy for time steps 0.001, 0.0005: {errors}")
        self.assertLess(errors[1], 1e-3)
        self.assertGreater(errors[0] / errors[1], 3.0, errors)

    def test_energy_of_hertz(self):
        """The force leaves out how R changes during a contact, a part of the order of the depth over R. The conservative law does not:
        its error falls with the square of the time step. Momentum and angular momentum are kept to rounding, as in test_momenta."""
        errors = {}
        for law, timestep in (("", 0.0005), (" conservative", 0.0005), (" conservative", 0.00025)):
            rows = energies(cloud(spacing=1.35), f"hertz 50000 0{law}", timestep, round(0.4 / timestep), 20)
            total, potential = rows.T[:2]
            self.assertGreater(potential.max(), 0.03 * total[0], "hardly any contacts")
            errors[law, timestep] = np.abs(total - total[0]).max() / total[0]
            np.testing.assert_allclose(rows[:, 3:6], rows[:1, 3:6].repeat(len(rows), axis=0), rtol=0, atol=3e-12, err_msg=law)
            np.testing.assert_allclose(rows[:, 6:9], rows[:1, 6:9].repeat(len(rows), axis=0), rtol=0, atol=3e-11, err_msg=law)
        print(f"hertz: the springs hold up to {potential.max() / total[0]} of the energy; relative errors {errors}")
        plain, coarse, fine = errors.values()
        self.assertLess(potential.max(), 0.1 * total[0])
        self.assertLess(plain, 0.01)
        self.assertLess(fine, 1e-4)
        self.assertGreater(coarse / fine, 3.0)
        self.assertGreater(plain / coarse, 20.0)

    def test_energy_between_walls(self):
        """Ellipsoids that bounce between planes, and hit each other."""
        box = dataclasses.replace(lattice(Grains, 3, 1.5, SHAPES, 9, speed=3.0), periodic=False)
        walls = [f"{axis}plane 0 4.5" for axis in "xyz"]
        errors = []
        for timestep in (0.0006, 0.0003):
            rows = energies(box, "hooke 3000 0", timestep, round(0.6 / timestep), 20, walls=walls)
            errors.append(np.abs(rows[:, 0] - rows[0, 0]).max() / rows[0, 0])
        self.assertGreater(np.ptp(rows[:, 3:6]), 1.0, "the walls are hardly hit")
        print(f"between walls, time steps 0.0006, 0.0003: {errors}")
        self.assertLess(errors[1], 1e-3)
        self.assertGreater(errors[0] / errors[1], 3.0, errors)

    def test_momenta(self):
        """Momentum and angular momentum are kept to rounding, whatever the law."""
        for law, ranks in (("hooke 2000 30 damping mass_velocity tangential linear_history 1000 0.5 0.5", 1),
                           ("hertz 20000 30 tangential mindlin 10000 0.5 0.5", 2)):
            rows = energies(cloud(), law, 0.0005, 400, 40, ranks)
            self.assertLess(rows[-1, 0], 0.8 * rows[0, 0], "hardly any damping")
            # Each of 400 steps adds rounding errors of the sums of 64 terms, u 64 times their largest one, of some units of momentum and
            # some tens of units of angular momentum: some 3e-12 and 3e-11.
            np.testing.assert_allclose(rows[:, 3:6], rows[:1, 3:6].repeat(len(rows), axis=0), rtol=0, atol=3e-12, err_msg=law)
            np.testing.assert_allclose(rows[:, 6:9], rows[:1, 6:9].repeat(len(rows), axis=0), rtol=0, atol=3e-11, err_msg=law)

    def test_damping_takes_energy(self):
        """Damping and friction without springs take energy in every step, up to the error of Verlet's method."""
        total = energies(cloud(), "hooke 2000 10 tangential linear_nohistory 0.5 0.3 damping mass_velocity", 0.0004, 400, 10)[:, 0]
        self.assertLess(total[-1], 0.8 * total[0])
        self.assertLess(np.diff(total).max(), 1e-5 * total[0])


class Shapes(unittest.TestCase):
    LAW = "hertz 50000 0"

    def forces(self, places, walls=""):
        """The forces on grains with semi-axes 0.4, 0.4 and 0.8, upright, at these heights."""
        count = len(places)
        centers = np.array([[2.0, 2.0, z] for z in places])
        upright = np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
        grains = Grains(np.diag([4.0, 4.0, 8.0]), True, centers, np.tile([0.4, 0.4, 0.8], (count, 1)), upright,
                        np.ones(count, dtype=int), np.zeros((count, 3)), np.zeros((count, 3)))
        return move(grains, granular(self.LAW) + walls, 1)[0][:, 7:10]

    def test_closed_forms(self):
        """The tip of a spheroid has the radius of curvature 0.4²/0.8; for two of them, R is half of that."""
        depth, radius = 0.01, 0.2
        pair = 50000 * np.sqrt(0.5 * radius * depth) * depth
        wall = 50000 * np.sqrt(radius * depth) * depth
        found = self.forces([3.0, 4.6 - depth])
        # The depth has an error of some u 4.6, a fraction of 1e-13 of itself, and its power 3/2 half as much again.
        np.testing.assert_allclose(found, [[0.0, 0.0, -pair], [0.0, 0.0, pair]], rtol=0, atol=1e-12 * pair)
        for lower, height, sign in (("1.0 NULL", 1.8 - depth, 1.0), ("NULL 7.0", 6.2 + depth, -1.0)):
            found = self.forces([height], f"\nfix wall all wall/pw85 zplane {lower} law {self.LAW}")
            np.testing.assert_allclose(found, [[0.0, 0.0, sign * wall]], rtol=0, atol=1e-12 * wall)


class Mixtures(unittest.TestCase):
    """Pairs of oblate, prolate and triaxial grains with axis ratios of 1 to 10 and sizes of 1 to 20, each with a contact that is known:
    the points with the normals n and -n are at the depth of the contact behind each other."""

    STIFFNESS, SPACING, EDGE = 100.0, 4.4, 4

    def pairs(self):
        """Grains 2k and 2k + 1 are a pair. Returns the grains, and the normals and depths of the pairs."""
        random = np.random.default_rng(17)
        count = self.EDGE**3
        ratios = 10.0 ** -np.concatenate([[0.0, 1.0], random.uniform(size=2 * count - 2)])
        middle = np.choose(np.arange(2 * count) % 3, [np.ones(2 * count), ratios, ratios**0.5])
        sizes = 20.0 ** -np.concatenate([[0.0, 1.0, 1.0, 0.0], random.uniform(size=2 * count - 4)])
        semi_axes = sizes[:, None] * np.stack([np.ones(2 * count), middle, ratios], axis=1)
        quaternions, normals = random.normal(size=(2 * count, 4)), random.normal(size=(count, 3))
        quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        depths = 0.02 * (semi_axes.min(axis=1)**2 / semi_axes.max(axis=1)).reshape(count, 2).min(axis=1)
        axes = np.array([rotation(q) for q in quaternions])
        images = np.einsum("nij,nj,nkj,nk->ni", axes, semi_axes**2, axes, np.repeat(normals, 2, axis=0))
        points = images / np.sqrt(np.einsum("ni,ni->n", images, np.repeat(normals, 2, axis=0)))[:, None]
        places = self.SPACING * (np.array(list(itertools.product(range(self.EDGE), repeat=3))) + 0.5)
        half = 0.5 * depths[:, None] * normals
        arms = points.reshape(count, 2, 3) * [[[1.0], [-1.0]]] + np.stack([-half, half], axis=1)
        centers = (places[:, None] - arms).reshape(2 * count, 3)
        cell = np.diag(np.full(3, self.EDGE * self.SPACING))
        grains = Grains(cell, True, centers, semi_axes, quaternions, 1 + np.arange(2 * count) % 2, *np.zeros((2, 2 * count, 3)))
        return grains, normals, depths, arms

    def states(self, grains, law, steps, every, ranks):
        """The rows of move(), at every n-th step."""
        commands = script(grains, granular(law), steps, "on").replace("timestep 0.0005", "timestep 2e-5")
        return np.array(run(commands.replace(f"all custom {steps}", f"all custom {every}"), grains, ranks, ("state.txt",))[1][0])

    def test_forces(self):
        grains, normals, depths, arms = self.pairs()
        self.assertGreater((grains.semi_axes.max(axis=1) / grains.semi_axes.min(axis=1)).max(), 9.9)
        found = self.states(grains, f"hooke {self.STIFFNESS} 0", 1, 1, 1)[0]
        forces = (self.STIFFNESS * depths[:, None] * normals)[:, None] * [[[-1.0], [1.0]]]
        # Depths have errors of some u times the largest coordinate, 18, and so have the arms, over the curvatures.
        tolerance = 1e-13 * self.STIFFNESS
        np.testing.assert_allclose(found[:, 7:10], forces.reshape(-1, 3), rtol=0, atol=tolerance)
        np.testing.assert_allclose(found[:, 10:13], np.cross(arms, forces).reshape(-1, 3), rtol=0, atol=tolerance)

    def test_ranks(self):
        """On four ranks, which the pairs cross as they fly through the box, forces are those of one rank at all times."""
        grains, normals, depths, _ = self.pairs()
        approach = np.stack([normals, -normals], axis=1).reshape(-1, 3) * np.repeat(200.0 * depths, 2)[:, None]
        flight = np.array([2000.0, 1500.0, -1300.0])
        grains = dataclasses.replace(grains, velocities=approach + flight, spins=100.0 * approach[:, [1, 2, 0]])
        law = f"hooke {self.STIFFNESS} 2 damping mass_velocity tangential linear_history 80 0.5 0.4"
        expected, found = (self.states(grains, law, 200, 20, ranks) for ranks in (1, 4))
        self.assertGreater(np.count_nonzero(expected[-1, :, 7]), 20, "hardly any contacts are left")
        # The order of ghosts changes sums by some u of their largest term, and positions by u times 18 in each of 200 steps, which the
        # stiffness turns into forces.
        np.testing.assert_allclose(found[:, :, 7:13], expected[:, :, 7:13], rtol=0, atol=1e-11)
        np.testing.assert_allclose(found[:, :, 4:7], expected[:, :, 4:7], rtol=0, atol=1e-12 * np.linalg.norm(flight))


class Errors(unittest.TestCase):
    START = "comm_modify vel yes\npair_style pw85/granular"
    LAW = "\npair_coeff * * hooke 1000 0"

    def check(self, commands, *words, grains=None):
        grains = grains or lattice(Grains, 2, 2.0, SHAPES[:2], 3)
        text = failure(preamble(grains) + commands + "\nrun 1\n", grains)
        for word in words:
            self.assertIn(word, text)

    def test_words(self):
        for law, words in (("hooke 1000", ("lacks damping",)),
                           ("hooke -1 0", ("bad stiffness: -1",)),
                           ("mdr 1000 0", ("unknown normal law mdr", "dmt, hertz, hertz/material, hooke, jkr")),
                           ("hertz/material 1000 0 0.6", ("bad Poisson's ratio: 0.6",)),
                           ("hertz 1000 0 tangential mindlin NULL 1 0.5", ("needs hertz/material",)),
                           ("hooke 1000 2 damping tsuji", ("coefficient of restitution above 1",)),
                           ("hooke 1000 0 rolling sds", ("lacks rolling stiffness",)),
                           ("hooke 1000 0 rolling sds 0 1 1", ("has a rolling stiffness of zero",)),
                           ("hooke 1000 0 capillary 1", ("unknown keyword capillary", "rolling, twisting"))):
            self.check(f"{self.START}\npair_coeff * * {law}", *words)

    def test_system(self):
        self.check("pair_style pw85/granular" + self.LAW, "use comm_modify vel yes")
        self.check(f"{self.START} 1.0{self.LAW}", "the pair cutoff 1 of types 1 and 1 misses contacts", "to 1.5 or more")
        self.check(f"{self.START}{self.LAW}\nset atom 3 shape 0 0 0", "atom 3 has no shape (type 2)", "set ... shape")

    def test_axes(self):
        """One axis that is zero (LAMMPS accepts this diameter, but its half rounds to zero), and axes that are no numbers."""
        start = f"variable bad atom exp(1000)-exp(1000)\nvariable tiny atom 2^(0-1074)\n{self.START}{self.LAW}\nset atom 3 "
        for words in ("shape 1 v_tiny 1", "shape 1 1 v_bad", "quat v_bad 0 1 90"):
            self.check(start + words, "Pair pw85/granular: atom 3 has a bad shape or quaternion (type 2): correct it with the set "
                       "command (set ... shape, set ... quat)")

    @unittest.skipUnless(release() >= (2026, 3, 30), "this LAMMPS has no superellipsoids")
    def test_superellipsoids(self):
        """They are refused, wherever they are needed; those with exponents of 2 are ellipsoids."""
        grains = dataclasses.replace(lattice(Grains, 2, 0.9, SHAPES[:2], 3), periodic=False)
        start = preamble(grains).replace("atom_style ellipsoid", "atom_style ellipsoid superellipsoid")

        class Exponents(Grains):
            """In data files these come after the quaternions."""

            def data_file(self):
                head, last = super().data_file().split("\nVelocities\n")
                head, rows = head.split("Ellipsoids\n\n")
                return f"{head}Ellipsoids\n\n" + rows.strip().replace("\n", " 2 2\n") + f" 2 2\n\nVelocities\n{last}"

        grains, plain = Exponents(**vars(grains)), grains
        zero, wall = "pair_style zero 4.0\npair_coeff * *\n", "fix wall all wall/pw85 zplane 0.0 NULL law hooke 1000 0\n"
        styles = {"Pair pw85/granular": self.START + self.LAW + "\n",
                  "Pair pw85/contact": "pair_style pw85/contact 4.0\npair_coeff * * 1\n",
                  "fix wall/pw85": zero + wall, "fix pw85/fire": zero + "fix relax all pw85/fire\n",
                  "Compute pw85/overlap": zero + "compute pairs all pw85/overlap\nthermo_style custom step c_pairs\n"}
        for name, commands in styles.items():
            for exponents in ("4 4", "2 3", "3 2"):
                text = failure(f"{start}{commands}set atom 3 block {exponents}\nrun 1\n", grains)
                self.assertIn(f"{name}: atom 3 is not an ellipsoid, but a superellipsoid (type 2): make its exponents 2", text)
        dump = "set atom 3 block 2 2\ndump state all custom 1 state.txt id fx fy fz\ndump_modify state sort id\nrun 0\n"
        first, second = (run(f"{begin}{self.START}{self.LAW}\n{words}", system, 1, ("state.txt",))[1][0][0]
                         for begin, words, system in ((start, dump, grains), (preamble(plain), dump.split("\n", 1)[1], plain)))
        self.assertGreater(np.abs(first[:, 1:]).max(), 1.0, "no contacts")
        np.testing.assert_array_equal(first, second)

    def test_respa(self):
        grains = lattice(Grains, 2, 2.0, SHAPES[:2], 3)
        self.check(f"{self.START}{self.LAW}\nrun_style respa 2 2 pair 1", "Pair pw85/granular does not work with run_style respa",
                   grains=grains)
        self.check("pair_style zero 3.0\npair_coeff * *\nfix wall all wall/pw85 zplane 0.0 NULL law hooke 1000 0\n"
                   "run_style respa 2 2 pair 1", "fix wall/pw85 does not work with run_style respa",
                   grains=dataclasses.replace(grains, periodic=False))

    def test_missing_laws(self):
        one = "\npair_coeff {0} {0} {1}"
        for law in ("", one.format(1, "hertz 1 0"), one.format(1, "hooke 1 0") + "\npair_coeff 1 2 hooke 1 0"):
            missing = 2 if law else 1
            self.check(self.START + law, f"Pair pw85/granular: type {missing} has no law of force: add pair_coeff {missing} {missing}")
        for law in ("hertz 1 0", "hooke 1 0 damping tsuji", "hooke 1 0 tangential linear_nohistory 1 1", "hooke 1 0 limit_damping",
                    "hooke 1 0 rolling sds 1 1 1"):
            self.check(self.START + one.format(1, "hooke 1 0") + one.format(2, law),
                       "the laws of types 1 and 2 cannot be mixed, because their words differ: add pair_coeff 1 2")

    def test_walls(self):
        start = self.START + self.LAW + "\nfix wall all wall/pw85 "
        law = "law hooke 1000 0"
        for words, message in ((f"zplane 0.0 NULL shear z 1.0 {law}", "a shear that is not along the wall"),
                               (f"zplane 0.0 NULL wiggle z 1.0 0.0 {law}", "has a period of zero"),
                               ("zplane 0.0 NULL law hooke 1000 x", "Expected floating point parameter"),
                               ("zplane 0.0 NULL law hertz 1000", "fix wall/pw85: the law of force lacks damping"),
                               (f"zplane 0.0 NULL {law}", "the box is periodic across the wall")):
            self.check(start + words, message)

    def test_depth(self):
        deep = lattice(Grains, 2, 2.0, SHAPES[:2], 3)
        deep.centers[1] = deep.centers[0] + [0.01, 0.0, 0.0]
        self.check(self.START + self.LAW, "atom 1 and atom 2 (types 1 and 2) overlap more than the law of force allows", "fix pw85/fire",
                   grains=deep)

    def test_without_motion(self):
        """Grains that no fix moves: a warning, but not if a run has no steps, for snapshots, or for heat in a packing at rest."""
        grains = lattice(Grains, 2, 0.95, SHAPES[:1], 3, speed=0.0)
        start = f"{preamble(grains)}{self.START}{self.LAW}\n"
        text = "no fix moves the grains, so they stand still under their forces: add fix nve/asphere"
        self.assertEqual(run(f"{start}run 0\nrun 2\n", grains)[0].count(text), 1)
        for commands in ("fix move all nve/asphere\nrun 2\n", "fix heat all pw85/heat constant 1 temperature 0\nrun 2\n",
                         "run 0\nwrite_dump all custom state.dump id x y z\nrerun state.dump dump x y z\n"):
            self.assertNotIn(text, run(start + commands, grains)[0], commands)

    def check_time_step(self, grains, commands, style, mass, units="lj", ftm2v=1.0, ranks=1, longer=1.01):
        """The limit of a contact with this mass is 0.2 √(m/k). It is printed with three digits, rounded down by at most 1 %. A force F
        accelerates a mass m by ftm2v F/m."""
        commands = f"comm_modify vel yes\nneighbor 0.1 bin\n{commands}\nfix move all nve/asphere"
        warning = f"{style}: the time step is too long for the stiffest contact: use timestep "
        limit = 0.2 * np.sqrt(mass / (1000.0 * ftm2v))
        start = f"processors {ranks} 1 1" + preamble(grains).replace("units lj", f"units {units}") + commands
        text, _ = run(f"{start}\ntimestep {longer * limit}\nrun 2\nrun 2\n"
                      f"timestep {0.99 * limit}\nrun 2\n", grains, ranks)
        found = [float(part.split()[0]) for part in text.split(warning)[1:]]
        self.assertEqual(len(found), 2, text)  # once in each of the first two runs
        for value in found:
            self.assertLessEqual(value, limit)
            self.assertGreater(value, 0.99 * limit)

    # kcal/mol/Å over g/mol is 4184e-7 Å/fs², and eV/Å over g/mol is 9648.5 Å/ps². In si all units fit.
    UNITS = ("lj", 1.0), ("si", 1.0), ("real", 4.184e-4), ("metal", 9648.5)

    def test_time_step(self):
        """The mass of a contact of two equal grains is half of their own."""
        near = lattice(Grains, 2, 0.95, SHAPES[:1], 3, speed=0.0, jitter=0.0)
        for units, ftm2v in self.UNITS:
            self.check_time_step(near, f"pair_style pw85/granular{self.LAW}", "Pair pw85/granular", 0.5 * near.masses[0], units, ftm2v)
        self.check_time_step(near, f"pair_style pw85/granular{self.LAW}", "Pair pw85/granular", 0.5 * near.masses[0], ranks=2)
        text, _ = run(f"{preamble(near)}{self.START}{self.LAW}\ntimestep 1\nminimize 0 0 10 10\n", near)
        self.assertNotIn("the time step is too long", text)

    def test_time_step_of_walls(self):
        """The lightest grain that touches the wall counts; the third grain, which is lighter, does not touch it."""
        shapes = np.array([[0.5, 0.5, 0.75], [0.25, 0.25, 0.4], [0.2, 0.2, 0.2]])
        grains = Grains(np.diag([4.0, 4.0, 4.0]), False, np.array([[1.0, 1.0, 0.74], [3.0, 1.0, 0.39], [2.0, 3.0, 2.0]]), shapes,
                        np.tile([1.0, 0.0, 0.0, 0.0], (3, 1)), np.ones(3, dtype=int), *np.zeros((2, 3, 3)))
        wall = "pair_style zero 2.0\npair_coeff * *\nfix wall all wall/pw85 zplane 0.0 NULL law hooke 1000 0"
        for units, ftm2v in self.UNITS:
            self.check_time_step(grains, wall, "fix wall/pw85", grains.masses[1], units, ftm2v)
        # The lightest grain is on the second processor. The time step is too long for the first one, too, whose limit is 2.7 times as long.
        self.check_time_step(grains, wall, "fix wall/pw85", grains.masses[1], ranks=2, longer=3.0)


if __name__ == "__main__":
    unittest.main()
