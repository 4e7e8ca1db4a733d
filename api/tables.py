# SPDX-License-Identifier: BSD-3-Clause
"""Writes a table of the functions of the C headers for the tests: the parameters of each function, and a call of it.

Usage: tables.py OUTPUT

writes the rows of the table that tests/functions.cpp includes.
"""

import re
from pathlib import Path

from causes import PACKED
from declarations import functions
from parameters import OBJECTS
from public_headers import HOST_HEADERS
from refusals import entry_of, run

TYPES = {
    "double": "real",
    "size_t": "size",
    "int": "integer",
    "int32_t": "int32",
    "int64_t": "int64",
    "unsigned char": "byte",
    "pw85_motion": "motion",
    **dict.fromkeys(OBJECTS, "handle"),
}
POWERS = {"": 1, "²": 2, "³": 3}
# How a call is answered, by the type of its result. Results of other types are not used.
RESULTS = {"void": ("none", "{}; return {{}};"), "int": ("status", "return {{{}, 0.0}};"), "double": ("real", "return {{0, {}}};")}


def extent(one, names):
    if one == PACKED:
        return f"{{{names.index('n')}, packed}}"
    return f"{{-1, {one}}}" if isinstance(one, int) else f"{{{names.index(one)}, 0}}"


def power(unit, name):
    """The power of a length or a time in a unit."""
    found = re.search(rf"(/?){name}([²³]?)", unit)
    return POWERS[found[2]] * (-1 if found[1] else 1) if found else 0


def row_of(parameter, names):
    shape = ", ".join(extent(one, names) for one in parameter.shape)
    unit, kind = parameter.attributes.unit, entry_of(TYPES, parameter.type, "TYPES of api/tables.py", parameter.place)
    flags = (unit == "mixed units", parameter.pointer, parameter.is_output() or parameter.outer, parameter.nullable)
    listed = ", ".join(str(flag).lower() for flag in flags)
    return f'{{"{parameter.name}", Type::{kind}, {power(unit, "length")}, {power(unit, "time")}, {listed}, {{{shape}}}}}'


def argument(one, names):
    if one.is_struct():
        return f"&{one.name}"
    place = f"x[{names.index(one.name)}]"
    if not one.pointer:
        return f"{place}.{TYPES[one.type]}"
    return f"static_cast<{one.type}{' const' if one.const else ''} *{'*' if one.outer else ''}>({place}.pointer)"


def lines(function):
    names, defined = [one.name for one in function.flattened], ""
    for struct in (one for one in function.parameters if one.is_struct()):  # whose array members are filled with ones
        values = function.values_of_members(struct, lambda one: argument(one, names))
        values += ["{1, 1, 1}"] * (struct.type == "pw85_system")
        defined += f"{struct.type} const {struct.name}{{{', '.join(values)}}}; "
    result, called = RESULTS.get(function.type, ("other", "static_cast<void>({}); return {{}};"))
    called = called.format(f"{function.name}({', '.join(argument(one, names) for one in function.parameters)})")
    yield f'{{"{function.name}", Result::{result}, {{'
    yield from (f"    {row_of(one, names)}," for one in function.flattened)
    yield f"}}, []({'' if names else '[[maybe_unused]] '}Argument const *x) -> Answer {{ {defined}{called} }}}},"


def main(output):
    listed = [function for function in functions(*HOST_HEADERS) if not function.is_of_simulations()]
    rows = [line for function in listed for line in lines(function)]
    Path(output).write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    run(main)
