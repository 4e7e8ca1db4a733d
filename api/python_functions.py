# SPDX-License-Identifier: BSD-3-Clause
"""Modules of Python functions: a template, in which functions that are marked `@declared` are made whole by the C declarations.

In a template stands what is Python's own: examples, what it says otherwise in a text, other names and defaults of arguments, another
body, the type of the result, where `float` is a number for one row.

    @declared
    def first_contact(r12, q1, q2, motion1, motion2, t_max=np.inf):
        (text)

Arguments are stated where their names or defaults are not those of C; one that follows the inputs is the output. The sections of a
text replace those that would be made, in the section of parameters those of the same names; paragraphs at the head replace the
sentences of C. Functions that the template does not have follow at the end.
"""

import ast
import inspect
import textwrap
from dataclasses import dataclass

from docstrings import INDENT, docstring
from rows import row_functions

LINE = 120


@dataclass
class Argument:
    name: str
    default: str | None = None
    kind: str = ""

    def written(self, kind):
        kind = f"{kind} | None" if self.default == "None" else kind
        return f"{self.name}: {kind}" + (f" = {self.default}" if self.default is not None else "")


@dataclass
class Signature:
    inputs: list
    output: Argument


@dataclass
class Written:
    """What a template has of a function."""

    arguments: list
    text: str = ""
    body: str = ""
    result: str = ""


def python_name(row):
    """The name of a function in its module, whether that is of legacy functions or not."""
    name = row.name.removeprefix("legacy_")
    return f"_{name}" if row.is_building_block() else name


def python_names():
    """The names in Python of C functions, those of many rows included."""
    names = {}
    for row in filter(lambda row: not row.is_by_hand(), row_functions()):
        name = f"legacy.{python_name(row)}" if row.name.startswith("legacy_") else python_name(row)
        names |= {one.name: name for one in (row.function, row.many) if one is not None}
    return names


def written(node):
    """What the definition of a function in a template says."""
    listed = node.args.args
    defaults = [None] * (len(listed) - len(node.args.defaults)) + [ast.unparse(one) for one in node.args.defaults]
    statements = node.body[1:] if ast.get_docstring(node) is not None else node.body
    body = "\n".join(ast.unparse(one) for one in statements if not isinstance(one, ast.Pass))
    kinds = [ast.unparse(one.annotation) if one.annotation is not None else "" for one in listed]
    return Written(
        [Argument(one.arg, default, kind) for one, default, kind in zip(listed, defaults, kinds)],
        inspect.cleandoc(ast.get_docstring(node) or ""),
        body,
        ast.unparse(node.returns) if node.returns is not None else "",
    )


def signature_of(row, own):
    inputs = own.arguments[: len(row.inputs)] or [Argument(one.name.replace("lambda", "lambda_")) for one in row.inputs]
    output = next(iter(own.arguments[len(row.inputs) :]), Argument("out"))
    kind = output.kind or ("Any" if output.name == "out" else "Floats | None")
    return Signature(inputs, Argument(output.name, kind=kind))


def definition(name, arguments, result, end):
    """The head of a function, in one line if that fits."""
    line = f"def {name}({', '.join(arguments)}) -> {result}:{end}"
    if len(line) <= LINE:
        return line
    inner = f"{INDENT}{', '.join(arguments)}"
    if len(inner) > LINE:
        inner = "\n".join(f"{INDENT}{argument}," for argument in arguments)
    return f"def {name}(\n{inner}\n) -> {result}:{end}"


def tuple_of(types):
    return types[0] if len(types) == 1 else f"tuple[{', '.join(types)}]"


def shapes_of(row, result):
    """The shapes of what a function returns; none where the template says another type."""
    return {"": [one.shape for one in row.outputs], "float": [()]}.get(result, [])


def heads(row, signature, result):
    """What a type checker is told, and the head of the function itself.

    The type of a result that is a number for one row depends on the first vector: see _typing.py.
    """
    name = python_name(row)
    general = [argument.written("ArrayLike") for argument in signature.inputs]
    output = f"{signature.output.name}: {signature.output.kind} = None"
    anything = [*general, output, "**kwargs: Any"]
    shapes = shapes_of(row, result)

    def returns(number):
        return tuple_of(["Floats" if shape else number for shape in shapes]) if shapes else result

    if all(shapes):
        return f"@listed\n{definition(name, anything, returns('Any'), '')}"
    first = next(k for k, one in enumerate(row.inputs) if one.shape)
    kinds = ["Row" if k == first else "One" if one.shape else "float" for k, one in enumerate(row.inputs)]
    of_row = [argument.written(kind) for argument, kind in zip(signature.inputs, kinds)]
    of_rows = [*general[:first], signature.inputs[first].written("Rows"), *general[first + 1 :], output]
    number, array = ("np.bool_", "NDArray[np.bool_]") if row.is_truth() else ("float", "Floats")
    # With dtype=..., truth values are numbers.
    of_rows += [] if row.is_truth() else ["**kwargs: Any"]
    overloads = [
        definition(name, [*of_row, f"{signature.output.name}: Floats | None = None"], returns(number), " ..."),
        definition(name, of_rows, returns(array), " ..."),
        definition(name, anything, returns("Any"), " ..."),
    ]
    lines = [f"@overload\n{overload}" for overload in overloads]
    return "\n".join([*lines, "@listed", definition(name, anything, returns("Any"), "")])


def made(row, own, names):
    """The whole text of a function."""
    signature = signature_of(row, own)
    arguments = ", ".join([*(argument.name for argument in signature.inputs), signature.output.name, "kwargs"])
    body = own.body or f"return _core.call_{row.name}({arguments})"
    text = f'"""{docstring(row, signature, own.text, names)}\n"""\n{body}'
    return f"{heads(row, signature, own.result)}\n{textwrap.indent(text, INDENT)}\n"


def module(template, is_legacy):
    """The text of a module, from that of its template."""
    rows = {python_name(row): row for row in row_functions() if row.name.startswith("legacy_") == is_legacy}
    names, lines, place, parts = python_names(), template.splitlines(keepends=True), 0, []
    for node in ast.parse(template).body:
        decorators = [ast.unparse(one) for one in getattr(node, "decorator_list", [])]
        if decorators == ["declared"]:
            parts += ["".join(lines[place : node.decorator_list[0].lineno - 1]), made(rows.pop(node.name), written(node), names)]
            place = node.end_lineno
    parts.append("".join(lines[place:]))
    parts += [f"\n\n{made(row, Written([]), names)}" for row in rows.values()]
    return "".join(parts)
