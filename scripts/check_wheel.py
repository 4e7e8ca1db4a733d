# SPDX-License-Identifier: BSD-3-Clause
"""Checks a repaired wheel that is installed in an environment: the wheel contains the texts that licences require and nothing of
GSL, and the environment uses the libraries inside the wheel. scripts/test_wheel.sh runs it by the Python of the environment.

Usage: check_wheel.py FOLDER_OF_THE_WHEEL ENVIRONMENT
"""

import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pypw85

ROOT = Path(__file__).resolve().parent.parent
[wheel] = Path(sys.argv[1]).glob("*.whl")
environment = Path(sys.argv[2]).resolve()


def check(what, holds):
    print(f"{'ok' if holds else 'FAILED'}: {what}", flush=True)
    return bool(holds)


with zipfile.ZipFile(wheel) as archive:
    content = {name: archive.read(name) for name in archive.namelist()}
licence = [data for name, data in content.items() if name.endswith(".dist-info/LICENSE")]
binaries = [data for name, data in content.items() if ".so" in name]
loaded = {line.split()[-1] for line in Path("/proc/self/maps").read_text().splitlines() if ".so" in line}
tutorial = ROOT / "examples/python/tutorial.py"
printed = subprocess.run([sys.executable, tutorial], check=True, stdout=subprocess.PIPE, cwd=environment).stdout
sys.exit(not all([
    check(f"{wheel.name} is for the systems that the manual names",
          re.search(r"\bmanylinux_2_\d+", (ROOT / "docs/installation.rst").read_text())[0] in wheel.name),
    check("it contains the licence", licence == [(ROOT / "LICENSE").read_bytes()]),
    check("it contains the notice of three.js, if that is in it",
          "pypw85/three/three.min.js" not in content or b"three.js authors" in content["pypw85/viewer.html"]),
    check("it contains nothing of GSL", binaries and not any(b"gsl_" in data for data in binaries)),
    check("the package is that of the environment", Path(pypw85.__file__).is_relative_to(environment)),
    check("the run-time library of OpenMP is that of the wheel",
          [str(path) for path in loaded if "libgomp" in path and Path(path).is_relative_to(environment)]),
    check("the tutorial prints what it should", printed == (ROOT / "examples/python/tutorial.out").read_bytes()),
]))
