# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the C API that take one row of numbers to another one: those that Python offers for arrays of any shape.

A function of one row is known by its parameters: numbers, arrays of stated length, motions. Its relative for many rows has the
same name with `_batch` in it. Where there is a function of many rows alone, it is called for one. An output that receives several
members of the result, as `out` with `mu2` and `lambda`, is as many results.
"""

from dataclasses import dataclass, replace
from functools import cache

from attributes import Attributes
from declarations import Function, functions
from parameters import Parameter
from public_headers import HOST_HEADERS, ONE_ROW
from refusals import Refused

# Python has one number of what this building block of 1.0's programs gives: f, by a function of python/src/function.cpp.
ONE_OF_MANY = {"pw85__residual": "f"}
NUMBERS_OF_MOTION = 7  # in a pw85_motion
# Python has these for matrices (python/pypw85/_conversions.py), which refuses all rows if one is bad.
BY_HAND = ("pw85_from_moments", "pw85_from_moments_2d")
# Other functions of one or many rows that languages have by hand: their parameters are not numbers and arrays of stated length alone.
NOT_OF_ROWS = ("pw85_set_reproducible", "pw85_is_reproducible", "pw85_inertia", "pw85_inertia_batch", "pw85_overlap_any",
               "pw85_contact_polytope", "pw85_contact_polytope_batch", "pw85_overlap_polytope", "pw85_overlap_polytope_batch")  # fmt: skip
# The result of a function that returns a number.
RETURNED = Parameter("", "double", True, False, None, False, "", Attributes(), "")


@dataclass(eq=False)  # each is made once
class RowFunction:
    """A function for one row, or for many where there is none for one."""

    function: Function
    many: Function | None  # the relative for many rows, or the function itself
    inputs: list  # parameters with the shapes of one row
    outputs: list  # one for each result

    @property
    def name(self):
        """In the compiled part of the package."""
        plain = self.function.plain.removesuffix("_batch").replace("legacy__", "legacy_").removeprefix("_")
        return ONE_OF_MANY.get(self.function.name, plain)

    def is_by_hand(self):
        """Whether the compiled part has a function for it that is not made of the declaration."""
        return self.function.name in ONE_OF_MANY

    def is_building_block(self):
        """Whether its name may change: it has two underscores."""
        return "__" in self.function.name and not self.is_by_hand()

    def is_of_many(self):
        """Whether there is no function of one row."""
        return self.function is self.many

    def is_truth(self):
        """Whether the result is a truth value, which takes a byte where there are many rows."""
        return len(self.outputs) == 1 and self.outputs[0].is_truth()

    def is_split(self):
        """Whether results are numbers that the function writes into one array."""
        return len(self.outputs) > len(self.function.outputs) > 0

    def takes_rows(self):
        """Whether the relative for many rows has an array of doubles for each operand, or of bytes for truth values."""
        listed = self.many.parameters[1:] if self.many else []
        return bool(listed) and all(one.pointer and (one.type == "double" or (self.is_truth() and one.is_truth())) for one in listed)

    def is_overlap(self):
        return self.is_truth() and self.name.startswith("overlap")

    def signature(self):
        """That of a generalised ufunc."""
        cores = ([f"({','.join(map(str, one.shape))})" for one in operands] for operands in (self.inputs, self.outputs))
        return "->".join(map(",".join, cores))


def is_of_one_row(function):
    if function.type not in ("int", "double", "void") or not function.inputs or (function.type != "double" and not function.outputs):
        return False
    is_written = all(one.type in ("double", "int") for one in function.outputs)
    kinds = {one.type if one.length or not one.pointer else f"{one.type} *" for one in function.inputs}  # lengths must be stated
    return is_written and kinds <= {"double", "pw85_motion *"}


def is_of_many_rows(function):
    """Whether all arrays have `n` rows of numbers."""
    first, *others = function.parameters
    return first.name == "n" and all(one.type == "double" and one.rows == "n" for one in others)


def name_of_many(name):
    return f"{name.removesuffix('_2d')}_batch_2d" if name.endswith("_2d") else f"{name}_batch"


def of_row(one):
    """A parameter with the shape that it has in one row."""
    return one.with_shape((NUMBERS_OF_MOTION,) if one.type == "pw85_motion" else one.row_shape)


def results(function):
    outputs = function.outputs
    if function.name in ONE_OF_MANY or not outputs:
        return [RETURNED]
    numbers = outputs[0].with_shape(())
    if len(outputs) == 1 and outputs[0].length == len(outputs[0].members()) > 1:
        return [replace(numbers, name=name) for name in outputs[0].members()]
    if function.type == "double":  # the function returns the first of the numbers that it writes
        return [numbers] * outputs[0].size
    return [of_row(one) for one in outputs]


def row_function(function, many):
    """The function with its operands; `many` is the function itself if it has an array of rows for each."""
    inputs = [of_row(one) for one in function.inputs[function is many :]]
    return RowFunction(function, many, inputs, results(function))


def rows_by_hand():
    """Those for which Python has a function by hand."""
    known = {function.name: function for function in functions(*ONE_ROW, "pw85_batch.h")}
    return [row_function(known[name], known[name_of_many(name)]) for name in BY_HAND]


@cache
def row_functions():
    """All others, in the order of the headers."""
    known = {function.name: function for function in functions(*HOST_HEADERS)}
    found, relatives = [], {name_of_many(name) for name in BY_HAND}
    for name, function in known.items():
        if name in {*BY_HAND, *relatives} or not function.parameters:
            continue
        if is_of_one_row(function):
            found.append(row_function(function, known.get(name_of_many(name))))
            relatives.add(name_of_many(name))
        elif is_of_many_rows(function):
            found.append(row_function(function, function))
        elif function.type == "int" and function.header in (*ONE_ROW, "pw85_batch.h") and name not in NOT_OF_ROWS:
            raise Refused(f"{function.place}: parameters that languages cannot take as rows, and not in NOT_OF_ROWS of api/rows.py")
    return found
