"""Reads README. The program shown must be that in examples/, and the commands for Python those of the chapter on installation; each
language must have its commands, which check_installation.py runs. The first screen must have what a stranger looks for, and the page
must stay short. Usage: check_readme.py SOURCE
"""

import re
import sys
from pathlib import Path

EXAMPLES = {"c": "c/pair.c", "cpp": "cpp/pair.cpp", "fortran": "fortran/pair.f90", "python": "python/pair.py"}
HEADINGS = {"C": "c", "C++": "cpp", "Fortran": "fortran", "Python": "python"}
PYTHON = "docs/installation/python.sh"
SCREEN, MOST_LINES = 40, 180
# What the first screen has: the picture, the program, its output, both commands with their minutes, the manual.
ON_FIRST_SCREEN = (r"<img src=", r"^```python", r"^```text", r"tutorial\.sh .*minute", r"test\.sh .*minute", r"\]\(docs/index\.rst\)")


def tutorial(text):
    """The first command of the first indented block."""
    return re.search(r"^ {4}(\S*tutorial\S*)", text, re.MULTILINE)[1]


def without_installation(text):
    """The command that compiles and runs the program in C++ with the headers of the source, without its comment."""
    return re.search(r"^ {4}(c\+\+ .*?) +#", text, re.MULTILINE)[1]


def blocks(text):
    return re.findall(r"^```(\w+)\n(.*?)^```\n", text, re.MULTILINE | re.DOTALL)


def commands_of_languages(text):
    """The block of commands behind the name of each language, which begins a line in bold letters."""
    return {
        HEADINGS[heading]: commands
        for heading, commands in re.findall(r"^\*\*([\w+]+)\*\*(?:(?!^```).)*^```sh\n(.*?)^```\n", text, re.MULTILINE | re.DOTALL)
    }


def wrong_programs(source, text):
    """What differs from the examples, and languages without their program or their commands."""
    if ("python", (source / "examples" / EXAMPLES["python"]).read_text(encoding="utf-8")) not in blocks(text):
        yield f"README does not show examples/{EXAMPLES['python']} as it is"
    commands = commands_of_languages(text)
    for language, path in EXAMPLES.items():
        if f"](examples/{path})" not in text or f"examples/{path}" not in commands.get(language, ""):
            yield f"README does not name examples/{path}, or has no commands for it"


def wrong_layout(source, text):
    """A page that is too long, a first screen that lacks something, and links to files that do not exist."""
    lines = text.splitlines()
    if len(lines) > MOST_LINES:
        yield f"README has {len(lines)} lines, more than {MOST_LINES}"
    screen = "\n".join(lines[:SCREEN])
    yield from (f"README's first {SCREEN} lines lack {what}" for what in ON_FIRST_SCREEN if not re.search(what, screen, re.MULTILINE))
    for target in re.findall(r"\]\(([^)#:]+)\)", text):
        if not (source / target).exists():
            yield f"README links to {target}, which does not exist"


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
    wrong = [*wrong_programs(source, readme), *wrong_layout(source, readme), *unknown_packages(source, readme)]
    if commands_of_languages(readme)["python"] not in (source / PYTHON).read_text(encoding="utf-8"):
        wrong.append(f"README's commands for Python are not those of {PYTHON}")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
