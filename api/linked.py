# SPDX-License-Identifier: BSD-3-Clause
"""The functions of pw85/pw85.hpp for doubles that call the compiled library: include/pw85/linked.hpp, of the template linked.hpp.in.

A template of pw85.hpp has such a function for each function of pw85.h of its name, in space and in the plane (`_2d`), if this gives out
every member of the result. The inputs are those of the template, in order; each output receives the members of the result that its
description names. Of an overlap the library does not give out the tier, which is then OverlapTier::unknown.
"""

import re

import layout
from cpp import structs
from declarations import INCLUDE, SOURCE, c_functions, functions

TEMPLATES = "pw85/pw85.hpp"
NOT_GIVEN_OUT = {"Overlap": ("tier",)}
OTHERS = (
    "Calls with other numbers take the templates, and so do these functions with doubles, of which the C API leaves out a part of the "
    "result or which constant expressions call:"
)


def in_doubles(text, dimension):
    """A type or parameter of a template, for doubles."""
    text = re.sub(r"\bT\b", "double", text).removeprefix("constexpr ").removeprefix("inline ")
    return re.sub(r"\bD\b", str(dimension), text)


def result_of(template):
    return re.search(r"(\w+)(?:<[^>]*>)?$", template.type)[1]


def is_relative(template, function):
    """Whether a function of C has the dimension and the inputs of a template, and gives out all members of the result, of which one
    array takes several only if they are numbers. What constant expressions can call is not replaced."""
    name, outputs = result_of(template), function.outputs
    for one in outputs if name in structs() else ():
        if unknown := {member.partition(".")[0] for member in one.members()} - {*structs()[name]}:
            raise ValueError(f"{function.descriptions[one.name].place}: {name} has no member {min(unknown)}")
    fixed = {found for one in template.written for found in re.findall(r"<T, ([23])>", one)}
    if template.type.startswith("constexpr ") or fixed not in (set(), {str(function.dimension)}):
        return False
    needed = {*structs()[name]} - {"status", *NOT_GIVEN_OUT.get(name, ())}
    same = len(function.inputs) == len(template.written) and {name for one in outputs for name in one.members()} == needed
    return same and all(len(one.members()) in (1, one.length) for one in outputs)


def relatives():
    """The templates, each with a function of C."""
    for template in functions(TEMPLATES):
        both = (c_functions().get(f"pw85_{template.name}{suffix}") for suffix in ("", "_2d"))
        yield from ((template, function) for function in both if function and is_relative(template, function))


def outputs_in_c(function):
    """Arguments for the outputs, of which one may take several members, and statements before and after the call."""
    arguments, before, after = [], [], []
    for one in function.outputs:
        results = [f"result.{name}" for name in one.members()]
        if one.type == "int" and one.name != "sign":
            before, after = ["    int answer = 0;"], [f"    {results[0]} = answer == 1;"]
            arguments.append("&answer")
        elif len(results) > 1:
            before, after = [f"    double numbers[{len(results)}];"], [f"    {name} = numbers[{i}];" for i, name in enumerate(results)]
            arguments.append("numbers")
        else:
            arguments.append(f"out({results[0]})")
    return arguments, before, after


def definition(template, function):
    written = [in_doubles(one, function.dimension) for one in template.written]
    inputs = [f"in({name})" for name in template.parameter_names()]
    outputs, before, after = outputs_in_c(function)
    result = in_doubles(template.type, function.dimension)
    unknown = [f"    result.{name} = OverlapTier::unknown;" for name in NOT_GIVEN_OUT.get(result_of(template), ())]
    return [
        f"/// Computes {template.name}() by {function.name}().",
        layout.arguments(f"PW85_LINKED {result} {template.name}(", written, ") noexcept"),
        *("{", "    using namespace detail::linked;", f"    {result} result;", *before),
        layout.arguments(f"    int const status = {function.name}(", [*inputs, *outputs], ");"),
        *("    result.status = static_cast<StatusCode>(status);", *after, *unknown, "    return result;", "}", ""),
    ]


def files():
    """The text of the header by its path."""
    listed = list(relatives())
    done = {template.name for template, _ in listed}
    rest = ", ".join(dict.fromkeys(f"{one.name}()" for one in functions(TEMPLATES) if one.name not in done))
    made = {"others": layout.wrapped(f"{OTHERS} {rest}.", first="/// "), "functions": [line for one in listed for line in definition(*one)]}
    return {INCLUDE / "pw85/linked.hpp": layout.insert(SOURCE / "api/linked.hpp.in", "//@", made)}
