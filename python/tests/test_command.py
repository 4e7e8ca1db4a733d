# SPDX-License-Identifier: BSD-3-Clause
"""The command pw85: what it prints and writes, its statuses, and one sentence for bad input."""

import errno
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

import numpy as np
import pytest

import pypw85
from pypw85 import cli
from systems import PW85, SUFFIXES, on_terminal, random_system


def all_images(system, reach=2):
    """Contacts of all pairs and all images, one pair at a time: {(id, id, image): μ²}."""
    found = {}
    n = len(system)
    grid = [tuple(image) for image in (np.mgrid[(slice(-reach, reach + 1),) * 3].reshape(3, -1).T).tolist()]
    for i in range(n):
        for image in grid:
            first = i if image > (0, 0, 0) else i + 1
            r12 = system.centers[first:] + np.array(image) @ system.cell - system.centers[i]
            mu2 = pypw85.contact(r12, system.q[i], system.q[first:])[0]
            found |= {(i, first + k, *image): value for k, value in enumerate(mu2.tolist())}
    return found


def test_every_format_gives_the_same_table(run, folder):
    system = random_system(step=0)
    tables = set()
    for name, suffix in SUFFIXES.items():
        system.ids = np.arange(40) + (name == "lammps-data")
        pypw85.write(f"a.{suffix}", system)
        done = run("check", f"a.{suffix}", "--csv", "contacts.csv")
        assert (done.status, done.err) == (1, "")
        first, *rest = done.out.splitlines()
        assert first.startswith(f"a.{suffix}: {name}, lengths ") and "quaternions" in first
        if name != "lammps-data":  # whose ids begin with 1
            tables.add(("\n".join(rest), (folder / "contacts.csv").read_text()))
    assert len(tables) == 1


@pytest.mark.parametrize("periodic", [True, False])
def test_against_all_images(run, folder, periodic):
    system = random_system(count=20, periodic=periodic)
    expected = all_images(system, 2 if periodic else 0)
    pypw85.write("a.dump", system)
    done = run("check", "a.dump", "--csv", "c.csv", "--below", 1.5)
    rows = np.loadtxt("c.csv", delimiter=",", skiprows=1)
    found = {}
    for row in rows:
        i, j, image, mu = int(row[2]), int(row[3]), row[4:7].astype(int), row[7]
        if (i, *-image) > (j, *image) or i > j:
            i, j, image = j, i, -image
        if i == j and tuple(image) < (0, 0, 0):
            image = -image
        found[(i, j, *image.tolist())] = mu**2
    wanted = {key: value for key, value in expected.items() if value < 1.5**2}
    assert found.keys() == wanted.keys()
    np.testing.assert_allclose([found[key] for key in wanted], list(wanted.values()), rtol=1e-11)
    overlaps = sum(value < 1 for value in wanted.values())
    assert rows[:, 8].sum() == overlaps
    assert int(done.out.splitlines()[3].split()[5]) == overlaps
    assert done.status == 1


def test_clean_system(run, folder):
    """The smallest μ is found even where no boxes meet."""
    spheres = pypw85.System.from_axes([[0, 0, 0], [6, 0, 0], [0, 7, 0]], np.ones((3, 3)), [[1, 0, 0, 0]] * 3)
    pypw85.write("a.csv", spheres)
    done = run("check", "a.csv", "--json", "a.json")
    assert (done.status, done.err) == (0, "")
    assert "no cell" in done.out
    (frame,) = json.loads((folder / "a.json").read_text())["frames"]
    assert (frame["overlaps"], frame["smallest_mu"], frame["contacts"], frame["cell"]) == (0, 3.0, [], None)
    assert "0 1 2 0 0 0 3 3 0 0 1 0 0".split() in [line.split() for line in done.out.splitlines()]


def test_one_particle(run, folder):
    pypw85.write("a.csv", pypw85.System.from_axes([[0, 0, 0]], [[1, 2, 3]], [[1, 0, 0, 0]]))
    done = run("check", "a.csv")
    assert (done.status, done.out.splitlines()[-1].split()) == (0, ["0", "0", "1", "-", "0", "0", "-"])
    # With its own images
    done = run("check", "a.csv", "--cell", "2.5,9,9", "--worst", 1)
    row = done.out.splitlines()[-1].split()
    assert (done.status, row[:3], row[3].strip("-"), row[4:7]) == (0, ["0", "1", "1"], "1", ["0", "0", "1.25"])


def test_coincident_centres(run, folder):
    pypw85.write("a.csv", pypw85.System.from_axes(np.zeros((2, 3)), np.ones((2, 3)), [[1, 0, 0, 0]] * 2))
    done = run("check", "a.csv", "--json", "a.json")
    assert (done.status, done.err) == (1, "")
    (contact,) = json.loads((folder / "a.json").read_text())["frames"][0]["contacts"]
    assert (contact["mu"], contact["point"]) == (0, [None] * 3)


def test_reports_agree(run, folder):
    import h5py

    pypw85.write("a.gsd", [random_system(seed, step=seed) for seed in range(3)])
    done = run("check", "a.gsd", "--csv", "a.csv", "--json", "a.json", "--hdf5", "a.h5", "--worst", 4)
    assert done.status == 1
    rows = np.loadtxt("a.csv", delimiter=",", skiprows=1)
    with h5py.File("a.h5") as file:
        contacts, frames = file["contacts"][()], file["frames"][()]
    np.testing.assert_array_equal(np.stack([contacts[name] for name in contacts.dtype.names], axis=1), rows)
    data = json.loads((folder / "a.json").read_text())["frames"]
    assert [len(frame["contacts"]) for frame in data] == frames["overlaps"].tolist()
    flat = [[*c["ids"], *c["image"], c["mu"], c["overlap"], *c["point"], *c["normal"]] for f in data for c in f["contacts"]]
    np.testing.assert_array_equal(flat, rows[:, 2:])
    worst = [float(line.split()[6]) for line in done.out.splitlines()[-4:]]
    np.testing.assert_allclose(worst, np.sort(rows[:, 7])[:4], rtol=1e-5)


def test_warnings(run, folder):
    thin = pypw85.System.from_axes([[0, 0, 0]], [[0.1, 0.1, 3]], [[1, 0, 0, 0]], cell=np.eye(3))
    pypw85.write("a.dump", thin)
    text = (folder / "a.dump").read_text().replace("ATOMS\n1\n", "ATOMS\n2\n") + "2 1 0 0 0 0 0 0 1 0 0 0\n"
    (folder / "b.dump").write_text(text)
    done = run("check", "b.dump")
    assert done.status == 1
    first, second = done.err.splitlines()
    assert first == "pw85: warning: b.dump, frame 0: 1 particle without a shape is left out"
    assert second.startswith("pw85: warning: b.dump, frame 0: the cell is so small")


def test_frames(run, folder):
    pypw85.write("a.dump", [random_system(seed, step=seed) for seed in range(5)])
    all_of_them = run("check", "a.dump", "--worst", 0).out.splitlines()[3:]
    assert [line.split()[0] for line in all_of_them] == list("01234")
    assert run("check", "a.dump", "--worst", 0, "--frames", "1::2").out.splitlines()[3:] == all_of_them[1::2]
    assert run("check", "a.dump", "--worst", 0, "--frames", "-1").out.splitlines()[3:] == all_of_them[-1:]
    assert "there is no frame 7: the file has 5 frames, 0 to 4" in run("check", "a.dump", "--frames", "7").err
    assert "there are no frames 7:9: the file has 5 frames, 0 to 4" in run("check", "a.dump", "--frames", "7:9", "--workers", 2).err
    assert all_of_them[0].split()[-1] != "-"


def test_another_number_of_particles(run, folder):
    pypw85.write("a.dump", [random_system(count=40), random_system(count=39)])
    done = run("check", "a.dump")
    assert done.status == 2
    assert "a.dump, frame 1: there are 39 particles, but 40 in the first frame" in done.err
    assert run("check", "a.dump", "--varying").status == 1


def test_workers(folder):
    pypw85.write("a.dump", [random_system(seed, step=seed) for seed in range(6)])
    one, two = (subprocess.run([*PW85, "check", "a.dump", "--workers", str(n)], capture_output=True)
                for n in (1, 2))  # fmt: skip
    assert (one.returncode, two.returncode) == (1, 1), two.stderr
    assert one.stdout == two.stdout
    text = (folder / "a.dump").read_text()
    (folder / "b.dump").write_text(text[:-100])
    bad = subprocess.run([*PW85, "check", "b.dump", "--workers", "2"], capture_output=True)
    assert bad.returncode == 2
    sentence = bad.stderr.split(b"\r")[-1]  # behind the progress
    assert sentence.startswith(b"pw85: b.dump, frame 5, line ") and bad.stderr.count(b"\n") == 1


BAD = [
    (["check", "missing.dump"], "missing.dump: no such file"),
    (["check", "."], ".: is a directory"),
    (["check", "empty"], "empty: the file is empty"),
    (["check", "a.dump", "--csv", "no/where.csv"], "no/where.csv: there is no folder no"),
    (["check", "a.dump", "--format", "gsd"], "no readable GSD file"),
    (["check", "a.dump", "--format", "hdf5"], "no readable HDF5 file"),
    (["check", "a.dump", "--format", "csv"], "there is no column 'x'"),
    (["check", "a.dump", "--format", "xyz"], "a.dump, frame 0, line 1: the number of particles must be here"),
    (["check", "a.dump", "--format", "lammps-data"], "are missing before the first section"),
    (["check", "a.dump", "--frames", "a:b"], "neither a number nor start:stop:step"),
    (["check", "a.dump", "--frames", "::0"], "must not be 0"),
    (["check", "a.dump", "--cell", "1,2"], "must be 3 or 9 finite numbers"),
    (["pack", "a.xyz", "-n", "3", "--fraction", "0.2", "--axes", "1,0,1"], "'1,0,1' must be 3 finite numbers > 0"),
    (["pack", "a.xyz", "-n", "3", "--fraction", "0.2", "--axes", "1,1,1", "--spread", "nan"], "must be a finite number >= 0, not 'nan'"),
    (["check", "a.dump", "--cell", "1,2,nan"], "must be 3 or 9 finite numbers"),
    (["check", "a.dump", "--cell", "0,0,0"], "zero or not finite"),
    (["check", "a.dump", "--shape-columns", "x,y,z,x"], "must name 1 to 3 columns"),
    (["check", "a.dump", "--quaternion-columns", "x"], "must name 4 columns"),
    (["check", "a.dump", "--shape-columns", "x,y,q"], "there is no column 'q'"),
    (["check", "a.dump", "--below", "0"], "--below"),
    (["check"], "Missing argument 'FILE'"),
    (["nonsense"], "No such command 'nonsense'"),
]


@pytest.mark.parametrize("arguments, reason", BAD, ids=[" ".join(arguments) for arguments, _ in BAD])
def test_bad_input(run, folder, arguments, reason):
    pypw85.write("a.dump", random_system())
    (folder / "empty").touch()
    before = set(folder.iterdir())
    done = run(*arguments)
    assert done.status == 2
    assert reason in done.err.splitlines()[-1] and "Traceback" not in done.err
    assert set(folder.iterdir()) == before


def test_no_permission(run, folder, monkeypatch):
    """As if for another user: root may read everything."""

    def refuse(path, *_, **__):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), path)

    pypw85.write("a.dump", random_system())
    monkeypatch.setattr("builtins.open", refuse)
    done = run("check", "a.dump")
    monkeypatch.undo()
    assert (done.status, done.err) == (2, "pw85: a.dump: permission denied: change its permissions, or work on a copy\n")


def test_old_report_stays_whole(run, folder):
    pypw85.write("a.dump", [random_system(), random_system(count=39)])
    (folder / "a.csv").write_text("precious")
    assert run("check", "a.dump", "--csv", "a.csv").status == 2
    assert (folder / "a.csv").read_text() == "precious"


def test_relax_refuses_a_thin_cell(run, folder):
    pypw85.write("a.dump", pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 1]], [[1, 0, 0, 0]], cell=np.diag([9, 9, 1.9])))
    done = run("relax", "a.dump", "b.dump")
    assert done.status == 2
    assert "apart by the length 1.9; with" in done.err and "skip such frames (--frames)" in done.err
    assert not (folder / "b.dump").exists()


NAMES = [
    (["check", "a.dump", "--csv", "no/c.csv"], "no/c.csv: there is no folder no"),
    (["check", "a.dump", "--hdf5", "c.csv/a"], "Not a directory"),
    (["check", "a.dump", "--json", "a.dump"], "a.dump: is the input"),
    (["check", "a.dump", "--csv", "link"], "link: is the input"),
    (["check", "a.dump", "--csv", "new", "--json", "./new"], "./new: is named for two outputs"),
    (["check", "a.dump", "--csv", "c.csv", "--frames", "7"], "there is no frame 7: the file has one frame, 0"),
    (["convert", "a.dump", "a.txt"], "no format has this suffix"),
    # Columns that are not used would be lost.
    (["convert", "a.dump", "a.dump"], "a.dump: is the input: name another file"),
    (["convert", "link", "./a.dump", "--to", "csv"], "a.dump: is the input"),
    (["relax", "a.dump", "link", "--to", "xyz"], "link: is the input"),
    (["convert", "a.dump", "no/a.xyz"], "no/a.xyz: there is no folder no"),
    (["convert", "a.dump", "a.gsd.gz"], "is not written compressed"),
    (["convert", "a.dump", "a.csv", "--frames", "7"], "there is no frame 7: the file has one frame, 0"),
    (["convert", "a.dump", "folder/", "--to", "csv"], "folder/: is a directory: name a file"),
    (["draw", "a.dump", "a.foo"], "a.foo: the name of a picture must end with one of"),
    (["draw", "a.dump", "no/a.png"], "no/a.png: there is no folder no"),
    (["draw", "a.dump", "a.dump.html/b.html"], "there is no folder a.dump.html"),
    (["plot", "a.dump", "a.foo"], "a.foo: the name of a picture must end with one of"),
    (["plot", "a.dump", "no/a.png"], "no/a.png: there is no folder no"),
    (["relax", "a.dump", "no/a.xyz"], "no/a.xyz: there is no folder no"),
    (["pack", "no/a.xyz", "-n", "2", "--axes", "1,1,1", "--fraction", "0.1"], "no/a.xyz: there is no folder no"),
    (["pack", "a.xyz", "-n", "2", "--axes", "1,1,1", "--fraction", "0.1", "--voxels", "a.png"], "must end with .h5, .hdf5 or .vtk"),
    (["pack", "a.xyz", "-n", "2", "--axes", "1,1,1", "--fraction", "0.1", "--voxels", "no/a.h5"], "no/a.h5: there is no folder no"),
]


@pytest.mark.parametrize("arguments, reason", NAMES, ids=[" ".join(arguments) for arguments, _ in NAMES])
def test_bad_names_of_outputs(run, folder, monkeypatch, arguments, reason):
    """Are refused before the work, and nothing is changed."""
    pypw85.write("a.dump", random_system())
    (folder / "c.csv").write_text("precious")
    (folder / "link").symlink_to("a.dump")
    before = {path: path.read_bytes() for path in folder.iterdir()}

    def work(*_, **__):
        pytest.fail("there was work")

    monkeypatch.setattr(sys.modules["pypw85.cli._input"], "load", work)
    monkeypatch.setattr(sys.modules["pypw85.cli.pack"], "pack_system", work)
    done = run(*arguments)
    assert done.status == 2 and reason in done.err and done.err.count("\n") == 1, done
    assert {path: path.read_bytes() for path in folder.iterdir()} == before


def test_what_is_lost_is_said(run, folder):
    """Once, however many frames."""
    pypw85.write("a.dump", [random_system(ids=1 + 2 * np.arange(40), step=step) for step in range(3)])
    done = run("convert", "a.dump", "a.gsd")
    assert (done.status, done.err.splitlines()) == (0, ["pw85: warning: a.gsd, frame 0: GSD has no ids: particles are numbered in "
                                                        "their order, from 0"])  # fmt: skip


def test_far_particles(run, folder):
    """μ² overflows from 1e154 on."""
    (folder / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n1e20,0,0,1\n")
    assert run("check", "a.csv", "--csv", "b.csv", "--below", "1e200").status == 0
    (folder / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n1e270,0,0,1\n")
    done = run("check", "a.csv")
    assert done.status == 2 and "has a position beyond 1e+150" in done.err


@pytest.mark.skipif(not os.path.exists("/proc/self/fd"), reason="there is no such name of an open file")
def test_pipe_as_output(folder):
    """What is written to /dev/stdout goes on; here by a link of one's own, which a mistake may replace."""
    pypw85.write("a.dump", random_system())
    (folder / "stdout").symlink_to("/proc/self/fd/1")
    done = subprocess.run([*PW85, "convert", "a.dump", "stdout", "--to", "csv"], capture_output=True)
    assert done.returncode == 0 and done.stdout.count(b"\n") == 44, done


def test_interruption(folder):
    """Ctrl-C ends at once, and leaves no temporary files."""
    pypw85.write("a.dump", [random_system()] * 1000)
    status, text = on_terminal("check", "a.dump", "--csv", "a.csv", until=rb"[\r\n] +0 +\d")
    assert (status, text.splitlines()[-1]) == (130, "pw85: interrupted")
    assert [path.name for path in folder.iterdir()] == ["a.dump"]


def test_interruption_of_workers(folder):
    """They end without a word: of Python, of its pools or of its tracker of resources."""
    pypw85.write("a.dump", [random_system()] * 1000)
    status, text = on_terminal("check", "a.dump", "--csv", "a.csv", "--workers", "2", until=rb"[\r\n] +0 +\d")
    said = [line.split("\r")[-1] for line in text.split("\n")]
    assert (status, said[-2:]) == (130, ["pw85: interrupted", ""])
    assert all(re.match(r"a\.dump: |cell |frame | *\d+ ", line) for line in said[:-2] if line.strip()), text
    assert [path.name for path in folder.iterdir()] == ["a.dump"]


def test_interruption_keeps_a_packing(folder):
    arguments = ["-n", "100", "--axes", "1,1,1", "--fraction", "0.8", "--voxels", "a.vtk", "--resolution", "8"]
    status, text = on_terminal("pack", "a.data", *arguments, until=rb"step \d+, \d+ pairs overlap")
    left = re.search(r"pw85: interrupted; a\.data: overlaps that remain: (\d+); the file contains the best .*\n$", text)
    assert left and status == 130, text
    assert {path.name for path in folder.iterdir()} == {"a.data", "a.vtk"}
    # Written with 17 digits, so that the very same pairs overlap
    assert len(pypw85.read("a.data").overlaps().mu) == int(left[1]) > 0


def test_interruption_keeps_frames(folder):
    """Frames that were relaxed, and those to which it did not come."""
    centers = np.random.default_rng(1).uniform(0, 6, (60, 3))
    dense = pypw85.System.from_axes(centers, np.ones((60, 3)), [[1, 0, 0, 0]] * 60, cell=6 * np.eye(3))
    pypw85.write("a.dump", [random_system(count=5), dense, random_system(1)])
    status, text = on_terminal("relax", "a.dump", "b.dump", until=rb"step \d+, \d+ pairs overlap")
    assert status == 130 and "b.dump, from frame 1: overlaps that remain" in text, text
    first, second, third = pypw85.frames("b.dump")
    assert len(first.overlaps().mu) == 0 and len(second) == 60
    np.testing.assert_array_equal(third.centers, random_system(1).centers)


def test_progress_is_for_terminals(folder):
    program = [sys.executable, "-c", "import time\nfrom pypw85.cli._progress import progress\nwith progress(): time.sleep(2)"]
    assert "starting [00:0" in on_terminal(program=program)[1]
    done = subprocess.run(program, capture_output=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")


def test_without_tqdm(folder):
    pypw85.write("a.dump", random_system())
    program = [sys.executable, "-c", "import sys; sys.modules['tqdm'] = None\nfrom pypw85.cli import main\nmain()", "check", "a.dump"]
    done = subprocess.run(program, capture_output=True)
    same = subprocess.run([*PW85, "check", "a.dump"], capture_output=True)
    assert (done.returncode, done.stdout, done.stderr) == (same.returncode, same.stdout, b"") == (1, same.stdout, b"")


def test_closed_pipe(folder):
    pypw85.write("a.dump", [random_system()] * 3000)
    command = subprocess.Popen([*PW85, "check", "a.dump"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    command.stdout.readline()
    command.stdout.close()
    errors = command.stderr.read()  # and, if it takes longer than a second, its progress
    assert b"Exception" not in errors and b"Traceback" not in errors, errors.decode()
    assert command.wait(timeout=60) == 141  # not 2, which is bad input


@pytest.mark.parametrize("closed, status", [(">&-", 2), ("2>&-", 0)])
def test_streams_that_are_closed(folder, closed, status):
    """A file that is opened would take the number 1 or 2 of a closed stream."""
    system = pypw85.System.from_axes(3 * np.eye(3), [[0.5, 0.5, 1]] * 3, [[1, 0, 0, 0]] * 3)
    pypw85.write("apart.h5", system)
    done = subprocess.run(["sh", "-c", f'exec "$@" {closed}', "sh", *PW85, "check", "apart.h5", "--csv", "-"], capture_output=True)
    assert done.returncode == status, done
    said = "pw85: the standard output is closed: redirect it to a file, or to /dev/null\n" if status else ""
    assert done.stderr.decode() == said, done
    assert len(done.stdout.splitlines()) == (0 if status else 1), done  # the names of the columns, and nothing of the summary


SLOW = """
import os, time
from pypw85.cli._progress import progress, say
try:
    with progress():
        say("the reader has gone")
        time.sleep(1.5)  # until the progress is shown
except BrokenPipeError:
    os._exit(3)
"""


def test_closed_pipe_of_a_slow_command():
    reader, writer = os.pipe()
    os.close(reader)
    buffered = {**os.environ, "PYTHONUNBUFFERED": ""}
    controller, terminal = os.openpty()  # for the progress
    done = subprocess.run([sys.executable, "-c", SLOW], env=buffered, stdout=writer, stderr=terminal)
    os.set_blocking(controller, False)
    with pytest.raises(BlockingIOError):  # nothing was written
        pytest.fail(os.read(controller, 65536).decode())
    for descriptor in (writer, terminal, controller):
        os.close(descriptor)
    assert done.returncode == 3


def touching_lattice(side):
    """Ellipsoids with μ = 1.05 between nearest neighbours, whose boxes meet: a cubic lattice of spheres under a linear map."""
    linear = np.array([[1, 0.5, 0.5], [0, 1, 0.5], [0, 0, 1]])
    grid = np.stack(np.meshgrid(*[np.arange(side)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    form = (linear @ linear.T)[np.triu_indices(3)]
    return pypw85.System(2.1 * grid @ linear.T, np.tile(form, (side**3, 1)), cell=2.1 * side * linear.T)


# The kernel counts in ru_maxrss what a parent had when it started the process, but not here.
PEAK = """
import pathlib, sys
from pypw85 import cli
sys.argv = ["pw85", "check", "a.dump"]
assert cli._run() == 0
print(pathlib.Path("/proc/self/status").read_text())
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the file with the peak is one of Linux")
def test_memory(folder):
    """The growth between two sizes against what docs/command.rst says.

    A tenth of that is left for memory which the allocator keeps; here it gives back what is more than 128 KiB.
    """
    text = (pathlib.Path(os.environ["PYPW85_SOURCE"]) / "docs" / "command.rst").read_text(encoding="utf-8")
    per_particle, per_pair = map(int, re.search(r"(\d+) bytes for each\s+particle, and (\d+) for each\s+pair", text).groups())
    needed, bound = [], []
    for side in (30, 50):  # larger than the blocks in which files are read
        system = touching_lattice(side)
        pypw85.write("a.dump", system)
        environment = {**os.environ, "MALLOC_MMAP_THRESHOLD_": "131072", "MALLOC_PERTURB_": "0"}  # fill no pages
        done = subprocess.run([sys.executable, "-c", PEAK], capture_output=True, text=True, env=environment)
        needed.append(1024 * int(re.search(r"VmHWM:\s+(\d+) kB", done.stdout)[1]))
        bound.append(per_particle * side**3 + per_pair * len(system.neighbors(1.25)))
    assert 0.5 <= (needed[1] - needed[0]) / (bound[1] - bound[0]) <= 0.9, (needed, bound)


def test_plot_without_pairs(run, folder):
    """The pictures of μ are empty: the command says so."""
    pypw85.write("far.csv", pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 1]], [[1, 0, 0, 0]], cell=9 * np.eye(3)))
    done = run("plot", "far.csv", "a.png", "--reach", 2)
    assert done.status == 0 and "far.csv: no pair has μ < 2, so there is nothing in the plots of μ: use a larger number" in done.err


@pytest.mark.parametrize("name", ["check", "convert", "draw", "mc", "plot", "relax"])
def test_options_for_reading_follow(run, name):
    """The options of the command itself come first; all commands that read a file have the same ones for this, behind them."""
    first, behind = run(name, "--help").out.split("\nOptions for reading the input file:\n")
    options = re.findall(r"^  (--[\w-]+)", behind, re.MULTILINE)
    assert {"--format", "--shape", "--spacing"} <= set(options)
    assert options == re.findall(r"^  (--[\w-]+)", run("check", "--help").out.split("input file:\n")[1], re.MULTILINE)
    assert not [option for option in options if re.search(rf"^  {option}\b(?!-)", first, re.MULTILINE)]
    assert "RANGE" not in first + behind


def test_help(run):
    done = run("check", "--help")
    assert done.status == 0 and "--workers" in done.out
    assert "shows the options of a command, and examples" in run("--help").out
    assert pypw85.version() in run("--version").out


@pytest.mark.parametrize("name", cli.pw85.commands)
def test_examples_of_help(run, folder, name):
    """They are there, on lines of their own, and they work."""
    lines = re.findall(r"^ +(pw85 .*)$", run(name, "--help").out, re.MULTILINE)
    assert lines and all(line.startswith(f"pw85 {name} ") for line in lines)
    systems = [random_system(seed, step=seed) for seed in range(2)]
    pypw85.write("run.dump", systems)
    pypw85.write("grains.xyz", systems[0])
    pypw85.write("packing.xyz", pypw85.pack(np.tile([1, 1, 2], (20, 1)), 0.2, seed=1))
    (folder / "centers.csv").write_text("x,y,z\n1,2,3\n4,5,6\n")
    for line in lines:
        done = run(*shlex.split(line)[1:])
        said = [one for one in done.err.splitlines() if not one.startswith("pw85: warning: ")]
        assert done.status == int(name == "check") and not said, (line, done)


def file_of(name):
    return pathlib.Path(os.environ["PYPW85_SOURCE"]) / "fuzz" / "files" / name


def test_labelled_images(run, folder):
    image = np.zeros((30, 30, 30), dtype=np.int32)
    offsets = np.indices(image.shape) - 14
    image[(offsets[0] / 4) ** 2 + (offsets[1] / 6) ** 2 + (offsets[2] / 10) ** 2 <= 1] = 7
    image[0:2, 0:2, 0:1], image[0, 0, 1] = 9, 9
    np.save(folder / "labels.npy", image)
    done = run("convert", "labels.npy", "out.csv", "--spacing", "0.5")
    assert done.status == 0 and "1 grain is thinner than two pixels" in done.err
    system = pypw85.read(folder / "out.csv")
    assert system.ids.tolist() == [7, 9] and system.dimensions == 3
    np.testing.assert_allclose(system.centers[0], [7, 7, 7], rtol=1e-14)
    np.testing.assert_array_equal(system.q, pypw85.read(folder / "labels.npy", spacing=0.5).q)
    done = run("check", "labels.npy")
    assert done.status == 0 and "labels of an image of 30 × 30 × 30 as ids" in done.out.splitlines()[0]
    assert run("check", "labels.npy", "--spacing", "1,2").status == 2


def test_what_was_taken_is_said(run, folder):
    done = run("check", file_of("compute_q.dump"), "--json", "a.json")
    source = "lengths c_diameter[1..3] as diameters, quaternions c_q[1..4] as w x y z"
    assert done.out.splitlines()[0].endswith(f": lammps-dump, {source}")
    assert json.loads((folder / "a.json").read_text())["frames"][0]["source"] == source
    done = run("check", file_of("compute_q.dump"), "--lengths", "radii", "--json", "a.json")
    assert "c_diameter[1..3] as radii" in done.out and done.status == 1


def test_clean_means_that_all_were_checked(run, folder):
    """Particles without a shape are no reason for status 0, unless they are said to be points."""
    (folder / "a.xyz").write_text("2\nProperties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\nB 3 0 0 0\n")
    done = run("check", "a.xyz")
    assert done.status == 2 and "1 particle without a shape was not checked: give a shape (--shape)" in done.err
    assert run("check", "a.xyz", "--points").status == 0
    assert run("check", "a.xyz", "--points", "--worst", "3").status == 0
    done = run("check", "a.xyz", "--points", "B")
    assert done.status == 0 and "1 particle of the type B left out as points" in done.out.splitlines()[0]
    assert run("check", "a.xyz", "--points", "C").status == 2
    assert run("check", "a.xyz", "--shape", "1,1,1").status == 0
    assert run("check", "a.xyz", "--shape", "2.5,2.5,2.5").status == 1


@pytest.mark.parametrize("workers", [1, 2])
def test_frames_before_a_broken_one(run, folder, workers):
    """Are reported; an empty frame is one of them."""
    text = file_of("empty_frame.dump").read_text()
    (folder / "a.dump").write_text(text + text[:300])
    whole, broken = (run("check", path, "--workers", workers) for path in (file_of("empty_frame.dump"), "a.dump"))
    assert (whole.status, broken.status) == (1, 2)
    assert broken.out.splitlines()[1:5] == whole.out.splitlines()[1:5] and "7       3" in broken.out.splitlines()[-1]
    assert "frame 0: there are no particles" in whole.err
    assert re.search(r"a\.dump, frame 3, line \d+: the file ends", broken.err), broken.err
    (folder / "b.dump").write_text("".join(text.partition("quatk\n")[:2]))
    assert "there are no particles" in run("check", "b.dump").err.splitlines()[-1]
    assert "the chosen frames have no particles: choose others with --frames" in run("plot", "b.dump", "a.png").err.splitlines()[-1]


@pytest.mark.parametrize("name, arguments, reason", [
    ("comments.data", ["--shape-columns", "a,b,c"], "have no named columns: leave out --shape-columns"),
    ("schema2_double.gsd", ["--quaternion-columns", "a,b,c,d"], "have no named columns: leave out --quaternion-columns"),
    ("anisoap.xyz", ["--shape-columns", "a,b,c"], "there is no column 'a', but species pos"),
    ("rods_and_spheres.csv", ["--periodic", "ab"], "there is no cell that could be periodic"),
])  # fmt: skip
def test_options_without_a_use_are_refused(run, folder, name, arguments, reason):
    done = run("check", file_of(name), *arguments)
    assert done.status == 2 and reason in done.err
    done = run("convert", file_of(name), "a.xyz", "--precision", "double")
    assert done.status == 2 and "leave out --precision" in done.err


def test_splats(run, folder):
    for output in ("a.html", "a.png"):
        assert run("draw", file_of("splats.ply"), output).status == 0
    done = run("check", file_of("splats.ply"), "--sigma", "3", "--strict", "--scales", "log")
    assert done.status == 1 and "3 standard deviations, as radii" in done.out.splitlines()[0]
    done = run("check", file_of("good.dump"), "--sigma", "3")
    assert done.status == 2 and "leave it out" in done.err
    done = run("convert", file_of("splats.ply"), "a.xyz", "--species", "0:H")
    assert (done.status, done.err) == (0, "") and len(pypw85.read("a.xyz")) == 2
    done = run("convert", "a.xyz", "a.ply", "--to", "splats")
    assert done.status == 2
