# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the compiled part of the Python package on objects, lists of pairs and systems, and on arrays of any dimension,
which python/src/objects.cpp includes.

A function takes the arguments of the function of C of its name, without the numbers of rows, and returns its status and its outputs.
Arrays are NumPy arrays of the right type, and outputs of many rows are arrays that it fills. A struct is given by its members.
"""

from declarations import OBJECTS, PACKED, SIMULATION, Role, functions, members, members_read
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
    return [one for one in kept if one.type == "int" or (one.type == "size_t" and one.parameters[0].type in OBJECTS)]


def product(extents):
    """The number of numbers in an array with these extents."""
    return " * ".join("(npy_intp{n} * (n + 1) / 2)" if one == PACKED else str(one) for one in extents) or "1"


class Body:
    """The statements of a function, by their order."""

    def __init__(self, function):
        self.function, self.reads, self.later, self.results = function, [], [], []
        self.counts = sorted(one.name for one in function.flattened if one.role == Role.COUNT)
        self.passed = [self.argument(one) for one in function.parameters]

    def argument(self, one):
        """What is passed for a parameter."""
        if one.is_returned():
            return self.returned(one)
        if one.is_struct():
            return self.struct(one)
        if one.role == Role.COUNT:
            return f"size_of({one.name})"
        self.reads.append(self.read(one))
        return one.name

    def returned(self, one):
        self.later.append(f"{one.type} {'*' if one.outer else ''}{one.name}{f'[{one.size}]' if one.shape else ''}{{}};")
        made = f'Made<{one.type}>{{{one.name}, "{one.type}", destroy<{one.type}, {one.type}_destroy>}}'
        self.results.append(made if one.outer else one.name)
        return one.name if one.shape else f"&{one.name}"

    def struct(self, one):
        given = {member.name: self.argument(member) for member in members_read(self.function, one)}
        values = [given.get(name, "nullptr") for name, _, _ in members(one.type)]
        if one.type == "pw85_system":
            self.reads.append("auto *const periodic = in.numbers<int const>(3, false);")
            values.append("{periodic[0], periodic[1], periodic[2]}")
        self.later.append(f"{one.type} const {one.name}{{{', '.join(values)}}};")
        return f"&{one.name}"

    def read(self, one):
        """The statement that reads an argument."""
        if one.role == Role.OBJECT:
            return f'auto *const {one.name} = in.object<{one.type}>("{one.type}");'
        if one.role == Role.ADDRESS:
            return f"auto *const {one.name} = reinterpret_cast<{one.type} *>(in.address());"
        if not one.pointer:
            return f"auto const {one.name} = in.{SCALARS[one.type]}();"
        return f"auto *const {one.name} = {self.array(one)};"

    def array(self, one):
        """The expression that reads an array."""
        # Whether there must be a cell is known to the library alone.
        kind, optional = f"{one.type}{' const' if one.const else ''}", str(one.nullable or one.name == "cell").lower()
        if one.rows not in self.counts:
            return f"in.numbers<{kind}>({product(one.shape)}, {optional})"
        if one.type == "pw85_motion":  # an array of numbers in Python
            return f"reinterpret_cast<pw85_motion const *>(in.rows<double const>({one.rows}, 7, {optional}))"
        columns = product(one.shape[1:]) if one.shape[1:] else "0"
        return f"in.rows<{kind}>({one.rows}, {columns}, {optional})"

    def lines(self):
        yield f"PyObject *{self.function.plain}(PyObject *, PyObject *const *args, Py_ssize_t nargs)\n{{"
        yield f"    Arguments in(args, nargs, {len(self.reads)});"
        yield from (f"    npy_intp {count} = -1;" for count in self.counts)
        yield from (f"    {line}" for line in [*self.reads, "if (PyErr_Occurred()) return nullptr;", *self.later])
        call = f"unlocked([&] {{ return {self.function.name}({', '.join(self.passed)}); }})"
        yield f"    return returned({', '.join([call, *self.results])});\n}}\n"


def table():
    names = [one.plain for one in listed_functions()]
    text = "\n".join(line for function in listed_functions() for line in Body(function).lines())
    entries = "".join(f'    {{"{name}", as_method({name}), METH_FASTCALL, "Status and results of pw85_{name}()."}},\n' for name in names)
    return f"{text}\nPyMethodDef made_methods[] = {{\n{entries}    {{nullptr, nullptr, 0, nullptr}},\n}};\n"


def type_of(one):
    """The type of a result in Python."""
    if one.outer:
        return "Any"
    number = "float" if one.type == "double" else "int"
    return f"tuple[{', '.join([number] * one.size)}]" if one.shape else number


def stubs():
    """The functions as a stub of Python."""
    for function in listed_functions():
        types = ["int", *(type_of(one) for one in function.parameters if one.is_returned())]
        result = f"tuple[{', '.join(types)}]" if types[1:] else "int"
        yield f"def {function.plain}(*args: Any) -> {result}: ..."
