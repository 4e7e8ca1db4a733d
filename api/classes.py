# SPDX-License-Identifier: BSD-3-Clause
"""C++ headers of functions on many rows, systems and objects, and of classes that own objects, made of the templates api/*.hpp.in.

A line of a template becomes a function that calls that of C of its name (cpp_calls.py):

    @function neighbors_check       a function of namespace pw85, by pw85_neighbors_check()
        options: NeighborOptions
    @member sweep                   a member of the class, by pw85_hard_ellipsoids_sweep()
    @member steps returns TrialSteps
    @member remove, save            several of the same kind

"as" gives another name, and "without direction" passes null. A function that "returns" a type has its outputs in it, and the status if
it has such a member. Indented lines below give the C++ type of a parameter, with its default, or that of a struct that has several
parameters as members. Some lines become many functions: "@rows pw85_batch.h" all that take n rows, "@pairs pw85_systems.h" all that
take a list of pairs and a system, and have rows for each pair. Their outputs become the struct that has these members, if there is one
in include/pw85/batch/values.hpp. api/committed.py writes the headers or compares them.
"""

import re

from cpp import CLASSES, FOLDER, TEMPLATES, is_of_list, is_of_rows, name_in_cpp, structs
from cpp_calls import Call
from declarations import SIMULATION, c_functions, functions, sections
from layout import arguments, cpp_header

MARK = re.compile(
    r"^(?P<indent> *)@(?P<kind>member|function) (?P<names>\w+(?:, \w+)*)(?: as (?P<own>\w+))?(?: without (?P<without>\w+))?"
    r"(?: returns (?P<type>\w+))?\n(?P<said>(?: *\w+: .*\n)*)",
    re.MULTILINE,
)
# The mark @private at the end of a class: the object that it owns, and how that is destroyed.
PRIVATE = """\
  private:
    struct Destroy {{
        [[gnu::always_inline]] void operator()({0} *object) const noexcept
        {{
            {0}_destroy(object);
        }}
    }};
    std::unique_ptr<{0}, Destroy> object_;
"""
MARK_OF_MANY = re.compile(r"^@(?P<kind>rows|pairs) (?P<header>\w+\.h)\n", re.MULTILINE)
KINDS = {"rows": is_of_rows, "pairs": is_of_list}


def definitions_of(match, prefix, path):
    """The functions of a line; an empty line is between them and those of the next one."""
    is_member, texts = match["kind"] == "member", []
    types = dict(line.strip().split(": ", 1) for line in match["said"].splitlines())
    for name in match["names"].split(", "):
        place, c_name = f"{path.name}: @{match['kind']} {name}", f"{prefix if is_member else 'pw85_'}{name}"
        if c_name not in c_functions():
            raise ValueError(f"{place}: no function {c_name}()")
        call = Call(c_functions()[c_name], types, is_member, match["without"], match["type"])
        known = {None, *call.function.parameter_names(), *(one.name for one in call.declared)}
        if unknown := {*types, match["without"]} - known:
            raise ValueError(f"{place}: no such parameter: {', '.join(sorted(unknown))}")
        texts.append(call.text(match["own"] or name, match["indent"]))
    return "\n".join(texts) + "\n" * bool(MARK.match(match.string, match.end()))


def call_of_all(function, kind):
    """A function that passes all arrays to detail::call_rows() or call_pairs(), which compare sizes."""
    outputs = [one.name for one in function.outputs]
    struct = next((name for name, members in structs().items() if members == outputs and name.endswith("Spans")), None)
    call = Call(function, {"out": struct} if struct else {})
    places = [call.place(one) for one in function.parameters if one.name != "n"]
    body = arguments(f"    return detail::call_{kind}(", [function.name, *places], ");").removeprefix("    ").split("\n    ")
    return call.text(name_in_cpp(function), body=body)


def definitions(match):
    """The functions of a kind, in the sections of a header of C."""
    texts = []
    for section in sections(match["header"]):
        listed = [function for function in section.functions if KINDS[match["kind"]](function)]
        if listed:
            texts += [f"/// @name {section.title}\n/// @{{\n", *(call_of_all(one, match["kind"]) for one in listed), "/// @}\n"]
    return "\n".join(texts)


def header(name, path):
    template = path.read_text(encoding="utf-8")
    owned = next((c_name for c_name, kind in CLASSES.items() if f"\nclass {kind} {{" in template), "pw85")
    made = MARK.sub(lambda match: definitions_of(match, f"{owned}_", path), template)
    made = MARK_OF_MANY.sub(definitions, made.replace("@private\n", PRIVATE.format(owned)))
    if left := re.search(r"^ *@(?!\{|\}).*", made, re.MULTILINE):
        raise ValueError(f"{path.name}: {left[0].strip()}: not understood")
    return cpp_header(FOLDER / f"{name}.hpp", made, path)


def files():
    """The texts of the headers by their paths."""
    made = {FOLDER / f"{name}.hpp": header(name, path) for name, path in TEMPLATES.items()}
    called = set(re.findall(r"\bpw85_\w+", "".join(made.values())))
    for function in (one for name in ("pw85_systems.h", *SIMULATION) for one in functions(name)):
        if function.name not in called:
            raise ValueError(f"{function.place}: in no template of C++, api/*.hpp.in")
    return made
