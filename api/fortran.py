# SPDX-License-Identifier: BSD-3-Clause
"""The Fortran module fortran/pw85.f90, made of its template, with an interface for each function of the C headers.

Functions that need more than an interface (for strings, pointers, and matrices that C stores by rows) are in the template
fortran/pw85.in.f90, which calls the C function by the name c_… . Absent optional arguments of Fortran 2018 are null pointers in C.
api/committed.py writes the module or compares it.
"""

import re
from collections import namedtuple
from itertools import groupby

from causes import PACKED
from declarations import functions
from layout import WIDTH, insert, wrapped
from parameters import CALLBACKS, ELEMENTS, STRUCTS
from public_headers import HOST_HEADERS, SOURCE, constants, source_text, version
from refusals import entry_of

MODULE, TEMPLATE = "fortran/pw85.f90", "fortran/pw85.in.f90"

INTEGERS = {"int": "c_int", "size_t": "c_size_t", "int32_t": "c_int32_t", "int64_t": "c_int64_t", "unsigned char": "c_int8_t"}
TYPES = {"double": "real(c_double)"} | {name: f"integer({kind})" for name, kind in INTEGERS.items()}
TYPES |= {name: f"type({name})" for name in (*STRUCTS, *ELEMENTS)}
PROCEDURE = re.compile(
    r"^(?P<comment>(?: *!> .*\n)+)? *(?P<kind>function|subroutine) (?P<name>pw85\w+)\((?P<arguments>[^)]*)\).*\n"
    r"(?P<declared>(?:(?: .*)?::.*\n| *import\n)+)",
    re.MULTILINE,
)
# A function or subroutine, as a program of Fortran sees it.
Procedure = namedtuple("Procedure", "name kind arguments comment declarations")


def argument(one, owners):
    """The attributes of an argument, and its name with its shape. Extents are in the order of Fortran, where rows of C are columns.
    An extent that is a member of a struct includes the name of the struct."""
    known = {name: f"{owner}%{name}" for name, owner in owners.items()} | {PACKED: "n*(n+1)/2"}
    shape = ", ".join(known.get(extent, str(extent)) for extent in reversed(one.shape))
    name = f"{one.name}({shape})" if shape else one.name
    if one.is_handle():
        kind = "type(c_funptr)" if one.type in CALLBACKS else "type(c_ptr)"
        return f"{kind}, {'intent(out)' if one.outer else 'value'}", name
    kind = entry_of(TYPES, one.type, "TYPES of api/fortran.py", one.place)
    if not one.pointer:
        return f"{kind}, value", name
    return f"{kind}, intent({'out' if one.is_output() else 'in'}){', optional' if one.nullable else ''}", name


def continued(line):
    """Splits a statement into lines of the length that Fortran allows."""
    indent = re.match(" *", line)[0]
    lines = wrapped(line, WIDTH - 2, "", indent + "  ") if len(line) > WIDTH else [line]
    return [f"{one} &" for one in lines[:-1]] + lines[-1:]


def interface(function, template):
    """The lines of the interface of a function. The name is c_… if the template has a procedure with the name of the function."""
    name = function.name.lower()
    own = re.search(rf"\b(?:function|subroutine) {name}\(", template) is not None
    bound = name.replace("pw85_", "c_", 1) if own else name
    kind, result, suffix = "subroutine", [], ""
    if function.type != "void":
        variable = "status" if function.type == "int" else "value"
        kind, suffix = "function", f" result({variable})"
        result = [f"{'type(c_ptr)' if '*' in function.type else TYPES[function.type]} :: {variable}"]
    matrices = [one for one in function.parameters if [type(extent) for extent in one.shape[-2:]] == [int, int]]
    if not own:
        rows = ", ".join(f"{one.name}(:, k{', i' if one.rows else ''})" for one in matrices)
        text = f" Row k in C is {rows}." if matrices else ""
        yield from wrapped(f"{function.brief()}.{text}", first="    !> ")
    yield from continued(f"    {kind} {bound}({', '.join(function.parameter_names())}){suffix} bind(C, name='{function.name}')")
    yield "      import"
    structs, names = [one for one in function.parameters if one.is_struct()], {*function.parameter_names()}
    owners = {name: struct.name for struct in structs for name in struct.member_names() - names}
    # Extents come first, because shapes refer to them.
    extents = [*structs, *(one for one in function.parameters if not one.pointer and (one.type == "size_t" or one.name == "n"))]
    sizes_first = (argument(one, owners) for one in sorted(function.parameters, key=lambda one: one not in extents))
    grouped = groupby(sizes_first, lambda one: one[0])
    declared = (f"{attributes} :: {', '.join(name for _, name in group)}" for attributes, group in grouped)
    for line in [*declared, *result]:
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


def files():
    template = source_text(TEMPLATE)
    numbers = dict(zip(("major", "minor", "patch"), version().split(".")))
    values = {f"PW85_VERSION_{part.upper()}": number for part, number in numbers.items()} | constants()
    made = {
        "constants": [constant(name, value) for name, value in values.items()],
        "names": [f"  public :: {function.name.lower()}" for function in functions(*HOST_HEADERS)],
        "interfaces": [line for header in HOST_HEADERS for line in [*interfaces(header, template), ""]][:-1],
    }
    return {MODULE: insert(SOURCE / TEMPLATE, "  !@", made)}


def procedures():
    found = {}
    for match in PROCEDURE.finditer(re.sub(r" *&\n *", " ", source_text(MODULE))):
        arguments = [name.strip() for name in match["arguments"].split(",")]
        lines = [line.strip() for line in match["declared"].splitlines() if "::" in line]
        declared = [line for line in lines if set(re.findall(r"\w+", line.split("::")[1])) & set(arguments)]
        comment = " ".join(re.sub(r" *!> ", " ", match["comment"] or "").split())
        found[match["name"]] = Procedure(match["name"], match["kind"], arguments, comment, declared)
    return found
