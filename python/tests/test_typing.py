# SPDX-License-Identifier: BSD-3-Clause
"""What type checkers and readers see: stubs under `mypy --strict`, and texts that are whole."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest

import pypw85
from pypw85 import _core, _documentation, gufuncs, legacy

PACKAGE = pathlib.Path(pypw85.__file__).parent
PROGRAM = """
import math
from typing import Any

import numpy as np
import numpy.typing as npt

import pypw85
from pypw85 import legacy

row = [3.0, 0.0, 0.0]
form = (1, 0, 0, 1, 0, 1)
q: npt.NDArray[np.float64] = pypw85.spheroid(1, 2, [0, 0, 1])

mu2, lambda_ = pypw85.contact(row, form, form)
total: float = math.sqrt(mu2) + lambda_
mu2_of_arrays, lambda_of_arrays = pypw85.contact(np.zeros((4, 3)), q, q)
both: npt.NDArray[np.float64] = mu2_of_arrays
number: float = pypw85.contact(row, q, q)[0]
mu2, lambda_ = pypw85.contact(row, form, form, np.empty(2))
mu2, lambda_ = pypw85.contact_function(row, form, form)
mu2, lambda_ = pypw85.contact_2d(row[:2], [1, 0, 1], [1, 0, 1])
mu2, lambda_ = legacy.contact_function2(row, form, form)
total += pypw85.f(0.5, row, form, form) + pypw85.f_neg(0.5, row, form, form) + legacy.f1(0.5, row, form, form)
total += pypw85.closest_approach(row, form, form) + legacy._det_sym(form) + pypw85.lambda_atol
hit: np.bool_ = pypw85.overlap(row, form, form)
hits: npt.NDArray[np.bool_] = pypw85.overlap([row, row], q, q)
point, normal = pypw85.contact_geometry(row, q, q, lambda_)
gap, point, other = pypw85.distance(row, form, form)
total += gap + pypw85.distance_plane(row, 1.0, form)[0] + pypw85.intersect_line(row, row, form)[1]
gaps: npt.NDArray[np.float64] = pypw85.distance([row, row], q, q)[0]
point += pypw85.distance_derivatives(row, q, q)[3] + other
point += pypw85.contact_gradient(row, q, q, lambda_)[0] + normal
name: str = pypw85.metadata["name"]
"""
WRONG = ["pypw85.contact(row, form)", "mu2 = pypw85.contact(row, form, form) + 1", "pypw85.spheroid(1, 2)",
         "text: str = pypw85.f(0.5, row, form, form)", "a, b, c = pypw85.contact(row, form, form)",
         "text: str = pypw85.distance(row, form, form)[0]"]


# What is revealed of the type of an expression: results of rows are numbers, results of arrays are arrays.
NUMBER, ARRAY = "float", "ndarray[Any, dtype[floating[_64Bit]]]"
REVEALED = {
    "pypw85.contact([0, 0, 6], q, q)": f"tuple[{NUMBER}, {NUMBER}]",
    "pypw85.contact(row, form, form)[0]": NUMBER,
    "pypw85.contact(np.zeros((4, 3)), q, q)[0]": ARRAY,
    "pypw85.contact([[0, 0, 6.0], [1, 2, 3]], form, q)[0]": ARRAY,
    "pypw85.contact_function(row, q, q)[0]": NUMBER,
    "pypw85.contact_2d(np.zeros((4, 2)), [1, 0, 1], [1, 0, 1])[0]": ARRAY,
    "pypw85.f(0.5, row, q, q)": NUMBER,
    "pypw85.f(0.5, [row, row], q, q)": ARRAY,
    "pypw85.closest_approach(row, q, q)": NUMBER,
    "pypw85.distance(row, q, q)[0]": NUMBER,
    "pypw85.distance(np.zeros((4, 3)), q, q)[0]": ARRAY,
    "pypw85.distance_plane(row, 1.0, q)[0]": NUMBER,
    "pypw85.overlap(row, q, q)": "bool_",
    "pypw85.overlap([row, row], q, q)": "ndarray[Any, dtype[bool_]]",
    "legacy.contact_function1(np.zeros((4, 3)), q, q)[0]": ARRAY,
}

# How NumPy 2 writes these types, without the names of modules.
OF_NUMPY_2 = {"tuple[int, ...]": "Any", "dtype[float64]": "dtype[floating[_64Bit]]", "bool[bool]": "bool_"}

# Parts of NumPy have no types, which the package calls nevertheless. Other packages have them, but reading them takes longer than the
# package itself.
SETTINGS = """[mypy]
strict = True
ignore_missing_imports = True
[mypy-pypw85.*]
disallow_untyped_calls = False
[mypy-torch.*,dask.*,scipy.*,matplotlib.*,meshio.*,PIL.*]
follow_imports = skip
"""


@pytest.fixture(scope="module")
def mypy(tmp_path_factory):
    """All runs have the same settings, so that NumPy and the package are read once."""
    folder = tmp_path_factory.mktemp("mypy")
    (folder / "mypy.ini").write_text(SETTINGS)

    # In an installation mypy finds the package by itself, and refuses to be told where.
    environment = os.environ if "site-packages" in PACKAGE.parts else {**os.environ, "MYPYPATH": str(PACKAGE.parent)}

    def run(*arguments, **programs):
        for name, program in programs.items():
            (folder / f"{name}.py").write_text(program)
        command = [sys.executable, "-m", "mypy", f"--cache-dir={folder / 'cache'}", *arguments]
        command += [f"{name}.py" for name in programs]
        return subprocess.run(command, cwd=folder, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    return run


# First: after a program that imports the package mypy would read it again, for the errors that it ignores in what is imported.
def test_package(mypy):
    done = mypy("-p", "pypw85")
    assert done.returncode == 0, done.stdout


@pytest.fixture(scope="module")
def programs(mypy):
    """What mypy says of a program that is right, with revealed types, and of one with each wrong line."""
    lines = "".join(f"reveal_type({expression})\n" for expression in REVEALED)
    wrong = {f"wrong{n}": PROGRAM + line + "\n" for n, line in enumerate(WRONG)}
    return mypy(right=PROGRAM + lines, **wrong).stdout


def test_programs(programs):
    assert set(re.findall(r"^(.*)\.py:\d+: error", programs, re.M)) == {f"wrong{n}" for n in range(len(WRONG))}, programs


def test_revealed_types(programs):
    types = re.findall(r'Revealed type is "(.*)"', programs)
    plain = [re.sub(r"\w+\.(?=\w)", "", each).replace("Tuple", "tuple") for each in types]
    for now, before in OF_NUMPY_2.items():
        plain = [each.replace(now, before) for each in plain]
    assert plain == list(REVEALED.values())


def test_stub_has_all():
    """What the compiled module has, its stub has, and the module of ufuncs has all of these."""
    tree = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
    stubs = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    stubs |= {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}
    names = {name for name in dir(_core) if not name.startswith("__")}
    assert stubs == names
    ufuncs = {name for name in names if isinstance(getattr(_core, name), np.ufunc) and not name.startswith("report_")}
    assert ufuncs <= set(gufuncs.__all__)


BUILDING_BLOCKS = ["_cholesky_decomp", "_cholesky_solve"]
LEGACY_BUILDING_BLOCKS = ["_det_sym", "_xT_adjA_x", "_detQ_as_poly", "_rT_adjQ_r_as_poly"]
FUNCTIONS = {f"{module.__name__}.{name}": getattr(module, name)
             for module, names in ((pypw85, pypw85.__all__ + BUILDING_BLOCKS),
                                   (legacy, legacy.__all__ + LEGACY_BUILDING_BLOCKS))
             for name in names if inspect.isfunction(getattr(module, name))}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_texts_are_whole(name):
    function = FUNCTIONS[name]
    text = inspect.getdoc(function)
    assert "{" not in re.sub(r"``.*?``|(?:>>>|\.\.\.).*", "", text)
    assert len(text.split("\n", 1)[0]) <= 120
    listed = set(re.findall(r"^(?:\*\*)?(\w+(?:, \w+)*)(?: :.*)?$", text.partition("Returns\n---")[0], re.M))
    listed = {parameter for group in listed for parameter in group.split(", ")}
    assert set(inspect.signature(function).parameters) <= listed
    assert "Returns\n-------\n" in text


def test_text_of_contact():
    text = inspect.getdoc(pypw85.contact)
    for part in ("Parameters", "r12 :", "q1, q2 :", "out :", "Returns", "mu2, lambda_ :", "Raises", "Examples"):
        assert part in text
    assert "in the square of the unit of `r12`." in text


@pytest.mark.parametrize("function", [pypw85.f, legacy.f1, legacy.f2, legacy.f2_derivatives])
def test_refusals_without_status(function):
    """Functions of C that return no status say in Python, too, that they refuse input."""
    raises = inspect.getdoc(function).partition("Raises\n------\n")[2]
    assert raises.startswith("PW85Error\n    For a single value: invalid input. In arrays, invalid rows become NaN.")


def test_all_paragraphs_are_used():
    sources = "".join(path.read_text(encoding="utf-8") for path in PACKAGE.glob("*.py"))
    for name in _documentation.PARAGRAPHS:
        assert f"    {{{name}}}\n" in sources, name
