# SPDX-License-Identifier: BSD-3-Clause
"""Files of other programs: what is written is read again, conventions, and what is said of broken files."""

import decimal
import gzip
import io
import itertools
import os
import pathlib
import random
import re
import stat
import subprocess
import sys
import warnings

import numpy as np
import pytest

import pypw85
from pypw85 import _core
from pypw85.formats import _files, _table
from systems import CELL, SUFFIXES, random_system

DUMP = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS pp pp ff
0 10
-5 5
1 11
ITEM: ATOMS id type x y z shapex shapey shapez quatw quati quatj quatk
7 1 1 2 3 2 4 6 1 0 0 0
9 2 4 5 6 2 2 2 0.6 0 0 0.8
"""


def changed(old, new, count=1):
    text = DUMP.format(step=5)
    assert old in text
    return text.replace(old, new, count)


@pytest.fixture
def file(tmp_path):
    def make(text, name="a.dump"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return make


def assert_same(actual, expected, assert_rows):
    for name in ("centers", "semi_axes", "quaternions", "q"):
        a, b = getattr(actual, name), getattr(expected, name)
        assert_rows((a == b).all(axis=1), a, b)
    if expected.cell is None:
        assert actual.cell is None
    else:
        np.testing.assert_array_equal(actual.cell, expected.cell)
    assert actual.periodic == expected.periodic


@pytest.mark.parametrize("suffix", SUFFIXES.values())
def test_round_trip(suffix, tmp_path, assert_rows):
    path = tmp_path / f"a.{suffix}"
    # GSD numbers from 0, LAMMPS from 1
    expected = random_system(step=0, ids=np.arange(40) + (suffix == "data"))
    pypw85.write(path, expected)
    actual = pypw85.read(path)
    assert_same(actual, expected, assert_rows)
    np.testing.assert_array_equal(actual.ids, expected.ids)
    assert len(np.unique(actual.types)) == 2
    assert {path.name} == {entry.name for entry in tmp_path.iterdir()}


@pytest.mark.parametrize("suffix", ["xyz", "h5", "csv"])
def test_round_trip_without_cell(suffix, tmp_path, assert_rows):
    system = random_system()
    expected = pypw85.System.from_axes(system.centers, system.semi_axes, system.quaternions, types=["big"] * 40)
    pypw85.write(tmp_path / f"a.{suffix}", expected)
    actual = pypw85.read(tmp_path / f"a.{suffix}")
    assert_same(actual, expected, assert_rows)
    assert actual.periodic == (False, False, False)
    np.testing.assert_array_equal(actual.types, expected.types)


@pytest.mark.parametrize("suffix", ["dump", "xyz", "h5"])
def test_partly_periodic(suffix, tmp_path):
    pypw85.write(tmp_path / f"a.{suffix}", random_system(periodic=(True, False, True)))
    assert pypw85.read(tmp_path / f"a.{suffix}").periodic == (True, False, True)


def made(path, text):
    path.write_text(text)
    return path


@pytest.mark.parametrize("suffix", ["dump", "gsd", "xyz", "h5"])
def test_frames(suffix, tmp_path, assert_rows):
    path = tmp_path / f"a.{suffix}"
    expected = [random_system(seed, step=10 * seed) for seed in range(4)]
    pypw85.write(path, iter(expected))
    found = list(pypw85.frames(path))
    assert [system.step for system in found] == [0, 10, 20, 30]
    for a, b in zip(found, expected):
        assert_same(a, b, assert_rows)
    assert [system.step for system in pypw85.frames(path, slice(1, None, 2))] == [10, 30]
    assert [system.step for system in pypw85.frames(path, slice(-2, None))] == [20, 30]
    assert pypw85.read(path, -1).step == 30
    with pytest.raises(pypw85.FileError, match="there is no frame "):
        pypw85.read(path, 4)


def test_repeated_ids(tmp_path):
    """They name no particle."""
    rows = "id,x,y,z,radius\n7,0,0,0,1\n3,9,0,0,1\n7,1,0,0,1\n"
    with pytest.warns(UserWarning, match="2 particles have the id 7: the particles are numbered from 1 in their order instead"):
        assert pypw85.read(made(tmp_path / "a.csv", rows)).ids.tolist() == [1, 2, 3]
    assert pypw85.read(made(tmp_path / "a.csv", rows.replace("7,1", "8,1"))).ids.tolist() == [7, 3, 8]


def test_shapes_that_are_not_needed(tmp_path):
    rows = "x,y,z,radius\n0,0,0,1\n"
    with pytest.warns(UserWarning, match="--shape has no effect, because all particles have shapes"):
        assert pypw85.read(made(tmp_path / "a.csv", rows), shape=(2, 2, 2)).semi_axes.tolist() == [[1, 1, 1]]
    with pytest.warns(UserWarning, match="--shape has no effect, because all particles of the type 0 have shapes"):
        pypw85.read(made(tmp_path / "a.csv", rows), shapes={"0": (2, 2, 2)})


@pytest.mark.parametrize("header, sequence, words", [
    ("x,y,z,a,b,c", "ZYX", "needs 3 columns of angles, and no column looks like an angle: name them in the order of ZYX"),
    ("x,y,z,a,b,c,phi", "zx", "needs 2 columns of angles, and only phi look like angles: name them"),
])  # fmt: skip
def test_euler_angles_that_are_not_there(header, sequence, words, tmp_path):
    rows = f"{header}\n{','.join('1' for _ in header.split(','))}\n"
    with pytest.raises(pypw85.FileError, match=f"--euler {sequence} {words}"):
        pypw85.read(made(tmp_path / "a.csv", rows), euler=sequence, angle="degrees")


def test_tables_without_names(tmp_path):
    with pytest.raises(pypw85.FileError, match="the first line must name the columns .*, not be 1 2 3: add such a line"):
        pypw85.read(made(tmp_path / "a.csv", "1,2,3\n4,5,6\n"))


@pytest.mark.filterwarnings("ignore:.*GSD has")
def test_systems_from_forms_have_axes(tmp_path, assert_rows):
    given = random_system()
    system = pypw85.System(given.centers, given.q, given.cell)
    np.testing.assert_allclose(system.semi_axes, np.sort(given.semi_axes, axis=1), rtol=1e-13)
    q = pypw85.ellipsoid_quaternion(system.semi_axes, system.quaternions)
    assert_rows(np.abs(q - given.q).max(axis=1) <= 64 * 2.0**-53, q, given.q)
    pypw85.write(tmp_path / "a.gsd", system)
    assert len(pypw85.read(tmp_path / "a.gsd")) == 40


def test_dump_as_lammps_writes_it(file):
    system = pypw85.read(file(DUMP.format(step=5)))
    assert (system.step, system.periodic) == (5, (True, True, False))
    np.testing.assert_array_equal(system.origin, [0, -5, 1])
    np.testing.assert_array_equal(system.cell, 10 * np.eye(3))
    np.testing.assert_array_equal(system.semi_axes, [[1, 2, 3], [1, 1, 1]])
    np.testing.assert_array_equal(system.ids, [7, 9])
    np.testing.assert_array_equal(system.types, [1, 2])


def test_tilted_boxes_of_lammps(file):
    """The bounds of a dump enclose the tilted box."""
    bounds = "ITEM: BOX BOUNDS xy xz yz pp pp pp\n-2 13 3\n-5 5.5 -2\n1 11 0.5"
    tilted = changed("ITEM: BOX BOUNDS pp pp ff\n0 10\n-5 5\n1 11", bounds)
    general = changed("ITEM: BOX BOUNDS pp pp ff\n0 10\n-5 5\n1 11",
                      "ITEM: BOX BOUNDS abc origin pp pp pp\n10 0 0 0\n3 10 0 -5\n-2 0.5 10 1")
    for text in (tilted, general):
        system = pypw85.read(file(text))
        np.testing.assert_array_equal(system.cell, [[10, 0, 0], [3, 10, 0], [-2, 0.5, 10]])
        np.testing.assert_array_equal(system.origin, [0, -5, 1])


def test_scaled_positions(file):
    system = pypw85.read(file(changed("x y z", "xs ys zs")))
    np.testing.assert_array_equal(system.centers, [[10, 15, 31], [40, 45, 61]])


def test_named_columns(file):
    path = file(changed("shapex shapey shapez quatw quati quatj quatk", "v_1 v_2 v_3 d_4 d_5 d_6 d_7"))
    with pytest.raises(pypw85.FileError, match="no shapes"):
        pypw85.read(path)
    system = pypw85.read(path, shape_columns=["v_1", "v_2", "v_3"], quaternion_columns=["d_4", "d_5", "d_6", "d_7"],
                         quaternion="wxyz")  # fmt: skip
    np.testing.assert_array_equal(system.semi_axes, [[1, 2, 3], [1, 1, 1]])


def test_options(file):
    path = file(DUMP.format(step=5))
    columns = ["quatk", "quatw", "quati", "quatj"]
    system = pypw85.read(path, lengths="radii", quaternion_columns=columns, cell=7 * np.eye(3), periodic=(False, False, True))
    np.testing.assert_array_equal(system.semi_axes, [[2, 4, 6], [2, 2, 2]])
    np.testing.assert_array_equal(system.quaternions[0], [0, 1, 0, 0])
    np.testing.assert_array_equal(system.cell, 7 * np.eye(3))
    assert system.periodic == (False, False, True)


def test_particles_without_shape(file):
    path = file(changed("2 4 6 1 0 0 0", "0 0 0 1 0 0 0"))
    system = pypw85.read(path)
    assert (len(system), system.shapeless, system.ids[0]) == (1, 1, 9)
    system = pypw85.read(path, shape=(4, 4, 8))
    np.testing.assert_array_equal(system.semi_axes, [[2, 2, 4], [1, 1, 1]])


def test_atoms_without_ellipsoid_in_a_data_file(file, tmp_path):
    pypw85.write(tmp_path / "a.data", random_system(count=3))
    lines = (tmp_path / "a.data").read_text().splitlines()
    lines = [line.replace("3 ellipsoids", "2 ellipsoids") for line in lines[:-1]]
    with pytest.raises(pypw85.FileError, match="line 16: the atom 3 has the flag 1, but there is none for it"):
        pypw85.read(file("\n".join(lines), "b.data"))
    lines[15] = re.sub(r"^(3 \d+) 1", r"\1 0", lines[15])
    system = pypw85.read(file("\n".join(lines), "b.data"))
    assert (len(system), system.shapeless) == (2, 1)


def test_extended_xyz_of_ovito(file):
    text = """2
Lattice="4 0 0 0 5 0 0 0 6" Properties=species:S:1:pos:R:3:AsphericalShape:R:3:Orientation:R:4 pbc="T F T"
A 1 2 3 1 2 3 0 0 0 1
B 4 5 6 1 1 1 0 0 0.6 0.8
"""
    system = pypw85.read(file(text, "a.xyz"))
    np.testing.assert_array_equal(system.quaternions, [[1, 0, 0, 0], [0.8, 0, 0, 0.6]])
    np.testing.assert_array_equal(system.semi_axes[0], [1, 2, 3])
    assert system.periodic == (True, False, True) and list(system.types) == ["A", "B"]


def test_gsd_shapes(tmp_path):
    import gsd.hoomd

    is_new = hasattr(gsd.hoomd, "Frame")  # since gsd 2.8
    snapshot = gsd.hoomd.Frame() if is_new else gsd.hoomd.Snapshot()
    snapshot.configuration.box = [8, 9, 10, 0.5, 0.25, 0.125]
    snapshot.particles.N = 3
    snapshot.particles.typeid = [0, 1, 2]
    snapshot.particles.types = ["A", "B", "C"]
    snapshot.particles.type_shapes = [{"type": "Ellipsoid", "a": 1, "b": 2, "c": 3}, {"type": "Sphere", "diameter": 1}, {}]
    snapshot.particles.position = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]
    with gsd.hoomd.open(str(tmp_path / "a.gsd"), "w" if is_new else "wb") as out:
        out.append(snapshot)
    system = pypw85.read(tmp_path / "a.gsd")
    np.testing.assert_array_equal(system.semi_axes, [[1, 2, 3], [0.5, 0.5, 0.5]])
    np.testing.assert_array_equal(system.cell, [[8, 0, 0], [4.5, 9, 0], [2.5, 1.25, 10]])
    assert (system.shapeless, list(system.types)) == (1, ["A", "B"])


def test_forms_in_hdf5(tmp_path):
    import h5py

    system = random_system()
    with h5py.File(tmp_path / "a.h5", "w") as out:
        out["particles/all/position"], out["particles/all/form"] = system.centers, system.q
    np.testing.assert_allclose(pypw85.read(tmp_path / "a.h5").q, system.q, atol=1e-14)
    with h5py.File(tmp_path / "a.h5", "r+") as out:
        out["particles/all/form"][3] = 0
    with pytest.raises(pypw85.FileError, match="particle 4 has a form that is not positive definite"):
        pypw85.read(tmp_path / "a.h5")


def test_tensors_for_paraview(tmp_path):
    system = random_system(count=5)
    pypw85.write(tmp_path / "a.vtk", system)
    lines = (tmp_path / "a.vtk").read_text().splitlines()
    start = lines.index("TENSORS6 shape double") + 1
    xx, yy, zz, xy, yz, xz = np.loadtxt(lines[start:start + 5]).T
    root = pypw85.full(np.stack([xx, xy, xz, yy, yz, zz], axis=1))
    np.testing.assert_allclose(root @ root, pypw85.full(system.q), atol=1e-14)


BAD_DUMPS = {
    "truncated in the table": (DUMP.format(step=5)[:-40], 10, "columns"),
    "truncated between lines": (DUMP.format(step=5).rsplit("9 2", 1)[0], 10, "after 1 of 2 particles: it is truncated"),
    "truncated in the header": (DUMP.format(step=5)[:90], 9, "truncated"),
    "too many columns": (changed("1 0 0 0\n", "1 0 0 0 5\n"), 10, "13 columns instead of 12"),
    "word for a number": (changed("1 2 3", "1 abc 3"), 10, r"column 4 \(y\) must be a number, not 'abc'"),
    "position not a number": (changed("1 2 3", "1 nan 3"), 10, "particle 7 has a position that is not finite"),
    "infinite position": (changed("4 5 6", "4 5 inf"), 11, "particle 9 has a position that is not finite"),
    "zero axis": (changed("2 4 6", "2 0 6"), 10, "particle 7 has a length that is not positive"),
    "negative axis": (changed("2 4 6", "2 -4 6"), 10, "particle 7 has a length that is not positive"),
    "axis not a number": (changed("2 4 6", "2 nan 6"), 10, "particle 7 has a length that is not finite"),
    "zero quaternion": (changed("1 0 0 0", "0 0 0 0"), 10, "particle 7 has a quaternion that is zero"),
    "quaternion not a number": (changed("1 0 0 0", "nan 0 0 0"), 10, "particle 7 has a quaternion that is zero or not"),
    "quaternion of length 2": (changed("1 0 0 0", "2 0 0 0"), 10, "particle 7 has a quaternion whose length is not 1"),
    "no shapes": (changed("2 4 6", "0 0 0").replace("2 2 2", "0 0 0"), None, "no particle has a shape"),
    "no columns of shapes": (changed("shapex", "a"), 9, "the columns a shapey shapez could change .*, and are not used: .*--shape-columns"),
    "no orientations": (changed("quatw", "a"), 9, "the columns a quati quatj quatk could change the shapes"),
    "no positions": (changed("x y z", "a b c"), 9, "no columns x y z"),
    "an id that is no integer": (changed("\n7 1", "\n7.5 1"), 10, "'id' must be a whole number"),
    "no particles": (changed("ATOMS\n2\n", "ATOMS\n0\n").split("7 1")[0], None, "no particles"),
    "number of particles not a number": (changed("ATOMS\n2\n", "ATOMS\ntwo\n"), 4, "the number of particles must be"),
    "box not a number": (changed("0 10", "0 ten"), 6, "bounds of the box must be 2 numbers"),
    "flat box": (changed("0 10", "0 0"), None, "zero or not finite"),
    "infinite box": (changed("0 10", "0 inf"), None, "zero or not finite"),
    "more lines than particles": (changed("ATOMS\n2\n", "ATOMS\n1\n"), 11, "more lines than particles"),
    "no header": ("ITEM: ATOMS id x y z\n1 2 3 4\n", 1, "missing"),
    "bytes that are no text": (DUMP.format(step=5).encode().replace(b"1 2 3", b"1 \xff\xfe 3"), 10, "must be a number"),
}


@pytest.mark.parametrize("name", BAD_DUMPS)
def test_bad_dumps(name, file):
    text, line, reason = BAD_DUMPS[name]
    with pytest.raises(pypw85.FileError, match=reason) as raised:
        list(pypw85.frames(file(text)))
    assert (raised.value.line, raised.value.frame) == (line, 1 if "more lines" in name else 0)


def test_frame_and_line_of_later_frames(file):
    bad = DUMP.format(step=6).replace("4 5 6", "4 abc 6")
    with pytest.raises(pypw85.FileError, match=r"a.dump, frame 1, line 22: column 4 \(y\)"):
        list(pypw85.frames(file(DUMP.format(step=5) + bad)))


@pytest.mark.parametrize("suffix", SUFFIXES.values())
def test_truncated_anywhere(suffix, tmp_path, file):
    """Whatever is missing, there is one sentence, or what is left is a file of its own."""
    pypw85.write(tmp_path / f"a.{suffix}", random_system(count=5))
    content = (tmp_path / f"a.{suffix}").read_bytes()
    refused = 0
    for size in range(0, len(content) - 25, max(1, len(content) // 150)):
        try:
            list(pypw85.frames(file(content[:size], f"b.{suffix}")))
        except pypw85.FileError as error:
            assert "\n" not in str(error) and str(error).startswith(str(tmp_path))
            refused += 1
    assert refused > 75


@pytest.mark.parametrize("name, text, reason", [
    ("a.xyz", "1\nhello\nA 1 2 3\n", "there are no shapes"),
    ("a.xyz", "1\nhello\nA 1 2\n", "not recognised"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:3:foo:R:2000000000\nA 1 2 3 1\n", "5 columns instead of the 2000000004"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:3:radius\nA 1 2 3 1\n", "must have names, kinds and numbers"),
    ("a.xyz", "1\nProperties=pos:R:3:pos:R:3:radius:R:1\n1 2 3 1 2 3 1\n", "several columns 'pos.1.'"),
    ("a.xyz", "1\nProperties=pos:R:3:radius:R:1 Timestep=inf\n1 2 3 1\n", "Timestep must be a whole number, not 'inf'"),
    ("a.xyz", "1\nProperties=pos:R:3:radius:R:1 Timestep=1e300\n1 2 3 1\n", "Timestep must be a whole number"),
    ("a.xyz", "1\nProperties=pos:R:3:radius:R:1 pbc=T\n1 2 3 1\n", "pbc must be three of T and F"),
    ("a.xyz", "1\nProperties=pos:R:3:radius:R:1" + " " * 40000 + "x\n1 2 3 1\n", "line 2: the line has more than 32768 characters"),
    ("a.xyz", "0\nProperties=pos:R:3:radius:R:1\n", "there are no particles"),
    ("a.csv", "x,y,z,radius,id\n1,2,3,1,1e20\n", "line 2: 'id' must be a whole number"),
    ("a.csv", "x,y,z,radius\n1e270,2,3,1\n", "line 2: particle 1 has a position beyond 1e.150"),
    ("a.csv", "x,y,z,radius\n1,2,3,1e-200\n", "line 2: particle 1 has a length beyond"),
    ("a.csv", "x,y,z,radius\n1_0,2,3,1\n", r"column 1 \(x\)"),
    ("a.csv", "x,y,x,z,radius\n1,2,3,4,1\n", "several columns 'x'"),
    ("a.csv", 'x,y,z,radius,type\n1,2,3,1,"a\n', "line 2: the line cannot be read .*quotation"),
    ("a.csv", "# periodic T T\nx,y,z,radius\n1,2,3,1\n", "the comments '# origin' and '# periodic' have two values"),
    ("a.csv", "x,y,z,radius,type\n1,2,3,1," + 300 * "n" + "\n", "more than 255 characters"),
    ("a.csv", b"x,y,z,radius,type\n1,2,3,1,a\n1,2,3,1,\xc5\n", "line 3: the name of a type is not text in UTF-8"),
    ("a.dump", changed(" pp pp ff", ""), "the file does not say along which"),
    ("a.dump", changed("ATOMS\n2", "ATOMS\n-2"), "line 4: the number of particles must be a whole number, not '-2'"),
    ("a.dump", DUMP.format(step="inf"), "line 2: the time step must be a whole number, not 'inf'"),
    ("a.data", f"x\n\n{2**63} atoms\n0 1 xlo xhi\n", "line 3: the number of atoms must be a whole number"),
    ("a.xyz", "2\nProperties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", "truncated"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:2:radius:R:1\nA 1 2 1\n", "has 2 columns instead of 3"),
    ("a.xyz", '1\nProperties=species:S:1:pos:R:3:radius:R:1 Lattice="1 2\nA 1 2 3 1\n', "quotation mark"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:3:radius:R:1 Lattice=1,2\nA 1 2 3 1\n", "Lattice must be 9 numbers"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\nB 1 2 3 1\n", "more lines than particles"),
    ("a.csv", "x,y,z,a,b,c\n1,2,3,1,2,3\n", "lacks an orientation"),
    ("a.csv", "x,y,z,radius\n1,2,3\n", "3 columns instead of 4"),
    ("a.csv", "x,y,z,radius\n1,2,3,\n", r"column 4 \(radius\)"),
    ("a.csv", "x,y,z,radius\n", "no particles"),
    ("a.csv", "# cell 1 0 0\nx,y,z,radius\n1,2,3,1\n", "line 1: the comment '# cell' must be followed by nine numbers"),
    ("a.csv", "# cell 1 0 0 0 1 0 1 1 0\nx,y,z,radius\n1,2,3,1\n", "lie in a plane"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n", "bounds of the box are missing"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n", "no section Atoms"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # spin\n\n1 1 1 1 0 0 0\n", "atom_style spin"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms\n\n1 1 1 1 0 0 0\n", "no shapes"),
    ("a.dat", "hello", "format is not recognised"),
    ("a.obj", "# a cube\n\n  # of quads\nv 0 0 0\nv 1 0 0\n", r"this is a mesh, not a file of particles: read it with pypw85\.Mesh\.read"),
    ("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n",
     "these are points without shapes, .*: save a table"),
    ("b.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement face 0\nend_header\n", "this is a mesh"),
    ("a.stl", "SOLID cube\nFACET NORMAL 0 0 1\n", r"this is a mesh, not a file of particles: read it with pypw85\.Mesh\.read"),
    ("a.dat", "", "the file is empty"),
    ("a.dat", "\n \n", "the file is empty"),
])  # fmt: skip
def test_bad_text(name, text, reason, file):
    with pytest.raises(pypw85.FileError, match=reason):
        list(pypw85.frames(file(text, name)))


@pytest.mark.parametrize("suffix, line", [("csv", 9), ("xyz", 7), ("data", 18), ("dump", 14)])
def test_lines(suffix, line, tmp_path, file):
    """Lines are counted as an editor counts them: here that of the fifth particle."""
    system = random_system(count=5)
    system.centers[4, 1] = 0.123456789
    pypw85.write(tmp_path / f"a.{suffix}", system)
    text = (tmp_path / f"a.{suffix}").read_text()
    word = next(word for word in text.replace(",", " ").split() if word.startswith("0.12345678"))
    bad = text.replace(word, "abc")
    assert bad.splitlines()[line - 1].count("abc") == 1
    with pytest.raises(pypw85.FileError, match=f"line {line}: column . .*'abc'"):
        pypw85.read(file(bad, f"b.{suffix}"))


TEXT = ["dump", "data", "xyz", "csv"]


@pytest.fixture
def small_blocks(monkeypatch):
    """Some lines are read at once, and lines lie across the bytes that are read ahead."""
    monkeypatch.setattr(_table, "_BLOCK", 700)
    monkeypatch.setattr(_files, "READ_AHEAD", 300)


@pytest.mark.parametrize("suffix", [*TEXT, "dump.gz", "xyz.gz"])
def test_blocks_of_lines(suffix, tmp_path, assert_rows, small_blocks):
    names = [f"a{k // 3}" for k in range(40)]
    expected = [random_system(seed, step=seed, types=names) for seed in range(1 if suffix in ("data", "csv") else 3)]
    pypw85.write(tmp_path / f"a.{suffix}", expected)
    found = list(pypw85.frames(tmp_path / f"a.{suffix}"))
    assert len(found) == len(expected)
    for a, b in zip(found, expected):
        assert_same(a, b, assert_rows)
        assert list(a.types) == names


@pytest.mark.parametrize("suffix", TEXT)
def test_lines_of_blocks(suffix, tmp_path, file, small_blocks):
    """A word that is wrong is found in its line, and so is the end of a truncated table, wherever these are."""
    pypw85.write(tmp_path / f"a.{suffix}", random_system(step=0))
    lines = (tmp_path / f"a.{suffix}").read_text().splitlines(keepends=True)
    first = len(lines) - 40 if suffix != "data" else next(k for k, line in enumerate(lines) if line.startswith("Atoms")) + 2
    for k in (0, 1, 6, 20, 39):
        broken = [*lines]
        words = re.split("([ ,])", broken[first + k])
        broken[first + k] = "".join([*words[:10], "1_0", *words[11:]])
        with pytest.raises(pypw85.FileError, match=r"must be a number, not '1_0'") as raised:
            pypw85.read(file("".join(broken), f"b.{suffix}"))
        assert raised.value.line == first + k + 1
        if suffix != "csv" and k:
            with pytest.raises(pypw85.FileError, match=f"the file ends after {k} of 40 particles") as raised:
                pypw85.read(file("".join(lines[:first + k]), f"b.{suffix}"))
            assert raised.value.line == first + k


def test_plain_files_are_read_by_compiled_code(tmp_path, monkeypatch):
    def by_words(*_):
        pytest.fail("lines were read word by word")

    monkeypatch.setattr(_table.Table, "_rows_by_words", by_words)
    for suffix in TEXT:
        types = ["a", "Größe"] * 20
        pypw85.write(tmp_path / f"a.{suffix}", random_system(types=types))
        windows = (tmp_path / f"a.{suffix}").read_bytes().replace(b"\n", b"\r\n")
        (tmp_path / f"b.{suffix}").write_bytes(windows)
        for name in "ab":
            assert list(pypw85.read(tmp_path / f"{name}.{suffix}").types) == types


def number_words(rng):
    """Decimals of all sizes: short, of 17 digits, and of all digits that the midpoint of two numbers has."""
    for exponent in rng.integers(-1074, 1024, 2000):
        number = float(np.ldexp(rng.uniform(-1, 1), exponent))
        middle = decimal.Decimal(number) + (decimal.Decimal(float(np.nextafter(number, np.inf))) - decimal.Decimal(number)) / 2
        yield from (repr(number), f"{number:.17g}", f"{number:+.6e}", f"{number:.3g}", str(middle))
    yield from ("0", "-0", "+0", "1.", ".5", "-.5e1", "1E5", "+1e+5", "00012", "inf", "-Infinity", "NaN", "5e-324", "4.9e-324", "2e-324",
                "1.7976931348623157e308", "1e309", "-1e400", "1e-400", "0" * 400 + "1", "1" + "0" * 400, "9007199254740993")


@pytest.mark.parametrize("separator", [" ", ","])
def test_numbers_are_those_of_float(separator, rng):
    """Bit for bit, if they are read at all; those out of range, and only those, are left to Python."""
    decimal.getcontext().prec = 1200
    for word in number_words(rng):
        expected = float(word)
        found = _core.parse_rows(f"x{separator}{word}\n".encode(), 0 if separator == " " else ord(separator), b"-n")
        if found is None:
            assert np.isinf(expected) or abs(expected) < 2.0**-1022, word
        else:
            assert found[0].tobytes() == np.array(expected).tobytes() or (np.isnan(expected) and np.isnan(found[0][0, 0])), word


@pytest.mark.parametrize("word", ["", "+", "-", ".", "e5", "1e", "1e+", "1_0", "0x10", "1,0", "--1", "+-1", "-+1", "++1", "1a",
                                  "nan(1)", "nan()", "infi", "\u0661", "1\u00a0", "\xb2", "1\0", "T"])  # fmt: skip
def test_words_that_are_no_numbers(word):
    assert _core.parse_rows(f"{word} \n".encode(), 0, b"n") is None
    assert _core.parse_rows(f"1;{word}\n".encode(), ord(";"), b"nn") is None


def test_plain_rows():
    """What str.split() makes of lines; without an end, the last line is one, too."""
    block = b"a 1 x -2.5\t \r\n  b\x1c3 y\x0b4\na 5 z 6"
    numbers, codes, names = _core.parse_rows(block, 0, b"tn-n")
    assert (numbers.tolist(), codes.tolist(), names) == ([[1, -2.5], [3, 4], [5, 6]], [[0], [1], [0]], ([b"a", b"b"],))
    numbers, codes, names = _core.parse_rows(b",1,, 2\r\n a b ,3,x,4\n", ord(","), b"tn-n")
    assert (numbers.tolist(), codes.tolist(), names) == ([[1, 2], [3, 4]], [[0], [1]], ([b"", b"a b"],))
    for bad in (b"a 1 x\n", b"a 1 x 2 3\n", b"\n", b"a 1 x 2\n\n", b"a 1 \xc2\xa0 2\n"):
        assert _core.parse_rows(bad, 0, b"tn-n") is None, bad
    numbers, codes, names = _core.parse_rows(b'"a,b",1,"x","2"\r\n"",3,x,4\n"c","5",,"6"', ord(","), b"tn-n")
    assert (numbers.tolist(), codes.tolist(), names) == ([[1, 2], [3, 4], [5, 6]], [[0], [1], [2]], ([b"a,b", b"", b"c"],))
    for bad in ('"a""b",1,x,2', 'a"b,1,x,2', ' "a",1,x,2', '"a,1,x,2', '"a"b,1,x,2', 'a,1,x,"2', 'a,1,x,2,"', 'a,1,x,"', 'a,1,"x,2',
                '\r,1,"x",2',
                'a,1,x,"2" ', '"a",1,x"y,2'):  # fmt: skip
        assert _core.parse_rows(bad.encode(), ord(","), b"tn-n") is None, bad
        assert _core.parse_rows(bad.encode() + b"\n", ord(","), b"tn-n") is None, bad
    assert _core.parse_rows(b"a,1,2\n", ord(","), b"tn-n") is None


@pytest.mark.parametrize("separator", [" ", ","])
def test_rows_are_read_as_they_were_written(separator, monkeypatch):
    """In blocks of three rows, the last of which is not full."""
    monkeypatch.setattr(_table, "_WRITTEN", 3)
    bits = np.random.default_rng(1).integers(0, 2**63, 1000, dtype=np.uint64)
    numbers = np.concatenate([bits.view(np.float64), [0.0, -0.0, 0.1, 5e-324, 2.0**53, 1e23, np.finfo(float).max, 1.0]])
    numbers = numbers[np.isfinite(numbers)]
    numbers = numbers[: len(numbers) // 2 * 2].reshape(-1, 2)
    names = np.array(["a", "Öl", "b"])[np.arange(len(numbers)) % 3]
    ids = np.arange(len(numbers)) - 2**62
    file = io.StringIO()
    _table.write_rows(file, separator, ids, numbers[:, ::-1], _table.coded(names, str.upper))
    rows = [line.split(separator) for line in file.getvalue().removesuffix("\n").split("\n")]
    assert [int(row[0]) for row in rows] == ids.tolist()
    read = np.array([[float(word) for word in row[1:3]] for row in rows])
    assert read.tobytes() == np.ascontiguousarray(numbers[:, ::-1]).tobytes()
    assert [row[3] for row in rows] == [name.upper() for name in names]
    assert all(len(word) <= len(repr(float(word))) for row in rows for word in row[1:3])


WORDS = ["1", "-2.5", "1e3", "a", "", '""', '"a"', '"1"', '"a,b"', " 1", 'a"b', '"', "\r", "\x1c", "é", "\u00a0", "nan",
         "+1", '"a""b"', '  "a"', "\t"]  # fmt: skip


@pytest.mark.parametrize("name, head, separator", [("a.csv", "x,y,z,radius,type,other\n", ","),
                                                   ("a.xyz", "3\nProperties=pos:R:3:radius:R:1:species:S:1:other:S:1\n", " ")])
def test_compiled_code_reads_what_python_reads(name, head, separator, file, monkeypatch):
    """Tables with odd words: the same numbers and names, or the same error."""

    def outcome(path):
        try:
            system = pypw85.read(path, format=name[2:])
        except pypw85.FileError as error:
            return str(error)
        return system.centers.tolist(), system.semi_axes.tolist(), list(map(str, system.types))

    chance = random.Random(1)
    found = []
    for _ in range(400):
        rows = [["1", "2", "3", "1", "a", "b"] for _ in range(3)]
        for _ in range(chance.choice([1, 1, 2, 4])):
            row = chance.choice(rows)
            row[chance.randrange(6)] = chance.choice(WORDS) + chance.choice(["", "", "", chance.choice(WORDS)])
        path = file(head + "\n".join(map(separator.join, rows)) + chance.choice(["", "\n", "\r\n"]), name)
        found.append(outcome(path))
        with monkeypatch.context() as context:
            context.setattr(_table.Table, "_plain_rows", lambda *_: None)
            assert outcome(path) == found[-1], path.read_bytes()
    assert 50 < sum(isinstance(each, tuple) for each in found) < 350


def test_hdf5_without_particles(tmp_path):
    import h5py

    with h5py.File(tmp_path / "a.h5", "w") as out:
        out["positions"] = np.zeros((3, 3))
    with pytest.raises(pypw85.FileError, match="no /particles/.../position"):
        pypw85.read(tmp_path / "a.h5")
    with h5py.File(tmp_path / "a.h5", "w") as out:
        out["particles/all/position"], out["particles/all/semi_axes"] = np.zeros((3, 3)), np.ones((2, 3))
    with pytest.raises(pypw85.FileError, match="semi_axes must have the shape"):
        pypw85.read(tmp_path / "a.h5")


def test_no_file_and_a_directory(tmp_path):
    with pytest.raises(FileNotFoundError):
        pypw85.read(tmp_path / "missing")
    with pytest.raises(pypw85.FileError, match="is a directory"):
        pypw85.read(tmp_path)


HOSTILE = ["a,b", "a b", " a", 'q"q', "'", "a\nb", "a\r", "\x1b[2J", "=1+1", "@SUM(A1)", "+x", "-x", "x" * 100, "x" * 100 + "y",
           "x" * 300, "", "é", "\u00a0", "a\u00a0b", "\u2028", "\u4e2d", "\udcff", "\x85", "#", "007", "7", "-0",
           "\u00b2", "\u0663", "1_0", "nan", "None"]  # fmt: skip


@pytest.mark.filterwarnings("ignore:.*single precision")
@pytest.mark.parametrize("suffix", [*SUFFIXES.values(), "xyz.gz"])
@pytest.mark.parametrize("name", HOSTILE, ids=ascii)
def test_names_come_back_or_are_refused(name, suffix, tmp_path):
    path = tmp_path / f"a.{suffix}"
    types = ["Na", name, "x" * 100, "7"]
    try:
        pypw85.write(path, random_system(count=4, types=types))
    except ValueError as error:
        assert "give it another name" in str(error) and str(error).isprintable()
        assert not list(tmp_path.iterdir())
    else:
        assert list(map(str, pypw85.read(path).types)) == types


def test_which_names_are_refused(tmp_path):
    """Formats hold what they can: quoted in CSV, any text in HDF5."""
    refused = {name: [] for name in ("a,b", "a b", "a\nb", "=1", "é", "x" * 255, "")}
    for name, suffix in itertools.product(refused, SUFFIXES.values()):
        try:
            pypw85.write(tmp_path / f"a.{suffix}", random_system(count=2, types=["Na", name]))
        except ValueError:
            refused[name].append(suffix)
    blanks = ["dump", "data", "xyz"]
    assert refused == {"a,b": [], "a b": blanks, "a\nb": [*blanks, "csv"], "=1": ["csv"], "é": ["gsd"], "x" * 255: [],
                       "": [*blanks, "csv"]}  # fmt: skip


@pytest.mark.parametrize("types", [["b", "a", "b"], [1, 3, 1], [-1, 0, 5], ["2", "1", "2"], [1.5, 2.5, 1.5]], ids=str)
@pytest.mark.parametrize("suffix", SUFFIXES.values())
def test_types(suffix, types, tmp_path, recwarn):
    """Names and whole numbers come back; LAMMPS's data files renumber others, and say so."""
    if suffix == "data" and types[0] == 1.5:
        with pytest.raises(ValueError, match="not a name that LAMMPS allows"):
            pypw85.write(tmp_path / "a.data", random_system(count=3, types=types))
        return
    pypw85.write(tmp_path / f"a.{suffix}", random_system(count=3, types=types, ids=np.arange(3) + (suffix == "data")))
    found = pypw85.read(tmp_path / f"a.{suffix}").types
    if suffix == "data" and types[0] == -1:
        assert (list(found), len(recwarn)) == ([1, 2, 3], 1) and "are renumbered" in str(recwarn[0].message)
    elif suffix == "gsd":
        # A type has one shape there
        assert [str(name).partition("_")[0] for name in found] == list(map(str, types))
    else:
        assert list(map(str, found)) == list(map(str, types))


def test_names_of_types_in_gsd_differ(tmp_path):
    """A type with several shapes is divided; a name that results may be that of another type."""
    system = pypw85.System.from_axes(3.0 * np.arange(9).reshape(3, 3), [[1, 1, 1], [2, 2, 2], [1, 1, 1]], [[1, 0, 0, 0]] * 3,
                                     cell=64 * np.eye(3), origin=[-32] * 3, ids=range(3), types=["A", "A", "A_0"])  # fmt: skip
    with pytest.warns(UserWarning, match="one shape for each type"):
        pypw85.write(tmp_path / "a.gsd", system)
    assert list(pypw85.read(tmp_path / "a.gsd").types) == ["A_1", "A_2", "A_0"]


@pytest.mark.parametrize("suffix", SUFFIXES.values())
@pytest.mark.parametrize("length", [0.5, 3.0, 1e-200, 1e200])
@pytest.mark.filterwarnings("ignore:.*GSD has")
def test_quaternions_of_any_length(suffix, length, tmp_path, assert_rows):
    expected = random_system(step=0)
    system = pypw85.System.from_axes(expected.centers, expected.semi_axes, length * expected.quaternions, cell=expected.cell)
    lengths = np.linalg.norm(system.quaternions, axis=1)
    assert_rows(np.abs(lengths - 1) <= 4 * 2.0**-53, system.quaternions)
    pypw85.write(tmp_path / f"a.{suffix}", system)
    q = pypw85.read(tmp_path / f"a.{suffix}").q
    # GSD rounds the components of a quaternion, each to half a unit, and with them axes whose squares are up to 1.
    assert_rows(np.abs(q - expected.q).max(axis=1) <= (8 * 2.0**-24 if suffix == "gsd" else 64 * 2.0**-53), q, expected.q)


def test_quaternions_of_single_precision_stay_as_they_are(rng):
    q = rng.normal(size=(1000, 4))
    q = (q / np.linalg.norm(q, axis=1, keepdims=True)).astype(np.float32).astype(np.float64)
    system = pypw85.System.from_axes(np.zeros((1000, 3)), np.ones((1000, 3)), q)
    np.testing.assert_array_equal(system.quaternions, q)


@pytest.mark.parametrize("suffix", [*SUFFIXES.values(), "vtk"])
@pytest.mark.parametrize("change, reason", [
    (lambda s: s.centers.__setitem__((2, 1), np.nan), "has a position that is not finite"),
    (lambda s: s.centers.__setitem__((2, 1), 1e200), "has a position beyond"),
    (lambda s: s.semi_axes.__setitem__((2, 1), -1), "has a length that is not positive"),
    (lambda s: s.quaternions.__setitem__(2, np.nan), "has a quaternion that is zero or not a number"),
    (lambda s: s.quaternions.__setitem__((2, 1), np.inf), "has a quaternion that is zero or not a number"),
    (lambda s: s.ids.__setitem__(2, 2**60), "has an id beyond"),
    (lambda s: setattr(s, "step", 2**63), "more than 64 bits"),
])  # fmt: skip
def test_what_could_not_be_read_is_not_written(suffix, change, reason, tmp_path):
    system = random_system(count=5)
    change(system)
    with pytest.raises(ValueError, match=reason):
        pypw85.write(tmp_path / f"a.{suffix}", system)
    with pytest.raises(ValueError, match="there are no frames"):
        pypw85.write(tmp_path / f"a.{suffix}", [])
    with pytest.raises(ValueError, match="there are no particles"):
        pypw85.write(tmp_path / f"a.{suffix}", pypw85.System(np.empty((0, 3)), np.empty((0, 6))))
    assert not list(tmp_path.iterdir())


def test_ids_are_whole_numbers():
    make = lambda ids: pypw85.System.from_axes(np.zeros((2, 3)), np.ones((2, 3)), [[1, 0, 0, 0]] * 2, ids=ids)  # noqa: E731
    assert make([3.0, 4.0]).ids.dtype.kind == "i"
    for ids in ([1.5, 2], ["a", "b"], [1e20, 2], [np.nan, 1]):
        with pytest.raises(TypeError, match="ids must be integers"):
            make(ids)


def test_gsd_says_what_is_lost(tmp_path):
    def warnings_of(system):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            pypw85.write(tmp_path / "a.gsd", system)
        return " ".join(str(one.message) for one in caught)

    exact = random_system()
    assert warnings_of(exact) == ""
    assert warnings_of(random_system(ids=1 + 2 * np.arange(40))).count("GSD has no ids") == 1
    assert "periodic" in warnings_of(random_system(periodic=(True, True, False)))
    exact.shapeless = 3
    assert "3 particles without a shape are left out" in warnings_of(exact)
    axes = exact.semi_axes, exact.quaternions
    moved = pypw85.System.from_axes(exact.centers + 0.1, *axes, cell=exact.cell, origin=exact.origin, ids=exact.ids)
    assert "single precision: positions change by up to " in warnings_of(moved)
    # Within the unit cell of length 4, half a unit in the last place of single precision is 2⁻²³.
    change = np.abs(pypw85.read(tmp_path / "a.gsd").centers - moved.wrapped()).max()
    assert 0 < change <= 2.0**-23
    for scale in (1e45, 1e-60):
        far = pypw85.System.from_axes(scale * exact.centers, scale * exact.semi_axes, axes[1], cell=scale * exact.cell)
        with pytest.raises(ValueError, match="beyond single precision"):
            pypw85.write(tmp_path / "a.gsd", far)


def test_hdf5_has_what_changes_from_frame_to_frame(tmp_path):
    """Dumps are not sorted: ids and types of the first frame are not those of the others; and the corner may move."""
    first = random_system(1, count=5, step=1)
    second = random_system(2, count=5, step=2, ids=[9, 8, 7, 6, 5], types=[5, 4, 3, 2, 1], origin=[1, 2, 3])
    pypw85.write(tmp_path / "a.h5", [first, second])
    for found, expected in zip(pypw85.frames(tmp_path / "a.h5"), (first, second)):
        for name in ("ids", "types", "origin", "step"):
            np.testing.assert_array_equal(getattr(found, name), getattr(expected, name), err_msg=name)
    names = [random_system(count=2, types=["a", "b"]), random_system(count=2, types=["a", "longer"])]
    pypw85.write(tmp_path / "a.h5", names)
    assert list(pypw85.read(tmp_path / "a.h5", 1).types) == ["a", "longer"]
    without_cell = pypw85.System(first.centers, first.q)
    for other in (random_system(count=5, periodic=False), without_cell, random_system(count=5, types=list("abcde"))):
        with pytest.raises(ValueError, match="choose frames"):
            pypw85.write(tmp_path / "b.h5", [first, other])


def test_size_of_hdf5(tmp_path):
    pypw85.write(tmp_path / "a.h5", random_system(count=200))
    assert (tmp_path / "a.h5").stat().st_size < 100_000
    pypw85.write(tmp_path / "b.h5", [random_system(count=200)] * 30)
    numbers = 30 * 200 * (3 + 3 + 4 + 1 + 1)
    assert (tmp_path / "b.h5").stat().st_size < 1.3 * 8 * numbers + 50_000


def test_steps_come_back(tmp_path):
    for suffix in SUFFIXES.values():
        pypw85.write(tmp_path / f"a.{suffix}", random_system(step=12))
        assert pypw85.read(tmp_path / f"a.{suffix}").step == 12, suffix


def test_plain_xyz(file):
    path = file("2\nwater, isn't it\nO 0 0 0\nH 3 0 0.5\n2\n\nO 0 0 1\nH 3 0 2\n", "a.xyz")
    first, second = pypw85.frames(path, shapes={"*": (1, 1, 1)})
    np.testing.assert_array_equal(first.centers, [[0, 0, 0], [3, 0, 0.5]])
    np.testing.assert_array_equal(second.centers, [[0, 0, 1], [3, 0, 2]])
    assert (list(first.types), first.cell) == (["O", "H"], None)
    velocities = file('1\nLattice="9 0 0 0 9 0 0 0 9"\nO 1 2 3 4 5 6\n', "b.xyz")
    np.testing.assert_array_equal(pypw85.read(velocities, shape=(1, 1, 1)).cell, 9 * np.eye(3))


def test_csv_of_a_spreadsheet(file):
    """A byte order mark, ends of lines as of Windows, and quotation marks."""
    text = '\ufeff"x","y","z","radius","type"\r\n1,2,3,"1","a ""b"", c"\r\n4,5,6,1,d\r\n'
    system = pypw85.read(file(text, "a.csv"))
    np.testing.assert_array_equal(system.centers, [[1, 2, 3], [4, 5, 6]])
    assert list(system.types) == ['a "b", c', "d"]


def test_names_do_not_move_columns(file):
    """A blank of Unicode is one to NumPy, too, and no part of a name."""
    text = "1\nProperties=species:S:1:pos:R:3:radius:R:1\na\u00a0b 1 2 3 1\n"
    with pytest.raises(pypw85.FileError, match="6 columns instead of the 5"):
        pypw85.read(file(text, "a.xyz"))


@pytest.mark.parametrize("suffix", ["dump", "data", "xyz", "csv"])
def test_compressed(suffix, tmp_path, assert_rows, file):
    expected = random_system(step=0)
    path = tmp_path / f"a.{suffix}.gz"
    pypw85.write(path, expected)
    assert_same(pypw85.read(path), expected, assert_rows)
    pypw85.write(tmp_path / f"a.{suffix}", expected)
    content = path.read_bytes()
    assert gzip.decompress(content) == (tmp_path / f"a.{suffix}").read_bytes()
    for broken in (content[:-100], content[:20] + b"\xff" * 20 + content[40:]):
        with pytest.raises(pypw85.FileError, match="what is compressed cannot be read"):
            list(pypw85.frames(file(broken, "b.gz")))


@pytest.mark.parametrize("suffix", ["dump", "xyz"])
def test_compressed_frames_one_after_the_other(suffix, tmp_path, monkeypatch):
    """The start of the file is decompressed three times, to recognise it, to find frames, to read them, not for each frame."""
    opened = []
    original = gzip.open
    monkeypatch.setattr(gzip, "open", lambda *arguments: opened.append(original(*arguments)) or opened[-1])
    pypw85.write(tmp_path / f"a.{suffix}.gz", [random_system(seed, step=seed) for seed in range(20)])
    assert [system.step for system in pypw85.frames(tmp_path / f"a.{suffix}.gz")] == list(range(20))
    assert len(opened) <= 4
    assert pypw85.read(tmp_path / f"a.{suffix}.gz", -1).step == 19


def test_formats_that_are_not_compressed(tmp_path, file):
    for suffix in ("gsd", "h5", "vtk"):
        with pytest.raises(pypw85.FileError, match="is not written compressed"):
            pypw85.write(tmp_path / f"a.{suffix}.gz", random_system())
    pypw85.write(tmp_path / "a.gsd", random_system())
    with pytest.raises(pypw85.FileError, match="compressed files of the format gsd are not read"):
        pypw85.read(file(gzip.compress((tmp_path / "a.gsd").read_bytes()), "b.gz"))


CORPUS = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "fuzz"


def test_corpus():
    """Files that were hard to read: each is read or refused, in little memory."""
    done = subprocess.run([sys.executable, CORPUS / "fuzz_files.py"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count(": ok") == len(list((CORPUS / "files").iterdir())) > 50


REFUSED = {
    "external.h5": "is a link to another file, which is not followed",
    "external_storage.h5": "position is in another file, which is not read",
    "virtual.h5": "position is in another file, which is not read",
    "circle.h5": "lead in a circle",
    "circle_of_groups.h5": "no /particles/.../position",
    "empty_group.h5": "no /particles/.../position",
    "empty_element.h5": "position is neither a data set nor a group",
    "words.h5": "position must have numbers",
    "large_id.h5": "id must have whole numbers",
    "boundary.h5": "attribute boundary",
    "claims.h5": "claims more than its .* bytes can hold",
    "type_out_of_range.gsd": "particle 1 has the type 7, but there are 1",
    "many_particles.gsd": "says that it has 4000000000 particles",
    "shape_is_a_list.gsd": "type 0 is not an ellipsoid",
    "shape_of_words.gsd": "type 0 is not an ellipsoid",
    "shape_nan.gsd": "has a length that is not finite",
    "long_line.xyz.gz": "longer than 1048576 bytes",
    "twice.data": "line 12: the id 1 is there twice",
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name):
    """With the file, what is wrong, and where; frames are not those of another file."""
    path = CORPUS / "files" / name
    with pytest.raises(pypw85.FileError, match=REFUSED[name]) as raised:
        list(pypw85.frames(path, shapes={"*": (1, 1, 1)}))
    assert str(raised.value).startswith(str(path))


def test_two_dimensions_of_hoomd():
    """The box may have a height, which is no period."""
    assert pypw85.read(CORPUS / "files" / "flat.gsd").periodic == (True, True, False)


def test_messages_can_be_printed(file):
    with pytest.raises(pypw85.FileError) as raised:
        pypw85.read(file("x,y,z,radius\n1,2,\x1b[2J,1\n", "a\nb.csv"))
    assert str(raised.value).isprintable() and r"\x1b[2J" in str(raised.value)
    with pytest.warns(UserWarning) as warned:
        system = pypw85.read(file("x,y,z,\x9bradius (mm),name\x1b[2J\n1,2,3,4,5\n", "a.csv"), shape_columns=3 * ["\x9bradius (mm)"])
    assert r"\x1b[2J" in system.source and all(map(str.isprintable, [system.source, *system.notes, str(warned[0].message)]))


@pytest.fixture(params=SUFFIXES.values())
def output(request, tmp_path):
    """Writes a file, and gives what it should be."""
    system = random_system(step=0)
    pypw85.write(tmp_path / f"expected.{request.param}", system)
    return lambda path: pypw85.write(path, system, next(k for k, v in SUFFIXES.items() if v == request.param)), request.param


def test_links_are_followed(output, tmp_path):
    write, suffix = output
    (tmp_path / "folder").mkdir()
    target = tmp_path / "folder" / f"target.{suffix}"
    (tmp_path / "link").symlink_to(target)
    for _ in range(2):  # to what is not there yet, and to what is
        write(tmp_path / "link")
        assert (tmp_path / "link").is_symlink() and not target.is_symlink()
        assert len(pypw85.read(target)) == 40
    assert [entry.name for entry in (tmp_path / "folder").iterdir()] == [target.name]
    (tmp_path / "circle").symlink_to("circle")
    with pytest.raises(OSError, match="symbolic links"):
        write(tmp_path / "circle")


@pytest.mark.parametrize("mode", [0o600, 0o664, 0o640])
def test_mode_is_kept(output, mode, tmp_path):
    write, suffix = output
    path = tmp_path / f"a.{suffix}"
    path.touch()
    path.chmod(mode)
    write(path)
    assert path.stat().st_mode & 0o7777 == mode and path.stat().st_size


def test_pipes_and_devices_stay(output, tmp_path):
    """A pipe gets what a file would hold; nothing takes its place."""
    write, suffix = output
    os.mkfifo(tmp_path / "pipe")
    with subprocess.Popen(["cat", tmp_path / "pipe"], stdout=subprocess.PIPE) as reader:
        write(tmp_path / "pipe")
        (tmp_path / f"got.{suffix}").write_bytes(reader.stdout.read())
    assert (tmp_path / "pipe").is_fifo()
    assert len(pypw85.read(tmp_path / f"got.{suffix}")) == 40


@pytest.fixture
def device(tmp_path):
    """Makes a device of one's own: a mistake must not replace one of the machine."""

    def make(minor):
        path = tmp_path / f"device{minor}"
        try:
            os.mknod(path, stat.S_IFCHR | 0o666, os.makedev(1, minor))
            path.open("wb").close()
        except PermissionError:
            pytest.skip("only root makes devices, and not in all file systems")
        return path

    return make


@pytest.mark.skipif(sys.platform != "linux", reason="numbers of devices are those of Linux")
def test_devices_stay(output, device, tmp_path):
    write, _ = output
    null, full = device(3), device(7)
    (tmp_path / "link").symlink_to(null)
    for path in (null, tmp_path / "link"):
        write(path)
    with pytest.raises(OSError, match="No space left on device: .*device7"):
        write(full)
    assert null.is_char_device() and full.is_char_device() and (tmp_path / "link").is_symlink()


def test_output_that_cannot_be_written(output, tmp_path, monkeypatch):
    """Is refused before the first system is asked for."""
    _, suffix = output

    def systems():
        pytest.fail("there was work")
        yield

    name = next(k for k, v in SUFFIXES.items() if v == suffix)
    (tmp_path / "file").touch()
    for path, kind in [("no/where", FileNotFoundError), ("file/a", NotADirectoryError), (".", IsADirectoryError),
                       ("new/", IsADirectoryError)]:  # fmt: skip
        with pytest.raises(kind):
            pypw85.write(f"{tmp_path}/{path}", systems(), name)
    monkeypatch.setattr(os, "access", lambda *_: False)
    for path in ("file", "new"):
        with pytest.raises(PermissionError):
            pypw85.write(tmp_path / path, systems(), name)


def test_what_was_there_stays_whole(tmp_path):
    """If writing fails in the middle."""
    path = tmp_path / "a.dump"
    path.write_text("precious")

    def systems():
        yield random_system()
        raise RuntimeError("in the middle")

    with pytest.raises(RuntimeError):
        pypw85.write(path, systems())
    assert path.read_text() == "precious"
    assert list(tmp_path.iterdir()) == [path]


def test_formats_that_cannot_hold_it(tmp_path):
    rotated = random_system(cell=CELL.T.copy())
    with pytest.raises(ValueError, match="lower triangular"):
        pypw85.write(tmp_path / "a.dump", rotated)
    with pytest.raises(ValueError, match="one frame"):
        pypw85.write(tmp_path / "a.csv", [rotated, rotated])
    with pytest.raises(ValueError, match="another number of particles"):
        pypw85.write(tmp_path / "a.h5", [rotated, random_system(count=3)])
    with pytest.raises(pypw85.FileError, match="no format has this suffix"):
        pypw85.write(tmp_path / "a.txt", rotated)
    assert not list(tmp_path.iterdir())
