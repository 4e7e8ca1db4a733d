#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the rooms of src/, its folders, depend on each other downward only, and whether each source stands in its part.

    check_rooms.py SOURCE_DIR    complains about includes that lead upward, about circles, and about sources without a part

A room may include itself and the rooms that it stands on. A part is what a build can leave out (src/sources.txt): a source may include
headers of its own part and of the parts below. The libraries pw85_gpu and pw85_legacy have rooms, but no part.
"""

import re
import sys
from pathlib import Path

# The rooms from the bottom to the top, and what each stands on.
ROOMS = {
    "base": (),
    "periodic": (),
    "simd": ("base", "periodic"),
    "rare": ("base", "simd"),
    "any_dimension": ("base",),
    "brent": ("base", "simd"),
    "rows": ("base", "simd"),
    "shared": ("simd",),
    "lists": ("base", "periodic", "simd", "rows"),
    "forces": ("base", "periodic", "simd", "rows", "lists"),
    "neighbors": ("base", "periodic", "simd"),
    "enclosing": ("base", "any_dimension"),
    "meshes": ("base", "rows", "neighbors"),
    "simulation": ("base", "periodic", "simd", "rows", "neighbors"),
    "addition": ("base", "simd"),
    "c_api": ("base", "periodic", "simd", "any_dimension", "brent", "rows", "lists", "forces", "enclosing"),
    "gpu": ("base", "periodic", "simd"),
    "legacy": ("base",),
}
WITHOUT_PART = ("gpu", "legacy", "brent/brent_gsl.cpp", "brent/brent_boost.cpp")  # libraries of their own, and one of two
PARTS = ("contact", "geometry", "systems", "simulation")
# The rooms of the parts above contact, whole.
PART_OF_ROOM = {"periodic": "systems", "lists": "systems", "forces": "systems", "neighbors": "systems", "meshes": "systems",
                "simulation": "simulation", "addition": "simulation"}  # fmt: skip
# How the names of those headers of C begin that only sources of a part, and of those above it, include.
PART_OF_HEADER = {"pw85_systems": "systems", "pw85_gpu": "systems", "pw85_simulation": "simulation"}


def sources(src):
    """The sources of the folder, and the includes of each."""
    return {path.relative_to(src).as_posix(): re.findall(r'^#include ([<"])([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.MULTILINE)
            for path in sorted(src.rglob("*.[ch]pp"))}  # fmt: skip


def included(name, text):
    """The path in src/ of a header that a source includes."""
    parts = []
    for part in [*Path(name).parent.parts, *text.split("/")]:
        parts = parts[:-1] if part == ".." else [*parts, part]
    return "/".join(parts)


def part_of_header(header):
    return next((part for beginning, part in PART_OF_HEADER.items() if header.startswith(beginning)), "contact")


def parts_of_sources(src):
    return {name: part for part, name in (line.split() for line in (src / "sources.txt").read_text(encoding="utf-8").splitlines())}


def complaints_of_rooms(found):
    for below, room in ((below, room) for room, all_below in ROOMS.items() for below in all_below):
        if list(ROOMS).index(below) > list(ROOMS).index(room):
            yield f"{room} stands on {below}, which is above it"
    for name, includes in found.items():
        room = name.partition("/")[0]
        if room not in ROOMS:
            yield f"{name}: is in a room that is not in the list of {Path(__file__).name}"
            continue
        headers = [included(name, text) for mark, text in includes if mark == '"' and text != "instruction_sets.h"]
        allowed = (room, *ROOMS[room])
        yield from (f"{name}: includes {header}, which is above it" for header in headers if header.partition("/")[0] not in allowed)
        yield from (f"{name}: includes {header}, which is not there" for header in headers if header not in found)


def complaints_of_parts(found, part_of):
    for name, includes in found.items():
        room = name.partition("/")[0]
        if name.endswith(".hpp") or room in WITHOUT_PART or name in WITHOUT_PART:
            continue
        if name not in part_of:
            yield f"{name}: is not in sources.txt"
            continue
        part = part_of[name]
        if PART_OF_ROOM.get(room, part) != part:
            yield f"{name}: is of the part {part}, its room of {PART_OF_ROOM[room]}"
        for _, text in includes:
            if PARTS.index(part_of_header(text)) > PARTS.index(part):
                yield f"{name}: includes {text}, which a build with {part} need not have"
    yield from (f"{name}: is in sources.txt, and not there" for name in part_of if name not in found)


def main():
    src = Path(sys.argv[1]) / "src"
    found = sources(src)
    wrong = [*complaints_of_rooms(found), *complaints_of_parts(found, parts_of_sources(src))]
    print("\n".join(wrong))
    loops = [name for name in found if name != "base/parallel.hpp" and "pragma omp parallel" in (src / name).read_text(encoding="utf-8")]
    print("\n".join(f"{name}: starts threads, which base/parallel.hpp does for all" for name in loops))
    return 1 if wrong or loops or len(found) < 100 else 0


sys.exit(main())
