# SPDX-License-Identifier: BSD-3-Clause
"""Plugin of pytest: records which errors the modules of pypw85 raise while the tests run, and with which messages.

An import hook compiles the modules with each `raise E` as `raise recorded(key, E)`. Only this process is recorded, so that tests of
messages call the command in this process (systems.command). test_messages.py, which runs last, reads the record.
"""

import ast
import importlib.machinery
import sys

# The messages of each statement that raises, by its key. Each key is there, with an empty set until the statement is reached.
RAISED = {}
# The modules of tests that are skipped as a whole, because something that they need is missing
SKIPPED = []


def recorded(key, error):
    """Returns the error, and records its message."""
    RAISED[key].add(str(error) if isinstance(error, BaseException) else error.__name__)
    return error


def text_of(error):
    """The text of an error in the source: its strings, with … for each number or name that they print."""
    pieces = [piece.value for piece in ast.walk(error) if isinstance(piece, ast.Constant) and isinstance(piece.value, str)]
    return "…".join(piece for piece in pieces if piece.strip()) or ast.unparse(error)


class Recording(ast.NodeTransformer):
    """Wraps the errors that a module raises. A bare `raise` passes on an error that was recorded where it was raised first."""

    def __init__(self, file):
        self.file = file

    def visit_Raise(self, node):
        if node.exc is not None:
            key = f"{self.file}: {text_of(node.exc)}"
            RAISED.setdefault(key, set())
            node.exc = ast.Call(ast.Name("__recorded__", ast.Load()), [ast.Constant(key), node.exc], [])
            ast.fix_missing_locations(node)
        return node


class RecordingLoader(importlib.machinery.SourceFileLoader):
    """Compiles a module with recorded errors. It neither reads nor writes the bytecode that other processes use."""

    def get_code(self, fullname):
        file = self.path.rpartition("/pypw85/")[2]
        tree = Recording(file).visit(ast.parse(self.get_data(self.path), self.path))
        return compile(tree, self.path, "exec", dont_inherit=True)

    def exec_module(self, module):
        module.__recorded__ = recorded
        super().exec_module(module)


class RecordingFinder:
    @staticmethod
    def find_spec(name, path=None, target=None):
        if name.partition(".")[0] != "pypw85":
            return None
        spec = importlib.machinery.PathFinder.find_spec(name, path, target)
        if spec is not None and type(spec.loader) is importlib.machinery.SourceFileLoader:
            spec.loader = RecordingLoader(spec.loader.name, spec.loader.path)
        return spec


def pytest_configure(config):
    config.is_recorded = IS_FIRST


def pytest_collectreport(report):
    if report.skipped:
        SKIPPED.append(report.nodeid)


def pytest_collection_modifyitems(items):
    items.sort(key=lambda item: item.path.name == "test_messages.py")


IS_FIRST = "pypw85" not in sys.modules
if IS_FIRST:
    sys.meta_path.insert(0, RecordingFinder)
