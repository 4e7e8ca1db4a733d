# SPDX-License-Identifier: BSD-3-Clause
"""Names, types and texts in C++ of functions of C and their parameters."""

import re
from functools import cache
from math import prod

from declarations import CPP, c_functions
from layout import PART, camel
from public_headers import CPP_HEADERS, DETAIL, SYSTEMS, headers_in_folders, statuses, text_of
from refusals import refuse
from voice import with_limits

MANY = ("batch", "systems", "simulation", "history", "api")  # folders whose functions are not those of one row
WITH_MEMBERS = ("pw85_hard_ellipsoids", "pw85_random_addition")  # objects whose functions are members of their classes
# Types whose names do not follow from those of C.
TYPES = {"size_t": "std::size_t", "int32_t": "std::int32_t", "int64_t": "std::int64_t", "pw85_system": "Particles",
         "pw85_motion": "Motion<double, 3>"}  # fmt: skip
SHORT_NAMES = {
    "std::span<Vector<double, 3> const>": "Vectors",
    "std::span<SymmetricMatrix<double, 3> const>": "Forms",
    "std::span<Vector<double, 2> const>": "FlatVectors",
    "std::span<SymmetricMatrix<double, 2> const>": "FlatForms",
}
STRUCT = re.compile(r"^(?:template <[^>]*> )?struct (\w+) \{\n(.*?)^\};", re.MULTILINE | re.DOTALL)
MEMBERS = re.compile(r"^    (?!static |using )[\w:, ]+? \**(\w+(?:, \w+)*);", re.MULTILINE)
# Behind a value, what points to its numbers; .data() behind others.
ENDS = {"Cell": ".front().coordinates", "Vector": ".coordinates", "SymmetricMatrix": ".entries", "Factor": ".entries"}


def has_rows(listed, extent):
    """Whether all arrays have as many rows."""
    return all(one.rows == extent if one.pointer else one.type in ("double", "int") for one in listed)


def is_of_rows(function):
    return function.parameter_names()[:1] == ["n"] and has_rows(function.parameters[1:], "n")


def is_of_list(function):
    listed = function.parameters
    return [one.type for one in listed[:2]] == ["pw85_pair_list", "pw85_system"] and has_rows(listed[2:], "num_pairs")


def name_in_cpp(function):
    return function.plain.removesuffix("_2d")


def is_member(function):
    """Whether it is a member of the class of its first parameter."""
    return bool(function.parameters) and function.parameters[0].type in WITH_MEMBERS and not function.parameters[0].outer


@cache
def by_hand(header):
    """The text of a header without what is made."""
    return PART.sub("", text_of(header))


@cache
def names_in_cpp():
    """The functions of C that C++ has, too, and their names there."""
    known = {match["name"] for name in CPP_HEADERS for match in CPP.finditer(by_hand(name))}

    def is_in_cpp(one):
        is_of_systems = one.header in SYSTEMS and one.type == "int" and not is_member(one)
        return name_in_cpp(one) in known or is_of_systems or is_of_rows(one) or is_of_list(one)

    return {one.name: name_in_cpp(one) for one in c_functions().values() if is_in_cpp(one)}


@cache
def texts():
    """The headers in folders, without comments, details and what is made, by their names."""
    return {header: re.sub(r"//.*", "", DETAIL.sub("", by_hand(header))) for header in headers_in_folders()}


@cache
def homes(name):
    """The headers that define a function of namespace pw85 for one row."""
    form = re.compile(rf"\b{name}\([^;{{}}]*\)\s*noexcept\s*\{{")
    return [header for header, text in texts().items() if header.split("/")[1] not in MANY and form.search(text)]


@cache
def structs():
    """The members of the structs of the arguments and results, by the names of the structs; the status is the last one."""
    found = {}
    for text in texts().values():
        for name, body in STRUCT.findall(text):
            plain = re.sub(r"<[^;]*>|\[[^\]]*\]| = [^,;]*", "", body)
            found[name] = [name for listed in MEMBERS.findall(plain) for name in listed.split(", ")]
    return found


def type_in_cpp(kind):
    return TYPES.get(kind) or (camel(kind.removeprefix("pw85_")) if kind.startswith("pw85_") else kind)


def row_type(function, one):
    """The type of a row, or of an array of one row."""
    extents, n = one.row_shape, function.dimension
    if one.type == "double":
        is_cell = function.header in ("pw85_systems.h", "pw85_simulation_addition.h")
        known = {(): "double", (n,): f"Vector<double, {n}>", (n * (n + 1) // 2,): f"SymmetricMatrix<double, {n}>",
                 (4,): "Vector<double, 4>", (3, 3): "Cell" if is_cell else "Factor<double, 3>"}  # fmt: skip
        return known.get(extents) or f"std::array<double, {prod(extents)}>"
    if one.type == "int32_t" and extents == (2,):
        return "IndexPair"
    return f"std::array<{type_in_cpp(one.type)}, {prod(extents)}>" if extents else type_in_cpp(one.type)


def in_cpp(text):
    """A sentence about C, with the names of C++."""
    text = re.sub(r"\b(pw85_\w+)\(\)", lambda match: f"{names_in_cpp().get(match[1], match[1])}()", text)
    return re.sub(r"#(PW85_\w+)", lambda match: f"Status::{statuses()[match[1]][0]}", text)


def brief(function):
    text = re.sub(r"\bn (?=[a-z])", "many ", function.brief())
    if function.dimension == 2:
        text = text.replace("pairs", "pairs of ellipses")
    return f"{in_cpp(text)}: see {function.name}()."


def described(function, one):
    """What is said of a parameter, and what it has a row for."""
    text = with_limits(in_cpp(one.text), one)
    if not one.rows:
        return text
    counts = next(other for other in function.flattened if other.name == one.rows)
    refuse(counts.place, {"number of what? C++ names the rows": not counts.attributes.rows})
    of_row = counts.attributes.rows.replace("vertices", "vertex").removesuffix("s")
    row = f"one for each {of_row}{', or empty' if one.nullable else ''}"
    return f"{row}{': ' if one.text else '; '}{text}" if text else row
