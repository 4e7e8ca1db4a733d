"""The tutorial script prints what is on record."""

import os
import pathlib
import subprocess
import sys

EXAMPLES = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "examples" / "python"


def test_output():
    done = subprocess.run([sys.executable, EXAMPLES / "tutorial.py"], capture_output=True, check=True)
    assert done.stdout.decode() == (EXAMPLES / "tutorial.out").read_text(encoding="utf-8")
