# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of C functions, and the members of the structs that are arguments.

`pw85_pair_list const *list`, `pw85_system const *system` and `pw85_law const *law` are structs, whose members have comments with the
same brackets as parameters. Members count as parameters of the function, and extents may be names of members.
"""

import re
from collections import namedtuple
from dataclasses import dataclass, replace
from math import prod

from attributes import ASTRAY, Attributes, parsed
from causes import PACKED
from public_headers import of_texts, text_of
from refusals import line_of, refuse

STRUCTS = ("pw85_pair_list", "pw85_system", "pw85_law")  # structs that are arguments
OBJECTS = ("pw85_neighbors", "pw85_mesh", "pw85_hard_ellipsoids", "pw85_random_addition")  # what the library owns
CALLBACKS = ("pw85_potential",)  # types of functions of the caller
TRUTHS = ("overlap", "contains", "is_free", "take")  # names of integers that are truth values; others are signs and indices
ELEMENTS = ("pw85_motion", "pw85_wall", "pw85_field")  # structs that are elements of arrays
NUMBERS = ("double", "int", "size_t", "int32_t", "int64_t", "unsigned char", "char", "void")
TYPES = (*NUMBERS, *STRUCTS, *ELEMENTS, *OBJECTS, *CALLBACKS)
PARAMETER = re.compile(r"(?P<type>(?:unsigned )?\w+)(?P<const> const)?(?P<pointers>[ *]*)(?P<name>\w+)(?:\[(?P<length>\d+)\])?")
STRUCT = r"^typedef struct %s \{\n(?P<members>.*?)^\} %s;"
MEMBER = re.compile(r"/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*(?P<declaration>[^;/[]+);", re.DOTALL)

# What a comment says of a parameter, and the place where: file and line.
Description = namedtuple("Description", "attributes text is_output place")


def description(attributes, text, is_output, extents, place):
    """What a comment says in brackets and behind them; brackets that are open, or stand behind a word, are not read as attributes."""
    found, plain = parsed(attributes, extents, place), " ".join(text.split())
    refuse(place, {f"attributes must stand between brackets behind the name: {plain}": ASTRAY.search(plain)})
    return Description(found, plain, is_output, place)


@dataclass
class Parameter:
    """A parameter of a C function, or a member of a struct argument."""

    name: str
    type: str  # type of the value, or of the elements of a pointer: "double", "size_t", "pw85_motion"
    pointer: bool
    const: bool  # whether it is a pointer to const
    length: int | None  # the length in the declaration, if there is one
    outer: bool  # whether it is a pointer to a pointer, by which the function returns a new handle
    text: str  # its sentence, or the sentence of the parameter that it is like
    attributes: Attributes
    place: str  # where it is described: file and line
    is_count: bool = False  # whether it is the number of rows of other parameters

    @property
    def shape(self):
        """Extents: numbers, and names of other parameters; empty for one number."""
        return self.attributes.shape

    @property
    def nullable(self):
        return bool({"optional", "optional if not needed"} & self.attributes.words)

    @property
    def rows(self):
        """The name of the number of rows; empty where all extents are numbers."""
        return next((extent for extent in self.shape[:1] if isinstance(extent, str) and extent != PACKED), "")

    @property
    def row_shape(self):
        """Extents of a row where there are rows."""
        return self.shape[bool(self.rows) :]

    @property
    def size(self):
        """The number of numbers, in a row where there are rows."""
        return prod(self.row_shape)

    def with_shape(self, shape):
        return replace(self, attributes=replace(self.attributes, shape=shape))

    def is_handle(self):
        """Whether it is a pointer to an object that the library owns, or one that the library does not read."""
        return self.pointer and self.type in ("void", *OBJECTS, *CALLBACKS)

    def is_struct(self):
        """Whether it is a struct, whose members are arguments."""
        return self.pointer and self.type in STRUCTS

    def is_output(self):
        return self.pointer and not self.const and not self.is_handle()

    def is_truth(self):
        """Whether it is an integer, or a byte in many rows, that is a truth value."""
        return self.type in ("int", "unsigned char") and self.name in TRUTHS

    def is_returned(self):
        """Whether the function gives one row of numbers or a new object by it."""
        return self.outer or (self.is_output() and not any(isinstance(extent, str) for extent in self.shape))

    def value_on_error(self):
        """What an output is on error; empty if it stays as it is."""
        return self.attributes.on_error or ("NaN" if self.type == "double" and self.is_returned() else "")

    def members(self):
        """The members of the C++ result that it receives."""
        return self.attributes.members or (self.name,)

    def member_names(self):
        return {one.name for one in members(self.type)} if self.is_struct() else set()


def parameter(written, said, own):
    """A parameter or member. Extents of another function's parameter count where they are as many numbers as the declaration says."""
    match, shape = PARAMETER.fullmatch(written), said.attributes.shape
    refuse(own.place, {f"of no type in TYPES of api/parameters.py: {written}": match is None or match["type"] not in TYPES})
    length = int(match["length"]) if match["length"] else None
    if length is not None and not (shape and (own.attributes.shape or prod(shape) == length)):
        shape = (length,)
    one = Parameter(match["name"], match["type"], "*" in match["pointers"] or length is not None, bool(match["const"]), length,
                    "**" in match["pointers"], said.text, replace(said.attributes, shape=shape), own.place)  # fmt: skip
    refuse(own.place, own.attributes.misfits(one, own.is_output))
    return one


def with_counts(listed):
    """The parameters, with marks at those that count rows of others."""
    listed = list(listed)
    counts = {one.rows for one in listed}
    return [replace(one, is_count=one.type == "size_t" and not one.pointer and one.name in counts) for one in listed]


def counts_of(declared):
    """The names of numbers of rows among declarations."""
    return [match[1] for one in declared if (match := re.fullmatch(r"(?:size_t|int) (\w+)", one))]


@of_texts
def members(struct):
    """The members of a struct argument, except for those that are arrays."""
    header = "pw85_systems.h"
    text = text_of(header)
    body = re.search(STRUCT % (struct, struct), text, re.DOTALL | re.MULTILINE)
    place = line_of(header, text, text.find(f"struct {struct}"))
    refuse(place, {f"no struct {struct} that ends with its name": body is None})
    found = [*MEMBER.finditer(text, *body.span("members"))]
    listed, extents = [], counts_of(match["declaration"] for match in found)
    for match in found:
        place = f"{line_of(header, text, match.start())}: {struct}, {match['declaration']}"
        comment = re.fullmatch(r"\s*(?:\[([^\]]*)\])?(.*)", re.sub(r"\n *\*", " ", match["comment"]), re.DOTALL)
        said = description(comment[1], comment[2], False, extents, place)
        listed.append(parameter(match["declaration"], said, said))
        refuse(place, {"two members of one name": listed[-1].name in [one.name for one in listed[:-1]]})
    return with_counts(listed)
