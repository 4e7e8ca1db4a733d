# SPDX-License-Identifier: BSD-3-Clause
"""The made parts of the C++ headers of many rows, systems and objects: functions and members that call those of C (cpp_calls.py).

Such a part begins with a line that says what is in it:

    // Made by api/committed.py: rows of pw85_batch.h                   all functions that take n rows, by sections
    // Made by api/committed.py: pairs of pw85_systems.h                those that take a list of pairs, and have a row for each
    // Made by api/committed.py: functions of Periodic cells            the others of a section, or of a header, with a status
    // Made by api/committed.py: members of pw85_hard_ellipsoids        the functions on an object, as members of its class

A function that the text by hand calls is not made. The tables say what does not follow from the declarations.
"""

import re

from cpp import by_hand, is_member, is_of_list, is_of_rows, name_in_cpp, structs
from cpp_calls import Call
from declarations import c_functions, functions, sections
from layout import arguments, renewed
from public_headers import CPP_HEADERS, SYSTEMS, text_of
from refusals import refuse

# The names of members that are not those of C, and functions whose call with null is a member that is written by hand.
NAMES = {"pw85_hard_ellipsoids_try": "try_placement"}
OVERLOADED = ("pw85_hard_ellipsoids_set_law", "pw85_hard_ellipsoids_set_potential", "pw85_hard_ellipsoids_chain")
# Types of parameters in C++, with defaults, and structs that have several parameters as members.
CHANGE = {"change": "CellChange = CellChange::isotropic"}
TYPES = {
    "pw85_hard_ellipsoids_volume_moves": CHANGE,
    "pw85_hard_ellipsoids_tune": {"pressure": "double = 0.0"} | CHANGE,
    "pw85_hard_ellipsoids_set_fractions": {"fractions": "TrialFractions"},
    "pw85_hard_ellipsoids_set_steps": {"steps": "TrialSteps"},
    "pw85_neighbors_create": {"options": "NeighborOptions"},
    "pw85_neighbors_check": {"options": "NeighborOptions"},
    "pw85_contact_forces_pairs": {"derivatives": "DerivativeSpans"},
}
# Types of what is returned instead of outputs.
RESULTS = {
    "pw85_hard_ellipsoids_dimensions": "int",
    "pw85_hard_ellipsoids_steps": "TrialSteps",
    "pw85_hard_ellipsoids_counts": "TrialCounts",
    "pw85_random_addition_state": "AdditionState",
    "pw85_cell_reduce": "ReducedCell",
    "pw85_mesh_contact": "MeshContact",
    "pw85_mesh_overlap": "ShapeOverlap",
    "pw85_mesh_distance": "MeshDistance",
}


def called(text):
    return set(re.findall(r"\bpw85_\w+(?=[(,])", re.sub(r"//.*", "", text)))


def call_of(function):
    """The call of a function, whose outputs are in the struct of spans that has no other members, if there is one."""
    outputs = {name for one in function.outputs for name in one.members()}
    spans = [name for name, members in structs().items() if name.endswith("Spans") and outputs >= {*members}]
    types = {"out": spans[0]} if spans else {}
    return Call(function, types | TYPES.get(function.name, {}), is_member(function), RESULTS.get(function.name))


def functions_of(place, said):
    """The functions of a header, or of a section of those of systems, that are neither members nor of pairs."""
    listed = [section for header in SYSTEMS for section in sections(header) if said in (header, section.title)]
    refuse(place, {f"no such header or section: {said}": not listed})
    return "\n".join(call_of(one).text(name_in_cpp(one)) for section in listed for one in made_alone(section.functions)
                     if not (is_member(one) or is_of_list(one)))  # fmt: skip


def members_of(place, said):
    made = [one for one in made_alone(functions(*SYSTEMS)) if is_member(one) and one.parameters[0].type == said]
    refuse(place, {f"no object has members: {said}": not made})
    return "\n".join(call_of(one).text(NAMES.get(one.name, one.name.removeprefix(f"{said}_")), "    ") for one in made)


def made_alone(listed):
    """Those of some functions that are made, and have a status or a size."""
    by_hands = {name for header in CPP_HEADERS for name in called(by_hand(header))} - {*OVERLOADED}
    return [one for one in listed if one.type in ("int", "size_t") and one.name not in by_hands]


def rows_of(place, said):
    """The functions of a header that pass all arrays to detail::call_rows() or call_pairs(), which compare sizes, by its sections."""
    texts = []
    for section in sections(said):
        listed = [call_of_all(one) for one in section.functions if is_of_rows(one) or is_of_list(one)]
        texts += [f"/// @name {section.title}\n/// @{{\n", *listed, "/// @}\n"] if listed else []
    return "\n".join(texts)


def call_of_all(function):
    call, caller = call_of(function), "call_pairs" if is_of_list(function) else "call_rows"
    places = [call.place(one) for one in function.parameters if one.name != "n"]
    body = arguments(f"    return detail::{caller}(", [function.name, *places], ");").removeprefix("    ").split("\n    ")
    return call.text(name_in_cpp(function), body=body)


MAKERS = {"rows": rows_of, "pairs": rows_of, "functions": functions_of, "members": members_of}


def files():
    """The headers that have made parts. Each function on systems and objects is in one of them."""
    refuse("api/classes.py", {f"no function {name}()": name not in c_functions() for name in (*NAMES, *OVERLOADED, *TYPES, *RESULTS)})
    made = {f"include/{name}": renewed(name, MAKERS) for name in CPP_HEADERS if "api/committed.py:" in text_of(name)}
    known = {name for text in (*made.values(), *map(by_hand, CPP_HEADERS)) for name in called(text)}
    for one in functions(*SYSTEMS):
        refuse(one.place, {"in no made part of a header of C++": one.name not in known})
    return made
