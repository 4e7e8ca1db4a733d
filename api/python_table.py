# SPDX-License-Identifier: BSD-3-Clause
"""The table of functions that the compiled part of the Python package includes: a row for each function of api/rows.py."""

NUMBERS_OF_FORM = 6
SILENT_HEADERS = ("pw85_legacy.h", "pw85_zheng.h")  # of a library that keeps no record of refusals


def argument(one, number):
    if one.is_motion():
        return f"motion(in[{number}])"
    return f"{'' if one.shape else '*'}in[{number}]"


def call(row, outputs):
    """The call of the function. Where its library keeps no record of refusals, the function of the library pw85 that has the same inputs,
    all of which are declared "as" its own, tells why it is refused."""
    function, inputs = row.function, [argument(one, k) for k, one in enumerate(row.inputs)]
    written = f"{function.name}({', '.join([*['1'] * row.is_of_many(), *inputs, *outputs])})"
    if function.type != "int" or function.header not in SILENT_HEADERS:
        return written
    name, = {function.descriptions[one.name].attributes.like for one in row.inputs}
    return f"recorded({written}, {', '.join([name, *inputs])})"


def status_of(row, first):
    """The status of a function that returns none: of λ and the pair, or of the matrix, where the first number of the result is NaN."""
    if not row.function.is_nan_on_error():
        return "PW85_SUCCESS"
    blamed = [f"in[{k}]" for k, one in enumerate(row.inputs) if one.name in ("lambda", "r12") or one.shape == (NUMBERS_OF_FORM,)]
    return f"status_of({', '.join([first, *blamed])})"


def body(row):
    """Statements that compute a row. Integers of C are numbers of Python, NaN on error."""
    if row.is_by_hand():
        return f"return {row.name}(in, out);"
    first, outputs = "*out[0]", [f"&integer{k}" if one.is_integer() else f"out[{k}]" for k, one in enumerate(row.outputs)]
    integers = [k for k, one in enumerate(row.outputs) if one.is_integer()]
    declared = "".join(f"int integer{k}; " for k in integers)
    stored = "".join(f"number(status, integer{k}, out[{k}]); " for k in integers)
    if row.is_split():
        first, outputs, stored = "row[0]", ["row"], "split(row, out); "
        declared = f"double row[{row.outputs[0].parameter.size}]; "
    if row.function.type == "int":
        computed = f"int const status = {call(row, outputs)};"
    elif row.function.outputs:
        computed = f"{call(row, outputs)}; int const status = {status_of(row, first)};"
    else:
        computed = f"{first} = {call(row, [])}; int const status = {status_of(row, first)};"
    return f"{declared}{computed} {stored}return status;"


def batch(row):
    """The function of many rows; one that is not only of arrays has a function of its own in function.cpp."""
    if row.many is None or any(one.is_integer() for one in row.outputs):
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


def table(rows):
    """The rows of the table. The truth value of a bad row is true for overlaps, so that a simulation refuses it."""
    return "".join(
        f'{{"{row.name}", "{row.signature()}",\n [](Inputs in, Outputs out) -> int {{ {body(row)} }},\n'
        f" {batch(row)}, {codes(row)}, {str(row.is_truth() and row.name.startswith('overlap')).lower()}}},\n"
        for row in rows
    )
