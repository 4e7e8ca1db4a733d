# SPDX-License-Identifier: BSD-3-Clause
"""The header include/pw85_batch.h, made of its template api/pw85_batch.h.in and of the functions of one row in pw85.h,
pw85_grains.h and pw85_shapes.h.

A line of the template

    @rows pw85_f ellipsoids and boxes: what is said of the results

becomes the declaration of pw85_f_batch() with its contract. "@lanes" is the same for functions that have lanes (LANES of shims.py). Its
arrays have a row in the place of each number or array; what else is to be said of them stands in those headers. Where the line does not
say of what the rows are, they are pairs; where it says nothing of the results, their bits or answers are the same.
Indented lines below, "name: [n; optional] text", describe parameters. A number "name: [as pw85_f()]" is one for all rows. The
declarations of functions that have none of one row are in the template as they are.
"""

import re
from dataclasses import dataclass
from itertools import groupby

import layout
from declarations import INCLUDE, LIMITS, SOURCE, c_functions
from rows import TRUTHS, name_of_many

HEADER, TEMPLATE = INCLUDE / "pw85_batch.h", SOURCE / "api/pw85_batch.h.in"
ROWS = re.compile(
    r"^@(?P<kind>rows|lanes) (?P<name>\w+)(?: (?P<rows>[\w -]+))?(?:: (?P<results>.*))?\n(?P<said>(?:    .*\n)*)", re.MULTILINE
)
PLURALS = {"normal": "normals", "offset": "offsets", "direction": "directions", "quaternion": "quaternions", "start": "starts"}  # of inputs
SAID = re.compile(r"\[(?P<attributes>[^\]]*)\] ?(?P<text>.*)")


@dataclass
class Argument:
    """A parameter of a function of many rows."""

    name: str
    type: str
    attributes: str
    text: str  # its sentence
    is_output: bool
    nullable: bool
    is_array: bool = True

    def declared(self):
        return f"{self.type} {'' if self.is_output else 'const '}*{self.name}" if self.is_array else f"{self.type} {self.name}"


def names_and_shape(one):
    """The names that a parameter of one row has in the function of many rows, and the shape of a row."""
    if one.is_output():
        return (one.members(), ()) if one.length == len(one.members()) else ([one.name], one.shape)
    return [PLURALS.get(one.name, one.name)], one.shape


def argument(function, one, name, shape, row, said):
    """The parameter of many rows that stands for one of one row. `said` has the sentences of the template."""
    is_truth = one.is_output() and one.type == "int" and one.name in TRUTHS
    is_optional = one.is_output() and (one.nullable or len(names_and_shape(one)[0]) > 1)
    limits = [limit for limit in LIMITS if limit in one.attributes.words]
    unit = [one.attributes.unit] if one.attributes.unit else []
    attributes = ["×".join(["n", *map(str, shape)]), *unit, *(["optional"] if is_optional else []), *limits]
    match = SAID.fullmatch(said.get(name, f"[{'; '.join(attributes)}] {f'1, 0, or 255 for a bad {row}' if is_truth else ''}"))
    is_array = match["attributes"] != f"as {function.name}()"
    nullable = "optional" in match["attributes"].split("; ")
    kind = "unsigned char" if is_truth else one.type
    return Argument(name, kind, match["attributes"], match["text"], one.is_output(), nullable, is_array)


class Statement:
    """A line of the template."""

    def __init__(self, match):
        self.function = c_functions()[match["name"]]
        self.has_lanes = match["kind"] == "lanes"
        self.rows = match["rows"] or "pairs"
        self.row = self.rows.split()[0].removesuffix("s")
        self.said = dict(line.strip().split(": ", 1) for line in match["said"].splitlines())
        self.results = match["results"]

    def arguments(self):
        """The parameters of one row, each with those that stand for it in the function of many rows."""
        return [
            (one, [argument(self.function, one, name, shape, self.row, self.said) for name in names])
            for one in self.function.parameters
            for names, shape in [names_and_shape(one)]
        ]

    def head(self, begin, end):
        """The declaration of the function of many rows."""
        declared = ["size_t n", *(argument.declared() for _, many in self.arguments() for argument in many)]
        return layout.arguments(f"{begin} {name_of_many(self.function.name)}(", declared, end)


def sentences(listed):
    """The descriptions of the parameters, one for neighbours of which the same is said."""
    for (is_output, attributes, text), group in groupby(listed, lambda one: (one.is_output, one.attributes, one.text)):
        yield f"@param{'[out]' if is_output else ''} {','.join(one.name for one in group)} [{attributes}] {text}".rstrip()


def declaration(match):
    """The declaration of a function of many rows with its comment, for a line of the template."""
    statement = Statement(match)
    listed = [one for _, many in statement.arguments() for one in many]
    name, row = statement.function.name, statement.row
    results = statement.results or f"with the same {'answers' if any(one.type == 'unsigned char' for one in listed) else 'bits'}."
    mark = "." if results[0].isupper() else "," if results.startswith("with ") else ";"
    text = [
        f"Computes {name}() for n {statement.rows}{mark} {results}",
        "",
        f"@param n [number of {row}s]",
        *sentences(listed),
        f"@return as for {name}(), of the first bad {row}",
    ]
    lines = [line for part in text for line in layout.wrapped(part, layout.WIDTH - 4) or [""]]
    comment = "\n".join(f" * {line}".rstrip() for line in lines)
    return f"/**{comment[2:]} */\n{statement.head('PW85_API int', ');')}\n"


def header():
    return ROWS.sub(declaration, TEMPLATE.read_text(encoding="utf-8"))


def statements():
    """The lines of the template, in order."""
    return [Statement(match) for match in ROWS.finditer(TEMPLATE.read_text(encoding="utf-8"))]
