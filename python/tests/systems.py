# SPDX-License-Identifier: BSD-3-Clause
"""Systems that several tests use, and the command as a function."""

import contextlib
import dataclasses
import os
import re
import signal
import subprocess
import sys
import warnings

import numpy as np

import pypw85
from pypw85 import cli

PW85 = [sys.executable, "-m", "pypw85"]
SUFFIXES = {"lammps-dump": "dump", "lammps-data": "data", "gsd": "gsd", "xyz": "xyz", "hdf5": "h5", "csv": "csv"}
CELL = np.array([[4, 0, 0], [0.5, 4, 0], [-0.25, 0.5, 4]])


def random_system(seed=1, count=40, cell=CELL, **others):
    """Ellipsoids of two types around the origin, with numbers that single precision holds exactly."""
    random = np.random.default_rng(seed)
    single = lambda x: x.astype(np.float32).astype(np.float64)  # noqa: E731
    types = random.integers(0, 2, count)
    axes = np.array([[0.25, 0.5, 1], [0.5, 0.5, 0.75]])[types]
    quaternions = random.normal(size=(count, 4))
    quaternions = single(quaternions / np.linalg.norm(quaternions, axis=1)[:, None])
    # Within the cell, on a lattice of points that are as exact
    centers = (random.integers(0, 1024, (count, 3)) / 1024 - 0.5) @ cell
    options = {"cell": cell, "ids": np.arange(count), "types": 1 + types, "origin": -cell.sum(axis=0) / 2, **others}
    return pypw85.System.from_axes(centers, axes, quaternions, **options)


def read(path, **options):
    """A file, without warnings."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pypw85.read(path, **options)


def read_text(path, text, **options):
    """A file that is made of a text."""
    path.write_text(text)
    return read(path, **options)


@dataclasses.dataclass
class Outcome:
    status: int
    out: str
    err: str


def command(capsys, monkeypatch, *arguments):
    """What `pw85 arguments` does; progress, which a slow machine shows, is taken out of what it says."""
    monkeypatch.setattr(sys, "argv", ["pw85", *map(str, arguments)])
    capsys.readouterr()
    status = cli._run()
    out, err = capsys.readouterr()
    return Outcome(status, out, re.sub(r"\r[^\r\n]*\[[\d:]+\] *|\r *", "", err))


def expect_resumed(program, states, table, monkeypatch, capsys):
    """Runs a program of the folder reference for three states: of a table without the second one it makes this row alone."""
    monkeypatch.setattr(program, "states", lambda: states)
    monkeypatch.setattr(sys, "argv", [program.__file__, str(table)])
    program.main()
    whole = table.read_text()
    lines = whole.splitlines(keepends=True)
    table.write_text(lines[0] + lines[1] + lines[3])
    capsys.readouterr()
    program.main()
    assert table.read_text() == whole
    assert capsys.readouterr().out.startswith(" ".join(states[1]) + " ")
    program.main()
    assert capsys.readouterr().out == ""


def heed_interrupts():
    """For a child, before its program starts: a shell lets programs that it runs in the background ignore Ctrl-C, and `pw85 check` with
    several processes, which other tests call here, blocks it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def on_terminal(*arguments, until=None, program=PW85):
    """What a program writes to a terminal; Ctrl-C there, for all its processes, once it has written `until`."""
    controller, terminal = os.openpty()
    running = subprocess.Popen([*program, *arguments], stdin=terminal, stdout=terminal, stderr=terminal, start_new_session=True,
                               preexec_fn=heed_interrupts)  # fmt: skip
    os.close(terminal)
    written = b""
    with contextlib.suppress(OSError):  # the end of the file, on Linux
        while chunk := os.read(controller, 65536):
            written += chunk
            if until is not None and re.search(until, written):
                until = os.killpg(running.pid, signal.SIGINT)
    os.close(controller)
    return running.wait(timeout=60), written.decode().replace("\r\n", "\n")


def of_run(text):
    """What `pw85 mc` printed of a run: without what it took of its start, and without the part of the time that samples took, which differs
    from run to run."""
    first_line = text.rfind("\n", 0, text.index(", seed ")) + 1
    return re.sub(r"; samples took \d+% of the time", "", text[first_line:])
