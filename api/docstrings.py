# SPDX-License-Identifier: BSD-3-Clause
"""Docstrings in the form of NumPy: what the C headers say (voice.py), and what Python says otherwise in its place."""

import re
import textwrap
from dataclasses import dataclass, field

from voice import Voice

WIDTH = 120
INDENT = " " * 4
SECTION = re.compile(r"^([A-Z][\w ]+)\n-{3,}\n", re.MULTILINE)
ORDER = ("Parameters", "Returns", "Raises", "See Also", "Notes", "Examples")


@dataclass
class Docstring:
    """Paragraphs at the head, and the text of each section by its title."""

    head: list = field(default_factory=list)
    sections: dict = field(default_factory=dict)


def parse(text):
    """A docstring as it is written."""
    head, *rest = SECTION.split(text)
    paragraphs = [paragraph.strip("\n") for paragraph in re.split(r"\n\n", head) if paragraph.strip()]
    return Docstring(paragraphs, {title: lines.strip("\n") for title, lines in zip(rest[::2], rest[1::2])})


def entries(lines):
    """What a section says, by the head of each entry: "q1, q2 : (..., 6) array_like"."""
    found = re.split(r"^(?=\S)", lines, flags=re.MULTILINE)
    return {entry.partition("\n")[0]: entry.partition("\n")[2].rstrip("\n") for entry in found if entry.strip()}


def filled(text, indent=""):
    return textwrap.fill(text, WIDTH - len(INDENT), initial_indent=indent, subsequent_indent=indent,
                         break_long_words=False, break_on_hyphens=False)  # fmt: skip


def head_of_argument(names, shape, is_optional):
    return f"{', '.join(names)} : {rows_of(shape)} array_like{', optional' if is_optional else ''}"


def rows_of(shape):
    return f"({', '.join(['...', *map(str, shape)])})"


def head_of_results(names, shape, is_only, is_truth):
    if is_truth:
        return "(...) array of bool, or bool"
    plural = "s" if len(names) > 1 else ""
    text = f"{rows_of(shape)} array{plural}" + ("" if shape else f" or number{plural}")
    return text if is_only else f"{', '.join(names)} : {text}"


NUMBERS = {2: "two", 3: "three", 4: "four", 5: "five", 6: "six", 7: "seven"}


def output_entry(name, outputs):
    """What is said of the array into which results go."""
    shapes = [rows_of(one.shape) for one in outputs]
    put = f"{INDENT}Where to put the result{'s' if len(shapes) > 1 else ''}."
    if len(shapes) == 1:
        return f"{name} : {shapes[0]} array, optional\n{put if name == 'out' else put[:-1] + ', which is returned.'}"
    count = NUMBERS[len(shapes)]
    if len(set(shapes)) > 1:
        return f"{name} : tuple of {count} arrays, {', '.join(shapes[:-1])} and {shapes[-1]}, optional\n{put}"
    if shapes[0] == "(...)":
        return f"{name} : (..., {len(shapes)}) array, or a tuple of {count} (...) arrays, optional\n{put}"
    return f"{name} : tuple of {count} {shapes[0]} arrays, optional\n{put}"


def grouped(operands, text_of):
    """Neighbours of the same shape of which the same is said."""
    groups = []
    for one in operands:
        if groups and groups[-1][0].shape == one.shape and text_of(groups[-1][0]) == text_of(one):
            groups[-1].append(one)
        else:
            groups.append([one])
    return groups


def section_of(made, given):
    """The entries that follow from the declarations, but for those that are given, by any of their names."""
    own = entries(given)
    named = {name: head for head in own for name in head.partition(" : ")[0].split(", ")}
    lines = {}
    for head, text in made:
        names, mark, kind = head.partition(" : ")
        rest = ", ".join(name for name in names.split(", ") if name not in named)
        for name in names.split(", "):
            lines |= {named[name]: own[named[name]]} if name in named else {f"{rest}{mark}{kind}": text}
    if own.keys() - lines.keys():
        raise ValueError(f"no such parameter: {', '.join(own.keys() - lines.keys())}")
    return "\n".join(f"{head}\n{text}".rstrip("\n") for head, text in lines.items())


def text_of_others(row):
    """What is said of the arguments that each ufunc has."""
    codes = " With ``dtype=np.uint8`` the result is 1, 0, or 255 for a bad row, for `bad_rows`."
    return filled(f"As for any ufunc.{codes if row.is_truth() else ''}", INDENT)


def arguments_of(row, signature, voice, given):
    """The section of parameters."""
    optional = {one.name for one, argument in zip(row.inputs, signature.inputs) if argument.default is not None}
    made = [
        (head_of_argument([voice.arguments[one.name] for one in group], group[0].shape, group[0].name in optional),
         filled(voice.described(group[0].name), INDENT))
        for group in grouped(row.inputs, lambda one: (voice.described(one.name), one.name in optional))
    ]  # fmt: skip
    made.append(tuple(output_entry(signature.output.name, row.outputs).split("\n")))
    return section_of([*made, ("**kwargs", text_of_others(row))], given)


def results_of(row, voice, given):
    """The section of results, which stands for all of them where it is given."""
    if given:
        return given

    def text_of(one):
        return voice.described(one.parameter.name) if one.parameter is not None else ""

    only = len(row.outputs) == 1
    return "\n".join(
        f"{head_of_results([one.name.replace('lambda', 'lambda_') for one in group], group[0].shape, only, row.is_truth())}\n"
        f"{filled(text_of(group[0]), INDENT)}".rstrip()
        for group in grouped(row.outputs, text_of)
    )


def docstring(row, signature, given, names):
    """The text of a function of Python. `given` is what Python says of it otherwise or in addition."""
    own, voice = parse(given), Voice(row, signature, names)
    if own.sections.keys() - set(ORDER):
        raise ValueError(f"no such section: {', '.join(own.sections.keys() - set(ORDER))}")
    raises = voice.raises() and f"PW85Error\n{filled(voice.raises(), INDENT)}"
    made = {
        "Parameters": arguments_of(row, signature, voice, own.sections.get("Parameters", "")),
        "Returns": results_of(row, voice, own.sections.get("Returns", "")),
        "Raises": own.sections.get("Raises") or raises,
        "Notes": own.sections.get("Notes") or "\n\n".join(map(filled, voice.notes())),
    }
    sections = own.sections | made
    listed = (f"{title}\n{'-' * len(title)}\n{sections[title]}" for title in ORDER if sections.get(title))
    return "\n\n".join([*(own.head or map(filled, voice.head())), *listed])
