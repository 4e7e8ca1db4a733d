"""Runs README's commands and those of the chapter on installation, in the Test Anything Protocol.

Usage: check_installation.py SOURCE [--docs LIBRARY PROGRAM...]

In a copy of the source, with a home directory of its own and no more of the environment than a login shell has (and the variables of
ccache and pip): builds and installs the library by scripts/tutorial.sh, then builds and runs programs against it, and installs the
Python package into a fresh virtual environment. With --docs, it makes the tables and pictures instead, with what is built: the shared
library, the measuring programs, and the Python package on the path. Commands that install packages get an `apt-get` that looks whether
the packages are there; those of other systems are checked for syntax.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import check_readme

# Scripts of the chapter that are run, and the file with the output of their last command, if it is on record.
RUN = {
    "debian": None,
    "pkg-config": "examples/c/tutorial.txt",
    "fortran": "examples/fortran/closest_approach.txt",
    "python": "examples/c/pair.txt",
}
LANGUAGES = ("c", "cpp", "fortran")  # of README, whose commands for Python are those of the chapter
OTHER_SYSTEMS = ["fedora", "macos", "msys2"]
# What .ci/run runs itself.
ELSEWHERE = {"test": "scripts/test.sh"}
# Scripts that the test of the installation runs (tests/install/test_install.py --whole).
WHOLE = ["cmake"]
# Commands for the pages, which .ci/run pages gives in the build folder of the tests.
OF_DOCS = [
    "meson setup build-docs -Ddocs=enabled",
    "meson compile -C build-docs docs",
    "meson compile -C build-docs measurements",
    "meson compile -C build-docs pictures",
]

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


def run(command, folder, environment=None):
    """Whether a command succeeds, and its output."""
    done = subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8")
    return done.returncode == 0, done.stdout


def run_as_user(text, folder, home, tools):
    environment = {
        "HOME": str(home),
        "PATH": f"{tools}:/usr/local/bin:/usr/bin:/bin",
        "LANG": "C.UTF-8",
        # Each source alone: the library has the objects of the build of the tests, which ccache knows. The part `tutorial` of .ci/run
        # compiles as users do.
        "PW85_SETUP_OPTIONS": "-Djoined=false -Ddefault_library=both",
        **{name: value for name, value in os.environ.items() if name.startswith(("CCACHE_", "PIP_"))},
    }
    return run(["sh", "-e", "-c", text], folder, environment)


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


def copied(source, work):
    """A copy of the source."""
    copy = work / "pw85"
    shutil.copytree(source, copy, ignore=lambda folder, names: built(source, folder, names))
    return copy


def whole_lines(text):
    """The commands of a text, each on one line."""
    return [" ".join(line.split()) for line in text.replace("\\\n", "").splitlines()]


def checks_without_running(source):
    """As checks_of_commands, of the lists above and of what is not run."""
    scripts = scripts_of(source)
    known = {"build", "docs", "pictures", *RUN, *OTHER_SYSTEMS, *ELSEWHERE, *WHOLE}
    yield "each script has a check", lambda: (set(scripts) == known, f"{set(scripts) ^ known}")
    omitted = [line for name in ("docs", "pictures") for line in commands(scripts[name]) if line.startswith("meson")]
    yield "what makes the pages", lambda: (omitted == OF_DOCS, f"{omitted}")
    tutorial = (source / "scripts/tutorial.sh").read_text(encoding="utf-8")
    of_script = " \\\n    -Ddefault_library=shared -Djoined=true ${PW85_SETUP_OPTIONS-}"
    for word, by_user in (('"$build"', "build"), ("$prefix", "$HOME/.local"), (of_script, "")):
        tutorial = tutorial.replace(word, by_user)
    lines = whole_lines(tutorial)
    others = [line for line in whole_lines("\n".join(commands(scripts["build"]))) if line not in lines]
    yield "what builds is in scripts/tutorial.sh", lambda: (not others, f"{others}")
    for name in OTHER_SYSTEMS + WHOLE:
        yield f"syntax of {name}", lambda name=name: (subprocess.run(["sh", "-n", scripts[name]]).returncode == 0, "")
    for name, command in ELSEWHERE.items():
        yield name, lambda name=name, command=command: (commands(scripts[name]) == [command], "")


def all_commands(source):
    """Names, commands, and the output of the last of them, if it is on record."""
    readme = (source / "README.md").read_text(encoding="utf-8")
    of_languages = check_readme.commands_of_languages(readme)
    printed = next(text for language, text in check_readme.blocks(readme) if language == "text")
    yield "README without an installation", check_readme.without_installation(readme), printed
    yield "tutorial", check_readme.tutorial(readme), (source / "examples/c/tutorial.txt").read_text(encoding="utf-8")
    yield from ((f"README in {language}", of_languages[language], printed) for language in LANGUAGES)
    for name, file in RUN.items():
        text = scripts_of(source)[name].read_text(encoding="utf-8")
        yield name, text, (source / file).read_text(encoding="utf-8") if file else ""


def checks_of_commands(source, work):
    """Names of checks, and functions that return whether they pass, and what to print if not."""
    copy, home, tools = copied(source, work), work / "home", make_tools(work / "tools")
    home.mkdir()
    # The chapter installs into a folder of the user, which here is that of scripts/tutorial.sh.
    (home / ".local").symlink_to(copy / "install")

    def passes(text, expected):
        good, output = run_as_user(text, copy, home, tools)
        return good and output.endswith(expected), output

    for name, text, expected in all_commands(copy):
        yield name, lambda text=text, expected=expected: passes(text, expected)


def checks_of_docs(source, work, library, *programs):
    """As checks_of_commands. The tables and pictures are written beside the programs that make them, which is why these are copied."""
    copy, tools = copied(source, work), make_tools(work / "tools")
    packages = "\n".join(line for line in commands(scripts_of(copy)["docs"]) if line not in OF_DOCS)
    yield "packages", lambda: run_as_user(packages, copy, work, tools)
    for program, *words in (["bench/measure.py", *programs], ["docs/pictures/draw.py", library]):
        yield program, lambda command=(sys.executable, copy / program, *words): run(command, copy)


def main():
    source = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="pw85-docs-") as folder:
        work = Path(folder).resolve()
        if "--docs" in sys.argv:
            todo = list(checks_of_docs(source, work, *(Path(name).resolve() for name in sys.argv[3:])))
        else:
            todo = [*checks_without_running(source), *checks_of_commands(source, work)]
        print(f"1..{len(todo)}")
        for number, (name, check) in enumerate(todo, 1):
            good, output = check()
            if not good:
                print("\n".join(f"# {line}" for line in output.splitlines()))
            print(f"{'ok' if good else 'not ok'} {number} {name}", flush=True)


main()
