# SPDX-License-Identifier: BSD-3-Clause
"""Valid arguments of the functions of one row, for the examples of the languages."""

from refusals import entry_of

# By their names, in three dimensions.
VALUES = {
    "r12": [3, 0.5, 0], "q": [9, 0, 0, 4, 0, 1], "q1": [9, 0, 0, 4, 0, 1], "q2": [0.25, 0, 0, 0.25, 0, 0.25], "semi_axes": [3, 2, 1],
    "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "s1": [[3, 0, 0], [0, 2, 0], [0, 0, 1]], "s2": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    "quaternion": [0.9, 0.1, 0.3, 0.2], "lambda": 0.5, "a": 3, "b": 2, "c": 1, "angle": 0.5, "n": [0, 0, 1], "mu2": 1, "t_max": 10,
    "velocity": [-1, 0, 0], "second_moments": [9, 0, 0, 4, 0, 1], "offset": 5, "curvature": 0.5, "curvatures": [1, 2], "radius": 99,
    "center": [8, 8, 8], "lower": [2, -1, -1], "upper": [4, 1, 1], "origin": [-5, 0, 0], "r": [4, 2, 1], "direction": [1, 0, 0],
    "normal": [1, 0, 0], "start": [1, 0, 0], "axis": [1, 0, 0], "end1": [2, 2, 1], "end2": [2, -2, 1], "vertex1": [2, 2, 1],
    "vertex2": [2, -2, 1], "vertex3": [2, 0, 4], "motion1": [0, 0, 0, 0, 0, 0, 0],
    "motion2": [-1, 0, 0, 0, 0, 0, 0],
}  # fmt: skip
R12 = {"distance": [5, 0.5, 0], "gap": [0.5, 0.25, 0]}  # by the first word of the function
PLANE = (0, 1, 3)  # the entries of a symmetric matrix that it has in the plane


def example_value(function, one, count):
    """Numbers, nested as rows of a matrix, of an argument whose first extent is count; a number if that is 0."""
    name = one.name if one.name in VALUES else one.name.removesuffix("s")
    value = entry_of(VALUES, name, "VALUES of api/examples.py", one.place)
    value = R12.get(function.name.split("_")[1], value) if name == "r12" else value
    if not count or len(value) == count:
        return value
    return [value[k] for k in PLANE] if len(value) == 6 else value[:count]
