# SPDX-License-Identifier: BSD-3-Clause
"""C++ headers of functions on many rows, systems and objects, and of classes that own objects, made of the templates api/*.hpp.in.

A line of a template becomes a function that calls that of C of its name (cpp_calls.py):

    @function neighbors_check       a function of namespace pw85, by pw85_neighbors_check()
        options: NeighborOptions
    @member sweep                   a member of the class, by pw85_hard_ellipsoids_sweep()
    @member steps returns TrialSteps
    @member remove, save            several of the same kind
    @others                         all functions on the object of the class, or outside of a class on none, that no template calls

"as" gives another name, and "without direction" passes null. A function that "returns" a type has its outputs in it, and the status if
it has such a member. Indented lines below give the C++ type of a parameter, with its default, or that of a struct that has several
parameters as members. Some lines become many functions: "@rows pw85_batch.h" all that take n rows, "@pairs pw85_systems.h" all that
take a list of pairs and a system, and have rows for each pair. Their outputs become the struct that has these members, if there is one
in include/pw85/batch/values.hpp. api/committed.py writes the headers or compares them.
"""

import re

from declarations import c_functions, functions, sections
from public_headers import SIMULATION
from refusals import Refused, line_of
from cpp import CLASSES, FOLDER, TEMPLATES, is_of_list, is_of_rows, kinds, name_in_cpp, structs
from cpp_calls import Call
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
MARK_OF_OTHERS = re.compile(r"^(?P<indent> *)@others\n", re.MULTILINE)
KINDS = {"rows": is_of_rows, "pairs": is_of_list}


def definitions_of(match, prefix, path, made):
    """The functions of a line; an empty line is between them and those of the next one. `made` are those of the lines before."""
    is_member, texts = match["kind"] == "member", []
    types = dict(line.strip().split(": ", 1) for line in match["said"].splitlines())
    for name in match["names"].split(", "):
        place = f"{line_of(path.name, match.string, match.start('kind'))}: @{match['kind']} {name}"
        c_name, own = f"{prefix if is_member else 'pw85_'}{name}", match["own"] or name
        if c_name not in c_functions():
            raise Refused(f"{place}: no function {c_name}()")
        if (own, match["without"]) in made:
            raise Refused(f"{place}: {own}() is made twice")
        for kind in (match["type"], *types.values()):
            if kind and kind.split()[0] not in kinds():
                raise Refused(f"{place}: no type {kind.split()[0]} in the headers of C++")
        made.add((own, match["without"]))
        call = Call(c_functions()[c_name], types, is_member, match["without"], match["type"])
        outputs = call.function.outputs  # the only one can be the result itself
        if match["type"] and outputs[1:] and (left := [one.name for one in outputs if not call.place(one).startswith("found.")]):
            raise Refused(f"{place}: {match['type']} has no member {left[0]}")
        known = {None, *call.function.parameter_names(), *(one.name for one in call.declared)}
        if unknown := {*types, match["without"]} - known:
            raise Refused(f"{place}: no such parameter: {', '.join(sorted(unknown))}")
        texts.append(call.text(own, match["indent"]))
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


def marks_of_others(match, owned, others):
    """The line in the place of a mark @others; an empty one if there are none."""
    kind, owner = ("member", owned) if match["indent"] else ("function", "")
    names = [one.name.removeprefix(f"{owner or 'pw85'}_") for one in others if owner_of(one) == owner]
    return f"{match['indent']}@{kind} {', '.join(names)}\n" if names else "\n"


def owner_of(function):
    """The type of the object on which a function works; empty if it works on none."""
    return next((one.type for one in function.parameters if one.type in CLASSES), "")


def header(name, path, others):
    template = path.read_text(encoding="utf-8")
    owned = next((c_name for c_name, kind in CLASSES.items() if f"\nclass {kind} {{" in template), "pw85")
    template = MARK_OF_OTHERS.sub(lambda match: marks_of_others(match, owned, others), template)
    listed = set()
    made = MARK.sub(lambda match: definitions_of(match, f"{owned}_", path, listed), template)
    made = MARK_OF_MANY.sub(definitions, made.replace("@private\n", PRIVATE.format(owned)))
    if left := re.search(r"^ *@(?!\{|\}).*", made, re.MULTILINE):
        raise Refused(f"{line_of(path.name, template, template.index(left[0]))}: not understood: {left[0].strip()}")
    return cpp_header(FOLDER / f"{name}.hpp", made, path)


def headers(others):
    return {FOLDER / f"{name}.hpp": header(name, path, others) for name, path in TEMPLATES.items()}


def uncalled(made):
    """The functions on systems and objects that no text calls. Comments, which may name functions, do not count."""
    called = set(re.findall(r"\bpw85_\w+", re.sub(r"//.*", "", "".join(made.values()))))
    return [one for name in ("pw85_systems.h", *SIMULATION) for one in functions(name) if one.name not in called]


def files():
    """The texts of the headers by their paths."""
    made = headers(uncalled(headers([])))
    if left := uncalled(made):
        raise Refused(f"{left[0].place}: in no template of C++, api/*.hpp.in")
    return made
