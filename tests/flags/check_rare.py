# SPDX-License-Identifier: BSD-3-Clause
"""Whether the tiers that hardly ever run are compiled once: of an archive, the units of src/rare/, and the folders
that have a question of their own, alone have functions with wider numbers.

Usage: check_rare.py NM ARCHIVE
"""

import re
import subprocess
import sys

WITH_WIDER = ("_rare_", "_volumes_baseline-unity", "any_dimension_", "enclosing_")  # that of volumes alone has another name, joined
WIDER = re.compile(r"Doubled<|Extended<|sign_of_terms")


def functions(nm, archive):
    """Pairs of a unit and one of its functions."""
    unit = None
    command = [nm, "--demangle", "--defined-only", archive]
    for line in subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines():
        if line.endswith(".o:"):
            unit = line[:-1]
        elif found := re.match(r"\S* [tTwW] (.*)", line):
            yield unit, found.group(1)


def main():
    wider = [(unit, name) for unit, name in functions(*sys.argv[1:]) if WIDER.search(name)]
    elsewhere = [(unit, name) for unit, name in wider if not any(part in unit for part in WITH_WIDER)]
    for unit, name in elsewhere:
        print(f"{unit}: {name}")
    print(f"{len(wider)} functions with wider numbers, {len(elsewhere)} of them elsewhere")
    return 1 if elsewhere or not wider else 0  # none at all: other names, of which this test knows nothing


sys.exit(main())
