# SPDX-License-Identifier: BSD-3-Clause
"""The header include/pw85_batch.h, made of its template api/pw85_batch.h.in and of the functions of one row in pw85.h,
pw85_grains.h and pw85_shapes.h.

At the mark @rows stand the functions of many rows for all functions of one row with an array among their inputs, except for those that
the mark names. Their arrays have a row in the place of each number or array; what else is to be said of them stands in those headers.
Lines below the mark say what is particular to a function:

    pw85_f ellipsoids and boxes: what is said of the results
        name: [n; optional] text

Where such a line does not say of what the rows are, the inputs do (BESIDE); where it says nothing of the results, their bits or answers
are the same. Indented lines describe parameters. A number "name: [as pw85_f()]" is one for all rows. Functions that have none of one row
are in the template as they are.
"""

import re
from itertools import groupby

import layout
from causes import LIMITS
from declarations import c_functions, functions
from public_headers import INCLUDE, ONE_ROW, SOURCE
from refusals import Refused, line_of
from rows import TRUTHS, name_of_many

HEADER, TEMPLATE = INCLUDE / "pw85_batch.h", SOURCE / "api/pw85_batch.h.in"
MARK = re.compile(r"^@rows without (?P<without>.*)\n(?P<said>(?:(?:    )?\w.*\n)*)", re.MULTILINE)
SAID = re.compile(r"^(?P<name>\w+)(?: (?P<rows>[\w -]+))?(?:: (?P<results>.*))?\n(?P<parameters>(?:    .*\n)*)", re.MULTILINE)
PLURALS = {"normal": "normals", "offset": "offsets", "direction": "directions", "quaternion": "quaternions", "start": "starts"}  # of inputs
# What there is beside ellipsoids, by an input.
BESIDE = {"offset": "{} and half-spaces", "lower": "{} and boxes", "vertex1": "{} and triangles", "end1": "{} and segments",
          "axis": "{} and cylinders", "r": "points and {}", "origin": "lines and {}"}  # fmt: skip


def has_rows(function):
    """Whether there is a function of many rows: each parameter is a number or an array of stated length, and an input is an array."""
    is_known = all(one.type in ("double", "int", "pw85_motion") and not one.rows for one in function.parameters)
    return function.type == "int" and "__" not in function.name and is_known and any(one.length for one in function.inputs)


def rows_of(function):
    """What the rows are."""
    names = {one.name for one in function.inputs}
    text = next((text for name, text in BESIDE.items() if name in names), "{}")
    return "pairs" if names & {"q2", "s2"} else text.format("ellipses" if function.dimension == 2 else "ellipsoids")


def names_of(one):
    """The names that a parameter of one row has in the function of many rows."""
    if one.is_output():
        return one.members() if one.length == len(one.members()) else [one.name]
    return [PLURALS.get(one.name, one.name)]


class Statement:
    """The function of many rows for a function of one row, with what the template says of it."""

    def __init__(self, function, said=None):
        self.function, self.name = function, name_of_many(function.name)
        self.rows = (said and said["rows"]) or rows_of(function)
        self.row = self.rows.split()[0].removesuffix("s")
        self.results = said and said["results"]
        self.said, names = {}, [name for one in function.parameters for name in names_of(one)]
        for line in said["parameters"].splitlines() if said else ():
            name, _, text = line.strip().partition(": ")
            if name not in names or name in self.said or not text.startswith("["):
                place = line_of(TEMPLATE.name, said.string, said.string.index(line, said.start()))
                raise Refused(f"{place}: {self.name}() has no parameter {name}, or it is described twice, or without brackets")
            self.said[name] = text

    def arguments(self):
        """The parameters of one row, each with those of the made header that stand for it."""
        many = {one.name: one for one in c_functions()[self.name].parameters}
        return [(one, [many[name] for name in names_of(one)]) for one in self.function.parameters]

    def made(self, one, name):
        """The parameter of many rows that stands for one of one row: its declaration, and tag, name, attributes and text of its comment."""
        is_truth = one.is_output() and one.type == "int" and one.name in TRUTHS
        is_optional = one.is_output() and (one.nullable or len(one.members()) > 1)
        extents = "×".join(["n", *(map(str, one.shape) if len(names_of(one)) == 1 else ())])
        limits = [limit for limit in LIMITS if limit in one.attributes.words]
        attributes = "; ".join(filter(None, [extents, one.attributes.unit, "optional" if is_optional else "", *limits]))
        said = self.said.get(name, f"[{attributes}] {f'1, 0, or 255 for a bad {self.row}' if is_truth else ''}")
        is_number = said.startswith(f"[as {self.function.name}()]")
        kind = "unsigned char" if is_truth else one.type
        declared = f"{kind} {name}" if is_number else f"{kind} {'' if one.is_output() else 'const '}*{name}"
        return declared, f"@param{'[out]' if one.is_output() else ''}", name, said.rstrip()

    def declaration(self):
        """The declaration of the function of many rows with its comment."""
        listed = [self.made(one, name) for one in self.function.parameters for name in names_of(one)]
        has_answers = any(declared.startswith("unsigned char") for declared, *_ in listed)
        results = self.results or f"with {'the same answers' if has_answers else 'bitwise equal results'}."
        mark = "." if results[0].isupper() else "," if results.startswith("with ") else ";"
        text = [f"Computes {self.function.name}() for n {self.rows}{mark} {results}", "", f"@param n [number of {self.row}s]"]
        for (tag, said), group in groupby(listed, lambda one: (one[1], one[3])):
            text.append(f"{tag} {','.join(name for _, _, name, _ in group)} {said}")
        text.append(f"@return as for {self.function.name}(), of the first bad {self.row}")
        lines = [line for part in text for line in layout.wrapped(part, layout.WIDTH - 4) or [""]]
        comment = "\n".join(f" * {line}".rstrip() for line in lines)
        head = layout.arguments(f"PW85_API int {self.name}(", ["size_t n", *(declared for declared, *_ in listed)], ");")
        return f"/**{comment[2:]} */\n{head}\n"


def statements():
    """Those of all functions, in the order of the headers."""
    text = TEMPLATE.read_text(encoding="utf-8")
    mark = MARK.search(text)
    if mark is None:
        raise Refused(f"{TEMPLATE.name}: no mark @rows")
    known = {one.name: one for one in functions(*ONE_ROW) if has_rows(one)}
    without, said = re.findall(r"\w+", mark["without"]), [*SAID.finditer(text, *mark.span("said"))]
    names = [*without, *(one["name"] for one in said)]
    for name, start in zip(names, [*(mark.start() for _ in without), *(one.start() for one in said)]):
        if name not in known or names.count(name) > 1:
            raise Refused(f"{line_of(TEMPLATE.name, text, start)}: no function {name}() of one row, or it is named twice")
    return [Statement(known[name], dict(zip(names[len(without):], said)).get(name)) for name in known if name not in without]


def header():
    made = "\n".join(one.declaration() for one in statements())
    text = MARK.sub(lambda match: made, TEMPLATE.read_text(encoding="utf-8"))
    if left := re.search(r"^@.*", text, re.MULTILINE):
        raise Refused(f"{TEMPLATE.name}: {left[0]}: not understood")
    return text
