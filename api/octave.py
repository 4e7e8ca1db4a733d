# SPDX-License-Identifier: BSD-3-Clause
"""Makes what the package for Octave and MATLAB in octave/ has by the declarations of the C API: functions with their help and a test,
and tables of what they call in C.

pw85_contact() and pw85_contact_2d() are pw85_contact (r12, q1, q2), where each argument is a matrix with a row for each pair. A pair
of rows of matGeom stands for these three: pw85_contact (x, y). octave/src/pw85_mex.c reads the arguments by the tables made here.
"""

import re
import textwrap
from functools import cache
from math import prod

import declarations
import r
from declarations import SOURCE

FOLDER = SOURCE / "octave"
MARK = r.MARK.replace("r.py", "octave.py")
BY_HAND = {"pw85_from_matgeom": "Quadratic forms", "pw85_reproducible": "Version and errors", "pw85_version": "Version and errors",
           "pw85_enclosing_ellipsoid": "Enclosing ellipsoids", "pw85_enclosing_ellipsoid_of": "Enclosing ellipsoids"}  # fmt: skip
MOST_COLUMNS = 128  # PW85_COLUMNS
# What the tests give for other arguments than ellipsoids.
VALUES = {"lambda": "0.5", "mu2": "1", "t_max": "Inf", "motion1": "zeros (1, 7)", "motion2": "[-1, zeros(1, 6)]", "a": "[3; 2]",
          "b": "1", "angle": "0.5", "semi_axes": "[3 2 1; 4 1 1]", "rotation": "eye (3)", "quaternion": "[0.9 0.1 0.3 0.2]"}  # fmt: skip
FORMS = {"r12": "r2 - r1", "q": "q2", "q1": "q1", "q2": "q2"}
ROWS = {2: "[0 0 3 1 0], [5.5 0.5 3 1 30; 5.9 0.1 3 1 10; 3.95 0.1 1 0.5 9]",
        3: "[0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]"}  # fmt: skip
ROWS_OF_ALL = ("Each argument has a row for each row of the results, or one row for all of them. What is refused is an error that names "
               "the argument and its row.")  # fmt: skip
COLUMNS = {2: "[xc yc a b theta]", 3: "[xc yc zc a b c phi theta psi]"}


@cache
def functions():
    """The questions by their names in Octave, which are those of the C API without `_2d`."""
    return {f"pw85_{one.first.name.removesuffix('_2d')}": one for one in r.questions()}


@cache
def names_in_octave():
    """The names in Octave of functions of C."""
    return {row.function.name: name for name, one in functions().items() for row in one.rows.values()}


def ellipsoids(question):
    return [name for name in question.arguments() if name in r.ELLIPSOIDS]


def num_ellipsoids(question):
    return len(ellipsoids(question))


def inputs(question):
    return [one.name for one in question.first.inputs]


def is_endless(question):
    return inputs(question)[-1] == "t_max"


def outputs(question):
    row = question.first
    return [one.name or row.name.removesuffix("_2d") for one in row.outputs]


def result(question):
    """What a call is assigned to."""
    found = outputs(question)
    return found[0] if len(found) == 1 else f"[{', '.join(found)}]"


def table(name, question):
    """The C code of a function, and its entry in the list of all."""
    short, lines, entries = name.removeprefix("pw85_"), [], []
    for dimension, row in sorted(question.rows.items()):
        head = f"static int {short}_{dimension}(size_t n, double const *const *in, void *const *out, size_t *row)"
        lines += [r.wrapped(head, "") + ("\n{\n    (void)row;" if row.takes_rows() else "\n{")]
        lines += [r.wrapped(line.strip(), " " * (4 + len(line) - len(line.lstrip()))) for line in r.call(row)] + ["}\n"]
        given = ", ".join(f'{{"{one.name}", {r.KINDS.get(one.name, "PW85_VALUES")}, {prod(one.shape)}}}' for one in row.inputs)
        sizes = [prod(one.shape) for one in row.outputs]
        assert sum(sizes) + sum(prod(one.shape) for one in row.inputs) <= MOST_COLUMNS, name
        text = f"[{dimension - 2}] = {{{short}_{dimension}, {str(row.is_truth()).lower()}, {len(row.inputs)}, {{{given}}}, "
        entries.append(r.wrapped(f"{text}{len(sizes)}, {{{', '.join(map(str, sizes))}}}}},", " " * 8))
    head = f'    {{"{short}", {num_ellipsoids(question)}, {str(is_endless(question)).lower()}, {{'
    return "\n".join(lines), "\n".join([head, *entries, "    }},"])


def c_source():
    made = [table(name, one) for name, one in sorted(functions().items())]
    head = f"/* SPDX-License-Identifier: BSD-3-Clause */\n/* The functions of ellipsoids: {MARK}. */\n/* clang-format off */"
    return "\n".join([
        head, '#include "pw85_octave.h"', "", *(text for text, _ in made), "struct pw85_question const pw85_questions[] = {",
        *(entry for _, entry in made), "};\n", "size_t const pw85_num_questions = sizeof pw85_questions / sizeof *pw85_questions;\n",
    ])  # fmt: skip


class InOctave(r.InR):
    """What the headers say, in the words of Octave."""

    def __init__(self, question):
        super().__init__(question, names_in_octave())


def help_text(text):
    return r.with_named_statuses(text).replace("`", "")


def paragraph(text, indent="  ", first=None):
    return textwrap.fill(help_text(text), 96, initial_indent=f"%{first or indent}", subsequent_indent=f"%{indent}",
                         break_long_words=False, break_on_hyphens=False)  # fmt: skip


def item(name, text):
    return paragraph(text, " " * 14, f"  {name:<10}  ")


def usages(name, question):
    """The ways to call a function."""
    given = [inputs(question), question.arguments()] if num_ellipsoids(question) else [inputs(question)]
    ways = [f"{result(question)} = {name} ({', '.join(listed)})" for listed in given]
    return [re.sub(", t_max", " [, t_max]", way) for way in ways]


def size_of(one, other):
    """What is said of the columns: those of ellipsoids, and of ellipses if they differ."""
    sizes = dict.fromkeys(prod(operand.shape) for operand in (one, other) if operand is not None)
    return f"{' or '.join(map(str, sizes))} column{'s' if max(sizes) > 1 else ''}"


def operands(question, attribute):
    """The inputs or outputs in the highest dimension, each beside that of ellipses."""
    flat = getattr(question.rows[2], attribute) if len(question.rows) == 2 else [None] * 99
    return zip(getattr(question.first, attribute), flat, strict=False)


def described_items(question, voice):
    for one, other in operands(question, "inputs"):
        motion = f": {r.MOTION}" if one.parameter.type == "pw85_motion" else "."
        absent = " Infinite if it is missing." if one.name == "t_max" else ""
        yield item(one.name, f"{voice.described(one.parameter.name)} {size_of(one, other).capitalize()}{motion}{absent}")
    if num_ellipsoids(question):
        shapes = " or, in the plane, ".join(COLUMNS[dimension] for dimension in sorted(question.rows, reverse=True))
        yield item(", ".join(ellipsoids(question)), f"Rows of matGeom, {shapes}: see pw85_from_matgeom.")
    yield "%"
    for (one, other), name in zip(operands(question, "outputs"), outputs(question), strict=True):
        matrix = f", a matrix of {one.shape[0]} x {one.shape[1]} row by row" if len(one.shape) == 2 else ""
        text = f"{voice.described(one.parameter.name)} {size_of(one, other).capitalize()}{matrix}."
        yield item(name, "true or false." if question.first.is_truth() else text)


def page(name, question):
    """The file of a function: help, body and test."""
    voice, head = InOctave(question), result(question)
    brief, *rest = voice.head()
    lines = [f"function {head} = {name} (varargin)", paragraph(brief, "  ", f"{name}  "), "%"]
    lines += [f"%   {way}" for way in usages(name, question)]
    for text in (*rest, *voice.notes(), r.DIMENSIONS[tuple(sorted(question.rows))], ROWS_OF_ALL):
        lines += ["%", paragraph(text)]
    lines += ["%", *described_items(question, voice), "%", f"%  The function of the C API is {question.first.function.name}().", ""]
    lines += ["% SPDX-License-Identifier: BSD-3-Clause", f"% {MARK[0].upper()}{MARK[1:]}."]
    lines += [f"  {head} = pw85_mex ('{name.removeprefix('pw85_')}', varargin{{:}});", "end", "", *test_of(name, question), ""]
    return "\n".join(lines)


def test_of(name, question):
    """Rows of matGeom give what their centres and forms give, and each row alone what it gives among others."""
    made, dimension = f"[a{{1:{len(outputs(question))}}}]", max(question.rows)
    values = [VALUES.get(one.name) or ("[1 0 0]" if prod(one.shape) == 3 else "[1 0]") for one in question.others()]
    if not num_ellipsoids(question):
        return ["%!test", f"%! q = {name} ({', '.join(values)});", "%! assert (all (q(:,[1 end])(:) > 0));"]
    left = iter(values)
    by_forms = ", ".join(FORMS.get(one.name) or next(left) for one in question.first.inputs)
    by_rows, last = (", ".join([*given[2 - num_ellipsoids(question) :], *values]) for given in (("x", "y"), ("x", "y(end,:)")))
    again = made.replace("a", "b")
    return ["%!test", f"%! [x, y] = deal ({ROWS[dimension]});", "%! [r1, q1] = pw85_from_matgeom (x);",
            "%! [r2, q2] = pw85_from_matgeom (y);", f"%! {made} = {name} ({by_forms});", f"%! {again} = {name} ({by_rows});",
            "%! assert (b, a);", f"%! {again} = {name} ({last});",
            "%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));"]  # fmt: skip


def index():
    """The list of all functions by the sections of the headers, and of pw85_enclosing.h."""
    lines, listed = ["pw85 >> Ellipses and ellipsoids"], [*functions(), *BY_HAND]
    for section in sections():
        own = [name for name in listed if section == (BY_HAND.get(name) or section_of(functions()[name]))]
        lines += [section, *(f"  {name}" for name in own)] if own else []
    return "\n".join([*lines, ""])


@cache
def sections():
    titles = [one.title for header in declarations.HOST_HEADERS for one in declarations.sections(header)]
    return list(dict.fromkeys([*filter(None, titles), *BY_HAND.values()]))


def section_of(question):
    """The title of the section of the header that declares a function."""
    header = question.first.function.header
    return next(one.title for one in declarations.sections(header) if question.first.function in one.functions)


def released():
    """The day of this version, which pkg wants to know."""
    text = (SOURCE / "CHANGELOG.md").read_text(encoding="utf-8")
    return re.search(rf"^## \[{re.escape(declarations.version())}\] - (\S+)$", text, re.MULTILINE)[1]


def files():
    """The texts of all made files by their paths."""
    described = (FOLDER / "DESCRIPTION.in").read_text(encoding="utf-8").replace("@version@", declarations.version())
    made = {"DESCRIPTION": described.replace("@date@", released()), "INDEX": index(), "src/questions.c": c_source()}
    made |= {f"inst/{name}.m": page(name, one) for name, one in functions().items()}
    return {FOLDER / path: text for path, text in made.items()}
