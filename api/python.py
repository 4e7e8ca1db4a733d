# SPDX-License-Identifier: BSD-3-Clause
"""What the Python package has by the declarations of the C API: its functions for rows of numbers (api/rows.py).

Usage: python.py table OUTPUT               the table that the compiled part includes (python/src/function.cpp)
       python.py objects OUTPUT             the functions on objects that it includes (python/src/objects.cpp)
       python.py names TEMPLATE OUTPUT      a module or stub, in whose template `#@` marks where names belong: see with_names()
       python.py functions TEMPLATE OUTPUT  a module of functions (api/python_functions.py)
"""

import ast
import sys
from pathlib import Path

from declarations import SOURCE
from layout import insert
from python_functions import is_legacy, module, python_name, tuple_of
from python_objects import stubs
from python_objects import table as objects_table
from python_table import table
from rows import row_functions


def made_lines():
    """Lines for each mark of a template."""
    rows = sorted(row_functions(), key=lambda row: row.name)
    results = {row.name: tuple_of(["Floats" if one.shape else "Any" for one in row.outputs]) for row in rows}
    return {
        "functions": [f"{python_name(row)}," for row in row_functions() if not is_legacy(row)],
        "names": [f"{name}," for name in results],
        "objects": list(stubs()),
        "ufuncs": [f"{name}: np.ufunc" for name in results],
        "calls": [f"def call_{name}(*args: Any) -> {result}: ..." for name, result in results.items()],
    }


def public_names(text):
    """What a module offers: the public names that it imports or assigns."""
    names = []
    for node in ast.parse(text).body:
        if isinstance(node, ast.ImportFrom):
            names += [alias.asname or alias.name for alias in node.names]
        elif isinstance(node, ast.Assign):
            names += [target.id for target in node.targets]
    return sorted(name for name in names if not name.startswith("_"))


def names_of(template):
    """The public names of a module, by its template."""
    return public_names(insert(template, "#@", made_lines() | {"all": []}))


def with_names(template):
    """A template with what its marks stand for. The mark `all` stands for the public names of the text that the others make."""
    return insert(template, "#@", made_lines() | {"all": [f'"{name}",' for name in names_of(template)]})


def package_names():
    """The public names of the package."""
    return names_of(SOURCE / "python/pypw85/__init__.in.py")


def main(kind, *paths):
    *templates, output = map(Path, paths)
    if kind == "table":
        text = table(row_functions())
    elif kind == "objects":
        text = objects_table()
    elif kind == "names":
        text = with_names(*templates)
    else:
        text = module(*templates)
    output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
