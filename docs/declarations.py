"""The declarations of the public headers with their comments: what reference pages list, and tests compare lists with."""

import re
from dataclasses import dataclass, field
from pathlib import Path

INCLUDE = Path(__file__).resolve().parent.parent / "include"
C_HEADERS = ("pw85.h", "pw85_zheng.h", "pw85_legacy.h", "pw85_pre1.h")
CPP_HEADERS = ("pw85/pw85.hpp", "pw85/batch.hpp")

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


def functions(header):
    return [function for section in sections(header) for function in section.functions]
