"""Docstrings in the form of NumPy from the comments of the C headers, with what Python says otherwise in its place."""

import re
import textwrap
from dataclasses import dataclass, field

from causes import CAUSES, is_named
from declarations import c_functions, referenced

WIDTH = 120
INDENT = " " * 4
SECTION = re.compile(r"^([A-Z][\w ]+)\n-{3,}\n", re.MULTILINE)
ORDER = ("Parameters", "Returns", "Raises", "See Also", "Notes", "Examples")

# Clauses of C that mean nothing in Python.
OF_C = re.compile(r"(?:; )?\b(?:any output )?may be null$|, also on success|; -1 on error$|(?:^|; )may be the same array as \w+$")
LEADING_SHAPE = re.compile(r"^(?:(?:n|\d+)×\d+(?: matrix)?|one number each)[,;:]? ?")

INFINITY = next(cause for cause in CAUSES if cause.key == "infinity")

# What is wrong where a contract names a cause of an error (api/causes.py), of one parameter.
WRONG = {
    "not definite": "a form is not positive definite",
    "not positive": "`{name}` is not positive",
    "negative": "`{name}` is negative",
    "no rotation": "`{name}` is not orthonormal",
    "zero": "`{name}` is zero",
    "concentric": "`{name}` is zero",
    "lambda": "λ is not in [0, 1]",
    "empty box": "`lower` is larger than `upper`",
    "shrinks": "an ellipsoid shrinks to nothing before `t_max`",
    "singular": "`{name}` is singular",
}


@dataclass
class Docstring:
    """Paragraphs at the head, and the lines of each section; those of parameters and results by the names that they describe."""

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


def sentence(text):
    """A text with a full stop at its end and, unless it begins with a formula, a capital at its head."""
    begins_with_word = re.match(r"a |[a-z]{2,}(?:[ ,;:.-]|$)", text)
    text = f"{text[0].upper()}{text[1:]}" if begins_with_word else text
    return f"{text.rstrip('.')}." if text else ""


def constant(match):
    name = match[1].removeprefix("PW85_")
    return f"`{name.lower()}`" if name == "LAMBDA_ATOL" else f"``Status.{name}``"


def in_python(text):
    """A sentence without the clauses that mean nothing in Python."""
    while OF_C.search(text):
        text = OF_C.sub("", text)
    return text


class Voice:
    """How texts of the C headers are said in Python, of one function."""

    def __init__(self, row, signature, names):
        self.row = row
        self.names = names  # C functions that Python has, with the names that they have there
        self.arguments = {one.name: argument.name for one, argument in zip(row.inputs, signature.inputs)}
        self.is_flat = row.function.name.endswith("_2d")

    def reference(self, match, is_inherited):
        flat = f"{match[1]}_2d"
        name = flat if self.is_flat and is_inherited and flat in self.names else match[1]
        return f"`{self.names[name]}`" if name in self.names else f"``{match[1]}`` in the C API"

    def said(self, text, is_inherited=False):
        text = re.sub(r"\b(pw85\w+)\(\)", lambda match: self.reference(match, is_inherited), text)
        text = re.sub(r"#(PW85_\w+)", constant, re.sub(r"\blambda\b", "λ", text))
        if self.is_flat and is_inherited:
            text = text.replace("forms of the ellipsoids", "forms (xx, xy, yy) of the ellipses").replace("ellipsoid", "ellipse")
        return text

    def described(self, name, function=None):
        """The sentence of a parameter in the words of Python: its own, or that of the function to which it refers."""
        text, is_inherited = described(function or self.row.function, name)
        return sentence(self.said(LEADING_SHAPE.sub("", in_python(text)), is_inherited))

    def paragraphs(self):
        text = re.split(r"@(?:param|return)", self.row.function.comment)[0]
        return [self.said(in_python(" ".join(paragraph.split()))) for paragraph in re.split(r"\n\s*\n", text) if paragraph.strip()]

    def head(self):
        """The first sentence, or as much of it as fits in a line, and the others of the first paragraph."""
        first = self.paragraphs()[0]
        match = re.match(r".{1,110}?\.(?=\s|$)", first) or re.match(r".*?[.:;](?=\s|$)", first)
        return [text for text in (sentence(match[0].rstrip(".:;")), filled(sentence(first[match.end() :].strip()))) if text]

    def notes(self):
        return "\n\n".join(map(filled, self.paragraphs()[1:]))

    def raises(self):
        """Which rows are refused; nothing where none is."""
        function = self.row.function
        if function.type != "int":
            return ""
        infinite = [f"`{one.name}` may be infinite" for one in self.row.inputs if not is_named(INFINITY, function, one.name)]
        wrong = [f"a number is not finite{f' ({infinite[0]})' if infinite else ''}"]
        for cause in CAUSES:
            for one in self.row.inputs:
                if cause.key in WRONG and re.fullmatch(cause.parameters, one.name) and is_named(cause, function, one.name):
                    wrong.append(WRONG[cause.key].format(name=self.arguments[one.name]))
        unique = list(dict.fromkeys(wrong))
        text = f"For a single row: {', '.join(unique[:-1])}{' or ' if unique[1:] else ''}{unique[-1]}. {self.convergence()}"
        return f"PW85Error\n{filled(f'{text}Rows of arrays become NaN.', INDENT)}"

    def convergence(self):
        known = c_functions()
        texts = (re.search(r"@return (.*)", other.comment, re.DOTALL) for other in referenced(self.row.function, known))
        text = " ".join(next((match[1] for match in texts if match), "").split())
        match = re.search(r"#PW85_ECONVERGENCE(?: \((.*)\)| (as for \w+\(\)))?", text)
        if match is None or not (match[1] or match[2]):
            return ""
        return f"``Status.ECONVERGENCE``: {self.said(match[1] or match[2])}. "


def described(function, name):
    """The sentence of a parameter, and whether another function has it."""
    other = next((one for one in referenced(function, c_functions()) if name in one.sentences()), None)
    if other is None:
        return "", False
    text = other.sentences()[name][0]
    match = re.match(r"as for (\w+)\(\)([,;] )?(.*)", text)
    if match is None:
        return text.rstrip("."), other is not function
    known = c_functions()[match[1]]
    first = described(known, name)[0].partition(";")[0]
    words = set(re.findall(r"\w+", match[3]))
    is_of_it = name in words or not words & set(function.parameter_names())
    return first + (match[2] + match[3] if match[2] and is_of_it else ""), True


def head_of_argument(names, shape, is_optional):
    return f"{', '.join(names)} : {rows_of(shape)} array_like{', optional' if is_optional else ''}"


def rows_of(shape):
    return f"({', '.join(['...', *map(str, shape)])})"


def head_of_results(names, shape, is_only):
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
    lines, used = [], set()
    for head, text in made:
        heads = [named[name] for name in head.partition(" : ")[0].split(", ") if name in named]
        if not heads:
            lines.append(f"{head}\n{text}".rstrip("\n"))
        for other in heads:
            if other not in used:
                lines.append(f"{other}\n{own[other]}".rstrip("\n"))
                used.add(other)
    if own.keys() - used:
        raise ValueError(f"no such parameter: {', '.join(own.keys() - used)}")
    return "\n".join(lines)


def arguments_of(row, signature, voice, given):
    """The section of parameters."""
    optional = {one.name for one, argument in zip(row.inputs, signature.inputs) if argument.default is not None}
    made = [
        (head_of_argument([voice.arguments[one.name] for one in group], group[0].shape, group[0].name in optional),
         filled(voice.described(group[0].name), INDENT))
        for group in grouped(row.inputs, lambda one: (voice.described(one.name), one.name in optional))
    ]  # fmt: skip
    made.append(tuple(output_entry(signature.output.name, row.outputs).split("\n")))
    return section_of([*made, ("**kwargs", f"{INDENT}As for any ufunc.")], given)


def results_of(row, voice, given):
    """The section of results, which stands for all of them where it is given."""
    if given:
        return given

    def text_of(one):
        return voice.described(one.parameter.name) if one.parameter is not None else ""

    only = len(row.outputs) == 1
    return "\n".join(
        f"{head_of_results([one.name.replace('lambda', 'lambda_') for one in group], group[0].shape, only)}\n"
        f"{filled(text_of(group[0]), INDENT)}".rstrip()
        for group in grouped(row.outputs, text_of)
    )


def docstring(row, signature, given, names):
    """The text of a function of Python. `given` is what Python says of it otherwise or in addition."""
    own, voice = parse(given), Voice(row, signature, names)
    made = {
        "Parameters": arguments_of(row, signature, voice, own.sections.get("Parameters", "")),
        "Returns": results_of(row, voice, own.sections.get("Returns", "")),
        "Raises": own.sections.get("Raises") or voice.raises(),
        "Notes": own.sections.get("Notes") or voice.notes(),
    }
    sections = own.sections | made
    listed = (f"{title}\n{'-' * len(title)}\n{sections[title]}" for title in ORDER if sections.get(title))
    return "\n\n".join([*(own.head or voice.head()), *listed])
