# SPDX-License-Identifier: BSD-3-Clause
"""Text in lines of limited length, and templates: what all programs that print files need."""

import re
import textwrap

from public_headers import text_of
from refusals import line_of, refuse

WIDTH = 100  # of C, C++, Fortran and Rust
# Markdown takes a line that begins with such a sign and a blank for an item of a list.
SIGN = re.compile(r"(?<=\S) (?=[-+*] )")


def wrapped(text, width=WIDTH, first="", rest=None):
    """The lines of a text. The first begins with `first`, the others with `rest`, or with `first`, too. No word is broken, and no line is
    broken before +, - or *."""
    lines = textwrap.wrap(SIGN.sub("\1", text), width, initial_indent=first, subsequent_indent=first if rest is None else rest,
                          break_long_words=False, break_on_hyphens=False)  # fmt: skip
    return [line.replace("\1", " ") for line in lines]


def filled(text, width=WIDTH, first="", rest=None):
    return "\n".join(wrapped(text, width, first, rest))


def arguments(begin, listed, end):
    """A list of arguments in lines that are aligned with its bracket, or begin on the next line where that is too far to the right."""
    text = ", ".join(argument.replace(" ", "\0") for argument in listed) + end.replace(" ", "\0")
    beside, below = " " * len(begin), " " * (len(begin) - len(begin.lstrip()) + 4)
    lines = wrapped(text, first=beside)
    if all(len(line) <= WIDTH for line in lines):
        text = begin + "\n".join(lines).removeprefix(beside)
    else:
        text = "\n".join([begin, *wrapped(text, first=below)])
    return text.replace("\0", " ")


def camel(name):
    """The name of a type in C++ and Rust."""
    return "".join(word.capitalize() for word in name.split("_"))


def in_one_line_or_each(begin, listed, end, indent="", width=WIDTH):
    """The lines of a list: one if that fits, or one for each element."""
    line = f"{indent}{begin}{', '.join(listed)}{end}"
    return [line] if len(line) <= width else [indent + begin.rstrip(), *(f"{indent}    {one}," for one in listed), indent + end.lstrip()]


def cpp_header(name, text):
    """A made header of C++: a text, whose first lines are its comment, with what stands around the text of each."""
    comment, _, rest = text.partition("\n\n")
    guard = "_".join(part.upper() for part in re.split(r"\W", "/".join(name.split("/")[-2:])))
    guard = f"PW85_{guard.removeprefix('PW85_')}_INCLUDED"
    made = "//\n// Made from the headers by api/committed.py.\n// clang-format off"
    return f"{comment}\n{made}\n#ifndef {guard}\n#define {guard}\n\n{rest}\n#endif\n"


# A part of a header that is written by hand: the part is made, by the words on its first line.
PART = re.compile(
    r"^(?P<head> */[/*] Made by api/committed\.py: (?P<name>\w+)(?P<said>[^*\n]*)(?: \*/)?\n.*clang-format off.*\n)"
    r"(?:.*\n)*?(?P<end>.*clang-format on.*)$",
    re.MULTILINE,
)


def renewed(header, made):
    """The text of a header with its made parts. Each is what the function of its word makes of the other words."""
    text, name = text_of(header), header.rpartition("/")[2]

    def part(match):
        place = line_of(name, text, match.start("name"))
        refuse(place, {f"not understood: {match['name']}": match["name"] not in made})
        return match["head"] + made[match["name"]](place, match["said"].strip().removeprefix("of ")) + match["end"]

    other = PART.sub("", text).find("api/committed.py:")
    refuse(line_of(name, text, other), {"no part that is made": other >= 0})
    return PART.sub(part, text)


def insert(template, mark, made):
    """The text of a template, a path. A line with a mark and a name is replaced by the lines that are made for the name, indented as it
    is."""

    def text(match):
        name = match["name"]
        refuse(line_of(template.name, match.string, match.start("name")), {f"not understood: {match[0].strip()}": name not in made})
        return "".join(f"{match['indent']}{line}".rstrip() + "\n" for line in made[name])

    form = rf"^(?P<indent> *){re.escape(mark)} ?(?P<name>.*)\n"
    return re.sub(form, text, template.read_text(encoding="utf-8"), flags=re.MULTILINE)
