# SPDX-License-Identifier: BSD-3-Clause
"""Walls, fields and laws of pairs of the command pw85 mc: the bits of pypw85.HardEllipsoids, what is said of them, and bad input."""

import pathlib
import re

import numpy as np
import pytest

import pypw85
from pypw85 import Field, HardEllipsoids, Law, Wall
from systems import of_run

h5py = pytest.importorskip("h5py")

# Upright ellipsoids around the origin, a bit apart, which reach from -1.6 to 1.6 along x and y, and from -2.1 to 2.1 along z
SPACING = np.array([1.1, 1.1, 2.2])
PLACES = SPACING * (np.stack(np.meshgrid(*map(np.arange, (3, 3, 2)), indexing="ij"), axis=-1).reshape(-1, 3) - [1, 1, 0.5])
SETTLE, SWEEPS, EVERY = 5, 20, 5


def start(periodic="none", cell=True):
    """With a cell that is periodic along some vectors, or without one."""
    n = len(PLACES)
    others = {"cell": np.diag(SPACING * [3, 3, 2]), "periodic": [name in periodic for name in "abc"]} if cell else {}
    others |= {"ids": 10 + np.arange(n)}
    return pypw85.System.from_axes(PLACES, np.tile([0.5, 0.5, 1.0], (n, 1)), np.tile([1.0, 0, 0, 0], (n, 1)), **others)


pytestmark = pytest.mark.usefixtures("folder")

# Each kind of walls and fields, in a cell that may have it: periodic directions, options, walls, fields
CASES = {
    "plane": ("ab", ["--wall", "plane:0,0,2,5", "--wall", "plane:0 0 -1 2.5"], [Wall.plane([0, 0, 2], 5), Wall.plane([0, 0, -1], 2.5)], []),
    "sphere": ("none", ["--wall", "sphere:0,0,0.25,4"], [Wall.sphere([0, 0, 0.25], 4)], []),
    "cylinder": ("c", ["--wall", "cylinder:0.25,0,7,0,0,-3,2.6"], [Wall.cylinder([0.25, 0, 7], [0, 0, -3], 2.6)], []),
    "box": ("none", ["--wall", "box:-2,-2,-2.5,2,2.5,3"], [Wall.box([-2, -2, -2.5], [2, 2.5, 3])], []),
    "linear": ("ab", ["--field", "linear:0,0,0.75"], [], [Field.linear([0, 0, 0.75])]),
    "weight": ("ab", ["--field", "weight:0,0,-0.5"], [], [Field.weight([0, 0, -0.5])]),
    "harmonic": ("c", ["--field", "harmonic:1,2,3,4,5,0"], [], [Field.harmonic([1, 2, 3], [4, 5, 0])]),
    "aligning": ("abc", ["--field", "aligning:1,0,0,5"], [], [Field.aligning([1, 0, 0], 5)]),
    "other axis": ("abc", ["--field", "aligning:1,2,3,-5,0"], [], [Field.aligning([1, 2, 3], -5, 0)]),
    "both": ("ab", ["--wall", "plane:0,0,-1,3", "--field", "weight:0,0,1", "--field", "aligning:0,1,0,2"], [Wall.plane([0, 0, -1], 3)],
             [Field.weight([0, 0, 1]), Field.aligning([0, 1, 0], 2)]),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_same_as_class(run, case):
    """State and samples have the bits of a simulation in Python, also those of a run that was continued."""
    periodic, options, walls, fields = CASES[case]
    pypw85.write("start.h5", start(periodic))
    common = ["mc", "start.h5", "--equilibrate", SETTLE, "--every", EVERY, "--seed", 3, *options]
    done = run(*common, "--sweeps", SWEEPS, "--out", "whole.h5")
    assert done.status == 0, done
    simulation, observables = HardEllipsoids(pypw85.read("start.h5"), seed=3), pypw85.Observables()
    simulation.set_walls(walls)
    simulation.set_fields(fields)
    simulation.tune(SETTLE)
    samples = []
    for _ in range(SWEEPS // EVERY):
        simulation.sweep(EVERY)
        samples.append(observables.add(simulation))
    with h5py.File("whole.h5") as file:
        assert file["pw85_mc/state"][()].tobytes() == simulation.save()
        found = file["pw85_mc/samples"][()]
    for name in pypw85.Sample._fields:
        np.testing.assert_array_equal(found[name], [getattr(sample, name) for sample in samples])
    assert np.isnan(found["volume"]).all() == (periodic != "abc") and found["energy"].any() == bool(fields)
    assert run(*common, "--sweeps", SWEEPS // 2, "--out", "parts.h5").status == 0
    again = run("mc", "--resume", "parts.h5", "--sweeps", SWEEPS)
    assert of_run(again.out) == of_run(done.out).replace("whole", "parts")
    with h5py.File("parts.h5") as file:
        assert file["pw85_mc/state"][()].tobytes() == simulation.save()


def test_what_is_said(run):
    """Walls and fields are repeated as they were given, also where a run goes on, with the energy; there is no volume."""
    pypw85.write("start.xyz", start("ab"))
    options = CASES["both"][1]
    done = run("mc", "start.xyz", "--sweeps", 40, "--every", 1, "--out", "run.csv", "--trajectory", "run.dump",
               "--trajectory-every", 40, *options)  # fmt: skip
    lines = of_run(done.out).splitlines()
    assert lines[:4] == ["run.csv.h5: 18 particles, not periodic along all vectors, seed 1", "wall plane:0,0,-1,3", "field weight:0,0,1",
                         "field aligning:0,1,0,2"]  # fmt: skip
    named = {line.split()[0] for line in lines}
    assert {"energy", "nematic_order", "director"} <= named
    assert not {"volume", "density", "compressibility_chains", "compressibility_contacts"} & named
    assert not any("chain" in line for line in lines) and lines[-1] == "no overlaps after 40 sweeps"
    assert run("mc", "--resume", "run.csv").out == of_run(done.out)
    table = np.genfromtxt("run.csv", delimiter=",", names=True)
    energy = float(re.search(r"^energy +([\d.]+)", done.out, re.M)[1])
    assert energy == pytest.approx(table["energy"].mean(), rel=1e-7)
    last = pypw85.read("run.csv.h5")
    assert last.periodic == (True, True, False) and last.ids.tolist() == list(range(10, 28)) and len(last.overlaps().mu) == 0
    pypw85.write("short.xyz", start("ab"))
    done = run("mc", "short.xyz", "--sweeps", 4, "--every", 1, "--out", "short.h5", "--wall", "plane:0,0,1,4")
    assert done.status == 0 and "\nenergy" not in done.out and "too short for the errors of" in done.out
    done = run("mc", "short.xyz", "--sweeps", 4, "--periodic", "abc", "--out", "free.h5")
    assert done.status == 0 and "wall" not in done.out and "\nenergy" not in done.out


@pytest.mark.parametrize("trajectory", ["run.xyz", "run.dump", "run.gsd"])
def test_without_cell(run, trajectory):
    """Particles in a sphere need none. The trajectory and the last configuration are inside."""
    if trajectory.endswith("gsd"):
        pytest.importorskip("gsd")
    pypw85.write("start.xyz", start(cell=False))
    common = ["mc", "start.xyz", "--wall", "sphere:0,0,0,4", "--trajectory-every", 10, "--trajectory", trajectory, "--sweeps"]
    assert run(*common, 20, "--out", "run.h5").status == 0
    done = run("mc", "--resume", "run.h5", "--sweeps", 40)
    assert done.status == 0 and "no overlaps after 40 sweeps" in done.out, done
    last = pypw85.read("run.h5")
    assert last.cell is None
    frames = [*pypw85.frames(trajectory), last]
    assert [frame.step for frame in frames] == [10, 20, 30, 40, 40]
    for frame in frames:
        assert np.linalg.norm(frame.centers, axis=1).max() < 3.5
        np.testing.assert_allclose(np.sort(frame.semi_axes, axis=1), np.tile([0.5, 0.5, 1], (18, 1)), rtol=1e-6)


def test_plane(run):
    """Ellipses in a disc, with z that is 0."""
    places = PLACES[::2, :2]
    pypw85.write("start.xyz", pypw85.System.from_ellipses(places, np.tile([0.5, 0.25], (9, 1)), np.zeros(9)))
    done = run("mc", "start.xyz", "--wall", "sphere:0,0,0,2.5", "--field", "aligning:0,1,0,3,0", "--sweeps", 20, "--equilibrate", 5,
               "--out", "run.h5")  # fmt: skip
    assert done.status == 0 and of_run(done.out).startswith("run.h5: 9 ellipses, not periodic along all vectors, seed 1\nwall sphere"), done
    simulation = HardEllipsoids(pypw85.read("start.xyz"))
    simulation.set_walls([Wall.sphere([0, 0], 2.5)])
    simulation.set_fields([Field.aligning([0, 1], 3, 0)])
    simulation.tune(5)
    simulation.sweep(20)
    with h5py.File("run.h5") as file:
        assert file["pw85_mc/state"][()].tobytes() == simulation.save()


def test_pressure_with_aligning_field(run):
    """Changes of the volume are for a cell that is periodic along its vectors, with a field that turns particles alone."""
    pypw85.write("start.xyz", start("abc"))
    done = run("mc", *GOOD, "--pressure", 1, "--field", "aligning:0,0,1,2", "--reach", 2, "--every", 1)
    assert done.status == 0 and "βP = 1" in done.out and re.search(r"^compressibility_contacts ", done.out, re.M), done
    assert "chain" not in done.out


# A law of each kind: what the option says, and the law. The table has that of the powers, in few digits.
U, D_U = (lambda x: 4 * x**-6 - 4 * x**-3), (lambda x: -24 * x**-7 + 12 * x**-4)
MU2 = np.linspace(1, 2.25, 11)
LAWS = {
    "powers": ("powers:4,12,4,6,2.25", Law.inverse_powers(4, 12, 4, 6, mu2_max=2.25)),
    "table": ("table:law.txt", Law.table(1, 2.25, U(MU2), D_U(MU2))),
}


@pytest.mark.parametrize("name", LAWS)
def test_law(run, name):
    """A law of pairs: the bits of the class, also where a run goes on without the file of the table; the energy is an average."""
    option, law = LAWS[name]
    pypw85.write("start.h5", start("abc"))
    np.savetxt("law.txt", np.stack([MU2, U(MU2), D_U(MU2)], axis=1), header="mu2 U dU/dmu2", fmt="%.17g")
    common = ["mc", "start.h5", "--equilibrate", SETTLE, "--every", EVERY, "--law", option]
    done = run(*common, "--sweeps", 8 * SWEEPS, "--out", "whole.h5")
    assert done.status == 0, done
    simulation = HardEllipsoids(pypw85.read("start.h5"))
    simulation.set_law(law)
    simulation.tune(SETTLE)
    energies, pressures = [], []
    for _ in range(8 * SWEEPS // EVERY):
        simulation.sweep(EVERY)
        energies.append(simulation.energy())
        system = simulation.system()
        found = system.neighbors(1.5)
        mu2 = pypw85.contact_pairs(found.pairs, system.centers, system.q, system.cell, images=found.images)[0]
        hard = pypw85.compressibility([mu2, mu2], len(system)).value
        mu2 = mu2[mu2 < 2.25]
        pressures.append(hard - 2 * (mu2 * D_U(mu2)).sum() / (3 * len(system)))
    with h5py.File("whole.h5") as file:
        assert file["pw85_mc/state"][()].tobytes() == simulation.save()
        assert file["pw85_mc/samples"]["energy"].tolist() == energies and min(energies) < -1
        # The table is of few digits: a cubic polynomial between its points.
        near = {"powers": 1e-9, "table": 0.05}[name]
        np.testing.assert_allclose(file["pw85_mc/samples"]["compressibility_contacts"], pressures, atol=near, rtol=0)
    lines = of_run(done.out).splitlines()
    assert lines[:2] == ["whole.h5: 18 particles, constant volume, seed 1", f"law {option}"]
    assert re.search(r"^energy +-", done.out, re.M) and "chain" not in done.out
    assert run(*common, "--sweeps", SWEEPS, "--out", "parts.h5").status == 0
    pathlib.Path("law.txt").unlink()
    continued = run("mc", "--resume", "parts.h5", "--sweeps", 8 * SWEEPS)
    assert of_run(continued.out) == of_run(done.out).replace("whole", "parts")
    with h5py.File("parts.h5") as file:
        assert file["pw85_mc/state"][()].tobytes() == simulation.save()


def test_law_at_constant_pressure(run):
    """There the compressibility is that of the whole energy, and no warning says otherwise."""
    pypw85.write("start.xyz", start("abc"))
    done = run("mc", *GOOD, "--pressure", 1, "--law", LAWS["powers"][0], "--every", 1, "--volume-trials", 2, "--equilibrate", 1)
    assert done.status == 0 and "βP = 1" in done.out and "hard cores alone" not in done.out, done
    simulation = HardEllipsoids(pypw85.read("start.xyz"))
    simulation.set_law(LAWS["powers"][1])
    simulation.volume_moves(1, 1)
    simulation.tune(1, pressure=1)
    for _ in range(10):
        simulation.sweep()
        simulation.volume_moves(2, 1)
    with h5py.File("new.h5") as file:
        assert file["pw85_mc/state"][()].tobytes() == simulation.save()


TABLES = [
    ("1 2 3\n", "law.txt must have two lines or more, each of three finite numbers: μ², U and dU/dμ²: write table:FILE"),
    ("1 2\n3 4\n", "must have two lines or more"),
    ("1 2 3\n2 x 3\n", "must have two lines or more"),
    ("1 2 3\n2 nan 3\n", "must have two lines or more"),
    ("1 2 3\n2 2 3\n4 2 3\n", "law.txt: μ² must increase by the same step from line to line"),
    ("2 2 3\n1 2 3\n", "μ² must increase"),
    ("1 2e6 0\n2 0 0\n", "start.xyz: --law table:law.txt: law must have energies of pairs of at most 2²⁰ k_B T"),
]


@pytest.mark.parametrize("text, reason", TABLES)
def test_bad_table(run, text, reason):
    pypw85.write("start.xyz", start("abc"))
    pathlib.Path("law.txt").write_text(text, encoding="utf-8")
    done = run("mc", *GOOD, "--law", "table:law.txt")
    assert done.status == 2 and "Traceback" not in done.err and reason in done.err.splitlines()[-1], done
    assert not pathlib.Path("new.h5").exists()


GOOD = ["start.xyz", "--sweeps", "10", "--out", "new.h5"]
BAD = [
    (["--wall", "plain:0,0,1,5"], "a wall must be one of plane, sphere, cylinder, box, as in plane:NX,NY,NZ,OFFSET; sphere:"),
    (["--wall", ""], "a wall must be one of plane"),
    (["--field", "gravity:0,0,1"], "a field must be one of linear, weight, harmonic, aligning, as in linear:GX,GY,GZ; "),
    (["--wall", "plane"], r"'plane': '' must be 4 finite numbers.*: write plane:NX,NY,NZ,OFFSET"),
    (["--wall", "plane:0,0,1"], r"'plane:0,0,1': '0,0,1' must be 4 finite numbers.*: write plane:NX,NY,NZ,OFFSET"),
    (["--wall", "sphere:0,0,0,nan"], "must be 4 finite numbers.*: write sphere:X,Y,Z,RADIUS"),
    (["--wall", "cylinder:0,0,0,1,2"], "must be 7 finite numbers.*: write cylinder:X,Y,Z,AX,AY,AZ,RADIUS"),
    (["--wall", "box:0,0,0,1,2,x"], "is not a list of numbers: write box:LX,LY,LZ,UX,UY,UZ"),
    (["--field", "aligning:0,0,1"], r"must be 4 or 5 finite numbers.*: write aligning:DX,DY,DZ,STRENGTH\[,AXIS\]"),
    (["--field", "aligning:0,0,1,2,0.5"], "the axis must be 0, 1 or 2, not 0.5: write aligning"),
    (["--field", "harmonic:0,0,0,1"], "must be 6 finite numbers.*: write harmonic:X,Y,Z,KX,KY,KZ"),
    (["--wall", "plane:0,0,1,5", "--wall", "plane:0,0,-1,2"],
     r"start\.xyz: --wall plane:0,0,-1,2: particle 10: walls must not cut a particle: move one of them$"),
    (["--wall", "plane:0,0,1,-20"],
     "--wall plane:0,0,1,-20: particle 10: walls must not have a particle in them, where normal·x >= offset: correct"),
    (["--wall", "plane:0,0,0,5"], "--wall plane:0,0,0,5: vector must be a normal that is finite and not zero, not "),
    (["--wall", "plane:1,0,0,5"],
     r"--wall plane:1,0,0,5: must be the same in all images of the cell: change its numbers, or name .* \(--periodic\)$"),
    (["--wall", "sphere:0,0,0,9"], "--wall sphere:0,0,0,9: must be the same in all images of the cell"),
    (["--field", "linear:0,0,1", "--field", "linear:1,0,0"], "--field linear:1,0,0: must be the same in all images of the cell"),
    (["--field", "linear:0,0,1.7e308"], "--field linear:0,0,1.7e308: the energy of each particle must be finite"),
    (["--wall", "plane:0,0,1,5", "--pressure", "1"], "--pressure needs a cell that is periodic along its three vectors: leave it out"),
    (["--field", "weight:0,0,1", "--reach", "1"], "--reach needs a cell that is periodic along its three vectors: leave it out"),
    (["--wall", "plane:0,0,1,5", "--chains", "1"], "event chains do not support walls, fields and laws: leave out --chains"),
    (["--field", "aligning:0,0,1,1", "--chain-length", "1"],
     "event chains do not support walls, fields and laws: leave out --chain-length"),
    (["--periodic", "abc", "--law", "springs:1"], "a law must be one of powers, table, as in powers:A,N,B,M,MU2_MAX"),
    (["--periodic", "abc", "--law", "powers:4,12,4,6"], "must be 5 finite numbers.*: write powers:A,N,B,M,MU2_MAX"),
    (["--periodic", "abc", "--law", "powers:4,6,4,12,2"], r"--law powers:4,6,4,12,2: parameters must have exponents n > m > 0, not"),
    (["--periodic", "abc", "--law", "powers:4,12,4,6,0.5"], r"--law powers:4,12,4,6,0.5: parameters must have a cutoff above μ² = 1"),
    (["--periodic", "abc", "--law", "table:no.txt"], "no.txt: No such file or directory: write table:FILE"),
    (["--periodic", "abc", "--law", "powers:4,12,4,6,2", "--chains", "1"], "do not support walls, fields and laws: leave out --chains"),
    (["--law", "powers:4,12,4,6,2"], r"must be periodic along its three vectors"),
    ([], r"must be periodic along its three vectors: use --cell and --periodic abc, or hold the particles by walls and fields"),
]  # fmt: skip


@pytest.mark.parametrize("options, reason", BAD, ids=[" ".join(options) for options, _ in BAD])
def test_bad_input(run, monkeypatch, options, reason):
    """One sentence, before the first sweep, and no file is left."""
    pypw85.write("start.xyz", start("ab"))
    monkeypatch.setattr(HardEllipsoids, "tune", lambda *_: pytest.fail("there was a sweep"))
    done = run("mc", *GOOD, *options)
    assert done.status == 2 and "Traceback" not in done.err, done
    assert re.search(reason, done.err.splitlines()[-1]), done.err
    assert [path.name for path in pathlib.Path().iterdir()] == ["start.xyz"]


def test_chains_of_none(run):
    """No chains are what there is with walls, so that --chains 0 says nothing wrong."""
    pypw85.write("start.xyz", start("ab"))
    assert run("mc", *GOOD, "--wall", "plane:0,0,1,5", "--chains", "0").status == 0


@pytest.mark.parametrize("option", [["--wall", "plane:0,0,1,5"], ["--field", "weight:0,0,1"], ["--law", "powers:4,12,4,6,2"]])
def test_resumed(run, option):
    """The file says which walls, fields and laws there are: others are refused, and these, too."""
    pypw85.write("start.xyz", start("abc" if option[0] == "--law" else "ab"))
    assert run("mc", *GOOD, *option).status == 0
    done = run("mc", "--resume", "new.h5", "--sweeps", 20, *option)
    assert done.status == 2 and f"leave out {option[0]}" in done.err
