# SPDX-License-Identifier: BSD-3-Clause
"""The functions of many rows: the made part of include/pw85_batch.h, by the functions of one row in pw85.h, pw85_grains.h and
pw85_shapes.h, and the functions in src/c_api/. Those that have lanes are in the files *_lanes.cpp, and call the kernel of LANES. The
others are in the files *_rows.cpp, and call the function of one row for each row, with an argument of src/rows/each_row.hpp for each
parameter.

The part has the functions of many rows for all functions of one row with an array among their inputs, except for WITHOUT. Their arrays
have a row in the place of each number or array; what else is to be said of them stands in those headers. Lines of api/pw85_batch.txt
say what is particular to a function:

    pw85_f ellipsoids and boxes: what is said of the results
        name: [n; optional] text

Where such a line does not say of what the rows are, the inputs do (BESIDE); where it says nothing of the results, their bits or answers
are the same. Indented lines describe parameters. A number "name: [as pw85_f()]" is one for all rows. Functions that have none of one row
are in the header by hand.
"""

import re
from itertools import groupby

from declarations import c_functions, functions
from layout import WIDTH, arguments, renewed, wrapped
from public_headers import ONE_ROW, source_text, text_of
from refusals import line_of, refuse
from rows import name_of_many
from shims import FILES, FOLDER, HEAD, SOURCES, questions

HEADER, TEXTS = "pw85_batch.h", "pw85_batch.txt"
WITHOUT = ("pw85_ellipsoid", "pw85_contains_2d", "pw85_containment_2d")
SAID = re.compile(r"^(?P<name>\w+)(?: (?P<rows>[\w -]+))?(?:: (?P<results>.*))?\n(?P<parameters>(?:    .*\n)*)", re.MULTILINE)
PLURALS = {"normal": "normals", "offset": "offsets", "direction": "directions", "quaternion": "quaternions", "start": "starts"}  # of inputs
# What there is beside ellipsoids, by an input.
BESIDE = {"offset": "{} and half-spaces", "lower": "{} and boxes", "vertex1": "{} and triangles", "axis": "{} and cylinders",
          "radius": "{} and capsules", "end1": "{} and segments", "r": "points and {}", "origin": "lines and {}"}  # fmt: skip

# The kernels of functions of many rows that have lanes: the header of the question in src/simd/lanes/, the
# arrays, whose members are the parameters that the rows do not have, and the rows, if they are not those of pairs.
LANES = {
    "contact": ("contact", "ContactArrays"),
    "contact_2d": ("contact", "ContactArrays"),
    "closest_approach": ("contact", "ApproachArray", "Directions{{directions, q1, q2}}"),
    "overlap": ("overlap", "OverlapArray"),
    "overlap_2d": ("overlap", "OverlapArray"),
    "overlap_volume": ("volumes", "VolumeArray"),
    "overlap_area_2d": ("two_dimensions", "AreaArray"),
    "distance": ("distance", "DistanceArrays"),
    "distance_geometry": ("distance", "DistanceArrays"),
    "penetration": ("depth", "DepthArrays"),
    "signed_distance": ("signed_distance", "SignedDistanceArrays"),
    "signed_distance_geometry": ("signed_distance", "SignedDistanceArrays"),
    "closest_passage": ("passage", "PassageArrays"),
    "grain_contact": ("grains", "GrainArrays"),
    "distance_point": ("surface_distances", "SurfaceArrays", "PointRows{r, q}"),
    "distance_cylinder": ("surface_distances", "SurfaceArrays", "CylinderRows{axis, radius, center, q}"),
    "intersect_line": ("lines", "ChordArrays", "SetRows<Lines>{{origin, directions}, q}"),
}
SETS = {"segment": "SetRows<Segments>{{end1, end2}, q}", "triangle": "SetRows<Triangles>{{vertex1, vertex2, vertex3}, q}",
        "box": "SetRows<Boxes>{{lower, upper}, q}"}  # fmt: skip
LANES |= {f"contact_{name}": ("shapes", "SetContactArrays", rows) for name, rows in SETS.items()}
LANES |= {f"overlap_{name}": ("shapes", "OverlapArray", rows) for name, rows in SETS.items()}


def has_rows(function):
    """Whether there is a function of many rows: each parameter is a number or an array of stated length, and an input is an array."""
    is_known = all(one.type in ("double", "int", "pw85_motion") and not one.rows for one in function.parameters)
    return function.type == "int" and is_known and any(one.length for one in function.inputs)


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
    """The function of many rows for a function of one row, with what api/pw85_batch.txt says of it."""

    def __init__(self, function, said=None):
        self.function, self.name = function, name_of_many(function.name)
        said = said or SAID.match(f"{function.name}\n")  # nothing but the name
        self.rows, self.results = said["rows"] or rows_of(function), said["results"]
        self.row = self.rows.split()[0].removesuffix("s")
        self.said, names = {}, [name for one in function.parameters for name in names_of(one)]
        for line in said["parameters"].splitlines():
            name, _, text = line.strip().partition(": ")
            place = line_of(TEXTS, said.string, said.string.index(line, said.start()))
            is_wrong = name not in names or name in self.said or not text.startswith("[")
            refuse(place, {f"{self.name}() has no parameter {name}, or it is described twice, or without brackets": is_wrong})
            self.said[name] = text

    def made(self, one, name):
        """The parameter of many rows that stands for one of one row: its declaration, and tag, name, attributes and text of its comment."""
        is_truth = one.is_output() and one.is_truth()
        is_optional = one.is_output() and (one.nullable or len(one.members()) > 1)
        extents = "×".join(["n", *(map(str, one.shape) if len(names_of(one)) == 1 else ())])
        limits = [limit.attribute for limit in one.attributes.limits]
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
        lines = [line for part in text for line in wrapped(part, WIDTH - 4) or [""]]
        comment = "\n".join(f" * {line}".rstrip() for line in lines)
        head = arguments(f"PW85_API int {self.name}(", ["size_t n", *(declared for declared, *_ in listed)], ");")
        return f"/**{comment[2:]} */\n{head}\n"


def statements():
    """Those of all functions, in the order of the headers."""
    text, found, end = source_text(f"api/{TEXTS}"), {}, 0
    known = {one.name: one for one in functions(*ONE_ROW) if has_rows(one) and one.name not in WITHOUT}
    for said in SAID.finditer(text):
        is_wrong = said["name"] not in known or said["name"] in found
        refuse(line_of(TEXTS, text, end), {"not understood": said.start() != end,
               f"no function {said['name']}() of one row, or it is named twice": is_wrong})  # fmt: skip
        found[said["name"]], end = said, said.end()
    refuse(line_of(TEXTS, text, end), {"not understood": end != len(text)})
    return [Statement(one, found.get(name)) for name, one in known.items()]


def header():
    return renewed(HEADER, {"rows": lambda *_: "\n".join(one.declaration() for one in statements())})


def row_argument(one, many):
    """The argument of each_row() for a parameter of one row; `many` stand for it in the function of many rows."""
    first, element = many[0], f"{many[0].type}{' const' * many[0].const}"
    kinds = {"SameNumber": not first.pointer, "TwoNumbers": len(many) > 1, "Bytes": first.type == "unsigned char",
             "Numbers": not one.pointer, f"OptionalRowsOf<{one.size}>": first.nullable,
             f"RowsOf<{one.size}>": element == "double const", f"RowsOf<{one.size}, {element}>": True}  # fmt: skip
    kind = next(kind for kind, is_of_kind in kinds.items() if is_of_kind)
    return f"{kind}{{{', '.join(argument.name for argument in many)}}}"


def kernel_of(function):
    """The header of the question, the rows and the arrays of a function that has lanes."""
    question, arrays, *rows = LANES[function.plain]
    return question, (rows or [f"PairArrays<{function.dimension}>{{r12, q1, q2}}"])[0], arrays


def of_many_rows(statement):
    many = {one.name: one for one in c_functions()[statement.name].parameters}
    listed = [(one, [many[name] for name in names_of(one)]) for one in statement.function.parameters]
    if statement.function.plain in LANES:
        _, rows, arrays = kernel_of(statement.function)
        others = ", ".join(name for name in many if name not in ("n", *re.findall(r"\w+", rows)))
        names = [one.name for one in many.values() if one.pointer and not one.nullable]
        begin, passed = "    return compute_rows(", [rows, f"{arrays}{{{others}}}", *names]
    else:
        names = [first.name for _, (first, *_) in listed]
        begin, passed = "    return each_row(", [statement.function.name, *(row_argument(one, own) for one, own in listed)]
    head = arguments(f"int {statement.name}(", c_functions()[statement.name].written, ")")
    table = arguments("    static constexpr char const *names[] = {", [f'"{one}"' for one in [statement.name, *names]], "};")
    return f"\n{head}\n{{\n{table}\n{arguments(begin, ['names', 'n', *passed], ');')}\n}}\n"


def many_rows_file(title, listed):
    has_lanes = listed[0].function.plain in LANES
    questions = sorted({kernel_of(one.function)[0] for one in listed}) if has_lanes else []
    own = ["rows/many_pairs", *(f"simd/lanes/{name}" for name in questions)] if has_lanes else ["rows/each_row"]
    head = HEAD.format(what=f", many rows with{'' if has_lanes else 'out'} lanes: {title[0].lower()}{title[1:]}", sources=SOURCES,
                       includes="\n".join(["#include <pw85_batch.h>\n", *(f'#include "../{name}.hpp"' for name in own)]),
                       namespaces="using namespace pw85::detail::kernels;")  # fmt: skip
    return head + "".join(map(of_many_rows, listed))


def files():
    listed = {}
    for statement in statements():
        question = questions()[statement.function.name]
        name = f"{question}_{'lanes' if statement.function.plain in LANES else 'rows'}"
        listed.setdefault(name, (FILES[question], []))[1].append(statement)
    made = {f"{FOLDER}/{name}.cpp": many_rows_file(*own) for name, own in listed.items()}
    return made | {f"include/{HEADER}": text_of(HEADER)}
