# SPDX-License-Identifier: BSD-3-Clause
"""What the Python package has by the declarations of the C API: its functions for rows of numbers (api/rows.py), and its names.

Usage: python.py table OUTPUT               the table that the compiled part includes (api/python_calls.py)
       python.py objects OUTPUT             the functions on objects that it includes
       python.py names TEMPLATE OUTPUT      a module or stub, in whose template `#@` marks where names belong: see with_names()
       python.py functions TEMPLATE OUTPUT  a module of functions

In the template of a module of functions, those that are marked `@declared` are made whole by the C declarations. There stands what is
Python's own: examples, what it says otherwise in a text, other names and defaults of arguments, another body, the type of the result,
where `float` is a number for one row.

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
from collections import namedtuple
from dataclasses import dataclass
from pathlib import Path

from docstrings import INDENT, docstring
from layout import in_one_line_or_each, insert
from public_headers import SOURCE
from python_calls import objects_table, rows_table, stubs
from refusals import refuse, run
from rows import row_functions, rows_by_hand
from voice import Voice

LINE = 120


@dataclass
class Argument:
    name: str
    default: str | None = None
    kind: str = ""

    def written(self, kind):
        kind = f"{kind} | None" if self.default == "None" else kind
        return f"{self.name}: {kind}" + (f" = {self.default}" if self.default is not None else "")


# The arguments, and the type of the result if the template states it.
Signature = namedtuple("Signature", "inputs output result")


def is_legacy(row):
    return row.name.startswith("legacy_")


def python_name(row):
    """The name of a function in its module, whether that is of legacy functions or not."""
    return "_" * row.is_building_block() + row.name.removeprefix("legacy_")


def python_names():
    """The names in Python of C functions, those of many rows included."""
    rows = [row for row in row_functions() if not row.is_by_hand()]
    return {one.name: "legacy." * is_legacy(row) + python_name(row) for row in rows for one in (row.function, row.many) if one}


def signature_of(row, node):
    """The arguments that a definition in a template states, or those of C."""
    stated, count = node.args.args, len(row.inputs)
    defaults = [None] * (len(stated) - len(node.args.defaults)) + [ast.unparse(one) for one in node.args.defaults]
    kinds = [ast.unparse(one.annotation) if one.annotation else "" for one in stated]
    listed = [Argument(one.arg, default, kind) for one, default, kind in zip(stated, defaults, kinds)]
    inputs = listed[:count] or [Argument(one.name.replace("lambda", "lambda_")) for one in row.inputs]
    output = listed[count] if listed[count:] else Argument("out")
    kind = output.kind or ("Any" if output.name == "out" else "Floats | None")
    return Signature(inputs, Argument(output.name, "None", kind), ast.unparse(node.returns) if node.returns else "")


def definition(name, arguments, result, end):
    return "\n".join(in_one_line_or_each(f"def {name}(", arguments, f") -> {result}:{end}", width=LINE))


def tuple_of(types):
    return types[0] if len(types) == 1 else f"tuple[{', '.join(types)}]"


def heads(row, signature):
    """What a type checker is told, and the head of the function itself.

    The type of a result that is a number for one row depends on the first vector: see _typing.py.
    """
    name, (output, result), truth = python_name(row), (signature.output, signature.result), row.is_truth()
    general = [argument.written("ArrayLike") for argument in signature.inputs]
    put = f"{output.name}: {output.kind} = None"
    anything = [*general, put, "**kwargs: Any"]
    shapes = {"": [one.shape for one in row.outputs], "float": [()]}.get(result, [])

    def returns(number):
        return tuple_of(["Floats" if shape else number for shape in shapes]) if shapes else result

    last = f"@listed\n{definition(name, anything, returns('Any'), '')}"
    if all(shapes):
        return last
    first = next(k for k, one in enumerate(row.inputs) if one.shape)
    kinds = ["Row" if k == first else "One" if one.shape else "float" for k, one in enumerate(row.inputs)]
    of_row = [argument.written(kind) for argument, kind in zip(signature.inputs, kinds)]
    of_rows = [*general[:first], signature.inputs[first].written("Rows"), *general[first + 1 :], put]
    number, array = ("np.bool_", "NDArray[np.bool_]") if truth else ("float", "Floats")
    overloads = [
        definition(name, [*of_row, f"{output.name}: Floats | None = None"], returns(number), " ..."),
        definition(name, [*of_rows, *["**kwargs: Any"] * (not truth)], returns(array), " ..."),  # with dtype=..., truths are numbers
        definition(name, anything, returns("Any"), " ..."),
    ]
    return "\n".join([*(f"@overload\n{overload}" for overload in overloads), last])


def made(row, node):
    """The whole text of a function, by its definition in a template."""
    signature, text = signature_of(row, node), ast.get_docstring(node)
    statements = [one for one in node.body[text is not None :] if not isinstance(one, ast.Pass)]
    arguments = [argument.name for argument in (*signature.inputs, signature.output)]
    body = "\n".join(map(ast.unparse, statements)) or f"return _core.call_{row.name}({', '.join([*arguments, 'kwargs'])})"
    voice = Voice(row, python_names(), dict(zip((one.name for one in row.inputs), arguments)), has_matrices=True)
    whole = f'"""{docstring(row, signature, inspect.cleandoc(text or ""), voice)}\n"""\n{body}'
    return f"{heads(row, signature)}\n{textwrap.indent(whole, INDENT)}\n"


def module(template):
    """The text of a module, from its template; that of the legacy functions has their word in its name."""
    rows = {python_name(row): row for row in row_functions() if is_legacy(row) == ("legacy" in template.name)}
    text, place, parts = template.read_text(encoding="utf-8"), 0, []
    lines = text.splitlines(keepends=True)
    for node in ast.parse(text).body:
        if [ast.unparse(one) for one in getattr(node, "decorator_list", [])] == ["declared"]:
            refuse(f"{template.name}:{node.lineno}", {f"no function of the headers is {node.name}() in Python": node.name not in rows})
            parts += ["".join(lines[place : node.decorator_list[0].lineno - 1]), made(rows.pop(node.name), node)]
            place = node.end_lineno
    parts.append("".join(lines[place:]))
    nothing = ast.parse("def unstated(): pass").body[0]
    return "".join([*parts, *(f"\n\n{made(row, nothing)}" for row in rows.values())])


def made_lines():
    """Lines for each mark of a template."""
    rows = sorted((*row_functions(), *rows_by_hand()), key=lambda row: row.name)
    results = {row.name: tuple_of(["Floats" if one.shape else "Any" for one in row.outputs]) for row in rows}
    return {
        "functions": [f"{python_name(row)}," for row in row_functions() if not is_legacy(row)],
        "names": [f"{name}," for name in results],
        "objects": list(stubs()),
        "ufuncs": [f"{name}: np.ufunc" for name in results],
        "calls": [f"def call_{name}(*args: Any) -> {result}: ..." for name, result in results.items()],
    }


def public_names(template):
    """What a module offers by its template: the public names that it imports or assigns."""
    names = []
    for node in ast.parse(insert(template, "#@", made_lines() | {"all": []})).body:
        if isinstance(node, ast.ImportFrom):
            names += [alias.asname or alias.name for alias in node.names]
        elif isinstance(node, ast.Assign):
            names += [target.id for target in node.targets]
    return sorted(name for name in names if not name.startswith("_"))


def with_names(template):
    """A template with what its marks stand for. The mark `all` stands for the public names of the text that the others make."""
    return insert(template, "#@", made_lines() | {"all": [f'"{name}",' for name in public_names(template)]})


def package_names():
    return public_names(SOURCE / "python/pypw85/__init__.in.py")


def main(kind, *paths):
    *templates, output = map(Path, paths)
    made = {"table": rows_table, "objects": objects_table, "names": with_names, "functions": module}
    output.write_text(made[kind](*templates), encoding="utf-8")


if __name__ == "__main__":
    run(main)
