# SPDX-License-Identifier: BSD-3-Clause
"""Files of other programs: read as their programs mean them, or refused with what decides; and files that those programs read."""

import importlib.metadata
import os
import pathlib
import shutil
import subprocess
import warnings

import click
import numpy as np
import pytest

import pypw85
from systems import random_system

FILES = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "fuzz" / "files"

# The smallest μ of each file, from closed forms, and what is said to have been taken.
READ = {
    "compute_q.dump": (0.375, "lengths c_diameter[1..3] as diameters, quaternions c_q[1..4] as w x y z"),
    "quatxyzw.dump": (0.375, "quaternions quatw quatx quaty quatz as w x y z"),
    "ovito_names.dump": (0.375, "lengths AsphericalShape.X AsphericalShape.Y AsphericalShape.Z as radii"),
    "sphere_by_radius.dump": (0.75, "radius where these are 0"),
    "flat.dump": (4 / 3, "as diameters"),
    "zero_shape_and_radius.xyz": (0.5, "lengths aspherical_shape[1..3] as radii, radius where these are 0"),
    "anisoap.xyz": (0.375, "lengths c_diameter[1..3] as diameters, quaternions c_q[1..4] as w x y z"),
    "hybrid_write_data.data": (0.4 / 1.17, "as diameters"),
    "general_triclinic.data": (0.5, "as diameters"),
    "comments.data": (0.5, "as diameters"),
    "unnormalised.data": (0.375, "quaternions quatw quati quatj quatk as w x y z"),
    "schema2_double.gsd": (1 + 0.5e-12, "lengths of type_shapes as radii"),
    "rods_and_spheres.csv": (2.0, "lengths a b c as radii, quaternions qw qx qy qz as w x y z"),
    "semicolon.csv": (0.75, "lengths a b c as radii"),
    "dream3d.csv": (0.75, "sequence ZXZ (axes that rotate with the body)"),
    "seeds.txt": (1.2, "rot_seq as degrees about axes of the body"),
    "splats.ply": (0.375, "one standard deviation, as radii"),
}


def read(name, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pypw85.read(FILES / name, **options)


@pytest.mark.parametrize("name", READ)
def test_read(name):
    system = read(name)
    mu, source = READ[name]
    # The angles of DREAM.3D and the lengths of splats have single precision.
    np.testing.assert_allclose(system.check().smallest_mu, mu, rtol=1e-6 if name in ("dream3d.csv", "splats.ply") else 1e-14)
    assert source in system.source


REFUSED = {
    "orient_ijkw.dump": r"line 9: c_orient\[1..4\] is x y z w for OVITO and moltemplate, and w x y z for others: .*--quaternion xyzw",
    "liggghts_superquadric.dump": "line 11: particle 2 is not an ellipsoid, but a superquadric with blockiness1 8",
    "circumscribed_radius.dump": "radius may be that of the circumscribed sphere",
    "hybrid_nohint.data": "line 12: the third column must be the flag 0 or 1 .*, not 2: .* hybrid",
    "flag_row_missing.data": "line 13: the atom 2 has the flag 1, but there is none for it in the section Ellipsoids",
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name):
    with pytest.raises(pypw85.FileError, match=REFUSED[name]):
        read(name)


@pytest.mark.parametrize("options, mu", [({"quaternion": "xyzw"}, 0.375), ({"quaternion": "wxyz"}, 1.5),
                                         ({"quaternion_columns": [f"c_orient[{k}]" for k in (4, 1, 2, 3)]}, 0.375)])  # fmt: skip
def test_what_the_message_advises_decides(options, mu):
    np.testing.assert_allclose(read("orient_ijkw.dump", **options).check().smallest_mu, mu, rtol=1e-14)


def test_shapes_for_circumscribed_radii():
    assert read("circumscribed_radius.dump", shape=(2, 2, 4)).check().smallest_mu == 0.75
    assert read("circumscribed_radius.dump", shape_columns=3 * ["radius"]).check().smallest_mu == 1.5 / 4


def dump(columns, *rows):
    head = f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{len(rows)}\nITEM: BOX BOUNDS ff ff ff\n" + 3 * "-9 9\n"
    return f"{head}ITEM: ATOMS {columns}\n" + "".join(row + "\n" for row in rows)


# Half of what the columns hold, or all of it, and the quaternion (w, x, y, z) of the columns 0.6 0 0.8 0
@pytest.mark.parametrize("columns, share, quaternion", [
    ("shapex shapey shapez quati quatj quatk quatw", 0.5, [0, 0.6, 0, 0.8]),
    ("shapex shapey shapez quat1 quat2 quat3 quat4", 1, [0.6, 0, 0.8, 0]),
    ("AsphericalShape.X AsphericalShape.Y AsphericalShape.Z quati quatj quatk quatw", 1, [0, 0.6, 0, 0.8]),
    ("c_shape[1] c_shape[2] c_shape[3] c_q[1] c_q[2] c_q[3] c_q[4]", 0.5, [0.6, 0, 0.8, 0]),
    ("c_diam[1] c_diam[2] c_diam[3] qx qy qz qw", 0.5, [0, 0.6, 0, 0.8]),
])  # fmt: skip
def test_columns_of_dumps(columns, share, quaternion, tmp_path):
    path = tmp_path / "a.dump"
    path.write_text(dump("id type x y z " + columns, "1 1 0 0 0 1 2 3 0.6 0 0.8 0"))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        system = pypw85.read(path)
    np.testing.assert_array_equal(system.semi_axes, share * np.array([[1, 2, 3]]))
    np.testing.assert_array_equal(system.quaternions, [quaternion])


def test_turned_boxes(tmp_path):
    """LAMMPS turns positions into them, but not the quaternions of computes."""
    text = dump("id type x y z c_q[1] c_q[2] c_q[3] c_q[4] c_diam[1] c_diam[2] c_diam[3]", "1 1 0 0 0 1 0 0 0 1 2 3")
    box = "ITEM: BOX BOUNDS abc origin pp pp pp\n0 9 0 0\n-9 0 0 0\n0 0 9 0\n"
    text = text.replace("ITEM: BOX BOUNDS ff ff ff\n" + 3 * "-9 9\n", box)
    (tmp_path / "a.dump").write_text(text)
    with pytest.raises(pypw85.FileError, match=r"line 9: the box is turned .* not the quaternions c_q\[1\]"):
        pypw85.read(tmp_path / "a.dump")
    (tmp_path / "a.dump").write_text(text.replace("9 0 0\n-9 0 0 0", "0 0 0\n0 9 0 0").replace("\n0 0 0 0\n", "\n9 0 0 0\n"))
    assert pypw85.read(tmp_path / "a.dump").cell.tolist() == [[9, 0, 0], [0, 9, 0], [0, 0, 9]]


def test_neighbours_behind_a_table(tmp_path):
    """As DREAM.3D writes them; the first line says where they begin."""
    text = (FILES / "dream3d.csv").read_text()
    (tmp_path / "a.csv").write_text(text + "Feature_ID,NumNeighbors,NeighborList\n1,1,2\n2,1,1\n")
    assert len(pypw85.read(tmp_path / "a.csv")) == 2


def test_dumps_without_one_kind_of_coordinates(tmp_path):
    """x y zs is not a plane; q is the charge."""
    (tmp_path / "a.dump").write_text(dump("id type x y zs radius", "1 1 0 0 0.5 1", "2 1 0 0 0.7 1"))
    with pytest.raises(pypw85.FileError, match="line 9: there are no columns x y z, but id type x y zs radius"):
        pypw85.read(tmp_path / "a.dump")
    row = "0.5 7 7 8 0 0 0 1 2 3 0.6 0 0.8 0"
    (tmp_path / "a.dump").write_text(dump("id type q c_cm c_px v_px x y z shapex shapey shapez quatw quati quatj quatk", f"1 1 {row}"))
    np.testing.assert_array_equal(pypw85.read(tmp_path / "a.dump").quaternions, [[0.6, 0, 0.8, 0]])


@pytest.mark.parametrize("text", ["<mujoco/>", '<?xml version="1.0"?>\n<!-- a -->\n<robot name="a"/>', "<sdf version='1.9'/>"])
def test_models_of_bodies(text, tmp_path):
    (tmp_path / "a.xml").write_text(text)
    with pytest.raises(pypw85.FileError, match=r"models of bodies \(MJCF, URDF, SDF\) are not read"):
        pypw85.read(tmp_path / "a.xml")


@pytest.mark.parametrize("key", ["rounding_radius", "n"])
def test_shapes_of_gsd_with_other_keys(key, tmp_path):
    with pytest.raises(ValueError, match="not an ellipsoid: .*" + key):
        pypw85.from_gsd([{"type": "Ellipsoid", "a": 1, "b": 2, "c": 3, key: 1}], [0], [[1, 0, 0, 0]])
    pypw85.from_gsd([{"type": "Sphere", "diameter": 1, key: 0}], [0], [[1, 0, 0, 0]])


@pytest.mark.parametrize("name", ["blockiness", "radius", "theta"])
def test_other_elements_of_h5md(name, tmp_path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "a.h5", "w") as file:
        for group in ("first", "second"):
            file[f"particles/{group}/position"], file[f"particles/{group}/semi_axes"] = np.eye(3), np.ones((3, 3))
        file[f"particles/first/{name}"] = np.ones(3)
    with pytest.raises(pypw85.FileError, match=f"the data set {name} could change the shapes .*--ignore-columns {name}"):
        pypw85.read(tmp_path / "a.h5")
    with pytest.warns(UserWarning, match="only the first of the groups first second of /particles is read"):
        assert len(pypw85.read(tmp_path / "a.h5", ignore_columns=[name])) == 3


def test_type_twice(tmp_path):
    """As in examples of LIGGGHTS."""
    (tmp_path / "a.dump").write_text(dump("id type type x y z radius", "1 2 2 0 0 0 1"))
    assert pypw85.read(tmp_path / "a.dump").types.tolist() == [2]


def test_columns_with_two_meanings(tmp_path):
    """Seven columns of one compute: lengths of property/atom, or of smd/tlsph/shape."""
    path = tmp_path / "a.dump"
    path.write_text(dump("id type x y z " + " ".join(f"c_shape[{k}]" for k in range(1, 8)), "1 1 0 0 0 1 2 3 0.6 0 0.8 0"))
    with pytest.raises(pypw85.FileError, match="--lengths diameters or --lengths radii"):
        pypw85.read(path)
    for lengths, share in (("radii", 1), ("diameters", 0.5)):
        system = pypw85.read(path, lengths=lengths)
        np.testing.assert_array_equal(system.semi_axes, share * np.array([[1, 2, 3]]))
        np.testing.assert_array_equal(system.quaternions, [[0.6, 0, 0.8, 0]])


def test_named_columns_mean_what_their_names_say():
    system = read("ovito_names.dump", shape_columns=[f"AsphericalShape.{x}" for x in "XYZ"],
                  quaternion_columns=[f"Orientation.{x}" for x in "XYZW"])  # fmt: skip
    np.testing.assert_allclose(system.check().smallest_mu, 0.375, rtol=1e-14)


@pytest.mark.parametrize("header", ["X;Y;Z;Radius", "x (mm)\ty (mm)\tz (mm)\tradius (mm)", "Points:0,Points:1,Points:2,radius",
                                    "centroid_x|centroid_y|centroid_z|r1|r2|r3", "# x y z r", "x y z diameter"])  # fmt: skip
def test_headers_of_tables(header, tmp_path):
    separator = next(one for one in ";\t,| " if one in header)
    number = "1,5" if separator in ";\t" else "3" if "diameter" in header else "1.5"
    header_columns = header.removeprefix("# ")
    rows = [["0", "0", "0", number], ["0", "0", "2", number]]
    rows = [row + [number] * (header_columns.count(separator) - 3) for row in rows]
    (tmp_path / "a.csv").write_text("\n".join([header, *(separator.join(row) for row in rows)]) + "\n\n")
    np.testing.assert_allclose(pypw85.read(tmp_path / "a.csv").check().smallest_mu, 2 / 3, rtol=1e-15)


def test_two_dimensions(tmp_path):
    """Are never taken for three: not for statistics, not by relaxation, and not on the way through other formats."""
    for name in ("flat.dump", "flat_mixture.gsd", "flat_gas.gsd"):
        system = read(name)
        assert "two-dimensional" in system.source + " ".join(system.notes)
        assert (system.dimensions, system.periodic) == (2, (True, True, False))
        axes = system.semi_axes
        area = system.cell[0, 0] * system.cell[1, 1]
        assert system.check().packing_fraction == pytest.approx(np.pi * (axes[:, 0] * axes[:, 1]).sum() / area, rel=1e-14)
        assert (system.check().volume, system.check().dimensions) == (area, 2)
        for suffix in ("dump", "data", "gsd", "xyz", "h5", "csv"):
            with warnings.catch_warnings():
                warnings.filterwarnings("error", message=".*dimensional")
                warnings.filterwarnings("ignore", message=".*(numbered|one shape|single precision)")
                pypw85.write(tmp_path / f"a.{suffix}", system)
            again = read(tmp_path / f"a.{suffix}")
            assert again.dimensions == 2
            np.testing.assert_array_equal(again.centers - again.origin, system.centers - system.origin)
            np.testing.assert_array_equal(again.q, system.q)
            np.testing.assert_array_equal(again.cell, system.cell)
    assert read("flat.dump", dimensions=3).check().overlaps == 2
    with pytest.raises(pypw85.FileError, match="do not lie in one plane of z"):
        read("comments.data", dimensions=2)


def test_double_precision_in_gsd(tmp_path, assert_rows):
    """Keeps all bits, as the file that came from HOOMD-blue has them; the schema is that of HOOMD-blue 7."""
    import gsd.fl

    random = np.random.default_rng(5)
    system = random_system()
    system = pypw85.System.from_axes(
        random.uniform(-2, 2, (40, 3)), random.uniform(0.1, 0.2, (40, 3)), random.normal(size=(40, 4)), cell=4 / 3 * np.diag([3, 4, 5]),
        origin=-2 / 3 * np.array([3, 4, 5]), ids=np.arange(40))  # fmt: skip
    system.centers[0] = np.nextafter(-system.origin, 0)  # within the cell, but rounding moves it out
    for given in (system, read("schema2_double.gsd")):
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*one shape for each type")
            warnings.filterwarnings("error", message=".*single precision")
            pypw85.write(tmp_path / "a.gsd", given, precision="double")
        again = pypw85.read(tmp_path / "a.gsd")
        for name in ("centers", "semi_axes", "quaternions"):
            a, b = getattr(again, name), getattr(given, name)
            assert_rows((a == b).all(axis=1), a, b)
        np.testing.assert_array_equal(again.cell, given.cell)
    is_old = tuple(map(int, importlib.metadata.version("gsd").split(".")[:2])) < (2, 8)
    mode = "rb" if is_old else "r"
    with gsd.fl.open(str(tmp_path / "a.gsd"), mode) as file:
        assert (file.schema, file.schema_version) == ("hoomd", (2, 0))
    with pytest.raises(pypw85.FileError, match="leave out --precision"):
        pypw85.write(tmp_path / "a.xyz", system, precision="double")


def test_gsd_reads_what_was_written(tmp_path):
    hoomd = pytest.importorskip("gsd.hoomd")
    system = random_system(step=7)
    pypw85.write(tmp_path / "a.gsd", [system, system])
    with hoomd.open(str(tmp_path / "a.gsd"), "r" if hasattr(hoomd, "Frame") else "rb") as file:
        snapshot = file[1]
    assert (snapshot.configuration.step, snapshot.configuration.dimensions, snapshot.particles.N) == (7, 3, 40)
    np.testing.assert_array_equal(snapshot.particles.position, system.centers.astype(np.float32))
    shapes = [snapshot.particles.type_shapes[k] for k in snapshot.particles.typeid]
    np.testing.assert_array_equal([[shape[name] for name in "abc"] for shape in shapes], system.semi_axes)


def test_ase_reads_dumps(tmp_path):
    io = pytest.importorskip("ase.io", reason="the Debian package python3-ase is missing")
    system = random_system()
    pypw85.write(tmp_path / "a.dump", [system, system])
    frames = io.read(tmp_path / "a.dump", index=":", format="lammps-dump-text")
    assert len(frames) == 2
    np.testing.assert_allclose(frames[1].positions, system.centers, atol=1e-14)


def test_pandas_reads_and_writes_tables(tmp_path):
    pandas = pytest.importorskip("pandas")
    system = random_system()
    pypw85.write(tmp_path / "a.csv", pypw85.System.from_axes(system.centers, system.semi_axes, system.quaternions))
    table = pandas.read_csv(tmp_path / "a.csv", float_precision="round_trip")
    np.testing.assert_array_equal(table[["x", "y", "z"]], system.centers)
    table.rename(columns={"x": "Center X", "y": "Center Y", "z": "Center Z", "qw": "q0", "qx": "q1", "qy": "q2", "qz": "q3"}).to_csv(
        tmp_path / "b.csv", sep=";", decimal=",")  # fmt: skip
    again = pypw85.read(tmp_path / "b.csv")
    for name in ("centers", "semi_axes", "quaternions"):
        np.testing.assert_array_equal(getattr(again, name), getattr(system, name))


@pytest.mark.parametrize("is_binary", [True, False])
def test_meshio_writes_splats(is_binary, tmp_path):
    meshio = pytest.importorskip("meshio")
    system = random_system()
    values = {f"scale_{k}": np.log(system.semi_axes[:, k]) for k in range(3)} | {f"rot_{k}": 3 * system.quaternions[:, k] for k in range(4)}
    meshio.ply.write(tmp_path / "a.ply", meshio.Mesh(system.centers, [], point_data=values), binary=is_binary)
    again = pypw85.read(tmp_path / "a.ply")
    np.testing.assert_array_equal(again.centers, system.centers)
    # exp() of log() errs by a unit of the logarithm, which is up to 1.4 here, and by one of its own.
    np.testing.assert_allclose(again.semi_axes, system.semi_axes, rtol=8 * 2.0**-53)
    np.testing.assert_allclose(again.quaternions, system.quaternions, atol=1e-7)  # which are units only in single precision


def test_ase_reads_and_writes_extended_xyz(tmp_path):
    io = pytest.importorskip("ase.io", reason="the Debian package python3-ase is missing")
    system = random_system(types=["Fe"] * 40)
    pypw85.write(tmp_path / "a.xyz", system)
    atoms = io.read(tmp_path / "a.xyz", format="extxyz")
    np.testing.assert_array_equal(atoms.arrays["aspherical_shape"], system.semi_axes)
    np.testing.assert_array_equal(atoms.arrays["orientation"], np.roll(system.quaternions, -1, axis=1))
    np.testing.assert_array_equal(atoms.cell, system.cell)
    del atoms.arrays["aspherical_shape"], atoms.arrays["orientation"]
    for k in range(3):
        atoms.arrays[f"c_diameter[{k + 1}]"] = 2 * system.semi_axes[:, k]
    atoms.arrays["c_q"] = system.quaternions
    io.write(tmp_path / "b.xyz", atoms, format="extxyz")
    again = pypw85.read(tmp_path / "b.xyz")
    # ASE writes 8 decimals.
    for name in ("centers", "semi_axes", "quaternions"):
        np.testing.assert_allclose(getattr(again, name), getattr(system, name), atol=1e-8)


def test_species_for_ase(tmp_path):
    """ASE knows chemical elements alone."""
    io = pytest.importorskip("ase.io", reason="the Debian package python3-ase is missing")
    data = pytest.importorskip("ase.data")
    from pypw85.cli import pw85
    from pypw85.formats import xyz

    assert set(data.chemical_symbols) == xyz._ELEMENTS
    pypw85.write(tmp_path / "a.csv", random_system())
    said = r"ASE \(3.22 to 3.28\) reads only .* and not 1, 2: .*--species 1:H"
    with pytest.warns(UserWarning, match=said):
        assert pw85.main(["convert", str(tmp_path / "a.csv"), str(tmp_path / "a.xyz")], standalone_mode=False) == 0
    with pytest.raises(KeyError):
        io.read(tmp_path / "a.xyz", format="extxyz")
    command = ["convert", str(tmp_path / "a.csv"), str(tmp_path / "a.xyz"), "--species"]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert pw85.main([*command, "1:He,2:fe"], standalone_mode=False) == 0
    atoms = io.read(tmp_path / "a.xyz", format="extxyz")
    assert atoms.get_atomic_numbers().tolist() == [{1: 2, 2: 26}[one] for one in random_system().types]
    with pytest.raises(pypw85.FileError, match="there is no type 3, but 1 2: use one of these"):
        pw85.main([*command, "3:H"], standalone_mode=False)
    for wrong in ("1", "1:", ":H", "1:H,1:He"):
        with pytest.raises(click.BadParameter, match="must be different types and their names"):
            pw85.main([*command, wrong], standalone_mode=False)


def test_h5md_of_the_specification(tmp_path):
    """What H5MD 1.1 asks for: author, creator, and steps and times that all elements share."""
    h5py = pytest.importorskip("h5py")
    system = random_system()
    pypw85.write(tmp_path / "a.h5", [with_step(system, 5), with_step(system, 9)])
    with h5py.File(tmp_path / "a.h5") as file:
        assert file["h5md"].attrs["version"].tolist() == [1, 1] and file["h5md/author"].attrs["name"]
        assert (file["h5md/creator"].attrs["name"], file["h5md/creator"].attrs["version"]) == ("pypw85", pypw85.__version__)
        for name in ("position", "orientation", "semi_axes", "box/edges"):
            element = file["particles/all"][name]
            assert element["step"][:].tolist() == [5, 9] and element["time"][:].tolist() == [5.0, 9.0], name
            assert element["time"] == file["particles/all/position/time"]


def with_step(system, step):
    return pypw85.System.from_axes(system.centers, system.semi_axes, system.quaternions, cell=system.cell, step=step)


def test_mdanalysis_reads_h5md(tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        mda = pytest.importorskip("MDAnalysis", reason="the Debian package python3-mdanalysis is missing")
        system = random_system()
        pypw85.write(tmp_path / "a.h5md", [with_step(system, 5), with_step(system, 9)])
        universe = mda.Universe.empty(len(system), trajectory=False)
        universe.load_new(str(tmp_path / "a.h5md"), format="H5MD", convert_units=False)
        times = []
        for frame in universe.trajectory:
            times.append(frame.time)
            np.testing.assert_allclose(frame.positions, system.centers, rtol=1e-6)
            np.testing.assert_allclose(frame.triclinic_dimensions, system.cell, rtol=1e-5, atol=1e-5)
    assert times == [5, 9]


@pytest.mark.parametrize("name", ["a.xyz", "a.dump", "a.gsd"])
def test_partners_read_what_is_converted(name, tmp_path):
    """What the command makes of an HDF5 file, in ASE and gsd."""
    from pypw85.cli import pw85

    system = random_system(types=["Fe"] * 40)
    pypw85.write(tmp_path / "in.h5", system)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert pw85.main(["convert", str(tmp_path / "in.h5"), str(tmp_path / name)], standalone_mode=False) == 0
    if name == "a.gsd":
        gsd = pytest.importorskip("gsd.hoomd")
        with gsd.open(str(tmp_path / name), "rb") as file:
            places = file[0].particles.position
    else:
        io = pytest.importorskip("ase.io", reason="the Debian package python3-ase is missing")
        places = io.read(tmp_path / name, format="extxyz" if name == "a.xyz" else "lammps-dump-text").positions
    assert len(places) == 40 and np.ptp(places, axis=0).min() > 0
    shift = (places - system.centers).mean(axis=0)  # HOOMD-blue's origin is in the middle of the box
    np.testing.assert_allclose(places - shift, system.centers, atol=1e-5)


DUMPS = """pair_style zero 1.5
pair_coeff * *
compute q all property/atom quatw quati quatj quatk
compute diameter all property/atom shapex shapey shapez
dump d all custom 1 c.dump id type x y z c_q[*] c_diameter[*]
dump_modify d format float %.17g
run 0
"""


@pytest.mark.skipif(shutil.which("lmp") is None, reason="LAMMPS is not installed")
def test_lammps_reads_and_writes_data(tmp_path):
    """Ids from 0, and tilts that LAMMPS refuses; it writes what it has read, also in a hybrid style."""
    cell = np.array([[6, 0, 0], [5, 6, 0], [-4, 4.5, 6]])
    system = pypw85.System.from_axes((np.arange(60).reshape(20, 3) % 7) / 7 @ cell, np.tile([0.25, 0.5, 0.75], (20, 1)),
                                     np.tile([0.6, 0, 0.8, 0], (20, 1)), cell=cell, ids=np.arange(20))  # fmt: skip
    with pytest.warns(UserWarning, match="ids of LAMMPS are different numbers from 1"):
        pypw85.write(tmp_path / "a.data", system)
    overlaps = system.check().overlaps
    for style in ("ellipsoid", "hybrid ellipsoid dipole", "hybrid molecular ellipsoid"):
        # The columns of other styles are those of the manual of LAMMPS.
        text = (tmp_path / "a.data").read_text()
        if style != "ellipsoid":
            text = as_hybrid(text, "dipole" in style)
        (tmp_path / "b.data").write_text(text)
        commands = f"units lj\natom_style {style}\nread_data b.data\nwrite_data c.data\n" + DUMPS
        done = subprocess.run(["lmp", "-in", "/dev/stdin", "-log", "none"], input=commands, cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0 and "ERROR" not in done.stdout, done.stdout
        for name in ("b.data", "c.data"):
            again = pypw85.read(tmp_path / name)
            assert (len(again), again.check().overlaps) == (20, overlaps) and overlaps > 0
            np.testing.assert_allclose(np.sort(again.semi_axes, axis=1), np.sort(system.semi_axes, axis=1), rtol=1e-15)
        assert pypw85.read(tmp_path / "c.dump").check().overlaps == overlaps


def as_hybrid(text, is_dipole):
    """The section Atoms of hybrid styles: id type x y z, then the columns of each style."""
    lines = text.splitlines()
    first = lines.index("Atoms # ellipsoid")
    lines[first] = "Atoms # hybrid"
    for k in range(first + 2, lines.index("Ellipsoids") - 1):
        number, kind, flag, density, *place = lines[k].split()
        others = [flag, density, "0", "0", "0", "1"] if is_dipole else ["3", flag, density]
        lines[k] = " ".join([number, kind, *place, *others])
    return "\n".join(lines) + "\n"


# A type of points beside ellipsoids, as LAMMPS writes it since 4 Feb 2025 and before
POINTS = ["1 1 0 0 0 1 1 4 1 0 0 0", "2 2 0 0 1 1 1 1 1 0 0 0", "3 2 0 0 9 1 1 1 1 0 0 0"]


@pytest.mark.parametrize("columns", ["shapex shapey shapez quatw quati quatj quatk",
                                     "c_shape[1] c_shape[2] c_shape[3] c_q[1] c_q[2] c_q[3] c_q[4]"])  # fmt: skip
def test_points_of_lammps(columns, tmp_path):
    path = tmp_path / "a.dump"
    path.write_text(dump("id type x y z " + columns, *POINTS))
    with pytest.warns(UserWarning, match="all 2 particles of the type 2 have the shape 1 1 1 .* leave points out \\(--points 2\\)"):
        assert pypw85.read(path).check().overlaps == 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system = pypw85.read(path, points=["2"])
    assert (system.ids.tolist(), system.shapeless) == ([1], 0) and "2 particles of the type 2 left out as points" in system.source
    for points, reason in ((["3"], "there is no type 3, but 1 2: use one of these"), (["1", "2"], "all particles have the type 1 2")):
        with pytest.raises(pypw85.FileError, match=reason):
            pypw85.read(path, points=points)
    # A sphere of the same type is no point; and nobody asks where all are spheres, or turned.
    for rows in ([*POINTS, "4 2 0 0 20 2 2 2 1 0 0 0"], POINTS[1:], [POINTS[0], POINTS[1].replace("1 0 0 0", "0 1 0 0")],
                 [row.replace("1 1 1 1 0 0 0", "0 0 0 0 0 0 0") for row in POINTS]):  # fmt: skip
        path.write_text(dump("id type x y z " + columns, *rows))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            pypw85.read(path)


def test_superquadrics_without_exponents(tmp_path):
    (tmp_path / "a.dump").write_text(dump("id x y z shapex shapey shapez quat1 quat2 quat3 quat4", "1 0 0 0 1 1 2 1 0 0 0"))
    with pytest.warns(UserWarning, match="there are no columns blockiness1 and blockiness2: superquadrics of LIGGGHTS are taken as ellip"):
        pypw85.read(tmp_path / "a.dump")


def test_points_without_types(tmp_path):
    (tmp_path / "a.dump").write_text(dump("id x y z radius", "1 0 0 0 1"))
    with pytest.raises(pypw85.FileError, match="the particles have no types: leave out --points"):
        pypw85.read(tmp_path / "a.dump", points=["2"])
