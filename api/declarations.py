# SPDX-License-Identifier: BSD-3-Clause
"""Parses the declarations of the public headers with their comments. It is the only parser of these headers.

The C headers declare every function. The properties of a parameter are read from its type, and from the words at the beginning of
its sentence in the comment:

- `double r12[3]` has a fixed length, and a shape of more than one extent if the sentence begins with it: "9×9, symmetric";
- `double const *r12` is an array whose shape the sentence begins with: "n×3", "n each", where an extent is a number or the name
  of another parameter;
- a pointer that is not to const is an output, and the comment marks it @param[out];
- "may be null", "or null" and "null if", "null for" mean that the pointer may be null; "any output may be null" means this for all
  outputs;
- `pw85_pair_list const *list`, `pw85_system const *system` and `pw85_law const *law` are structs, whose members have comments of
  the same kind. Members count as parameters of the function, and extents may be names of members. If the comment of a function
  says "`q` may be null", the function does not read that member. If it says "`cell` is not null", the function needs a pointer
  that other functions do not need;
- "as for pw85_f()" refers to the parameter of the same name of another function. A comment that says "arguments as for pw85_f()" or
  "see pw85_f()" does so for all parameters that it does not describe.

docs/ (reference pages, checks of the comments), the other programs of this folder and tests import it.
"""

import re
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
INCLUDE = SOURCE / "include"
# The headers of functions of one row: a pair of ellipsoids; contacts of grains; an ellipsoid and a wall or another shape.
ONE_ROW = ("pw85.h", "pw85_grains.h", "pw85_shapes.h")
# Those of simulations, which pw85_simulation.h includes.
SIMULATION = tuple(f"pw85_simulation_{name}.h" for name in ("state", "surroundings", "trials", "insertions", "observations"))
# The headers of the library pw85: one row; many rows; systems of particles; simulations.
PARTS = (*ONE_ROW, "pw85_batch.h", "pw85_systems.h", *SIMULATION)
# Those of the functions that take numbers and arrays of the host, whatever the library.
HOST_HEADERS = (*PARTS, "pw85_legacy.h", "pw85_zheng.h")
C_HEADERS = (*PARTS, "pw85_gpu.h", "pw85_zheng.h", "pw85_legacy.h", "pw85_pre1.h")
CPP_HEADERS = (
    "pw85/pw85.hpp",
    *(f"pw85/batch/{name}.hpp" for name in ("rows", "pairs")),
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
EXTENT = r"(?:[a-z_]+|\d+)"
SHAPE = re.compile(rf"({EXTENT}(?:×{EXTENT})*)(?= each\b| matrix\b| in\b| or null|[,;:.]|$)")
STRUCTS = ("pw85_pair_list", "pw85_system", "pw85_law")  # structs that are arguments; other structs are elements of arrays
OBJECTS = ("pw85_neighbors", "pw85_mesh", "pw85_hard_ellipsoids")  # what the library owns
CALLBACKS = ("pw85_potential",)  # types of functions of the caller
STRUCT = re.compile(r"^typedef struct (?P<name>\w+) \{\n(?P<members>.*?)^\} (?P=name);", re.DOTALL | re.MULTILINE)
MEMBER = re.compile(r"/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*(?P<declaration>[^;/]+);", re.DOTALL)
NULLABLE = re.compile(r"\b(?:may be|or) null\b|\bnull (?:if|for) ")


@dataclass
class Parameter:
    """A parameter of a C function."""

    name: str
    type: str  # type of the value, or of the elements of a pointer: "double", "size_t", "pw85_motion"
    pointer: bool
    const: bool  # whether it is a pointer to const
    length: int | None  # the length in the declaration, if there is one
    text: str  # its sentence, or the sentence of the parameter to which it refers
    shape: tuple  # extents: numbers, and names of other parameters; empty for one number
    nullable: bool
    outer: bool  # whether it is a pointer to a pointer, by which the function returns a new handle

    def is_handle(self):
        """Whether it is a pointer to an object that the library owns."""
        return self.pointer and self.type in ("void", *OBJECTS, *CALLBACKS)

    def is_struct(self):
        """Whether it is a struct, whose members are arguments."""
        return self.pointer and self.type in STRUCTS

    def is_output(self):
        return self.pointer and not self.const and not self.is_handle()


@dataclass(eq=False)  # each function is parsed once, so that what is found about it can be kept
class Function:
    name: str
    type: str
    parameters: list  # as written, without defaults
    comment: str  # without its marks
    header: str

    def parameter_names(self):
        return [re.search(r"(\w+)\)?(?:\[.*\])?$", parameter)[1] for parameter in self.parameters]

    def brief(self):
        """The first sentence of the comment."""
        return re.match(r".*?[.:;](?=\s|$)", " ".join(self.comment.split()))[0].rstrip(".:;")

    @cached_property
    def sentences(self):
        """The sentence of the comment about each parameter that it describes, and whether it marks the parameter as an output."""
        found = {}
        for mark, names, text in re.findall(r"@param(\[out\])? ([\w,]+) (.*?)(?=@|\Z)", self.comment, re.DOTALL):
            for name in names.split(","):
                found[name] = (" ".join(text.split()), bool(mark))
        return found

    def is_of_simulations(self):
        """Whether its results depend on the calls before, so that it has tests of its own: tests/test_hard_ellipsoids.cpp."""
        return self.name.startswith("pw85_hard_ellipsoids_")

    def references(self):
        """The names of the functions to which the comment refers."""
        return REFERENCE.findall(" ".join(self.comment.split()))


@dataclass
class Section:
    title: str
    functions: list = field(default_factory=list)


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
    for cached in (sections, c_functions, parameters, flattened):
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
            Function(match["name"], match["type"].strip(), split_parameters(match["parameters"]), comment, header)
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


def shape_of(sentence, length, names):
    """The shape with which a sentence begins; otherwise that of an array with the length in its declaration."""
    match = SHAPE.match(sentence)
    extents = [] if match is None else [int(part) if part.isdigit() else part for part in match[1].split("×")]
    if extents and all(isinstance(extent, int) or extent in names for extent in extents):
        return tuple(extents)
    return () if length is None else (length,)


@cache
def parameters(function):
    """The parameters of a function of C, as described by its comment and those to which this refers."""
    found = [parameter(function, written) for written in function.parameters]
    if any("any output may be null" in text for other in referenced(function, c_functions())
           for text, _ in other.sentences.values()):
        for one in found:
            one.nullable = one.nullable or one.is_output()
    return found


def parameter(function, written):
    match = PARAMETER.fullmatch(written)
    name, pointer = match["name"], "*" in match["pointers"] or match["length"] is not None
    length = None if match["length"] is None else length_of(match["length"])
    sentences = [other.sentences[name][0] for other in referenced(function, c_functions()) if name in other.sentences]
    own = [sentence for sentence in sentences if not re.match(r"as for ", sentence)]
    names = function.parameter_names() + [member for struct in STRUCTS for member, _, _ in members(struct)]
    shape = shape_of(own[0] if own else "", length, names) if pointer else ()
    is_struct = match["type"] in STRUCTS  # "may be null" in its sentence is about its members
    nullable = pointer and not is_struct and any(NULLABLE.search(sentence) for sentence in sentences[:1] + own[:1])
    return Parameter(name, match["type"], pointer, bool(match["const"]), length, own[0] if own else "", shape, nullable,
                     "**" in match["pointers"])


@cache
def members(struct):
    """Name, declaration and comment of each member of a struct argument, except for members that are arrays."""
    text = (INCLUDE / "pw85_systems.h").read_text(encoding="utf-8")
    body = next(match["members"] for match in STRUCT.finditer(text) if match["name"] == struct)
    found = []
    for match in MEMBER.finditer(body):
        comment = " ".join(re.sub(r"^ *\*", "", match["comment"], flags=re.MULTILINE).split())
        declaration = " ".join(match["declaration"].split())
        if "[" not in declaration:
            found.append((PARAMETER.fullmatch(declaration)["name"], declaration, comment))
    return found


def members_read(function, struct):
    """The members of a struct argument that a function reads, as parameters."""
    names = [name for name, _, _ in members(struct.type)]
    said = " ".join(
        other.sentences[struct.name][0] for other in referenced(function, c_functions()) if struct.name in other.sentences
    )
    for name, declaration, comment in members(struct.type):
        match = PARAMETER.fullmatch(declaration)
        pointer = "*" in match["pointers"]
        nullable = pointer and bool(NULLABLE.search(comment)) and f"`{name}` is not null" not in said
        if f"`{name}` may be null" not in said:
            shape = shape_of(comment, None, names) if pointer else ()
            yield Parameter(name, match["type"], pointer, bool(match["const"]), None, comment, shape, nullable, False)


@cache
def flattened(function):
    """The parameters of a function. Each struct is replaced by the members that the function reads."""
    found = []
    for one in parameters(function):
        found += members_read(function, one) if one.is_struct() else [one]
    return found
