# SPDX-License-Identifier: BSD-3-Clause
"""Parses the declarations of the public headers with their comments. It is the only parser of these headers.

The C headers declare every function. What a program must know of a parameter stands in its type and in the brackets behind its name:
see api/attributes.py. A parameter that is not described is an error, with file and line.

`pw85_pair_list const *list`, `pw85_system const *system` and `pw85_law const *law` are structs, whose members have comments with the
same brackets. Members count as parameters of the function, and extents may be names of members.

docs/ (reference pages, checks of the comments), the other programs of this folder and tests import it.
"""

import re
from collections import namedtuple
from dataclasses import dataclass
from dataclasses import replace as changed
from functools import cache, cached_property
from math import prod
from pathlib import Path

from attributes import PACKED, Attributes, Refused, line_of, parsed, text_behind

SOURCE = Path(__file__).resolve().parent.parent
INCLUDE = SOURCE / "include"
# The headers of functions of one row: a pair of ellipsoids; contacts of grains; an ellipsoid and a wall or another shape.
ONE_ROW = ("pw85.h", "pw85_grains.h", "pw85_shapes.h")
# Those of simulations, which pw85_simulation.h includes.
SIMULATION = tuple(f"pw85_simulation_{name}.h" for name in ("state", "surroundings", "trials", "insertions", "observations", "addition"))
# The headers of the library pw85: one row; many rows; ellipsoids around points; systems of particles; simulations.
PARTS = (*ONE_ROW, "pw85_batch.h", "pw85_enclosing.h", "pw85_systems.h", *SIMULATION)
# Those of the functions that take numbers and arrays of the host, whatever the library.
HOST_HEADERS = (*PARTS, "pw85_legacy.h", "pw85_zheng.h")
C_HEADERS = (*PARTS, "pw85_gpu.h", "pw85_zheng.h", "pw85_legacy.h", "pw85_pre1.h")
EVERY_HEADER = (*C_HEADERS, "pw85_any_dimension.h")
CPP_HEADERS = (
    "pw85/pw85.hpp",
    *(f"pw85/batch/{name}.hpp" for name in ("rows", "pairs")),
    "pw85/enclosing.hpp",
    *(f"pw85/systems/{name}.hpp" for name in ("lists", "sums", "periodic", "neighbors", "meshes")),
    *(f"pw85/simulation/{name}.hpp" for name in ("surroundings", "trials", "hard_ellipsoids", "addition", "random_addition")),
)

SECTION = r"^(?:/\*\*| \*|///) @name (?P<title>[^\n]+)$"
C = re.compile(
    SECTION + r"|(?P<comment>/\*\*(?:(?!\*/).)*\*/\s*)?^(?:PW85_API|PW85_PRE1_FUNCTION) "
    r"(?P<type>[\w *]+?)(?P<name>pw85\w+)\((?P<parameters>[^)]*)\)\s*[;{]",
    re.DOTALL | re.MULTILINE,
)
CPP = re.compile(
    SECTION + r"|^(?P<comment>(?:///.*\n)+)(?:template <[^;{]*?> ?)?\s?"
    r"(?:PW85_FUNCTION|static inline) (?P<type>[^;{(]*?)(?P<name>\w+)\((?P<parameters>[^;]*)\) noexcept(?:;|\s*\{)",
    re.MULTILINE,
)
REFERENCE = re.compile(r"(?:as for|contract as|see|arguments of) (?:in )?(\w+)\(\)", re.IGNORECASE)
PARAMETER = re.compile(r"(?P<type>(?:unsigned )?\w+)(?P<const> const)?(?P<pointers>[ *]*)(?P<name>\w+)(?:\[(?P<length>\d+)\])?")
DESCRIPTION = re.compile(
    r"@param(?P<output>\[out\])? (?P<names>\w+(?:,\w+)*)(?!\S)(?:\s+\[(?P<attributes>[^\]]*)\])?(?P<text>.*)", re.DOTALL
)
STRUCTS = ("pw85_pair_list", "pw85_system", "pw85_law")  # structs that are arguments
OBJECTS = ("pw85_neighbors", "pw85_mesh", "pw85_hard_ellipsoids", "pw85_random_addition")  # what the library owns
CALLBACKS = ("pw85_potential",)  # types of functions of the caller
ELEMENTS = ("pw85_motion", "pw85_wall", "pw85_field")  # structs that are elements of arrays
NUMBERS = ("double", "int", "size_t", "int32_t", "int64_t", "unsigned char", "char", "void")
TYPES = (*NUMBERS, *STRUCTS, *ELEMENTS, *OBJECTS, *CALLBACKS)
RETURNED = ("int", "void", "size_t", "double", "double const *", "char const *", "pw85_pair_list", "pw85_system")
# Lines of C that declare a function, tags that are not read, and references to constants.
DECLARATION = re.compile(r"^(?:PW85_API\b|(?!typedef )(?:\w+ )+\*?pw85\w*\().*", re.MULTILINE)
TAG = re.compile(r"@(?!(?:param(?:\[out\])?|return|name|file|brief)(?:\s|$))\w.*")
CONSTANT = re.compile(r"#(PW85_\w+)")
STRUCT = re.compile(r"^typedef struct (?P<name>\w+) \{\n(?P<members>.*?)^\} (?P=name);", re.DOTALL | re.MULTILINE)
MEMBER = re.compile(r"/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*(?P<declaration>[^;/]+);", re.DOTALL)


# What a comment says of a parameter, and the place where: file and line.
Description = namedtuple("Description", "attributes text is_output place")


@dataclass
class Parameter:
    """A parameter of a C function, or a member of a struct argument."""

    name: str
    type: str  # type of the value, or of the elements of a pointer: "double", "size_t", "pw85_motion"
    pointer: bool
    const: bool  # whether it is a pointer to const
    length: int | None  # the length in the declaration, if there is one
    outer: bool  # whether it is a pointer to a pointer, by which the function returns a new handle
    text: str  # its sentence, or the sentence of the parameter that it is like
    attributes: Attributes
    place: str  # where it is described: file and line
    is_count: bool = False  # whether it is the number of rows of other parameters

    @property
    def shape(self):
        """Extents: numbers, and names of other parameters; empty for one number."""
        return self.attributes.shape

    @property
    def nullable(self):
        return bool({"optional", "optional if not needed"} & self.attributes.words)

    @property
    def rows(self):
        """The name of the number of rows; empty where all extents are numbers."""
        return next((extent for extent in self.shape[:1] if isinstance(extent, str) and extent != PACKED), "")

    @property
    def size(self):
        """The number of numbers, in a row where there are rows."""
        return prod(self.shape[bool(self.rows) :])

    def is_handle(self):
        """Whether it is a pointer to an object that the library owns, or one that the library does not read."""
        return self.pointer and self.type in ("void", *OBJECTS, *CALLBACKS)

    def is_struct(self):
        """Whether it is a struct, whose members are arguments."""
        return self.pointer and self.type in STRUCTS

    def is_output(self):
        return self.pointer and not self.const and not self.is_handle()

    def is_returned(self):
        """Whether the function gives one row of numbers or a new object by it."""
        return self.outer or (self.is_output() and not any(isinstance(extent, str) for extent in self.shape))

    def members(self):
        """The members of the C++ result that it receives."""
        return self.attributes.members or (self.name,)

    def member_names(self):
        """The names of the members of a struct."""
        return {one.name for one in members(self.type)} if self.is_struct() else set()


@dataclass(eq=False)  # each function is parsed once, so that what is found about it can be kept
class Function:
    name: str
    type: str
    list_of_parameters: str  # as in the header
    comment: str  # without its marks
    header: str
    line: int  # of the comment

    @cached_property
    def written(self):
        """The parameters in the header, without defaults."""
        return split_parameters(self.list_of_parameters)

    @property
    def place(self):
        """File and line, for errors."""
        return f"{self.header}:{self.line}: {self.name}()"

    @property
    def plain(self):
        """Its name without the prefix."""
        return self.name.removeprefix("pw85_")

    @property
    def dimension(self):
        return 2 if self.name.endswith("_2d") else 3

    def parameter_names(self):
        return [re.search(r"(\w+)\)?(?:\[.*\])?$", parameter)[1] for parameter in self.written]

    @cached_property
    def parameters(self):
        """The parameters of a function of C."""
        names = self.parameter_names()
        if unknown := self.descriptions.keys() - set(names):
            raise Refused(f"{self.descriptions[min(unknown)].place}: no such parameter: {min(unknown)}")
        if len(set(names)) < len(names):
            raise Refused(f"{self.place}: two parameters of one name: {', '.join(names)}")
        listed = zip(self.written, names)
        return with_counts(parameter(written, described(self, name), self.descriptions[name]) for written, name in listed)

    @property
    def inputs(self):
        return [one for one in self.parameters if not one.is_output()]

    @property
    def outputs(self):
        return [one for one in self.parameters if one.is_output()]

    @cached_property
    def flattened(self):
        """The parameters. Each struct is replaced by the members that the function reads."""
        return [one for own in self.parameters for one in (members_read(self, own) if own.is_struct() else [own])]

    def brief(self):
        """The first sentence of the comment."""
        return first_sentence(" ".join(self.comment.split())).rstrip(".:;")

    def extents(self):
        """The names of numbers of rows: arguments, and members of structs."""
        structs = (struct for struct in STRUCTS if any(written.startswith(f"{struct} ") for written in self.written))
        return counts_of(self.written) + [one.name for struct in structs for one in members(struct) if one.type == "size_t"]

    @cached_property
    def descriptions(self):
        """What the comment says of each parameter that it describes, by their names."""
        found = {}
        for match in re.finditer(r"@param[^@]*", self.comment):
            place = f"{self.header}:{self.line + self.comment.count(chr(10), 0, match.start())}: {self.name}()"
            said = DESCRIPTION.fullmatch(match[0])
            if said is None:
                raise Refused(f"{place}: not understood: {' '.join(match[0].split())}")
            names, place = said["names"].split(","), f"{place}, {said['names']}"
            whole = description(said["attributes"], said["text"], bool(said["output"]), self.extents(), place)
            each = whole.attributes.each
            if len(each) not in (0, len(names)):
                raise Refused(f"{place}: {len(each)} members for {len(names)} outputs")
            for k, name in enumerate(names):
                if name in found:
                    raise Refused(f"{place}: {name} is described twice")
                members = each[k : k + 1] or whole.attributes.members
                found[name] = whole._replace(attributes=changed(whole.attributes, members=members))
        return found

    def is_nan_on_error(self):
        """Whether a function without status gives NaN for invalid input."""
        returned = re.search(r"@return\s+\[([^\]]*)\]", self.comment)
        if returned and returned[1] != "NaN on error":
            raise Refused(f"{self.place}, @return: unknown attribute: {returned[1]}")
        found = [one.attributes.on_error for one in self.descriptions.values() if self.type in ("void", "double")]
        return returned is not None or "NaN" in found

    def is_of_simulations(self):
        """Whether its results depend on the calls before, so that it has tests of its own: tests/test_hard_ellipsoids.cpp and others."""
        return self.name.startswith(("pw85_hard_ellipsoids_", "pw85_random_addition_"))

    def references(self):
        """The names of the functions to which the comment refers."""
        return REFERENCE.findall(" ".join(self.comment.split()))


Section = namedtuple("Section", "title functions")


def first_sentence(text):
    return re.match(r".*?[.:;](?=\s|$)|.*", text)[0]


def split_parameters(text):
    """Splits a list of parameters at the commas outside of brackets."""
    parameters, depth = [""], 0
    for character in text:
        depth += (character in "<([{") - (character in ">)]}")
        if character == "," and depth == 0:
            parameters.append("")
        else:
            parameters[-1] += character
    stripped = [re.sub(r" = .*", "", " ".join(parameter.split())) for parameter in parameters]
    return [parameter for parameter in stripped if parameter not in ("", "void")]


replaced = {}  # texts of headers that are not yet those of the files


def replace(texts):
    """Takes these texts for those of headers."""
    replaced.update(texts)
    for cached in (sections, c_functions, constants, members):
        cached.cache_clear()


def text_of(header):
    return replaced.get(header) or (INCLUDE / header).read_text(encoding="utf-8")


@cache
def sections(header):
    """The sections of a header, in order; the first has no title, and is empty where every function is in one that has."""
    found = [Section("", [])]
    text, is_c = text_of(header), header.endswith(".h")
    matches = [*(C if is_c else CPP).finditer(text)]
    refuse_unread(header, text, matches, is_c)
    for match in matches:
        if match["title"]:
            found.append(Section(match["title"].strip(), []))
            continue
        comment = re.sub(r"^ ?(?:/\*\*|\*/|\*|///) ?| *\*/", "", match["comment"] or "", flags=re.MULTILINE)
        found[-1].functions.append(
            Function(match["name"], match["type"].strip(), match["parameters"], comment, header, text.count("\n", 0, match.start()) + 1)
        )
    return found


def refuse_unread(header, text, matches, is_c):
    """Refuses lines with declarations and tags that are not read, or with types and constants that there are not."""
    wrong = [*TAG.finditer(text), *(one for one in CONSTANT.finditer(text) if one[1] not in macros())]
    if is_c:
        read = {text.rfind("\n", 0, one.start("name")) + 1 for one in matches if one["name"] and one["type"].strip() in RETURNED}
        wrong += [one for one in DECLARATION.finditer(text) if one.start() not in read]
    for one in wrong:
        raise Refused(f"{line_of(header, text, one.start())}: not understood: {one[0]}")


def values(header):
    """The public structures that a C++ header declares or defines."""
    details = r"^namespace (pw85::)?detail \{$.*?^\} // namespace (pw85::)?detail$"
    text = re.sub(details, "", text_of(header), flags=re.MULTILINE | re.DOTALL)
    return re.findall(r"^(?:template <[^;{]*?> ?)?struct (\w+)(?:;| (?:: \w+ )?\{)", text, re.MULTILINE)


def functions(header):
    return [function for section in sections(header) for function in section.functions]


@cache
def version():
    """The version of the library, which stands in meson.build alone."""
    return re.search(r"^  version: '([\d.]+)'", (SOURCE / "meson.build").read_text(encoding="utf-8"), re.MULTILINE)[1]


@cache
def statuses():
    """The status codes by their names in C: their names in C++ and their values."""
    found = re.findall(r"X\((PW85_\w+), (\w+), (\d+),", text_of("pw85/status.h"))
    return {c_name: (cpp_name, value) for c_name, cpp_name, value in found}


@cache
def macros():
    """The names of all macros and statuses."""
    texts = (path.read_text(encoding="utf-8") for path in INCLUDE.rglob("*.h*"))
    return {*statuses(), *(name for text in texts for name in re.findall(r"#define (PW85_\w+)", text))}


@cache
def constants():
    """The macros of the C headers that are numbers, and the status codes, as texts."""
    found = {}
    for header in HOST_HEADERS:
        for line, text in enumerate(text_of(header).splitlines(), 1):
            if match := re.match(r"#define (PW85_\w+) (\S.*)|(?:typedef )?enum (?!pw85_status )", text):
                if not match[1] or not re.fullmatch(r"[\d.e-]+", match[2]):
                    raise Refused(f"{header}:{line}: constants are macros of decimal numbers, not: {text}")
                found[match[1]] = match[2]
    return found | {name: value for name, (_, value) in statuses().items()}


@cache
def c_functions():
    """All functions of the C headers by name."""
    found = {}
    for function in (one for header in C_HEADERS for one in functions(header)):
        if found.setdefault(function.name, function) is not function:
            raise Refused(f"{function.place}: declared twice, also at {found[function.name].place}")
    return found


def referenced(function, known):
    """The function itself, and all known functions to which its comment refers, directly or indirectly."""
    found, queue = [], [function]
    while queue:
        function = queue.pop(0)
        if function not in found:
            found.append(function)
            queue += [known[name] for name in function.references() if name in known]
    return found


def entry_of(table, key, name, place):
    """The entry of a table. If there is none, the error says which declaration needs one in the table of this name."""
    if key not in table:
        raise Refused(f"{place}: {name} has no entry {key}")
    return table[key]


def returned(function):
    """What the comment of a function of C, or of the first to which it refers, says of the status; empty if none does."""
    comments = (" ".join(other.comment.split()) for other in referenced(function, c_functions()))
    return next((found[1] for text in comments if (found := re.search(r"@return (.*?)(?= @|$)", text))), "")


def counts_of(declared):
    """The names of numbers of rows among declarations."""
    return [match[1] for one in declared if (match := re.fullmatch(r"(?:size_t|int) (\w+)", one))]


def description(attributes, text, is_output, extents, place):
    """What a comment says in brackets and behind them."""
    try:
        return Description(parsed(attributes, extents), text_behind(text), is_output, place)
    except ValueError as error:
        raise Refused(f"{place}: {error}") from None


def described(function, name, seen=()):
    """The description of a parameter, with the attributes of the one that it is like, and the beginning of its text."""
    if name not in function.descriptions:
        raise Refused(f"{function.place}, {name}: not described")
    own = function.descriptions[name]
    like = own.attributes.like
    if not like:
        return own
    known = c_functions() if function.header in C_HEADERS else {one.name: one for one in functions(function.header)}
    if like not in known:
        raise Refused(f"{own.place}: no function {like}()")
    if like in (function.name, *seen) or name not in known[like].parameter_names():
        raise Refused(f"{own.place}: {like}() does not say what {name} is")
    other = described(known[like], name, (*seen, function.name))
    is_whole = function.name.endswith("_2d") and not own.text
    text = other.text if is_whole else "; ".join(filter(None, [other.text.partition(";")[0], own.text]))
    return Description(own.attributes.merged(other.attributes), text, own.is_output, own.place)


def parameter(written, said, own):
    """A parameter or member. Extents of another function's parameter count where they are as many numbers as the declaration says."""
    match, shape = PARAMETER.fullmatch(written), said.attributes.shape
    if match is None or match["type"] not in TYPES:
        raise Refused(f"{own.place}: of no type in TYPES of api/declarations.py: {written}")
    length = int(match["length"]) if match["length"] else None
    if length is not None and not (shape and (own.attributes.shape or prod(shape) == length)):
        shape = (length,)
    one = Parameter(match["name"], match["type"], "*" in match["pointers"] or length is not None, bool(match["const"]), length,
                    "**" in match["pointers"], said.text, changed(said.attributes, shape=shape), own.place)  # fmt: skip
    for wrong in own.attributes.misfits(one, own.is_output):
        raise Refused(f"{own.place}: {wrong}")
    return one


@cache
def members(struct):
    """The members of a struct argument, except for those that are arrays."""
    text = text_of("pw85_systems.h")
    body = next((match for match in STRUCT.finditer(text) if match["name"] == struct), None)
    if body is None:
        raise Refused(f"{line_of('pw85_systems.h', text, text.find(f'struct {struct}'))}: no struct {struct} that ends with its name")
    found = [match for match in MEMBER.finditer(text, *body.span("members")) if "[" not in match["declaration"]]
    listed, extents = [], counts_of(match["declaration"] for match in found)
    for match in found:
        place = f"{line_of('pw85_systems.h', text, match.start())}: {struct}, {match['declaration']}"
        comment = re.fullmatch(r"\s*(?:\[([^\]]*)\])?(.*)", re.sub(r"\n *\*", " ", match["comment"]), re.DOTALL)
        said = description(comment[1], comment[2], False, extents, place)
        listed.append(parameter(match["declaration"], said, said))
        if listed[-1].name in [one.name for one in listed[:-1]]:
            raise Refused(f"{place}: two members of one name")
    return with_counts(listed)


def members_read(function, struct):
    """The members of a struct argument that a function reads, with what its contract says of them."""
    said, found = described(function, struct.name).attributes, []
    for one in members(struct.type):
        words = one.attributes.words - ({"optional"} if one.name in said.needs else set())
        if "near the cell" in words:
            words = words - ({"near the cell"} if "or far away" in said.words else set()) | said.words & {"or NaN"}
        found.append(changed(one, attributes=changed(one.attributes, words=words)))
    return [one for one in found if one.name not in said.without]


def values_of_members(function, struct, value):
    """The values of the members of a struct argument that is given by its members; those that the function does not read are null."""
    given = {member.name: value(member) for member in members_read(function, struct)}
    return [given.get(one.name, "nullptr") for one in members(struct.type)]


def with_counts(listed):
    """The parameters, with marks at those that count rows of others."""
    listed = list(listed)
    counts = {one.rows for one in listed}
    return [changed(one, is_count=one.type == "size_t" and not one.pointer and one.name in counts) for one in listed]
