# SPDX-License-Identifier: BSD-3-Clause
"""Names of functions of C in C++, and what the C headers say, in the words of C++."""

import re
from functools import cache

from declarations import CPP_HEADERS, INCLUDE, SOURCE, c_functions, flattened, functions, parameters, referenced, statuses
from voice import limits_of

FOLDER = INCLUDE / "pw85"
ROWS_HEADERS = ("batch/rows", "systems/lists")  # made by api/spans.py
# Made by api/classes.py of these templates.
TEMPLATES = {name: SOURCE / f"api/{name.split('/')[1]}.hpp.in" for name in (
    "systems/neighbors", "systems/meshes", "systems/sums", "systems/periodic", "simulation/hard_ellipsoids")}  # fmt: skip


def has_rows(listed, extent):
    """Whether all arrays have as many rows."""
    return all(one.shape[:1] == (extent,) if one.pointer else one.type in ("double", "int") for one in listed)


def is_of_rows(function):
    return function.parameter_names()[:1] == ["n"] and has_rows(parameters(function)[1:], "n")


def is_of_list(function):
    listed = parameters(function)
    return [one.type for one in listed[:2]] == ["pw85_pair_list", "pw85_system"] and has_rows(listed[2:], "num_pairs")


def is_of_plane(name):
    return name.endswith("_2d")


def plain(name):
    """The name in C++ of a function of C."""
    return re.sub(r"^pw85_|_2d$", "", name)


@cache
def names_in_cpp():
    """The functions of C that C++ has, too, and their names there."""
    made = [f"pw85/{name}.hpp" for name in (*ROWS_HEADERS, *TEMPLATES)]
    known = {function.name for header in CPP_HEADERS if header not in made for function in functions(header)}
    templates = "".join(path.read_text(encoding="utf-8") for path in TEMPLATES.values())
    known |= set(re.findall(r"^(?:@function |static inline [\w:]+ )(\w+)", templates, re.MULTILINE))
    return {
        name: plain(name)
        for name, function in c_functions().items()
        if plain(name) in known or is_of_rows(function) or is_of_list(function)
    }


def in_cpp(text):
    """A sentence about C, with the names of C++."""
    text = re.sub(r"\b(pw85_\w+)\(\)", lambda match: f"{names_in_cpp().get(match[1], match[1])}()", text)
    return re.sub(r"#(PW85_\w+)", lambda match: f"Status::{statuses()[match[1]][0]}", text)


def returned(function):
    """What the comment of a function, or of one to which it refers, says of its status."""
    comments = (" ".join(other.comment.split()) for other in referenced(function, c_functions()))
    return next((found[1] for text in comments if (found := re.search(r"@return (.*?)(?= @|$)", text))), "the status")


def brief(function):
    text = re.sub(r"\bn (?=[a-z])", "many ", function.brief())
    if is_of_plane(function.name):
        text = text.replace("pairs", "pairs of ellipses")
    verb = "Computes " if re.match(r"\w+\(\)", text) else ""
    return f"{verb}{in_cpp(text)}: see {function.name}()."


def described(function, parameter):
    """What is said of a parameter, and what it has a row for."""
    text = "; ".join(filter(None, [in_cpp(parameter.text), *limits_of(parameter)]))
    if not (parameter.shape and isinstance(parameter.shape[0], str)):
        return text
    counts = next(one for one in flattened(function) if one.name == parameter.shape[0])
    of_row = counts.attributes.rows.replace("vertices", "vertex").removesuffix("s")
    row = f"one for each {of_row}{', or empty' if parameter.nullable else ''}"
    return f"{row}{': ' if parameter.text else '; '}{text}" if text else row
