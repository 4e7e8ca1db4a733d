# SPDX-License-Identifier: BSD-3-Clause
"""The table of functions that the compiled part of the Python package includes: a row for each function of api/rows.py."""

from math import prod

from declarations import c_functions, parameters

NUMBERS_OF_FORM = 6
SILENT_HEADERS = ("pw85_legacy.h", "pw85_zheng.h")  # of a library that keeps no record of refusals

ROW = """\
{{"{name}", "{signature}",
 [](Inputs in, Outputs out) -> int {{ {body} }},
 {batch}, {codes}, {if_bad}}},
"""


def is_true_if_bad(row):
    """Whether a truth value is true of a bad row: overlaps are, so that a simulation refuses it."""
    return row.is_truth() and row.name.startswith("overlap")


def argument(operand, number):
    if operand.parameter.type == "pw85_motion":
        return f"motion(in[{number}])"
    return f"{'' if operand.shape else '*'}in[{number}]"


def call(row, outputs):
    inputs = [argument(one, k) for k, one in enumerate(row.inputs)]
    written = f"{row.function.name}({', '.join((['1'] if row.is_of_many() else []) + inputs + outputs)})"
    return f"recorded({written}, [&] {{ {recorder(row)} }})" if is_silent(row) else written


def is_silent(row):
    """Whether the function returns a status, and is of a library that keeps no record of refusals."""
    return row.function.type == "int" and row.function.header in SILENT_HEADERS


def recorder(row):
    """A call of the function of the library pw85 that has the same inputs: all of them are declared "as" its own."""
    name, = {row.function.descriptions[one.name].attributes.like for one in row.inputs}
    outputs = [one for one in parameters(c_functions()[name]) if one.is_output()]
    ignored = ", ".join(f"ignored + {sum(prod(two.shape) for two in outputs[:k])}" for k in range(len(outputs)))
    inputs = ", ".join(f"in[{k}]" for k in range(len(row.inputs)))
    return f"double ignored[{sum(prod(one.shape) for one in outputs)}]; {name}({inputs}, {ignored});"


def status_of(row, value):
    """The status of a function that returns none: of λ and the pair, or of the matrix, where the result is NaN."""
    if not row.function.is_nan_on_error():
        return "PW85_SUCCESS"
    blamed = [f"in[{k}]" for k, one in enumerate(row.inputs) if one.name in ("lambda", "r12") or one.shape == (NUMBERS_OF_FORM,)]
    return f"status_of({', '.join([value, *blamed])})"


def body_with_integers(row):
    """Of a function of which some results are integers of C, which are numbers of Python, NaN on error."""
    written = [f"&integer{k}" if one.is_integer() else f"out[{k}]" for k, one in enumerate(row.outputs)]
    of_integers = [k for k, one in enumerate(row.outputs) if one.is_integer()]
    declared = f"int {', '.join(f'integer{k}' for k in of_integers)};"
    stored = "".join(f" number(status, integer{k}, out[{k}]);" for k in of_integers)
    return f"{declared} int const status = {call(row, written)};{stored} return status;"


def body(row):
    if row.is_by_hand():
        return f"return {row.name}(in, out);"
    if row.is_truth():
        return f"int answer; return truth({call(row, ['&answer'])}, answer, out);"
    if row.is_split():
        made = call(row, ["row"])
        declared = f"double row[{row.outputs[0].parameter.shape[0]}];"
        if row.function.type == "int":
            return f"{declared} return split({made}, row, out);"
        return f"{declared} {made}; return split({status_of(row, 'row[0]')}, row, out);"
    if row.function.type == "double":
        return f"*out[0] = {call(row, [])}; return {status_of(row, '*out[0]')};"
    if any(one.is_integer() for one in row.outputs):
        return body_with_integers(row)
    made = call(row, [f"out[{k}]" for k in range(len(row.outputs))])
    return f"return {made};" if row.function.type == "int" else f"{made}; return {status_of(row, '*out[0]')};"


def batch(row):
    """The function of many rows; one that is not only of arrays has a function of its own in function.cpp."""
    if row.many is None or row.is_truth() or any(one.is_integer() for one in row.outputs):
        return "nullptr"
    is_of_arrays = all(one.pointer for one in parameters(row.many)[1:])
    has_motions = any(one.type == "pw85_motion" for one in parameters(row.many))
    return f"batch<{row.many.name}>" if is_of_arrays and not has_motions else row.many.name.removeprefix("pw85_")


def codes(row):
    """The function of many rows that answers by bytes, or one that calls that of one row for each."""
    if not row.is_truth():
        return "nullptr"
    if row.many is not None:
        return f"codes<{row.many.name}>"
    sizes = [str(prod(one.shape)) for one in row.inputs]
    return f"codes_of_each<{', '.join([row.function.name, *sizes])}>"


def table(rows):
    return "".join(
        ROW.format(
            name=row.name,
            signature=row.signature(),
            body=body(row),
            batch=batch(row),
            codes=codes(row),
            if_bad=str(is_true_if_bad(row)).lower(),
        )
        for row in rows
    )
