# SPDX-License-Identifier: BSD-3-Clause
"""Makes what the package for Octave and MATLAB in octave/ has by the declarations of the C API: functions with their help and a test,
and tables of what they call in C.

A function asks a question (api/questions.py): pw85_contact() and pw85_contact_2d() are pw85_contact (r12, q1, q2), where each argument is
a matrix with a row for each pair. A pair of rows of matGeom stands for these three: pw85_contact (x, y). octave/src/pw85_mex.c reads the
arguments by the tables made here.
"""

import re

from declarations import sections
from layout import filled
from public_headers import HOST_HEADERS, source_text, version, with_version
from questions import MOTION, c_source, questions
from voice import with_named_statuses

MARK = "made by api/octave.py from the headers of the C API"
BY_HAND = {"pw85_from_matgeom": "Quadratic forms", "pw85_reproducible": "Version and errors", "pw85_version": "Version and errors",
           "pw85_enclosing_ellipsoid": "Enclosing ellipsoids", "pw85_enclosing_ellipsoid_of": "Enclosing ellipsoids"}  # fmt: skip
# What the tests give for other arguments than ellipsoids.
VALUES = {"lambda": "0.5", "mu2": "1", "t_max": "Inf", "motion1": "zeros (1, 7)", "motion2": "[-1, zeros(1, 6)]", "a": "[3; 2]",
          "b": "1", "angle": "0.5", "semi_axes": "[3 2 1; 4 1 1]", "rotation": "eye (3)", "quaternion": "[0.9 0.1 0.3 0.2]"}  # fmt: skip
FORMS = {"r12": "r2 - r1", "q": "q2", "q1": "q1", "q2": "q2"}
ROWS = {2: "[0 0 3 1 0], [5.5 0.5 3 1 30; 5.9 0.1 3 1 10; 3.95 0.1 1 0.5 9]",
        3: "[0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]"}  # fmt: skip
ROWS_OF_ALL = ("Each argument has a row for each row of the results, or one row for all of them. What is refused is an error that names "
               "the argument and its row.")  # fmt: skip
COLUMNS = {2: "[xc yc a b theta]", 3: "[xc yc zc a b c phi theta psi]"}


def name_of(question):
    return f"pw85_{question.name}"


def voice(question):
    return question.voice(name_of)


def inputs(question):
    return [one.name for one in question.first.inputs]


def result(question):
    found = [one.name for one in question.first.outputs]
    return found[0] if len(found) == 1 else f"[{', '.join(found)}]"


def is_endless(question):
    """Whether the last argument may be missing: it is infinite then."""
    return f"{str(inputs(question)[-1] == 't_max').lower()}, "


def paragraph(text, indent="  ", first=None):
    return filled(with_named_statuses(text).replace("`", ""), 96, f"%{first or indent}", f"%{indent}")


def item(name, text):
    return paragraph(text, " " * 14, f"  {name:<10}  ")


def usages(question):
    """The ways to call a function."""
    given = [inputs(question), question.arguments] if question.ellipsoids else [inputs(question)]
    ways = [f"{result(question)} = {name_of(question)} ({', '.join(listed)})" for listed in given]
    return [re.sub(", t_max", " [, t_max]", way) for way in ways]


def operands(question, attribute):
    """The inputs or outputs in the highest dimension of which the same is said: their names, the first one, the text, and how many columns
    they have, of ellipsoids, and of ellipses if these are others."""
    listed = [getattr(row, attribute) for _, row in sorted(question.rows.items(), reverse=True)]
    sizes = {one.name: dict.fromkeys([one.size, *(other.size for other in others)]) for one, *others in zip(*listed)}
    for text, group in voice(question).grouped(listed[0]):
        known, each = sizes[group[0].name], " each" if len(group) > 1 else ""
        columns = f"{' or '.join(map(str, known))} column{'s' if max(known) > 1 else ''}{each}"
        yield ", ".join(one.name for one in group), group[0], text, columns


def described_items(question):
    for names, one, text, columns in operands(question, "inputs"):
        motion = f": {MOTION}" if one.type == "pw85_motion" else "."
        absent = " Infinite if it is missing." if one.name == "t_max" else ""
        yield item(names, f"{text} {columns}{motion}{absent}")
    if question.ellipsoids:
        shapes = " or, in the plane, ".join(COLUMNS[dimension] for dimension in sorted(question.rows, reverse=True))
        yield item(", ".join(question.ellipsoids), f"Rows of matGeom, {shapes}: see pw85_from_matgeom.")
    yield "%"
    for names, one, text, columns in operands(question, "outputs"):
        matrix = f", a matrix of {one.shape[0]} x {one.shape[1]} row by row" if len(one.shape) == 2 else ""
        yield item(names, "true or false." if question.first.is_truth() else f"{text} {columns}{matrix}.")


def page(question):
    """The file of a function: help, body and test."""
    name, head, (brief, *rest) = name_of(question), result(question), voice(question).head()
    lines = [f"function {head} = {name} (varargin)", paragraph(brief, "  ", f"{name}  "), "%"]
    lines += [f"%   {way}" for way in usages(question)]
    for text in (*rest, *voice(question).notes(), question.dimensions, ROWS_OF_ALL):
        lines += ["%", paragraph(text)]
    lines += ["%", *described_items(question), "%", f"%  The function of the C API is {question.first.function.name}().", ""]
    lines += ["% SPDX-License-Identifier: BSD-3-Clause", f"% {MARK[0].upper()}{MARK[1:]}."]
    lines += [f"  {head} = pw85_mex ('{question.name}', varargin{{:}});", "end", "", *test_of(question), ""]
    return "\n".join(lines)


def test_of(question):
    """Rows of matGeom give what their centres and forms give, and each row alone what it gives among others."""
    name, made, count = name_of(question), f"[a{{1:{len(question.first.outputs)}}}]", len(question.ellipsoids)
    values = [VALUES.get(one.name) or ("[1 0 0]" if one.size == 3 else "[1 0]") for one in question.others]
    if not count:
        return ["%!test", f"%! q = {name} ({', '.join(values)});", "%! assert (all (q(:,[1 end])(:) > 0));"]
    left = iter(values)
    by_forms = ", ".join(FORMS.get(one.name) or next(left) for one in question.first.inputs)
    by_rows, last = (", ".join([*given[2 - count :], *values]) for given in (("x", "y"), ("x", "y(end,:)")))
    again = made.replace("a", "b")
    return ["%!test", f"%! [x, y] = deal ({ROWS[max(question.rows)]});", "%! [r1, q1] = pw85_from_matgeom (x);",
            "%! [r2, q2] = pw85_from_matgeom (y);", f"%! {made} = {name} ({by_forms});", f"%! {again} = {name} ({by_rows});",
            "%! assert (b, a);", f"%! {again} = {name} ({last});",
            "%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));"]  # fmt: skip


def index():
    """The list of all functions by the sections of the headers, and of pw85_enclosing.h."""
    declared = [section for header in HOST_HEADERS for section in sections(header)]
    titles = {name_of(one): next(section.title for section in declared if one.first.function in section.functions)
              for one in questions()} | BY_HAND  # fmt: skip
    lines = ["pw85 >> Ellipses and ellipsoids"]
    for title in dict.fromkeys([*(section.title for section in declared), *BY_HAND.values()]):
        own = [f"  {name}" for name, section in titles.items() if section == title]
        lines += [title, *own] if title and own else []
    return "\n".join([*lines, ""])


def files():
    log = source_text("CHANGELOG.md")
    released = re.search(rf"^## \[{re.escape(version())}\] - (\S+)$", log, re.MULTILINE)[1]  # the day, which pkg wants to know
    described = with_version("octave/DESCRIPTION.in").replace("@date@", released)
    table = c_source(MARK, "pw85_octave.h", is_endless)
    made = {"octave/DESCRIPTION": described, "octave/INDEX": index(), "octave/src/questions.c": table}
    return made | {f"octave/inst/{name_of(one)}.m": page(one) for one in questions()}
