#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether each folder of sources begins with a README that says what belongs there and what does not, and names files that exist.

    check_folders.py SOURCE_DIR    complains about folders without a README, long ones, titles of other folders, and names without a file
"""

import re
import sys
from pathlib import Path

ROOTS = ("src", "include/pw85", "python", "lammps", "tests")
CACHE = re.compile(r"(^|/)(__pycache__|\.)")
MOST_LINES = 12


def folders(source):
    """The folders that have files, by their paths in the source."""
    for root in ROOTS:
        for folder in sorted({path.parent.relative_to(source) for path in (source / root).rglob("*") if path.is_file()}):
            if not CACHE.search(folder.as_posix()):
                yield folder


def names(text):
    """The paths that a README names in backticks or as targets of links."""
    found = re.findall(r"(?:`|\]\()([\w./-]+)(?:`|\))", text)
    return [name for name in found if "/" in name or re.search(r"\.[a-z]+$", name)]


def exists(source, folder, name):
    """Whether a path is there, seen from the folder, the folder above, the source, or the folder of the C headers."""
    return any((place / name).exists() for place in (source / folder, (source / folder).parent, source, source / "include"))


def complaints(source, folder):
    path = source / folder / "README.md"
    if not path.is_file():
        yield f"{folder}: has no README.md"
        return
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    if len(lines) > MOST_LINES:
        yield f"{folder}/README.md: has {len(lines)} lines, more than {MOST_LINES}"
    if lines[0] != f"# {folder}":
        yield f"{folder}/README.md: begins with “{lines[0]}”, not with “# {folder}”"
    yield from (f"{folder}/README.md: names {name}, which does not exist" for name in names(text) if not exists(source, folder, name))


def main():
    source = Path(sys.argv[1])
    every = list(folders(source))
    wrong = [text for folder in every for text in complaints(source, folder)]
    print(f"{len(every)} folders", *wrong, sep="\n")
    return 1 if wrong or len(every) < 50 else 0


sys.exit(main())
