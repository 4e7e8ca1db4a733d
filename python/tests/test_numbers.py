# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that are not the numbers that a function takes: the message has the argument, what is allowed, and the value."""

import warnings

import numpy as np
import pytest

import pypw85

Q, E, R = [1, 0, 0, 1, 0, 1], np.eye(4), [4, 0, 0, 0]
TRIANGLE = [[1, 2], [3, 5], [5, 6]]
PAIR = pypw85.System.from_axes([[0, 0, 0], [3, 0, 0]], [[0.5, 0.5, 1]] * 2, [[1, 0, 0, 0]] * 2, cell=6 * np.eye(3))
P = (0.0, 0.0, 1.0)
ONE = {"centers": [[0, 0, 0]], "q": [Q]}
MASKED = np.ma.masked_array(Q, [1, 0, 0, 0, 0, 0])
INTEGER, SEED, REAL = "must be an integer", r"must be an integer from 0 to 2\*\*64 - 1", "must be a real number"


def simulation():
    return pypw85.HardEllipsoids(PAIR)


def ellipse(angle=0.0, semi_axes=(1, 2), **others):
    return pypw85.System.from_ellipses([[0, 0]], [semi_axes], [angle], **others)


def spheroid(across):
    return pypw85.System.from_directions([[0, 0, 0]], across, 1, [[0, 0, 1]])


def axes(semi_axes, quaternion=(1, 0, 0, 0)):
    return pypw85.System.from_axes([[0, 0, 0]], [semi_axes], [quaternion])


# Arguments of the wrong type: the call, and the message
WRONG_TYPES = [
    (lambda: pypw85.nd_contact("abc", E, E), "nd_contact: r12 must be real numbers, not 'abc'"),
    (lambda: pypw85.nd_contact([1, 2, 3, "x"], E, E), r"nd_contact: r12 must be real numbers, not \[1, 2, 3, 'x'\]"),
    (lambda: pypw85.nd_contact(R, None, E), "nd_contact: q1 must be real numbers, not None"),
    (lambda: pypw85.nd_contact([4j, 0, 0, 0], E, E), r"nd_contact: r12 must be real numbers, not \[4j, 0, 0, 0\]"),
    (lambda: pypw85.nd_contact(R, E, E * 1j), "nd_contact: q2 must be real numbers, not an array of complex128"),
    (lambda: pypw85.nd_contact([[1, 2], [3]], E, E), r"nd_contact: r12 must be real numbers, not \[\[1, 2\], \[3\]\]"),
    (lambda: pypw85.nd_overlap(R, {}, E), r"nd_overlap: q1 must be real numbers, not \{\}"),
    (lambda: pypw85.nd_contact_geometry(R, E, E, "x"), "nd_contact_geometry: lambda_ must be real numbers, not 'x'"),
    (lambda: pypw85.enclosing_ellipsoid("abc"), "enclosing_ellipsoid: points must be real numbers, not 'abc'"),
    (lambda: pypw85.enclosing_ellipsoid([[1j, 2], [3, 4]]), r"enclosing_ellipsoid: points must be real numbers, not \[\[1j"),
    (lambda: pypw85.enclosing_ellipsoid(TRIANGLE, "x"), f"enclosing_ellipsoid: tolerance {REAL}, not 'x'"),
    (lambda: pypw85.credible_ellipsoid(TRIANGLE, None), f"credible_ellipsoid: share {REAL}, not None"),
    (lambda: pypw85.credible_ellipsoid(TRIANGLE, 1, 1j), f"credible_ellipsoid: tolerance {REAL}, not 1j"),
    (lambda: pypw85.contact("abc", Q, Q), "contact: r12 must be real numbers, not 'abc'"),
    (lambda: pypw85.contact([3, 0, "x"], Q, Q), r"contact: r12 must be real numbers, not \[3, 0, 'x'\]"),
    (lambda: pypw85.contact([[3, 0, 0]] * 2, Q, [1j] * 6), r"contact: q2 must be real numbers, not \[1j"),
    (lambda: pypw85.contact([[3, 0], [1]], Q, Q), r"contact: r12 must be real numbers, not \[\[3, 0\], \[1\]\]"),
    (lambda: pypw85.contact(None, Q, Q), "contact: r12 must be real numbers, not None"),
    (lambda: pypw85.contact(np.array(["2020-01-01"] * 3, "M8[D]"), Q, Q), r"contact: r12 .*, not an array of datetime64\[D\]"),
    (lambda: pypw85.contact(object(), Q, Q), "contact: r12 must be real numbers, not object"),
    (lambda: pypw85.contact([object()] * 3, Q, Q), "contact: r12 must be real numbers, not list"),
    (lambda: pypw85.f(10**400, [3, 0, 0], Q, Q), "f: lambda_ must be real numbers, not 1000"),
    (lambda: pypw85.f(np.complex128(1), [3, 0, 0], Q, Q), r"f: lambda_ must be real numbers, not \(1\+0j\)"),
    (lambda: pypw85.spheroid(1, 1, [0, 0, 1], "x"), "spheroid: out, which follows the inputs, must be an array of NumPy .* not 'x'"),
    (lambda: pypw85.contact([3, 0, 0], Q, Q, 0.5), "contact: out, which follows the inputs, must be an array .*, not 0.5"),
    (lambda: pypw85.overlap([3, 0, 0], Q, Q, np.ma.masked_array(0)), "overlap: out, .* without a mask, not a masked array"),
    (lambda: pypw85.contact([[3, 0, 0]] * 2, Q, Q, dtype=int), "contact: dtype must be float64, not int64"),
    (lambda: pypw85.overlap([3, 0, 0], Q, Q, dtype=float), "overlap: dtype must be bool or uint8, not float64"),
    (lambda: pypw85.contact([[3, 0, 0]] * 2, Q, Q, (np.zeros(2, int), np.zeros(2))), "contact: out must be an array of float64, not int64"),
    (lambda: pypw85.contact([3, 0, 0], Q, Q, (np.zeros((), int), np.zeros(()))), "contact: out must be an array of float64, not int64"),
    (lambda: pypw85.contact_pairs([[0, 1]], "abc", [Q]), "centers must be real numbers, not 'abc'"),
    (lambda: pypw85.neighbors([[0, 0, 0]], [Q], skin="x"), f"neighbors: skin {REAL}, not 'x'"),
    (lambda: pypw85.neighbors([[0, 0, 0]], [Q], scale=None), f"neighbors: scale {REAL}, not None"),
    (lambda: pypw85.random_points(Q, 2.5), rf"random_points: n {INTEGER} from 0 to 2\*\*40, not 2.5"),
    (lambda: pypw85.random_points(Q, 3, seed="a"), f"random_points: seed {SEED}, not 'a'"),
    (lambda: pypw85.random_points(Q, 3, surface="no"), "random_points: surface must be True or False, not 'no'"),
    (lambda: pypw85.even_points("abc", 3), "even_points: q must be real numbers, not 'abc'"),
    (lambda: pypw85.inertia(Q, shell="no"), "inertia: shell must be True or False, not 'no'"),
    (lambda: pypw85.inertia("abc"), "inertia: q must be real numbers, not 'abc'"),
    (lambda: pypw85.ellipsoid_mesh(Q, None), f"ellipsoid_mesh: deviation {REAL}, not None"),
    (lambda: pypw85.from_mesh([1, 2]), "from_mesh: mesh must be a pypw85.Mesh, not list"),
    (lambda: pypw85.HardEllipsoids(PAIR, seed=1.5), f"HardEllipsoids: seed {SEED}, not 1.5"),
    (lambda: pypw85.HardEllipsoids.restore("x"), "HardEllipsoids.restore: state must be bytes, not 'x'"),
    (lambda: simulation().sweep("5"), f"HardEllipsoids.sweep: number {INTEGER} >= 0, not '5'"),
    (lambda: simulation().chain(1, "x"), f"HardEllipsoids.chain: length {REAL}, not 'x'"),
    (lambda: simulation().chain(1, 1.0, [1j, 2, 3]), r"HardEllipsoids.chain: direction must be real numbers, not \[1j"),
    (lambda: simulation().tune(1, [0.4, 0.5]), rf"HardEllipsoids.tune: acceptance {REAL}, not \[0.4, 0.5\]"),
    (lambda: simulation().tune(1, 0.4, "1"), f"HardEllipsoids.tune: pressure {REAL}, not '1'"),
    (lambda: simulation().volume_moves(1, "1"), f"HardEllipsoids.volume_moves: pressure {REAL}, not '1'"),
    (lambda: simulation().set_steps(1, None, 1), f"HardEllipsoids.set_steps: rotation {REAL}, not None"),
    (lambda: simulation().set_fractions("a"), f"HardEllipsoids.set_fractions: translation {REAL}, not 'a'"),
    (lambda: simulation().set_kind_steps("a", 1, 1), "HardEllipsoids.set_kind_steps: semi_axes must be real numbers, not 'a'"),
    (lambda: simulation().set_kind_steps([1, 1, 1], 1, "a"), "HardEllipsoids.set_kind_steps: rotation must be real numbers, not 'a'"),
    (lambda: simulation().insertion_moves(1, [1, 1, 1], "a"), "HardEllipsoids.insertion_moves: activities must be real numbers, not 'a'"),
    (lambda: simulation().neighbors(1.5), f"HardEllipsoids.neighbors: particle {INTEGER}, not 1.5"),
    (lambda: simulation().try_placement(0, "a"), "HardEllipsoids.try_placement: center must be real numbers, not 'a'"),
    (lambda: simulation().set_walls([3]), r"HardEllipsoids.set_walls: walls\[0\] must be a pypw85.Wall, not int"),
    (lambda: simulation().set_fields([3]), r"HardEllipsoids.set_fields: fields\[0\] must be a pypw85.Field, not int"),
    (lambda: simulation().set_fields(None), "HardEllipsoids.set_fields: fields must be a list of pypw85.Field, not NoneType"),
    (lambda: simulation().set_walls(pypw85.Wall.sphere([0, 0, 0], 1)),
     "HardEllipsoids.set_walls: walls must be a list of pypw85.Wall, not Wall"),
    (lambda: pypw85.write(PAIR, "a.xyz"), "write: path must be the name of a file, not System"),
    (lambda: pypw85.write("a.xyz", None), "write: systems must be a list of pypw85.System, not NoneType"),
    (lambda: pypw85.read("a.xyz", 1.5), f"read: frame {INTEGER}, not 1.5"),
    (lambda: pypw85.mean_square_displacement([PAIR], [1.5]), rf"mean_square_displacement: lags\[0\] {INTEGER} from 1 to .*, not 1.5"),
    (lambda: simulation().set_mesh([1]), "HardEllipsoids.set_mesh: mesh must be a pypw85.Mesh, not list"),
    (lambda: simulation().set_law(3), "HardEllipsoids.set_law: law must be a pypw85.Law, not int"),
    (lambda: simulation().set_potential("a"), "HardEllipsoids.set_potential: potential must be a function, or the address .*, not 'a'"),
    (lambda: pypw85.Wall.plane("a", 1), "Wall.plane: normal must be real numbers, not 'a'"),
    (lambda: pypw85.Wall.plane([1, 0, 0], "1"), f"Wall.plane: offset {REAL}, not '1'"),
    (lambda: pypw85.Wall.cylinder([0, 0, 0], [0, 0, 1], []), rf"Wall.cylinder: radius {REAL}, not \[\]"),
    (lambda: pypw85.Field.aligning([1, 0, 0], 1, 1.5), f"Field.aligning: axis {INTEGER} from 0 to 2, not 1.5"),
    (lambda: pypw85.Observables(bins=1e12), f"Observables: bins {INTEGER} from 1 to 1000000, not 1000000000000.0"),
    (lambda: pypw85.Observables("a"), f"Observables: width {REAL}, not 'a'"),
    (lambda: pypw85.Observables().add(simulation(), "x"), f"Observables.add: compressibility {REAL}, not 'x'"),
    (lambda: pypw85.Observables().add(PAIR), "Observables.add: simulation must be a pypw85.HardEllipsoids, not System"),
    (lambda: pypw85.Blocking(1.5), rf"Blocking: size {INTEGER} from 1 to 2\*\*31 - 1, not 1.5"),
    (lambda: pypw85.Blocking().add(None), "Blocking.add: sample must be real numbers, not None"),
    (lambda: pypw85.pack("a", 0.3), "pack: semi_axes must be real numbers, not 'a'"),
    (lambda: pypw85.pack([[1, 1, 1]], None), f"pack: fraction {REAL}, not None"),
    (lambda: pypw85.relax(3), "relax: system must be a pypw85.System, not int"),
    (lambda: pypw85.relax(PAIR, 1.5), f"relax: steps {INTEGER} >= 1, not 1.5"),
    (lambda: pypw85.random_addition("a", np.eye(2)), "random_addition: semi_axes must be real numbers, not 'a'"),
    (lambda: pypw85.random_addition([[0.1, 0.1]], np.eye(2), 1.5), rf"random_addition: number {INTEGER} from 1 to 2\*\*31 - 1, not 1.5"),
    (lambda: pypw85.random_addition([[0.1, 0.1]], np.eye(2), seed=1.5), f"random_addition: seed {SEED}, not 1.5"),
    (lambda: pypw85.random_addition([[0.1, 0.1]], np.eye(2), attempts="a"), f"random_addition: attempts {REAL}, not 'a'"),
    (lambda: pypw85.System(**ONE, step="a"), f"step {INTEGER}, not 'a'"),
    (lambda: pypw85.System(**ONE, origin="a"), "origin must be real numbers, not 'a'"),
    (lambda: ellipse("a"), r"angles must be real numbers, not \['a'\]"),
    (lambda: spheroid("a"), "across must be real numbers, not 'a'"),
    (lambda: pypw85.Law.inverse_powers("a", 12, 4, 6), f"Law.inverse_powers: repulsion {REAL}, not 'a'"),
    (lambda: pypw85.Law.table(0, 1, "a", [1]), "Law.table: u must be real numbers, not 'a'"),
    (lambda: pypw85.bad_rows("a"), "bad_rows: result must be real numbers, not 'a'"),
    (lambda: pypw85.bad_rows([1.0], "a"), f"bad_rows: core_ndim {INTEGER} >= 0, not 'a'"),
    (lambda: pypw85.compressibility("a", 1), "compressibility: mu2 of configuration 0 must be real numbers, not 'a'"),
    (lambda: pypw85.lattice([1, 1, 3], 0.5, 1.5), f"lattice: number {INTEGER} >= 0, not 1.5"),
    (lambda: simulation().set_walls([pypw85.Wall(0.5, P, P, 1)]), r".*set_walls: walls\[0\]: kind must be an integer, not 0.5"),
    (lambda: simulation().set_walls([pypw85.Wall(None, P, P, 1)]),
     r"HardEllipsoids.set_walls: walls\[0\]: kind must be an integer, not None"),
    (lambda: simulation().set_walls([pypw85.Wall(0, None, P, 1)]), r".*set_walls: walls\[0\]: point must be real numbers, not None"),
    (lambda: simulation().set_walls([pypw85.Wall(0, P, "abc", 1)]), r".*set_walls: walls\[0\]: vector must be real numbers, not 'abc'"),
    (lambda: simulation().set_walls([pypw85.Wall(0, P, P, None)]), r".*set_walls: walls\[0\]: size must be a real number, not None"),
    (lambda: simulation().set_fields([pypw85.Field(0.5, 0, P, P, 1)]), r".*set_fields: fields\[0\]: kind must be an integer, not 0.5"),
    (lambda: simulation().set_fields([pypw85.Field(3, None, P, P, 1)]), r".*set_fields: fields\[0\]: axis must be an integer, not None"),
    (lambda: simulation().set_fields([pypw85.Field(3, 0, P, P, "1")]), r".*set_fields: fields\[0\]: strength must be a real number, not"),
    (lambda: simulation().set_law(pypw85.Law(2, None)), "HardEllipsoids.set_law: law: parameters must be real numbers, not None"),
    (lambda: pypw85.law_forces_pairs([[0, 1]], np.zeros((2, 3)), [Q, Q], pypw85.Law(None, np.ones(5))),
     "law_forces_pairs: law: kind must be an integer from 1 to 3, not None"),
    (lambda: pypw85.from_labels("nosuch.npy"), "from_labels: image must be an array of integers, not the text 'nosuch.npy': read a"),
    (lambda: pypw85.random_addition([[0.1, 0.1]], np.eye(2), stage=None), "random_addition: stage must be a function, not None"),
    (lambda: pypw85.relax(pypw85.System(**ONE), stage=1), "relax: stage must be a function, not 1"),
]  # fmt: skip
# Numbers that are not allowed
WRONG_VALUES = [
    (lambda: pypw85.nd_contact_geometry(R, E, E, [0.5, 1.5]), r"nd_contact_geometry: row \(1,\): lambda_ must be in \[0, 1\], not 1.5"),
    (lambda: pypw85.nd_contact_geometry(R, E, E, np.nan), r"nd_contact_geometry: lambda_ must be finite, not nan"),
    (lambda: pypw85.nd_contact_geometry([R, [0] * 4], E, E, 0.5), r"nd_contact_geometry: row \(1,\): r12 must not be zero, not \[0.0"),
    (lambda: pypw85.nd_contact_geometry(R, E, -E, 2), r"nd_contact_geometry: q2 must be positive definite, not \[-1.0"),
    (lambda: pypw85.credible_ellipsoid(TRIANGLE, 0.5),
     "credible_ellipsoid: share must take at least 3 of the 3 samples in 2 dimensions, not 2"),
    (lambda: pypw85.credible_ellipsoid(TRIANGLE, 1, -1), "credible_ellipsoid: tolerance must be > 0, not -1.0"),
    (lambda: pypw85.contact([3, 0, 0], Q, Q, np.zeros(3)), "out, if it is one array, must have 2 numbers in the last dimension"),
    (lambda: pypw85.contact([[3, 0, 0]] * 2, Q, Q, (np.zeros(3), np.zeros(2))), r"contact: out must have the shape \(2,\), not \(3,\)"),
    (lambda: pypw85.random_points(Q, 10**20), r"random_points: n must be an integer from 0 to 2\*\*40, not 1000"),
    (lambda: pypw85.random_points([0] * 6, 3), r"random_points: q must be positive definite, not \[0.0"),
    (lambda: pypw85.random_points(MASKED, 3), r"random_points: q must be finite, not \[nan"),
    (lambda: pypw85.inertia([0] * 6), r"inertia: q must be positive definite, not \[0.0"),
    (lambda: pypw85.inertia([1, 2], True), r"inertia: q has shape \(2,\); a form has 6 entries in the last axis"),
    (lambda: pypw85.Observables(bins=10**12), "Observables: bins must be an integer from 1 to 1000000, not 1000000000000"),
    (lambda: pypw85.pack([[1, 1, 1]], 0.3, seed="a"), "pack: seed must be an integer >= 0, not 'a'"),
    (lambda: pypw85.pack([[1, 1, 1]], 0.3, seed=-1), "pack: seed must be an integer >= 0, not -1"),
    (lambda: pypw85.pack([[1, 1, 1]], 0.3, dimensions="x"), "pack: dimensions must be 2 or 3, not 'x'"),
    (lambda: pypw85.random_addition([[0.1, 0.1]], np.eye(2), seconds=0), "random_addition: seconds must be > 0, not 0"),
    (lambda: simulation().tune(1, 0.4, 1, []), r"HardEllipsoids.tune: change must be 'isotropic', 'axis', .*, not \[\]"),
    (lambda: simulation().set_kind_steps([1, 2], 1, 1),
     r"set_kind_steps: semi_axes must have the shape \(3,\) or \(species, 3\), not \(2,\)"),
    (lambda: simulation().set_kind_steps([1, 1, 1], [1, 2], 1),
     "set_kind_steps: translation must be one number, or one for each of the 1 spe"),
    (lambda: pypw85.law_forces_pairs([[0, 1]], np.zeros((2, 3)), [Q, Q], pypw85.Law(0, np.ones(5))),
     "law_forces_pairs: law: kind must be an integer from 1 to 3, not 0"),
    (lambda: simulation().set_law(pypw85.Law(9, np.ones(5))), "HardEllipsoids.set_law: law: kind must be an integer from 1 to 3, not 9"),
    (lambda: simulation().set_law(pypw85.Law(2, np.ones((1, 5)))),
     r"HardEllipsoids.set_law: law: parameters must be a row of numbers, not an array of the shape \(1, 5\)"),
    (lambda: simulation().set_law(pypw85.Law(2, [1, 2])), "HardEllipsoids.set_law: num_parameters must be 5 for this kind"),
    (lambda: simulation().set_potential(3), "HardEllipsoids.set_potential: potential must be an integer from 4096 to .*, not 3"),
    (lambda: pypw85.System(**ONE, periodic="ab"), "periodic must be True, False or three of them, not 'ab'"),
    (lambda: pypw85.System(**ONE, periodic=[0.5, 2, 0]), r"periodic must be True, False or three of them, not \[0.5, 2, 0\]"),
    (lambda: pypw85.System(**ONE, periodic=[1, 2, 0]), r"periodic must be True, False or three of them, not \[1, 2, 0\]"),
    (lambda: pypw85.neighbors([[0, 0, 0]], [Q], periodic=[True] * 2),
     r"neighbors: periodic must be True, False or three of them, not \[True"),
    (lambda: pypw85.System(**ONE, dimensions="a"), "dimensions must be 2 or 3, not 'a'"),
    (lambda: axes([1, 1, -1]), r"System.from_axes: particle 0: semi_axes must be > 0, not \[1.0, 1.0, -1.0\]"),
    (lambda: axes([1, 1, np.nan]), r"System.from_axes: particle 0: semi_axes must be finite, not \[1.0, 1.0, nan\]"),
    (lambda: axes([1, 1, 1], [0, 0, 0, 0]), r"System.from_axes: particle 0: quaternions must not be zero, not \[0.0"),
    (lambda: spheroid(-1), r"System.from_axes: particle 0: semi_axes must be > 0, not \[-1.0"),
    (lambda: ellipse(np.nan), "System.from_ellipses: particle 0: angles must be finite, not nan"),
    (lambda: ellipse(periodic="ab"), "periodic must be True, False or two of them, not 'ab'"),
    (lambda: pypw85.System([[0, 0, 0]], Q), r"q must be rows of 6 numbers, not an array of the shape \(6,\): for a single one"),
    (lambda: pypw85.System(**ONE, cell=[9, 9, 9]),
     r"cell must be three vectors of three numbers, one in each row, not an array of the shape \(3,\)"),
    (lambda: pypw85.compare([3, 0, 0], Q, Q, np.nan), "compare: mu2 must not be NaN$"),
    (lambda: pypw85.nd_contact([1, 2, 3], [[1, 0, 0], [1, 1, 0], [0, 0, 1]], np.eye(3)), "nd_contact: q1 must be symmetric"),
    (lambda: pypw85.nd_contact([1, 2, 3], [1, 0, 1], [1, 0, 1]),
     r"nd_contact: q1 must have 3×3 or 6 numbers for 3 dimensions, not the shape \(3,\)"),
    (lambda: pypw85.lattice(10, 0.5, 4), r"lattice: semi_axes must be three numbers, not an array of the shape \(\)"),
    (lambda: pypw85.formats.Options(periodic="ab"), "read: periodic must be True, False or three of them, not 'ab'"),
    (lambda: pypw85.from_lammps([1, 2, 3], [0, 0, 0, 0]), "from_lammps: quaternion_wxyz must not be zero"),
    (lambda: pypw85.from_rotation_vector([1, 2, 3], [np.nan, 0, 0]), "from_rotation_vector: quaternion_wxyz must be finite"),
    (lambda: pypw85.plot([0, 0, np.nan], Q, [0, 0, 0], Q), "plot: r12 must be finite"),
    (lambda: pypw85.from_inertia(np.diag([1, 1, 5])),
     r"from_inertia: second_moments must be positive definite, not .*: they follow from the inertia: check that"),
    (lambda: pypw85.Law.table(0, 1, [1, 2], [1]), r"Law.table: u and d_u must be .* length, not of the shapes \(2,\) and \(1,\)"),
]  # fmt: skip
WALLS = [
    (pypw85.Wall.plane([0, 0, 0], 1), r"wall 1: vector must be a normal that is finite and not zero, not \(0.0, 0.0, 0.0\)"),
    (pypw85.Wall.plane([0, 0, 1], np.nan), "wall 1: size must be an offset that is finite, not nan"),
    (pypw85.Wall.sphere([0, np.inf, 0], 1), r"wall 1: point must be a center that is finite, not \(0.0, inf, 0.0\)"),
    (pypw85.Wall.cylinder([0, 0, 0], [0, 0, 1], -1), "wall 1: size must be a radius > 0 whose square is finite and not 0, not -1.0"),
    (pypw85.Wall.box([0, 0, 0], [-1, 1, 1]), r"wall 1 must have lower <= upper corners, not Wall\(kind=3, point=\(0.0, .*, vector=\(-1"),
    (pypw85.Wall(10**30, (0, 0, 0), (0, 0, 1), 1), r"wall 1: kind must be from 0 to 3, PW85_WALL_\.\.\., not 1000000000"),
    (pypw85.Wall.sphere([0, 0, 0], 9)._replace(kind=7), r"wall 1: kind must be from 0 to 3, PW85_WALL_\.\.\., not 7"),
    (pypw85.Wall.sphere([0, 0, 0], 9), "wall 0 must be the same in all images of the cell, not Wall"),
]
FIELDS = [
    (pypw85.Field.linear([np.nan, 0, 0]), r"field 1: vector must be a gradient that is finite, not \(nan, 0.0, 0.0\)"),
    (pypw85.Field.harmonic([np.inf, 0, 0], [1, 1, 1]), r"field 1: point must be a center that is finite, not \(inf, 0.0, 0.0\)"),
    (pypw85.Field.aligning([0, 0, 1], np.nan), "field 1: strength must be finite, not nan"),
    (pypw85.Field.aligning([0, 0, 0], 1), r"field 1: vector must be a direction whose square is finite and not 0, not \(0.0, 0.0, 0.0\)"),
    (pypw85.Field(9, 0, (0, 0, 0), (1, 0, 0), 1), r"field 1: kind must be from 0 to 3, PW85_FIELD_\.\.\., not 9"),
    (pypw85.Field(3, 7, (0, 0, 0), (1, 0, 0), 1), "field 1: axis must be from 0 to 2, not 7"),
    (pypw85.Field.linear([1, 0, 0]), "field 0 must be the same in all images of the cell, not Field"),
]


# Laws that no function takes
WRONG_LAWS = [
    (pypw85.Law.inverse_powers(np.nan, 12, 4, 6, 4), r"parameters must be finite, not \[nan, 12.0, 4.0, 6.0, 4.0\]"),
    (pypw85.Law.inverse_powers(4, 6, 4, 12, 4), r"parameters must have exponents n > m > 0, not \[4.0, 6.0, 4.0, 12.0, 4.0\]"),
    (pypw85.Law.inverse_powers(4, 12, 4, 6, -1), r"parameters must have a cutoff that is > 0, not \[4.0, 12.0, 4.0, 6.0, -1.0\]"),
    (pypw85.Law.table(2, 1, [0, 0], [0, 0]), r"parameters must have a range whose end is above its begin, not \[2.0, 1.0, 0.0"),
    (pypw85.Law.table(1, 2, [0, 0, np.inf, 0], [0] * 4), r"parameters must be finite, not inf \(entry 6\)"),
    (pypw85.Law(2, [4, 12]), "num_parameters must be 5 for this kind, not 2"),
]
LAWS = [
    *WRONG_LAWS,
    (pypw85.Law.soft_repulsion(1), "law must not be a soft repulsion, which ends where the hard cores begin: use inverse powers or"),
    (pypw85.Law.inverse_powers(4, 12, 4, 6, 1), r"parameters must have a cutoff above μ² = 1, where hard cores touch, not \[4.0, 12.0"),
    (pypw85.Law.inverse_powers(4, 12, 4, 6), "law must have a cutoff of at most 10⁶ in μ²"),
    (pypw85.Law.inverse_powers(4e6, 12, 4, 6, 4), "law must have energies of pairs of at most 2²⁰ k_B T"),
]


@pytest.mark.parametrize("call, message", WRONG_TYPES, ids=[message for _, message in WRONG_TYPES])
def test_wrong_types(call, message):
    with pytest.raises(TypeError, match=f"^{message}"):
        call()


@pytest.mark.parametrize("call, message", WRONG_VALUES, ids=[message for _, message in WRONG_VALUES])
def test_wrong_values(call, message):
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # the exception says all
        with pytest.raises(ValueError, match=message):
            call()


@pytest.mark.parametrize("wall, message", WALLS, ids=[message for _, message in WALLS])
def test_walls_that_are_refused(wall, message):
    """In open space behind a good wall, or in a periodic cell."""
    is_second = "wall 1" in message
    system = pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 1]], [[1, 0, 0, 0]]) if is_second else PAIR
    with pytest.raises(pypw85.PW85Error, match=message):
        pypw85.HardEllipsoids(system).set_walls([pypw85.Wall.plane([0, 0, 1], 9)] * is_second + [wall])


@pytest.mark.parametrize("field, message", FIELDS, ids=[message for _, message in FIELDS])
def test_fields_that_are_refused(field, message):
    good = [pypw85.Field.aligning([0, 0, 1], 1)] if "field 1" in message else []
    with pytest.raises(pypw85.PW85Error, match=message):
        simulation().set_fields([*good, field])


@pytest.mark.parametrize("law, message", LAWS, ids=[message for _, message in LAWS])
def test_laws_that_are_refused(law, message):
    with pytest.raises(pypw85.PW85Error, match=f"^HardEllipsoids.set_law: {message}"):
        simulation().set_law(law)


@pytest.mark.parametrize("law, message", [
    *WRONG_LAWS, (pypw85.Law.soft_repulsion(8, 0.5), r"parameters must have an exponent that is >= 1, not \[8.0, 0.5\]"),
])  # fmt: skip
def test_laws_of_pairs_that_are_refused(law, message):
    with pytest.raises(ValueError, match=f"^law_forces_pairs: {message}"):
        pypw85.law_forces_pairs([[0, 1]], [[0, 0, 0], [1, 0, 0]], [Q, Q], law)


def test_what_counts_as_a_number():
    """Types of NumPy, and 0 and 1 in place of truth values."""
    assert len(pypw85.random_points(np.array(Q, np.float32), np.int8(3), np.uint64(2**64 - 1), surface=1)) == 3
    assert pypw85.System(**ONE, cell=np.eye(3), periodic=[1, 0, np.True_]).periodic == (True, False, True)
    assert pypw85.System(**ONE, cell=np.eye(3), periodic=np.array(False)).periodic == (False, False, False)
    assert pypw85.nd_contact([np.float16(4), 0, None or 0, 0], np.eye(4, dtype=bool), E)[0] == 4
    averages = pypw85.Blocking()
    for sample in (1, np.nan, 2):
        averages.add(sample)
    assert np.isnan(averages.estimate().value[0])
