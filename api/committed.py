# SPDX-License-Identifier: BSD-3-Clause
"""Makes the files that follow from the headers and are committed, because builds without the generators need them.

Usage: committed.py [check]

writes them all; with `check` names those whose text differs, and fails if there is one.
"""

import sys

import batch
import declarations
import fortran
import linked
import shims
import spans
import symbols
from declarations import SOURCE


def files():
    """The texts of all of them by their paths."""
    made = batch.header()
    declarations.replace({"pw85_batch.h": made})  # from which the others follow
    return {batch.HEADER: made, fortran.MODULE: fortran.module()} | shims.files() | symbols.files() | spans.headers() | linked.files()


def main(check=None):
    if check not in (None, "check"):
        sys.exit(f"{check}: the only option is check")
    different = []
    for path, text in files().items():
        if check and (not path.exists() or path.read_text(encoding="utf-8") != text):
            different.append(path.relative_to(SOURCE))
        elif not check:
            path.write_text(text, encoding="utf-8")
    sys.exit("".join(f"{path} is not what api/committed.py makes of the headers: run it\n" for path in different) or 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
