# SPDX-License-Identifier: BSD-3-Clause
"""The functions of C++ for many rows: headers with one function on std::span for each function of these kinds.

- include/pw85/batch/rows.hpp: functions that take n rows;
- include/pw85/systems/lists.hpp: functions that take a list of pairs and a system, and have rows for each pair.

A function of C becomes one of C++ of the same name, without the prefix and without `_2d`, which the types say. An array becomes a
span, and an output that may be null, but the first, a span that is empty by default. Outputs that are the members of a struct of
include/pw85/batch/values.hpp become that struct. Other functions of many rows are written by hand beside these headers.
api/committed.py writes the headers or compares them.
"""

import textwrap
from dataclasses import dataclass

from cpp_calls import WIDTH, Call, wrapped
from cpp_texts import FOLDER, ROWS_HEADERS, is_of_list, is_of_rows, plain
from cpp_types import structs
from declarations import parameters, sections

BEGIN = """\
// SPDX-License-Identifier: BSD-3-Clause
/// @file
{brief}
///
/// Made from {part} by api/committed.py.
// clang-format off
#ifndef PW85_{guard}_HPP_INCLUDED
#define PW85_{guard}_HPP_INCLUDED

#include <{part}>

#include <pw85/{folder}/calls.hpp>

namespace pw85 {{

"""
END = """} // namespace pw85

#endif
"""


@dataclass
class Kind:
    """A header, and which functions it has."""

    name: str  # with its folder in include/pw85
    brief: str
    part: str  # the header of C that declares them
    has: object  # whether it has a function of C
    call: str  # of calls.hpp in its folder


KINDS = (
    Kind(
        ROWS_HEADERS[0],
        "Functions of many pairs, ellipsoids, points or lines, one row for each: the functions of pw85_batch.h, on spans.",
        "pw85_batch.h",
        is_of_rows,
        "call_rows",
    ),
    Kind(
        ROWS_HEADERS[1],
        "Functions of the pairs of a list, in a system of particles: the functions of pw85_systems.h, on spans.",
        "pw85_systems.h",
        is_of_list,
        "call_pairs",
    ),
)


def definition(function, kind):
    """Outputs that are the members of a struct of spans become that struct."""
    outputs = [one.name for one in parameters(function) if one.is_output()]
    struct = next((name for name, members in structs().items() if members == outputs and name.endswith("Spans")), None)
    call = Call(function, {"out": struct} if struct else {})
    places = [call.place(one) for one in call.listed if one.name != "n"]
    body = wrapped(f"    return detail::{kind.call}(", [function.name, *places], ");")
    yield from (*call.lines(plain(function.name), body=[line.removeprefix("    ") for line in body]), "")


def header(kind):
    lines = []
    for section in sections(kind.part):
        listed = [function for function in section.functions if kind.has(function)]
        if listed:
            lines += [f"/// @name {section.title}", "/// @{", ""]
            lines += [line for function in listed for line in definition(function, kind)]
            lines += ["/// @}", ""]
    guard, folder = kind.name.upper().replace("/", "_"), kind.name.split("/")[0]
    brief = textwrap.fill(kind.brief, WIDTH, initial_indent="/// ", subsequent_indent="/// ")
    begin = BEGIN.format(brief=brief, guard=guard, part=kind.part, folder=folder)
    return begin + "".join(f"{line}\n" for line in lines) + END


def headers():
    """The texts of the headers by their paths."""
    return {FOLDER / f"{kind.name}.hpp": header(kind) for kind in KINDS}
