# SPDX-License-Identifier: BSD-3-Clause
"""Makes what the npm package in js/ has by the declarations of the C API: the table of its functions, their types, package.json.

A function of JavaScript answers a question for one pair, and its relative with `Rows` for many: pw85_contact_batch() is contact() and
contactRows(). js/pw85.js reads arguments and writes results by the table. The names are those of C without `pw85_`, in camel case.
"""

import json
import re
import sys
import textwrap
from functools import cache
from math import prod

from declarations import SOURCE, version
from rows import row_functions
from voice import PlainVoice, with_named_statuses

FOLDER = SOURCE / "js"
# The questions of each module, by their names in C. A page loads at most 300 kB for ellipsoids, and as much for ellipses.
ASKED = {
    "pw85": ("ellipsoid", "ellipsoid_quaternion", "contact", "contact_geometry", "overlap", "distance", "overlap_volume", "first_contact"),
    "plane": ("ellipse", "contact_2d", "contact_geometry_2d", "overlap_2d", "distance_2d", "overlap_area_2d"),
}
OTHERS = ("pw85_last_error", "pw85_strerror")  # functions that js/pw85.js calls beside them
ARRAYS = {"f64": "Float64Array", "i32": "Int32Array", "u8": "Uint8Array"}
MARK = "Made by api/javascript.py from the headers of the C API."
LICENCE = "// SPDX-License-Identifier: BSD-3-Clause"


@cache
def asked_of(module):
    found = {row.name: row for row in row_functions() if row.name in ASKED[module]}
    assert set(found) == set(ASKED[module]), set(ASKED[module]) - set(found)
    return list(found.values())


def asked():
    return [row for module in ASKED for row in asked_of(module)]


def camel(name):
    return re.sub(r"_(\w)", lambda match: match[1].upper(), name)


def type_of(row, one):
    """The numbers that C writes."""
    if one.is_integer():
        return "u8" if row.takes_rows() and row.is_truth() else "i32"
    return "f64"


def called(row):
    """The function of C that is called."""
    return row.many.name if row.takes_rows() else row.function.name


def exports(module):
    """The functions of C in a module."""
    return [*(called(row) for row in asked_of(module)), *OTHERS]


def entry(row):
    """A row of the table."""
    assert row.takes_rows() or not row.is_split(), row.name
    inputs = [{"name": camel(one.name), "cName": one.name, "size": prod(one.shape), "isNumber": not one.shape} for one in row.inputs]
    outputs = [
        {"name": camel(one.name or row.name), "size": prod(one.shape), "type": type_of(row, one), "isTruth": one.is_truth(),
         "shape": bool(one.shape)}
        for one in row.outputs
    ]  # fmt: skip
    return {"name": camel(row.name), "function": called(row), "isOfRows": row.takes_rows(), "inputs": inputs, "outputs": outputs}


def table():
    lines = [f"{LICENCE}\n// {MARK}"]
    for module in ASKED:
        lines += [f"export const {module.upper()} = [", *(f"    {json.dumps(entry(row))}," for row in asked_of(module)), "];"]
    return "\n".join([*lines, ""])


def plain(text):
    """A text of the headers as it stands in comments."""
    return with_named_statuses(text).replace("``", "`")


class InJavaScript(PlainVoice):
    """What the headers say, in the words of JavaScript."""

    def __init__(self, row):
        super().__init__(row, row, {one.function.name: camel(one.name) for one in asked()})
        self.arguments = {one.name: camel(one.name) for one in row.inputs}

    def of_argument(self, one):
        """What an argument is, with its numbers."""
        count = prod(one.shape)
        motion = " Velocity (3 numbers), angular velocity (3 numbers), growth of the semi-axes per unit of time."
        said = plain(self.described(one.name))
        return f"{said}{motion if one.parameter.type == 'pw85_motion' else ''}{f' {count} numbers.' if one.shape else ''}"


def comment(lines, indent="    "):
    """A comment of the lines, each of which may be wrapped."""
    width = {"width": 110, "break_long_words": False, "break_on_hyphens": False}
    wrapped = []
    for line in lines:
        rest = " *   " if line.startswith("@") else " * "
        wrapped += textwrap.wrap(line, initial_indent=" * ", subsequent_indent=rest, **width)
    return "\n".join(f"{indent}{line}".rstrip() for line in ["/**", *wrapped, " */"])


def result(row, of_one):
    """The type of the result, by the type of an output."""
    types = {camel(one.name or row.name): of_one(one) for one in row.outputs}
    return next(iter(types.values())) if len(types) == 1 else f"{{ {'; '.join(f'{name}: {kind}' for name, kind in types.items())} }}"


def out_of(row):
    """The type of the arrays that the caller gives for results."""
    listed = {camel(one.name or row.name): type_of(row, one) for one in row.outputs}
    arrays = {name: "Doubles" if kind == "f64" else ARRAYS[kind] for name, kind in listed.items()}
    return next(iter(arrays.values())) if len(arrays) == 1 else f"{{ {'; '.join(f'{name}?: {kind}' for name, kind in arrays.items())} }}"


def parameters_of(row, kind):
    optional = {"t_max"}
    return ", ".join(f"{camel(one.name)}{'?' if one.name in optional else ''}: {kind(one)}" for one in row.inputs)


def signature(row):
    """The function for one row with its types."""
    one = result(row, lambda output: ARRAYS[type_of(row, output)] if output.shape else "boolean" if output.is_truth() else "number")
    return f"{camel(row.name)}({parameters_of(row, lambda one: 'Numbers' if one.shape else 'number')}): {one}"


def declaration(row):
    """The types of a function and of that for many rows."""
    voice, name = InJavaScript(row), camel(row.name)
    rows = result(row, lambda output: ARRAYS[type_of(row, output)])
    many = parameters_of(row, lambda one: "Numbers" if one.shape else "Numbers | number")
    listed = [f"@param {camel(one.name)} {voice.of_argument(one)}" for one in row.inputs]
    last = "tMax: Numbers | number | undefined" if "tMax?" in many else ""
    with_out = re.sub(r"tMax\?: [^,]*$", last, many)
    said = [plain(text) for text in [*voice.head(), *voice.notes()]]
    return "\n".join([
        comment([*said, *listed]), f"    {signature(row)};",
        comment([f"{name}() of many rows: see {{@link Numbers}}."]), f"    {name}Rows({many}): {rows};",
        f"    {name}Rows<Out extends {out_of(row)}>({with_out}, out: Out): Out;", "",
    ])  # fmt: skip


def types():
    text = (FOLDER / "pw85.in.d.ts").read_text(encoding="utf-8")
    for module in ASKED:
        text = text.replace(f"    // @{module}@\n", "\n".join(map(declaration, asked_of(module))))
    return text.replace("// @mark@", f"// {MARK}")


def package():
    return (FOLDER / "package.in.json").read_text(encoding="utf-8").replace("@version@", version())


def files():
    """The texts of all made files by their paths."""
    made = {"questions.js": table(), "pw85.d.ts": types(), "package.json": package()}
    return {FOLDER / path: text for path, text in made.items()}


if __name__ == "__main__":
    print(" ".join(f"-Wl,--export={name}" for name in exports(sys.argv[1])))
