# SPDX-License-Identifier: BSD-3-Clause
"""The functions of pw85/pw85.hpp for doubles that call the compiled library: include/pw85/linked.hpp.

A template of pw85.hpp has such a function for each function of pw85.h of its name, in space and in the plane (`_2d`), if this gives out
every member of the result. The inputs are those of the template, in order; each output receives the members of the result that its
description names. Of an overlap the library does not give out the tier, which is then OverlapTier::unknown.
api/committed.py writes the header or compares it.
"""

import re
import textwrap
from functools import cache

from declarations import INCLUDE, c_functions, functions, parameters
from cpp_calls import WIDTH, wrapped

HEADER = INCLUDE / "pw85/linked.hpp"
TEMPLATES = "pw85/pw85.hpp"
STRUCT = re.compile(r"^(?:template <[^>]*> )?struct (\w+) \{\n(.*?)^\};", re.MULTILINE | re.DOTALL)
DETAIL = re.compile(r"^namespace pw85::detail \{$.*?^\} // namespace pw85::detail$", re.MULTILINE | re.DOTALL)
MEMBERS = re.compile(r"^    (?!static |using )[\w:<>, ]+? (\w+(?:, \w+)*);", re.MULTILINE)
NOT_GIVEN_OUT = {"Overlap": ("tier",)}

OTHERS = (
    "Calls with other numbers take the templates, and so do these functions with doubles, of which the C API leaves out a part of the "
    "result or which constant expressions call:"
)
BEGIN = """\
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions of pw85/pw85.hpp for doubles, computed by the compiled library (link with pw85).
///
///     #include <pw85/linked.hpp>
///     auto const [overlap, tier, status] = pw85::overlap(r12, q1, q2); // calls pw85_overlap()
///
/// Names, arguments, results and contracts are those of pw85.hpp, which this header includes. A
/// call with doubles takes the function of this header, since it is not a template: the solver is
/// not compiled again, and the library computes with the instruction set of the processor.
///
{others}
///
/// The functions have external linkage: exported inline functions of modules may call them. They
/// are always inlined: no unit runs the code of another one. They are not for device code.

// Made from pw85.hpp and pw85.h by api/committed.py.
// clang-format off
#ifndef PW85_LINKED_HPP_INCLUDED
#define PW85_LINKED_HPP_INCLUDED

#include <pw85.h>

#include <pw85/pw85.hpp>

#define PW85_LINKED [[gnu::always_inline]] inline

namespace pw85 {{

namespace detail::linked {{

// Inputs and outputs as arguments of the C API.

PW85_LINKED double in(double x) noexcept {{ return x; }}

PW85_LINKED int in(int x) noexcept {{ return x; }}

template <int D> PW85_LINKED double const *in(Vector<double, D> const &v) noexcept
{{
    return v.coordinates;
}}

template <int D> PW85_LINKED double const *in(SymmetricMatrix<double, D> const &m) noexcept
{{
    return m.entries;
}}

template <int D> PW85_LINKED double const *in(Factor<double, D> const &s) noexcept
{{
    return s.entries;
}}

template <class Number> PW85_LINKED Number *out(Number &x) noexcept {{ return &x; }}

template <int D> PW85_LINKED double *out(Vector<double, D> &v) noexcept {{ return v.coordinates; }}

template <int D> PW85_LINKED double *out(SymmetricMatrix<double, D> &m) noexcept
{{
    return m.entries;
}}

template <int D> PW85_LINKED double *out(Factor<double, D> &s) noexcept {{ return s.entries; }}

template <std::size_t N> PW85_LINKED double *out(double (&rows)[N][N]) noexcept
{{
    return &rows[0][0];
}}

/// A motion, for as long as the call lasts.
struct MotionInC {{
    pw85_motion motion;

    [[gnu::always_inline]] explicit MotionInC(Motion<double, 3> const &m) noexcept
        : motion{{{{m.velocity[0], m.velocity[1], m.velocity[2]}},
                 {{m.angular_velocity[0], m.angular_velocity[1], m.angular_velocity[2]}},
                 m.growth}}
    {{
    }}

    [[gnu::always_inline]] operator pw85_motion const *() const noexcept {{ return &motion; }}
}};

PW85_LINKED MotionInC in(Motion<double, 3> const &m) noexcept {{ return MotionInC(m); }}

}} // namespace detail::linked

"""
END = """} // namespace pw85

#undef PW85_LINKED

#endif
"""


@cache
def members():
    """The names of the members of each result, by its definition; the last one is the status."""
    found = {}
    for path in sorted((INCLUDE / "pw85").glob("*/*.hpp")):
        text = DETAIL.sub("", re.sub(r"//.*", "", path.read_text(encoding="utf-8")))
        for name, body in STRUCT.findall(text):
            plain = re.sub(r"\[[^\]]*\]", "", body)
            found[name] = [name for listed in MEMBERS.findall(plain) for name in listed.split(", ")]
    return found


def in_doubles(text, dimension):
    """A type or parameter of a template, for doubles."""
    text = re.sub(r"\bT\b", "double", text).removeprefix("constexpr ").removeprefix("inline ")
    return re.sub(r"\bD\b", str(dimension), text)


def relatives():
    """The templates, each with a function of C and the dimension in which this computes."""
    for template in functions(TEMPLATES):
        for suffix, dimension in (("", 3), ("_2d", 2)):
            function = c_functions().get(f"pw85_{template.name}{suffix}")
            if function and is_of_dimension(template, dimension) and is_complete(template, function):
                yield template, function, dimension


def is_of_dimension(template, dimension):
    """Whether the template takes vectors and forms of this dimension. Those of the plane overload those in space."""
    fixed = {found for one in template.parameters for found in re.findall(r"<T, ([23])>", one)}
    return not fixed or fixed == {str(dimension)}


def result_of(template):
    return re.search(r"(\w+)(?:<[^>]*>)?$", template.type)[1]


def given_out(template):
    name = result_of(template)
    return [one for one in members()[name] if one not in ("status", *NOT_GIVEN_OUT.get(name, ()))]


def is_complete(template, function):
    """Whether the function of C has the same inputs and gives out all members of the result, of which one array takes several only if
    they are numbers. What constant expressions can call is not replaced."""
    listed = parameters(function)
    inputs, outputs = [one for one in listed if not one.is_output()], [one for one in listed if one.is_output()]
    members_of_c = {name for one in outputs for name in one.members()}
    same = len(inputs) == len(template.parameters) and members_of_c == set(given_out(template))
    return same and all(len(one.members()) in (1, one.length) for one in outputs) and not template.type.startswith("constexpr ")


def outputs_in_c(function):
    """Arguments for the outputs, of which one may take several members, and statements before and after the call."""
    arguments, before, after = [], [], []
    for one in (one for one in parameters(function) if one.is_output()):
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


def definition(template, function, dimension):
    written = [in_doubles(one, dimension) for one in template.parameters]
    inputs = [f"in({name})" for name in template.parameter_names()]
    outputs, before, after = outputs_in_c(function)
    result = in_doubles(template.type, dimension)
    unknown = [f"    result.{name} = OverlapTier::unknown;" for name in NOT_GIVEN_OUT.get(result_of(template), ())]
    yield f"/// Computes {template.name}() by {function.name}()."
    yield from wrapped(f"PW85_LINKED {result} {template.name}(", written, ") noexcept")
    yield from ("{", "    using namespace detail::linked;", f"    {result} result;", *before)
    yield from wrapped(f"    int const status = {function.name}(", [*inputs, *outputs], ");")
    yield "    result.status = static_cast<StatusCode>(status);"
    yield from (*after, *unknown, "    return result;", "}", "")


def header():
    listed = list(relatives())
    done = {template.name for template, _, _ in listed}
    rest = ", ".join(dict.fromkeys(f"{one.name}()" for one in functions(TEMPLATES) if one.name not in done))
    others = textwrap.fill(f"{OTHERS} {rest}.", WIDTH, initial_indent="/// ", subsequent_indent="/// ")
    lines = [line for one in listed for line in definition(*one)]
    return BEGIN.format(others=others) + "".join(f"{line}\n" for line in lines) + END


def files():
    """The text of the header by its path."""
    return {HEADER: header()}
