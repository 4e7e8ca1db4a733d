# SPDX-License-Identifier: BSD-3-Clause
"""The command lines of the programs that make the tables of reference data."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

REFERENCE = Path(os.environ["PYPW85_SOURCE"]) / "reference"
PROGRAMS = [path for path in sorted(REFERENCE.glob("*/*.py")) if '__name__ == "__main__"' in path.read_text(encoding="utf-8")]


def state_of(folder):
    return {path: path.stat().st_mtime_ns for path in folder.rglob("*") if "__pycache__" not in path.parts}


def test_found():
    assert len(PROGRAMS) == 10


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
@pytest.mark.parametrize("word, status", [("--help", 0), ("--no-such-option", 2)])
def test_command_line(program, word, status, tmp_path):
    """A question does no work and replaces no table, and a slip does not either."""
    pytest.importorskip("scipy")
    before = state_of(REFERENCE)
    done = subprocess.run([sys.executable, program, word], cwd=tmp_path, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == status, done.stderr
    assert (done.stderr if status else done.stdout).startswith(f"usage: {program.name}")
    assert state_of(REFERENCE) == before and not list(tmp_path.iterdir())
