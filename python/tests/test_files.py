"""Files of other programs: what is written is read again, conventions, and what is said of broken files."""

import numpy as np
import pytest

import pypw85
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
    expected = random_system(step=0)
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
    with pytest.raises(pypw85.FileError, match="no such frame"):
        pypw85.read(path, 4)


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


@pytest.mark.parametrize("columns", ["c_shape[1] c_shape[2] c_shape[3] c_shape[4] c_shape[5] c_shape[6] c_shape[7]",
                                     "c_diameter[1] c_diameter[2] c_diameter[3] "
                                     "c_orient[1] c_orient[2] c_orient[3] c_orient[4]"])  # fmt: skip
def test_columns_of_computes(file, columns):
    text = changed("shapex shapey shapez quatw quati quatj quatk", columns)
    np.testing.assert_array_equal(pypw85.read(file(text)).semi_axes, [[1, 2, 3], [1, 1, 1]])


def test_named_columns(file):
    path = file(changed("shapex shapey shapez quatw quati quatj quatk", "v_1 v_2 v_3 d_4 d_5 d_6 d_7"))
    with pytest.raises(pypw85.FileError, match="no shapes"):
        pypw85.read(path)
    system = pypw85.read(path, shape_columns=["v_1", "v_2", "v_3"], quaternion_columns=["d_4", "d_5", "d_6", "d_7"])
    np.testing.assert_array_equal(system.semi_axes, [[1, 2, 3], [1, 1, 1]])


def test_options(file):
    path = file(DUMP.format(step=5))
    system = pypw85.read(path, lengths="radii", quaternion="xyzw", cell=7 * np.eye(3), periodic=(False, False, True))
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
    "word for a number": (changed("1 2 3", "1 abc 3"), 10, r"column 4 \(y\) should be a number, not 'abc'"),
    "position not a number": (changed("1 2 3", "1 nan 3"), 10, "particle 7 has a position that is not finite"),
    "infinite position": (changed("4 5 6", "4 5 inf"), 11, "particle 9 has a position that is not finite"),
    "zero axis": (changed("2 4 6", "2 0 6"), 10, "particle 7 has a length that is not positive"),
    "negative axis": (changed("2 4 6", "2 -4 6"), 10, "particle 7 has a length that is not positive"),
    "axis not a number": (changed("2 4 6", "2 nan 6"), 10, "particle 7 has a length that is not positive"),
    "zero quaternion": (changed("1 0 0 0", "0 0 0 0"), 10, "particle 7 has a quaternion that is zero"),
    "quaternion not a number": (changed("1 0 0 0", "nan 0 0 0"), 10, "particle 7 has a quaternion that is zero or not"),
    "quaternion of length 2": (changed("1 0 0 0", "2 0 0 0"), 10, "particle 7 has a quaternion whose length is not 1"),
    "no shapes": (changed("2 4 6", "0 0 0").replace("2 2 2", "0 0 0"), None, "no particle has a shape"),
    "no columns of shapes": (changed("shapex", "a"), None, "there are no shapes"),
    "no orientations": (changed("quatw", "a"), 10, "is no sphere, but has no orientation"),
    "no positions": (changed("x y z", "a b c"), 9, "no columns x y z"),
    "an id that is no integer": (changed("\n7 1", "\n7.5 1"), 10, "'id' should be a whole number"),
    "no particles": (changed("ATOMS\n2\n", "ATOMS\n0\n").split("7 1")[0], None, "no particles"),
    "number of particles not a number": (changed("ATOMS\n2\n", "ATOMS\ntwo\n"), 4, "the number of particles should be"),
    "box not a number": (changed("0 10", "0 ten"), 6, "bounds of the box should be 2 numbers"),
    "flat box": (changed("0 10", "0 0"), None, "zero or not finite"),
    "infinite box": (changed("0 10", "0 inf"), None, "zero or not finite"),
    "more lines than particles": (changed("ATOMS\n2\n", "ATOMS\n1\n"), 11, "more lines than particles"),
    "no header": ("ITEM: ATOMS id x y z\n1 2 3 4\n", 1, "missing"),
    "bytes that are no text": (DUMP.format(step=5).encode().replace(b"1 2 3", b"1 \xff\xfe 3"), 10, "should be a number"),
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
    ("a.xyz", "1\nhello\nA 1 2 3\n", "not recognised"),
    ("a.xyz", "2\nProperties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\n", "truncated"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:2:radius:R:1\nA 1 2 1\n", "has 2 columns instead of 3"),
    ("a.xyz", '1\nProperties=species:S:1:pos:R:3:radius:R:1 Lattice="1 2\nA 1 2 3 1\n', "quotation mark"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:3:radius:R:1 Lattice=1,2\nA 1 2 3 1\n", "Lattice should be 9 numbers"),
    ("a.xyz", "1\nProperties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\nB 1 2 3 1\n", "more lines than particles"),
    ("a.csv", "x,y,z,a,b,c\n1,2,3,1,2,3\n", "no orientation"),
    ("a.csv", "x,y,z,radius\n1,2,3\n", "3 columns instead of 4"),
    ("a.csv", "x,y,z,radius\n1,2,3,\n", r"column 4 \(radius\)"),
    ("a.csv", "x,y,z,radius\n", "no particles"),
    ("a.csv", "# cell 1 0 0\nx,y,z,radius\n1,2,3,1\n", "cell should be 9 numbers"),
    ("a.csv", "# cell 1 0 0 0 1 0 1 1 0\nx,y,z,radius\n1,2,3,1\n", "lie in a plane"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n", "bounds of the box are missing"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n", "no section Atoms"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # sphere\n\n1 1 1 1 0 0 0\n", "atom_style sphere"),
    ("a.data", "x\n\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms\n\n1 1 1 1 0 0 0\n", "no shapes"),
    ("a.dat", "hello", "format is not recognised"),
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


def test_hdf5_without_particles(tmp_path):
    import h5py

    with h5py.File(tmp_path / "a.h5", "w") as out:
        out["positions"] = np.zeros((3, 3))
    with pytest.raises(pypw85.FileError, match="no /particles/.../position"):
        pypw85.read(tmp_path / "a.h5")
    with h5py.File(tmp_path / "a.h5", "w") as out:
        out["particles/all/position"], out["particles/all/semi_axes"] = np.zeros((3, 3)), np.ones((2, 3))
    with pytest.raises(pypw85.FileError, match="semi_axes should have the shape"):
        pypw85.read(tmp_path / "a.h5")


def test_no_file_and_a_directory(tmp_path):
    with pytest.raises(FileNotFoundError):
        pypw85.read(tmp_path / "missing")
    with pytest.raises(pypw85.FileError, match="is a directory"):
        pypw85.read(tmp_path)


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
    with pytest.raises(pypw85.FileError, match="no format has such names"):
        pypw85.write(tmp_path / "a.txt", rotated)
    assert not list(tmp_path.iterdir())
