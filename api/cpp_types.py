# SPDX-License-Identifier: BSD-3-Clause
"""Types of C++ for the parameters of functions of C."""

import re
from functools import cache
from math import prod

from cpp_texts import FOLDER, TEMPLATES, is_of_plane

CLASSES = {"pw85_neighbors": "Neighbors", "pw85_mesh": "Mesh", "pw85_hard_ellipsoids": "HardEllipsoids"}
STRUCTS = {"pw85_pair_list": "PairList", "pw85_system": "Particles", "pw85_law": "Law"}
# What the rows of an array of double are, by their extents: in space, and in the plane.
ELEMENTS = {
    3: {
        (): "double",
        (3,): "Vector<double, 3>",
        (6,): "SymmetricMatrix<double, 3>",
        (4,): "Vector<double, 4>",
        (3, 3): "Factor<double, 3>",
    },
    2: {(): "double", (2,): "Vector<double, 2>", (3,): "SymmetricMatrix<double, 2>"},
}
ELEMENTS_OF_OTHERS = {
    ("int32_t", 2): "IndexPair", ("pw85_motion", 1): "Motion<double, 3>", ("pw85_wall", 1): "Wall", ("pw85_field", 1): "Field",
}  # fmt: skip
SHORT_NAMES = {
    "std::span<Vector<double, 3> const>": "Vectors",
    "std::span<SymmetricMatrix<double, 3> const>": "Forms",
    "std::span<Vector<double, 2> const>": "FlatVectors",
    "std::span<SymmetricMatrix<double, 2> const>": "FlatForms",
}
NUMBERS = {"size_t": "std::size_t", "int32_t": "std::int32_t", "int64_t": "std::int64_t"}


@cache
def structs():
    """The members of the structs of the arguments and results, by the names of the structs."""
    others = ("batch/values", "systems/values", "simulation/trials", "shapes/overlap_shapes")
    paths = [*(FOLDER / f"{name}.hpp" for name in others), *TEMPLATES.values()]
    text, found = "".join(path.read_text(encoding="utf-8") for path in paths), {}
    for name, body in re.findall(r"^struct (\w+) \{\n(.*?)^\};", text, re.MULTILINE | re.DOTALL):
        without = re.sub(r" = [^,;]*|///?.*|<[^;]*>", "", body)
        found[name] = [one for line in re.findall(r" ([\w, *]+);", without) for one in re.findall(r"(\w+)(?:,|$)", line)]
    return found


def row_of(function, one, extents):
    """The type of a row, or of an array of one row."""
    if one.type == "double":
        cell = {(3, 3): "Cell"} if function.header == "pw85_systems.h" else {}
        known = ELEMENTS[2 if is_of_plane(function.name) else 3] | cell
        return known.get(extents) or f"std::array<double, {prod(extents)}>"
    name = NUMBERS.get(one.type, one.type)
    return ELEMENTS_OF_OTHERS.get((one.type, prod(extents))) or (f"std::array<{name}, {prod(extents)}>" if extents else name)


def address(kind, name):
    """The pointer to the numbers of one row."""
    ends = {"Cell": ".front().coordinates", "Vector": ".coordinates", "SymmetricMatrix": ".entries"}
    return name + ends.get(kind.split("<")[0], ".data()")
