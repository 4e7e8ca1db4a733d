# SPDX-License-Identifier: BSD-3-Clause
"""Prints the section of CHANGELOG.md for a version, for the page of a release. Usage: release_notes.py VERSION

It fails unless the section has a date, and the version is that of meson.build. Each paragraph and each item is one line, because hosts
show the line breaks of such a page.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def section(text, version):
    """The lines of a section without its heading; None unless there is one, with a date."""
    found = re.search(rf"^## \[{re.escape(version)}\] - \d{{4}}-\d\d-\d\d\n(.*?)(?=^## |\Z)", text, re.DOTALL | re.MULTILINE)
    return found and found[1].strip()


def with_long_lines(markdown):
    """The text with the lines of each paragraph and of each item joined."""
    return re.sub(r"(?<=\S)\n *(?=[^\s#-]|-\S)", " ", markdown)


def version_of_sources():
    return re.search(r"project\(\s*'pw85',.*?version: '([^']+)'", (ROOT / "meson.build").read_text(encoding="utf-8"), re.DOTALL)[1]


def main():
    version = sys.argv[1]
    if version != version_of_sources():
        sys.exit(f"meson.build says that this is version {version_of_sources()}")
    notes = section((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), version)
    if not notes:
        sys.exit(f"CHANGELOG.md has no section for {version} with a date")
    print(with_long_lines(notes))


if __name__ == "__main__":
    main()
