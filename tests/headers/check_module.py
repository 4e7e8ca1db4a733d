# SPDX-License-Identifier: BSD-3-Clause
"""The module of docs/flags/grains.cppm, whose exported inline function calls pw85/linked.hpp: compilers that know modules compile it,
and a program that imports it gets right answers.

Usage: check_module.py SOURCE BUILD LIBRARY, with the folder of the library in the build
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
PROGRAM = """
import grains;
int main() { return balls_overlap(1.0, 1.9) && !balls_overlap(1.0, 2.0) ? 0 : 1; }
"""


def major(compiler):
    text = subprocess.run([compiler, "-dumpversion"], check=True, text=True, stdout=subprocess.PIPE).stdout
    return int(re.match(r"\d+", text)[0])


def commands(compiler, module, link):
    """The commands that make `program` of user.cpp; none if the compiler does not know modules."""
    known = major(compiler)
    if "clang" in compiler and known >= 16:
        made = [["--precompile", module, "-o", "grains.pcm"], ["-fmodule-file=grains=grains.pcm", "user.cpp", "grains.pcm", *link]]
    elif "clang" not in compiler and known >= 12:
        made = [["-fmodules-ts", "-x", "c++", "-c", module, "-o", "grains.o"], ["-fmodules-ts", "user.cpp", "grains.o", *link]]
    else:
        return []
    include = [word for word in link if word.startswith("-I")]
    return [[compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", *include, *words] for words in made]


def main():
    source, build, library = (Path(word).resolve() for word in sys.argv[1:])
    link = [f"-I{source / 'include'}", f"-I{build / 'include'}", f"-L{library}", "-lpw85", "-o", "program"]
    # ccache, where a compiler's name stands for it, restores the object of a module without its interface.
    environment = {**os.environ, "LD_LIBRARY_PATH": str(library), "CCACHE_DISABLE": "1"}
    tried = 0
    for compiler in filter(shutil.which, ("g++", "clang++", "clang++-19")):
        with tempfile.TemporaryDirectory(prefix="pw85-module-") as folder:
            (Path(folder) / "user.cpp").write_text(PROGRAM, encoding="utf-8")
            listed = commands(compiler, source / "docs/flags/grains.cppm", link)
            for command in listed:
                subprocess.run(command, cwd=folder, check=True, env=environment)
            if listed:
                subprocess.run([Path(folder) / "program"], check=True, env=environment)
                print(f"{compiler}: compiled and right")
                tried += 1
    return 0 if tried else SKIPPED


if __name__ == "__main__":
    sys.exit(main())
