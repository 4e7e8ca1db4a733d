# SPDX-License-Identifier: BSD-3-Clause
"""Writes a table of the functions of the C headers for the tests: the parameters of each function, and a call of it.

Usage: tables.py OUTPUT

writes the rows of the table that tests/functions.cpp includes.
"""

import sys
from pathlib import Path

from declarations import HOST_HEADERS, OBJECTS, PACKED, flattened, functions, members, members_read, parameters

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
RESULTS = {"void": "none", "int": "status", "double": "real"}  # results of other types are not used


def extent(one, names):
    if one == PACKED:
        return f"{{{names.index('n')}, packed}}"
    return f"{{-1, {one}}}" if isinstance(one, int) else f"{{{names.index(one)}, 0}}"


def powers(unit):
    """The powers of length and of time in a unit."""
    found = {"length": 0, "time": 0, "energy": 0}
    for sign, part in zip((1, -1), unit.split("/"), strict=False):
        name = part.rstrip("²³")
        if name in found:
            found[name] += sign * POWERS[part[len(name) :]]
    return found["length"], found["time"]


def row_of(parameter, names):
    shape = ", ".join(extent(one, names) for one in parameter.shape)
    unit = parameter.attributes.unit
    length, time = powers(unit)
    flags = (unit == "mixed units", parameter.pointer, parameter.is_output() or parameter.outer, parameter.nullable)
    listed = ", ".join(str(flag).lower() for flag in flags)
    return f'{{"{parameter.name}", Type::{TYPES[parameter.type]}, {length}, {time}, {listed}, {{{shape}}}}}'


def argument(index, parameter):
    if not parameter.pointer:
        return f"x[{index}].{TYPES[parameter.type]}"
    pointer = f"{parameter.type}{' const' if parameter.const else ''} *{'*' if parameter.outer else ''}"
    return f"static_cast<{pointer}>(x[{index}].pointer)"


def struct_of(function, struct, names):
    """The definition of a struct argument. Members that the function does not read are null, and array members are filled with
    ones."""
    read = {member.name: member for member in members_read(function, struct)}
    values = [argument(names.index(name), read[name]) if name in read else "nullptr" for name, _, _ in members(struct.type)]
    ones = ["{1, 1, 1}"] if struct.type == "pw85_system" else []
    return f"{struct.type} const {struct.name}{{{', '.join(values + ones)}}}; "


def lines(function):
    listed = flattened(function)
    names = [parameter.name for parameter in listed]
    structs = [parameter for parameter in parameters(function) if parameter.is_struct()]
    arguments = ", ".join(
        f"&{one.name}" if one.is_struct() else argument(names.index(one.name), one) for one in parameters(function)
    )
    defined = "".join(struct_of(function, struct, names) for struct in structs)
    call, result = f"{function.name}({arguments})", RESULTS.get(function.type, "other")
    body = {
        "status": f"return {{{call}, 0.0}};",
        "real": f"return {{0, {call}}};",
        "none": f"{call}; return {{}};",
        "other": f"static_cast<void>({call}); return {{}};",
    }[result]
    unused = "" if arguments else "[[maybe_unused]] "
    yield f'{{"{function.name}", Result::{result}, {{'
    yield from (f"    {row_of(parameter, names)}," for parameter in listed)
    yield f"}}, []({unused}Argument const *x) -> Answer {{ {defined}{body} }}}},"


def main(output):
    listed = [function for header in HOST_HEADERS for function in functions(header) if not function.is_of_simulations()]
    rows = [line for function in listed for line in lines(function)]
    Path(output).write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
