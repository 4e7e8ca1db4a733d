"""Does what README says, as a newcomer would, in a copy of the source: runs the tutorial and the commands of each language, and
compares what they print. Programs shown must be those in examples/, and the commands for Python those of the chapter on
installation, which another test runs. Usage: check_readme.py SOURCE
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
import itertools

EXAMPLES = {"c": "c/pair.c", "cpp": "cpp/pair.cpp", "fortran": "fortran/pair.f90", "python": "python/pair.py"}
COMPILERS = {"c": "cc", "cpp": "c++", "fortran": "gfortran"}
PYTHON = "docs/installation/python.sh"


def tutorial(text):
    """The first command of the first indented block."""
    return re.search(r"^ {4}(\S*tutorial\S*)", text, re.MULTILINE)[1]


def blocks(text):
    return re.findall(r"^```(\w+)\n(.*?)^```\n", text, re.MULTILINE | re.DOTALL)


def make_foreign_python(folder):
    """A python3 that is not that of the system, as that of pyenv or conda, and comes first on the path. It can do nothing."""
    folder.mkdir()
    (folder / "python3").write_text("#!/bin/sh\nexit 1\n", encoding="utf-8")
    (folder / "python3").chmod(0o755)


def run(script, folder):
    unset = ("PKG_CONFIG_PATH", "LD_LIBRARY_PATH", "CPATH", "LIBRARY_PATH")
    environment = {name: value for name, value in os.environ.items() if name not in unset}
    environment["PATH"] = f"{folder.parent / 'foreign'}:{environment['PATH']}"
    return subprocess.run(["sh", "-e", "-c", script], cwd=folder, env=environment, check=True, stdout=subprocess.PIPE,
                          encoding="utf-8").stdout


def built(source):
    return lambda folder, names: [name for name in names if Path(folder) == source
                                  and (name.startswith("build") or name in (".git", "install"))]


def shown_programs(source, listed):
    """What differs from the examples."""
    for language, path in EXAMPLES.items():
        if (language, (source / "examples" / path).read_text(encoding="utf-8")) not in listed:
            yield f"README does not show examples/{path} as it is"


def unknown_packages(source, text):
    """What README tells Debian's users to install, and tests do not, so that it may not suffice, or not be there."""
    installed = re.findall(r"[\w.+-]+", (source / "scripts/packages.sh").read_text(encoding="utf-8"))
    for packages in re.findall(r"`apt-get install ([^`]+)`", text):
        for package in packages.split():
            if package not in installed:
                yield f"README names the package {package}, which scripts/packages.sh does not have"


def main():
    source = Path(sys.argv[1])
    readme = (source / "README.md").read_text(encoding="utf-8")
    listed = blocks(readme)
    expected = next(text for language, text in listed if language == "text")
    wrong = [*shown_programs(source, listed), *unknown_packages(source, readme)]
    # The commands that follow the program of a language.
    commands = {language: after for (language, _), (kind, after) in itertools.pairwise(listed) if kind == "sh"}
    if commands["python"] not in (source / PYTHON).read_text(encoding="utf-8"):
        wrong.append(f"README's commands for Python are not those of {PYTHON}")
    with tempfile.TemporaryDirectory(prefix="pw85-readme-") as folder:
        copy = Path(folder) / "pw85"
        shutil.copytree(source, copy, ignore=built(source))
        make_foreign_python(Path(folder) / "foreign")
        run(tutorial(readme), copy)
        for language, compiler in COMPILERS.items():
            if not shutil.which(compiler):
                print(f"{language} is not tested, for lack of {compiler}")
                continue
            printed = run(commands[language], copy)
            if printed != expected:
                wrong.append(f"README's program in {language} printed\n{printed}instead of\n{expected}")
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
