"""Whether the installed source of the module compiles by itself, for compilers that cannot read another's module file.

Usage: check_source.py BUILD FOLDER COMPILER...
"""

import subprocess
import sys
import tempfile
from pathlib import Path

build, installed, *compiler = sys.argv[1:]
with tempfile.TemporaryDirectory(prefix="pw85-fortran-") as folder:
    subprocess.run(["meson", "install", "-C", build, "--no-rebuild", "--tags", "fortran-source", "--destdir", folder],
                   check=True)
    source = Path(folder) / installed.lstrip("/") / "pw85.f90"
    subprocess.run([*compiler, "-c", source], cwd=folder, check=True)
    if not (Path(folder) / "pw85.mod").exists():
        sys.exit("no module file")
