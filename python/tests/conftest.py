# SPDX-License-Identifier: BSD-3-Clause
"""What the tests share: the files that they need, random pairs, and a way to name a failing row."""

import compileall
import functools
import os
import pathlib

import numpy as np
import pytest

import pypw85
from systems import command

# The variables that name files of the sources, the file that shows that a value is right, and the value where the tests lie in the
# sources. Meson sets both.
SOURCE = pathlib.Path(__file__).resolve().parents[2]
VARIABLES = {
    "PYPW85_SOURCE": ("the root of the sources of pw85", "include/pw85.h", SOURCE),
    "PYPW85_REFERENCE_DATA": ("pw85_ref_data.h5 of the folder data of the sources", "", SOURCE / "data/pw85_ref_data.h5"),
}


def pytest_configure():
    """Sets the variables, or says which one is missing. Modules of tests read them when they are collected."""
    for name, (what, witness, usual) in VARIABLES.items():
        given = pathlib.Path(os.environ.setdefault(name, str(usual)))
        if not (given / witness).exists():
            raise pytest.UsageError(f"set {name} to {what}: there is no {given / witness}")
    # Programs that tests start load the package again, and may be told to leave no bytecode. Where the package cannot be written to, it
    # stays as it is.
    compileall.compile_dir(pathlib.Path(pypw85.__file__).parent, quiet=2)


# Numbers in doctests are printed bare, as NumPy did before 2.0.
np.set_printoptions(legacy="1.21")


@pytest.fixture
def rng():
    return np.random.default_rng(20240229)


@pytest.fixture
def run(capsys, monkeypatch):
    """The command as a function of its arguments."""
    return functools.partial(command, capsys, monkeypatch)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty folder, which is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def usual_mode():
    """Leaves the reproducible mode as it was."""
    before = pypw85.is_reproducible()
    yield
    pypw85.set_reproducible(before)


@pytest.fixture
def random_pairs(rng):
    """Makes `count` pairs (r12, q1, q2) of triaxial ellipsoids, with aspect ratios up to 4 and around contact."""

    def make(count):
        def forms():
            return pypw85.ellipsoid_quaternion(rng.uniform(0.5, 2, (count, 3)), rng.normal(size=(count, 4)))

        return rng.normal(scale=1.5, size=(count, 3)), forms(), forms()

    return make


@pytest.fixture
def assert_rows():
    """Asserts that a condition holds for all rows, and prints the first row for which it does not, in hexadecimal."""

    def check(condition, *arrays):
        condition = np.asarray(condition)
        if condition.all():
            return
        first = int(np.flatnonzero(~condition)[0])
        rows = [np.atleast_1d(np.asarray(array, dtype=float)[first]).ravel() for array in arrays]
        pytest.fail(f"row {first}: " + "; ".join(" ".join(float(x).hex() for x in row) for row in rows))

    return check
