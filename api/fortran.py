# SPDX-License-Identifier: BSD-3-Clause
"""The Fortran module fortran/pw85.f90, made of its template, with an interface for each function of the C headers.

Functions that need more than an interface (for strings, pointers, and matrices that C stores by rows) are in the template
fortran/pw85.in.f90, which calls the C function by the name c_… . Absent optional arguments of Fortran 2018 are null pointers in C.
api/committed.py writes the module or compares it.
"""

import re
import textwrap
from dataclasses import dataclass

from declarations import CALLBACKS, HOST_HEADERS, PACKED, SOURCE, constants, functions, members, parameters, version

FORTRAN = SOURCE / "fortran"
MODULE, TEMPLATE = FORTRAN / "pw85.f90", FORTRAN / "pw85.in.f90"
WIDTH = 100

TYPES = {
    "double": "real(c_double)",
    "int": "integer(c_int)",
    "size_t": "integer(c_size_t)",
    "int32_t": "integer(c_int32_t)",
    "int64_t": "integer(c_int64_t)",
    "unsigned char": "integer(c_int8_t)",
    "pw85_motion": "type(pw85_motion)",
    "pw85_pair_list": "type(pw85_pair_list)",
    "pw85_system": "type(pw85_system)",
    "pw85_law": "type(pw85_law)",
    "pw85_wall": "type(pw85_wall)",
    "pw85_field": "type(pw85_field)",
}


def argument(parameter, owners):
    """The attributes of an argument, and its name with its shape. Extents are in the order of Fortran, where rows of C are columns.
    An extent that is a member of a struct includes the name of the struct."""
    known = {name: f"{owner}%{name}" for name, owner in owners.items()} | {PACKED: "n*(n+1)/2"}
    extents = [known.get(extent, str(extent)) for extent in reversed(parameter.shape)]
    shape = ", ".join(extents)
    name = f"{parameter.name}({shape})" if shape else parameter.name
    if parameter.type in CALLBACKS:
        return ("type(c_funptr)", "value"), name
    if parameter.is_handle():
        return ("type(c_ptr)", "intent(out)") if parameter.outer else ("type(c_ptr)", "value"), name
    if not parameter.pointer:
        return (TYPES[parameter.type], "value"), name
    intent = "intent(out)" if parameter.is_output() else "intent(in)"
    return (TYPES[parameter.type], intent, *(["optional"] if parameter.nullable else [])), name


def continued(line):
    """Splits a statement into lines of the length that Fortran allows."""
    indent = re.match(" *", line)[0]
    lines = textwrap.wrap(line, WIDTH - 2, initial_indent="", subsequent_indent=indent + "  ", break_long_words=False,
                          drop_whitespace=True) if len(line) > WIDTH else [line.strip()]
    lines[0] = indent + lines[0].lstrip()
    return [f"{one} &" for one in lines[:-1]] + lines[-1:]


def declarations_of(arguments):
    """One declaration for consecutive arguments with the same attributes."""
    grouped = []
    for attributes, name in arguments:
        if grouped and grouped[-1][0] == attributes:
            grouped[-1][1].append(name)
        else:
            grouped.append((attributes, [name]))
    return [f"{', '.join(attributes)} :: {', '.join(names)}" for attributes, names in grouped]


def interface(function, template):
    """The lines of the interface of a function. The name is c_… if the template has a procedure with the name of the function."""
    name = function.name.lower()
    own = re.search(rf"\b(?:function|subroutine) {name}\(", template) is not None
    bound = name.replace("pw85_", "c_", 1) if own else name
    listed = parameters(function)
    kind, result, suffix = "subroutine", [], ""
    if function.type != "void":
        variable = "status" if function.type == "int" else "value"
        kind, suffix = "function", f" result({variable})"
        result = [f"{'type(c_ptr)' if '*' in function.type else TYPES[function.type]} :: {variable}"]
    if not own:
        yield from textwrap.wrap(function.brief() + ".", WIDTH, initial_indent="    !> ", subsequent_indent="    !> ")
    names = ", ".join(parameter.name for parameter in listed)
    yield from continued(f"    {kind} {bound}({names}){suffix} bind(C, name='{function.name}')")
    yield "      import"
    owners = {name: one.name for one in listed if one.is_struct() for name, _, _ in members(one.type)}
    for name in function.parameter_names():
        owners.pop(name, None)
    # Extents come first, because shapes refer to them.
    sizes_first = sorted(listed, key=lambda one: not (one.is_struct() or ((one.type == "size_t" or one.name == "n") and not one.pointer)))
    for line in declarations_of(argument(one, owners) for one in sizes_first) + result:
        yield from continued("      " + line)
    yield from (f"    end {kind} {bound}", "")


def interfaces(header, template):
    yield from (f"  ! {header}", "  interface", "")
    for function in functions(header):
        yield from interface(function, template)
    yield "  end interface"


def constant(name, value):
    kind = "integer(c_int)" if value.isdigit() else "real(c_double)"
    return f"  {kind}, parameter, public :: {name.lower()} = {value if value.isdigit() else value + '_c_double'}"


def module():
    template = TEMPLATE.read_text(encoding="utf-8")
    numbers = dict(zip(("major", "minor", "patch"), version().split(".")))
    values = {f"PW85_VERSION_{part.upper()}": number for part, number in numbers.items()} | constants()
    names = [function.name.lower() for header in HOST_HEADERS for function in functions(header)]
    made = {
        "constants": [constant(name, value) for name, value in values.items()],
        "names": [f"  public :: {name}" for name in names],
        "interfaces": [line for header in HOST_HEADERS for line in [*interfaces(header, template), ""]][:-1],
    }
    for name, lines in made.items():
        template = template.replace(f"  !@ {name}\n", "\n".join(lines) + "\n")
    return template


PROCEDURE = re.compile(
    r"^(?P<comment>(?: *!> .*\n)+)? *(?P<kind>function|subroutine) (?P<name>pw85\w+)\((?P<arguments>[^)]*)\).*\n"
    r"(?P<declared>(?:(?: .*)?::.*\n| *import\n)+)",
    re.MULTILINE,
)


@dataclass
class Procedure:
    """A function or subroutine, as a program of Fortran sees it."""

    name: str
    kind: str
    arguments: list
    comment: str
    declarations: list


def procedures():
    """The procedures of the module by their names, in the order of the module."""
    found = {}
    for match in PROCEDURE.finditer(re.sub(r" *&\n *", " ", MODULE.read_text(encoding="utf-8"))):
        arguments = [name.strip() for name in match["arguments"].split(",")]
        lines = [line.strip() for line in match["declared"].splitlines() if "::" in line]
        declared = [line for line in lines if set(re.findall(r"\w+", line.split("::")[1])) & set(arguments)]
        comment = " ".join(re.sub(r" *!> ", " ", match["comment"] or "").split())
        found[match["name"]] = Procedure(match["name"], match["kind"], arguments, comment, declared)
    return found
