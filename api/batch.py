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
from itertools import groupby

import layout
from attributes import LIMITS
from declarations import INCLUDE, SOURCE, c_functions
from rows import TRUTHS, name_of_many

HEADER, TEMPLATE = INCLUDE / "pw85_batch.h", SOURCE / "api/pw85_batch.h.in"
ROWS = re.compile(
    r"^@(?P<kind>rows|lanes) (?P<name>\w+)(?: (?P<rows>[\w -]+))?(?:: (?P<results>.*))?\n(?P<said>(?:    .*\n)*)", re.MULTILINE
)
PLURALS = {"normal": "normals", "offset": "offsets", "direction": "directions", "quaternion": "quaternions", "start": "starts"}  # of inputs


def names_and_shape(one):
    """The names that a parameter of one row has in the function of many rows, and the shape of a row."""
    if one.is_output():
        return (one.members(), ()) if one.length == len(one.members()) else ([one.name], one.shape)
    return [PLURALS.get(one.name, one.name)], one.shape


class Statement:
    """A line of the template."""

    def __init__(self, match):
        self.place = f"{TEMPLATE.name}:{match.string.count(chr(10), 0, match.start()) + 1}"
        if match["name"] not in c_functions():
            raise ValueError(f"{self.place}: no function {match['name']}()")
        self.function = c_functions()[match["name"]]
        self.name = name_of_many(self.function.name)
        self.has_lanes = match["kind"] == "lanes"
        self.rows = match["rows"] or "pairs"
        self.row = self.rows.split()[0].removesuffix("s")
        self.said = dict(line.strip().split(": ", 1) for line in match["said"].splitlines())
        self.results = match["results"]
        if unknown := self.said.keys() - {name for one in self.function.parameters for name in names_and_shape(one)[0]}:
            raise ValueError(f"{self.place}: {self.name}() has no parameter {', '.join(sorted(unknown))}")

    def arguments(self):
        """The parameters of one row, each with those of the made header that stand for it."""
        many = {one.name: one for one in c_functions()[self.name].parameters}
        return [(one, [many[name] for name in names_and_shape(one)[0]]) for one in self.function.parameters]

    def made(self, one, name, shape):
        """The parameter of many rows that stands for one of one row: its declaration, and tag, name, attributes and text of its comment."""
        is_truth = one.is_output() and one.type == "int" and one.name in TRUTHS
        is_optional = one.is_output() and (one.nullable or len(one.members()) > 1)
        extents = "×".join(["n", *map(str, shape)])
        limits = [limit for limit in LIMITS if limit in one.attributes.words]
        attributes = "; ".join(filter(None, [extents, one.attributes.unit, "optional" if is_optional else "", *limits]))
        said = self.said.get(name, f"[{attributes}] {f'1, 0, or 255 for a bad {self.row}' if is_truth else ''}")
        is_number = said.startswith(f"[as {self.function.name}()]")
        kind = "unsigned char" if is_truth else one.type
        declared = f"{kind} {name}" if is_number else f"{kind} {'' if one.is_output() else 'const '}*{name}"
        return declared, f"@param{'[out]' if one.is_output() else ''}", name, said.rstrip()

    def declaration(self):
        """The declaration of the function of many rows with its comment."""
        names = ((one, *names_and_shape(one)) for one in self.function.parameters)
        listed = [self.made(one, name, shape) for one, own, shape in names for name in own]
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


def header():
    text = TEMPLATE.read_text(encoding="utf-8")
    made = ROWS.sub(lambda match: Statement(match).declaration() + "\n" * text.startswith("@", match.end()), text)
    if left := re.search(r"^@.*", made, re.MULTILINE):
        raise ValueError(f"{TEMPLATE.name}: {left[0]}: not understood")
    return made


def statements():
    """The lines of the template, in order."""
    return [Statement(match) for match in ROWS.finditer(TEMPLATE.read_text(encoding="utf-8"))]
