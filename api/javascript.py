# SPDX-License-Identifier: BSD-3-Clause
"""Makes what the npm package in js/ has by the declarations of the C API: the table of its functions, their types, package.json.

A function of JavaScript answers a question for one pair, and its relative with `Rows` for many: pw85_contact_batch() is contact() and
contactRows(). js/pw85.js reads arguments and writes results by the table. The names are those of C without `pw85_`, in camel case.
"""

import json
import re
from functools import cache

from layout import insert, wrapped
from public_headers import SOURCE, with_version
from refusals import run
from rows import row_functions
from voice import PlainVoice, with_named_statuses

# The questions of each module, by their names in C, in order. A page loads at most 300 kB for ellipsoids, and as much for ellipses.
ASKED = {
    "pw85": ("ellipsoid", "ellipsoid_quaternion", "contact", "contact_geometry", "overlap", "overlap_volume", "distance", "first_contact"),
    "plane": ("ellipse", "overlap_area_2d", "contact_2d", "contact_geometry_2d", "overlap_2d", "distance_2d"),
}
OTHERS = ("pw85_last_error", "pw85_strerror")  # functions that js/pw85.js calls beside them
ARRAYS = {"f64": "Float64Array", "i32": "Int32Array", "u8": "Uint8Array"}
MARK = "Made by api/javascript.py from the headers of the C API."
MOTION = " Velocity (3 numbers), angular velocity (3 numbers), growth of the semi-axes per unit of time."
LICENCE = "// SPDX-License-Identifier: BSD-3-Clause"


@cache
def asked_of(module):
    known = {row.name: row for row in row_functions()}
    return [known[name] for name in ASKED[module]]


def asked():
    return [row for module in ASKED for row in asked_of(module)]


def camel(name):
    return re.sub(r"_(\w)", lambda match: match[1].upper(), name)


def type_of(row, one):
    """The numbers that C writes."""
    if one.type == "int":
        return "u8" if row.takes_rows() and row.is_truth() else "i32"
    return "f64"


def called(row):
    return row.many.name if row.takes_rows() else row.function.name


def exports(module):
    return [*(called(row) for row in asked_of(module)), *OTHERS]


def entry(row):
    assert row.takes_rows() or not row.is_split(), row.name
    inputs = [{"name": camel(one.name), "cName": one.name, "size": one.size, "isNumber": not one.shape} for one in row.inputs]
    outputs = [
        {"name": camel(one.name), "size": one.size, "type": type_of(row, one), "isTruth": one.is_truth(),
         "shape": bool(one.shape)}
        for one in row.outputs
    ]  # fmt: skip
    return {"name": camel(row.name), "function": called(row), "isOfRows": row.takes_rows(), "inputs": inputs, "outputs": outputs}


def table():
    lines = [f"{LICENCE}\n// {MARK}"]
    for module in ASKED:
        lines += [f"export const {module.upper()} = [", *(f"    {json.dumps(entry(row))}," for row in asked_of(module)), "];"]
    return "\n".join([*lines, ""])


@cache
def voice(row):
    return PlainVoice(row, {one.function.name: camel(one.name) for one in asked()}, {one.name: camel(one.name) for one in row.inputs})


def comment(lines):
    """A comment of the lines, each of which may be wrapped."""
    yield "/**"
    for line in lines:
        yield from wrapped(line, 110, " * ", " *   " if line.startswith("@") else " * ")
    yield " */"


def names_and(row, kind):
    """The names of the outputs, each with what `kind` says of it."""
    return {camel(one.name): kind(one) for one in row.outputs}


def one_or_object(types, mark=":"):
    """The type of the only output, or of an object that has them all."""
    listed = [f"{name}{mark} {kind}" for name, kind in types.items()]
    return next(iter(types.values())) if len(types) == 1 else f"{{ {'; '.join(listed)} }}"


def parameters_of(row, of_number, endless="tMax?: {}"):
    """The parameters with their types; `endless` stands for the time that may be missing."""
    kinds = [(camel(one.name), "Numbers" if one.shape else of_number) for one in row.inputs]
    return ", ".join(endless.format(kind) if name == "tMax" else f"{name}: {kind}" for name, kind in kinds)


def signature(row):
    """The function for one row with its types."""
    types = names_and(row, lambda one: ARRAYS[type_of(row, one)] if one.shape else "boolean" if one.is_truth() else "number")
    return f"{camel(row.name)}({parameters_of(row, 'number')}): {one_or_object(types)}"


def declaration(row):
    """The types of a function and of that for many rows, whose caller may give arrays for the results."""
    name, both = camel(row.name), "Numbers | number"
    said = [*voice(row).head(), *voice(row).notes()]
    for text, (first, *others) in voice(row).grouped(row.inputs):
        size = f"{MOTION if first.type == 'pw85_motion' else ''}{f' {first.size} numbers.' if first.shape else ''}"
        said.append(f"@param {camel(first.name)} {text}{size}")
        said += [f"@param {camel(one.name)} As `{camel(first.name)}`." for one in others]
    yield from comment(with_named_statuses(text).replace("``", "`") for text in said)
    yield f"{signature(row)};"
    yield from comment([f"{name}() of many rows: see {{@link Numbers}}."])
    yield f"{name}Rows({parameters_of(row, both)}): {one_or_object(names_and(row, lambda one: ARRAYS[type_of(row, one)]))};"
    out = one_or_object(names_and(row, lambda one: {"f64": "Doubles"}.get(kind := type_of(row, one), ARRAYS[kind])), "?:")
    yield f"{name}Rows<Out extends {out}>({parameters_of(row, both, 'tMax: {} | undefined')}, out: Out): Out;"


def types():
    made = {module: [line for row in asked_of(module) for line in [*declaration(row), ""]][:-1] for module in ASKED}
    made["mark"] = [f"// {MARK}"]
    return insert(SOURCE / "js/pw85.in.d.ts", "//@", made)


def files():
    return {"js/questions.js": table(), "js/pw85.d.ts": types(), "js/package.json": with_version("js/package.in.json")}


if __name__ == "__main__":
    run(lambda module: print(" ".join(f"-Wl,--export={name}" for name in exports(module))))
