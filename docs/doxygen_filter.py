"""What Doxygen and Breathe cannot read in our headers, rewritten for them: a filter from a file to standard output."""

import re
import sys
from pathlib import Path

from statuses import status_codes

# @param a [attributes] text: Doxygen takes brackets before parentheses for a link.
ATTRIBUTES = re.compile(r"^( \* @(?:param(?:\[out\])? [\w,]+|return)) \[([^\]]*)\]", re.MULTILINE)

# @param a,b text: one @param for each name. The text ends at the next command, a blank line, or the end of the comment.
SHARED_PARAMETERS = re.compile(
    r"^( \* |/// )@param(\[out\])? (\w+(?:,\w+)+) ((?:.*\n)(?:(?: \*|///)(?!/| @| *\n).*\n)*?)"
    r"(?=(?: \*|///) @|.*\*/| \* *\n|(?!///))",
    re.MULTILINE,
)


def split_parameters(match):
    begin, direction, names, text = match.group(1), match.group(2) or "", match.group(3), match.group(4)
    return "".join(f"{begin}@param{direction} {name} {text}" for name in names.split(","))


def end_of_comment_alone(source):
    """The end of a comment on a line of its own, so that texts may be repeated."""
    return re.sub(r"^( \* .*\S) ?\*/$", r"\1\n */", source, flags=re.MULTILINE)


def enumerators(name):
    """The status codes, which a macro lists, as enumerators with their texts."""
    return "".join(f"{code[name]} = {code[2]}, /**< {code[3]} */\n" for code in status_codes())


STATUS_MACRO = re.compile(
    r"#define PW85_STATUS_ENUMERATOR\(c_name, (?P<cpp>name|cpp_name).*?#undef PW85_STATUS_ENUMERATOR\n", re.DOTALL
)


def main():
    source = Path(sys.argv[1]).read_text(encoding="utf-8")
    if "@file" not in source:
        source = "/** @file */\n" + source
    # The functions of linked.hpp have the names of the templates, by which the manual refers to these.
    source = re.sub(r"^namespace pw85 \{$.*(?=^#undef PW85_LINKED$)", "", source, flags=re.DOTALL | re.MULTILINE)
    source = ATTRIBUTES.sub(r"\1 (\2)", source)
    source = SHARED_PARAMETERS.sub(split_parameters, end_of_comment_alone(source))
    # Doxygen does not know namespaces that are inline by a macro, and takes attributes and constraints for types.
    source = re.sub(r"\[\[gnu::[^\]]*\]\] ", "", source)
    # What has internal linkage it lists twice, in its file and in its namespace.
    source = re.sub(r"^(template <.*> )?static (?=constexpr|inline)", r"\1", source, flags=re.MULTILINE)
    source = re.sub(r"^( *)requires\(.*\) explicit", r"\1explicit", source, flags=re.MULTILINE)
    # It finds no scope for what is specialised in another namespace.
    source = re.sub(r"^(?:///[^\n]*\n)*template <class T> (?:class|struct) std::.*?^};\n", "", source, flags=re.DOTALL | re.MULTILINE)
    source = STATUS_MACRO.sub(lambda macro: enumerators(0 if macro["cpp"] == "cpp_name" else 1), source)
    # Lists of facts are referred to by their numbers, which each list of Doxygen's counts from 1.
    source = re.sub(r"^/// (\d+)\. ", r"///\n/// (\1) ", source, flags=re.MULTILINE)
    # Names of headers are not to become links to pages that there are not, nor words of prose links to types. Titles have no links.
    source = re.sub(
        r"^(?!#)(?!.*@file)(.*)$",
        lambda line: re.sub(r"\b(?:pw85/)?\w+\.hp?p?\b", r"%\g<0>", line[0]),
        source,
        flags=re.MULTILINE,
    )
    source = re.sub(
        r"^ *(?:///|/?\*)(?!.*@name).*$",
        lambda line: re.sub(r"\b(?!Vector\b|Status\b)[A-Z][a-z]+(?= [a-z(])", r"%\g<0>", line[0]),
        source,
        flags=re.MULTILINE,
    )
    sys.stdout.write(source)


main()
