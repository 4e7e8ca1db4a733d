# SPDX-License-Identifier: BSD-3-Clause
"""Plugin of pytest: records which errors the modules of pypw85 raise while the tests run, and with which messages.

An import hook compiles the modules with each `raise E` as `raise recorded(file, line, E)`; only this process is recorded.
"""

import ast
import importlib.machinery
import sys

# The messages of each statement that raises: {(file, line): {message}}. Each is there, without messages until it raises.
RAISED = {}


def recorded(file, line, error):
    """Returns the error, and records its message."""
    RAISED[file, line].add(str(error) if isinstance(error, BaseException) else error.__name__)
    return error


class Recording(ast.NodeTransformer):
    """Wraps the errors that a module raises. A bare `raise` passes on what was recorded where it was raised first."""

    def __init__(self, file):
        self.file = file

    def visit_Raise(self, node):  # noqa: N802
        if node.exc is not None:
            RAISED[self.file, node.lineno] = set()
            function = ast.Name("__recorded__", ast.Load())
            node.exc = ast.Call(function, [ast.Constant(self.file), ast.Constant(node.lineno), node.exc], [])
            ast.fix_missing_locations(node)
        return node


class RecordingLoader(importlib.machinery.SourceFileLoader):
    """Compiles a module with recorded errors. It reads and writes no bytecode, which other processes use."""

    def get_code(self, fullname):
        tree = ast.parse(self.get_data(self.path), self.path)
        file = self.path.rpartition("/pypw85/")[2]
        return compile(Recording(file).visit(tree), self.path, "exec", dont_inherit=True)

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


if "pypw85" not in sys.modules:
    sys.meta_path.insert(0, RecordingFinder)
