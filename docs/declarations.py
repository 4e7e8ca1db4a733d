"""The declarations of the public headers with their comments: what reference pages list, and tests compare lists with."""

import re
from dataclasses import dataclass, field
from pathlib import Path

INCLUDE = Path(__file__).resolve().parent.parent / "include"
C_HEADERS = ("pw85.h", "pw85_gpu.h", "pw85_zheng.h", "pw85_legacy.h", "pw85_pre1.h")
CPP_HEADERS = ("pw85/pw85.hpp", "pw85/batch.hpp", "pw85/neighbors.hpp")

SECTION = r"^(?:/\*\*| \*|///) @name (?P<title>[^\n]+)$"
C = re.compile(
    SECTION + r"|(?P<comment>/\*\*(?:(?!\*/).)*\*/\s*)?^(?:PW85_API|static inline) "
    r"(?P<type>[\w *]+?)(?P<name>pw85\w+)\((?P<parameters>[^)]*)\)",
    re.DOTALL | re.MULTILINE,
)
CPP = re.compile(
    SECTION + r"|^(?P<comment>(?:///.*\n)+)(?:template <[^;{]*?> ?)?\s?"
    r"(?:PW85_FUNCTION|static inline) (?P<type>[^;{(]*?)(?P<name>\w+)\((?P<parameters>[^;]*)\) noexcept;",
    re.MULTILINE,
)


@dataclass
class Function:
    name: str
    type: str
    parameters: list  # as written, without defaults
    comment: str  # without its marks

    def parameter_names(self):
        return [re.search(r"(\w+)\)?(?:\[.*\])?$", parameter)[1] for parameter in self.parameters]

    def brief(self):
        """The first sentence of the comment."""
        return re.match(r".*?[.:;](?=\s|$)", " ".join(self.comment.split()))[0].rstrip(".:;")


@dataclass
class Section:
    title: str
    functions: list = field(default_factory=list)


def split_parameters(text):
    """At the commas that are in no bracket."""
    parameters, depth = [""], 0
    for character in text:
        depth += (character in "<([{") - (character in ">)]}")
        if character == "," and depth == 0:
            parameters.append("")
        else:
            parameters[-1] += character
    stripped = [re.sub(r" = .*", "", " ".join(parameter.split())) for parameter in parameters]
    return [parameter for parameter in stripped if parameter not in ("", "void")]


def sections(header):
    """The sections of a header, in order; the first has no title, and is empty where every function is in one that has."""
    found = [Section("")]
    text = (INCLUDE / header).read_text(encoding="utf-8")
    for match in (CPP if header.endswith("pp") else C).finditer(text):
        if match["title"]:
            found.append(Section(match["title"].strip()))
            continue
        comment = re.sub(r"^ ?(?:/\*\*|\*/|\*|///) ?| *\*/", "", match["comment"] or "", flags=re.MULTILINE)
        found[-1].functions.append(
            Function(match["name"], match["type"].strip(), split_parameters(match["parameters"]), comment)
        )
    return found


def values(header):
    """The structures that a C++ header declares or defines."""
    text = (INCLUDE / header).read_text(encoding="utf-8")
    return re.findall(r"^(?:template <[^;{]*?> ?)?struct (\w+)(?:;| \{)", text, re.MULTILINE)


def functions(header):
    return [function for section in sections(header) for function in section.functions]


FORTRAN = re.compile(
    r"^(?P<comment>(?: *!> .*\n)+)? *(?P<kind>function|subroutine) (?P<name>pw85\w+)\((?P<arguments>[^)]*)\).*\n"
    r"(?P<declared>(?:(?: .*)?::.*\n| *import.*\n)+)",
    re.MULTILINE,
)


@dataclass
class FortranFunction:
    name: str
    kind: str
    arguments: list
    comment: str
    declarations: list


def fortran_functions():
    """The functions and subroutines of the Fortran module by the names of C in lower case, in the order of the module."""
    text = (INCLUDE.parent / "fortran/pw85.f90").read_text(encoding="utf-8")
    found = {}
    for match in FORTRAN.finditer(re.sub(r" *&\n *", " ", text)):
        arguments = [argument.strip() for argument in match["arguments"].split(",")]
        lines = [line.strip() for line in match["declared"].splitlines() if "::" in line and "import" not in line]
        declared = [line for line in lines if set(re.findall(r"\w+", line.split("::")[1])) & set(arguments)]
        comment = " ".join(re.sub(r" *!> ", " ", match["comment"] or "").split())
        found[match["name"]] = FortranFunction(match["name"], match["kind"], arguments, comment, declared)
    return found
