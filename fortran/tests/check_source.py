# SPDX-License-Identifier: BSD-3-Clause
"""Whether a program needs no more than the installed source of the module and libpw85, for compilers that cannot read another's
module file: `gfortran pw85.f90 PROGRAM -lpw85`.

Usage: check_source.py PROGRAM EXPECTED_OUTPUT BUILD FOLDER LIBRARY COMPILER...
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

program, expected, build, installed, library, *compiler = sys.argv[1:]
with tempfile.TemporaryDirectory(prefix="pw85-fortran-") as folder:
    subprocess.run(["meson", "install", "-C", build, "--no-rebuild", "--tags", "fortran-source", "--destdir", folder],
                   check=True)
    source = Path(folder) / installed.lstrip("/") / "pw85.f90"
    place = Path(library).resolve().parent
    subprocess.run([*compiler, source, Path(program).resolve(), "-o", "program", f"-L{place}", "-lpw85"], cwd=folder, check=True)
    printed = subprocess.run([Path(folder) / "program"], env={**os.environ, "LD_LIBRARY_PATH": str(place)}, check=True,
                             stdout=subprocess.PIPE, encoding="utf-8").stdout
if printed != Path(expected).read_text(encoding="utf-8"):
    sys.exit(f"{program} printed {printed!r}")
