# SPDX-License-Identifier: BSD-3-Clause
"""C++ headers of classes that own objects of the library, and of functions on objects and systems, made of the templates api/*.hpp.in.

A line of a template becomes a function that calls that of C of its name (cpp_calls.py):

    @function neighbors_check       a function of namespace pw85, by pw85_neighbors_check()
        options: NeighborOptions
    @member sweep                   a member of the class, by pw85_hard_ellipsoids_sweep()
    @member steps returns TrialSteps

"as" gives another name, and "without direction" passes null. A function that "returns" a type has its outputs in it, and the status if
it has such a member. Indented lines below give the C++ type of a parameter, with its default, or that of a struct that has several
parameters as members. api/committed.py writes the headers or compares them.
"""

import re

from cpp_calls import Call
from cpp_texts import FOLDER, TEMPLATES
from cpp_types import CLASSES
from declarations import c_functions

MARK = re.compile(
    r"^(?P<indent> *)@(?P<kind>member|function) (?P<name>\w+)(?: as (?P<own>\w+))?(?: without (?P<without>\w+))?"
    r"(?: returns (?P<type>\w+))?\n(?P<said>(?: *\w+: .*\n)*)",
    re.MULTILINE,
)


def definition(match, prefix, path):
    is_member, name = match["kind"] == "member", match["name"]
    place, c_name = f"{path.name}: @{match['kind']} {name}", f"pw85_{prefix * is_member}{name}"
    if c_name not in c_functions():
        raise ValueError(f"{place}: no function {c_name}()")
    types = dict(line.strip().split(": ", 1) for line in match["said"].splitlines())
    call = Call(c_functions()[c_name], types, is_member, match["without"], match["type"])
    unknown = {*types, match["without"]} - {None, *(one.name for one in call.listed), *(own for _, own, _ in call.described)}
    if unknown:
        raise ValueError(f"{place}: no such parameter: {', '.join(sorted(unknown))}")
    return "".join(f"{line}\n" for line in call.lines(match["own"] or name, match["indent"]))


def header(path):
    template = path.read_text(encoding="utf-8")
    owner = re.search(r"^class (\w+) \{", template, re.MULTILINE)
    prefixes = {kind: f"{c_name.removeprefix('pw85_')}_" for c_name, kind in CLASSES.items()}
    made = MARK.sub(lambda match: definition(match, prefixes[owner[1]] if owner else "", path), template)
    if left := re.search(r"^ *@(?!\{|\}).*", made, re.MULTILINE):
        raise ValueError(f"{path.name}: {left[0].strip()}: not understood")
    return made


def files():
    """The texts of the headers by their paths."""
    return {FOLDER / f"{name}.hpp": header(path) for name, path in TEMPLATES.items()}
