# SPDX-License-Identifier: BSD-3-Clause
"""Functions of C++ that call functions of C with many rows, systems and objects: their declarations, comments and bodies.

Counts are left out: arrays become spans, whose sizes are compared. Structs of C become those of C++, and the name is that of C without
its prefix and without `_2d`, which the types say. Outputs that may be null, but the first, are empty by default. Several parameters can
be members of one struct of C++, and outputs can be returned. api/classes.py makes headers of these functions.
"""

import re
from collections import defaultdict, namedtuple
from itertools import groupby

from cpp import ENDS, SHORT_NAMES, brief, described, in_cpp, row_type, structs, type_in_cpp
from layout import arguments, wrapped
from parameters import OBJECTS
from refusals import refuse

NAMES = {"system": "particles"}  # of parameters in C++
EXTENTS = {"num_pairs": "list.pairs", "num_particles": "particles.centers"}  # of members of structs
VALUES = {"NaN": "detail::quiet_nan<double>()", "num_particles": "particles.centers.size()"}
TEXTS = {
    "list": "indices of particles, with or without images",
    "particles": "centres, forms and cell; sizes must fit, and indices be those of particles",
}


# A parameter of C++, with that of C, or with the first one of a struct of several.
Declared = namedtuple("Declared", "text is_output name parameter")


class Call:
    """A function of C++, in the parts that its parameters make: statements in their order; `marked` are those if sizes are compared, and
    `checked` are the arrays that have as many rows as another one.

    `types` are those of parameters of C++, with defaults, or of structs of several parameters. `result` is the type that has the outputs;
    if there is none, the function returns what that of C returns. `out` is a function of C++ that gives a pointer to the numbers of a
    member of the result."""

    def __init__(self, function, types, is_member=False, result=None, out=None):
        flags = {one.name: "bool" for one in function.parameters if one.type == "int" and one.is_truth()}
        self.function, self.types, self.is_member, self.result, self.out = function, flags | types, is_member, result, out
        self.declared, self.first, self.marked, self.checked, self.before, self.after = [], [], [], defaultdict(list), [], []
        self.sizes, own = {}, function.parameter_names()
        self.members = structs().get((result or "").partition("<")[0], ())  # of the result
        for one in function.parameters:
            if one.rows:
                self.sizes.setdefault(one.rows, self.place(one) if one.rows in own else EXTENTS[one.rows])
        self.passed = [self.argument(one) for one in function.parameters]

    def argument(self, one):
        """What is passed for a parameter, which it declares."""
        if one.type in OBJECTS:
            return self.object(one)
        if one.is_struct():
            return self.struct(one)
        if one.is_handle():
            self.declare(one, f"{one.type} *{one.name}")
            return one.name
        if one.is_count:
            return f"{self.sizes[one.name]}.size()"
        if one.rows:
            return self.rows(one)
        return self.row(one) if one.pointer else self.number(one)

    def place(self, one):
        """Where a parameter is: a parameter of C++, or a member of one or of the result."""
        name = one.members()[0]
        if one.is_output() and name.partition(".")[0] in self.members:
            return f"found.{name}"
        owners = (struct for struct, kind in self.types.items() if struct != one.name and name in structs().get(kind, ()))
        place = next((f"{struct}.{name}" for struct in owners), NAMES.get(one.name, one.name))
        refuse(one.place, {f"no struct of C++ has the member {name}": one.attributes.members and "." not in place})
        return place

    def declare(self, one, text):
        """Adds a parameter. A new object comes before other outputs."""
        name = re.search(r"(\w+)(?: = .*)?$", text)[1]
        k = len(self.declared) - (one.outer and any(other.is_output for other in self.declared))
        self.declared.insert(k, Declared(text, one.is_output() or one.outer, name, one))

    def declare_or_find(self, one, text):
        """Adds a parameter, or the struct that has it, and returns its place."""
        place = self.place(one)
        owner = place.split(".")[0]
        if owner == place:
            self.declare(one, text)
        elif owner not in ("found", *(other.name for other in self.declared)):
            self.declare(one, f"{self.types[owner]} const &{owner}")
        return place

    def object(self, one):
        kind = type_in_cpp(one.type)
        if self.is_member:
            return "get()"
        self.declare(one, f"{kind} {'' if one.outer else 'const '}&{one.name}")
        if not one.outer:
            return f"{one.name}.get()"
        self.first.append(f"{one.name} = {kind}();")
        self.before.append(f"{one.type} *made = nullptr;")
        self.after.append(f"{one.name} = {kind}(made);")
        return "&made"

    def struct(self, one):
        name = NAMES.get(one.name, one.name)
        self.declare(one, f"{type_in_cpp(one.type)} const &{name}")
        self.before.append(f"{one.type} const {name}_in_c = detail::in_c({name});")
        if one.type == "pw85_pair_list":
            self.checked["list.pairs"].append("detail::optional(list.images)")
        if one.type == "pw85_system":
            read = {member.name for member in self.function.members_read(one)}
            first, other = (f"{name}.{member}" for member in sorted(("centers", "q"), key=lambda member: member not in read))
            self.checked[first].append(other if {"centers", "q"} <= read else f"detail::optional({other})")
        return f"&{name}_in_c"

    def rows(self, one):
        written = f"std::span<{row_type(self.function, one)}{' const' if one.const else ''}>"
        is_first_output = one.is_output() and not any(other.is_output for other in self.declared)
        default = " = {}" if one.nullable and not is_first_output else ""
        place = self.declare_or_find(one, f"{SHORT_NAMES.get(written, written)} {one.name}{default}")
        if place != self.sizes[one.rows]:
            self.checked[self.sizes[one.rows]].append(place)
        return f"{place}.data()" if one.type in ("pw85_wall", "pw85_field") else f"detail::in_c({place})"

    def row(self, one):
        """A number or an array of one row, which is read or written."""
        kind, row = self.types.get(one.name), row_type(self.function, one)
        if kind in structs():
            return self.members_of(kind, one)
        if self.result and one.is_output() and self.place(one) == one.name:
            return self.returned(one)
        if len(one.members()) > 1:
            return self.split(one)
        place = self.declare_or_find(one, f"{kind or row} {'' if one.is_output() else 'const '}&{one.name}")
        if kind == "bool":
            self.before.append(f"int {one.name}_in_c = -1;")
            self.after.append(f"{place} = {one.name}_in_c == 1;")
            return f"&{one.name}_in_c"
        if one.is_output() and place == one.name:
            self.mark(one)
        if self.out and one.is_output() and one.type == "double":
            return f"{self.out}({place})"
        if row == "Cell" and one.nullable:
            return f"detail::in_c({place})"
        if one.type == "pw85_motion":
            self.before.append(f"pw85_motion const {one.name}_in_c = detail::in_c({place});")
            return f"&{one.name}_in_c"
        return place + ENDS.get(row.split("<")[0], ".data()") if one.shape else f"&{place}"

    def split(self, one):
        """An output whose numbers are members of the result."""
        self.before.append(f"double {one.name}[{one.size}];")
        width = one.size // len(one.members())
        for k, name in enumerate(one.members()):
            values = ", ".join(f"{one.name}[{i}]" for i in range(k * width, (k + 1) * width))
            self.after.append(f"found.{name} = {values if width == 1 else f'{{{values}}}'};")
        return one.name

    def members_of(self, struct, one):
        """An input whose numbers are the members of a struct of C++."""
        listed = ", ".join(structs()[struct])
        self.declare(one, f"{struct} const &{one.name}")
        self.before += [f"auto const &[{listed}] = {one.name};", f"double const {one.name}_in_c[] = {{{listed}}};"]
        return f"{one.name}_in_c"

    def mark(self, one):
        """The statement that marks an output before sizes are compared."""
        if value := one.value_on_error():
            values = ", ".join([VALUES.get(value, value)] * one.size)
            self.marked.append(f"{one.name} = {{{values}}};" if one.shape else f"{one.name} = {values};")

    def returned(self, one):
        """The only output, which is returned."""
        names = [f"{one.name}[{k}]" for k in range(one.size)] if one.shape else []
        self.before.append(f"{one.type} {one.name}{f'[{len(names)}]' if names else ''};")
        self.after.append(f"return {{{', '.join(names)}}};" if names else f"return {one.name};")
        return one.name if names else f"&{one.name}"

    def number(self, one):
        plain_type = type_in_cpp(one.type)
        kind, equals, default = self.types.get(one.name, plain_type).partition(" = ")
        place = self.declare_or_find(one, f"{kind} {one.name}{equals}{default}")
        return place if kind == plain_type else f"static_cast<{one.type}>({place})"

    def check(self, indent):
        """The statement that compares the sizes of arrays."""
        calls = [f"detail::have_rows({size}.size(), {', '.join(places)})" for size, places in self.checked.items()]
        whole = f"!{calls[0]}" if len(calls) == 1 else f"!({' && '.join(calls)})"
        lines = wrapped(f"if ({whole}) return\0StatusCode::invalid_argument;", 100 - len(indent), rest="    ")
        return [line.replace("\0", " ") for line in lines]

    def body(self, indent):
        yield from self.first
        if self.checked:
            yield from (*self.marked, *self.check(indent))
        if any(self.place(one).startswith("found.") for one in self.function.parameters):
            yield f"{self.result} found{{}};"
        yield from self.before
        begin, end, last = self.frame()
        yield from arguments(f"{indent}{begin}{self.function.name}(", self.passed, f"){end}").removeprefix(indent).split(f"\n{indent}")
        yield from (*self.after, *last)

    def frame(self):
        """What stands before and behind the call of the function of C, and at the end."""
        if "status" in self.members:
            return "found.status = static_cast<StatusCode>(", ");", ["return found;"]
        if self.result:
            return "static_cast<void>(", ");", [] if self.after else ["return found;"]
        if self.function.type != "int":
            return "return ", ";", []
        if not self.after:
            return "return static_cast<StatusCode>(", ");", []
        return "int const status = ", ";", ["return static_cast<StatusCode>(status);"]

    def comment(self):
        yield brief(self.function)
        if self.is_member:
            return
        yield ""
        for (is_output, text), group in groupby(self.declared, lambda one: (one.is_output, self.text_of(one))):
            yield f"@param{'[out]' if is_output else ''} {','.join(one.name for one in group)} {text}"
        yield f"@return {'the values, and ' if self.result else ''}{in_cpp(self.function.returned() or 'the status')}".strip()

    def text_of(self, declared):
        """What is said of a parameter of C++."""
        _, _, name, one = declared
        if one.outer:
            return "empty on error"
        if one.is_struct() and name in TEXTS:
            return TEXTS[name]
        if name in self.types and name != one.name:
            return f"rows in all spans, or in some: see {self.function.name}()" if one.shape else f"see {self.types[name]}"
        return described(self.function, one)

    def text(self, name, indent="", body=None, head="static inline", comment=()):
        """The definition; `body` stands for the statements of the call."""
        kind = self.result or ("StatusCode" if self.function.type == "int" else type_in_cpp(self.function.type))
        is_const = " const" if self.is_member and self.function.parameters[0].const else ""
        head = "[[gnu::always_inline]]" if self.is_member else head
        mark, inner = f"{indent}/// ", f"{indent}    "
        lines = [text for line in comment or self.comment() for text in wrapped(line, first=mark) or [mark.rstrip()]]
        declared = arguments(f"{indent}{head} {kind} {name}(", [one.text for one in self.declared], f"){is_const} noexcept")
        statements = (f"{inner}{line}" for line in body or self.body(inner))
        return "".join(f"{line}\n" for line in (*lines, declared, f"{indent}{{", *statements, f"{indent}}}"))
