# SPDX-License-Identifier: BSD-3-Clause
"""Questions about ellipsoids, as R and Octave ask them: one function for two and three dimensions, on columns of numbers.

What they call in C is made here, too: a function for each dimension that answers n rows, whose inputs and outputs are arrays. The
sources r/src/rows.c and octave/src/pw85_mex.c read the columns and call these functions by tables.
"""

from dataclasses import dataclass
from functools import cache

from layout import filled
from public_headers import ONE_ROW
from rows import row_functions
from voice import PlainVoice

CONSTRUCTORS = ("ellipse", "ellipsoid", "ellipsoid_quaternion")
KINDS = {"r12": "PW85_SEPARATION", "q": "PW85_FORM1", "q1": "PW85_FORM1", "q2": "PW85_FORM2"}
DIMENSIONS = {(2, 3): "For ellipses and ellipsoids.", (2,): "For ellipses.", (3,): "For ellipsoids in three dimensions."}
MOTION = ("the velocity (3 numbers), the angular velocity in radians per unit of time (3 numbers), and growth: at time t the semi-axes "
          "are 1 + growth t times those at time 0.")  # fmt: skip


@dataclass
class Question:
    """The functions of C in two and three dimensions, of which one may be missing."""

    name: str  # in C, without `_2d`
    rows: dict  # by the dimension, of which the highest comes first

    @property
    def first(self):
        """The function whose comment is the text."""
        return self.rows[max(self.rows)]

    @property
    def others(self):
        """The operands that are not ellipsoids."""
        return [one for one in self.first.inputs if one.name not in KINDS]

    @property
    def ellipsoids(self):
        """The names of arguments that stand for centres and forms."""
        names = {one.name for one in self.first.inputs}
        return [name for name, forms in (("x", {"q", "q1"}), ("y", {"q2"})) if names & forms]

    @property
    def arguments(self):
        return [*self.ellipsoids, *(one.name for one in self.others)]

    @property
    def dimensions(self):
        """For which dimensions it is, in words."""
        return DIMENSIONS[tuple(sorted(self.rows))]

    def is_constructor(self):
        return self.name in CONSTRUCTORS

    def voice(self, name_of):
        """What the headers say, in a language in which a question has a name, or none."""
        return PlainVoice(self.first, {row.function.name: name_of(one) for one in questions() for row in one.rows.values()})


def is_asked(row):
    names = [one.name for one in row.inputs]
    if row.is_building_block() or row.function.header not in (*ONE_ROW, "pw85_batch.h"):
        return False
    return names == ["q"] or names[1:3] == ["q1", "q2"] or row.name in CONSTRUCTORS


@cache
def questions():
    found = {}
    for row in filter(is_asked, row_functions()):
        dimension = 2 if row.name == "ellipse" else row.function.dimension
        found.setdefault(row.name.removesuffix("_2d"), {})[dimension] = row
    return [Question(name, rows) for name, rows in found.items()]


def call(row):
    """The lines of C that compute n rows."""
    if row.takes_rows():
        passed = [f"in[{k}]" for k in range(len(row.inputs))] + [f"out[{k}]" for k in range(len(row.outputs))]
        return ["    (void)row;", f"    return {row.many.name}({', '.join(['n', *passed])});"]
    passed, kind = [], "unsigned char" if row.is_truth() else "double"
    for k, one in enumerate(row.inputs):
        text = f"in[{k}] + {one.size} * i" if one.shape else f"in[{k}][i]"
        passed.append(f"(pw85_motion const *)({text})" if one.type == "pw85_motion" else text)
    passed += [f"&integer{k}" if one.type == "int" else f"(double *)out[{k}] + {one.size} * i" for k, one in enumerate(row.outputs)]
    integers = [k for k, one in enumerate(row.outputs) if one.type == "int"]
    return ["    for (*row = 0; *row < n; ++*row) {", "        size_t const i = *row;", *(f"        int integer{k};" for k in integers),
            f"        int const status = {row.function.name}({', '.join(passed)});", "        if (status != 0) return status;",
            *(f"        (({kind} *)out[{k}])[i] = ({kind})integer{k};" for k in integers), "    }", "    return 0;"]  # fmt: skip


def wrapped(line):
    indent = " " * (len(line) - len(line.lstrip()))
    return filled(line.strip(), first=indent, rest=indent + "    ")


def entry(question, facts, columns):
    """The lines of a question in the table: its functions in two and three dimensions, and what c_source() is given."""
    yield f'    {{"{question.name}", {len(question.ellipsoids)}, {facts(question)}{{'
    for dimension, row in sorted(question.rows.items()):
        assert [one.name for one in row.inputs if one.name not in KINDS] == [one.name for one in question.others], question.name
        given = ", ".join(f'{{"{one.name}", {KINDS.get(one.name, "PW85_VALUES")}, {one.size}}}' for one in row.inputs)
        sizes, names = ", ".join(str(one.size) for one in row.outputs), ", ".join(f'"{one}"' for one in columns(question, dimension))
        text = f"{question.name}_{dimension}, {str(row.is_truth()).lower()}, {len(row.inputs)}, {{{given}}}, "
        yield wrapped(f"        [{dimension - 2}] = {{{text}{len(row.outputs)}, {{{sizes}}}{f', {{{names}}}' if names else ''}}},")
    yield "    }},"


def c_source(mark, header, facts=lambda question: "", columns=lambda question, dimension: ()):
    """The functions and the table of all questions by their names. A language can have facts of a question, and names of columns."""
    listed = sorted(questions(), key=lambda one: one.name)
    rows = {f"{one.name}_{dimension}": row for one in listed for dimension, row in sorted(one.rows.items())}
    arguments = "size_t n, double const *const *in, void *const *out, size_t *row"
    made = [line for name, row in rows.items() for line in (f"static int {name}({arguments})", "{", *call(row), "}", "")]
    head = f"/* SPDX-License-Identifier: BSD-3-Clause */\n/* The functions of ellipsoids: {mark}. */\n/* clang-format off */"
    return "\n".join([
        head, f'#include "{header}"', "", *map(wrapped, made), "struct pw85_question const pw85_questions[] = {",
        *(line for one in listed for line in entry(one, facts, columns)), "};\n",
        "size_t const pw85_num_questions = sizeof pw85_questions / sizeof *pw85_questions;\n",
    ])  # fmt: skip
