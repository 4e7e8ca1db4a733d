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

from cpp import CLASSES, TEMPLATES, is_of_list, is_of_rows, kinds, name_in_cpp, structs
from cpp_calls import Call
from declarations import c_functions, functions, sections
from layout import arguments, cpp_header, insert
from public_headers import INCLUDE, SYSTEMS
from refusals import Refused, line_of, refuse

SAID = re.compile(r" (?P<names>\w+(?:, \w+)*)(?: as (?P<own>\w+))?(?: without (?P<without>\w+))?(?: returns (?P<type>\w+))?")
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
KINDS = {"rows": is_of_rows, "pairs": is_of_list}


class Header:
    """A header that is made of its template. `others` are the functions that no template calls."""

    def __init__(self, path, others):
        text = path.read_text(encoding="utf-8")
        self.path, self.others, self.made = path, others, set()
        self.owned = next((c_name for c_name, kind in CLASSES.items() if f"\nclass {kind} {{" in text), "pw85")

    def text(self):
        made = {"member": self.functions, "function": self.functions, "others": self.functions_of_others, "rows": functions_of_all,
                "pairs": functions_of_all, "private": lambda match: PRIVATE.format(self.owned)}  # fmt: skip
        return insert(self.path, "@", made)

    def functions(self, match, listed=None):
        """The functions of a line, or those listed; an empty line is between them and those of the next one."""
        said, place = SAID.fullmatch(listed or match["said"]), line_of(self.path.name, match.string, match.start("name"))
        refuse(place, {f"not understood: @{match['name']}{match['said']}": said is None})
        types = dict(line.strip().split(": ", 1) for line in match["below"].splitlines())
        mark, names = f"{place}: @{match['name']}", said["names"].split(", ")
        texts = (self.function(f"{mark} {name}", match["indent"], name, said, types) for name in names)
        return "\n".join(texts) + "\n" * bool(re.match(" *@(member|function|others)", match.string[match.end() :]))

    def function(self, place, indent, name, said, types):
        """A member of the class, which is indented, or a function."""
        prefix, key = self.owned if indent else "pw85", (said["own"] or name, said["without"])
        c_name = f"{prefix}_{name}"
        refuse(place, {f"no function {c_name}()": c_name not in c_functions(), f"{key[0]}() is made twice": key in self.made})
        named = [kind.split()[0] for kind in (said["type"], *types.values()) if kind]
        refuse(place, {f"no type {kind} in the headers of C++": kind not in kinds() for kind in named})
        self.made.add(key)
        call = Call(c_functions()[c_name], types, bool(indent), said["without"], said["type"])
        outputs = [one.name for one in call.function.outputs if not call.place(one).startswith("found.")]
        if said["type"] and call.function.outputs[1:]:  # the only one can be the result itself
            refuse(place, {f"{said['type']} has no member {one}": True for one in outputs})
        known = {None, *call.function.parameter_names(), *(one.name for one in call.declared)}
        unknown = ", ".join(sorted({*types, said["without"]} - known))
        refuse(place, {f"no such parameter: {unknown}": unknown})
        return call.text(key[0], indent)

    def functions_of_others(self, match):
        """All functions on the object of the class, or outside of it on none, that no template calls."""
        owner = self.owned if match["indent"] else ""
        names = [one.name.removeprefix(f"{owner or 'pw85'}_") for one in self.others if owner_of(one) == owner]
        return self.functions(match, f" {', '.join(names)}") if names else ""


def owner_of(function):
    """The type of the object on which a function works; empty if it works on none."""
    return next((one.type for one in function.parameters if one.type in CLASSES), "")


def functions_of_all(match):
    """The functions of a kind, in the sections of a header of C."""
    texts = []
    for section in sections(match["said"].strip()):
        listed = [call_of_all(one, match["name"]) for one in section.functions if KINDS[match["name"]](one)]
        texts += [f"/// @name {section.title}\n/// @{{\n", *listed, "/// @}\n"] if listed else []
    return "\n".join(texts)


def call_of_all(function, kind):
    """A function that passes all arrays to detail::call_rows() or call_pairs(), which compare sizes."""
    outputs = [one.name for one in function.outputs]
    struct = next((name for name, members in structs().items() if members == outputs and name.endswith("Spans")), None)
    call = Call(function, {"out": struct} if struct else {})
    places = [call.place(one) for one in function.parameters if one.name != "n"]
    body = arguments(f"    return detail::call_{kind}(", [function.name, *places], ");").removeprefix("    ").split("\n    ")
    return call.text(name_in_cpp(function), body=body)


def headers(others):
    """The texts of the headers by their paths, and the functions on systems and objects that none calls. Comments may name functions."""
    made = {INCLUDE / name: cpp_header(INCLUDE / name, Header(path, others).text(), path) for name, path in TEMPLATES.items()}
    called = set(re.findall(r"\bpw85_\w+", re.sub(r"//.*", "", "".join(made.values()))))
    return made, [one for one in functions(*SYSTEMS) if one.name not in called]


def files():
    """The texts of the headers by their paths."""
    made, left = headers(headers([])[1])
    for one in left:
        raise Refused(f"{one.place}: in no template of C++, api/*.hpp.in")
    return made
