#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of conventions.rst again, from the data by which tables are read: conventions.py [--check]."""

import importlib.util
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/conventions.rst"
HEAD = """.. list-table:: Conventions
   :header-rows: 1
   :widths: 10 25 11 9 30 15

   * - name
     - program
     - lengths
     - first pixel
     - angles
     - how known
"""
WORDS = {"diameters": "whole axes", "radii": "semi-axes", "rms": "RMS lengths"}


def conventions():
    """The module of data, which imports nothing of the package."""
    found = importlib.util.spec_from_file_location("conventions_data", ROOT / "python/pypw85/formats/_conventions.py")
    module = importlib.util.module_from_spec(found)
    sys.modules[found.name] = module
    found.loader.exec_module(module)
    return module.CONVENTIONS


def table():
    rows = []
    for one in conventions():
        angles = f"{one.unit}, {one.describe_angles()}" if one.angles[0] else "none"
        rows += [f"   * - ``{one.name}``", f"     - {one.program}", f"     - {WORDS[one.meaning]}", f"     - {one.first or 'no pixels'}",
                 f"     - {angles}", f"     - {'run: ' + one.run if one.run else 'its documents; not run'}"]  # fmt: skip
    return HEAD + "\n".join(rows) + "\n"


def main():
    text = PAGE.read_text(encoding="utf-8")
    begin, rest = text.split(".. conventions table begins\n")
    end = rest.split(".. conventions table ends")[1]
    wanted = f"{begin}.. conventions table begins\n\n{table()}\n.. conventions table ends{end}"
    if sys.argv[1:] == ["--check"]:
        return 0 if wanted == text else "docs/conventions.rst is not made of the data: run docs/conventions.py"
    PAGE.write_text(wanted, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
