# SPDX-License-Identifier: BSD-3-Clause
"""The functions of pw85/pw85.hpp for doubles that call the compiled library: the made parts of include/pw85/linked.hpp.

A template of pw85.hpp has such a function for each function of pw85.h of its name, in space and in the plane (`_2d`), if this gives out
every member of the result. The inputs are those of the template, in order; each output receives the members of the result that its
description names. Of an overlap the library does not give out the tier, which is then OverlapTier::unknown.
"""

import re

from cpp import by_hand, structs
from cpp_calls import Call
from declarations import c_functions, functions
from layout import filled, renewed
from refusals import refuse
from shims import template_of

HEADER, TEMPLATES = "pw85/linked.hpp", "pw85/pw85.hpp"
NOT_GIVEN_OUT = {"Overlap": ("tier",)}
OTHERS = (
    "Calls with other numbers take the templates, and so do these functions with doubles, of which the C API leaves out a part of the "
    "result or which constant expressions call:"
)


def result_of(template, dimension):
    kind = re.search(r"\w+(?:<[^>]*>)?$", template.type)[0]
    return kind.replace("<T", "<double").replace(", D>", f", {dimension}>")


def is_relative(template, function):
    """Whether a function of C has the dimension and the inputs of a template, and gives out all members of the result but the status,
    and all of its members that are results (`relative.direction1`). What constant expressions can call is not replaced."""
    name, given = result_of(template, 0).partition("<")[0], {}
    for one in function.outputs:
        for first, _, inner in (member.partition(".") for member in one.members()):
            refuse(one.place, {f"{name} has no member {first}": first not in structs().get(name, [first])})
            given.setdefault(first, set()).add(inner)
    fixed = {found for one in template.written for found in re.findall(r"<T, ([23])>", one)}
    if template.type.startswith("constexpr ") or fixed not in (set(), {str(function.dimension)}):
        return False
    refuse(template.place, {f"no struct {name} in the headers of C++": name not in structs()})
    whole = [{""}, *({*members} - {"status"} for members in structs().values())]
    has_all = {*given} == {*structs()[name]} - {"status", *NOT_GIVEN_OUT.get(name, ())} and all(inner in whole for inner in given.values())
    return len(function.inputs) == len(template.written) and has_all


def relatives():
    """The templates, each with a function of C."""
    for template in functions(TEMPLATES):
        named = (c_functions().get(f"pw85_{template.name}{suffix}") for suffix in ("", "_2d", "_geometry", "_geometry_2d"))
        yield from ((template, function) for function in named
                    if function and template_of(function) == template.name and is_relative(template, function))


def definition(template, function):
    call = Call(function, {}, result=result_of(template, function.dimension), out="detail::out")
    call.after += [f"found.{name} = OverlapTier::unknown;" for name in NOT_GIVEN_OUT.get(call.result, ())]
    inner = dict.fromkeys(name.partition(".")[0] for one in function.outputs for name in one.members() if "." in name)
    call.after += [f"found.{name}.status = found.status;" for name in inner]
    return call.text(template.name, head="PW85_LINKED", comment=[f"Computes {template.name}() by {function.name}()."])


def functions_of(place, said):
    return "\n".join(definition(*one) for one in relatives())


def templates_of(place, said):
    """The names of templates that no function replaces."""
    done = {template.name for template, _ in relatives()} | {*re.findall(r"^PW85_LINKED .*?(\w+)\(", by_hand(HEADER), re.MULTILINE)}
    rest = ", ".join(dict.fromkeys(f"{one.name}()" for one in functions(TEMPLATES) if one.name not in done))
    return "/// @file\n" + filled(f"{OTHERS} {rest}.", first="/// ") + "\n"


def files():
    makers = {"functions": functions_of, "templates": templates_of}
    return {f"include/{HEADER}": renewed(HEADER, makers)}
