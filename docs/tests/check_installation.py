"""Runs the commands of the chapter on installation, in the Test Anything Protocol.

Usage: check_installation.py SOURCE [--docs]

In a copy of the source, with a home directory of its own and no more of the environment than a login shell has (and the variables of
ccache and pip): builds and installs the library, then builds and runs programs against it, and installs the Python package into a fresh
virtual environment. With --docs, it makes the pictures instead. Commands that install packages get an `apt-get` that looks
whether the packages are there; those of other systems are checked for syntax.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# Scripts in the order in which they are run, and the file with the output of their last command, if it is on record.
RUN = {
    "debian": None,
    "build": None,
    "pkg-config": "examples/c/tutorial.txt",
    "fortran": "examples/fortran/closest_approach.txt",
    "python": "examples/c/pair.txt",
}
RUN_DOCS = {"docs": None, "pictures": None}
OTHER_SYSTEMS = ["fedora", "macos", "msys2"]
# What .ci/run runs itself.
ELSEWHERE = {"test": "scripts/test.sh"}
# Scripts that the test of the installation runs (tests/install/test_install.py --whole).
WHOLE = ["cmake"]
# Commands that take minutes and that another test runs in its own build folder: docs_pages makes the pages.
RUN_BY_OTHER_TESTS = ["meson compile -C build-docs docs"]

TOOLS = {
    "sudo": 'exec "$@"',
    "python3": "echo 'a python3 that is not that of the system, as that of pyenv or conda' >&2; exit 1",
    "apt-get": """command -v dpkg-query >/dev/null || exit 0 # another system, where nothing is known of packages
[ "$1" = install ] && shift && for package; do
  dpkg-query -W -f '${Status}\\n' "$package" | grep -q 'ok installed' || { echo "$package is not installed"; exit 1; }
done""",
}


def make_tools(folder):
    folder.mkdir()
    for name, body in TOOLS.items():
        (folder / name).write_text(f"#!/bin/sh\n{body}\n", encoding="utf-8")
        (folder / name).chmod(0o755)
    return folder


def run(script, source, home, tools):
    lines = script.read_text(encoding="utf-8").splitlines()
    done = subprocess.run(
        ["sh", "-c", "\n".join(line for line in lines if line not in RUN_BY_OTHER_TESTS)],
        cwd=source,
        env={
            "HOME": str(home),
            "PATH": f"{tools}:/usr/local/bin:/usr/bin:/bin",
            "LANG": "C.UTF-8",
            "PW85_MEASURE_ONCE": "",
            **{name: value for name, value in os.environ.items() if name.startswith(("CCACHE_", "PIP_"))},
        },
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
    )
    return done.returncode == 0, done.stdout


def commands(script):
    lines = script.read_text(encoding="utf-8").splitlines()
    return lines[lines.index("# start") + 1 : lines.index("# end")]


def scripts_of(source):
    return {script.stem: script for script in (source / "docs" / "installation").glob("*.sh")}


def built(source, folder, names):
    """What is no source."""
    return [
        name for name in names if Path(folder) == source and (name.startswith("build") or name in (".git", "install"))
    ]


def checks_without_running(scripts):
    """As checks_of_commands, of the lists above and of what is not run."""
    known = {*RUN, *RUN_DOCS, *OTHER_SYSTEMS, *ELSEWHERE, *WHOLE}
    yield "each script has a check", lambda: (set(scripts) == known, f"{set(scripts) ^ known}")
    omitted = [line for name in RUN_DOCS for line in commands(scripts[name]) if line in RUN_BY_OTHER_TESTS]
    yield "what other tests run", lambda: (omitted == RUN_BY_OTHER_TESTS, f"{omitted}")
    for name in OTHER_SYSTEMS + WHOLE:
        yield f"syntax of {name}", lambda name=name: (subprocess.run(["sh", "-n", scripts[name]]).returncode == 0, "")
    for name, command in ELSEWHERE.items():
        yield name, lambda name=name, command=command: (commands(scripts[name]) == [command], "")


def checks_of_commands(source, work, expected_outputs):
    """Names of checks, and functions that return whether they pass, and what to print if not."""
    copy, home = work / "pw85", work / "home"
    shutil.copytree(source, copy, ignore=lambda folder, names: built(source, folder, names))
    home.mkdir()
    scripts = scripts_of(copy)
    tools = make_tools(work / "tools")

    def passes(name, expected):
        good, output = run(scripts[name], copy, home, tools)
        return good and (expected is None or output.endswith((copy / expected).read_text(encoding="utf-8"))), output

    for name, expected in expected_outputs.items():
        yield name, lambda name=name, expected=expected: passes(name, expected)


def main():
    source = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="pw85-docs-") as folder:
        work = Path(folder).resolve()
        if "--docs" in sys.argv:
            todo = list(checks_of_commands(source, work, RUN_DOCS))
        else:
            todo = [*checks_without_running(scripts_of(source)), *checks_of_commands(source, work, RUN)]
        print(f"1..{len(todo)}")
        for number, (name, check) in enumerate(todo, 1):
            good, output = check()
            if not good:
                print("\n".join(f"# {line}" for line in output.splitlines()))
            print(f"{'ok' if good else 'not ok'} {number} {name}", flush=True)


main()
