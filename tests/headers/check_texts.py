#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the contracts still say something in the words of other languages.

    check_texts.py SOURCE_DIR

reads the files that api/ makes. A symbol that is replaced by another one must not be compared with itself ("sign of mu2 - mu2"), no
text must name the number of rows n where a function does not take it, and no line must begin with "+ ", which Markdown takes for an item of
a list.
"""

import re
import sys
from pathlib import Path

WITH_ITSELF = re.compile(r"(?<![\w.^·/*|\[])(\w+) (?:-|<|>|<=|>=|≤|≥) \1(?![\w(^·.\[])")
NUMBER_OF_ROWS = re.compile(r"\bfor n (?:pairs|rows|ellips\w+|points|lines|values|vectors)\b")
SUM_AS_ITEM = re.compile(r"^ *(?:///|\*|%|!>)? *\+ .*", re.MULTILINE)
# Functions of these take arrays, which know their numbers of rows.
WITHOUT_N = ("r/man/", "octave/inst/", "js/", "rust/pw85/", "include/pw85/batch/", "include/pw85/systems/")


def complaints(source):
    sys.path.insert(0, str(source / "api"))
    import committed

    for path, text in committed.files().items():
        name = path.relative_to(source).as_posix()
        plain = re.sub(r"\s*\n(?: *(?:///?|%|\*|!>) ?)?\s*", " ", text)  # sentences may go on in the next line
        yield from (f"{name}: {match[0]}" for match in WITH_ITSELF.finditer(plain))
        yield from (f"{name}: {match[0]}" for match in SUM_AS_ITEM.finditer(text))
        if name.startswith(WITHOUT_N):
            yield from (f"{name}: {match[0]}" for match in NUMBER_OF_ROWS.finditer(plain))


if __name__ == "__main__":
    found = list(complaints(Path(sys.argv[1]).resolve()))
    print("\n".join(found))
    sys.exit(1 if found else 0)
