# SPDX-License-Identifier: BSD-3-Clause
"""Wrong calls of the command: status 2, a sentence that says what is wrong with the value and what to do, and no traceback."""

import os
import re

import numpy as np
import pytest

import pypw85

PACK = "pack new.xyz -n 8 --axes 1,1,2 --fraction 0.2"
MC = "mc start.xyz --sweeps 10 --out run.h5"
# A call, and what its sentence says
WRONG = [
    # pack
    ("pack new.xyz", "Missing option '--axes'"),
    ("pack new.xyz -n 8 --axes 1,1,2", "a random packing needs -n and --fraction"),
    ("pack new.xyz --axes 1,1,2 --fraction 0.2", "a random packing needs -n and --fraction"),
    (f"{PACK} --seed -1", "must be a whole number from 0.*, not '-1'"),
    (f"{PACK} --steps 0", "must be a whole number from 1.*, not '0'"),
    (f"{PACK} --spread nan", "must be a finite number >= 0, not 'nan'"),
    (f"{PACK} --to png", "Invalid value for '--to'"),
    (f"{PACK} --cell 1,2", r"--cell must have 3 or 9 numbers"),
    (f"{PACK} --cell 1,1,nan", "must be .* finite numbers"),
    (f"{PACK} --dimensions 2", "--axes must have 2 numbers"),
    (f"{PACK} --dimensions 4", "Invalid value for '--dimensions'"),
    ("pack new.xyz -n 2 --axes 1,1,2 --axes 1,1,3 --axes 1,1,4 --fraction 0.2", "-n must be at least 3, the number of shapes .*, not 2"),
    (f"{PACK} --spread 1000", "--spread 1000 gives sizes beyond the range of double precision: use a smaller value"),
    (f"{PACK} --attempts 5", "--attempts has no effect without --rsa: add --rsa, or leave out --attempts"),
    (f"{PACK} --resolution 5", "--resolution has no effect without --voxels: add --voxels, or leave out --resolution"),
    ("pack new.xyz --axes 1,1,3 --rsa --cell 10,10,10", "--rsa can prove saturation of ellipses and balls only, .*: use --attempts, "),
    ("pack new.xyz --axes 1,1,1 --rsa --cell 10,10,10 --steps 5", "--steps has no effect with --rsa, .*: leave it out"),
    (f"{PACK} --align 0,0,1", "--align has no effect without --lattice"),
    (f"{PACK} --voxels a.h5 --resolution 1e9", r"must be a whole number from 1 to 2\*\*20 - 1, not '1e9'"),
    (f"{PACK} --voxels a.vtk --cell 1,0,0,1,1,0,0,0,1", "the cell must be rectangular for an image of VTK: write the voxels as .h5"),
    ("pack a.h5 -n 8 --axes 1,1,2 --fraction 0.2 --voxels ./a.h5", "OUTPUT and --voxels must be different files"),
    (f"{PACK} --voxels image.png", r"image\.png"),
    ("pack new.png -n 8 --axes 1,1,2 --fraction 0.2", r"^pw85: new\.png: no format has this suffix"),
    ("pack none/new.xyz -n 8 --axes 1,1,2 --fraction 0.2", r"^pw85: none/new\.xyz: there is no folder none: create it"),
    ("pack folder.xyz -n 8 --axes 1,1,2 --fraction 0.2", r"^pw85: folder\.xyz: is a directory: name a file"),
    ("pack new.xyz -n 1000000000000000 --axes 1,1,2 --fraction 0.2", r"not enough memory for the neighbour list: use fewer"),
    ("pack new.xyz -n 0 --axes 1,1,2 --fraction 0.2", "must be a whole number from 1.*, not '0'"),
    ("pack new.xyz -n 1.5 --axes 1,1,2 --fraction 0.2", r"must be a whole number.*, not '1\.5'"),
    ("pack new.xyz -n 8 --axes 1,1,2 --fraction nan", "must be a finite number > 0 and < 1, not 'nan'"),
    ("pack new.xyz -n 8 --axes 1,1,2 --fraction 1", "must be a finite number > 0 and < 1, not '1'"),
    ("pack new.xyz -n 8 --axes 1,1,2 --fraction -0.2", r"must be a finite number > 0 and < 1, not '-0\.2'"),
    ("pack new.xyz -n 8 --axes 1,1,0 --fraction 0.2", "must be 3 finite numbers > 0"),
    ("pack new.xyz -n 8 --axes 1,1,a --fraction 0.2", "'1,1,a' is not a list of numbers"),
    ("pack new.xyz -n 8 --axes 1e-9,1,1e9 --fraction 0.2",
     r"^pw85: the longest semi-axis must be at most .* not \[1e-09, 1\.0, 1000000000\.0\] of ellipsoid 0"),
    ("pack new.xyz -n 8 --axes 1e300,1,1 --fraction 0.2", "beyond double precision: choose another unit"),
    (f"{PACK} --lattice hcp", "Invalid value for '--lattice'"),
    ("pack new.xyz -n 8 --axes 1,1,2 --lattice fcc", "a lattice needs -n and --fraction"),
    (f"{PACK} --lattice fcc --cell 1,1,1", "--cell has no effect with --lattice: leave it out"),
    (f"{PACK} --lattice fcc --seed 3", "--seed has no effect with --lattice: leave it out"),
    (f"{PACK} --lattice fcc --rsa", "--rsa has no effect with --lattice: leave it out"),
    (f"{PACK} --lattice fcc --axes 1,1,1", "use --axes only once"),
    (f"{PACK} --lattice fcc --align 0,0,0", "--align must be three finite numbers that are not all 0"),
    (f"{PACK} --lattice fcc --align 0,1", "must be 3 finite numbers, not 2"),
    ("pack new.xyz -n 9 --axes 1,1,2 --fraction 0.2 --lattice fcc", "-n must be a multiple of 4, .*, not 9: take 8 or 12"),
    ("pack new.xyz -n 8 --axes 1,1,2 --fraction 0.7 --lattice sc", r"--fraction must be at most 0\.1309.*, or --lattice stretched"),
    ("pack new.xyz --axes 1,1,2 --rsa", "--rsa needs --cell, or -n and --fraction"),
    ("pack new.xyz --axes 1,1,2 --rsa --cell 9,9,9 -n 4", "with --rsa, -n also needs --fraction: add --fraction, or use --cell alone"),
    ("pack new.xyz --axes 1,1,2 --rsa --cell 9,9,9 --fraction 0.1", "with --rsa, --fraction also needs -n: add -n"),
    ("pack new.xyz --axes 1,1,2 --rsa --cell 9,9,9 --attempts 0.5", "must be a whole number from 1"),
    ("pack new.xyz --axes 1,1,2 --axes 1,2 -n 8 --fraction 0.1",
     "--axes must have 3 numbers, not 2: add the third one, or --dimensions 2 for ellipses"),
    ("pack new.xyz --axes 1,1,2 --dimensions 2 -n 8 --fraction 0.1", "--axes must have 2 numbers with --dimensions 2, not 3"),
    # relax
    ("relax start.xyz", "Missing argument 'OUTPUT'"),
    ("relax start.xyz new.foo", r"new\.foo: no format has this suffix"),
    ("relax none.xyz new.xyz", r"^pw85: none\.xyz: no such file"),
    ("relax start.xyz new.xyz --steps 0", "must be a whole number from 1.*, not '0'"),
    ("relax start.xyz new.xyz --frames a", "'a' is neither a number nor"),
    # mc
    ("mc", "give START and --sweeps and --out for a new run, or --resume FILE to continue one"),
    ("mc start.xyz --sweeps 1e3", "give --out for a new run"),
    ("mc start.xyz --out run.h5", "give --sweeps for"),
    ("mc start.xyz --sweeps 9 --out run.h5 --chains 0 --chain-length 3", "--chain-length has no effect with --chains 0: leave out one"),
    ("mc start.xyz --sweeps 9 --out run.h5 --reach 2 --bins 1e12", "Invalid value for '--bins': must be a whole number from 1 to 1000000"),
    ("mc --sweeps 5 --out run.h5", "give START for"),
    ("mc start.xyz --sweeps 10 --out run.txt", r"run\.txt: is not a name of a run"),
    ("mc none.xyz --sweeps 10 --out run.h5", r"none\.xyz: no such file"),
    ("mc --resume start.xyz", r"^pw85: start\.xyz: is not a run: name a file that pw85 mc has written"),
    ("mc --resume none.h5", r"none\.h5: no such file"),
    ("mc --resume other.h5", r"other\.h5: is not a run"),
    ("mc --resume run.h5 --seed 1", "leave out --seed"),
    (f"{MC} --width 0", "must be a finite number > 0 and at most 1, not '0'"),
    (f"{MC} --width nan", "must be a finite number > 0 and at most 1, not 'nan'"),
    (f"{MC} --width 2", "Invalid value for '--width': must be a finite number > 0 and at most 1, not '2'"),
    ("mc start.xyz --sweeps 10 --out folder.h5", r"^pw85: folder\.h5: is a directory: name a file"),
    ("mc start.xyz --sweeps 10 --out none/run.h5", r"^pw85: none/run\.h5: there is no folder none"),
    ("mc --resume folder.h5", r"^pw85: folder\.h5: is a directory: name a file"),
    ("mc --resume truncated.h5", r"^pw85: truncated\.h5: no readable HDF5 file"),
    (f"{MC} --every 0", "must be a whole number from 1.*, not '0'"),
    (f"{MC} --pressure -1", "must be a finite number > 0, not '-1'"),
    (f"{MC} --pressure inf", "must be a finite number > 0, not 'inf'"),
    (f"{MC} --volume axis", "has no effect without --pressure"),
    (f"{MC} --exchange 1", "must be a finite number >= 0 and < 1, not '1'"),
    (f"{MC} --exchange 0.1", "nothing to exchange"),
    (f"{MC} --threads 0", "must be a whole number from 1.*, not '0'"),
    (f"{MC} --trajectory a.png", r"a\.png: a trajectory grows"),
    (f"{MC} --wall plane", "Invalid value for '--wall'"),
    (f"{MC} --trajectory a.xyz --trajectory-every 5 --precision single", "--precision has no effect on a trajectory that is not a"),
    (f"{MC} --periodic none --wall sphere:3,3,3,90 --width 0.2", "--width has no effect without a cell that is periodic along"),
    (f"{MC} --field linear:0,0,0", r"--field linear:0,0,0: has no effect: leave it out"),
    (f"{MC} --field aligning:0,0,1,0", r"--field aligning:0,0,1,0: has no effect: leave it out"),
    *[(f"{MC.replace('start', 'flat')} --field {field}", f"--field {field}: has no effect on particles that stay in a plane")
      for field in ("linear:0,0,1", "weight:0,0,1", "harmonic:0,0,0,0,0,1", "aligning:0,0,1,2,0")],
    (f"{MC.replace('start', 'flat')} --field aligning:0,1,0,3", "on ellipses, whose axis 2 is along z: append the AXIS 0 or 1"),
    (f"{MC} --reach 1e6", "there is not enough memory for all pairs within --reach, 1e.06: choose a smaller one"),
    (f"{MC} --bins 5", "has no effect without --reach"),
    # draw
    ("draw start.xyz", "Missing argument 'PICTURE'"),
    ("draw start.xyz pic", r"^pw85: pic: the name of a picture must end with one of"),
    ("draw start.xyz pic.foo", r"^pw85: pic\.foo: the name of a picture must end with one of"),
    ("draw none.xyz a.png", r"none\.xyz: no such file"),
    ("draw start.xyz start.xyz", r"the name of a picture must end with one of|is the input"),
    ("draw start.xyz none/a.png", r"none/a\.png: "),
    *[(f"draw start.xyz a.html --{name} 60", f"--{name} has no effect on a page") for name in ("elevation", "azimuth", "size")],
    *[(f"draw flat.xyz a.png --{option}", f"--{option.split()[0]} has no effect on ellipses in a plane")
      for option in ("elevation 9", "azimuth 9", "color orientation")],
    ("draw start.xyz a.html --elevation nan", "must be a finite number of degrees, not 'nan'"),
    ("draw start.xyz a.png --azimuth inf", "must be a finite number of degrees, not 'inf'"),
    ("draw start.xyz a.png --elevation high", "must be a finite number of degrees, not 'high'"),
    ("draw start.xyz a.png --size 10", "Invalid value for '--size'"),
    ("draw start.xyz a.png --color red", "Invalid value for '--color'"),
    ("draw start.xyz a.png --frames 7", "there is no frame 7: the file has one frame, 0"),
    # plot
    ("plot start.xyz", "Missing argument 'PICTURE'"),
    ("plot start.xyz pic", r"^pw85: pic: the name of a picture must end with one of"),
    ("plot none.xyz a.png", r"none\.xyz: no such file"),
    ("plot start.xyz a.png --reach nan", "must be a finite number > 0, not 'nan'"),
    ("plot start.xyz a.png --reach inf", "must be a finite number > 0, not 'inf'"),
    ("plot start.xyz a.png --reach 1e300", r"not enough memory for all pairs with μ < 1e\+300: use a smaller number \(--reach\)"),
    ("plot start.xyz a.png --reach 0", "must be a finite number > 0, not '0'"),
    ("plot start.xyz a.png --bins 0", "Invalid value for '--bins': must be a whole number from 1 to 1000000, not '0'"),
    ("plot start.xyz a.png --bins 1e9", "Invalid value for '--bins': must be a whole number from 1 to 1000000, not '1e9'"),
    ("plot start.xyz a.html", r"^pw85: a\.html: the name of a picture must end with one of (?!.*html)"),
    ("plot start.xyz a.png --frames 7:9", "there are no frames 7:9: the file has one frame, 0"),
    ("check start.xyz --frames 99999999999999999999", "there is no frame 99999999999999999999: the file has one frame, 0"),
    ("plot start.xyz none/a.png", r"none/a\.png: there is no folder none"),
    ("plot truncated.h5 a.png", r"^pw85: truncated\.h5: no readable HDF5 file .*: it is broken or truncated; bring back a copy"),
    # convert
    ("convert start.xyz a.stl --species 1:H", "--species has no effect on a mesh of triangles, which has no types: leave it out"),
    ("convert start.xyz a.vtk --species 1:H", "--species has no effect on the format vtk, which has no types: leave it out"),
    ("convert start.xyz a.sdf --species 1:H", "--species has no effect on the format sdf, which has no types: leave it out"),
    ("convert start.xyz a.stl --deviation nan", "Invalid value for '--deviation': must be a finite number > 0, not 'nan'"),
    ("convert start.xyz a.stl --deviation 1e-9", "a deviation of 1e-09 needs more than .*: use a larger deviation"),
    # check
    ("check", "Missing argument 'FILE'"),
    ("check none.xyz", r"none\.xyz: no such file"),
    ("check start.xyz --worst 1.5", "Invalid value for '--worst': must be a whole number from 0"),
    ("check start.xyz --angle-columns a,b", "--angle-columns must name 1 column, not 2: use --euler for more than one angle"),
    ("check start.xyz --euler zyx --angle-columns a,b", "--angle-columns must name 3 columns, not 2: one for each letter of --euler"),
    ("check start.xyz --ignore-columns foo", "there is no column 'foo', but .*: name one of these"),
    ("check start.xyz --spacing 2", "--spacing applies to the format labels only, not to xyz: leave it out"),
    ("check start.xyz --below nan", "must be a finite number > 0, not 'nan'"),
    ("check start.xyz --below inf", "must be a finite number > 0, not 'inf'"),
    ("check start.xyz --below 2", "--below has no effect without --csv or --json or --hdf5"),
    ("check start.xyz --below -1", "must be a finite number > 0, not '-1'"),
    ("check start.xyz --worst -1", "Invalid value for '--worst'"),
    ("check start.xyz --workers 0", "Invalid value for '--workers'"),
    ("check start.xyz --csv none/a.csv", r"none/a\.csv: there is no folder none"),
    ("check start.xyz --csv a.csv --below 1e300", r"not enough memory for all pairs with μ < 1e\+300: use a smaller number \(--below\)"),
    ("check start.xyz --csv start.xyz", r"start\.xyz: is the input: name another file"),
    ("check start.xyz --csv a.csv --json a.csv", r"a\.csv: is named for two outputs"),
    ("check start.xyz --frames 1:2:0", "the step of frames must not be 0"),
    ("check start.xyz --cell 1,2", "must be 3 or 9 finite numbers"),
    ("check start.xyz --periodic q", "Invalid value for '--periodic'"),
    ("check start.xyz --euler zz", "Invalid value for '--euler': must be one to three of xyz .* not 'zz'"),
    ("check start.xyz --shape 1,2,0", "Invalid value for '--shape': '1,2,0' must be 3 finite numbers > 0"),
    ("check start.xyz --shape 1,1,1 --shape 2,2,2", "--shape is given twice for one type: leave one of them out"),
    ("check start.xyz --shape 1:1,1,1 --shape 1:1,1,1", "--shape is given twice for '1': leave one of them out"),
    ("check start.xyz --overlap", "No such option"),
    ("examine start.xyz", "No such command"),
]
# What is no sentence of the command: names of the library's functions, temporary files, and tracebacks
FOREIGN = re.compile(r"Traceback|neighbors: |\.pw85-|not positive definite|Error\(|errno|None")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("wrong")
    system = pypw85.System.from_axes(np.eye(3) * 3, [[0.5, 0.5, 1]] * 3, [[1, 0, 0, 0]] * 3, cell=6 * np.eye(3))
    for name in ("start.xyz", "other.h5"):
        pypw85.write(path / name, system)
    flat = pypw85.System.from_ellipses(np.eye(2) * 3, [[0.5, 1]] * 2, [0, 0], cell=9 * np.eye(2))
    pypw85.write(path / "flat.xyz", flat)
    (path / "truncated.h5").write_bytes((path / "other.h5").read_bytes()[:1000])
    (path / "folder.xyz").mkdir()
    (path / "folder.h5").mkdir()
    return path


@pytest.mark.parametrize("call, sentence", WRONG, ids=[call for call, _ in WRONG])
def test_wrong_call(call, sentence, folder, run, monkeypatch):
    monkeypatch.chdir(folder)
    before = sorted(os.listdir())
    done = run(*call.split())
    assert done.status == 2, done
    lines = done.err.strip().splitlines()
    assert re.search(sentence, lines[-1]) and re.match(r"(pw85|Error): \S", lines[-1]), done
    assert not FOREIGN.search(done.err), done
    assert sorted(os.listdir()) == before


def test_points_without_effect(folder, run, monkeypatch):
    monkeypatch.chdir(folder)
    done = run("check", "start.xyz", "--points")
    assert done.status == 0 and "warning: start.xyz, frame 0: --points has no effect, because all particles have shapes\n" in done.err, done
