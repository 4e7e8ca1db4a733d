# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the C API that follow from their declarations, in src/c_api/.

- For each question of pw85.h, pw85_grains.h and pw85_shapes.h a file with its functions of one row: they check pointers, set the
  floating-point environment, load the inputs, call the template of the same name (or the kernel of the chosen instruction set), store the
  members of its result by their names, and record the cause of a refusal (src/base/last_error.hpp).
- The files *_rows.cpp have the functions of many rows that have no lanes. They call the function of one row for each row, with an
  argument of src/rows/each_row.hpp for each parameter.
- The files *_lanes.cpp have those of many rows that have lanes: they call the kernel of LANES.

A function that a file of src/c_api/ defines by hand is not made.
"""

import re

import batch
from attributes import LIMITS, Refused
from cpp import homes, name_in_cpp
from declarations import ONE_ROW, SOURCE, c_functions, functions, sections
from layout import WIDTH, arguments

FOLDER = SOURCE / "src/c_api"
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
# The files of functions, sections and headers that have other names.
FILE_OF = {"pw85_contact_rounded": "rounded", "pw85_overlap_witness": "witness", "Time": "passage", "pw85_shapes.h": "solids"}
# The kernels of functions of many rows that have lanes: the header of the question in src/simd/lanes/, the
# arrays, whose members are the parameters that the rows do not have, and the rows, if they are not those of pairs.
LANES = {
    "contact": ("contact", "ContactArrays"),
    "contact_2d": ("contact", "ContactArrays"),
    "closest_approach": ("contact", "ApproachArray", "Directions{{directions, q1, q2}}"),
    "overlap": ("overlap", "OverlapArray"),
    "overlap_2d": ("overlap", "OverlapArray"),
    "overlap_volume": ("volumes", "VolumeArray"),
    "overlap_area_2d": ("two_dimensions", "AreaArray"),
    "distance": ("distance", "DistanceArrays"),
    "penetration": ("depth", "DepthArrays"),
    "signed_distance": ("signed_distance", "SignedDistanceArrays"),
    "closest_passage": ("passage", "PassageArrays"),
    "grain_contact": ("grains", "GrainArrays"),
    "distance_point": ("surface_distances", "SurfaceArrays", "PointRows{r, q}"),
    "distance_cylinder": ("surface_distances", "SurfaceArrays", "CylinderRows{axis, radius, center, q}"),
    "intersect_line": ("lines", "ChordArrays", "SetRows<Lines>{{origin, directions}, q}"),
}
SETS = {"segment": "SetRows<Segments>{{end1, end2}, q}", "triangle": "SetRows<Triangles>{{vertex1, vertex2, vertex3}, q}",
        "box": "SetRows<Boxes>{{lower, upper}, q}"}  # fmt: skip
LANES |= {f"contact_{name}": ("shapes", "SetContactArrays", rows) for name, rows in SETS.items()}
LANES |= {f"overlap_{name}": ("shapes", "OverlapArray", rows) for name, rows in SETS.items()}
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
SOURCES_OF_ONE, SOURCES_OF_MANY = "pw85.h, pw85_grains.h and pw85_shapes.h", "pw85.h, pw85_grains.h, pw85_shapes.h and api/pw85_batch.h.in"


def by_hand():
    """The functions that are written by hand."""
    texts = (path.read_text(encoding="utf-8") for path in FOLDER.glob("*.cpp"))
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
    names = [name for word, name in LIMITS.items() if name and word in one.attributes.words]
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
        if one.nullable and (one not in numbers or "optional" not in one.attributes.words):
            raise Refused(f"{one.place}: only outputs of doubles can be optional in a function of one row")
    needed = [one.name for one in function.parameters if one.pointer and one not in answers and not (one.is_output() and one.nullable)]
    condition = f"    if (any_null({', '.join(needed)}))"
    marked = [f"{one.name}, {one.length or 1}" for one in numbers]
    yield from (f"    store_nan({numbers});" for numbers in marked if answers)
    for one in answers:
        if not one.attributes.on_error:
            raise Refused(f"{one.place}: no value on error, such as -1 on error")
        yield from (f"    if (any_null({one.name})) return refused(PW85_EINVAL);", f"    *{one.name} = {one.attributes.on_error};")
    status = "PW85_EINVAL" if answers else f"null_pointer({', '.join(marked)})"
    line = f"{condition} return refused({status});"
    yield line if len(line) <= WIDTH else f"{condition}\n{arguments('        return refused(null_pointer(', marked, '));')}"


def body(function, of_kernels):
    name = name_in_cpp(function)
    if function.name in of_kernels:
        passed = [f"PW85_OF_PAIR(kernels::chosen(), {name})", *function.parameter_names()]
        return arguments("    return checked(in_default_environment(", passed, "), refused);")
    called = arguments(f"        auto const result = pw85::{name}(", [loaded(function, one) for one in function.inputs], ");")
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
    name = name_in_cpp(function)
    if name not in [one.name for one in functions("pw85/pw85.hpp")]:
        raise Refused(f"{function.place}: pw85/pw85.hpp does not declare {name}(), which it calls")
    if not (found := homes(name)):
        raise Refused(f"{function.place}: no header of include/pw85/ defines {name}(), which it calls")
    return found


def one_row_file(title, listed):
    names = DISPATCHED.findall((SOURCE / "src/simd/one_pair.hpp").read_text(encoding="utf-8"))
    of_kernels = {f"pw85_{name}" for name in names}
    own = ["../base/c_arrays.hpp", "../base/floating_point_environment.hpp", "../base/last_error.hpp"]
    own += ["../simd/one_pair.hpp"] if any(one.name in of_kernels for one in listed) else []
    headers = sorted({home for one in listed if one.name not in of_kernels for home in homes_of(one)})
    includes = ["#include <pw85.h>\n", *(f"#include <{header.as_posix()}>" for header in headers), *[""] * bool(headers)]
    includes = "\n".join([*includes, *(f'#include "{header}"' for header in own)])
    namespaces = "using namespace pw85::detail;\nusing namespace pw85::detail::c_api;"
    head = HEAD.format(what=f": {title[0].lower()}{title[1:]}", sources=SOURCES_OF_ONE, includes=includes, namespaces=namespaces)
    return head + "".join(of_one_row(function, of_kernels) for function in listed)


def row_argument(one, many):
    """The argument of each_row() for a parameter of one row; `many` stand for it in the function of many rows."""
    first, names = many[0], ", ".join(argument.name for argument in many)
    if not first.pointer:
        return f"SameNumber{{{names}}}"
    if len(many) > 1:
        return f"TwoNumbers{{{names}}}"
    if first.type == "unsigned char":
        return f"Bytes{{{names}}}"
    if not one.pointer:
        return f"Numbers{{{names}}}"
    if first.nullable:
        return f"OptionalRowsOf<{one.size}>{{{names}}}"
    element = f"{first.type} const" if first.const else first.type
    return f"RowsOf<{one.size}{'' if element == 'double const' else f', {element}'}>{{{names}}}"


def kernel_of(function):
    """The header of the question, the rows and the arrays of a function that has lanes."""
    question, arrays, *rows = LANES[function.plain]
    return question, (rows or [f"PairArrays<{function.dimension}>{{r12, q1, q2}}"])[0], arrays


def of_many_rows(statement):
    listed = statement.arguments()
    if statement.function.plain in LANES:
        _, rows, arrays = kernel_of(statement.function)
        own = [one for _, many in listed for one in many]
        others = ", ".join(one.name for one in own if one.name not in re.findall(r"\w+", rows))
        names = [one.name for one in own if one.pointer and not one.nullable]
        begin, passed = "    return compute_rows(", [rows, f"{arrays}{{{others}}}", *names]
    else:
        names = [many[0].name for _, many in listed]
        begin, passed = "    return each_row(", [statement.function.name, *(row_argument(one, many) for one, many in listed)]
    head = arguments(f"int {statement.name}(", c_functions()[statement.name].written, ")")
    table = arguments("    static constexpr char const *names[] = {", [f'"{one}"' for one in [statement.name, *names]], "};")
    return f"\n{head}\n{{\n{table}\n{arguments(begin, ['names', 'n', *passed], ');')}\n}}\n"


def many_rows_file(title, listed):
    has_lanes = listed[0].function.plain in LANES
    questions = sorted({kernel_of(one.function)[0] for one in listed}) if has_lanes else []
    own = ["rows/many_pairs", *(f"simd/lanes/{name}" for name in questions)] if has_lanes else ["rows/each_row"]
    head = HEAD.format(what=f", many rows with{'' if has_lanes else 'out'} lanes: {title[0].lower()}{title[1:]}", sources=SOURCES_OF_MANY,
                       includes="\n".join(["#include <pw85_batch.h>\n", *(f'#include "../{name}.hpp"' for name in own)]),
                       namespaces="using namespace pw85::detail::kernels;")  # fmt: skip
    return head + "".join(map(of_many_rows, listed))


def file_of(function, section):
    """The file that has the function. What two-dimensional functions instantiate stands in one file."""
    if function.dimension == 2:
        return "two_dimensions"
    if function.name.endswith("_factored"):
        return "factored"
    titles = {title: name for name, title in FILES.items()} | {f"pw85_{name}": name for name in FILES} | FILE_OF
    return next((titles[key] for key in (function.name, section.title, function.header) if key in titles), "others")


def files():
    """The texts of the files by their paths."""
    of_one, of_many, known, hands = {}, {}, {}, by_hand()
    for section in (one for header in ONE_ROW for one in sections(header)):
        for function in section.functions:
            known[function.name] = name = file_of(function, section)
            if function.name not in hands:
                of_one.setdefault(name, []).append(function)
    for statement in batch.statements():
        name = f"{known[statement.function.name]}_{'lanes' if statement.function.plain in LANES else 'rows'}"
        of_many.setdefault(name, []).append(statement)
    made = {FOLDER / f"{name}.cpp": one_row_file(FILES[name], listed) for name, listed in of_one.items()}
    return made | {FOLDER / f"{name}.cpp": many_rows_file(FILES[name.rpartition("_")[0]], listed) for name, listed in of_many.items()}
