#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the C++ headers as one file, for those who copy one file: all that pw85/pw85.hpp includes.

Usage: scripts/single_header.py >pw85_all.hpp

The file needs a compiler for C++20 and its standard library, and can be in the same unit as the headers: each part keeps its include
guard.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ENTRY = "pw85/pw85.hpp"
INCLUDE = re.compile(r"#include <(pw85/[\w/]+\.hp?p?)>\n")


def version():
    return re.search(r"^ +version: '(.*)'", (ROOT / "meson.build").read_text(), re.MULTILINE)[1]


def merged(header, seen):
    """The text of a header, with that of each header of pw85 in the place of its first include."""
    seen.add(header)
    text = (ROOT / "include" / header).read_text(encoding="utf-8").rstrip("\n") + "\n"
    return f"// ---- {header}\n" + INCLUDE.sub(lambda found: merged(found[1], seen) if found[1] not in seen else "", text)


def main():
    licence = "".join(f"// {line}".rstrip() + "\n" for line in (ROOT / "LICENSE").read_text(encoding="utf-8").splitlines())
    sys.stdout.write(f"// pw85 {version()}: the C++ headers as one file, made by scripts/single_header.py.\n//\n{licence}"
                     f"#pragma once\n{merged(ENTRY, set())}")


if __name__ == "__main__":
    main()
