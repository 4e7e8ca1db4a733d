"""Does what README says, as a newcomer would, in a copy of the source: runs the tutorial, saves the program of the section
on C under the name that its commands use, runs these commands, and compares what is printed. Usage: check_readme.py SOURCE
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def commands(text):
    """The lines of the first indented block."""
    return re.search(r"(?:^ {4}.*\n)+", text, re.MULTILINE)[0]


def run(script, folder):
    environment = {name: value for name, value in os.environ.items() if name not in ("PKG_CONFIG_PATH", "LD_LIBRARY_PATH")}
    return subprocess.run(["sh", "-e", "-c", script], cwd=folder, env=environment, check=True, stdout=subprocess.PIPE,
                          encoding="utf-8").stdout


def built(source):
    return lambda folder, names: [name for name in names if Path(folder) == source
                                  and (name.startswith("build") or name in (".git", "install"))]


def main():
    source = Path(sys.argv[1])
    readme = (source / "README.md").read_text(encoding="utf-8")
    program, rest = re.search(r"^```c\n(.*?)^```\n(.*)", readme, re.MULTILINE | re.DOTALL).groups()
    expected = re.search(r"^```text\n(.*?)^```\n", rest, re.MULTILINE | re.DOTALL)[1]
    with tempfile.TemporaryDirectory(prefix="pw85-readme-") as folder:
        copy = Path(folder) / "pw85"
        shutil.copytree(source, copy, ignore=built(source))
        run(next(line.split("#")[0] for line in commands(readme).splitlines() if "tutorial" in line), copy)
        (copy / "program.c").write_text(program, encoding="utf-8")
        printed = run(commands(rest), copy)
    if printed != expected:
        sys.exit(f"README's program printed\n{printed}instead of\n{expected}")


main()
