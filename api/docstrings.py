# SPDX-License-Identifier: BSD-3-Clause
"""Docstrings in the form of NumPy: what the C headers say (voice.py), and what Python says otherwise in its place."""

import re
from itertools import groupby

from layout import filled

WIDTH = 116
INDENT = " " * 4
SECTION = re.compile(r"^([A-Z][\w ]+)\n-{3,}\n", re.MULTILINE)
ORDER = ("Parameters", "Returns", "Raises", "See Also", "Notes", "Examples")
NUMBERS = {2: "two", 3: "three", 4: "four", 5: "five", 6: "six", 7: "seven"}


def parse(text):
    """The paragraphs at the head of a docstring as it is written, and the text of each section by its title."""
    head, *rest = SECTION.split(text)
    paragraphs = [paragraph.strip("\n") for paragraph in head.split("\n\n") if paragraph.strip()]
    sections = {title: lines.strip("\n") for title, lines in zip(rest[::2], rest[1::2])}
    if sections.keys() - set(ORDER):
        raise ValueError(f"no such section: {', '.join(sections.keys() - set(ORDER))}")
    return paragraphs, sections


def entry(head, text):
    return f"{head}\n{filled(text, WIDTH, INDENT)}".rstrip()


def rows_of(shape):
    return f"({', '.join(['...', *map(str, shape)])})"


def of_same(operands, text_of):
    """Neighbours of the same shape of which the same is said: their shape, the text, and them."""
    for (shape, text), group in groupby(operands, lambda one: (one.shape, text_of(one))):
        yield shape, text, list(group)


def output_entry(name, shapes):
    """What is said of the array into which results of these shapes go."""
    count, written = NUMBERS.get(len(shapes)), [rows_of(shape) for shape in shapes]
    put = f"Where to put the result{'s' if count else ''}{'' if count or name == 'out' else ', which is returned'}."
    if not count:
        kind = f"{written[0]} array"
    elif len({*written}) > 1:
        kind = f"tuple of {count} arrays, {', '.join(written[:-1])} and {written[-1]}"
    elif shapes[0]:
        kind = f"tuple of {count} {written[0]} arrays"
    else:
        kind = f"(..., {len(shapes)}) array, or a tuple of {count} (...) arrays"
    return entry(f"{name} : {kind}, optional", put)


def in_place(made, given):
    """The entries "q1, q2 : (..., 6) array_like" of a section, but for those that are given, by any of their names."""
    own = [one.rstrip("\n") for one in re.split(r"^(?=\S)", given, flags=re.MULTILINE) if one.strip()]
    named = {name: one for one in own for name in one.partition("\n")[0].partition(" : ")[0].split(", ")}
    found = {}  # in order
    for one in made:
        names, mark, rest = one.partition(" : ")
        left = ", ".join(name for name in names.split(", ") if name not in named)
        for name in names.split(", "):
            found[named.get(name) or f"{left}{mark}{rest}"] = None
    if {*own} - found.keys():
        raise ValueError(f"no such parameter: {', '.join({*own} - found.keys())}")
    return "\n".join(found)


def arguments_of(row, signature, voice, given):
    """The section of parameters."""
    optional = {one.name for one, argument in zip(row.inputs, signature.inputs) if argument.default is not None}
    made = []
    for shape, (text, is_optional), group in of_same(row.inputs, lambda one: (voice.described(one.name), one.name in optional)):
        names = ", ".join(voice.arguments[one.name] for one in group)
        made.append(entry(f"{names} : {rows_of(shape)} array_like{', optional' if is_optional else ''}", text))
    codes = " With ``dtype=np.uint8`` the result is 1, 0, or 255 for a bad row, for `bad_rows`."
    made.append(output_entry(signature.output.name, [one.shape for one in row.outputs]))
    made.append(entry("**kwargs", f"As for any ufunc.{codes if row.is_truth() else ''}"))
    return in_place(made, given)


def results_of(row, voice):
    """The section of results."""
    for shape, text, group in of_same(row.outputs, lambda one: voice.described(one.parameter.name) if one.parameter else ""):
        names, plural = ", ".join(one.name.replace("lambda", "lambda_") for one in group), "s" if len(group) > 1 else ""
        kind = f"{rows_of(shape)} array{plural}" + ("" if shape else f" or number{plural}")
        head = "(...) array of bool, or bool" if row.is_truth() else kind if len(row.outputs) == 1 else f"{names} : {kind}"
        yield entry(head, text)


def docstring(row, signature, given, voice):
    """The text of a function of Python. `given` is what Python says of it otherwise or in addition."""
    paragraphs, sections = parse(given)
    raises = voice.raises() and entry("PW85Error", voice.raises())
    made = {
        "Returns": "\n".join(results_of(row, voice)),
        "Raises": raises,
        "Notes": "\n\n".join(filled(text, WIDTH) for text in voice.notes()),
    } | sections
    made["Parameters"] = arguments_of(row, signature, voice, sections.get("Parameters", ""))
    listed = (f"{title}\n{'-' * len(title)}\n{made[title]}" for title in ORDER if made.get(title))
    return "\n\n".join([*(paragraphs or (filled(text, WIDTH) for text in voice.head())), *listed])
