# SPDX-License-Identifier: BSD-3-Clause
"""Makes the files that follow from the headers and are committed, because builds without the generators need them.

Usage: committed.py [check]

writes them all; with `check` names those whose text differs, and fails if there is one.
"""

import sys

import batch
import classes
import fortran
import javascript
import linked
import objects
import octave
import r
import rare
import rust
import shims
import symbols
from declarations import functions
from layout import PART
from public_headers import EVERY_HEADER, SOURCE, replace
from refusals import run

PROGRAMS = (fortran, batch, shims, objects, symbols, linked, classes, rare, r, octave, javascript, rust)


def files():
    """The texts of all of them by their paths, and the list for diffs and reviews of those that are made as a whole."""
    replace({batch.HEADER: batch.header()})  # from which the others follow
    for function in functions(*EVERY_HEADER):
        _ = function.flattened, function.is_nan_on_error()  # also where no program needs all attributes
    made = {SOURCE / name: text for program in PROGRAMS for name, text in program.files().items()}
    marks = (f"{path.relative_to(SOURCE)} linguist-generated\n" for path in sorted(made) if PART.search(made[path]) is None)
    return made | {SOURCE / ".gitattributes": "# Made by api/committed.py, as all files in this list.\n" + "".join(marks)}


def main(check=None):
    if check not in (None, "check"):
        sys.exit(f"{check}: the only option is check")
    made = files()
    marked = [path for path in (SOURCE / shims.FOLDER).glob("*.cpp") if shims.MARK in path.read_text(encoding="utf-8")]
    different = [path.relative_to(SOURCE) for path in marked if check and path not in made]
    for path, text in made.items():
        if check and (not path.exists() or path.read_text(encoding="utf-8") != text):
            different.append(path.relative_to(SOURCE))
        elif not check:
            path.write_text(text, encoding="utf-8")
    sys.exit("".join(f"{path} is not what api/committed.py makes of the headers: run it\n" for path in different) or 0)


if __name__ == "__main__":
    run(main)
