# SPDX-License-Identifier: BSD-3-Clause
"""Functions of C++ that call functions of C with many rows, systems and objects: their declarations, comments and bodies.

Counts are left out: arrays become spans, whose sizes are compared. Structs of C become those of C++, and the name is that of C without
its prefix and without `_2d`, which the types say. Outputs that may be null, but the first, are empty by default. Several parameters can
be members of one struct of C++, and outputs can be returned. api/spans.py and api/classes.py make headers of these functions.
"""

import re
import textwrap
from dataclasses import dataclass, field
from itertools import groupby
from math import prod

import batch
from cpp_texts import brief, described, in_cpp, returned
from cpp_types import CLASSES, NUMBERS, SHORT_NAMES, STRUCTS, address, row_of, structs
from declarations import OBJECTS, members_read, parameters

WIDTH = 100
NAMES = {"system": "particles"}  # of parameters in C++
EXTENTS = {"num_pairs": "list.pairs", "num_particles": "particles.centers"}  # of members of structs
VALUES = {"NaN": "detail::quiet_nan<double>()", "num_particles": "particles.centers.size()"}


def wrapped(begin, arguments, end):
    yield from batch.wrapped(begin, arguments, end).split("\n")


@dataclass
class Call:
    """A function of C++, in the parts that its parameters make."""

    function: object
    types: dict = field(default_factory=dict)  # of parameters of C++, with defaults, or of structs of several parameters
    is_member: bool = False  # of the class that owns the object
    without: str | None = None  # a parameter for which null is passed
    result: str | None = None  # the type that has the outputs; if there is none, the function returns what that of C returns
    declared: list = field(default_factory=list)
    described: list = field(default_factory=list)  # of each declared parameter: whether it is an output, its name, that of C
    first: list = field(default_factory=list)
    marked: list = field(default_factory=list)  # if sizes are compared, which comes next
    checked: list = field(default_factory=list)
    before: list = field(default_factory=list)
    passed: list = field(default_factory=list)
    after: list = field(default_factory=list)

    def __post_init__(self):
        self.listed, self.sizes = parameters(self.function), {}
        own = {one.name for one in self.listed}
        for one in self.listed:
            for extent in one.shape[:1]:
                if isinstance(extent, str):
                    self.sizes.setdefault(extent, self.place(one) if extent in own else EXTENTS[extent])
        for one in self.listed:
            self.add(one)

    def place(self, one):
        """Where a parameter is: a parameter of C++, or a member of one or of the result."""
        name = one.members()[0]
        if one.is_output() and self.result and name in structs().get(self.result, ()):
            return f"found.{name}"
        for struct, kind in self.types.items():
            if struct != one.name and name in structs().get(kind, ()):
                return f"{struct}.{name}"
        return NAMES.get(one.name, one.name)

    def declare(self, one, text):
        """Adds a parameter. A new object comes before other outputs."""
        name = re.search(r"(\w+)(?: = .*)?$", text)[1]
        k = len(self.declared) - (one.outer and any(is_output for is_output, _, _ in self.described))
        self.declared.insert(k, text)
        self.described.insert(k, (one.is_output() or one.outer, name, one))

    def declare_or_find(self, one, text):
        """Adds a parameter, or the struct that has it, and returns its place."""
        place = self.place(one)
        owner = place.split(".")[0]
        if owner == place:
            self.declare(one, text)
        elif owner not in ("found", *(name for _, name, _ in self.described)):
            self.declare(one, f"{self.types[owner]} const &{owner}")
        return place

    def add(self, one):
        if one.name == self.without:
            self.passed.append("nullptr")
        elif one.name in self.sizes and not one.pointer:
            self.passed.append(f"{self.sizes[one.name]}.size()")
        elif one.type in OBJECTS:
            self.passed.append(self.object(one))
        elif one.is_struct():
            self.passed.append(self.struct(one))
        elif one.shape and isinstance(one.shape[0], str):
            self.passed.append(self.rows(one))
        elif one.pointer:
            self.passed.append(self.row(one))
        else:
            self.passed.append(self.number(one))

    def object(self, one):
        kind = CLASSES[one.type]
        if one.outer:
            self.declare(one, f"{kind} &{one.name}")
            self.first.append(f"{one.name} = {kind}();")
            self.before.append(f"{one.type} *made = nullptr;")
            self.after.append(f"{one.name} = {kind}(made);")
            return "&made"
        if self.is_member:
            return "get()"
        self.declare(one, f"{kind} const &{one.name}")
        return f"{one.name}.get()"

    def struct(self, one):
        name = NAMES.get(one.name, one.name)
        self.declare(one, f"{STRUCTS[one.type]} const &{name}")
        self.before.append(f"{one.type} const {name}_in_c = detail::in_c({name});")
        read = {member.name for member in members_read(self.function, one)}
        if one.type == "pw85_pair_list":
            self.checked.append(("list.pairs.size()", "detail::optional(list.images)"))
        elif one.type == "pw85_system":
            first, second = ("centers", "q") if "centers" in read else ("q", "centers")
            other = f"{name}.{second}" if {"centers", "q"} <= read else f"detail::optional({name}.{second})"
            self.checked.append((f"{name}.{first}.size()", other))
        return f"&{name}_in_c"

    def rows(self, one):
        written = f"std::span<{row_of(self.function, one, one.shape[1:])}{' const' if one.const else ''}>"
        is_first = not any(is_output for is_output, _, _ in self.described)
        default = " = {}" if one.nullable and not (one.is_output() and is_first) else ""
        place = self.declare_or_find(one, f"{SHORT_NAMES.get(written, written)} {one.name}{default}")
        size = self.sizes[one.shape[0]]
        if place != size:
            self.checked.append((f"{size}.size()", place))
        return f"{place}.data()" if one.type in ("pw85_wall", "pw85_field") else f"detail::in_c({place})"

    def row(self, one):
        """A number or an array of one row, which is read or written."""
        kind = self.types.get(one.name)
        if kind in structs():
            self.declare(one, f"{kind} const &{one.name}")
            self.before.append(f"auto const &[{', '.join(structs()[kind])}] = {one.name};")
            self.before.append(f"double const {one.name}_in_c[] = {{{', '.join(structs()[kind])}}};")
            return f"{one.name}_in_c"
        row = row_of(self.function, one, one.shape)
        if self.result and one.is_output() and self.place(one) == one.name:
            return self.returned(one)
        place = self.declare_or_find(one, f"{kind or row} {'' if one.is_output() else 'const '}&{one.name}")
        if kind == "bool":
            self.before.append(f"int {one.name}_in_c = -1;")
            self.after.append(f"{place} = {one.name}_in_c == 1;")
            return f"&{one.name}_in_c"
        if one.is_output() and place == one.name:
            self.mark(one)
        if row == "Cell" and one.nullable:
            return f"detail::in_c({place})"
        return address(row, place) if one.shape else f"&{place}"

    def mark(self, one):
        """The statement that marks an output before sizes are compared."""
        value = one.attributes.on_error or ("NaN" if one.type == "double" else "")
        if value:
            value = VALUES.get(value, value)
            values = ", ".join([value] * prod(one.shape))
            self.marked.append(f"{one.name} = {{{values}}};" if one.shape else f"{one.name} = {value};")

    def returned(self, one):
        """The only output, which is returned."""
        names = [f"{one.name}[{k}]" for k in range(prod(one.shape))] if one.shape else []
        self.before.append(f"{one.type} {one.name}{f'[{len(names)}]' if names else ''};")
        self.after.append(f"return {{{', '.join(names)}}};" if names else f"return {one.name};")
        return one.name if names else f"&{one.name}"

    def number(self, one):
        plain_type = NUMBERS.get(one.type, one.type)
        kind, _, default = self.types.get(one.name, plain_type).partition(" = ")
        place = self.declare_or_find(one, f"{kind} {one.name}{f' = {default}' if default else ''}")
        return place if kind == plain_type else f"static_cast<{one.type}>({place})"

    def check(self, indent):
        """The statement that compares the sizes of arrays."""
        groups = {size: [place for other, place in self.checked if other == size] for size, _ in self.checked}
        calls = [f"detail::have_rows({size}, {', '.join(places)})" for size, places in groups.items()]
        whole = f"!{calls[0]}" if len(calls) == 1 else f"!({' && '.join(calls)})"
        lines = textwrap.wrap(f"if ({whole}) return\0StatusCode::invalid_argument;", WIDTH - len(indent), subsequent_indent=" " * 4)
        yield from (line.replace("\0", " ") for line in lines)

    def body(self, indent):
        has_status = "status" in structs().get(self.result, ())
        yield from self.first
        if self.checked:
            yield from (*self.marked, *self.check(indent))
        if any(self.place(one).startswith("found.") for one in self.listed):
            yield f"{self.result} found{{}};"
        yield from self.before
        begin, end, last = "int const status = ", ";", ["return static_cast<StatusCode>(status);"]
        if has_status:
            begin, end, last = "found.status = static_cast<StatusCode>(", ");", ["return found;"]
        elif self.result:
            begin, end, last = "static_cast<void>(", ");", [] if self.after else ["return found;"]
        elif self.function.type != "int":
            begin, last = "return ", []
        elif not self.after:
            begin, end, last = "return static_cast<StatusCode>(", ");", []
        yield from (line.removeprefix(indent) for line in wrapped(f"{indent}{begin}{self.function.name}(", self.passed, f"){end}"))
        yield from (*self.after, *last)

    def comment(self):
        yield brief(self.function)
        if self.is_member:
            return
        yield ""
        texts = [(is_output, self.text_of(name, one), name) for is_output, name, one in self.described]
        for (is_output, text), group in groupby(texts, lambda one: one[:2]):
            yield f"@param{'[out]' if is_output else ''} {','.join(name for _, _, name in group)} {text}"
        yield f"@return {'the values, and ' if self.result else ''}{in_cpp(returned(self.function))}".strip()

    def text_of(self, name, one):
        """What is said of a parameter of C++; `one` is that of C, or the first one of a struct of several."""
        if one.outer:
            return "empty on error"
        if one.is_struct() and name in ("list", "particles"):
            are_pairs = "indices of particles, with or without images"
            return are_pairs if name == "list" else "centres, forms and cell; sizes must fit, and indices be those of particles"
        if name in self.types and name != one.name:
            return f"rows in all spans, or in some: see {self.function.name}()" if one.shape else f"see {self.types[name]}"
        return described(self.function, one)

    def lines(self, name, indent="", body=None):
        """The lines of the definition; `body` stands for the statements of the call."""
        kind = self.result or ("StatusCode" if self.function.type == "int" else NUMBERS[self.function.type])
        head, is_const = "static inline", ""
        if self.is_member:
            head, is_const = "[[gnu::always_inline]]", " const" if self.listed[0].const else ""
        for line in self.comment():
            mark = f"{indent}/// "
            yield from textwrap.wrap(line, WIDTH, initial_indent=mark, subsequent_indent=mark) or [mark.rstrip()]
        yield from wrapped(f"{indent}{head} {kind} {name}(", self.declared, f"){is_const} noexcept")
        yield from (f"{indent}{{", *(f"{indent}    {line}" for line in body or self.body(f"{indent}    ")), f"{indent}}}")
