# SPDX-License-Identifier: BSD-3-Clause
"""The functions of C++ for many rows: headers with one function on std::span for each function of these kinds.

- include/pw85/batch/rows.hpp: functions that take n rows;
- include/pw85/systems/lists.hpp: functions that take a list of pairs and a system, and have rows for each pair.

A function of C becomes one of C++ of the same name, without the prefix and without `_2d`, which the types say. An array becomes a
span, and an output that may be null, but the first, a span that is empty by default. Outputs that are the members of a struct of
include/pw85/batch/values.hpp become that struct. Other functions of many rows are written by hand beside these headers.
api/committed.py writes the headers or compares them.
"""

import re
import textwrap
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from math import prod

import batch
from declarations import CPP_HEADERS, INCLUDE, c_functions, flattened, functions, parameters, referenced, sections, statuses
from voice import limits_of

FOLDER = INCLUDE / "pw85"
WIDTH = 100

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
    structs: dict  # the struct arguments: their declarations in C++, and what is said of them


# What the rows of an array of double are, by their extents: in space, and in the plane.
ELEMENTS = {
    3: {
        (): "double",
        (3,): "Vector<double, 3>",
        (6,): "SymmetricMatrix<double, 3>",
        (4,): "Vector<double, 4>",
        (3, 3): "Factor<double, 3>",
    },
    2: {(): "double", (2,): "Vector<double, 2>", (3,): "SymmetricMatrix<double, 2>"},
}
ELEMENTS_OF_OTHERS = {"unsigned char": "unsigned char", "int": "int", "pw85_motion": "Motion<double, 3>"}
SHORT_NAMES = {
    "std::span<Vector<double, 3> const>": "Vectors",
    "std::span<SymmetricMatrix<double, 3> const>": "Forms",
    "std::span<Vector<double, 2> const>": "FlatVectors",
    "std::span<SymmetricMatrix<double, 2> const>": "FlatForms",
}


def has_rows(listed, extent):
    """Whether all arrays have as many rows."""
    return all(one.shape[:1] == (extent,) if one.pointer else one.type in ("double", "int") for one in listed)


def is_of_rows(function):
    return function.parameter_names()[:1] == ["n"] and has_rows(parameters(function)[1:], "n")


def is_of_list(function):
    listed = parameters(function)
    return [one.type for one in listed[:2]] == ["pw85_pair_list", "pw85_system"] and has_rows(listed[2:], "num_pairs")


KINDS = (
    Kind(
        "batch/rows",
        "Functions of many pairs, ellipsoids, points or lines, one row for each: the functions of pw85_batch.h, on spans.",
        "pw85_batch.h",
        is_of_rows,
        "call_rows",
        {},
    ),
    Kind(
        "systems/lists",
        "Functions of the pairs of a list, in a system of particles: the functions of pw85_systems.h, on spans.",
        "pw85_systems.h",
        is_of_list,
        "call_pairs",
        {
            "PairList const &list": "indices of particles, with or without images",
            "Particles const &particles": "centres, forms and cell; sizes must fit, and indices be those of particles",
        },
    ),
)


@cache
def structs():
    """The structs of spans by the names of their members, all of which may be left out."""
    text = (FOLDER / "batch/values.hpp").read_text(encoding="utf-8")
    found = re.findall(r"^struct (\w+Spans) \{\n(.*?)^\};", text, re.MULTILINE | re.DOTALL)
    return {tuple(re.findall(r"(\w+) = \{\}", members)): name for name, members in found}


def is_of_plane(name):
    return name.endswith("_2d")


def plain(name):
    """The name in C++ of a function of C."""
    return re.sub(r"^pw85_|_2d$", "", name)


def span(function, parameter):
    """The type of a parameter in C++."""
    if not parameter.pointer:
        return parameter.type
    extents = parameter.shape[1:]
    if parameter.type != "double":
        element = ELEMENTS_OF_OTHERS[parameter.type]
    else:
        of_matrix = f"std::array<double, {prod(extents)}>"
        element = ELEMENTS[2 if is_of_plane(function.name) else 3].get(extents, of_matrix)
    written = f"std::span<{element}{' const' if parameter.const else ''}>"
    return SHORT_NAMES.get(written, written)


@cache
def names_in_cpp():
    """The functions of C that C++ has, too, and their names there."""
    made = [f"pw85/{kind.name}.hpp" for kind in KINDS]
    by_hand = {function.name for header in CPP_HEADERS if header not in made for function in functions(header)}
    return {
        name: plain(name)
        for name, function in c_functions().items()
        if plain(name) in by_hand or any(kind.has(function) for kind in KINDS)
    }


def in_cpp(text):
    """A sentence about C, with the names of C++."""
    text = re.sub(r"\b(pw85_\w+)\(\)", lambda match: f"{names_in_cpp().get(match[1], match[1])}()", text)
    return re.sub(r"#(PW85_\w+)", lambda match: f"Status::{statuses()[match[1]][0]}", text)


def returned(function):
    """What the comment of a function, or of one to which it refers, says of its status."""
    comments = (" ".join(other.comment.split()) for other in referenced(function, c_functions()))
    return next((found[1] for text in comments if (found := re.search(r"@return (.*?)(?= @|$)", text))), "the status")


def brief(function):
    text = re.sub(r"\bn (?=[a-z])", "many ", function.brief())
    if is_of_plane(function.name):
        text = text.replace("pairs", "pairs of ellipses")
    verb = "Computes " if re.match(r"\w+\(\)", text) else ""
    return f"{verb}{in_cpp(text)}: see {function.name}()."


def described(function, parameter):
    """What is said of a parameter, and what it has a row for."""
    text = "; ".join(filter(None, [in_cpp(parameter.text), *limits_of(parameter)]))
    if not parameter.pointer:
        return text
    counts = next(one for one in flattened(function) if one.name == parameter.shape[0])
    row = f"one for each {counts.attributes.rows.removesuffix('s')}{', or empty' if parameter.nullable else ''}"
    return f"{row}{': ' if parameter.text else '; '}{text}" if text else row


def comment(function, kind, listed, struct):
    yield from (brief(function), "")
    yield from (f"@param {declared.split('&')[1]} {text}" for declared, text in kind.structs.items())
    said = [(one.is_output(), described(function, one), one.name) for one in listed if not (struct and one.is_output())]
    for (is_output, text), group in groupby(said, lambda one: one[:2]):
        yield f"@param{'[out]' if is_output else ''} {','.join(name for _, _, name in group)} {text}"
    if struct:
        yield f"@param[out] out one row for each pair in all spans, or in some: see {function.name}()"
    yield f"@return {in_cpp(returned(function)).strip()}"


def wrapped(begin, arguments, end):
    yield from batch.wrapped(begin, arguments, end).split("\n")


def definition(function, kind):
    listed = parameters(function)[max(1, len(kind.structs)) :]
    outputs = [one for one in listed if one.is_output()]
    struct = structs().get(tuple(one.name for one in outputs))
    for line in comment(function, kind, listed, struct):
        yield from textwrap.wrap(line, WIDTH, initial_indent="/// ", subsequent_indent="/// ") or ["///"]
    written = [f"{span(function, one)} {one.name}{' = {}' if one.nullable and one is not outputs[0] else ''}" for one in listed]
    names = [one.name for one in listed]
    if struct:
        written[-len(outputs) :] = [f"{struct} const &out"]
        names[-len(outputs) :] = [f"out.{one.name}" for one in outputs]
    yield from wrapped(f"static inline StatusCode {plain(function.name)}(", [*kind.structs, *written], ") noexcept")
    yield "{"
    first = [declared.split("&")[1] for declared in kind.structs]
    yield from wrapped(f"    return detail::{kind.call}(", [function.name, *first, *names], ");")
    yield from ("}", "")


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
