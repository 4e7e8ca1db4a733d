#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the headers of include/pw85 depend on each other downward only.

    check_layers.py INCLUDE           complains about circles, about includes that lead upward, and about too many floors
    check_layers.py --list INCLUDE    prints the headers of C++, one a line

A folder may include itself and the folders that it stands on. The headers of the root are either the ground, which everything stands
on, or entries, which stand on everything. A header is one floor above the highest that it includes; its floor within a folder counts
the headers of that folder alone.
"""

import re
import sys
from pathlib import Path

GROUND = {"attributes.hpp", "requirements.hpp", "export.h", "last_error.h", "status.h", "status.hpp", "version.h"}

# The folders from the bottom to the top, and what each stands on.
STANDS_ON = {
    "ground": (),
    "algebra": ("ground",),
    "contact": ("ground", "algebra"),
    "overlap": ("ground", "algebra", "contact"),
    "shapes": ("ground", "algebra", "contact", "overlap"),
    "distance": ("ground", "algebra", "contact", "overlap", "shapes"),
    "volume": ("ground", "algebra", "contact", "overlap"),
    "bodies": ("ground", "algebra", "contact", "distance", "volume"),
    "motion": ("ground", "algebra", "contact"),
    "history": ("ground", "algebra", "contact"),
    "any_dimension": ("ground", "algebra", "contact", "overlap", "distance"),
    "batch": ("ground", "algebra", "motion"),
    "systems": ("ground", "algebra", "contact", "overlap", "shapes", "motion", "batch"),
    "simulation": ("ground", "algebra", "systems"),
    "entries": ("ground", "algebra", "contact", "overlap", "distance", "shapes", "volume", "bodies",
        "motion", "any_dimension", "batch", "systems", "simulation"),
}
MAX_FLOORS = 8  # of folders, and of headers within a folder


def headers(include):
    """The headers by their paths in include/pw85, and what each includes of the others."""
    root = include / "pw85"
    found = {}
    for path in sorted(root.rglob("*.h*")):
        if path.suffix in (".h", ".hpp"):
            text = path.read_text(encoding="utf-8")
            found[path.relative_to(root).as_posix()] = re.findall(r"^#include <pw85/(?!stop)(\S+)>", text, re.MULTILINE)
    return found


def folder(header):
    name, _, rest = header.partition("/")
    if rest:
        return name
    return "ground" if header in GROUND else "entries"


def floors(names, below):
    """The floor of each name; None if there is a circle."""
    floor = {}
    while len(floor) < len(names):
        ready = [name for name in names if name not in floor and all(other in floor for other in below(name))]
        if not ready:
            return None
        for name in ready:
            floor[name] = 1 + max((floor[other] for other in below(name)), default=0)
    return floor


def complaints(includes):
    for header, others in includes.items():
        here = folder(header)
        if here not in STANDS_ON:
            yield f"{header}: is in a folder that is not in the list of {Path(__file__).name}"
            continue
        allowed = (here, *STANDS_ON[here])
        yield from (f"{header}: includes {other}, which is above it" for other in others if folder(other) not in allowed)
    known = {header: [other for other in others if other in includes] for header, others in includes.items()}
    if floors(known, known.get) is None:
        yield "headers include each other in a circle"
        return
    between = floors(STANDS_ON, STANDS_ON.get)
    if max(between.values()) > MAX_FLOORS:
        yield f"the folders have {max(between.values())} floors"
    for name in STANDS_ON:
        inside = [header for header in known if folder(header) == name]
        floor = floors(inside, lambda header: [other for other in known[header] if folder(other) == name])
        print(f"{name}: {len(inside)} headers on {max(floor.values())} floors")
        if max(floor.values()) > MAX_FLOORS:
            yield f"{name}: its headers have {max(floor.values())} floors"


def main():
    include = Path(sys.argv[-1])
    includes = headers(include)
    if sys.argv[1] == "--list":
        print("\n".join(f"pw85/{header}" for header in includes if header.endswith(".hpp")))
        return 0
    found = list(complaints(includes))
    print("\n".join(found))
    return 1 if found or len(includes) < 40 else 0


sys.exit(main())
