# SPDX-License-Identifier: BSD-3-Clause
"""Makes what the R package in r/ has by the declarations of the C API: R functions, what they call in C, pages of help.

A function of R asks a question of ellipsoids, in two and three dimensions: pw85_contact() and pw85_contact_2d() are contact(x, y),
where `x` and `y` are data frames with a row for each ellipsoid. r/src/rows.c reads their columns and calls the functions of C by
the tables that are made here.
"""

import re
import textwrap
import unicodedata
from dataclasses import dataclass
from functools import cache
from math import prod

from declarations import ONE_ROW, SOURCE, version
from rows import row_functions
from voice import PlainVoice, with_named_statuses

FOLDER = SOURCE / "r"
NAMES = {"overlap": "overlaps"}  # the names in R that are others than those of C
CONSTRUCTORS = ("ellipse", "ellipsoid", "ellipsoid_quaternion")  # called by r/R/ellipsoids.R
ENTRIES = {(2, 2): "x y", (2, 3): "xx xy yy", (3, 3): "x y z", (3, 6): "xx xy xz yy yz zz"}  # by the dimension and their number
KINDS = {"r12": "PW85_SEPARATION", "q": "PW85_FORM1", "q1": "PW85_FORM1", "q2": "PW85_FORM2"}
ELLIPSOIDS = {"x": "A data frame with a row for each ellipse or ellipsoid, see pw85-package.", "y": "The second ellipsoids, as `x`."}
DIMENSIONS = {(2, 3): "For ellipses and ellipsoids.", (2,): "For ellipses.", (3,): "For ellipsoids in three dimensions."}
MARK = "made by api/r.py from the headers of the C API"
# Letters that pages of help have in other words, because not every typesetter of R has them.
ASCII = {"λ": "lambda", "μ": "mu", "α": "alpha", "β": "beta", "κ": "kappa", "ρ": "rho", "ε": "epsilon", "ω": "omega", "δ": "delta",
         "Σ": "Sigma", "∂": "d", "√": "sqrt ", "×": " x ", "·": ".", "≤": "<=", "≥": ">=", "π": "pi", "−": "-", "ᵀ": "^T"}  # fmt: skip


@dataclass
class Question:
    """A function of R: those of C in two and three dimensions, of which one may be missing."""

    name: str
    rows: dict  # by the dimension

    @property
    def first(self):
        """The function whose comment is the text in R."""
        return self.rows[max(self.rows)]

    def others(self):
        """The operands that are not ellipsoids."""
        return [one for one in self.first.inputs if one.name not in KINDS]

    def arguments(self):
        ellipsoids = [name for name, forms in (("x", ("q", "q1")), ("y", ("q2",))) if {one.name for one in self.first.inputs} & {*forms}]
        return [*ellipsoids, *(one.name for one in self.others())]

    def is_constructor(self):
        return self.name in CONSTRUCTORS

    def usage(self):
        listed = ", ".join(f"{name} = Inf" if name == "t_max" else name for name in self.arguments())
        return f"{'.' if self.is_constructor() else ''}{self.name}({listed})"


def is_asked(row):
    names = [one.name for one in row.inputs]
    if row.is_building_block() or row.function.header not in (*ONE_ROW, "pw85_batch.h"):
        return False
    return names == ["q"] or names[1:3] == ["q1", "q2"] or row.name in CONSTRUCTORS


def questions():
    found = {}
    for row in filter(is_asked, row_functions()):
        name, is_flat = row.name.removesuffix("_2d"), row.name.endswith("_2d") or row.name == "ellipse"
        found.setdefault(name, {})[2 if is_flat else 3] = row
    return [Question(NAMES.get(name, name), rows) for name, rows in found.items()]


@cache
def exported():
    """The questions that users ask, without what the constructors call."""
    return [one for one in questions() if not one.is_constructor()]


@cache
def names_in_r():
    """The names in R of functions of C."""
    return {row.function.name: one.name for one in exported() for row in one.rows.values()}


def columns(row, dimension):
    """The names of the columns of the result, output by output."""
    found = []
    for one in row.outputs:
        count = prod(one.shape)
        numbers = " ".join(map(str, range(1, count + 1)))
        entries = ENTRIES.get((dimension, count), numbers) if len(one.shape) == 1 else numbers
        prefix = "" if len(row.outputs) == 1 else f"{one.name}_"
        found += [one.name or row.name] if not one.shape else [f"{prefix}{entry}" for entry in entries.split()]
    return found


def call(row):
    """The lines of C that compute n rows."""
    if row.takes_rows():
        given = [f"in[{k}]" for k in range(len(row.inputs))] + [f"out[{k}]" for k in range(len(row.outputs))]
        return [f"return {row.many.name}({', '.join(['n', *given])});"]
    assert not row.is_split(), row.name
    given = []
    for k, one in enumerate(row.inputs):
        text = f"in[{k}] + {prod(one.shape)} * i" if one.shape else f"in[{k}][i]"
        given.append(f"(pw85_motion const *)({text})" if one.parameter.type == "pw85_motion" else text)
    integers, written, stored = [], [], []
    kind = "unsigned char" if row.is_truth() else "double"
    for k, one in enumerate(row.outputs):
        if one.is_integer():
            integers.append(f"int integer{k};")
            written.append(f"&integer{k}")
            stored.append(f"(({kind} *)out[{k}])[i] = ({kind})integer{k};")
        else:
            written.append(f"(double *)out[{k}] + {prod(one.shape)} * i")
    return ["for (*row = 0; *row < n; ++*row) {", "    size_t const i = *row;", *(f"    {one}" for one in integers),
            f"    int const status = {row.function.name}({', '.join([*given, *written])});", "    if (status != 0) return status;",
            *(f"    {one}" for one in stored), "}", "return 0;"]  # fmt: skip


def wrapped(text, indent):
    return textwrap.fill(text, 100, initial_indent=indent, subsequent_indent=indent + "    ", break_long_words=False)


def table(question):
    """The C code of a question."""
    for dimension, row in question.rows.items():
        head = f"static int {question.name}_{dimension}(size_t n, double const *const *in, void *const *out, size_t *row)"
        yield wrapped(head, "") + ("\n{\n    (void)row;" if row.takes_rows() else "\n{")
        yield from (wrapped(line.strip(), " " * (4 + len(line) - len(line.lstrip()))) for line in call(row))
        yield "}\n"
    yield f"static struct pw85_question const {question.name}_question = {{"
    yield f'    "{question.name}",\n    {{'
    for dimension, row in sorted(question.rows.items()):
        others = [one.name for one in row.inputs if one.name not in KINDS]
        place = {name: k for k, name in enumerate(others)}
        rows = ((one.name, KINDS.get(one.name, "PW85_VALUES"), prod(one.shape), place.get(one.name, 0)) for one in row.inputs)
        inputs = ", ".join(f'{{"{name}", {kind}, {size}, {index}}}' for name, kind, size, index in rows)
        outputs = ", ".join(str(prod(one.shape)) for one in row.outputs)
        names = ", ".join(f'"{name}"' for name in columns(row, dimension))
        yield f"        [{dimension - 2}] = {{{question.name}_{dimension}, {str(row.is_truth()).lower()}, {len(row.inputs)},"
        yield f"{wrapped(f'{{{inputs}}}, {len(row.outputs)}, {{{outputs}}}, {{{names}}}}},', ' ' * 15)}"
    yield "    },\n};\n"
    arguments, ellipsoids = question.arguments(), sum(name in ("x", "y") for name in question.arguments())
    yield wrapped(f"static SEXP call_{question.name}({', '.join(f'SEXP {name}' for name in arguments)})", "") + "\n{"
    yield f"    SEXP const given[] = {{{', '.join(arguments)}}};"
    yield f"    return pw85_rows(&{question.name}_question, {ellipsoids}, {len(arguments) - ellipsoids}, given);\n}}\n"


def c_source():
    head = f"/* SPDX-License-Identifier: BSD-3-Clause */\n/* The questions of ellipsoids: {MARK}. */\n/* clang-format off */"
    lines = [head, '#include "pw85_r.h"', ""]
    lines += [line for question in questions() for line in table(question)]
    lines.append("R_CallMethodDef const pw85_questions[] = {")
    lines += [f'    {{"{one.name}", (DL_FUNC)&call_{one.name}, {len(one.arguments())}}},' for one in questions()]
    return "\n".join([*lines, "    {NULL, NULL, 0},", "};", ""])


def r_source():
    lines = [f"# SPDX-License-Identifier: BSD-3-Clause\n# The questions of ellipsoids: {MARK}.\n"]
    for one in questions():
        lines.append(f"{one.usage().replace('(', ' <- function(', 1)} .Call({', '.join([f'C_{one.name}', *one.arguments()])})")
    return "\n".join([*lines, ""])


class InR(PlainVoice):
    """What the headers say, in the words of R."""

    def __init__(self, question, names):
        super().__init__(question.first, question.first, names)


def help_text(text):
    """A text of the headers as it stands in a page of help, in ASCII."""
    text = re.sub(r"Σ(?=_?\w* ?[|(])", "sum ", text.replace("μ²", "mu2"))
    text = re.sub("[⁰¹²³⁴-⁹⁻]+", lambda match: "^" + unicodedata.normalize("NFKC", match[0]), text)
    text = unicodedata.normalize("NFKC", "".join(ASCII.get(letter, letter) for letter in text))
    text = re.sub(r"([{}%])", r"\\\1", with_named_statuses(text))
    text = re.sub(r"`+([^`]+)`+", r"\\code{\1}", text).replace("pw85-package", "\\link{pw85-package}")
    return textwrap.fill(text, 100, break_long_words=False, break_on_hyphens=False)


MOTION = ("the velocity (3 numbers), the angular velocity in radians per unit of time (3 numbers), and growth: at time t the semi-axes "
          "are 1 + growth t times those at time 0.")  # fmt: skip


def value_of(question, voice):
    """What the function returns."""
    row, dimension = question.first, max(question.rows)
    texts = [(one.name, voice.described(one.parameter.name)) for one in row.outputs]
    if len(texts) == 1:
        kind = "logical vector" if row.is_truth() else "matrix" if row.outputs[0].shape else "numeric vector"
        return [f"A {kind} with {'a row' if kind == 'matrix' else 'an element'} for each row. {'' if row.is_truth() else texts[0][1]}"]
    return ["A data frame with a row for each row of the arguments, and these columns; a vector has a column for each entry, as "
            f"`{columns(row, dimension)[-1]}`.", "@\\describe{",
            *(f"@\\item{{\\code{{{name}}}}}{{{help_text(text)}}}" for name, text in texts), "@}"]  # fmt: skip


def page(question):
    """The page of help of a function."""
    voice, row = InR(question, names_in_r()), question.first
    brief, *rest = voice.head()
    details = [*rest, *voice.notes(), DIMENSIONS[tuple(sorted(question.rows))]]
    details.append(
        "Row i of the result belongs to row i of `x` (ellipsoid 1, form q1) and of `y` (ellipsoid 2, form q2); r12 is the centre of "
        "ellipsoid 2 minus that of ellipsoid 1. Fewer rows are recycled." if "y" in question.arguments() else "The centre plays no part."
    )
    described = ELLIPSOIDS | {one.name: voice.described(one.name) + (
        f" A matrix or data frame with {prod(one.shape)} columns, or {prod(one.shape)} numbers for all rows" if one.shape else "") + (
        f": {MOTION}" if one.parameter.type == "pw85_motion" else "." if one.shape else "")
        for one in question.others()}  # fmt: skip
    value = [line[1:] if line.startswith("@") else help_text(line) for line in value_of(question, voice)]
    errors = help_text("If a row has an NA, its result is NA. A row that is refused is an error of class `pw85_error`: see pw85-package.")
    return "\n".join([
        f"% SPDX-License-Identifier: BSD-3-Clause\n% {MARK[0].upper()}{MARK[1:]}.",
        f"\\name{{{question.name}}}\n\\alias{{{question.name}}}\n\\title{{{title(brief)}}}",
        f"\\description{{\n{help_text(brief)}\n}}", f"\\usage{{\n{question.usage()}\n}}", "\\arguments{",
        *(f"\\item{{{name}}}{{{help_text(described[name])}}}" for name in question.arguments()), "}",
        "\\details{\n" + "\n\n".join(map(help_text, details)) + f"\n\nThe function of the C API is \\code{{{row.function.name}}}.\n}}",
        "\\value{\n" + "\n".join(value) + f"\n\n{errors}\n}}", f"\\examples{{\n{example_of(question)}\n}}\n",
    ])  # fmt: skip


def title(brief):
    """The first clause, as a title."""
    return help_text(re.split(r"[,:;(]|\. | which | that |\.$", brief)[0].strip()).replace("\n", " ")


def example_of(question):
    made = "ellipsoids({}, {}, 0, a = 3, b = 2, c = 1)" if 3 in question.rows else "ellipses({}, {}, a = 3, b = 1)"
    values = {"lambda": "0.5", "mu2": "1", "t_max": "Inf", "motion1": "numeric(7)", "motion2": "c(-1, numeric(6))"}
    lines = [f"x <- {made.format(0, 0)}"] + [f"y <- {made.format(5.5, 0.5)}"] * ("y" in question.arguments())
    others = [values.get(one.name, "c(1, 0, 0)") for one in question.others()]
    return "\n".join([*lines, f"{question.name}({', '.join([name for name in question.arguments() if name in 'xy'] + others)})"])


def files():
    """The texts of all made files by their paths."""
    made = {"DESCRIPTION": (FOLDER / "DESCRIPTION.in").read_text(encoding="utf-8").replace("@version@", version())}
    made |= {"src/questions.c": c_source(), "R/questions.R": r_source()} | {f"man/{one.name}.Rd": page(one) for one in exported()}
    return {FOLDER / path: text for path, text in made.items()}
