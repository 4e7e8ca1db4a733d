# SPDX-License-Identifier: BSD-3-Clause
"""The causes for which functions of the library return a status other than success, as their contracts name them.

A contract names a cause by certain words in the description of a parameter or of the returned status. The conventions at the top of
pw85.h name the causes that hold for all functions. The chapter on errors shows the table, and docs/tests/check_causes.py
provokes each cause in each function.
"""

import re
from dataclasses import dataclass

from declarations import PARTS, flattened, functions, members, referenced
from declarations import parameters as declared

REFERENCE = re.compile(r"(?:as (?:for|in)|contract as|see|arguments of) (pw85\w+)\(\)", re.IGNORECASE)
KNOWN = {function.name: function for header in PARTS for function in functions(header)}


@dataclass(frozen=True)
class Cause:
    key: str
    text: str  # the description in the table
    status: str
    parameters: str  # a regular expression for the names of the parameters
    words: str = ""  # a regular expression for the words by which a contract names it; empty if the conventions name it


CAUSES = (
    Cause("null", "a pointer is null, and its description does not allow that", "PW85_EINVAL", r"\w+"),
    Cause("NaN", "a number is NaN", "PW85_EINVAL", r"\w+"),
    Cause("infinity", "a number is infinite, and its description does not allow that", "PW85_EINVAL", r"\w+"),
    Cause("not definite", "a form is not positive definite", "PW85_ENOTPD", r"q|q1|q2"),
    Cause(
        "not positive",
        "a length, a scale or a curvature is not positive",
        "PW85_EINVAL",
        r"semi_axes|a|b|radius|scale|curvatures",
        r"> 0",
    ),
    Cause("range", "the square of a length is zero or infinite in double", "PW85_EINVAL", r"semi_axes|a|b", r"range of double"),
    Cause("negative", "a time, a skin or a ``mu2`` is negative", "PW85_EINVAL", r"t_max|skin|mu2", r">= 0"),
    Cause("no rotation", "a matrix is neither a rotation nor a reflection", "PW85_EINVAL", r"rotation", r"at most 1e-6"),
    Cause(
        "zero",
        "a direction, a normal, an axis or a quaternion is zero",
        "PW85_EINVAL",
        r"directions?|starts?|normals?|axis|quaternions?",
        r"lengths? > 0|zero (?:direction|normal|axis)",
    ),
    Cause("concentric", "the centres coincide", "PW85_EINVAL", r"r12", r"r12 != 0"),
    Cause("lambda", "λ is outside of [0, 1]", "PW85_EINVAL", r"lambda", r"outside \[0, 1\]"),
    Cause("empty box", "a lower corner is beyond the upper one", "PW85_EINVAL", r"lower", r"lower <= upper"),
    Cause(
        "shrinks",
        "an ellipsoid shrinks to nothing before ``t_max``",
        "PW85_EINVAL",
        r"motion1|motion2|motions",
        r"shrinks? to nothing",
    ),
    Cause("index", "the index of a particle or of a vertex is out of range", "PW85_EINVAL", r"pairs|indices|triangles", r"from 0"),
    Cause(
        "size",
        "a number of rows is so large that their bytes cannot be counted",
        "PW85_EINVAL",
        r"n|num_pairs|num_particles|num_ellipsoids|num_planes|num_vertices|num_triangles",
        r"number of|n×|num_pairs×|num_ellipsoids×|num_planes×|the same as",
    ),
    Cause("singular", "a cell is singular", "PW85_EINVAL", r"cell", r"singular|not independent|other arguments"),
    Cause("not periodic", "a cell has no vector that is periodic", "PW85_EINVAL", r"cell", r"at least one is periodic"),
    Cause("no cell", "there are images without a cell", "PW85_EINVAL", r"images", r"`images` without `cell`"),
    Cause("far", "a centre is too many cells away for its images to be told", "PW85_EINVAL", r"centers", r"2²⁹|2³¹|2⁵⁰"),
    Cause(
        "other list", "the list is of another number of particles", "PW85_EINVAL", r"list", r"not that of the list"
    ),
)
FUNCTIONS = tuple(function for function in KNOWN.values() if function.type == "int")
ALLOWED = {"null": r"may be null|or null|null if nothing|null for", "infinity": r"may be infinity"}
ALL_OUTPUTS = r"any output may be null|any of them null"


def tagged(function, tag):
    """The text of a tag of a comment, such as @return, or an empty text."""
    found = re.search(rf"@{tag} (\S.*?)(?=@|$)", function.comment, re.DOTALL)
    return " ".join(found[1].split()) if found else ""


def referred(text):
    """The functions to which a text refers."""
    return [KNOWN[name] for name in REFERENCE.findall(" ".join(text.split())) if name in KNOWN]


def returned(function):
    """The text of the contract about the returned status, with that of the functions to which it refers there."""
    own = tagged(function, "return")
    return " ".join([own, *map(returned, referred(own or function.comment))])


def struct_with(function, name):
    """The struct that a function takes and that has a member of this name, if it has no parameter of the name; or None."""
    if name in function.parameter_names():
        return None
    structs = [one for one in declared(function) if one.is_struct()]
    return next((one for one in structs if name in [member for member, _, _ in members(one.type)]), None)


def described(function, name):
    """The text of the contract about a parameter, with that of the functions to which it refers there."""
    struct = struct_with(function, name)
    comment = next((text for member, _, text in members(struct.type) if member == name), "") if struct else ""
    own = tagged(function, rf"param(?:\[out\])? (?:\w+,)*{struct.name if struct else name}(?:,\w+)*")
    return " ".join([comment, own, *(described(other, name) for other in referred(own or function.comment))])


def outputs_may_be_null(function):
    others = referred(function.comment)
    return bool(re.search(ALL_OUTPUTS, function.comment)) or any(map(outputs_may_be_null, others))


def of_one_row(function):
    """For a function of many rows, "pw85_f() for n pairs", the contract of the function of one row with those to which it refers;
    otherwise an empty text."""
    name = re.match(r"\s*(pw85\w+)\(\)[^.]*? for (?:n|the pairs) ", function.comment)
    return " ".join(one.comment for one in referenced(KNOWN[name[1]], KNOWN)) if name else ""


# These functions accept the values: a sum is NaN if one of its terms is NaN.
SUMS = {"pw85_contact_forces_pairs": ("NaN", "infinity", "far")}


def is_named(cause, function, name, is_output=False):
    """Whether the contract of a function names a cause for a parameter."""
    said = described(function, name)
    if cause.words:
        return bool(re.search(cause.words, " ".join([said, returned(function), of_one_row(function)])))
    if cause.key == "null" and struct_with(function, name):
        return not next(one.nullable for one in flattened(function) if one.name == name)
    if cause.key == "null" and is_output and outputs_may_be_null(function):
        return False
    return not re.search(ALLOWED.get(cause.key, r"^\b$"), said)


def parameters(function):
    """(name, whether it is an output) for each parameter, with the members of structs in the place of the structs."""
    return [(one.name, one.pointer and not one.const) for one in flattened(function)]


def has_cause(function, cause):
    """Whether a cause is among those that the contract of a function names."""
    return any(
        is_named(cause, function, name, is_output)
        for name, is_output in parameters(function)
        if re.fullmatch(cause.parameters, name) and (not is_output or cause.key == "null")
    )
