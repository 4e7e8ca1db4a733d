# SPDX-License-Identifier: BSD-3-Clause
"""All messages of the package: each is provoked by a test of this session, and has the form that readers expect.

The plugin raised_errors records them, and runs this module last. A new `raise` needs a test that provokes it. A line in FILES, MESHES or
CALLS is enough.
"""

import errno
import importlib.util
import os
import pathlib
import re
import types
import typing

import numpy as np
import pytest

import pypw85
import raised_errors
from systems import command

# Packages without which single tests are skipped, and their messages not provoked
PACKAGES = ("click", "gsd", "h5py", "matplotlib", "meshio", "scipy", "torch", "zstandard")
# Tests that build other interpreters and wheels are tests of their own in Meson.
APART = {"test_interpreter.py", "test_wheel.py"}
# Messages of what no test can bring about in every session, each with the reason
EXCEPTED = {
    "_device.py: _no_device(name)": "the device fails while it computes",
    "_mesh_files.py: meshio cannot read it": "depends on the version of meshio",
    "_meshes.py: Mesh: ": "not enough memory",
    "_random_addition.py: random_addition: ": "not enough memory",
    "cli/_progress.py: KeyboardInterrupt": "Ctrl-C, which tests send to other processes",
}  # fmt: skip
# What a message must not have: the end of a sentence, several blanks or lines, and what Python says of its own objects
WRONG_FORM = re.compile(r"\.$|^$|\n|\bshould \w+|(?<!there )\bis no (?!longer)[a-z]|<class |<built-in|\barray\(|\bdtype\(| at 0x")


DATA = ("x\n\n2 atoms\n1 ellipsoids\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms # ellipsoid\n\n1 1 1 1 1 1 1\n2 1 0 1 5 5 5"
        "\n\nEllipsoids\n\n1 1 2 3 1 0 0 0\n")  # fmt: skip
LABELS = "\n\nAtom Type Labels\n\n1 A\n2 A\n\nAtoms"
XYZ = "1\nProperties=pos:R:3:radius:R:1"
SEED = "Geometry: ellipsoid\nposition: (0, 0, 0)\n"
DS9 = "# Region file format: DS9\n"
PLY = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
TABLE = "x,y,z,a,b,c,qw,qx,qy,qz\n0,0,0,1,1,2,1,0,0,0\n"
# Files that cannot be read: name, content, options, and the message
FILES = [
    ("a.reg", DS9 + "image\n", {}, "there are no regions"),
    ("a.reg", DS9 + "image\nbox(1,2,3,4,0)\n", {}, r"'box\(1,2,3,4,0\)' is not an ellipse or circle"),
    ("a.reg", DS9 + "fk5\ncircle(1,2,3)\n", {}, "the regions are in the system 'fk5'"),
    ("a.reg", DS9 + "image\ncircle(1,2,3\")\n", {}, "units other than pixels"),
    ("a.reg", DS9 + "image\nellipse(1,2,3,4,5,6,0)\n", {}, "is an annulus of several"),
    ("a.data", DATA + "\nEllipsoids\n\n1 1 2 3 1 0 0 0\n", {}, "line 18: there are several sections Ellipsoids"),
    ("a.data", DATA.replace("1 ellipsoids\n", ""), {}, "the header does not say how many ellipsoids there are"),
    ("a.data", DATA.replace("1 ellipsoids", "1 ellipsoids\n2 atom types").replace("\n\nAtoms", LABELS), {}, "occurs twice in the section"),
    ("a.data", DATA.replace("Ellipsoids\n\n", "Ellipsoids\n"), {}, "an empty line must follow Ellipsoids, because LAMMPS skips a line"),
    ("a.data", DATA.replace("1 1 2 3", "3 1 2 3"), {}, "there is no atom 3: remove this ellipsoid"),
    ("a.data", DATA.replace("1 1 2 3", "1 1 2 0"), {}, "an ellipsoid must have positive lengths"),
    ("a.data", DATA.replace("1 1 2 3 1 0 0 0", "1 1 2 3 1 0 0 0 4 2"), {}, "block1 is not 2: this is a superellipsoid"),
    ("a.data", DATA.replace("# ellipsoid", "# hybrid").replace("1 1 1 1 1 1 1", "1 1 1 1 1 0 3"), {},
     "no column of the section Atoms has 1"),
    ("a.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
               "ITEM: ENTRIES c_1\n1\n", {}, "this is a dump of pairs"),
    ("a.txt", SEED.replace("ellipsoid", "box") + "a: 1\n", {"format": "microstructpy"}, "the seed is of the geometry 'box'"),
    ("a.txt", "\n", {"format": "microstructpy"}, "there are no seeds"),
    ("a.txt", SEED + "a: -1\nb: 1\nc: 1\n", {"format": "microstructpy"}, "must be a finite number > 0, not '-1'"),
    ("a.txt", SEED + "axes: (1, 0, 1)\n", {"format": "microstructpy"}, "the semi-axes of a seed must be finite numbers > 0, not 0"),
    ("a.txt", SEED.replace("ellipsoid", "sphere"), {"format": "microstructpy"}, "the radius of a sphere must be 1 number, and is missing"),
    ("a.txt", SEED + "axes: (1, 1, 1)\nmatrix: 1 0 0 0 1 0 0 0 1\nrot_seq: ((z, 1.0))\n", {"format": "microstructpy"}, "all give the"),
    ("a.bin", b"\0\0\0\0", {"format": "splats"}, "the file must be a .splat, or have the mark of .ply or .spz at its start"),
    ("a.spz", b"\x1f\x8b\x08\0\0\0\0\0", {"format": "splats"}, "what is compressed cannot be read"),
    ("a.xyz", "1\nProperties=species:S:1:radius:R:1\nA 1\n", {}, "the property pos is missing"),
    ("a.xyz", "1\nProperties=pos:S:3:radius:R:1\nA B C 1\n", {}, "holds names: choose columns of numbers"),
    ("a.xyz", XYZ + ' Lattice="1e200 0 0 0 1 0 0 0 1"\n1 2 3 1\n', {}, "the cell has a vector beyond"),
    ("a.xyz", XYZ + ' Lattice="9 0 0 0 9 0 0 0 9" Origin="inf 0 0"\n1 2 3 1\n', {}, "the corner of the cell must be three numbers"),
    ("a.csv", "x,y,z,a,b,c,phi,theta,psi\n0,0,0,1,1,2,inf,0,0\n", {"euler": "ZXZ", "angle": "degrees"}, "has a phi that is not finite"),
    ("a.csv", TABLE, {"convention": "opencv"}, "--convention opencv needs columns such as"),
    ("a.csv", TABLE, {"polar": ("u", "v")}, "there is no column 'u'"),
    ("a.csv", "x,y,z,radius\n", {}, "there are no particles"),
]  # fmt: skip
# Meshes that cannot be read
MESHES = [
    ("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "row 0: vertices must be finite"),
    ("a.obj", "v 0 0 0\n", "has no triangles"),
    ("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", r"the face \[0, 1, 2\] must have indices of the 2 vertices"),
    ("a.obj", "v 0 0 0\nf 1 1\n", "line 2: a face must have three or more numbers of vertices, not '1 1'"),
    ("a.obj", "surf 0 1 0 1\n", "line 1: free-form surfaces have no triangles"),
    ("a.stl", b"\0" * 84, "a binary STL file of 0 triangles must have 84 bytes"),
    ("a.stl", "solid\nfacet\nvertex 0 0 0\nfacet\n", "line 4: the facet before must have 3 vertices, not 1"),
    ("a.stl", "solid\nfacet\nvertex 0 0\n", "line 3: a vertex must have three numbers, not 'vertex 0 0'"),
    ("a.stl", "solid\nfacet\nvertex 0 0 0\n", "the file ends within a facet"),
    ("a.ply", "ply\nformat ascii 1.0\nelement dot 0\nproperty float x\nend_header\n", "must have an element 'vertex', not only dot"),
    ("a.ply", PLY + "property list uchar int w\nend_header\n0 0 0 0\n", "the element vertex has the list 'w'"),
    ("a.ply", PLY.replace("ascii", "binary_little_endian").replace("vertex 1", "vertex 0") + "element face 2\n"
              "property list uchar uchar vertex_indices\nproperty uchar red\nend_header\n\1\0\0\2\0\0",
     "must all have the same number of vertices"),
]  # fmt: skip
SPLATS = "ply\nformat ascii 1.0\nelement vertex 1\n" + "".join(f"property float {name}\n" for name in (
    "x", "y", "z", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"))  # fmt: skip
FILES += [
    ("a.ply", SPLATS + "end_header\n0 0 0 a 0 0 1 0 0 0\n", {}, "line 15: '0 0 0 a 0 0 1 0 0 0' must be numbers"),
    ("a.ply", SPLATS + "end_header\n0 0 0\n", {}, "line 15: the line must have 10 numbers, not 3"),
    ("a.ply", SPLATS.replace("float rot_3", "list uchar float rot_3") + "end_header\n0 0 0 0 0 0 1 0 0 0\n", {},
     "the element 'vertex' has lists"),
]  # fmt: skip


COMPRESSED = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "fuzz/files/splat_transform.compressed.ply"
SPHERES = {"centers": [[0, 0, 0]], "semi_axes": [[1, 1, 1]], "quaternions": [[1, 0, 0, 0]]}


def sphere(**others):
    return pypw85.System.from_axes(**SPHERES, **others)


def of_euler(euler="z", angle="radians", angles=((0.0,),)):
    return pypw85.System.from_euler([[0, 0, 0]], [[1, 1, 1]], euler, angles, angle)


def forces(rows):
    q = [[1.0, 0, 0, 1, 0, 1]] * 2
    derivatives = pypw85.contact_derivatives_pairs([[0, 1]], [[0, 0, 0], [1, 0, 0]], q)
    changed = {name: getattr(derivatives, name)[:rows] for name in ("d_r12", "d_rot1", "d_rot2")}
    return pypw85.contact_forces_pairs([[0, 1]], [[0, 0, 0], [1, 0, 0]], [1.0], derivatives._replace(**changed))


class OnGPU:
    __cuda_array_interface__: typing.ClassVar = {"shape": (1, 2), "typestr": "<i4", "data": (0, False), "version": 3}


# Calls that are refused: the call, and the message
CALLS = [
    (lambda path: pypw85.System([[0, 0, 0]] * 2, [[1, 0, 0, 1, 0, 1]]), "2 centers, but 1 form"),
    (lambda path: of_euler("zz"), "System.from_euler: euler must be one to three of xyz .* or of XYZ .*, no two alike .*, not 'zz'"),
    (lambda path: of_euler("zx"), "the sequence zx must have 2 angles for each particle"),
    (lambda path: of_euler(angle="turns"), "angle must be 'radians' or 'degrees', not 'turns'"),
    (lambda path: pypw85.System.from_directions([[0, 0, 0]], 1, 2, [[0, 0, 0]]), "directions must be finite and not zero"),
    (lambda path: sphere(dimensions=2).draw(path / "a.png", color="type"), "ellipses in a plane have colours by their angles"),
    (lambda path: pypw85.contact_pairs(OnGPU(), [[0, 0, 0]], [[1, 0, 0, 1, 0, 1]], out=()), "'out' is not supported for arrays on a GPU"),
    (lambda path: forces(0), "the derivatives must have 1 rows, one for each pair"),
    (lambda path: pypw85.voxels(sphere(), 2), "voxels need a cell: pass cell"),
    (lambda path: pypw85.voxels(sphere(cell=9 * np.eye(3)), 2**18), "not enough memory for 262144³ voxels: use a smaller"),
    (lambda path: pypw85.write(path / "a.vtk", [sphere()] * 2), "a VTK file holds one frame: choose one with --frames"),
    (lambda path: pypw85.write(path / "a.data", [sphere(cell=9 * np.eye(3))] * 2), "a data file of LAMMPS holds one frame"),
    (lambda path: pypw85.write(path / "a.data", sphere(cell=9 * np.eye(3), origin=[1e20, 0, 0])),
     "is so far from 0 that rounding would change"),
    (lambda path: pypw85.write(path / "a.txt", sphere(), "microstructpy"), "the format microstructpy is only read: choose one of"),
    (lambda path: pypw85.write(path / "a.gsd", sphere(step=-1)), "GSD has no negative time steps, as -1"),
    (lambda path: pypw85.read(COMPRESSED, scales="log"), "the scales of compressed PLY files are always logarithms: leave out --scales"),
    (lambda path: pypw85.read("/dev/null"), "/dev/null: is not a regular file: copy its content into one"),
]  # fmt: skip


def made(path, content):
    path.write_bytes(content if isinstance(content, bytes) else content.encode("latin-1"))
    return path


@pytest.mark.parametrize("name, content, options, message", FILES, ids=[message for *_, message in FILES])
def test_files_that_are_refused(name, content, options, message, tmp_path):
    with pytest.raises(pypw85.FileError, match=message):
        pypw85.read(made(tmp_path / name, content), **options)


@pytest.mark.parametrize("call, message", CALLS, ids=[message for _, message in CALLS])
def test_calls_that_are_refused(call, message, tmp_path):
    with pytest.raises((TypeError, ValueError), match=message):
        call(tmp_path)


def gsd_file(path, **chunks):
    """Writes a GSD file of one particle with other chunks."""
    gsd = pytest.importorskip("gsd.fl")
    schema = chunks.pop("schema", "hoomd")
    with gsd.open(str(path), "w" if hasattr(pytest.importorskip("gsd.hoomd"), "Frame") else "wb", "test", schema, [1, 4]) as file:
        for name, values in {"particles/N": np.array([1], np.uint32), **chunks}.items():
            file.write_chunk(name, values)
        file.end_frame()
    return path


@pytest.mark.parametrize("chunks, message", [
    ({"schema": "other"}, "the schema of this GSD file is 'other', not that of HOOMD-blue"),
    ({"particles/N": np.zeros(0, np.uint32)}, r"cannot be read \(.*\): the file is broken; write it again"),
    ({"particles/types": np.zeros((1, 2), np.float64)}, "particles/types must be text"),
    ({"particles/position": np.zeros((2, 3), np.float32)}, r"particles/position must have the shape \(1, 3\), not \(2, 3\), of numbers"),
])  # fmt: skip
def test_gsd_files_that_are_refused(chunks, message, tmp_path):
    with pytest.raises(pypw85.FileError, match=message):
        pypw85.read(gsd_file(tmp_path / "a.gsd", **chunks), shape=(1, 1, 1))


def without_values(file, name, shape):
    del file[name]
    file.create_dataset(name, shape=shape, dtype="f8", chunks=shape)


def replaced(file, name, values):
    del file[name]
    file[name] = values


class NoMemory:
    """A GSD file with chunks larger than the memory."""

    def chunk_exists(self, frame, name):
        return True

    def read_chunk(self, frame, name):
        raise MemoryError


def test_gsd_files_of_runs(tmp_path):
    gsd = pytest.importorskip("pypw85.formats.gsd")
    with pytest.raises(pypw85.FileError, match="has 1 frame, and had 2 at the checkpoint: bring back the trajectory of this run"):
        gsd.Growing(str(gsd_file(tmp_path / "a.gsd")), 2)
    with pytest.raises(pypw85.FileError, match="particles/N needs more memory than there is"):
        gsd._Chunks("a.gsd", NoMemory(), 0)


def test_files_of_runs(tmp_path, monkeypatch):
    runs = pytest.importorskip("pypw85.cli._runs")
    with pytest.raises(pypw85.FileError, match="No such file or directory: name a file in another folder"):
        runs._open_locked("run.h5", str(tmp_path / "none" / "lock"))
    file = runs._open_locked("run.h5", str(tmp_path / "lock"))
    with pytest.raises(pypw85.FileError, match="another process is at work on this run: wait for its end, or interrupt it"):
        runs._open_locked("run.h5", str(tmp_path / "lock"))
    os.close(file)
    run = types.SimpleNamespace(path=str(tmp_path / "run.h5"))
    with pytest.raises(pypw85.FileError, match="No space left on device: "), runs.Run._explaining(run, run.path):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_folders_that_cannot_be_written(tmp_path, monkeypatch):
    def refused(**others):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr("tempfile.TemporaryDirectory", refused)
    with pytest.raises(PermissionError, match=r"Permission denied: '.*a\.csv'"):
        pypw85.write(tmp_path / "a.csv", sphere())


@pytest.mark.parametrize("change, message", [
    (lambda file: replaced(file, "particles/all/position/step", [0.5, 1.5]), "position/step must be whole numbers"),
    (lambda file: replaced(file, "particles/all/position/step", [0]), "position/step has 1 frame, fewer than there are positions"),
    (lambda file: replaced(file, "particles/all/orientation/value", [[[1.0, 0, 0, 0]]]), "has 1 frame, fewer than there are positions"),
    (lambda file: without_values(file, "particles/all/semi_axes/value", (2, 1, 3)), "was never written: write the file again"),
])  # fmt: skip
def test_hdf5_files_that_are_refused(change, message, tmp_path):
    h5py = pytest.importorskip("h5py")
    pypw85.write(tmp_path / "a.h5", [sphere()] * 2)
    with h5py.File(tmp_path / "a.h5", "a") as file:
        change(file)
    with pytest.raises(pypw85.FileError, match=message):
        pypw85.read(tmp_path / "a.h5", 1)


def test_hdf5_files_of_ellipses(tmp_path):
    h5py = pytest.importorskip("h5py")
    pypw85.write(tmp_path / "a.h5", sphere(dimensions=2))
    with h5py.File(tmp_path / "a.h5", "a") as file:
        replaced(file, "particles/all/semi_axes/value", [[[1.0, 2.0]]])
    with pytest.raises(pypw85.FileError, match="there are two lengths, which are those of ellipses: three dimensions need three"):
        pypw85.read(tmp_path / "a.h5", dimensions=3)


@pytest.mark.parametrize("name, content", [
    ("a.xyz", XYZ + "\n1 2 3 1\n"),
    ("a.dump",
     "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id x y z radius\n1 1 1 1 1\n"),
])  # fmt: skip
def test_files_that_become_shorter(name, content, tmp_path):
    """The frame is located first, and read when it is asked for."""
    frames = pypw85.frames(made(tmp_path / name, 2 * content))
    next(frames)
    made(tmp_path / name, content)
    with pytest.raises(pypw85.FileError, match="the file has become shorter"):
        list(frames)


@pytest.mark.parametrize("call, sentence", [
    ("draw two.xyz a.png", "there are no particles: choose another frame with --frames"),
    ("plot new.h5 a.png", "has no samples yet: they are in it when the run has ended or was interrupted"),
])  # fmt: skip
def test_calls_of_the_command_that_are_refused(call, sentence, tmp_path, capsys, monkeypatch):
    h5py = pytest.importorskip("h5py")
    monkeypatch.chdir(tmp_path)
    made(tmp_path / "two.xyz", XYZ.replace("1", "0", 1) + "\n" + XYZ + "\n1 2 3 1\n")
    with h5py.File("new.h5", "w") as file:
        file.create_group("pw85_mc")
    outcome = command(capsys, monkeypatch, *call.split())
    assert outcome.status == 2 and sentence in outcome.err


@pytest.mark.parametrize("name, content, message", MESHES, ids=[message for *_, message in MESHES])
def test_meshes_that_are_refused(name, content, message, tmp_path):
    pytest.importorskip("meshio")
    with pytest.raises(ValueError, match=message):
        pypw85.Mesh.read(made(tmp_path / name, content))


def is_whole(session):
    """Returns whether all tests of the package run in this session, on the packages that they need."""
    config, here = session.config, pathlib.Path(__file__).parent
    if not getattr(config, "is_recorded", False) or raised_errors.SKIPPED or config.option.keyword or config.option.markexpr:
        return False
    files = {path.name for path in here.glob("test_*.py")} - APART
    return files <= {item.path.name for item in session.items} and all(map(importlib.util.find_spec, PACKAGES))


def test_each_message_is_provoked(request):
    if not is_whole(request.session):
        pytest.skip("only part of the tests runs, or a package is missing")
    silent = {key for key, messages in raised_errors.RAISED.items() if not messages}
    unreached, unused = sorted(silent - set(EXCEPTED)), sorted(set(EXCEPTED) - silent)
    assert not unreached, "no test provokes these messages:\n" + "\n".join(unreached)
    assert not unused, "these messages are provoked now, or gone: remove them from the exceptions:\n" + "\n".join(unused)


def test_form_of_messages():
    wrong = [(key, one) for key, messages in raised_errors.RAISED.items() for one in messages if WRONG_FORM.search(one)]
    assert not wrong
