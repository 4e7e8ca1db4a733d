# SPDX-License-Identifier: BSD-3-Clause
"""Layers of the package: functions <- System <- files and pictures, packing, statistics <- command. Imports go downward."""

import ast
import pathlib
import subprocess
import sys

import pypw85

PACKAGE = pathlib.Path(pypw85.__file__).parent
# The lowest layer first. What no entry names, by its first part, belongs to the functions, which are the lowest of all.
LAYERS = [
    {"_system"},
    {"formats", "_bounding", "_drawing", "_equilibration", "_images", "_lattices", "_observables", "_packing", "_plotting",
    "_random_addition", "_simulations",
     "_statistics", "_structure", "_voxels"},
    {"cli", "__main__"},
    {""},  # the package itself
]
PROGRAM = """
import importlib, sys

class Unavailable:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("matplotlib", "tqdm", "h5py"):
            raise ImportError(name)

sys.meta_path.insert(0, Unavailable())
import pypw85
system = pypw85.System.from_axes([[0, 0, 0], [1, 0, 0]], [[1, 1, 2]] * 2, [[1, 0, 0, 0]] * 2)
assert len(system.overlaps().pairs) == 1
try:
    system.draw("a.png")
except ImportError as error:
    assert "matplotlib" in str(error)
else:
    raise AssertionError("drawn without Matplotlib")
for name in sys.argv[1:]:
    importlib.import_module(name)
"""


def module_names():
    """By their names in the package, "" for the package itself."""
    return {
        ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix("__init__").removesuffix("."): path
        for path in PACKAGE.rglob("*.py")
    }


def imported(node, name, path):
    """Full names that a node of the syntax tree of a module imports, which may be names in a module, too."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.Call) and ast.unparse(node.func).endswith(("import_module", "__import__")):
        return [argument.value for leaf in node.args for argument in ast.walk(leaf) if isinstance(argument, ast.Constant)]
    if not isinstance(node, ast.ImportFrom):
        return []
    parts = ["pypw85", *name.split(".")] if name else ["pypw85"]
    base = parts[: len(parts) - node.level + (path.name == "__init__.py")] if node.level else []
    prefix = ".".join([*base, *([node.module] if node.module else [])])
    return [f"{prefix}.{alias.name}" for alias in node.names]


def import_graph():
    """The modules of the package that each one imports, anywhere in its text."""
    modules = module_names()
    known = modules.keys() | {"_core"}  # which is compiled, and imports none of them before it is called
    graph = {"_core": set()}
    for name, path in modules.items():
        nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        found = [full for node in nodes for full in imported(node, name, path) if f"{full}.".startswith("pypw85.")]
        inner = [full.removeprefix("pypw85").removeprefix(".") for full in found]
        graph[name] = {n if n in known else n.rpartition(".")[0] for n in inner} & known - {name}
    return graph


def layer(name):
    first = name.partition(".")[0]
    return next((k for k, names in enumerate(LAYERS, 1) if first in names), 0)


def find_circle(graph):
    """Modules in circles and those that import them: what stays when modules that import no others are taken away, again and again."""
    rest = dict(graph)
    while leaves := [name for name, others in rest.items() if not others & rest.keys()]:
        for name in leaves:
            del rest[name]
    return sorted(rest)


def test_graph():
    """That imports are found at all: a few of each kind."""
    graph = import_graph()
    assert {"_forms", "_typing", "formats"} <= graph["_drawing"]
    assert {"_system", "formats._frames"} <= graph["formats.csv"]
    assert "formats.csv" in graph["formats"]
    assert {"_core", "_functions", "formats"} <= graph[""]
    assert {"_drawing", "cli._input"} <= graph["cli.draw"]
    assert find_circle({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": set()}) == ["a", "b", "c"]


def test_no_circle():
    assert find_circle(import_graph()) == []


def test_downward():
    upward = [
        f"{name} imports {other}" for name, others in import_graph().items() for other in others if layer(other) > layer(name)
    ]
    assert upward == []


def test_without_other_packages(tmp_path):
    """Pictures and files need Matplotlib, tqdm and h5py when they are made, not when the package is imported."""
    names = [f"pypw85.{name}" for name in module_names() if name not in ("", "torch", "__main__", "cli.__main__")]
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, *names], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
