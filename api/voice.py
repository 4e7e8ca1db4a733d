# SPDX-License-Identifier: BSD-3-Clause
"""Translates the comments of the C headers for Python docstrings: Python names, no pointers, whole sentences."""

import re
from functools import partial
from itertools import groupby

from causes import CAUSES
from declarations import first_sentence

# Clauses of C that mean nothing in Python.
OF_C = re.compile(r", also on success|(?:(?:^|; )may be the same array as \w+)+$")
INFINITY = next(cause for cause in CAUSES if cause.key == "infinity")


def sentence(text):
    """A text with a full stop at its end and, unless it begins with a formula, a capital at its head."""
    begins_with_word = re.match(r"a |[a-z]{2,}(?:[ ,;:.-]|$)", text)
    text = f"{text[0].upper()}{text[1:]}" if begins_with_word else text
    return f"{text.rstrip('.')}." if text else ""


def constant(match):
    name = match[1].removeprefix("PW85_")
    return f"``{name.lower()}``" if name == "LAMBDA_ATOL" else f"``Status.{name}``"


def with_limits(text, one):
    """A text of a parameter, with what is said of the attributes that limit its values."""
    return "; ".join(filter(None, [text, *(limit.said for limit in one.attributes.limits)]))


def with_named_statuses(text):
    """A text in which a status is not a member of a class of Python."""
    return re.sub(r"``Status\.(\w+)``", r"the status \1", text)


class Voice:
    """How texts of the C headers are said in Python, of one function."""

    def __init__(self, row, names, arguments=None, has_matrices=False, named="`{}`", unnamed="``{}`` in the C API"):
        self.row, self.named, self.unnamed = row, named, unnamed
        self.has_matrices = has_matrices  # arrays of two dimensions; otherwise rows of numbers
        self.names = names  # C functions that the language has, with the names that they have there
        self.arguments = {one.name: one.name for one in row.inputs} | (arguments or {})  # the names of arguments, by those in C
        has_flat_forms = any(one.name in ("q", "q1", "q2") and one.shape == (3,) for one in row.inputs)
        self.is_flat = row.function.dimension == 2 or has_flat_forms

    def reference(self, name, is_inherited):
        """The name of a function of C. In what a function of ellipses inherits, that of ellipses is meant."""
        flat = self.names.get(f"{name}_2d") if self.is_flat and is_inherited else None
        own = flat or self.names.get(name)
        return self.named.format(own) if own else self.unnamed.format(name)

    def unit(self, match):
        """The unit of an argument, whose name is marked."""
        return f"unit of `{self.arguments[match[1]]}`" if match[1] in self.arguments else match[0]

    def said(self, text, is_inherited=False):
        text = re.sub(r"\b(pw85\w+)\(\)", lambda match: self.reference(match[1], is_inherited), text)
        text = re.sub(r"\bunit of (\w+)\b(?!·)", self.unit, re.sub(r"\bfor n (?=[a-z])", "for many ", text))
        text = re.sub(r"#(PW85_\w+)", constant, re.sub(r"\blambda\b", "λ", text))
        if self.is_flat and is_inherited:
            text = text.replace("forms of the ellipsoids", "forms (xx, xy, yy) of the ellipses")
            text = text.replace("ellipsoid", "ellipse").replace("∂V/", "∂A/")
        if self.has_matrices:
            text = re.sub(r"\brow-major:? ", "", text)
        for name, own in self.arguments.items():
            text = re.sub(rf"\b{name}(?![a-z0-9_])", own, text) if "_" in name else text
        return text

    def described(self, one):
        """What is said of a parameter in the words of Python, with its limits."""
        text = with_limits(OF_C.sub("", one.text.rstrip(".")), one)
        return sentence(self.said(text, is_inherited=bool(one.attributes.like)))

    def grouped(self, operands):
        """Neighbours of the same shape and unit of which the same is said, with the text."""
        groups = groupby(operands, lambda one: (one.shape, one.attributes.unit, self.described(one)))
        return [(text, list(group)) for (*_, text), group in groups]

    def paragraphs(self):
        text = re.split(r"@(?:param|return)", self.row.function.comment)[0]
        return [self.said(OF_C.sub("", " ".join(paragraph.split()))) for paragraph in re.split(r"\n\s*\n", text) if paragraph.strip()]

    def head(self):
        """The first sentence, or as much of it as a line has room for, and the others of the first paragraph."""
        text = self.paragraphs()[0]
        match = re.match(r".{1,110}?\.(?=\s|$)", text)
        first = match[0] if match else first_sentence(text)
        return [one for one in (sentence(first.rstrip(".:;")), sentence(text[len(first) :].strip())) if one]

    def notes(self):
        """The other paragraphs."""
        return self.paragraphs()[1:]

    def raises(self):
        """Which rows are refused; nothing where none is."""
        function = self.row.function
        if function.type != "int":
            return "For a single value: invalid input. In arrays, invalid rows become NaN." if function.is_nan_on_error() else ""
        inputs = self.row.inputs
        infinite = [f"`{one.name}` may be infinite" for one in inputs if not INFINITY.is_named(one)]
        wrong = [f"a number is not finite{f' ({infinite[0]})' if infinite else ''}"]
        for cause in CAUSES:
            for one in inputs:
                if cause.wrong and cause.can_have(one) and cause.is_named(one):
                    wrong.append(cause.wrong.format(name=self.arguments[one.name]))
        *others, last = dict.fromkeys(wrong)
        listed = f"{', '.join(others)}{' or ' if others else ''}{last}"
        match = re.search(r"#PW85_ECONVERGENCE (?:\((.*)\)|(as for \w+\(\)))", function.returned())
        convergence = f" ``Status.ECONVERGENCE``: {self.said(match[1] or match[2])}." if match else ""
        return f"For a single row: {listed}.{convergence}{'' if self.row.is_truth() else ' In arrays, invalid rows become NaN.'}"


# For a language that has only some of the functions, or has other names for them.
PlainVoice = partial(Voice, named="`{}()`", unnamed="`{}()` of the C API")
