"""Runs the commands of the chapter on installation, in the Test Anything Protocol. Usage: check_installation.py SOURCE

In a copy of the source, with a home directory of its own: builds and installs the library, then builds and runs
programs against it. Commands that install packages, or are tests themselves, are checked for syntax only.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

RUN = {
    "build": None,
    "pkg-config": "examples/c/tutorial.txt",
    "fortran": "examples/fortran/closest_approach.txt",
}


def run(script, source, home):
    done = subprocess.run(
        ["sh", script],
        cwd=source,
        env={**os.environ, "HOME": str(home)},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
    )
    return done.returncode == 0, done.stdout


def built(source, folder, names):
    """What is no source."""
    return [
        name for name in names if Path(folder) == source and (name.startswith("build") or name in (".git", "install"))
    ]


def main():
    source = Path(sys.argv[1])
    scripts = sorted((source / "docs" / "installation").glob("*.sh"))
    print(f"1..{len(scripts) + len(RUN)}")
    number = 0
    for script in scripts:
        number += 1
        good = subprocess.run(["sh", "-n", script]).returncode == 0
        print(f"{'ok' if good else 'not ok'} {number} syntax of {script.name}", flush=True)
    with tempfile.TemporaryDirectory(prefix="pw85-docs-") as folder:
        copy, home = Path(folder) / "pw85", Path(folder) / "home"
        shutil.copytree(source, copy, ignore=lambda folder, names: built(source, folder, names))
        home.mkdir()
        for name, expected in RUN.items():
            number += 1
            possible = name != "fortran" or shutil.which("gfortran")
            good, output = run(copy / "docs" / "installation" / f"{name}.sh", copy, home) if possible else (True, "")
            good = good and (
                not possible or expected is None or output == (copy / expected).read_text(encoding="utf-8")
            )
            if not good:
                print("\n".join(f"# {line}" for line in output.splitlines()))
            print(
                f"{'ok' if good else 'not ok'} {number} {name}{'' if possible else ' # SKIP no gfortran'}", flush=True
            )


main()
