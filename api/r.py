# SPDX-License-Identifier: BSD-3-Clause
"""Makes what the R package in r/ has by the declarations of the C API: R functions, what they call in C, pages of help.

A function of R asks a question (api/questions.py): pw85_contact() and pw85_contact_2d() are contact(x, y), where `x` and `y` are data
frames with a row for each ellipsoid. r/src/rows.c reads their columns and calls the functions of C by the tables that are made here.
"""

import re
import unicodedata

from layout import filled
from public_headers import with_version
from questions import MOTION, c_source, questions
from voice import with_named_statuses

NAMES = {"overlap": "overlaps"}  # the names in R that are others than those of C
ENTRIES = {(2, 2): "x y", (2, 3): "xx xy yy", (3, 3): "x y z", (3, 6): "xx xy xz yy yz zz"}  # by the dimension and their number
WHICH = {(2, 3): "ellipse or ellipsoid", (2,): "ellipse", (3,): "ellipsoid"}
MARK = "made by api/r.py from the headers of the C API"
# Letters that pages of help have in other words, because not every typesetter of R has them.
ASCII = {"λ": "lambda", "μ": "mu", "α": "alpha", "β": "beta", "κ": "kappa", "ρ": "rho", "ε": "epsilon", "ω": "omega", "δ": "delta",
         "Σ": "Sigma", "∂": "d", "√": "sqrt ", "×": " x ", "·": ".", "≤": "<=", "≥": ">=", "π": "pi", "−": "-", "ᵀ": "^T"}  # fmt: skip
# What examples give for other arguments than ellipsoids.
VALUES = {"lambda": "0.5", "mu2": "1", "t_max": "Inf", "motion1": "numeric(7)", "motion2": "c(-1, numeric(6))"}


def name_of(question):
    return NAMES.get(question.name, question.name)


def exported():
    """The questions that users ask, without what the constructors call: these are called by r/R/ellipsoids.R."""
    return [one for one in questions() if not one.is_constructor()]


def voice(question):
    return question.voice(lambda one: "" if one.is_constructor() else name_of(one))


def usage(question):
    listed = ", ".join(f"{name} = Inf" if name == "t_max" else name for name in question.arguments)
    return f"{'.' if question.is_constructor() else ''}{name_of(question)}({listed})"


def columns(question, dimension):
    """The names of the columns of the result, output by output."""
    row, found = question.rows[dimension], []
    for one in row.outputs:
        numbers = " ".join(map(str, range(1, one.size + 1)))
        entries = ENTRIES.get((dimension, one.size), numbers) if len(one.shape) == 1 else numbers
        prefix = "" if len(row.outputs) == 1 else f"{one.name}_"
        found += [f"{prefix}{entry}" for entry in entries.split()] if one.shape else [one.name]
    return found


def r_source():
    called = [(usage(one).replace("(", " <- function(", 1), ", ".join([f'"{one.name}"', *one.arguments])) for one in questions()]
    lines = [f"{defined} .External(C_ask, {given})" for defined, given in called]
    return "\n".join([f"# SPDX-License-Identifier: BSD-3-Clause\n# The questions of ellipsoids: {MARK}.\n", *lines, ""])


def help_text(text):
    """A text of the headers as it stands in a page of help, in ASCII."""
    text = re.sub(r"Σ(?=_?\w* ?[|(])", "sum ", text)
    text = re.sub("[⁰¹²³⁴-⁹⁻]+", lambda match: "^" + unicodedata.normalize("NFKC", match[0]), text)
    text = unicodedata.normalize("NFKC", "".join(ASCII.get(letter, letter) for letter in text))
    text = re.sub(r"([{}%])", r"\\\1", with_named_statuses(text))
    text = re.sub(r"`+([^`]+)`+", r"\\code{\1}", text).replace("pw85-package", "\\link{pw85-package}")
    return filled(text)


def described(question):
    which = WHICH[tuple(sorted(question.rows))]
    first, second = f"A data frame with a row for each {which}, see pw85-package.", f"The second {which.split()[-1]}s, as `x`."
    yield from zip(question.ellipsoids, (first, second) if "x" in question.ellipsoids else (second,))
    for text, group in voice(question).grouped(question.others):
        one, names = group[0], ", ".join(one.name for one in group)
        size = f" A matrix or data frame with {one.size} columns, or {one.size} numbers for all rows" if one.shape else ""
        yield names, f"{text}{size}{f': {MOTION}' if one.type == 'pw85_motion' else '.' if one.shape else ''}"


def value_of(question):
    row, dimension = question.first, max(question.rows)
    texts = [(", ".join(f"\\code{{{one.name}}}" for one in group), text) for text, group in voice(question).grouped(row.outputs)]
    if len(row.outputs) == 1:
        kind = "logical vector" if row.is_truth() else "matrix" if row.outputs[0].shape else "numeric vector"
        text = f"A {kind} with {'a row' if kind == 'matrix' else 'an element'} for each row. {'' if row.is_truth() else texts[0][1]}"
        return [help_text(text)]
    text = ("A data frame with a row for each row of the arguments, and these columns; a vector has a column for each entry, as "
            f"`{columns(question, dimension)[-1]}`.")  # fmt: skip
    items = (f"\\item{{{names}}}{{{help_text(text)}}}" for names, text in texts)
    return [help_text(text), "\\describe{", *items, "}"]


def page(question):
    name, (brief, *rest) = name_of(question), voice(question).head()
    details = [*rest, *voice(question).notes(), question.dimensions]
    details.append(
        "Row i of the result belongs to row i of `x` (ellipsoid 1, form q1) and of `y` (ellipsoid 2, form q2); r12 is the centre of "
        "ellipsoid 2 minus that of ellipsoid 1. Fewer rows are recycled."
        if "y" in question.arguments
        else "The centre plays no part."
    )
    errors = help_text("If a row has an NA, its result is NA. A row that is refused is an error of class `pw85_error`: see pw85-package.")
    title = help_text(brief.rstrip(".")).replace("\n", " ")
    function = f"The function of the C API is \\code{{{question.first.function.name}}}."
    return "\n".join([
        f"% SPDX-License-Identifier: BSD-3-Clause\n% {MARK[0].upper()}{MARK[1:]}.",
        f"\\name{{{name}}}\n\\alias{{{name}}}\n\\title{{{title}}}",
        f"\\description{{\n{help_text(brief)}\n}}", f"\\usage{{\n{usage(question)}\n}}", "\\arguments{",
        *(f"\\item{{{one}}}{{{help_text(text)}}}" for one, text in described(question)), "}",
        "\\details{\n" + "\n\n".join([*map(help_text, details), function]) + "\n}",
        "\\value{\n" + "\n".join(value_of(question)) + f"\n\n{errors}\n}}", f"\\examples{{\n{example_of(question)}\n}}\n",
    ])  # fmt: skip


def example_of(question):
    made = "ellipsoids({}, {}, 0, a = 3, b = 2, c = 1)" if 3 in question.rows else "ellipses({}, {}, a = 3, b = 1)"
    lines = [f"x <- {made.format(0, 0)}"] + [f"y <- {made.format(5.5, 0.5)}"] * ("y" in question.arguments)
    others = [VALUES.get(one.name, "c(1, 0, 0)") for one in question.others]
    return "\n".join([*lines, f"{name_of(question)}({', '.join([*question.ellipsoids, *others])})"])


def files():
    table = c_source(MARK, "pw85_r.h", columns=columns)
    made = {"r/DESCRIPTION": with_version("r/DESCRIPTION.in"), "r/src/questions.c": table, "r/R/questions.R": r_source()}
    return made | {f"r/man/{name_of(one)}.Rd": page(one) for one in exported()}
