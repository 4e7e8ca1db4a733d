# SPDX-License-Identifier: BSD-3-Clause
"""Paragraphs that several docstrings share, and a table of the functions of the extension module."""

from __future__ import annotations

import inspect
import re
import textwrap
from typing import TypeVar
from collections.abc import Callable

from . import _core

Function = TypeVar("Function", bound=Callable[..., object])

# The functions of the extension module, by their names in it
FUNCTIONS: dict[str, Callable[..., object]] = {}


def listed(function: Function) -> Function:
    """Decorator: adds a function of the extension module to FUNCTIONS."""
    prefix = "legacy_" if function.__module__.endswith(".legacy") else ""
    FUNCTIONS[prefix + function.__name__.removeprefix("_")] = function
    return function


def documented(function: Function) -> Function:
    """Decorator: replaces a line like ``{pair_list}`` of a docstring by the paragraph of that name."""
    if function.__doc__:  # not with python -OO
        function.__doc__ = re.sub(r"^( *)\{(\w+)\}\n", _paragraph, function.__doc__, flags=re.MULTILINE)
    return function


def _paragraph(line: re.Match[str]) -> str:
    return textwrap.indent(PARAGRAPHS[line[2]].lstrip("\n"), line[1])


PARAGRAPHS = {
    "pair_list": """
pairs : (k, 2) array_like of int
    Indices (i, j) of particles, from 0. Contiguous int32 arrays are not copied.
centers : (n, 3) array_like
    Centres of the particles.
q : (n, 6) array_like
    Forms of the particles, in the square of the unit of `centers`.
cell : (3, 3) array_like, optional
    Rows are the vectors of the periodic cell, in the unit of `centers`; it may be skewed. Without `images`, a pair is
    particle i and the image of particle j whose centre is nearest. In a small cell another image can have a smaller μ²:
    see `nearest_image_limit`.
images : (k, 3) array_like of int, optional
    Multiples of the cell vectors to add to the centre of j.
""",
    "raises_pair_list": """
Raises
------
IndexError
    An index is not in [0, n).
ValueError
    Shapes do not match, or the cell is singular or not finite.
TypeError
    `pairs` or `images` are not integers, `pairs` is masked, another argument is not real, or an output array does not fit.
""",
}


def names_of_inputs(name: str) -> list[str]:
    """The first parameters of the Python function of this name."""
    return list(inspect.signature(FUNCTIONS[name]).parameters)[: len(cores_of_inputs(name))]


def cores_of_inputs(name: str) -> list[tuple[int, ...]]:
    """Shapes of one row of each input."""
    inputs = getattr(_core, name).signature.split("->")[0][1:-1].split("),(")
    return [tuple(int(size) for size in core.split(",") if size) for core in inputs]
