# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the C API on objects that the library owns, src/c_api/objects_*.cpp: neighbour lists, meshes, simulations.

A made function marks its outputs, checks its arguments by what their declarations say (src/base/checked_call.hpp), and calls the
function of namespace pw85::detail of the same name, which is written by hand and declared in src/base/objects.hpp. This gets
references in the place of pointers to objects and structs that must not be null. Functions without status are written by hand.
"""

from math import prod

import batch
from declarations import OBJECTS, SIMULATION, SOURCE, functions, members_read, parameters
from shims import limits

FOLDER = SOURCE / "src/c_api"
NAMES = {header: "objects_" + header.removeprefix("pw85_").removesuffix(".h") for header in ("pw85_systems.h", *SIMULATION)}
MARKS = {"NaN": "quiet_nan<double>()", "null": "nullptr"}
BEGIN = """\
// SPDX-License-Identifier: BSD-3-Clause
{what}
//
// Made from {headers} by api/committed.py.
// clang-format off
"""


def is_reference(one):
    return not one.nullable and (one.type in OBJECTS or one.is_struct())


def declared(function, one, written):
    """A parameter of the function that works."""
    if not is_reference(one):
        return written
    return f"{one.type} {'const &' if one.const else '*&' if one.outer else '&'}{one.name}"


def worker(function):
    """The declaration of the function that works."""
    listed = [declared(function, one, text) for one, text in zip(parameters(function), function.parameters)]
    return batch.wrapped(f"int {function.name.removeprefix('pw85_')}(", listed, ") noexcept;")


def is_fixed(one):
    return all(isinstance(extent, int) for extent in one.shape)


def marked(one):
    """The statement that fills an output with what it is on error; none if it stays as it is."""
    value = one.attributes.on_error or ("NaN" if one.type == "double" and is_fixed(one) else "")
    if not value or not (one.is_output() or one.outer):
        return []
    return [f"    mark({one.name}, {' * '.join(map(str, one.shape)) or 1}, {MARKS.get(value, value)});"]


def checked(one, places):
    """An argument for the check; none where each value is allowed. `places` are those of members of structs."""
    place, flags = places.get(one.name, one.name), [limits(one), "limit::optional" if one.nullable else ""]
    end = "".join(f", {text}" for text in [" | ".join(filter(None, flags))] if text)
    rows = "" if is_fixed(one) else places.get(one.shape[0], one.shape[0])
    if one.type != "double" or one.is_output():
        if one.nullable or not one.pointer:
            return []
        return [f'Argument::array("{one.name}", {place}, {rows})' if rows else f'Argument("{one.name}", {place})']
    if rows:
        return [f'Argument::rows("{one.name}", {place}, {rows}, {prod(one.shape[1:])}{end})']
    return [f'Argument("{one.name}", {place}{f", {prod(one.shape)}" if one.pointer else ""}{end})']


def arguments(function):
    """The arguments for the check, with the members of structs that must not be null. The functions check cells by themselves."""
    places = {}
    for one in parameters(function):
        yield from checked(one, places)
        if one.is_struct() and is_reference(one):
            read = [member for member in members_read(function, one) if member.name != "cell"]
            places |= {member.name: f"{one.name}_given.{member.name}" for member in read}
            for member in read:
                yield from checked(member, places) if member.pointer else ()


def shim(function):
    listed = parameters(function)
    passed = [f"*{one.name}" if is_reference(one) else one.name for one in listed]
    structs = [one.name for one in listed if one.is_struct() and is_reference(one)]
    work = batch.wrapped(f"    auto const work = [&] {{ return {function.name.removeprefix('pw85_')}(", passed, "); };")
    lines = [
        "",
        batch.wrapped(f"int {function.name}(", [*function.parameters], ")"),
        "{",
        *(line for one in listed for line in marked(one)),
        *(f"    auto const {name}_given = value_or_empty({name});" for name in structs),
        work,
        batch.wrapped("    return checked_call(", [f'"{function.name}"', "work", *arguments(function)], ");"),
        "}",
    ]
    return "\n".join(lines) + "\n"


def files():
    """The texts of the files by their paths."""
    made, declarations = {}, []
    for header, name in NAMES.items():
        listed = [function for function in functions(header) if function.is_of_object()]
        text = BEGIN.format(what=f"// The C API of objects: the functions of {header}.", headers=header)
        text += '#include "../base/checked_call.hpp"\n#include "../base/objects.hpp"\n\nusing namespace pw85::detail;\n'
        made[FOLDER / f"{name}.cpp"] = text + "".join(map(shim, listed))
        declarations += map(worker, listed)
    what = "/// @file\n/// The functions that work on objects, each called by the function of the C API of its name."
    lines = [
        BEGIN.format(what=what, headers="pw85_systems.h and the parts of pw85_simulation.h").rstrip(),
        "#ifndef PW85_BASE_OBJECTS_HPP_INCLUDED",
        "#define PW85_BASE_OBJECTS_HPP_INCLUDED",
        "",
        "#include <pw85_simulation.h>",
        "",
        "namespace pw85::detail {",
        "",
        *declarations,
        "",
        "} // namespace pw85::detail",
        "",
        "#endif",
    ]
    return made | {SOURCE / "src/base/objects.hpp": "\n".join(lines) + "\n"}
