# SPDX-License-Identifier: BSD-3-Clause
"""The causes for which functions of the library return a status other than success, each with the attribute of a parameter that names it.

The conventions at the top of pw85.h name the causes that hold for all functions. The chapter on errors shows the causes, and
docs/tests/check_causes.py provokes each one in each function.
"""

import re
from dataclasses import dataclass

PACKED = "n(n+1)/2"  # the extent of packed symmetric matrices in n dimensions
RANGES = ("> 0", ">= 0", "!= 0", "0..1")  # attributes of which a parameter has one


@dataclass(frozen=True)
class Cause:
    key: str
    attribute: str = ""  # by which a contract names it; empty if the conventions name it
    text: str = ""  # the description in the table
    parameters: str = r"\w+"  # a regular expression for the names of parameters that may have it
    type: str = "double"  # of such parameters; empty for any
    sizes: tuple = ()  # how many numbers the attribute needs, if not any
    unless: tuple = ()  # the attributes that accept what the conventions refuse
    name: str = ""  # in src/base/last_error.hpp, where a check of each number knows it
    said: str = ""  # of such a parameter in Python
    wrong: str = ""  # what is wrong, of one parameter, in Python
    status: str = "PW85_EINVAL"

    def is_named(self, one):
        """Whether the attributes of a parameter name it."""
        if self.key == "size":
            return bool(one.attributes.rows)
        words = one.attributes.words
        return self.attribute in words if self.attribute else not words.intersection(self.unless)

    def can_have(self, one):
        """Whether a parameter of this name and direction can have it."""
        others = {*RANGES} - {self.attribute} if self.attribute in RANGES else set()
        is_read = self.key == "null" or not one.pointer or one.const
        is_meant = self.type in ("", one.type) and re.fullmatch(self.parameters, one.name)
        return bool(is_meant) and is_read and not others & one.attributes.words

    def is_of(self, function):
        """Whether it is among those that the contract of a function names."""
        return any(self.can_have(one) and self.is_named(one) for one in function.flattened)


CAUSES = (
    Cause("null", "", "a pointer is null, and its description does not allow that", type="", unless=("optional",)),
    Cause("NaN", "", "a number is NaN", type="", unless=("or NaN",)),
    Cause("infinity", "", "a number is infinite, and its description does not allow that", type="", unless=("or NaN", "or infinite")),
    Cause("not definite", "definite", "a form is not positive definite", r"q|q1|q2|second_moments", sizes=(3, 6, PACKED), name="definite",
          wrong="a form is not positive definite", status="PW85_ENOTPD"),
    Cause("not positive", "> 0", "a length, a scale, a curvature or a tolerance is not positive",
          r"semi_axes|a|b|radius|scale|curvatures|tolerance", name="positive", said="> 0", wrong="`{name}` is not positive"),
    Cause("range", "finite square", "the square of a length is zero or infinite in double", r"semi_axes|a|b", name="finite_square",
          wrong="the square of `{name}` overflows or underflows"),
    Cause("negative", ">= 0", "a time, a skin, a ``mu2`` or the radius of a capsule is negative", r"t_max|skin|mu2|radius",
          name="from_zero", said=">= 0", wrong="`{name}` is negative"),
    Cause("no rotation", "rotation", "a matrix is neither a rotation nor a reflection", r"rotation", sizes=(9,), name="rotation",
          wrong="`{name}` is not orthonormal"),
    Cause("zero", "!= 0", "a direction, a normal, an axis or a quaternion is zero",
          r"directions?|starts?|normals?|axis|quaternions?", name="not_zero", said="not zero", wrong="`{name}` is zero"),
    Cause("concentric", "!= 0", "the centres coincide", r"r12", name="not_zero", said="not zero", wrong="`{name}` is zero"),
    Cause("lambda", "0..1", "λ is outside of [0, 1]", r"lambda", sizes=(1,), name="unit_interval", wrong="λ is not in [0, 1]"),
    Cause("empty box", "lower <= upper", "a lower corner is beyond the upper one", r"lower", name="below_next",
          said="`lower` <= `upper`", wrong="`lower` is larger than `upper`"),
    Cause("shrinks", "> 0 until t_max", "an ellipsoid shrinks to nothing before ``t_max``", r"motion1|motion2|motions", "pw85_motion",
          name="until_t_max", wrong="an ellipsoid shrinks to nothing before `t_max`"),
    Cause("dimension", "1..16", "the number of dimensions is outside of 1 … 16", r"n", "int"),
    Cause("index", "index", "the index of a particle or of a vertex is out of range", r"pairs|indices|triangles", "int32_t"),
    Cause("size", "number of rows", "a number of rows is so large that their bytes cannot be counted",
          r"n|m|num_pairs|num_particles|num_ellipsoids|num_planes|num_vertices|num_triangles", "size_t"),
    Cause("not periodic", "a periodic row", "a cell has no vector that is periodic", r"cell", sizes=(9,)),
    Cause("singular", "independent rows", "a cell is singular", r"cell", sizes=(9,)),
    Cause("no cell", "needs cell", "there are images without a cell", r"images", "int32_t"),
    Cause("far", "near the cell", "a centre is too many cells away for its images to be told", r"centers", sizes=(3,)),
    Cause("other list", "of as many particles", "the list is of another number of particles", r"list", "pw85_neighbors"),
)  # fmt: skip
# The attributes that limit values in their order, each with its cause. The last ones are no causes of refusals.
LIMITS = {cause.attribute: cause for cause in CAUSES if cause.attribute not in ("", "number of rows")} | {
    "<= 1": Cause("", "<= 1", name="at_most_one"),
    "or infinite": Cause("", "or infinite", type="", name="may_be_infinite", said="may be infinite"),
    "or NaN": Cause("", "or NaN", type="", name="may_be_nan"),
    "or far away": Cause("", "or far away", type=""),
}
