# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the compiled part of the Python package, which python/src/function.cpp and python/src/objects.cpp include.

For each function of one row (api/rows.py) a row of a table, of which generalised ufuncs are made. For those on objects, lists of pairs
and systems, and on arrays of any dimension, a function that takes the arguments of the function of C of its name, without the numbers of
rows, and returns its status and its outputs. Arrays are NumPy arrays of the right type, and outputs of many rows are arrays that it
fills. A struct is given by its members.
"""

from causes import PACKED
from declarations import functions
from parameters import OBJECTS
from public_headers import SYSTEMS
from refusals import entry_of
from rows import row_functions, rows_by_hand

NUMBERS_OF_FORM = 6
SILENT_HEADERS = ("pw85_legacy.h", "pw85_zheng.h")  # of a library that keeps no record of refusals
HEADERS_OF_OBJECTS = (*SYSTEMS, "pw85_enclosing.h", "pw85_any_dimension.h")
# Functions of pw85_batch.h whose arrays are not rows of as many arguments.
OTHERS = ("pw85_overlap_any", "pw85_contact_polytope_batch", "pw85_overlap_polytope_batch")
SCALARS = {"size_t": "size", "int": "integer", "double": "real"}


def call_of_row(row, outputs):
    """The call of the function. Where its library keeps no record of refusals, the function of the library pw85 that has the same inputs,
    all of which are declared "as" its own, tells why it is refused."""
    function = row.function
    inputs = [f"motion(in[{k}])" if one.type == "pw85_motion" else f"{'' if one.shape else '*'}in[{k}]" for k, one in enumerate(row.inputs)]
    written = f"{function.name}({', '.join([*['1'] * row.is_of_many(), *inputs, *outputs])})"
    if function.type != "int" or function.header not in SILENT_HEADERS:
        return written
    (name,) = {function.descriptions[one.name].attributes.like for one in row.inputs}
    return f"recorded({written}, {', '.join([name, *inputs])})"


def status_of_row(row, first):
    """The status of a function that returns none: of λ and the pair, or of the matrix, where the first number of the result is NaN."""
    if not row.function.is_nan_on_error():
        return "PW85_SUCCESS"
    blamed = [f"in[{k}]" for k, one in enumerate(row.inputs) if one.name in ("lambda", "r12") or one.shape == (NUMBERS_OF_FORM,)]
    return f"status_of({', '.join([first, *blamed])})"


def body_of_row(row):
    """Statements that compute a row. Integers of C are numbers of Python, NaN on error."""
    if row.is_by_hand():
        return f"return {row.name}(in, out);"
    integers = [k for k, one in enumerate(row.outputs) if one.type == "int"]
    first, outputs = "*out[0]", [f"&integer{k}" if k in integers else f"out[{k}]" for k in range(len(row.outputs))]
    declared = "".join(f"int integer{k}; " for k in integers)
    stored = "".join(f"number(status, integer{k}, out[{k}]); " for k in integers)
    if row.is_split():
        first, outputs, stored = "row[0]", ["row"], "split(row, out); "
        declared = f"double row[{len(row.outputs)}]; "
    if row.function.type == "int":
        return f"{declared}int const status = {call_of_row(row, outputs)}; {stored}return status;"
    call = call_of_row(row, outputs) if row.function.outputs else f"{first} = {call_of_row(row, [])}"
    return f"{declared}{call}; int const status = {status_of_row(row, first)}; {stored}return status;"


def batch(row):
    """The function of many rows; one that is not only of arrays has a function of its own in function.cpp."""
    if row.many is None or any(one.type == "int" for one in row.outputs):
        return "nullptr"
    is_of_arrays = all(one.pointer and one.type != "pw85_motion" for one in row.many.parameters[1:])
    return f"batch<{row.many.name}>" if is_of_arrays else row.many.plain


def codes(row):
    """The function of many rows that answers by bytes, or one that calls that of one row for each."""
    if not row.is_truth():
        return "nullptr"
    if row.many is not None:
        return f"codes<{row.many.name}>"
    return f"codes_of_each<{', '.join([row.function.name, *(str(one.size) for one in row.inputs)])}>"


def rows_table():
    """The rows of the table. The truth value of a bad row is true for overlaps, so that a simulation refuses it."""
    return "".join(
        f'{{"{row.name}", "{row.signature()}",\n [](Inputs in, Outputs out) -> int {{ {body_of_row(row)} }},\n'
        f" {batch(row)}, {codes(row)}, {str(row.is_overlap()).lower()}}},\n"
        for row in (*row_functions(), *rows_by_hand())
    )


def functions_of_objects():
    """Those with a status, except those of api/rows.py, and sizes of objects; of two for one row and for many the latter."""
    found = functions(*HEADERS_OF_OBJECTS)
    found += [one for one in functions("pw85_batch.h") if one.name in OTHERS]
    names, of_rows = {one.name for one in found}, {row.function.name for row in row_functions()}
    kept = [one for one in found if one.name not in of_rows and f"{one.name}_batch" not in names]
    return [one for one in kept if one.type == "int" or (one.type == "size_t" and one.parameters[0].type in OBJECTS)]


def product(extents):
    """The number of numbers in an array with these extents."""
    return " * ".join("(npy_intp{n} * (n + 1) / 2)" if one == PACKED else str(one) for one in extents) or "1"


class Body:
    """The statements of a function on objects, by their order."""

    def __init__(self, function):
        self.function, self.reads, self.later, self.results = function, [], [], []
        self.counts = sorted(one.name for one in function.flattened if one.is_count)
        self.passed = [self.argument(one) for one in function.parameters]

    def argument(self, one):
        """What is passed for a parameter."""
        if one.is_returned():
            return self.returned(one)
        if one.is_struct():
            return self.struct(one)
        if one.is_count:
            return f"size_of({one.name})"
        self.reads.append(f"auto {'*' if one.pointer else ''}const {one.name} = {self.read(one)};")
        return one.name

    def returned(self, one):
        self.later.append(f"{one.type} {'*' if one.outer else ''}{one.name}{f'[{one.size}]' if one.shape else ''}{{}};")
        made = f'Made<{one.type}>{{{one.name}, "{one.type}", destroy<{one.type}, {one.type}_destroy>}}'
        self.results.append(made if one.outer else one.name)
        return one.name if one.shape else f"&{one.name}"

    def struct(self, one):
        values = self.function.values_of_members(one, self.argument)
        if one.type == "pw85_system":
            self.reads.append("auto *const periodic = in.numbers<int const>(3, false);")
            values.append("{periodic[0], periodic[1], periodic[2]}")
        self.later.append(f"{one.type} const {one.name}{{{', '.join(values)}}};")
        return f"&{one.name}"

    def read(self, one):
        """The expression that reads an argument. Whether there must be a cell is known to the library alone."""
        if one.type in OBJECTS:
            return f'in.object<{one.type}>("{one.type}")'
        if one.is_handle():
            return f"reinterpret_cast<{one.type} *>(in.address())"
        if not one.pointer:
            return f"in.{entry_of(SCALARS, one.type, 'SCALARS of api/python_calls.py', one.place)}()"
        kind, optional = f"{one.type}{' const' if one.const else ''}", str(one.nullable or one.name == "cell").lower()
        if one.rows not in self.counts:
            return f"in.numbers<{kind}>({product(one.shape)}, {optional})"
        if one.type == "pw85_motion":  # an array of numbers in Python
            return f"reinterpret_cast<pw85_motion const *>(in.rows<double const>({one.rows}, 7, {optional}))"
        return f"in.rows<{kind}>({one.rows}, {product(one.shape[1:]) if one.shape[1:] else '0'}, {optional})"

    def text(self):
        lines = [f"    Arguments in(args, nargs, {len(self.reads)});"]
        lines += [f"    npy_intp {count} = -1;" for count in self.counts]
        lines += [f"    {line}" for line in [*self.reads, "if (PyErr_Occurred()) return nullptr;", *self.later]]
        call = f"unlocked([&] {{ return {self.function.name}({', '.join(self.passed)}); }})"
        lines += [f"    return returned({', '.join([call, *self.results])});"]
        head = f"PyObject *{self.function.plain}(PyObject *, PyObject *const *args, Py_ssize_t nargs)"
        return "\n".join([head, "{", *lines, "}\n\n"])


def objects_table():
    listed = functions_of_objects()
    entries = (f'    {{"{one.plain}", as_method({one.plain}), METH_FASTCALL, "Status and results of {one.name}()."}},\n' for one in listed)
    texts = "".join(Body(one).text() for one in listed)
    return f"{texts}PyMethodDef made_methods[] = {{\n{''.join(entries)}    {{nullptr, nullptr, 0, nullptr}},\n}};\n"


def type_of(one):
    if one.outer:
        return "Any"
    number = "float" if one.type == "double" else "int"
    return f"tuple[{', '.join([number] * one.size)}]" if one.shape else number


def stubs():
    """The functions on objects as a stub of Python."""
    for function in functions_of_objects():
        types = ["int", *(type_of(one) for one in function.parameters if one.is_returned())]
        result = f"tuple[{', '.join(types)}]" if types[1:] else "int"
        yield f"def {function.plain}(*args: Any) -> {result}: ..."
