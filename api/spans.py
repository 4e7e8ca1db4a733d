"""The functions of rows of C++: include/pw85/batch/rows.hpp, one on std::span for each function of pw85.h that takes n rows.

Usage: spans.py [check]

writes the header, or compares it with what it would write. A function of C becomes one of C++ of the same name, without the prefix
and without `_2d`, which the types say. An array of n rows becomes a span, and an output that may be null, but the first, a span that
is empty by default. Functions that take structs are written by hand beside it.
"""

import re
import sys
import textwrap
from functools import cache
from itertools import groupby

from committed import write_or_compare
from declarations import CPP_HEADERS, INCLUDE, SHAPE, c_functions, functions, parameters, referenced, sections, statuses

HEADER = INCLUDE / "pw85/batch/rows.hpp"
WIDTH = 120
BY_HAND = {"pw85_contact_derivatives_batch"}  # its outputs are the members of a struct

BEGIN = """\
/// @file
/// Functions of many pairs, ellipsoids, points or lines, one row for each: the functions of pw85.h, on spans.
///
/// Made from pw85.h by api/spans.py.
#ifndef PW85_BATCH_ROWS_HPP_INCLUDED
#define PW85_BATCH_ROWS_HPP_INCLUDED

#include <pw85/batch/calls.hpp>

namespace pw85 {

"""
END = """} // namespace pw85

#endif
"""

# What the rows of an array of double are, by their extents: in space, and in the plane.
ELEMENTS = {
    3: {(): "double", (3,): "Vector<double, 3>", (6,): "SymmetricMatrix<double, 3>", (4,): "Vector<double, 4>"},
    2: {(): "double", (2,): "Vector<double, 2>", (3,): "SymmetricMatrix<double, 2>"},
}
ELEMENTS_OF_OTHERS = {"unsigned char": "unsigned char", "int": "int", "pw85_motion": "Motion<double, 3>"}
SHORT_NAMES = {
    "std::span<Vector<double, 3> const>": "Vectors",
    "std::span<SymmetricMatrix<double, 3> const>": "Forms",
    "std::span<Vector<double, 2> const>": "FlatVectors",
    "std::span<SymmetricMatrix<double, 2> const>": "FlatForms",
}


def is_of_rows(function):
    """Whether all arrays of a function have n rows, the number that comes first."""
    if function.parameter_names()[:1] != ["n"] or function.name in BY_HAND:
        return False
    _, *rest = parameters(function)
    return all(one.shape[:1] == ("n",) if one.pointer else one.type == "double" for one in rest)


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
    elif len(extents) == 2:
        element = f"std::array<double, {extents[0] * extents[1]}>"
    else:
        element = ELEMENTS[2 if is_of_plane(function.name) else 3][extents]
    written = f"std::span<{element}{' const' if parameter.const else ''}>"
    return SHORT_NAMES.get(written, written)


@cache
def names_in_cpp():
    """The functions of C that C++ has, too, and their names there."""
    by_hand = {function.name for header in CPP_HEADERS if INCLUDE / header != HEADER for function in functions(header)}
    return {name: plain(name) for name, function in c_functions().items() if plain(name) in by_hand or is_of_rows(function)}


def in_cpp(text):
    """A sentence about C, with the names of C++."""
    text = re.sub(r"\b(pw85_\w+)\(\)", lambda match: f"{names_in_cpp().get(match[1], match[1])}()", text)
    return re.sub(r"#(PW85_\w+)", lambda match: f"Status::{statuses()[match[1]][0]}", text)


def first_said(function, pattern):
    """What the comments of a function and of those to which it refers say first."""
    return next(found[1] for other in referenced(function, c_functions())
                if (found := re.search(pattern, " ".join(other.comment.split()))))


def brief(function):
    text = re.sub(r"\bn (?=[a-z])", "many ", function.brief())
    if is_of_plane(function.name):
        text = text.replace("pairs", "pairs of ellipses")
    return f"{in_cpp(text)}: see {function.name}()."


def described(function, parameter):
    """The sentence of a parameter: instead of its shape, what it has a row for."""
    if not parameter.pointer:
        return in_cpp(parameter.text)
    rest = re.sub(r"^ each\b|[,;]? (?:or null|any output may be null)", "", SHAPE.sub("", parameter.text, count=1))
    row = first_said(function, r"@param n number of (\w+)s")
    return f"one for each {row}{', or empty' if parameter.nullable else ''}{in_cpp(rest)}"


def comment(function, listed):
    yield from (brief(function), "")
    for (is_output, text), group in groupby(listed, lambda one: (one.is_output(), described(function, one))):
        yield f"@param{'[out]' if is_output else ''} {','.join(one.name for one in group)} {text}"
    yield f"@return {in_cpp(first_said(function, r'@return (.*?)(?= @|$)')).strip()}"


def wrapped(begin, arguments, end):
    """A list of arguments that begins and ends so, in lines that are aligned with its bracket."""
    text = ", ".join(argument.replace(" ", "\0") for argument in arguments) + end.replace(" ", "\0")
    indent = begin.index("(") + 1
    lines = textwrap.wrap(text, WIDTH - indent, break_long_words=False, break_on_hyphens=False)
    yield from (f"{' ' * indent if i else begin}{line}".replace("\0", " ") for i, line in enumerate(lines))


def definition(function):
    _, *listed = parameters(function)
    outputs = [one for one in listed if one.is_output()]
    for line in comment(function, listed):
        yield from textwrap.wrap(line, WIDTH, initial_indent="/// ", subsequent_indent="/// ") or ["///"]
    written = [f"{span(function, one)} {one.name}{' = {}' if one.nullable and one is not outputs[0] else ''}" for one in listed]
    yield from wrapped(f"static inline Status {plain(function.name)}(", written, ") noexcept")
    yield "{"
    yield from wrapped("    return detail::call_rows(", [function.name, *(one.name for one in listed)], ");")
    yield from ("}", "")


def header():
    lines = []
    for section in sections("pw85.h"):
        listed = [function for function in section.functions if is_of_rows(function)]
        if listed:
            lines += [f"/// @name {section.title}", "/// @{", ""]
            lines += [line for function in listed for line in definition(function)]
            lines += ["/// @}", ""]
    return BEGIN + "".join(f"{line}\n" for line in lines) + END


if __name__ == "__main__":
    write_or_compare(HEADER, header(), *sys.argv[1:] or [None])
