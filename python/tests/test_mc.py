# SPDX-License-Identifier: BSD-3-Clause
"""The command pw85 mc: its files, interruptions, full disks, and one sentence for bad input."""

import errno
import functools
import gzip
import itertools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import pypw85
from pypw85 import formats
from pypw85.cli import _runs as runs, _series
from pypw85.formats import _files
from pypw85.formats import gsd as gsd_files
from systems import PW85, heed_interrupts, of_run, on_terminal, random_system

gsd = pytest.importorskip("gsd")
pytest.importorskip("gsd.hoomd")
h5py = pytest.importorskip("h5py")
resource = pytest.importorskip("resource", reason="there are no limits of processes here")

# Small and dense, at constant pressure, with everything that a run can do
START = pypw85.pack(np.tile([[0.5, 0.5, 1.0], [0.7, 0.7, 0.4]], (12, 1)), 0.35, seed=1, types=np.tile(["rod", "plate"], 12))
START.origin = np.array([-0.5, 0.25, 1.0])
NPT = ["start.xyz", "--pressure", "1.5", "--volume", "triclinic", "--equilibrate", "5", "--every", "5", "--chains", "2", "--reach", "2",
       "--bins", "4", "--trajectory-every", "10"]  # fmt: skip
SWEEPS = "400"
# What is said of start.xyz
TAKEN = "start.xyz: xyz, lengths aspherical_shape[1..3] as radii, quaternions orientation[1..4] as x y z w\n"


@pytest.fixture
def folder(folder):
    pypw85.write("start.xyz", START)
    return folder


def content(path):
    """All data sets and attributes of a file of HDF5, as bytes."""
    found = {}

    def take(name, thing):
        found.update({f"{name}@{key}": np.asarray(value).tobytes() for key, value in thing.attrs.items()})
        if isinstance(thing, h5py.Dataset):
            found[name] = thing.asstr()[()].tolist() if thing.dtype.kind == "O" else thing[()].tobytes()

    with h5py.File(path) as file:
        file.visititems(take)
    return found


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The folder of a run that was not interrupted."""
    folder = tmp_path_factory.mktemp("whole")
    pypw85.write(folder / "start.xyz", START)
    arguments = [*NPT, "--sweeps", SWEEPS, "--out", "run.h5", "--trajectory", "run.dump"]
    done = subprocess.run([*PW85, "mc", *arguments], capture_output=True, text=True, cwd=folder)
    assert (done.returncode, done.stderr) == (0, ""), done
    assert done.stdout.startswith(TAKEN), done
    (folder / "out").write_text(of_run(done.stdout))
    return folder


def same_as(whole, folder="."):
    """Whether the run in a folder has come to the same end."""
    path = pathlib.Path(folder)
    assert content(path / "run.h5") == content(whole / "run.h5")
    return (path / "run.dump").read_bytes() == (whole / "run.dump").read_bytes()


def test_results(whole):
    """Averages, table, trajectory and last configuration belong to each other."""
    with h5py.File(whole / "run.h5") as file:
        group = file["pw85_mc"]
        samples, averages = group["samples"][()], group["averages"][()]
        g, edges = group["pair_correlation/g"][()], group["pair_correlation/edges"][()]
        trials = {move: tuple(counts[()]) for move, counts in group["counts"].items()}
    assert samples["sweep"].tolist() == list(range(5, 401, 5))
    assert averages["name"].astype(str).tolist() == list(samples.dtype.names[1:])
    for name, value, error, _ in averages.tolist():
        np.testing.assert_allclose(value, samples[name.decode()].mean(), rtol=1e-13, err_msg=name.decode())
        assert error > 0 or np.isnan(error) or (error == 0 and (samples[name.decode()] == value).all())
    np.testing.assert_allclose(samples["density"] * samples["volume"], 24, rtol=1e-14)
    assert len(g) == 4 and edges[-1] == 2 and g[0] < 0.5 < g[-1] < 1.5
    assert trials["volume"][0] == 400 and sum(trials[name][0] for name in ("translation", "rotation")) == 400 * 24
    frames = list(pypw85.frames(whole / "run.dump"))
    assert [frame.step for frame in frames] == list(range(10, 401, 10))
    last = pypw85.read(whole / "run.h5")
    assert last.step == 400 and last.types.tolist() == frames[-1].types.tolist() == START.types.tolist()
    np.testing.assert_allclose(frames[-1].q, last.q, rtol=1e-9, atol=1e-12)
    assert all(len(frame.overlaps().mu) == 0 for frame in [*frames, last])
    corner = START.origin @ np.linalg.inv(START.cell)
    np.testing.assert_allclose([frame.origin @ np.linalg.inv(frame.cell) for frame in [*frames, last]], [corner] * 41, atol=1e-12)
    text = (whole / "out").read_text().splitlines()
    assert text[0] == "run.h5: 24 particles, βP = 1.5, seed 1" and text[-1] == "no overlaps after 400 sweeps"
    assert {line.split()[0] for line in text} >= {"density", "nematic_order", "compressibility_chains", "director"}
    units = text.index("units: lengths in the unit L of START, volume in L³, density in L⁻³; other averages are pure numbers")
    v0 = 4 / 3 * np.pi * START.semi_axes.prod(axis=1).mean()
    assert text[units + 1] == f"βP is in L⁻³; βP v0 = {1.5 * v0:.6g}, with the mean volume v0 = {v0:.6g} L³ of a particle"
    assert any(line.split() == "value standard error independent samples".split() for line in text)


def test_old_format(run, folder):
    """A run of 40 sweeps in the first format of its file, which every later version continues."""
    content_of = gzip.decompress(pathlib.Path(__file__).with_name("run_1.h5.gz").read_bytes())
    pathlib.Path("run.h5").write_bytes(content_of)
    with h5py.File("run.h5") as file:
        state, samples = file["pw85_mc/state"][()].tobytes(), file["pw85_mc/samples"][()]
    assert pypw85.HardEllipsoids.restore(state).save() == state and len(samples) == 8
    assert run("mc", "--resume", "run.h5", "--sweeps", 60).status == 0
    with h5py.File("run.h5") as file:
        later = file["pw85_mc/samples"][()]
        assert (later[:8] == samples).all() and later["sweep"].tolist() == list(range(5, 61, 5))


def readers(path):
    return {"resume": lambda: runs.resume(path), "read": lambda: pypw85.read(path), "series": lambda: _series.read_series(path)}


def test_damaged_bytes(whole, folder):
    """Each byte of a run counts, but for the first ones, by which its format is recognised. HDF5 alone reads some files with other bytes,
    and ends the process at others."""
    content_of = (whole / "run.h5").read_bytes()
    for place in np.linspace(8, len(content_of) - 13, 64).astype(int).tolist():
        changed = bytearray(content_of)
        changed[place] ^= 1 << place % 8
        pathlib.Path("run.h5").write_bytes(changed)
        for read in readers("run.h5").values():
            with pytest.raises(pypw85.FileError, match=r"^run\.h5: is damaged, or was changed after pw85 mc had written it: "):
                read()
    pathlib.Path("run.h5").write_bytes(content_of[:-12])  # as of versions before the checksum
    assert content("run.h5") == content(whole / "run.h5") and runs.resume("run.h5").is_finished
    with h5py.File("run.h5", "r+") as file:
        file["pw85_mc/progress"][0] += 1
    with pytest.raises(pypw85.FileError, match="^run.h5: was changed after pw85 mc had written it: bring back a copy of it, or begin"):
        runs.resume("run.h5")


def test_damaged_sizes(folder):
    """A run without the checksum, in which a data set claims to be larger than any memory."""
    pathlib.Path("run.h5").write_bytes(gzip.decompress(pathlib.Path(__file__).with_name("run_1.h5.gz").read_bytes()))
    with h5py.File("run.h5", "r+") as file:
        for name in ("samples", "state"):
            kind = file[f"pw85_mc/{name}"].dtype
            del file[f"pw85_mc/{name}"]
            file.create_dataset(f"pw85_mc/{name}", shape=1 << 52, dtype=kind, chunks=(1 << 10,))
    cures = {"resume": "bring back a copy of it, or begin a new run", "series": "bring back a copy of it"}
    for name, cure in cures.items():
        with pytest.raises(pypw85.FileError, match=f"^run.h5: needs more memory than there is: .*, or broken; {cure}$"):
            readers("run.h5")[name]()


@pytest.mark.parametrize(("fraction", "axes"), [(0.02, (1, 1, 3)), (0.3, (1, 1, 1)), (0.5, (1, 1, 3)), (0.45, (1, 1, 0.2))])
def test_usual_chains(run, folder, fraction, axes):
    """Chains have some fifty contacts or paths of a quarter of the longest semi-axis, from dilute to dense, in any unit. The number of
    contacts is (Z - 1) times the length, over the mean separation along the direction at a contact."""
    system = pypw85.pack(np.tile(np.array(axes, dtype=float), (200, 1)), fraction, seed=2)
    found = []
    for unit in (1.0, 2.0**-40, 2.0**40):
        scaled = pypw85.System.from_axes(system.centers * unit, system.semi_axes * unit, system.quaternions, cell=system.cell * unit)
        simulation = pypw85.HardEllipsoids(scaled, seed=3)
        simulation.tune(50)
        found.append(runs.usual_sampling(simulation).chain_length / unit)
    np.testing.assert_allclose(found, found[0], rtol=1e-9)
    # For spheres the mean separation at a contact, along the direction, is 2/3 of the distance of the centres. That of ellipsoids is
    # between twice the shortest and twice the longest semi-axis.
    z = np.mean([simulation.chain(1, found[-1] * unit) for _ in range(200)])
    least, most = ((z - 1) * found[0] / (4 / 3 * size) + 4 * found[0] / max(axes) for size in (max(axes), min(axes)))
    assert least < 1.3 * runs.PATHS and most > 0.7 * runs.PATHS


def test_usual_chains_of_discs():
    """As for spheres; the mean separation along the direction of two discs that touch is π/4 of their distance."""
    discs = pypw85.System.from_ellipses(np.indices((14, 14)).reshape(2, -1).T * 2.4, np.ones((196, 2)), np.zeros(196), 33.6 * np.eye(2))
    simulation = pypw85.HardEllipsoids(discs, seed=1)
    simulation.tune(200)
    length = runs.usual_sampling(simulation).chain_length
    z = np.mean([simulation.chain(1, length) for _ in range(200)])
    np.testing.assert_allclose((z - 1) * length / (np.pi / 2) + 4 * length, runs.PATHS, rtol=0.2)


def test_usual_sampling_by_compressibility(monkeypatch):
    """Samples are rarer, and chains for the trials fewer, from Z = 22 on. Without a Z they are those of a dilute system."""
    simulation = pypw85.HardEllipsoids(START, seed=1)
    for z, every, trials in ((1.0, 10, 250), (21.9, 10, 250), (22.0, 20, 1000), (1e9, 20, 1000), (np.nan, 10, 250), (np.inf, 10, 250)):
        monkeypatch.setattr(pypw85.HardEllipsoids, "chain", lambda *_, z=z: z)
        for given in (0, 7, 10**5):
            sampling = runs.usual_sampling(simulation, given)
            expected = given or every, max(1, round(24 * (given or every) / trials))
            assert sampling[:2] == expected, (z, given, sampling)


def test_samples_of_dense(run, folder):
    """In a dense system samples are rarer. Options that are given have precedence, and a run that is continued keeps its samples."""
    pypw85.write("dense.xyz", pypw85.pack(np.tile([0.5, 0.5, 1.5], (100, 1)), 0.6, seed=1))
    common = ["mc", "dense.xyz", "--equilibrate", 20, "--sweeps", 60]
    assert "a sample every 20 sweeps with 2 event chains of length " in run(*common, "--out", "run.h5").out
    for given, said in (
        (["--every", 10], "every 10 sweeps with 1 event chain of"),
        (["--chains", 3], "every 20 sweeps with 3 event chains of"),
        (["--chains", 0], "every 10 sweeps;"),
        (["--chain-length", 0.5], "every 20 sweeps with 2 event chains of length 0.5;"),
        (["--every", 1, "--chains", 2, "--chain-length", 0.5], "every 1 sweep with 2 event chains of length 0.5;"),
    ):
        name = "_".join(map(str, given)) + ".h5"
        assert f"\na sample {said}" in run(*common, *given, "--out", name).out, given
    run(*common[:-1], 20, "--out", "part.h5")
    run("mc", "--resume", "part.h5", "--sweeps", 60)
    with h5py.File("run.h5") as one, h5py.File("part.h5") as other:
        assert (one["pw85_mc/state"][()] == other["pw85_mc/state"][()]).all()
        assert (one["pw85_mc/samples"][()] == other["pw85_mc/samples"][()]).all()


def test_samples_said(run, folder):
    """The number of chains is that for the trials between samples, and the end says what a sample was."""
    done = run("mc", "start.xyz", "--sweeps", 400, "--every", 50, "--equilibrate", 5, "--out", "run.h5")
    with h5py.File("run.h5") as file:
        length = file["pw85_mc/chain_length"][()]
    assert re.search(rf"\na sample every 50 sweeps with 5 event chains of length {length:.4g}; samples took \d+% of the time\n", done.out)
    again = run("mc", "--resume", "run.h5")
    assert f"with 5 event chains of length {length:.4g}\n" in again.out  # no time: nothing was done
    done = run("mc", "start.xyz", "--sweeps", 4, "--every", 1, "--equilibrate", 5, "--chain-length", 0.5, "--out", "other.h5")
    assert "a sample every 1 sweep with 1 event chain of length 0.5;" in done.out


@pytest.mark.parametrize("kind", ["SIGINT", "SIGTERM", "SIGKILL"])
def test_interrupted(run, folder, whole, kind):
    """A run that was interrupted comes to the same end, bit by bit, with another number of threads and in another folder."""
    arguments = [*NPT, "--sweeps", SWEEPS, "--out", "run.h5", "--trajectory", "run.dump", "--checkpoint", "0", "--threads", "2"]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    running = subprocess.Popen([*PW85, "mc", *arguments], **pipes, text=True, preexec_fn=heed_interrupts)
    while running.poll() is None and not (os.path.exists("run.dump") and os.path.getsize("run.dump") > 0):
        time.sleep(0.002)
    running.send_signal(getattr(signal, kind))
    out, err = running.communicate()
    if kind == "SIGKILL":
        assert running.returncode == -signal.SIGKILL
    else:
        assert running.returncode == 130, err
        assert err.startswith("pw85: interrupted after ") and err.endswith(" of 400 sweeps: continue with pw85 mc --resume run.h5\n")
    assert out == TAKEN
    assert 0 < pypw85.read("run.h5").step < 400
    with open("run.dump", "a") as file:
        file.write("what was written behind the checkpoint")
    os.mkdir("other")
    for name in ("run.h5", "run.dump", "run.h5.samples"):
        if kind == "SIGKILL" or name != "run.h5.samples":
            shutil.move(name, "other")
    assert not os.path.exists("run.h5.samples")
    done = run("mc", "--resume", "other/run.h5")
    assert (done.status, done.err) == (0, "")
    assert of_run(done.out) == "other/" + (whole / "out").read_text()
    assert same_as(whole, "other")
    again = run("mc", "--resume", "other/run.h5")
    assert again.out == of_run(done.out) and same_as(whole, "other")


THREADS = """
import os, sys
from pypw85 import cli
sys.argv = ["pw85", "mc", "large.xyz", "--sweeps", "2", "--out", "run.h5", "--threads", "3"]
assert cli._run() == 0
print(len(os.listdir("/proc/self/task")))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the folder of threads is one of Linux")
def test_threads(folder):
    """The threads that are asked for work on a system that is large enough to share."""
    edge = 18
    places = np.stack(np.meshgrid(*[np.arange(float(edge))] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    n = len(places)
    upright = np.tile([1.0, 0, 0, 0], (n, 1))
    pypw85.write("large.xyz", pypw85.System.from_axes(places, np.full((n, 3), 0.4), upright, cell=edge * np.eye(3)))
    done = subprocess.run([sys.executable, "-c", THREADS], capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    assert done.stdout.splitlines()[-1] == "3", done


def test_more_sweeps(run, folder, whole):
    """A finished run goes on."""
    assert run("mc", *NPT, "--sweeps", 150, "--out", "run.h5", "--trajectory", "run.dump").status == 0
    assert pypw85.read("run.h5").step == 150
    assert run("mc", "--resume", "run.h5", "--sweeps", SWEEPS).status == 0
    assert same_as(whole)


def limited(arguments, limit):
    """The command, in a process whose files cannot grow beyond a limit in bytes."""
    limits = functools.partial(resource.setrlimit, resource.RLIMIT_FSIZE, (limit, limit))
    return subprocess.run([*PW85, "mc", *arguments], capture_output=True, text=True, preexec_fn=limits)


@pytest.mark.parametrize("what", ["run.h5", "run.dump", "run.gsd"])
def test_full_disk(run, folder, what):
    """The last checkpoint stays, and the run comes to its end once there is room. Samples or frames fill the disk."""
    samples, frames = ("1", "100") if what == "run.h5" else ("100", "1")
    kind = "gsd" if what == "run.gsd" else "dump"
    arguments = [*NPT, "--every", samples, "--trajectory-every", frames, "--sweeps", "100"]
    assert run("mc", *arguments, "--out", "whole.h5", "--trajectory", f"whole.{kind}").status == 0
    begun = [*NPT, "--sweeps", "1", "--every", "1", "--trajectory-every", "1"]
    assert run("mc", *begun, "--out", "begun.h5", "--trajectory", f"begun.{kind}").status == 0
    done = limited([*arguments, "--out", "run.h5", "--trajectory", f"run.{kind}", "--checkpoint", "0"], os.path.getsize("begun.h5") + 8000)
    assert (done.returncode, done.stdout) == (2, TAKEN), done
    assert done.stderr == f"pw85: {what}: File too large: make room, and continue from the last checkpoint (--resume run.h5)\n"
    assert 0 < pypw85.read("run.h5").step < 100
    assert run("mc", "--resume", "run.h5").status == 0
    one, other = content("run.h5"), content("whole.h5")
    assert all(one[f"pw85_mc/{name}"] == other[f"pw85_mc/{name}"] for name in ("state", "samples", "averages"))
    read = frames_of_gsd if kind == "gsd" else lambda name: pathlib.Path(name).read_bytes()
    assert read(f"run.{kind}") == read(f"whole.{kind}")
    assert not [name for name in os.listdir() if name.startswith(".pw85")]


def test_no_room_at_all(run, folder):
    """Is said before the first sweep."""
    done = limited([*NPT, "--sweeps", "1e9", "--out", "run.h5", "--trajectory", "run.dump"], 1000)
    assert (done.returncode, done.stderr) == (2, "pw85: run.h5: File too large: make room\n")
    assert os.listdir() == ["start.xyz"]


def test_table(run, folder, whole):
    """A name that ends with .csv asks for a table, beside the file of the run."""
    arguments = [*NPT, "--out", "run.csv", "--trajectory", "run.xyz"]
    assert run("mc", *arguments, "--sweeps", 300).status == 0
    assert run("mc", "--resume", "run.csv", "--sweeps", SWEEPS).status == 0
    with h5py.File(whole / "run.h5") as file:
        samples = file["pw85_mc/samples"][()]
    table = np.genfromtxt("run.csv", delimiter=",", names=True)
    assert table.dtype.names == samples.dtype.names
    for name in table.dtype.names:
        np.testing.assert_array_equal(table[name], samples[name])
    assert [frame.step for frame in pypw85.frames("run.xyz")] == list(range(10, 401, 10))


def test_table_grows_with_samples(run, folder):
    """Each sample is in the table as soon as it is taken, without a checkpoint, for programs that show a run while it lasts."""
    arguments = [*NPT[:-2], "--sweeps", "1e9", "--out", "run.csv", "--checkpoint", "1e9"]
    running = subprocess.Popen([*PW85, "mc", *arguments], preexec_fn=heed_interrupts)
    try:
        wait_for(lambda: os.path.exists("run.csv") and pathlib.Path("run.csv").read_text().count("\n") > 5, running)
    finally:
        running.kill()
        running.wait()
    table = np.genfromtxt("run.csv", delimiter=",", names=True)
    assert table["sweep"][:5].tolist() == [5, 10, 15, 20, 25] and (table["volume"] > 0).all()
    assert pypw85.read("run.csv.h5").step == 0  # the only checkpoint is that of the start
    assert run("mc", "--resume", "run.csv", "--sweeps", 40).status == 0
    again = np.genfromtxt("run.csv", delimiter=",", names=True)
    assert again["sweep"].tolist() == list(range(5, 41, 5))
    np.testing.assert_array_equal(again[:5], table[:5])


def wait_for(condition, running):
    while running.poll() is None and not condition():
        time.sleep(0.002)
    assert running.poll() is None


def frames_of_gsd(path):
    """All numbers of a GSD file, as the library gsd reads them."""
    with gsd.fl.open(path, "r" if hasattr(gsd.hoomd, "Frame") else "rb") as file:
        names = file.find_matching_chunk_names("")
        return [{name: file.read_chunk(frame, name).tolist() for name in names} for frame in range(file.nframes)]


def number_of_frames(path):
    """Of a file that grows."""
    return sum(1 for _ in formats.locate(path, "gsd"))


def test_trajectory_in_gsd(run, folder, whole):
    """Frames are in the file while the run lasts, in double precision. A run that was killed goes on, and its frames are those of one that
    was not, also where some were written after the last checkpoint."""
    arguments = [*NPT, "--out", "run.h5", "--trajectory", "run.gsd"]
    running = subprocess.Popen([*PW85, "mc", *arguments, "--sweeps", "1e9", "--checkpoint", "0.2"], preexec_fn=heed_interrupts)
    try:
        wait_for(lambda: os.path.exists("run.gsd") and number_of_frames("run.gsd") > 3, running)
        wait_for(lambda: pypw85.read("run.h5").step > 20, running)
        growing = [frame.step for frame in pypw85.frames("run.gsd")]
        wait_for(lambda: number_of_frames("run.gsd") > len(growing), running)
    finally:
        running.kill()
        running.wait()
    assert growing == list(range(10, 10 * len(growing) + 1, 10)) and len(growing) > 3
    kept, at_checkpoint = frames_of_gsd("run.gsd"), pypw85.read("run.h5").step // 10
    assert 0 < at_checkpoint <= len(kept)
    sweeps = 10 * len(kept) + 20
    assert run("mc", "--resume", "run.h5", "--sweeps", sweeps).status == 0
    found = frames_of_gsd("run.gsd")
    assert len(found) == len(kept) + 2 and found[: len(kept)] == kept
    assert run("mc", *NPT, "--sweeps", sweeps, "--out", "other.h5", "--trajectory", "other.gsd").status == 0
    assert frames_of_gsd("other.gsd") == found
    last, state = list(pypw85.frames("run.gsd"))[-1], pypw85.read("run.h5")
    assert last.step == state.step == sweeps and last.types.tolist() == state.types.tolist()
    np.testing.assert_array_equal(last.semi_axes, state.semi_axes)
    # Doubles, but for the place of the origin
    np.testing.assert_allclose(last.wrapped() - last.origin, state.wrapped() - state.origin, rtol=0, atol=1e-13)
    assert found[0]["particles/position"][0][0] != np.float32(found[0]["particles/position"][0][0])


def test_reader_waits_for_a_frame(tmp_path):
    """A file is broken while a frame is added to it, for as long as the machine lets the writer wait: ten times longer here than a reader
    tries a file that nobody writes."""
    path, began = tmp_path / "a.gsd", threading.Event()
    formats.write(path, pypw85.lattice([1, 1, 1], 0.1, 8))
    content = path.read_bytes()

    def add_a_frame():
        with _files.locked(path, True, 1.0):
            path.write_bytes(content[: len(content) // 2])
            began.set()
            time.sleep(10 * gsd_files._TRIALS * gsd_files._PAUSE)
            path.write_bytes(content)

    writer = threading.Thread(target=add_a_frame)
    writer.start()
    began.wait()
    assert number_of_frames(path) == 1
    writer.join()
    path.write_bytes(content[: len(content) // 2])
    with pytest.raises(pypw85.FileError, match="no readable GSD file"):
        number_of_frames(path)


def test_trajectory_of_single_precision(run, folder):
    """gsd.hoomd of any version reads it."""
    arguments = [*NPT, "--sweeps", "30", "--out", "run.h5", "--trajectory", "run.gsd", "--precision", "single"]
    assert run("mc", *arguments).status == 0
    with gsd.hoomd.open("run.gsd", "r" if hasattr(gsd.hoomd, "Frame") else "rb") as file:
        assert [frame.configuration.step for frame in file] == [10, 20, 30]
        assert file[0].particles.N == 24 and file[0].particles.type_shapes[0]["type"] == "Ellipsoid"


def test_trajectory_in_gsd_that_is_short(run, folder):
    """Frames of the checkpoint are there, or the run does not go on."""
    arguments = [*NPT, "--sweeps", "30", "--trajectory"]
    assert run("mc", *arguments, "run.gsd", "--out", "run.h5").status == 0
    assert run("mc", *NPT, "--sweeps", "20", "--trajectory", "short.gsd", "--out", "short.h5").status == 0
    os.replace("short.gsd", "run.gsd")
    done = run("mc", "--resume", "run.h5", "--sweeps", 40)
    assert done.status == 2 and "run.gsd: has 2 frames, and had 3 at the checkpoint: bring back the trajectory" in done.err


def test_growing_samples(run, folder, monkeypatch):
    """At a checkpoint, samples since the last one are added to files, and the file of the run does not grow with them. A run that was
    killed goes on with what they had at its checkpoint; they must be there, and as they were."""
    arguments = [*NPT, "--every", "1", "--sweeps", "120", "--trajectory-every", "120", "--trajectory"]
    assert run("mc", *arguments, "whole.dump", "--out", "whole.csv").status == 0
    sizes, write = [], runs._write_durably
    monkeypatch.setattr(runs, "_write_durably", lambda path, content: (sizes.append(len(content)), write(path, content)))
    killed = pypw85.HardEllipsoids.chain
    calls = itertools.count()

    def chain(*others):
        if next(calls) == 91:  # the first one finds the length of chains
            raise MemoryError
        return killed(*others)

    with monkeypatch.context() as dying:
        dying.setattr(pypw85.HardEllipsoids, "chain", chain)
        assert run("mc", *arguments, "run.dump", "--out", "run.csv", "--checkpoint", "0").status != 0
    row = 8 * (1 + len(pypw85._observables.Sample._fields))
    assert os.path.getsize("run.csv.h5.samples") == 90 * row
    # Blocking has a row for each doubling of the samples, the last one at the 64th.
    assert sizes[71] == sizes[95]
    for name, more in (("run.csv.h5.samples", b"what was written behind the checkpoint"), ("run.csv", b"1,2,3")):
        with open(name, "ab") as file:
            file.write(more)
    content_of = pathlib.Path("run.csv.h5.samples").read_bytes()
    for bad, reason in (
        (content_of[: 90 * row - 1], f"is shorter than at the checkpoint, {90 * row} bytes: bring back the samples of this run"),
        (b"x" + content_of[1:], "was changed after pw85 mc had written it: bring back a copy of it, or begin a new run"),
    ):
        pathlib.Path("run.csv.h5.samples").write_bytes(bad)
        assert run("mc", "--resume", "run.csv").err.endswith(f"run.csv.h5.samples: {reason}\n")
    pathlib.Path("run.csv.h5.samples").write_bytes(content_of)
    assert run("mc", "--resume", "run.csv").status == 0
    assert not os.path.exists("run.csv.h5.samples")
    assert pathlib.Path("run.csv").read_text() == pathlib.Path("whole.csv").read_text()
    one, other = content("run.csv.h5"), content("whole.csv.h5")
    assert all(one[f"pw85_mc/{name}"] == other[f"pw85_mc/{name}"] for name in ("state", "samples", "averages", "progress"))


def kinds_of(system):
    """Types and semi-axes of all particles, sorted."""
    return sorted(zip(system.types.tolist(), np.sort(system.semi_axes.round(6)).tolist(), strict=True))


def test_exchange(run, folder):
    """Types go with the semi-axes that particles exchange, and a run that continues has the same bits."""
    mixture = [*NPT, "--pressure", "0.2", "--equilibrate", "50", "--exchange", "0.5", "--trajectory", "run.xyz"]
    assert run("mc", *mixture, "--sweeps", 60, "--out", "whole.h5").status == 0
    os.rename("run.xyz", "whole.xyz")
    assert run("mc", *mixture, "--sweeps", 30, "--out", "run.h5").status == 0
    done = run("mc", "--resume", "run.h5", "--sweeps", 60)
    assert done.status == 0 and "trials: exchange\n" in done.out
    one, other = content("run.h5"), content("whole.h5")
    assert all(one[name] == other[name] for name in one if not name.endswith("@version"))
    assert pathlib.Path("run.xyz").read_bytes() == pathlib.Path("whole.xyz").read_bytes()
    with h5py.File("run.h5") as file:
        counts = {move: tuple(numbers[()]) for move, numbers in file["pw85_mc/counts"].items()}
    assert counts["exchange"][1] > 0 and abs(counts["exchange"][0] / (60 * 24) - 0.5) < 0.1, counts
    assert counts["translation"][0] + counts["rotation"][0] + counts["exchange"][0] == 60 * 24
    frames = [*pypw85.frames("run.xyz"), pypw85.read("run.h5")]
    assert any((frame.types != START.types).any() for frame in frames)
    assert all(kinds_of(frame) == kinds_of(START) for frame in frames)


def test_constant_volume(run, folder):
    """In a cell that is smaller than its particle: the images count."""
    rod = pypw85.System.from_axes([[0, 0, 0]], [[2.0, 0.3, 0.3]], [[1, 0, 0, 0]], cell=np.diag([5, 1.2, 1.2]))
    pypw85.write("rod.csv", rod)
    pypw85.write("rod.xyz", rod)
    done = run("mc", "rod.xyz", "--sweeps", 300, "--chains", 0, "--out", "rod.h5")
    assert (done.status, done.err) == (0, "") and "constant volume" in done.out and "compressibility_chains" not in done.out
    last = pypw85.read("rod.h5")
    assert (last.q != rod.q).any() and (last.cell == rod.cell).all()
    images = [image for image in itertools.product(range(-1, 2), range(-4, 5), range(-4, 5)) if any(image)]
    assert (pypw85.contact(np.array(images) @ last.cell, last.q[0], last.q[0])[0] >= 1).all()


def test_needle(run, folder):
    """A fluid whose cell changes its shape: the run ends before images touch. Other kinds go on.
    A start that is too narrow is refused."""
    fluid = pypw85.pack(np.full((20, 3), 0.5), 0.2, seed=1)
    pypw85.write("fluid.xyz", fluid)
    arguments = ["mc", "fluid.xyz", "--pressure", "0.5", "--volume-trials", 20, "--sweeps", "1e4", "--every", "1e4", "--chains", 0]
    done = run(*arguments, "--volume", "axis", "--out", "axis.h5")
    cure = r"in which images of particles nearly touch: use --volume isotropic for fluids, or more particles "
    cure += r"\(--volume axis is for crystals\)"
    assert done.status == 2 and re.search(rf"axis\.h5: the cell has the edges [\d.]+ × [\d.]+ × [\d.]+, {cure}$", done.err), done
    assert run("mc", "--resume", "axis.h5").status == 2
    short = ["--sweeps", 300, "--every", 1, "--volume-trials", 3]
    done = run(*arguments, *short, "--volume", "isotropic", "--out", "isotropic.h5")
    assert done.status == 0 and re.search(r"^\d\.\d+ accepted of 900 trials: volume$", done.out, re.M)
    edges = [float(x) for x in re.search(r"^cell edges (.*)$", done.out, re.M)[1].split()]
    assert edges == pytest.approx(3 * [edges[0]]) and "shape of the cell" not in done.out
    pypw85.write("narrow.xyz", pypw85.System.from_axes([[0, 0, 0]], [3 * [0.5]], [[1, 0, 0, 0]], cell=np.diag([1.2, 9, 9])))
    for change, status in (("triclinic", 2), ("isotropic", 0)):
        narrow = ["mc", "narrow.xyz", "--pressure", 1, "--sweeps", 1, "--volume", change, "--out", f"narrow-{change}.h5"]
        assert run(*narrow).status == status and os.path.exists(f"narrow-{change}.h5") == (status == 0)


def test_stretched(run, folder):
    """A warning, once one edge is twice as long beside another one."""
    pypw85.write("gas.xyz", pypw85.System.from_axes([[0, 0, 0]], [3 * [1e-9]], [[1, 0, 0, 0]], cell=np.eye(3)))
    done = run("mc", "gas.xyz", "--pressure", 2, "--volume", "axis", "--volume-trials", 30, "--sweeps", 200, "--every", 1, "--chains", 0,
               "--out", "gas.h5")  # fmt: skip
    assert done.status == 0 and "warning: the shape of the cell has changed much: use --volume axis and triclinic for crystals" in done.out


def test_doubts(run, folder, monkeypatch):
    """Warnings of a drift, of widths that are too large or too small, of chains without a pressure, and of a short run."""
    crystal = 2 * np.stack(np.meshgrid(*[np.arange(3)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    upright = pypw85.System.from_axes(crystal, np.tile([0.3, 0.3, 0.9], (27, 1)), [[1, 0, 0, 0]] * 27, cell=6 * np.eye(3))
    pypw85.write("upright.xyz", upright)
    common = ["mc", "upright.xyz", "--every", 1, "--chains", 0]
    done = run(*common, "--sweeps", 400, "--equilibrate", 0, "--out", "begun.h5")
    assert "warning: the run is too short for the errors of nematic_order" in done.out  # without those that are constant
    assert re.search(r"^volume +216 +0 +", done.out, re.M)
    with monkeypatch.context() as changed:
        changed.setattr(pypw85.Observables, "drifts", lambda _: {"density": 2.1, "compressibility_contacts": -3.14})
        changed.setattr(pypw85.Observables, "unresolved", lambda _: ["nematic_order"])
        done = run(*common, "--sweeps", 400, "--equilibrate", 200, "--out", "narrow.h5", "--width", "1e-9")
    drifts = "warning: drifts from the start to the end: compressibility_contacts by -3.1 times its error: begin again, equilibrate longer"
    assert drifts in done.out and "allow for this" not in done.out  # because no error is printed
    marked = [line.split()[0] for line in done.out.splitlines() if line.endswith("?")]
    assert marked == ["nematic_order", "compressibility_contacts"]
    with h5py.File("narrow.h5") as file:
        averages = {row["name"].decode(): row["error"] for row in file["pw85_mc/averages"][()]}
    assert np.isnan(averages["nematic_order"]) and averages["volume"] == 0  # which is constant
    assert "density by" not in done.out and "warning: no pair was within the width: choose a larger one (--width)" in done.out
    pypw85.write("dense.xyz", pypw85.pack(np.full((32, 3), 0.5), 0.45, seed=1))
    with monkeypatch.context() as changed:
        changed.setattr(pypw85.Observables, "drifts", lambda _: {"compressibility_contacts": -3.14, "contacts_bias": 3})
        changed.setattr(pypw85.Observables, "unresolved", lambda _: [])
        done = run("mc", "dense.xyz", "--sweeps", 400, "--every", 2, "--chains", 0, "--equilibrate", 40, "--out", "wide.h5", "--width", 1)
    drifts = "contacts by -3.1 times its error, contacts_bias by 3.0 times its error: begin again, equilibrate longer (--equilibrate); "
    assert drifts + "the errors in the table allow for this" in done.out
    assert re.search(r"warning: the width biases compressibility_contacts by about \S+: choose a smaller one \(--width\)", done.out), done
    done = run("mc", "start.xyz", "--sweeps", 3, "--out", "new.h5", "--width", 5)
    assert done.err.endswith("Invalid value for '--width': must be a finite number > 0 and at most 1, not '5'\n")
    pypw85.write("one.xyz", pypw85.System.from_axes([[0, 0, 0]], [[0.3, 0.3, 0.5]], [[1, 0, 0, 0]], cell=np.eye(3)))
    done = run("mc", "one.xyz", "--sweeps", 40, "--every", 1, "--out", "one.h5")
    assert "warning: there is no pressure from chains: a particle could touch its own image" in done.out
    assert of_run(done.out).startswith("one.h5: 1 particle, constant volume")


def test_constants(run, folder):
    """What the settings hold constant has the error 0 in a run that is too short for other errors, of which the warning tells alone."""
    common = ["mc", "start.xyz", "--sweeps", 40, "--every", 1]
    done = run(*common, "--out", "nvt.h5")
    warning = re.search(r"warning: the run is too short for the errors of (.*), which need \d+", done.out)
    assert not {"volume", "density", "packing_fraction", "energy"} & set(warning[1].split(", ")), done
    assert "nematic_order" in warning[1] and "\nenergy" not in done.out
    assert all(re.search(rf"\n{name} +\S+ +0 +\S+\n", done.out) for name in ("volume", "density", "packing_fraction")), done
    with h5py.File("nvt.h5") as file:
        errors = {row["name"].decode(): row["error"] for row in file["pw85_mc/averages"][()]}
    assert errors["volume"] == errors["energy"] == 0 and np.isnan(errors["nematic_order"])
    done = run(*common, "--pressure", 1.5, "--out", "npt.h5")
    assert re.search(r"too short for the errors of volume, density, packing_fraction, ", done.out), done
    assert re.search(r"\nvolume +\S+ +- +\S+  \?\n", done.out), done


def test_badly_tuned(run, folder):
    """Steps that were tuned in the jammed packing are too short when it has loosened; one that is tuned longer has no such warning."""
    pypw85.write("jammed.xyz", pypw85.pack(np.tile([1.0, 1.0, 3.0], (60, 1)), 0.55, seed=0))
    said = "of the translations were accepted instead of about 0.4: the steps were tuned before the system was in equilibrium"
    common = ["mc", "jammed.xyz", "--sweeps", 300, "--chains", 0]
    assert said in run(*common, "--equilibrate", 3, "--out", "short.h5").out
    assert said not in run(*common, "--equilibrate", 600, "--out", "long.h5").out


def test_numbers(run, folder):
    """Numbers of sweeps, chains and so on can be written as 1e1; a run without samples says so."""
    done = run("mc", "start.xyz", "--sweeps", "9e0", "--equilibrate", "1e1", "--seed", 2**64 - 1, "--out", "run.h5")
    assert (done.status, done.err) == (0, "")
    assert of_run(done.out).splitlines()[0].endswith(f"seed {2**64 - 1}")
    assert "\nno averages: a sample is taken every 10 sweeps (--every)\n" in done.out
    assert done.out.endswith("\nno overlaps after 9 sweeps\n")
    assert run("pack", "new.xyz", "-n", "1e1", "--axes", "1,1,2", "--fraction", "0.1", "--steps", "1e3").status == 0
    done = run("pack", "new.xyz", "-n", "1.5", "--axes", "1,1,2", "--fraction", "0.1")
    assert "must be a whole number from 1 to" in done.err and "not '1.5'" in done.err


def test_signals_together(folder):
    """timeout(1) sends a signal to the process and one to its group. The sample is finished and the checkpoint is written."""
    arguments = ["start.xyz", "--sweeps", "1e3", "--every", "1", "--equilibrate", "0", "--chains", "1", "--chain-length", "1e5"]
    running = subprocess.Popen([*PW85, "mc", *arguments, "--out", "run.h5"], stderr=subprocess.PIPE, text=True, preexec_fn=heed_interrupts)
    while not os.path.exists("run.h5"):
        time.sleep(0.01)
    time.sleep(0.1)
    for _ in range(2):
        running.send_signal(signal.SIGTERM)
        time.sleep(0.01)
    assert running.communicate()[1].startswith("pw85: interrupted after ") and running.returncode == 130
    assert pypw85.read("run.h5").step > 0


def test_unwritable_later(run, folder, monkeypatch):
    """The cure suits the cause."""

    def fail(*_):
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr("pypw85.cli._runs._write_durably", fail)
    done = run("mc", *NPT, "--sweeps", "10", "--out", "run.h5", "--trajectory", "run.dump")
    assert (done.status, done.err) == (2, "pw85: run.h5: Permission denied: name a file in another folder\n")


def test_two_at_once(run, folder, whole):
    """Only one process continues a run, under whatever name; the other one says so and changes nothing."""
    assert run("mc", *NPT, "--sweeps", 10, "--out", "run.h5", "--trajectory", "run.dump").status == 0
    os.symlink("run.h5", "link.h5")
    endless = [*PW85, "mc", "--resume", "run.h5", "--sweeps", "1e9"]
    held = subprocess.Popen(endless, stderr=subprocess.PIPE, text=True, preexec_fn=heed_interrupts)
    length = os.path.getsize("run.dump")
    while os.path.getsize("run.dump") == length:
        time.sleep(0.01)
    for name in ("run.h5", "link.h5"):
        done = run("mc", "--resume", name, "--sweeps", "2e9")
        assert done.status == 2 and re.search(r"another process is at work on this run: wait for its end, or interrupt it$", done.err), done
    held.send_signal(signal.SIGKILL)
    held.communicate()
    assert run("mc", "--resume", "run.h5", "--sweeps", SWEEPS).status == 0
    assert same_as(whole)
    assert not [name for name in os.listdir() if name.startswith(".")]


def test_abandoned_folders(folder):
    """What a killed process has left goes away at the next writing: not what is new, what a process locks, or what is none of it."""
    import fcntl

    for name in (".pw85-old", ".pw85-new", ".pw85-held", "pw85-other"):
        os.mkdir(name)
        pathlib.Path(name, "part").write_text("unfinished")
        if name != ".pw85-new":
            os.utime(name, (0, 0))
    held = os.open(".pw85-held", os.O_RDONLY)
    fcntl.flock(held, fcntl.LOCK_EX)
    pypw85.formats._files._searched.clear()
    pypw85.write("again.xyz", START)
    assert {name for name in os.listdir() if "pw85" in name} == {".pw85-new", ".pw85-held", "pw85-other"}
    os.close(held)
    done = subprocess.run([*PW85, "convert", "start.xyz", "start.csv"], capture_output=True, text=True)
    assert done.returncode == 0, done
    assert {name for name in os.listdir() if "pw85" in name} == {".pw85-new", "pw85-other"}


def test_progress(folder):
    """The time left, on a terminal."""
    status, text = on_terminal("mc", "start.xyz", "--sweeps", "1e8", "--out", "run.h5", "--equilibrate", "5", until=rb"\d:\d\d:\d\d left")
    assert status == 130 and " of 100000000 sweeps, " in text, text
    assert text.splitlines()[-1].endswith("of 100000000 sweeps: continue with pw85 mc --resume run.h5")
    assert pypw85.read("run.h5").step > 0


# Ellipses of two kinds, as a file of two dimensions
ELLIPSES = pypw85.System.from_ellipses(
    1.5 * np.stack(np.meshgrid(np.arange(6), np.arange(5), indexing="ij"), axis=-1).reshape(-1, 2),
    np.tile([[0.7, 0.4], [0.5, 0.5]], (15, 1)), np.zeros(30), np.diag([9.0, 7.5]), types=np.tile(["long", "round"], 15),
)  # fmt: skip
PLANE = ["--pressure", "1.5", "--volume", "triclinic", "--equilibrate", "20", "--every", "5", "--chains", "2", "--reach", "2", "--bins",
         "4", "--exchange", "0.2", "--trajectory-every", "20"]  # fmt: skip


@pytest.mark.parametrize("name", ["start.gsd", "start.xyz", "start.dump"])
def test_plane(run, folder, name):
    """Ellipses of a file of two dimensions stay in their plane, in all that the run writes; and a run that continues has the same bits."""
    if name.endswith("gsd"):
        pytest.importorskip("gsd")
    pypw85.write(name, ELLIPSES)
    plane = ["mc", name, *PLANE]
    done = run(*plane, "--sweeps", 100, "--out", "whole.csv", "--trajectory", "whole.xyz")
    assert done.status == 0 and "whole.csv.h5: 30 ellipses, βP = 1.5, seed 1\n" in done.out, done
    assert len(re.search(r"^director (.*)$", done.out, re.M)[1].split()) == 2
    assert len(re.search(r"^cell edges (.*)$", done.out, re.M)[1].split()) == 2
    assert run(*plane, "--sweeps", 40, "--out", "run.csv", "--trajectory", "run.xyz").status == 0
    done = run("mc", "--resume", "run.csv", "--sweeps", 100)
    assert (done.status, done.err) == (0, "")
    for end in "csv", "xyz":
        assert pathlib.Path(f"run.{end}").read_bytes() == pathlib.Path(f"whole.{end}").read_bytes()
    table = np.genfromtxt("run.csv", delimiter=",", names=True)
    frames = [*pypw85.frames("run.xyz"), pypw85.read("run.csv.h5")]
    for frame in frames:
        assert frame.dimensions == 2 and not frame.centers[:, 2].any() and len(frame.overlaps().mu) == 0
        longest = frame.semi_axes[:, :2].max(axis=1).round(6).tolist()
        assert sorted(zip(frame.types.tolist(), longest)) == 15 * [("long", 0.7)] + 15 * [("round", 0.5)]
    area = np.pi * 15 * (0.7 * 0.4 + 0.5 * 0.5)
    np.testing.assert_allclose(table["packing_fraction"] * table["volume"], area, rtol=1e-6)
    assert frames[-1].packing_fraction == pytest.approx(table["packing_fraction"][-1])


def test_area(run, folder):
    """At constant area."""
    pypw85.write("plane.xyz", ELLIPSES)
    done = run("mc", "plane.xyz", "--sweeps", 20, "--every", 5, "--out", "one.csv")
    assert done.status == 0 and "one.csv.h5: 30 ellipses, constant area, seed 1" in done.out, done
    done = run("mc", "plane.xyz", "--dimensions", "3", "--periodic", "ab", "--sweeps", 10, "--out", "three.h5")
    assert done.status == 2 and "must be periodic along its three vectors" in done.err


def test_needle_in_the_plane(run, folder):
    """A cell of a fluid that changes its shape; the vector across the plane does not count as narrow."""
    lattice = 1.5 * np.stack(np.meshgrid(np.arange(4), np.arange(4)), axis=-1).reshape(-1, 2)
    pypw85.write("fluid.xyz", pypw85.System.from_ellipses(lattice, np.full((16, 2), 0.5), np.zeros(16), 6 * np.eye(2)))
    arguments = ["mc", "fluid.xyz", "--pressure", "0.3", "--volume", "axis", "--chains", 0]
    assert run(*arguments, "--sweeps", 5, "--out", "short.h5").status == 0
    done = run(*arguments, "--volume-trials", 20, "--sweeps", "1e4", "--every", "1e4", "--out", "long.h5")
    assert done.status == 2 and re.search(r"long\.h5: the cell has the edges [\d.]+ × [\d.]+, in which images", done.err), done


# Where bits of a checkpoint change
CHANGED = {
    "state": "pw85_mc/state",
    "progress": "pw85_mc/progress",
    "averages": "pw85_mc/observables/values",
    "ids": "particles/all/id/value",
}
GOOD = ["mc", "start.xyz", "--sweeps", "10", "--out", "new.h5"]
BAD = [
    (["mc", "grains.xyz", *GOOD[2:]], r"grains\.xyz: pairs that overlap: \d+ \(the particles \d+ and \d+, .* and others\): "
                                      r"separate them \(pw85 relax\)"),
    (["mc", "big.xyz", *GOOD[2:]], r"pairs that overlap: 1 \(the particles 1 and its image\)"),
    (["mc", "open.xyz", *GOOD[2:]], "must be periodic along its three vectors: use --cell"),
    (["mc", "channel.xyz", *GOOD[2:]], r"must be periodic along its two vectors: use --cell and --periodic ab"),
    ([*GOOD, "--dimensions", "2"], "leave out --dimensions 2"),
    ([*GOOD, "--periodic", "ab"], "must be periodic along its three vectors: use --cell"),
    (["mc", "missing.xyz", *GOOD[2:]], "missing.xyz: no such file"),
    (["mc", "nan.xyz", *GOOD[2:]], "nan.xyz, frame 0, line 3: "),
    *[([*GOOD, "--pressure", number], f"must be a finite number > 0, not '{number}'") for number in ("0", "-1", "nan", "inf", "x")],
    *[([*GOOD, "--sweeps", number], f"must be a whole number.*, not '{number}'") for number in ("0", "0.5", "nan", "inf", "x")],
    ([*GOOD, "--chain-length", "0"], "must be a finite number > 0, not '0'"),
    *[([*GOOD, *given], "would have more than .* free paths, and at most 1e.08 are allowed: choose fewer") for given in
      (["--chain-length", "1e9"], ["--chains", "1e9"], ["--chains", "1e5", "--chain-length", "1e4"])],
    ([*GOOD, "--pressure", "1", "--volume-trials", "1e9"], "must be a whole number from 1 to 10000, not '1e9'"),
    ([*GOOD, "--reach", "nan"], "must be a finite number >= 0, not 'nan'"),
    *[([*GOOD, "--exchange", number], f"must be a finite number >= 0 and < 1, not '{number}'") for number in ("1", "-0.1", "nan", "x")],
    (["mc", "alike.xyz", *GOOD[2:], "--exchange", "0.1"], "alike.xyz: all particles have the same semi-axes: there is nothing to exchange"),
    (["mc", "renamed.xyz", *GOOD[2:], "--exchange", "0.1"], "renamed.xyz: particles of the types .* and .* have the same semi-axes"),
    ([*GOOD, "--seed", "-1"], "--seed"),
    ([*GOOD[:4]], "give --out for a new run, or --resume FILE to continue one"),
    (["mc"], "give START and --sweeps and --out for a new run, or --resume FILE to continue one"),
    ([*GOOD[:5], "no/new.h5"], "no/new.h5: there is no folder no"),
    ([*GOOD[:5], "new.txt"], "new.txt: is not a name of a run: end it with .h5 or .csv"),
    ([*GOOD[:5], "old.h5"], r"old.h5: exists already: continue it \(--resume\), or name another file"),
    ([*GOOD[:5], "table.csv"], "table.csv: exists already"),
    ([*GOOD, "--trajectory", "start.xyz"], "start.xyz: exists already"),
    ([*GOOD, "--trajectory", "new.h5"], "a trajectory grows during the run: end its name with .gsd, .xyz or .dump"),
    ([*GOOD, "--trajectory", "new.xyz.gz"], "a trajectory grows during the run: end its name with .gsd, .xyz or .dump"),
    ([*GOOD, "--trajectory", "no/new.xyz"], "no/new.xyz: there is no folder no"),
    (["mc", "--resume", "missing.h5"], "missing.h5: no such file"),
    (["mc", "--resume", "start.xyz"], "start.xyz: is not a run: name a file that pw85 mc has written"),
    (["mc", "--resume", "other.h5"], r"other.h5: is not a run: name a file that pw85 mc has written with --out"),
    (["mc", "--resume", "older.h5"], r"older.h5: is a run of pypw85 2.9.9 in a format that .* does not read: continue it with that"),
    (["mc", "--resume", "broken.h5"], "broken.h5: no readable HDF5 .*: it is broken or truncated; bring back a copy of it, or begin"),
    *[(["mc", "--resume", f"{name}.h5"], f"{name}.h5: is damaged, or was changed after pw85 mc had written it: bring back a copy")
      for name in CHANGED],
    (["mc", "--resume", "old.h5", "--sweeps", "10"], r"old.h5: has 20 sweeps already: ask for more \(--sweeps\)"),
    (["mc", "--resume", "old.h5", "--seed", "2"], "leave out --seed"),
    (["mc", "start.xyz", "--resume", "old.h5"], "leave out START"),
    (["mc", "--resume", "table.csv"], "table.csv.h5: no such file"),
    ([*GOOD, "--volume", "axis"], "--volume has no effect without --pressure: add --pressure, or leave out --volume"),
    ([*GOOD, "--bins", "5"], "--bins has no effect without --reach: "),
    ([*GOOD, "--trajectory-every", "5"], "--trajectory-every has no effect without --trajectory: "),
    ([*GOOD, "--every", "11"], "--every must be at most --sweeps, 10, not 11: nothing would be written"),
    ([*GOOD, "--trajectory", "new.xyz"], "--trajectory-every must be at most --sweeps, 10, not 1000: nothing would be written"),
    ([*GOOD, "--chains", "0", "--chain-length", "5"], "--chain-length has no effect with --chains 0: "),
    ([*GOOD, "--threads", "100000"], "must be a whole number from 1 to 1024.*, not '100000'"),
    *[([*GOOD, "--equilibrate", number], f"must be a whole number from 0 to.*, not '{number}'")
      for number in ("-1", "0.5", "nan", "inf", "x")],
    *[([*GOOD, "--seed", number], rf"must be a whole number from 0 to 2\*\*64 - 1.*, not '{number}'")
      for number in ("1.5", "18446744073709551616")],
    ([*GOOD, "--trajectory", "/dev/full"], "/dev/full: a trajectory grows during the run: end its name with .gsd, .xyz or .dump"),
    (["mc", "--resume", "elsewhere/old.h5"], "elsewhere/old.xyz: is shorter than at the checkpoint"),
]  # fmt: skip


@pytest.fixture(scope="module")
def bad_files(tmp_path_factory, whole):
    """A finished run, and files that are no start or no run."""
    folder = tmp_path_factory.mktemp("bad")
    pypw85.write(folder / "start.xyz", START)
    pypw85.write(folder / "grains.xyz", random_system())
    big = pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 1]], [[1, 0, 0, 0]], cell=np.diag([1.5, 9, 9]))
    pypw85.write(folder / "big.xyz", big)
    pypw85.write(folder / "open.xyz", pypw85.System(START.centers, START.q))
    channel = pypw85.System.from_ellipses([[0, 0], [2, 2]], [[0.5, 0.4]] * 2, [0, 1], 4 * np.eye(2), periodic=(True, False))
    pypw85.write(folder / "channel.xyz", channel)
    cube = pypw85.System.from_axes(2 * np.eye(3), [[0.5] * 3] * 3, [[1, 0, 0, 0]] * 3, cell=4 * np.eye(3))
    pypw85.write(folder / "alike.xyz", cube)
    types = ["other", *START.types.tolist()[1:]]
    renamed = pypw85.System.from_axes(START.centers, START.semi_axes, START.quaternions, cell=START.cell, types=types)
    pypw85.write(folder / "renamed.xyz", renamed)
    (folder / "nan.xyz").write_text((folder / "start.xyz").read_text().replace("\n1 rod ", "\n1 rod nan ", 1))
    pypw85.write(folder / "other.h5", START)
    (folder / "table.csv").write_text("precious")
    arguments = ["start.xyz", "--sweeps", "20", "--out", "old.h5", "--trajectory", "old.xyz", "--trajectory-every", "10"]
    subprocess.run([*PW85, "mc", *arguments], check=True, cwd=folder, capture_output=True)
    for name in ("older", "broken", *CHANGED):
        shutil.copy(folder / "old.h5", folder / f"{name}.h5")
    with h5py.File(folder / "older.h5", "r+") as file:
        file["pw85_mc"].attrs["version"] = "2.9.9"
        del file["pw85_mc"].attrs["format"]
    for name, path in CHANGED.items():
        change_a_bit(folder / f"{name}.h5", path)
    with open(folder / "broken.h5", "r+b") as file:
        file.truncate(os.path.getsize(folder / "broken.h5") // 2)
    (folder / "elsewhere").mkdir()
    shutil.copy(folder / "old.h5", folder / "elsewhere/old.h5")
    (folder / "elsewhere/old.xyz").write_text("short")
    return folder


def change_a_bit(path, name):
    """As a disk may do it."""
    with h5py.File(path) as file:
        place = file[name].id.get_offset()
        place = place if place is not None else file[name].id.get_chunk_info(0).byte_offset
    with open(path, "r+b") as file:
        file.seek(place)
        byte = file.read(1)[0]
        file.seek(place)
        file.write(bytes([byte ^ 1]))


@pytest.mark.parametrize("arguments, reason", BAD, ids=[" ".join(arguments) for arguments, _ in BAD])
def test_bad_input(run, monkeypatch, bad_files, arguments, reason):
    """One sentence, before the first sweep; nothing is changed."""
    monkeypatch.chdir(bad_files)
    before = {path: path.read_bytes() for path in bad_files.iterdir() if path.is_file()}
    monkeypatch.setattr(pypw85.HardEllipsoids, "sweep", lambda *_: pytest.fail("there was a sweep"))
    monkeypatch.setattr(pypw85.HardEllipsoids, "tune", lambda *_: pytest.fail("there was a sweep"))
    done = run(*arguments)
    assert done.status == 2 and "Traceback" not in done.err, done
    last = done.err.splitlines()[-1]
    assert re.search(reason, last), last
    assert {path: path.read_bytes() for path in bad_files.iterdir() if path.is_file()} == before
