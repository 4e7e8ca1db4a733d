# SPDX-License-Identifier: BSD-3-Clause
"""The examples print what is on record."""

import os
import pathlib
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "examples"
EXPECTED = [
    ("pair", "c/pair.txt"),
    *((name, f"python/{name}.out") for name in ("tutorial", "check_witness", "suspension", "cull_splats")),
    ("hopper", "python/hopper.out"),
]
NEEDS = {"hopper": "meshio"}


@pytest.mark.parametrize("name, expected", EXPECTED)
def test_output(name, expected):
    if name in NEEDS:
        pytest.importorskip(NEEDS[name])
    done = subprocess.run([sys.executable, EXAMPLES / "python" / f"{name}.py"], capture_output=True, check=True)
    assert done.stdout.decode() == (EXAMPLES / expected).read_text(encoding="utf-8")
