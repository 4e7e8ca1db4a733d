# SPDX-License-Identifier: BSD-3-Clause
"""Parses the declarations of the public headers with their comments. It is the only parser of these headers.

The C headers declare every function. What a program must know of a parameter stands in its type and in the brackets behind its name:

    @param[out] point [n×3; optional] where the ellipsoids touch

The text behind the brackets is for readers: no program depends on its words. Brackets without attributes are left out: the numbers of
an input must then be finite, and no pointer may be null. A parameter that is not described and an output that is not marked are errors,
with file and line. So is an attribute that is not in this list, stands twice or in another order, or does not fit the parameter:

    as pw85_f()          all attributes of the parameter of the same name of another function; extents only where this has none
    number of pairs      how many rows arrays have, and what a row is
    n×3                  the extents of an array: names of parameters, then numbers; those of `x[3]` are known
    n(n+1)/2             the extent of a packed symmetric matrix in n dimensions
    without q, with cell of structs: the members that the function does not read, and those that must not be null here
    length², 1/time      the unit; none stands where a number has no unit, `mixed units` where the entries of an array have several
    optional             the pointer may be null (`optional if not needed`: where another argument does not need it)
    LIMITS               what the function refuses (api/causes.py), in the order of this table
    or infinite, or NaN  the function accepts such numbers (of a system: centres that are such, or `or far away`)
    members mu2, lambda  the members of the C++ result that one array receives
    member length        the member that an output receives, where its name is another one; one for each of the outputs that are
                         described together
    -1 on error          what an output that is no double is on error, and one of a function without status (also what is returned)

`pw85_pair_list const *list`, `pw85_system const *system` and `pw85_law const *law` are structs, whose members have comments with the
same brackets. Members count as parameters of the function, and extents may be names of members.

docs/ (reference pages, checks of the comments), the other programs of this folder and tests import it.
"""

import re
from dataclasses import dataclass, field
from dataclasses import replace as changed
from enum import Enum, auto
from functools import cache, cached_property
from math import prod
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
INCLUDE = SOURCE / "include"
# The headers of functions of one row: a pair of ellipsoids; contacts of grains; an ellipsoid and a wall or another shape.
ONE_ROW = ("pw85.h", "pw85_grains.h", "pw85_shapes.h")
# Those of simulations, which pw85_simulation.h includes.
SIMULATION = tuple(f"pw85_simulation_{name}.h" for name in ("state", "surroundings", "trials", "insertions", "observations"))
# The headers of the library pw85: one row; many rows; ellipsoids around points; systems of particles; simulations.
PARTS = (*ONE_ROW, "pw85_batch.h", "pw85_enclosing.h", "pw85_systems.h", *SIMULATION)
# Those of the functions that take numbers and arrays of the host, whatever the library.
HOST_HEADERS = (*PARTS, "pw85_legacy.h", "pw85_zheng.h")
C_HEADERS = (*PARTS, "pw85_gpu.h", "pw85_zheng.h", "pw85_legacy.h", "pw85_pre1.h")
CPP_HEADERS = (
    "pw85/pw85.hpp",
    *(f"pw85/batch/{name}.hpp" for name in ("rows", "pairs")),
    "pw85/enclosing.hpp",
    *(f"pw85/systems/{name}.hpp" for name in ("lists", "sums", "periodic", "neighbors", "meshes")),
    *(f"pw85/simulation/{name}.hpp" for name in ("surroundings", "trials", "hard_ellipsoids")),
)

SECTION = r"^(?:/\*\*| \*|///) @name (?P<title>[^\n]+)$"
C = re.compile(
    SECTION + r"|(?P<comment>/\*\*(?:(?!\*/).)*\*/\s*)?^(?:PW85_API|PW85_PRE1_FUNCTION) "
    r"(?P<type>[\w *]+?)(?P<name>pw85\w+)\((?P<parameters>[^)]*)\)",
    re.DOTALL | re.MULTILINE,
)
CPP = re.compile(
    SECTION + r"|^(?P<comment>(?:///.*\n)+)(?:template <[^;{]*?> ?)?\s?"
    r"(?:PW85_FUNCTION|static inline) (?P<type>[^;{(]*?)(?P<name>\w+)\((?P<parameters>[^;]*)\) noexcept(?:;|\s*\{)",
    re.MULTILINE,
)
REFERENCE = re.compile(r"(?:as for|contract as|see|arguments of) (?:in )?(\w+)\(\)", re.IGNORECASE)
PARAMETER = re.compile(
    r"(?P<type>(?:unsigned )?\w+)(?P<const> const)?(?P<pointers>[ *]*)(?P<name>\w+)(?:\[(?P<length>.*)\])?"
)
DESCRIPTION = re.compile(
    r"@param(?P<output>\[out\])? (?P<names>[\w,]+)(?:\s+\[(?P<attributes>[^\]]*)\])?(?P<text>.*)", re.DOTALL
)
# The extent of packed symmetric matrices in n dimensions.
PACKED = "n(n+1)/2"
# Limits of values, with their names in src/base/last_error.hpp where a check of each number knows them.
LIMITS = {
    "> 0": "positive", ">= 0": "from_zero", "!= 0": "not_zero", "0..1": "unit_interval", "1..16": "", "<= 1": "at_most_one",
    "lower <= upper": "below_next", "> 0 until t_max": "until_t_max", "finite square": "finite_square", "definite": "definite",
    "rotation": "rotation", "index": "", "a periodic row": "", "independent rows": "", "needs cell": "", "near the cell": "",
    "of as many particles": "", "or infinite": "may_be_infinite", "or NaN": "may_be_nan", "or far away": "",
}  # fmt: skip
NAMES = r"([\w.]+(?:, [\w.]+)*)"
# The attributes in their order, with what they say in a group; {extent} is the name of a parameter.
FORMS = {
    "like": r"as (pw85\w+)\(\)",
    "rows": r"number of ([a-z -]+)",
    "shape": r"((?:{extent})(?:×(?:{extent}))*(?:×[1-9]\d*)*|[1-9]\d*(?:×[1-9]\d*)*)",
    "without": f"without {NAMES}",
    "needs": f"with {NAMES}",
    "unit": r"((?:length|time|energy)[²³]?(?:/(?:length|time)[²³]?)?|1/(?:length|time)[²³]?|no unit|mixed units)",
    **{word: re.escape(word) for word in ("optional", "optional if not needed", *LIMITS)},
    "members": f"members {NAMES}",
    "each": f"member {NAMES}",
    "on_error": r"(\S+) on error",
}
STRUCTS = ("pw85_pair_list", "pw85_system", "pw85_law")  # structs that are arguments; other structs are elements of arrays
OBJECTS = ("pw85_neighbors", "pw85_mesh", "pw85_hard_ellipsoids")  # what the library owns
CALLBACKS = ("pw85_potential",)  # types of functions of the caller
STRUCT = re.compile(r"^typedef struct (?P<name>\w+) \{\n(?P<members>.*?)^\} (?P=name);", re.DOTALL | re.MULTILINE)
MEMBER = re.compile(r"/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*(?P<declaration>[^;/]+);", re.DOTALL)


@dataclass
class Attributes:
    """What the brackets say of a parameter."""

    shape: tuple = ()
    like: str = ""  # the function of the parameter with the same attributes
    rows: str = ""  # what the rows are that it counts: "pairs"
    members: tuple = ()  # of the C++ result that one output receives
    each: tuple = ()  # of which each output receives one
    without: tuple = ()
    needs: tuple = ()
    on_error: str = ""
    unit: str = ""
    words: frozenset = frozenset()

    def merged(self, other):
        """These, and those of the parameter that this one is like."""
        own = {name: value for name, value in vars(self).items() if value}
        return changed(other, **own | {"words": self.words | other.words})


@dataclass
class Description:
    """What a comment says of a parameter."""

    attributes: Attributes
    text: str
    is_output: bool
    place: str  # file and line


class Role(Enum):
    """The kinds of parameters that programs treat in different ways."""

    OBJECT = auto()  # what the library owns
    ADDRESS = auto()  # a function or an address of the caller
    STRUCT = auto()  # whose members are arguments
    COUNT = auto()  # a number of rows, which arrays of other languages know
    ROWS = auto()  # an array whose number of rows is an argument or a member
    ROW = auto()  # a pointer to one number, array or element
    NUMBER = auto()


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

    @property
    def role(self):
        """What it is for programs that pass or read it, whatever its direction."""
        if self.type in OBJECTS:
            return Role.OBJECT
        if self.is_handle():
            return Role.ADDRESS
        if self.is_struct():
            return Role.STRUCT
        if self.pointer:
            return Role.ROWS if self.rows else Role.ROW
        return Role.COUNT if self.is_count else Role.NUMBER

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


@dataclass(eq=False)  # each function is parsed once, so that what is found about it can be kept
class Function:
    name: str
    type: str
    written: list  # the parameters in the header, without defaults
    comment: str  # without its marks
    header: str
    line: int  # of the comment

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
        for name in self.descriptions.keys() - set(self.parameter_names()):
            raise ValueError(f"{self.descriptions[name].place}: no such parameter: {name}")
        return with_counts(parameter(self, written) for written in self.written)

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

    @cached_property
    def descriptions(self):
        """What the comment says of each parameter that it describes, by their names."""
        found = {}
        for match in re.finditer(r"@param[^@]*", self.comment):
            place = f"{self.header}:{self.line + self.comment.count(chr(10), 0, match.start())}: {self.name}()"
            said = DESCRIPTION.fullmatch(match[0])
            if said is None:
                raise ValueError(f"{place}: not understood: {' '.join(match[0].split())}")
            place = f"{place}, {said['names']}"
            attributes, names = attributes_of(said["attributes"], self, place), said["names"].split(",")
            text = text_behind(said["attributes"], said["text"], place)
            if len(attributes.each) not in (0, len(names)):
                raise ValueError(f"{place}: {len(attributes.each)} members for {len(names)} outputs")
            for k, name in enumerate(names):
                if name in found:
                    raise ValueError(f"{place}: {name} is described twice")
                own = changed(attributes, members=attributes.each[k : k + 1] or attributes.members)
                found[name] = Description(own, text, bool(said["output"]), place)
        return found

    def is_nan_on_error(self):
        """Whether a function without status gives NaN for invalid input."""
        found = [one.attributes.on_error for one in self.descriptions.values() if self.type in ("void", "double")]
        return "@return [NaN on error] " in self.comment or "NaN" in found

    def is_of_simulations(self):
        """Whether its results depend on the calls before, so that it has tests of its own: tests/test_hard_ellipsoids.cpp."""
        return self.name.startswith("pw85_hard_ellipsoids_")

    def is_of_object(self):
        """Whether it has a status and an object of the library, which it makes or on which it works."""
        return self.type == "int" and any(one.role == Role.OBJECT for one in self.parameters)

    def references(self):
        """The names of the functions to which the comment refers."""
        return REFERENCE.findall(" ".join(self.comment.split()))


@dataclass
class Section:
    title: str
    functions: list = field(default_factory=list)


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
    for cached in (sections, c_functions):
        cached.cache_clear()


@cache
def sections(header):
    """The sections of a header, in order; the first has no title, and is empty where every function is in one that has."""
    found = [Section("")]
    text = replaced.get(header) or (INCLUDE / header).read_text(encoding="utf-8")
    for match in (CPP if header.endswith("pp") else C).finditer(text):
        if match["title"]:
            found.append(Section(match["title"].strip()))
            continue
        comment = re.sub(r"^ ?(?:/\*\*|\*/|\*|///) ?| *\*/", "", match["comment"] or "", flags=re.MULTILINE)
        found[-1].functions.append(
            Function(match["name"], match["type"].strip(), split_parameters(match["parameters"]), comment, header,
                     text.count("\n", 0, match.start()) + 1)
        )
    return found


def values(header):
    """The public structures that a C++ header declares or defines."""
    text = (INCLUDE / header).read_text(encoding="utf-8")
    text = re.sub(r"^namespace (pw85::)?detail \{$.*?^\} // namespace (pw85::)?detail$", "", text, flags=re.MULTILINE | re.DOTALL)
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
    text = (INCLUDE / "pw85/status.h").read_text(encoding="utf-8")
    return {c_name: (cpp_name, value) for c_name, cpp_name, value in re.findall(r"X\((PW85_\w+), (\w+), (\d+),", text)}


@cache
def constants():
    """The macros of the C headers that are numbers, and the status codes, as texts."""
    text = "".join((INCLUDE / header).read_text(encoding="utf-8") for header in C_HEADERS)
    found = dict(re.findall(r"^#define (PW85_\w+) ([\d.e-]+)$", text, re.MULTILINE))
    return found | {name: value for name, (_, value) in statuses().items()}


@cache
def c_functions():
    """All functions of the C headers by name."""
    return {function.name: function for header in C_HEADERS for function in functions(header)}


def referenced(function, known):
    """The function itself, and all known functions to which its comment refers, directly or indirectly."""
    found, queue = [], [function]
    while queue:
        function = queue.pop(0)
        if function not in found:
            found.append(function)
            queue += [known[name] for name in function.references() if name in known]
    return found


def length_of(text):
    """The value of the length in a declaration, which is a sum or product of numbers and constants."""
    integers = {name: int(value) for name, value in constants().items() if value.isdigit()}
    return eval(text, {"__builtins__": {}}, integers)


def attributes_of(text, function, place):
    """The attributes between brackets, each once and in the order of FORMS; `text` is None where there are none."""
    counted = [*function.written, *(declaration for struct in STRUCTS for _, declaration, _ in members(struct))]
    extents = [re.escape(PACKED), *(match[1] for one in counted if (match := re.fullmatch(r"(?:size_t|int) (\w+)", one)))]
    found, last = {}, (-1, "")
    for item in [] if text is None else " ".join(text.split()).split("; "):
        matches = ((k, name, re.fullmatch(form.replace("{extent}", "|".join(extents)), item)) for k, (name, form) in enumerate(FORMS.items()))
        k, name, match = next((one for one in matches if one[2]), (0, "", None))
        if match is None:
            raise ValueError(f"{place}: unknown attribute: {item}")
        if k <= last[0]:
            raise ValueError(f"{place}: {item} must not stand behind {last[1]}")
        found[name], last = match[match.lastindex or 0], (k, item)
    lists = {name: tuple(found[name].split(", ")) for name in ("without", "needs", "members", "each") if name in found}
    if "shape" in found:
        lists["shape"] = tuple(int(part) if part.isdigit() else part for part in found["shape"].split("×"))
    texts = {name: found[name] for name in ("like", "rows", "unit", "on_error") if name in found}
    return Attributes(words=frozenset(found.keys() - lists.keys() - texts.keys()), **lists, **texts)


def text_behind(attributes, text, place):
    """The text behind the brackets, of which none may be left open or stand behind a word."""
    plain = " ".join(text.split())
    if plain.startswith("[") or (attributes is None and re.search(r"\[(?:[^\]]*; )?(?:optional|length|n×|as pw85)", plain)):
        raise ValueError(f"{place}: attributes must stand between brackets behind the name: {plain}")
    return plain


def described(function, name, seen=()):
    """The description of a parameter, with the attributes of the one that it is like, and the beginning of its text."""
    if name not in function.descriptions:
        raise ValueError(f"{function.header}:{function.line}: {function.name}(), {name}: not described")
    own = function.descriptions[name]
    like = own.attributes.like
    if not like:
        return own
    known = c_functions() if function.header in C_HEADERS else {one.name: one for one in functions(function.header)}
    if like not in known:
        raise ValueError(f"{own.place}: no function {like}()")
    if like in (function.name, *seen) or name not in known[like].parameter_names():
        raise ValueError(f"{own.place}: {like}() does not say what {name} is")
    other = described(known[like], name, (*seen, function.name))
    is_whole = function.name.endswith("_2d") and not own.text
    text = other.text if is_whole else "; ".join(filter(None, [other.text.partition(";")[0], own.text]))
    return Description(own.attributes.merged(other.attributes), text, own.is_output, own.place)


def parameter(function, written):
    match = PARAMETER.fullmatch(written)
    said, own = described(function, match["name"]), function.descriptions[match["name"]].attributes
    one = made_parameter(match, said.text, said.attributes, bool(own.shape))
    for wrong in misfits(function, one, own, said.is_output):
        raise ValueError(f"{said.place}: {wrong}")
    return one


def misfits(function, one, own, is_marked):
    """What is wrong where the attributes do not fit the parameter. `own` are those of its own brackets; `is_marked` is for @param[out]."""
    is_output, said, limits = one.is_output() or one.outer, one.attributes, own.words & LIMITS.keys()
    is_answer = is_output and one.type == "int" and one.is_returned() and len(function.written) > 1
    unread = {*own.without, *own.needs} - {name for name, *_ in (members(one.type) if one.is_struct() else ())}
    found = {
        "an output needs @param[out]": is_output and not is_marked,
        "an input must not have @param[out]": is_marked and not is_output,
        f"{one.shape} are not {one.length} numbers": own.shape and one.length is not None and prod(one.shape) != one.length,
        "an array without extents": one.const and one.type == "double" and not one.shape,
        "one number has no extents": own.shape and not one.pointer,
        "a number cannot be absent: not optional": one.nullable and not one.pointer,
        f"not a number of rows: {said.rows}": said.rows and (one.type != "size_t" or one.pointer),
        f"not a struct with {', '.join(sorted(unread))}": unread,
        f"only doubles have a unit: {said.unit}": said.unit and one.type not in ("double", "pw85_motion"),
        f"an output is not limited: {', '.join(sorted(limits))}": limits and is_output,
        f"an input stays as it is: {said.on_error} on error": said.on_error and not is_output,
        f"an input is not a member of the result: {', '.join(own.members)}": own.members and not is_output,
        "an int needs a value on error, for example -1 on error": is_answer and not said.on_error,
    }
    return [text for text, is_wrong in found.items() if is_wrong]


def made_parameter(match, text, attributes, has_own_shape=True):
    """A parameter or member. Extents of another function's parameter count where they are as many numbers as the declaration says."""
    shape, length = attributes.shape, None if match["length"] is None else length_of(match["length"])
    if length is not None and not (shape and (has_own_shape or prod(shape) == length)):
        shape = (length,)
    return Parameter(match["name"], match["type"], "*" in match["pointers"] or length is not None, bool(match["const"]), length,
                     "**" in match["pointers"], text, changed(attributes, shape=shape))


@cache
def members(struct):
    """Name, declaration and comment of each member of a struct argument, except for members that are arrays. A comment has a match for
    attributes and text, and a place."""
    text = (INCLUDE / "pw85_systems.h").read_text(encoding="utf-8")
    body = next(match for match in STRUCT.finditer(text) if match["name"] == struct)
    found = []
    for match in MEMBER.finditer(body["members"]):
        comment = " ".join(re.sub(r"^ *\*", "", match["comment"], flags=re.MULTILINE).split())
        declaration = " ".join(match["declaration"].split())
        line = text.count("\n", 0, body.start("members") + match.start()) + 1
        if "[" not in declaration:
            name = PARAMETER.fullmatch(declaration)["name"]
            found.append((name, declaration, (comment, f"pw85_systems.h:{line}: {struct}, {name}")))
    return found


def members_read(function, struct):
    """The members of a struct argument that a function reads, as parameters."""
    said, found = described(function, struct.name).attributes, []
    for name, declaration, (comment, place) in members(struct.type):
        match = re.fullmatch(r"(?:\[(?P<attributes>[^\]]*)\])?(?P<text>.*)", comment)
        attributes = attributes_of(match["attributes"], function, place)
        words = attributes.words - ({"optional"} if name in said.needs else set())
        if "near the cell" in words:
            words = words - ({"near the cell"} if "or far away" in said.words else set()) | said.words & {"or NaN"}
        if name not in said.without:
            text = text_behind(match["attributes"], match["text"], place)
            found.append(made_parameter(PARAMETER.fullmatch(declaration), text, changed(attributes, words=words)))
    return with_counts(found)


def values_of_members(function, struct, value):
    """The values of the members of a struct argument that is given by its members; those that the function does not read are null."""
    given = {member.name: value(member) for member in members_read(function, struct)}
    return [given.get(name, "nullptr") for name, *_ in members(struct.type)]


def with_counts(listed):
    """The parameters, with marks at those that count rows of others."""
    listed = list(listed)
    counts = {one.rows for one in listed}
    return [changed(one, is_count=one.type == "size_t" and not one.pointer and one.name in counts) for one in listed]
