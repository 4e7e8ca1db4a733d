"""The functions of many rows of the C API that have no lanes: src/kernels/many_rows.cpp, made of the functions of one row.

The functions are those of the lines "@rows" of api/pw85_batch.h.in. Each calls the function of one row for each row, with an argument of
src/kernels/each_row.hpp for each parameter.
"""

from math import prod

import batch
from declarations import SOURCE
from rows import name_of_many

MANY_ROWS = SOURCE / "src/kernels/many_rows.cpp"
BEGIN = """\
// The functions of many rows that have no lanes. They call the function of one row for each row (each_row.hpp).
//
// Made from pw85.h and api/pw85_batch.h.in by api/committed.py.
#include <pw85_batch.h>

#include "each_row.hpp"

using namespace pw85::detail::kernels;
"""


def row_argument(one, many):
    """The argument of each_row() for a parameter of one row; `many` stand for it in the function of many rows."""
    first, names = many[0], ", ".join(argument.name for argument in many)
    if not first.is_array:
        return f"SameNumber{{{names}}}"
    if len(many) > 1:
        return f"TwoNumbers{{{names}}}"
    if first.type == "unsigned char":
        return f"Bytes{{{names}}}"
    if not one.pointer:
        return f"Numbers{{{names}}}"
    columns = prod(batch.names_and_shape(one)[1])
    if first.nullable:
        return f"OptionalRowsOf<{columns}>{{{names}}}"
    element = first.type if first.is_output else f"{first.type} const"
    return f"RowsOf<{columns}{'' if element == 'double const' else f', {element}'}>{{{names}}}"


def definition(statement):
    name, listed = statement.function.name, statement.arguments()
    parameters = ["size_t n", *(argument.declared() for _, many in listed for argument in many)]
    arguments = ["n", name, *(row_argument(one, many) for one, many in listed)]
    begin = batch.wrapped(f"int {name_of_many(name)}(", parameters, ")")
    return f"\n{begin}\n{{\n{batch.wrapped('    return each_row(', arguments, ');')}\n}}\n"


def many_rows():
    return BEGIN + "".join(definition(statement) for statement in batch.statements() if not statement.has_lanes)
