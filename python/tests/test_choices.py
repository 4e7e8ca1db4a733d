# SPDX-License-Identifier: BSD-3-Clause
"""Options that have a few words, flags or counts: another value is refused, with the argument, the value and what is allowed."""

import numpy as np
import pytest

import pypw85

Q = [1, 0, 0, 1, 0, 1]
TABLE = "x,y,z,a,b,c,qw,qx,qy,qz\n0,0,0,1,1,2,1,0,0,0\n"
# Options of read(): what one cannot be, and the message behind "read: "
OPTIONS = [
    ({"quaternion": "WXYZ"}, "quaternion must be 'wxyz' or 'xyzw', not 'WXYZ'"),
    ({"quaternion": "wxy"}, "quaternion must be 'wxyz' or 'xyzw', not 'wxy'"),
    ({"quaternion": ["wxyz"]}, r"quaternion must be 'wxyz' or 'xyzw', not \['wxyz'\]"),
    ({"lengths": "foo"}, "lengths must be 'radii', 'diameters' or 'rms', not 'foo'"),
    ({"convention": "x"}, "convention must be 'imagej', .* or 'none', not 'x'"),
    ({"angle": "degree"}, "angle must be 'degrees' or 'radians', not 'degree'"),
    ({"angle_zero": "z"}, "angle_zero must be 'x' or 'y', not 'z'"),
    ({"angle_sense": "clockwise"}, "angle_sense must be 'xy' or 'yx', not 'clockwise'"),
    ({"scales": "ln"}, "scales must be 'log' or 'linear', not 'ln'"),
    ({"euler": "zz"}, "euler must be one to three of xyz .* or of XYZ .*, no two alike side by side, not 'zz'"),
    ({"euler": 3}, "euler must be one to three of xyz .* not 3"),
    *(({"dimensions": value}, rf"dimensions must be 2 or 3, not {value!r}") for value in (4, 0, -1, 2.5, "3", True)),
    ({"periodic": "ab"}, "periodic must be True, False or three of them, not 'ab'"),
    ({"periodic": (True, True)}, r"periodic must be True, False or three of them, not \(True, True\)"),
    ({"cell": [10, 10, 10]}, r"cell must be three vectors of three numbers, one in each row, not \[10, 10, 10\]"),
    ({"cell": [[1], [2, 3]]}, r"cell must be real numbers, not \[\[1\], \[2, 3\]\]"),
    ({"shape": [1, 2]}, r"shape must be three finite numbers > 0, not \[1, 2\]"),
    ({"shape": [1, 2, -1]}, r"shape must be three finite numbers > 0, not \[1, 2, -1\]"),
    ({"shape": "abc"}, "shape must be real numbers, not 'abc'"),
    ({"shapes": {"A": [1, 1]}}, r"shapes of 'A' must be three finite numbers > 0, not \[1, 1\]"),
    ({"shapes": [1, 1, 1]}, r"shapes must map names of types to three lengths, not be \[1, 1, 1\]"),
    ({"shape_columns": "abc"}, "shape_columns must be a list of 1, 2 or 3 names, not 'abc'"),
    ({"quaternion_columns": ["qw"]}, r"quaternion_columns must be a list of 4 names, not \['qw'\]"),
    ({"polar": 3}, "polar must be a list of 2 names, not 3"),
    ({"points": "ghost"}, "points must be a list of names, not 'ghost'"),
    ({"ignore_columns": [1]}, r"ignore_columns must be a list of names, not \[1\]"),
    ({"sigma": "2"}, "sigma must be a real number, not '2'"),
    ({"sigma": 0}, "sigma must be > 0 and finite, not 0.0"),
    ({"strict": "no"}, "strict must be True or False, not 'no'"),
    ({"format": "foo"}, "format must be 'lammps-dump', .* or 'labels', not 'foo'"),
    ({"format": "vtk"}, "format must be 'lammps-dump', .* or 'labels', not 'vtk'"),
    ({"frame": "last"}, "frame must be an integer, not 'last'"),
    ({"frame": 1.5}, "frame must be an integer, not 1.5"),
]  # fmt: skip


@pytest.mark.parametrize("options, message", OPTIONS, ids=[message for _, message in OPTIONS])
def test_options_of_files(options, message, tmp_path):
    (tmp_path / "a.csv").write_text(TABLE)
    with pytest.raises((TypeError, ValueError), match=f"^read: {message}"):
        pypw85.read(tmp_path / "a.csv", **options)


def test_options_that_files_have(tmp_path):
    """Types of NumPy, one flag for all vectors."""
    (tmp_path / "a.csv").write_text(TABLE)
    system = pypw85.read(tmp_path / "a.csv", np.int8(-1), dimensions=np.int64(3), cell=8 * np.eye(3, dtype=int), periodic=True,
                         quaternion="wxyz", ignore_columns=())  # fmt: skip
    assert (system.dimensions, system.periodic, round(system.volume, 9)) == (3, (True, True, True), 512)


def spheres(**others):
    """Two that are apart."""
    return pypw85.System.from_axes([[0, 0, 0], [5, 0, 0]], [[1, 1, 1]] * 2, [[1, 0, 0, 0]] * 2, **others)


def simulation():
    return pypw85.HardEllipsoids(spheres(cell=9 * np.eye(3)))


def law(mu2_max):
    return pypw85.Law.inverse_powers(4, 12, 4, 6, mu2_max)


def sphere(**others):
    return pypw85.System([[0, 0, 0]], [[1, 0, 0, 1, 0, 1]], **others)


# Other calls
CALLS = [
    (lambda path: spheres(cell=np.zeros((3, 3))), r"System: cell must have independent rows, not \[\[0.0"),
    (lambda path: spheres(cell=np.diag([1, np.nan, 1])), r"System: cell must be finite, not \[\[1.0"),
    (lambda path: spheres(ids=[7, 7]), "ids must be different, not 7 twice"),
    (lambda path: spheres(ids=3), "2 centers, but 1 id"),
    (lambda path: spheres(types="a"), "2 centers, but 1 type"),
    (lambda path: spheres(origin=[1, 2]), r"origin must be three finite numbers, not \[1, 2\]"),
    (lambda path: spheres(origin=[1, 2, np.nan]), r"origin must be three finite numbers, not \[1, 2, nan\]"),
    (lambda path: spheres(shapeless=-1), "shapeless must be an integer >= 0, not -1"),
    (lambda path: spheres().check(worst=1.5), "System.check: worst must be an integer >= 0, not 1.5"),
    (lambda path: spheres().check(below="x"), "System.check: below must be a real number, not 'x'"),
    (lambda path: spheres().contacts(-1), "System.contacts: below must be > 0 and finite, not -1"),
    (lambda path: pypw85.pair_correlation(spheres(cell=9 * np.eye(3)), 2.0, 2.5), "pair_correlation: bins must be an integer >= 1"),
    (lambda path: pypw85.from_labels(np.ones((3, 3), int), "x"), "from_labels: spacing must be real numbers, not 'x'"),
    (lambda path: next(pypw85.frames(path, 3)), r"frames: chosen must be a slice, as slice\(0, 100, 10\), not 3"),
    (lambda path: simulation().try_placement(0, take="no"), "HardEllipsoids.try_placement: take must be True or False, not 'no'"),
    (lambda path: simulation().try_insertion([3, 3, 3], [1, 0, 0, 0], [1, 1, 1], 2), "HardEllipsoids.try_insertion: take must be True or"),
    (lambda path: simulation().compress("no"), "HardEllipsoids.compress: take must be True or False, not 'no'"),
    (lambda path: simulation().set_law(law(0.5)), "HardEllipsoids.set_law: parameters must have a cutoff above μ² = 1, where hard"),
    (lambda path: simulation().set_law(pypw85.Law.table(0.1, 1, [1, 0], [-1, 0])), r"HardEllipsoids.set_law: .* = 1, .*, not \[0.1, 1"),
    (lambda path: pypw85.overlap([3, 0, 0], Q, Q, np.zeros(6)), r"overlap: out must have the shape \(\), not \(6,\)"),
    (lambda path: pypw85.spheroid(1, 1, [0, 0, 1], np.zeros((2, 6))), r"spheroid: out must have the shape \(6,\), not \(2, 6\)"),
    (lambda path: pypw85.read(path / "a", frames=3), r"read\(\) got an unexpected keyword argument 'frames': the options are lengths, "),
    (lambda path: pypw85.from_euler([1, 2, 3], "ZYx", [0, 0, 0]), "from_euler: seq must be one to three of xyz .*, not 'ZYx'"),
    (lambda path: pypw85.from_euler([1, 2, 3], "Z", 0, degrees="no"), "from_euler: degrees must be True or False, not 'no'"),
    (lambda path: sphere().draw(path / "a.png", color="size"), "draw: color must be 'overlaps', 'orientation' or 'type', not 'size'"),
    (lambda path: sphere().draw(path / "a.png", elevation="up"), "draw: elevation must be a real number, not 'up'"),
    (lambda path: sphere().draw(path / "a.png", contacts="no"), "draw: contacts must be True or False, not 'no'"),
    (lambda path: sphere().draw(path / "a.png", size=0), "draw: size must be an integer from 1 to 20000, not 0"),
    (lambda path: pypw85.set_reproducible("off"), "set_reproducible: on must be True or False, not 'off'"),
    (lambda path: pypw85.set_reproducible(2), "set_reproducible: on must be True or False, not 2"),
    (lambda path: pypw85.write(path / "a", [], "foo"), "write: format must be 'lammps-dump', .* 'mjcf'.*, not 'foo'"),
    (lambda path: pypw85.write(path / "a.gsd", [], precision="half"), "write: precision must be 'single' or 'double', not 'half'"),
]  # fmt: skip


@pytest.mark.parametrize("call, message", CALLS, ids=[message for _, message in CALLS])
def test_calls(call, message, tmp_path):
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
        call(tmp_path)


def test_outputs_are_not_changed_before_they_are_refused():
    form = np.array(Q, dtype=float)
    with pytest.raises(ValueError, match="out must have the shape"):
        pypw85.overlap([3, 0, 0], Q, Q, form)
    assert form.tolist() == Q


def test_steps_of_an_absent_species():
    """They are for particles that may be inserted, or a slip of the keyboard."""
    one = simulation()
    with pytest.warns(UserWarning, match=r"set_kind_steps: no particle has the semi-axes \[1.0, 1.0, 1.5\]: these steps are for particles"):
        one.set_kind_steps([[1, 1, 1], [1, 1, 1.5]], 0.1, 0.1)
    assert one.kind_steps([1, 1, 1.5]).translation == 0.1
