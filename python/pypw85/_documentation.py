"""The texts of functions: paragraphs that several share, so that the text of each is whole, and where a function is found by name."""

from __future__ import annotations

import re
import textwrap
from typing import TypeVar
from collections.abc import Callable

Function = TypeVar("Function", bound=Callable[..., object])

# The functions that are documented, by their names in the compiled part.
FUNCTIONS: dict[str, Callable[..., object]] = {}


def documented(function: Function) -> Function:
    """Decorator: puts the paragraph of that name in place of a line like ``{forms}`` in the text of a function, and lists it."""
    prefix = "legacy_" if function.__module__.endswith(".legacy") else ""
    FUNCTIONS[prefix + function.__name__.removeprefix("_")] = function
    if function.__doc__:  # not with python -OO
        function.__doc__ = re.sub(r"^( *)\{(\w+)\}\n", _paragraph, function.__doc__, flags=re.MULTILINE)
    return function


def _paragraph(line: re.Match[str]) -> str:
    return textwrap.indent(PARAGRAPHS[line[2]].lstrip("\n"), line[1])


PARAGRAPHS = {
    "lambda_in": """
lambda_ : (...) array_like
    In [0, 1].
""",
    "lambda_found": """
lambda_ : (...) array_like
    In [0, 1], from `contact`.
""",
    "r12": """
r12 : (..., 3) array_like
    From the centre of ellipsoid 1 to that of ellipsoid 2.
""",
    "forms": """
q1, q2 : (..., 6) array_like
    Forms of the ellipsoids, in the square of the unit of `r12`.
""",
    "form": """
q : (..., 6) array_like
    Form of the ellipsoid.
""",
    "half_space": """
normal : (..., 3) array_like
    Into the half-space, of any length > 0.
offset : (...) array_like
    In the unit of normal·x; negative if the centre is in the half-space.
""",
    "lambda_found_2d": """
lambda_ : (...) array_like
    In [0, 1], from `contact_2d`.
""",
    "pair_2d": """
r12 : (..., 2) array_like
    From the centre of ellipse 1 to that of ellipse 2.
q1, q2 : (..., 3) array_like
    Forms (xx, xy, yy), in the square of the unit of `r12`.
""",
    "direction": """
direction : (..., 3) array_like
    From centre 1 to centre 2, of any length > 0.
q1, q2 : (..., 6) array_like
    Forms of the ellipsoids.
""",
    "direction_2d": """
direction : (..., 2) array_like
    From centre 1 to centre 2, of any length > 0.
q1, q2 : (..., 3) array_like
    Forms (xx, xy, yy).
""",
    "semi_axes": """
semi_axes : (..., 3) array_like
    Lengths of the principal semi-axes (not diameters), > 0.
""",
    "q3": """
q3 : (..., 6) array_like, optional
    2 Q1 - Q2, if it is at hand.
""",
    "keywords": """
**kwargs
    As for any ufunc.
""",
    "out": """
out : (...) array, optional
    Where to put the result.
**kwargs
    As for any ufunc.
""",
    "out_form": """
out : (..., 6) array, optional
    Where to put the result.
**kwargs
    As for any ufunc.
""",
    "out_vectors": """
out : tuple of two (..., 3) arrays, optional
    Where to put the results.
**kwargs
    As for any ufunc.
""",
    "out_several": """
out : tuple of arrays, optional
    Where to put the results.
**kwargs
    As for any ufunc.
""",
    "out_contact": """
out : (..., 2) array, or a tuple of two (...) arrays, optional
    Where to put μ² and λ.
**kwargs
    As for any ufunc.
""",
    "returns_contact": """
Returns
-------
mu2, lambda_ : (...) arrays or numbers
    μ² and the maximiser λ in [0, 1]; no unit.
""",
    "returns_distance": """
Returns
-------
(...) array or number
    In the unit of the semi-axes.
""",
    "raises_pair": """
Raises
------
PW85Error
    For a single pair: invalid input, or a form that is not positive definite. Rows of arrays become NaN.
""",
    "raises_row": """
Raises
------
PW85Error
    For a single row: invalid input, or a form that is not positive definite. Rows of arrays become NaN.
""",
    "raises_direction": """
Raises
------
PW85Error
    For a single pair: invalid input, a zero direction. Rows of arrays become NaN.
""",
    "raises_lambda": """
Raises
------
PW85Error
    For a single pair: invalid input, λ outside [0, 1]. Rows of arrays become NaN.
""",
    "pair_list": """
pairs : (k, 2) array_like of int
    Indices (i, j) of particles, from 0. Contiguous int32 is used as it is, anything else copied.
centers : (n, 3) array_like
    Centres of the particles.
q : (n, 6) array_like
    Their forms, in the square of the unit of `centers`.
cell : (3, 3) array_like, optional
    Rows are the vectors of the periodic cell, in the unit of `centers`. Unless `images` says otherwise, the image of j
    nearest to i (by the distance of the centres) is taken, however skewed the cell. In small cells another one can have a
    smaller μ²: see `nearest_image_limit`.
images : (k, 3) array_like of int, optional
    Multiples of the vectors of the cell, to be added to the centres of j.
""",
    "raises_pair_list": """
Raises
------
IndexError
    An index is not in [0, n).
ValueError
    Shapes do not match, or the cell is singular or not finite.
TypeError
    Pairs are not integers or masked, something else is no real number, or outputs do not fit.
""",
}
