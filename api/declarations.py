# SPDX-License-Identifier: BSD-3-Clause
"""Parses the declarations of the public headers with their comments. It is the only parser of these headers.

The C headers declare every function. What a program must know of a parameter stands in its type and in the brackets behind its name:
see api/attributes.py. A parameter that is not described is an error, with file and line.

docs/ (reference pages, checks of the comments), the other programs of this folder and tests import it.
"""

import re
from collections import namedtuple
from dataclasses import dataclass, replace
from functools import cached_property

from parameters import STRUCTS, Description, counts_of, description, members, parameter, with_counts
from public_headers import C_HEADERS, PARTS, macros, of_texts, text_of
from refusals import line_of, refuse

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
DESCRIPTION = re.compile(r"@param(?P<output>\[out\])? (?P<names>\w+(?:,\w+)*)(?!\S)(?:\s+\[(?P<attributes>[^\]]*)\])?(?P<text>.*)", re.S)
RETURNED = ("int", "void", "size_t", "double", "double const *", "char const *", "pw85_pair_list", "pw85_system")
# Lines of C that declare a function, tags that are not read, and references to constants.
DECLARATION = re.compile(r"^(?:PW85_API\b|(?!typedef )(?:\w+ )+\*?pw85\w*\().*", re.MULTILINE)
TAG = re.compile(r"@(?!(?:param(?:\[out\])?|return|name|file|brief)(?:\s|$))\w.*")
CONSTANT = re.compile(r"#(PW85_\w+)")


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
        return f"{self.header}:{self.line}: {self.name}()"

    @property
    def plain(self):
        return self.name.removeprefix("pw85_")

    @property
    def dimension(self):
        return 2 if self.name.endswith("_2d") else 3

    @property
    def prose(self):
        """The comment in one line."""
        return " ".join(self.comment.split())

    def brief(self):
        return first_sentence(self.prose).rstrip(".:;")

    def references(self):
        return REFERENCE.findall(self.prose)

    def parameter_names(self):
        return [re.search(r"(\w+)\)?(?:\[.*\])?$", parameter)[1] for parameter in self.written]

    @cached_property
    def parameters(self):
        names = self.parameter_names()
        refuse(self.place, {f"two parameters of one name: {', '.join(names)}": len(set(names)) < len(names)})
        described = ((self.described(name), self.descriptions[name]) for name in names)
        return with_counts(parameter(written, *both) for written, both in zip(self.written, described))

    @property
    def inputs(self):
        return [one for one in self.parameters if not one.is_output()]

    @property
    def outputs(self):
        return [one for one in self.parameters if one.is_output()]

    @cached_property
    def flattened(self):
        """The parameters. Each struct is replaced by the members that the function reads."""
        return [one for own in self.parameters for one in (self.members_read(own) if own.is_struct() else [own])]

    def members_read(self, struct):
        """The members of a struct argument that it reads, with what its contract says of them."""
        said, found = self.described(struct.name).attributes, []
        for one in members(struct.type):
            words = one.attributes.words - ({"optional"} if one.name in said.needs else set())
            if "near the cell" in words:
                words = words - ({"near the cell"} if "or far away" in said.words else set()) | said.words & {"or NaN"}
            found.append(replace(one, attributes=replace(one.attributes, words=words)))
        return [one for one in found if one.name not in said.without]

    def values_of_members(self, struct, value):
        """The values of the members of a struct argument that is given by its members; those that it does not read are null."""
        given = {member.name: value(member) for member in self.members_read(struct)}
        return [given.get(one.name, "nullptr") for one in members(struct.type)]

    def extents(self):
        """The names of numbers of rows: arguments, and members of structs."""
        structs = (struct for struct in STRUCTS if any(written.startswith(f"{struct} ") for written in self.written))
        return counts_of(self.written) + [one.name for struct in structs for one in members(struct) if one.type == "size_t"]

    @cached_property
    def descriptions(self):
        """What the comment says of each parameter that it describes, by their names."""
        found, known = {}, self.parameter_names()
        for match in re.finditer(r"@param[^@]*", self.comment):
            place = f"{self.header}:{self.line + self.comment.count(chr(10), 0, match.start())}: {self.name}()"
            said = DESCRIPTION.fullmatch(match[0])
            refuse(place, {f"not understood: {' '.join(match[0].split())}": said is None})
            names, place = said["names"].split(","), f"{place}, {said['names']}"
            whole = description(said["attributes"], said["text"], bool(said["output"]), self.extents(), place)
            each = whole.attributes.each
            refuse(place, {f"{len(each)} members for {len(names)} outputs": len(each) not in (0, len(names))})
            for k, name in enumerate(names):
                refuse(place, {f"{name} is described twice": name in found, f"no such parameter: {name}": name not in known})
                members = each[k : k + 1] or whole.attributes.members
                found[name] = whole._replace(attributes=replace(whole.attributes, members=members))
        return found

    def described(self, name, seen=()):
        """The description of a parameter, with the attributes of the one that it is like, and the beginning of its text."""
        refuse(f"{self.place}, {name}", {"not described": name not in self.descriptions})
        own = self.descriptions[name]
        like = own.attributes.like
        if not like:
            return own
        known = c_functions() if self.header in C_HEADERS else {one.name: one for one in functions(self.header)}
        refuse(own.place, {f"no function {like}()": like not in known})
        is_said = like not in (self.name, *seen) and name in known[like].parameter_names()
        refuse(own.place, {f"{like}() does not say what {name} is": not is_said})
        other = known[like].described(name, (*seen, self.name))
        is_whole = self.dimension == 2 and not own.text
        text = other.text if is_whole else "; ".join(filter(None, [other.text.partition(";")[0], own.text]))
        return Description(own.attributes.merged(other.attributes), text, own.is_output, own.place)

    def is_nan_on_error(self):
        """Whether a function without status gives NaN for invalid input."""
        returned = re.search(r"@return\s+\[([^\]]*)\]", self.comment)
        if returned:
            refuse(f"{self.place}, @return", {f"unknown attribute: {returned[1]}": returned[1] != "NaN on error"})
        found = [one.attributes.on_error for one in self.descriptions.values() if self.type in ("void", "double")]
        return returned is not None or "NaN" in found

    def returned(self):
        """What the comment of a function of C, or of the first to which it refers, says of the status; empty if none does."""
        texts = (other.prose for other in referenced(self, c_functions()))
        return next((found[1] for text in texts if (found := re.search(r"@return (.*?)(?= @|$)", text))), "")

    def is_of_simulations(self):
        """Whether its results depend on the calls before, so that it has tests of its own: tests/test_hard_ellipsoids.cpp and others."""
        return self.name.startswith(("pw85_hard_ellipsoids_", "pw85_random_addition_"))


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


def refuse_unread(header, text, matches, is_c):
    """Refuses lines with declarations and tags that are not read, or with types and constants that there are not."""
    wrong = [*TAG.finditer(text), *(one for one in CONSTANT.finditer(text) if one[1] not in macros())]
    if is_c:
        read = {text.rfind("\n", 0, one.start("name")) + 1 for one in matches if one["name"] and one["type"].strip() in RETURNED}
        wrong += [one for one in DECLARATION.finditer(text) if one.start() not in read]
    for one in wrong:
        refuse(line_of(header, text, one.start()), {f"not understood: {one[0]}": True})


@of_texts
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
        line = text.count("\n", 0, match.start()) + 1
        found[-1].functions.append(Function(match["name"], match["type"].strip(), match["parameters"], comment, header, line))
    return found


def functions(*headers):
    return [function for header in headers for section in sections(header) for function in section.functions]


@of_texts
def c_functions():
    found = {}
    for one in functions(*C_HEADERS):
        other = found.setdefault(one.name, one)
        refuse(one.place, {f"declared twice, also at {other.place}": other is not one})
    return found


def functions_with_status():
    return [function for function in functions(*PARTS) if function.type == "int"]


def referenced(function, known):
    """The function itself, and all known functions to which its comment refers, directly or indirectly."""
    found, queue = [], [function]
    while queue:
        function = queue.pop(0)
        if function not in found:
            found.append(function)
            queue += [known[name] for name in function.references() if name in known]
    return found
