# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the C API of one row that follow from their declarations, in src/c_api/.

There is a file for each question of pw85.h, pw85_grains.h and pw85_shapes.h. Its functions check pointers, set the floating-point
environment, load the inputs, call the template of the same name (or the kernel of the chosen instruction set), store the members of its
result by their names, and record the cause of a refusal (src/base/last_error.hpp). A function that a file of src/c_api/ defines by hand is
not made. api/batch.py makes the functions of many rows.
"""

import re

from cpp import homes, name_in_cpp
from declarations import functions, sections
from layout import WIDTH, arguments
from public_headers import ONE_ROW, SOURCE, of_texts, source_text
from refusals import refuse

FOLDER = "src/c_api"
# The files with their titles. A file has few questions, so that programs with the static library get what they call.
FILES = {
    "forms": "Quadratic forms",
    "contact": "Contact of two ellipsoids",
    "factored": "Ellipsoids by their factors",
    "rounded": "The contact function, correctly rounded",
    "condition": "Condition numbers",
    "overlap": "Overlaps",
    "compare": "Comparisons",
    "witness": "Witnesses",
    "contains": "Containment, yes or no",
    "containment": "Factors of containment",
    "volumes": "Volumes and intersections",
    "two_dimensions": "Two dimensions",
    "distance": "Distance",
    "gap_inside": "Gaps of contained ellipsoids",
    "first_contact": "First contacts",
    "passage": "Closest passages and free paths",
    "grains": "Curvature and contact of grains",
    "bodies": "Surface and inertia of bodies",
    "walls": "Walls, points and lines",
    "shapes": "Shapes",
    "solids": "Distances to shapes",
    "contact_function": "The contact function by Brent's method",
    "others": "Functions of other sections",
}
# The files of functions, sections and headers.
FILE_OF = {title: name for name, title in FILES.items()} | {f"pw85_{name}": name for name in FILES} | {
    "pw85_contact_rounded": "rounded", "pw85_overlap_witness": "witness", "Time": "passage", "pw85_shapes.h": "solids"}  # fmt: skip
MARK = "by api/committed.py"
DEFINITION = re.compile(r"^(?:int|void|double|char const \*) ?(pw85\w+)\(", re.MULTILINE)
# Those that are compiled per instruction set: the list of src/simd/one_pair.hpp.
DISPATCHED = re.compile(r"^ +X\((\w+)\)", re.MULTILINE)
HEAD = """\
// SPDX-License-Identifier: BSD-3-Clause
// The C API{what}.
//
// Made from {sources} by api/committed.py.
// clang-format off
{includes}

{namespaces}
"""
SOURCES = "pw85.h, pw85_grains.h and pw85_shapes.h"


def by_hand():
    texts = (path.read_text(encoding="utf-8") for path in (SOURCE / FOLDER).glob("*.cpp"))
    return {name for text in texts if MARK not in text for name in DEFINITION.findall(text)}


def loaded(function, one):
    """An input as an argument of the template."""
    if not one.pointer:
        return one.name
    if one.type == "pw85_motion":
        return f"load_motion(*{one.name})"
    if re.fullmatch(r"q\d?|second_moments", one.name):
        return f"load_matrix<{function.dimension}>({one.name})"
    return f"load_factor<3>({one.name})" if one.length == 9 else f"load_vector<{one.length}>({one.name})"


def stored(one):
    """An output as arguments of put(): the members of the result that it receives, each with a pointer."""
    width = one.size // len(one.members())
    for i, member in enumerate(one.members()):
        place = f"part({one.name}, {i * width})" if one.nullable else f"{one.name} + {i * width}"
        yield from (f"result.{member}", place if i else one.name)


def limits(one):
    """The limits of an input, as an expression; empty if it must be finite only."""
    names = [limit.name for limit in one.attributes.limits if limit.name]
    names += ["independent"] if re.fullmatch(r"s\d?", one.name) and one.length == 9 else []
    names += ["optional"] if one.nullable else []
    return " | ".join(f"limit::{name}" for name in names)


def described(one, places=None):
    """A parameter for the check of arguments or the record of a refusal. `places` are those of members of structs."""
    place, rows = ((places or {}).get(name, name) for name in (one.name, one.rows))
    is_read = not one.is_output() and one.type in ("double", "" if rows else "pw85_motion")
    kind = "" if not rows else "::rows" if is_read else "::array"
    size = "7" if one.type == "pw85_motion" else str(one.size)
    checked = [size if one.pointer else "", limits(one)] if is_read else []
    return f"Argument{kind}({', '.join(filter(None, [chr(34) + one.name + chr(34), place, rows, *checked]))})"


def checks(function):
    """Statements that refuse null pointers. Answers and numbers are marked before anything else can fail."""
    answers, numbers = ([one for one in function.outputs if (one.type == "int") is kind] for kind in (True, False))
    for one in function.parameters:
        is_wrong = one.nullable and (one not in numbers or "optional" not in one.attributes.words)
        refuse(one.place, {"only outputs of doubles can be optional in a function of one row": is_wrong})
    needed = [one.name for one in function.parameters if one.pointer and one not in answers and not (one.is_output() and one.nullable)]
    condition = f"    if (any_null({', '.join(needed)}))"
    marked = [f"{one.name}, {one.length or 1}" for one in numbers]
    yield from (f"    store_nan({numbers});" for numbers in marked if answers)
    for one in answers:
        refuse(one.place, {"no value on error, such as -1 on error": not one.attributes.on_error})
        yield from (f"    if (any_null({one.name})) return refused(PW85_EINVAL);", f"    *{one.name} = {one.attributes.on_error};")
    status = "PW85_EINVAL" if answers else f"null_pointer({', '.join(marked)})"
    line = f"{condition} return refused({status});"
    yield line if len(line) <= WIDTH else f"{condition}\n{arguments('        return refused(null_pointer(', marked, '));')}"


def template_of(function):
    """The template of pw85.hpp that it calls: that of its name, or of its name without `_geometry`, whose result has all of the contact."""
    name = name_in_cpp(function)
    return name if name in [one.name for one in functions("pw85/pw85.hpp")] else name.removesuffix("_geometry")


def body(function, of_kernels):
    name = name_in_cpp(function)
    if function.name in of_kernels:
        passed = [f"PW85_OF_PAIR(kernels::chosen(), {name})", *function.parameter_names()]
        return arguments("    return checked(in_default_environment(", passed, "), refused);")
    template = template_of(function)
    called = arguments(f"        auto const result = pw85::{template}(", [loaded(function, one) for one in function.inputs], ");")
    outputs = [text for one in function.outputs for text in stored(one)]
    put = arguments("        return put(", ["result.status", *outputs], ");")
    return f"    int const status = in_default_environment([&] {{\n{called}\n{put}\n    }});\n    return checked(status, refused);"


def of_one_row(function, of_kernels):
    """The function, and before it the one that records the cause of a refusal. This is not inlined, so that calls that succeed do not
    make room for what it needs."""
    kept = {one.name: one for one in function.parameters if not one.is_output() or not one.nullable}
    written = [text for text, one in zip(function.written, function.parameters) if one.name in kept]
    return "\n".join([
        "", arguments(f"[[gnu::cold, gnu::noinline]] static int refuse_{function.plain}(", ["int status", *written], ") noexcept"),
        "{", arguments("    return refuse_call(", ["status", f'"{function.name}"', *map(described, kept.values())], ");"), "}",
        "", arguments(f"int {function.name}(", function.written, ")"),
        "{", "    auto const refused = [&](int status) PW85_IN_COLD_PATH {",
        arguments(f"        return refuse_{function.plain}(", ["status", *kept], ");"), "    };",
        *checks(function), body(function, of_kernels), "}", "",
    ])  # fmt: skip


def homes_of(function):
    """The headers of the template that it calls."""
    name = template_of(function)
    is_declared, found = name in [one.name for one in functions("pw85/pw85.hpp")], homes(name)
    refuse(function.place, {f"pw85/pw85.hpp does not declare {name}(), which it calls": not is_declared,
                            f"no header of include/pw85/ defines {name}(), which it calls": not found})  # fmt: skip
    return found


def one_row_file(title, listed):
    of_kernels = {f"pw85_{name}" for name in DISPATCHED.findall(source_text("src/simd/one_pair.hpp"))}
    own = ["../base/c_arrays.hpp", "../base/floating_point_environment.hpp", "../base/last_error.hpp"]
    own += ["../simd/one_pair.hpp"] if any(one.name in of_kernels for one in listed) else []
    headers = sorted({home for one in listed if one.name not in of_kernels for home in homes_of(one)})
    includes = ["#include <pw85.h>\n", *(f"#include <{header}>" for header in headers), *[""] * bool(headers)]
    includes = "\n".join([*includes, *(f'#include "{header}"' for header in own)])
    namespaces = "using namespace pw85::detail;\nusing namespace pw85::detail::c_api;"
    head = HEAD.format(what=f": {title[0].lower()}{title[1:]}", sources=SOURCES, includes=includes, namespaces=namespaces)
    return head + "".join(of_one_row(function, of_kernels) for function in listed)


def file_of(function, section):
    """The file that has the function. What two-dimensional functions instantiate stands in one file."""
    if function.dimension == 2:
        return "two_dimensions"
    if function.name.endswith("_factored"):
        return "factored"
    return next((FILE_OF[key] for key in (function.name, section.title, function.header) if key in FILE_OF), "others")


@of_texts
def questions():
    """The files of all functions of one row, by their names."""
    return {one.name: file_of(one, section) for header in ONE_ROW for section in sections(header) for one in section.functions}


def files():
    listed, hands = {}, by_hand()
    for function in functions(*ONE_ROW):
        if function.name not in hands:
            listed.setdefault(questions()[function.name], []).append(function)
    return {f"{FOLDER}/{name}.cpp": one_row_file(FILES[name], own) for name, own in listed.items()}
