# SPDX-License-Identifier: BSD-3-Clause
"""Docstrings: their examples are run, and their lists name what there is."""

import ast
import doctest
import importlib
import importlib.util
import pathlib

import pytest

import pypw85
from pypw85 import formats

PACKAGE = pathlib.Path(pypw85.__file__).parent
LEFT_OUT = {"__main__.py"} | ({"torch.py"} if importlib.util.find_spec("torch") is None else set())
MODULES = sorted(path for path in PACKAGE.rglob("*.py") if path.name not in LEFT_OUT)
# Arguments that are made by their class methods, whose members users do not need
OPAQUE = (pypw85.Wall, pypw85.Field, pypw85.Law)


def examples_in_source(path):
    """The number of examples in the docstrings of a file."""
    nodes = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
             if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef))]  # fmt: skip
    return sum(len(doctest.DocTestParser().get_examples(ast.get_docstring(node) or "")) for node in nodes)


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_examples_are_collected(path):
    """pytest runs what doctest finds. A decorator without functools.wraps() would hide the docstring of a function from it."""
    name = ".".join(["pypw85", *path.relative_to(PACKAGE).with_suffix("").parts]).removesuffix(".__init__")
    found = doctest.DocTestFinder().find(importlib.import_module(name))
    assert sum(len(test.examples) for test in found) == examples_in_source(path)


def test_formats_in_docstrings():
    for name in formats.READABLE:
        assert f'"{name}"' in pypw85.read.__doc__
    for name in formats.WRITABLE:
        assert f'"{name}"' in pypw85.write.__doc__


def test_options_in_docstring():
    for name in formats.Options.__dataclass_fields__:
        assert f"`{name}`" in pypw85.read.__doc__


RESULTS = [made for made in vars(pypw85).values()
           if isinstance(made, type) and issubclass(made, tuple) and "_fields" in vars(made) and made not in OPAQUE]  # fmt: skip


@pytest.mark.parametrize("result", RESULTS, ids=lambda result: result.__name__)
def test_results_explain_their_members(result):
    """The docstring of a named tuple names each of its members."""
    assert [member for member in result._fields if f"`{member}`" not in result.__doc__] == []
