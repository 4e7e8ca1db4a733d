# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the C API on systems of particles, and on objects that the library owns (neighbour lists, meshes, simulations), in
src/c_api/objects_*.cpp.

A made function marks its outputs, checks its arguments by what their declarations say (src/base/checked_call.hpp), and calls the
function of namespace pw85::detail of the same name, which is written by hand and declared in src/base/objects.hpp. This gets
references in the place of pointers to objects and structs that must not be null. Functions without status are written by hand.
"""

from declarations import functions
from layout import arguments, cpp_header
from parameters import OBJECTS
from public_headers import SYSTEMS
from shims import FOLDER, HEAD, by_hand, described

INCLUDES = '#include "../base/checked_call.hpp"\n#include "../base/objects.hpp"'
MARKS = {"NaN": "quiet_nan<double>()", "null": "nullptr"}
HEADER = """\
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions that work on objects, each called by the function of the C API of its name.

#include <pw85_simulation.h>

namespace pw85::detail {{

{declarations}

}} // namespace pw85::detail
"""


def is_of_object(function):
    """Whether a function has a status, and a system or an object of the library."""
    return function.type == "int" and any(one.type in (*OBJECTS, "pw85_system") for one in function.parameters)


def is_reference(one):
    return not one.nullable and (one.type in OBJECTS or one.is_struct())


def worker(function):
    """The declaration of the function that works."""
    marks = [" const &" if one.const else " *&" if one.outer else " &" for one in function.parameters]
    listed = [f"{one.type}{mark}{one.name}" if is_reference(one) else written
              for one, mark, written in zip(function.parameters, marks, function.written)]  # fmt: skip
    return arguments(f"int {function.plain}(", listed, ") noexcept;")


def checked_arguments(function, places):
    """The arguments for the check, with the members of structs that must not be null. The functions check cells by themselves."""
    for one in function.parameters:
        inner = function.members_read(one) if one.is_struct() and is_reference(one) else []
        for checked in (one, *(member for member in inner if member.pointer and member.name != "cell")):
            if (checked.type == "double" and not checked.is_output()) or (checked.pointer and not checked.nullable):
                yield described(checked, places)


def shim(function):
    passed = [f"*{one.name}" if is_reference(one) else one.name for one in function.parameters]
    structs = [one for one in function.parameters if one.is_struct() and is_reference(one)]
    places = {member: f"{one.name}_given.{member}" for one in structs for member in one.member_names()}  # null structs being empty
    lines = [
        "",
        arguments(f"int {function.name}(", function.written, ")"),
        "{",
        *(f"    auto const {one.name}_given = value_or_empty({one.name});" for one in structs),
        *(f"    mark({one.name}, {' * '.join(map(str, one.shape)) or 1}, {(MARKS | places).get(value, value)});"
          for one in function.parameters if (value := one.value_on_error())),
        arguments(f"    auto const work = [&] {{ return {function.plain}(", passed, "); };"),
        arguments("    return checked_call(", [f'"{function.name}"', "work", *checked_arguments(function, places)], ");"),
        "}",
    ]
    return "\n".join(lines) + "\n"


def files():
    hands = by_hand()
    listed = {header: [one for one in functions(header) if is_of_object(one) and one.name not in hands] for header in SYSTEMS}
    workers, path = "\n".join(worker(function) for own in listed.values() for function in own), "src/base/objects.hpp"
    made = {path: cpp_header(path, HEADER.format(declarations=workers))}
    for header, own in listed.items():
        head = HEAD.format(what=f" of objects: the functions of {header}", sources=header, includes=INCLUDES,
                           namespaces="using namespace pw85::detail;")  # fmt: skip
        made[f"{FOLDER}/objects_{header.removeprefix('pw85_').removesuffix('.h')}.cpp"] = head + "".join(map(shim, own))
    return made
