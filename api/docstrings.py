# SPDX-License-Identifier: BSD-3-Clause
"""Docstrings in the form of NumPy: what the C headers say (voice.py), and what Python says otherwise in its place."""

import re

from layout import filled
from refusals import refuse

WIDTH = 116
INDENT = " " * 4
SECTION = re.compile(r"^([A-Z][\w ]+)\n-{3,}\n", re.MULTILINE)
ORDER = ("Parameters", "Returns", "Raises", "See Also", "Notes", "Examples")


def parse(text, place):
    """The paragraphs at the head of a docstring as it is written, and the text of each section by its title."""
    head, *rest = SECTION.split(text)
    paragraphs = [paragraph.strip("\n") for paragraph in head.split("\n\n") if paragraph.strip()]
    sections = {title: lines.strip("\n") for title, lines in zip(rest[::2], rest[1::2])}
    refuse(place, {f"no such section: {title}": title not in ORDER for title in sections})
    return paragraphs, sections


def entry(head, text):
    return f"{head}\n{filled(text, WIDTH, INDENT)}".rstrip()


def rows_of(shape):
    return f"({', '.join(['...', *map(str, shape)])})"


def output_entry(name, shapes):
    """The entry of the output arrays for results of these shapes."""
    *others, last = map(rows_of, shapes)
    if not others:
        return entry(f"{name} : {last} array, optional", f"Output array{'' if name == 'out' else ', which is also returned'}.")
    arrays = f"tuple of {len(shapes)} arrays"
    kind = f"{arrays}, {', '.join(others)} and {last}" if any(shapes) else f"(..., {len(shapes)}) array, or {arrays}"
    return entry(f"{name} : {kind}, optional", "Output arrays.")


def in_place(made, given, place):
    """The entries "q1, q2 : (..., 6) array_like" of a section; given entries replace generated ones of the same names."""
    own = [one.rstrip("\n") for one in re.split(r"^(?=\S)", given, flags=re.MULTILINE) if one.strip()]
    named = {name: one for one in own for name in one.partition("\n")[0].partition(" : ")[0].split(", ")}
    found = {}  # in order
    for one in made:
        names, mark, rest = one.partition(" : ")
        left = ", ".join(name for name in names.split(", ") if name not in named)
        for name in names.split(", "):
            found[named.get(name) or f"{left}{mark}{rest}"] = None
    refuse(place, {f"no such parameter: {one.partition(chr(10))[0]}": one not in found for one in own})
    return "\n".join(found)


def arguments_of(row, signature, voice, given):
    made, optional = [], {one.name for one, argument in zip(row.inputs, signature.inputs) if argument.default is not None}
    for text, group in voice.grouped(row.inputs):
        names = ", ".join(voice.arguments[one.name] for one in group)
        made.append(entry(f"{names} : {rows_of(group[0].shape)} array_like{', optional' * (group[0].name in optional)}", text))
    codes = " With ``dtype=np.uint8`` the result is 1, 0, or 255 for an invalid row (see `bad_rows`)."
    made.append(output_entry(signature.output.name, [one.shape for one in row.outputs]))
    made.append(entry("**kwargs", f"Other keyword arguments of ufuncs.{codes if row.is_truth() else ''}"))
    return in_place(made, given, row.function.place)


def results_of(row, voice):
    if row.is_truth():
        yield entry("(...) array of bool, or bool", f"{'True' if row.is_overlap() else 'False'} for an invalid row of an array.")
        return
    for text, group in voice.grouped(row.outputs):
        names, plural = ", ".join(one.name.replace("lambda", "lambda_") for one in group), "s" if len(group) > 1 else ""
        kind = f"{rows_of(group[0].shape)} array{plural}" + ("" if group[0].shape else f" or number{plural}")
        yield entry(kind if len(row.outputs) == 1 else f"{names} : {kind}", text)


def docstring(row, signature, given, voice):
    """The docstring of a Python function. The sections of `given` replace or complete those from the C header."""
    paragraphs, sections = parse(given, row.function.place)
    raises, notes = voice.raises(), "\n\n".join(filled(text, WIDTH) for text in voice.notes())
    made = {"Returns": "\n".join(results_of(row, voice)), "Raises": raises and entry("PW85Error", raises), "Notes": notes} | sections
    made["Parameters"] = arguments_of(row, signature, voice, sections.get("Parameters", ""))
    listed = (f"{title}\n{'-' * len(title)}\n{made[title]}" for title in ORDER if made.get(title))
    return "\n\n".join([*(paragraphs or (filled(text, WIDTH) for text in voice.head())), *listed])
