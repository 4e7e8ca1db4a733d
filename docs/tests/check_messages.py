"""Compares the messages of the styles for LAMMPS and the requirements of the C functions with their tests, by the sources alone.

Each message must be expected by a test: four of its words in a row stand in one, or all between two values that it prints. Messages
are what the functions that stop LAMMPS or warn are given, and the sentences about grains and walls that other functions return to them.
Each requirement that pw85_last_error() names must stand in a test as a whole.
Usage: check_messages.py SOURCE
"""

import re
import sys
from pathlib import Path

STOPS = re.compile(r"\b(?:stop_all|stop_one|refuse\w*|warning)\(")
STRING = re.compile(r'"((?:\\.|[^"\\])*)"')
REQUIREMENT = re.compile(r'"must (?:\\.|[^"\\])*"(?:\s*"(?:\\.|[^"\\])*")*')
RETURNED = re.compile(r'\breturn\s+((?:"(?:\\.|[^"\\])*"\s*)+);')
WRONG_FORM = re.compile(r"\.$|!|\n|\bshould (be|have)\b|(?<!there )\bis no (?!longer)[a-z]")


def arguments(text, start):
    """The text up to the parenthesis that closes a call, from behind the one that opens it."""
    depth = 1
    for token in re.finditer(r'"(?:\\.|[^"\\])*"|[()]', text[start:]):
        depth += {"(": 1, ")": -1}.get(token[0], 0)
        if not depth:
            return text[start : start + token.start()]
    return ""


def messages(source):
    """(file, line, parts) of each message; values stand between its parts."""
    for path in sorted((source / "lammps").glob("*.[ch]pp")):
        text = path.read_text(encoding="utf-8")
        given = [(call.start(), arguments(text, call.end())) for call in STOPS.finditer(text)]
        returned = [(one.start(), one[1]) for one in RETURNED.finditer(text) if ": " in one[1]]
        for start, strings in given + returned:
            parts = re.findall(r'(?:"(?:\\.|[^"\\])*"\s*)+', strings)
            parts = ["".join(STRING.findall(part)) for part in parts]
            if "".join(parts).strip() not in ("", "(type )"):  # the type of an atom stands before another message
                yield path.name, text.count("\n", 0, start) + 1, parts


def is_expected(parts, tests):
    """Returns whether tests have four words in a row of one of the parts of a message, or, if all are shorter, the longest one."""
    longest = max(parts, key=len).strip(" :").split()
    candidates = [part.split() for part in parts if len(part.split()) > 4] or [longest]
    return any(" ".join(words[k : k + 4]) in tests for words in candidates for k in range(max(1, len(words) - 3)))


def text_of(paths):
    """The text of files, with the parts of strings that stand in several lines put together."""
    text = "".join(path.read_text(encoding="utf-8") for path in sorted(paths))
    return re.sub(r'"\s*\n\s*[rf]?"', "", text).replace("\\", "")


def requirements(source):
    """(file, line, text) of each requirement that a function of the library can name."""
    for path in sorted((source / "src").rglob("*.[ch]pp")):
        text = path.read_text(encoding="utf-8")
        for found in REQUIREMENT.finditer(text):
            yield path.relative_to(source), text.count("\n", 0, found.start()) + 1, "".join(STRING.findall(found[0]))


def wrong_requirements(source):
    tests = text_of((source / "tests").glob("*.cpp"))
    found = list(requirements(source))
    wrong = [f"{file}:{line}: no test expects “{text}”" for file, line, text in found if f'"{text}"' not in tests]
    return wrong + ([] if len(found) > 80 else [f"only {len(found)} requirements were found"])


def main():
    source = Path(sys.argv[1])
    tests = text_of((source / "lammps/tests").glob("*.py"))
    found = list(messages(source))
    wrong = wrong_requirements(source)
    for file, line, parts in found:
        message = "".join(parts).strip()
        if not is_expected(parts, tests):
            wrong.append(f"lammps/{file}:{line}: no test expects the message “{message}”")
        if WRONG_FORM.search(message):
            wrong.append(f"lammps/{file}:{line}: “{message}” does not have the form of a message")
    wrong += [] if len(found) > 100 else [f"only {len(found)} messages were found: the check does not know the calls"]
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
