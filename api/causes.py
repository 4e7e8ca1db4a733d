# SPDX-License-Identifier: BSD-3-Clause
"""The causes for which functions of the library return a status other than success, each with the attribute of a parameter that names it.

The conventions at the top of pw85.h name the causes that hold for all functions. The chapter on errors shows the table, and
docs/tests/check_causes.py provokes each cause in each function.
"""

import re
from dataclasses import dataclass

from declarations import PARTS, functions


@dataclass(frozen=True)
class Cause:
    key: str
    text: str  # the description in the table
    status: str
    parameters: str  # a regular expression for the names of parameters that may have it
    attribute: str = ""  # by which a contract names it; empty if the conventions name it
    type: str = ""  # the type of the parameters, if others of their names are of other types


CAUSES = (
    Cause("null", "a pointer is null, and its description does not allow that", "PW85_EINVAL", r"\w+"),
    Cause("NaN", "a number is NaN", "PW85_EINVAL", r"\w+"),
    Cause("infinity", "a number is infinite, and its description does not allow that", "PW85_EINVAL", r"\w+"),
    Cause("not definite", "a form is not positive definite", "PW85_ENOTPD", r"q|q1|q2|second_moments", "definite"),
    Cause("not positive", "a length, a scale, a curvature or a tolerance is not positive",
          "PW85_EINVAL", r"semi_axes|a|b|radius|scale|curvatures|tolerance", "> 0"),
    Cause("range", "the square of a length is zero or infinite in double", "PW85_EINVAL", r"semi_axes|a|b", "finite square"),
    Cause("negative", "a time, a skin, a ``mu2`` or the radius of a capsule is negative",
          "PW85_EINVAL", r"t_max|skin|mu2|radius", ">= 0"),
    Cause("no rotation", "a matrix is neither a rotation nor a reflection", "PW85_EINVAL", r"rotation", "rotation"),
    Cause("zero", "a direction, a normal, an axis or a quaternion is zero",
          "PW85_EINVAL", r"directions?|starts?|normals?|axis|quaternions?", "!= 0"),
    Cause("concentric", "the centres coincide", "PW85_EINVAL", r"r12", "!= 0"),
    Cause("lambda", "λ is outside of [0, 1]", "PW85_EINVAL", r"lambda", "0..1"),
    Cause("empty box", "a lower corner is beyond the upper one", "PW85_EINVAL", r"lower", "lower <= upper"),
    Cause("shrinks", "an ellipsoid shrinks to nothing before ``t_max``", "PW85_EINVAL", r"motion1|motion2|motions", "> 0 until t_max"),
    Cause("dimension", "the number of dimensions is outside of 1 … 16", "PW85_EINVAL", r"n", "1..16", "int"),
    Cause("index", "the index of a particle or of a vertex is out of range", "PW85_EINVAL", r"pairs|indices|triangles", "index"),
    Cause("size", "a number of rows is so large that their bytes cannot be counted",
          "PW85_EINVAL", r"n|m|num_pairs|num_particles|num_ellipsoids|num_planes|num_vertices|num_triangles", "number of rows", "size_t"),
    Cause("singular", "a cell is singular", "PW85_EINVAL", r"cell", "independent rows"),
    Cause("not periodic", "a cell has no vector that is periodic", "PW85_EINVAL", r"cell", "a periodic row"),
    Cause("no cell", "there are images without a cell", "PW85_EINVAL", r"images", "needs cell"),
    Cause("far", "a centre is too many cells away for its images to be told", "PW85_EINVAL", r"centers", "near the cell"),
    Cause("other list", "the list is of another number of particles", "PW85_EINVAL", r"list", "of as many particles"),
)  # fmt: skip
# The attributes of parameters that have another cause instead.
INSTEAD = {"not positive": ">= 0", "negative": "> 0"}


def is_named(cause, one):
    """Whether the attributes of a parameter name a cause."""
    words = one.attributes.words
    if cause.key == "null":
        return not one.nullable or "optional if not needed" in words
    if cause.key in ("NaN", "infinity"):
        return "or NaN" not in words and (cause.key == "NaN" or "or infinite" not in words)
    return bool(one.attributes.rows) if cause.key == "size" else cause.attribute in words


def can_have(cause, one):
    """Whether a parameter of its name and direction can have a cause."""
    if INSTEAD.get(cause.key) in one.attributes.words:
        return False
    is_of_type = cause.type in ("", one.type)
    return is_of_type and bool(re.fullmatch(cause.parameters, one.name)) and (cause.key == "null" or not one.pointer or one.const)


def functions_with_status():
    return [function for header in PARTS for function in functions(header) if function.type == "int"]


def has_cause(function, cause):
    """Whether a cause is among those that the contract of a function names."""
    return any(can_have(cause, one) and is_named(cause, one) for one in function.flattened)
