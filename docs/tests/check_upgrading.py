# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the page on upgrading that compile a program of 1.0, and start one that was linked with the libraries of 1.0.

Usage: check_upgrading.py SOURCE BUILD
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LIBRARIES = ("pw85", "pw85_legacy")


def run(folder, *command, **environment):
    done = subprocess.run(command, cwd=folder, env={**os.environ, **environment}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          encoding="utf-8")
    if done.returncode != 0:
        sys.exit(f"{command}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def install(source, build, prefix):
    """The headers, links to the libraries, and the files of pkg-config, where they are found from each other."""
    shutil.copytree(source / "include", prefix / "include", ignore=shutil.ignore_patterns("*.in", "meson.build"))
    shutil.copy(build / "include/pw85/version.h", prefix / "include/pw85")
    libdir = re.search(r"^libdir=\$\{prefix\}/(.*)$", (build / "meson-private/pw85.pc").read_text(encoding="utf-8"), re.MULTILINE)[1]
    packages = prefix / libdir / "pkgconfig"
    packages.mkdir(parents=True)
    for name in LIBRARIES:
        shutil.copy(build / f"meson-private/{name}.pc", packages)
        for library in (build / "src").glob(f"lib{name}.so*"):
            if not library.is_dir():
                (prefix / libdir / library.name).symlink_to(library.resolve())
    return packages


def link_with_old_libraries(folder):
    """Makes old_program, which needs libraries that have no version in their names, as those of 1.0."""
    old = folder / "old"
    old.mkdir()
    (old / "library.c").write_text("void pw85_legacy_f2(void) {}\n", encoding="utf-8")
    run(old, "cc", "-shared", "-fPIC", "library.c", "-o", "libpw85_legacy.so")
    run(folder, "cc", "-c", "program.c", "-I", "prefix/include", "-o", "program.o")
    run(folder, "cc", "program.o", "-o", "old_program", "-L", "old", "-lpw85_legacy", "-lm")
    needed = run(folder, "readelf", "-d", "old_program")
    if "[libpw85_legacy.so]" not in needed:
        sys.exit(f"old_program does not need libpw85_legacy.so:\n{needed}")


def main():
    source, build = (Path(word).resolve() for word in sys.argv[1:3])
    with tempfile.TemporaryDirectory(prefix="pw85-upgrading-") as name:
        folder = Path(name)
        packages = install(source, build, folder / "prefix")
        shutil.copy(source / "tests/headers/program_of_1_0.c", folder / "program.c")
        link_with_old_libraries(folder)
        places = {"PKG_CONFIG_PATH": str(packages), "LD_LIBRARY_PATH": str(packages.parent)}
        compiling, links = (source / "docs/upgrading/compiled.sh").read_text(encoding="utf-8").split("# start links\n")
        printed = run(folder, "sh", "-c", compiling, **places)
        for library in packages.parent.glob("*.so"):  # those of the development files
            library.unlink()
        printed += run(folder, "sh", "-e", "-c", links, **places)
    version = re.search(r"version: '(.*?)'", (source / "meson.build").read_text(encoding="utf-8"))[1]
    expected = f"{version}\n16 digits\n16 digits\n"
    if printed != expected:
        sys.exit(f"printed {printed!r} instead of {expected!r}")


main()
