# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the compiled part of the Python package on objects, lists of pairs and systems, and on arrays of any dimension,
which python/src/objects.cpp includes.

A function takes the arguments of the function of C of its name, without the numbers of rows, and returns its status and its outputs.
Arrays are NumPy arrays of the right type, and outputs of many rows are arrays that it fills. A struct is given by its members.
"""

from math import prod

from declarations import OBJECTS, PACKED, SIMULATION, functions, members, members_read, parameters
from rows import row_functions

HEADERS = ("pw85_systems.h", *SIMULATION, "pw85_enclosing.h", "pw85_any_dimension.h")
# Functions of pw85_batch.h whose arrays are not rows of as many arguments.
OTHERS = ("pw85_overlap_any", "pw85_contact_polytope_batch", "pw85_overlap_polytope_batch")
SCALARS = {"size_t": "size", "int": "integer", "double": "real"}


def listed_functions():
    """Those with a status, except those of api/rows.py, and sizes of objects; of two for one row and for many the latter."""
    found = [one for header in HEADERS for one in functions(header)] + [one for one in functions("pw85_batch.h") if one.name in OTHERS]
    names, of_rows = {one.name for one in found}, {row.function.name for row in row_functions()}
    kept = [one for one in found if one.name not in of_rows and f"{one.name}_batch" not in names]
    return [one for one in kept if one.type == "int" or (one.type == "size_t" and parameters(one)[0].type in OBJECTS)]


def plain(function):
    return function.name.removeprefix("pw85_")


def is_result(one):
    """Whether it is an output of one row, which is returned."""
    return one.outer or (one.is_output() and all(isinstance(extent, int) for extent in one.shape))


def counts(listed):
    """The names of numbers of rows, which the arrays tell."""
    sizes = {one.name for one in listed if one.type == "size_t" and not one.pointer}
    return {one.shape[0] for one in listed if one.pointer and one.shape} & sizes


def product(extents):
    """The number of numbers in an array with these extents."""
    return " * ".join("(npy_intp{n} * (n + 1) / 2)" if one == PACKED else str(one) for one in extents) or "1"


def array(one, sizes):
    """The expression that reads an array. `sizes` are numbers of rows."""
    # Whether there must be a cell is known to the library alone.
    optional = "true" if one.nullable or one.name == "cell" else "false"
    if not one.shape or one.shape[0] not in sizes:
        return f"in.numbers<{one.type}{' const' if one.const else ''}>({product(one.shape)}, {optional})"
    if one.type == "pw85_motion":  # an array of numbers in Python
        return f"reinterpret_cast<pw85_motion const *>(in.rows<double const>({one.shape[0]}, 7, {optional}))"
    columns = product(one.shape[1:]) if one.shape[1:] else "0"
    return f"in.rows<{one.type}{' const' if one.const else ''}>({one.shape[0]}, {columns}, {optional})"


def read(one, sizes):
    """The statement that reads an argument."""
    if one.type in OBJECTS:
        return f'auto *const {one.name} = in.object<{one.type}>("{one.type}");'
    if one.is_handle():
        return f"auto *const {one.name} = reinterpret_cast<{one.type} *>(in.address());"
    if not one.pointer:
        return f"auto const {one.name} = in.{SCALARS[one.type]}();"
    return f"auto *const {one.name} = {array(one, sizes)};"


class Body:
    """The statements of a function, by their order."""

    def __init__(self, function):
        self.function, self.results = function, []
        self.counted, self.number = set(), 0
        self.reads, self.later, self.passed = [], [], []
        for one in parameters(function):
            self.add(one)

    def add(self, one):
        if is_result(one):
            extent = f"[{prod(one.shape)}]" if one.shape else ""
            self.later.append(f"{one.type} {'*' if one.outer else ''}{one.name}{extent}{{}};")
            made = f'Made<{one.type}>{{{one.name}, "{one.type}", destroy<{one.type}, {one.type}_destroy>}}'
            self.results.append(made if one.outer else one.name)
            self.passed.append(one.name if one.shape else f"&{one.name}")
        elif one.is_struct():
            self.add_struct(one)
            self.passed.append(f"&{one.name}")
        else:
            self.add_read(one, counts(parameters(self.function)))
            self.passed.append(f"size_of({one.name})" if one.name in self.counted else one.name)

    def add_read(self, one, names):
        if one.name in names:
            self.counted.add(one.name)
        else:
            self.reads.append(read(one, names | self.counted))
            self.number += 1

    def add_struct(self, one):
        given = {member.name: member for member in members_read(self.function, one)}
        values = []
        for name, _, _ in members(one.type):
            if name in given:
                self.add_read(given[name], counts(given.values()))
            values.append("nullptr" if name not in given else f"size_of({name})" if name in self.counted else name)
        if one.type == "pw85_system":
            self.reads.append("auto *const periodic = in.numbers<int const>(3, false);")
            self.number += 1
            values.append("{periodic[0], periodic[1], periodic[2]}")
        self.later.append(f"{one.type} const {one.name}{{{', '.join(values)}}};")

    def lines(self):
        name, call = plain(self.function), f"{self.function.name}({', '.join(self.passed)})"
        yield f"PyObject *{name}(PyObject *, PyObject *const *args, Py_ssize_t nargs)"
        yield "{"
        yield f"    Arguments in(args, nargs, {self.number});"
        yield from (f"    npy_intp {count} = -1;" for count in sorted(self.counted))
        yield from (f"    {line}" for line in self.reads)
        yield "    if (PyErr_Occurred()) return nullptr;"
        yield from (f"    {line}" for line in self.later)
        yield f"    return returned({', '.join([f'unlocked([&] {{ return {call}; }})', *self.results])});"
        yield "}\n"


def table():
    made = [Body(function) for function in listed_functions()]
    text = "\n".join(line for body in made for line in body.lines())
    names = [plain(body.function) for body in made]
    entries = "".join(f'    {{"{name}", as_method({name}), METH_FASTCALL, "Status and results of pw85_{name}()."}},\n' for name in names)
    return f"{text}\nPyMethodDef made_methods[] = {{\n{entries}    {{nullptr, nullptr, 0, nullptr}},\n}};\n"


def type_of(one):
    """The type of a result in Python."""
    if one.outer:
        return "Any"
    number = "float" if one.type == "double" else "int"
    return f"tuple[{', '.join([number] * prod(one.shape))}]" if one.shape else number


def stubs():
    """The functions as a stub of Python."""
    for function in listed_functions():
        types = ["int", *(type_of(one) for one in parameters(function) if is_result(one))]
        result = f"tuple[{', '.join(types)}]" if types[1:] else "int"
        yield f"def {plain(function)}(*args: Any) -> {result}: ..."
