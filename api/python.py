"""What the Python package has by the declarations of the C API: its functions for rows of numbers (api/rows.py).

Usage: python.py table OUTPUT               the table that the compiled part includes (python/src/function.cpp)
       python.py ufuncs TEMPLATE OUTPUT     a module or stub, in whose template `#@` marks where the names of the ufuncs belong
       python.py functions TEMPLATE OUTPUT  a module of functions (api/python_functions.py)
"""

import re
import sys
from pathlib import Path

from python_functions import module
from python_table import table
from rows import row_functions

# Made of a function that takes its arguments in one block: python/src/function.cpp.
MADE_BY_HAND = {"f": [()]}


def results():
    """The shapes of the results of each function of the compiled part, by its name in order."""
    return dict(sorted(({row.name: [one.shape for one in row.outputs] for row in row_functions()} | MADE_BY_HAND).items()))


def type_of(shapes):
    types = ["Floats" if shape else "Any" for shape in shapes]
    return types[0] if len(types) == 1 else f"tuple[{', '.join(types)}]"


def made_for(mark):
    """Lines for each mark of a template."""
    return {
        "names": [f"{name}," for name in results()],
        "ufuncs": [f"{name}: np.ufunc" for name in results()],
        "calls": [f"def call_{name}(*args: Any) -> {type_of(shapes)}: ..." for name, shapes in results().items()],
    }[mark]


def filled(template):
    """A template with lines in the place of its marks, indented like these."""

    def lines(match):
        return "".join(f"{match[1]}{line}\n" for line in made_for(match[2]))

    return re.sub(r"^( *)#@ (\w+)\n", lines, template, flags=re.MULTILINE)


def main(kind, *paths):
    templates = [Path(path).read_text(encoding="utf-8") for path in paths[:-1]]
    if kind == "table":
        text = table(row_functions())
    elif kind == "ufuncs":
        text = filled(*templates)
    else:
        text = module(*templates, is_legacy="legacy" in Path(paths[0]).name)
    Path(paths[-1]).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
